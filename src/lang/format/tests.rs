//! The style, and what it promises: the same tree, every comment, and nothing more to do.

use std::path::Path;

use proptest::prelude::*;

use super::format;
use super::tokens::{self, Kind};
use crate::diag::FileId;
use crate::lang::parse;

const FILE: FileId = FileId(0);

fn formatted(text: &str) -> String {
    format(text, FILE).unwrap_or_else(|told| panic!("{told:#?}\n{text}"))
}

/// The tree without its places.
fn tree(text: &str) -> String {
    let parsed = parse::file(text, FILE);
    assert!(parsed.faults.is_empty(), "{:#?}\n{text}", parsed.faults);
    let shown = format!("{:?}", parsed.tree);
    let mut kept = String::new();
    for piece in shown.split("Span { ") {
        kept.push_str(
            piece.split_once(" }").map_or(piece, |(place, rest)| {
                if place.starts_with("file:") { rest } else { piece }
            }),
        );
    }
    kept
}

fn comments(text: &str) -> Vec<String> {
    let tokens = tokens::read(text);
    tokens.iter().flat_map(|token| &token.comments).map(|c| c.text.to_string()).collect()
}

/// Holds the formatted text to what is promised of it.
fn check(text: &str) -> String {
    let once = formatted(text);
    assert_eq!(tree(&once), tree(text), "the tree of\n{text}\nis not that of\n{once}");
    assert_eq!(comments(&once), comments(text), "{text}\n{once}");
    assert_eq!(formatted(&once), once, "not the same again:\n{text}");
    assert!(once.ends_with('\n') && !once.ends_with("\n\n"), "{once}");
    assert!(once.lines().all(|line| line.trim_end() == line), "{once}");
    assert!(!once.contains("\n\n\n") && !once.contains('\r'), "{once}");
    once
}

/// Every scene of the project and every example of its pages that the grammar takes.
fn texts() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    let mut folders = vec![root.join("scenes"), root.join("tests/suite"), root.join("docs")];
    folders.push(root.join("README.md"));
    while let Some(path) = folders.pop() {
        if path.is_dir() {
            folders.extend(std::fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
            continue;
        }
        let ending = path.extension().and_then(|ending| ending.to_str());
        match ending {
            Some("scn") => all.push(std::fs::read_to_string(&path).unwrap()),
            Some("md") => {
                let page = std::fs::read_to_string(&path).unwrap();
                let blocks =
                    page.split("```scn").skip(1).filter_map(|block| block.split_once('\n'));
                all.extend(blocks.map(|(_, text)| text.split("```").next().unwrap().to_string()));
            }
            _ => {}
        }
    }
    all.retain(|text| parse::file(text, FILE).faults.is_empty());
    assert!(all.len() > 150, "{}", all.len());
    all
}

#[test]
fn what_the_project_ships_keeps_its_tree_and_its_comments() {
    for text in texts() {
        check(&text);
        check(&text.replace('\n', "\r\n"));
        check(text.trim_end());
    }
}

/// Places where a comment may stand: between any two tokens but inside a number with its unit,
/// a power, and the first line.
fn gaps(text: &str) -> Vec<usize> {
    let tokens = tokens::read(text);
    let first_line = text.find("scn").map_or(0, |at| at + text[at..].find('\n').unwrap_or(0));
    let after = |at: usize| match tokens[at].kind {
        Kind::Number => tokens[at + 1].kind != Kind::Word && tokens[at + 1].text != "%",
        Kind::Sign(b'^') => false,
        _ => tokens[at + 1].text != "^" && (at == 0 || tokens[at - 1].text != "^"),
    };
    let places = (0..tokens.len() - 1).filter(|at| after(*at));
    let mut places: Vec<_> = places.map(|at| tokens[at].start + tokens[at].text.len()).collect();
    places.retain(|at| *at >= first_line);
    places.push(0);
    places
}

