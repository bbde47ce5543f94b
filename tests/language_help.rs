//! What a message tells one to write: the help of faults that many make.

mod common;

use scn::diag::Level;

/// The only error of a text, as told.
fn only(text: &str) -> String {
    let text = format!("scn 1 in m\nintegrator: preview\n{text}\n");
    let (compiled, sources) = common::compile(&text);
    let errors: Vec<_> =
        compiled.diagnostics.iter().filter(|told| told.level == Level::Error).collect();
    let shown: Vec<_> = errors.iter().map(|told| common::show(told, &sources)).collect();
    assert_eq!(errors.len(), 1, "{text}\n{}", shown.join("\n"));
    shown[0].clone()
}

#[test]
fn what_is_offered_can_be_what_was_meant() {
    for (text, offered) in [
        ("material a: diffuse { color: 1 }", "`albedo` and `emission`"),
        ("material a: diffuse {}", "albedo: 0.5"),
        ("let colour = 1\nlet d = coluor * 2", "did you mean `colour`?"),
        ("prject: 1", "`let`"),
        ("}", "remove this `}`"),
        ("for i in [1, 2] { light a: constant { radiance: 1 W/m^2/sr } }", "`\"ball_{i}\"`"),
        ("object a: mesh { file: \"a\", unit: m, place: [scale((1, 2, 1))] }", "scale(1, 2, 1)"),
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
    ] {
        let told = only(text);
        assert!(!told.contains(not), "{text}: {not}\n{told}");
    }
}
