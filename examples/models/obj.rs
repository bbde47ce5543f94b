//! Writing Wavefront text: objects made of polygons, a triangle a line.

use std::fmt::Write;

use glam::DVec3;

use crate::mesh::Mesh;

/// A group of an .obj file: its name, its material, its polygons corner by corner.
pub struct Group {
    /// After `g`.
    pub name: &'static str,
    /// After `usemtl`.
    pub material: &'static str,
    /// Corners, counter-clockwise seen from the front.
    pub quads: Vec<[[f64; 3]; 4]>,
}

/// The text of an .obj file. Corners at one place are one vertex within a group. A quad is cut
/// from its first corner to its third: some of Cornell's are not quite flat.
pub fn text(comment: &str, library: &str, groups: &[Group]) -> String {
    let mut text = format!("# {comment}\nmtllib {library}\n");
    let mut written = 0;
    for group in groups {
        let mut vertices: Vec<[f64; 3]> = Vec::new();
        let mut faces = String::new();
        for quad in &group.quads {
            let [a, b, c, d] = quad.map(|corner| {
                let known = vertices.iter().position(|v| *v == corner);
                let index = known.unwrap_or_else(|| {
                    vertices.push(corner);
                    vertices.len() - 1
                });
                written + index + 1
            });
            faces += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
        }
        let _ = writeln!(text, "\ng {}", group.name);
        for [x, y, z] in &vertices {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        let _ = write!(text, "usemtl {}\n{faces}", group.material);
        written += vertices.len();
    }
    text
}

/// A surface to be written with its normals.
pub struct Smooth<'a> {
    /// The first line, without its `#`.
    pub comment: &'a str,
    /// The .mtl file, if it has materials.
    pub library: Option<&'a str>,
    /// The surface.
    pub mesh: &'a Mesh,
    /// The normal at each vertex.
    pub normals: &'a [DVec3],
    /// Digits after the point of positions and of normals.
    pub digits: [usize; 2],
    /// The names of materials, and which triangles have them.
    pub groups: &'a [(&'a str, Vec<usize>)],
}

impl Smooth<'_> {
    /// The text of the .obj file.
    pub fn text(&self) -> String {
        let mut text = format!("# {}\n", self.comment);
        if let Some(library) = self.library {
            let _ = writeln!(text, "mtllib {library}");
        }
        let [positions, normals] = [&self.mesh.positions[..], self.normals];
        for ((letters, vectors), digits) in
            [("v", positions), ("vn", normals)].into_iter().zip(self.digits)
        {
            for v in vectors {
                let [x, y, z] = v.to_array().map(|value| rounded(value, digits));
                let _ = writeln!(text, "{letters} {x} {y} {z}");
            }
        }
        for (material, triangles) in self.groups {
            let _ = writeln!(text, "usemtl {material}");
            for &triangle in triangles {
                let [a, b, c] = self.mesh.triangles[triangle].map(|corner| corner + 1);
                let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
            }
        }
        text
    }
}

/// A number with so many digits after the point, without a minus before zero.
fn rounded(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.to_string(),
        _ => text,
    }
}
