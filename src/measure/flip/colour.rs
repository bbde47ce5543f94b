//! The colour spaces of FLIP and its measure of colour difference [Andersson20].

use crate::math::{Picture, Rgb};
use crate::measure::planes::Plane;

/// Linear sRGB to CIE XYZ, from the primaries and the white point (.3127, .3290) of BT.709.
const TO_XYZ: [[f32; 3]; 3] = [
    [0.412_390_8, 0.357_584_34, 0.180_480_8],
    [0.212_639, 0.715_168_7, 0.072_192_32],
    [0.019_330_82, 0.119_194_78, 0.950_532_15],
];

/// Its inverse.
const FROM_XYZ: [[f32; 3]; 3] = [
    [3.240_97, -1.537_383_2, -0.498_610_76],
    [-0.969_243_64, 1.875_967_5, 0.041_555_06],
    [0.055_630_08, -0.203_976_96, 1.056_971_5],
];

/// XYZ of white: the sums of the rows of `TO_XYZ`.
const WHITE: [f32; 3] = [0.950_455_94, 1.0, 1.089_057_8];

/// The exponent that makes large differences of colour count less than in proportion.
const COMPRESSION: f32 = 0.7;

/// Compressed differences up to this part of the largest one …
const KNEE: f32 = 0.4;

/// … are spread over the scale from 0 to this, the rest over what remains up to 1.
const KNEE_SHARE: f32 = 0.95;

/// YCxCz: linear opponent channels, light-dark, red-green and blue-yellow, in which the eye's
/// blur is applied.
pub(super) struct Opponent {
    pub(super) planes: [Plane; 3],
}

impl Opponent {
    /// Of each pixel after `display`, clipped to [0, 1].
    pub(super) fn of(picture: &Picture, display: &impl Fn(Rgb) -> Rgb) -> Self {
        let mut planes = [(); 3].map(|()| Plane::zero(picture.width, picture.height));
        for (i, pixel) in picture.pixels.iter().enumerate() {
            let linear = display(*pixel).to_array().map(|c| c.clamp(0.0, 1.0));
            let [x, y, z] = relative_to_white(times(&TO_XYZ, linear));
            planes[0].values[i] = 116.0 * y - 16.0;
            planes[1].values[i] = 500.0 * (x - y);
            planes[2].values[i] = 200.0 * (y - z);
        }
        Self { planes }
    }

    /// Y relative to white.
    pub(super) fn luminance(&self) -> Plane {
        let y = &self.planes[0];
        let values = y.values.iter().map(|v| (v + 16.0) / 116.0).collect();
        Plane { width: y.width, height: y.height, values }
    }
}

/// CIELAB of an opponent colour that the display can show (others are clipped to it), its two
/// chromatic axes scaled by lightness: the Hunt effect, dark colours differ less.
pub(super) fn perceived([lightness, cx, cz]: [f32; 3]) -> [f32; 3] {
    let y = (lightness + 16.0) / 116.0;
    let xyz = [(y + cx / 500.0) * WHITE[0], y * WHITE[1], (y - cz / 200.0) * WHITE[2]];
    hunt_lab(times(&FROM_XYZ, xyz).map(|c| c.clamp(0.0, 1.0)))
}

/// The difference of two perceived colours, in [0, 1].
pub(super) fn difference(a: [f32; 3], b: [f32; 3]) -> f32 {
    let compressed = hyab(a, b).powf(COMPRESSION);
    let largest = largest_difference();
    let knee = KNEE * largest;
    let spread = if compressed < knee {
        KNEE_SHARE / knee * compressed
    } else {
        KNEE_SHARE + (compressed - knee) / (largest - knee) * (1.0 - KNEE_SHARE)
    };
    spread.clamp(0.0, 1.0)
}

/// City-block in lightness, Euclidean in chroma [Abasi20].
fn hyab([l, a, b]: [f32; 3], [m, c, d]: [f32; 3]) -> f32 {
    (l - m).abs() + (a - c).hypot(b - d)
}

/// The largest compressed difference a display can show: of its green and its blue.
fn largest_difference() -> f32 {
    static LARGEST: std::sync::LazyLock<f32> = std::sync::LazyLock::new(|| {
        hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])).powf(COMPRESSION)
    });
    *LARGEST
}

/// Linear sRGB to CIELAB with both chromatic axes times lightness / 100.
fn hunt_lab(linear: [f32; 3]) -> [f32; 3] {
    let [x, y, z] = relative_to_white(times(&TO_XYZ, linear)).map(lab_curve);
    let lightness = 116.0 * y - 16.0;
    let hunt = 0.01 * lightness;
    [lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)]
}

/// CIELAB's cube root with its straight foot.
fn lab_curve(t: f32) -> f32 {
    const BEND: f32 = 6.0 / 29.0;
    if t > BEND * BEND * BEND { t.cbrt() } else { t / (3.0 * BEND * BEND) + 4.0 / 29.0 }
}

fn relative_to_white([x, y, z]: [f32; 3]) -> [f32; 3] {
    [x / WHITE[0], y / WHITE[1], z / WHITE[2]]
}

fn times(matrix: &[[f32; 3]; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    matrix.map(|[a, b, c]| a * x + b * y + c * z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_neutral_and_the_matrices_are_inverse() {
        let [l, a, b] = hunt_lab([1.0; 3]);
        assert!((l - 100.0).abs() < 1e-3 && a.abs() < 1e-3 && b.abs() < 1e-3, "{l} {a} {b}");
        for colour in [[1.0, 0.0, 0.0], [0.2, 0.7, 0.1], [0.0, 0.3, 1.0]] {
            let back = times(&FROM_XYZ, times(&TO_XYZ, colour));
            for (found, wanted) in back.iter().zip(colour) {
                assert!((found - wanted).abs() < 1e-6, "{back:?}");
            }
        }
    }

    #[test]
    fn lab_of_the_primaries() {
        // CIELAB (D65) of sRGB red and blue by scikit-image 0.26.0's rgb2lab; the chromatic axes
        // here are times L/100.
        for (colour, [l, a, b]) in
            [([1.0, 0.0, 0.0], [53.24, 80.09, 67.20]), ([0.0, 0.0, 1.0], [32.30, 79.19, -107.86])]
        {
            let found = hunt_lab(colour);
            assert!((found[0] - l).abs() < 0.02, "{found:?}");
            assert!((found[1] - a * l / 100.0).abs() < 0.03, "{found:?}");
            assert!((found[2] - b * l / 100.0).abs() < 0.03, "{found:?}");
        }
    }

    #[test]
    fn opponent_channels_come_back() {
        let colour = Rgb::new(0.6, 0.2, 0.9);
        let picture = Picture { width: 1, height: 1, pixels: vec![colour] };
        let planes = Opponent::of(&picture, &|p| p).planes;
        let found = perceived([planes[0].values[0], planes[1].values[0], planes[2].values[0]]);
        for (found, wanted) in found.iter().zip(hunt_lab(colour.to_array())) {
            assert!((found - wanted).abs() < 1e-3, "{found} {wanted}");
        }
    }

    #[test]
    fn differences_grow_from_zero_to_one() {
        let lab = |grey: f32| hunt_lab([grey; 3]);
        assert_eq!(difference(lab(0.5), lab(0.5)), 0.0);
        let steps: Vec<f32> = (1..10).map(|i| difference(lab(0.0), lab(i as f32 / 9.0))).collect();
        assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
        assert!(steps.iter().all(|v| (0.0..=1.0).contains(v)), "{steps:?}");
    }
}
