//! Quantities that may vary with the wavelength: reflectances, radiances, indices of refraction.

use super::meant;
use super::quantities::{in_range, number};
use crate::lang::arithmetic;
use crate::lang::errors::{quantities, spectrum as errors, types};
use crate::lang::eval::Evaluator;
use crate::lang::spectra;
use crate::lang::value::{Value, ValueKind, shown};
use crate::math::Spectrum;
use crate::math::units::Dimension;
use crate::optics::{self, colour};
use crate::scene::schema::{Checked, Range};
use crate::scene::spectral::Spectral;

/// What is expected of a quantity.
pub fn expected(spectral: Spectral) -> String {
    let article = crate::lang::errors::with_article(spectral.word());
    format!("{article}: a number, a colour or a spectrum")
}

/// Whether a value is a list or a vector of three plain numbers.
fn three(value: &Value) -> Option<()> {
    let (ValueKind::List(all) | ValueKind::Vector { components: all, .. }) = &value.kind else {
        return None;
    };
    let plain = |it: &Value| {
        matches!(it.kind, ValueKind::Number { dimension: Dimension::NONE, unit: None, .. })
    };
    (all.len() == 3 && all.iter().all(plain)).then_some(())
}

/// A number, a colour or a spectrum of a quantity.
pub fn spectrum(
    ev: &Evaluator,
    value: &Value,
    spectral: Spectral,
    range: &Range,
    what: &str,
) -> Option<Checked> {
    let quantity = arithmetic::quantity(ev, value);
    let dimension = spectral.dimension();
    let found = match &quantity.kind {
        ValueKind::Broken => return None,
        ValueKind::Number { dimension, .. }
        | ValueKind::Colour(_, dimension)
        | ValueKind::Spectrum(_, dimension) => *dimension,
        _ => {
            let found = quantity.described();
            let told = types::mismatch(what, &expected(spectral), &found, value.span);
            let plain = spectral.dimension() == Dimension::NONE;
            ev.reports.tell(match three(&quantity).and_then(|()| meant::said(ev, value.span)) {
                Some(text) if plain => {
                    types::colour_meant(told, text.trim_matches(['[', '(', ')', ']']), value.span)
                }
                _ => told,
            });
            return None;
        }
    };
    let colour = matches!(quantity.kind, ValueKind::Colour(..));
    let landed = match spectra::spectrum(&quantity)? {
        same if found == dimension => same,
        // As bright as white of this much, spread over the width of the eye.
        density if Some(found) == spectral.density() && !colour => {
            let metres = colour::eye_width() * 1e-9;
            match density {
                // The same at every wavelength, which is not quite white.
                Spectrum::Constant(_) => Spectrum::Table(optics::tabulated(&density)?),
                other => other,
            }
            .scaled(metres)
        }
        Spectrum::Constant(_) if found == Dimension::NONE => {
            number(ev, &quantity, dimension, what)?;
            return None;
        }
        _ if found == Dimension::NONE => {
            ev.reports.tell(quantities::spectrum_without_unit(what, dimension, colour, value.span));
            return None;
        }
        _ => {
            let expected = crate::lang::errors::with_article(spectral.word());
            let told = quantities::dimension(what, &expected, &found.name(), value.span);
            let text = ev.written(value.span);
            let told = quantities::with_unit(told, text, found, (dimension, range), value.span);
            let whole = found.times(Dimension::SOLID_ANGLE);
            let lacking = whole == dimension || Some(whole) == spectral.density();
            ev.reports.tell(if lacking { quantities::lacks_solid_angle(told) } else { told });
            return None;
        }
    };
    within(ev, &quantity, &landed, &spectral.range(), dimension, what)?;
    within(ev, &quantity, &landed, range, dimension, what)?;
    Some(Checked::Spectrum(landed))
}

/// An index of refraction, real or complex.
pub fn index(ev: &Evaluator, value: &Value, range: &Range, what: &str) -> Option<Checked> {
    let quantity = arithmetic::quantity(ev, value);
    let (n, k) = match &quantity.kind {
        ValueKind::Broken => return None,
        ValueKind::Index { n, k } => (n.clone(), k.clone()),
        ValueKind::Number { dimension, .. }
        | ValueKind::Colour(_, dimension)
        | ValueKind::Spectrum(_, dimension) => {
            if *dimension != Dimension::NONE {
                let (expected, found) = ("an index of refraction", quantity.described());
                ev.reports.tell(quantities::dimension(what, expected, &found, value.span));
                return None;
            }
            (spectra::spectrum(&quantity)?, None)
        }
        _ => {
            let expected = "an index of refraction: a number, a spectrum, `complex(n, k)` or one from a shelf, such as `glass.bk7`";
            let told = types::mismatch(what, expected, &quantity.described(), value.span);
            ev.reports.tell(match &quantity.kind {
                ValueKind::Record(record) => match record.shelved {
                    Some(datum) => types::whole_medium(told, datum.word),
                    None => told,
                },
                _ => told,
            });
            return None;
        }
    };
    let real = match k {
        Some(_) => format!("the n of {what}"),
        None => what.to_string(),
    };
    let k = k.unwrap_or(Spectrum::Constant(0.0));
    within(ev, &quantity, &n, &Range::above(0.0), Dimension::NONE, &real)?;
    within(ev, &quantity, &n, range, Dimension::NONE, &real)?;
    let imaginary = format!("the k of {what}");
    within(ev, &quantity, &k, &Range::at_least(0.0), Dimension::NONE, &imaginary)?;
    Some(Checked::Index(n, k))
}

