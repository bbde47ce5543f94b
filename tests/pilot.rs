//! What `scn plan` foretells from a pilot run: the error that a render then has.

mod by_hand;
mod shots;

use by_hand::{Patient, render};
use scn::run;

/// √relMSE after 128 samples, as foretold and as it was.
fn foretold_and_true(scene: &str, name: &str, scale: f64, sampler: &str) -> [f64; 2] {
    let sets = [format!("sampler={sampler}")];
    let shots = shots::open_with(scene, &sets);
    let shot = shots.iter().find(|shot| shot.name == name).unwrap();
    let prepared = shot.prepare(scale);
    let pilot = run::pilot(&prepared.world, &prepared.integrator, 0, &|| 0.0);
    let relmse = pilot.noise.unwrap().relmse * pilot.samples as f64 / 128.0;
    let outcome = render(&prepared, 0, 128, &Patient);
    assert!(!outcome.bound, "two rounds are over");
    [relmse, outcome.noise.unwrap().relmse].map(f64::sqrt)
}

#[test]
fn errors_come_as_foretold() {
    for (scene, name, scale) in [
        ("scenes/tour/ball.scn", "noon", 1.5),
        ("scenes/tour/lamp.scn", "smooth", 1.0),
        ("scenes/w01_first_pictures.scn", "fig06", 0.6),
        ("scenes/w01_first_pictures.scn", "fig04", 0.6),
    ] {
        let [independent, was] = foretold_and_true(scene, name, scale, "independent");
        println!("{name}: {independent:.5} {was:.5}");
        assert!((0.7..1.4).contains(&(independent / was)), "{name}: {independent} for {was}");
        // Of samples spread evenly it is cautious, for rounds are longer than a pilot run.
        let [sobol, was] = foretold_and_true(scene, name, scale, "sobol { round: 64 }");
        println!("{name}: {sobol:.5} {was:.5}");
        assert!((0.8..8.0).contains(&(sobol / was)), "{name}: {sobol} for {was}");
    }
}
