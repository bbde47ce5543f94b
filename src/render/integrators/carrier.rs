//! What a sample carries along: what it found, and by which paths.

use glam::Vec3;

use super::traced::{Source, Tracing};
use crate::math::Rgb;
use crate::math::paths::{Automaton, End, Event};
use crate::render::World;
use crate::render::geometry::{Hit, Ray};
use crate::render::lights::Site;
use crate::render::materials::Scattered;
use crate::render::overlaps::Overlaps;

/// What a sample brings home.
pub struct Carrier<'w> {
    /// Rays to lamps.
    pub shadow_rays: u64,
    /// Radiance along the camera's ray, in light units.
    pub radiance: Rgb,
    /// The part of it that belongs to each layer.
    pub layers: Vec<Rgb>,
    /// Which paths belong where; None: all to the picture alone.
    paths: Option<&'w Automaton>,
    /// Which bodies end where others begin.
    overlaps: Option<&'w Overlaps>,
    /// The paths themselves, where they are asked for.
    pub(super) traced: Option<Tracing>,
    /// Number of the object that the camera's ray met.
    pub object: Option<u32>,
    /// Rays that wait to be followed; kept from sample to sample, for its memory.
    pub(super) waiting: Vec<Branch>,
    /// Rays of this sample that were to be followed.
    followed: u64,
    /// Whether to give up a sample that has followed so many rays; asked now and then.
    give_up: Option<&'w GiveUp<'w>>,
    /// The sample was given up: what it found is no sample.
    pub given_up: bool,
}

/// Whether to give up a sample, by the rays that it has followed; or samples that are taken together, by
/// those of all.
pub type GiveUp<'w> = dyn Fn(u64) -> bool + Sync + 'w;

/// Rays between two questions whether to go on: some hundred microseconds. Of a sample that is alone,
/// or of a wave.
pub(super) const PATIENCE: u64 = 1024;

/// A ray that light is followed along, backwards, and what is known of the way so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch {
    pub ray: Ray,
    /// What one unit of radiance along the ray brings to the camera.
    pub throughput: Rgb,
    /// The part of the throughput that roulette does not count: radiance is squeezed into less solid
    /// angle in matter of a higher index, and comes back when light leaves; and where paths are sent
    /// for more light than elsewhere, each counts less.
    pub squeeze: f32,
    pub trail: Trail,
    /// Where the ray comes from.
    pub site: Site,
    /// Density of the ray's direction there, times the rays that were sent by it; 0 if it is
    /// the camera's, or reflected or refracted by a smooth surface.
    pub pdf_w: f32,
    /// Surfaces at which all specular ways were followed.
    pub specular_splits: u32,
    /// Surfaces from which several rays went on.
    pub diffuse_splits: u32,
    /// Surfaces that scattered.
    pub scattered: u32,
    /// Surfaces that reflected or refracted in one direction alone.
    pub mirrored: u32,
    /// Bits of overlapping bodies that the ray is inside of.
    pub inside: u64,
}

/// Where a path stands among those that are asked for, and which one it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trail {
    /// Of the automaton.
    state: u16,
    /// Number of its last surface among those that are traced; [`Tracing::EYE`] if it has none.
    last: u32,
}

impl Trail {
    /// From the eye.
    pub(super) const START: Self = Self { state: Automaton::START, last: Tracing::EYE };

    /// Where it stands.
    pub(super) fn state(self) -> u16 {
        self.state
    }
}

impl<'w> Carrier<'w> {
    /// With nothing found, for a film of this world.
    pub fn new(world: &'w World, give_up: Option<&'w GiveUp<'w>>) -> Self {
        Self {
            shadow_rays: 0,
            radiance: Rgb::BLACK,
            layers: vec![Rgb::BLACK; world.film.layers],
            paths: world.paths.as_ref(),
            overlaps: world.overlaps.as_ref(),
            traced: None,
            object: None,
            waiting: Vec::new(),
            followed: 0,
            give_up,
            given_up: false,
        }
    }

    /// Begins a sample.
    #[inline]
    pub fn start(&mut self) -> Trail {
        self.shadow_rays = 0;
        self.radiance = Rgb::BLACK;
        self.layers.fill(Rgb::BLACK);
        self.object = None;
        self.waiting.clear();
        self.followed = 0;
        if let Some(traced) = &mut self.traced {
            traced.clear();
        }
        Trail::START
    }

    /// A path goes on by one more event, at the position of a surface.
    #[inline]
    pub fn after(&mut self, trail: Trail, event: Event, position: Vec3) -> Trail {
        let state = self.paths.map_or(trail.state, |paths| paths.after(trail.state, event));
        let last = match &mut self.traced {
            None => trail.last,
            Some(traced) => traced.after(trail.last, event, position),
        };
        Trail { state, last }
    }

