//! Every light there is, and every shape that may shine, gives a floor its irradiance: none may be
//! left out of the list.

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::math::Spectrum;
use scn::plan::daylight::Daylight;
use scn::scene::{self, Integrator, Light, Object, Sides};

use crate::by_hand::vocabulary::{assert_complete, words};
use crate::by_hand::{Hand, at, direct};
use crate::{assert_is, even, receiver, tracer};

fn light_word(light: &Light) -> &'static str {
    match light {
        Light::Constant(_) => "constant",
        Light::Directional(_) => "directional",
        Light::PointLight(_) => "point",
        Light::Preetham(_) => "preetham",
        Light::SpotLight(_) => "spot",
    }
}

fn object_word(object: &Object) -> &'static str {
    match object {
        Object::Disk(_) => "disk",
        Object::Mesh(_) => "mesh",
        Object::Plane(_) => "plane",
        Object::Quad(_) => "quad",
        Object::Sphere(_) => "sphere",
        Object::Triangle(_) => "triangle",
    }
}

fn sky(sun: scene::SunForm) -> scene::Preetham {
    scene::Preetham {
        turbidity: at(scene::Number(2.4)),
        latitude: at(scene::Angle(0.9)),
        day: at(scene::Count(200)),
        time: at(scene::Time(10.0 * 3600.0)),
        longitude: at(None),
        zone: at(None),
        north: at(scene::Direction(DVec3::Y)),
        up: at(scene::Direction(DVec3::Z)),
        sun: at(sun),
        ground: at(scene::Reflectance(Spectrum::Constant(0.0))),
    }
}

/// A light for a white floor at the origin that faces up, with the radiance that the floor then
/// has: E/π.
fn lights() -> Vec<(Light, f64)> {
    let plain = |value: f64| Spectrum::Constant(value);
    let mut all = vec![
        (Light::Constant(scene::Constant { radiance: at(scene::Radiance(plain(0.7))) }), 0.7),
        (
            Light::Directional(scene::Directional {
                direction: at(scene::Direction(dvec3(0.6, 0.0, -0.8))),
                irradiance: at(scene::Irradiance(plain(2.0))),
            }),
            2.0 * 0.8 / PI,
        ),
        (
            Light::PointLight(scene::PointLight {
                position: at(scene::Point(dvec3(3.0, 0.0, 4.0))),
                intensity: at(scene::Intensity(plain(50.0))),
            }),
            2.0 * 0.8 / PI,
        ),
        (
            Light::SpotLight(scene::SpotLight {
                position: at(scene::Point(dvec3(3.0, 0.0, 4.0))),
                direction: at(scene::Direction(dvec3(-0.6, 0.0, -0.8))),
                intensity: at(scene::Intensity(plain(50.0))),
                cone: at(scene::Angle(0.5)),
                falloff: at(scene::Angle(0.2)),
            }),
            2.0 * 0.8 / PI,
        ),
    ];
    let disc = scene::SunDisc { half_angle: at(scene::Angle(0.00465)) };
    for sun in [
        scene::SunForm::NoSun(scene::NoSun {}),
        scene::SunForm::SunDirection(scene::SunDirection {}),
        scene::SunForm::SunDisc(disc),
    ] {
        let sky = sky(sun);
        let truth = Daylight::of(&sky).unwrap().level_irradiance()[1] / PI;
        all.push((Light::Preetham(sky), truth));
    }
    all
}

/// Shapes that shine with a radiance of 1, with the radiance that the floor then has.
fn lamps(hand: impl Fn() -> Hand) -> Vec<(Hand, f64)> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let corners = [dvec3(-1.0, 1.0, 2.0), dvec3(2.0, 0.5, 1.0), dvec3(0.3, -1.5, 1.5)];
    let mut mesh = scn::math::Mesh { material_names: vec!["lamp".into()], ..Default::default() };
    mesh.positions = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| dvec3(x, y, 1.0))
        .to_vec();
    mesh.triangles = vec![[0, 2, 1], [0, 3, 2]];
    mesh.slots = vec![0, 0];
    let mut of_mesh = hand().mesh(mesh, 1.0, 0.0);
    let shining = of_mesh.scene.material(&scene::Ref::new("lamp")).clone();
    of_mesh.meshes.last_mut().unwrap().as_mut().unwrap().materials = vec![shining];
    vec![
        (hand().disk(z, -z, 1.0, "lamp"), 0.5),
        (of_mesh, 1.740_840 / PI),
        (hand().quad(z, y * 0.5, x * 0.5, "lamp"), 0.752_275 / PI),
        (hand().sphere(z * 3.0, 1.0, "lamp"), 1.0 / 9.0),
        (hand().triangle(corners, "lamp"), 0.919_901 / PI),
    ]
}

