//! Faults of .obj files, and of what a scene says about their materials.

use super::TOLD;
use crate::diag::near;
use crate::diag::words::{counted, few};
use crate::diag::{Code, Diagnostic, Span};
use crate::files::Failure;
use crate::files::obj::{Fault, Notice, STATEMENTS, Unread, What};

/// A statement that is wrong; `at` is its place and that of the field that names the file.
pub fn fault(file: &str, fault: &Fault, at: (Span, Span)) -> Diagnostic {
    let line = fault.place.line;
    let (code, headline, label, help) = match &fault.what {
        What::NotANumber(word) => (
            Code::MESH_BAD_NUMBER,
            format!("`{word}` in line {line} of `{file}` is not a number"),
            "no number".to_string(),
            if word.contains(',') {
                "write a point before the decimals and blanks between numbers"
            } else {
                "write the coordinate; if the file was cut off or joined, export it again"
            },
        ),
        What::NotFinite(word) => (
            Code::MESH_BAD_NUMBER,
            format!("`{word}` in line {line} of `{file}` is not a finite number"),
            "not finite, or too large for any computer's numbers".to_string(),
            "export the mesh again: the program that wrote it divided by zero or overflowed",
        ),
        What::TooFar(word) => (
            Code::MESH_BAD_NUMBER,
            format!("the coordinate `{word}` in line {line} of `{file}` is too large"),
            "coordinates reach to 1e30".to_string(),
            "write the coordinates in a larger unit, and name it by `unit:`",
        ),
        What::TooFewNumbers { statement, found, wanted } => (
            Code::MESH_TOO_FEW_NUMBERS,
            format!(
                "`{statement}` in line {line} of `{file}` has {}; it needs {wanted}",
                counted(*found as u64, "number")
            ),
            format!("{found} of {wanted}"),
            "write all coordinates; if the file was cut off, export it again",
        ),
        What::NotAnIndex(word) => (
            Code::MESH_BAD_INDEX,
            format!("`{word}` in line {line} of `{file}` is not a corner of a face"),
            "no corner".to_string(),
            "a corner is written `1`, `1/2`, `1//3` or `1/2/3`: vertex, texture coordinate, normal",
        ),
        What::ZeroIndex(of) => (
            Code::MESH_BAD_INDEX,
            format!("the face in line {line} of `{file}` uses index 0"),
            format!("{} count from 1", of.words()),
            "add one to every index, if the program that wrote the file counts from 0",
        ),
        What::OutOfRange { of, index, count } => (
            Code::MESH_BAD_INDEX,
            match index {
                0.. => format!(
                    "the face in line {line} of `{file}` uses {} {index}; the file has {count}",
                    one(of.words()),
                ),
                _ => format!(
                    "the face in line {line} of `{file}` counts {} {} back; \
                     there are {count} before it",
                    index.unsigned_abs(),
                    of.words(),
                ),
            },
            format!("no such `{}`", of.statement()),
            "export the mesh again: vertices are missing, or the face is wrong",
        ),
        What::TooFewCorners(found) => (
            Code::MESH_TOO_FEW_CORNERS,
            format!(
                "the face in line {line} of `{file}` has {}; it needs 3",
                counted(*found as u64, "corner")
            ),
            "no surface".to_string(),
            "remove the face or complete it; points and lines are written `p` and `l`",
        ),
        What::MixedNormals => (
            Code::MESH_MIXED_NORMALS,
            format!("the face in line {line} of `{file}` has normals at some corners only"),
            "some corners have a normal, some have none".to_string(),
            "give every corner of the face a normal, or none",
        ),
        What::MissingName(statement) => (
            Code::MESH_MISSING_NAME,
            format!("`{statement}` in line {line} of `{file}` has no name"),
            "a name should follow".to_string(),
            "write the name, or remove the line",
        ),
        What::TooManyWords(most) => (
            Code::MESH_TOO_MUCH,
            format!("line {line} of `{file}` has more than {}", counted(*most as u64, "word")),
            "too long to read".to_string(),
            "remove the backslashes that join its lines, or split the polygon into triangles",
        ),
        What::TooManyNames(statement, most) => (
            Code::MESH_TOO_MUCH,
            format!(
                "`{file}` has more than {} after `{statement}`",
                counted(*most as u64, "different name")
            ),
            "one too many".to_string(),
            "split the mesh into several files",
        ),
    };
    Diagnostic::error(code, headline).label(at.0, label).label(at.1, NAMED_HERE).help(help)
}

