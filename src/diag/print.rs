//! Diagnostics on a terminal, by miette. The only file that knows miette.
//!
//! miette draws the user's lines and the labels under them. It panics on labels far along a line
//! and obeys control characters, so it is given an [`Excerpt`] in place of the text.

use std::fmt;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents,
    SourceCode, SourceSpan, SpanContents, ThemeCharacters, ThemeStyles,
};

use super::excerpt::{Excerpt, harmless_line, harmless_text};
use super::lines::Lines;
use super::{Diagnostic, Level, Sources, order};

/// More faults than this are counted, not shown.
const MAX_SHOWN: usize = 50;
/// Columns that line numbers and margins need beside the user's text.
const MARGIN: usize = 10;
/// Columns before the further lines of a headline.
const CONTINUED: usize = 4;
/// A label has at least so many columns for its words, however far right it stands.
const LABEL_WIDTH: usize = 36;

/// Units that stand after numbers in our texts.
const UNITS: [&str; 22] = [
    "%", "GB", "K", "MB", "W", "bytes", "cm", "deg", "h", "kB", "km", "lm", "m", "min", "mm", "ms",
    "nm", "rad", "s", "sr", "um", "us",
];

/// How reports look on the stream they go to.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Whether to colour.
    pub colour: bool,
    /// Whether lines may be drawn with characters beyond ASCII.
    pub unicode: bool,
    /// Columns.
    pub width: usize,
}

impl Look {
    /// For a file or a pipe.
    pub const PLAIN: Self = Self { colour: false, unicode: true, width: 100 };
}

/// The report of all `diagnostics`, in the order given, with a closing line that counts them;
/// empty if there are none. `subject` is what was looked at, such as the scene file's name.
pub fn report(diagnostics: &[Diagnostic], sources: &Sources, subject: &str, look: Look) -> String {
    if diagnostics.is_empty() {
        return String::new();
    }
    let mut lines = Lines::new(sources);
    let mut text = String::new();
    for diagnostic in diagnostics.iter().take(MAX_SHOWN) {
        text.push_str(&one(diagnostic, &mut lines, look));
        text.push('\n');
    }
    if diagnostics.len() > MAX_SHOWN {
        text.push_str(&format!("… and {} more\n", diagnostics.len() - MAX_SHOWN));
    }
    let (errors, warnings) = order::count(diagnostics);
    let tally = order::tally(errors, warnings);
    let level = if errors > 0 { Level::Error } else { Level::Warning };
    text.push_str(&format!("{} in {}\n", bold(&tally, level, look), harmless_line(subject)));
    text
}

fn one(diagnostic: &Diagnostic, lines: &mut Lines<'_>, look: Look) -> String {
    let width = look.width.max(LABEL_WIDTH + MARGIN);
    let mut excerpt = Excerpt::new(diagnostic, lines, width - MARGIN);
    for label in &mut excerpt.labels {
        let room = (width - MARGIN).saturating_sub(label.position.column).max(LABEL_WIDTH);
        label.text = wrapped(&label.text, room).join("\n");
    }
    // Broken here: miette would break inside of a unit. Its first line begins with the code.
    let mark = format!("  {}[{}]: ", diagnostic.level, diagnostic.code).chars().count();
    let headline = harmless_text(&diagnostic.headline);
    let headline = wrapped_after(&headline, width.saturating_sub(mark), width - CONTINUED);
    let report = Report { level: diagnostic.level, headline: headline.join("\n"), excerpt };
    let handler = GraphicalReportHandler::new_themed(theme(diagnostic, look))
        .with_width(width)
        .with_context_lines(1)
        .with_wrap_lines(false)
        .with_links(false)
        .without_syntax_highlighting()
        .without_cause_chain();
    let mut text = String::new();
    if handler.render_report(&mut text, &report).is_err() {
        // Nothing drawn is lost but the drawing: the words remain.
        text = format!("{}\n", report.headline);
    }
    let mut text: String =
        text.trim_start().lines().map(|line| format!("{}\n", line.trim_end())).collect();
    let notes = [("why", &diagnostic.why), ("help", &diagnostic.help)];
    for (word, note) in notes.iter().filter_map(|(word, note)| Some((word, note.as_ref()?))) {
        let rest = width.saturating_sub(MARGIN);
        for (i, line) in wrapped(&harmless_text(note), rest).iter().enumerate() {
            let margin = if i == 0 { format!("{word}:") } else { String::new() };
            let margin = format!("  {margin:<6}");
            let margin = if look.colour && i == 0 { cyan(&margin) } else { margin };
            text.push_str(format!("{margin}{line}").trim_end());
            text.push('\n');
        }
    }
    text
}

