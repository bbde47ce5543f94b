//! What was probably meant by text the grammar refuses: forms of other languages and of
//! handwriting, each with what to write instead.

use super::explain::innermost;
use crate::lang::words::is_keyword;
use crate::math::units;
use crate::scene::KINDS;

/// What to write instead of what stands at byte `at` of `text`.
pub fn hint(text: &str, at: usize) -> Option<String> {
    let before = text.get(..at)?.trim_end();
    let after = text.get(at..)?;
    let after = after.lines().next().unwrap_or("").trim_start();
    let line = before.rsplit('\n').next().unwrap_or(before);
    let number = trailing(line, |c| c.is_ascii_digit() || c == '.');
    let exponent = after.strip_prefix('^').map(str::trim_start);
    if exponent.is_some_and(|it| it.starts_with(|c: char| c.is_alphabetic() || "(+.".contains(c))) {
        return Some(
            "write the exponent as a number from -16 to 16: nothing is computed there".into(),
        );
    }
    if let Some(quantity) = super::unit_form::written(line, after) {
        return Some(format!("write `{quantity}`"));
    }
    if after.starts_with('°') {
        return Some("write `deg` for degrees: `35 deg`".into());
    }
    if let Some(colour) = after.strip_prefix('#').and_then(hexadecimal) {
        return Some(format!("write `{colour}`"));
    }
    if !number.is_empty() {
        if let Some(end) = after.strip_prefix("..") {
            let end = leading(end.trim_start_matches(['.', '=']), |c| c.is_ascii_digit());
            return Some(format!("write `{number} to {end}`"));
        }
        if let Some(rest) = after.strip_prefix(['x', '×', '*']) {
            let height = leading(rest.trim_start(), |c| c.is_ascii_digit());
            if !height.is_empty() {
                return Some(format!("write `({number}, {height})`"));
            }
        }
        if innermost(line) == Some('(') && after.starts_with(|c: char| c.is_ascii_digit()) {
            let inside = &line[line.rfind('(')? + 1..];
            let rest = after.split([')', '}', ']']).next().unwrap_or("");
            let all: Vec<_> = inside.split_whitespace().chain(rest.split_whitespace()).collect();
            let all: Vec<_> = all.iter().map(|part| part.trim_end_matches(',')).collect();
            return Some(format!("write commas between them: `({})`", all.join(", ")));
        }
    }
    if let Some(vector) = three_numbers(line, after) {
        return Some(format!("write `rgb{vector}` for a colour, `{vector}` for a vector"));
    }
    let word = leading(after, |c| c.is_ascii_alphanumeric() || c == '_');
    if line.ends_with(')') && units::find(word).is_some() {
        let unit = after.split([',', '}', ')', ']']).next().unwrap_or(word).trim();
        return Some(format!("write `*` before the unit: `… * {unit}`"));
    }
    block_or_name(line, after).or_else(|| field(line, word))
}

/// `key: 0.8 0.4 0.2`, which the grammar refuses at its second or third number: "(0.8, 0.4, 0.2)".
fn three_numbers(line: &str, after: &str) -> Option<String> {
    let first = line.rsplit([':', '=']).next()?;
    let rest = after.split(['}', ',', '/']).next()?;
    let all: Vec<_> = first.split_whitespace().chain(rest.split_whitespace()).collect();
    let numbers = all.len() == 3 && all.iter().all(|part| part.parse::<f64>().is_ok());
    numbers.then(|| format!("({})", all.join(", ")))
}

