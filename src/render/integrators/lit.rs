//! What lamps bring to many surfaces at once, if nothing is in the way.

use glam::Vec3;

use super::lighting::Lighting;
use super::path::{Path, power};
use super::turns::Turns;
use crate::math::Rgb;
use crate::render::lanes::{LANES, Parted, Row, Rows, by_processor, get, padded, put};
use crate::render::lights::Arrivals;
use crate::render::materials::{Lambert, Lamberts};

/// Surfaces that light is scattered by, one lane for each, and what that brings.
pub(super) struct Lit {
    pub lamberts: Lamberts,
    /// Rays that go on from each.
    rays: Row,
    light: Rows,
    /// 1 where there is any.
    some: Row<u32>,
    /// Where that is.
    brought: Parted,
}

impl Default for Lit {
    fn default() -> Self {
        Self {
            lamberts: Lamberts::default(),
            rays: [0.0; LANES],
            light: [[0.0; LANES]; 3],
            some: [0; LANES],
            brought: Parted::default(),
        }
    }
}

impl Lit {
    /// Gives a lane its surface, with the chance of it among so many rays that go on.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, surface: Option<(&Lambert, f32)>, rays: u32) {
        self.lamberts.put(lane, surface);
        self.rays[lane] = rays as f32;
    }

    /// Finds what the first so many lanes bring home, and which of them bring anything, in their
    /// order.
    pub fn find(
        &mut self,
        count: usize,
        (path, lighting): (&Path, &Lighting),
        (arrivals, turns): (&Arrivals, &Turns),
    ) -> impl Iterator<Item = (usize, Rgb)> {
        light_all(count, path, lighting, (arrivals, turns), self);
        let Self { light, some, brought, .. } = self;
        let [brought, _] = brought.by(count, |lane| some[lane] != 0);
        brought.iter().map(|&lane| {
            let [r, g, b] = get(light, lane as usize).to_array();
            (lane as usize, Rgb::new(r, g, b))
        })
    }
}

by_processor! {
    #[inline(never)]
    fn light_all(
        count: usize,
        path: &Path,
        lighting: &Lighting,
        asked: (&Arrivals, &Turns),
        lit: &mut Lit,
    ) {
        let (arrivals, turns) = asked;
        for lane in 0..padded(count) {
            let (lambert, chance) = lit.lamberts.at(lane);
            let seen = (turns.throughput(lane), &lambert, [lit.rays[lane], chance]);
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
