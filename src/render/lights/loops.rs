//! Loops of vectors over many sites that ask the same light.

use super::lamp::Lamp;
use super::rectangle::Rectangle;
use super::together::{Found, Sites};
use super::{Arrival, Directional};
use crate::math::Rgb;
use crate::render::lanes::{Row, by_processor, padded};

by_processor! {
    /// Light of a lamp that is one rectangle.
    #[inline(never)]
    pub(super) fn from_rectangle(
        rectangle: &Rectangle,
        lamp: &Lamp,
        sites: &Sites,
        u: [&Row<f64>; 2],
        found: &mut Found,
    ) {
        let both = lamp.both();
        for lane in 0..padded(sites.lanes().len()) {
            let from = sites.point(lane);
            let u = [u[0][lane], u[1][lane]];
            let (sampled, is_seen) = rectangle.see((&from, both), u);
            let arrival = lamp.arrival(&from, &sampled, 1.0);
            let irradiance = Rgb::new(
                if is_seen { arrival.irradiance.r } else { 0.0 },
                if is_seen { arrival.irradiance.g } else { 0.0 },
                if is_seen { arrival.irradiance.b } else { 0.0 },
            );
            found.put(lane, &Arrival { irradiance, ..arrival });
        }
    }
}

by_processor! {
    /// Parallel light.
    #[inline(never)]
    pub(super) fn from_direction(directional: &Directional, sites: &Sites, found: &mut Found) {
        for lane in 0..padded(sites.lanes().len()) {
            found.put(lane, &directional.arrive(&sites.point(lane)));
        }
    }
}