    /// A branch goes on behind an event at the position of a surface. Whether it is to be followed: not
    /// if nothing is shown of its path, however it goes on. All of the hit is asked for where bodies
    /// overlap.
    #[inline]
    pub(super) fn behind<'h>(
        &mut self,
        branch: &mut Branch,
        (event, position): (Event, Vec3),
        hit: impl FnOnce() -> Option<&'h Hit>,
    ) -> bool {
        self.followed += 1;
        if self.followed.is_multiple_of(PATIENCE) && self.gives_up() {
            return false;
        }
        if let (Some(overlaps), Event::SpecularTransmission) = (self.overlaps, event)
            && let Some(hit) = hit()
        {
            branch.inside = overlaps.beyond(branch.inside, hit, branch.ray.direction);
        }
        branch.trail = self.after(branch.trail, event, position);
        !self.paths.is_some_and(|paths| paths.is_dead(branch.trail.state))
    }

    #[cold]
    fn gives_up(&mut self) -> bool {
        if !self.give_up.is_some_and(|give_up| give_up(self.followed)) {
            return false;
        }
        self.given_up = true;
        self.waiting.clear();
        // The next one is not followed either.
        self.followed -= 1;
        true
    }

    /// The same, and it is followed later.
    pub(super) fn follow(&mut self, mut branch: Branch, event: Event, hit: &Hit) {
        if self.behind(&mut branch, (event, hit.position), || Some(hit)) {
            self.waiting.push(branch);
        }
    }

    /// Whether nothing is shown of a path that comes to a light now.
    #[inline]
    pub fn is_hidden(&self, trail: Trail) -> bool {
        self.paths.is_some_and(|paths| paths.end(trail.state) == End::Outside)
    }

    /// A path asks a light that brings this radiance if nothing is in its way.
    pub fn ask(
        &mut self,
        world: &World,
        shadows: bool,
        ray: &Ray,
        (trail, radiance): (Trail, Rgb),
    ) {
        self.shadow_rays += u64::from(shadows);
        if !(shadows && world.geometry.occluded(ray)) {
            self.add(trail, radiance, || Source::of(ray));
        }
    }

    /// A path has come to a light, and brings this radiance.
    #[inline]
    pub fn add(&mut self, trail: Trail, radiance: Rgb, source: impl FnOnce() -> Source) {
        if let Some(paths) = self.paths {
            match paths.end(trail.state) {
                End::Outside => return,
                End::Picture => {}
                End::Layer(layer) => {
                    // A film may have less of them, where only the picture is wanted.
                    if let Some(sum) = self.layers.get_mut(usize::from(layer)) {
                        *sum += radiance;
                    }
                }
            }
        }
        if let Some(traced) = &mut self.traced {
            traced.add(trail.last, radiance, source());
        }
        self.radiance += radiance;
    }
}

impl Branch {
    /// Not begun.
    pub const BLANK: Self = Self {
        ray: Ray::new(Vec3::ZERO, Vec3::Z),
        throughput: Rgb::ONE,
        squeeze: 1.0,
        trail: Trail::START,
        site: Site::free(Vec3::ZERO),
        pdf_w: 0.0,
        specular_splits: 0,
        diffuse_splits: 0,
        scattered: 0,
        mirrored: 0,
        inside: 0,
    };

    /// The camera's ray.
    pub fn first(world: &World, ray: &Ray, trail: Trail) -> Self {
        let mut branch = Self::BLANK;
        branch.begin(world, ray, trail);
        branch
    }

    /// Becomes the camera's ray. In its place: one that is put together elsewhere is copied, and each
    /// copy waits until all of it is written.
    #[inline(always)]
    pub fn begin(&mut self, world: &World, ray: &Ray, trail: Trail) {
        self.ray = *ray;
        self.throughput = Rgb::ONE;
        self.squeeze = 1.0;
        self.trail = trail;
        self.site = const { Site::free(Vec3::ZERO) };
        self.site.point.position = ray.origin;
        self.pdf_w = 0.0;
        self.specular_splits = 0;
        self.diffuse_splits = 0;
        self.scattered = 0;
        self.mirrored = 0;
        self.inside = world.overlaps.as_ref().map_or(0, |overlaps| overlaps.camera);
    }

    /// The first surface that the ray meets.
    #[inline]
    pub fn meet(&mut self, world: &World) -> Option<Hit> {
        let mut hit = world.geometry.closest(&self.ray);
        self.pass(world, &mut hit);
        hit
    }

    /// From the first surface that the ray meets to the first that is there.
    #[inline]
    pub fn pass(&mut self, world: &World, hit: &mut Option<Hit>) {
        if let (Some(overlaps), Some(met)) = (&world.overlaps, *hit) {
            let found = overlaps.first(&world.geometry, met, self.ray.direction, self.inside);
            *hit = found.map(|(hit, inside)| {
                self.inside = inside;
                hit
            });
        }
    }

    /// Becomes a ray that goes on from a surface, one of `rays`; its trail is still that before the
    /// surface.
    #[inline]
    pub fn turn(&mut self, site: &Site, way: &Scattered, rays: u32) {
        let throughput = self.throughput * way.weight * way.squeeze;
        self.take(site, way, (site.point.ray(way.wi), throughput), rays);
    }

    /// The same, by a ray and a throughput that are known.
    #[inline(always)]
    pub fn take(&mut self, site: &Site, way: &Scattered, (ray, throughput): (Ray, Rgb), rays: u32) {
        self.ray = ray;
        self.throughput = throughput;
        self.squeeze *= way.squeeze;
        if way.pdf_w == 0.0 {
            // In one direction alone.
            self.pdf_w = 0.0;
            self.mirrored += 1;
        } else {
            self.site = *site;
            self.pdf_w = rays as f32 * way.pdf_w;
            self.scattered += 1;
        }
    }

    /// The same as a ray of its own.
    pub fn turned(&self, site: &Site, way: &Scattered, rays: u32) -> Self {
        let mut turned = *self;
        turned.turn(site, way, rays);
        turned
    }
}
