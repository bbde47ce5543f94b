//! Mirrors, metals, glass and mixtures keep the energy of light, and give it back where physics
//! has it.

#[path = "../by_hand/mod.rs"]
mod by_hand;
mod angles;
mod energy;
mod glass;
mod mixtures;
mod plates;

use scn::measure::statistics::{Moments, agrees};
use scn::scene::{self, Depth, Integrator};

use by_hand::{Hand, at, path, splits};

/// All light; at the first so many mirrors, panes of glass and metals by all ways on.
fn tracer(specular: u64) -> Integrator {
    Integrator::Path(scene::Path { splits: at(splits(specular, 0, 1)), ..path() })
}

/// The same by `direct`, with any number of mirrors.
fn direct(specular: u64) -> Integrator {
    let Integrator::Direct(direct) = by_hand::direct() else { panic!("direct") };
    Integrator::Direct(scene::Direct {
        specular_depth: at(Depth::Unlimited),
        splits: at(splits(specular, 0, 1)),
        environment: at(scene::Switch(true)),
        ..direct
    })
}

/// Evenly spread samples, so that a few of them suffice.
fn even(mut hand: Hand, samples: u64) -> Hand {
    let round = at(scene::Count(samples));
    hand.scene.sampler = at(scene::Sampler::Sobol(scene::Sobol { round }));
    hand.samples(samples)
}

/// Holds when the mean is within `close` of the truth, and known to a quarter of that.
fn assert_mean(found: &Moments, truth: f64, close: f64, what: &str) {
    let verdict = agrees(found.mean(), found.standard_error(), truth, close);
    assert!(verdict.holds(), "{what}: {verdict}");
}

/// Gives the last object, a mesh, a material of the scene in place of its own.
fn made_of(mut hand: Hand, material: &str) -> Hand {
    let of = hand.scene.material(&scene::Ref::new(material)).clone();
    hand.meshes.last_mut().unwrap().as_mut().unwrap().materials = vec![of];
    hand
}
