//! Drops triangles that have no area and triangles that are there twice: the first give no
//! normal, the second fight over every ray.

use glam::DVec3;
use rayon::slice::ParallelSliceMut;

use crate::math::Mesh;

/// Triangles that were left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dropped {
    pub count: u64,
    /// The number of the first line that made one.
    pub first_line: u32,
}

/// What is left.
pub(super) struct Tidy {
    /// Triangles in their order, with the vertices and slots they use.
    pub mesh: Mesh,
    /// For each slot, the slot it was.
    pub slots: Vec<u32>,
    /// Triangles whose area is zero in f64.
    pub degenerate: Option<Dropped>,
    /// Triangles with the corners of an earlier one, whichever way round.
    pub repeated: Option<Dropped>,
}

/// Goes through a mesh; `lines` has the line of each triangle.
pub(super) fn tidy(mesh: Mesh, lines: &[u32]) -> Tidy {
    let mut keep: Vec<bool> = mesh.triangles.iter().map(|t| has_area(&mesh, t)).collect();
    let degenerate = dropped(&keep, lines);
    let solid = keep.clone();
    drop_repeated(&mesh, &mut keep);
    let repeats: Vec<bool> =
        keep.iter().zip(&solid).map(|(kept, solid)| *kept || !*solid).collect();
    let repeated = dropped(&repeats, lines);
    let slots = (0..mesh.material_names.len() as u32).collect();
    if degenerate.is_none() && repeated.is_none() {
        return Tidy { mesh, slots, degenerate, repeated };
    }
    let (mesh, slots) = kept(mesh, &keep);
    Tidy { mesh, slots, degenerate, repeated }
}

fn dropped(keep: &[bool], lines: &[u32]) -> Option<Dropped> {
    let gone = || keep.iter().zip(lines).filter(|(keep, _)| !**keep);
    let first_line = gone().map(|(_, line)| *line).min()?;
    Some(Dropped { count: gone().count() as u64, first_line })
}

/// Whether a triangle's area is not zero in f64, however small or large its edges are.
fn has_area(mesh: &Mesh, triangle: &[u32; 3]) -> bool {
    let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
    let (u, v) = (b - a, c - a);
    let unit = |e: DVec3| e / e.abs().max_element();
    u != DVec3::ZERO && v != DVec3::ZERO && unit(u).cross(unit(v)) != DVec3::ZERO
}

/// Of triangles with the same corners, keeps the first. Corners are the same if their positions
/// are, whatever their numbers.
fn drop_repeated(mesh: &Mesh, keep: &mut [bool]) {
    let same = same_positions(&mesh.positions);
    let solid = (0..mesh.triangles.len()).filter(|i| keep[*i]);
    let mut all: Vec<([u32; 3], u32)> = solid
        .map(|i| {
            let mut corners = mesh.triangles[i].map(|corner| same[corner as usize]);
            corners.sort_unstable();
            (corners, i as u32)
        })
        .collect();
    all.par_sort_unstable();
    for pair in all.windows(2) {
        if pair[0].0 == pair[1].0 {
            keep[pair[1].1 as usize] = false;
        }
    }
}

/// For each vertex, the first one at its position.
fn same_positions(positions: &[DVec3]) -> Vec<u32> {
    // Adding zero turns -0 into 0.
    let bits = |i: u32| positions[i as usize].to_array().map(|x| (x + 0.0).to_bits());
    let mut order: Vec<([u64; 3], u32)> =
        (0..positions.len() as u32).map(|i| (bits(i), i)).collect();
    order.par_sort_unstable();
    let mut same = vec![0; positions.len()];
    let mut first = 0;
    for at in 0..order.len() {
        if at == 0 || order[at].0 != order[at - 1].0 {
            first = order[at].1;
        }
        same[order[at].1 as usize] = first;
    }
    same
}

