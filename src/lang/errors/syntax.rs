//! `syntax/…`: the text does not have the form of a scene file.

use crate::diag::{Code, Diagnostic, FileId, Span};
use crate::lang::limits;
use crate::lang::scan::Fault;

/// Brackets and quotes that do not match.
pub fn brackets(fault: &Fault, text: &str, file: FileId) -> Diagnostic {
    let place =
        |at: usize| Span::new(file, at, at + text[at..].chars().next().map_or(0, char::len_utf8));
    match fault {
        Fault::Unclosed { open, bracket, end } => {
            let closer = match bracket {
                '(' => ')',
                '[' => ']',
                _ => '}',
            };
            let here = Span::new(file, *end, *end);
            // A brace that spans lines is closed on a line of its own.
            let line = text[..*open].rfind('\n').map_or(0, |newline| newline + 1);
            let start = &text[line..*open];
            let indent = &start[..start.len() - start.trim_start().len()];
            let written = match text[*open..*end].contains('\n') && closer == '}' {
                true => format!("\n{indent}}}"),
                false => closer.to_string(),
            };
            let headline = format!("`{bracket}` is never closed");
            Diagnostic::error(Code::SYNTAX_UNCLOSED_BRACKET, headline)
                .label(place(*open), "opened here")
                .label(here, format!("`{closer}` belongs after this"))
                .help(format!("write `{closer}` where it ends"))
                .mend(format!("write `{closer}`"), here, written)
        }
        Fault::String { open, end } => {
            let span = Span::new(file, *open, *end);
            Diagnostic::error(Code::SYNTAX_UNCLOSED_STRING, "this string has no second quote")
                .label(span, "begins here")
                .why("A string ends on the line it begins on.")
                .help("write `\"` where it ends; `\\n` is a line break inside a string")
                .mend("write the second quote", Span::new(file, *end, *end), "\"")
        }
        Fault::Stray { at, bracket } => {
            let headline = format!("`{bracket}` closes nothing");
            Diagnostic::error(Code::SYNTAX_STRAY_BRACKET, headline)
                .label(place(*at), "no bracket is open here")
                .help(format!("remove this `{bracket}`, or write the bracket it should close"))
                .mend(format!("remove `{bracket}`"), place(*at), "")
        }
        Fault::Unopened { at, item, insert } => {
            Diagnostic::error(Code::SYNTAX_STRAY_BRACKET, "`{` is missing: `}` closes nothing")
                .label(Span::new(file, *insert, *insert), "`{` belongs here")
                .label(place(*at), "this would close it")
                .help(format!("write `{{` in `{}`", clipped(&text[item.clone()])))
                .mend("write `{`", Span::new(file, *insert, *insert), " {")
        }
        Fault::TooDeep { at } => {
            let headline =
                format!("more than {} brackets or signs inside each other", limits::DEPTH);
            Diagnostic::error(Code::SYNTAX_TOO_DEEP, headline)
                .label(place(*at), "one too many")
                .help("give inner values a name by `let` and use the name")
        }
    }
}

/// A file over the limit.
pub fn file_too_large(span: Span) -> Diagnostic {
    let headline =
        format!("a scene file may have {} MB, and this has more", limits::FILE_BYTES >> 20);
    Diagnostic::error(Code::IMPORT_UNREADABLE, headline)
        .label(Span { end: span.start, ..span }, "")
        .help("measured data belongs in files of its own, which the scene names")
}

/// No first line.
pub fn first_line(top: Span) -> Diagnostic {
    Diagnostic::error(
        Code::SYNTAX_FIRST_LINE,
        "the first line does not say that this is a scene file",
    )
    .label(top, "`scn 1` belongs here")
    .why("The first line names the edition of the language, and the unit of bare coordinates.")
    .help("write `scn 1 in m` as the first line, or `mm`, `cm` in place of `m`")
    .mend("write `scn 1 in m`", top, "scn 1 in m\n\n")
}

/// A scene of another program.
pub fn other_program(program: &str, line: Span) -> Diagnostic {
    let headline = format!("this is a scene of {program}, not one of scn");
    Diagnostic::error(Code::SYNTAX_OTHER_PROGRAM, headline)
        .label(line, format!("scenes of {program} have such a line"))
        .why("Scene files of this program begin with `scn` and the edition of the language.")
        .help("save its meshes as Wavefront .obj, and name them in a scene file of your own")
}

/// `scn` without its number.
pub fn first_line_number(span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_FIRST_LINE, "the first line names no edition of the language")
        .label(span, "the edition belongs after `scn`")
        .help("write `scn 1 in m`")
        .mend("write `scn 1 in m`", span, "scn 1 in m")
}

