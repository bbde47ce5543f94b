//! The questions of a ray, and by whose instructions they are answered.
//!
//! All that happens to a ray is inlined into one function for each kind of processor, so that it is
//! compiled for that processor whole.

use super::best::{Best, Meeting};
use super::lanes::{Lanes, Portable, Task};
use super::ray::Probe;
use super::walk::walk;
use super::{Geometry, Hit, Ray};

/// Whose instructions a ray is met by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Walker {
    Portable(Portable),
    #[cfg(target_arch = "x86_64")]
    Avx2(super::avx2::Avx2),
}

impl Walker {
    /// For any processor.
    pub const PORTABLE: Self = Self::Portable(Portable);

    /// The best that this processor has.
    pub fn found() -> Self {
        #[cfg(target_arch = "x86_64")]
        if !cfg!(feature = "portable")
            && let Some(lanes) = super::avx2::Avx2::found()
        {
            return Self::Avx2(lanes);
        }
        Self::PORTABLE
    }

    /// Does something by these instructions.
    pub fn apart<T: Task>(self, task: T) -> T::Answer {
        match self {
            Self::Portable(lanes) => lanes.apart(task),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(lanes) => lanes.apart(task),
        }
    }

    /// See [`Geometry::closest`].
    #[inline]
    pub fn closest(self, geometry: &Geometry, ray: &Ray) -> Option<Hit> {
        match self {
            Self::Portable(lanes) => closest(lanes, geometry, ray),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(lanes) => {
                let (o, d) = (ray.origin, ray.direction);
                // SAFETY: an `Avx2` is made only where the processor has these instructions.
                unsafe {
                    avx2::closest(
                        lanes,
                        geometry,
                        o.x,
                        o.y,
                        o.z,
                        d.x,
                        d.y,
                        d.z,
                        ray.t_max,
                        ray.leaves,
                        ray.reaches,
                    )
                }
            }
        }
    }

    /// See [`Geometry::occluded`].
    #[inline]
    pub fn occluded(self, geometry: &Geometry, ray: &Ray) -> bool {
        match self {
            Self::Portable(lanes) => occluded(lanes, geometry, ray),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(lanes) => {
                let (o, d) = (ray.origin, ray.direction);
                // SAFETY: as above.
                unsafe {
                    avx2::occluded(
                        lanes,
                        geometry,
                        o.x,
                        o.y,
                        o.z,
                        d.x,
                        d.y,
                        d.z,
                        ray.t_max,
                        ray.leaves,
                        ray.reaches,
                    )
                }
            }
        }
    }

    /// See [`Geometry::meet`]; without instances.
    #[inline]
    pub fn meet(self, geometry: &Geometry, ray: &Ray) -> Option<Meeting> {
        match self {
            Self::Portable(lanes) => meet(lanes, geometry, ray),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(lanes) => {
                let (o, d) = (ray.origin, ray.direction);
                // SAFETY: as above.
                unsafe {
                    avx2::meet(
                        lanes,
                        geometry,
                        o.x,
                        o.y,
                        o.z,
                        d.x,
                        d.y,
                        d.z,
                        ray.t_max,
                        ray.leaves,
                        ray.reaches,
                    )
                }
            }
        }
    }

    /// See [`Geometry::hit`].
    #[inline]
    pub fn hit(self, geometry: &Geometry, ray: &Ray, meeting: &Meeting) -> Hit {
        match self {
            Self::Portable(lanes) => hit(lanes, geometry, ray, meeting),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Self::Avx2(lanes) => unsafe { avx2::hit(lanes, geometry, ray, meeting) },
        }
    }

    /// The first meeting of the ray, with instances; `other` is the first that is no instance's.
    #[inline(never)]
    pub fn meet_crowd(
        self,
        geometry: &Geometry,
        ray: &Ray,
        other: Option<Meeting>,
    ) -> Option<Meeting> {
        match self {
            Self::Portable(lanes) => geometry.crowd.first(lanes, ray, &geometry.shapes, other),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Self::Avx2(lanes) => unsafe { avx2::meet_crowd(lanes, geometry, ray, other) },
        }
    }

