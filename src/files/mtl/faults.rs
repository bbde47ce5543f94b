//! What can be wrong with the statements of a .mtl file, as plain data.

use std::ops::Range;

/// A statement that is wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// How.
    pub what: What,
    /// Where, in bytes of the library's text.
    pub at: Range<usize>,
    /// The material it belongs to.
    pub material: Option<String>,
}

/// How a statement can be wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A word where a number should be.
    NotANumber(String),
    /// An infinity, a NaN, or a number too large.
    NotFinite(String),
    /// Another count of numbers than the statement has.
    WrongCount {
        /// The statement's word.
        statement: String,
        /// How many there are.
        found: usize,
        /// How many there must be, in words.
        wanted: &'static str,
    },
    /// A component of a colour, an exponent or an index below zero.
    Negative(String),
    /// d or Tr outside of 0 to 1.
    NoFraction(String),
    /// An illum that is no whole number from 0 to 14.
    NotAnIllum(String),
    /// `spectral` or `xyz` in place of a colour.
    OtherColour(String),
    /// `newmtl` without a name.
    MissingName,
    /// A second material of the name; where the first is.
    SameName(Range<usize>),
    /// A statement before the first `newmtl`.
    NoMaterial,
}
