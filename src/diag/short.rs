//! Diagnostics in one line each: for editors and other programs that read lines, for GitHub's
//! annotations, and for a brief word beside other work.

use super::excerpt::harmless_text;
use super::lines::{Lines, Position};
use super::{Diagnostic, Level, Sources, Span};

/// `file:line:column: warning[code]: headline`; without a place, without it.
pub fn lines(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let mut lines = Lines::new(sources);
    let mut text = String::new();
    for diagnostic in diagnostics {
        if let Some((name, start, _)) = place(diagnostic, &mut lines) {
            text.push_str(&format!("{}:{}:{}: ", one_line(name), start.line, start.column));
        }
        let headline = one_line(&diagnostic.headline);
        text.push_str(&format!("{}[{}]: {headline}\n", diagnostic.level, diagnostic.code));
    }
    text
}

/// `::warning file=…,line=…::headline`: commands that GitHub's runners turn into annotations.
pub fn github(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let mut lines = Lines::new(sources);
    let mut text = String::new();
    for diagnostic in diagnostics {
        let mut properties = Vec::new();
        // An argument is no file that could be annotated.
        let file = |span: Span| sources.get(span.file).path.is_some();
        if let Some((name, start, end)) = place(diagnostic, &mut lines)
            && diagnostic.place().is_some_and(file)
        {
            properties.push(format!("file={}", property(name)));
            properties.push(format!("line={},col={}", start.line, start.column));
            properties.push(format!("endLine={}", end.line));
            // Columns of another line than the first mean nothing there.
            if end.line == start.line {
                properties.push(format!("endColumn={}", end.column));
            }
        }
        properties.push(format!("title={}", property(diagnostic.code.name)));
        let words = [Some(&diagnostic.headline), diagnostic.why.as_ref(), diagnostic.help.as_ref()];
        let words: Vec<&str> = words.into_iter().flatten().map(String::as_str).collect();
        let (level, properties) = (diagnostic.level, properties.join(","));
        text.push_str(&format!("::{level} {properties}::{}\n", message(&words.join("\n"))));
    }
    text
}

fn place<'a>(
    diagnostic: &Diagnostic,
    lines: &mut Lines<'a>,
) -> Option<(&'a str, Position, Position)> {
    let span = diagnostic.place()?;
    let (start, end) = lines.positions(span);
    Some((&lines.sources().get(span.file).name, start, end))
}

fn one_line(text: &str) -> String {
    harmless_text(text).replace('\n', " ")
}

/// A message of a command, in GitHub's escapes.
fn message(text: &str) -> String {
    let harmless = harmless_text(text).replace('%', "%25");
    harmless.replace('\r', "%0D").replace('\n', "%0A")
}

/// A property of a command, likewise.
fn property(text: &str) -> String {
    message(text).replace(':', "%3A").replace(',', "%2C")
}

impl std::fmt::Display for Level {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Span};

    fn faults() -> (Vec<Diagnostic>, Sources) {
        let mut sources = Sources::new();
        let file = sources.add("a,b:c.scn", "one\ntwo\n");
        let one = Diagnostic::warning(Code::SYNTAX_UNEXPECTED, "100 %\nlost")
            .label(Span::new(file, 4, 7), "here")
            .help("do\nthis");
        (vec![one, Diagnostic::error(Code::SYNTAX_COMMENT, "\u{1b}[31mred")], sources)
    }

    #[test]
    fn a_fault_is_one_line_with_its_place() {
        let (faults, sources) = faults();
        let told = lines(&faults, &sources);
        let expected = "a,b:c.scn:2:1: warning[syntax/unexpected]: 100 % lost\n\
                        error[syntax/comment]: \u{241b}[31mred\n";
        assert_eq!(told, expected);
    }

    #[test]
    fn arguments_are_annotated_nowhere() {
        let mut sources = Sources::new();
        let set = sources.add_argument("--set", "a=b");
        let fault =
            Diagnostic::error(Code::SYNTAX_UNEXPECTED, "no").label(Span::new(set, 0, 1), "");
        assert_eq!(github(&[fault], &sources), "::error title=syntax/unexpected::no\n");
    }

    #[test]
    fn commands_of_github_escape_what_would_end_them() {
        let (faults, sources) = faults();
        let told = github(&faults, &sources);
        let expected = "::warning file=a%2Cb%3Ac.scn,line=2,col=1,endLine=2,endColumn=4,\
                        title=syntax/unexpected::100 %25%0Alost%0Ado%0Athis\n\
                        ::error title=syntax/comment::\u{241b}[31mred\n";
        assert_eq!(told, expected);
    }
}
