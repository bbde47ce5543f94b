//! The tree over a crowd: split where the bounds of both halves cost least [ContyEstevez18].

use super::bounds::Emitter;
use super::{Crowd, Next, Node};

/// Places along an axis at which a split is tried.
const BUCKETS: usize = 12;

/// More emitters than this are split along the longest axis of their box, fewer along the best one.
const MANY: usize = 512;

/// Below so many levels halves are of equal count, so that no crowd makes a deep tree.
const DEEP: u32 = 48;

/// A part of the crowd that waits for its node.
struct Waiting {
    node: usize,
    from: usize,
    to: usize,
    depth: u32,
}

pub(super) fn build(emitters: &[Emitter]) -> Option<Crowd> {
    if emitters.is_empty() {
        return None;
    }
    let mut order: Vec<u32> = (0..emitters.len() as u32).collect();
    let mut nodes = Vec::with_capacity(2 * emitters.len() - 1);
    let mut leaves = vec![0; emitters.len()];
    nodes.push((0, Next::Leaf(0)));
    let mut waiting = vec![Waiting { node: 0, from: 0, to: emitters.len(), depth: 0 }];
    while let Some(Waiting { node, from, to, depth }) = waiting.pop() {
        let part = &mut order[from..to];
        if let [only] = part {
            leaves[*only as usize] = node as u32;
            nodes[node].1 = Next::Leaf(*only);
            continue;
        }
        let middle = from + split(emitters, part, depth);
        let first = nodes.len();
        nodes[node].1 = Next::Pair(first as u32);
        for (from, to) in [(from, middle), (middle, to)] {
            waiting.push(Waiting { node: nodes.len(), from, to, depth: depth + 1 });
            nodes.push((node as u32, Next::Leaf(0)));
        }
    }
    // From the last to the first: children come after their parents.
    let mut bounds = vec![emitters[0]; nodes.len()];
    for (number, (_, next)) in nodes.iter().enumerate().rev() {
        bounds[number] = match next {
            Next::Leaf(emitter) => emitters[*emitter as usize],
            Next::Pair(first) => bounds[*first as usize].and(&bounds[*first as usize + 1]),
        };
    }
    let made = nodes.iter().zip(&bounds).map(|(links, bounds)| Node::new(bounds, *links));
    Some(Crowd { nodes: made.collect(), leaves, all: bounds[0] })
}

/// Orders two or more emitters so that the first of them go to one side; how many: at least one,
/// and not all.
fn split(emitters: &[Emitter], part: &mut [u32], depth: u32) -> usize {
    let of = |number: u32| &emitters[number as usize];
    let centres = part.iter().map(|number| of(*number).centre());
    let min = centres.clone().fold(of(part[0]).centre(), |a, b| a.min(b));
    let max = centres.fold(min, |a, b| a.max(b));
    let size = max - min;
    let longest = size.max_element();
    let half = part.len() / 2;
    if !(longest > 0.0 && longest.is_finite()) || depth >= DEEP {
        return half;
    }
    // The cheapest of all splits: its axis, and the first bucket of its second half.
    let mut best = (f64::INFINITY, 0, 0);
    let bucket = |number: u32, axis: usize| {
        let along = (of(number).centre()[axis] - min[axis]) / size[axis];
        ((along * BUCKETS as f64) as usize).min(BUCKETS - 1)
    };
    for axis in 0..3 {
        if size[axis] <= 0.0 || part.len() > MANY && size[axis] < longest {
            continue;
        }
        let mut buckets: [Option<Emitter>; BUCKETS] = [None; BUCKETS];
        for number in part.iter() {
            let bucket = &mut buckets[bucket(*number, axis)];
            *bucket = Some(bucket.map_or(*of(*number), |all| all.and(of(*number))));
        }
        let join = |buckets: &[Option<Emitter>]| {
            buckets.iter().flatten().copied().reduce(|a, b| a.and(&b))
        };
        // Thin boxes are split across their length first.
        let shape = longest / size[axis];
        for at in 1..BUCKETS {
            let (low, high) = buckets.split_at(at);
            let (Some(low), Some(high)) = (join(low), join(high)) else { continue };
            let cost = shape * (low.cost() + high.cost());
            if cost < best.0 {
                best = (cost, axis, at);
            }
        }
    }
    let (_, axis, at) = best;
    if at == 0 {
        return half;
    }
    part.sort_by_key(|number| bucket(*number, axis) >= at);
    part.partition_point(|number| bucket(*number, axis) < at)
}

impl Node {
    fn new(emitter: &Emitter, (parent, next): (u32, Next)) -> Self {
        let centre = emitter.centre().as_vec3();
        // The centre was rounded, and so is the radius.
        let off = (emitter.centre() - centre.as_dvec3()).length();
        let radius = ((emitter.radius() + off) * (1.0 + f64::from(f32::EPSILON))) as f32;
        Self {
            centre,
            radius,
            axis: emitter.axis.as_vec3(),
            spread: [emitter.spread.cos() as f32, emitter.spread.sin() as f32],
            reach: emitter.reach.cos() as f32,
            both: emitter.both,
            intensity: emitter.intensity,
            parent,
            next,
        }
    }
}
