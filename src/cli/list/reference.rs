//! The whole language as one page in Markdown: docs/reference.md. A test fails when that file is
//! not what this makes.

use super::spectra::{index_doc, quantity_doc, record_form};
use super::{flow, item_form, own, spectra, types};
use crate::data::{SHELVES, Shelf};
use crate::lang::words::{FUNCTIONS, KEYWORDS, PI};
use crate::math::units::{Dimension, UNITS};
use crate::scene::KINDS;
use crate::scene::schema::{Field, Kind, Record, Type, Variants};
use crate::scene::spectral::{RECORDS, Spectral};

const HEAD: &str = "\
# Reference

Every word of the language. This page is written by `scn list --format markdown` from what the
checker itself reads; `scn list WORD` shows a part of it. What the words are put together by stands
in [language.md](language.md). Names in brackets, such as [Jakob19], lead to
[references.bib](references.bib).
";

/// Where [language.md](language.md) tells of points, directions and colours.
const NUMBERS: &str = "language.md#numbers-and-units";

/// The page.
pub fn page() -> String {
    let mut text = String::from(HEAD);
    for named in [false, true] {
        let links: Vec<_> = kinds(named).map(|kind| link(kind.word, kind.word)).collect();
        let which = if named { "Many, each with a name" } else { "One for each picture" };
        text.push_str(&format!("\n- {which}: {}", links.join(", ")));
    }
    text.push_str(
        "\n- [Quantities](#quantities), [units](#units), [spectra](#spectra), \
         [shelves](#shelves), [functions](#functions), [keywords](#keywords)\n",
    );
    text.extend(kinds(false).chain(kinds(true)).map(kind));
    text + &quantities() + &units() + &records() + &shelves() + &functions() + &keywords()
}

fn kinds(named: bool) -> impl Iterator<Item = &'static Kind> {
    KINDS.iter().filter(move |kind| kind.named == named)
}

fn kind(kind: &Kind) -> String {
    let mut text = section(2, kind.word, &format!("`{}`", item_form(kind)));
    text.push_str(&format!("\n{}", flow(kind.doc)));
    match kind.default.map(types::tidy) {
        Some(default) if default != "{}" => text.push_str(&format!(" Default: `{default}`.")),
        None if !kind.optional => text.push_str(" It must be given."),
        _ => {}
    }
    text.push('\n');
    match kind.ty {
        Type::OneOf(variants) => text + &choice(variants),
        Type::Record(record) => text + &fields(record),
        _ => text,
    }
}

/// A section for each variant.
fn choice(variants: &Variants) -> String {
    let one = |record: &Record| {
        let heading = format!("{} {}", variants.name, record.word);
        section(3, &heading, &flow(record.doc)) + &fields(record)
    };
    variants.all.iter().map(one).collect()
}

/// A table of the fields, and below it what may be chosen in them.
fn fields(record: &Record) -> String {
    let row = |field: &Field| {
        let default = match field.default {
            Some(default) => format!("`{}`", types::tidy(default)),
            None => types::without_default(field).to_string(),
        };
        let range = types::range(field).unwrap_or_default();
        let word = format!("`{}`", field.word);
        [word, form(field.ty), range, default, flow(field.doc)]
    };
    let mut text = match record.fields {
        [] => "\nIt has no fields.\n".to_string(),
        all => table(["field", "type", "range", "default", "what it is"], all.iter().map(row)),
    };
    for field in record.fields {
        match field.ty {
            Type::Words(words) | Type::CountOr(words) | Type::Paths(Some(words)) => {
                text.push('\n');
                let one = |(word, doc): &(&str, &str)| {
                    format!("- `{}: {word}`: {}\n", field.word, flow(doc))
                };
                text.extend(words.all.iter().map(one));
            }
            Type::OneOf(variants) => {
                text.push_str(&section(3, variants.name, &flow(variants.doc)));
                text.push_str(&choice(variants));
            }
            Type::Record(inner) => {
                text.push_str(&section(3, field.word, &flow(inner.doc)));
                text.push_str(&fields(inner));
            }
            _ => {}
        }
    }
    text
}

/// What may stand in a place, with a link to where that is told.
fn form(ty: Type) -> String {
    let mut told = ty;
    while let Type::List(inner) | Type::Map(inner) = told {
        told = *inner;
    }
    let (word, target) = match told {
        Type::Number(Dimension::NONE) => return types::form(ty),
        Type::Number(dimension) => (types::bare(dimension), "#units".to_string()),
        Type::Point => ("point".to_string(), NUMBERS.to_string()),
        Type::Direction => ("direction".to_string(), NUMBERS.to_string()),
        Type::Step => ("scale(…), rotate(…) or move(…)".to_string(), "#functions".to_string()),
        Type::Spectrum(of) | Type::Textured { of, .. } => {
            (of.word().to_string(), anchor(of.word()))
        }
        Type::Index => ("index".to_string(), anchor(spectra::INDEX)),
        Type::OneOf(variants) => (variants.name.to_string(), anchor(variants.name)),
        Type::Reference { kind, .. } => (kind.to_string(), anchor(kind)),
        _ => return types::form(ty),
    };
    types::form(ty).replacen(&word, &format!("[{word}]({target})"), 1)
}

