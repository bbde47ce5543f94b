//! Glass that is not seen, and mixtures among which paths end.

use glam::DVec3;
use scn::math::Spectrum;
use scn::scene::{self, Depth, Integrator, Sides};

use crate::by_hand::{self, Hand, at, splits};
use crate::tracer;

#[test]
fn glass_in_a_white_room_is_not_seen() {
    for index in [1.0, 1.0 + 1e-7, 1.33, 1.5, 100.0] {
        for integrator in
            [tracer(|_| ()), tracer(|path| path.splits = at(splits(2, 0, 1))), by_hand::direct()]
        {
            let hand = Hand::new(integrator.clone())
                .glass("glass", index)
                .sphere(DVec3::ZERO, 1.0, "glass")
                .background(1.0)
                .camera(DVec3::Z * 4.0, DVec3::ZERO, 20.0)
                .size(4, 4)
                .samples(64);
            let mut hand = hand;
            if let Integrator::Direct(direct) = &mut hand.scene.integrator.value {
                direct.specular_depth = at(Depth::Unlimited);
            }
            for pixel in hand.picture().pixels {
                // Only rounding and roulette are left.
                assert!((pixel.g - 1.0).abs() < 0.15, "{index}: {}", pixel.g);
            }
        }
    }
}

#[test]
fn paths_among_mixtures_end_whatever_is_split() {
    let half = |first: &str, second: &str| scene::Mix {
        first: at(scene::Ref::new(first)),
        second: at(scene::Ref::new(second)),
        amount: at(scene::Number(0.5)),
    };
    let mirror = scene::Mirror {
        reflectance: at(scene::Textured::Plain(scene::Reflectance(Spectrum::Constant(1.0)))),
        emission: at(scene::Radiance(Spectrum::Constant(0.0))),
        emits: at(Sides::Front),
    };
    let inside = |integrator: Integrator| {
        Hand::new(integrator)
            .material("chalk", 0.6, 0.0)
            .made_of("mirror", scene::Material::Mirror(mirror.clone()))
            .made_of("half", scene::Material::Mix(half("mirror", "chalk")))
            .sphere(DVec3::ZERO, 1.0, "half")
            .sphere(DVec3::ZERO, 0.1, "chalk")
            .camera(DVec3::new(0.5, 0.1, 0.2), DVec3::X, 40.0)
            .directional(DVec3::X, 1.0)
            .samples(4)
            .picture()
    };
    for (specular, diffuse) in [(1, 0), (3, 0), (0, 2), (2, 2)] {
        let picture = inside(tracer(|path| path.splits = at(splits(specular, diffuse, 3))));
        assert!(picture.pixels.iter().all(|pixel| pixel.is_finite()));
    }
}
