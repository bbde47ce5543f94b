//! Checks every statement of a .mtl file and writes the clean ones for tobj: colours with three
//! components, materials named by their number.

use std::collections::HashMap;
use std::ops::Range;

use super::{Fault, Library, Material, Said, What, map};
use crate::files::lines::{self, Line, Lines};

/// The most faults that are told one by one.
const TOLD: usize = 20;
/// The most unknown words that are told.
const UNKNOWN_TOLD: usize = 10;
/// The longest line that is read, in bytes; no statement needs as much.
const LONGEST: usize = 1000;

/// Statements of the format, and of its physically based extension, whose values nothing asks
/// for yet.
const OTHERS: &[&str] = &[
    "Pc", "Pcr", "Pm", "Pr", "Ps", "Tf", "aniso", "anisor", "bump", "decal", "disp", "map_Bump",
    "map_Ka", "map_Kd", "map_Ke", "map_Ks", "map_Ns", "map_Pm", "map_Pr", "map_Ps", "map_bump",
    "map_d", "map_refl", "norm", "refl",
];

/// Statements about how textures are filtered, which no picture of ours depends on.
const SILENT: &[&str] = &["map_aat", "sharpness"];

pub(super) struct Scan {
    pub library: Library,
    pub clean: String,
    names: HashMap<String, usize>,
}

