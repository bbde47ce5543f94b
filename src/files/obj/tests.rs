//! Texts of .obj files, good and bad.

use glam::DVec3;
use proptest::prelude::*;

use super::{Of, Reading, Unread, What, parse};
use crate::math::{Mesh, NoProgress};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn read(text: impl AsRef<[u8]>) -> Reading {
    parse(text.as_ref(), &NoProgress).unwrap()
}

fn mesh(text: impl AsRef<[u8]>) -> Mesh {
    let reading = read(text);
    assert_eq!(reading.faults, []);
    reading.obj.unwrap().mesh
}

/// Each fault: how, in which line, on which words.
fn faults(text: impl AsRef<[u8]>) -> Vec<(What, usize, String)> {
    let reading = read(text);
    assert_eq!(reading.obj.is_none(), !reading.faults.is_empty());
    let words = |fault: super::Fault| {
        let place = fault.place;
        let shown = place.text[..place.range.start].matches('\n').count() + place.first_line;
        assert_eq!(shown, place.line, "the excerpt begins where it says");
        (fault.what, place.line, place.text[place.range].to_string())
    };
    reading.faults.into_iter().map(words).collect()
}

fn one_fault(text: impl AsRef<[u8]>) -> (What, usize, String) {
    let mut all = faults(text);
    assert_eq!(all.len(), 1, "{all:?}");
    all.remove(0)
}

fn refused(bytes: &[u8]) -> String {
    parse(bytes, &NoProgress).unwrap_err().to_string()
}

#[test]
fn faces_normals_and_materials_are_read() {
    let text = "mtllib paint.mtl\no thing\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvt 0 0\n\
                vn 0 0 2\ng front\nusemtl white wall\nf 1//1 2//1 3//1 4//1\n\
                usemtl red\nf -4/1 -3/1 -2/1\nusemtl white wall\nf 4 3 2\n";
    let obj = read(text).obj.unwrap();
    let mesh = &obj.mesh;
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 2], [3, 2, 1]]);
    assert_eq!(mesh.positions[2], DVec3::new(1.0, 1.0, 0.0));
    assert_eq!(mesh.normals, [DVec3::Z]);
    let none = [Mesh::NO_NORMAL; 3];
    assert_eq!(mesh.normal_indices, [[0; 3], [0; 3], none, none]);
    assert_eq!(mesh.slots, [0, 0, 1, 0]);
    assert_eq!(mesh.material_names, ["white wall", "red"]);
    assert_eq!(obj.lines, [11, 11, 13, 15]);
    assert_eq!(obj.slots.iter().map(|slot| slot.line).collect::<Vec<_>>(), [10, 12]);
    assert_eq!(obj.libraries[0].0, "paint.mtl");
}

#[test]
fn numbers_are_read_to_the_last_digit() {
    let text = "v 0.1 1e-300 -123456789.123456789\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(mesh(text).positions[0], DVec3::new(0.1, 1e-300, -123_456_789.123_456_79));
}

#[test]
fn what_tobj_refuses_or_mistakes_is_read_right() {
    // A continuation, a name that is not UTF-8, line ends of old systems, a weight of a vertex.
    assert_eq!(mesh(format!("{TRIANGLE}f 1 \\\n 2 \\\r\n 3\n")).triangles.len(), 1);
    let mut old = format!("{TRIANGLE}usemtl caf").into_bytes();
    old.extend(b"\xe9\nf 1 2 3\n");
    assert_eq!(mesh(old).material_names, ["café"]);
    assert_eq!(mesh(format!("{TRIANGLE}f 1 2 3").replace('\n', "\r")).triangles.len(), 1);
    assert_eq!(mesh("v 4 0 0 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").positions[0].x, 4.0);
    assert_eq!(mesh(format!("\u{feff}{TRIANGLE}f 1 2 3")).triangles.len(), 1);
    // Faces may come before their vertices.
    assert_eq!(mesh(format!("f 1 2 3\n{TRIANGLE}")).triangles, [[0, 1, 2]]);
    // Comments, also behind a statement.
    assert_eq!(mesh(format!("# f 9 9 9\n{TRIANGLE}f 1 2 3 # f 4\n")).triangles.len(), 1);
}

#[test]
fn tobj_alone_does_what_it_is_guarded_from() {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let alone = |text: &[u8]| {
        tobj::load_obj_buf(&mut std::io::BufReader::new(text), &options, |_| Ok(Default::default()))
    };
    let accepted = |text: String| alone(text.as_bytes()).is_ok();
    assert!(accepted(format!("{TRIANGLE}v nan 1e400 inf\nf 1 2 4\n")));
    assert!(accepted(format!("{TRIANGLE}f 1 2\nl 1 2\n")));
    assert!(alone(b"v 0 0 0\nusemtl caf\xe9\n").is_err());
    assert!(!accepted(format!("{TRIANGLE}f 1 2 \\\n3\n")));
    // A face at `f 0` would be no fault to it either, until the vertex is looked up.
    assert!(!accepted(format!("{TRIANGLE}f 0 1 2\n")));
}

