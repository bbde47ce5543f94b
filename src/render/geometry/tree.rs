//! The tree over all bounded shapes: what [`super::build`] makes and [`super::walk`] walks.

use super::ask::Walker;
use super::block::Block;
use super::node::Node;

/// The tree.
pub(super) struct Tree {
    /// The first is the root; children come after their parents.
    pub nodes: Vec<Node>,
    pub blocks: Vec<Block>,
    /// Whether all coordinates of triangles are below [`super::ray::MODERATE`].
    pub moderate: bool,
    pub walker: Walker,
}

impl Tree {
    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>() + self.blocks.capacity() * size_of::<Block>()
    }
}
