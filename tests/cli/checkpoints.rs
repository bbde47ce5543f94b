//! Renders that are kept, killed and gone on with.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use scn::math::random;

use crate::bench::{BALL, Bench, Run, assert_same, forge, whole};

/// Samples of each pixel that a run had from before, and when it was killed.
struct Killed {
    before: u64,
    after: u64,
}

/// Runs until so many checkpoints are told, and kills it there; if `writing`, when the next one is
/// being written. None if it ended before.
fn killed(bench: &Bench, arguments: &str, checkpoints: u64, writing: bool) -> Option<Killed> {
    let mut child = bench
        .command(&format!("{arguments} --log json"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut before, mut told) = (0, 0);
    for line in BufReader::new(child.stdout.take().unwrap()).lines() {
        let event: serde_json::Value = serde_json::from_str(&line.unwrap()).unwrap();
        match event["event"].as_str() {
            Some("resumed") => before = event["samples"].as_u64().unwrap(),
            Some("checkpoint") if event["ended"] == true => break,
            Some("checkpoint") => told += 1,
            _ => continue,
        }
        if told == checkpoints {
            let half = |name: &String| name.ends_with(".part");
            while writing && !bench.files().iter().any(half) && child.try_wait().unwrap().is_none()
            {
            }
            child.kill().unwrap();
            child.wait().unwrap();
            return Some(Killed { before, after: event["samples"].as_u64().unwrap() });
        }
    }
    let done = child.wait_with_output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    None
}

/// Kills a render of `ball.scn` that often, each time going on from the last checkpoint, lets it
/// end, and returns how often that was.
fn tortured(bench: &Bench, arguments: &str, kills: u64, seed: u64) -> u64 {
    let arguments = format!("render ball.scn --only left --checkpoint 0.001ms {arguments}");
    let (mut begin, mut kept) = ("", 0);
    for i in 0..kills {
        let chance = random::at(random::mix(seed), i);
        let (checkpoints, writing) = (1 + chance % 4, chance & 1024 != 0);
        let Some(Killed { before, after }) =
            killed(bench, &format!("{arguments} {begin}"), checkpoints, writing)
        else {
            return i;
        };
        assert!(kept <= before && before < after, "{kept} of before, {before}, {after}");
        (begin, kept) = ("--resume", after);
    }
    bench.run(&format!("{arguments} --resume")).well();
    kills
}

#[test]
fn killed_twenty_times_it_makes_the_same_bits() {
    let bench = Bench::new();
    let options = "--samples 2000 --seed 3";
    bench.run(&format!("render ball.scn --only left -o whole.exr {options}")).well();
    assert_eq!(tortured(&bench, &format!("-o broken.exr {options}"), 20, 1), 20);
    assert_same(bench.path("broken.exr"), bench.path("whole.exr"));
    // What the killed ones left was swept up.
    assert_eq!(bench.files(), ["ball.scn", "broken.checkpoint", "broken.exr", "whole.exr"]);
}

#[test]
#[ignore = "long: renders are killed a thousand times"]
fn killed_a_thousand_times_they_make_the_same_bits() {
    for seed in 0..20 {
        let bench = Bench::new();
        let options = format!("--samples {} --seed {seed}", 3000 + 517 * seed);
        bench.run(&format!("render ball.scn --only left -o whole.exr {options}")).well();
        tortured(&bench, &format!("-o broken.exr {options}"), 50, seed);
        assert_same(bench.path("broken.exr"), bench.path("whole.exr"));
    }
}

/// Parts of it are even, and end before others.
fn adaptive() -> String {
    BALL.replace("(32, 24)", "(160, 32)")
        .replace("samples: 4 }", "error: 0.25 %, samples: 4000, adaptive: on }")
        .replace("fov_y: 40 deg", "fov_y: 30 deg")
}

#[test]
fn a_render_that_ends_by_its_error_ends_where_it_would_have_ended() {
    let bench = Bench::new();
    bench.put("ball.scn", adaptive());
    bench.run("render ball.scn --only left -o whole.exr").well();
    assert!(tortured(&bench, "-o broken.exr", 12, 5) > 6);
    assert_same(bench.path("broken.exr"), bench.path("whole.exr"));
    let made = whole(bench.path("whole.exr"));
    let told = |key: &str| made.1.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str());
    assert_eq!(told("scn:stopped_by"), Some("error"));
    assert!(told("scn:schedule").is_some(), "no part of it ended before others: {:?}", made.1);

    // What ended its parts is part of what it is.
    let run = bench.run("render ball.scn --only left -o broken.exr --resume --samples 9000");
    run.ends(2).says("have reached an error of 0.25 %, and ended");
}

