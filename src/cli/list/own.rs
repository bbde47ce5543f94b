//! The words of the language itself: keywords, functions, units, and a number; beside them, in
//! the overview, spectra.

use super::types::{self, tidy};
use super::{block, spectra, strong};
use crate::diag::print::Look;
use crate::lang::words::{FUNCTIONS, Function, KEYWORDS, Keyword, PI};
use crate::math::units::{self, UNITS, Unit};

/// What the number with a name is.
pub const PI_DOC: &str = "The number 3.14159…: `irradiance: pi * W/m^2`.";

/// What luminous units are for.
pub const LUMINOUS_DOC: &str = "No field takes luminous units yet: lights are given in watts, and 1 W/m^2/sr in a scene is seen as 683 nit. Divide by 683.";

/// Numbers below this are shown as powers of ten.
const SMALL: f64 = 1e-3;

/// Every one of them.
pub fn words() -> impl Iterator<Item = &'static str> {
    let keywords = KEYWORDS.iter().map(|keyword| keyword.word);
    let functions = FUNCTIONS.iter().map(|function| function.word);
    let units = UNITS.iter().map(|unit| unit.word);
    keywords.chain(functions).chain([PI]).chain(spectra::words()).chain(units)
}

/// What the word is, if it is one of them.
pub fn page(word: &str, look: Look) -> Option<String> {
    if let Some(keyword) = KEYWORDS.iter().find(|keyword| keyword.word == word) {
        return Some(one(keyword, look));
    }
    if let Some(function) = FUNCTIONS.iter().find(|function| function.word == word) {
        return Some(call(function, look));
    }
    if word == PI {
        return Some(entry(PI, PI_DOC, look));
    }
    units::find(word).map(|unit| measure(unit, look))
}

/// All of them but the units, a line each.
pub fn overview(look: Look) -> String {
    let mut text = String::from("\nThe language's own words:\n");
    let width = words().map(str::len).max().unwrap_or(0);
    let row = |word, form: &str| format!("  {}  {form}\n", strong(word, width, look));
    text.extend(KEYWORDS.iter().map(|keyword| row(keyword.word, keyword.form)));
    text.extend(FUNCTIONS.iter().map(|function| row(function.word, &forms(function))));
    text.push_str(&row(PI, "the number 3.14159…"));
    text.extend(spectra::rows().iter().map(|(word, form)| row(word, form)));
    text + &row("units", "`scn list units` shows them")
        + &row("types", "`scn list types` shows them")
}

pub fn keywords(look: Look) -> String {
    KEYWORDS.iter().map(|keyword| one(keyword, look)).collect::<Vec<_>>().join("\n")
}

pub fn functions(look: Look) -> String {
    FUNCTIONS.iter().map(|function| call(function, look)).collect::<Vec<_>>().join("\n")
}

/// Units, those of one dimension in a line.
pub fn units(look: Look) -> String {
    let mut text = String::from("Units. A unit follows its number: `550 mm`, `9 W/m^2/sr`.\n\n");
    let mut rest = UNITS;
    while let Some(first) = rest.first() {
        let same = rest.iter().take_while(|unit| unit.dimension == first.dimension).count();
        let words: Vec<_> = rest[..same].iter().map(|unit| unit.word).collect();
        let what = types::bare(first.dimension);
        text.push_str(&format!("  {}  {what}\n", strong(&words.join(" "), 20, look)));
        rest = &rest[same..];
    }
    text.push('\n');
    text + &block(LUMINOUS_DOC, "", look)
}

fn one(keyword: &Keyword, look: Look) -> String {
    entry(keyword.form, keyword.doc, look)
}

fn call(function: &Function, look: Look) -> String {
    entry(&forms(function), function.doc, look)
}

/// How a function is called, in all its ways.
pub fn forms(function: &Function) -> String {
    let form = |params: &&[&str]| format!("{}({})", function.word, params.join(", "));
    function.params.iter().map(form).collect::<Vec<_>>().join(" or ")
}

fn measure(unit: &Unit, look: Look) -> String {
    let base = unit.dimension.unit();
    let what = unit.dimension.name();
    let mut doc = match base.is_empty() {
        true => "A unit of plain numbers.".to_string(),
        false => format!("A unit; it measures {what}."),
    };
    if base != unit.word {
        doc.push_str(&format!(" 1 {} is {}.", unit.word, worth(unit)));
    }
    entry(unit.word, &doc, look)
}

/// A unit in base units: `0.01 m`.
pub fn worth(unit: &Unit) -> String {
    let scale = match unit.scale {
        small if small < SMALL => format!("{small:e}"),
        scale => tidy(&scale.to_string()),
    };
    format!("{scale} {}", unit.dimension.unit()).trim_end().to_string()
}

fn entry(heading: &str, doc: &str, look: Look) -> String {
    format!("{}\n{}", strong(heading, 0, look), block(doc, "  ", look))
}
