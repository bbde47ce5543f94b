//! FLIP: how different two pictures look to a person who flips between them, pixel by pixel in
//! [0, 1]. For pictures as displayed [Andersson20], and for any range of radiance [Andersson21].
//!
//! Written from the papers; tests/peers holds it to NVIDIA's flip-evaluator within 1e-3.

mod colour;
mod exposures;
mod features;
mod sensitivity;

use crate::math::{Picture, Rgb};
use crate::measure::planes::Plane;
use colour::Opponent;

pub use exposures::{Exposures, tone_map};

/// A 3840 pixel screen 0.7 m wide seen from 0.7 m: 3840 · π / 180 pixels a degree of view.
pub const PIXELS_PER_DEGREE: f64 = 3840.0 * std::f64::consts::PI / 180.0;

/// What HDR-FLIP found.
#[derive(Clone, Debug, PartialEq)]
pub struct Hdr {
    /// For each pixel its largest error over all exposures, in [0, 1].
    pub map: Plane,
    /// The exposures looked at.
    pub exposures: Exposures,
}

/// The error a person sees between two pictures of linear colour, each component clipped to what
/// a display can show, [0, 1]. `pixels_per_degree` (> 0) is how fine the display is seen.
///
/// # Panics
/// If the pictures differ in size.
pub fn ldr(reference: &Picture, test: &Picture, pixels_per_degree: f64) -> Plane {
    assert_eq!((reference.width, reference.height), (test.width, test.height), "one size");
    shown(reference, test, pixels_per_degree, |pixel| pixel)
}

/// The largest error a person sees under any exposure that makes sense of the reference: each
/// picture is exposed, tone-mapped, and compared as [`ldr`] does. Negative components count as
/// black. `None` when the reference is black: no exposure makes sense of it.
///
/// # Panics
/// If the pictures differ in size.
pub fn hdr(reference: &Picture, test: &Picture, pixels_per_degree: f64) -> Option<Hdr> {
    assert_eq!((reference.width, reference.height), (test.width, test.height), "one size");
    let exposures = Exposures::of(reference)?;
    let mut map = Plane::zero(reference.width, reference.height);
    for stops in exposures.stops() {
        let factor = stops.exp2() as f32;
        let map_here = shown(reference, test, pixels_per_degree, |pixel| {
            let [r, g, b] = pixel.to_array().map(|component| tone_map(component * factor));
            Rgb::new(r, g, b)
        });
        for (worst, here) in map.values.iter_mut().zip(map_here.values) {
            *worst = worst.max(here);
        }
    }
    Some(Hdr { map, exposures })
}

/// LDR-FLIP of both pictures after `display` made each pixel what the screen is to show.
fn shown(
    reference: &Picture,
    test: &Picture,
    pixels_per_degree: f64,
    display: impl Fn(Rgb) -> Rgb,
) -> Plane {
    let seen = |picture: &Picture| {
        let opponent = Opponent::of(picture, &display);
        let colours = sensitivity::perceived(&opponent, pixels_per_degree);
        (colours, features::of(&opponent.luminance(), pixels_per_degree))
    };
    let (colours_r, features_r) = seen(reference);
    let (colours_t, features_t) = seen(test);
    let differences = colours_r.iter().zip(&colours_t).zip(features_r.iter().zip(&features_t));
    let values = differences.map(|((ca, cb), (fa, fb))| {
        // A difference of edges or points adds to one of colour.
        colour::difference(*ca, *cb).powf(1.0 - features::difference(*fa, *fb))
    });
    Plane { width: reference.width, height: reference.height, values: values.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(pixel: Rgb) -> Picture {
        Picture { width: 6, height: 5, pixels: vec![pixel; 30] }
    }

    #[test]
    fn nothing_differs_from_itself() {
        let pixels = (0..30).map(|i| Rgb::new(i as f32 * 0.1, 0.3, 4.0 - i as f32 * 0.1));
        let picture = Picture { width: 6, height: 5, pixels: pixels.collect() };
        assert_eq!(ldr(&picture, &picture, PIXELS_PER_DEGREE).mean(), 0.0);
        assert_eq!(hdr(&picture, &picture, PIXELS_PER_DEGREE).unwrap().map.mean(), 0.0);
    }

    #[test]
    fn green_and_blue_differ_most() {
        let (green, blue) = (flat(Rgb::new(0.0, 1.0, 0.0)), flat(Rgb::new(0.0, 0.0, 1.0)));
        let map = ldr(&green, &blue, PIXELS_PER_DEGREE);
        assert!(map.values.iter().all(|v| (v - 1.0).abs() < 1e-3), "{:?}", map.values);
    }

    #[test]
    fn a_display_clips() {
        let (bright, white) = (flat(Rgb::grey(7.0)), flat(Rgb::ONE));
        assert!(ldr(&bright, &white, PIXELS_PER_DEGREE).mean() < 1e-6);
        assert!(hdr(&bright, &white, PIXELS_PER_DEGREE).unwrap().map.mean() > 0.3);
    }

    #[test]
    fn a_black_reference_has_no_exposure() {
        assert!(hdr(&flat(Rgb::BLACK), &flat(Rgb::ONE), PIXELS_PER_DEGREE).is_none());
        assert!(hdr(&flat(Rgb::grey(-1.0)), &flat(Rgb::ONE), PIXELS_PER_DEGREE).is_none());
    }

    #[test]
    fn huge_radiances_stay_in_range() {
        let mut sun = flat(Rgb::grey(0.5));
        sun.pixels[7] = Rgb::grey(f32::MAX);
        let found = hdr(&sun, &flat(Rgb::grey(0.5)), PIXELS_PER_DEGREE).unwrap();
        assert!(found.map.values.iter().all(|v| (0.0..=1.0).contains(v)), "{found:?}");
    }
}