/// `complex(n, k)`: of numbers, colours and spectra, but not a colour and a spectrum.
pub fn complex(ev: &Evaluator, n: &Value, k: &Value) -> Option<ValueKind> {
    let part = |value: &Value, what: &str| -> Option<Spectrum> {
        let quantity = arithmetic::quantity(ev, value);
        match &quantity.kind {
            ValueKind::Broken => None,
            ValueKind::Index { n, k: None } => Some(n.clone()),
            ValueKind::Number { dimension: Dimension::NONE, .. }
            | ValueKind::Colour(_, Dimension::NONE)
            | ValueKind::Spectrum(_, Dimension::NONE) => spectra::spectrum(&quantity),
            _ => {
                let expected = "a plain number, a colour or a spectrum";
                let found = quantity.described();
                ev.reports.tell(types::mismatch(what, expected, &found, value.span));
                None
            }
        }
    };
    let first = part(n, "the first argument of `complex`");
    let second = part(k, "the second argument of `complex`");
    let (first, second) = (first?, second?);
    let varies = |s: &Spectrum| matches!(s, Spectrum::Table(_) | Spectrum::Formula { .. });
    let colour = |s: &Spectrum| matches!(s, Spectrum::Rgb(_));
    if varies(&first) && colour(&second) || colour(&first) && varies(&second) {
        let (colour, other) = if colour(&first) { (n, k) } else { (k, n) };
        ev.reports.tell(errors::mixed(colour.span, other.span));
        return None;
    }
    Some(ValueKind::Index { n: first, k: Some(second) })
}

