//! Bodies that are large and too thin for single precision.

use super::meeting::CUBE;
use super::*;

/// The report of a box placed so, and of a ball far away, if it is refused; else the picture.
fn pane(place: &str, far: &str) -> Result<Picture, String> {
    let folder = folder(&[("cube.obj", CUBE)]);
    let ball = match far {
        "" => String::new(),
        at => format!(
            "object far: sphere {{ center: {at}, radius: 1 m, material: diffuse {{ albedo: 0.5 }} }}\n"
        ),
    };
    let text = format!(
        "object pane: mesh {{ file: \"cube.obj\", unit: m, material: dielectric {{ inside: glass }}, place: [{place}] }}\n{ball}"
    );
    let text = HEAD.replace(
        "preetham { turbidity: 3, latitude: 40 deg, day: 172, time: 10:00, sun: none }",
        "constant { radiance: 1 W/m^2/sr }",
    ) + &text;
    let shot = shots::open_text(&folder.path().join("it.scn"), &text, &[])?.remove(0);
    let picture = shot.prepare(1.0);
    Ok(shot.picture(&picture, 7))
}

#[test]
fn what_is_too_thin_for_light_to_go_through_is_refused_and_what_is_not_is_right() {
    for (place, far) in [
        ("scale(1, 1, 5e-8)", ""),
        ("scale(1, 1, 1e-8)", ""),
        ("scale(1, 1, 1e-18)", ""),
        ("scale(1, 1, 1e-24)", ""),
        ("scale(1, 1, 1e-4), rotate((1, 2, 3), 20 deg), move(0.3, 0.2, 1000)", "(0, 0, -1000)"),
    ] {
        let report = pane(place, far).err().unwrap_or_else(|| panic!("accepted: {place}"));
        assert!(report.contains("matter/too-small"), "{report}");
        assert_eq!(report.matches("error[").count(), 1, "{report}");
    }
    // Five steps: told, and rendered.
    let report = pane("scale(1, 1, 3e-7)", "").expect_err("it is told");
    assert!(report.contains("warning[scene/too-small]") && !report.contains("error["), "{report}");
    for place in
        ["scale(1, 1, 1.5e-3)", "scale(1, 1, 6e-7)", "scale(1, 1, 6e-7), rotate((1, 2, 3), 20 deg)"]
    {
        let picture = pane(place, "").unwrap_or_else(|report| panic!("{place}: {report}"));
        let off = picture.pixels.iter().map(|pixel| (pixel.g - 1.0).abs()).fold(0.0, f32::max);
        assert!(off < 1e-3, "{place}: {off}");
    }
}

#[test]
fn a_body_that_is_small_and_lies_on_another_is_told_once() {
    let text = ball("one", "(0, 0, 0)", 0.1, "inside: glass")
        + &ball("two", "(0, 0, 0)", 0.1, "inside: water")
        + "object far: sphere { center: (4000000, 0, 0), radius: 1 m, material: diffuse { albedo: 0.5 } }\n";
    let report = refused(&text, "too-small");
    assert!(!report.contains("matter/coincide"), "{report}");
}

#[test]
fn sharp_edges_are_not_thin() {
    // Two shallow cones base to base: in the outermost ring of faces, less than a thousandth of
    // them, there are two steps from one to the other.
    let radii = [0.0, 0.5, 0.9, 0.9996, 1.0, 0.9996, 0.9, 0.5, 0.0];
    let profile: Vec<(f64, f64)> = radii
        .into_iter()
        .enumerate()
        .map(|(i, r)| (r, if i < 4 { r - 1.0 } else { 1.0 - r }))
        .collect();
    let folder = folder(&[("lens.obj", &lathe(&[("glass", &profile)], 24))]);
    let text = "object lens: mesh { file: \"lens.obj\", unit: m, material: dielectric { inside: glass }, place: [scale(1, 1e-3, 1)] }\n";
    world_in(folder.path(), text).unwrap_or_else(|report| panic!("{report}"));
}
