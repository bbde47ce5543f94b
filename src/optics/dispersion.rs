//! How the index of refraction of clear matter falls with the wavelength: the formulas that are
//! fitted to measurements [Born99, sec. 2.3.4].
//!
//! Wavelengths in nm, coefficients in powers of micrometres as catalogues print them.

/// Sellmeier's index for pairs of B, and C in µm²: n² = 1 + Σ B λ² / (λ² − C). NaN where n² is
/// negative; infinite at a resonance, λ² = C.
pub fn sellmeier(terms: &[(f64, f64)], nm: f64) -> f64 {
    let squared = square_um(nm);
    let sum: f64 = terms.iter().map(|(b, c)| b * squared / (squared - c)).sum();
    (1.0 + sum).sqrt()
}

/// Cauchy's index: n = A + B / λ² + C / λ⁴.
pub fn cauchy([a, b, c]: [f64; 3], nm: f64) -> f64 {
    let squared = square_um(nm);
    a + b / squared + c / (squared * squared)
}

/// The index by the series of older catalogues:
/// n² = A₀ + A₁ λ² + A₂ λ⁻² + A₃ λ⁻⁴ + A₄ λ⁻⁶ + A₅ λ⁻⁸.
pub fn series(terms: [f64; 6], nm: f64) -> f64 {
    let squared = square_um(nm);
    let [a0, a1, falling @ ..] = terms;
    let tail = falling.iter().rev().fold(0.0, |sum, a| (sum + a) / squared);
    (a0 + a1 * squared + tail).sqrt()
}

/// λ² in µm².
fn square_um(nm: f64) -> f64 {
    (nm * 1e-3).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::{Figures, Glass, shelf};

    /// Fraunhofer's lines d, F, C in nm.
    const LINES: [f64; 3] = [587.5618, 486.1327, 656.2725];

    fn index(word: &str, nm: f64) -> f64 {
        let datum = shelf("glass").unwrap().find(word).unwrap();
        match datum.figures {
            Figures::Glass(Glass::Sellmeier(terms)) => sellmeier(terms, nm),
            Figures::Glass(Glass::Series(terms)) => series(terms, nm),
            _ => panic!("{word} is no glass"),
        }
    }

    /// The maker's index and Abbe number, or the glass code, or what handbooks say.
    #[test]
    fn glasses_have_the_indices_of_their_catalogues() {
        let known = [
            ("bk7", 1.5168, 64.17),
            ("f2", 1.62004, 36.37),
            ("lf5", 1.58144, 40.85),
            ("n_fk51a", 1.48656, 84.47),
            ("n_k5", 1.52249, 59.48),
            ("n_lasf9", 1.85025, 32.17),
            ("n_sf11", 1.78472, 25.68),
            ("n_sf66", 1.92286, 20.88),
            ("sf10", 1.72825, 28.41),
            ("sf11", 1.78472, 25.76),
            ("sf6", 1.80518, 25.43),
            ("tik1", 1.4787, 58.70),
            ("k5", 1.5225, 59.49),
            ("kf9", 1.5234, 51.49),
            ("basf10", 1.6502, 39.15),
            ("fused_silica", 1.45846, 67.82),
            ("diamond", 2.41749, 55.30),
            ("sapphire_o", 1.76817, 72.31),
            ("sapphire_e", 1.76010, 72.99),
        ];
        for (word, index_d, abbe) in known {
            let [d, f, c] = LINES.map(|nm| index(word, nm));
            assert!((d - index_d).abs() < 6e-5, "{word}: {d}, not {index_d}");
            let found = (d - 1.0) / (f - c);
            assert!((found - abbe).abs() < 6e-3, "{word}: {found}, not {abbe}");
        }
        assert_eq!(shelf("glass").unwrap().data().count(), known.len());
    }

    #[test]
    fn glasses_at_three_lines() {
        let known = [
            ("bk7", [1.516800, 1.522376, 1.514322]),
            ("f2", [1.620040, 1.632081, 1.615032]),
            ("sf10", [1.728250, 1.746481, 1.720848]),
            ("sf11", [1.784720, 1.806454, 1.775988]),
        ];
        for (word, expected) in known {
            for (nm, expected) in LINES.into_iter().zip(expected) {
                assert!((index(word, nm) - expected).abs() < 6e-7, "{word} at {nm} nm");
            }
        }
    }

    #[test]
    fn cauchy_by_hand() {
        assert!((cauchy([1.5, 0.004, 0.0001], 500.0) - (1.5 + 0.016 + 0.0016)).abs() < 1e-14);
        assert!(sellmeier(&[(-3.0, 0.01)], 500.0).is_nan());
    }
}
