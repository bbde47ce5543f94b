//! Checks every statement of an .obj file, and makes a text of the clean ones for tobj.
//!
//! The clean text holds `v`, `vn` and `f` alone, with indices that count from 1, each face
//! beginning at the corner its fan begins with. Materials stay here: all faces are one model.

mod faces;

use std::collections::HashMap;
use std::ops::Range;

use glam::{DVec3, Vec2};

use super::Excerpt;
use super::assemble::Triangles;
use super::faults::{Fault, Notice, Unread, What};
use crate::files::lines::{self, Line, Lines};
use crate::math::Progress;
use faces::Corner;

/// The most faults that are told one by one.
const TOLD: usize = 20;
/// The most unknown words that are told one by one.
const UNKNOWN_TOLD: usize = 10;
/// The most .mtl files one .obj file may name.
const MOST_LIBRARIES: usize = 32;
/// The most materials one .obj file may use.
const MOST_MATERIALS: usize = 100_000;
/// Clean text is made in pieces of about so many bytes.
const PIECE: usize = 1 << 16;
/// The largest coordinate, in file units: beyond it products of four overflow in mixed company.
pub const FARTHEST: f64 = 1e30;

/// What the scan found.
pub(super) struct Found {
    pub faults: Vec<Fault>,
    pub more: u64,
    pub notices: Vec<Notice>,
    pub triangles: Triangles,
    /// Texture coordinates.
    pub coordinates: Vec<Vec2>,
    pub slots: Vec<(String, Excerpt)>,
    pub libraries: Vec<(String, Excerpt)>,
    /// Statements of the format, and others.
    pub understood: u64,
    pub unknown: u64,
}

/// Makes clean text.
pub(super) struct Scan<'a> {
    bytes: &'a [u8],
    progress: &'a dyn Progress,
    lines: Lines<'a>,
    words: Vec<Range<usize>>,
    corners: Vec<Corner>,
    fan: Vec<DVec3>,
    clean: Vec<u8>,
    positions: Vec<DVec3>,
    normals: usize,
    /// The largest index of each kind that was ahead of its time.
    ahead: [i64; 3],
    slot: Option<u32>,
    slots_by_name: HashMap<String, u32>,
    named: Option<(String, Line, Range<usize>)>,
    smooth: Option<Excerpt>,
    found: Found,
}

impl<'a> Scan<'a> {
    pub fn new(bytes: &'a [u8], progress: &'a dyn Progress) -> Self {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        Self {
            bytes: text,
            progress,
            lines: Lines::new(text),
            words: Vec::new(),
            corners: Vec::new(),
            fan: Vec::new(),
            clean: Vec::new(),
            positions: Vec::new(),
            normals: 0,
            ahead: [0; 3],
            slot: None,
            slots_by_name: HashMap::new(),
            named: None,
            smooth: None,
            found: Found {
                faults: Vec::new(),
                more: 0,
                notices: Vec::new(),
                triangles: Triangles::default(),
                coordinates: Vec::new(),
                slots: Vec::new(),
                libraries: Vec::new(),
                understood: 0,
                unknown: 0,
            },
        }
    }

    /// The next piece of clean text; None at the end of the file.
    pub fn next_piece(&mut self) -> Option<Vec<u8>> {
        while self.scan_piece() {
            if !self.clean.is_empty() {
                return Some(std::mem::take(&mut self.clean));
            }
        }
        Some(std::mem::take(&mut self.clean)).filter(|last| !last.is_empty())
    }

    /// Scans what is left, and tells what was found.
    pub fn finish(mut self) -> Found {
        while self.scan_piece() {}
        self.check_ahead();
        self.found.faults.sort_by_key(|fault| fault.place.line);
        if self.found.triangles.with_normals.contains(&false)
            && let Some(place) = self.smooth
        {
            self.found.notices.push(Notice { what: Unread::Smoothing, count: 1, place });
        }
        self.found
    }

    /// How many there are so far, in the order of [`Of::ALL`].
    fn counts(&self) -> [usize; 3] {
        [self.positions.len(), self.found.coordinates.len(), self.normals]
    }

