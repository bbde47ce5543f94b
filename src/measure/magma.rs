//! Magma: a map of [0, 1] to colours of even steps in lightness, from black over purple and
//! orange to pale yellow. Readable in grey and by the colour-blind.

use super::planes::Plane;
use crate::math::{Picture, Rgb, srgb};

/// Eighteen even stops of magma as sRGB bytes, by Stéfan van der Walt and Nathaniel Smith (CC0);
/// between them it is straight to within three steps in 255.
const STOPS: [[u8; 3]; 18] = [
    [0x00, 0x00, 0x04],
    [0x09, 0x07, 0x20],
    [0x1a, 0x10, 0x42],
    [0x31, 0x11, 0x65],
    [0x4a, 0x10, 0x79],
    [0x62, 0x19, 0x80],
    [0x79, 0x22, 0x82],
    [0x91, 0x2b, 0x81],
    [0xaa, 0x33, 0x7d],
    [0xc2, 0x3b, 0x75],
    [0xd9, 0x46, 0x6b],
    [0xec, 0x58, 0x60],
    [0xf7, 0x72, 0x5c],
    [0xfc, 0x8e, 0x64],
    [0xfe, 0xaa, 0x74],
    [0xfe, 0xc6, 0x8a],
    [0xfd, 0xe2, 0xa3],
    [0xfc, 0xfd, 0xbf],
];

/// The linear colour of `t`, which is clipped to [0, 1].
pub fn magma(t: f32) -> Rgb {
    let place = f64::from(t.clamp(0.0, 1.0)) * (STOPS.len() - 1) as f64;
    let low = (place as usize).min(STOPS.len() - 2);
    let part = place - low as f64;
    let [r, g, b] = [0, 1, 2].map(|channel| {
        let [from, to] = [low, low + 1].map(|i| f64::from(STOPS[i][channel]) / 255.0);
        srgb::decode(from + part * (to - from)) as f32
    });
    Rgb::new(r, g, b)
}

/// A plane of numbers in [0, 1] as a picture.
pub fn in_magma(plane: &Plane) -> Picture {
    let pixels = plane.values.iter().map(|&value| magma(value)).collect();
    Picture { width: plane.width, height: plane.height, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_middle_are_the_stops() {
        let bytes = |t: f32| {
            magma(t).to_array().map(|c| (srgb::encode(f64::from(c)) * 255.0).round() as u8)
        };
        assert_eq!(bytes(0.0), [0x00, 0x00, 0x04]);
        assert_eq!(bytes(-3.0), [0x00, 0x00, 0x04]);
        assert_eq!(bytes(1.0), [0xfc, 0xfd, 0xbf]);
        assert_eq!(bytes(5.0 / 17.0), [0x62, 0x19, 0x80]);
        // matplotlib's magma at 0.5 is (183, 55, 121).
        for (found, wanted) in bytes(0.5).iter().zip([183, 55, 121]) {
            assert!(found.abs_diff(wanted) <= 3, "{:?}", bytes(0.5));
        }
    }

    #[test]
    fn lightness_rises_all_the_way() {
        let lightness: Vec<f32> = (0..=170).map(|i| magma(i as f32 / 170.0).luminance()).collect();
        assert!(lightness.windows(2).all(|pair| pair[0] < pair[1]), "{lightness:?}");
    }
}
