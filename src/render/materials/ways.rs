//! Where light goes on from many surfaces, one lane for each.

use std::ops::Range;

use glam::Vec3;

use super::{Event, Lamberts, Scattered};
use crate::math::Rgb;
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};
use crate::render::samplers::Fours;

/// Ways on side by side: as [`Scattered`].
pub struct Ways {
    wi: Rows,
    weight: Rows,
    squeeze: Row,
    pdf_w: Row,
    event: Row<Event>,
    /// 1 where there is one.
    some: Row<u32>,
}

impl Default for Ways {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        Self {
            wi: rows,
            weight: rows,
            squeeze: [1.0; LANES],
            pdf_w: row,
            event: [Event::DiffuseReflection; LANES],
            some: [0; LANES],
        }
    }
}

impl Ways {
    /// For so many diffuse surfaces, by numbers of theirs in [0, 1)⁴, of which the first two decide.
    /// No others may have been there before.
    pub fn by_cosine(&mut self, count: usize, lamberts: &Lamberts, fours: &Fours) {
        by_cosine(count, lamberts, fours, self);
    }

    /// The first so many lanes are of surfaces that scatter.
    pub(super) fn scatter(&mut self, count: usize) {
        self.squeeze[..count].fill(1.0);
        self.event[..count].fill(Event::DiffuseReflection);
    }

    /// Gives lanes the ways of mirrors: these, in their order.
    pub(super) fn reflect(&mut self, lanes: Range<usize>, wi: &Rows, reflectance: &Rows) {
        self.go_one_way(&lanes, wi);
        for (weights, all) in self.weight.iter_mut().zip(reflectance) {
            weights[lanes.clone()].copy_from_slice(&all[..lanes.len()]);
        }
        self.squeeze[lanes.clone()].fill(1.0);
        self.event[lanes].fill(Event::SpecularReflection);
    }

    /// Gives lanes the ways of surfaces of clear matter: these, in their order.
    pub(super) fn pass(
        &mut self,
        lanes: Range<usize>,
        wi: &Rows,
        squeeze: &Row,
        reflected: &Row<u32>,
    ) {
        self.go_one_way(&lanes, wi);
        self.weight.iter_mut().for_each(|weights| weights[lanes.clone()].fill(1.0));
        self.squeeze[lanes.clone()].copy_from_slice(&squeeze[..lanes.len()]);
        for (event, reflected) in self.event[lanes].iter_mut().zip(reflected) {
            *event = match reflected {
                0 => Event::SpecularTransmission,
                _ => Event::SpecularReflection,
            };
        }
    }

    /// Of directions that are the only ones.
    fn go_one_way(&mut self, lanes: &Range<usize>, wi: &Rows) {
        for (directions, all) in self.wi.iter_mut().zip(wi) {
            directions[lanes.clone()].copy_from_slice(&all[..lanes.len()]);
        }
        self.pdf_w[lanes.clone()].fill(0.0);
        self.some[lanes.clone()].fill(1);
    }

    /// Gives a lane its way; None: nothing goes on.
    #[inline]
    pub fn put(&mut self, lane: usize, way: Option<Scattered>) {
        self.some[lane] = u32::from(way.is_some());
        if let Some(Scattered { wi, weight, squeeze, pdf_w, event }) = way {
            put(&mut self.wi, lane, wi);
            put(&mut self.weight, lane, weight.to_array().into());
            self.squeeze[lane] = squeeze;
            self.pdf_w[lane] = pdf_w;
            self.event[lane] = event;
        }
    }

    /// The direction of a lane's way.
    #[inline(always)]
    pub fn wi(&self, lane: usize) -> Vec3 {
        get(&self.wi, lane)
    }

    /// The way of a lane, and whether there is one.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> (Scattered, bool) {
        let [r, g, b] = get(&self.weight, lane).to_array();
        let way = Scattered {
            wi: get(&self.wi, lane),
            weight: Rgb::new(r, g, b),
            squeeze: self.squeeze[lane],
            pdf_w: self.pdf_w[lane],
            event: self.event[lane],
        };
        (way, self.some[lane] != 0)
    }
}

by_processor! {
    #[inline(never)]
    fn by_cosine(count: usize, lamberts: &Lamberts, fours: &Fours, ways: &mut Ways) {
        for lane in 0..padded(count) {
            let [u, v, ..] = fours.at(lane);
            let (lambert, _) = lamberts.at(lane);
            let (way, some) = lambert.way([u, v]);
            put(&mut ways.wi, lane, way.wi);
            put(&mut ways.weight, lane, way.weight.to_array().into());
            ways.pdf_w[lane] = way.pdf_w;
            ways.some[lane] = u32::from(some);
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::BVec3;

    use super::super::{Facing, Lambert};
    use super::*;
    use crate::math::random;
    use crate::render::samplers::Sampler;

    #[test]
    fn ways_from_many_surfaces_are_those_from_each() {
        let numbers = |from: u64, lane: usize| random::unit_pair(random::at(from, lane as u64));
        let three = |from: u64, lane: usize| {
            let ([x, y], [z, _]) = (numbers(from, lane), numbers(from + 1, lane));
            2.0 * Vec3::new(x as f32, y as f32, z as f32) - 1.0
        };
        let surfaces: [Lambert; LANES] = std::array::from_fn(|lane| {
            let ng = three(64, lane).normalize();
            let ns = (ng + 0.5 * three(66, lane)).normalize();
            let facing = Facing { wo: ng, ng, ns, front: true };
            let black = BVec3::splat(lane.is_multiple_of(5));
            let albedo = Vec3::select(black, Vec3::ZERO, three(68, lane).abs());
            Lambert { albedo: Rgb::new(albedo.x, albedo.y, albedo.z), ..Lambert::black(&facing) }
        });
        for count in [1, 7, 8, 9, LANES] {
            let (mut lamberts, mut ways) = (Lamberts::default(), Ways::default());
            let mut fours = Fours::default();
            for (lane, surface) in surfaces.iter().enumerate().take(count) {
                lamberts.put(lane, Some((surface, 1.0)));
                fours.push(&mut Sampler::Independent.stream(7, 1, lane as u64));
            }
            fours.draw();
            ways.by_cosine(count, &lamberts, &fours);
            for (lane, surface) in surfaces.iter().enumerate().take(count) {
                let ((way, some), [u, v, ..]) = (ways.at(lane), fours.at(lane));
                let alone = surface.sample([u, v]);
                assert_eq!(some.then_some(way), alone, "{lane} of {count}");
            }
        }
    }
}