    /// Makes a piece of clean text; false at the end of the file.
    fn scan_piece(&mut self) -> bool {
        self.clean.clear();
        let mut words = std::mem::take(&mut self.words);
        let begin = self.lines.position();
        let mut more = true;
        while more && self.clean.len() < PIECE && self.lines.position() - begin < PIECE {
            match self.lines.next(&mut words) {
                Some(line) => self.statement(line, &words),
                None => more = false,
            }
        }
        self.words = words;
        self.progress.advance(self.lines.position() as u64, self.bytes.len() as u64);
        if !self.found.faults.is_empty() {
            self.clean.clear();
        }
        more
    }

    fn statement(&mut self, line: Line, words: &[Range<usize>]) {
        let bytes = self.bytes;
        self.found.understood += 1;
        if words.len() > lines::MOST_WORDS {
            return self.fault(What::TooManyWords(lines::MOST_WORDS), line, words[0].clone());
        }
        match &bytes[words[0].clone()] {
            b"v" => self.vertex(line, words),
            b"vt" => {
                let [u, v, ..] = self.numbers("vt", 1, 3, line, words);
                self.found.coordinates.push(Vec2::new(u as f32, v as f32));
            }
            b"vn" => self.normal(line, words),
            b"f" | b"fo" => self.face(line, words),
            b"usemtl" => self.material(line, words),
            b"mtllib" => self.library(line, words),
            b"o" | b"g" | b"mg" => {}
            b"s" => {
                let off = matches!(words.get(1).map(|w| &bytes[w.clone()]), Some(b"0" | b"off"));
                if !off && self.smooth.is_none() {
                    self.smooth = Some(lines::excerpt(bytes, line, whole(words)));
                }
            }
            b"p" => self.notice(Unread::Points, line, words),
            b"l" => self.notice(Unread::Lines, line, words),
            b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf"
            | b"parm" | b"trim" | b"hole" | b"scrv" | b"sp" | b"end" | b"con" => {
                self.notice(Unread::FreeForm, line, words);
            }
            _ => {
                self.found.understood -= 1;
                self.found.unknown += 1;
                let word = lines::shown(bytes, &words[0]);
                let unknown = |n: &&Notice| matches!(n.what, Unread::Unknown(_));
                let known =
                    self.found.notices.iter().any(|n| n.what == Unread::Unknown(word.clone()));
                if known || self.found.notices.iter().filter(unknown).count() < UNKNOWN_TOLD {
                    self.notice(Unread::Unknown(word), line, &words[..1]);
                }
            }
        }
    }

    fn vertex(&mut self, line: Line, words: &[Range<usize>]) {
        // x y z, then nothing, a weight (of no meaning for polygons), a colour, or both.
        let numbers = self.numbers("v", 3, 7, line, words);
        let p = DVec3::new(numbers[0], numbers[1], numbers[2]);
        for (coordinate, word) in p.to_array().iter().zip(&words[1..]) {
            if coordinate.abs() > FARTHEST {
                self.fault(What::TooFar(lines::shown(self.bytes, word)), line, word.clone());
            }
        }
        if words.len() > 5 {
            self.notice(Unread::VertexColours, line, &words[words.len() - 3..]);
        }
        self.positions.push(p);
        self.hand_on(b"v", words);
    }

    fn normal(&mut self, line: Line, words: &[Range<usize>]) {
        let [x, y, z, ..] = self.numbers("vn", 3, 3, line, words);
        if [x, y, z] == [0.0; 3] && words.len() > 3 {
            self.notice(Unread::ZeroNormal, line, words);
        }
        self.normals += 1;
        self.hand_on(b"vn", words);
    }

    /// Hands a statement of three numbers on.
    fn hand_on(&mut self, statement: &[u8], words: &[Range<usize>]) {
        self.clean.extend(statement);
        for word in words.iter().skip(1).take(3) {
            self.clean.push(b' ');
            self.clean.extend(&self.bytes[word.clone()]);
        }
        self.clean.push(b'\n');
    }

