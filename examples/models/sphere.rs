//! A ball as a mesh: the faces of an icosahedron cut into small triangles, their corners pushed out
//! onto the ball. Radius 1 around the origin.

use glam::DVec3;

use crate::mesh::Mesh;
use crate::obj;

/// Pieces along an edge of the icosahedron: 20 × 20² = 8,000 triangles.
const PIECES: usize = 20;
const DIGITS: [usize; 2] = [5, 4];

/// The files by name.
pub fn files() -> Vec<(&'static str, String)> {
    let mesh = ball();
    let everything = [("white", (0..mesh.triangles.len()).collect())];
    let text = obj::Smooth {
        comment: "A ball of radius 1 as a mesh.",
        library: Some("sphere.mtl"),
        mesh: &mesh,
        normals: &mesh.positions,
        digits: DIGITS,
        groups: &everything,
    }
    .text();
    vec![("sphere.obj", text), ("sphere.mtl", MTL.to_string())]
}

const MTL: &str = "\
# The course's white.
newmtl white
Ka 0 0 0
Kd 0.9 0.9 0.9
Ks 0 0 0
illum 0
";

fn ball() -> Mesh {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let corners: Vec<DVec3> = [(1.0, golden), (1.0, -golden), (-1.0, golden), (-1.0, -golden)]
        .into_iter()
        .flat_map(|(a, b)| [DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)])
        .collect();
    let mut mesh = Mesh::default();
    for i in 0..corners.len() {
        for j in i + 1..corners.len() {
            for k in j + 1..corners.len() {
                let [a, b, c] = [i, j, k].map(|corner| corners[corner]);
                let edge = |p: DVec3, q: DVec3| p.distance_squared(q) < 4.1;
                if edge(a, b) && edge(b, c) && edge(c, a) {
                    let outward = (b - a).cross(c - a).dot(a) > 0.0;
                    cut(&mut mesh, if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    mesh
}

/// Adds a face of the icosahedron as small triangles.
fn cut(mesh: &mut Mesh, [a, b, c]: [DVec3; 3]) {
    let corner = |mesh: &mut Mesh, i: usize, j: usize| {
        let [p, q] = [i, j].map(|steps| steps as f64 / PIECES as f64);
        let place = (a + (b - a) * p + (c - a) * q).normalize();
        // Faces share the corners on their edges, up to rounding.
        let known = mesh.positions.iter().position(|other| other.distance(place) < 1e-9);
        known.unwrap_or_else(|| {
            mesh.positions.push(place);
            mesh.positions.len() - 1
        })
    };
    for i in 0..PIECES {
        for j in 0..PIECES - i {
            let [p, q, r] = [(i, j), (i + 1, j), (i, j + 1)].map(|(i, j)| corner(mesh, i, j));
            mesh.triangles.push([p, q, r]);
            if i + j + 1 < PIECES {
                let s = corner(mesh, i + 1, j + 1);
                mesh.triangles.push([q, s, r]);
            }
        }
    }
}
