//! Where on its surface a hit lies: the coordinates by which textures are laid on.
//!
//! Triangles have them at their corners. Round shapes and planes have a chart: a map from world
//! space to the unit sphere, whose longitude and latitude they are, or to the coordinates.

use std::f64::consts::{PI, TAU};

use glam::{DAffine3, DVec2, DVec3, Vec2, Vec3};

use super::shapes::{Kind, Primitive};

/// Stands for the coordinates of a triangle that has none.
const NONE: [u32; 3] = [u32::MAX; 3];

/// Coordinates of the shapes that have any.
#[derive(Clone, Debug, Default)]
pub(super) struct Coordinates {
    corners: Vec<Vec2>,
    /// From the first triangle that has some to the last.
    triangles: Vec<[u32; 3]>,
    /// The number of that first one.
    first: usize,
    /// By primitive, once sorted.
    charts: Vec<(Primitive, DAffine3)>,
}

impl Coordinates {
    pub fn corner(&mut self, uv: Vec2) -> u32 {
        self.corners.push(uv);
        self.corners.len() as u32 - 1
    }

    pub fn lay(&mut self, triangle: Primitive, corners: [u32; 3]) {
        let within = corners.iter().all(|i| (*i as usize) < self.corners.len());
        assert!(within, "coordinates are pushed before their use");
        if self.triangles.is_empty() {
            self.first = triangle.index();
        }
        assert!(triangle.index() >= self.first, "triangles have theirs in their order");
        let place = triangle.index() - self.first;
        if self.triangles.len() <= place {
            self.triangles.resize(place + 1, NONE);
        }
        self.triangles[place] = corners;
    }

    pub fn chart(&mut self, primitive: Primitive, chart: DAffine3) {
        self.charts.push((primitive, chart));
    }

    /// To be called before coordinates are asked.
    pub fn sort(&mut self) {
        self.corners.shrink_to_fit();
        self.triangles.shrink_to_fit();
        self.charts.sort_unstable_by_key(|(primitive, _)| *primitive);
    }

    /// Of a point of a primitive; `weights` are those of the second and third corner of a
    /// triangle, and its coordinates if it has no others.
    #[inline(always)]
    pub fn at(&self, primitive: Primitive, position: Vec3, weights: Vec2) -> DVec2 {
        if primitive.kind() == Kind::Triangle && self.triangles.is_empty() {
            return weights.as_dvec2();
        }
        self.found(primitive, position, weights)
    }

    #[inline(never)]
    fn found(&self, primitive: Primitive, position: Vec3, weights: Vec2) -> DVec2 {
        if primitive.kind() == Kind::Triangle {
            return match self.triangles.get(primitive.index().wrapping_sub(self.first)) {
                Some(corners) if *corners != NONE => {
                    let [a, b, c] = corners.map(|i| self.corners[i as usize].as_dvec2());
                    let [u, v] = weights.as_dvec2().to_array();
                    a + u * (b - a) + v * (c - a)
                }
                _ => weights.as_dvec2(),
            };
        }
        let Ok(found) = self.charts.binary_search_by_key(&primitive, |(of, _)| *of) else {
            return DVec2::ZERO;
        };
        let local = self.charts[found].1.transform_point3(position.as_dvec3());
        match primitive.kind() {
            Kind::Sphere => on_sphere(local),
            _ => local.truncate(),
        }
    }

    pub fn bytes(&self) -> usize {
        self.corners.capacity() * size_of::<Vec2>()
            + self.triangles.capacity() * size_of::<[u32; 3]>()
            + self.charts.capacity() * size_of::<(Primitive, DAffine3)>()
    }
}

/// Around y, to the right seen from outside, with +z in the middle; and from −y up to +y.
fn on_sphere(local: DVec3) -> DVec2 {
    let height = local.normalize_or(DVec3::Z).y.clamp(-1.0, 1.0);
    DVec2::new(0.5 + local.x.atan2(local.z) / TAU, 0.5 + height.asin() / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_is_mapped_as_a_globe_is() {
        let places = [
            (DVec3::Z, [0.5, 0.5]),
            (DVec3::X, [0.75, 0.5]),
            (DVec3::NEG_X, [0.25, 0.5]),
            (DVec3::new(1e-9, 0.0, -1.0), [1.0, 0.5]),
            (DVec3::new(-1e-9, 0.0, -1.0), [0.0, 0.5]),
            (DVec3::new(0.0, 2.0, 2.0), [0.5, 0.75]),
            (DVec3::new(0.0, -1.0, 1e-12), [0.5, 0.0]),
        ];
        for (local, uv) in places {
            assert!(on_sphere(local).distance(DVec2::from_array(uv)) < 1e-8, "{local}");
        }
        assert!(on_sphere(DVec3::ZERO).is_finite());
    }
}