    /// Checks the numbers of a statement; those that are wrong or missing are zero.
    fn numbers(
        &mut self,
        statement: &'static str,
        wanted: usize,
        most: usize,
        line: Line,
        words: &[Range<usize>],
    ) -> [f64; 7] {
        let mut numbers = [0.0; 7];
        let found = words.len() - 1;
        if found < wanted {
            self.fault(What::TooFewNumbers { statement, found, wanted }, line, whole(words));
            return numbers;
        }
        for (number, word) in numbers[..most].iter_mut().zip(&words[1..]) {
            let text = std::str::from_utf8(&self.bytes[word.clone()]).unwrap_or("");
            match text.parse::<f64>() {
                Ok(value) if value.is_finite() => *number = value,
                Ok(_) => {
                    let what = What::NotFinite(lines::shown(self.bytes, word));
                    self.fault(what, line, word.clone());
                }
                Err(_) => {
                    let what = What::NotANumber(lines::shown(self.bytes, word));
                    self.fault(what, line, word.clone());
                }
            }
        }
        numbers
    }

    fn material(&mut self, line: Line, words: &[Range<usize>]) {
        let name = lines::name(self.bytes, line, words);
        if name.is_empty() {
            self.fault(What::MissingName("usemtl"), line, whole(words));
            return;
        }
        self.slot = self.slots_by_name.get(&name).copied();
        self.named = Some((name, line, whole(words)));
    }

    /// The slot of a face on this line; slots are made when a face first needs them.
    fn slot(&mut self, line: Line, words: &[Range<usize>]) -> u32 {
        if let Some(slot) = self.slot {
            return slot;
        }
        let unnamed = || (String::new(), line, whole(words));
        let (name, line, place) = self.named.clone().unwrap_or_else(unnamed);
        let slot = self.found.slots.len() as u32;
        if self.found.slots.len() == MOST_MATERIALS {
            self.fault(What::TooManyNames("usemtl", MOST_MATERIALS), line, place.clone());
        }
        let excerpt = lines::excerpt(self.bytes, line, place);
        self.found.slots.push((name.clone(), excerpt));
        self.slots_by_name.insert(name, slot);
        self.slot = Some(slot);
        slot
    }

    fn library(&mut self, line: Line, words: &[Range<usize>]) {
        let name = lines::name(self.bytes, line, words);
        if name.is_empty() {
            self.fault(What::MissingName("mtllib"), line, whole(words));
            return;
        }
        // Blanks part names, and stand in names: several names each end in .mtl.
        let parts: Vec<_> = name.split_whitespace().map(str::to_string).collect();
        let several = parts.iter().all(|part| part.to_lowercase().ends_with(".mtl"));
        for name in if several { parts } else { vec![name] } {
            if self.found.libraries.len() == MOST_LIBRARIES {
                self.fault(What::TooManyNames("mtllib", MOST_LIBRARIES), line, whole(words));
                return;
            }
            if !self.found.libraries.iter().any(|library| library.0 == name) {
                let place = lines::excerpt(self.bytes, line, whole(words));
                self.found.libraries.push((name, place));
            }
        }
    }

    fn fault(&mut self, what: What, line: Line, place: Range<usize>) {
        if self.found.faults.len() < TOLD {
            let place = lines::excerpt(self.bytes, line, place);
            self.found.faults.push(Fault { what, place });
        } else {
            self.found.more += 1;
        }
    }

    fn notice(&mut self, what: Unread, line: Line, words: &[Range<usize>]) {
        match self.found.notices.iter_mut().find(|notice| notice.what == what) {
            Some(notice) => notice.count += 1,
            None => {
                let place = lines::excerpt(self.bytes, line, whole(words));
                self.found.notices.push(Notice { what, count: 1, place });
            }
        }
    }
}

/// From the first word to the last.
fn whole(words: &[Range<usize>]) -> Range<usize> {
    words[0].start..words[words.len() - 1].end
}
