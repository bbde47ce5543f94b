//! Faults of .mtl files, and what they ask for that is not rendered.

use std::ops::Range;

use super::super::materials::Place;
use super::TOLD;
use crate::diag::near;
use crate::diag::words::{counted, few};
use crate::diag::{Code, Diagnostic, Span};
use crate::files::Failure;
use crate::files::mtl::{Fault, Material, STATEMENTS, What};

/// A statement that is wrong. `at` finds places in the file; `asked` is who names it.
pub fn fault(
    file: &str,
    fault: &Fault,
    at: &impl Fn(&Range<usize>) -> Span,
    asked: Span,
) -> Diagnostic {
    let of = match &fault.material {
        Some(name) if !name.is_empty() => format!("of the material `{name}` in `{file}`"),
        _ => format!("in `{file}`"),
    };
    let (code, headline, label, help) = match &fault.what {
        What::NotANumber(word) => (
            Code::MTL_BAD_NUMBER,
            format!("a value {of} is not a number: `{word}`"),
            "no number".to_string(),
            "write a number, with a point before its decimals".to_string(),
        ),
        What::NotFinite(word) => (
            Code::MTL_BAD_NUMBER,
            format!("a value {of} is not a finite number: `{word}`"),
            "not finite, or too large".to_string(),
            "write the number that is meant".to_string(),
        ),
        What::Negative(word) => (
            Code::MTL_NEGATIVE,
            format!("a value {of} is negative: `{word}`"),
            "below zero".to_string(),
            "write zero or more: there is no negative light".to_string(),
        ),
        What::NoFraction(word) => (
            Code::MTL_BAD_NUMBER,
            format!("the opacity `{word}` {of} is above 1"),
            "from 0 to 1".to_string(),
            "write 1 for opaque, 0 for what cannot be seen; `Tr` is the other way round"
                .to_string(),
        ),
        What::WrongCount { statement, found, wanted } => (
            Code::MTL_WRONG_COUNT,
            format!(
                "`{statement}` {of} has {}; it needs {wanted}",
                counted(*found as u64, "number")
            ),
            format!("needs {wanted}"),
            match statement.as_str() {
                "illum" | "Ns" | "Ni" | "d" | "Tr" => format!("write `{statement}` and one number"),
                _ => format!("write `{statement}` with red, green and blue, or with one grey"),
            },
        ),
        What::NotAnIllum(word) => (
            Code::MTL_BAD_ILLUM,
            format!("the illum {of} is no model of illumination: `{word}`"),
            "a whole number from 0 to 14".to_string(),
            "write `illum 1` for a diffuse surface".to_string(),
        ),
        What::OtherColour(word) => (
            Code::MTL_OTHER_COLOUR,
            format!("a colour {of} is given as `{word}`, which is not read"),
            "only red, green and blue are read".to_string(),
            "write red, green and blue; or replace the material by one of the scene".to_string(),
        ),
        What::MissingName => (
            Code::MTL_MISSING_NAME,
            format!("a `newmtl` in `{file}` has no name"),
            "a name should follow".to_string(),
            "write the name the .obj file uses after `usemtl`".to_string(),
        ),
        What::SameName(_) => (
            Code::MTL_SAME_NAME,
            format!(
                "`{file}` defines two materials called `{}`",
                fault.material.as_deref().unwrap_or("")
            ),
            "the second".to_string(),
            "rename or remove one of the two".to_string(),
        ),
        What::NoMaterial => (
            Code::MTL_BEFORE_NEWMTL,
            format!("`{file}` says something of a material before any `newmtl`"),
            "of which material?".to_string(),
            "begin the material before this line: `newmtl NAME`".to_string(),
        ),
    };
    let mut diagnostic = Diagnostic::error(code, headline).label(at(&fault.at), label);
    if let What::SameName(first) = &fault.what {
        diagnostic = diagnostic.label(at(first), "the first");
    }
    diagnostic.label(asked, "the file is named here").help(help)
}

/// A file that is no .mtl file at all.
pub fn other_format(file: &str, asked: Span, failure: &Failure) -> Diagnostic {
    Diagnostic::error(Code::MTL_NOT_WAVEFRONT, format!("the file of materials `{file}` {failure}"))
        .label(asked, "names it")
        .help("name a Wavefront .mtl file, or replace all materials in the scene: `material: …`")
}

/// A word that is no statement.
pub fn unknown(file: &str, word: &str, at: Span) -> Diagnostic {
    let headline = format!("`{word}` in `{file}` is not a statement of a .mtl file");
    Diagnostic::warning(Code::MTL_UNKNOWN_STATEMENT, headline).label(at, "has no effect").help(
        match near(word, STATEMENTS.iter().copied()).first() {
            Some(near) => format!("write `{near}`, if that is meant"),
            None => "nothing to do if the program that wrote the file uses it for itself".into(),
        },
    )
}

