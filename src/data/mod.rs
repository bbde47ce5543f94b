//! Measured figures, each with its source: what the shelves of the language hold, and what the
//! formulas of optics rest on.
//!
//! Tables of wavelengths stand as text in `figures/`, as their sources print them, and are read at
//! first use; short ones stand in the code. Wavelengths are in nanometres and rise from row to
//! row. Keys such as [CIE06] lead to docs/references.bib. Coefficients of milk and the
//! sea by their contents come with the worksheets that need them.

pub mod cie;
pub mod daylight;
mod glasses;
mod liquids;
mod metals;
mod paints;
mod shelves;
mod translucent;
pub mod water;

pub use shelves::{Datum, Figures, Glass, Matter, SHELVES, Shelf, shelf};

/// The rows of a table of ours. Panics where one cannot be read: a mistake of ours, which the
/// tests find.
fn rows<const COLUMNS: usize>(text: &str) -> Vec<[f64; COLUMNS]> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let mut cells = line.split(',').map(|cell| cell.parse().expect("a number"));
        let row = std::array::from_fn(|_| cells.next().expect("a cell for each column"));
        assert!(cells.next().is_none(), "a row too long: {line}");
        row
    };
    // The first line names the columns.
    lines.skip(1).map(row).collect()
}

/// Declares functions that read a table of `figures/` once: name, columns, file.
macro_rules! tables {
    ($($(#[$doc:meta])* $vis:vis fn $name:ident() -> [f64; $columns:literal] in $file:literal;)*) => {$(
        $(#[$doc])*
        $vis fn $name() -> &'static [[f64; $columns]] {
            static ROWS: std::sync::OnceLock<Vec<[f64; $columns]>> = std::sync::OnceLock::new();
            ROWS.get_or_init(|| crate::data::rows(include_str!(concat!("figures/", $file))))
        }
    )*};
}
use tables;

/// For each file of `figures/`: how many rows it has, and the first and last wavelength.
#[cfg(test)]
mod tests {
    use super::*;

    /// Rows, first and last wavelength; every further column within bounds.
    fn is_table<const N: usize>(rows: &[[f64; N]], count: usize, ends: [f64; 2], bounds: [f64; 2]) {
        assert_eq!(rows.len(), count);
        assert_eq!([rows[0][0], rows[count - 1][0]], ends);
        assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        let mut cells = rows.iter().flat_map(|row| &row[1..]);
        assert!(cells.all(|x| (bounds[0]..=bounds[1]).contains(x)));
    }

    #[test]
    fn tables_are_whole_and_their_wavelengths_rise() {
        is_table(cie::observer(), 81, [380.0, 780.0], [0.0, 1.79]);
        is_table(cie::illuminant_a(), 81, [380.0, 780.0], [9.0, 250.0]);
        is_table(cie::illuminant_d65(), 81, [380.0, 780.0], [45.0, 120.0]);
        is_table(daylight::preetham_sun(), 41, [380.0, 780.0], [0.0, 30_664.0]);
        is_table(daylight::bird_riordan(), 122, [300.0, 4000.0], [0.0, 22_000.0]);
        is_table(paints::cornell_box(), 76, [400.0, 700.0], [0.04, 0.777]);
        is_table(water::absorption(), 140, [380.0, 727.5], [0.00442, 1.678]);
        is_table(metals::gold(), 18, [342.5, 821.1], [0.13, 5.083]);
        is_table(metals::silver(), 18, [342.5, 821.1], [0.03, 5.727]);
        is_table(metals::copper(), 18, [342.5, 821.1], [0.21, 5.18]);
        is_table(metals::aluminium(), 14, [364.66, 837.74], [0.39, 8.5]);
        is_table(metals::chromium(), 18, [342.0, 821.0], [1.76, 3.48]);
        is_table(metals::iron(), 18, [342.0, 821.0], [1.85, 3.39]);
        is_table(metals::gold_glassner(), 80, [380.0, 775.0], [0.1, 5.0]);
        is_table(metals::silver_glassner(), 80, [380.0, 775.0], [0.1, 5.5]);
        is_table(metals::copper_glassner(), 80, [380.0, 775.0], [0.2, 5.0]);
    }

    #[test]
    fn single_figures_are_those_of_the_sources() {
        let at = |rows: &[[f64; 3]], nm| *rows.iter().find(|row| row[0] == nm).unwrap();
        assert_eq!(at(metals::gold(), 548.6), [548.6, 0.43, 2.455]);
        assert_eq!(at(metals::silver(), 450.9), [450.9, 0.04, 2.657]);
        assert_eq!(at(metals::iron(), 451.0), [451.0, 2.59, 2.77]);
        assert_eq!(at(metals::gold_glassner(), 400.0), [400.0, 1.658, 1.956]);
        let green = cie::observer().iter().find(|row| row[0] == 555.0).unwrap();
        assert_eq!(green[2], 1.0);
        let at = |rows: &[[f64; 2]], nm| rows.iter().find(|row| row[0] == nm).unwrap()[1];
        assert_eq!(at(cie::illuminant_d65(), 560.0), 100.0);
        assert_eq!(at(cie::illuminant_a(), 780.0), 241.675);
        assert_eq!(at(water::absorption(), 417.5), 0.00442);
        let at = |rows: &[[f64; 5]], nm| *rows.iter().find(|row| row[0] == nm).unwrap();
        // Water vapour begins at 690 nm: a table that is often copied repeats ozone there.
        let dusk = at(daylight::preetham_sun(), 690.0);
        assert_eq!(dusk, [690.0, 20_728.3, 0.028, 0.016, 0.0]);
        assert_eq!(at(daylight::bird_riordan(), 550.0)[1..], [1.892, 0.0, 0.085, 0.0]);
        assert_eq!(paints::cornell_box()[0], [400.0, 0.343, 0.092, 0.040]);
    }
}
