//! Under which exposures two pictures of high range are compared [Andersson21]:
//! from the one that just shows the brightest pixel of the reference to the one that shows its
//! median as brightly, about one stop apart.

use crate::math::Picture;

/// The filmic curve of ACES as fitted by Narkowicz, exposed by 0.6: numerator and denominator
/// are these polynomials, highest power first.
const NUMERATOR: [f64; 3] = [0.9036, 0.018, 0.0];
const DENOMINATOR: [f64; 3] = [0.8748, 0.354, 0.14];

/// How bright "just shown" is after tone mapping.
const BRIGHT: f64 = 0.85;

/// The median is at least this: over half of a picture may be black.
const LEAST_MEDIAN: f64 = f32::EPSILON as f64;

/// The exposures of a reference, in stops: factors 2^start to 2^stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposures {
    /// Of the darkest rendition.
    pub start: f64,
    /// Of the brightest; at least `start`.
    pub stop: f64,
    /// How many renditions; at least 2.
    pub count: u32,
}

impl Exposures {
    /// Of the reference; `None` if it is black.
    pub(super) fn of(reference: &Picture) -> Option<Self> {
        let mut luminances: Vec<f64> = reference
            .pixels
            .iter()
            .map(|pixel| {
                let [r, g, b] = pixel.to_array().map(|c| f64::from(c.max(0.0)));
                0.212_639 * r + 0.715_168_7 * g + 0.072_192_3 * b
            })
            .collect();
        let middle = luminances.len() / 2;
        let brightest = luminances.iter().copied().fold(0.0, f64::max);
        if brightest <= LEAST_MEDIAN {
            return None;
        }
        let (_, median, _) = luminances.select_nth_unstable_by(middle, f64::total_cmp);
        let median = median.max(LEAST_MEDIAN);
        let start = (white_point() / brightest).log2();
        let stop = (white_point() / median).log2();
        let count = (brightest / median).log2().ceil().max(2.0) as u32;
        Some(Self { start, stop, count })
    }

    /// Each exposure in stops.
    pub fn stops(&self) -> impl Iterator<Item = f64> {
        let Self { start, stop, count } = *self;
        (0..count).map(move |i| start + (stop - start) * f64::from(i) / f64::from(count - 1))
    }
}

/// What a display shows of a linear radiance; below 0 as 0, above all as 1.
pub fn tone_map(x: f32) -> f32 {
    let x = f64::from(x.max(0.0));
    let of = |[a, b, c]: [f64; 3]| (a * x + b) * x + c;
    (of(NUMERATOR) / of(DENOMINATOR)).min(1.0) as f32
}

/// The radiance shown as `BRIGHT`.
fn white_point() -> f64 {
    let [a, b, c] = [0, 1, 2].map(|i| NUMERATOR[i] - BRIGHT * DENOMINATOR[i]);
    let half = -0.5 * b / a;
    half + (half * half - c / a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn of(greys: &[f32]) -> Option<Exposures> {
        let pixels = greys.iter().map(|&g| Rgb::grey(g)).collect();
        Exposures::of(&Picture { width: greys.len(), height: 1, pixels })
    }

    #[test]
    fn the_white_point_is_shown_bright() {
        assert!((tone_map(white_point() as f32) - 0.85).abs() < 1e-6);
        assert_eq!((tone_map(0.0), tone_map(-3.0), tone_map(f32::MAX)), (0.0, 0.0, 1.0));
    }

    // Figures below: the parameters flip-evaluator 1.7 reports for the same greys.

    #[test]
    fn from_the_brightest_to_the_upper_median() {
        let found = of(&[1.0, 2.0, 3.0, 10.0]).unwrap();
        assert!((found.start + 2.238_631).abs() < 1e-4, "{found:?}");
        assert!((found.stop + 0.501_665).abs() < 1e-4, "{found:?}");
        assert_eq!(found.count, 2);
        assert_eq!(of(&[1.0, 1.0, 16.0]).unwrap().count, 4);
        assert_eq!(of(&[1.0, 1.0, 17.0]).unwrap().count, 5);
        let stops: Vec<f64> = of(&[1.0, 1.0, 16.0]).unwrap().stops().collect();
        assert!((stops[0] + 2.916_703).abs() < 1e-4 && (stops[3] - 1.083_297).abs() < 1e-4);
        assert!((stops[1] - stops[0] - 4.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_black_median_is_raised() {
        let found = of(&[0.0, 0.0, 0.0, 5.0]).unwrap();
        assert!((found.stop - 24.083_298).abs() < 1e-4, "{found:?}");
        assert_eq!(found.count, 26);
        assert_eq!(of(&[0.0, 0.0]), None);
        assert_eq!(of(&[]), None);
    }
}
