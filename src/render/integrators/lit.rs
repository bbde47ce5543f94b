//! What lamps bring to many surfaces at once, if nothing is in the way.

use glam::Vec3;

use super::lighting::Lighting;
use super::path::{Path, power};
use crate::math::Rgb;
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};
use crate::render::lights::Arrivals;
use crate::render::materials::{Lambert, Lamberts};

/// Surfaces that light is scattered by, one lane for each, and what that brings.
pub(super) struct Lit {
    lamberts: Lamberts,
    /// Of the paths that have come to them.
    throughput: Rows,
    /// Rays that go on from each.
    rays: Row,
    light: Rows,
    /// 1 where there is any.
    some: Row<u32>,
    /// The lanes where there is.
    places: Row<u32>,
}

impl Default for Lit {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        let (some, places) = ([0; LANES], [0; LANES]);
        Self {
            lamberts: Lamberts::default(),
            throughput: rows,
            rays: row,
            light: rows,
            some,
            places,
        }
    }
}

impl Lit {
    /// Gives a lane its surface, with the chance of it among so many rays that go on, and the
    /// throughput of the path that has come to it.
    #[inline(always)]
    pub fn put(
        &mut self,
        lane: usize,
        surface: Option<(&Lambert, f32)>,
        (throughput, rays): (Rgb, u32),
    ) {
        self.lamberts.put(lane, surface);
        put(&mut self.throughput, lane, throughput.to_array().into());
        self.rays[lane] = rays as f32;
    }

    /// Finds what arrives at the first so many lanes, and those to which something does, in their
    /// order.
    pub fn find(
        &mut self,
        count: usize,
        (path, lighting): (&Path, &Lighting),
        arrivals: &Arrivals,
    ) -> impl Iterator<Item = (usize, Rgb)> {
        light_all(count, path, lighting, arrivals, self);
        let mut found = 0;
        for lane in 0..count {
            self.places[found % LANES] = lane as u32;
            found += self.some[lane] as usize;
        }
        let light = &self.light;
        self.places[..found].iter().map(|&place| {
            let [r, g, b] = get(light, place as usize).to_array();
            (place as usize, Rgb::new(r, g, b))
        })
    }
}

by_processor! {
    #[inline(never)]
    fn light_all(
        count: usize,
        path: &Path,
        lighting: &Lighting,
        arrivals: &Arrivals,
        lit: &mut Lit,
    ) {
        for lane in 0..padded(count) {
            let (lambert, chance) = lit.lamberts.at(lane);
            let [r, g, b] = get(&lit.throughput, lane).to_array();
            let seen = (Rgb::new(r, g, b), &lambert, [lit.rays[lane], chance]);
            let arrived = (arrivals.wi(lane), arrivals.irradiance(lane));
            let (light, some) = path.light_of(lighting, seen, arrived, arrivals.density(lane));
            put(&mut lit.light, lane, light.to_array().into());
            lit.some[lane] = u32::from(some);
        }
    }
}

impl Path {
    /// What a light that was asked brings if nothing is in its way, and whether that is anything: one
    /// that arrives at a surface by a path of this throughput; so many rays go on from there, by this
    /// chance each. Its direction was found with density `pdf_w`, in so many samples.
    #[inline(always)]
    pub(super) fn light_of(
        &self,
        lighting: &Lighting,
        (throughput, lambert, [rays, chance]): (Rgb, &Lambert, [f32; 2]),
        (wi, irradiance): (Vec3, Rgb),
        (pdf_w, taken): (f32, f32),
    ) -> (Rgb, bool) {
        let (scattered, some) = lighting.scattered(lambert, wi, irradiance);
        let density = taken * pdf_w;
        // No other way finds it, or none is to count.
        let alone = (density == 0.0) | !self.mis;
        let weighed = power(density, rays * (chance * lambert.pdf_w(wi)));
        let part = if alone { 1.0 } else { weighed };
        (throughput * scattered * (part / taken), some)
    }
}
