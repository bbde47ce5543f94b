//! `scn plan`, and what a render tells of its biases.

use crate::bench::{BALL, Bench, bits, word};

/// The ball with something wrong.
fn biased() -> Bench {
    let bench = Bench::new();
    bench.put(
        "biased.scn",
        BALL.replace("integrator: direct", "integrator: direct { shadows: off }"),
    );
    bench
}

#[test]
fn a_plan_is_readable_in_80_columns_and_writes_nothing() {
    let bench = biased();
    let run = bench.run("plan biased.scn --only left").well();
    for words in [
        "biased.scn: 1 render\n",
        "\nleft\n  requires  light on surfaces: `sun` shines, `ball` gives light back\n",
        "  left out  shadow rays: `shadows: off`\n",
        "  memory    geometry ",
        "  pilot     ",
        "  limits    4 samples a pixel: ",
        "  error     1 % takes ",
        "            twice the time, 0.71 times the error\n",
        "  bias      `direct` (biased.scn:4): at most 80 % of the light on surfaces is\n",
        "            `shadows: off` (biased.scn:4): on average ",
        "bright\n",
    ] {
        assert!(run.stdout.contains(words), "{words:?} is not in:\n{}", run.stdout);
    }
    for line in run.stdout.lines() {
        assert!(line.chars().count() <= 80, "{line}");
    }
    assert_eq!(bench.files(), ["ball.scn", "biased.scn"]);
}

#[test]
fn a_plan_for_machines_has_what_is_documented() {
    let bench = biased();
    let run = bench.run("plan biased.scn --format json --time 9s --error 1%").well();
    let plan: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(plan["renders"].as_array().unwrap().len(), 2);
    let left = &plan["renders"][0];
    assert_eq!(left["render"], "left");
    assert_eq!(left["features"][1]["need"], "switched_off");
    assert_eq!(left["limits"][0]["value"], 9.0);
    assert!(left["limits"][1]["reached"]["samples"].as_u64().unwrap() >= 256);
    assert!(left["pilot"]["samples_per_second"].as_f64().unwrap() > 0.0);
    // Every field is in the page.
    let page = include_str!("../../docs/plan.md");
    let mut waiting = vec![&plan];
    while let Some(value) = waiting.pop() {
        for (field, value) in value.as_object().into_iter().flatten() {
            assert!(page.contains(&format!("`{field}`")), "docs/plan.md does not know {field}");
            waiting.push(value);
        }
        waiting.extend(value.as_array().into_iter().flatten());
    }
}

#[test]
fn a_render_takes_no_more_memory_than_its_plan_says() {
    let bench = biased();
    let options = "biased.scn --only left --threads 8 --samples 64 --set film.size=(128,128)";
    let run = bench.run(&format!("plan {options} --format json")).well();
    let plan: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let run = bench.run(&format!("render {options} --log json")).well();
    let events = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap());
    let events: Vec<serde_json::Value> = events.collect();
    let taken = events.iter().find_map(|event| event["peak_memory"].as_u64());
    // None where the system does not tell.
    let said = plan["renders"][0]["memory"]["peak"].as_u64();
    assert!(taken <= said, "{taken:?}, {said:?}");
}

#[test]
fn plans_of_faulty_scenes_and_options_are_refused() {
    let bench = biased();
    bench.put("bad.scn", "scn 1 in m\nintegrator: direct\ncamera: perspective {}\n");
    assert!(bench.run("plan bad.scn").ends(1).stderr.contains("error["));
    bench.run("plan biased.scn --only lift").ends(2).says("did you mean `left`?");
    bench.run("plan biased.scn --crop 0,0,99,9").ends(2).says("reaches beyond the film");
    bench.run("plan nothing.scn").ends(2).says("does not exist");
}

#[test]
fn everything_can_be_put_in() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left -o a.exr").well();
    bench.run("render ball.scn --only left -o b.exr --force all").well();
    assert_eq!(bits(bench.path("a.exr")), bits(bench.path("b.exr")));
    let run = bench.run("plan ball.scn --only left --force all").well();
    assert!(
        run.stdout.contains("texture coordinates: not required, but forced: "),
        "{}",
        run.stdout
    );
    assert!(!run.stdout.contains("left out"), "{}", run.stdout);
}

#[test]
fn a_render_tells_its_biases() {
    let bench = biased();
    let run = bench.run("render biased.scn --only left").well();
    assert!(run.stdout.contains("`shadows: off` (biased.scn:4): on average "), "{}", run.stdout);
    assert!(run.stdout.contains("`light sky: constant` under `direct` (biased.scn:8): it lights"));
    let told = word(bench.path("out/biased/left.png"), "scn:bias").unwrap();
    assert_eq!(told.lines().count(), 3, "{told}");
    assert!(told.contains("too bright"), "{told}");
}

#[test]
fn biases_are_refused_before_anything_is_done() {
    let bench = biased();
    let run = bench.run("render biased.scn --unbiased").ends(1);
    for words in ["error[scene/biased]", "`shadows: off` makes the", "write `shadows: on`"] {
        assert!(run.stderr.contains(words), "{words:?} is not in:\n{}", run.stderr);
    }
    assert_eq!(bench.files(), ["ball.scn", "biased.scn"]);
    // A floor alone gives light back once.
    let alone: String = BALL
        .lines()
        .filter(|line| !line.starts_with("object ball") && !line.starts_with("light sky"))
        .map(|line| format!("{line}\n"))
        .collect();
    bench.put("floor.scn", alone);
    let run = bench.run("render floor.scn --unbiased").well();
    assert!(!run.stdout.contains("bias"), "{}", run.stdout);
    assert_eq!(word(bench.path("out/floor/left.png"), "scn:bias"), None);
}
