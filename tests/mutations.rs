//! Scenes broken on purpose, in the ways people break them: what is told, where, and whether the
//! offered mend repairs it. Every mutation follows from one seed; meshes are not loaded.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use scn::cli::Disk;
use scn::diag::{Diagnostic, FileId, Level, Sources};
use scn::lang;
use scn::math::units;
use scn::scene::KINDS;
use scn::scene::schema::{Field, Record, Type};

/// Mutations of each kind, over all scenes together.
const EACH: usize = 200;

/// A way of breaking a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Misspelling,
    LostBrace,
    LostBracket,
    ExtraBracket,
    WrongType,
    WrongUnit,
    LostUnit,
    LostField,
    Swap,
    StrayCharacter,
    Truncation,
}

const ALL: [Kind; 11] = [
    Kind::Misspelling,
    Kind::LostBrace,
    Kind::LostBracket,
    Kind::ExtraBracket,
    Kind::WrongType,
    Kind::WrongUnit,
    Kind::LostUnit,
    Kind::LostField,
    Kind::Swap,
    Kind::StrayCharacter,
    Kind::Truncation,
];

/// A scene with one thing changed.
struct Mutation {
    text: String,
    /// The byte in the changed text where that is.
    at: usize,
    /// Whether it certainly is a fault.
    faulty: bool,
}

/// Numbers that look random, the same in every run (splitmix64).
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }

    fn pick<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        if all.is_empty() { None } else { Some(&all[self.below(all.len())]) }
    }
}

/// A word, number, string or sign of a text, by its bytes.
#[derive(Clone, Debug)]
struct Token {
    start: usize,
    end: usize,
}

fn tokens(text: &str) -> Vec<Token> {
    let bytes = text.as_bytes();
    let mut all = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let word = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
        let number = |b: &u8| b.is_ascii_digit() || *b == b'.';
        let run = |such: &dyn Fn(&u8) -> bool| bytes[at..].iter().take_while(|b| such(b)).count();
        let length = match bytes[at] {
            b if b.is_ascii_whitespace() => {
                at += 1;
                continue;
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                at += run(&|b| *b != b'\n');
                continue;
            }
            b'"' => 2 + bytes[at + 1..].iter().take_while(|b| **b != b'"').count(),
            b if b.is_ascii_digit() => run(&number),
            b if word(&b) => run(&word),
            _ => 1,
        };
        all.push(Token { start: at, end: at + length });
        at += length;
    }
    all
}

/// A shipped scene.
struct Scene {
    path: PathBuf,
    text: String,
    tokens: Vec<Token>,
}

impl Scene {
    fn word(&self, i: usize) -> &str {
        self.tokens.get(i).map_or("", |token| &self.text[token.start..token.end])
    }

    /// Tokens of which something holds.
    fn such(&self, holds: impl Fn(usize) -> bool) -> Vec<usize> {
        // The first line is broken by tests of its own.
        let line = self.text.find('\n').unwrap_or(0);
        (0..self.tokens.len()).filter(|i| self.tokens[*i].start > line && holds(*i)).collect()
    }

    fn replaced(&self, i: usize, with: &str) -> Mutation {
        let Token { start, end } = self.tokens[i];
        let text = format!("{}{with}{}", &self.text[..start], &self.text[end..]);
        Mutation { text, at: start, faulty: true }
    }
}

fn scenes() -> Vec<Scene> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = Vec::new();
    for folder in ["scenes", "scenes/lib", "src/cli"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "scn") {
                let text = std::fs::read_to_string(&path).unwrap();
                all.push(Scene { tokens: tokens(&text), path, text });
            }
        }
    }
    all.sort_by(|a, b| a.path.cmp(&b.path));
    assert!(all.len() >= 3);
    all
}

/// The words of the schema, and the fields that must be given wherever there are such.
struct Vocabulary {
    words: HashSet<&'static str>,
    required: HashSet<&'static str>,
}