fn quantities() -> String {
    let mut text = section(2, "Quantities", "What may vary with the wavelength.");
    let one = |spectral: &Spectral| section(3, spectral.word(), &quantity_doc(*spectral));
    text.extend(Spectral::ALL.iter().map(one));
    text + &section(3, spectra::INDEX, &index_doc())
}

fn units() -> String {
    let row = |unit: &crate::math::units::Unit| {
        let what = types::bare(unit.dimension);
        [format!("`{}`", unit.word), what, own::worth(unit)]
    };
    let intro = "A unit follows its number: `550 mm`, `9 W/m^2/sr`.";
    section(2, "Units", &format!("{intro} {}", own::LUMINOUS_DOC))
        + &table(["unit", "of", "worth"], UNITS.iter().map(row))
}

fn records() -> String {
    let intro = "Records that state a spectrum. [language.md](language.md#spectra) shows them at \
                 work; functions that give one stand [below](#functions).";
    let mut text = section(2, "Spectra", intro);
    for record in RECORDS {
        text.push_str(&section(3, record.word, &format!("`{}`", record_form(record))));
        text.push_str(&format!("\n{}\n", flow(record.doc)));
        if !record.fields.is_empty() {
            text.push_str(&fields(record));
        }
    }
    text
}

fn shelves() -> String {
    let intro = "What others have measured, each with its source: `metal.gold`.";
    let one = |shelf: &Shelf| {
        let row = |datum: &crate::data::Datum| {
            let word = format!("`{}.{}`", shelf.word, datum.word);
            [word, datum.doc.to_string(), datum.source.to_string()]
        };
        section(3, shelf.word, shelf.doc)
            + &table(["word", "what", "source"], shelf.data().map(row))
    };
    section(2, "Shelves", intro) + &SHELVES.iter().map(one).collect::<String>()
}

fn functions() -> String {
    let forms = |forms: String| format!("`{}`", forms.replace(" or ", "` or `"));
    let rows = FUNCTIONS.iter().map(|f| [forms(own::forms(f)), f.doc.to_string()]);
    let rows = rows.chain([[format!("`{PI}`"), own::PI_DOC.to_string()]]);
    let intro = "Those of the language itself; `let` defines others.";
    section(2, "Functions", intro) + &table(["written", "what it gives"], rows)
}

fn keywords() -> String {
    let forms = |form: &str| format!("`{}`", form.replace(", or ", "` or `"));
    let row = KEYWORDS.iter().map(|k| [format!("`{}`", k.word), forms(k.form), k.doc.to_string()]);
    let intro = "Words of the grammar; none can be a name.";
    section(2, "Keywords", intro) + &table(["word", "written", "what it does"], row)
}

/// A heading of a level with a paragraph.
fn section(level: usize, heading: &str, paragraph: &str) -> String {
    format!("\n{} {heading}\n\n{paragraph}\n", "#".repeat(level))
}

/// A table; bars within its cells are kept from parting them.
fn table<const N: usize>(head: [&str; N], rows: impl Iterator<Item = [String; N]>) -> String {
    let line = |cells: [String; N]| {
        format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | "))
    };
    let head = line(head.map(str::to_string));
    let rule = format!("|{}\n", " --- |".repeat(N));
    format!("\n{head}{rule}{}", rows.map(line).collect::<String>())
}

fn link(text: &str, heading: &str) -> String {
    format!("[{text}]({})", anchor(heading))
}

/// Where a heading is found on the page.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    let kept: String = kept.flat_map(char::to_lowercase).collect();
    format!("#{}", kept.replace(' ', "-"))
}

#[cfg(test)]
mod tests {
    use super::super::entries::entries;
    use super::*;

    #[test]
    fn every_word_is_told_and_every_link_leads_to_one_heading() {
        let page = page();
        for word in entries().iter().map(|entry| entry.word()).chain(own::words()) {
            assert!(page.contains(word), "{word}");
        }
        for shelf in SHELVES {
            for datum in shelf.data() {
                let row = format!(
                    "| `{}.{}` | {} | {} |",
                    shelf.word, datum.word, datum.doc, datum.source
                );
                assert!(page.contains(&row), "{row}");
            }
        }
        let headings: Vec<_> =
            page.lines().filter_map(|l| l.trim_start_matches('#').strip_prefix(' ')).collect();
        let links: Vec<_> =
            page.split("](#").skip(1).filter_map(|rest| rest.split(')').next()).collect();
        assert!(links.len() > 40, "{}", links.len());
        for link in links {
            let found = headings.iter().filter(|h| anchor(h) == format!("#{link}"));
            assert_eq!(found.count(), 1, "{link}");
        }
    }

    #[test]
    fn fields_tell_type_range_and_default() {
        let page = page();
        for row in [
            "| `fov_y` | [angle](#units) | 1e-9 deg or more, below 180 deg | must be given | Vertical",
            "| `material` | the name of a [material](#material), or a material itself |  | may be",
            "[reflectance](#reflectance): number, colour or spectrum | 0 or more |",
            "| `nm` | length | 1e-9 m |",
        ] {
            assert!(page.contains(row), "{row}");
        }
    }

    #[test]
    fn bars_do_not_part_a_cell() {
        let text = table(["a", "b"], [["x | y".to_string(), String::new()]].into_iter());
        assert_eq!(text, "\n| a | b |\n| --- | --- |\n| x \\| y |  |\n");
    }
}
