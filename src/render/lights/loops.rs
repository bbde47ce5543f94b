//! Loops of vectors over many sites that ask the same light.

use super::lamp::Lamp;
use super::rectangle::Rectangle;
use super::together::{Found, Sites};
use super::views::Views;
use super::{Arrival, Directional};
use crate::math::Rgb;
use crate::render::lanes::{Row, by_processor, padded};

by_processor! {
    /// Light of a lamp that is one rectangle.
    ///
    /// Each lane is a long chain of roots and quotients. In three loops, the processor begins those of
    /// the next lanes while it waits for one.
    #[inline(never)]
    pub(super) fn from_rectangle(
        rectangle: &Rectangle,
        lamp: &Lamp,
        sites: &Sites,
        u: [&Row<f64>; 2],
        views: &mut Views,
        found: &mut Found,
    ) {
        let (both, count) = (lamp.both(), padded(sites.lanes().len()));
        let [first, second] = u;
        for lane in 0..count {
            views.put(lane, &rectangle.view(&sites.point(lane), both));
        }
        for lane in 0..count {
            let view = views.at(lane, rectangle);
            views.look(lane, &rectangle.place(&view, [first[lane], second[lane]]));
        }
        for lane in 0..count {
            let (from, view) = (sites.point(lane), views.at(lane, rectangle));
            let (sampled, is_seen) = rectangle.see(&from, &view, &views.place(lane));
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
