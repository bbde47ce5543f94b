//! What all instances of a mesh share: a tree over its triangles, in a space of its own.
//!
//! That space is the mesh, moved and scaled by a power of two into [-1, 1], in f32. Its tree is made
//! as that over the shapes of the world is, of all triangles: one that has no area here may have one
//! where it stands.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};

use super::block::Block;
use super::node::Node;
use super::shapes::{Owner, Shapes, Triangle};
use super::tree::Tree;
use crate::math::{Bounds, Mesh};

/// A mesh with its tree.
pub(super) struct Template {
    pub mesh: Arc<Mesh>,
    /// From the mesh to the space of the tree: (p − `centre`) · `scale`.
    pub centre: DVec3,
    /// A power of two.
    pub scale: f64,
    /// The greatest coordinates of the mesh, without their signs.
    pub farthest: DVec3,
    pub nodes: Vec<Node>,
    pub blocks: Vec<Block>,
}

impl Template {
    pub fn new(mesh: &Arc<Mesh>) -> Self {
        let corners = mesh.triangles.iter().flatten();
        let bounds = Bounds::around(corners.map(|i| mesh.positions[*i as usize]));
        let centre = if bounds.is_empty() { DVec3::ZERO } else { bounds.centre() };
        let scale = into_one(bounds.half().max_element());
        let mut shapes = Shapes::new();
        for p in &mesh.positions {
            shapes.vertex(((*p - centre) * scale).as_vec3());
        }
        for corners in &mesh.triangles {
            shapes.triangle(Triangle { corners: *corners, normals: None, owner: Owner::default() });
        }
        let Tree { nodes, blocks, .. } = Tree::of_all(&shapes);
        let farthest = bounds.min.abs().max(bounds.max.abs());
        Self { mesh: mesh.clone(), centre, scale, farthest, nodes, blocks }
    }

    /// What a copy of it takes among the shapes of a world and in their tree, in bytes; about, since
    /// copies have nodes in common.
    pub fn bytes_of_copy(&self) -> usize {
        let mesh = &*self.mesh;
        let vectors = mesh.positions.len() + mesh.normals.len();
        let a_triangle = size_of::<Owner>() + size_of::<[u32; 3]>();
        self.nodes.len() * size_of::<Node>()
            + self.blocks.len() * size_of::<Block>()
            + vectors * size_of::<Vec3>()
            + mesh.triangles.len() * a_triangle
            + mesh.normal_indices.len() * size_of::<[u32; 3]>()
            + mesh.coordinates.len() * size_of::<Vec2>()
            + mesh.coordinate_indices.len() * size_of::<[u32; 3]>()
    }

    /// Memory held, in bytes; the mesh is part of it.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes()
            + self.nodes.capacity() * size_of::<Node>()
            + self.blocks.capacity() * size_of::<Block>()
    }
}

/// A power of two that brings a size to at most 1, and above 1/4; 1 for no size.
fn into_one(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { (-size.log2().ceil()).exp2() } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_brought_to_one() {
        for size in [1e-300, 1e-9, 0.5, 1.0, 1.0001, 3.0, 1e30] {
            let scale = into_one(size);
            assert!(size * scale > 0.25 && size * scale <= 1.0 + 1e-12, "{size}");
            assert_eq!(scale.log2().fract(), 0.0);
        }
        assert_eq!(into_one(0.0), 1.0);
    }
}
