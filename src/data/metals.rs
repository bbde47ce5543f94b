//! Metals: complex indices of refraction n + ik by wavelength, as they were measured.
//!
//! Measurements of one metal differ by a few hundredths of its reflectance, those of chromium and
//! iron by a tenth: films, their roughness and their oxide differ. Both sets for gold, silver and
//! copper are in use; pictures of other renderers and of courses mostly rest on [Glassner95].
//! The others came through the database of [Polyanskiy24].

use super::shelves::{Datum, Figures};

super::tables! {
    /// Wavelength in nm, n, k.
    pub fn gold() -> [f64; 3] in "gold.csv";
    /// Wavelength in nm, n, k.
    pub fn silver() -> [f64; 3] in "silver.csv";
    /// Wavelength in nm, n, k.
    pub fn copper() -> [f64; 3] in "copper.csv";
    /// Wavelength in nm, n, k.
    pub fn aluminium() -> [f64; 3] in "aluminium.csv";
    /// Wavelength in nm, n, k.
    pub fn chromium() -> [f64; 3] in "chromium.csv";
    /// Wavelength in nm, n, k.
    pub fn iron() -> [f64; 3] in "iron.csv";
    /// Wavelength in nm, n, k.
    pub fn gold_glassner() -> [f64; 3] in "gold_glassner.csv";
    /// Wavelength in nm, n, k.
    pub fn silver_glassner() -> [f64; 3] in "silver_glassner.csv";
    /// Wavelength in nm, n, k.
    pub fn copper_glassner() -> [f64; 3] in "copper_glassner.csv";
}

const NOBLE: &str = "Johnson and Christy, Physical Review B 6 (1972) [Johnson72]";
const TRANSITION: &str = "Johnson and Christy, Physical Review B 9 (1974) [Johnson74]";
const PRINTED: &str = "Glassner, Principles of Digital Image Synthesis (1995) [Glassner95]";

pub(super) static SHELF: &[Datum] = &[
    metal("aluminium", "Aluminium.", "Rakić, Applied Optics 34 (1995) [Rakic95]", aluminium),
    metal("chromium", "Chromium; other measurements differ by a tenth.", TRANSITION, chromium),
    metal("copper", "Copper.", NOBLE, copper),
    metal("copper_glassner", "Copper, as older pictures have it.", PRINTED, copper_glassner),
    metal("gold", "Gold.", NOBLE, gold),
    metal("gold_glassner", "Gold, as older pictures have it.", PRINTED, gold_glassner),
    metal("iron", "Iron; other measurements differ by a tenth.", TRANSITION, iron),
    metal("silver", "Silver.", NOBLE, silver),
    metal("silver_glassner", "Silver, as older pictures have it.", PRINTED, silver_glassner),
];

const fn metal(
    word: &'static str,
    doc: &'static str,
    source: &'static str,
    rows: fn() -> &'static [[f64; 3]],
) -> Datum {
    Datum { word, doc, source, figures: Figures::Metal(rows) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reflectance at right angles from vacuum, at a wavelength between two of the table.
    fn reflectance(rows: &[[f64; 3]], nm: f64) -> f64 {
        let after = rows.iter().position(|row| row[0] >= nm).unwrap();
        let (a, b) = (rows[after - 1], rows[after]);
        let t = (nm - a[0]) / (b[0] - a[0]);
        let [n, k] = [1, 2].map(|i| a[i] + t * (b[i] - a[i]));
        ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k)
    }

    #[test]
    fn metals_reflect_what_they_are_known_to() {
        let known = [
            (gold(), [0.9565, 0.7916, 0.4082]),
            (silver(), [0.9898, 0.9831, 0.9802]),
            (copper(), [0.9352, 0.6235, 0.5383]),
            (aluminium(), [0.9056, 0.9154, 0.9219]),
            (chromium(), [0.5556, 0.5545, 0.5548]),
            (iron(), [0.5312, 0.5124, 0.4958]),
        ];
        for (rows, expected) in known {
            for (nm, expected) in [650.0, 550.0, 450.0].into_iter().zip(expected) {
                let found = reflectance(rows, nm);
                assert!((found - expected).abs() < 1e-4, "{nm}: {found}, not {expected}");
            }
        }
    }
}
