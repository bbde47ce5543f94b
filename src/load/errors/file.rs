//! Faults of files as such: they cannot be read, or must not be.

use std::path::Path;

use crate::diag::near;
use crate::diag::{Code, Diagnostic, Span};
use crate::files::Failure;

/// A file that cannot be read. `beside` are the names of the files in its folder.
pub fn unreadable(
    name: &str,
    path: &Path,
    span: Span,
    failure: &Failure,
    beside: &[String],
) -> Diagnostic {
    let fault = Diagnostic::error(Code::FILE_UNREADABLE, format!("the file `{name}` {failure}"))
        .label(span, "names it");
    if failure.to_string() != "does not exist" {
        return fault.help("name a file that can be read");
    }
    let wanted = path.file_name().and_then(|name| name.to_str()).unwrap_or("");
    let fault = fault.why(format!(
        "It was looked for at {}: names are relative to the file that holds them.",
        super::super::files::shown(path)
    ));
    match near(wanted, beside.iter().map(String::as_str)).first() {
        Some(near) => fault.help(format!("there is a file `{near}` in that folder; was it meant?")),
        None => fault.help("correct the name, or put the file there"),
    }
}

/// A .mtl file outside of the folder of the .obj file that names it.
pub fn outside(obj: &str, name: &str, span: Span, field: Span) -> Diagnostic {
    elsewhere(obj, name, span, field)
        .help("put the .mtl file beside the .obj file, or name it in the scene: `mtl: \"…\"`")
}

/// A picture outside of the folder of the .mtl file that names it.
pub fn outside_picture(mtl: &str, name: &str, span: Span, field: Span) -> Diagnostic {
    elsewhere(mtl, name, span, field).help(
        "put the picture beside the .mtl file, or give the mesh a material of the scene, with a \
         texture that names it",
    )
}

fn elsewhere(file: &str, name: &str, span: Span, field: Span) -> Diagnostic {
    Diagnostic::error(
        Code::FILE_OUTSIDE_FOLDER,
        format!("`{file}` names the file `{name}`, which is not in its folder"),
    )
    .label(span, "leads out of the folder of the file that names it")
    .label(field, "this mesh uses it")
    .why("A mesh from elsewhere could read any file of this computer that way.")
}
