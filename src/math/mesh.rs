//! A triangle mesh in f64, in the units of its file.

use glam::{DVec3, Vec2};

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
    /// Texture coordinates; v goes up. A triangle refers to them by `coordinate_indices`.
    pub coordinates: Vec<Vec2>,
    /// Texture coordinates at the corners of each triangle; empty if no triangle has any,
    /// [`Mesh::NO_COORDINATE`] at the corners of a triangle that lacks some.
    pub coordinate_indices: Vec<[u32; 3]>,
    /// Material slot of each triangle, an index into `material_names`.
    pub slots: Vec<u32>,
    /// Names of the material slots, as the file has them, in order of first use; the empty name
    /// is the slot of faces that name none.
    pub material_names: Vec<String>,
}

impl Mesh {
    /// Stands in `normal_indices` for a corner without a shading normal.
    pub const NO_NORMAL: u32 = u32::MAX;
    /// Stands in `coordinate_indices` for a corner of a triangle without texture coordinates.
    pub const NO_COORDINATE: u32 = u32::MAX;

    /// Texture coordinates at the corners of a triangle, by index.
    pub fn coordinates_of(&self, triangle: usize) -> Option<[u32; 3]> {
        let indices = self.coordinate_indices.get(triangle)?;
        (!indices.contains(&Self::NO_COORDINATE)).then_some(*indices)
    }

    /// Shading normals at the corners of a triangle, by index.
    pub fn normals_of(&self, triangle: usize) -> Option<[u32; 3]> {
        let indices = self.normal_indices.get(triangle)?;
        (!indices.contains(&Self::NO_NORMAL)).then_some(*indices)
    }

    /// Material slot of a triangle.
    pub fn slot(&self, triangle: usize) -> usize {
        self.slots.get(triangle).copied().unwrap_or(0) as usize
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        (self.positions.capacity() + self.normals.capacity()) * size_of::<DVec3>()
            + (self.triangles.capacity()
                + self.normal_indices.capacity()
                + self.coordinate_indices.capacity())
                * size_of::<[u32; 3]>()
            + self.coordinates.capacity() * size_of::<Vec2>()
            + self.slots.capacity() * size_of::<u32>()
    }

    /// How many triangles of a slot lack texture coordinates.
    pub fn without_coordinates(&self, slot: u32) -> usize {
        let of_slot = |number: usize| self.slots.get(number).copied().unwrap_or(0) == slot;
        let all = (0..self.triangles.len()).filter(|number| of_slot(*number));
        all.filter(|number| self.coordinates_of(*number).is_none()).count()
    }
}
