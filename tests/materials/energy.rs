//! Furnaces: in even light, each material and each mixture gives back its part, no more and no
//! less; and closed rooms of it, that shine themselves, have the radiance of a geometric series.

use glam::{DVec3, dvec3};
use scn::math::{Mesh, Spectrum};
use scn::optics::fresnel;
use scn::scene::{self, Integrator, Material, Sides};

use crate::by_hand::vocabulary::{assert_complete, words};
use crate::by_hand::{Hand, at, bumpy_ball};
use crate::{assert_mean, direct, even, made_of, tracer};

/// Every material, and mixtures of them.
fn furnace(integrator: Integrator) -> Hand {
    let mut hand = Hand::new(integrator)
        .material("paint", 0.6, 0.0)
        .mirror("mirror", 1.0)
        .mirror("grey mirror", 0.7)
        .metal("silver", Spectrum::Constant(0.06), Spectrum::Constant(3.586))
        .background(1.0);
    for (name, index) in GLASS {
        hand = hand.glass(name, index);
    }
    let plain: Vec<_> = hand.scene.materials.iter().map(|it| it.name.value.clone()).collect();
    for first in &plain {
        for second in &plain {
            hand = hand.mix(&mixture(first, second), [first, second], AMOUNT);
        }
    }
    let nested = [mixture("paint", "mirror"), mixture("glass", "silver")];
    hand.mix("nested", [&nested[0], &nested[1]], 0.5)
}

const GLASS: [(&str, f64); 5] = [
    ("glass", 1.5),
    ("nothing", 1.0),
    ("next to nothing", 1.0 + 1e-7),
    ("thin", 0.8),
    ("dense", 100.0),
];

/// What of a mixture is the second material.
const AMOUNT: f64 = 0.3;

fn mixture(first: &str, second: &str) -> String {
    format!("{first} and {second}")
}

/// The part of even light that a flat piece of a material gives back at an angle of this cosine;
/// of glass, with what comes from behind, where the same light comes from n² times less solid
/// angle. A new material has to say it.
fn part(hand: &Hand, material: &str, cos: f64) -> f64 {
    let value = |spectrum: &Spectrum| match spectrum {
        Spectrum::Constant(value) => *value,
        _ => panic!("a plain number"),
    };
    let textured = |colour: &scene::Textured<scene::Reflectance>| match colour {
        scene::Textured::Plain(plain) => value(&plain.0),
        _ => panic!("a plain colour"),
    };
    match &hand.scene.material(&scene::Ref::new(material)).value.value {
        Material::Conductor(metal) => {
            fresnel::conductor(value(&metal.ior.value.n), value(&metal.ior.value.k), cos)
        }
        Material::Dielectric(glass) => {
            let index = GLASS.iter().find(|it| it.0 == glass.inside.name).unwrap().1;
            let reflected = fresnel::dielectric(index - 1.0, cos).reflectance;
            reflected + (1.0 - reflected) / (index * index)
        }
        Material::Diffuse(diffuse) => textured(&diffuse.albedo),
        Material::Mirror(mirror) => textured(&mirror.reflectance),
        Material::Mix(mix) => {
            let [first, second] = [&mix.first, &mix.second].map(|it| part(hand, &it.name, cos));
            (1.0 - mix.amount.0) * first + mix.amount.0 * second
        }
    }
}

/// The words of the materials that are tested.
fn word(material: &Material) -> &'static str {
    match material {
        Material::Conductor(_) => "conductor",
        Material::Dielectric(_) => "dielectric",
        Material::Diffuse(_) => "diffuse",
        Material::Mirror(_) => "mirror",
        Material::Mix(_) => "mix",
    }
}

#[test]
fn every_material_is_tested() {
    let hand = furnace(tracer(0));
    let tested = hand.scene.materials.iter().map(|it| word(&it.value.value)).collect();
    assert_complete("materials", tested, words::<Material>());
}

#[test]
fn in_even_light_each_material_and_mixture_gives_back_its_part() {
    let all = furnace(tracer(0)).scene.materials;
    for name in all.iter().map(|it| it.name.value.as_str()) {
        // Glass of two kinds in one surface is refused.
        let clear = |part: &&str| GLASS.iter().any(|it| it.0 == *part);
        let parts: Vec<&str> = name.split(" and ").collect();
        if parts.len() == 2 && parts.iter().all(clear) && parts[0] != parts[1] {
            continue;
        }
        let mixed = parts.len() == 2 || name == "nested";
        for (integrator, samples) in [(tracer(0), 1024), (tracer(2), 64), (direct(2), 64)] {
            for degrees in if mixed { &[50.0_f64][..] } else { &[0.0, 60.0, 89.0] } {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let hand = furnace(integrator.clone()).plane(DVec3::ZERO, DVec3::Z, name).camera(
                    dvec3(3.0 * sin, 0.0, 3.0 * cos),
                    DVec3::ZERO,
                    1e-3,
                );
                let truth = part(&hand, name, cos);
                let what = format!("{name} at {degrees}");
                assert_mean(&even(hand, samples).estimate(), truth, 0.005 * truth, &what);
            }
        }
    }
}