    /// Whether the ray meets an instance.
    #[inline(never)]
    pub fn occluded_by_crowd(self, geometry: &Geometry, ray: &Ray) -> bool {
        match self {
            Self::Portable(lanes) => geometry.crowd.occluded(lanes, ray),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Self::Avx2(lanes) => unsafe { avx2::occluded_by_crowd(lanes, geometry, ray) },
        }
    }
}

#[inline(always)]
fn closest<L: Lanes>(lanes: L, geometry: &Geometry, ray: &Ray) -> Option<Hit> {
    let probe = Probe::new(lanes, ray, geometry.tree.moderate)?;
    let meeting = best(lanes, geometry, ray, &probe).meeting()?;
    Some(geometry.hit_of(lanes, &probe, &meeting))
}

#[inline(always)]
fn meet<L: Lanes>(lanes: L, geometry: &Geometry, ray: &Ray) -> Option<Meeting> {
    let probe = Probe::new(lanes, ray, geometry.tree.moderate)?;
    let mut best = best(lanes, geometry, ray, &probe);
    best.settle(lanes, &geometry.tree.blocks, &probe);
    best.meeting()
}

#[inline(always)]
fn best<L: Lanes>(lanes: L, geometry: &Geometry, ray: &Ray, probe: &Probe) -> Best {
    let mut best = Best::before(ray.t_max);
    geometry.meet_planes(probe, &mut best);
    walk::<_, false>(lanes, &geometry.tree, &geometry.shapes, probe, &mut best);
    best
}

#[inline(always)]
fn hit<L: Lanes>(lanes: L, geometry: &Geometry, ray: &Ray, meeting: &Meeting) -> Hit {
    let probe = Probe::new(lanes, ray, geometry.tree.moderate).expect("a ray that met something");
    geometry.hit_of(lanes, &probe, meeting)
}

#[inline(always)]
fn occluded<L: Lanes>(lanes: L, geometry: &Geometry, ray: &Ray) -> bool {
    let Some(probe) = Probe::new(lanes, ray, geometry.tree.moderate) else { return false };
    let mut best = Best::before(ray.t_max);
    geometry.meet_planes(&probe, &mut best);
    best.primitive.is_some()
        || walk::<_, true>(lanes, &geometry.tree, &geometry.shapes, &probe, &mut best)
}

/// The same, compiled for processors with AVX2. A ray's numbers pass one by one, in registers: one
/// in memory has just been written in small parts, and reads of greater ones would wait for them.
#[cfg(target_arch = "x86_64")]
mod avx2 {
    use glam::Vec3;

    use crate::render::geometry::avx2::Avx2;
    use crate::render::geometry::{Geometry, Hit, Meeting, Ray, Sheet};

    macro_rules! compiled {
        ($question:ident -> $answer:ty) => {
            #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
            #[expect(clippy::too_many_arguments, reason = "they are nine numbers in registers")]
            pub fn $question(
                lanes: Avx2,
                geometry: &Geometry,
                ox: f32,
                oy: f32,
                oz: f32,
                dx: f32,
                dy: f32,
                dz: f32,
                t_max: f32,
                leaves: Sheet,
                reaches: Sheet,
            ) -> $answer {
                let (origin, direction) = (Vec3::new(ox, oy, oz), Vec3::new(dx, dy, dz));
                let ray = Ray { origin, direction, t_max, leaves, reaches };
                super::$question(lanes, geometry, &ray)
            }
        };
    }

    compiled!(closest -> Option<Hit>);
    compiled!(meet -> Option<Meeting>);
    compiled!(occluded -> bool);

    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    pub fn hit(lanes: Avx2, geometry: &Geometry, ray: &Ray, meeting: &Meeting) -> Hit {
        super::hit(lanes, geometry, ray, meeting)
    }

    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    pub fn meet_crowd(
        lanes: Avx2,
        geometry: &Geometry,
        ray: &Ray,
        other: Option<Meeting>,
    ) -> Option<Meeting> {
        geometry.crowd.first(lanes, ray, &geometry.shapes, other)
    }

    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    pub fn occluded_by_crowd(lanes: Avx2, geometry: &Geometry, ray: &Ray) -> bool {
        geometry.crowd.occluded(lanes, ray)
    }
}
