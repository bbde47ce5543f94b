//! What of a picture's detail the eye still sees at a distance: contrast sensitivity as a blur,
//! one for each opponent channel [Andersson20].

use std::f64::consts::PI;

use super::colour::{Opponent, perceived as to_perceived};
use crate::measure::planes::Plane;

/// One Gaussian of a filter in degrees of view x: `scale` √(π/`spread`) exp(−π² x² / `spread`).
struct Bell {
    scale: f64,
    spread: f64,
}

/// Light-dark.
const ACHROMATIC: [Bell; 1] = [Bell { scale: 1.0, spread: 0.0047 }];

/// Red-green.
const RED_GREEN: [Bell; 1] = [Bell { scale: 1.0, spread: 0.0053 }];

/// Blue-yellow, seen the least sharply.
const BLUE_YELLOW: [Bell; 2] =
    [Bell { scale: 34.1, spread: 0.04 }, Bell { scale: 13.5, spread: 0.025 }];

/// The widest spread: every filter reaches three of its standard deviations.
const WIDEST: f64 = 0.04;

/// What is perceived of each pixel: blurred as the eye does, in CIELAB with the Hunt effect.
pub(super) fn perceived(opponent: &Opponent, pixels_per_degree: f64) -> Vec<[f32; 3]> {
    let [y, cx, cz] = &opponent.planes;
    let y = blurred(y, &ACHROMATIC, pixels_per_degree);
    let cx = blurred(cx, &RED_GREEN, pixels_per_degree);
    let cz = blurred(cz, &BLUE_YELLOW, pixels_per_degree);
    let channels = y.values.iter().zip(&cx.values).zip(&cz.values);
    channels.map(|((&y, &cx), &cz)| to_perceived([y, cx, cz])).collect()
}

/// The plane under a sum of Gaussians, all weights together one.
fn blurred(plane: &Plane, bells: &[Bell], pixels_per_degree: f64) -> Plane {
    let profiles: Vec<Vec<f64>> =
        bells.iter().map(|b| profile(b.spread, pixels_per_degree)).collect();
    // Each Gaussian is separable, their sum is not: its weights are the squares' sums.
    let weight = |bell: &Bell, profile: &[f64]| {
        bell.scale * (PI / bell.spread).sqrt() * profile.iter().sum::<f64>().powi(2)
    };
    let total: f64 = bells.iter().zip(&profiles).map(|(bell, p)| weight(bell, p)).sum();
    let mut out = Plane::zero(plane.width, plane.height);
    for (bell, profile) in bells.iter().zip(&profiles) {
        let share = (weight(bell, profile) / total) as f32;
        let sum: f64 = profile.iter().sum();
        let weights: Vec<f32> = profile.iter().map(|w| (w / sum) as f32).collect();
        for (sum, value) in out.values.iter_mut().zip(plane.filtered(&weights, &weights).values) {
            *sum += share * value;
        }
    }
    out
}

/// exp(−π² x² / spread) at each pixel from the centre out to the reach.
fn profile(spread: f64, pixels_per_degree: f64) -> Vec<f64> {
    let deviation = (WIDEST / (2.0 * PI * PI)).sqrt();
    let reach = (3.0 * deviation * pixels_per_degree).ceil() as i64;
    (-reach..=reach)
        .map(|i| (-(PI * i as f64 / pixels_per_degree).powi(2) / spread).exp())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blur_keeps_what_is_even_and_spreads_what_is_not() {
        let even = Plane { width: 30, height: 30, values: vec![7.0; 900] };
        let mut point = Plane::zero(41, 41);
        point.values[20 * 41 + 20] = 1.0;
        for bells in [&ACHROMATIC[..], &RED_GREEN[..], &BLUE_YELLOW[..]] {
            assert!(blurred(&even, bells, 67.0).values.iter().all(|v| (v - 7.0).abs() < 1e-4));
            let spread = blurred(&point, bells, 67.0);
            assert!((spread.values.iter().sum::<f32>() - 1.0).abs() < 1e-5);
        }
        let peak = |bells: &[Bell]| blurred(&point, bells, 67.0).values[20 * 41 + 20];
        assert!(
            peak(&ACHROMATIC) > peak(&RED_GREEN) && peak(&RED_GREEN) > 3.0 * peak(&BLUE_YELLOW)
        );
    }

    #[test]
    fn at_a_distance_more_is_blurred() {
        assert_eq!(profile(WIDEST, 67.02).len(), 21);
        assert!(profile(WIDEST, 134.0).len() > 35);
    }
}