fn vocabulary() -> Vocabulary {
    fn records(
        ty: &'static Type,
        found: &mut Vec<&'static Record>,
        words: &mut HashSet<&'static str>,
    ) {
        match ty {
            Type::OneOf(variants) => {
                for record in variants.all {
                    words.insert(record.word);
                    found.push(record);
                    record.fields.iter().for_each(|field| records(&field.ty, found, words));
                }
            }
            Type::Record(record) => {
                found.push(record);
                record.fields.iter().for_each(|field| records(&field.ty, found, words));
            }
            Type::List(inner) | Type::Map(inner) => records(inner, found, words),
            _ => {}
        }
    }
    let (mut found, mut words) = (Vec::new(), HashSet::new());
    for kind in KINDS {
        words.insert(kind.word);
        records(&kind.ty, &mut found, &mut words);
    }
    let fields = || found.iter().flat_map(|record| record.fields);
    words.extend(fields().map(|field| field.word));
    let must = |field: &&Field| field.default.is_none() && !field.optional;
    let may: HashSet<_> = fields().filter(|field| !must(field)).map(|field| field.word).collect();
    let required = fields().filter(must).map(|f| f.word).filter(|word| !may.contains(word));
    Vocabulary { required: required.collect(), words }
}

/// What a finger does to a word.
fn misspelt(word: &str, chance: &mut Chance) -> String {
    let mut letters: Vec<char> = word.chars().collect();
    let at = chance.below(letters.len() - 1);
    match chance.below(4) {
        0 => {
            letters.remove(at);
        }
        1 => letters.insert(at, letters[at]),
        2 => letters.swap(at, at + 1),
        _ => letters[at] = if letters[at] == 'e' { 'r' } else { 'e' },
    }
    letters.into_iter().collect()
}

