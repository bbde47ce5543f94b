//! What comments allow, and what they do not.

use super::*;

const WHOLE: Seen = Seen { whole: true, renders: true };

/// The codes told of a text in which `unused-let` is found at each `§`, by their lines.
fn told(text: &str, seen: Seen) -> Vec<(usize, &'static str)> {
    let mut sources = Sources::new();
    let plain = text.replace('§', "");
    let file = sources.add("a.scn", plain.as_str());
    let mut found = Vec::new();
    for (i, (at, _)) in text.match_indices('§').enumerate() {
        let at = at - i * '§'.len_utf8();
        let finding = Diagnostic::warning(Code::LINT_UNUSED_LET, "x");
        found.push(finding.label(Span::new(file, at, at + 1), ""));
    }
    let outline = Outline { files: vec![file], ..Outline::default() };
    let kept = allowed(found, &outline, &sources, seen);
    let line = |it: &Diagnostic| it.place().map_or(0, |span| sources.line_column(span).0);
    let mut told: Vec<_> = kept.iter().map(|it| (line(it), it.code.name)).collect();
    told.sort();
    told
}

const FOUND: &str = "lint/unused-let";
const UNUSED: &str = "lint/allow-unused";

#[test]
fn a_comment_speaks_of_its_line_or_of_the_next() {
    let allow = "// lint: allow(unused-let) because \"so\"";
    assert_eq!(told(&format!("§a {allow}\n§b\n"), WHOLE), [(2, FOUND)]);
    assert_eq!(told(&format!("§a\n  {allow}\n§b\n§c"), WHOLE), [(1, FOUND), (4, FOUND)]);
    assert_eq!(told(&format!("{allow}\n// more words\n§b\n"), WHOLE), []);
    assert_eq!(told(&format!("{allow}\n\n§b\n"), WHOLE), [(1, UNUSED), (3, FOUND)]);
    assert_eq!(told(&format!("\"// no {allow}\" §b\n"), WHOLE), [(1, FOUND)]);
    assert_eq!(told(allow, WHOLE), [(1, UNUSED)]);
}

#[test]
fn where_an_item_begins_it_speaks_of_all_of_it() {
    let allow = "// lint: allow(lint/unused-let) because \"so\"";
    let item = "setup a { // }\n  §b: \"}\"\n  // }\n  c: [\n§d]\n}\n§e\n";
    assert_eq!(told(&format!("{allow}\n{item}"), WHOLE), [(8, FOUND)]);
    let ended = item.replace("// }\n  §b", &format!("{allow}\n  §b"));
    assert_eq!(told(&ended, WHOLE), [(7, FOUND)]);
    // The end of an item is a line like any other.
    assert_eq!(told(&format!("a {{\n§b\n}} {allow}\n§c"), WHOLE).len(), 3);
}

#[test]
fn comments_within_and_beside_each_other_are_told_apart() {
    let allow = "// lint: allow(unused-let) because \"so\"";
    // The outer and the inner one allow the same; the one between allows nothing.
    let text = format!("{allow}\na {{\n b: 1 {allow}\n c: [ {allow}\n §d ]\n}}\n§e\n");
    assert_eq!(told(&text, WHOLE), [(3, UNUSED), (7, FOUND)]);
    // Several speak of one item, which the last line ends without a newline.
    let text = format!("{allow}\n{allow}\na: [ {allow}\n§b ]");
    assert_eq!(told(&text, WHOLE), []);
    // More closed than opened.
    let text = format!("a }} {allow}\n}} ] {allow}\nb: [ {allow}\n§c }}\n§d");
    assert_eq!(told(&text, WHOLE), [(1, UNUSED), (2, UNUSED), (5, FOUND)]);
}

#[test]
fn what_is_unused_is_told_where_it_can_be_known() {
    let text = "a // lint: allow(unused-let, mesh/not-rendered) because \"so\"\n";
    assert_eq!(told(text, WHOLE).len(), 2);
    // A file without renders says nothing of meshes.
    assert_eq!(told(text, Seen { whole: true, renders: false }).len(), 1);
    assert_eq!(told(text, Seen { whole: false, renders: true }), []);
}

#[test]
fn comments_of_another_form_are_told() {
    for rest in [
        " allow",
        " allow()",
        " allow(unused-let,)",
        " deny(unused-let)",
        " allow(unused-let) since \"so\"",
        " allow(unused-let) because so",
        " allow(unused-let) because \"so",
        "",
    ] {
        let told = told(&format!("§a // lint:{rest}\n"), WHOLE);
        assert_eq!(told, [(1, "lint/allow-form"), (1, FOUND)], "{rest}");
    }
    let empty = "§a // lint: allow(unused-let) because \" \"\n";
    assert_eq!(told(empty, WHOLE), [(1, "lint/allow-without-reason")]);
    assert_eq!(
        told("a // lint: allow(unused-lett) because \"so\"", WHOLE),
        [(1, "lint/allow-unknown")]
    );
}

#[test]
fn an_unused_name_is_taken_away_with_its_comma_or_its_comment() {
    let mended = |text: &str| {
        let mut sources = Sources::new();
        let file = sources.add("a.scn", text);
        let here =
            Diagnostic::warning(Code::MESH_NOT_RENDERED, "").label(Span::new(file, 0, 1), "");
        let outline = Outline { files: vec![file], ..Outline::default() };
        let kept = allowed(vec![here], &outline, &sources, WHOLE);
        crate::lint::fixed(text, file, &kept).unwrap().text
    };
    let because = "because \"so\"";
    let both = format!("a // lint: allow(unused-let, mesh/not-rendered) {because}\nb\n");
    assert_eq!(mended(&both), format!("a // lint: allow(mesh/not-rendered) {because}\nb\n"));
    let one = format!("a  // lint: allow(unused-let) {because} \nb\n");
    assert_eq!(mended(&one), "a \nb\n");
    assert_eq!(mended(&format!("a\n  // lint: allow(unused-let) {because}\nb\n")), "a\nb\n");
}

#[test]
fn errors_are_never_allowed() {
    let mut sources = Sources::new();
    let file = sources.add("a.scn", "a // lint: allow(mesh/no-faces) because \"so\"");
    let fault = Diagnostic::error(Code::MESH_NO_FACES, "").label(Span::new(file, 0, 1), "");
    let outline = Outline { files: vec![file], ..Outline::default() };
    let seen = Seen { whole: false, renders: true };
    assert_eq!(allowed(vec![fault.clone()], &outline, &sources, seen), [fault]);
}
