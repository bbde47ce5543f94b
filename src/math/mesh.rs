//! A triangle mesh in f64, in the units of its file.

use glam::DVec3;

/// Triangles over shared vertices. Indices are in range and positions finite: whoever makes one
/// sees to that.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions, in file units.
    pub positions: Vec<DVec3>,
    /// Shading normals, unit length; a triangle refers to them by `normal_indices`.
    pub normals: Vec<DVec3>,
    /// Corners of each triangle, counter-clockwise seen from its front.
    pub triangles: Vec<[u32; 3]>,
    /// Normals at the corners of each triangle; empty if no triangle has any,
    /// [`Mesh::NO_NORMAL`] at the corners of a triangle that has none.
    pub normal_indices: Vec<[u32; 3]>,
    /// Material slot of each triangle, an index into `material_names`.
    pub slots: Vec<u32>,
    /// Names of the material slots, as the file has them, in order of first use; the empty name
    /// is the slot of faces that name none.
    pub material_names: Vec<String>,
}

impl Mesh {
    /// Stands in `normal_indices` for a corner without a shading normal.
    pub const NO_NORMAL: u32 = u32::MAX;

    /// How many triangles of a slot lack texture coordinates, and how many it has.
    pub fn without_coordinates(&self, slot: u32) -> (usize, usize) {
        let of_slot = |number: usize| self.slots.get(number).copied().unwrap_or(0) == slot;
        let all = (0..self.triangles.len()).filter(|number| of_slot(*number)).count();
        (all, all)
    }
}
