//! Spectra in lists: quantities, the records that state them, and what stands on the shelves.

use super::{block, fields, strong};
use crate::data::{Datum, Figures, SHELVES, Shelf};
use crate::diag::print::Look;
use crate::scene::schema::{Bound, Record};
use crate::scene::spectral::{INDEX_DOC, RECORDS, Spectral};

/// The word of the type of indices.
pub const INDEX: &str = "index";

/// Records and shelves.
pub fn words() -> impl Iterator<Item = &'static str> {
    RECORDS.iter().map(|record| record.word).chain(SHELVES.iter().map(|shelf| shelf.word))
}

/// Everything else that has a page: quantities, and what is on the shelves.
pub fn further_words() -> impl Iterator<Item = &'static str> {
    let quantities = Spectral::ALL.iter().map(|spectral| spectral.word()).chain([INDEX]);
    quantities.chain(SHELVES.iter().flat_map(Shelf::data).map(|datum| datum.word))
}

/// What the word means after these; None if it means nothing here.
pub fn page(word: &str, places: &[&str], look: Look) -> Option<String> {
    let mut pages = Vec::new();
    if places.is_empty() {
        pages.extend(RECORDS.iter().filter(|r| r.word == word).map(|r| record(r, look)));
        pages.extend(SHELVES.iter().filter(|s| s.word == word).map(|s| shelf(s, look)));
        let quantities = Spectral::ALL.iter().filter(|s| s.word() == word);
        pages.extend(quantities.map(|spectral| quantity(*spectral, look)));
        pages.extend((word == INDEX).then(|| index(look)));
    }
    let shelves = SHELVES
        .iter()
        .filter(|s| matches!(places, [] | [_]) && places.iter().all(|p| *p == s.word));
    for shelf in shelves {
        pages.extend(shelf.find(word).map(|found| datum(shelf, found, look)));
    }
    (!pages.is_empty()).then(|| pages.join("\n"))
}

/// Rows of the overview: each word, and how it is written.
pub fn rows() -> Vec<(&'static str, String)> {
    let record = |record: &&Record| {
        let form = match record.fields {
            [] => format!("{} {{ WAVELENGTH: VALUE, … }}", record.word),
            fields => {
                let words: Vec<_> =
                    fields.iter().map(|field| format!("{}: …", field.word)).collect();
                format!("{} {{ {} }}", record.word, words.join(", "))
            }
        };
        (record.word, form)
    };
    let shelf = |shelf: &Shelf| {
        let first = shelf.data().next().map_or("…", |datum| datum.word);
        (shelf.word, format!("{}.{first}, and others: `scn list {}`", shelf.word, shelf.word))
    };
    RECORDS.iter().map(record).chain(SHELVES.iter().map(shelf)).collect()
}

/// All shelves with what stands on them.
pub fn shelves(look: Look) -> String {
    SHELVES.iter().map(|one| shelf(one, look)).collect::<Vec<_>>().join("\n")
}

/// All quantities that may vary with the wavelength.
pub fn quantities(look: Look) -> String {
    let all = Spectral::ALL.iter().map(|spectral| quantity(*spectral, look));
    all.chain([index(look)]).collect::<Vec<_>>().join("\n")
}

fn quantity(spectral: Spectral, look: Look) -> String {
    entry(spectral.word(), &quantity_doc(spectral), look)
}

/// What a quantity is, what states it, its unit and its range.
pub fn quantity_doc(spectral: Spectral) -> String {
    let unit = match spectral.dimension().unit() {
        unit if unit.is_empty() => "It has no unit".to_string(),
        unit => format!("In {unit}"),
    };
    let low = match spectral.range().low {
        Bound::Inclusive(low) => format!("; {low} or more at every wavelength"),
        _ => String::new(),
    };
    let density = spectral.density().map_or(String::new(), |density| {
        format!(
            " {} in {} stands for it as well.",
            capital(&density.name()),
            spectral.dimension().unit() + "/nm"
        )
    });
    format!("{} A number, a colour or a spectrum. {unit}{low}.{density}", spectral.doc())
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |c| c.to_uppercase().chain(chars).collect())
}

fn index(look: Look) -> String {
    entry(INDEX, &index_doc(), look)
}

/// The same of an index of refraction.
pub fn index_doc() -> String {
    format!(
        "{INDEX_DOC} A number, a colour, a spectrum, a formula, `complex(n, k)`, or one from the shelves `glass` and `metal`."
    )
}

fn record(record: &Record, look: Look) -> String {
    entry(&record_form(record), record.doc, look) + &fields(record, look)
}

/// How a record of a spectrum is written.
pub fn record_form(record: &Record) -> String {
    match record.fields {
        [] => format!("{} {{ WAVELENGTH: VALUE, … }}", record.word),
        _ => format!("{} {{ … }}", record.word),
    }
}

fn shelf(shelf: &Shelf, look: Look) -> String {
    let mut text = entry(shelf.word, shelf.doc, look);
    let width = shelf.data().map(|datum| datum.word.len()).max().unwrap_or(0);
    let mut sources: Vec<&str> = Vec::new();
    for datum in shelf.data() {
        if !sources.contains(&datum.source) {
            sources.push(datum.source);
        }
    }
    for source in sources {
        text.push_str(&format!("\n{}", block(source, "    ", look)));
        for datum in shelf.data().filter(|datum| datum.source == source) {
            let margin = " ".repeat(width + 8);
            let mut lines = block(datum.doc, &margin, look);
            let word = format!("      {}  ", strong(datum.word, width, look));
            lines.replace_range(..margin.len(), &word);
            text.push_str(&lines);
        }
    }
    text
}

fn datum(shelf: &Shelf, datum: &Datum, look: Look) -> String {
    let what = match datum.figures {
        Figures::Metal(_) => "A complex index of refraction by wavelength.",
        Figures::Glass(_) => "An index of refraction by a formula.",
        Figures::Light(_) => "A light by wavelength, of luminance 1, without a unit.",
        Figures::Reflectance(..) => "A reflectance by wavelength.",
        Figures::Matter(_) | Figures::Water => "A medium.",
    };
    let name = format!("{}.{}", shelf.word, datum.word);
    entry(&name, &format!("{} {what}", datum.doc), look)
        + &block(&format!("Source: {}.", datum.source), "  ", look)
}

fn entry(heading: &str, doc: &str, look: Look) -> String {
    format!("{}\n{}", strong(heading, 0, look), block(doc, "  ", look))
}
