//! What the checker, the lists and the reference know of the vocabulary: types as data.

use super::At;
use super::spectral::Spectral;
use crate::math::Spectrum;
use crate::math::units::Dimension;

/// What may stand in a place.
#[derive(Clone, Copy, Debug)]
pub enum Type {
    /// A number with a dimension, in base units.
    Number(Dimension),
    /// A whole number, not negative.
    Count,
    /// `on` or `off`.
    Switch,
    /// Words in quotes.
    Text,
    /// The name of a file, relative to the file whose text holds it.
    File,
    /// Coordinates; bare numbers are in the unit of their file.
    Point,
    /// A vector that is normalised, or `x -x y -y z -z`.
    Direction,
    /// A pair of whole numbers.
    Size,
    /// A pair of plain numbers, or one for both.
    Pair,
    /// A step of a `place`: `scale(…)`, `rotate(…)`, `move(…)`.
    Step,
    /// A number, a colour or a spectrum of a quantity.
    Spectrum(Spectral),
    /// The same, or the name of a texture, or a texture.
    Textured {
        /// What it is of.
        of: Spectral,
        /// The word of the kind that textures are.
        kind: &'static str,
        /// The type of these.
        target: fn() -> Type,
    },
    /// An index of refraction, real or complex.
    Index,
    /// One of some words.
    Words(&'static Words),
    /// A whole number, or one of some words.
    CountOr(&'static Words),
    /// An expression over paths of light, in quotes; or one of these words.
    Paths(Option<&'static Words>),
    /// One of some variants, each a word with a record.
    OneOf(&'static Variants),
    /// Fields in braces.
    Record(&'static Record),
    /// Elements in square brackets.
    List(&'static Type),
    /// Names of the user's with values, in braces.
    Map(&'static Type),
    /// The name of a declaration of this kind, or a value such as it would have if it has a target.
    Reference {
        /// The kind's word.
        kind: &'static str,
        /// Its type; asked for late, since a kind may refer to itself. None: no value stands for
        /// the name.
        target: Option<fn() -> Type>,
    },
}

/// Bounds of a number, a count, or each component of a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower bound.
    pub low: Bound,
    /// Upper bound.
    pub high: Bound,
    /// Why there are bounds, in a sentence; empty where they go without saying.
    pub why: &'static str,
    /// What to write, where the bounds alone do not tell it; or empty.
    pub help: &'static str,
}

/// One end of a [`Range`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// No bound.
    None,
    /// The value itself is allowed.
    Inclusive(f64),
    /// The value itself is not allowed.
    Exclusive(f64),
}

impl Range {
    const fn of(low: Bound, high: Bound) -> Self {
        Self { low, high, why: "", help: "" }
    }

    /// Any finite number.
    pub const ANY: Self = Self::of(Bound::None, Bound::None);

    /// `low` or more.
    pub const fn at_least(low: f64) -> Self {
        Self::of(Bound::Inclusive(low), Bound::None)
    }

    /// More than `low`.
    pub const fn above(low: f64) -> Self {
        Self::of(Bound::Exclusive(low), Bound::None)
    }

    /// The same, and `high` or less.
    pub const fn up_to(self, high: f64) -> Self {
        Self { high: Bound::Inclusive(high), ..self }
    }

    /// The same, and less than `high`.
    pub const fn below(self, high: f64) -> Self {
        Self { high: Bound::Exclusive(high), ..self }
    }

    /// From `low` to `high`, both allowed.
    pub const fn between(low: f64, high: f64) -> Self {
        Self::of(Bound::Inclusive(low), Bound::Inclusive(high))
    }

    /// From `low` to `high`, neither allowed.
    pub const fn inside(low: f64, high: f64) -> Self {
        Self::of(Bound::Exclusive(low), Bound::Exclusive(high))
    }

    /// With the reason for its bounds, a sentence, and what to write.
    pub const fn because(self, why: &'static str, help: &'static str) -> Self {
        Self { why, help, ..self }
    }

    /// Whether a finite number lies within.
    pub fn holds(&self, x: f64) -> bool {
        let above = match self.low {
            Bound::None => true,
            Bound::Inclusive(low) => x >= low,
            Bound::Exclusive(low) => x > low,
        };
        let below = match self.high {
            Bound::None => true,
            Bound::Inclusive(high) => x <= high,
            Bound::Exclusive(high) => x < high,
        };
        above && below && x.is_finite()
    }
}

/// A field of a record.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its word.
    pub word: &'static str,
    /// What it means.
    pub doc: &'static str,
    /// What may stand there.
    pub ty: Type,
    /// Bounds, beyond what the type says.
    pub range: Range,
    /// The default, in the scene language. None: the field must be given, unless `optional`.
    pub default: Option<&'static str>,
    /// May be left out without a default.
    pub optional: bool,
}

/// Fields under a word: a variant, or a record of its own.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// The word before the brace; empty for a plain record.
    pub word: &'static str,
    /// What it means.
    pub doc: &'static str,
    /// Its fields, in the order of the reference.
    pub fields: &'static [Field],
}

/// The variants one of which must be chosen.
#[derive(Clone, Copy, Debug)]
pub struct Variants {
    /// What they are, in a word: "camera".
    pub name: &'static str,
    /// What they are, in a sentence.
    pub doc: &'static str,
    /// The choices.
    pub all: &'static [Record],
}

/// The words one of which must be chosen.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// What they choose, in a word.
    pub name: &'static str,
    /// What they choose, in a sentence.
    pub doc: &'static str,
    /// The choices with their meaning.
    pub all: &'static [(&'static str, &'static str)],
}

/// A kind of item: the word that begins it, and what it holds.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its word.
    pub word: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// What stands after the colon.
    pub ty: Type,
    /// Whether there are many, each with a name.
    pub named: bool,
    /// The default of an unnamed kind, in the scene language. None: it must be given, unless
    /// `optional`.
    pub default: Option<&'static str>,
    /// May be left out without a default.
    pub optional: bool,
}

/// A value that was checked against its [`Type`]; lowering it cannot fail.
#[derive(Clone, Debug, PartialEq)]
pub enum Checked {
    /// Of `Number`, in base units.
    Number(f64),
    /// Of `Count` and `CountOr`.
    Count(u64),
    /// Of `Switch`.
    Switch(bool),
    /// Of `Text`.
    Text(String),
    /// Of `File`.
    File(super::FileName),
    /// Of `Point` (metres) and `Direction` (unit length).
    Vector(glam::DVec3),
    /// Of `Size`.
    Size([u64; 2]),
    /// Of `Pair`.
    Pair([f64; 2]),
    /// Of `Step`.
    Step(super::Step),
    /// Of `Spectrum` and `Textured`, in base units.
    Spectrum(Spectrum),
    /// Of `Index`: n, and k of n + ik.
    Index(Spectrum, Spectrum),
    /// Of `Words` and `CountOr`, and of `Paths` that are none: which.
    Word(usize),
    /// Of `Paths`.
    Paths(super::Paths),
    /// Of `OneOf`: which, and its fields in the order of the schema.
    Variant(usize, Vec<At<Checked>>),
    /// Of `Record`: its fields in the order of the schema.
    Record(Vec<At<Checked>>),
    /// Of `List`.
    List(Vec<At<Checked>>),
    /// Of `Map`, in the order of the names.
    Map(Vec<(At<String>, At<Checked>)>),
    /// Of `Reference` and `Textured`: the name of a declaration that exists.
    Reference(String),
    /// An optional field that was left out.
    Absent,
}

/// A Rust type that stands for part of the vocabulary.
pub trait Vocabulary: Sized {
    /// What the checker knows of it.
    const TYPE: Type;
    /// Whether a field of this type may be left out without a default.
    const OPTIONAL: bool = false;