fn mutate(kind: Kind, scene: &Scene, words: &Vocabulary, chance: &mut Chance) -> Option<Mutation> {
    let is = |i: usize, all: &[&str]| all.contains(&scene.word(i));
    let digit = |i: usize| scene.word(i).starts_with(|c: char| c.is_ascii_digit());
    // A unit that follows a number, multiplies something, or stands alone.
    let unit = |i: usize| {
        let known = units::find(scene.word(i)).is_some() && !is(i + 1, &[":"]);
        known && (digit(i - 1) || is(i - 1, &["*", ":"]))
    };
    match kind {
        Kind::Misspelling => {
            // The name of a declaration may be any word.
            let named = |i: usize| {
                KINDS.iter().any(|kind| kind.named && kind.word == scene.word(i - 1))
                    && !is(i, &[":", "."])
            };
            let known = scene.such(|i| {
                scene.word(i).len() > 3 && words.words.contains(scene.word(i)) && !named(i)
            });
            let i = *chance.pick(&known)?;
            let wrong = misspelt(scene.word(i), chance);
            let same = words.words.contains(wrong.as_str()) || wrong == scene.word(i);
            (!same).then(|| scene.replaced(i, &wrong))
        }
        Kind::LostBrace => {
            Some(scene.replaced(*chance.pick(&scene.such(|i| is(i, &["{", "}"])))?, ""))
        }
        Kind::LostBracket => {
            let all = scene.such(|i| is(i, &["(", ")", "[", "]"]));
            Some(scene.replaced(*chance.pick(&all)?, ""))
        }
        Kind::ExtraBracket => {
            let bracket = ["(", ")", "[", "]", "{", "}"][chance.below(6)];
            let i = *chance.pick(&scene.such(|_| true))?;
            Some(scene.replaced(i, &format!("{bracket}{}", scene.word(i))))
        }
        Kind::WrongType => Some(scene.replaced(*chance.pick(&scene.such(digit))?, "\"text\"")),
        Kind::WrongUnit => {
            let i = *chance.pick(&scene.such(unit))?;
            let here = units::find(scene.word(i))?.dimension;
            let others = ["m", "mm", "deg", "s", "K", "W", "lm", "sr"];
            let other = |word: &&&str| units::find(word).is_some_and(|unit| unit.dimension != here);
            let others: Vec<_> = others.iter().filter(other).collect();
            Some(scene.replaced(i, chance.pick(&others)?))
        }
        Kind::LostUnit => {
            let units = scene.such(|i| unit(i) && !is(i - 1, &[":"]));
            let i = *chance.pick(&units)?;
            // `W/m^2/sr` whole, with the `*` before it.
            let mut end = i + 1;
            while is(end, &["/", "^"]) {
                end += 2;
            }
            let first = if is(i - 1, &["*"]) { i - 1 } else { i };
            let (start, end) = (scene.tokens[first].start, scene.tokens[end - 1].end);
            let text = format!("{}{}", scene.text[..start].trim_end(), &scene.text[end..]);
            Some(Mutation { at: scene.text[..start].trim_end().len(), text, faulty: true })
        }
        Kind::LostField => {
            let fields = scene.such(|i| {
                words.required.contains(scene.word(i))
                    && is(i + 1, &[":"])
                    && is(i - 1, &["{", ","])
            });
            let i = *chance.pick(&fields)?;
            let mut depth = 0;
            let mut end = i;
            // Up to the comma after it, or to what closes its record.
            while depth > 0 || !is(end, &[",", "}"]) {
                depth += i32::from(is(end, &["(", "[", "{"]));
                depth -= i32::from(is(end, &[")", "]", "}"]));
                end += 1;
            }
            end += usize::from(is(end, &[","]));
            let (start, end) = (scene.tokens[i].start, scene.tokens[end].start);
            let text = format!("{}{}", &scene.text[..start], &scene.text[end..]);
            Some(Mutation { text, at: start, faulty: true })
        }
        Kind::Swap => {
            let values = scene.such(|i| digit(i) || scene.word(i).starts_with('"'));
            let (a, b) = (*chance.pick(&values)?, *chance.pick(&values)?);
            let (a, b) = (a.min(b), a.max(b));
            if scene.word(a) == scene.word(b) {
                return None;
            }
            let second = scene.replaced(b, scene.word(a)).text;
            let Token { start, end } = scene.tokens[a];
            let text = format!("{}{}{}", &second[..start], scene.word(b), &second[end..]);
            Some(Mutation { text, at: start, faulty: false })
        }
        Kind::StrayCharacter => {
            let stray = ["$", "@", "!", "~", "#", "?", "&", "|", "°", "\u{201c}"][chance.below(10)];
            let i = *chance.pick(&scene.such(|_| true))?;
            let at = scene.tokens[i].start;
            let text = format!("{}{stray} {}", &scene.text[..at], &scene.text[at..]);
            Some(Mutation { text, at, faulty: true })
        }
        Kind::Truncation => {
            let i = *chance.pick(&scene.such(|_| true))?;
            let text = scene.text[..scene.tokens[i].start].trim_end().to_string();
            let open = |all: &[&str]| (0..i).filter(|i| is(*i, all)).count();
            let faulty = open(&["(", "[", "{"]) > open(&[")", "]", "}"]);
            Some(Mutation { at: text.len(), text, faulty })
        }
    }
}

fn told(path: &Path, text: &str) -> (Vec<Diagnostic>, Sources) {
    let mut sources = Sources::new();
    let compiled = lang::compile(path, text, &[], &[], &Disk, &mut sources);
    (compiled.diagnostics, sources)
}

fn errors(told: &[Diagnostic]) -> usize {
    told.iter().filter(|told| told.level == Level::Error).count()
}

/// Whether a fault is told within a line of byte `at`.
fn near(told: &[Diagnostic], sources: &Sources, text: &str, at: usize) -> bool {
    let line = text[..at].matches('\n').count() + 1;
    let here = |span: scn::diag::Span| {
        span.file == FileId(0) && sources.line_column(span).0.abs_diff(line) <= 1
    };
    told.iter().any(|told| told.labels.iter().any(|label| here(label.span)))
}

