//! Streams of rays: many questions at once.
//!
//! Each answer is to the bit that of the single question, whatever other rays there are and in
//! whatever order; so a stream may be cut anywhere.

use super::ask::Walker;
use super::few::{MeetAll, OccludedAll};
use super::hits::HitAll;
#[cfg(target_arch = "x86_64")]
use super::wide::Avx512;
use super::wide::{Job, Wide};
use super::{Geometry, Hit, Meeting, Ray};

impl Geometry {
    /// [`Self::meet`] of each ray. Panics unless there are as many places as rays.
    pub fn meet_all(&self, rays: &[Ray], met: &mut [Option<Meeting>]) {
        assert_eq!(rays.len(), met.len());
        if let Some(few) = &self.few {
            let geometry = self;
            return self.apart(MeetAll { geometry, few, rays, met });
        }
        for (ray, met) in rays.iter().zip(met) {
            *met = self.meet(ray);
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
        for (ray, occluded) in rays.iter().zip(occluded) {
            *occluded = self.occluded(ray);
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
