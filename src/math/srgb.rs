//! The transfer function of sRGB [IEC 61966-2-1]: between linear components and those a display
//! is sent, both in [0, 1]; what lies beyond is clipped.

/// From linear to encoded.
pub fn encode(linear: f64) -> f64 {
    match linear {
        // 1.055 − 0.055 is not 1 in f64.
        linear if linear >= 1.0 => 1.0,
        linear if linear <= 0.0031308 => 12.92 * linear.max(0.0),
        linear => 1.055 * linear.powf(1.0 / 2.4) - 0.055,
    }
}

/// From encoded to linear.
pub fn decode(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        encoded.max(0.0) / 12.92
    } else {
        ((encoded.min(1.0) + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_and_the_ends() {
        assert!((encode(0.5) - 0.735_356_98).abs() < 1e-8);
        assert!((decode(0.5) - 0.214_041_14).abs() < 1e-8);
        assert_eq!((encode(-1.0), encode(7.0)), (0.0, 1.0));
        assert_eq!((decode(-1.0), decode(7.0)), (0.0, 1.0));
    }

    #[test]
    fn every_byte_comes_back() {
        for byte in 0..=255 {
            let linear = decode(f64::from(byte) / 255.0) as f32;
            assert_eq!((encode(f64::from(linear)) * 255.0).round() as i32, byte);
        }
    }
}