#[test]
fn numbers_that_are_none_are_found() {
    let (what, line, words) = one_fault("v 0 0 0\nv 1 x7 0\n");
    assert_eq!((what, line, words.as_str()), (What::NotANumber("x7".into()), 2, "x7"));
    for word in ["nan", "NaN", "inf", "-infinity", "1e400"] {
        let (what, line, words) = one_fault(format!("v 0 0 0\n\nvn 0 {word} 0\n"));
        assert_eq!((what, line, words.as_str()), (What::NotFinite(word.into()), 3, word));
    }
    assert_eq!(one_fault("v 0 1e31 0").0, What::TooFar("1e31".into()));
    assert_eq!(one_fault(b"v 0 1\xff 0").0, What::NotANumber("1ÿ".into()));
    let wanted = What::TooFewNumbers { statement: "v", found: 2, wanted: 3 };
    assert_eq!(one_fault("v 1 2"), (wanted, 1, "v 1 2".into()));
    assert_eq!(one_fault("vt").0, What::TooFewNumbers { statement: "vt", found: 0, wanted: 1 });
}

#[test]
fn indices_of_nothing_are_found() {
    let fault = |face: &str| one_fault(format!("{TRIANGLE}vn 0 0 1\n{face}\n"));
    let beyond = |of, index, count| What::OutOfRange { of, index, count };
    assert_eq!(fault("f 1 0 2"), (What::ZeroIndex(Of::Vertices), 5, "0".into()));
    assert_eq!(fault("f 1//1 2//0 3//1").0, What::ZeroIndex(Of::Normals));
    assert_eq!(fault("f 1 2 4"), (beyond(Of::Vertices, 4, 3), 5, "4".into()));
    assert_eq!(fault("f 1 2 4000000000").0, beyond(Of::Vertices, 4_000_000_000, 3));
    assert_eq!(fault("f -1 -2 -4").0, beyond(Of::Vertices, -4, 3));
    assert_eq!(fault("f 1//1 2//1 3//2").0, beyond(Of::Normals, 2, 1));
    assert_eq!(fault("f 1 2 3/1").0, beyond(Of::TextureCoordinates, 1, 0));
    for word in ["x", "1.5", "/1", "1/2/3/4", "99999999999999999999", "1\\2"] {
        assert_eq!(
            fault(&format!("f 1 2 {word}")),
            (What::NotAnIndex(word.into()), 5, word.into())
        );
    }
}

#[test]
fn faces_that_are_none_are_found() {
    let fault = |text: &str| one_fault(format!("{TRIANGLE}vn 0 0 1\n{text}"));
    assert_eq!(fault("f 1 2"), (What::TooFewCorners(2), 5, "f 1 2".into()));
    assert_eq!(fault("f").0, What::TooFewCorners(0));
    assert_eq!(fault("f 1//1 2//1 3").0, What::MixedNormals);
    assert_eq!(fault("usemtl"), (What::MissingName("usemtl"), 5, "usemtl".into()));
    assert_eq!(fault("mtllib  ").0, What::MissingName("mtllib"));
}

#[test]
fn a_line_without_end_is_not_kept() {
    let endless = format!("{TRIANGLE}f{}\n", " 1 2 3".repeat(1_000_000));
    assert_eq!(one_fault(endless), (What::TooManyWords(100_000), 4, "f".into()));
}

#[test]
fn a_fault_in_a_joined_line_is_found_in_its_own() {
    let (what, line, _) = one_fault(format!("{TRIANGLE}f 1 \\\n 2 \\\n 7\n"));
    assert_eq!(line, 6, "{what:?}");
}

#[test]
fn faults_are_told_in_order_and_counted_beyond_twenty() {
    let text = format!("{TRIANGLE}{}", "f 1 2 x\n".repeat(500));
    let reading = read(text);
    assert_eq!((reading.faults.len(), reading.more), (20, 480));
    let all = faults(format!("f 1 2 9\nv 1\n{TRIANGLE}f 0 1 2\n"));
    assert_eq!(all.iter().map(|fault| fault.1).collect::<Vec<_>>(), [1, 2, 6]);
}

#[test]
fn names_of_libraries_may_hold_blanks() {
    let names = |text: &str| -> Vec<String> {
        read(text).obj.unwrap().libraries.into_iter().map(|library| library.0).collect()
    };
    assert_eq!(names("mtllib my paint.mtl\n"), ["my paint.mtl"]);
    assert_eq!(names("mtllib a.mtl b.MTL\nmtllib a.mtl\n"), ["a.mtl", "b.MTL"]);
    let many: String = (0..40).map(|i| format!("mtllib {i}.mtl\n")).collect();
    assert_eq!(faults(many)[0].0, What::TooManyNames("mtllib", 32));
}

