//! What makes a picture systematically wrong is found where it is, and only there; and what it is
//! said to cost is what it costs.

mod by_hand;

use glam::{DVec3, dvec3};
use scn::data::{self, Figures};
use scn::math::{Formula, Spectrum, Table};
use scn::plan::{Kind, biases, errors};
use scn::prepare::{self, Prepared};
use scn::run::{self, Difference};
use scn::scene::{self, AreaLights, Integrator, Light, Preview};

use by_hand::{Hand, Patient, Ticking, at, direct, integrator, render, still_life};

fn kinds(hand: &Hand) -> Vec<Kind> {
    biases(&hand.stage()).iter().map(|bias| bias.kind).collect()
}

/// A grey floor in the sun.
fn floor() -> Hand {
    Hand::new(direct())
        .material("grey", 0.5, 0.0)
        .material("black", 0.0, 0.0)
        .material("lamp", 0.0, 3.0)
        .quad(DVec3::ZERO, DVec3::X * 9.0, DVec3::Y * 9.0, "grey")
        .directional(dvec3(0.3, 0.0, -1.0), 2.0)
        .camera(dvec3(0.0, -2.0, 5.0), DVec3::ZERO, 40.0)
}

fn with_ball(hand: Hand, material: &str) -> Hand {
    hand.sphere(dvec3(0.0, 0.0, 1.0), 0.5, material)
}

#[test]
fn biases_are_found_where_they_are_and_nowhere_else() {
    let off = || integrator(false, AreaLights::Random);
    let centre = || integrator(true, AreaLights::Center);
    let lamp = |hand: Hand| hand.quad(dvec3(0.0, 0.0, 3.0), DVec3::Y, DVec3::X, "lamp");
    let preview = || Integrator::Preview(Preview {});
    use Kind::{ConstantLight, Depth, LampCentres, NoShadows};
    for (hand, expected) in [
        (floor(), vec![]),
        // Black surfaces hide light, and give none back.
        (with_ball(floor(), "black"), vec![]),
        (with_ball(floor(), "grey"), vec![Depth]),
        (lamp(floor()), vec![]),
        (floor().integrator(off()), vec![]),
        (with_ball(floor(), "black").integrator(off()), vec![NoShadows]),
        (with_ball(floor(), "grey").integrator(off()), vec![Depth, NoShadows]),
        (floor().integrator(centre()), vec![]),
        (lamp(floor()).integrator(centre()), vec![LampCentres]),
        (floor().background(1.0), vec![ConstantLight]),
        (floor().background(0.0), vec![]),
        (still_life(), vec![Depth, ConstantLight]),
        (still_life().integrator(preview()), vec![Kind::Preview]),
        (
            still_life().integrator(integrator(false, AreaLights::Center)),
            vec![Depth, ConstantLight, NoShadows, LampCentres],
        ),
        // Nothing shines, or nothing is there to be lit.
        (with_ball(Hand::new(off()).material("grey", 0.5, 0.0), "grey"), vec![]),
        (with_ball(Hand::new(off()).material("black", 0.0, 0.0), "black").background(1.0), vec![]),
    ] {
        assert_eq!(kinds(&hand), expected, "{:?}", hand.scene.integrator);
        for bias in biases(&hand.stage()) {
            let fault = errors::biased(&bias);
            assert!(!fault.headline.ends_with('.') && fault.help.is_some());
        }
    }
}

#[test]
fn small_lights_by_way_of_mirrors_are_rare_and_no_bias() {
    let path = || Integrator::Path(by_hand::path());
    let lit_by = |radius: f64, mirror: &str| {
        let hand = floor().integrator(path()).mirror("mirror", 1.0);
        let mut hand = with_ball(hand, mirror);
        hand.scene.lights.clear();
        hand.sphere(dvec3(0.0, 0.0, 4.0), radius, "lamp")
    };
    let rare = |hand: Hand| kinds(&hand).contains(&Kind::RareCaustics);
    // 2.5 m from the ball: π (√3 · 5 mm / 2.5 m)² are 3.8e-5 sr.
    assert!(rare(lit_by(0.005, "mirror")));
    assert!(!rare(lit_by(0.005, "grey")));
    assert!(!rare(lit_by(0.1, "mirror")));
    assert!(Kind::RareCaustics.is_noise() && !Kind::Caustics.is_noise());
    let told = biases(&lit_by(0.005, "mirror").stage());
    assert!(told[0].brief.contains("met by one path in 83,000"), "{}", told[0].brief);
}

