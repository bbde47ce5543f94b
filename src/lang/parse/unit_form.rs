//! Units in forms of handwriting and of other languages, `W/m²/sr`, `W/(m^2 sr)`, `W m^-2`, as
//! they are written here: `W/m^2/sr`.

use crate::math::units;

/// The quantity around a place where the grammar stopped, between `before` and `after` on its line,
/// written rightly; None if it is no number with units.
pub fn written(before: &str, after: &str) -> Option<String> {
    let first = before.rsplit([':', '=', ',', '{']).next()?.trim_start();
    let mut depth = 0;
    let end = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        matches!(c, ',' | '}' | ']') || depth < 0
    };
    let whole = format!("{first}{}{after}", if after.starts_with(' ') { "" } else { " " });
    let whole = &whole[..whole.find(end).unwrap_or(whole.len())];
    let whole = whole.split("//").next()?.trim();
    let number = whole.find(|c: char| !c.is_ascii_digit() && !"._+-".contains(c))?;
    let (number, unit) = whole.split_at(number);
    number.replace('_', "").parse::<f64>().ok()?;
    let mut parts = Vec::new();
    let mut reader = Reader { rest: unit.trim() };
    reader.product(1, &mut parts)?;
    if !reader.rest.is_empty() || parts.is_empty() {
        return None;
    }
    let power = |exponent: i32| match exponent {
        1 => String::new(),
        exponent => format!("^{exponent}"),
    };
    let above = parts.iter().filter(|(_, exponent)| *exponent > 0);
    let above: Vec<_> =
        above.map(|(unit, exponent)| format!("{unit}{}", power(*exponent))).collect();
    let below = parts.iter().filter(|(_, exponent)| *exponent < 0);
    let below: String =
        below.map(|(unit, exponent)| format!("/{unit}{}", power(-exponent))).collect();
    let between = if above.is_empty() { "" } else { " " };
    Some(format!("{number}{between}{}{below}", above.join(" * ")))
}

/// What is left of the text of units.
struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// Factors, each with its exponent times `sign`, up to a `)` or the end.
    fn product(&mut self, sign: i32, parts: &mut Vec<(&'a str, i32)>) -> Option<()> {
        let mut over = false;
        loop {
            self.rest = self.rest.trim_start();
            let Some(c) = self.rest.chars().next().filter(|c| *c != ')') else { return Some(()) };
            if matches!(c, '/' | '*' | '·' | '⋅') {
                over = c == '/';
                self.rest = &self.rest[c.len_utf8()..];
                continue;
            }
            let sign = if over { -sign } else { sign };
            over = false;
            if c == '(' {
                self.rest = &self.rest[1..];
                self.product(sign, parts)?;
                self.rest = self.rest.strip_prefix(')')?;
                continue;
            }
            let end = self.rest.find(|c: char| !c.is_ascii_alphabetic());
            let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
            units::find(word)?;
            self.rest = rest.trim_start();
            parts.push((word, sign * self.exponent()?));
        }
    }

    /// An exponent: after `^`, as a small digit, or none, which is 1.
    fn exponent(&mut self) -> Option<i32> {
        const SMALL: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        let minus = if self.rest.starts_with('⁻') { -1 } else { 1 };
        let after = self.rest.trim_start_matches('⁻');
        if let Some(c) = after.chars().next().filter(|c| SMALL.contains(*c)) {
            self.rest = &after[c.len_utf8()..];
            return Some(minus * SMALL.chars().position(|small| small == c)? as i32);
        }
        let Some(after) = self.rest.strip_prefix('^') else { return Some(1) };
        let after = after.trim_start();
        let end =
            after.char_indices().find(|(at, c)| !(c.is_ascii_digit() || *at == 0 && *c == '-'));
        let (digits, rest) = after.split_at(end.map_or(after.len(), |(at, _)| at));
        self.rest = rest;
        digits.parse().ok().filter(|exponent: &i32| exponent.abs() <= 16)
    }
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn units_are_written_as_the_language_has_them() {
        for (before, after, right) in [
            ("light a: constant { radiance: 1.5 W/m", "²/sr }", "1.5 W/m^2/sr"),
            ("radiance: 2 W/(m^2", "sr) }", "2 W/m^2/sr"),
            ("radiance: 2 W", "m^-2 sr^-1, up: y", "2 W/m^2/sr"),
            ("radiance: 2 W·m", "⁻²·sr⁻¹", "2 W/m^2/sr"),
        ] {
            assert_eq!(written(before, after).as_deref(), Some(right), "{before}|{after}");
        }
        for (before, after) in [("albedo: 0.8", "0.4 0.2"), ("radius: 1", "foo"), ("", "²")] {
            assert_eq!(written(before, after), None, "{before}|{after}");
        }
    }
}
