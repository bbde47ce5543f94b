//! What is wrong with what a person wrote: a place in their text, a sentence, a cause, a mend.
//!
//! Every room that finds faults builds [`Diagnostic`]s with one function per fault in its own
//! `errors/<family>.rs`; only [`print`] knows how they look on a terminal; [`json`],
//! [`sarif`] and [`short`] how machines read them. [`near`] and [`words`] help to write sentences.

mod code;
mod diagnostic;
mod excerpt;
pub mod json;
mod lines;
mod near;
mod order;
pub mod print;
pub mod sarif;
pub mod short;
mod sources;
mod span;
pub mod words;

pub use code::{CODES, Code, find};
pub use diagnostic::{Diagnostic, Edit, Label, Level, Mend};
pub use excerpt::{harmless_line, harmless_text};
pub use near::near;
pub use order::{count, in_order, tally};
pub use sources::{Source, Sources};
pub use span::{FileId, Span};
