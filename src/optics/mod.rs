//! Pure physics in f64: what spectra are worth, and what an eye makes of them.
//!
//! Wavelengths are in nanometres. Scattering by spheres comes with the worksheets that need it.

pub mod blackbody;
pub mod colour;
pub mod daylight;
pub mod dispersion;
pub mod fresnel;
pub mod metal;
mod upsampling;
pub mod water;

use crate::math::{Formula, Spectrum, Table};

pub use upsampling::{upsampled_light, upsampled_reflectance};

/// The wavelengths in nm that formulas are tabulated over: what an eye can see, and a little more.
pub const VISIBLE: (u32, u32) = (360, 830);

/// The wavelength in nm at which indices are told in catalogues, and at which they are taken where
/// one is to do for all: the yellow line of helium.
pub const MIDDLE: f64 = 587.6;

/// A formula's value at a wavelength in nm, in the units [`Formula`] names; NaN where an index has
/// no real value.
pub fn value(formula: &Formula, nm: f64) -> f64 {
    match formula {
        Formula::Blackbody(kelvin) => blackbody::radiance(*kelvin, nm),
        Formula::Sellmeier(terms) => dispersion::sellmeier(terms, nm),
        Formula::Cauchy(terms) => dispersion::cauchy(*terms, nm),
        Formula::Series(terms) => dispersion::series(*terms, nm),
    }
}

/// What a spectrum is worth at a wavelength in nm; of three channels, their mean.
pub fn at(spectrum: &Spectrum, nm: f64) -> f64 {
    match spectrum {
        Spectrum::Constant(value) => *value,
        Spectrum::Rgb([r, g, b]) => (r + g + b) / 3.0,
        Spectrum::Table(table) => table.at(nm),
        Spectrum::Formula { formula, scale } => scale * value(formula, nm),
    }
}

/// A spectrum as a table; None for a colour, which says nothing of wavelengths. Formulas are
/// tabulated every nanometre over [`VISIBLE`]: lines between are within 2e-4 of a black body of
/// 2000 K or more, and within 2e-6 of the index of any glass.
pub fn tabulated(spectrum: &Spectrum) -> Option<Table> {
    match spectrum {
        Spectrum::Constant(value) => Table::new(vec![(560.0, *value)]),
        Spectrum::Rgb(_) => None,
        Spectrum::Table(table) => Some(table.clone()),
        Spectrum::Formula { formula, scale } => {
            let node = |nm| (f64::from(nm), scale * value(formula, f64::from(nm)));
            Table::new((VISIBLE.0..=VISIBLE.1).map(node).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_between_nanometres_are_as_close_as_they_are_said_to_be() {
        let sf66 =
            vec![(2.0245976, 0.0147053225), (0.470187196, 0.0692998276), (2.59970433, 161.817601)];
        let cases = [
            (Formula::Blackbody(2000.0), 2e-4),
            (Formula::Blackbody(6500.0), 1e-5),
            (Formula::Sellmeier(sf66), 2e-6),
        ];
        for (formula, most) in cases {
            let table = tabulated(&Spectrum::of(formula.clone())).unwrap();
            for i in 0..4000 {
                let nm = 380.0 + f64::from(i) / 10.0;
                let error = table.at(nm) / value(&formula, nm) - 1.0;
                assert!(error.abs() < most, "{formula:?} at {nm} nm: {error}");
            }
        }
    }
}