/// miette's theme; the mark before the headline is `error[code]:`.
fn theme(diagnostic: &Diagnostic, look: Look) -> GraphicalTheme {
    let mut characters =
        if look.unicode { ThemeCharacters::unicode() } else { ThemeCharacters::ascii() };
    characters.error = format!("error[{}]:", diagnostic.code);
    characters.warning = format!("warning[{}]:", diagnostic.code);
    let styles = if look.colour { ThemeStyles::ansi() } else { ThemeStyles::none() };
    GraphicalTheme { characters, styles }
}

fn cyan(text: &str) -> String {
    format!("\x1b[36m{text}\x1b[0m")
}

fn bold(text: &str, level: Level, look: Look) -> String {
    let colour = match level {
        Level::Error => 31,
        Level::Warning => 33,
    };
    if look.colour { format!("\x1b[1;{colour}m{text}\x1b[0m") } else { text.to_string() }
}

/// Lines of at most `width` characters, broken between words, but not between a number and its unit.
/// Lines that are indented, such as examples, stay as they are.
pub fn wrapped(text: &str, width: usize) -> Vec<String> {
    wrapped_after(text, width, width)
}

/// The same with a first line of at most `first` characters.
fn wrapped_after(text: &str, first: usize, width: usize) -> Vec<String> {
    let mut all = Vec::new();
    for line in text.lines() {
        if line.starts_with(' ') {
            all.push(line.to_string());
            continue;
        }
        let mut current = String::new();
        let mut length = 0;
        for word in unbroken(line) {
            let more = word.chars().count();
            let width = if all.is_empty() { first } else { width };
            if length > 0 && length + 1 + more > width {
                all.push(std::mem::take(&mut current));
                length = 0;
            }
            if length > 0 {
                current.push(' ');
                length += 1;
            }
            current.push_str(&word);
            length += more;
        }
        all.push(current);
    }
    all
}

/// The words of a line, each number with its unit.
fn unbroken(line: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match all.last_mut() {
            Some(last) if ends_in_number(last) && is_unit(word) => {
                last.push(' ');
                last.push_str(word);
            }
            _ => all.push(word.to_string()),
        }
    }
    all
}

/// Whether its last word is a number, or the unit of one.
fn ends_in_number(text: &str) -> bool {
    let last = text.rsplit(' ').next().unwrap_or(text);
    last.ends_with(|c: char| c.is_ascii_digit()) || text.contains(' ') && UNITS.contains(&last)
}

/// Whether a word may be a unit: one of those of our texts, or a product or a quotient of some.
fn is_unit(word: &str) -> bool {
    let bare = word.trim_end_matches(['.', ',', ';', ':', ')', '`', '?']);
    UNITS.contains(&bare)
        || bare.starts_with(|c: char| c.is_ascii_alphabetic()) && bare.contains(['/', '^'])
}

/// A diagnostic as miette wants it.
#[derive(Debug)]
struct Report {
    level: Level,
    headline: String,
    excerpt: Excerpt,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.headline)
    }
}

impl std::error::Error for Report {}

impl miette::Diagnostic for Report {
    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.level {
            Level::Error => miette::Severity::Error,
            Level::Warning => miette::Severity::Warning,
        })
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        (!self.excerpt.labels.is_empty()).then_some(&self.excerpt as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.excerpt.labels.iter().enumerate().map(|(i, label)| {
            let span = SourceSpan::from(label.start..label.end);
            let text = Some(label.text.clone()).filter(|text| !text.is_empty());
            if i == 0 {
                LabeledSpan::new_primary_with_span(text, span)
            } else {
                LabeledSpan::new_with_span(text, span)
            }
        })))
    }
}

