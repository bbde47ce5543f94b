//! An expression as a tree, and what can be wrong with its text.

use std::fmt::{self, Display, Formatter};
use std::ops::Range;

use super::automaton::{Automaton, Which};
use super::{dead, parse};

/// The longest text, in bytes.
pub const MOST_LENGTH: usize = 1000;
/// The deepest nesting of groups.
pub const MOST_DEPTH: usize = 32;

/// A set of paths.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    pub(super) root: Node,
}

/// What is wrong with a text, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Bytes of the text.
    pub at: Range<usize>,
    /// What is wrong there.
    pub wrong: Wrong,
    /// What may have been meant in place of these bytes.
    pub instead: Option<String>,
}

/// What can be wrong with an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// Something that is no letter and no sign.
    Unknown,
    /// What follows an underscore is neither `r` nor `t`, or stands at a letter that has no sides.
    Side,
    /// A group or an alternative, or all of it, is empty.
    Empty,
    /// A `*`, `+` or `?` behind nothing.
    NothingRepeated,
    /// A `*`, `+` or `?` behind `L` or `E`, of which a path has one, or a group with one of them.
    EndRepeated,
    /// A second `*`, `+` or `?`.
    TwoSigns,
    /// A `(` that is not closed.
    Unclosed,
    /// A `)` that was not opened.
    Unopened,
    /// More than [`MOST_DEPTH`] groups in each other.
    TooDeep,
    /// More than [`MOST_LENGTH`] bytes.
    TooLong,
    /// No path is meant: none begins with `L` and ends with `E`.
    NoPath,
    /// Letters that stand on none of the paths that are meant.
    Dead,
}

/// Letters that may stand in one place: a bit for each of [`Event::ALL`](super::Event::ALL), then
/// `L`, then `E`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Letters(pub u8);

impl Letters {
    pub const LIGHT: Self = Self(0b0100_0000);
    pub const EYE: Self = Self(0b1000_0000);
    pub const ANY: Self = Self(0b0011_1111);
    /// Every set that has a name, under it.
    const NAMED: [(&'static str, Self); 12] = [
        ("L", Self::LIGHT),
        ("E", Self::EYE),
        (".", Self::ANY),
        ("D", Self(0b11)),
        ("G", Self(0b1100)),
        ("S", Self(0b11_0000)),
        ("D_r", Self(0b1)),
        ("D_t", Self(0b10)),
        ("G_r", Self(0b100)),
        ("G_t", Self(0b1000)),
        ("S_r", Self(0b1_0000)),
        ("S_t", Self(0b10_0000)),
    ];

    pub fn named(name: &str) -> Option<Self> {
        Self::NAMED.iter().find(|(known, _)| *known == name).map(|(_, letters)| *letters)
    }
}

/// How often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// `*`
    AnyTimes,
    /// `+`
    Once,
    /// `?`
    Perhaps,
}

impl Sign {
    pub fn of(char: char) -> Option<Self> {
        match char {
            '*' => Some(Self::AnyTimes),
            '+' => Some(Self::Once),
            '?' => Some(Self::Perhaps),
            _ => None,
        }
    }

    /// What both of them one after the other amount to.
    pub fn and(self, other: Self) -> Self {
        if self == other { self } else { Self::AnyTimes }
    }

    pub const fn char(self) -> char {
        match self {
            Self::AnyTimes => '*',
            Self::Once => '+',
            Self::Perhaps => '?',
        }
    }
}

/// A part of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    /// One letter of several.
    One(Letters),
    /// One after the other.
    Row(Vec<Node>),
    /// One of them.
    Either(Vec<Node>),
    /// Several times.
    Repeated(Box<Node>, Sign),
}

impl Node {
    fn reversed(&self) -> Self {
        match self {
            Self::One(letters) => Self::One(*letters),
            Self::Row(all) => Self::Row(all.iter().rev().map(Self::reversed).collect()),
            Self::Either(all) => Self::Either(all.iter().map(Self::reversed).collect()),
            Self::Repeated(node, sign) => Self::Repeated(Box::new(node.reversed()), *sign),
        }
    }
}

