//! The Stanford bunny: scanned by Greg Turk and Marc Levoy in 1993 [Turk94]. The scan that comes
//! with the Python package pymeshfix is turned, scaled and placed like the classic
//! reconstruction, `bun_zipper`: metres, y up, the face towards -x.

use std::collections::HashMap;

use glam::DVec3;

use crate::mesh::Mesh;
use crate::obj;
use crate::ply::Surface;

/// Metres for a unit of the scan; found, with `OFFSET`, by fitting 45 vertices of `bun_zipper`
/// to the surface. They lie within 0.34 mm of it.
const SCALE: f64 = 3.1183e-3;
/// Where the scan's origin lies, in metres.
const OFFSET: DVec3 = DVec3::new(-0.016765, 0.032865, -0.001582);
/// Digits after the point: micrometres, and normals to 0.003 degrees.
const DIGITS: [usize; 2] = [6, 4];

const WHITE: &str = "\
# The course's white bunny.
newmtl white
Ka 0 0 0
Kd 0.9 0.9 0.9
Ks 0 0 0
illum 0
";

const PINK: &str = "\
# The journal's pink, under the name the bunny's faces ask for. illum 0 uses no Ks.
newmtl white
Ka 0 0 0
Kd 1 0.75 0.8
Ks 1 1 1
illum 0
";

/// The files by name.
pub fn files(scan: &Surface) -> Vec<(&'static str, String)> {
    let positions: Vec<DVec3> = scan.positions.iter().map(|&p| placed(p.into())).collect();
    let triangles = without_flaps(&scan.triangles);
    let everything = [("white", (0..triangles.len()).collect())];
    let mesh = Mesh { positions, triangles };
    let text = obj::Smooth {
        comment: "The Stanford bunny, from the Stanford 3D Scanning Repository; metres.",
        library: Some("bunny.mtl"),
        mesh: &mesh,
        normals: &mesh.smooth_normals(),
        digits: DIGITS,
        groups: &everything,
    }
    .text();
    vec![
        ("bunny.obj", text),
        ("bunny.mtl", WHITE.to_string()),
        ("bunny_pink.mtl", PINK.to_string()),
    ]
}

/// From the scan, whose z is up, to where `bun_zipper` stands.
fn placed(p: DVec3) -> DVec3 {
    DVec3::new(p.x, p.z, -p.y) * SCALE + OFFSET
}

/// Without the triangles that stick to the surface and are no part of it: none of their edges
/// joins exactly two triangles.
fn without_flaps(triangles: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let edges = |[a, b, c]: [usize; 3]| [(a, b), (b, c), (c, a)].map(|(p, q)| (p.min(q), p.max(q)));
    let mut joined: HashMap<(usize, usize), usize> = HashMap::new();
    for edge in triangles.iter().flat_map(|&triangle| edges(triangle)) {
        *joined.entry(edge).or_default() += 1;
    }
    let part_of_it = |triangle: &[usize; 3]| edges(*triangle).iter().any(|edge| joined[edge] == 2);
    triangles.iter().copied().filter(part_of_it).collect()
}
