//! Pictures rendered once more.

use crate::bench::{BALL, Bench, assert_same, whole};

/// What is the same of two pictures of the same samples.
fn samples(bench: &Bench, name: &str) -> Vec<(String, Vec<u32>)> {
    whole(bench.path(name)).0
}

#[test]
fn the_same_samples_give_the_same_bits() {
    let bench = Bench::new();
    let settings = "--only right --samples 77 --seed 5 --scale 0.5 --crop 1,2,13,11";
    bench.run(&format!("render ball.scn {settings} -o a")).well();
    for picture in ["a/right.exr", "a/right.png"] {
        bench.run(&format!("render ball.scn --replay {picture} -o b.exr")).well();
        assert_same(bench.path("b.exr"), bench.path("a/right.exr"));
    }
    let mut command = bench.command("render ball.scn --only left -o c.exr --samples 9 --set");
    assert!(command.arg("light sun.direction=(1, -2, -1)").status().unwrap().success());
    bench.run("render ball.scn --replay c.exr -o d.exr").well();
    assert_same(bench.path("d.exr"), bench.path("c.exr"));
}

#[test]
fn samples_that_differ_from_tile_to_tile_are_those_of_the_picture() {
    let bench = Bench::new();
    let adaptive = BALL
        .replace("(32, 24)", "(160, 32)")
        .replace("samples: 4 }", "error: 0.25 %, samples: 4000, adaptive: on }");
    bench.put("ball.scn", adaptive);
    bench.run("render ball.scn --only left -o a").well();
    let words = whole(bench.path("a/left.exr")).1;
    assert!(words.iter().any(|(key, _)| key == "scn:schedule"), "{words:?}");
    for (picture, made) in [("a/left.exr", "b.exr"), ("a/left.png", "c.exr")] {
        bench.run(&format!("render ball.scn --replay {picture} -o {made}")).well();
        assert!(samples(&bench, made) == samples(&bench, "a/left.exr"));
    }
    let schedule = |name: &str| {
        let words = whole(bench.path(name)).1;
        words.into_iter().find(|(key, _)| key == "scn:schedule")
    };
    assert_eq!(schedule("b.exr"), schedule("a/left.exr"));
}

#[test]
fn the_picture_that_is_replayed_is_never_replaced() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left").well();
    let before = std::fs::read(bench.path("out/ball/left.exr")).unwrap();
    for arguments in [
        "out/ball/left.exr",
        "out/ball/left.png",
        "out/ball/left.exr -o out/ball",
        "out/ball/left.png -o out/../out/ball/left.png",
    ] {
        let run = bench.run(&format!("render ball.scn --replay {arguments}")).ends(2);
        run.says("is the one that is replayed").says("with -o");
    }
    assert!(std::fs::read(bench.path("out/ball/left.exr")).unwrap() == before);
    bench.run("render ball.scn --replay out/ball/left.exr -o out/again").well();
}

#[test]
fn pictures_of_other_scenes_and_programs_are_refused() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left -o a").well();
    let again = |arguments: &str| bench.run(&format!("render ball.scn --replay {arguments}"));
    for option in ["--samples 3", "--seed 3", "--only left", "--shard 1/2", "--resume"] {
        again(&format!("a/left.exr {option}")).ends(2).says("cannot be used with");
    }
    again("ball.scn").ends(2).says("is neither .exr nor .png");
    again("none.exr").ends(2).says("the picture `none.exr` does not exist");
    bench.put("ball.scn", BALL.replace("0.8 }", "0.7 }"));
    let run = again("a/left.exr").ends(2);
    run.says("the picture `a/left.exr` is of another scene").says("not `ball.scn` of hash");
    bench.put("ball.scn", BALL.replace("render left", "render lift"));
    again("a/left.exr").ends(2).says("no render `left`");
    // Exposure, caption and limits are no part of what is seen.
    bench.put(
        "ball.scn",
        BALL.replace("24)", "24), exposure: 1 ev").replace("samples: 4", "time: 9 h"),
    );
    again("a/left.exr -o b.exr").well();
    assert!(samples(&bench, "b.exr") == samples(&bench, "a/left.exr"));

    let (layers, words) = scn::files::exr::read(&bench.path("a/left.exr")).unwrap();
    let forged = |key: &str, value: Option<&str>| {
        let mut words = words.clone();
        words.retain(|(k, _)| k != key);
        words.extend(value.map(|value| (key.to_string(), value.to_string())));
        scn::files::exr::write(&bench.path("forged.exr"), &layers, &words).unwrap();
        again("forged.exr").ends(2)
    };
    forged("scn:seed", None).says("it has no `scn:seed`");
    forged("scn:seed", Some("-1")).says("has a strange `scn:seed`: `-1`");
    forged("scn:crop", Some("1,2")).says("has a strange `scn:crop`");
    forged("scn:samples", Some("0")).says("has 0 samples a pixel");
    forged("scn:schedule", Some("1,2,x")).says("has a strange `scn:schedule`");
    forged("scn:schedule", Some("1,2,3")).says("tells the samples of 3 tiles, but has 4");
    forged("scn:version", Some("0.0.1")).says("was made by scn 0.0.1");
    forged("scn:crop", Some("0,0,99,99")).says("reaches beyond the film");
}
