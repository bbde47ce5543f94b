//! The shelves of the language: what stands behind `metal.gold`, `glass.bk7`, `illuminant.a`.

use super::paints::{CORNELL, CORNELL_LAMP};
use super::{cie, glasses, liquids, metals, paints, translucent};

/// Data of one kind under a word.
#[derive(Clone, Copy, Debug)]
pub struct Shelf {
    /// Before the dot.
    pub word: &'static str,
    /// What stands on it, in one sentence.
    pub doc: &'static str,
    /// Its data, in parts; each part in the order of its words.
    parts: &'static [&'static [Datum]],
}

/// A datum with its source.
#[derive(Clone, Copy, Debug)]
pub struct Datum {
    /// After the dot.
    pub word: &'static str,
    /// What it is, in a sentence.
    pub doc: &'static str,
    /// Who measured or agreed on it, and its key in docs/references.bib.
    pub source: &'static str,
    /// The figures.
    pub figures: Figures,
}

/// What a datum is made of.
#[derive(Clone, Copy, Debug)]
pub enum Figures {
    /// Wavelength in nm, n and k of a complex index n + ik.
    Metal(fn() -> &'static [[f64; 3]]),
    /// The formula of a real index.
    Glass(Glass),
    /// Wavelength in nm and relative power.
    Light(fn() -> &'static [[f64; 2]]),
    /// Wavelength in nm, and reflectances; the one meant is in this column.
    Reflectance(fn() -> &'static [[f64; 4]], usize),
    /// A medium in three bands.
    Matter(Matter),
    /// Pure water: [`super::water`].
    Water,
}

/// A formula for the index of refraction n at the wavelength λ in micrometres.
#[derive(Clone, Copy, Debug)]
pub enum Glass {
    /// n² = 1 + Σ B λ² / (λ² − C): pairs of B, and C in µm².
    Sellmeier(&'static [(f64, f64)]),
    /// n² = A₀ + A₁ λ² + A₂ λ⁻² + A₃ λ⁻⁴ + A₄ λ⁻⁶ + A₅ λ⁻⁸, with powers of µm.
    Series([f64; 6]),
}

/// A medium; bands red, green, blue.
#[derive(Clone, Copy, Debug)]
pub struct Matter {
    /// Index of refraction.
    pub index: f64,
    /// Scattering coefficient in 1/mm; the reduced one where `asymmetry` is zero and the source
    /// says so.
    pub scattering: [f64; 3],
    /// Absorption coefficient in 1/mm.
    pub absorption: [f64; 3],
    /// Mean cosine of the angle of scattering.
    pub asymmetry: [f64; 3],
}

impl Shelf {
    /// What stands on it.
    pub fn data(&self) -> impl Iterator<Item = &'static Datum> + use<> {
        self.parts.iter().copied().flatten()
    }

    /// The datum of that word.
    pub fn find(&self, word: &str) -> Option<&'static Datum> {
        self.data().find(|datum| datum.word == word)
    }
}

/// Looks a shelf up by its word.
pub fn shelf(word: &str) -> Option<&'static Shelf> {
    SHELVES.iter().find(|shelf| shelf.word == word)
}

const CIE: &str = "CIE, ISO 11664-2 (2006) [CIE06]";

static ILLUMINANTS: &[Datum] = &[
    light("a", "A lamp of tungsten at 2856 K.", CIE, cie::illuminant_a),
    light("cornell", "The lamp of the Cornell box.", CORNELL, || &CORNELL_LAMP),
    light("d65", "Daylight; the white of sRGB.", CIE, cie::illuminant_d65),
    light("e", "The same power at every wavelength.", CIE, || &cie::ILLUMINANT_E),
];

static WATER: &[Datum] = &[Datum {
    word: "water",
    doc: "Pure water at 20 °C.",
    source: "Quan and Fry 1995 [Quan95], Pope and Fry 1997 [Pope97], both in Applied Optics",
    figures: Figures::Water,
}];

const fn light(
    word: &'static str,
    doc: &'static str,
    source: &'static str,
    rows: fn() -> &'static [[f64; 2]],
) -> Datum {
    Datum { word, doc, source, figures: Figures::Light(rows) }
}

/// All shelves, in the order of their words.
pub static SHELVES: &[Shelf] = &[
    Shelf {
        word: "glass",
        doc: "Indices of refraction of glasses and clear crystals.",
        parts: &[glasses::SHELF],
    },
    Shelf {
        word: "illuminant",
        doc: "Lights by wavelength, of luminance 1: `illuminant.a * 5 W/m^2/sr` is as bright as `5 W/m^2/sr`.",
        parts: &[ILLUMINANTS],
    },
    Shelf {
        word: "matter",
        doc: "Media: index, scattering and absorption of liquids and translucent matter. Media that scatter or absorb cannot be rendered yet; those that are clear can.",
        parts: &[liquids::SHELF, translucent::SHELF, WATER],
    },
    Shelf {
        word: "metal",
        doc: "Complex indices of refraction of metals.",
        parts: &[metals::SHELF],
    },
    Shelf {
        word: "paint",
        doc: "Reflectances by wavelength, as measured.",
        parts: &[paints::SHELF],
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_in_order_and_each_stands_for_one_datum_with_a_source() {
        assert!(SHELVES.is_sorted_by(|a, b| a.word < b.word));
        for shelf in SHELVES {
            for part in shelf.parts {
                assert!(part.is_sorted_by(|a, b| a.word < b.word), "{}", shelf.word);
            }
            for datum in shelf.data() {
                let name = format!("{}.{}", shelf.word, datum.word);
                assert_eq!(shelf.data().filter(|d| d.word == datum.word).count(), 1, "{name}");
                assert!(datum.source.contains('[') && datum.doc.ends_with('.'), "{name}");
            }
        }
        assert_eq!(shelf("metal").unwrap().find("gold").unwrap().doc, "Gold.");
        assert!(shelf("metal").unwrap().find("glod").is_none() && shelf("metals").is_none());
    }
}
