//! Bodies that cross, lie on each other or are too near to be told apart.

use super::*;

/// A box from -1 to 1.
const CUBE: &str =
    "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

/// Two pyramids base to base: their rim lies in y = 0.
const SPINDLE: &str = "v 1 0 0\nv 0 0 1\nv -1 0 0\nv 0 0 -1\nv 0 1 0\nv 0 -1 0
f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\nf 2 6 1\nf 3 6 2\nf 4 6 3\nf 1 6 4\n";

/// What two meshes, the second of them placed so, are found to be: none is no fault.
fn met(files: [&str; 2], place: &str) -> Option<&'static str> {
    let folder = folder(&[("one.obj", files[0]), ("two.obj", files[1])]);
    let text = format!(
        "object one: mesh {{ file: \"one.obj\", unit: m, material: dielectric {{ inside: glass }} }}
        object two: mesh {{ file: \"two.obj\", unit: m, material: dielectric {{ inside: water }}, place: [{place}] }}\n"
    );
    let report = world_in(folder.path(), &text).err()?;
    let codes = ["matter/cross", "matter/coincide"];
    Some(codes.into_iter().find(|code| report.contains(code)).unwrap_or_else(|| panic!("{report}")))
}

#[test]
fn bodies_cross_where_edges_meet_edges_and_diagonals() {
    let cross = Some("matter/cross");
    for (files, place, expected) in [
        // Edges through the diagonals of the sides of the other.
        ([CUBE, CUBE], "move(1, 1, 1)", cross),
        ([CUBE, CUBE], "move(1, 0.5, 0.5)", cross),
        ([CUBE, CUBE], "move(1, 1, 0.5)", cross),
        // Mirrored in a plane: edges meet edges alone.
        ([SPINDLE, SPINDLE], "move(1, 0, 0)", cross),
        ([SPINDLE, SPINDLE], "move(0, 1, 0)", cross),
        ([SPINDLE, SPINDLE], "move(0.5, 0, 0.5)", cross),
        // Edges of the one lie in sides of the other, and no triangle goes through one.
        ([CUBE, SPINDLE], "scale(0.5), move(0, 1, 0)", cross),
        ([CUBE, SPINDLE], "scale(0.5), move(0, -1, 0.1)", cross),
        ([SPINDLE, CUBE], "scale(0.2), move(0, 0.2, 0)", None),
        // Apart by a little, a tip on a side, edge on edge, ridge across ridge, corner to corner.
        ([CUBE, SPINDLE], "move(0, 2.001, 0)", None),
        ([CUBE, SPINDLE], "move(0, 2, 0)", None),
        ([CUBE, SPINDLE], "scale(0.5), move(0.5, 0, 0)", None),
        ([CUBE, CUBE], "move(2, 2, 0)", None),
        ([CUBE, CUBE], "rotate(x, 45 deg), move(0, 2.41421356237309505, 0)", None),
        ([SPINDLE, SPINDLE], "move(2, 0, 0)", None),
        ([SPINDLE, SPINDLE], "rotate(y, 90 deg), move(1, 1, 0)", None),
        ([CUBE, CUBE], "move(2, 2, 2)", None),
        // One has the whole side of the other.
        ([CUBE, CUBE], "move(2, 0, 0)", None),
        ([CUBE, CUBE], "scale(0.5)", None),
    ] {
        assert_eq!(met(files, place), expected, "{place} of {}", files[1]);
    }
    // A plane through the rim.
    let folder = folder(&[("it.obj", SPINDLE)]);
    let text = |height: &str| {
        format!(
            "object it: mesh {{ file: \"it.obj\", unit: m, material: dielectric {{ inside: glass }} }}
            object sea: plane {{ point: (0, {height}, 0), normal: y, material: dielectric {{ inside: water }} }}\n"
        )
    };
    let report = world_in(folder.path(), &text("0")).err().expect("it is in the sea by half");
    assert!(report.contains("matter/cross"), "{report}");
    assert!(world_in(folder.path(), &text("-1")).is_ok());
}

#[test]
fn meshes_on_each_other_coincide_even_if_they_have_their_corners_in_common() {
    let coincide = Some("matter/coincide");
    for (files, place, expected) in [
        ([CUBE, CUBE], "scale(1)", coincide),
        ([SPINDLE, SPINDLE], "scale(1)", coincide),
        ([SPINDLE, SPINDLE], "rotate(y, 90 deg)", coincide),
        // Of the same base.
        ([CUBE, CUBE], "move(0, 1, 0), scale(1, 2, 1), move(0, -1, 0)", coincide),
        ([CUBE, CUBE], "scale(1, 0.5, 1)", coincide),
        ([SPINDLE, SPINDLE], "scale(0.99)", None),
    ] {
        assert_eq!(met(files, place), expected, "{place} of {}", files[1]);
    }
}

#[test]
fn surfaces_that_single_precision_does_not_tell_apart_coincide() {
    for (inner, is_near) in [(0.9999998, true), (0.9999996, false), (0.9999, false)] {
        let text = ball("one", "(0, 0, 0)", 1.0, "inside: glass")
            + &ball("two", "(0, 0, 0)", inner, "inside: water");
        match is_near {
            true => drop(refused(&text, "coincide")),
            false => drop(world(&text).unwrap_or_else(|report| panic!("{report}"))),
        }
    }
    for mesh in [CUBE, SPINDLE] {
        assert_eq!(met([mesh, mesh], "scale(0.9999998)"), Some("matter/coincide"));
        assert_eq!(met([mesh, mesh], "scale(0.999999)"), None);
    }
    // In a larger scene they are nearer.
    let pair = ball("one", "(0, 0, 0)", 1.0, "inside: glass")
        + &ball("two", "(0, 0, 0)", 0.9999, "inside: water");
    assert!(world(&pair).is_ok());
    let far = "object far: sphere { center: (0, 2000, 0), radius: 1 m, material: diffuse { albedo: 0.5 } }\n";
    assert!(refused(&(pair + far), "coincide").contains("300 um"));
}
