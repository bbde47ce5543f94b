//! The light of a black body: Planck's law, with the constants of the SI of 2019 [BIPM19].

/// Planck's constant in J s.
const H: f64 = 6.626_070_15e-34;
/// The speed of light in m/s.
const C: f64 = 299_792_458.0;
/// Boltzmann's constant in J/K.
const K: f64 = 1.380_649e-23;

/// Spectral radiance in W/m²/sr per metre of wavelength, of a body at `kelvin` > 0 at a wavelength
/// in nm > 0 of vacuum. Good to a few parts in 1e14 wherever the result can be represented; below
/// that it is zero.
pub fn radiance(kelvin: f64, nm: f64) -> f64 {
    let metres = nm * 1e-9;
    let x = H * C / K / metres / kelvin;
    // One exponent: the power of the wavelength and the exponential would leave the range of f64
    // long before their product does. −expm1(−x) keeps its digits where x is small.
    ((2.0 * H * C * C).ln() - 5.0 * metres.ln() - x).exp() / -(-x).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_radiances() {
        // By Python's mpmath with 30 digits.
        let known = [
            (2856.0, 560.0, 2.680_081_428_384_936_1e11),
            (6500.0, 450.0, 4.751_173_613_156_218e13),
            (300.0, 500.0, 8.398_856_670_693_367e-27),
            (1e9, 780.0, 2.236_410_718_446_859_3e19),
        ];
        for (kelvin, nm, expected) in known {
            let found = radiance(kelvin, nm);
            assert!((found / expected - 1.0).abs() < 1e-12, "{found:e}, not {expected:e}");
        }
    }

    #[test]
    fn the_brightest_wavelength_follows_wien() {
        for kelvin in [1000.0, 2856.0, 6500.0, 30_000.0] {
            let peak = 2.897_771_955e6 / kelvin;
            let at = radiance(kelvin, peak);
            assert!(at > radiance(kelvin, peak * 1.001) && at > radiance(kelvin, peak / 1.001));
        }
    }

    #[test]
    fn all_wavelengths_together_follow_stefan_and_boltzmann() {
        let kelvin = 5000.0;
        // The trapezoid over the logarithm of the wavelength, which converges fast: the ends vanish.
        let step = 1e-3_f64;
        let part = |i: i32| {
            let nm = 1e3 * (f64::from(i) * step).exp();
            radiance(kelvin, nm) * nm * 1e-9 * step
        };
        let sum: f64 = (-4000..12_000).map(part).sum();
        let expected = 5.670_374_419e-8 * kelvin.powi(4) / std::f64::consts::PI;
        assert!((sum / expected - 1.0).abs() < 1e-8, "{sum}, not {expected}");
    }

    #[test]
    fn tails_are_finite() {
        assert_eq!(radiance(1.0, 380.0), 0.0);
        assert!(radiance(1e-300, 1e-300) >= 0.0);
        // Rayleigh and Jeans: 2 c k T / λ⁴.
        let expected = 2.0 * C * K * 1e9 / 1e-12;
        assert!((radiance(1e9, 1e6) / expected - 1.0).abs() < 1e-6);
    }
}