/// Tells what leaves its bounds, and for a spectrum where.
fn within(
    ev: &Evaluator,
    value: &Value,
    spectrum: &Spectrum,
    range: &Range,
    dimension: Dimension,
    what: &str,
) -> Option<()> {
    if *range == Range::ANY {
        return Some(());
    }
    spectra::spend(ev, spectrum, value.span)?;
    let table = match spectrum {
        Spectrum::Constant(x) => return in_range(ev, value, *x, range, dimension, what),
        Spectrum::Rgb(components) => {
            return components
                .iter()
                .try_for_each(|x| in_range(ev, value, *x, range, dimension, what));
        }
        other => optics::tabulated(other)?,
    };
    let outside = table.nodes().iter().find(|(_, x)| !range.holds(*x));
    let Some((nm, x)) = outside.copied() else { return Some(()) };
    let show = |x: f64| shown(x, dimension, None);
    let found = format!("{} at {} nm", show(x), crate::lang::value::neat(nm));
    ev.reports.tell(types::out_of_range(what, &found, range, &show, value.span));
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, FileId};
    use crate::lang::check::{Checker, Declared};
    use crate::lang::parse;
    use crate::scene::schema::{Type, Vocabulary};
    use crate::scene::{Coefficient, Flux, Index};

    /// What a value becomes on a type, or the headline of the first fault, and its code.
    fn checked(text: &str, ty: Type) -> Result<Checked, (String, Code)> {
        let mut ev = Evaluator::default();
        let parsed = parse::value(text, FileId(0));
        assert!(parsed.faults.is_empty(), "{text}");
        let value = ev.eval(&parsed.tree, &ev.frame(None));
        let declared = Declared::new();
        let found = Checker::new(&ev, &declared).check(&value, &ty, &Range::ANY, "field");
        drop(value);
        found.ok_or_else(|| {
            let told = std::mem::take(&mut ev.reports).finish();
            (told[0].headline.clone(), told[0].code)
        })
    }

    fn fault(text: &str, ty: Type) -> String {
        checked(text, ty).expect_err(text).0
    }

    #[test]
    fn indices_are_real_or_complex() {
        let index = |text| Index::lower(&checked(text, Index::TYPE).expect(text));
        assert_eq!(index("1.5").n, Spectrum::Constant(1.5));
        assert_eq!(index("1.5").k, Spectrum::Constant(0.0));
        assert_eq!(index("rgb(0.2, 0.4, 1.4)").n, Spectrum::Rgb([0.2, 0.4, 1.4]));
        assert_eq!(index("complex(0.2, rgb(3, 2, 1))").k, Spectrum::Rgb([3.0, 2.0, 1.0]));
        assert!(matches!(index("spectrum { 400 nm: 1.5 }").n, Spectrum::Table(_)));
        assert!(matches!(index("glass.bk7").n, Spectrum::Formula { .. }));
        let gold = index("metal.gold");
        assert!(matches!((gold.n, gold.k), (Spectrum::Table(_), Spectrum::Table(_))));
        let own = index("sellmeier { b: [1.0, 0.5], c: [0.01 um^2, 100 um^2] }");
        let terms = vec![(1.0, 0.01), (0.5, 100.0)];
        assert_eq!(own.n, Spectrum::of(crate::math::Formula::Sellmeier(terms)));
        let own = index("cauchy { a: 1.5, b: 0.004 um^2, c: 0.0001 um^4 }");
        let terms = [1.5, 0.004, 0.0001];
        assert_eq!(own.n, Spectrum::of(crate::math::Formula::Cauchy(terms)));
        assert!(matches!(index("complex(glass.bk7, 0.1)").n, Spectrum::Formula { .. }));
    }

    #[test]
    fn indices_have_ranges_and_no_dimension() {
        for (text, headline) in [
            ("0", "`field` must be more than 0, and is 0"),
            ("complex(0, 1)", "the n of `field` must be more than 0, and is 0"),
            ("complex(1, -1)", "the k of `field` must be at least 0, and is -1"),
            (
                "complex(1, spectrum { 400 nm: 1, 500 nm: -1 })",
                "the k of `field` must be at least 0, and is -1 at 500 nm",
            ),
            ("1.5 m", "`field`: expected an index of refraction, found a length"),
            (
                "illuminant.a * W",
                "`field`: expected an index of refraction, found a power by wavelength",
            ),
            (
                "matter.marble",
                "`field`: expected an index of refraction: a number, a spectrum, `complex(n, k)` or one from a shelf, such as `glass.bk7`, found the medium `matter.marble`",
            ),
        ] {
            assert_eq!(fault(text, Index::TYPE), headline);
        }
        let mixed = checked("complex(rgb(1, 2, 3), metal_k)", Index::TYPE).unwrap_err();
        assert_eq!(mixed.1, Code::NAME_UNKNOWN_NAME);
        let mixed = checked("complex(rgb(1, 2, 3), paint.cornell_red)", Index::TYPE).unwrap_err();
        assert_eq!(mixed.1, Code::SPECTRUM_MIXED);
    }

    #[test]
    fn coefficients_are_of_a_length() {
        let coefficient =
            |text| Coefficient::lower(&checked(text, Coefficient::TYPE).expect(text)).0;
        assert_eq!(coefficient("3 / mm"), Spectrum::Constant(3000.0));
        assert_eq!(coefficient("rgb(1, 2, 3) / m"), Spectrum::Rgb([1.0, 2.0, 3.0]));
        assert!(matches!(coefficient("spectrum { 400 nm: 1 } / cm"), Spectrum::Table(_)));
        for (text, headline) in [
            ("3", "`field` is a coefficient per length: `3` needs a unit"),
            ("rgb(1, 2, 3)", "`field` is a coefficient per length: this colour needs a unit"),
            (
                "spectrum { 400 nm: 1 }",
                "`field` is a coefficient per length: this spectrum needs a unit",
            ),
            ("3 m", "`field`: expected a coefficient, found a length"),
            ("-1 / m", "`field` must be at least 0 1/m, and is -1 1/m"),
            (
                "metal.gold",
                "`field`: expected a coefficient: a number, a colour or a spectrum, found a complex index of refraction",
            ),
        ] {
            assert_eq!(fault(text, Coefficient::TYPE), headline);
        }
    }

    #[test]
    fn a_flux_may_be_spread_over_wavelengths() {
        let flux = |text| Flux::lower(&checked(text, Flux::TYPE).expect(text)).0;
        assert_eq!(flux("60 W"), Spectrum::Constant(60.0));
        let Spectrum::Table(table) = flux("illuminant.a * 1 W/nm") else { panic!() };
        let luminance = colour::xyz(&table)[1];
        assert!((luminance / colour::eye_width() - 1.0).abs() < 1e-12, "{luminance}");
        assert_eq!(fault("60 lm", Flux::TYPE), "`field`: expected a flux, found a luminous flux");
        assert_eq!(
            fault("rgb(1, 2, 3) * W/nm", Flux::TYPE),
            "`field`: expected a flux, found a spectral power"
        );
    }
}
