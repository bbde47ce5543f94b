//! Quantities that may vary with the wavelength, and the records that state how.

use super::schema::{Field, Range, Record, Type};
use crate::math::units::Dimension;

/// What a spectrum is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spectral {
    /// The part of light that is given back.
    Reflectance,
    /// What happens to light along a way.
    Coefficient,
    /// The light along a ray.
    Radiance,
    /// The light on a surface.
    Irradiance,
    /// The light of a point, in one direction.
    Intensity,
    /// All light of a lamp.
    Flux,
}

impl Spectral {
    /// All of them, in the order of the reference.
    pub const ALL: [Self; 6] = [
        Self::Reflectance,
        Self::Coefficient,
        Self::Radiance,
        Self::Irradiance,
        Self::Intensity,
        Self::Flux,
    ];

    /// What it measures.
    pub const fn dimension(self) -> Dimension {
        match self {
            Self::Reflectance => Dimension::NONE,
            Self::Coefficient => Dimension::COEFFICIENT,
            Self::Radiance => Dimension::RADIANCE,
            Self::Irradiance => Dimension::IRRADIANCE,
            Self::Intensity => Dimension::INTENSITY,
            Self::Flux => Dimension::POWER,
        }
    }

    /// The dimension of the same for each length of wavelength, for quantities of light: what
    /// physics tabulates, and adds up over the wavelengths.
    pub const fn density(self) -> Option<Dimension> {
        match self {
            Self::Reflectance | Self::Coefficient => None,
            Self::Radiance => Some(Dimension::SPECTRAL_RADIANCE),
            Self::Irradiance => Some(Dimension::SPECTRAL_IRRADIANCE),
            Self::Intensity => Some(Dimension::SPECTRAL_INTENSITY),
            Self::Flux => Some(Dimension::SPECTRAL_POWER),
        }
    }

    /// Its word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Reflectance => "reflectance",
            Self::Coefficient => "coefficient",
            Self::Radiance => "radiance",
            Self::Irradiance => "irradiance",
            Self::Intensity => "intensity",
            Self::Flux => "flux",
        }
    }

    /// What it means, in a sentence.
    pub const fn doc(self) -> &'static str {
        match self {
            Self::Reflectance => "The part of the light that a surface gives back.",
            Self::Coefficient => "How often something happens to light along its way.",
            Self::Radiance => "The light along a ray; what an eye sees as brightness.",
            Self::Irradiance => "The light that falls on a surface.",
            Self::Intensity => "The light that a point sends out in a direction.",
            Self::Flux => "All light of a lamp.",
        }
    }

    /// Bounds at every wavelength. A reflectance above 1 is no error but doubted: files of other
    /// programs have them.
    pub const fn range(self) -> Range {
        Range::at_least(0.0)
    }
}

/// What [`Type::Index`] means, in a sentence.
pub const INDEX_DOC: &str = "The index of refraction n of clear matter, or n + ik of matter that absorbs; n is above 0, k 0 or more.";

/// `spectrum { 400 nm: 0.1, … }`; its fields are wavelengths.
pub static SPECTRUM: Record = Record {
    word: "spectrum",
    doc: "Values at wavelengths: straight lines between them, constant beyond the first and the last.",
    fields: &[],
};

/// Sellmeier's formula.
pub static SELLMEIER: Record = Record {
    word: "sellmeier",
    doc: "An index of refraction by Sellmeier's formula: n^2 = 1 + sum of b L^2 / (L^2 - c), L the wavelength in vacuum.",
    fields: &[
        field("b", "The numerators.", Type::List(&Type::Number(Dimension::NONE)), Range::ANY, None),
        field(
            "c",
            "The resonances: as many as `b` has numbers. Where a catalogue gives lengths, their squares.",
            Type::List(&Type::Number(Dimension::AREA)),
            Range::at_least(0.0),
            None,
        ),
    ],
};

/// Cauchy's formula.
pub static CAUCHY: Record = Record {
    word: "cauchy",
    doc: "An index of refraction by Cauchy's formula: n = a + b / L^2 + c / L^4, L the wavelength.",
    fields: &[
        field("a", "The index at long waves.", Type::Number(Dimension::NONE), Range::ANY, None),
        field("b", "An area.", Type::Number(Dimension::AREA), Range::ANY, None),
        field(
            "c",
            "The square of an area.",
            Type::Number(Dimension::SQUARED_AREA),
            Range::ANY,
            Some("0 um^4"),
        ),
    ],
};

/// Records that are spectra wherever a spectrum or arithmetic expects one.
pub static RECORDS: [&Record; 3] = [&SPECTRUM, &SELLMEIER, &CAUCHY];

const fn field(
    word: &'static str,
    doc: &'static str,
    ty: Type,
    range: Range,
    default: Option<&'static str>,
) -> Field {
    Field { word, doc, ty, range, default, optional: false }
}
