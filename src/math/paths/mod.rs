//! Paths of light, and expressions that choose among them [Heckbert90].
//!
//! A path is a word: `L`, a letter for each scattering, `E`, read from the light to the eye. An
//! expression stands for a set of such words; an [`Automaton`] says of a path, from the eye on, to
//! which of several expressions it belongs.

mod automaton;
mod dead;
mod expression;
mod parse;
mod positions;
#[cfg(test)]
mod tests;

pub use automaton::{Automaton, End, MOST_LAYERS, MOST_LETTERS, MOST_STATES, TooLarge, Which};
pub use expression::{Expression, Fault, MOST_DEPTH, MOST_LENGTH, Wrong};

/// What happens to light at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Event {
    /// Scattered to all sides, on the side it came from: `D_r`.
    DiffuseReflection,
    /// Scattered to all sides beyond the surface: `D_t`.
    DiffuseTransmission,
    /// Scattered about one direction, on the side it came from: `G_r`.
    GlossyReflection,
    /// Scattered about one direction beyond the surface: `G_t`.
    GlossyTransmission,
    /// Mirrored: `S_r`.
    SpecularReflection,
    /// Refracted, or passed straight on: `S_t`.
    SpecularTransmission,
}

impl Event {
    /// All of them, in their order.
    pub const ALL: [Self; 6] = [
        Self::DiffuseReflection,
        Self::DiffuseTransmission,
        Self::GlossyReflection,
        Self::GlossyTransmission,
        Self::SpecularReflection,
        Self::SpecularTransmission,
    ];

    /// How it is written: `S_t`.
    pub const fn letter(self) -> &'static str {
        ["D_r", "D_t", "G_r", "G_t", "S_r", "S_t"][self as usize]
    }
}
