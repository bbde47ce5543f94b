//! Names with a dot: `metal.gold`, `illuminant.a`. What stands on the shelves is `data`'s.

use std::rc::Rc;

use super::ast::Word;
use super::errors::name as names;
use super::eval::Evaluator;
use super::value::{Env, FieldValue, RecordValue, Thunk, Value, ValueKind};
use crate::data::{Datum, Figures, Glass, Matter, SHELVES, Shelf, shelf, water};
use crate::diag::Span;
use crate::math::units::Dimension;
use crate::math::{Formula, Spectrum, Table};
use crate::optics::{self, colour};
use crate::scene::MEASURED;
use crate::scene::spectral::Spectral;

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
        Some(datum) => Value { kind: value(datum, span), span },
        None => {
            let place = rest.iter().map(|word| word.span).reduce(Span::to).unwrap_or(span);
            let all: Vec<_> = shelf.data().map(|datum| datum.word).collect();
            ev.reports.tell(names::unknown_datum(shelf.word, &word, &all, place));
            Value::broken(span)
        }
    }
}

/// Whether a name with dots is that of a medium.
pub fn is_matter(path: &[Word]) -> bool {
    let [first, word] = path else { return false };
    let datum = shelf(&first.text).and_then(|shelf| shelf.find(&word.text));
    datum.is_some_and(|datum| matches!(datum.figures, Figures::Matter(_) | Figures::Water))
}

/// The data of a name without its shelf: how each is written, and what it is.
pub fn called(word: &str, span: Span) -> Vec<(String, ValueKind)> {
    let found = |shelf: &'static Shelf| {
        let datum = shelf.find(word)?;
        Some((format!("{}.{word}", shelf.word), value(datum, span)))
    };
    SHELVES.iter().filter_map(found).collect()
}

fn table(nodes: Vec<(f64, f64)>) -> Table {
    Table::new(nodes).expect("tested: wavelengths rise")
}

/// What a datum named at `span` is.
fn value(datum: &'static Datum, span: Span) -> ValueKind {
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
        Figures::Matter(matter) => {
            let per_metre = |of: [f64; 3]| ValueKind::Colour(of.map(|x| x * 1e3), coefficient());
            let index =
                ValueKind::Number { value: matter.index, dimension: Dimension::NONE, unit: None };
            let (absorption, scattering) =
                (per_metre(matter.absorption), per_metre(matter.scattering));
            medium(datum, index, absorption, Some((scattering, cosine(&matter))), span)
        }
        Figures::Water => {
            let (all, step) = WATER_NM;
            let nodes = all.step_by(step).map(f64::from);
            let nodes = nodes.map(|nm| (nm, optics::water::index(nm, CELSIUS, 0.0)));
            let index = Spectrum::Table(table(nodes.collect()));
            let rows = water::absorption().iter().map(|row| (row[0], row[1]));
            let absorption = Spectrum::Table(table(rows.collect()));
            let absorption = ValueKind::Spectrum(absorption, coefficient());
            medium(datum, ValueKind::Spectrum(index, Dimension::NONE), absorption, None, span)
        }
    }
}

/// How warm the water of the shelf is.
const CELSIUS: f64 = 20.0;

/// Wavelengths in nm at which the index of water is taken; between them it is all but straight.
const WATER_NM: (std::ops::RangeInclusive<u32>, usize) = (380..=800, 10);

fn coefficient() -> Dimension {
    Spectral::Coefficient.dimension()
}

/// One mean cosine for three bands, by how much each scatters. A band that scatters too little for
/// a measurement has none.
fn cosine(matter: &Matter) -> f64 {
    let turned = matter.scattering.iter().zip(matter.asymmetry).filter(|(_, g)| *g != 0.0);
    let (sum, all) = turned.fold((0.0, 0.0), |(sum, all), (s, g)| (sum + s * g, all + s));
    if all > 0.0 { sum / all } else { 0.0 }
}

/// A medium, as if it were written where its name stands. `scattering`: the coefficient, and the
/// mean cosine.
fn medium(
    datum: &'static Datum,
    index: ValueKind,
    absorption: ValueKind,
    scattering: Option<(ValueKind, f64)>,
    span: Span,
) -> ValueKind {
    let word = |text: &str| Word { text: text.into(), span };
    let field = |key: &str, kind: ValueKind| FieldValue {
        key: word(key),
        quantity: None,
        value: Thunk::Ready(Value { kind, span }),
    };
    let record = |name: &str, fields, shelved| {
        let (word, braces) = (Some(word(name)), span);
        let record = RecordValue { word, base: None, fields, braces, partial: false, shelved };
        ValueKind::Record(Rc::new(record))
    };
    let mut fields = vec![field(MEASURED.ior, index), field(MEASURED.absorption, absorption)];
    if let Some((scattering, cosine)) = scattering {
        fields.push(field(MEASURED.scattering, scattering));
        if cosine != 0.0 {
            let cosine =
                ValueKind::Number { value: cosine, dimension: Dimension::NONE, unit: None };
            let turned = record(MEASURED.turned, vec![field(MEASURED.cosine, cosine)], None);
            fields.push(field(MEASURED.phase, turned));
        }
    }
    record(MEASURED.medium, fields, Some(datum))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::FileId;

    #[test]
    fn every_datum_is_a_value() {
        for datum in SHELVES.iter().flat_map(|shelf| shelf.data()) {
            match value(datum, Span::new(FileId(0), 0, 0)) {
                ValueKind::Index { n, k } => {
                    let positive = |s: &Spectrum| optics::tabulated(s).unwrap().bounds().0 > 0.0;
                    assert!(positive(&n) && k.as_ref().is_none_or(positive), "{}", datum.word);
                }
                ValueKind::Spectrum(spectrum, _) => {
                    assert!(optics::tabulated(&spectrum).unwrap().bounds().0 >= 0.0);
                }
                ValueKind::Record(_) => {}
                other => panic!("{}: {other:?}", datum.word),
            }
        }
    }

    #[test]
    fn lights_have_a_luminance_of_one() {
        for datum in shelf("illuminant").unwrap().data() {
            let ValueKind::Spectrum(light, _) = value(datum, Span::new(FileId(0), 0, 0)) else {
                panic!("{}", datum.word)
            };
            let rgb = colour::emitted(&light);
            assert!((colour::luminance(rgb) - 1.0).abs() < 1e-12, "{}: {rgb:?}", datum.word);
        }
    }
}
