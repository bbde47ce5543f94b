//! Reflectances that were measured: the paints of the Cornell box.
//!
//! The lamp of the box is on the shelf of illuminants.

use super::shelves::{Datum, Figures};

super::tables! {
    /// Wavelength in nm; reflectance of white, green and red paint.
    pub fn cornell_box() -> [f64; 4] in "cornell_box.csv";
}

/// Wavelength in nm and relative radiance of the lamp of the Cornell box: four points, without a
/// unit at their source.
pub static CORNELL_LAMP: [[f64; 2]; 4] = [[400.0, 0.0], [500.0, 8.0], [600.0, 15.6], [700.0, 18.4]];

pub(super) const CORNELL: &str = "Cornell University, Cornell Box Data (1998) [Cornell98]";

pub(super) static SHELF: &[Datum] = &[
    paint("cornell_green", "The green wall of the Cornell box.", 2),
    paint("cornell_red", "The red wall of the Cornell box.", 3),
    paint("cornell_white", "The white walls and blocks of the Cornell box.", 1),
];

const fn paint(word: &'static str, doc: &'static str, column: usize) -> Datum {
    Datum { word, doc, source: CORNELL, figures: Figures::Reflectance(cornell_box, column) }
}
