//! Directions about many normals at once, by the cosine to each.

use glam::{Vec2, Vec3};

use super::diffuse::cosine;
use crate::math::{random, warp};
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};

/// A direction for each lane, and its density.
pub struct Cosines {
    wi: Rows,
    pdf_w: Row,
}

impl Default for Cosines {
    fn default() -> Self {
        Self { wi: [[0.0; LANES]; 3], pdf_w: [0.0; LANES] }
    }
}

impl Cosines {
    /// Directions about so many normals, by numbers of theirs in [0, 1)⁴, of which the first two
    /// decide.
    pub fn sample(&mut self, count: usize, normals: &Rows, u: &[Row<f64>; 4]) {
        about_all(count, normals, u, &mut self.wi, &mut self.pdf_w);
    }

    /// The direction of a lane, of unit length, and its density in solid angle.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> (Vec3, f32) {
        (get(&self.wi, lane), self.pdf_w[lane])
    }
}

/// A direction about a normal, with its density.
#[inline(always)]
pub(super) fn about(normal: Vec3, u: [f64; 2]) -> (Vec3, f32) {
    let u = Vec2::new(random::unit_f32(u[0]), random::unit_f32(u[1]));
    let wi = warp::about(normal, warp::square_to_cosine(u));
    (wi, cosine(normal, wi))
}

by_processor! {
    #[inline(never)]
    fn about_all(
        count: usize,
        normals: &Rows,
        u: &[Row<f64>; 4],
        directions: &mut Rows,
        pdf_w: &mut Row,
    ) {
        for lane in 0..padded(count) {
            let (wi, density) = about(get(normals, lane), [u[0][lane], u[1][lane]]);
            put(directions, lane, wi);
            pdf_w[lane] = density;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_about_many_normals_are_those_about_each() {
        let numbers = |from: u64, lane: usize| random::unit_pair(random::at(from, lane as u64));
        let row = |nth: usize| std::array::from_fn(|lane| numbers(63, lane)[nth]);
        let u = [row(0), row(1), [0.0; LANES], [0.0; LANES]];
        let mut normals = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            let ([x, y], [z, _]) = (numbers(61, lane), numbers(62, lane));
            let normal = 2.0 * Vec3::new(x as f32, y as f32, z as f32) - 1.0;
            put(&mut normals, lane, normal.normalize());
        }
        for count in [1, 7, 8, 9, LANES] {
            let mut cosines = Cosines::default();
            cosines.sample(count, &normals, &u);
            for lane in 0..count {
                let alone = about(get(&normals, lane), numbers(63, lane));
                assert_eq!(cosines.at(lane), alone, "{lane} of {count}");
            }
        }
    }
}