#[test]
fn what_is_left_out_is_told_once_with_its_count() {
    let text = format!(
        "{TRIANGLE}v 0 0 0 1 0 0\nvn 0 0 0\np 1\nl 1 2\nl 2 3\nfoo 1\nfoo 2\ncurv 0 1 1 2\n\
         s 1\nf 1//1 2//1 3//1\nf 1 2 3\n"
    );
    let reading = read(text);
    let told: Vec<_> =
        reading.notices.iter().map(|n| (n.what.clone(), n.count, n.place.line)).collect();
    let wanted = [
        (Unread::VertexColours, 1, 4),
        (Unread::ZeroNormal, 1, 5),
        (Unread::Points, 1, 6),
        (Unread::Lines, 2, 7),
        (Unread::Unknown("foo".into()), 2, 9),
        (Unread::FreeForm, 1, 11),
        (Unread::Smoothing, 1, 12),
    ];
    assert_eq!(told, wanted);
    // A normal without direction is none.
    let mesh = reading.obj.unwrap().mesh;
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(mesh.normal_indices, [[Mesh::NO_NORMAL; 3]; 2]);
}

#[test]
fn concave_quadrilaterals_are_split_where_they_can_be() {
    let arrow = "v 1 0 0\nv 0.2 0.2 0\nv 0 1 0\nv 0 0 0\nf 1 2 3 4\n";
    let mesh = mesh(arrow);
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        (b - a).cross(c - a).z / 2.0
    };
    let areas: Vec<f64> = mesh.triangles.iter().map(area).collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert!((areas.iter().sum::<f64>() - 0.2).abs() < 1e-12);
    let bow = read(
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n\
                    f 1 2 3 4 5 6 7 8\n",
    );
    assert_eq!(bow.notices[0].what, Unread::Concave);
}

#[test]
fn other_formats_are_named() {
    assert_eq!(refused(b"ply\nformat ascii"), "is a PLY file");
    assert_eq!(refused(b"\0\0\0"), "is no text: it holds zero bytes");
    assert_eq!(refused(b"newmtl white\nKd 1 1 1\n"), "is a .mtl file, not an .obj file");
    let garbage = "the quick brown fox\n".repeat(1000);
    let wanted = "is no Wavefront .obj file: no line of it is a statement of one";
    assert_eq!(refused(garbage.as_bytes()), wanted);
    assert!(read("").obj.unwrap().mesh.triangles.is_empty());
    assert!(read("# nothing\n").obj.unwrap().mesh.triangles.is_empty());
}

#[test]
fn a_hundred_megabytes_of_garbage_are_refused() {
    // Bytes without a zero and mostly without line ends; one statement keeps it from being
    // refused as no .obj file at once.
    let mut state = 1_u64;
    let mut garbage = b"v 0 0 0\n".to_vec();
    garbage.extend((0..100_000_000 / 8).flat_map(|_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state | 0x0101_0101_0101_0101).to_le_bytes()
    }));
    let reading = read(&garbage);
    let nothing = reading.obj.is_none_or(|obj| obj.mesh.triangles.is_empty());
    assert!(nothing && reading.faults.len() <= 20 && reading.notices.len() < 20);
}

/// A valid file with a bit of everything.
const VALID: &str = "# a comment\nmtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0 1\nv 0 0 1 1 0 0\n\
                     vt 0 0\nvn 0 0 1\no x\ng y\ns 1\nusemtl white\nf 1/1/1 2/1/1 3/1/1\n\
                     f 1 2 \\\n 3 4\nusemtl red\nf -1 -2 -3\nl 1 2\np 1\n";

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = parse(&bytes, &NoProgress);
    }

    #[test]
    fn no_change_of_a_valid_file_makes_the_reader_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4), 1..8),
    ) {
        let mut bytes = VALID.as_bytes().to_vec();
        for (at, byte, how) in changes {
            let at = at.index(bytes.len());
            match how {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, b"0-./\\ \n#"[usize::from(byte) % 8]),
                2 => drop(bytes.drain(at..(at + usize::from(byte % 20)).min(bytes.len()))),
                _ => bytes.extend_from_within(at..),
            }
            if bytes.is_empty() {
                bytes.push(b'f');
            }
        }
        if let Ok(Reading { obj: Some(obj), .. }) = parse(&bytes, &NoProgress) {
            let mesh = &obj.mesh;
            prop_assert!(mesh.positions.iter().all(|p| p.is_finite()));
            prop_assert!(mesh.normals.iter().all(|n| n.is_finite()));
            let count = mesh.positions.len() as u32;
            prop_assert!(mesh.triangles.iter().flatten().all(|i| *i < count));
            let normal = |i: &u32| *i == Mesh::NO_NORMAL || (*i as usize) < mesh.normals.len();
            prop_assert!(mesh.normal_indices.iter().flatten().all(normal));
            prop_assert_eq!(mesh.slots.len(), mesh.triangles.len());
            prop_assert_eq!(obj.lines.len(), mesh.triangles.len());
            prop_assert_eq!(obj.slots.len(), mesh.material_names.len());
        }
    }
}
