//! The unit at the end of a quantity as written, and what should stand in its place.

use crate::math::units::{self, Dimension};

/// Where the unit that ends `text` begins: after a number, after `*`, or at the beginning. With
/// its dimension.
fn tail(text: &str) -> Option<(usize, Dimension)> {
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '%';
    let begins = text.char_indices().filter(|(at, c)| {
        let before = text[..*at].trim_end();
        let joined =
            text[..*at].ends_with(word) && !text[..*at].ends_with(|c: char| c.is_ascii_digit());
        let number = before.ends_with(|c: char| c.is_ascii_digit());
        word(*c) && !joined && (before.is_empty() || number || before.ends_with('*'))
    });
    begins.map(|(at, _)| at).find_map(|at| Some((at, dimension(&text[at..])?)))
}

/// The dimension of a text that is a unit and nothing else: `W/m^2/sr`.
fn dimension(text: &str) -> Option<Dimension> {
    let mut whole = Dimension::NONE;
    let mut rest = text.trim();
    let mut over = false;
    loop {
        let power = |c: char| c.is_ascii_digit() || c == '-';
        let length = rest.find(|c: char| !c.is_ascii_alphabetic() && c != '%');
        let (word, after) = rest.split_at(length.unwrap_or(rest.len()));
        let mut unit = units::find(word)?.dimension;
        rest = after.trim_start();
        if let Some(exponent) = rest.strip_prefix('^') {
            let exponent = exponent.trim_start();
            let (digits, after) =
                exponent.split_at(exponent.find(|c| !power(c)).unwrap_or(exponent.len()));
            unit = unit.power(digits.parse().ok()?);
            rest = after.trim_start();
        }
        whole = if over { whole.over(unit) } else { whole.times(unit) };
        match rest.chars().next() {
            None => return Some(whole),
            Some(operator @ ('*' | '/')) => {
                over = operator == '/';
                rest = rest[1..].trim_start();
            }
            Some(_) => return None,
        }
    }
}

/// The text of a quantity whose unit is that of `found` with one of `unit` in its place, "" for a
/// plain number. None if not the unit alone decides what it is.
pub fn replaced(text: &str, found: Dimension, unit: &str) -> Option<String> {
    let several = ["//", "\n", " + ", " - "].iter().any(|sign| text.contains(sign));
    if several || unit.starts_with('1') {
        return None;
    }
    let (at, dimension) = tail(text)?;
    if dimension != found {
        return None;
    }
    let before = text[..at].trim_end();
    match (unit, before) {
        ("", "") => Some("1".to_string()),
        ("", before) => Some(before.trim_end_matches('*').trim_end().to_string()),
        (unit, "") => Some(unit.to_string()),
        (unit, before) => Some(format!("{before} {unit}")),
    }
}

/// The text of a quantity in `found` divided by `divisor` and in `unit` in its place: a number to
/// three digits, a product as a quotient. None if not the unit alone decides what it is, or if it
/// is one with a prefix.
pub fn divided(text: &str, found: Dimension, divisor: f64, unit: &str) -> Option<String> {
    let (at, _) = tail(text)?;
    // Base units alone: with `cm` the number would not be the quantity's.
    let words =
        text[at..].split(|c: char| !c.is_ascii_alphabetic()).filter(|word| !word.is_empty());
    if words.filter_map(units::find).any(|unit| unit.scale != 1.0) {
        return None;
    }
    let replaced = replaced(text, found, unit)?;
    let before = replaced.strip_suffix(unit)?.trim_end();
    if let Ok(number) = before.replace('_', "").parse::<f64>() {
        let number: f64 = format!("{:.2e}", number / divisor).parse().ok()?;
        return Some(format!("{} {unit}", crate::lang::value::digits(number)));
    }
    let before = before.strip_suffix('*')?.trim_end();
    Some(format!("{before} / {divisor} * {unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_that_decides_is_replaced() {
        let length = Dimension::LENGTH;
        assert_eq!(replaced("35 m", length, "deg").unwrap(), "35 deg");
        assert_eq!(replaced("35m", length, "deg").unwrap(), "35 deg");
        assert_eq!(replaced("1_000.5e-3 m", length, "").unwrap(), "1_000.5e-3");
        assert_eq!(replaced("stops * 1 m", length, "ev").unwrap(), "stops * 1 ev");
        assert_eq!(replaced("m", length, "deg").unwrap(), "deg");
        assert_eq!(replaced("x * m", length, "").unwrap(), "x");
        let radiance = Dimension::RADIANCE;
        assert_eq!(replaced("3 W/m^2/sr", radiance, "W/m^2").unwrap(), "3 W/m^2");
        let colour = "rgb(1, 2 * 3, 4) * W / m ^ 2 / sr";
        assert_eq!(replaced(colour, radiance, "W/m^2").unwrap(), "rgb(1, 2 * 3, 4) * W/m^2");
        assert_eq!(replaced("2 m^-1", length.power(-1), "m").unwrap(), "2 m");
    }

    #[test]
    fn a_quantity_is_divided_as_it_is_written() {
        let [lx, nit] = ["lx", "nit"].map(|word| units::find(word).unwrap().dimension);
        let divided = |text, found| divided(text, found, 683.0, "W");
        assert_eq!(divided("500 nit", nit).unwrap(), "0.732 W");
        assert_eq!(divided("100_000 lx", lx).unwrap(), "146 W");
        assert_eq!(divided("1e-9 lm/m^2", lx).unwrap(), "1.46e-12 W");
        assert_eq!(divided("rgb(1, 2, 3) * nit", nit).unwrap(), "rgb(1, 2, 3) / 683 * W");
        for text in ["5 lm/cm^2", "bright", "2 * 250 nit", "1 nit + 2 nit"] {
            assert_eq!(divided(text, nit), None, "{text}");
            assert_eq!(divided(text, lx), None, "{text}");
        }
    }

    #[test]
    fn what_is_not_decided_by_its_unit_is_left_alone() {
        let length = Dimension::LENGTH;
        for text in ["size", "(1 m + 2 m) * 3", "am", "1 m + x", "x + 1 m", "", "é m x"] {
            assert_eq!(replaced(text, length, "deg"), None, "{text}");
        }
        assert_eq!(replaced("2 m * 3 m", length.power(2), "m"), None);
        assert_eq!(replaced("1 m", length, "1/m"), None);
    }
}
