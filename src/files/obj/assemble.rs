//! From tobj's arrays to a mesh, and what the scan noted of each triangle beside it.

use glam::{DVec3, Vec2};

use super::{Excerpt, Obj};
use crate::files::Failure;
use crate::math::Mesh;

/// What the scan noted, in the order of the triangles.
#[derive(Default)]
pub(super) struct Triangles {
    /// The line of the face.
    pub lines: Vec<u32>,
    /// The material slot.
    pub slots: Vec<u32>,
    /// Whether the face has normals.
    pub with_normals: Vec<bool>,
    /// The texture coordinates of its corners, as far as any triangle has all of them; others
    /// before have [`Mesh::NO_COORDINATE`].
    pub coordinates: Vec<[u32; 3]>,
}

/// The mesh of the one model that clean text makes.
pub(super) fn assemble(
    models: Vec<tobj::Model>,
    triangles: Triangles,
    coordinates: Vec<Vec2>,
    slots: Vec<(String, Excerpt)>,
    libraries: Vec<(String, Excerpt)>,
) -> Result<Obj, Failure> {
    let Some(model) = models.into_iter().next() else {
        return Ok(Obj { libraries, ..Obj::default() });
    };
    let read = model.mesh;
    let corners = triangles.lines.len() * 3;
    let with_normals = !read.normal_indices.is_empty();
    if read.indices.len() != corners || (with_normals && read.normal_indices.len() != corners) {
        return Err(Failure::new("cannot be understood by the .obj reader: it lost faces"));
    }
    let normals: Vec<_> = vectors(&read.normals).map(unit).collect();
    let normal_indices = if triangles.with_normals.contains(&true) {
        let corners = read.normal_indices.as_chunks::<3>().0.iter();
        let usable =
            |corners: &[u32; 3]| corners.iter().all(|i| normals[*i as usize] != DVec3::ZERO);
        let either = corners.zip(&triangles.with_normals).map(|(corners, has)| {
            if *has && usable(corners) { *corners } else { [Mesh::NO_NORMAL; 3] }
        });
        either.collect()
    } else {
        Vec::new()
    };
    let (material_names, slots) = slots.into_iter().unzip();
    let mut coordinate_indices = triangles.coordinates;
    if !coordinate_indices.is_empty() {
        coordinate_indices.resize(triangles.lines.len(), [Mesh::NO_COORDINATE; 3]);
    }
    let mesh = Mesh {
        positions: vectors(&read.positions).collect(),
        normals: if normal_indices.is_empty() { Vec::new() } else { normals },
        triangles: read.indices.as_chunks::<3>().0.to_vec(),
        normal_indices,
        coordinates: if coordinate_indices.is_empty() { Vec::new() } else { coordinates },
        coordinate_indices,
        slots: triangles.slots,
        material_names,
    };
    Ok(Obj { mesh, lines: triangles.lines, slots, libraries })
}

fn vectors(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    numbers.as_chunks::<3>().0.iter().map(|v| DVec3::from_array(*v))
}

/// Of unit length, whatever its length is; zero stays zero.
fn unit(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    if largest == 0.0 { DVec3::ZERO } else { (v / largest).normalize() }
}
