//! `spectrum/…` and `file/…`: spectra that are none, and the files that hold them.

use crate::diag::{Code, Diagnostic, Span};
use crate::lang::ast::Word;
use crate::lang::limits;
use crate::lang::value::neat;

/// A field of `spectrum` that is no wavelength. `number`: it is a number; `bare`: without a unit.
pub fn no_wavelength(key: &Word, number: bool, bare: bool) -> Diagnostic {
    let headline = format!("`spectrum`: `{}` is no wavelength", key.text);
    let told = Diagnostic::error(Code::SPECTRUM_NO_WAVELENGTH, headline)
        .label(key.span, "a wavelength belongs before the colon");
    match (number, bare) {
        (_, true) => told.help(format!("write `{} nm`", key.text)).mend(
            format!("write `{} nm`", key.text),
            key.span.after(),
            " nm",
        ),
        (true, false) => told.help("write a length above 0, such as `400 nm`"),
        (false, false) => told.help("write `spectrum { 400 nm: 0.1, 700 nm: 0.5 }`"),
    }
}

/// `spectrum {}`
pub fn empty(braces: Span) -> Diagnostic {
    Diagnostic::error(Code::SPECTRUM_NO_WAVELENGTH, "this spectrum has no wavelength")
        .label(braces, "wavelengths with values belong here")
        .help("write `spectrum { 400 nm: 0.1, 700 nm: 0.5 }`")
}

/// A table beyond what an eye sees.
pub fn unseen(ends: (f64, f64), seen: (f64, f64), place: Span) -> Diagnostic {
    let [first, last] = [ends.0, ends.1].map(neat);
    let range = if first == last { format!("{first} nm") } else { format!("{first} to {last} nm") };
    let told = Diagnostic::error(
        Code::SPECTRUM_NOT_VISIBLE,
        format!("this table is of {range}, which no eye sees"),
    )
    .label(place, format!("eyes see from {} to {} nm", seen.0, seen.1))
    .why("Beyond its wavelengths a table is constant: all that is seen would be its last value.");
    match last < 100.0 {
        true => told
            .help("check the unit: were micrometres meant? A file of them is `data(\"FILE\", um)`"),
        false => told.help("check the unit of its wavelengths"),
    }
}

/// A colour and a spectrum in one sum or product.
pub fn mixed(colour: Span, operator: Span) -> Diagnostic {
    Diagnostic::error(
        Code::SPECTRUM_MIXED,
        "a colour and a spectrum have no sum, product or quotient",
    )
    .label(operator, "between a colour and a spectrum")
    .label(colour, "three numbers, which say nothing of wavelengths")
    .why("Many spectra have the same colour, and each gives another result.")
    .help("write `upsample(…)` around the colour to take a smooth spectrum of it")
}

/// Sellmeier's b and c of different lengths, or empty.
pub fn uneven_terms(b: usize, c: usize, span: Span) -> Diagnostic {
    let headline = match b {
        0 if c == 0 => "`sellmeier` has no term".to_string(),
        _ => format!("`sellmeier` has {b} in `b`, and {c} in `c`"),
    };
    Diagnostic::error(Code::SPECTRUM_NO_INDEX, headline)
        .label(span, "each term has one number in either list")
        .help("write as many in `c` as in `b`, in the same order")
}

/// A resonance among the wavelengths that are seen.
pub fn resonance(nm: f64, span: Span) -> Diagnostic {
    let headline =
        format!("this formula has no index at {} nm: it has a resonance there", nm.round());
    Diagnostic::error(Code::SPECTRUM_NO_INDEX, headline)
        .label(span, "the square root of one of these is a wavelength of light")
        .why("Catalogues give the resonances as areas, or as lengths whose squares they are.")
        .help("square the lengths: `[0.1 um^2]` for a length of 0.316 um")
}

/// A formula without a real index.
pub fn no_real_index(nm: u32, found: f64, span: Span) -> Diagnostic {
    let found = match found.is_finite() {
        true => format!("{found:.4}"),
        false => "no number".to_string(),
    };
    let headline = format!("this formula has no index of refraction: at {nm} nm it is {found}");
    Diagnostic::error(Code::SPECTRUM_NO_INDEX, headline)
        .label(span, "must be above 0 wherever light is seen")
        .help("check the signs and the units of its coefficients: catalogues count in micrometres")
}

/// A file that could not be read. `path` is the place it was looked for at, `cause` a clause that
/// continues "the file …".
pub fn unread(name: &str, path: &str, cause: &str, span: Span) -> Diagnostic {
    let headline = match name.trim().is_empty() {
        true => "`data` names no file".to_string(),
        false => format!("the file `{name}` {cause}"),
    };
    let told = Diagnostic::error(Code::FILE_UNREADABLE, headline).label(span, "names it");
    if name.trim().is_empty() {
        return told.help("write the name of a file of rows, such as `data(\"paint.csv\")`");
    }
    let told = told.why(format!(
        "It was looked for at {path}: names are relative to the file that holds them."
    ));
    told.help(match cause {
        "does not exist" | "has a file where a folder should be in its path" => {
            "correct the name, or put the file there"
        }
        "is a folder" => "name a file in that folder",
        cause if cause.contains("not a file") => "save what it gives to a file, and name that file",
        cause if cause.starts_with("is larger than") => {
            "leave out rows: straight lines join those that stay"
        }
        cause if cause.starts_with("is not UTF-8") => {
            "save the file as UTF-8 text: editors and spreadsheets offer it"
        }
        _ => "name a file that can be read",
    })
}

/// More files than the limit.
pub fn too_many_files(span: Span) -> Diagnostic {
    let headline =
        format!("a scene may take data from {} files, and this is one more", limits::FILES);
    Diagnostic::error(Code::FILE_UNREADABLE, headline)
        .label(span, "one too many")
        .help("leave out data that no render needs")
}

/// A file whose text is no table.
pub fn bad_data(
    name: &str,
    what: &str,
    help: &str,
    place: Option<Span>,
    asked: Span,
) -> Diagnostic {
    let told = Diagnostic::error(Code::FILE_BAD_DATA, format!("the file `{name}` {what}"));
    match place {
        Some(place) => told.label(place, "in this row").label(asked, "read from here"),
        None => told.label(asked, "read from here"),
    }
    .help(help.to_string())
}
