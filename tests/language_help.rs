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
        ("material a: diffuse { tint: 1 }", "`albedo`, `emission` and `emits`"),
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
        (
            "medium oil: homogeneous { ior: 1.5 }\nmedium air: homogeneous { ior: 1 }\n\
             material a: dielectric { inside: water2 }",
            "the media declared: `air` and `oil`",
        ),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, material: diffuse { albedo: 0 }, yields_to: 5 }",
            "the name of an object",
        ),
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
fn what_stands_further_in_is_offered() {
    for (text, offered) in [
        ("material a: dielectric { ior: 1.5 }", "write `inside: homogeneous { ior: 1.5 }`"),
        ("material a: dielectric { inside: glass.bk7 }", "`homogeneous { ior: glass.bk7 }`"),
        ("material a: dielectric { inside: 1.5 }", "write `homogeneous { ior: 1.5 }`"),
        ("material a: dielectric { inside: bk7 }", "mean `homogeneous { ior: glass.bk7 }`"),
        ("material a: conductor { ior: gold }", "did you mean `metal.gold`?"),
        (
            "material a: glass { ior: 1.5 }",
            "did you mean `dielectric`, as in `dielectric { inside: homogeneous { ior: 1.5 } }`",
        ),
        ("material a: metal { ior: metal.gold }", "did you mean `conductor`, as in"),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, material: glass }",
            "`material glass: dielectric { inside: homogeneous { ior: 1.5 } }`",
        ),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, albedo: 0.5 }",
            "write `material: diffuse { albedo: 0.5 }`",
        ),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, material: 0.5 }",
            "write `diffuse { albedo: 0.5 }` or `mirror { reflectance: 0.5 }`",
        ),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, material: gold }",
            "mean `conductor { ior: metal.gold }`",
        ),
        ("object a: sphere { center: (0, 0, 0), size: 2 m, material: mirror }", "`radius: 2 m`"),
        ("render a { integrator: path { specular: 2 } }", "write `splits: { specular: 2 }`"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn words_of_other_programs_are_known() {
    for (text, offered) in [
        ("sensor: perspective {}", "did you mean `camera`?"),
        ("mesh bunny: { unit: m }", "write `object NAME: mesh { … }`"),
        ("object a: rectangle {}", "did you mean `quad`"),
        ("object a: cube {}", "a `quad` for each flat side"),
        ("light a: area {}", "give its material an `emission`"),
        ("light a: infinite {}", "did you mean `constant`"),
        ("material a: lambertian {}", "did you mean `diffuse`"),
        ("material a: Plastic {}", "`mix { … }` joins two of them"),
        ("material a: diffuse { color: 1 }", "write `albedo: 1`"),
        ("material a: dielectric { eta: 1.5 }", "write `inside: homogeneous { ior: 1.5 }`"),
        ("stop: { spp: 16 }", "write `samples: 16`"),
        // More like `inside`, which it is not.
        ("material a: dielectric { index: 1.5 }", "write `inside: homogeneous { ior: 1.5 }`"),
        (
            "object a: sphere { center: (0, 0, 0), radius: 1 m, bsdf: diffuse { albedo: 0 } }",
            "write `material: diffuse { albedo: 0 }`",
        ),
        ("medium a: homogeneous { phase: hg { g: 0.5 } }", "as in `henyey_greenstein { g: 0.5 }`"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn a_medium_of_the_shelf_where_an_index_belongs() {
    for (text, offered) in [
        ("material a: dielectric { ior: matter.water }", "write `inside: matter.water`"),
        ("material a: conductor { ior: matter.water }", "write `medium water: matter.water`"),
        ("medium a: homogeneous { ior: matter.water }", "write `medium water: matter.water`"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn units_that_a_place_can_have_are_offered() {
    let day = |fields| format!("light a: preetham {{ turbidity: 3, latitude: 5 deg, {fields} }}");
    let point = |field| format!("light a: point {{ position: (0, 0, 0), {field} }}");
    for (text, offered) in [
        (day("day: 1, time: 18.5"), "help: write `18.5 h` or `18:30`\n"),
        (day("day: 1, time: 18.30"), "help: write `18.30 h` or `18:30`\n"),
        (day("day: 1, time: 18"), "help: write `18 h` or `18:00`\n"),
        (day("day: 1, time: 12.3456"), "help: write `12.3456 h`\n"),
        (day("day: 1, time: 12:00, zone: 2"), "help: write `2 h` or `2:00`\n"),
        (day("day: 1, time: 12:00, zone: -2"), "help: write `-2 h`\n"),
        (
            "light a: preetham { turbidity: 20, latitude: 5 deg, day: 1, time: 9:00 }".to_string(),
            "write 2 for very clear air",
        ),
        (day("day: 1, time: 12:00, zone: 90 deg"), "did you mean `6 h`?"),
        (day("day: 1, time: 12:00, longitude: 1 h"), "did you mean `15 deg`?"),
        ("stop: { time: 60 }".to_string(), "help: write `60 s`, `60 min` or `60 h`\n"),
        (point("intensity: 60 W"), "write `60 W / (4 * pi * sr)`"),
        (point("intensity: 60 W"), "or `60 W/sr`, if"),
        (point("power: 60 W"), "write `intensity: 60 W / (4 * pi * sr)`"),
        (
            day("day: 1, time: 12:00, sun: disc { half_angle: 1 rad }"),
            "must be at least 0.01 deg and at most 30 deg, and is 1 rad",
        ),
        ("let c = complex(0, 1)\nmaterial a: conductor { ior: c }".to_string(), "the n of `mat"),
    ] {
        let told = only(&text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

/// What a message offers can be written.
#[test]
fn what_is_offered_is_of_the_language() {
    for text in [
        "material a: dielectric { inside: homogeneous { ior: glass.bk7 } }",
        "light a: point { position: (0, 0, 0), intensity: 60 W / (4 * pi * sr) }",
        "light a: preetham { turbidity: 3, latitude: 5 deg, day: 1, time: 18:30, zone: 2:00 }",
        "material glass: dielectric { inside: homogeneous { ior: 1.5 } }",
    ] {
        let text = format!("scn 1 in m\nintegrator: preview\n{text}\n");
        let (compiled, sources) = common::compile(&text);
        let mut told = compiled.diagnostics.iter();
        if let Some(told) = told.find(|told| told.level == Level::Error) {
            panic!("{text}\n{}", common::show(told, &sources));
        }
    }
}

#[test]
fn an_operator_without_a_value_is_told_where_it_stands() {
    for text in [
        "let a = 1 +\nfilm: { size: (8, 8) }",
        "let a = 1 m *\nobject b: sphere { center: (0, 0, 0), radius: a, material: mirror }",
    ] {
        let told = only(text);
        assert!(told.starts_with("a value is missing after this `"), "{text}\n{told}");
        assert!(told.contains("scene.scn:3:"), "{text}\n{told}");
    }
}

#[test]
fn of_an_unknown_edition_nothing_else_is_told() {
    let (compiled, sources) = common::compile("scn 2 in m\nobject a { radius }\nlet x = y\n");
    let told: Vec<_> = compiled.diagnostics.iter().map(|it| common::show(it, &sources)).collect();
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains("reads edition 1 alone"), "{told:?}");
}

#[test]
fn a_chain_of_mixtures_has_a_bound_that_is_told_once() {
    let within = |depth: usize| {
        let mut text = "diffuse { albedo: 0.5 }".to_string();
        (0..depth)
            .for_each(|_| text = format!("mix {{ first: {text}, second: mirror, amount: 1 }}"));
        format!("scn 1 in m\nintegrator: preview\nmaterial a: {text}\n")
    };
    let (compiled, _) = common::compile(&within(40));
    assert!(compiled.diagnostics.iter().all(|told| told.level != Level::Error));
    let chain: String = (1..70)
        .map(|i| {
            let before = i - 1;
            format!("material m{i}: mix {{ first: m{before}, second: mirror, amount: 1 }}\n")
        })
        .collect();
    let told = only(&format!("material m0: mirror\n{chain}"));
    assert!(told.starts_with("more than 64 materials are made of each other in a row"), "{told}");
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

/// A text with the first mend that is offered of it, which leaves nothing wrong.
fn mended(text: &str) -> String {
    let text = format!("scn 1 in m\nintegrator: preview\n{text}\n");
    let (compiled, sources) = common::compile(&text);
    let mut mends = compiled.diagnostics.iter().flat_map(|told| &told.mends);
    let Some(mend) = mends.next() else {
        let told = compiled.diagnostics.iter().map(|told| common::show(told, &sources));
        panic!("no mend of\n{text}\n{}", told.collect::<String>());
    };
    let mut right = text.clone();
    for edit in mend.edits.iter().rev() {
        right.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.text);
    }
    let (compiled, sources) = common::compile(&right);
    if let Some(told) = compiled.diagnostics.iter().find(|told| told.level == Level::Error) {
        panic!("{right}\n{}", common::show(told, &sources));
    }
    right
}

#[test]
fn mends_are_what_was_meant() {
    const BALL: &str = "center: (0, 0, 0), material: diffuse { albedo: 0.5 }";
    let view = |field: &str| {
        format!("camera: perspective {{ eye: (0, 0, 3), look_at: (0, 0, 0), {field} }}")
    };
    let ball = |field: &str| format!("object ball: sphere {{ {BALL}, {field} }}");
    let changed = |item: &str| {
        format!("{}\n{}\nrender a {{ {item} }}", ball("radius: 1 m"), view("fov_y: 40 deg"))
    };
    for (text, right) in [
        (ball("diameter: 2 m"), ", radius: 1 m }"),
        (ball("diameter: 25.5 cm"), ", radius: 12.75 cm }"),
        (ball("diameter: 1 m + 2 m"), ", radius: 0.5 * (1 m + 2 m) }"),
        (view("fov: 30"), ", fov_y: 30 deg }"),
        (view("fov: 0.5 rad"), ", fov_y: 0.5 rad }"),
        ("material a: conductor { eta: 0.2, k: 3.9 }".into(), "{ ior: complex(0.2, 3.9) }"),
        ("material a: conductor { k: 3.9, ior: 0.2 }".into(), "{ ior: complex(0.2, 3.9) }"),
        ("material a: diffuse { albedo: [0.8, 0.4, 0.2] }".into(), "albedo: rgb(0.8, 0.4, 0.2)"),
        ("material a: diffuse { albedo: (0.5, 0.5, 1) }".into(), "albedo: rgb(0.5, 0.5, 1)"),
        (
            "material a: diffuse { albedo: \"wood.png\" }".into(),
            "albedo: image { file: \"wood.png\" }",
        ),
        (ball("radius: 1 m, place: [rotate(45 deg, y)]"), "[rotate(y, 45 deg)]"),
        (changed("camera: { fov_y: 20 deg }"), "{ camera.fov_y: 20 deg }"),
        (changed("object ball: { radius: 2 m }"), "{ object ball.radius: 2 m }"),
        (
            changed("object ball: { radius: 2 m, center: (1, 0, 0) }"),
            "{ object ball.radius: 2 m, object ball.center: (1, 0, 0) }",
        ),
    ] {
        let mended = mended(&text);
        assert!(mended.contains(right), "{right}\n{mended}");
    }
}

#[test]
fn what_measures_something_else_is_told_so() {
    let text = "camera: perspective { eye: (0, 0, 3), look_at: (0, 0, 0), fov_x: 45 deg }";
    let told = only(text);
    assert!(told.contains("another angle") && told.contains("tan(fov_x / 2)"), "{told}");
}

#[test]
fn forms_that_the_grammar_refuses_are_known() {
    for (text, offered) in [
        ("light a: constant { radiance: 1.5 W/m²/sr }", "write `1.5 W/m^2/sr`"),
        ("light a: constant { radiance: 2 W/(m^2 sr) }", "write `2 W/m^2/sr`"),
        ("light a: directional { direction: -y, irradiance: 2 W m^-2 }", "write `2 W/m^2`"),
        ("light a.radiance: 2 W m^-2 sr^-1", "write `2 W/m^2/sr`"),
        ("render a {}\nrender d extends a {}", "write `render d: a { … }`"),
        ("let i = 2\nlet a = 4 ^ i", "write the exponent as a number from -16 to 16"),
    ] {
        let told = only(text);
        assert!(told.contains(offered), "{text}: {offered}\n{told}");
    }
}

#[test]
fn nothing_is_told_that_is_not_so() {
    let told = only("render k { integrator.depth: 3, integrator: direct }");
    assert!(
        told.starts_with("`integrator` is stated whole, and `integrator.depth` beside"),
        "{told}"
    );
    let told = only("let kk = 1\nlet twice(a) = 2 * a\nlet b = nothing_like_it(1)");
    assert!(told.contains("`twice`") && !told.contains("`kk`"), "{told}");
}

/// Fields that must be given are shown with values that can stand as they are.
#[test]
fn examples_are_neither_wrong_nor_doubtful() {
    use scn::scene::schema::Type;
    let mut shown = 0;
    for kind in scn::scene::KINDS {
        let Type::OneOf(variants) = kind.ty else { continue };
        for record in variants.all {
            let name = if kind.named { " shown" } else { "" };
            let item =
                |fields: &str| format!("{}{name}: {} {{ {fields} }}", kind.word, record.word);
            let asked = format!("scn 1 in m\n{}\n", item(""));
            let (compiled, _) = common::compile(&asked);
            let helps =
                compiled.diagnostics.iter().filter(|it| it.code.name == "type/missing-field");
            let help = helps.filter_map(|told| told.help.clone()).next();
            let Some(fields) = help.as_deref().and_then(|help| help.split('`').nth(1)) else {
                continue;
            };
            // Files are the user's.
            if fields.contains('…') {
                continue;
            }
            let mut scene = format!("scn 1 in m\n\n{}\n", item(fields));
            let sky = "light sky: constant { radiance: 1 W/m^2/sr }\n";
            let ball = |material: &str| {
                format!(
                    "object ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: {material} }}\n"
                )
            };
            let clay = "diffuse { albedo: 0.5 }";
            scene += &match kind.word {
                "camera" | "layer" => format!("integrator: path\n{sky}{}", ball(clay)),
                "light" => format!("integrator: path\n{}", ball(clay)),
                "material" => format!("integrator: path\n{sky}{}", ball("shown")),
                "texture" => {
                    format!("integrator: path\n{sky}{}", ball("diffuse { albedo: shown }"))
                }
                _ => format!(
                    "integrator: path\n{sky}camera: perspective {{ eye: (1, 2, 5), look_at: (0, 0, 0), \
                     fov_y: 40 deg }}\n"
                ),
            };
            let mut sources = scn::diag::Sources::new();
            let path = std::path::Path::new("scene.scn");
            let found = scn::cli::check(path, &scene, &[], &mut sources).found;
            let told = found.iter().map(|told| common::show(told, &sources));
            assert!(found.is_empty(), "{scene}\n{}", told.collect::<String>());
            shown += 1;
        }
    }
    assert!(shown >= 15, "{shown}");
}

/// What is told of a field of paths, as it stands alone in `path { … }`.
fn of_path(field: &str) -> String {
    only(&format!("render a {{ integrator: path {{ {field} }} }}"))
}

#[test]
fn a_count_beside_its_bounds_tells_them() {
    for field in ["reuse: -1", "reuse: 2.5"] {
        let told = of_path(field);
        assert!(told.contains("expected a whole number from 1 to 64"), "{field}\n{told}");
    }
    assert!(of_path("reuse: 0").contains("must be at least 1 and at most 64"));
    let told = only("sampler: stratified { grid: 0.5 }");
    assert!(told.contains("expected a whole number from 1 to 1024"), "{told}");
}

#[test]
fn a_number_is_no_switch() {
    for (field, wanted) in [
        ("reuse: on", "`integrator.reuse` is a whole number from 1 to 64, and `on` is none"),
        ("reuse: all", "`integrator.reuse` is a whole number from 1 to 64, and `all` is none"),
        ("depth: off", "is a whole number from 0 to 1000000 or `unlimited`, and `off` is none"),
        ("depth: \"a\"", "expected a whole number from 0 to 1000000 or `unlimited`"),
    ] {
        let told = of_path(field);
        assert!(told.contains(wanted), "{field}\n{told}");
        assert!(!told.contains("let "), "{field}\n{told}");
    }
    let told = only("film: { exposure: off }");
    assert!(told.contains("is an exposure from -100 ev to 100 ev, and `off` is none"), "{told}");
    let told =
        only("object a: disk { center: (0, 0, 0), normal: y, radius: all, material: mirror }");
    assert!(told.contains("is a length of more than 0 m, and `all` is none"), "{told}");
    let told = only("film: { size: (on, 512) }");
    assert!(told.contains("`film.size` is a whole number from 1 to"), "{told}");
}

#[test]
fn what_is_off_or_one_word_is_turned_on_by_that_word() {
    let told = of_path("guide: on");
    assert!(told.contains("did you mean `photons`?"), "{told}");
    // Of several words none is surer than the others.
    let told = only("material a: diffuse { albedo: 0.5, emits: on }");
    assert!(told.contains("its words: `both` and `front`"), "{told}");
}

#[test]
fn the_parts_of_a_mixture_are_known_by_other_names() {
    let text = "scn 1 in m\nintegrator: preview\n\
         material m: mix { a: diffuse { albedo: 0.2 }, b: mirror, part: 0.4 }\n";
    let (compiled, sources) = common::compile(text);
    let told: Vec<_> =
        compiled.diagnostics.iter().map(|told| common::show(told, &sources)).collect();
    let offered = ["first: diffuse { albedo: 0.2 }", "second: mirror", "amount: 0.4"];
    assert_eq!(told.len(), offered.len(), "{}", told.join("\n"));
    for (told, offered) in told.iter().zip(offered) {
        assert!(told.contains(&format!("help: write `{offered}`")), "{told}");
    }
    // Where one is stated already it is not what another word means.
    let told = only("material a: diffuse { a: 0.5, albedo: 0.5 }");
    assert!(!told.contains("first:"), "{told}");
}
