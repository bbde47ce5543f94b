//! What can be wrong with the statements of an .obj file, as plain data.

use super::Obj;
use crate::files::lines::Excerpt;

/// What reading gave.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// The mesh; None if there are faults.
    pub obj: Option<Obj>,
    /// The first faults, in the order of the file.
    pub faults: Vec<Fault>,
    /// How many more there are.
    pub more: u64,
    /// What is well-formed but left out or doubtful.
    pub notices: Vec<Notice>,
}

/// A statement that is wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// How.
    pub what: What,
    /// Where.
    pub place: Excerpt,
}

/// How a statement can be wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A word where a number should be.
    NotANumber(String),
    /// An infinity, a NaN, or a number too large for f64.
    NotFinite(String),
    /// A coordinate beyond [`super::scan::FARTHEST`].
    TooFar(String),
    /// Fewer numbers than the statement needs.
    TooFewNumbers {
        /// `v`, `vt` or `vn`.
        statement: &'static str,
        /// How many there are.
        found: usize,
        /// How many there must be.
        wanted: usize,
    },
    /// A word where indices should be: `1`, `1/2`, `1//3` or `1/2/3`.
    NotAnIndex(String),
    /// Index 0: they count from 1.
    ZeroIndex(Of),
    /// An index of something the file does not have.
    OutOfRange {
        /// Of what.
        of: Of,
        /// The index as written.
        index: i64,
        /// How many there are: in the file, or before this line if the index counts back.
        count: usize,
    },
    /// A face of less than three corners.
    TooFewCorners(usize),
    /// A face with normals at some corners only.
    MixedNormals,
    /// `usemtl` or `mtllib` without a name.
    MissingName(&'static str),
    /// More different names after `usemtl` or `mtllib` than are read.
    TooManyNames(&'static str, usize),
    /// A line of more words than are read.
    TooManyWords(usize),
}

/// What an index counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// `v`.
    Vertices,
    /// `vt`.
    TextureCoordinates,
    /// `vn`.
    Normals,
}

impl Of {
    /// Each, in the order in which a corner names them.
    pub const ALL: [Self; 3] = [Self::Vertices, Self::TextureCoordinates, Self::Normals];

    /// In words, several of them.
    pub fn words(self) -> &'static str {
        match self {
            Self::Vertices => "vertices",
            Self::TextureCoordinates => "texture coordinates",
            Self::Normals => "normals",
        }
    }

    /// The statement that makes one.
    pub fn statement(self) -> &'static str {
        match self {
            Self::Vertices => "v",
            Self::TextureCoordinates => "vt",
            Self::Normals => "vn",
        }
    }
}

/// Something left out or doubtful, once for all its places.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// What it is.
    pub what: Unread,
    /// In how many statements.
    pub count: u64,
    /// The first of them.
    pub place: Excerpt,
}

/// What is left out or doubtful.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unread {
    /// A word that is no statement of the format.
    Unknown(String),
    /// Curves and surfaces: `curv`, `surf` and what belongs to them.
    FreeForm,
    /// Statement `p`.
    Points,
    /// Statement `l`.
    Lines,
    /// Colours after the coordinates of a vertex.
    VertexColours,
    /// A polygon no fan of triangles covers.
    Concave,
    /// `vn 0 0 0`.
    ZeroNormal,
    /// Smoothing groups on faces without normals.
    Smoothing,
}