/// An edition there is not.
pub fn edition(found: &str, span: Span) -> Diagnostic {
    let headline = format!("edition {found} of the language is not known");
    Diagnostic::error(Code::SYNTAX_EDITION, headline)
        .label(span, "this program reads edition 1 alone")
        .help("write `scn 1`, or use a newer version of this program")
        .mend("write `1`", span, "1")
}

/// A unit of the file that is no length.
pub fn file_unit(found: &str, span: Span) -> Diagnostic {
    let headline = match found {
        "" => "the unit of the file's coordinates is missing after `in`".to_string(),
        _ => format!("`{found}` is no length to count coordinates in"),
    };
    Diagnostic::error(Code::SYNTAX_FILE_UNIT, headline)
        .label(span, "the unit of bare coordinates in this file")
        .help("write a unit of length such as `m`, `cm`, `mm`, or a multiple: `scn 1 in 2.5 cm`")
}

/// Something stands where something else belongs.
pub fn unexpected(expected: &str, found: &str, span: Span) -> Diagnostic {
    let what = match found {
        "" => "nothing".to_string(),
        _ => format!("`{}`", clipped(found)),
    };
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, format!("expected {expected}, found {what}"))
        .label(span, format!("expected {expected}"))
}

/// An operator at the end of a line, after which the next item begins.
pub fn nothing_after(sign: &str, span: Span) -> Diagnostic {
    let headline = format!("a value is missing after this `{sign}`");
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, headline)
        .label(span, "nothing follows")
        .help(format!("write the value, or take the `{sign}` away"))
}

/// A comment of another language.
pub fn comment(found: &str, span: Span) -> Diagnostic {
    let found = found.chars().take(2).collect::<String>();
    let found = found.trim_end_matches(|c: char| c.is_alphanumeric());
    Diagnostic::error(
        Code::SYNTAX_COMMENT,
        format!("a comment begins with `//`, not with `{found}`"),
    )
    .label(Span { end: span.start + found.len() as u32, ..span }, "write `//`")
    .help("write `//` in front of each line of a comment")
}

/// A keyword where a name belongs.
pub fn keyword_as_name(word: &str, span: Span) -> Diagnostic {
    Diagnostic::error(
        Code::SYNTAX_KEYWORD_AS_NAME,
        format!("`{word}` is a word of the language, no name"),
    )
    .label(span, "a name belongs here")
    .help(format!("choose another name, or put it in quotes: `\"{word}\"`"))
    .mend("put it in quotes", span, format!("\"{word}\""))
}

/// `path:` and nothing after it.
pub fn missing_value(path: &str, span: Span) -> Diagnostic {
    let path = clipped(path);
    Diagnostic::error(Code::SYNTAX_MISSING_VALUE, format!("`{path}` has no value"))
        .label(span, "nothing that could be its value follows")
        .help(format!("write `{path}: value`"))
}

/// A path, a value, and no colon between them.
pub fn missing_colon(kind: &str, at: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_MISSING_COLON, format!("`:` is missing in this {kind}"))
        .label(at, "`:` belongs here")
        .why("Everything is said in one form: `word: value`, or `word name: value`.")
        .help("write `:` before the value")
        .safe_mend("write `:`", at, ":")
}

/// `=` for `:` or the other way round. `place`: with the blanks around it.
pub fn wrong_equals(found: char, span: Span, place: Span) -> Diagnostic {
    let (headline, right, written) = match found {
        '=' => ("a value follows `:`, not `=`", ":", ": "),
        _ => ("the value of a `let` follows `=`, not `:`", "=", " = "),
    };
    Diagnostic::error(Code::SYNTAX_COLON_OR_EQUALS, headline)
        .label(span, format!("write `{right}`"))
        .why("`let name = value` defines a name; `path: value` says something of the scene.")
        .help(format!("write `{right}`"))
        .safe_mend(format!("write `{right}`"), place, written)
}

/// Two items or fields on a line without a comma.
pub fn missing_separator(last: Span, next: Span, what: &str) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_MISSING_SEPARATOR, format!("nothing parts two {what}s"))
        .label(last.after(), format!("a comma or a new line belongs here, before the next {what}"))
        .label(next, format!("the next {what}"))
        .help("write `,`, or begin a new line")
        .safe_mend("write `,`", last.after(), ",")
}

/// A semicolon. `parted`: nothing follows that it would part, on its line.
pub fn semicolon(span: Span, parted: bool) -> Diagnostic {
    let fault = Diagnostic::error(Code::SYNTAX_UNEXPECTED, "a semicolon parts nothing here")
        .label(span, "take it away")
        .why("New lines or commas part items and fields.");
    match parted {
        true => {
            fault.help("take the semicolon away").safe_mend("take the semicolon away", span, "")
        }
        false => fault.help("begin a new line, or write `,`").safe_mend("write `,`", span, ","),
    }
}

