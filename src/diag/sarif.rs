//! Diagnostics in SARIF 2.1.0, the form in which code hosts and editors take the findings of
//! tools. Columns count characters (`unicodeCodePoints`).

use std::path::Path;

use serde_json::{Value, json};

use super::lines::Lines;
use super::{Code, Diagnostic, Mend, Sources, Span};

/// A log of one run with all `diagnostics`, by the tool `name` in its `version`.
pub fn report(
    diagnostics: &[Diagnostic],
    sources: &Sources,
    (name, version): (&str, &str),
) -> Value {
    let mut lines = Lines::new(sources);
    let mut rules: Vec<Code> = diagnostics.iter().map(|diagnostic| diagnostic.code).collect();
    rules.sort_by_key(|code| code.name);
    rules.dedup();
    let results: Vec<Value> =
        diagnostics.iter().map(|diagnostic| result(diagnostic, &rules, &mut lines)).collect();
    json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": name,
                "version": version,
                "rules": rules.iter().map(rule).collect::<Vec<_>>(),
            } },
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    })
}

fn rule(code: &Code) -> Value {
    json!({
        "id": code.name,
        "shortDescription": { "text": code.title() },
        "help": { "text": format!("scn explain {}", code.name), "markdown": code.page },
    })
}

fn result(diagnostic: &Diagnostic, rules: &[Code], lines: &mut Lines<'_>) -> Value {
    let words = [Some(&diagnostic.headline), diagnostic.why.as_ref(), diagnostic.help.as_ref()];
    let words: Vec<&str> = words.into_iter().flatten().map(String::as_str).collect();
    let mut result = json!({
        "ruleId": diagnostic.code.name,
        "ruleIndex": rules.iter().position(|code| *code == diagnostic.code),
        "level": diagnostic.level.to_string(),
        "message": { "text": words.join("\n") },
    });
    if let [first, others @ ..] = diagnostic.labels.as_slice() {
        result["locations"] = json!([location(first.span, &first.text, lines)]);
        if !others.is_empty() {
            let others = others.iter().map(|label| location(label.span, &label.text, lines));
            result["relatedLocations"] = others.collect();
        }
    }
    // What is no file cannot be changed.
    let of_files = |mend: &&Mend| {
        mend.edits.iter().all(|edit| lines.sources().get(edit.span.file).path.is_some())
    };
    let mends: Vec<&Mend> = diagnostic.mends.iter().filter(of_files).collect();
    if !mends.is_empty() {
        result["fixes"] = mends
            .iter()
            .map(|mend| {
                let changes = mend.edits.iter().map(|edit| {
                    json!({
                        "artifactLocation": artifact(edit.span, lines),
                        "replacements": [{
                            "deletedRegion": region(edit.span, lines),
                            "insertedContent": { "text": edit.text },
                        }],
                    })
                });
                let changes: Vec<Value> = changes.collect();
                json!({ "description": { "text": mend.title }, "artifactChanges": changes })
            })
            .collect();
    }
    result
}

fn location(span: Span, text: &str, lines: &mut Lines<'_>) -> Value {
    let source = lines.sources().get(span.file);
    let mut location = match source.path {
        Some(_) => json!({ "physicalLocation": {
            "artifactLocation": artifact(span, lines),
            "region": region(span, lines),
        } }),
        None => json!({ "logicalLocations": [{
            "name": &*source.name,
            "fullyQualifiedName": format!("{} {}", source.name, source.text),
        }] }),
    };
    if !text.is_empty() {
        location["message"] = json!({ "text": text });
    }
    location
}

fn artifact(span: Span, lines: &Lines<'_>) -> Value {
    let source = lines.sources().get(span.file);
    json!({ "uri": uri(source.path.as_deref().unwrap_or(Path::new(&*source.name))) })
}

fn region(span: Span, lines: &mut Lines<'_>) -> Value {
    let (start, end) = lines.positions(span);
    json!({
        "startLine": start.line,
        "startColumn": start.column,
        "endLine": end.line,
        "endColumn": end.column,
    })
}

/// A path as a reference of RFC 3986: slashes between its parts, all else that has a meaning there
/// in percent escapes.
fn uri(path: &Path) -> String {
    let mut uri = String::new();
    for &byte in path.as_os_str().as_encoded_bytes() {
        match byte {
            b'\\' if cfg!(windows) => uri.push('/'),
            b'/' | b'-' | b'.' | b'_' | b'~' => uri.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => uri.push(char::from(byte)),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_references() {
        assert_eq!(uri(Path::new("../scenes/a.scn")), "../scenes/a.scn");
        assert_eq!(uri(Path::new("a b:c%\u{e9}.scn")), "a%20b%3Ac%25%C3%A9.scn");
    }

    #[cfg(unix)]
    #[test]
    fn names_that_are_no_text_keep_their_bytes() {
        use std::os::unix::ffi::OsStrExt;
        let path = Path::new(std::ffi::OsStr::from_bytes(b"a\xff.scn"));
        assert_eq!(uri(path), "a%FF.scn");
        let mut sources = Sources::new();
        let file = sources.add_file(path, "x");
        let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "").label(Span::new(file, 0, 1), "");
        let log = report(&[fault], &sources, ("scn", "0"));
        let place = &log["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
        assert_eq!(place["artifactLocation"]["uri"], "a%FF.scn");
    }

    #[test]
    fn arguments_are_no_files() {
        let mut sources = Sources::new();
        let set = sources.add_argument("--set", "a=b");
        let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "wrong")
            .label(Span::new(set, 0, 1), "here")
            .mend("write `c`", Span::new(set, 0, 1), "c");
        let result = &report(&[fault], &sources, ("scn", "0"))["runs"][0]["results"][0];
        let place = &result["locations"][0];
        assert_eq!(place["logicalLocations"][0]["fullyQualifiedName"], "--set a=b");
        assert_eq!((place.get("physicalLocation"), result.get("fixes")), (None, None));
    }

    #[test]
    fn places_mends_and_rules_are_told() {
        let mut sources = Sources::new();
        let file = sources.add("a.scn", "\u{e9}x = 1\n");
        let fault = Diagnostic::warning(Code::SYNTAX_COLON_OR_EQUALS, "wrong")
            .label(Span::new(file, 2, 3), "here")
            .label(Span::new(file, 4, 5), "and there")
            .mend("write `:`", Span::new(file, 4, 5), ":");
        let bare = Diagnostic::error(Code::FILE_UNREADABLE, "nowhere").why("Why.");
        let log = report(&[fault, bare], &sources, ("scn", "0"));
        let run = &log["runs"][0];
        let first = &run["results"][0];
        assert_eq!(run["tool"]["driver"]["rules"][0]["id"], "file/unreadable");
        assert_eq!((&first["ruleIndex"], &first["level"]), (&json!(1), &json!("warning")));
        let region = &first["locations"][0]["physicalLocation"]["region"];
        assert_eq!((&region["startColumn"], &region["endColumn"]), (&json!(2), &json!(3)));
        assert_eq!(first["relatedLocations"][0]["message"]["text"], "and there");
        let change = &first["fixes"][0]["artifactChanges"][0];
        assert_eq!(change["replacements"][0]["insertedContent"]["text"], ":");
        assert_eq!(run["results"][1]["message"]["text"], "nowhere\nWhy.");
        assert_eq!(run["results"][1].get("locations"), None);
    }
}
