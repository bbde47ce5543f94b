//! What expressions are worth before they land on a type, and the names they may use.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

use super::ast::{Expr, Let, Quantity, Word};
use crate::data::Datum;
use crate::diag::{FileId, Span};
use crate::math::Spectrum;
use crate::math::units::{Dimension, Unit};
use crate::scene::Step;

/// A value, and where it was written.
#[derive(Clone, Debug)]
pub struct Value {
    /// What it is.
    pub kind: ValueKind,
    /// Where it was written; for a name's value, where the value stands.
    pub span: Span,
}

/// The kinds of values. Words and records get their meaning where they land.
#[derive(Clone, Debug)]
pub enum ValueKind {
    /// A number in base units.
    Number {
        /// In base units.
        value: f64,
        /// What it measures.
        dimension: Dimension,
        /// The unit it was written with, for messages.
        unit: Option<&'static Unit>,
    },
    /// Linear components in base units.
    Colour([f64; 3], Dimension),
    /// Values by wavelength, in base units: a table or a formula.
    Spectrum(Spectrum, Dimension),
    /// An index of refraction n + ik by wavelength; without k it is real.
    Index {
        /// Its real part.
        n: Spectrum,
        /// Its imaginary part.
        k: Option<Spectrum>,
    },
    /// Two or three components; bare ones count in the unit of `file`.
    Vector {
        /// The components.
        components: Rc<[Value]>,
        /// The file whose text holds the vector.
        file: FileId,
    },
    /// Words in quotes.
    Text {
        /// The words.
        text: Rc<str>,
        /// The file whose text holds them.
        file: FileId,
    },
    /// A word that is no let: its place will say what it means.
    Word(Word),
    /// A list.
    List(Rc<[Value]>),
    /// Fields in braces.
    Record(Rc<RecordValue>),
    /// A step of a place.
    Step(Step),
    /// Told already.
    Broken,
}

/// Fields in braces.
#[derive(Clone, Debug)]
pub struct RecordValue {
    /// The word before the brace.
    pub word: Option<Word>,
    /// What `with` was applied to, if that was a word.
    pub base: Option<Word>,
    /// The fields.
    pub fields: Vec<FieldValue>,
    /// The braces.
    pub braces: Span,
    /// Some field could not be read.
    pub partial: bool,
    /// The datum on a shelf that it is, if it is one as it stands there.
    pub shelved: Option<&'static Datum>,
}

/// A field of a record, not computed before it lands.
#[derive(Clone, Debug)]
pub struct FieldValue {
    /// Its word, as written.
    pub key: Word,
    /// A number in place of the word: a wavelength.
    pub quantity: Option<Quantity>,
    /// What it is.
    pub value: Thunk,
}

/// A value that may still have to be computed.
#[derive(Clone, Debug)]
pub enum Thunk {
    /// To be computed with these names.
    Lazy(Arc<Expr>, Env),
    /// Known.
    Ready(Value),
}

impl Thunk {
    /// Where it is said.
    pub fn span(&self) -> Span {
        match self {
            Self::Lazy(expr, _) => expr.span,
            Self::Ready(value) => value.span,
        }
    }
}

/// The names an expression may use.
#[derive(Clone)]
pub struct Env(pub Rc<Frame>);

impl std::fmt::Debug for Env {
    /// Frames lead to each other in circles.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Env")
    }
}

/// Names defined together, and those around them.
pub struct Frame {
    /// The names defined here.
    pub names: RefCell<HashMap<Arc<str>, Rc<Binding>>>,
    /// The names around.
    pub outer: Option<Env>,
}

/// A defined name.
pub struct Binding {
    /// Where its name stands.
    pub name: Word,
    /// What it is.
    pub what: Bound,
}

/// What a name is.
pub enum Bound {
    /// A parameter or a loop's variable.
    Value(Value),
    /// A let with the names it may use, and its value once computed.
    Let(Arc<Let>, Env, RefCell<Option<Value>>),
    /// A let that depends on itself; told.
    Broken,
}

impl Env {
    /// The binding of a name.
    pub fn find(&self, name: &str) -> Option<Rc<Binding>> {
        let mut frame = Some(self);
        while let Some(Env(here)) = frame {
            if let Some(found) = here.names.borrow().get(name) {
                return Some(found.clone());
            }
            frame = here.outer.as_ref();
        }
        None
    }

