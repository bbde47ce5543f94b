//! Flat surfaces, and where they lie on each other.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::placed::{Body, Placed};

/// Corners that stand for a disk.
const ROUND: usize = 32;
/// Surfaces nearer to each other than this part of their size are in one plane: single precision
/// can hardly tell them apart.
const TOGETHER: f64 = 1e-7;
/// An overlap of less than this part of the smaller surface is rounding along a common edge.
const LEAST: f64 = 1e-5;

/// A convex flat surface, counter-clockwise seen from its front; without corners, a plane.
#[derive(Clone, Debug)]
pub struct Flat {
    /// A point of it.
    pub point: DVec3,
    /// Unit length.
    pub normal: DVec3,
    corners: Vec<DVec3>,
}

impl Flat {
    /// Directions whose sine is less are the same.
    pub(super) const PARALLEL: f64 = 1e-6;

    /// None if the thing is not flat.
    pub fn of(thing: &Placed) -> Option<Self> {
        match &thing.body {
            Body::Face { corners, .. } => Self::face(corners.clone()),
            Body::Disk { centre, normal, radius, .. } => {
                let (u, v) = normal.any_orthonormal_pair();
                let corner = |i: usize| {
                    let (sin, cos) = (TAU * i as f64 / ROUND as f64).sin_cos();
                    *centre + *radius * (cos * u + sin * v)
                };
                let corners = (0..ROUND).map(corner).collect();
                Some(Self { point: *centre, normal: *normal, corners })
            }
            Body::Plane { point, normal, .. } => {
                Some(Self { point: *point, normal: *normal, corners: Vec::new() })
            }
            Body::Mesh { .. } | Body::Sphere { .. } => None,
        }
    }

    /// A triangle or a parallelogram; None if it has no area.
    pub fn face(corners: Vec<DVec3>) -> Option<Self> {
        let (a, b, c) = (corners[0], corners[1], corners[2]);
        let normal = (b - a).cross(c - a).try_normalize()?;
        Some(Self { point: a, normal, corners })
    }

    fn size(&self) -> f64 {
        let far = self.corners.iter().map(|corner| corner.distance(self.point));
        far.fold(0.0, f64::max)
    }

    /// Whether both have some part in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.common(other, 0.0).is_some()
    }

    /// The middle of the part that both have in common; nearer to each other than `together`, in
    /// metres, they are in one plane.
    pub fn common(&self, other: &Self, together: f64) -> Option<DVec3> {
        if self.normal.cross(other.normal).length() > Self::PARALLEL {
            return None;
        }
        // Two planes are measured by where their points are.
        let size = match self.size().max(other.size()) {
            0.0 => self.point.distance(other.point),
            size => size,
        };
        let apart = (other.point - self.point).dot(self.normal).abs();
        if apart > together.max(TOGETHER * size) {
            return None;
        }
        if self.corners.is_empty() || other.corners.is_empty() {
            let bounded = if self.corners.is_empty() { other } else { self };
            return Some(bounded.middle());
        }
        let (u, v) = self.normal.any_orthonormal_pair();
        let flatten = |flat: &Self| -> Vec<DVec2> {
            let at = |p: &DVec3| DVec2::new((*p - self.point).dot(u), (*p - self.point).dot(v));
            let mut corners: Vec<DVec2> = flat.corners.iter().map(at).collect();
            if area(&corners) < 0.0 {
                corners.reverse();
            }
            corners
        };
        let (mine, theirs) = (flatten(self), flatten(other));
        let common = clipped(mine.clone(), &theirs);
        let overlap = area(&common) > LEAST * area(&mine).min(area(&theirs));
        overlap.then(|| {
            let middle = common.iter().sum::<DVec2>() / common.len() as f64;
            self.point + middle.x * u + middle.y * v
        })
    }

    fn middle(&self) -> DVec3 {
        match self.corners.len() {
            0 => self.point,
            count => self.corners.iter().sum::<DVec3>() / count as f64,
        }
    }
}

/// The area of a polygon; negative if it is clockwise.
fn area(corners: &[DVec2]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>()
}

/// The part of a polygon inside of a convex one; both counter-clockwise.
fn clipped(mut corners: Vec<DVec2>, by: &[DVec2]) -> Vec<DVec2> {
    for (i, from) in by.iter().enumerate() {
        let edge = by[(i + 1) % by.len()] - *from;
        let height = |p: &DVec2| edge.perp_dot(*p - *from);
        let mut kept = Vec::new();
        for (j, p) in corners.iter().enumerate() {
            let q = corners[(j + 1) % corners.len()];
            let (hp, hq) = (height(p), height(&q));
            if hp >= 0.0 {
                kept.push(*p);
            }
            if (hp >= 0.0) != (hq >= 0.0) {
                kept.push(p.lerp(q, hp / (hp - hq)));
            }
        }
        corners = kept;
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, size: f64) -> Flat {
        let at = |u: f64, v: f64| DVec3::new(x + u * size, y, v * size);
        Flat::face(vec![at(0.0, 0.0), at(0.0, 1.0), at(1.0, 1.0), at(1.0, 0.0)]).unwrap()
    }

    #[test]
    fn squares_overlap_where_they_share_more_than_an_edge() {
        let one = square(0.0, 0.0, 1.0);
        assert!(one.overlaps(&square(0.5, 0.0, 1.0)));
        assert!(one.overlaps(&square(0.2, 0.0, 0.1)) && square(0.2, 0.0, 0.1).overlaps(&one));
        assert!(!one.overlaps(&square(1.0, 0.0, 1.0)));
        assert!(!one.overlaps(&square(0.5, 0.001, 1.0)));
        let middle = one.common(&square(0.5, 0.0, 1.0), 0.0).unwrap();
        assert!(middle.distance(DVec3::new(0.75, 0.0, 0.5)) < 1e-12, "{middle}");
        let plane = Flat { point: DVec3::X * 9.0, normal: -DVec3::Y, corners: Vec::new() };
        assert!(one.overlaps(&plane) && plane.overlaps(&one) && plane.overlaps(&plane));
        assert!(!plane.overlaps(&square(0.0, 1e-3, 1.0)));
        let wall = Flat { normal: DVec3::X, ..plane };
        assert!(!one.overlaps(&wall));
    }
}
