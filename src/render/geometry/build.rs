//! Builds the tree: obvhs clusters the boxes (PLOC [Meister18], in parallel), this file turns its
//! binary tree into one of eight children a node, of bounded depth.
//!
//! obvhs sees boxes moved and scaled into the unit cube, so that areas neither vanish nor overflow,
//! and grown by a little noise: where boxes tie, as those of copies do, its clustering would join
//! one pair a round. Only the shape of its tree is taken; boxes are made afresh from the shapes.
//! Triangles without area, and those whose corners are no numbers, are never met and left out.

use std::ops::Range;

use glam::{DVec3, Vec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use rayon::prelude::*;

use super::Bounds;
use super::ask::Walker;
use super::block::Block;
use super::lanes::LANES;
use super::node::{Below, Child, Node};
use super::pages;
use super::ray::MODERATE;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::triangle;
use super::walk::DEEPEST;
use crate::math::random;

/// How deep obvhs's own tree is followed. What lies deeper is cut into eight equal parts again and
/// again, and eight to the power of what remains is more than all shapes there can be.
const FOLLOWED: usize = DEEPEST - 11;

/// Noise, as a part of a box's own size: far below what matters to the choice of clusters.
const NOISE: f64 = 1.0 / 1024.0;
/// Noise for boxes without size, as a part of the whole.
const NOISE_OF_POINTS: f64 = 1.0 / 1_048_576.0;

/// Counts as more than any leaf holds: a sphere or disk never shares a leaf.
const ALONE: u32 = LANES as u32 + 1;

/// Fewer shapes than this are not worth a second thread.
const GRAIN: usize = 4096;

impl Tree {
    /// Over all shapes but planes.
    pub fn build(shapes: &Shapes) -> Self {
        Self::followed(shapes, FOLLOWED)
    }

    /// The same, with triangles that have no area: those of a mesh that is yet to be mapped.
    pub fn of_all(shapes: &Shapes) -> Self {
        Self::over_items(shapes, shapes.primitives().collect(), FOLLOWED)
    }

    /// The same, following obvhs's tree so deep.
    pub(super) fn followed(shapes: &Shapes, depth: usize) -> Self {
        let items = shapes.primitives().filter(|p| can_be_met(shapes, *p)).collect();
        Self::over_items(shapes, items, depth)
    }

    /// The nodes of a tree over boxes: its ends are spheres with their numbers.
    pub fn over(boxes: &[Bounds]) -> Vec<Node> {
        let items: Vec<_> = (0..boxes.len()).map(|i| Primitive::new(Kind::Sphere, i)).collect();
        if items.is_empty() {
            return Vec::new();
        }
        let boxed = |p: Primitive| grown(boxes[p.index()]);
        let mut nodes = Collapse::of(&boxed, items, FOLLOWED).nodes;
        enclose(&mut nodes);
        nodes
    }

    fn over_items(shapes: &Shapes, items: Vec<Primitive>, depth: usize) -> Self {
        let mut tree = Self {
            nodes: Vec::new(),
            blocks: Vec::new(),
            moderate: moderate(shapes),
            walker: Walker::found(),
        };
        if items.is_empty() {
            return tree;
        }
        let boxed = |p: Primitive| padded(shapes, p);
        let Collapse { mut nodes, leaves, order, clusters, weights, .. } =
            Collapse::of(&boxed, items, depth);
        drop((clusters, weights));
        let fill = |leaf: &Leaf| Block::new(shapes, &order[leaf.range()]);
        tree.blocks = pages::roomy(leaves.len());
        let filled = leaves.par_iter().with_min_len(GRAIN / LANES).map(fill);
        filled.collect_into_vec(&mut tree.blocks);
        for (number, leaf) in leaves.iter().enumerate() {
            let all = order[leaf.range()].iter();
            let bounds = all.fold(Bounds::EMPTY, |sum, p| sum.union(padded(shapes, *p)));
            let (node, lane) = leaf.place;
            nodes[node].set_block(lane, bounds, number);
        }
        enclose(&mut nodes);
        tree.nodes = pages::roomy(nodes.len());
        tree.nodes.append(&mut nodes);
        tree
    }
}

/// Gives nodes above others their boxes.
fn enclose(nodes: &mut [Node]) {
    // Children come after their parents.
    for at in (0..nodes.len()).rev() {
        for lane in 0..LANES {
            let child = nodes[at].children[lane];
            if child != Child::ROOT
                && let Below::Node(below) = child.below()
            {
                let bounds = nodes[below].bounds();
                nodes[at].set(lane, bounds);
            }
        }
    }
}

/// Whether a ray can meet it, and its box is one.
fn can_be_met(shapes: &Shapes, primitive: Primitive) -> bool {
    match primitive.kind() {
        Kind::Triangle => {
            let normal = triangle::normal(shapes.exact_corners(primitive.index()));
            normal != DVec3::ZERO && normal.is_finite()
        }
        Kind::Plane => false,
        _ => true,
    }
}

/// Whether all coordinates of triangles are below [`MODERATE`].
fn moderate(shapes: &Shapes) -> bool {
    shapes.vertices().iter().all(|vertex| vertex.abs().max_element() < MODERATE)
}

/// The box around a shape, grown.
fn padded(shapes: &Shapes, primitive: Primitive) -> Bounds {
    shapes.bounds_of(primitive).map_or(Bounds::EMPTY, grown)
}

/// Grown by 2⁻²³ of the greatest extent, and to the next float at least. So a ray that runs exactly
/// along a face, whose parameters are then 0·∞ or nearly, is counted in.
fn grown(bounds: Bounds) -> Bounds {
    let pad = Vec3::splat((bounds.max - bounds.min).max_element() * f32::EPSILON);
    Bounds {
        min: (bounds.min - pad).map(f32::next_down),
        max: (bounds.max + pad).map(f32::next_up),
    }
}

/// obvhs's tree over the boxes, seen as told above.
fn cluster<B: Fn(Primitive) -> Bounds + Sync>(boxed: &B, items: &[Primitive]) -> Bvh2 {
    let whole = items.par_iter().with_min_len(GRAIN).map(|p| boxed(*p));
    let whole = whole.reduce(|| Bounds::EMPTY, Bounds::union);
    let (low, high) = (whole.min.as_dvec3(), whole.max.as_dvec3());
    let size = (high - low).max_element();
    let scale = if size > 0.0 { 1.0 / size } else { 0.0 };
    let seen = |(number, primitive): (usize, &Primitive)| {
        let bounds = boxed(*primitive);
        let min = (bounds.min.as_dvec3() - low) * scale;
        let max = (bounds.max.as_dvec3() - low) * scale;
        let [luck, _] = random::unit_pair(random::mix(number as u64));
        let noise = luck * (NOISE * (max - min).max_element() + NOISE_OF_POINTS);
        let place = |p: DVec3| {
            let p = p.as_vec3a();
            if p.is_finite() { p } else { Vec3A::ZERO }
        };
        Aabb::new(place(min - noise), place(max + noise))
    };
    let boxes: Vec<Aabb> = items.par_iter().enumerate().with_min_len(GRAIN).map(seen).collect();
    let numbers = (0..items.len() as u32).collect();
    let mut clusters = PlocBuilder::new().build(
        PlocSearchDistance::Medium,
        &boxes,
        numbers,
        SortPrecision::U64,
        SEARCH_FROM,
    );
    ReinsertionOptimizer::default().run(&mut clusters, REINSERTED, None);
    clusters
}

/// Rounds of clustering that look at neighbours only, as obvhs's medium preset does.
const SEARCH_FROM: usize = 3;
/// Part of the nodes that are tried elsewhere, as obvhs's medium preset does.
const REINSERTED: f32 = 0.05;

/// How many shapes lie under each of obvhs's nodes; one [`ALONE`] counts as more than a leaf holds.
fn weights(clusters: &Bvh2, items: &[Primitive]) -> Vec<u32> {
    let mut weights = vec![0_u32; clusters.nodes.len()];
    // Parents before children; then backwards, children before parents.
    let mut order = vec![0_u32];
    let mut done = 0;
    while let Some(&at) = order.get(done) {
        done += 1;
        let node = &clusters.nodes[at as usize];
        if !node.is_leaf() {
            order.extend([node.first_index, node.first_index + 1]);
        }
    }
    for &at in order.iter().rev() {
        let node = &clusters.nodes[at as usize];
        let first = node.first_index as usize;
        weights[at as usize] = if node.is_leaf() {
            let item = clusters.primitive_indices[first] as usize;
            if items[item].kind() == Kind::Triangle { 1 } else { ALONE }
        } else {
            weights[first].saturating_add(weights[first + 1])
        };
    }
    weights
}

/// A leaf of up to eight triangles.
struct Leaf {
    /// Node and lane.
    place: (usize, usize),
    /// Its triangles, in the order of the tree.
    first: usize,
    count: usize,
}

impl Leaf {
    fn range(&self) -> Range<usize> {
        self.first..self.first + self.count
    }
}

struct Collapse<'a, B> {
    /// The box of each item.
    boxed: &'a B,
    items: Vec<Primitive>,
    clusters: Bvh2,
    weights: Vec<u32>,
    /// How deep the clusters are followed.
    depth: usize,
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
    /// The triangles of all leaves.
    order: Vec<Primitive>,
}