/// Direct light with that of the sky, and all light; asked one by one and all together.
fn ways() -> [(&'static str, Integrator); 4] {
    let Integrator::Direct(it) = direct() else { panic!("direct") };
    let environment = || at(scene::Switch(true));
    let chosen = at(scene::LightCount::Chosen(1));
    let one = scene::Direct { environment: environment(), lights: chosen, ..it.clone() };
    [
        ("direct", Integrator::Direct(scene::Direct { environment: environment(), ..it })),
        ("direct, one light", Integrator::Direct(one)),
        ("path", tracer(|_| ())),
        ("mis: off", tracer(|path| path.mis.value.0 = false)),
    ]
}

#[test]
fn every_light_and_every_shape_that_shines_is_tested() {
    let lights = lights();
    let tested = lights.iter().map(|(light, _)| light_word(light)).collect();
    assert_complete("lights", tested, words::<Light>());
    let lamps = lamps(|| receiver(direct(), DVec3::Z));
    let objects = lamps.iter().flat_map(|(hand, _)| &hand.scene.objects);
    // A plane without end is refused as a lamp; tests/extremes.rs asks for that.
    let shapes = objects.map(|it| object_word(&it.value.value)).chain(["plane"]).collect();
    assert_complete("shapes", shapes, words::<Object>());
}

#[test]
fn every_light_gives_a_floor_its_irradiance() {
    for (light, truth) in lights() {
        for (way, integrator) in ways() {
            let hand = receiver(integrator, DVec3::Z).light(light.clone());
            let found = even(hand, 1024).estimate();
            // Skies are known to the grid that they are told in.
            let close = if let Light::Preetham(_) = light { 0.005 } else { 0.003 };
            assert_is(&format!("{} by {way}", light_word(&light)), &found, truth, close);
        }
    }
}

#[test]
fn every_shape_that_shines_gives_a_floor_its_irradiance_and_so_do_both_its_sides() {
    for (way, integrator) in ways() {
        for both in [false, true] {
            let start = || {
                let mut hand = receiver(integrator.clone(), DVec3::Z);
                for material in &mut hand.scene.materials {
                    if let scene::Material::Diffuse(it) = &mut material.value.value {
                        it.emits = at(if both { Sides::Both } else { Sides::Front });
                    }
                }
                hand
            };
            for (hand, truth) in lamps(start) {
                let word = object_word(&hand.scene.objects.last().unwrap().value.value);
                let samples = if word == "disk" { 4096 } else { 1024 };
                let found = even(hand, samples).estimate();
                assert_is(&format!("{word} by {way}, both {both}"), &found, truth, 0.003);
            }
        }
    }
}

#[test]
fn what_shines_from_its_front_lights_nothing_behind_it() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let corners = [dvec3(-1.0, 1.0, 2.0), dvec3(0.3, -1.5, 1.5), dvec3(2.0, 0.5, 1.0)];
    for (way, integrator) in ways() {
        let start = || receiver(integrator.clone(), z);
        for (shape, hand) in [
            ("disk", start().disk(z, z, 1.0, "lamp")),
            ("disk close by", start().disk(z * 0.2, z, 1.0, "lamp")),
            ("square", start().quad(z, x, y, "lamp")),
            ("square far away", start().quad(z * 1e4, x, y, "lamp")),
            ("triangle", start().triangle(corners, "lamp")),
            ("ball around it", start().sphere(z * 0.3, 1.0, "lamp")),
        ] {
            let picture = even(hand, 64).picture();
            assert_eq!(picture.pixels[0].g, 0.0, "{shape} by {way}");
        }
    }
}

/// The sun of the ground truths: a cone of .00465 rad gives 6.792860e-5 of its radiance.
#[test]
fn the_sun_gives_the_irradiance_of_its_cone() {
    let sun = |half_angle: f64| {
        let disc = scene::SunDisc { half_angle: at(scene::Angle(half_angle)) };
        sky(scene::SunForm::SunDisc(disc))
    };
    for half_angle in [1e-4, 0.00465, 0.02] {
        let light = sun(half_angle);
        let to_sun = Daylight::of(&light).unwrap().to_sun();
        // By direct light alone the sky does not shine.
        let hand = receiver(direct(), to_sun).light(Light::Preetham(light.clone()));
        let floor = even(hand, 256).estimate();
        let seen = Hand::new(direct())
            .material("floor", 1.0, 0.0)
            .disk(-to_sun, to_sun, 0.1, "floor")
            .camera(DVec3::ZERO, to_sun, 1e-6)
            .light(Light::Preetham(light));
        let radiance = f64::from(seen.picture().pixels[0].g);
        let cone = match half_angle {
            0.00465 => 6.792_860e-5,
            other => PI * other.sin().powi(2),
        };
        // A little of the sky is seen before the sun.
        assert_is(&format!("{half_angle}"), &floor, cone / PI * radiance, 0.003);
    }
}
