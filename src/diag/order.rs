//! Faults in the order a person reads them, each once.

use std::collections::{HashMap, HashSet};

use super::lines::{Lines, Position};
use super::{Diagnostic, Level, Sources};

/// Sorted by place: files in the order they were read, then lines; faults without a place first.
/// What two renders find in the same file is told once.
pub fn in_order(diagnostics: Vec<Diagnostic>, sources: &Sources) -> Vec<Diagnostic> {
    let mut lines = Lines::new(sources);
    let mut files = HashMap::new();
    let mut seen = HashSet::new();
    let mut all: Vec<((usize, Position), Diagnostic)> = Vec::new();
    for diagnostic in diagnostics {
        let key = match diagnostic.place() {
            None => (0, Position { line: 0, column: 0 }),
            Some(span) => {
                // An excerpt is a text of its own; its name says which file it is from.
                let name = sources.get(span.file).name.clone();
                let next = files.len() + 1;
                (*files.entry(name).or_insert(next), lines.positions(span).0)
            }
        };
        if seen.insert((key, diagnostic.code, diagnostic.headline.clone())) {
            all.push((key, diagnostic));
        }
    }
    // Files were numbered as faults met them; what counts is when they were read.
    let mut ranks: Vec<_> = files.into_iter().collect();
    let read = |name: &str| sources.iter().position(|source| &*source.name == name);
    ranks.sort_by_key(|(name, _)| read(name));
    let rank: HashMap<usize, usize> =
        ranks.iter().enumerate().map(|(rank, (_, number))| (*number, rank + 1)).collect();
    all.sort_by_key(|((file, position), _)| (rank.get(file).copied().unwrap_or(0), *position));
    all.into_iter().map(|(_, diagnostic)| diagnostic).collect()
}

/// How many errors and how many warnings there are.
pub fn count(diagnostics: &[Diagnostic]) -> (usize, usize) {
    let errors = diagnostics.iter().filter(|d| d.level == Level::Error).count();
    (errors, diagnostics.len() - errors)
}

/// "2 errors, 1 warning"; empty if there is neither.
pub fn tally(errors: usize, warnings: usize) -> String {
    let part = |n: usize, word: &str| match n {
        0 => None,
        1 => Some(format!("1 {word}")),
        n => Some(format!("{n} {word}s")),
    };
    let parts = [part(errors, "error"), part(warnings, "warning")];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Span};

    #[test]
    fn faults_stand_in_the_order_of_their_places_and_once() {
        let mut sources = Sources::new();
        let scene = sources.add("a.scn", "one\ntwo\n");
        let once = sources.add_excerpt("b.obj", "f 1 2\n", 7);
        let again = sources.add_excerpt("b.obj", "v 0 0\nf 1 2\n", 6);
        let fault = |file, start, text: &str| {
            Diagnostic::error(Code::SYNTAX_UNEXPECTED, text)
                .label(Span::new(file, start, start + 1), "")
        };
        let all = vec![
            fault(once, 0, "third"),
            fault(scene, 4, "second"),
            fault(scene, 4, "second, another"),
            fault(again, 6, "third"),
            fault(scene, 0, "first"),
            Diagnostic::warning(Code::SYNTAX_UNEXPECTED, "nowhere"),
        ];
        let told: Vec<_> =
            in_order(all, &sources).into_iter().map(|diagnostic| diagnostic.headline).collect();
        assert_eq!(told, ["nowhere", "first", "second", "second, another", "third"]);
    }

    #[test]
    fn tallies_are_words() {
        assert_eq!(tally(2, 1), "2 errors, 1 warning");
        assert_eq!(tally(0, 3), "3 warnings");
        assert_eq!(tally(1, 0), "1 error");
        assert_eq!(tally(0, 0), "");
    }
}
