//! Streams of rays: many questions at once.
//!
//! Each answer is to the bit that of the single question, whatever other rays there are and in
//! whatever order; so a stream may be cut anywhere.

use super::ask::Walker;
use super::doubts::Doubts;
use super::few::Few;
use super::fleet::{self, MeetFleet, OccludedFleet};
use super::hits::HitAll;
use super::packet::Packet;
#[cfg(target_arch = "x86_64")]
use super::wide::Avx512;
use super::wide::{Job, Wide, ones};
use super::{Geometry, Hit, Meeting, Ray};

impl Geometry {
    /// [`Self::meet`] of each ray. Panics unless there are as many places as rays.
    pub fn meet_all(&self, rays: &[Ray], met: &mut [Option<Meeting>]) {
        assert_eq!(rays.len(), met.len());
        if let Some(few) = &self.few {
            let geometry = self;
            return self.apart(MeetAll { geometry, few, rays, met });
        }
        if rays.len() < fleet::LEAST || self.tree.nodes.is_empty() {
            for (ray, met) in rays.iter().zip(met) {
                *met = self.meet(ray);
            }
            return;
        }
        let walker = self.tree.walker;
        walker.apart(MeetFleet { geometry: self, rays, met });
        if !self.crowd.is_empty() {
            for (ray, met) in rays.iter().zip(met) {
                *met = walker.meet_crowd(self, ray, *met);
            }
        }
    }

    /// [`Self::hit`] of each ray that met something; none of others. Panics unless there are as many
    /// meetings and places as rays.
    pub fn hit_all(&self, rays: &[Ray], met: &[Option<Meeting>], hits: &mut [Option<Hit>]) {
        assert_eq!(rays.len(), met.len());
        assert_eq!(rays.len(), hits.len());
        let geometry = self;
        self.apart(HitAll { geometry, rays, met, hits });
    }

    /// [`Self::occluded`] of each ray. Panics unless there are as many places as rays.
    pub fn occluded_all(&self, rays: &[Ray], occluded: &mut [bool]) {
        assert_eq!(rays.len(), occluded.len());
        if let Some(few) = &self.few {
            let geometry = self;
            return self.apart(OccludedAll { geometry, few, rays, occluded });
        }
        if rays.len() < fleet::LEAST || self.tree.nodes.is_empty() {
            for (ray, occluded) in rays.iter().zip(occluded) {
                *occluded = self.occluded(ray);
            }
            return;
        }
        let walker = self.tree.walker;
        walker.apart(OccludedFleet { geometry: self, rays, occluded });
        if !self.crowd.is_empty() {
            for (ray, occluded) in rays.iter().zip(occluded) {
                *occluded = *occluded || walker.occluded_by_crowd(self, ray);
            }
        }
    }

    /// Does something by the widest instructions there are.
    fn apart<J: Job>(&self, job: J) {
        match self.tree.walker {
            Walker::Portable(wide) => wide.apart(job),
            #[cfg(target_arch = "x86_64")]
            Walker::Avx2(wide) => match Avx512::found() {
                Some(wide) => wide.apart(job),
                None => wide.apart(job),
            },
        }
    }
}

/// A packet of fewer rays than this is not worth its while.
const LONELY: usize = 4;

/// [`Geometry::meet_all`].
pub(super) struct MeetAll<'a> {
    pub geometry: &'a Geometry,
    pub few: &'a Few,
    pub rays: &'a [Ray],
    pub met: &'a mut [Option<Meeting>],
}

impl Job for MeetAll<'_> {
    #[inline(always)]
    fn run<W: Wide>(self, wide: W) {
        let Self { geometry, few, rays, met } = self;
        let (mut packet, mut doubts) = (Packet::EMPTY, Doubts::NONE);
        for (rays, met) in rays.chunks(W::WIDTH).zip(met.chunks_mut(W::WIDTH)) {
            if rays.len() < LONELY {
                for (ray, met) in rays.iter().zip(met) {
                    *met = geometry.meet(ray);
                }
                continue;
            }
            packet.fill::<W>(rays);
            let found = few.first(wide, geometry, &packet, &mut doubts);
            // Two loops: an answer that comes from elsewhere would be copied by way of memory, and so
            // would all others.
            for (lane, met) in met.iter_mut().enumerate() {
                *met = found.meeting(lane);
            }
            for lane in ones(!found.asked & ((1 << rays.len()) - 1)) {
                met[lane] = geometry.meet(&rays[lane]);
            }
            if !few.alone {
                for lane in ones(found.asked) {
                    met[lane] = few.among_others(geometry, &rays[lane], met[lane]);
                }
            }
        }
    }
}

/// [`Geometry::occluded_all`].
pub(super) struct OccludedAll<'a> {
    pub geometry: &'a Geometry,
    pub few: &'a Few,
    pub rays: &'a [Ray],
    pub occluded: &'a mut [bool],
}

impl Job for OccludedAll<'_> {
    #[inline(always)]
    fn run<W: Wide>(self, wide: W) {
        let Self { geometry, few, rays, occluded } = self;
        let (mut packet, mut doubts) = (Packet::EMPTY, Doubts::NONE);
        for (rays, occluded) in rays.chunks(W::WIDTH).zip(occluded.chunks_mut(W::WIDTH)) {
            if rays.len() < LONELY {
                for (ray, occluded) in rays.iter().zip(occluded) {
                    *occluded = geometry.occluded(ray);
                }
                continue;
            }
            packet.fill::<W>(rays);
            let (any, asked) = few.any(wide, geometry, &packet, &mut doubts);
            for (lane, occluded) in occluded.iter_mut().enumerate() {
                *occluded = any & 1 << lane != 0;
            }
            for lane in ones(!asked & ((1 << rays.len()) - 1)) {
                occluded[lane] = geometry.occluded(&rays[lane]);
            }
            if !few.alone {
                for lane in ones(asked & !any) {
                    occluded[lane] = few.others_occlude(geometry, &rays[lane]);
                }
            }
        }
    }
}
