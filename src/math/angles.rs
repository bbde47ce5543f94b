//! Angles, sines and cosines in f64 by polynomials: the same bits on every processor, and without
//! jumps, so that loops over them become vectors.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};

/// tan(π/8): angles beyond it are measured from π/4.
const EIGHTH: f64 = 0.414_213_562_373_095_05;

/// The angle of the point (x, y) from the x axis, in [-π, π], within two units in its last place;
/// 0 of the origin. For coordinates whose sum is finite.
#[inline(always)]
pub fn atan2(y: f64, x: f64) -> f64 {
    let (far, near) = (x.abs().max(y.abs()), x.abs().min(y.abs()));
    // tan(a − π/4) = (tan a − 1) / (tan a + 1).
    let beyond = near > EIGHTH * far;
    let above = if beyond { near - far } else { near };
    let below = if beyond { near + far } else { far };
    let t = above / below;
    let t = if below > 0.0 { t } else { 0.0 };
    let z = t * t;
    // atan(t)/t as a polynomial in t², by Chebyshev's points: within 2e-18.
    let even = 0.037_965_257_453_853_62 + z * -0.017_805_397_205_405_795;
    let even = 0.058_468_782_973_307_675 + z * (-0.050_351_024_566_010_73 + z * even);
    let even = 0.076_920_453_309_022_24 + z * (-0.066_629_518_136_291_76 + z * even);
    let even = 0.111_111_107_449_196_58 + z * (-0.090_908_968_090_640_27 + z * even);
    let even = 0.199_999_999_999_408_9 + z * (-0.142_857_142_792_502_45 + z * even);
    let tail = z * (-0.333_333_333_333_331_2 + z * even);
    let angle = t + t * tail + if beyond { FRAC_PI_4 } else { 0.0 };
    let angle = if y.abs() > x.abs() { FRAC_PI_2 - angle } else { angle };
    let angle = if x < 0.0 { PI - angle } else { angle };
    if y < 0.0 { -angle } else { angle }
}

/// Adding it to a number of less than 2⁵¹ and taking it off again leaves the nearest whole number.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// π/2 in two parts, the first of so few digits that small multiples of it are exact.
const QUARTER: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];

/// Sine and cosine of an angle of a few turns at most, within 2e-16.
#[inline(always)]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = (angle * FRAC_2_PI + ROUNDER) - ROUNDER;
    let r = (angle - quarters * QUARTER[0]) - quarters * QUARTER[1];
    // Both series, of an angle of at most π/4.
    let z = r * r;
    let s = 1.0 / 6_227_020_800.0 + z * (-1.0 / 1_307_674_368_000.0);
    let s = 1.0 / 362_880.0 + z * (-1.0 / 39_916_800.0 + z * s);
    let s = 1.0 / 120.0 + z * (-1.0 / 5040.0 + z * s);
    let sin = r + r * (z * (-1.0 / 6.0 + z * s));
    let c = -1.0 / 87_178_291_200.0 + z * (1.0 / 20_922_789_888_000.0);
    let c = -1.0 / 3_628_800.0 + z * (1.0 / 479_001_600.0 + z * c);
    let c = -1.0 / 720.0 + z * (1.0 / 40_320.0 + z * c);
    let cos = 1.0 + z * (-0.5 + z * (1.0 / 24.0 + z * c));
    // The quarters, less whole turns: from -2 to 2.
    let rest = quarters - 4.0 * ((quarters * 0.25 + ROUNDER) - ROUNDER);
    let opposite = rest.abs() == 2.0;
    let (a, b) = if rest.abs() == 1.0 { (cos, sin) } else { (sin, cos) };
    let a = if opposite | (rest == -1.0) { -a } else { a };
    let b = if opposite | (rest == 1.0) { -b } else { b };
    (a, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random;

    #[test]
    fn angles_are_as_the_library_has_them() {
        for i in 0..100_000 {
            let [x, y] = random::unit_pair(random::at(51, i)).map(|u| 2.0 * u - 1.0);
            let small = 10_f64.powf(-20.0 * random::unit_pair(random::at(52, i))[0]);
            let (x, y) = [(x, y), (small * x, y), (x, small * y)][(i % 3) as usize];
            let (found, truth) = (atan2(y, x), y.atan2(x));
            assert!((found - truth).abs() <= 4e-16 * truth.abs(), "{y} {x}: {found}, not {truth}");
        }
        for y in [-1.0_f64, 0.0, 1.0] {
            for x in [-1.0, 0.0, 1.0] {
                assert!((atan2(y, x) - y.atan2(x)).abs() < 1e-15, "{y} {x}");
            }
        }
    }

    #[test]
    fn sines_and_cosines_are_as_the_library_has_them() {
        for i in 0..100_000_u32 {
            let angle = 20.0 * (f64::from(i) / 50_000.0 - 1.0);
            let ((sin, cos), truth) = (sin_cos(angle), angle.sin_cos());
            let off = (sin - truth.0).abs().max((cos - truth.1).abs());
            assert!(off <= 2.3e-16, "{angle}: {off:e}");
        }
    }
}