#[test]
fn the_page_lists_every_bias() {
    // Each word stands in one arm of `Kind::word`, or is told of what samples could not hold.
    let arms = include_str!("../src/plan/bias.rs").split("pub fn word(self)").nth(1).unwrap();
    let arms = arms.split("\n    }\n").next().unwrap();
    let mut words: Vec<&str> = arms.split('"').skip(1).step_by(2).collect();
    words.extend(["clipped", "not_finite"]);
    let page = include_str!("../docs/plan.md").split("\n## Biases\n").nth(1).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let listed: Vec<&str> = rows.take_while(|word| *word != "render").collect();
    assert!(words.contains(&Kind::Dispersion.word()));
    words.sort_unstable();
    let mut sorted = listed.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, words, "docs/plan.md lists other biases than there are");
}

#[test]
fn the_depth_is_bounded_by_the_largest_albedo_in_use() {
    let bound = |hand: Hand| biases(&hand.stage())[0].bound;
    assert_eq!(bound(with_ball(floor(), "grey")), Some(0.5));
    let hand = floor().material("white", 0.75, 0.0).material("unused", 0.9, 0.0);
    assert_eq!(bound(with_ball(hand, "white")), Some(0.75));
    let hand = floor().material("mirror", 1.0, 0.0);
    assert_eq!(bound(with_ball(hand, "mirror")), None);
}

/// What the biases of a scene are measured to cost.
fn measured(hand: &Hand) -> Vec<(Kind, Difference)> {
    let stage = hand.stage();
    let mut prepared = hand.prepared();
    let mut one = |bias: &scn::plan::Bias| {
        let instead = prepare::other_integrator(&stage, &prepared, bias.instead.as_ref()?);
        let Prepared { world, integrator, .. } = &mut prepared;
        let found = run::difference(world, integrator, &instead, 1 << 20, &Patient);
        Some((bias.kind, found.unwrap()))
    };
    biases(&stage).iter().filter_map(&mut one).collect()
}

/// Mean luminance of the scene's picture.
fn mean(hand: &Hand) -> f64 {
    let picture = render(&hand.prepared(), 77, 256, &Patient).picture;
    let sum: f64 = picture.pixels.iter().map(|pixel| f64::from(pixel.luminance())).sum();
    sum / picture.pixels.len() as f64
}

#[test]
fn what_a_bias_is_said_to_cost_is_what_it_costs() {
    for (shadows, area_lights) in [(false, AreaLights::Random), (true, AreaLights::Center)] {
        let hand = still_life().integrator(integrator(shadows, area_lights));
        let (biased, right) = (mean(&hand), mean(&still_life()));
        let truth = biased / right - 1.0;
        let all = measured(&hand);
        let [(_, found)] = all[..] else { panic!("{all:?}") };
        let apart = (found.relative - truth).abs();
        // The long renders have noise of their own: about 0.1 %.
        assert!(apart < 4.0 * found.standard_error.hypot(1e-3), "{found:?} {truth}");
        assert!(found.standard_error < 0.02, "{found:?}");
        assert!(shadows || found.relative > 4.0 * found.standard_error, "{found:?} {truth}");
        assert!((1 << 15..=1 << 16).contains(&found.samples));
    }
}

#[test]
fn the_world_is_as_before_after_measuring() {
    let hand = still_life().integrator(integrator(false, AreaLights::Random)).samples(2);
    let before = hand.picture();
    let stage = hand.stage();
    let mut prepared = hand.prepared();
    let instead = biases(&stage)[2].instead.clone().unwrap();
    let instead = prepare::other_integrator(&stage, &prepared, &instead);
    let Prepared { world, integrator, .. } = &mut prepared;
    assert!(run::difference(world, integrator, &instead, 0, &Patient).is_some());
    // Cancelled, it tells nothing.
    let cancelled = Ticking::new(0.1, 3);
    assert_eq!(run::difference(world, integrator, &instead, 0, &cancelled), None);
    assert_eq!(render(&prepared, 0, 2, &Patient).picture, before);
}

#[test]
fn a_pilot_run_tells_the_noise_of_the_picture() {
    let hand = still_life().size(96, 80).grid(1);
    let prepared = hand.prepared();
    let Prepared { world, integrator, .. } = &prepared;
    let pilot = run::pilot(world, integrator, 3, &|| 0.0);
    let whole = render(&prepared, 4, pilot.samples, &Patient);
    let (told, real) = (pilot.noise.unwrap().relmse, whole.noise.unwrap().relmse);
    assert!((told / real).ln().abs() < 0.25, "{told} {real}");
    assert!(!pilot.bound && pilot.rate().is_finite());
    let again = run::pilot(world, integrator, 3, &|| 0.0);
    assert_eq!((pilot.noise, pilot.pixels), (again.noise, again.pixels));
    let shadow_rays = whole.shadow_rays as f64 / whole.rays as f64;
    assert!((pilot.shadow_rays / shadow_rays - 1.0).abs() < 0.05, "{pilot:?} {shadow_rays}");
}