/// A setup or a render without braces.
pub fn missing_body(found: &str, span: Span) -> Diagnostic {
    let found = clipped(found);
    Diagnostic::error(Code::SYNTAX_MISSING_BODY, format!("`{found}` has no braces"))
        .label(span, "`{ … }` belongs after it")
        .why("A setup or a render says in braces what it changes, even if it is nothing.")
        .help(format!("write `{found} {{}}`"))
        .safe_mend("write `{}`", span.after(), " {}")
}

/// A number the language writes differently.
pub fn number_form(found: &str, span: Span) -> Diagnostic {
    let right = match found.strip_suffix('.') {
        Some(whole) => whole.to_string(),
        None => format!("0{found}"),
    };
    Diagnostic::error(
        Code::SYNTAX_NUMBER_FORM,
        format!("`{found}` is no number: a digit is missing"),
    )
    .label(span, "a digit stands on both sides of the point")
    .help(format!("write `{right}`"))
    .safe_mend(format!("write `{right}`"), span, right)
}

/// `1,5`
pub fn decimal_comma(whole: &str, fraction: &str, span: Span) -> Diagnostic {
    let right = format!("{whole}.{fraction}");
    let headline = format!("`{whole},{fraction}` is no number: decimals follow a point");
    Diagnostic::error(Code::SYNTAX_NUMBER_FORM, headline)
        .label(span, "a decimal comma")
        .why("A comma parts items, fields and arguments.")
        .help(format!("write `{right}`"))
        .mend(format!("write `{right}`"), span, right)
}

/// A number beyond f64.
pub fn number_too_large(found: &str, span: Span) -> Diagnostic {
    let found = clipped(found);
    Diagnostic::error(Code::SYNTAX_NUMBER_TOO_LARGE, format!("`{found}` is too large for a number"))
        .label(span, "beyond 1.8e308")
        .help("write a smaller number, or a larger unit")
}

/// 12:75.
pub fn clock(found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_NUMBER_FORM, format!("`{found}` is no time of day"))
        .label(span, "hours go to 24, minutes to 59")
        .help("write a time such as `9:30`, or a number of hours such as `9.5 h`")
}

/// An exponent that is none.
pub fn exponent(found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_NUMBER_FORM, format!("`{}` is no exponent", clipped(found)))
        .label(span, "a whole number from -16 to 16 belongs here")
        .help("write a small whole exponent, as in `m^2`")
}

/// A backslash with something unknown.
pub fn bad_escape(found: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_BAD_ESCAPE, format!("`{found}` means nothing in a string"))
        .label(span, "not known")
        .why("A backslash begins `\\\"`, `\\\\`, `\\n` or `\\u{…}`.")
        .help("write `\\\\` for a backslash; folders in file names are parted by `/`")
        .mend("write `\\\\`", Span { end: span.start + 1, ..span }, "\\\\")
}

/// A brace in a string that is neither doubled nor matched.
pub fn lone_brace(found: char, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_INTERPOLATION, format!("a single `{found}` in a string"))
        .label(span, "its counterpart is missing")
        .why("Braces in a string hold a value: `\"day {hour}\"`.")
        .help(format!("write `{found}{found}` for a brace"))
        .mend(format!("write `{found}{found}`"), span, format!("{found}{found}"))
}

/// `{}` or `{((}` in a string.
pub fn interpolation(span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_INTERPOLATION, "the braces in this string hold no value")
        .label(span, "a value belongs here")
        .help("write a value such as `{hour}`, or `{{` and `}}` for braces")
}

/// A name that may not hold values.
pub fn fixed_name(span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_INTERPOLATION, "no value may stand in this name")
        .label(span, "a name as it is belongs here")
        .why("Only texts, the names of renders, bases and declarations may hold values.")
        .help("write the name itself")
}

/// `400 nm: 0.1` as a field.
pub fn number_key(found: &str, span: Span) -> Diagnostic {
    let headline = format!("`{found}` is no field: fields are words");
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, headline)
        .label(span, "expected a word")
        .help("write a field's word; wavelengths stand in `spectrum { … }` alone")
}

/// `material.albedo: …` inside a record.
pub fn path_in_record(key: &str, part: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_UNEXPECTED, "a record has fields, no paths into them")
        .label(span, "no path stands here")
        .why("A path changes a part of what a setup or the top level states.")
        .help(format!(
            "write `{key}: {{ {part}: … }}`, or the path on its own outside of the braces"
        ))
}

/// An item in a place it is not for.
pub fn misplaced(what: &str, place: &str, help: &str, span: Span) -> Diagnostic {
    Diagnostic::error(Code::SYNTAX_MISPLACED, format!("{what} stands {place}"))
        .label(span, format!("not {place}"))
        .help(help)
}

/// The beginning of a text, on one line.
pub fn clipped(text: &str) -> String {
    let line = text.lines().next().unwrap_or("").trim_end();
    match line.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", line[..end].trim_end()),
        None => line.to_string(),
    }
}
