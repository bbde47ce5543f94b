//! What a scene does not require, and is left out, changes no picture.

mod by_hand;
mod shots;

use glam::{DVec3, dvec3};
use scn::load::Stage;
use scn::math::{NoProgress, Picture};
use scn::plan::{Feature, Need, Plan};
use scn::prepare::{self, Settings};
use scn::run::Outcome;
use scn::scene::AreaLights;

use by_hand::{Hand, Patient, direct, integrator, render, still_life};

/// The most samples of a pixel: a picture that differs does so from its first paths on.
const SAMPLES: u64 = 8;

/// A render of the stage on a film of about 40 pixels, as required and with everything put in.
fn both(stage: &Stage) -> [Outcome; 2] {
    let [width, height] = stage.scene.film.size.0;
    let settings = Settings { scale: 40.0 / width.max(height) as f64, ..Settings::default() };
    let samples = stage.scene.stop.most_samples().unwrap().min(SAMPLES);
    [Plan::of(stage), Plan::of(stage).forced()].map(|plan| {
        let (prepared, found) = prepare::prepare_by(&plan, stage, &settings, &NoProgress);
        render(&prepared.unwrap_or_else(|| panic!("{found:?}")), 5, samples, &Patient)
    })
}

fn lit(picture: &Picture) -> bool {
    picture.pixels.iter().any(|pixel| pixel.g > 0.0)
}

// Every random number has its own place, so that the two are the same to the bit, which is more
// than agreement within four standard errors.
#[test]
fn every_shipped_scene_is_the_same_with_everything_put_in() {
    let mut renders = 0;
    for file in std::fs::read_dir(shots::path("scenes")).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "scn") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let all = shots::open_text(&path, &text, &[]).unwrap_or_else(|report| panic!("{report}"));
        for shot in all {
            let [required, forced] = both(&shot.stage);
            assert!(lit(&required.picture), "{}", shot.name);
            assert_eq!(required.picture, forced.picture, "{}", shot.name);
            renders += 1;
        }
    }
    assert!(renders >= 11, "{renders}");
}

/// Scenes that leave out other things.
fn scenes() -> Vec<(Hand, Vec<Feature>)> {
    use Feature::{Coordinates, LampPoints, Lights, Normals, ShadowRays};
    let ball = |radius: f64| {
        Hand::new(direct())
            .size(24, 24)
            .samples(6)
            .material("grey", 0.5, 0.0)
            .material("black", 0.0, 0.0)
            .material("lamp", 0.0, 3.0)
            .sphere(DVec3::ZERO, radius, "grey")
            .camera(dvec3(0.0, 1.0, 5.0), DVec3::ZERO, 40.0)
    };
    let sun = |hand: Hand| hand.directional(dvec3(0.3, -1.0, -0.5), 2.0);
    let lamp = |hand: Hand| hand.quad(dvec3(0.0, 4.0, 0.0), DVec3::X, DVec3::Z, "lamp");
    let preview = scn::scene::Integrator::Preview(scn::scene::Preview {});
    vec![
        (still_life().samples(6), vec![Lights, ShadowRays, LampPoints, Normals]),
        (sun(ball(1.0)), vec![Lights]),
        // Seen from within, the ball hides the sun.
        (sun(ball(9.0)), vec![Lights, ShadowRays]),
        (lamp(ball(1.0)), vec![Lights, ShadowRays, LampPoints]),
        (
            lamp(ball(1.0)).integrator(integrator(true, AreaLights::Center)),
            vec![Lights, ShadowRays],
        ),
        (
            lamp(ball(1.0)).integrator(integrator(false, AreaLights::Random)),
            vec![Lights, LampPoints],
        ),
        (lamp(ball(1.0)).integrator(preview), vec![]),
        (ball(1.0).background(0.5), vec![]),
        (
            sun(Hand::new(direct()).material("black", 0.0, 0.0)).sphere(DVec3::ZERO, 1.0, "black"),
            vec![],
        ),
    ]
    .into_iter()
    .inspect(|(_, features)| assert!(!features.contains(&Coordinates)))
    .collect()
}

#[test]
fn what_is_left_out_changes_nothing() {
    for (hand, features) in scenes() {
        let stage = hand.stage();
        let plan = Plan::of(&stage);
        let required = |feature: &Feature| plan.builds(*feature);
        let built: Vec<Feature> = Feature::ALL.into_iter().filter(required).collect();
        assert_eq!(built, features, "{plan:?}");
        let [required, forced] = both(&stage);
        assert_eq!(required.picture, forced.picture, "{plan:?}");
        assert!(forced.shadow_rays >= required.shadow_rays);
        for answer in &plan.answers {
            assert!(!answer.why.is_empty() && !answer.why.ends_with('.'), "{answer:?}");
            let forced = plan.clone().forced().builds(answer.feature);
            assert_eq!(forced, answer.need != Need::SwitchedOff, "{answer:?}");
        }
    }
}

#[test]
fn shadow_rays_are_saved_where_nothing_hides_anything() {
    let (hand, _) = scenes().swap_remove(1);
    let [required, forced] = both(&hand.stage());
    assert_eq!(required.shadow_rays, 0);
    assert!(forced.shadow_rays > 100 && lit(&required.picture));
}

#[test]
fn normals_that_no_mesh_has_take_no_memory() {
    let hand = Hand::new(direct())
        .material("grey", 0.5, 0.0)
        .quad(DVec3::ZERO, DVec3::X, DVec3::Y, "grey")
        .directional(-DVec3::Z, 1.0);
    let stage = hand.stage();
    let bytes = |plan: Plan| {
        let (prepared, _) = prepare::prepare_by(&plan, &stage, &hand.settings, &NoProgress);
        prepared.unwrap().summary.bytes
    };
    assert!(bytes(Plan::of(&stage)) < bytes(Plan::of(&stage).forced()));
}