/// The mesh of the triangles that are kept, and for each slot which one it was.
fn kept(mesh: Mesh, keep: &[bool]) -> (Mesh, Vec<u32>) {
    let filter = |all: Vec<[u32; 3]>| -> Vec<[u32; 3]> {
        all.into_iter().zip(keep).filter(|(_, keep)| **keep).map(|(one, _)| one).collect()
    };
    let mut triangles = filter(mesh.triangles);
    let normal_indices = filter(mesh.normal_indices);
    let coordinate_indices = filter(mesh.coordinate_indices);
    let slots = mesh.slots.into_iter().zip(keep).filter(|(_, keep)| **keep);
    let mut slots: Vec<u32> = slots.map(|(slot, _)| slot).collect();

    let old = renumber(triangles.as_flattened_mut(), mesh.positions.len());
    let positions = old.iter().map(|i| mesh.positions[*i as usize]).collect();
    let old = renumber(&mut slots, mesh.material_names.len());
    let material_names = old.iter().map(|i| mesh.material_names[*i as usize].clone()).collect();
    let (normals, coordinates) = (mesh.normals, mesh.coordinates);
    let mesh = Mesh {
        positions,
        normals,
        triangles,
        normal_indices,
        coordinates,
        coordinate_indices,
        slots,
        material_names,
    };
    (mesh, old)
}

/// Numbers anew in the order of first use; for each new number, the old one.
fn renumber(indices: &mut [u32], count: usize) -> Vec<u32> {
    const UNUSED: u32 = u32::MAX;
    let mut new = vec![UNUSED; count];
    let mut old = Vec::new();
    for index in indices {
        let number = &mut new[*index as usize];
        if *number == UNUSED {
            *number = old.len() as u32;
            old.push(*index);
        }
        *index = *number;
    }
    old
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: positions.iter().map(|p| DVec3::from_array(*p)).collect(),
            triangles: triangles.to_vec(),
            slots: (0..triangles.len() as u32).collect(),
            material_names: (0..triangles.len()).map(|i| format!("m{i}")).collect(),
            ..Mesh::default()
        }
    }

    #[test]
    fn what_has_no_area_goes_and_slivers_stay() {
        let positions =
            [[0., 0., 0.], [0.1, 0.1, 0.1], [0.3, 0.3, 0.3], [0., 1e-200, 0.], [1e-200, 0., 0.]];
        let triangles = [[0, 1, 2], [0, 0, 1], [1, 0, 1], [0, 3, 4], [0, 3, 2]];
        let tidy = tidy(mesh(&positions, &triangles), &[7, 5, 9, 11, 12]);
        assert_eq!(tidy.degenerate, Some(Dropped { count: 3, first_line: 5 }));
        assert_eq!(tidy.repeated, None);
        assert_eq!(tidy.mesh.triangles, [[0, 1, 2], [0, 1, 3]]);
        assert_eq!(tidy.mesh.positions.len(), 4);
        assert_eq!(
            (tidy.mesh.material_names, tidy.slots),
            (vec!["m3".into(), "m4".into()], vec![3, 4])
        );
    }

    #[test]
    fn triangles_at_the_same_place_are_one_whichever_way_round() {
        let positions = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [-0.0, 0., 0.], [5., 5., 5.]];
        let triangles = [[0, 1, 2], [1, 2, 3], [2, 1, 0], [0, 1, 4]];
        let tidy = tidy(mesh(&positions, &triangles), &[1, 4, 3, 2]);
        assert_eq!(tidy.repeated, Some(Dropped { count: 2, first_line: 3 }));
        assert_eq!(tidy.degenerate, None);
        assert_eq!(tidy.mesh.triangles, [[0, 1, 2], [0, 1, 3]]);
        assert_eq!(tidy.mesh.slots, [0, 1]);
    }

    #[test]
    fn a_mesh_in_order_stays_as_it_is() {
        let good = mesh(&[[9., 9., 9.], [0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], &[[1, 2, 3]]);
        assert_eq!(tidy(good.clone(), &[1]).mesh, good);
    }
}