const HARMLESS: &str = "nothing to do if the program that wrote the file uses it for itself";
const NAMED_HERE: &str = "the file is named here";

/// One of them: "vertices" is "vertex".
fn one(many: &str) -> &str {
    match many {
        "vertices" => "vertex",
        many => many.strip_suffix('s').unwrap_or(many),
    }
}

/// What is left out or doubtful.
pub fn notice(file: &str, notice: &Notice, at: (Span, Span)) -> Diagnostic {
    let line = notice.place.line;
    let lines = counted(notice.count, "line");
    let (code, headline, label, help) = match &notice.what {
        Unread::Unknown(word) => (
            Code::MESH_UNKNOWN_STATEMENT,
            format!("`{word}` in `{file}` is not a statement of a Wavefront file"),
            match notice.count {
                1 => "has no effect".to_string(),
                _ => format!("has no effect, here and wherever it stands, in {lines}"),
            },
            match near(word, STATEMENTS).first() {
                Some(near) => format!("write `{near}`, if that is meant"),
                None => HARMLESS.to_string(),
            },
        ),
        Unread::FreeForm => (
            Code::MESH_NOT_RENDERED,
            format!("the curves and surfaces in `{file}` are not rendered: only faces are"),
            format!("in {lines}, this one first"),
            "export the mesh as polygons".to_string(),
        ),
        Unread::Points | Unread::Lines => (
            Code::MESH_NOT_RENDERED,
            match notice.what {
                Unread::Points => {
                    format!("the points in `{file}` are not rendered: only faces are")
                }
                _ => format!("the lines in `{file}` are not rendered: only faces are"),
            },
            match notice.count {
                1 => "has no effect".to_string(),
                count => format!("the first of {count}"),
            },
            "nothing to do if only the faces matter".to_string(),
        ),
        Unread::VertexColours => (
            Code::MESH_NOT_RENDERED,
            format!("the colours of the vertices of `{file}` are not rendered"),
            format!("in {lines}, this one first"),
            "colours come from materials: `usemtl` in the file, or `material` in the scene"
                .to_string(),
        ),
        Unread::Concave => (
            Code::MESH_CONCAVE_FACE,
            match notice.count {
                1 => format!(
                    "the face in line {line} of `{file}` cannot be split well into triangles"
                ),
                _ => format!(
                    "{} of `{file}`, the first in line {line}, cannot be split well into triangles",
                    counted(notice.count, "face")
                ),
            },
            "no corner of it sees all others".to_string(),
            "triangulate the mesh in the program that made it".to_string(),
        ),
        Unread::ZeroNormal => (
            Code::MESH_ZERO_NORMAL,
            match notice.count {
                1 => format!("the normal in line {line} of `{file}` has length zero"),
                _ => format!(
                    "{} of `{file}`, the first in line {line}, have length zero",
                    counted(notice.count, "normal")
                ),
            },
            "has no direction".to_string(),
            "the faces that use it are shaded flat; export the normals again".to_string(),
        ),
        Unread::Smoothing => (
            Code::MESH_SMOOTHING_GROUP,
            format!("faces of `{file}` without normals are shaded flat, whatever `s` says"),
            "smoothing groups are not computed".to_string(),
            "export the mesh with normals (`vn`) to have it smooth".to_string(),
        ),
    };
    Diagnostic::warning(code, headline).label(at.0, label).label(at.1, NAMED_HERE).help(help)
}

/// A file that is no .obj file at all.
pub fn other_format(file: &str, field: Span, failure: &Failure) -> Diagnostic {
    Diagnostic::error(Code::MESH_NOT_WAVEFRONT, format!("the mesh `{file}` {failure}"))
        .label(field, "not a Wavefront .obj file")
        .help("export the mesh as .obj: nearly every program for meshes can")
}

/// A file without a face, or with `all` of its triangles without area.
pub fn no_faces(file: &str, all: usize, field: Span) -> Diagnostic {
    let fault = Diagnostic::error(
        Code::MESH_NO_FACES,
        if all == 0 {
            format!("the mesh `{file}` has no faces")
        } else {
            format!("no triangle of the mesh `{file}` has an area")
        },
    )
    .label(field, "there is nothing to see in this file");
    match all {
        0 => fault.help("export the mesh with its faces; points and lines are not rendered"),
        _ => fault.help("export the mesh again: its vertices lie on a line or at a point"),
    }
}

