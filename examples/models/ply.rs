//! Reading a scan: binary little-endian PLY, vertices as three floats, faces as triangles.

/// Triangles over shared vertices.
pub struct Surface {
    /// Positions, in the file's units.
    pub positions: Vec<[f64; 3]>,
    /// Corners of the triangles, indices into `positions`.
    pub triangles: Vec<[usize; 3]>,
}

const END: &[u8] = b"end_header\n";
const FORMAT: [&str; 8] = [
    "format binary_little_endian 1.0",
    "element vertex",
    "property float x",
    "property float y",
    "property float z",
    "element face",
    "property list uchar int vertex_indices",
    "end_header",
];

/// Reads the text and tables of a PLY file of exactly this form.
pub fn read(bytes: &[u8]) -> Result<Surface, String> {
    let end = bytes.windows(END.len()).position(|w| w == END).ok_or("no PLY header")? + END.len();
    let header = std::str::from_utf8(&bytes[..end]).map_err(|_| "the PLY header is not text")?;
    let lines: Vec<&str> = header
        .lines()
        .filter(|line| !["ply", "comment", "obj_info"].iter().any(|word| line.starts_with(word)))
        .collect();
    let as_expected = lines.len() == FORMAT.len()
        && lines.iter().zip(FORMAT).all(|(line, expected)| line.starts_with(expected));
    if !as_expected {
        return Err(format!("expected the header {FORMAT:?}, found {lines:?}"));
    }
    let count = |line: &str| -> Result<usize, String> {
        let number = line.rsplit(' ').next().unwrap_or_default();
        number.parse().map_err(|_| format!("`{line}` has no count"))
    };
    let (vertices, faces) = (count(lines[1])?, count(lines[5])?);

    let mut rest = &bytes[end..];
    let mut take = |size: usize| -> Result<&[u8], String> {
        let (taken, left) = rest.split_at_checked(size).ok_or("the file ends too early")?;
        rest = left;
        Ok(taken)
    };
    let word = |bytes: &[u8], i: usize| [bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]];
    let mut surface = Surface { positions: Vec::new(), triangles: Vec::new() };
    for _ in 0..vertices {
        let b = take(12)?;
        surface.positions.push([0, 4, 8].map(|i| f64::from(f32::from_le_bytes(word(b, i)))));
    }
    for _ in 0..faces {
        let b = take(13)?;
        let corners = [1, 5, 9].map(|i| i32::from_le_bytes(word(b, i)) as usize);
        if b[0] != 3 || corners.iter().any(|&corner| corner >= vertices) {
            return Err("a face is no triangle over the vertices".into());
        }
        surface.triangles.push(corners);
    }
    Ok(surface)
}