/// A Ka that is not zero, and a scene that does not say what it means.
pub fn ambient(file: &str, shining: &[(&str, Place, &Material)], field: Span) -> Diagnostic {
    let names = few(shining.iter().map(|(name, ..)| *name), TOLD);
    let materials = if shining.len() == 1 { "material" } else { "materials" };
    let mut fault = Diagnostic::error(
        Code::MTL_AMBIENT,
        format!("the scene must say what Ka means in the {materials} {names} of `{file}`"),
    );
    let places = shining.iter().filter_map(|(_, at, said)| Some(at.span(said.ambient.as_ref()?)));
    for (i, span) in places.take(3).enumerate() {
        fault = fault.label(span, if i == 0 { "Ka is not zero" } else { "nor here" });
    }
    fault
        .label(field, "this mesh uses it")
        .why("Some programs write the light a surface emits as Ka, others write 1 1 1 everywhere.")
        .help(
            "say it beside `file`: `ambient: emission` if such a surface shines, \
             `ambient: ignored` if it does not",
        )
        .mend("write `ambient: emission`: the surface shines", field.after(), ", ambient: emission")
        .mend("write `ambient: ignored`: it does not", field.after(), ", ambient: ignored")
}

/// What a material asks for and does not get.
pub fn not_rendered(
    name: &str,
    as_diffuse: bool,
    left_out: &[(&'static str, Span)],
    field: Span,
) -> Diagnostic {
    let mut words: Vec<&str> = left_out.iter().map(|(words, _)| *words).collect();
    words.dedup();
    let words = match words.as_slice() {
        [one] => (*one).to_string(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
        [] => String::new(),
    };
    let mut warning = Diagnostic::warning(
        Code::MTL_NOT_RENDERED,
        match as_diffuse {
            true => format!("the material `{name}` is rendered as diffuse, without {words}"),
            false => format!("the material `{name}` is rendered without {words}"),
        },
    );
    for (i, (_, span)) in left_out.iter().take(3).enumerate() {
        warning = warning.label(*span, if i == 0 { "not rendered yet" } else { "nor this" });
    }
    warning
        .label(field, "this mesh uses it")
        .help("replace it by a material of the scene to have it otherwise")
}

/// A Kd or Ks above one.
pub fn above_one(name: &str, word: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(
        Code::MTL_ABOVE_ONE,
        format!("the material `{name}` gives back more light than it gets"),
    )
    .label(at, format!("{word} is above 1"))
    .help(format!("write a {word} of at most 1; if the surface shines of itself, write Ke"))
}

/// A material without any colour.
pub fn no_colour(name: &str, at: Span) -> Diagnostic {
    Diagnostic::warning(
        Code::MTL_NO_COLOUR,
        format!("the material `{name}` has no Kd and is rendered black"),
    )
    .label(at, "no Kd follows")
    .help("write its diffuse colour, such as `Kd 0.8 0.8 0.8`, if it is not black")
}

/// A mirror without a colour.
pub fn no_mirror_colour(name: &str, at: Span, field: Span) -> Diagnostic {
    Diagnostic::error(
        Code::MTL_NO_MIRROR_COLOUR,
        format!("the material `{name}` is a mirror, and has no Ks"),
    )
    .label(at, "no Ks follows")
    .label(field, "this mesh uses it")
    .why("Under `illum 3` Ks is the part of the light that is given back.")
    .help(
        "write it below `newmtl`, such as `Ks 1 1 1`; or replace the material by one of the scene",
    )
}

/// Glass without an index.
pub fn no_index(name: &str, at: Span, field: Span) -> Diagnostic {
    Diagnostic::error(
        Code::MTL_NO_INDEX,
        format!("the material `{name}` is glass, and has no index of refraction"),
    )
    .label(at, "no Ni above 0 follows")
    .label(field, "this mesh uses it")
    .help("write it below `newmtl`, such as `Ni 1.5`; or replace the material by one of the scene")
}

/// A metal that no shelf has.
pub fn no_such_metal(name: &str, known: &[&str], at: Span, field: Span) -> Diagnostic {
    let told = Diagnostic::error(Code::MTL_NO_SUCH_METAL, format!("there is no metal `{name}`"))
        .label(at, "its `illum 11` asks for a metal of that name")
        .label(field, "this mesh uses it");
    let quoted = match name.contains(|c: char| !c.is_alphanumeric() && c != '_') {
        true => format!("\"{name}\""),
        false => name.to_string(),
    };
    let line = format!("`materials: {{ {quoted}: conductor {{ ior: complex(…, …) }} }}`");
    match near(name, known.iter().copied()).first() {
        Some(near) => {
            told.help(format!("call it `{near}` in the file, if that is meant; else write {line}"))
        }
        None => {
            told.help(format!("known are {}; else write {line}", few(known.iter().copied(), TOLD)))
        }
    }
}

/// A medium that the scene does not declare.
pub fn no_such_medium(name: &str, known: &[&str], at: Span, field: Span) -> Diagnostic {
    let told = Diagnostic::error(
        Code::MTL_NO_SUCH_MEDIUM,
        format!("the scene declares no medium `{name}`"),
    )
    .label(at, "its `illum` asks for a medium of the scene, by name")
    .label(field, "this mesh uses it");
    let quoted = match name.contains(|c: char| !c.is_alphanumeric() && c != '_') {
        true => format!("\"{name}\""),
        false => name.to_string(),
    };
    let line = format!("`medium {quoted}: homogeneous {{ ior: … }}`");
    match near(name, known.iter().copied()).first() {
        Some(near) => told.help(format!("write {line}; the scene has a medium `{near}`")),
        None => told.help(format!("write {line}")),
    }
}