    /// The value, from a tree checked against [`Self::TYPE`]. Panics on any other tree.
    fn lower(checked: &Checked) -> Self;
}

impl<T: Vocabulary> Vocabulary for Option<T> {
    const TYPE: Type = T::TYPE;
    const OPTIONAL: bool = true;

    fn lower(checked: &Checked) -> Self {
        (*checked != Checked::Absent).then(|| T::lower(checked))
    }
}

impl<T: Vocabulary> Vocabulary for Vec<At<T>> {
    const TYPE: Type = Type::List(&T::TYPE);

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::List(all) => all.iter().map(|e| At::new(T::lower(&e.value), e.span)).collect(),
            other => unchecked("a list", other),
        }
    }
}

impl<T: Vocabulary> Vocabulary for Vec<(At<String>, At<T>)> {
    const TYPE: Type = Type::Map(&T::TYPE);

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Map(all) => all
                .iter()
                .map(|(name, e)| (name.clone(), At::new(T::lower(&e.value), e.span)))
                .collect(),
            other => unchecked("a map", other),
        }
    }
}

/// A tree that was not checked, or against another type: a mistake of ours.
pub(super) fn unchecked(expected: &str, found: &Checked) -> ! {
    panic!("lowering {expected} from {found:?}: the tree was not checked against its type")
}
