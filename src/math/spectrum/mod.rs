//! A quantity over the visible wavelengths, as an author states it.
//!
//! Plain data. What a formula is worth at a wavelength, and what three channels make of a
//! spectrum, is told by `optics`.

mod table;

use serde::Serialize;

pub use table::{Table, union};

/// A spectrum in f64; its dimension is said where it stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub enum Spectrum {
    /// The same at every wavelength, and in every channel.
    Constant(f64),
    /// Linear components, primaries of sRGB.
    Rgb([f64; 3]),
    /// Values at wavelengths.
    Table(Table),
    /// A formula, times a number.
    Formula {
        /// The formula.
        formula: Formula,
        /// The number.
        scale: f64,
    },
}

/// Formulas over the wavelength λ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub enum Formula {
    /// The spectral radiance of a black body of a temperature in K, in W/m²/sr/m.
    Blackbody(f64),
    /// An index n of refraction: n² = 1 + Σ B λ² / (λ² − C). Pairs of B, and C in µm².
    Sellmeier(Vec<(f64, f64)>),
    /// An index n of refraction: n = A + B / λ² + C / λ⁴, in powers of µm.
    Cauchy([f64; 3]),
    /// An index n of refraction: n² = A₀ + A₁ λ² + A₂ λ⁻² + A₃ λ⁻⁴ + A₄ λ⁻⁶ + A₅ λ⁻⁸, in powers
    /// of µm.
    Series([f64; 6]),
}

impl Spectrum {
    /// A formula as it is.
    pub fn of(formula: Formula) -> Self {
        Self::Formula { formula, scale: 1.0 }
    }

    /// Whether it is zero at every wavelength.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Constant(value) => *value == 0.0,
            Self::Rgb(components) => *components == [0.0; 3],
            Self::Table(table) => table.nodes().iter().all(|(_, value)| *value == 0.0),
            Self::Formula { scale, .. } => *scale == 0.0,
        }
    }

    /// Times a number.
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Constant(value) => Self::Constant(value * factor),
            Self::Rgb(components) => Self::Rgb(components.map(|c| c * factor)),
            Self::Table(table) => Self::Table(table.map(|value| value * factor)),
            Self::Formula { formula, scale } => {
                Self::Formula { formula: formula.clone(), scale: scale * factor }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_keeps_what_a_spectrum_is() {
        let formula = Spectrum::of(Formula::Blackbody(3000.0));
        let twice = Spectrum::Formula { formula: Formula::Blackbody(3000.0), scale: 2.0 };
        assert_eq!(formula.scaled(2.0), twice);
        assert_eq!(Spectrum::Rgb([1.0, 0.0, 3.0]).scaled(2.0), Spectrum::Rgb([2.0, 0.0, 6.0]));
        assert!(formula.scaled(0.0).is_zero() && !formula.is_zero());
    }
}
