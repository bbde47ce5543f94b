//! Reconstruction filters, by importance sampling: each sample belongs to one pixel and falls
//! around its centre with density |f| / ∫|f| [Ernst06]; its weight is the sign of f, times
//! ∫|f| / ∫f. So the expectation of a pixel is the filtered picture ∫ f L / ∫ f exactly, and no
//! two pixels share a sample. Filters are products of one function along x and along y.
//!
//! The price of negative lobes: weights of both signs add noise to even surfaces too, about
//! 0.56/√samples of their brightness for Mitchell and Netravali's B = C = 1/3. Dividing by the sum
//! of the weights would hide it where a picture is even, but its expectation is another picture.

use super::table::Table;

/// How samples around a pixel's centre are weighed. Distances are in pixels.
#[derive(Clone, Debug)]
pub enum Filter {
    /// All alike.
    Box {
        /// How far it reaches along x and y.
        radius: f64,
    },
    /// Falls in a straight line to zero.
    Tent {
        /// How far it reaches along x and y.
        radius: f64,
    },
    /// A tabulated one.
    Table(Table),
}

/// Cells of a table along half an axis. The density is straight within a cell: for the filters
/// here within 1e-5 of the true one everywhere, relative to its peak.
const CELLS: usize = 2048;

/// Standard deviations beyond which a Gaussian is taken for zero: it is 1e-22 of its peak there.
const FAR: f64 = 10.0;

impl Filter {
    /// A Gaussian of this standard deviation, lowered so that it ends at zero at the radius:
    /// exp(−x²/2σ²) − exp(−r²/2σ²).
    pub fn gaussian(radius: f64, deviation: f64) -> Self {
        let reach = radius.min(FAR * deviation);
        let at = |x: f64| -0.5 * (x / deviation).powi(2);
        // Small beside the deviation, it is a difference of two near numbers: so by expm1.
        let bell = |x: f64| at(radius).exp() * (at(x) - at(radius)).exp_m1();
        let bell = |x: f64| if reach < radius { at(x).exp() } else { bell(x) };
        Self::Table(Table::new(&[(0.0, reach, CELLS)], bell))
    }

    /// Mitchell and Netravali's cubics [Mitchell88], stretched from ±2 to the radius.
    pub fn mitchell(radius: f64, b: f64, c: f64) -> Self {
        let cubic = |x: f64| {
            if x < 1.0 {
                ((12.0 - 9.0 * b - 6.0 * c) * x - 18.0 + 12.0 * b + 6.0 * c) * x * x + 6.0 - 2.0 * b
            } else {
                // −(B+6C)x³ + (6B+30C)x² − (12B+48C)x + 8B+24C, in factors: the sign is exact.
                (x - 2.0).powi(2) * (2.0 * b + 6.0 * c - (b + 6.0 * c) * x)
            }
        };
        // Where it turns negative; the cells end there. B = C = 0 is zero from 1 on.
        let root = if b + 6.0 * c > 0.0 { (2.0 * b + 6.0 * c) / (b + 6.0 * c) } else { 1.0 };
        let scale = radius / 2.0;
        let pieces = [(0.0, root * scale, CELLS), (root * scale, radius, CELLS)];
        Self::Table(Table::new(&pieces, |x| cubic(x / scale)))
    }

    /// Where in a pixel a sample falls, from `u` in [0, 1)²: the offset from the pixel's centre
    /// along x and y, and the sample's weight, whose mean is 1.
    #[inline]
    pub fn sample(&self, u: [f64; 2]) -> (f64, f64, f64) {
        let ((x, along_x), (y, along_y)) = (self.along(u[0]), self.along(u[1]));
        (x, y, along_x * along_y)
    }