/// Whether the first mend that is offered leaves no error.
fn repaired(path: &Path, text: &str, told: &[Diagnostic]) -> bool {
    let mut text = text.to_string();
    let Some(mend) = told.iter().find_map(|told| told.mends.first()) else { return false };
    let mut edits = mend.edits.clone();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    for edit in edits {
        if edit.span.file != FileId(0) || text.get(edit.span.range()).is_none() {
            return false;
        }
        text.replace_range(edit.span.range(), &edit.text);
    }
    errors(&self::told(path, &text).0) == 0
}

/// What became of the mutations of a kind.
#[derive(Default)]
struct Figures {
    all: usize,
    faulty: usize,
    silent: Vec<String>,
    near: usize,
    far: Vec<String>,
    repaired: usize,
    unrepaired: Vec<String>,
    reports: Vec<usize>,
}

fn figures() -> BTreeMap<Kind, Figures> {
    let scenes = scenes();
    let words = vocabulary();
    let mut chance = Chance(1);
    let mut all: BTreeMap<Kind, Figures> = BTreeMap::new();
    for kind in ALL {
        let figures = all.entry(kind).or_default();
        let mut tries = 0;
        while figures.all < EACH && tries < 20 * EACH {
            let scene = &scenes[tries % scenes.len()];
            tries += 1;
            let Some(changed) = mutate(kind, scene, &words, &mut chance) else { continue };
            let (told, sources) = told(&scene.path, &changed.text);
            figures.all += 1;
            let line = changed.text[..changed.at].matches('\n').count();
            let shown = changed.text.lines().nth(line).unwrap_or("").trim().to_string();
            let first = told.first().map_or("nothing", |told| told.headline.as_str());
            let shown = format!(
                "{}:{}: {shown}\n        {first}",
                scene.path.file_name().unwrap().to_string_lossy(),
                line + 1
            );
            if !changed.faulty {
                figures.reports.push(errors(&told));
                continue;
            }
            figures.faulty += 1;
            figures.reports.push(errors(&told));
            if errors(&told) == 0 {
                figures.silent.push(shown);
                continue;
            }
            match near(&told, &sources, &changed.text, changed.at) {
                true => figures.near += 1,
                false => figures.far.push(shown.clone()),
            }
            match repaired(&scene.path, &changed.text, &told) {
                true => figures.repaired += 1,
                false => figures.unrepaired.push(shown),
            }
        }
    }
    all
}

#[test]
fn broken_scenes_are_told_where_they_are_broken_and_how_to_mend_them() {
    for scene in scenes() {
        assert_eq!(errors(&told(&scene.path, &scene.text).0), 0, "{}", scene.path.display());
    }
    let all = figures();
    let mut total = 0;
    println!("kind              mutations  faulty  silent  near  mended  median of reports");
    let percent = |part: usize, all: usize| 100.0 * part as f64 / all.max(1) as f64;
    let mut wrong = Vec::new();
    for (kind, figures) in &all {
        let mut reports = figures.reports.clone();
        reports.sort_unstable();
        let median = reports[reports.len() / 2];
        let near = percent(figures.near, figures.faulty);
        let mended = percent(figures.repaired, figures.faulty);
        println!(
            "{:16}  {:9}  {:6}  {:6}  {near:3.0}%  {mended:5.0}%  {median}",
            format!("{kind:?}"),
            figures.all,
            figures.faulty,
            figures.silent.len(),
        );
        total += figures.all;
        let mut hold = |holds: bool, what: &str, shown: &[String]| {
            if !holds {
                wrong.push(format!("{kind:?}: {what}\n    {}", shown.join("\n    ")));
            }
        };
        hold(figures.silent.is_empty(), "some are told nothing", &figures.silent);
        let least = if *kind == Kind::LostBrace { 75.0 } else { 90.0 };
        hold(figures.faulty == 0 || near >= least, "told too far away", &figures.far);
        let mends = matches!(kind, Kind::Misspelling | Kind::WrongUnit | Kind::LostUnit);
        hold(!mends || mended >= 60.0, "too few are mended", &figures.unrepaired);
        hold(median <= 5, "too many reports", &[]);
    }
    println!("{total} mutations");
    assert!(total >= 1500, "{total}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