#[test]
fn closed_shapes_give_back_their_part_from_outside_and_inside() {
    // In the densest hardly a direction leads out.
    let within = |index: f64| if index < 10.0 { index * index } else { 0.0 };
    let indices = GLASS.map(|(name, index)| (name, 1.0, within(index)));
    let others = [("paint", 0.6, 0.0), ("mirror", 1.0, 0.0), ("grey mirror", 0.7, 0.0)];
    let dusty = mixture("glass", "mirror");
    let mixed = [(dusty.as_str(), 1.0, 2.25)];
    for (material, truth, within) in indices.into_iter().chain(others).chain(mixed) {
        for integrator in [tracer(0), tracer(2), direct(0), direct(2)] {
            for (eye, truth) in [(dvec3(0.0, 0.0, 4.0), truth), (dvec3(0.2, 0.1, 0.3), within)] {
                // No light comes in. In glass the same light comes from less solid angle.
                if truth == 0.0 {
                    continue;
                }
                let hand = furnace(integrator.clone()).sphere(DVec3::ZERO, 1.0, material).camera(
                    eye,
                    DVec3::ZERO,
                    20.0,
                );
                let samples = if material == dusty { 8192 } else { 1024 };
                let found = even(hand, samples).estimate();
                assert_mean(&found, truth, 0.005 * truth, material);
            }
        }
    }
}

/// How much of even light a mesh with smooth normals gives back, and how far off a pixel of it is
/// at most.
fn smooth(material: &str, mesh: Mesh, integrator: Integrator) -> [f64; 2] {
    let hand = made_of(furnace(integrator).mesh(mesh, 1.0, 0.0), material);
    let hand = hand.camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0).size(32, 32).samples(64);
    let parts: Vec<f64> = hand.picture().pixels.iter().map(|p| f64::from(p.g)).collect();
    let most = parts.iter().map(|part| (part - 1.0).abs()).fold(0.0, f64::max);
    [parts.iter().sum::<f64>() / parts.len() as f64, most]
}

#[test]
fn a_smooth_mirror_and_smooth_glass_lose_no_light_along_their_silhouettes() {
    let round = |rings: usize| {
        let mesh = bumpy_ball(rings);
        Mesh { positions: mesh.normals.clone(), ..mesh }
    };
    for integrator in [direct(0), tracer(0)] {
        // With normals far from those of the surface.
        let [_, most] = smooth("mirror", bumpy_ball(8), integrator.clone());
        assert!(most < 1e-4, "a mirror: {most}");
        // Within glass light may go in a circle for ever, where it goes by normals that are not
        // those of the surface: the less, the closer they are.
        for (mesh, close) in [(bumpy_ball(64), 0.02), (round(8), 0.005), (round(32), 2e-4)] {
            let triangles = mesh.triangles.len();
            let [mean, _] = smooth("glass", mesh, integrator.clone());
            assert!((mean - 1.0).abs() < close, "glass of {triangles} triangles: {mean}");
        }
    }
}

/// Gives a material an emission; false if it has none to give.
fn shine(material: &mut Material, radiance: f64) -> bool {
    let (emission, emits) = match material {
        Material::Conductor(it) => (&mut it.emission, &mut it.emits),
        Material::Diffuse(it) => (&mut it.emission, &mut it.emits),
        Material::Mirror(it) => (&mut it.emission, &mut it.emits),
        Material::Dielectric(_) | Material::Mix(_) => return false,
    };
    emission.value.0 = Spectrum::Constant(radiance);
    *emits = at(Sides::Both);
    true
}

/// A hollow ball of a material that shines: what a ray meets first, what is behind that, and so on,
/// always at the same angle where it is mirrored.
#[test]
fn closed_rooms_that_shine_have_their_radiance() {
    let mixed = mixture("paint", "grey mirror");
    for material in ["paint", "grey mirror", "silver", &mixed] {
        for next_event in [true, false] {
            let Integrator::Path(mut path) = tracer(0) else { panic!("path") };
            path.next_event.value.0 = next_event;
            // The last of the light is left to roulette.
            path.roulette = at(scene::Roulette::Mean);
            path.roulette_after = at(scene::Count(if material == "silver" { 350 } else { 12 }));
            let mut hand = furnace(Integrator::Path(path));
            for it in &mut hand.scene.materials {
                // Of a mixture each part shines its own.
                let radiance = if it.name.value == "paint" { 2.0 } else { 1.0 };
                shine(&mut it.value.value, radiance);
            }
            let (eye, towards) = (dvec3(0.6, 0.0, 0.0), dvec3(0.0, 0.8, 0.0));
            let hand = hand.sphere(DVec3::ZERO, 1.0, material).camera(eye, eye + towards, 1e-3);
            // The ray comes to the ball at (.6, .8, 0).
            let back = part(&hand, material, 0.8);
            let emitted = match material {
                "paint" => 2.0,
                "silver" | "grey mirror" => 1.0,
                _ => 2.0 * (1.0 - AMOUNT) + AMOUNT,
            };
            let truth = emitted / (1.0 - back);
            let samples = if material == "silver" { 64 } else { 1024 };
            let found = even(hand, samples).estimate();
            assert_mean(&found, truth, 0.005 * truth, &format!("{material}, {next_event}"));
        }
    }
}
