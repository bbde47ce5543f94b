//! Edges and points of a picture as the eye finds them: first and second derivatives of a
//! Gaussian [Andersson20].

use crate::measure::planes::Plane;

/// Width of the feature detector in degrees of view; its standard deviation is half of it.
const WIDTH: f64 = 0.082;

/// The exponent of a difference of features: small ones count for more than in proportion.
const EXPONENT: f32 = 0.5;

/// How strongly a pixel is an edge, and how strongly a point.
pub(super) fn of(luminance: &Plane, pixels_per_degree: f64) -> Vec<[f32; 2]> {
    let deviation = 0.5 * WIDTH * pixels_per_degree;
    let reach = (3.0 * deviation).ceil() as i64;
    let profile = |of: &dyn Fn(f64, f64) -> f64| -> Vec<f32> {
        let bell = |x: f64| (-x * x / (2.0 * deviation * deviation)).exp();
        balanced((-reach..=reach).map(|x| of(x as f64, bell(x as f64))).collect())
    };
    let smooth = profile(&|_, bell| bell);
    let slope = profile(&|x, bell| -x * bell);
    let bend = profile(&|x, bell| (x * x / (deviation * deviation) - 1.0) * bell);

    let smooth_down = luminance.filtered_down(&smooth);
    let smooth_along = luminance.filtered_along(&smooth);
    let strength = |derivative: &[f32]| {
        let x = smooth_down.filtered_along(derivative).values;
        let y = smooth_along.filtered_down(derivative).values;
        x.into_iter().zip(y).map(|(x, y)| x.hypot(y))
    };
    strength(&slope).zip(strength(&bend)).map(|(edge, point)| [edge, point]).collect()
}

/// The difference of features in [0, 1].
pub(super) fn difference([edge, point]: [f32; 2], [other_edge, other_point]: [f32; 2]) -> f32 {
    let larger = (edge - other_edge).abs().max((point - other_point).abs());
    (larger * std::f32::consts::FRAC_1_SQRT_2).powf(EXPONENT).min(1.0)
}

/// Weights scaled so that the positive ones sum to 1 and the negative ones, if any, to −1.
fn balanced(weights: Vec<f64>) -> Vec<f32> {
    let sum = |sign: f64| weights.iter().map(|w| (w * sign).max(0.0)).sum::<f64>();
    let (up, down) = (sum(1.0), sum(-1.0));
    weights
        .iter()
        .map(|&w| if w > 0.0 { w / up } else { w / down.max(f64::MIN_POSITIVE) } as f32)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_balanced() {
        assert_eq!(balanced(vec![2.0, -1.0, 6.0, -3.0]), [0.25, -0.25, 0.75, -0.75]);
        assert_eq!(balanced(vec![1.0, 3.0]), [0.25, 0.75]);
        assert_eq!(balanced(vec![0.0, 3.0]), [0.0, 1.0]);
    }

    #[test]
    fn a_step_is_an_edge_and_a_dot_is_a_point() {
        let (width, height) = (40, 40);
        let mut step = Plane::zero(width, height);
        for y in 0..height {
            step.values[y * width + 20..(y + 1) * width].fill(1.0);
        }
        let [edge, point] = of(&step, 67.0)[20 * width + 20];
        assert!(edge > 0.85 && edge > 2.0 * point, "{edge} {point}");
        let mut dot = Plane::zero(width, height);
        dot.values[20 * width + 20] = 1.0;
        let [edge, point] = of(&dot, 67.0)[20 * width + 20];
        assert!(edge < 1e-6 && point > 0.01, "{edge} {point}");
    }
}
