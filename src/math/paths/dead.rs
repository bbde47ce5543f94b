//! Letters of an expression that stand on none of the paths it means: `S` in `L D E | S`.

use super::expression::{Expression, Letters, Node};
use super::positions::{Positions, Set, letters};

/// The letters that stand on no path, by their numbers in the order of the text.
pub(super) fn dead(expression: &Expression) -> Vec<usize> {
    let count = letters(&expression.root);
    let mut positions = Positions::new(count);
    let (first, last) = positions.push(expression);
    let (eyes, lights) = (positions.of(Letters::EYE), positions.of(Letters::LIGHT));

    // From the eye on: nothing follows a light, and no second eye.
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut met = Set::empty(count);
    let mut open: Vec<usize> = first.both(&eyes).collect();
    open.iter().for_each(|eye| met.insert(*eye));
    while let Some(position) = open.pop() {
        if lights.has(position) {
            continue;
        }
        let follow = &positions.follow[position];
        for next in follow.both(follow).filter(|next| !eyes.has(*next)) {
            before[next].push(position);
            if !met.has(next) {
                met.insert(next);
                open.push(next);
            }
        }
    }
    // And back, from the lights at which paths end.
    let mut alive = Set::empty(count);
    let mut open: Vec<usize> = last.both(&lights).filter(|light| met.has(*light)).collect();
    open.iter().for_each(|light| alive.insert(*light));
    while let Some(position) = open.pop() {
        for &earlier in &before[position] {
            if !alive.has(earlier) {
                alive.insert(earlier);
                open.push(earlier);
            }
        }
    }

    let mut numbers = Vec::with_capacity(count);
    numbered(&expression.root, &mut 0, &mut numbers);
    let dead = numbers.into_iter().enumerate().filter(|(position, _)| !alive.has(*position));
    let mut dead: Vec<usize> = dead.map(|(_, number)| number).collect();
    dead.sort_unstable();
    dead
}

/// The numbers of letters in the order of the text, in the order of [`Positions`], which goes
/// through rows backwards.
fn numbered(node: &Node, next: &mut usize, numbers: &mut Vec<usize>) {
    match node {
        Node::One(_) => {
            numbers.push(*next);
            *next += 1;
        }
        Node::Row(all) => {
            let each = |node: &Node| {
                let mut own = Vec::new();
                numbered(node, next, &mut own);
                own
            };
            let each: Vec<Vec<usize>> = all.iter().map(each).collect();
            numbers.extend(each.into_iter().rev().flatten());
        }
        Node::Either(all) => all.iter().for_each(|node| numbered(node, next, numbers)),
        Node::Repeated(node, _) => numbered(node, next, numbers),
    }
}
