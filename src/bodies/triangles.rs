//! How two triangles meet.

use glam::DVec3;

use super::flat::Flat;
use crate::math::Bounds;

/// How two triangles meet, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Contact {
    /// The middle of one goes through the middle of the other.
    Cross(DVec3),
    /// They lie on each other.
    On(DVec3),
    /// They have a point in common, and neither goes through the other.
    Touch(DVec3),
}

/// Nearer than this part of their size triangles touch; that is no crossing yet.
pub(super) const TOUCH: f64 = 1e-9;

/// How two triangles meet; of those that lie less than `together` above each other, in metres, no
/// ray can tell which one is nearer.
pub(super) fn contact(one: [DVec3; 3], other: [DVec3; 3], together: f64) -> Option<Contact> {
    let touch = TOUCH * Bounds::around(one).size().min(Bounds::around(other).size());
    let [mine, theirs] = [normal(one)?, normal(other)?];
    let along = mine.cross(theirs);
    if along.length() <= Flat::PARALLEL {
        let (a, b) = (Flat::face(one.to_vec())?, Flat::face(other.to_vec())?);
        if let Some(at) = a.common(&b, together) {
            return Some(Contact::On(at));
        }
    }
    let along = along.try_normalize()?;
    let first = Cut::of(one, other[0], theirs, touch)?;
    let second = Cut::of(other, one[0], mine, touch)?;
    let ([from, to], [least, most]) = (first.ends(along), second.ends(along));
    let (low, high) = (from.0.max(least.0), to.0.min(most.0));
    if high < low - touch {
        return None;
    }
    let part = (0.5 * (low + high) - from.0) / (to.0 - from.0);
    let at = from.1.lerp(to.1, if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 });
    let through = first.on_both_sides && second.on_both_sides && high - low > touch;
    Some(if through { Contact::Cross(at) } else { Contact::Touch(at) })
}

fn normal([a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    (b - a).cross(c - a).try_normalize()
}

/// What a plane has in common with a triangle.
struct Cut {
    /// Where its rim is on the plane, at so many places: each is a corner or between two of them.
    points: [DVec3; 3],
    count: usize,
    /// Whether corners lie above and below.
    on_both_sides: bool,
}

impl Cut {
    /// None: there is nothing.
    fn of(corners: [DVec3; 3], point: DVec3, normal: DVec3, touch: f64) -> Option<Self> {
        let heights = corners.map(|corner| {
            let height = normal.dot(corner - point);
            if height.abs() <= touch { 0.0 } else { height }
        });
        let mut cut = Self { points: [DVec3::ZERO; 3], count: 0, on_both_sides: false };
        for i in 0..3 {
            let (j, high) = ((i + 1) % 3, heights[i]);
            if high == 0.0 {
                cut.add(corners[i]);
            }
            if high * heights[j] < 0.0 {
                cut.add(corners[i].lerp(corners[j], high / (high - heights[j])));
                cut.on_both_sides = true;
            }
        }
        (cut.count > 0).then_some(cut)
    }

    fn add(&mut self, place: DVec3) {
        self.points[self.count] = place;
        self.count += 1;
    }

    /// Its ends in a direction, each with how far along it is.
    fn ends(&self, along: DVec3) -> [(f64, DVec3); 2] {
        let first = (along.dot(self.points[0]), self.points[0]);
        let rest = self.points[1..self.count].iter().map(|p| (along.dot(*p), *p));
        rest.fold([first; 2], |[least, most], end| {
            [if end.0 < least.0 { end } else { least }, if end.0 > most.0 { end } else { most }]
        })
    }
}
