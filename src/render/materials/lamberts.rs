//! What many surfaces scatter to all sides, one lane for each.

use super::Lambert;
use crate::math::Rgb;
use crate::render::lanes::{LANES, Row, Rows, get, put};

/// Diffuse surfaces side by side.
pub struct Lamberts {
    albedo: Rows,
    ng: Rows,
    ns: Rows,
    /// With which chance a way on is sampled of them.
    chance: Row,
}

impl Default for Lamberts {
    fn default() -> Self {
        let rows = [[0.0; LANES]; 3];
        Self { albedo: rows, ng: rows, ns: rows, chance: [0.0; LANES] }
    }
}

impl Lamberts {
    /// Gives a lane its surface, and the chance of it; None: it scatters nothing.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, surface: Option<(&Lambert, f32)>) {
        let Some((lambert, chance)) = surface else {
            put(&mut self.albedo, lane, glam::Vec3::ZERO);
            self.chance[lane] = 0.0;
            return;
        };
        put(&mut self.albedo, lane, lambert.albedo.to_array().into());
        put(&mut self.ng, lane, lambert.ng);
        put(&mut self.ns, lane, lambert.ns);
        self.chance[lane] = chance;
    }

    /// The surface of a lane, and the chance of it.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> (Lambert, f32) {
        let [r, g, b] = get(&self.albedo, lane).to_array();
        let (ng, ns) = (get(&self.ng, lane), get(&self.ns, lane));
        (Lambert { albedo: Rgb::new(r, g, b), ng, ns }, self.chance[lane])
    }
}
