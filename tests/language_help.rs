//! What a message tells one to write: the help of faults that many make.

mod common;

use scn::diag::Level;

/// The only error of a text, as told; all of them, if there are more.
fn only(text: &str) -> String {
    let text = format!("scn 1 in m\nintegrator: preview\n{text}\n");
    let (compiled, sources) = common::compile(&text);
    let errors = compiled.diagnostics.iter().filter(|told| told.level == Level::Error);
    let shown: Vec<_> = errors.map(|told| common::show(told, &sources)).collect();
    match shown.as_slice() {
        [one] => one.clone(),
        _ => panic!("{} errors in\n{text}\n{}", shown.len(), shown.join("\n")),
    }
}

#[test]
fn what_is_offered_can_be_what_was_meant() {
    for (text, offered) in [
        ("material a: diffuse { color: 1 }", "`albedo`, `emission` and `emits`"),
        ("material a: diffuse {}", "albedo: 0.5"),
        ("let colour = 1\nlet d = coluor * 2", "did you mean `colour`?"),
        ("prject: 1", "`let`"),
        ("}", "remove this `}`"),
        ("for i in [1, 2] { light a: constant { radiance: 1 W/m^2/sr } }", "`\"ball_{i}\"`"),
        ("object a: mesh { file: \"a\", unit: m, place: [scale((1, 2, 1))] }", "scale(1, 2, 1)"),
        ("material a: diffuse { albedo: srgb(200, 100, 60) }", "`srgb(0.784, 0.392, 0.235)`?"),
        ("material a: diffuse { albedo: srgb(2.5, 0, 0) }", "or `rgb(…)`"),
        ("material a: diffuse { albedo: 0, emission: 500 nit }", "write `0.732 W/m^2/sr`"),
        ("light a: directional { direction: x, irradiance: 100000 lx }", "write `146 W/m^2`"),
        ("light a: constant { radiance: rgb(1, 2, 3) * nit }", "`rgb(1, 2, 3) / 683 * W/m^2/sr`"),
        ("let l = 500\nlight a: constant { radiance: l * nit }", "`l / 683 * W/m^2/sr`"),
        ("light a: constant { radiance: 500 lx }", "in W/m^2/sr"),
        ("light a: constant { radiance: blackbody(5500 C) * 1 }", "in `K`"),
        ("let t = 80 F", "in `K`"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn forms_of_other_languages_are_known() {
    for (text, offered) in [
        ("camera: perspective { eye: (0, 0, 0), look_at: (0, 0, 1), fov_y: 35° }", "`deg`"),
        (
            "camera: perspective { eye: [0, 2, 7], look_at: (0, 0, 0), fov_y: 35 deg }",
            "round brackets: `(0, 2, 7)`",
        ),
        (
            "camera: perspective { eye: (0, 2, 7), look_at: (0, 0, 0), fov_y: 35 rad }",
            "did you mean `35 deg`?",
        ),
        (
            "camera: perspective { eye: (0, 2, 7), look_at: (0, 0, 0), fov_y: 35 rad }",
            "less than 180 deg, and is 35 rad",
        ),
        ("material a: diffuse { albedo: 0.8 0.4 0.2 }", "write `rgb(0.8, 0.4, 0.2)`"),
        ("material a.albedo: 0.8 0.4 0.2", "write `rgb(0.8, 0.4, 0.2)`"),
        ("light a: directional { direction: x, irradiance: blackbody(5772 K) }", "`* 6.8e-5 sr`"),
        ("film: { size: 512 x 512 }", "write `(512, 512)`"),
        ("film.size: 512 x 384", "write `(512, 384)`"),
        ("material a: diffuse { albedo: #cc6644 }", "srgb(0.800, 0.400, 0.267)"),
        ("light a: directional { direction: (0 2 7), irradiance: 1 W/m^2 }", "`(0, 2, 7)`"),
        ("let a = 1..3", "write `1 to 3`"),
        ("for i in 1..3 { }", "write `1 to 3`"),
        ("object a: sphere { center: (0, 0, 0), radius: 1 m, material clay }", "`material: clay`"),
        ("light a: constant { radiance: rgb(1, 2, 3) W/m^2/sr }", "`… * W/m^2/sr`"),
        ("light a.radiance: rgb(1, 2, 3) W/m^2/sr", "`… * W/m^2/sr`"),
        ("object a: sphere { center: (0, 0, 0), radius: 1,5 m }", "write `1.5`"),
        ("film.exposure: 1,5 ev", "write `1.5`"),
        ("render a: { film.exposure: 1 ev }", "remove `:`"),
        ("object my ball: sphere { radius: 1 m }", "`object \"my ball\": …`"),
        ("object my-ball: sphere { radius: 1 m }", "`object \"my-ball\": …`"),
        ("render my-ball { film.exposure: 1 ev }", "`render \"my-ball\" { … }`"),
        ("setup my-ball { film.exposure: 1 ev }", "`setup my_ball { … }`"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn what_is_too_far_is_not_offered() {
    for (text, not) in [
        ("let c = red * 1", "rad"),
        ("let c = 2 * nosuch", "`h`"),
        ("render a: fine {}", "mean `a`"),
        ("render a {}\nrender a {}", "some systems"),
    ] {
        let told = only(text);
        assert!(!told.contains(not), "{text}: {not}\n{told}");
    }
}
