//! A quantity over the visible wavelengths, as an author states it.

use serde::Serialize;

use super::Rgb;

/// A spectrum in f64; its dimension is said where it stands. Tabulated and fitted spectra come
/// with the worksheets that need them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Spectrum {
    /// The same at every wavelength.
    Constant(f64),
    /// Linear components, primaries of sRGB.
    Rgb([f64; 3]),
}

impl Spectrum {
    /// Its linear components in f64.
    pub fn components(self) -> [f64; 3] {
        match self {
            Self::Constant(value) => [value; 3],
            Self::Rgb(components) => components,
        }
    }

    /// As a renderer of three bands sees it.
    pub fn rgb(self) -> Rgb {
        let [r, g, b] = self.components();
        Rgb::new(r as f32, g as f32, b as f32)
    }

    /// Whether it is zero everywhere.
    pub fn is_zero(self) -> bool {
        self.components() == [0.0; 3]
    }
}
