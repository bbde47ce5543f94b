//! What a scanner needs to know of bytes and lines.

/// How much more a byte closes than it opens.
pub fn braces(byte: u8) -> isize {
    match byte {
        b'}' => 1,
        b'{' => -1,
        _ => 0,
    }
}

pub fn text_braces(bytes: &[u8]) -> isize {
    bytes.iter().copied().map(braces).sum()
}

pub fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

/// Bytes up to the end of the line.
pub fn line_rest(bytes: &[u8]) -> usize {
    bytes.iter().position(|b| *b == b'\n').unwrap_or(bytes.len())
}

/// Bytes of a number, or of a clock value with its colon.
pub fn number_length(bytes: &[u8]) -> usize {
    let word = bytes.iter().take_while(|b| is_word(**b)).count();
    let minutes = bytes.get(word + 1..word + 3);
    let clock = bytes.get(word) == Some(&b':')
        && minutes.is_some_and(|minutes| minutes.iter().all(u8::is_ascii_digit));
    if word <= 2 && clock { word + 3 } else { word }
}

/// Whether a line begins an item: a keyword of one, or `word [name] {.name} :`.
pub fn begins_item(line: &[u8]) -> bool {
    let line = &line[..line_rest(line)];
    let word = |at: usize| line[at..].iter().take_while(|b| is_word(**b)).count();
    let blanks = |at: usize| line[at..].iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
    let first = word(0);
    if first == 0 || line[0].is_ascii_digit() {
        return false;
    }
    if matches!(&line[..first], b"use" | b"let" | b"for" | b"setup" | b"render" | b"without") {
        return true;
    }
    let mut at = first + blanks(first);
    if line.get(at) == Some(&b'"') {
        match line[at + 1..].iter().position(|b| *b == b'"') {
            Some(length) => at += length + 2,
            None => return false,
        }
    } else {
        at += word(at);
    }
    while line.get(at) == Some(&b'.') {
        at += 1 + word(at + 1);
    }
    line.get(at + blanks(at)) == Some(&b':')
}

/// Where in a line the key after the first colon begins: `film: size: …`.
pub fn second_key(line: &str) -> Option<usize> {
    let after = line.find(':')? + 1;
    let colon = after + line[after..].find(':')?;
    let before = line[..colon].trim_end();
    let key = before.len() - before.bytes().rev().take_while(|b| is_word(*b)).count();
    (key >= after && key < before.len()).then_some(key)
}

/// How much of an unclosed string was probably meant to be in it: up to what looks like the next
/// field, or up to the brackets that end the line.
pub fn likely_end(inside: &str) -> usize {
    let next_field = inside.match_indices(',').map(|(at, _)| at).find(|at| {
        let rest = inside[at + 1..].trim_start();
        let word = rest.bytes().take_while(|b| is_word(*b)).count();
        word > 0 && rest[word..].starts_with(':')
    });
    next_field.unwrap_or_else(|| {
        let cut = inside.trim_end_matches([' ', '}', ')', ']', ',']).len();
        if inside[cut..].contains(['}', ')', ']', ',']) { cut } else { inside.len() }
    })
}