impl<'a, B: Fn(Primitive) -> Bounds + Sync> Collapse<'a, B> {
    /// Over items, of which there are some.
    fn of(boxed: &'a B, items: Vec<Primitive>, depth: usize) -> Self {
        let clusters = cluster(boxed, &items);
        let weights = weights(&clusters, &items);
        let (nodes, leaves, order) = (Vec::new(), Vec::new(), Vec::new());
        let mut all = Self { boxed, items, clusters, weights, depth, nodes, leaves, order };
        all.root();
        all
    }

    fn root(&mut self) {
        // The walk begins at a node, even if all is one leaf.
        self.nodes.push(Node::EMPTY);
        if self.is_leaf(0) {
            let all = self.under(0);
            self.leaf((0, 0), all);
            return;
        }
        let mut open = vec![(0, 0, 0)];
        while let Some((at, cluster, depth)) = open.pop() {
            for (lane, child) in self.open(cluster).into_iter().enumerate() {
                if self.is_leaf(child) {
                    let all = self.under(child);
                    self.leaf((at, lane), all);
                } else if depth + 1 < self.depth {
                    open.push((self.below(at, lane), child, depth + 1));
                } else {
                    let all = self.under(child);
                    self.even((at, lane), &all);
                }
            }
        }
    }

    /// A new node under a lane.
    fn below(&mut self, at: usize, lane: usize) -> usize {
        let below = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        self.nodes[at].children[lane] = Child::node(below);
        below
    }

