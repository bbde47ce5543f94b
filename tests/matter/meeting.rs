//! Bodies that cross, lie on each other or are too near to be told apart.

use super::*;

/// A box from -1 to 1.
pub(super) const CUBE: &str =
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
        // Side on side.
        ([CUBE, CUBE], "move(2, 0, 0)", coincide),
        ([CUBE, CUBE], "move(2.001, 0, 0)", None),
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

/// How far any pixel is from the light that is everywhere, which nothing clear can change.
fn furnace(folder: &Path, text: &str) -> f32 {
    let text = format!(
        "{text}light around: constant {{ radiance: 1 W/m^2/sr }}
        render it {{ without light sky, camera: perspective {{ eye: (1, 2, 9), look_at: (1, 0, 0), fov_y: 50 deg }} }}\n"
    );
    let shot = open(folder, &text).unwrap_or_else(|report| panic!("{report}"));
    let picture = shot.picture(&shot.prepare(1.0), 7);
    picture.pixels.iter().map(|pixel| (pixel.g - 1.0).abs()).fold(0.0, f32::max)
}

#[test]
fn bodies_side_by_side_are_in_contact_where_one_yields() {
    let folder = folder(&[("cube.obj", CUBE), ("spindle.obj", SPINDLE)]);
    // In these directions planes of the two are not the same in single precision.
    let turned = "rotate(z, 33 deg), rotate(y, 71 deg)";
    let text = |two: &str, place: &str, [one_yields, two_yields]: [&str; 2]| {
        format!(
            "object one: mesh {{ file: \"cube.obj\", unit: m, material: dielectric {{ inside: glass }}, place: [{turned}]{one_yields} }}
            object two: mesh {{ file: \"{two}.obj\", unit: m, material: dielectric {{ inside: water }}, place: [{place}, {turned}]{two_yields} }}\n"
        )
    };
    for (two, place) in [
        // Side on side, a part of it, sides in common from within and from without.
        ("cube", "move(2, 0, 0)"),
        ("cube", "scale(1, 1, 1.65), move(2, 0, 0.65)"),
        ("cube", "scale(0.5, 1, 1)"),
        ("cube", "move(1, 0, 0)"),
        ("cube", "move(1.5, 0.5, 0)"),
        ("spindle", "scale(2, 1, 2), move(2, 0, 0)"),
    ] {
        for yields in [[", yields_to: two", ""], ["", ", yields_to: one"]] {
            let far = furnace(folder.path(), &text(two, place, yields));
            assert!(far < 1e-4, "{two} {place} {yields:?}: {far}");
        }
    }
}

#[test]
fn a_block_on_a_sea_looks_as_if_it_was_in_it_by_a_hair() {
    let folder = folder(&[("cube.obj", CUBE)]);
    let seen = |place: &str, block: &str, sea: &str| {
        let text = format!(
            "object it: mesh {{ file: \"cube.obj\", unit: m, material: dielectric {{ inside: glass }}, place: [{place}]{block} }}
            object sea: plane {{ point: (0, -1, 0), normal: y, material: dielectric {{ inside: water }}{sea} }}
            render it {{ camera.eye: (1, 2, 9), integrator.splits.specular: 12 }}\n"
        );
        let shot = open(folder.path(), &text).unwrap_or_else(|report| panic!("{report}"));
        shot.picture(&shot.prepare(1.0), 7)
    };
    let floats = ", yields_to: sea";
    let sunk = seen("move(0, -0.0001, 0)", floats, "");
    for flush in [seen("scale(1)", floats, ""), seen("scale(1)", "", ", yields_to: it")] {
        let both = sunk.pixels.iter().zip(&flush.pixels);
        let differ = both.filter(|(a, b)| (a.g - b.g).abs() > 5e-3 * a.g.abs()).count();
        assert!(differ <= sunk.pixels.len() / 50, "{differ}");
    }
    let apart = seen("move(0, 0.0001, 0)", "", "");
    let both = sunk.pixels.iter().zip(&apart.pixels);
    let differ = both.filter(|(a, b)| (a.g - b.g).abs() > 5e-3 * a.g.abs()).count();
    assert!(differ > sunk.pixels.len() / 50, "{differ}");
}

#[test]
fn two_blocks_of_one_glass_in_contact_look_like_one() {
    let folder = folder(&[("cube.obj", CUBE)]);
    let seen = |text: &str| {
        let text = format!(
            "{text}render it {{ camera.eye: (1, 2, 9), integrator.splits.specular: 12 }}\n"
        );
        let shot = open(folder.path(), &text).unwrap_or_else(|report| panic!("{report}"));
        shot.picture(&shot.prepare(1.0), 7)
    };
    let block = |name: &str, place: &str, more: &str| {
        format!(
            "object {name}: mesh {{ file: \"cube.obj\", unit: m, material: dielectric {{ inside: glass }}, place: [{place}, rotate(y, 20 deg)]{more} }}\n"
        )
    };
    let whole = seen(&block("whole", "scale(2, 1, 1)", ""));
    let two = seen(
        &(block("one", "move(-1, 0, 0)", "") + &block("two", "move(1, 0, 0)", ", yields_to: one")),
    );
    let gap = seen(&(block("one", "move(-1.0001, 0, 0)", "") + &block("two", "move(1, 0, 0)", "")));
    let differ = |other: &Picture| {
        let both = whole.pixels.iter().zip(&other.pixels);
        both.filter(|(a, b)| (a.g - b.g).abs() > 0.02 * a.g).count()
    };
    // Light from block to block would go through air, and some of it not at all.
    assert!(
        differ(&gap) > 20 && differ(&two) * 4 < differ(&gap),
        "{} {}",
        differ(&gap),
        differ(&two)
    );
}

#[test]
fn what_cannot_yield_where_it_lies_on_the_other_is_refused() {
    let pair = ball("one", "(0, 0, 0)", 1.0, "inside: glass")
        + "object two: sphere { center: (0, 0, 0), radius: 1 m, material: dielectric { inside: water }, yields_to: one }\n";
    let report = refused(&pair, "coincide");
    assert!(report.contains("`two` lies on `one`, and cannot yield to it there"), "{report}");
    // Its upper side lies on one block from above, and on another from below.
    let folder = folder(&[("cube.obj", CUBE), ("stairs.obj", &stairs())]);
    let text = "object it: mesh { file: \"cube.obj\", unit: m, material: dielectric { inside: glass }, yields_to: stairs }
        object stairs: mesh { file: \"stairs.obj\", unit: m, material: dielectric { inside: water } }\n";
    let report = world_in(folder.path(), text).err().expect("it has nowhere to go");
    assert!(report.contains("`it` lies on `stairs`, and cannot yield to it there"), "{report}");
}

/// Two cubes in one file: the one has its top in y = 1, the other its bottom.
fn stairs() -> String {
    let mut text = String::new();
    for (low, from) in [([-3.0, 0.0, -0.5], 0), ([0.5, 1.0, -0.5], 8)] {
        for line in CUBE.lines() {
            let mut words = line.split(' ');
            let kind = words.next().unwrap();
            text += kind;
            for (word, low) in words.zip(low.iter().chain([&0.0])) {
                let number: f64 = word.parse().unwrap();
                text += &match kind {
                    "v" if *low == -3.0 => format!(" {}", low + 1.5 * (number + 1.0)),
                    "v" => format!(" {}", low + 0.5 * (number + 1.0)),
                    _ => format!(" {}", number + f64::from(from)),
                };
            }
            text += "\n";
        }
    }
    text
}