    /// All names, for the nearest one.
    pub fn all(&self) -> Vec<Arc<str>> {
        self.names(|_| true)
    }

    /// The names of all functions.
    pub fn functions(&self) -> Vec<Arc<str>> {
        let takes = |binding: &Binding| match &binding.what {
            Bound::Let(said, ..) => said.params.is_some(),
            Bound::Value(_) | Bound::Broken => false,
        };
        self.names(takes)
    }

    fn names(&self, such: impl Fn(&Binding) -> bool) -> Vec<Arc<str>> {
        // Among more than these no person looks for a name.
        const MOST: usize = 2000;
        let mut found = Vec::new();
        let mut frame = Some(self);
        while let Some(Env(here)) = frame {
            let names = here.names.borrow();
            let wanted = names.iter().filter(|(_, it)| names.len() <= MOST && such(it));
            found.extend(wanted.map(|(name, _)| name.clone()));
            frame = here.outer.as_ref();
        }
        found
    }
}

impl Value {
    /// A value that was told to be wrong.
    pub fn broken(span: Span) -> Self {
        Self { kind: ValueKind::Broken, span }
    }

    /// A number.
    pub fn number(value: f64, dimension: Dimension, span: Span) -> Self {
        Self { kind: ValueKind::Number { value, dimension, unit: None }, span }
    }

    /// Whether it was told to be wrong.
    pub fn is_broken(&self) -> bool {
        matches!(self.kind, ValueKind::Broken)
    }

    /// What a person calls it, with its article: "a length", "a colour", "the word `mean`".
    pub fn described(&self) -> String {
        match &self.kind {
            ValueKind::Number { dimension, .. } => dimension.name(),
            ValueKind::Colour(_, dimension) if *dimension == Dimension::NONE => "a colour".into(),
            ValueKind::Colour(_, dimension) => format!("{} in colour", dimension.name()),
            ValueKind::Spectrum(_, Dimension::NONE) => "a spectrum".into(),
            ValueKind::Spectrum(_, dimension) => format!("{} by wavelength", dimension.name()),
            ValueKind::Index { k: None, .. } => "an index of refraction".into(),
            ValueKind::Index { .. } => "a complex index of refraction".into(),
            ValueKind::Vector { components, .. } if components.len() == 2 => "a pair".into(),
            ValueKind::Vector { .. } => "a vector".into(),
            ValueKind::Text { .. } => "a text".into(),
            ValueKind::Word(word) => format!("the word `{}`", word.text),
            ValueKind::List(_) => "a list".into(),
            ValueKind::Record(record) => match (record.shelved, &record.word) {
                (Some(datum), _) => format!("the medium `matter.{}`", datum.word),
                (None, Some(word)) => format!("`{} {{ … }}`", word.text),
                (None, None) => "fields in braces".into(),
            },
            ValueKind::Step(_) => "a step of a place".into(),
            ValueKind::Broken => "something broken".into(),
        }
    }
}

/// A number as a person writes it, with its unit.
pub fn shown(value: f64, dimension: Dimension, unit: Option<&Unit>) -> String {
    let degrees = crate::math::units::find("deg");
    let unit = unit.or(degrees).filter(|unit| unit.dimension == dimension);
    let (value, word) = match unit {
        Some(unit) => (digits(value / unit.scale), unit.word.to_string()),
        None => (digits(value), dimension.unit()),
    };
    if word.is_empty() { value } else { format!("{value} {word}") }
}

/// A number as people write it: very large and very small ones with an exponent.
pub fn digits(value: f64) -> String {
    let value = neat(value);
    match value.abs() {
        0.0 | 1e-6..1e15 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// Without the dust of rounding: 13 digits.
pub fn neat(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::units;

    #[test]
    fn numbers_are_shown_in_the_unit_they_were_written_in() {
        assert_eq!(shown(0.003, Dimension::LENGTH, units::find("mm")), "3 mm");
        assert_eq!(shown(std::f64::consts::PI, Dimension::ANGLE, None), "180 deg");
        assert_eq!(shown(0.1 + 0.2, Dimension::NONE, None), "0.3");
        assert_eq!(shown(1e308, Dimension::NONE, None), "1e308");
        assert_eq!(shown(4.0, Dimension::RADIANCE, None), "4 W/m^2/sr");
    }
}
