//! The deterministic automaton of several expressions [Rabin59], run from the eye to the light.
//!
//! Its states are sets of positions, and those that no path can tell apart are one [Moore56].

use std::collections::{HashMap, HashSet};

use super::Event;
use super::expression::{Expression, Letters};
use super::positions::{Positions, Set, letters};

/// The most states, before those that nothing tells apart are joined.
pub const MOST_STATES: usize = 4096;
/// The most letters of all expressions together.
pub const MOST_LETTERS: usize = 1024;
/// The most layers.
pub const MOST_LAYERS: usize = 64;

/// Which paths a layer takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Which<'a> {
    /// Those of an expression that no layer before it takes.
    Only(&'a Expression),
    /// Those that no other layer takes.
    Others,
}

/// Where the light of a path goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// It is not shown.
    Outside,
    /// To the picture alone.
    Picture,
    /// To the picture, and to the layer of this number.
    Layer(u8),
}

/// What was asked for is more than [`MOST_STATES`], [`MOST_LETTERS`] or [`MOST_LAYERS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TooLarge {
    /// States.
    States,
    /// Letters.
    Letters,
    /// Layers.
    Layers,
}

/// Says of each path where its light goes. A state is a number; paths begin at [`Self::START`],
/// at the eye.
#[derive(Clone, Debug, PartialEq)]
pub struct Automaton {
    /// The next state by state and [`Event`].
    next: Vec<[u16; Event::ALL.len()]>,
    /// Where a path goes that ends at the light in this state.
    ends: Vec<End>,
    /// The state from which no path is shown; [`u16::MAX`] if there is none.
    dead: u16,
}

impl Automaton {
    /// The state of a path that has left the eye.
    pub const START: u16 = 0;

    /// The automaton of a picture of the paths of `picture`, or of all of them; a path goes to the
    /// first layer that takes it.
    pub fn new(picture: Option<&Expression>, layers: &[Which]) -> Result<Self, TooLarge> {
        if layers.len() > MOST_LAYERS {
            return Err(TooLarge::Layers);
        }
        let only = layers.iter().map(|which| match which {
            Which::Only(expression) => Some(*expression),
            Which::Others => None,
        });
        let all: Vec<Option<&Expression>> = std::iter::once(picture).chain(only).collect();
        let count = all.iter().flatten().map(|expression| letters(&expression.root)).sum();
        if count > MOST_LETTERS {
            return Err(TooLarge::Letters);
        }

        let mut positions = Positions::new(count);
        let mut first = Set::empty(count);
        let mut last: Vec<Option<Set>> = Vec::new();
        for expression in all {
            last.push(expression.map(|expression| {
                let (begin, end) = positions.push(expression);
                first.add(&begin);
                end
            }));
        }
        let others = layers.iter().position(|which| *which == Which::Others);
        let light = positions.of(Letters::LIGHT);
        let end = |state: &Set| {
            let mut lit = Set::empty(count);
            state.both(&light).for_each(|position| lit.insert(position));
            if last[0].as_ref().is_some_and(|last| !lit.meets(last)) {
                return End::Outside;
            }
            let taken = |last: &Option<Set>| last.as_ref().is_some_and(|last| lit.meets(last));
            let layer = last[1..].iter().position(taken).or(others);
            // There are at most 64.
            layer.map_or(End::Picture, |layer| End::Layer(layer as u8))
        };
        let after = |state: &Set, at: &Set| {
            let mut next = Set::empty(count);
            state.both(at).for_each(|position| next.add(&positions.follow[position]));
            next
        };

        let start = after(&first, &positions.of(Letters::EYE));
        let events = Event::ALL.map(|event| positions.of(Letters(1 << event as u8)));
        let mut numbers = HashMap::from([(start.clone(), 0_u16)]);
        let mut states = vec![start];
        let mut next = Vec::new();
        while next.len() < states.len() {
            let state = states[next.len()].clone();
            let mut row = [0; Event::ALL.len()];
            for (to, at) in row.iter_mut().zip(&events) {
                let set = after(&state, at);
                *to = match numbers.get(&set) {
                    Some(number) => *number,
                    None if states.len() == MOST_STATES => return Err(TooLarge::States),
                    None => {
                        let number = states.len() as u16;
                        numbers.insert(set.clone(), number);
                        states.push(set);
                        number
                    }
                };
            }
            next.push(row);
        }
        let ends: Vec<End> = states.iter().map(end).collect();
        Ok(Self::joined(&next, &ends))
    }

    /// The same automaton with as few states as can be, numbered as they are first met.
    fn joined(next: &[[u16; 6]], ends: &[End]) -> Self {
        let mut classes = vec![0_u16; ends.len()];
        let mut count = 0;
        // States are apart if their ends are, or if an event leads to states that are.
        loop {
            let mut seen = HashMap::new();
            let finer: Vec<u16> = (0..ends.len())
                .map(|state| {
                    let key = (
                        classes[state],
                        ends[state],
                        next[state].map(|to| classes[usize::from(to)]),
                    );
                    let new = seen.len() as u16;
                    *seen.entry(key).or_insert(new)
                })
                .collect();
            classes = finer;
            if seen.len() == count {
                break;
            }
            count = seen.len();
        }
        let mut made = Self { next: Vec::new(), ends: Vec::new(), dead: u16::MAX };
        for state in 0..ends.len() {
            // Classes are numbered in the order of their first states.
            if usize::from(classes[state]) == made.ends.len() {
                made.next.push(next[state].map(|to| classes[usize::from(to)]));
                made.ends.push(ends[state]);
            }
        }
        let dead = (0..made.ends.len()).find(|&state| {
            let stays = made.next[state].iter().all(|to| usize::from(*to) == state);
            stays && made.ends[state] == End::Outside
        });
        made.dead = dead.map_or(u16::MAX, |state| state as u16);
        made
    }

    /// The state after a scattering.
    pub fn after(&self, state: u16, event: Event) -> u16 {
        self.next[usize::from(state)][event as usize]
    }

    /// Where the light goes of a path that ends at the light in this state.
    pub fn end(&self, state: u16) -> End {
        self.ends[usize::from(state)]
    }

    /// Whether nothing of what begins in this state is shown.
    pub fn is_dead(&self, state: u16) -> bool {
        state == self.dead
    }

    /// Whether a path can go to this layer.
    pub fn layer_is_used(&self, layer: u8) -> bool {
        self.ends.contains(&End::Layer(layer))
    }

    /// Where paths of these events can go, of those that `other` shows.
    pub fn ends(&self, events: &[Event], other: &Self) -> Vec<End> {
        let mut ends = Vec::new();
        let mut states = vec![(Self::START, Self::START)];
        let mut known: HashSet<(u16, u16)> = states.iter().copied().collect();
        while let Some((own, others)) = states.pop() {
            if other.end(others) != End::Outside && !ends.contains(&self.end(own)) {
                ends.push(self.end(own));
            }
            let next = events.iter().map(|at| (self.after(own, *at), other.after(others, *at)));
            states.extend(next.filter(|next| !other.is_dead(next.1) && known.insert(*next)));
        }
        ends
    }

    /// How many states there are.
    pub fn states(&self) -> usize {
        self.ends.len()
    }

    /// Where a path goes, told by its scatterings from the eye to the light.
    pub fn of(&self, events: impl IntoIterator<Item = Event>) -> End {
        let last = events.into_iter().fold(Self::START, |state, event| self.after(state, event));
        self.end(last)
    }
}
