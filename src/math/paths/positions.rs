//! The positions of an expression's letters, and which may follow which [Glushkov61]. Read from
//! the eye to the light: backwards.

use super::expression::{Expression, Letters, Node, Sign};

/// A set of positions.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Set(Vec<u64>);

impl Set {
    pub fn empty(of: usize) -> Self {
        Self(vec![0; of.div_ceil(64)])
    }

    pub fn insert(&mut self, position: usize) {
        self.0[position / 64] |= 1 << (position % 64);
    }

    pub fn has(&self, position: usize) -> bool {
        self.0[position / 64] >> (position % 64) & 1 == 1
    }

    pub fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a |= b);
    }

    pub fn meets(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).any(|(a, b)| a & b != 0)
    }

    /// What is in both, ascending.
    pub fn both<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = usize> + 'a {
        self.0.iter().zip(&other.0).enumerate().flat_map(|(word, (a, b))| {
            let mut bits = a & b;
            std::iter::from_fn(move || {
                let bit = (bits != 0).then(|| bits.trailing_zeros() as usize)?;
                bits &= bits - 1;
                Some(word * 64 + bit)
            })
        })
    }
}

/// Letters in a node.
pub(super) fn letters(node: &Node) -> usize {
    match node {
        Node::One(_) => 1,
        Node::Row(all) | Node::Either(all) => all.iter().map(letters).sum(),
        Node::Repeated(node, _) => letters(node),
    }
}

/// The positions of several expressions, counted through.
pub(super) struct Positions {
    /// How many there are.
    count: usize,
    /// What may stand at each.
    letters: Vec<Letters>,
    /// What may follow each.
    pub follow: Vec<Set>,
}

/// What is to be known of a part of an expression.
struct Part {
    nullable: bool,
    first: Set,
    last: Set,
}

impl Positions {
    /// None yet, but room for so many.
    pub fn new(count: usize) -> Self {
        Self { count, letters: Vec::new(), follow: Vec::new() }
    }

    /// Adds those of an expression: where it may begin, and where it may end.
    pub fn push(&mut self, expression: &Expression) -> (Set, Set) {
        let Part { first, last, .. } = self.part(&expression.root);
        (first, last)
    }

    /// All positions where one of these letters may stand.
    pub fn of(&self, letters: Letters) -> Set {
        let mut set = Set::empty(self.count);
        let there = self.letters.iter().enumerate().filter(|(_, own)| own.0 & letters.0 != 0);
        there.for_each(|(position, _)| set.insert(position));
        set
    }

    fn part(&mut self, node: &Node) -> Part {
        let empty = || Set::empty(self.count);
        match node {
            Node::One(letters) => {
                let mut only = empty();
                only.insert(self.letters.len());
                self.follow.push(empty());
                self.letters.push(*letters);
                Part { nullable: false, first: only.clone(), last: only }
            }
            Node::Row(all) => {
                let mut row = Part { nullable: true, first: empty(), last: empty() };
                for node in all.iter().rev() {
                    let next = self.part(node);
                    self.joined(&row.last, &next.first);
                    if row.nullable {
                        row.first.add(&next.first);
                    }
                    let before = std::mem::replace(&mut row.last, next.last);
                    if next.nullable {
                        row.last.add(&before);
                    }
                    row.nullable &= next.nullable;
                }
                row
            }
            Node::Either(all) => {
                let mut either = Part { nullable: false, first: empty(), last: empty() };
                for node in all {
                    let one = self.part(node);
                    either.first.add(&one.first);
                    either.last.add(&one.last);
                    either.nullable |= one.nullable;
                }
                either
            }
            Node::Repeated(node, sign) => {
                let mut part = self.part(node);
                if *sign != Sign::Perhaps {
                    self.joined(&part.last, &part.first);
                }
                part.nullable |= *sign != Sign::Once;
                part
            }
        }
    }

    /// What begins with `first` may follow what ends with `last`.
    fn joined(&mut self, last: &Set, first: &Set) {
        for position in last.both(last) {
            self.follow[position].add(first);
        }
    }
}
