//! Builds the tree: obvhs clusters the boxes (PLOC [Meister18], in parallel), this file turns its
//! binary tree into one of four children a node, of bounded depth.
//!
//! obvhs sees boxes moved and scaled into the unit cube, so that areas neither vanish nor overflow,
//! and grown by a little noise: where boxes tie, as those of copies do, its clustering would join
//! one pair a round. Only the shape of its tree is taken; boxes are made afresh from the shapes.

use glam::{DVec3, Vec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use super::Bounds;
use super::block::Block;
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::{Child, DEEPEST, LANES, Node, Tree};
use crate::math::random;

/// How deep obvhs's own tree is followed. What lies deeper is cut into four equal parts again and
/// again, and four to the power of what remains is more than all shapes there can be.
const FOLLOWED: usize = DEEPEST - 16;

/// Noise, as a part of a box's own size: far below what matters to the choice of clusters.
const NOISE: f64 = 1.0 / 1024.0;
/// Noise for boxes without size, as a part of the whole.
const NOISE_OF_POINTS: f64 = 1.0 / 1_048_576.0;

/// Counts as more than any leaf holds: a sphere or disk never shares a leaf.
const ALONE: u32 = LANES as u32 + 1;

/// A shape and its box.
struct Item {
    primitive: Primitive,
    bounds: Bounds,
}

impl Tree {
    /// Over all shapes but planes.
    pub fn build(shapes: &Shapes) -> Self {
        Self::followed(shapes, FOLLOWED)
    }

    /// The same, following obvhs's tree so deep.
    pub(super) fn followed(shapes: &Shapes, depth: usize) -> Self {
        let boxed = |p| shapes.bounds_of(p).map(|b| Item { primitive: p, bounds: padded(b) });
        let items: Vec<Item> = shapes.primitives().filter_map(boxed).collect();
        let mut tree = Self { nodes: Vec::new(), blocks: Vec::new() };
        if !items.is_empty() {
            let clusters = cluster(&items);
            let weights = weights(&clusters, &items);
            let mut builder = Builder { shapes, items, clusters, weights, depth, tree: &mut tree };
            builder.root();
        }
        tree.nodes.shrink_to_fit();
        tree.blocks.shrink_to_fit();
        tree
    }
}

/// Grown by 2⁻²³ of its greatest extent, and to the next float at least. So a ray that runs exactly
/// along a face, whose parameters are then 0·∞ or nearly, is counted in.
fn padded(bounds: Bounds) -> Bounds {
    let pad = Vec3::splat((bounds.max - bounds.min).max_element() * f32::EPSILON);
    Bounds {
        min: (bounds.min - pad).map(f32::next_down),
        max: (bounds.max + pad).map(f32::next_up),
    }
}

/// obvhs's tree over the boxes, seen as told above.
fn cluster(items: &[Item]) -> Bvh2 {
    let whole = items.iter().fold(Bounds::EMPTY, |all, item| all.union(item.bounds));
    let (low, high) = (whole.min.as_dvec3(), whole.max.as_dvec3());
    let size = (high - low).max_element();
    let scale = if size > 0.0 { 1.0 / size } else { 0.0 };
    let boxes: Vec<Aabb> = (0_u64..)
        .zip(items)
        .map(|(number, item)| {
            let min = (item.bounds.min.as_dvec3() - low) * scale;
            let max = (item.bounds.max.as_dvec3() - low) * scale;
            let [luck, _] = random::unit_pair(random::mix(number));
            let noise = luck * (NOISE * (max - min).max_element() + NOISE_OF_POINTS);
            let place = |p: DVec3| {
                let p = p.as_vec3a();
                if p.is_finite() { p } else { Vec3A::ZERO }
            };
            Aabb::new(place(min - noise), place(max + noise))
        })
        .collect();
    let numbers = (0..items.len() as u32).collect();
    let mut clusters = PlocBuilder::with_capacity(boxes.len()).build(
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
fn weights(clusters: &Bvh2, items: &[Item]) -> Vec<u32> {
    let mut weights = vec![0_u32; clusters.nodes.len()];
    // Parents before children; then backwards, children before parents.
    let mut order = vec![0_usize];
    let mut done = 0;
    while let Some(&at) = order.get(done) {
        done += 1;
        let node = &clusters.nodes[at];
        if !node.is_leaf() {
            order.extend([node.first_index as usize, node.first_index as usize + 1]);
        }
    }
    for &at in order.iter().rev() {
        let node = &clusters.nodes[at];
        let first = node.first_index as usize;
        weights[at] = if node.is_leaf() {
            let item = clusters.primitive_indices[first] as usize;
            if items[item].primitive.kind() == Kind::Triangle { 1 } else { ALONE }
        } else {
            weights[first].saturating_add(weights[first + 1])
        };
    }
    weights
}

struct Builder<'a> {
    shapes: &'a Shapes,
    items: Vec<Item>,
    clusters: Bvh2,
    weights: Vec<u32>,
    /// How deep the clusters are followed.
    depth: usize,
    tree: &'a mut Tree,
}

impl Builder<'_> {
    fn root(&mut self) {
        // The walk begins at a node, even if all is one leaf.
        let at = self.reserve();
        if self.is_leaf(0) {
            let (bounds, child) = self.leaf(&self.under(0));
            self.tree.nodes[at].set(0, bounds, child);
        } else {
            self.fill(at, 0, 0);
        }
    }

    fn reserve(&mut self) -> usize {
        self.tree.nodes.push(Node::EMPTY);
        self.tree.nodes.len() - 1
    }

    fn is_leaf(&self, cluster: usize) -> bool {
        self.clusters.nodes[cluster].is_leaf() || self.weights[cluster] <= LANES as u32
    }

    /// Fills a node, `depth` nodes below the root, with what lies under an inner cluster.
    fn fill(&mut self, at: usize, cluster: usize, depth: usize) -> Bounds {
        let mut all = Bounds::EMPTY;
        for (lane, child) in self.open(cluster).into_iter().enumerate() {
            let (bounds, child) = if self.is_leaf(child) {
                self.leaf(&self.under(child))
            } else if depth + 1 < self.depth {
                let below = self.reserve();
                (self.fill(below, child, depth + 1), Child::node(below))
            } else {
                self.even(&self.under(child))
            };
            self.tree.nodes[at].set(lane, bounds, child);
            all = all.union(bounds);
        }
        all
    }

    /// Up to four clusters that make up one: the largest is opened first.
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
        parts
    }

    /// Every item under a cluster.
    fn under(&self, cluster: usize) -> Vec<usize> {
        let mut items = Vec::new();
        let mut open = vec![cluster];
        while let Some(at) = open.pop() {
            let node = &self.clusters.nodes[at];
            let first = node.first_index as usize;
            if node.is_leaf() {
                items.push(self.clusters.primitive_indices[first] as usize);
            } else {
                open.extend([first + 1, first]);
            }
        }
        items
    }

    /// A subtree whose depth is the logarithm of its items, whatever they are.
    fn even(&mut self, items: &[usize]) -> (Bounds, Child) {
        let triangles = items.iter().all(|i| self.items[*i].primitive.kind() == Kind::Triangle);
        if items.len() == 1 || (items.len() <= LANES && triangles) {
            return self.leaf(items);
        }
        let at = self.reserve();
        let mut all = Bounds::EMPTY;
        for (lane, part) in items.chunks(items.len().div_ceil(LANES)).enumerate() {
            let (bounds, child) = self.even(part);
            self.tree.nodes[at].set(lane, bounds, child);
            all = all.union(bounds);
        }
        (all, Child::node(at))
    }

    /// One sphere, one disk, or up to four triangles.
    fn leaf(&mut self, items: &[usize]) -> (Bounds, Child) {
        let items = items.iter().map(|i| &self.items[*i]);
        let bounds = items.clone().fold(Bounds::EMPTY, |all, item| all.union(item.bounds));
        let first = items.clone().map(|item| item.primitive).min();
        if let Some(round) = first.filter(|p| p.kind() != Kind::Triangle) {
            return (bounds, Child::round(round));
        }
        let triangles: Vec<_> =
            items.map(|i| (i.primitive, self.shapes.corners(i.primitive.index()))).collect();
        self.tree.blocks.push(Block::new(&triangles));
        (bounds, Child::block(self.tree.blocks.len() - 1))
    }
}
