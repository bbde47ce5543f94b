//! `import/…`: files that name files.

use crate::diag::words::listed;
use crate::diag::{Code, Diagnostic, Span};
use crate::lang::limits;

/// A file that cannot be read.
pub fn unreadable(name: &str, path: &str, cause: &str, span: Span) -> Diagnostic {
    let told = Diagnostic::error(Code::IMPORT_UNREADABLE, format!("`{name}` {cause}"))
        .label(span, "used here");
    match name == path {
        true => told.help("the name is relative to the folder of the file it stands in"),
        false => told
            .why(format!("It was looked for at `{path}`."))
            .help("the name is relative to the folder of the file it stands in"),
    }
}

/// More files than the limit; told of the first one.
pub fn too_many(span: Span) -> Diagnostic {
    let headline = format!("a scene may have {} files, and this is one more", limits::FILES);
    Diagnostic::error(Code::IMPORT_UNREADABLE, headline)
        .label(span, "one too many")
        .help("put several setups into one file")
}

/// More text than the limit.
pub fn too_much(name: &str, span: Span) -> Diagnostic {
    let most = limits::ALL_BYTES >> 20;
    let headline =
        format!("the files of a scene may have {most} MB together, and `{name}` is too much");
    Diagnostic::error(Code::IMPORT_UNREADABLE, headline)
        .label(span, "beyond the limit")
        .help("measured data belongs in files of its own, which the scene names")
}

/// Files that use each other.
pub fn circle(files: &[(String, Span)]) -> Diagnostic {
    let names: Vec<_> = files.iter().map(|(name, _)| name.as_str()).collect();
    let headline = match names.as_slice() {
        [one] => format!("`{one}` uses itself"),
        _ => format!("{} use each other in a circle", listed(names.iter().copied(), "and")),
    };
    let mut told = Diagnostic::error(Code::IMPORT_CIRCLE, headline);
    for (name, span) in files {
        told = told.label(*span, format!("uses `{name}`"));
    }
    told.help("move what both need into a file of its own")
}
