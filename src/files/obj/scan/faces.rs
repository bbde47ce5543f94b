//! Faces: their corners, checked and counted from the beginning of the file.

use std::io::Write;
use std::ops::Range;

use super::super::fan;
use super::super::faults::{Of, Unread, What};
use super::{Scan, whole};
use crate::files::lines::{self, Line, Lines};
use crate::math::Mesh;

/// A corner of a face, counted from zero.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    vertex: usize,
    coordinates: Option<u32>,
    normal: Option<usize>,
}

impl Scan<'_> {
    pub(super) fn face(&mut self, line: Line, words: &[Range<usize>]) {
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        let before = self.found.faults.len() as u64 + self.found.more;
        corners.extend(words[1..].iter().filter_map(|word| self.corner(line, word)));
        let faultless = before == self.found.faults.len() as u64 + self.found.more;
        let with_normals = corners.iter().filter(|corner| corner.normal.is_some()).count();
        if words.len() < 4 {
            self.fault(What::TooFewCorners(words.len() - 1), line, whole(words));
        } else if faultless && with_normals != 0 && with_normals != corners.len() {
            self.fault(What::MixedNormals, line, whole(words));
        } else if faultless {
            self.clean_face(&corners, line, words);
        }
        self.corners = corners;
    }

    fn clean_face(&mut self, corners: &[Corner], line: Line, words: &[Range<usize>]) {
        let start = self.fan_start(corners, line, words);
        self.clean.push(b'f');
        for i in 0..corners.len() {
            let corner = corners[(start + i) % corners.len()];
            // Writing into memory does not fail.
            let _ = match corner.normal {
                Some(normal) => write!(self.clean, " {}//{}", corner.vertex + 1, normal + 1),
                None => write!(self.clean, " {}", corner.vertex + 1),
            };
        }
        self.clean.push(b'\n');
        let slot = self.slot(line, words);
        let triangles = &mut self.found.triangles;
        for i in 2..corners.len() {
            let fan = [start, start + i - 1, start + i].map(|i| corners[i % corners.len()]);
            if let [Some(a), Some(b), Some(c)] = fan.map(|corner| corner.coordinates) {
                triangles.coordinates.resize(triangles.lines.len(), [Mesh::NO_COORDINATE; 3]);
                triangles.coordinates.push([a, b, c]);
            }
            triangles.lines.push(line.number as u32);
            triangles.slots.push(slot);
            triangles.with_normals.push(corners[0].normal.is_some());
        }
    }

    /// The corner to begin with; the first if vertices are yet to come.
    fn fan_start(&mut self, corners: &[Corner], line: Line, words: &[Range<usize>]) -> usize {
        if corners.len() == 3 {
            return 0;
        }
        self.fan.clear();
        self.fan.extend(corners.iter().filter_map(|c| self.positions.get(c.vertex)));
        if self.fan.len() < corners.len() {
            return 0;
        }
        match fan::start(&self.fan) {
            Some(start) => start,
            None => {
                self.notice(Unread::Concave, line, words);
                0
            }
        }
    }

    fn corner(&mut self, line: Line, word: &Range<usize>) -> Option<Corner> {
        let mut indices = [None; 3];
        for (i, part) in self.bytes[word.clone()].split(|byte| *byte == b'/').enumerate() {
            let text = std::str::from_utf8(part).unwrap_or("?");
            let index = text.parse::<i64>();
            match (indices.get_mut(i), index) {
                (Some(place), Ok(index)) => {
                    *place = Some(self.resolve(Of::ALL[i], index, line, word)?);
                }
                (Some(_), Err(_)) if part.is_empty() && i > 0 => {}
                _ => {
                    let what = What::NotAnIndex(lines::shown(self.bytes, word));
                    self.fault(what, line, word.clone());
                    return None;
                }
            }
        }
        let coordinates = indices[1].map(|index| index as u32);
        Some(Corner { vertex: indices[0]?, coordinates, normal: indices[2] })
    }

    /// An index counted from zero. Those of things to come are looked at in the end.
    fn resolve(&mut self, of: Of, index: i64, line: Line, word: &Range<usize>) -> Option<usize> {
        let count = self.counts()[of as usize];
        if index == 0 {
            self.fault(What::ZeroIndex(of), line, word.clone());
            return None;
        }
        if index > 0 {
            if index as u64 > count as u64 {
                let ahead = &mut self.ahead[of as usize];
                *ahead = index.max(*ahead);
            }
            return Some((index - 1) as usize);
        }
        let resolved = (count as i64).checked_add(index).filter(|resolved| *resolved >= 0);
        if resolved.is_none() {
            self.fault(What::OutOfRange { of, index, count }, line, word.clone());
        }
        resolved.map(|resolved| resolved as usize)
    }

    /// Looks for the indices of things that never came. The file is walked again only if there
    /// are any.
    pub(super) fn check_ahead(&mut self) {
        let counts = self.counts();
        if (0..3).all(|kind| self.ahead[kind] as u64 <= counts[kind] as u64) {
            return;
        }
        let bytes = self.bytes;
        let (mut lines, mut words) = (Lines::new(bytes), Vec::new());
        while let Some(line) = lines.next(&mut words) {
            if !matches!(&bytes[words[0].clone()], b"f" | b"fo") {
                continue;
            }
            for word in &words[1..] {
                if let Some((of, index)) = beyond(&bytes[word.clone()], counts) {
                    let what = What::OutOfRange { of, index, count: counts[of as usize] };
                    self.fault(what, line, word.clone());
                }
            }
        }
    }
}

/// The first index of a well-formed corner that is above its count.
fn beyond(corner: &[u8], counts: [usize; 3]) -> Option<(Of, i64)> {
    let parts = || corner.split(|byte| *byte == b'/');
    let index = |part| std::str::from_utf8(part).ok()?.parse::<i64>().ok();
    let mut indices = parts().zip(Of::ALL).filter_map(|(part, of)| Some((of, index(part)?)));
    let beyond = indices.find(|(of, index)| *index > counts[*of as usize] as i64);
    beyond.filter(|_| parts().count() <= 3)
}