/// `render a: { … }`, and names that need quotes.
fn block_or_name(line: &str, after: &str) -> Option<String> {
    let head = line.trim_start();
    let mut words = head.split_whitespace();
    let kind = words.next()?;
    let block = matches!(kind, "render" | "setup");
    if block && head.ends_with(':') && after.starts_with('{') {
        let block = head.trim_end_matches(':').trim_end();
        return Some(format!(
            "remove `:`, or name after it what this builds on: `{block}: base {{ … }}`"
        ));
    }
    let whole = format!("{head} {after}");
    if let [_, name, "extends" | "from" | "inherits" | "like" | "of" | "uses", bases @ ..] =
        &*whole.split('{').next().unwrap_or("").split_whitespace().collect::<Vec<_>>()
        && block
        && !bases.is_empty()
    {
        let bases = bases.join(" ");
        return Some(format!(
            "write `{kind} {name}: {bases} {{ … }}`: after the colon stands what it builds on"
        ));
    }
    let named = KINDS.iter().any(|known| known.word == kind && known.named);
    let end = whole.find([':', '{', '=', '"', '('])?;
    if !(block || named) || head.len() > end || words.next().is_none() {
        return None;
    }
    // As written, with the blanks between its words.
    let blank = if after.starts_with('-') { "" } else { " " };
    let name = format!("{}{blank}{after}", head[kind.len()..].trim());
    let name = name[..name.find([':', '{', '=', '"', '('])?].trim();
    Some(match kind {
        "setup" => {
            let name = name.replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_");
            format!("the name of a setup is one word: `setup {name} {{ … }}`")
        }
        "render" => format!("such a name needs quotes: `render \"{name}\" {{ … }}`"),
        _ => format!("such a name needs quotes: `{kind} \"{name}\": …`"),
    })
}

/// `material clay` as a field.
fn field(line: &str, value: &str) -> Option<String> {
    let key = trailing(line, |c| c.is_ascii_alphanumeric() || c == '_');
    let first = line[..line.len() - key.len()].trim_end();
    let alone = first.is_empty() || first.ends_with(['{', ',']);
    let word = key.starts_with(|c: char| c.is_ascii_alphabetic()) && !is_keyword(key);
    (alone && word && !value.is_empty()).then(|| format!("write `{key}: {value}`"))
}

/// The operator at the end of the line before that of byte `at`, where the grammar stopped, if that
/// line begins an item.
pub fn dangling(text: &str, at: usize) -> Option<usize> {
    let before = text.get(..at)?.trim_end();
    let kind = trailing(before, |c| c.is_ascii_alphanumeric() || c == '_' || c == '.');
    let word = kind.split('.').next().unwrap_or(kind);
    let item = KINDS.iter().any(|known| known.word == word);
    let head = before[..before.len() - kind.len()].trim_end_matches([' ', '\t']);
    let line = head.strip_suffix('\n')?.trim_end();
    (item && line.ends_with(['+', '-', '*', '/'])).then(|| line.len() - 1)
}

/// `1,5`: the digits on both sides of a decimal comma before byte `at` of `text`.
pub fn decimal_comma(text: &str, at: usize) -> Option<(&str, &str)> {
    let digit = |c: char| c.is_ascii_digit();
    let fraction = leading(text.get(at..)?, digit);
    let whole = trailing(text.get(..at)?.strip_suffix(',')?, digit);
    let before = text[..at - 1 - whole.len()].trim_end();
    let value = before.ends_with([':', '=', '-', '+']);
    (value && !whole.is_empty() && !fraction.is_empty()).then_some((whole, fraction))
}

/// `cc6644` as a colour.
fn hexadecimal(text: &str) -> Option<String> {
    let digits = leading(text, |c| c.is_ascii_hexdigit());
    let width = match digits.len() {
        6 => 2,
        3 => 1,
        _ => return None,
    };
    let component = |i: usize| {
        let value = u32::from_str_radix(&digits[i * width..(i + 1) * width], 16).ok()?;
        let largest = if width == 2 { 255.0 } else { 15.0 };
        Some(format!("{:.3}", f64::from(value) / largest))
    };
    Some(format!("srgb({}, {}, {})", component(0)?, component(1)?, component(2)?))
}

/// The beginning of a text whose characters are all such.
fn leading(text: &str, such: impl Fn(char) -> bool) -> &str {
    &text[..text.find(|c| !such(c)).unwrap_or(text.len())]
}

/// The end of a text whose characters are all such.
fn trailing(text: &str, such: impl Fn(char) -> bool) -> &str {
    text.rfind(|c| !such(c))
        .map_or(text, |at| &text[at + text[at..].chars().next().map_or(1, char::len_utf8)..])
}