#[test]
fn time_that_was_spent_counts_on() {
    let bench = Bench::new();
    let arguments = "render ball.scn --only left -o a.exr --checkpoint";
    bench.run(&format!("{arguments} --samples 6")).well();
    // As if they had taken an hour.
    let hour = 3600.0;
    forge(bench.path("a.checkpoint"), |words| words["seconds"] = hour.into());
    let made = whole(bench.path("a.exr")).0;
    // With a limit of less, of as much, or of less again it is done: no sample is added.
    for limit in ["59min", "1h", "0.001ms"] {
        std::fs::remove_file(bench.path("a.exr")).unwrap();
        let run = bench.run(&format!("{arguments} --resume --log json --time {limit}")).well();
        let events = run.events();
        let told = |event: &str| events.iter().find(|told| told["event"] == event).unwrap();
        assert!(told("resumed")["seconds"].as_f64().unwrap() >= hour);
        assert!(told("rendered")["seconds"].as_f64().unwrap() >= hour);
        assert_eq!(told("rendered")["stopped_by"], "time");
        assert_eq!(word_of(&bench, "a.exr"), "6");
        assert!(whole(bench.path("a.exr")).0 == made);
    }
    // What is added counts from there on.
    let run = bench.run(&format!("{arguments} --resume --log json --samples 9")).well();
    let events = run.events();
    let rendered = events.iter().find(|told| told["event"] == "rendered").unwrap();
    let seconds = rendered["seconds"].as_f64().unwrap();
    assert!(seconds > hour, "{seconds}");
    assert_eq!(word_of(&bench, "a.exr"), "9");
    bench.run("render ball.scn --only left -o b.exr --samples 9").well();
    assert!(whole(bench.path("a.exr")).0 == whole(bench.path("b.exr")).0);
}

/// Samples of each pixel, as a picture tells them.
fn word_of(bench: &Bench, name: &str) -> String {
    let (_, words) = whole(bench.path(name));
    words.into_iter().find(|(key, _)| key == "scn:samples").unwrap().1
}