    fn is_leaf(&self, cluster: usize) -> bool {
        self.clusters.nodes[cluster].is_leaf() || self.weights[cluster] <= LANES as u32
    }

    /// Up to eight clusters that make up one, the largest last: those are opened first.
    fn open(&self, cluster: usize) -> Vec<usize> {
        let mut parts = Vec::with_capacity(LANES);
        parts.push(cluster);
        while parts.len() < LANES {
            let area = |at: usize| self.clusters.nodes[at].aabb().half_area();
            let largest = (0..parts.len())
                .filter(|i| !self.is_leaf(parts[*i]))
                .max_by(|i, j| area(parts[*i]).total_cmp(&area(parts[*j])));
            let Some(largest) = largest else { break };
            let first = self.clusters.nodes[parts[largest]].first_index as usize;
            parts[largest] = first;
            parts.push(first + 1);
        }
        let area = |at: &usize| self.clusters.nodes[*at].aabb().half_area();
        parts.sort_by(|i, j| area(i).total_cmp(&area(j)));
        parts
    }

    /// Every shape under a cluster.
    fn under(&self, cluster: usize) -> Vec<Primitive> {
        let mut all = Vec::new();
        let mut open = vec![cluster];
        while let Some(at) = open.pop() {
            let node = &self.clusters.nodes[at];
            let first = node.first_index as usize;
            if node.is_leaf() {
                all.push(self.items[self.clusters.primitive_indices[first] as usize]);
            } else {
                open.extend([first + 1, first]);
            }
        }
        all
    }

    /// A subtree whose depth is the logarithm of its shapes, whatever they are.
    fn even(&mut self, place: (usize, usize), all: &[Primitive]) {
        let triangles = all.iter().all(|p| p.kind() == Kind::Triangle);
        if all.len() == 1 || (all.len() <= LANES && triangles) {
            self.leaf(place, all.to_vec());
            return;
        }
        let at = self.below(place.0, place.1);
        for (lane, part) in all.chunks(all.len().div_ceil(LANES)).enumerate() {
            self.even((at, lane), part);
        }
    }

    /// A sphere or disk is a child itself; triangles make up a leaf.
    fn leaf(&mut self, place: (usize, usize), mut all: Vec<Primitive>) {
        if all[0].kind() != Kind::Triangle {
            let (node, lane) = place;
            self.nodes[node].children[lane] = Child::round(all[0]);
            self.nodes[node].set(lane, (self.boxed)(all[0]));
            return;
        }
        all.sort_unstable();
        self.leaves.push(Leaf { place, first: self.order.len(), count: all.len() });
        self.order.extend(all);
    }
}