/// A spectrum of a shelf; a light has a luminance of 1.
fn datum(shelf: &str, word: &str) -> Spectrum {
    let nodes: Vec<(f64, f64)> = match data::shelf(shelf).unwrap().find(word).unwrap().figures {
        Figures::Light(rows) => rows().iter().map(|row| (row[0], row[1])).collect(),
        Figures::Reflectance(rows, i) => rows().iter().map(|row| (row[0], row[i])).collect(),
        _ => panic!("{shelf}.{word} is no table"),
    };
    Spectrum::Table(Table::new(nodes).unwrap())
}

/// A floor of this albedo in a sun of this irradiance, and a black lamp that shines so.
fn coloured(albedo: &Spectrum, sun: &Spectrum, lamp: &Spectrum) -> Hand {
    let mut hand = floor();
    let Light::Directional(light) = &mut hand.scene.lights[0].value.value else { panic!() };
    light.irradiance = at(scene::Irradiance(sun.clone()));
    for material in &mut hand.scene.materials {
        let scene::Material::Diffuse(diffuse) = &mut material.value.value else { continue };
        match &*material.name.value {
            "grey" => {
                diffuse.albedo = at(scene::Textured::Plain(scene::Reflectance(albedo.clone())))
            }
            "lamp" => diffuse.emission = at(scene::Radiance(lamp.clone())),
            _ => {}
        }
    }
    hand.quad(dvec3(0.0, 0.0, 3.0), DVec3::Y, DVec3::X, "lamp")
}

fn told(hand: &Hand) -> Vec<String> {
    let all = biases(&hand.stage());
    let all = all.iter().filter(|bias| bias.kind == Kind::RgbForSpectra);
    all.map(|bias| format!("{}: {}", bias.setting, bias.brief)).collect()
}

#[test]
fn products_of_spectra_are_wrong_by_what_is_known() {
    let none = Spectrum::Constant(0.0);
    let red = datum("paint", "cornell_red");
    let tungsten = datum("illuminant", "a");
    let line = |nm: f64| {
        Spectrum::Table(Table::new(vec![(nm - 0.01, 0.0), (nm, 9e4), (nm + 0.01, 0.0)]).unwrap())
    };
    for (sun, part) in [(&tungsten, "14."), (&line(589.3), "86.")] {
        for hand in [coloured(&red, sun, &none), coloured(&red, &none, sun)] {
            let [told] = &told(&hand)[..] else { panic!("{:?}", told(&hand)) };
            assert!(told.contains(&format!(" and `grey`: {part}")), "{told}");
            assert!(told.contains(" % too bright where they meet, "), "{told}");
        }
    }
    let both = told(&coloured(&red, &tungsten, &line(589.3)));
    assert!(both[0].starts_with("RGB for the spectra of `light light0` and"), "{both:?}");
    assert!(both[1].starts_with("RGB for the spectra of `lamp` and"), "{both:?}");
    // Nothing is left of the light, but a channel knows nothing of that.
    let blue = Spectrum::Table(Table::new(vec![(500.0, 0.9), (501.0, 0.0)]).unwrap());
    let black = told(&coloured(&blue, &line(510.0), &none));
    assert!(black[0].contains("should be black"), "{black:?}");
    // Of several surfaces the one is told on which it is most wrong.
    let mut hand = with_ball(coloured(&datum("paint", "cornell_green"), &tungsten, &none), "black");
    let scene::Material::Diffuse(diffuse) = &mut hand.scene.materials[0].value.value else {
        panic!("diffuse")
    };
    diffuse.albedo = at(scene::Textured::Plain(scene::Reflectance(red.clone())));
    let [told] = &told(&hand)[..] else { panic!("{:?}", told(&hand)) };
    assert!(told.contains(" and `black`: 14."), "{told}");
    assert!(told.contains("; on one more material off by 4.68 %, a channel by 30.8 %"), "{told}");
}

