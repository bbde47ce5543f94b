//! What many mirrors and smooth metals do with light, one lane for each.

use super::facing::Facings;
use super::{Conductor, Facing, Material, Surface, Ways};
use crate::math::Rgb;
use crate::optics::fresnel;
use crate::render::lanes::{LANES, Row, Rows, by_processor, padded, put};

/// Mirrors and metals side by side.
pub(super) struct Reflectors {
    count: usize,
    seen: Facings,
    /// Where light comes from that they give back, and its cosine to their normals.
    wi: Rows,
    cos: Row,
    /// The part of it; of a metal it is found in the end.
    reflectance: Rows,
    /// The lanes of metals, and their materials' numbers.
    metals: Vec<(usize, u32)>,
    channels: Channels,
}

/// Metals of an index for each channel, side by side.
struct Channels {
    /// Their lanes among all.
    lanes: Vec<usize>,
    n: [Row<f64>; 3],
    k: [Row<f64>; 3],
    cos: Row,
    reflectance: Rows,
}

impl Default for Reflectors {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        let indices = [[1.0; LANES]; 3];
        let channels =
            Channels { lanes: Vec::new(), n: indices, k: indices, cos: row, reflectance: rows };
        let seen = Facings::default();
        Self { count: 0, seen, wi: rows, cos: row, reflectance: rows, metals: Vec::new(), channels }
    }
}

impl Reflectors {
    /// Forgets them.
    pub fn clear(&mut self) {
        self.count = 0;
        self.metals.clear();
    }

    /// One more: a mirror that gives back this part of the light.
    #[inline]
    pub fn mirror(&mut self, facing: &Facing, reflectance: Rgb) {
        put(&mut self.reflectance, self.count, reflectance.to_array().into());
        self.seen.put(self.count, facing);
        self.count += 1;
    }

    /// One more: a metal, by the number of its material.
    #[inline]
    pub fn metal(&mut self, facing: &Facing, material: u32) {
        self.metals.push((self.count, material));
        self.seen.put(self.count, facing);
        self.count += 1;
    }

    /// Their ways, from lane `first` on. How many there are.
    pub fn ways(&mut self, materials: &[Material], first: usize, ways: &mut Ways) -> usize {
        if self.count > 0 {
            mirrored(self.count, self);
            self.ask_metals(materials);
            ways.reflect(first..first + self.count, &self.wi, &self.reflectance);
        }
        self.count
    }

    /// Finds what metals give back.
    fn ask_metals(&mut self, materials: &[Material]) {
        let Self { cos, reflectance, channels, .. } = self;
        channels.lanes.clear();
        for &(lane, material) in &self.metals {
            match &materials[material as usize].surface {
                Surface::Conductor(Conductor::Channels { n, k }) => {
                    let nth = channels.lanes.len();
                    (0..3).for_each(|i| channels.n[i][nth] = n[i]);
                    (0..3).for_each(|i| channels.k[i][nth] = k[i]);
                    channels.cos[nth] = cos[lane];
                    channels.lanes.push(lane);
                }
                Surface::Conductor(metal) => {
                    let part = metal.reflectance(cos[lane]);
                    put(reflectance, lane, part.to_array().into());
                }
                other => debug_assert!(false, "{other:?} among metals"),
            }
        }
        conducted(channels.lanes.len(), channels);
        for (nth, &lane) in channels.lanes.iter().enumerate() {
            (0..3).for_each(|i| reflectance[i][lane] = channels.reflectance[i][nth]);
        }
    }
}

by_processor! {
    #[inline(never)]
    fn mirrored(count: usize, all: &mut Reflectors) {
        for lane in 0..padded(count) {
            let facing = all.seen.at(lane);
            let (wi, ns) = facing.mirrored();
            put(&mut all.wi, lane, wi);
            all.cos[lane] = Conductor::cosine(&facing, ns);
        }
    }
}

by_processor! {
    #[inline(never)]
    fn conducted(count: usize, channels: &mut Channels) {
        for i in 0..3 {
            for lane in 0..padded(count) {
                let (n, k) = (channels.n[i][lane], channels.k[i][lane]);
                let part = fresnel::conductor(n, k, channels.cos[lane].into());
                channels.reflectance[i][lane] = part as f32;
            }
        }
    }
}