    /// The same along one axis. The offset grows with `u`, so stratified numbers stay stratified.
    #[inline]
    fn along(&self, u: f64) -> (f64, f64) {
        match self {
            Self::Box { radius } => ((2.0 * u - 1.0) * radius, 1.0),
            Self::Tent { radius } => {
                let from_edge =
                    if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() };
                (from_edge * radius, 1.0)
            }
            Self::Table(table) => table.sample(u),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{chi_squared, random};

    fn cubic(b: f64, c: f64) -> impl Fn(f64) -> f64 {
        // As printed in the paper.
        move |x: f64| {
            let x = x.abs();
            (if x < 1.0 {
                (12.0 - 9.0 * b - 6.0 * c) * x.powi(3)
                    + (-18.0 + 12.0 * b + 6.0 * c) * x.powi(2)
                    + (6.0 - 2.0 * b)
            } else {
                (-b - 6.0 * c) * x.powi(3)
                    + (6.0 * b + 30.0 * c) * x.powi(2)
                    + (-12.0 * b - 48.0 * c) * x
                    + (8.0 * b + 24.0 * c)
            }) / 6.0
        }
    }

    fn bell(radius: f64, deviation: f64) -> impl Fn(f64) -> f64 {
        let e = move |x: f64| (-x * x / (2.0 * deviation * deviation)).exp();
        move |x| e(x) - e(radius)
    }

    type Case = (Filter, f64, Box<dyn Fn(f64) -> f64>);

    fn cases() -> Vec<Case> {
        vec![
            (Filter::Box { radius: 0.5 }, 0.5, Box::new(|_| 1.0)),
            (Filter::Tent { radius: 1.0 }, 1.0, Box::new(|x| 1.0 - x.abs())),
            (Filter::gaussian(1.5, 0.5), 1.5, Box::new(bell(1.5, 0.5))),
            (Filter::gaussian(0.5, 8.0), 0.5, Box::new(|x| ((0.25 - x * x) / 128.0).exp_m1())),
            (Filter::gaussian(8.0, 0.25), 8.0, Box::new(bell(8.0, 0.25))),
            (
                Filter::mitchell(2.0, 1.0 / 3.0, 1.0 / 3.0),
                2.0,
                Box::new(cubic(1.0 / 3.0, 1.0 / 3.0)),
            ),
            (Filter::mitchell(2.0, 0.0, 0.0), 2.0, Box::new(|x| cubic(0.0, 0.0)(x).max(0.0))),
            (Filter::mitchell(2.0, 1.0, 0.0), 2.0, Box::new(cubic(1.0, 0.0))),
            (Filter::mitchell(2.0, 0.0, 1.0), 2.0, Box::new(cubic(0.0, 1.0))),
        ]
    }

    fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
        let (n, step) = (10_000, (to - from) / 10_000.0);
        (0..n).map(|i| f(from + (f64::from(i) + 0.5) * step)).sum::<f64>() * step
    }

    #[test]
    fn offsets_follow_the_filter() {
        for (filter, radius, f) in cases() {
            const BINS: usize = 40;
            let mut counts = [0; BINS];
            for i in 0..100_000 {
                let [u, _] = random::unit_pair(random::at(9, i));
                let (x, _) = filter.along(u);
                assert!(x.abs() <= radius);
                let bin = ((x / radius + 1.0) * 0.5 * BINS as f64) as usize;
                counts[bin.min(BINS - 1)] += 1;
            }
            let edge = |i: usize| radius * (2.0 * i as f64 / BINS as f64 - 1.0);
            let masses: Vec<_> =
                (0..BINS).map(|i| integral(|x| f(x).abs(), edge(i), edge(i + 1))).collect();
            let all: f64 = masses.iter().sum();
            let probabilities: Vec<_> = masses.iter().map(|mass| mass / all).collect();
            chi_squared::assert_fits(&counts, &probabilities);
        }
    }

    #[test]
    fn weights_have_mean_one_and_the_filters_sign() {
        for (filter, _, f) in cases() {
            let n = 1 << 20;
            let mut mean = 0.0;
            for i in 0..n {
                let (x, weight) = filter.along((f64::from(i) + 0.5) / f64::from(n));
                mean += weight / f64::from(n);
                assert!(weight * f(x) >= -1e-9, "weight {weight} where the filter is {}", f(x));
            }
            assert!((mean - 1.0).abs() < 1e-5, "{mean}");
        }
    }

    #[test]
    fn a_step_becomes_the_integral_of_the_filter() {
        // A picture that is 1 left of `edge` and 0 right of it, by an even march through u.
        for (filter, radius, f) in cases() {
            for edge in [-0.3, 0.0, 0.45 * radius, 0.8 * radius] {
                let n = 1 << 20;
                let lit = (0..n).map(|i| filter.along((f64::from(i) + 0.5) / f64::from(n)));
                let found: f64 =
                    lit.filter(|(x, _)| *x < edge).map(|(_, w)| w).sum::<f64>() / f64::from(n);
                let expected =
                    integral(&f, -radius, edge.max(-radius)) / integral(&f, -radius, radius);
                assert!((found - expected).abs() < 2e-5, "{found} for {expected} at {edge}");
            }
        }
    }

    #[test]
    fn extreme_settings_stay_finite() {
        for radius in [0.01, 8.0] {
            for other in [0.01, 8.0] {
                for filter in [Filter::gaussian(radius, other), Filter::mitchell(radius, 1.0, 1.0)]
                {
                    for u in [0.0, 0.25, 0.5, 1.0 - f64::EPSILON] {
                        let (x, y, weight) = filter.sample([u, 1.0 - f64::EPSILON - u]);
                        assert!(x.abs() <= radius && y.abs() <= radius && weight.is_finite());
                    }
                }
            }
        }
    }
}