#[test]
fn products_that_are_exact_or_of_colours_are_not_told() {
    let none = Spectrum::Constant(0.0);
    let red = datum("paint", "cornell_red");
    let tungsten = datum("illuminant", "a");
    let white = datum("illuminant", "d65");
    let rgb = Spectrum::Rgb([0.9, 0.4, 0.1]);
    let flat = Spectrum::Table(Table::new(vec![(400.0, 0.5), (700.0, 0.5)]).unwrap());
    for (albedo, sun) in [
        (&red, &Spectrum::Constant(3.0)),
        (&red, &white),
        (&Spectrum::Constant(0.5), &tungsten),
        (&flat, &tungsten),
        (&rgb, &tungsten),
        (&red, &rgb),
        (&none, &tungsten),
    ] {
        assert_eq!(told(&coloured(albedo, sun, &none)), [""; 0], "{albedo:?} {sun:?}");
    }
    // A light of the same power at every wavelength is not white.
    assert_eq!(told(&coloured(&red, &flat, &none)).len(), 1);
    // In white light only a surface is wrong that sRGB lacks.
    let laser = Table::new(vec![(510.0, 0.02), (520.0, 0.9), (530.0, 0.02)]).unwrap();
    let hand = coloured(&Spectrum::Table(laser), &Spectrum::Constant(3.0), &none);
    assert_eq!(told(&hand).len(), 1);
    // A lamp does not light itself, unless it can.
    let shines = |hand: Hand| {
        let mut hand = hand;
        let scene::Material::Diffuse(diffuse) = &mut hand.scene.materials[0].value.value else {
            panic!("diffuse")
        };
        diffuse.albedo = at(scene::Textured::Plain(scene::Reflectance(red.clone())));
        diffuse.emission = at(scene::Radiance(tungsten.clone()));
        hand
    };
    let alone = Hand::new(direct()).material("lamp", 0.5, 1.0);
    let alone = shines(alone.quad(DVec3::ZERO, DVec3::X, DVec3::Y, "lamp"));
    assert_eq!(told(&alone), [""; 0]);
    let two = alone.clone().quad(DVec3::Z, DVec3::X, DVec3::Y, "lamp");
    assert_eq!(told(&two).len(), 1);
}

/// A ball of glass of this index.
fn refracting(n: Spectrum) -> Hand {
    let mut hand = floor().glass("glass", 1.5).sphere(dvec3(0.0, 0.0, 1.0), 0.5, "glass");
    let scene::Medium::Homogeneous(glass) = &mut hand.scene.media[0].value.value;
    glass.ior.value.n = n;
    // A floor that is not the same all over.
    hand.point(dvec3(0.8, 0.3, 0.5), 1.0).size(16, 16).samples(4)
}

#[test]
fn an_index_that_varies_is_told_with_its_size_and_the_one_that_is_taken() {
    let told = |n: Spectrum| {
        let all = biases(&refracting(n).stage());
        let all = all.into_iter().filter(|bias| bias.kind == Kind::Dispersion);
        all.map(|bias| [bias.setting, bias.effect, bias.brief]).collect::<Vec<_>>()
    };
    // n = A + B / λ² at 486.1, 587.6 and 656.3 nm.
    let cauchy = |b: f64| Spectrum::of(Formula::Cauchy([1.5, b, 0.0]));
    let [[setting, effect, brief]] = &told(cauchy(4e-3))[..] else { panic!("one") };
    assert_eq!(setting, "the index of `glass`");
    assert!(effect.contains("refracted by 1.5116, its index in yellow"), "{effect}");
    assert!(effect.contains("1.5169 in blue and 1.5093 in red"), "{effect}");
    assert!(brief.contains("0.51 % of the index"), "{brief}");
    // N-BK7 by its catalogue, as the ground truths have it.
    let bk7 = [(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)];
    let [[_, effect, _]] = &told(Spectrum::of(Formula::Sellmeier(bk7.to_vec())))[..] else {
        panic!("one")
    };
    assert!(effect.contains("1.5168, its index in yellow; it is 1.5224 in blue and 1.5143 in red"));
    for constant in [cauchy(0.0), cauchy(1e-5), Spectrum::Constant(1.5)] {
        assert!(told(constant.clone()).is_empty(), "{constant:?}");
    }
    // All light is refracted by that one index, and by no other.
    let picture = |n: Spectrum| refracting(n).picture();
    let middle = 1.5 + 4e-3 / 0.5876_f64.powi(2);
    assert_eq!(picture(cauchy(4e-3)), picture(Spectrum::Constant(middle)));
    assert!(picture(cauchy(4e-3)) != picture(Spectrum::Constant(1.5 + 4e-3 / 0.4861_f64.powi(2))));
}