#[test]
fn a_comment_is_kept_wherever_it_stands() {
    for text in texts() {
        // Each page has its own share of places: all of them take too long.
        let places = gaps(&text);
        for (i, at) in places.iter().enumerate().filter(|(i, _)| (i + text.len()) % 7 == 0) {
            let comment = [" // here\n", "\n// alone\n", "// tight\n\n// and one more\n"][i % 3];
            let changed = format!("{}{comment}{}", &text[..*at], &text[*at..]);
            if parse::file(&changed, FILE).faults.is_empty() {
                check(&changed);
            }
        }
    }
}

#[test]
fn the_style_is_this() {
    let wanted = "\
scn 1 in 2.5 cm // the unit

use \"lib/box.scn\"
let f(a, b) = (a + b) * -2 / 3 m
let g = [1, 2]
film: { size: (8, 8), exposure: 1 ev }
light sky.time: 12:30
light sky: constant { radiance: 9 W/m^2/sr } // trails

// Alone.
setup a: b + c {
    // Inside.
    x: rgb(1, 2, 3) / m with { a: 50 % }

    y: pi * W/m^2
}
render \"a {1+1}\": a {}
render b { without light sky, a.b: 2 m^-2 }
for i in 1 to 9 step 2 { c: m * W/sr }
";
    let written = "scn   1 in 2.5cm // the unit


use \"lib/box.scn\"
let f( a,b )=(a+b)*-2/3m
let g = [1,2,],film:{size:(8,8),exposure:1ev}
light sky . time:12:30
light sky:constant{radiance:9W/m ^ 2/sr}// trails


// Alone.
setup a:b+c{

  // Inside.
  x:rgb(1,2,3)/m with{a:50%}

  y : pi*W / m^2,

}
render \"a {1+1}\":a{ }
render b{without light sky,a.b:2m^ -2}
for i in 1 to 9 step 2{c:m*W/sr,}";
    assert_eq!(check(written), wanted);
}

#[test]
fn what_does_not_fit_is_broken_where_it_opens() {
    let long = "a_rather_long_name_for_something";
    let wanted = format!(
        "\
scn 1 in m
camera: perspective {{
    eye: (0, 2, 7)
    look_at: (0, 1, 0)
    names: [{long}, {long}]
    fov_y: 35 deg
}}
let a = f({long}, {long}) with {{
    b: {long}
    c: {long}
}}
let b = {long} + {long}
    + {long} + {long}
    - {long}
let c = [
    {long},
    {long},
    {long},
    4,
]
let d = [sphere {{
    radius: 1 m
}}]
let e = f(1, sphere {{
    radius: 1 m
}})
let f = (1, 2, 3)
"
    );
    let written = format!(
        "scn 1 in m
camera: perspective {{ eye: (0, 2, 7), look_at: (0, 1, 0), names: [{long}, {long}], fov_y: 35 deg }}
let a = f({long}, {long}) with {{ b: {long}, c: {long} }}
let b = {long} + {long} + {long} + {long} - {long}
let c = [{long}, {long}, {long}, 4]
let d = [sphere {{
    radius: 1 m }}]
let e = f(
    1,
    sphere {{
        radius: 1 m }})
let f = (1,
         2, 3)"
    );
    assert_eq!(check(&written), wanted);
}

#[test]
fn short_elements_share_lines() {
    let numbers: Vec<_> = (0..60).map(|i| format!("0.{i}")).collect();
    let text = format!("scn 1\nlet a = [{}]\n", numbers.join(", "));
    let shown = check(&text);
    assert_eq!(shown.lines().count(), 7, "{shown}");
    assert!(shown.lines().all(|line| line.len() <= 100), "{shown}");
}

#[test]
fn comments_stay_where_they_stand() {
    let wanted = "\
// Before.
scn 1 in m // first

a: b { // opens
    // of c
    c: 1 // after c
    d: // between
        2

    // last
}
e: [ // opens
    1, // one
    // of two
    2,
    // last
]
f: {
    // nothing else
}
// The end.
";
    assert_eq!(check(wanted), wanted);
}

