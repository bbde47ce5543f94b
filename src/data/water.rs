//! Pure water and sea water.

super::tables! {
    /// Absorption of pure water [Pope97]: wavelength in nm, coefficient in 1/m.
    pub fn absorption() -> [f64; 2] in "water_absorption.csv";
}

/// Coefficients n₀ to n₉ of the index of refraction of sea water [Quan95], with wavelengths in nm,
/// temperatures in °C and salinities in parts of a thousand; `optics::water` holds the formula.
pub const INDEX: [f64; 10] =
    [1.31405, 1.779e-4, -1.05e-6, 1.6e-8, -2.02e-6, 15.868, 0.01155, -0.00423, -4382.0, 1.1455e6];
