//! What a setting costs: two integrators in one world, compared by the same random numbers.
//!
//! Both take a picture of the film's window on a small film, several times with other numbers each.
//! The same numbers go through both, so that their noise is mostly the same and drops out of the
//! difference.

use super::{Begin, Settings, Watch, render};
use crate::measure::statistics::Moments;
use crate::render::World;
use crate::render::film::{Film, Filter, Window};
use crate::render::integrators::Integrator;

/// How much brighter a picture is than another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Difference of the mean luminances, in parts of the other's.
    pub relative: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Samples of each of the two.
    pub samples: u64,
}

/// Pairs of pictures: enough for a standard error that is itself known to a fifth.
const PAIRS: u64 = 16;

/// Bounds on the samples of each of the two.
const SAMPLES: std::ops::RangeInclusive<u64> = 1024..=65_536;

/// Chooses the random numbers.
const SEED: u64 = 0x6269_6173;

/// How much brighter `biased` is than `right`, from about so many samples of each, within bounds.
/// None if there is no light in the picture of `right`, or it was cancelled. The world is as before
/// afterwards.
pub fn difference(
    world: &mut World,
    biased: &Integrator,
    right: &Integrator,
    samples: u64,
    watch: &dyn Watch,
) -> Option<Difference> {
    let samples = samples.clamp(*SAMPLES.start(), *SAMPLES.end()) / PAIRS;
    let window = world.film.window;
    let longest = window.width().max(window.height());
    let side = samples.isqrt().min(longest);
    // Rounded up, and so at least 1.
    let size = [window.width(), window.height()]
        .map(|n| (u128::from(n) * u128::from(side)).div_ceil(longest.into()) as u64);
    let small = Film {
        size,
        window: Window { x0: 0, y0: 0, x1: size[0], y1: size[1] },
        filter: Filter::Box { radius: 0.5 },
        layers: 0,
    };
    let each = (samples / small.window.pixels()).max(1);
    let camera = world.camera.over([window.x0, window.y0], [window.width(), window.height()], size);
    let film = std::mem::replace(&mut world.film, small);
    let camera = std::mem::replace(&mut world.camera, camera);
    let found = measure(world, biased, right, each, watch);
    world.film = film;
    world.camera = camera;
    found
}

/// With so many samples a pixel in each picture.
fn measure(
    world: &World,
    biased: &Integrator,
    right: &Integrator,
    each: u64,
    watch: &dyn Watch,
) -> Option<Difference> {
    let (mut apart, mut truth) = (Moments::default(), Moments::default());
    for pair in 0..PAIRS {
        let settings = Settings::samples(SEED + pair, each);
        let mean = |integrator: &Integrator| {
            let outcome = render(world, integrator, &settings, Begin::new(world), &Quiet(watch));
            let pixels = &outcome.picture.pixels;
            let sum: f64 = pixels.iter().map(|pixel| f64::from(pixel.luminance())).sum();
            sum / pixels.len() as f64
        };
        let (wrong, good) = (mean(biased), mean(right));
        if watch.cancelled() {
            return None;
        }
        apart.add(wrong - good);
        truth.add(good);
    }
    let mean = truth.mean();
    (mean > 0.0).then(|| Difference {
        relative: apart.mean() / mean,
        standard_error: apart.standard_error() / mean,
        samples: PAIRS * each * world.film.window.pixels(),
    })
}

/// Can be cancelled, and tells nobody.
struct Quiet<'a>(&'a dyn Watch);

impl Watch for Quiet<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }

    fn now(&self) -> f64 {
        self.0.now()
    }

    fn progress(&self, _done: u64, _total: u64) {}
}