impl SourceCode for Excerpt {
    /// With context, the whole segment: it was cut to what is to be seen. A span over two
    /// segments is refused, which keeps miette from drawing them as one.
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        _after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let end = span.offset() + span.len();
        let segment = self
            .segments
            .iter()
            .find(|segment| segment.start <= span.offset() && end <= segment.end)
            .ok_or(MietteError::OutOfBounds)?;
        let whole = || (segment.start, segment.end, segment.first_line - 1, 0, segment.lines);
        let label = self.labels.iter().find(|label| label.start == span.offset());
        let (start, end, line, column, lines) = match label {
            // Asked for the place the heading names.
            Some(label) if before == 0 => {
                (label.start, end, label.position.line - 1, label.position.column - 1, 1)
            }
            _ => whole(),
        };
        Ok(Box::new(MietteSpanContents::new_named(
            segment.name.clone(),
            &self.text.as_bytes()[start..end],
            SourceSpan::from(start..end),
            line,
            column,
            lines,
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Span};
    use proptest::prelude::*;

    #[test]
    fn a_report_shows_every_place_on_the_users_own_lines() {
        let mut sources = Sources::new();
        let text = "scn 1 in m\n\nobject box: mesh {\n    file: \"box.obj\"\n}\n";
        let at = text.find("\"box").unwrap();
        let scene = sources.add("scenes/box.scn", text);
        let mesh = sources.add_excerpt("models/box.obj", "f 1 2 3\nusemtl whit\nf 4 5 6", 1041);
        let diagnostic = Diagnostic::error(
            Code::SYNTAX_UNEXPECTED,
            "`models/box.obj` uses a material `whit` that no .mtl file of it has",
        )
        .label(Span::new(mesh, 15, 19), "there is no material of this name")
        .label(Span::new(scene, at, at + 9), "the mesh is asked for here")
        .why("Its faces have no colour then.")
        .help("write the name as the .mtl has it:\n    usemtl white");
        let warning = Diagnostic::warning(Code::SYNTAX_UNEXPECTED, "nothing to see");
        let text = report(&[diagnostic, warning], &sources, "scenes/box.scn", Look::PLAIN);
        let expected = [
            "error[syntax/unexpected]: `models/box.obj` uses a material `whit` that no .mtl file of it has",
            "      ╭─[models/box.obj:1042:8]",
            " 1041 │ f 1 2 3",
            " 1042 │ usemtl whit",
            "      ·        ──┬─",
            "      ·          ╰── there is no material of this name",
            " 1043 │ f 4 5 6",
            "      ╰────",
            "   ╭─[scenes/box.scn:4:11]",
            " 3 │ object box: mesh {",
            " 4 │     file: \"box.obj\"",
            "   ·           ────┬────",
            "   ·               ╰── the mesh is asked for here",
            " 5 │ }",
            "   ╰────",
            "  why:  Its faces have no colour then.",
            "  help: write the name as the .mtl has it:",
            "            usemtl white",
            "",
            "warning[syntax/unexpected]: nothing to see",
            "",
            "1 error, 1 warning in scenes/box.scn",
        ];
        assert_eq!(text.lines().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn no_line_ends_between_a_number_and_its_unit() {
        let text = "the film takes 342 kB (about 3 sr W/m^2), of 5 spheres";
        for width in 8..60 {
            for line in wrapped(text, width) {
                let broken = ["kB", "sr", "W"].iter().any(|unit| line.starts_with(unit));
                assert!(!broken, "{width}: {line}");
            }
        }
        assert_eq!(wrapped(text, 18)[..2], ["the film takes", "342 kB (about"]);
        let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "long ".repeat(13) + "1 W/m^2/sr");
        for width in 60..110 {
            let told = report(
                std::slice::from_ref(&fault),
                &Sources::new(),
                "a.scn",
                Look { width, ..Look::PLAIN },
            );
            assert!(told.contains("1 W/m^2/sr"), "{width}:\n{told}");
        }
    }

    #[test]
    fn colour_is_there_when_asked_for_and_only_then() {
        let fault = [Diagnostic::error(Code::SYNTAX_UNEXPECTED, "x").why("y")];
        let print = |look| report(&fault, &Sources::new(), "a.scn", look);
        assert!(!print(Look { unicode: false, ..Look::PLAIN }).contains('\x1b'));
        assert!(print(Look { colour: true, unicode: false, ..Look::PLAIN }).contains('\x1b'));
    }

    #[test]
    fn long_words_and_labels_keep_to_the_width() {
        let mut sources = Sources::new();
        let text = format!("{}here\n", "blank ".repeat(200_000));
        let file = sources.add("long.scn", text);
        let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "word ".repeat(100))
            .label(Span::new(file, 1_200_000, 1_200_004), "label ".repeat(40))
            .help("help ".repeat(100));
        let look = Look { width: 70, ..Look::PLAIN };
        for line in report(&[fault], &sources, "long.scn", look).lines() {
            // A label far right takes what room its words need.
            assert!(line.chars().count() <= 70 + LABEL_WIDTH, "{line}");
        }
    }

    proptest! {
        #[test]
        fn no_text_and_no_label_breaks_the_printer(
            text in "(\\PC|[\\x00-\\x20]|\n|\r|\t|\u{202e}){0,200}",
            labels in prop::collection::vec((0u32..250, 0u32..250, "\\PC{0,60}|\x1b\n"), 0..5),
            width in 0usize..140,
            first_line in 1usize..1_000_000,
        ) {
            let mut sources = Sources::new();
            sources.add_excerpt("a\u{7}\n.scn", text.clone(), first_line);
            sources.add("b.scn", text);
            let mut fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "fault");
            for (i, (start, end, words)) in labels.into_iter().enumerate() {
                let span = Span { file: crate::diag::FileId(i as u32 % 2), start, end };
                fault = fault.label(span, words);
            }
            let text = report(&[fault], &sources, "a.scn", Look { width, ..Look::PLAIN });
            let harmful = |c: char| c.is_control() && c != '\n';
            prop_assert!(!text.contains(harmful), "{text:?}");
        }
    }
}