#[cfg(unix)]
#[test]
fn interrupted_ones_are_kept_and_gone_on_with() {
    let bench = Bench::new();
    let arguments = "render ball.scn --only left -o a.exr --samples 3000";
    let mut child = bench
        .command(&format!("{arguments} --checkpoint 0.001ms --log json"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let event = |line: String| serde_json::from_str::<serde_json::Value>(&line).unwrap();
    lines.find(|line| line.as_ref().unwrap().contains("\"checkpoint\"")).unwrap().unwrap();
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let rest: Vec<_> = lines.map(|line| event(line.unwrap())).collect();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let kept: Vec<_> = rest.iter().filter(|event| event["ended"] == true).collect();
    assert_eq!(kept.len(), 1, "{rest:?}");
    let interrupted = rest.iter().find(|event| event["event"] == "interrupted").unwrap();
    assert_eq!(kept[0]["samples"], interrupted["samples"]);
    assert!(whole(bench.path("a.exr")).1.iter().any(|(key, _)| key == "scn:interrupted"));

    let run = bench.run(&format!("{arguments} --resume --log json")).well();
    let events = run.events();
    let resumed = events.iter().find(|event| event["event"] == "resumed").unwrap();
    assert_eq!(resumed["samples"], kept[0]["samples"]);
    bench.run(&arguments.replace("a.exr", "b.exr")).well();
    assert_same(bench.path("a.exr"), bench.path("b.exr"));
}

/// The line that a child writes with this event, or its last one.
#[cfg(unix)]
fn until(lines: &mut impl Iterator<Item = std::io::Result<String>>, event: &str) {
    let named = format!("\"event\":\"{event}\"");
    assert!(lines.any(|line| line.unwrap().contains(&named)), "no {event}");
}

#[cfg(unix)]
#[test]
fn one_render_alone_writes_a_checkpoint() {
    let bench = Bench::new();
    let arguments = "render ball.scn --only left -o a.exr";
    let mut child = bench
        .command(&format!("{arguments} --samples 4000000000 --checkpoint 0.001ms --log json"))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    // Before there is anything of its name, and after.
    until(&mut lines, "rendering");
    let told = "the checkpoint `a.checkpoint` is being written by another render";
    bench.run(&format!("{arguments} --checkpoint --seed 1")).ends(2).says(told);
    until(&mut lines, "checkpoint");
    bench.run(&format!("{arguments} --checkpoint")).ends(2).says(told);
    bench.run(&format!("{arguments} --resume --time 1ms")).ends(2).says(told);
    bench.run("render ball.scn --only left -o b.exr --checkpoint").well();
    // A killed one holds nothing.
    child.kill().unwrap();
    child.wait().unwrap();
    bench.run(&format!("{arguments} --resume --time 1ms")).well();
    assert_eq!(bench.files(), ["a.checkpoint", "a.exr", "b.checkpoint", "b.exr", "ball.scn"]);
}

#[cfg(unix)]
#[test]
fn nothing_is_kept_of_half_a_sample_and_that_is_told() {
    let bench = Bench::new();
    bench.put("ball.scn", BALL.replace("(32, 24)", "(2048, 2048)"));
    let mut child = bench
        .command("render ball.scn --only left -o a.png --checkpoint --threads 1 --log json")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    until(&mut lines, "progress");
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let rest: Vec<String> = lines.map(|line| line.unwrap()).collect();
    let run = Run::new(child.wait_with_output().unwrap()).ends(130);
    run.says("`a.checkpoint` is not written: nothing is kept before every pixel has its first");
    assert!(rest.iter().any(|line| line.contains("\"remark\"") && line.contains("not written")));
    assert_eq!(bench.files(), ["a.png", "ball.scn"]);
}

#[test]
fn a_checkpoint_lies_beside_each_picture() {
    let bench = Bench::new();
    bench.run("render ball.scn --checkpoint").well();
    let kept = ["out/ball/left.checkpoint", "out/ball/right.checkpoint"];
    assert!(kept.iter().all(|name| bench.files().contains(&name.to_string())));
    let run = bench.run("render ball.scn --checkpoint 5min").ends(2);
    run.says("`out/ball/left.checkpoint` is there already").says("--resume").says("delete it");
    // One render has a checkpoint, the other one begins anew, and says so.
    std::fs::remove_file(bench.path(kept[1])).unwrap();
    let run = bench.run("render ball.scn --resume --samples 9").well();
    assert!(run.stdout.contains("left.checkpoint, 4 samples a pixel in"), "{}", run.stdout);
    assert!(run.stdout.contains("there is no out/ball/right.checkpoint, so it begins anew"));
    assert!(kept.iter().all(|name| bench.files().contains(&name.to_string())));
    let run = bench.run("render ball.scn --resume --samples 8").ends(2);
    run.says("holds 9 samples a pixel already, more than the limit of 8");
    bench.run("render --checkpoint ball.scn").ends(2).says("stands before --checkpoint");
}

#[test]
fn limits_caption_and_exposure_may_change() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left -o a.exr --checkpoint --samples 100").well();
    let changed = BALL
        .replace("samples: 4", "samples: 200, time: 1 h")
        .replace("(32, 24)", "(32, 24), exposure: 1 ev")
        .replace("Light from", "The light comes from");
    bench.put("ball.scn", changed);
    bench.run("render ball.scn --only left -o a.exr --resume").well();
    bench.run("render ball.scn --only left -o b.exr").well();
    assert_same(bench.path("a.exr"), bench.path("b.exr"));
}

#[test]
fn what_is_of_another_render_is_left_alone() {
    let bench = Bench::new();
    bench.put("other.scn", BALL.replace("albedo: 0.8", "albedo: 0.7"));
    bench.put("wide.scn", BALL.replace("(32, 24)", "(33, 24)"));
    bench.run("render ball.scn --only left -o a.exr --checkpoint").well();
    let before = std::fs::read(bench.path("a.checkpoint")).unwrap();
    for (arguments, words) in [
        ("ball.scn --only right", "render `left`, not `right`"),
        ("ball.scn --only left --seed 1", "seed 0, not 1"),
        ("ball.scn --only left --scale 0.5", "scale 1, not 0.5"),
        ("ball.scn --only left --crop 0,0,8,8", "the whole film, not the crop 0,0,8,8"),
        ("ball.scn --only left --set integrator.shadows=off", "not made with --set `integrator"),
        ("other.scn --only left", "the scene `ball.scn` of hash "),
        ("wide.scn --only left", "a film of 32 × 24, not a film of 33 × 24"),
    ] {
        let run = bench.run(&format!("render {arguments} -o a.exr --resume")).ends(2);
        run.says("the checkpoint `a.checkpoint` is of another render:").says(words);
        assert!(std::fs::read(bench.path("a.checkpoint")).unwrap() == before);
    }
    // A shard has a checkpoint of its own.
    bench.run("render ball.scn --only left -o a.exr --resume --shard 1/1").well();
    assert!(bench.files().contains(&"a.1-of-1.checkpoint".to_string()));
    std::fs::copy(bench.path("a.1-of-1.part"), bench.path("a.checkpoint")).unwrap();
    let run = bench.run("render ball.scn --only left -o a.exr --resume").ends(2);
    run.says("is a part of a render, not a checkpoint");
    std::fs::copy(bench.path("a.1-of-1.checkpoint"), bench.path("a.checkpoint")).unwrap();
    let run = bench.run("render ball.scn --only left -o a.exr --resume").ends(2);
    run.says("part 1 of 1, samples 0 to 3 of 4, not all samples");
}

#[test]
fn broken_and_forged_ones_are_told_not_trusted() {
    let bench = Bench::new();
    let run = |words: &str| {
        let run = bench.run("render ball.scn --only left -o a.exr --resume").ends(2);
        run.says("the checkpoint `a.checkpoint` ").says(words);
    };
    bench.run("render ball.scn --only left -o a.exr --checkpoint --samples 3").well();
    let good = std::fs::read(bench.path("a.checkpoint")).unwrap();
    bench.put("a.checkpoint", &good[..good.len() / 2]);
    run("is not whole: it ends too early");
    let mut flipped = good.clone();
    flipped[good.len() / 2] ^= 1;
    bench.put("a.checkpoint", flipped);
    run("is damaged: its bytes do not fit its checksum");
    bench.put("a.checkpoint", "I am no checkpoint, but a long text about something else.");
    run("is neither a checkpoint nor a part of a render");

    type Change = fn(&mut serde_json::Value);
    let changes: [(Change, &str); 6] = [
        (|words| words["seconds"] = (-1.0).into(), "contradicts itself"),
        (|words| words["frame"]["window"]["x1"] = 31.into(), "contradicts itself"),
        (|words| words["frame"]["light_unit"] = 0.0.into(), "contradicts itself"),
        (|words| words["about"]["render"] = "../left".into(), "contradicts itself"),
        (|words| words["kind"] = "else".into(), "is whole, but not written by this scn"),
        (|words| words["about"]["seed"] = "0".into(), "is whole, but not written by this scn"),
    ];
    for (change, words) in changes {
        bench.put("a.checkpoint", &good);
        forge(bench.path("a.checkpoint"), change);
        run(words);
    }
    // The samples of another film, with words that fit.
    bench.put("wide.scn", BALL.replace("(32, 24)", "(33, 24)"));
    bench.run("render wide.scn --only left -o b.exr --checkpoint --samples 3").well();
    bench.put("a.checkpoint", &good);
    let mut about = None;
    forge(bench.path("a.checkpoint"), |words| about = Some(words.clone()));
    forge(bench.path("b.checkpoint"), |words| *words = about.unwrap());
    std::fs::copy(bench.path("b.checkpoint"), bench.path("a.checkpoint")).unwrap();
    run("contradicts itself");
}

/// Runs it where no file may be longer than so many blocks, of 512 or 1024 bytes.
#[cfg(target_os = "linux")]
fn limited(bench: &Bench, blocks: u32, arguments: &str) -> Run {
    let binary = env!("CARGO_BIN_EXE_scn");
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec {binary} {arguments}");
    let mut command = Command::new("sh");
    command.args(["-c", &script]).current_dir(bench.path(""));
    Run::new(command.output().unwrap())
}

#[cfg(target_os = "linux")]
#[test]
fn where_the_disk_takes_no_checkpoint_the_render_goes_on_and_the_older_one_stays() {
    let bench = Bench::new();
    let arguments = "render ball.scn --only left -o a.exr --samples 300";
    bench.run("render ball.scn --only left -o a.exr --checkpoint --samples 3").well();
    let before = std::fs::read(bench.path("a.checkpoint")).unwrap();
    let run = limited(&bench, 20, &format!("{arguments} --checkpoint 0.001ms --resume")).well();
    let told =
        "the checkpoint `a.checkpoint` is larger than the system allows; the older one stays";
    assert_eq!(run.stderr.matches(told).count(), 1, "{}", run.stderr);
    assert!(std::fs::read(bench.path("a.checkpoint")).unwrap() == before);
    bench.run(&arguments.replace("a.exr", "b.exr")).well();
    assert_same(bench.path("a.exr"), bench.path("b.exr"));
    // Without room for the picture the work is not done; there is still something to go on from.
    let run = limited(&bench, 1, &format!("{arguments} --checkpoint 0.001ms --resume")).ends(2);
    run.says(told).says("the picture `a.exr` is larger than the system allows");
    bench.run(&format!("{arguments} --resume")).well();
    assert_same(bench.path("a.exr"), bench.path("b.exr"));
    assert_eq!(bench.files(), ["a.checkpoint", "a.exr", "b.exr", "ball.scn"]);
}

#[test]
fn a_refusal_names_what_counts_alone() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left --samples 2 --checkpoint -o a.exr").well();
    // Of other light, caption and exposure: the light alone counts.
    let mut command = bench.command("render ball.scn --only left --samples 4 --resume -o a.exr");
    command.args(["--set", "caption=\"else\"", "--set", "film.exposure=1 ev"]);
    let run = Run::new(command.args(["--set", "light sky.radiance=1 W/m^2/sr"]).output().unwrap());
    let run = run.ends(2).says("not made with --set `light sky.radiance=1 W/m^2/sr`\n");
    assert!(!run.stderr.contains("caption") && !run.stderr.contains("exposure"), "{}", run.stderr);
}
