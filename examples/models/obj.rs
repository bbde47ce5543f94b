//! Writing Wavefront text: objects made of polygons, a triangle a line.

use std::fmt::Write;

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
