//! A scene text in the one style there is: layout alone changes, never a word.
//!
//! Four spaces a level, a hundred columns, no alignment. Items stand on lines of their own. A
//! record written on one line stays on one if it fits; else it has a field a line, without commas.
//! A list likewise, with commas; short elements share lines. Vectors and arguments stand on one
//! line if they fit. Comments stay where they stand. Between items and fields
//! one blank line is kept. Lines end with a line feed alone, the last one too.
//!
//! Left out: lines without a place to break them, such as long strings, stay as long as they are;
//! comments are not wrapped.

mod tokens;
mod tree;
mod write;

#[cfg(test)]
mod tests;

use super::parse;
use crate::diag::{Diagnostic, FileId};

/// The text in that style; or what is wrong with it, for only a text without faults of syntax has
/// a form to be shown in. `id`: the text's number, for the places of faults.
pub fn format(text: &str, id: FileId) -> Result<String, Vec<Diagnostic>> {
    let starts = parse::starts(text, id)?;
    let tokens = tokens::read(text);
    let file = tree::build(&tokens, &starts);
    Ok(write::file(&tokens, &file))
}
