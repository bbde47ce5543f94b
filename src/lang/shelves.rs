//! Names with a dot: `metal.gold`, `illuminant.a`. What stands on the shelves is `data`'s.

use super::ast::Word;
use super::errors::name as names;
use super::eval::Evaluator;
use super::value::{Env, Value, ValueKind};
use crate::data::{Datum, Figures, Glass, SHELVES, Shelf, shelf};
use crate::diag::Span;
use crate::math::units::Dimension;
use crate::math::{Formula, Spectrum, Table};
use crate::optics::colour;

/// What a name with dots stands for; told if it stands for nothing.
pub fn named(ev: &Evaluator, path: &[Word], env: &Env, span: Span) -> Value {
    let [first, rest @ ..] = path else { return Value::broken(span) };
    let Some(shelf) = shelf(&first.text) else {
        let told = match env.find(&first.text) {
            Some(known) => names::dot_after_value(first, known.name.span, span),
            None => {
                let all: Vec<_> = SHELVES.iter().map(|shelf| shelf.word).collect();
                names::unknown_shelf(first, &all)
            }
        };
        ev.reports.tell_unknown(&first.text, told);
        return Value::broken(span);
    };
    let word = rest.iter().map(|word| &*word.text).collect::<Vec<_>>().join(".");
    match shelf.find(&word) {
        Some(datum) => Value { kind: value(datum), span },
        None => {
            let place = rest.iter().map(|word| word.span).reduce(Span::to).unwrap_or(span);
            let all: Vec<_> = shelf.data().map(|datum| datum.word).collect();
            ev.reports.tell(names::unknown_datum(shelf.word, &word, &all, place));
            Value::broken(span)
        }
    }
}

/// The data of a name without its shelf: how each is written, and what it is.
pub fn called(word: &str) -> Vec<(String, ValueKind)> {
    let found = |shelf: &'static Shelf| {
        let datum = shelf.find(word)?;
        Some((format!("{}.{word}", shelf.word), value(datum)))
    };
    SHELVES.iter().filter_map(found).collect()
}

fn value(datum: &'static Datum) -> ValueKind {
    let table = |nodes: Vec<(f64, f64)>| Table::new(nodes).expect("tested: wavelengths rise");
    match datum.figures {
        Figures::Metal(rows) => {
            let column = |i: usize| table(rows().iter().map(|row| (row[0], row[i])).collect());
            let (n, k) = (Spectrum::Table(column(1)), Spectrum::Table(column(2)));
            ValueKind::Index { n, k: Some(k) }
        }
        Figures::Glass(glass) => {
            let formula = match glass {
                Glass::Sellmeier(terms) => Formula::Sellmeier(terms.to_vec()),
                Glass::Series(terms) => Formula::Series(terms),
            };
            ValueKind::Index { n: Spectrum::of(formula), k: None }
        }
        Figures::Light(rows) => {
            let power = table(rows().iter().map(|row| (row[0], row[1])).collect());
            let [_, luminance, _] = colour::xyz(&power);
            let light = power.map(|power| power / luminance);
            ValueKind::Spectrum(Spectrum::Table(light), Dimension::NONE)
        }
        Figures::Reflectance(rows, column) => {
            let paint = table(rows().iter().map(|row| (row[0], row[column])).collect());
            ValueKind::Spectrum(Spectrum::Table(paint), Dimension::NONE)
        }
        Figures::Matter(_) | Figures::Water => ValueKind::Matter(datum),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics;

    #[test]
    fn every_datum_is_a_value() {
        for datum in SHELVES.iter().flat_map(|shelf| shelf.data()) {
            match value(datum) {
                ValueKind::Index { n, k } => {
                    let positive = |s: &Spectrum| optics::tabulated(s).unwrap().bounds().0 > 0.0;
                    assert!(positive(&n) && k.as_ref().is_none_or(positive), "{}", datum.word);
                }
                ValueKind::Spectrum(spectrum, _) => {
                    assert!(optics::tabulated(&spectrum).unwrap().bounds().0 >= 0.0);
                }
                ValueKind::Matter(_) => {}
                other => panic!("{}: {other:?}", datum.word),
            }
        }
    }

    #[test]
    fn lights_have_a_luminance_of_one() {
        for datum in shelf("illuminant").unwrap().data() {
            let ValueKind::Spectrum(light, _) = value(datum) else { panic!("{}", datum.word) };
            let rgb = colour::emitted(&light);
            assert!((colour::luminance(rgb) - 1.0).abs() < 1e-12, "{}: {rgb:?}", datum.word);
        }
    }
}
