//! The distributions that tests are decided by: normal, Student's t, chi-squared.
//!
//! Incomplete gamma and beta come from `puruspe`; what it lacks, the inverse of Student's t, is
//! found here by bisection, which cannot diverge. Relative accuracy is about 1e-6 or better.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Above this many degrees of freedom Student's t is taken for the normal: a quantile z then
/// moves by the part (z² + 1) / (4 · freedom), some 1e-6.
const NORMAL_FROM: f64 = 1e6;

/// The value a standard normal stays below with probability `p`; infinite at 0 and 1.
pub fn normal_quantile(p: f64) -> f64 {
    match p {
        p if p <= 0.0 => f64::NEG_INFINITY,
        p if p >= 1.0 => f64::INFINITY,
        p if p < 0.5 => -SQRT_2 * puruspe::inverfc(2.0 * p),
        p => SQRT_2 * puruspe::inverfc(2.0 * (1.0 - p)),
    }
}

/// How likely a standard normal is at least `|z|` away from 0. NaN counts as infinitely far.
pub fn normal_two_sided(z: f64) -> f64 {
    if z.is_nan() { 0.0 } else { puruspe::erfc(z.abs() * FRAC_1_SQRT_2).clamp(0.0, 1.0) }
}

/// The value Student's t with `freedom` degrees (> 0, fractions allowed) stays below with
/// probability `p`; infinite at 0 and 1.
pub fn student_t_quantile(p: f64, freedom: f64) -> f64 {
    if freedom >= NORMAL_FROM || p <= 0.0 || p >= 1.0 {
        return normal_quantile(p);
    }
    let both_tails = 2.0 * p.min(1.0 - p);
    if both_tails >= 1.0 {
        return 0.0;
    }
    // The tails shrink as t grows: double until t is past the answer, then halve what is left.
    let (mut low, mut high) = (0.0, 1.0);
    while student_t_two_sided(high, freedom) > both_tails && high < f64::MAX / 2.0 {
        low = high;
        high *= 2.0;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if student_t_two_sided(middle, freedom) > both_tails {
            low = middle;
        } else {
            high = middle;
        }
    }
    high.copysign(p - 0.5)
}

/// How likely Student's t with `freedom` degrees (> 0) is at least `|t|` away from 0. NaN counts
/// as infinitely far.
pub fn student_t_two_sided(t: f64, freedom: f64) -> f64 {
    if t.is_nan() || t.is_infinite() {
        return 0.0;
    }
    if freedom >= NORMAL_FROM {
        return normal_two_sided(t);
    }
    puruspe::betai(0.5 * freedom, 0.5, freedom / (freedom + t * t)).clamp(0.0, 1.0)
}

/// How likely a chi-squared with `freedom` degrees (> 0) is `x` or more.
pub fn chi_squared_survival(x: f64, freedom: f64) -> f64 {
    if x.is_nan() || x == f64::INFINITY {
        0.0
    } else if x <= 0.0 {
        1.0
    } else {
        puruspe::gammq(0.5 * freedom, 0.5 * x).clamp(0.0, 1.0)
    }
}

/// The level each of `tests` independent tests is held to, for the chance `alpha` that any of
/// them fails by accident: 1 − (1 − α)^(1/tests) [Sidak67].
pub fn sidak(alpha: f64, tests: u64) -> f64 {
    -((-alpha).ln_1p() / tests.max(1) as f64).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn near(found: f64, wanted: f64, relative: f64) {
        assert!((found - wanted).abs() <= relative * wanted.abs(), "{found:e}, not {wanted:e}");
    }

    // Figures below: SciPy 1.17.1 (norm.ppf, t.ppf, t.sf, chi2.sf).

    #[test]
    fn normal_quantiles() {
        near(normal_quantile(0.975), 1.959_963_984_540_054, 1e-12);
        near(normal_quantile(1e-9), -5.997_807_015_007_687, 1e-12);
        near(normal_quantile(1.0 - 1e-12), 7.034_486_910_047_836, 1e-9);
        assert!(normal_quantile(0.5).abs() < 1e-15);
        assert_eq!(normal_quantile(0.0), f64::NEG_INFINITY);
        assert_eq!(normal_quantile(1.0), f64::INFINITY);
    }

    #[test]
    fn students_quantiles() {
        near(student_t_quantile(0.975, 1.0), 12.706_204_736_174_694, 1e-10);
        near(student_t_quantile(0.975, 15.0), 2.131_449_545_559_776, 1e-10);
        near(student_t_quantile(0.9, 3.5), 1.576_576_605_136_405_2, 1e-10);
        near(student_t_quantile(1e-9, 5.0), -98.937_224_648_369_96, 1e-10);
        near(student_t_quantile(0.975, 1000.0), 1.962_339_080_826_408_3, 1e-9);
        assert_eq!(student_t_quantile(0.5, 7.0), 0.0);
        // Where the normal takes over there is no step worth seeing.
        near(student_t_quantile(0.995, 0.999e6), student_t_quantile(0.995, 1.001e6), 5e-6);
        near(student_t_quantile(0.975, f64::INFINITY), 1.959_963_984_540_054, 1e-12);
    }

    #[test]
    fn tails() {
        near(student_t_two_sided(40.0, 15.0), 2.0 * 5.845_330_620_433_193e-17, 1e-9);
        near(student_t_two_sided(-2.13, 15.0), 2.0 * 0.025_068_587_480_194_57, 1e-9);
        near(student_t_two_sided(8.0, 50.0), 2.0 * 8.316_483_014_160_684e-11, 1e-9);
        near(normal_two_sided(6.0), 2.0 * 9.865_876_450_376_946e-10, 1e-12);
        near(chi_squared_survival(3.84, 1.0), 0.050_043_521_248_705_19, 1e-9);
        near(chi_squared_survival(300.0, 100.0), 7.412_100_857_323_018e-22, 1e-8);
        near(chi_squared_survival(1e4, 1e4), 0.498_119_365_966_182_67, 1e-8);
        assert_eq!(normal_two_sided(0.0), 1.0);
        assert_eq!(chi_squared_survival(-1.0, 3.0), 1.0);
    }

    #[test]
    fn what_is_not_a_number_is_as_far_off_as_can_be() {
        assert_eq!(normal_two_sided(f64::NAN), 0.0);
        assert_eq!(student_t_two_sided(f64::NAN, 3.0), 0.0);
        assert_eq!(chi_squared_survival(f64::NAN, 3.0), 0.0);
    }

    #[test]
    fn sidak_holds_the_whole_family() {
        near(sidak(0.01, 1), 0.01, 1e-12);
        // (1 − level)^tests = 1 − α, also where 1 − level has few digits left.
        near((1_000_000.0 * (-sidak(0.01, 1_000_000)).ln_1p()).exp(), 0.99, 1e-12);
    }
}
