//! Expressions that choose among the paths of light.

use serde::{Serialize, Serializer};

use super::schema::{Checked, Type, Vocabulary, Words, unchecked};
use crate::math::paths::Expression;

/// A set of paths.
#[derive(Clone, Debug, PartialEq)]
pub struct Paths {
    /// As written.
    pub text: String,
    /// What it means.
    pub expression: Expression,
}

impl Serialize for Paths {
    /// However many blanks it was written with.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.expression.to_string().serialize(serializer)
    }
}

impl Vocabulary for Paths {
    const TYPE: Type = Type::Paths(None);

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Paths(paths) => paths.clone(),
            other => unchecked("paths", other),
        }
    }
}

/// Which paths a layer takes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Only {
    /// These, but for those that a layer before it takes.
    Paths(Paths),
    /// Those that no other layer takes.
    Others,
}

impl Vocabulary for Only {
    const TYPE: Type = Type::Paths(Some(&Words {
        name: "choice of paths",
        doc: "Paths, or what is left of them.",
        all: &[("others", "The paths that no other layer takes.")],
    }));

    fn lower(checked: &Checked) -> Self {
        match checked {
            Checked::Paths(paths) => Self::Paths(paths.clone()),
            Checked::Word(0) => Self::Others,
            other => unchecked("a choice of paths", other),
        }
    }
}
