//! Safe mends, applied to a text.

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Edit, FileId};

/// A text with mends in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// The text.
    pub text: String,
    /// What was mended, in the order of the text.
    pub mends: Vec<Mended>,
}

/// A mend that was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mended {
    /// The line where it begins, from 1, as the lines were before.
    pub line: usize,
    /// What was done, an imperative.
    pub title: String,
}

/// Applies the first safe mend of each finding to the text of `file`, as far as they do not meet:
/// of two that change the same place, the first is taken. None if there is none to apply.
pub fn fixed(text: &str, file: FileId, found: &[Diagnostic]) -> Option<Fixed> {
    let mut taken: Vec<&Edit> = Vec::new();
    // Where each begins and ends.
    let mut places: BTreeMap<u32, u32> = BTreeMap::new();
    let mut mends: Vec<(u32, String)> = Vec::new();
    for diagnostic in found {
        let Some(mend) = diagnostic.mends.iter().find(|mend| mend.safe) else { continue };
        let fits = mend.edits.iter().all(|edit| {
            edit.span.file == file && text.get(edit.span.range()).is_some() && !meets(&places, edit)
        });
        if fits && let Some(first) = mend.edits.iter().map(|edit| edit.span.start).min() {
            taken.extend(&mend.edits);
            for Edit { span, .. } in &mend.edits {
                let end = places.entry(span.start).or_default();
                *end = span.end.max(*end);
            }
            mends.push((first, mend.title.clone()));
        }
    }
    if taken.is_empty() {
        return None;
    }
    mends.sort();
    taken.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut mended = String::with_capacity(text.len());
    let mut at = 0;
    for edit in taken {
        let range = edit.span.range();
        mended.push_str(&text[at..range.start]);
        mended.push_str(&edit.text);
        at = range.end;
    }
    mended.push_str(&text[at..]);
    let line = |at: u32| 1 + text[..at as usize].matches('\n').count();
    let mends = mends.into_iter().map(|(at, title)| Mended { line: line(at), title }).collect();
    Some(Fixed { text: mended, mends })
}

/// Whether an edit changes a place that is changed already; those places lie apart. Two insertions
/// at one place do.
fn meets(places: &BTreeMap<u32, u32>, edit: &Edit) -> bool {
    let (start, end) = (edit.span.start, edit.span.end);
    let before = places.range(..start).next_back().is_some_and(|(_, it)| *it > start);
    before || places.range(start..).next().is_some_and(|(at, _)| *at == start || *at < end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Span};

    fn mend(start: usize, end: usize, text: &str) -> Diagnostic {
        let span = Span::new(FileId(0), start, end);
        Diagnostic::warning(Code::SYNTAX_COMMENT, "").safe_mend(format!("to {text}"), span, text)
    }

    #[test]
    fn safe_mends_are_applied_and_others_are_not() {
        let unsafe_one = Diagnostic::warning(Code::SYNTAX_COMMENT, "").mend(
            "no",
            Span::new(FileId(0), 0, 3),
            "two",
        );
        let found = [mend(8, 8, "!"), unsafe_one, mend(4, 7, "w\u{f6}rld")];
        let fixed = fixed("one two\n.", FileId(0), &found).unwrap();
        assert_eq!(fixed.text, "one w\u{f6}rld\n!.");
        let mended = |line, title: &str| Mended { line, title: title.to_string() };
        assert_eq!(fixed.mends, [mended(1, "to w\u{f6}rld"), mended(2, "to !")]);
    }

    #[test]
    fn of_mends_that_meet_the_first_is_taken() {
        let found = [mend(0, 3, "a"), mend(2, 4, "b"), mend(3, 4, "c"), mend(3, 3, "d")];
        assert_eq!(fixed("12345", FileId(0), &found).unwrap().text, "ac5");
        // Beyond the text, inside of a character, in another text.
        assert_eq!(fixed("\u{e9}", FileId(0), &[mend(0, 1, "x"), mend(5, 9, "x")]), None);
        assert_eq!(fixed("12345", FileId(1), &found), None);
    }
}
