//! Light that samples share: what comes to one from beyond its first diffuse surface serves a whole
//! group [Bekaert02].
//!
//! A path goes from its first diffuse surface, the near one, by the cosine to another, the far one.
//! What that sends back is the same in all directions: so it lights the near surfaces of all samples of
//! the group that see it. Each of them might have found it. So it is parted among them by their
//! densities to do so, by the balance heuristic [Veach95]: the parts are one together, and none is
//! large by itself, in a corner neither.

mod group;

use std::ops::Range;

use glam::Vec3;

use super::World;
use super::carrier::Carrier;
use super::flight::Flight;
use super::guided::Chosen;
use super::path::Path;
use super::roulette::SAFE;
use super::wave::Wave;
use crate::math::Rgb;
use crate::render::geometry::Point;
use crate::render::materials::{Lambert, Matter, Ways};
use group::Group;

/// The samples of a wave, as far as they share light. Kept from wave to wave, for its memory.
#[derive(Default)]
pub(super) struct Reuse {
    samples: Vec<Sample>,
    /// What each brought home before its far surface: the light of all paths, and that of each layer.
    before: Vec<Rgb>,
    /// The same from there on, of those of a group.
    beyond: Vec<Rgb>,
    /// Far surfaces of this turn that the cosine has not chosen: that light is for those it chooses.
    strays: Vec<usize>,
    group: Group,
}

/// What a sample gives to others, and takes from them.
#[derive(Clone, Copy, Default)]
struct Sample {
    near: Option<Near>,
    far: Option<Far>,
    /// It is no longer on the way from one to the other.
    is_beyond: bool,
}

/// The first diffuse surface of a path.
#[derive(Clone, Copy)]
struct Near {
    point: Point,
    lambert: Lambert,
    /// What the camera gets of the radiance that comes from a direction, times its density by the
    /// cosine.
    throughput: Rgb,
    /// How the way on was chosen: by the cosine, or by photons.
    chosen: Chosen,
    /// Samples share light with those alone for which all beyond the far surface counts the same.
    kind: Kind,
}

/// The surfaces before, where their number is bounded, and where its path stands among those that are
/// shown.
type Kind = (u32, u16);

/// The next one.
#[derive(Clone, Copy)]
struct Far {
    point: Point,
    /// Geometric normal on the side of the near surface.
    ng: Vec3,
}

impl Path {
    /// Whether samples share light.
    pub(super) fn shares(&self) -> bool {
        self.reuse > 1
    }

    /// Notes which of the surfaces that were met are the near and the far ones of their samples.
    pub(super) fn note<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let Flight { branches, surfaces, lit, turns, reuse, .. } = flight;
        reuse.strays.clear();
        for (nth, surface) in surfaces.iter().enumerate() {
            let lane = surface.lane;
            let (branch, carrier) = (&mut branches[lane], &mut wave.carriers[lane]);
            let sample = &mut reuse.samples[lane];
            if sample.is_beyond {
                continue;
            }
            let (lambert, chance) = lit.lamberts.at(nth);
            let is_diffuse = surface.scatters && chance == 1.0 && !lambert.albedo().is_black();
            let point = surface.site.point;
            if let Some(near) = &sample.near {
                sample.is_beyond = true;
                if is_diffuse && !surface.split.specular {
                    sample.far = Some(Far { point, ng: lambert.normal() });
                    if !near.chosen.is_own {
                        reuse.strays.push(nth);
                    }
                    reuse.put_by(lane, carrier);
                    (branch.throughput, branch.squeeze) = (Rgb::ONE, 1.0);
                    turns.begin_anew(nth);
                }
            } else if is_diffuse && !surface.split.is_any() && carrier.waiting.is_empty() {
                let throughput = branch.throughput * lambert.albedo();
                let met = branch.scattered + branch.mirrored;
                let bounded = if self.depth == u32::MAX { 0 } else { met };
                let kind = (bounded, branch.trail.state());
                let chosen = Chosen::OWN;
                sample.near = Some(Near { point, lambert, throughput, chosen, kind });
                turns.limit(nth, SAFE);
            }
        }
    }
}

impl Path {
    /// Parts among the samples of each group what has come from their far surfaces.
    pub(super) fn share<M: Matter>(&self, wave: &mut Wave, flight: &mut Flight<M>) {
        let mut first = 0;
        for nth in 0..wave.groups.len() {
            let samples = first..wave.groups[nth];
            first = samples.end;
            let rays = flight.reuse.share(wave.world, samples, &mut wave.carriers);
            wave.follow(rays);
            if wave.given_up {
                return;
            }
        }
    }
}

impl Reuse {
    /// Begins a wave of so many samples, with so many layers.
    pub fn begin(&mut self, samples: usize, layers: usize) {
        self.samples.clear();
        self.samples.resize(samples, Sample::default());
        self.before.clear();
        self.before.resize(samples * (1 + layers), Rgb::BLACK);
    }

    /// How the way on of a sample is chosen.
    #[inline(always)]
    pub fn choose(&mut self, sample: usize, chosen: Chosen) {
        if let Some(Sample { near: Some(near), is_beyond: false, .. }) =
            self.samples.get_mut(sample)
        {
            near.chosen = chosen;
        }
    }

    /// Takes their ways on from paths whose light others bring.
    pub fn end_strays(&mut self, ways: &mut Ways) {
        for nth in self.strays.drain(..) {
            ways.put(nth, None);
        }
    }

    /// Puts by what a sample has brought home so far.
    fn put_by(&mut self, sample: usize, carrier: &mut Carrier) {
        let width = 1 + carrier.layers.len();
        let before = &mut self.before[sample * width..(sample + 1) * width];
        before[0] = std::mem::replace(&mut carrier.radiance, Rgb::BLACK);
        before[1..].swap_with_slice(&mut carrier.layers);
    }

    /// Parts among the samples of a group what has come from their far surfaces. Returns how many rays
    /// that took.
    pub fn share(
        &mut self,
        world: &World,
        samples: Range<usize>,
        carriers: &mut [Carrier],
    ) -> usize {
        let Self { samples: all, before, beyond, group, .. } = self;
        let width = 1 + world.film.layers;
        group.clear();
        beyond.clear();
        for (nth, sample) in samples.clone().enumerate() {
            if let Some(near) = &all[sample].near {
                group.push_near(nth, near);
            }
        }
        let carriers = &mut carriers[samples.clone()];
        let mut lane = 0;
        for (sample, carrier) in samples.zip(&mut *carriers) {
            let Sample { near: Some(near), far, .. } = &all[sample] else { continue };
            lane += 1;
            let Some(far) = far else { continue };
            let before = &before[sample * width..(sample + 1) * width];
            let first = beyond.len();
            beyond.push(std::mem::replace(&mut carrier.radiance, before[0]));
            beyond.extend_from_slice(&carrier.layers);
            carrier.layers.copy_from_slice(&before[1..]);
            if !near.chosen.is_own {
                beyond.truncate(first);
                continue;
            }
            let is_shared = beyond[first..].iter().all(|light| light.is_finite());
            carrier.shadow_rays += group.push_far(far, lane - 1, is_shared);
        }
        group.look(world);
        for (nth, light) in beyond.chunks_exact(width).enumerate() {
            for (sample, part) in group.parts(nth) {
                let carrier = &mut carriers[sample];
                carrier.radiance += part * light[0];
                for (sum, light) in carrier.layers.iter_mut().zip(&light[1..]) {
                    *sum += part * *light;
                }
            }
        }
        group.rays()
    }
}
