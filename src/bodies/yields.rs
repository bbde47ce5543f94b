//! Which objects end where others begin.

use super::placed::Placed;
use crate::diag::Span;

/// Of placed objects, by number: which each yields to, near or far.
pub(super) struct Yields(Vec<Vec<u32>>);

impl Yields {
    pub fn of(placed: &[Placed]) -> Self {
        let next = |object: &Placed| {
            let name = object.object.value.yields_to().as_ref()?;
            let same = |other: &Placed| *other.name().value == name.0.name;
            placed.iter().position(same).map(|at| at as u32)
        };
        let nexts: Vec<Option<u32>> = placed.iter().map(next).collect();
        let all = |first: &Option<u32>| {
            let mut chain = Vec::new();
            let mut at = *first;
            while let Some(object) = at.filter(|object| !chain.contains(object)) {
                chain.push(object);
                at = nexts[object as usize];
            }
            chain
        };
        Self(nexts.iter().map(all).collect())
    }

    /// Whether anything yields.
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(Vec::is_empty)
    }

    /// Where the first of them says that it yields.
    pub fn first(&self, placed: &[Placed]) -> Span {
        let first = self.0.iter().position(|chain| !chain.is_empty()).unwrap_or_default();
        placed[first].object.value.yields_to().span
    }

    /// Whether one object ends where another begins.
    pub fn yields(&self, one: u32, to: u32) -> bool {
        self.0[one as usize].contains(&to)
    }

    /// Whether either does.
    pub fn are_related(&self, one: u32, other: u32) -> bool {
        self.yields(one, other) || self.yields(other, one)
    }
}