impl Display for Node {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let joined = |f: &mut Formatter, all: &[Self], between: &str| {
            all.iter()
                .enumerate()
                .try_for_each(|(i, node)| write!(f, "{}{node}", if i == 0 { "" } else { between }))
        };
        match self {
            Self::One(letters) => {
                let named = Letters::NAMED.iter().find(|(_, known)| known == letters);
                f.write_str(named.map_or("", |(name, _)| name))
            }
            Self::Row(all) => joined(f, all, " "),
            Self::Either(all) => {
                f.write_str("(")?;
                joined(f, all, " | ")?;
                f.write_str(")")
            }
            Self::Repeated(node, sign) if matches!(**node, Self::Row(_) | Self::Repeated(..)) => {
                write!(f, "({node}){}", sign.char())
            }
            Self::Repeated(node, sign) => write!(f, "{node}{}", sign.char()),
        }
    }
}

impl Display for Expression {
    /// With one blank between letters.
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.root.fmt(f)
    }
}

impl Expression {
    /// Reads an expression; else all that is wrong with it, in the order of the text.
    pub fn parse(text: &str) -> Result<Self, Vec<Fault>> {
        let whole = |wrong| vec![Fault { at: 0..text.len(), wrong, instead: None }];
        if text.len() > MOST_LENGTH {
            return Err(whole(Wrong::TooLong));
        }
        if text.trim().is_empty() {
            return Err(whole(Wrong::Empty));
        }
        let (root, letters) = parse::parse(text)?;
        let read = Self { root };
        if !read.means_something() {
            let instead = read.nearest(text.trim());
            return Err(vec![Fault { at: 0..text.len(), wrong: Wrong::NoPath, instead }]);
        }
        // Letters that stand beside each other are told together.
        let mut faults: Vec<Fault> = Vec::new();
        let mut previous = None;
        for number in dead::dead(&read) {
            let at = letters[number].clone();
            match faults.last_mut() {
                Some(fault) if previous == number.checked_sub(1) => fault.at.end = at.end,
                _ => faults.push(Fault { at, wrong: Wrong::Dead, instead: None }),
            }
            previous = Some(number);
        }
        if faults.is_empty() { Ok(read) } else { Err(faults) }
    }

    /// Whether there is a path that it means.
    fn means_something(&self) -> bool {
        // What is too large for an automaton is refused where one is made of it.
        Automaton::new(None, &[Which::Only(self)]).map_or(true, |made| made.layer_is_used(0))
    }

    /// What may have been meant by an expression that means no path: its ends may be missing, or
    /// stand in the first and the last alternative, or it was written from the eye to the light.
    fn nearest(&self, text: &str) -> Option<String> {
        let bare = match self.root {
            Node::Either(_) => format!("({text})"),
            _ => text.to_string(),
        };
        let all = [
            self.root.reversed().to_string(),
            self.ends_outside().unwrap_or_default(),
            format!("L {bare}"),
            format!("{bare} E"),
            format!("L {bare} E"),
        ];
        all.into_iter().find(|text| {
            let read = parse::parse(text).map(|(root, _)| Self { root });
            read.is_ok_and(|read| read.means_something() && dead::dead(&read).is_empty())
        })
    }

    /// `L (D | S) E` of `L D | S E`.
    fn ends_outside(&self) -> Option<String> {
        let Node::Either(mut all) = self.root.clone() else { return None };
        let Some(Node::Row(first)) = all.first_mut() else { return None };
        (first.remove(0) == Node::One(Letters::LIGHT)).then_some(())?;
        let Some(Node::Row(last)) = all.last_mut() else { return None };
        (last.pop()? == Node::One(Letters::EYE)).then_some(())?;
        Some(format!("L {} E", Node::Either(all)))
    }
}
