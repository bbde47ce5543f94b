//! A scene file as a tree: what stands where, before any word means anything.

use std::collections::HashSet;
use std::sync::Arc;

use crate::diag::Span;
use crate::math::units::Unit;

/// A word or a name in quotes, with its place (quotes included).
#[derive(Clone, Debug)]
pub struct Word {
    /// As meant: without quotes, escapes resolved.
    pub text: Arc<str>,
    /// Where it stands.
    pub span: Span,
}

/// The name of a declaration, a render or a base, which may hold values.
#[derive(Clone, Debug)]
pub struct Name {
    /// What it is made of.
    pub pieces: Arc<[Piece]>,
    /// Where it stands.
    pub span: Span,
}

/// A piece of a string.
#[derive(Clone, Debug)]
pub enum Piece {
    /// Words as they are.
    Words(String),
    /// `{value}`.
    Value(Expr),
}

/// A file.
#[derive(Clone, Debug, Default)]
pub struct File {
    /// Metres per bare coordinate, where the first line says it.
    pub unit: Option<f64>,
    /// The span of the first line's statement; None where it is missing.
    pub first_line: Option<Span>,
    /// What the file says, in its order.
    pub items: Vec<Item>,
    /// Words of items that could not be read: what they declare is not missing.
    pub broken_words: HashSet<String>,
}

/// An item.
#[derive(Clone, Debug)]
pub enum Item {
    /// `use "file"`
    Use(Word),
    /// `let name = value`, `let name(a, b) = value`
    Let(Arc<Let>),
    /// `for name in values { … }`
    For(Arc<For>),
    /// `setup name: bases { … }`
    Setup(Arc<Setup>),
    /// `render name: bases { … }`
    Render(Arc<Render>),
    /// `without kind name`
    Without(Arc<Without>),
    /// `path: value`
    Set(Arc<Set>),
}

/// A definition.
#[derive(Debug)]
pub struct Let {
    /// Its name.
    pub name: Word,
    /// Parameters of a function; None: a value.
    pub params: Option<Vec<Word>>,
    /// What it is.
    pub value: Arc<Expr>,
}

/// A loop.
#[derive(Debug)]
pub struct For {
    /// The loop's variable.
    pub variable: Word,
    /// A list or a range.
    pub head: Arc<Expr>,
    /// What is said for each.
    pub body: Vec<Item>,
    /// `for … in …`, without the body.
    pub span: Span,
}

/// A named difference.
#[derive(Debug)]
pub struct Setup {
    /// Its name.
    pub name: Word,
    /// What it builds on.
    pub bases: Vec<Name>,
    /// What it says.
    pub body: Vec<Item>,
}

/// A picture asked for.
#[derive(Debug)]
pub struct Render {
    /// Its name.
    pub name: Name,
    /// What it builds on.
    pub bases: Vec<Name>,
    /// What it says.
    pub body: Vec<Item>,
}

/// The removal of a declaration.
#[derive(Debug)]
pub struct Without {
    /// The kind's word.
    pub kind: Word,
    /// The declaration's name.
    pub name: Name,
    /// All of it.
    pub span: Span,
}

/// `word [name] {.part}: value`
#[derive(Debug)]
pub struct Set {
    /// A kind's word.
    pub kind: Word,
    /// The name, for kinds with names.
    pub name: Option<Name>,
    /// The way into the value; empty: all of it is stated.
    pub parts: Vec<Word>,
    /// What is said.
    pub value: Arc<Expr>,
    /// The path before the colon.
    pub path: Span,
}

/// A value as written.
#[derive(Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

impl Clone for Expr {
    fn clone(&self) -> Self {
        Self { kind: self.kind.clone(), span: self.span }
    }
}

/// The forms of a value.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// `1.5`, `3 cm`, `2 m^2`, `12:30`
    Number {
        /// The number as written.
        value: f64,
        /// Its unit, and the unit's exponent.
        unit: Option<(&'static Unit, i8)>,
    },
    /// `"day {hour}"`
    Text(Arc<[Piece]>),
    /// `(1, 2, 3)`
    Vector(Arc<[Expr]>),
    /// `[1, 2]`
    List(Arc<[Expr]>),
    /// `f(1, 2)`
    Call {
        /// The function.
        function: Vec<Word>,
        /// Its arguments.
        arguments: Arc<[Expr]>,
    },
    /// `word { field: value }`, `{ field: value }`
    Record(Arc<Record>),
    /// `word`, `shelf.word`
    Name(Vec<Word>),
    /// `-value`
    Negated(Arc<Expr>),
    /// `a + b - c`, or `a * b / c`: first to last
    Chain {
        /// The first operand.
        first: Arc<Expr>,
        /// Operators with their places, and what follows them.
        rest: Arc<[(Operator, Span, Expr)]>,
    },
    /// `value^2`
    Power(Arc<Expr>, i8),
    /// `value with { field: value }`, changes first to last
    With {
        /// What is changed.
        base: Arc<Expr>,
        /// The changes.
        changes: Arc<[Record]>,
    },
    /// `1 to 9 step 2`
    Range {
        /// The first.
        from: Arc<Expr>,
        /// The last that may be reached.
        to: Arc<Expr>,
        /// The step; None: 1.
        step: Option<Arc<Expr>>,
    },
    /// Could not be read; that has been told.
    Broken,
}

/// A number as written, with its unit and the unit's exponent.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// The number.
    pub value: f64,
    /// Its unit.
    pub unit: Option<(&'static Unit, i8)>,
}

/// An operator between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

/// Fields in braces.
#[derive(Clone, Debug)]
pub struct Record {
    /// The word before the brace.
    pub word: Option<Word>,
    /// The fields in their order.
    pub entries: Vec<Entry>,
    /// The braces and what they hold.
    pub braces: Span,
    /// Some entry could not be read: what is missing here is not missed.
    pub partial: bool,
}

/// A field with its value.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The field, as written.
    pub key: Word,
    /// A number where a field's word may stand: `400 nm`.
    pub quantity: Option<Quantity>,
    /// What it is.
    pub value: Arc<Expr>,
}