#[test]
fn faults_of_syntax_are_told_and_nothing_is_formatted() {
    for text in
        ["", "a: 1", "scn 1 in m\na: (1", "scn 1 in m\na: 1 b: 2", "scn 2\n", "scn 1\na = 1"]
    {
        assert!(!format(text, FILE).unwrap_err().is_empty(), "{text}");
    }
    // What is wrong by its meaning has a form all the same.
    assert_eq!(formatted("scn 1\nnothing:what{x:1}"), "scn 1\nnothing: what { x: 1 }\n");
}

/// A value of the language, as text.
fn value() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec![
        "1",
        "2.5 m",
        "50%",
        "3 m^2",
        "12:30",
        "a",
        "glass.bk7",
        "\"x {1 + a} // y\"",
        "-y",
        "W/m^2",
        "a_name_that_is_long_enough_to_fill_lines",
        "{}",
        "[]",
        "1_000e-3",
        "- - 2",
        "pi",
    ]);
    leaf.prop_map(str::to_string).prop_recursive(4, 24, 4, |inner| {
        let all = prop::collection::vec(inner.clone(), 1..5);
        let pair = (inner.clone(), inner);
        prop_oneof![
            all.clone().prop_map(|all| format!("[{}]", all.join(","))),
            all.clone().prop_map(|all| format!("f({})", all.join(" , "))),
            all.clone().prop_map(|all| format!("({})", all.join(","))),
            all.clone().prop_map(|all| format!("k{{{}}}", fields(&all, ","))),
            all.clone().prop_map(|all| format!("k {{{}\n}}", fields(&all, "\n"))),
            all.prop_map(|all| format!("({})", all.join("+"))),
            pair.clone().prop_map(|(a, b)| format!("({a}*{b})")),
            pair.clone().prop_map(|(a, b)| format!("({a} / {b}^2)")),
            pair.prop_map(|(a, b)| format!("(a with {{ a: {a} }} with {{\"b\":{b}}})")),
        ]
    })
}

fn fields(values: &[String], separator: &str) -> String {
    let all: Vec<_> = values.iter().enumerate().map(|(i, v)| format!("x{i}: {v}")).collect();
    all.join(separator)
}

/// An item of the language, as text.
fn item() -> impl Strategy<Value = String> {
    let simple = value().prop_flat_map(|v| {
        prop::sample::select(vec![
            format!("a: {v}"),
            format!("object \"b {{1}}\".c.\"d\": {v}"),
            format!("let a = {v}"),
            format!("let f(a,b,) = {v}"),
            "use \"x.scn\"".to_string(),
            "without light sky".to_string(),
        ])
    });
    simple.prop_recursive(2, 12, 4, |inner| {
        (prop::collection::vec(inner, 0..4), prop::sample::select(vec![",", "\n", ",\n\n\n"]))
            .prop_flat_map(|(items, separator)| {
                let body = items.join(separator);
                prop::sample::select(vec![
                    format!("setup s:a+b {{{body}}}"),
                    format!("render \"r\" {{\n{body} }}"),
                    format!("for i in [1,2] {{ {body}}}"),
                    format!("for i in 1 to 3 * 2 step a {{{body}}}"),
                ])
            })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_keeps_its_tree_and_its_comments(
        items in prop::collection::vec(item(), 0..6),
        places in prop::collection::vec((any::<prop::sample::Index>(), 0..5_usize), 0..6),
    ) {
        let mut text = format!("scn 1 in mm\n{}", items.join("\n"));
        for (at, which) in places {
            let gaps = gaps(&text);
            let comment = [" // a\n", "\n// b\n", "//c\n\n\n//d", "\n\n", " // \u{e9} \"{\n"][which];
            let comment = if comment.ends_with('d') { "//c\n\n\n//d\n" } else { comment };
            text.insert_str(gaps[at.index(gaps.len())], comment);
        }
        prop_assume!(parse::file(&text, FILE).faults.is_empty());
        check(&text);
    }

    #[test]
    fn any_bytes_are_formatted_or_refused(text in "(\\PC|\n|\"|//){0,200}") {
        for text in [text.clone(), format!("scn 1 in m\n{text}")] {
            if format(&text, FILE).is_ok() {
                check(&text);
            }
        }
    }
}