/// Triangles without area, left out.
pub fn degenerate(file: &str, count: u64, at: Span, field: Span) -> Diagnostic {
    let triangles = counted(count, "triangle");
    let (have, are) = if count == 1 { ("has", "is") } else { ("have", "are") };
    let headline = format!("{triangles} of `{file}` {have} no area and {are} left out");
    Diagnostic::warning(Code::MESH_DEGENERATE_TRIANGLES, headline)
        .label(at, "the first is in this face: its corners lie on a line or at a point")
        .label(field, NAMED_HERE)
        .help("nothing to do: such triangles cannot be seen")
}

/// Triangles that are there twice, left out.
pub fn repeated(file: &str, count: u64, at: Span, field: Span) -> Diagnostic {
    let triangles = counted(count, "triangle");
    let (repeat, are) = if count == 1 { ("repeats", "is") } else { ("repeat", "are") };
    let headline = format!("{triangles} of `{file}` {repeat} earlier ones and {are} left out");
    Diagnostic::warning(Code::MESH_REPEATED_TRIANGLES, headline)
        .label(at, "the first is in this face: an earlier one has the same corners")
        .label(field, NAMED_HERE)
        .why("Of two surfaces at one place, chance would decide which one a ray meets.")
        .help("nothing to do if the first of them is the right one")
}

/// `material` and `materials` on one mesh.
pub fn two_replacements(object: &str, one: Span, other: Span) -> Diagnostic {
    Diagnostic::error(
        Code::MESH_TWO_REPLACEMENTS,
        format!("the mesh `{object}` has both `material` and `materials`"),
    )
    .label(other, "replaces some materials by their name")
    .label(one, "replaces all of them")
    .help("remove one of the two")
}

/// A name in `materials` that no face of the mesh uses.
pub fn unknown_material(file: &str, name: &str, span: Span, names: &[String]) -> Diagnostic {
    let named: Vec<&str> = names.iter().map(String::as_str).filter(|n| !n.is_empty()).collect();
    let fault = Diagnostic::error(
        Code::MESH_UNKNOWN_MATERIAL,
        format!("no face of `{file}` has a material called `{name}`"),
    )
    .label(span, "no such material there");
    let fault = match named.as_slice() {
        [] => fault.why("Its faces name no material."),
        all => {
            fault.why(format!("The materials of its faces: {}.", few(all.iter().copied(), TOLD)))
        }
    };
    match near(name, named).first() {
        Some(near) => fault.help(format!("write `{near}`, if that is meant")),
        None if names.iter().all(String::is_empty) => {
            fault.help("write `material: …`, which replaces the material of all faces")
        }
        None => fault.help("write one of these names, or remove the line"),
    }
}

/// Faces before any `usemtl`, and no material for them.
pub fn no_material(object: &str, file: &str, at: Span, field: Span) -> Diagnostic {
    Diagnostic::error(
        Code::MESH_NO_MATERIAL,
        format!("faces of `{file}` have no material"),
    )
    .label(at, "no `usemtl` comes before this face")
    .label(field, NAMED_HERE)
    .help(format!(
        "give the object `{object}` one for all its faces: `material: …`, the name of a material \
         of the scene"
    ))
}

/// A `usemtl` whose name no .mtl file has; `names` are those they have, None if there is no file.
pub fn missing_material(
    file: &str,
    name: &str,
    names: Option<&Vec<&str>>,
    at: Span,
    field: Span,
) -> Diagnostic {
    let fault = Diagnostic::error(
        Code::MESH_MISSING_MATERIAL,
        format!("`{file}` uses the material `{name}`, which is nowhere defined"),
    )
    .label(at, "used here")
    .label(field, NAMED_HERE);
    let mend = format!("give it one in the scene: `materials: {{ \"{name}\": … }}`");
    match names {
        None => fault
            .why(format!("`{file}` names no .mtl file, and the scene gives none."))
            .help(format!("{mend}, or name the file: `mtl: \"…\"`")),
        Some(names) => {
            let has = match names.is_empty() {
                true => "none".into(),
                false => few(names.iter().copied(), TOLD),
            };
            let fault = fault.why(format!("The .mtl file defines {has}."));
            match near(name, names.iter().copied()).first() {
                Some(near) => {
                    fault.help(format!("write `usemtl {near}` if that is meant, or {mend}"))
                }
                None => fault.help(mend),
            }
        }
    }
}
