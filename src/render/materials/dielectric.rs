//! A smooth surface between two kinds of clear matter: Fresnel's formulas and Snell's law.

use glam::{BVec3, Vec3};

use super::{Event, Facing, Scattered};
use crate::math::Rgb;
use crate::optics::fresnel::{self, Boundary};

/// A surface between two media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Index of refraction behind the face.
    pub inside: f64,
    /// Index of refraction before it.
    pub outside: f64,
}

impl Dielectric {
    pub(super) fn at(&self, facing: &Facing) -> Interface {
        Interface::new(facing, self.indices(facing))
    }

    /// The index on the viewer's side, and that beyond.
    #[inline]
    pub(super) fn indices(&self, facing: &Facing) -> [f64; 2] {
        if facing.front { [self.outside, self.inside] } else { [self.inside, self.outside] }
    }
}

impl Interface {
    /// Between these indices, here and beyond. Without jumps, so that a loop over it becomes vectors.
    #[inline(always)]
    pub(super) fn new(facing: &Facing, [here, beyond]: [f64; 2]) -> Self {
        let (wi, ns) = facing.mirrored();
        let cos = facing.wo.as_dvec3().dot(ns.as_dvec3()).clamp(0.0, 1.0);
        // Of indices that are nearly the same the difference is exact, the quotient is not.
        let boundary = fresnel::dielectric((beyond - here) / here, cos);
        Self { facing: Facing { ns, ..*facing }, wi, eta: beyond / here, boundary }
    }
}

/// Such a surface at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    /// With a normal at which the mirrored direction is above the surface.
    facing: Facing,
    /// Where reflected light comes from.
    wi: Vec3,
    /// Index beyond over the index on the viewer's side.
    eta: f64,
    boundary: Boundary,
}

impl Interface {
    /// Where reflected light comes from.
    pub(super) fn wi(&self) -> Vec3 {
        self.wi
    }

    /// The part of the light that is reflected.
    #[inline(always)]
    pub(super) fn reflectance(&self) -> f32 {
        self.boundary.reflectance as f32
    }

    /// The part of the light that goes through.
    pub(super) fn transmittance(&self) -> f32 {
        (1.0 - self.boundary.reflectance) as f32
    }

    pub(super) fn reflected(&self) -> Option<Scattered> {
        (self.boundary.reflectance > 0.0).then_some(Scattered {
            wi: self.wi,
            weight: Rgb::grey(self.reflectance()),
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        })
    }

    pub(super) fn refracted(&self) -> Option<Scattered> {
        if self.boundary.reflectance >= 1.0 {
            return None;
        }
        Some(Scattered {
            wi: self.through(),
            weight: Rgb::grey(self.transmittance()),
            squeeze: self.squeeze(),
            pdf_w: 0.0,
            event: Event::SpecularTransmission,
        })
    }

    /// Where light comes from that goes through, if any does.
    #[inline(always)]
    fn through(&self) -> Vec3 {
        let Facing { wo, ns, .. } = self.facing;
        let bend = self.boundary.bend;
        let bent = -(wo.as_dvec3() + bend * ns.as_dvec3()).normalize().as_vec3();
        // Without a boundary the way on is the way so far, to the bit.
        self.facing.below(Vec3::select(BVec3::splat(bend == 0.0), -wo, bent))
    }

    #[inline(always)]
    fn squeeze(&self) -> f32 {
        (1.0 / (self.eta * self.eta)) as f32
    }

    /// One of the two, each as often as light goes there: its direction, what it is squeezed, and
    /// whether it is the first. Without jumps, so that a loop over it becomes vectors.
    #[inline(always)]
    pub(super) fn way(&self, u: f64) -> (Vec3, f32, bool) {
        let reflected = u < self.boundary.reflectance;
        let wi = Vec3::select(BVec3::splat(reflected), self.wi, self.through());
        (wi, if reflected { 1.0 } else { self.squeeze() }, reflected)
    }

    /// The same.
    pub(super) fn sample(&self, u: f64) -> Scattered {
        let (wi, squeeze, reflected) = self.way(u);
        let event = if reflected { Event::SpecularReflection } else { Event::SpecularTransmission };
        Scattered { wi, weight: Rgb::ONE, squeeze, pdf_w: 0.0, event }
    }
}

#[cfg(test)]
mod tests {
    use super::super::facing::tests::{above, seen};
    use super::*;

    const INDICES: [f64; 6] = [1.0, 1.0 + 1e-7, 1.33, 1.5, 2.42, 100.0];

    fn surface(inside: f64, behind: bool) -> Dielectric {
        let (inside, outside) = if behind { (1.0, inside) } else { (inside, 1.0) };
        Dielectric { inside, outside }
    }

    #[test]
    fn all_light_goes_on_and_on_its_side_of_the_surface() {
        for (i, index) in (0..60_000).zip(INDICES.into_iter().cycle()) {
            let facing = seen(above(i), above(i + 1_000_000));
            let glass = surface(index, i % 4 < 2).at(&facing);
            let ways = [glass.reflected(), glass.refracted()];
            let sum: f32 = ways.iter().flatten().map(|way| way.weight.g).sum();
            assert!((sum - 1.0).abs() < 1e-6, "{index}: {facing:?}");
            for way in ways.iter().flatten() {
                let up = way.event == Event::SpecularReflection;
                assert!(way.wi.is_finite() && (way.wi.z > 0.0) == up && way.wi.z != 0.0);
                assert!((way.wi.length() - 1.0).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn refraction_obeys_its_law_and_can_be_reversed() {
        for (i, index) in (0..60_000).zip(INDICES.into_iter().cycle()) {
            let facing = seen(above(i), Vec3::Z);
            let down = surface(index, false);
            let Some(way) = down.at(&facing).refracted() else {
                assert!(facing.wo.z < 1e-6, "{index}: {facing:?}");
                continue;
            };
            // The components along the surface, by Snell's law.
            let along = facing.wo.truncate().as_dvec2() + index * way.wi.truncate().as_dvec2();
            assert!(along.length() < 2e-7 * index, "{index}: {facing:?}");
            assert!((way.squeeze * (index * index) as f32 - 1.0).abs() < 1e-6);
            // From the other side the same part of the light comes the same way.
            let back = Facing { wo: way.wi, ng: -Vec3::Z, ns: -Vec3::Z, front: false };
            let there = down.at(&facing);
            let back = down.at(&back);
            let cos = f64::from(facing.wo.z);
            // Rounding of directions is rounding of angles, and matters where they graze, or where
            // a little more would be reflected totally.
            if cos > 1e-2 && index < 3.0 {
                let off = (there.boundary.reflectance - back.boundary.reflectance).abs();
                assert!(off < 1e-3, "{index} {cos}: {off}");
                let again = back.refracted().map_or(facing.wo, |back| back.wi);
                assert!((again - facing.wo).length() < 1e-3, "{index}: {again} {facing:?}");
            }
        }
    }

    #[test]
    fn no_difference_of_indices_is_no_surface() {
        for i in 0..10_000 {
            let facing = seen(above(i), above(i + 1_000_000));
            let glass = Dielectric { inside: 1.5, outside: 1.5 }.at(&facing);
            assert!(glass.reflected().is_none());
            let way = glass.refracted().unwrap();
            assert!(way.wi == -facing.wo && way.weight == Rgb::ONE && way.squeeze == 1.0);
        }
    }
}