impl Scan {
    pub fn new(bytes: &[u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let library = Library { text: display(bytes), ..Library::default() };
        Self { library, clean: String::new(), names: HashMap::new() }
    }

    pub fn run(&mut self) {
        let text = std::mem::take(&mut self.library.text);
        let (mut lines, mut words) = (Lines::new(text.as_bytes()), Vec::new());
        while let Some(line) = lines.next(&mut words) {
            self.statement(&text, line, &words);
        }
        self.library.text = text;
    }

    fn statement(&mut self, text: &str, line: Line, words: &[Range<usize>]) {
        let word = &text[words[0].clone()];
        let at = words[0].start..words[words.len() - 1].end;
        if word == "newmtl" {
            return self.begin(lines::name(text.as_bytes(), line, words), at);
        }
        let known = ["Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum"].contains(&word);
        if !known && !OTHERS.contains(&word) && !SILENT.contains(&word) {
            let unknown = &mut self.library.unknown;
            let told = unknown.iter().any(|said| said.value == word);
            if !told && unknown.len() < UNKNOWN_TOLD {
                unknown.push(Said { value: word.to_string(), at: words[0].clone() });
            }
            return;
        }
        if self.library.materials.is_empty() {
            return self.fault(What::NoMaterial, at);
        }
        match word {
            "Ka" | "Kd" | "Ks" | "Ke" => self.colour(text, words, at),
            "Ns" | "Ni" => self.number(text, words, at),
            "d" if words.len() == 3 && &text[words[1].clone()] == "-halo" => {
                self.material().others.push(Said { value: "d -halo".into(), at });
            }
            "d" | "Tr" => self.opacity(text, words, at),
            "illum" => self.illum(text, words, at),
            // White: no filter at all.
            "Tf" if words[1..].iter().all(|w| text[w.clone()].parse() == Ok(1.0)) => {}
            "map_Kd" => match map::parse(text, words) {
                Some(value) => self.material().diffuse_map = Some(Said { value, at }),
                None => self.material().others.push(Said { value: word.to_string(), at }),
            },
            _ if OTHERS.contains(&word) => {
                let value = word.to_string();
                self.material().others.push(Said { value, at });
            }
            _ => {}
        }
    }

    fn begin(&mut self, name: String, at: Range<usize>) {
        if name.is_empty() {
            self.fault(What::MissingName, at.clone());
        } else if let Some(first) = self.names.insert(name.clone(), self.library.materials.len()) {
            let first = self.library.materials[first].name.at.clone();
            self.fault(What::SameName(first), at.clone());
        }
        self.clean.push_str(&format!("newmtl m{}\n", self.library.materials.len()));
        self.library.materials.push(Material::new(Said { value: name, at }));
    }

    /// The material the statement belongs to; there is one.
    fn material(&mut self) -> &mut Material {
        self.library.materials.last_mut().expect("looked at before")
    }

    /// `Ka`, `Kd`, `Ks`, `Ke`: one number for a grey, or three.
    fn colour(&mut self, text: &str, words: &[Range<usize>], at: Range<usize>) {
        let word = &text[words[0].clone()];
        if let Some(other) = words.get(1).map(|w| &text[w.clone()])
            && ["spectral", "xyz"].contains(&other)
        {
            return self.fault(What::OtherColour(other.to_string()), at);
        }
        let Some(numbers) = self.numbers(text, words, &at, &[1, 3], "1 or 3 numbers") else {
            return;
        };
        let colour = [numbers[0], numbers[numbers.len() / 2], numbers[numbers.len() - 1]];
        self.clean.push_str(&format!("{word} {:e} {:e} {:e}\n", colour[0], colour[1], colour[2]));
        let said = Some(Said { value: colour, at });
        let material = self.material();
        match word {
            "Ka" => material.ambient = said,
            "Kd" => material.diffuse = said,
            "Ks" => material.specular = said,
            _ => material.emissive = said,
        }
    }

    fn number(&mut self, text: &str, words: &[Range<usize>], at: Range<usize>) {
        let word = &text[words[0].clone()];
        let Some(numbers) = self.numbers(text, words, &at, &[1], "1 number") else { return };
        self.clean.push_str(&format!("{word} {:e}\n", numbers[0]));
        let said = Some(Said { value: numbers[0], at });
        match word {
            "Ns" => self.material().exponent = said,
            _ => self.material().index = said,
        }
    }

    fn opacity(&mut self, text: &str, words: &[Range<usize>], at: Range<usize>) {
        let Some(numbers) = self.numbers(text, words, &at, &[1], "1 number") else { return };
        if numbers[0] > 1.0 {
            let what = What::NoFraction(text[words[1].clone()].to_string());
            return self.fault(what, words[1].clone());
        }
        let transparent = &text[words[0].clone()] == "Tr";
        let value = if transparent { 1.0 - numbers[0] } else { numbers[0] };
        self.clean.push_str(&format!("d {value:e}\n"));
        self.material().dissolve = Some(Said { value, at });
    }

    fn illum(&mut self, text: &str, words: &[Range<usize>], at: Range<usize>) {
        let [_, word] = words else {
            let (found, wanted) = (words.len() - 1, "1 number");
            return self.fault(What::WrongCount { statement: "illum".into(), found, wanted }, at);
        };
        match text[word.clone()].parse::<u8>() {
            Ok(value @ 0..=14) => {
                self.clean.push_str(&format!("illum {value}\n"));
                self.material().illum = Some(Said { value, at });
            }
            _ => {
                let what = What::NotAnIllum(lines::shown(text.as_bytes(), word));
                self.fault(what, word.clone());
            }
        }
    }

    /// The numbers of a statement: finite, none below zero, as many as one of `counts`.
    fn numbers(
        &mut self,
        text: &str,
        words: &[Range<usize>],
        at: &Range<usize>,
        counts: &[usize],
        wanted: &'static str,
    ) -> Option<Vec<f64>> {
        let mut numbers = Vec::new();
        // What is no number is told first: it may be why the count is wrong.
        for word in words[1..].iter().take(4) {
            let shown = || lines::shown(text.as_bytes(), word);
            let what = match text[word.clone()].parse::<f64>() {
                Ok(value) if !value.is_finite() || value > f64::from(f32::MAX) => {
                    What::NotFinite(shown())
                }
                Ok(value) if value < 0.0 => What::Negative(shown()),
                Ok(value) => {
                    numbers.push(value);
                    continue;
                }
                Err(_) => What::NotANumber(shown()),
            };
            self.fault(what, word.clone());
            return None;
        }
        let found = words.len() - 1;
        if !counts.contains(&found) {
            let statement = text[words[0].clone()].to_string();
            self.fault(What::WrongCount { statement, found, wanted }, at.clone());
            return None;
        }
        Some(numbers)
    }

    fn fault(&mut self, what: What, at: Range<usize>) {
        if self.library.faults.len() == TOLD {
            self.library.more += 1;
            return;
        }
        let material = self.library.materials.last().map(|material| material.name.value.clone());
        self.library.faults.push(Fault { what, at, material });
    }
}

impl Material {
    fn new(name: Said<String>) -> Self {
        Self {
            name,
            ambient: None,
            diffuse: None,
            diffuse_map: None,
            specular: None,
            emissive: None,
            exponent: None,
            index: None,
            dissolve: None,
            illum: None,
            others: Vec::new(),
        }
    }
}

/// The file as it can be shown; its lines keep their numbers.
fn display(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    let mut rest = bytes;
    while !rest.is_empty() {
        let end = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        text.push_str(&lines::decode(&rest[..end.min(LONGEST)]));
        text.push_str(if end > LONGEST { "…\n" } else { "\n" });
        let skip = if rest[end..].starts_with(b"\r\n") { 2 } else { 1 };
        rest = rest.get(end + skip..).unwrap_or(&[]);
    }
    text
}
