//! Renders made in parts, and joined.

use crate::bench::{BALL, Bench, assert_same, forge, whole};

/// Renders shards of `ball.scn` into parts called `left.i-of-n.part`.
fn shards(bench: &Bench, of: u64, arguments: &str) -> Vec<String> {
    let shard = |i| {
        let run = format!("render ball.scn --only left -o . --shard {i}/{of} {arguments}");
        bench.run(&run).well();
        format!("left.{i}-of-{of}.part")
    };
    (1..=of).map(shard).collect()
}

#[test]
fn seven_parts_in_any_order_are_one_run() {
    let bench = Bench::new();
    let settings = "--samples 500 --seed 9 --scale 0.75 --crop 3,2,20,17";
    bench.run(&format!("render ball.scn --only left -o whole.exr {settings}")).well();
    let parts = shards(&bench, 7, settings);
    let expected = whole(bench.path("whole.exr"));
    for order in [[0, 1, 2, 3, 4, 5, 6], [4, 2, 6, 0, 5, 1, 3], [6, 5, 4, 3, 2, 1, 0]] {
        let parts: Vec<&str> = order.iter().map(|&i| &*parts[i]).collect();
        bench.run(&format!("merge {} -o merged.exr", parts.join(" "))).well();
        assert_same(bench.path("merged.exr"), bench.path("whole.exr"));
    }
    assert!(expected.0.iter().any(|(name, _)| name == "error"));
}

#[test]
fn a_folder_gets_both_pictures_and_the_log_tells_the_same() {
    let bench = Bench::new();
    let one = bench.run("render ball.scn --only left -o one --samples 300 --log json").well();
    let parts = shards(&bench, 3, "--samples 300").join(" ");
    let merged = bench.run(&format!("merge {parts} -o merged/ --log json")).well();
    let rendered = |events: Vec<serde_json::Value>| {
        let mut event = events.into_iter().find(|event| event["event"] == "rendered").unwrap();
        for own in ["seconds", "rays_per_second", "peak_memory"] {
            event.as_object_mut().unwrap().remove(own);
        }
        event
    };
    assert_eq!(rendered(one.events()), rendered(merged.events()));
    let event = &merged.events()[0];
    let told = ["event", "render", "parts", "samples"].map(|key| event[key].to_string());
    assert_eq!(told, ["\"merged\"", "\"left\"", "3", "300"]);
    let names = ["merged/left.exr", "merged/left.png"];
    assert!(names.iter().all(|name| bench.files().contains(&name.to_string())));
    assert_same(bench.path("one/left.exr"), bench.path(names[0]));
    let pixels = |name: &str| scn::files::png::read(&bench.path(name)).unwrap().0;
    assert_eq!(pixels("one/left.png"), pixels(names[1]));
    let run = bench.run(&format!("merge {parts} -o human.exr")).well();
    for words in
        ["left\n  merged    3 parts, 300 samples a pixel", "error     ", "wrote     human.exr"]
    {
        assert!(run.stdout.contains(words), "{words:?} is not in:\n{}", run.stdout);
    }
}

#[test]
fn missing_double_and_overlapping_parts_are_named() {
    let bench = Bench::new();
    let parts = shards(&bench, 5, "--samples 320");
    let others = shards(&bench, 2, "--samples 320");
    let merge = |parts: &[&str]| {
        bench.run(&format!("merge {} -o merged.exr", parts.join(" "))).ends(2).stderr
    };
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| &*parts[i]);
    assert_eq!(
        merge(&[d, a, e]),
        "error: 2 shards are missing: 2/5, 3/5\n  render with --shard 2/5\n"
    );
    assert!(merge(&[a, b, c, d]).contains("1 shard is missing: 5/5"));
    std::fs::copy(bench.path(b), bench.path("copy")).unwrap();
    let told = merge(&[a, b, c, "copy", d, e]);
    assert!(told.contains("`left.2-of-5.part` and `copy` are the same: part 2 of 5"), "{told}");
    let told = merge(&[&others[0], b, c, d, e]);
    let words = "`left.1-of-2.part` (part 1 of 2, samples 0 to 127) and `left.2-of-5.part` (part 2 \
                 of 5, samples 64 to 127) overlap";
    assert!(told.contains(words), "{told}");
    let told = merge(&[&others[0], d, e]);
    assert_eq!(told, "error: missing: samples 128 to 191\n");
    // Of two cuts, but whole.
    bench.run(&format!("merge {e} {} {d} {c} -o merged.exr", others[0])).well();
    bench.run("render ball.scn --only left -o whole.exr --samples 320").well();
    assert_same(bench.path("merged.exr"), bench.path("whole.exr"));
}

#[test]
fn parts_of_other_pictures_are_refused() {
    let bench = Bench::new();
    let mine = shards(&bench, 2, "--samples 200");
    let stranger = |scene: &str, arguments: &str| {
        bench.put("other.scn", scene);
        let options = format!("-o other/ --shard 2/2 {arguments}");
        bench.run(&format!("render other.scn {options}")).well();
        let names = bench.files();
        let part = names.iter().find(|name| name.starts_with("other/")).unwrap().clone();
        let run = bench.run(&format!("merge {} {part} -o merged.exr", mine[0])).ends(2);
        std::fs::remove_file(bench.path(&part)).unwrap();
        let head = format!("`{part}` is not of one picture with `left.1-of-2.part`:");
        run.says(&head).stderr
    };
    let left = "--only left --samples 200";
    for (told, words) in [
        (stranger(BALL, "--only right --samples 200"), "render `right`, not `left`"),
        (stranger(BALL, &format!("{left} --seed 4")), "seed 4, not 0"),
        (stranger(BALL, &format!("{left} --crop 0,0,9,9")), "the crop 0,0,9,9, not the whole film"),
        (stranger(BALL, "--only left --samples 201"), "201 samples a pixel, not 200"),
        (stranger(&BALL.replace("0.8 }", "0.7 }"), left), "the scene `other.scn` of hash"),
        (stranger(&BALL.replace("24)", "24), exposure: 1 ev"), left), "exposure 1 ev, not 0 ev"),
        (stranger(&BALL.replace("Light", "Sun"), left), "the caption `Sun from the right.`, not"),
        (stranger(BALL, left), "made from the file `other.scn` with no --set, not from `ball.scn`"),
    ] {
        assert!(told.contains(words), "no {words:?} in:\n{told}");
        assert!(!bench.files().contains(&"merged.exr".to_string()));
    }
}

#[test]
fn what_is_no_part_is_told() {
    let bench = Bench::new();
    let parts = shards(&bench, 2, "--samples 100");
    bench.run("render ball.scn --only left -o a.exr --checkpoint --samples 100").well();
    let run = bench.run(&format!("merge {} a.exr a.checkpoint none -o m.exr", parts[0])).ends(2);
    let run = run.says("the part `a.exr` is neither a checkpoint nor a part of a render");
    run.says("`a.checkpoint` is a checkpoint, not a part").says("the part `none` does not exist");
    let good = std::fs::read(bench.path(&parts[1])).unwrap();
    let both = parts.join(" ");
    for end in [0, 5, 30, good.len() / 2, good.len() - 1] {
        bench.put(&parts[1], &good[..end]);
        bench.run(&format!("merge {both} -o m.exr")).ends(2).says("is not whole");
    }
    type Change = fn(&mut serde_json::Value);
    let changes: [Change; 6] = [
        |words| words["slice"]["first"] = 0.into(),
        |words| words["slice"]["end"] = 99.into(),
        |words| words["slice"] = serde_json::Value::Null,
        |words| words["limits"]["samples"] = 101.into(),
        |words| words["frame"]["window"]["x1"] = u64::MAX.into(),
        |words| words["about"]["render"] = "a/../../left".into(),
    ];
    for change in changes {
        bench.put(&parts[1], &good);
        forge(bench.path(&parts[1]), change);
        bench.run(&format!("merge {both} -o m.exr")).ends(2).says("contradicts itself");
    }
    bench.put(&parts[1], &good);
    let run = bench.run(&format!("merge {both} -o {}", parts[1])).ends(2);
    run.says("pictures are written as .exr or .png");
    bench.run(&format!("merge {both} -o m.exr")).well();
}

#[test]
fn a_shard_needs_to_know_its_samples() {
    let bench = Bench::new();
    let run = |arguments: &str| bench.run(&format!("render ball.scn --only left {arguments}"));
    run("--shard 2/3 --time 1s").ends(2).says("it is done after 1 s").says("give --samples N");
    run("--shard 2/3 --error 1%").ends(2).says("an error of 1 %");
    let told = run("--shard 1/3 --samples 128").ends(2);
    told.says("128 samples a pixel are 2 blocks of 64, too few for 3 shards").says("at least 129");
    run("--shard 4/3").ends(2).says("there is no shard 4 of 3");
    assert_eq!(bench.files(), ["ball.scn"]);
    bench.put("ball.scn", BALL.replace("samples: 4", "samples: 4, time: 1 h"));
    run("--shard 1/1").ends(2).says("4 samples a pixel or 60 min 0 s");
    run("--shard 1/1 --samples 4").well();
}

#[test]
fn a_shard_can_be_kept_and_gone_on_with() {
    let bench = Bench::new();
    let run = |arguments: &str| {
        bench.run(&format!("render ball.scn --only left -o . --samples 400 {arguments}")).well()
    };
    run("--shard 1/2");
    run("--shard 2/2 --checkpoint 0.001ms");
    let name = "left.2-of-2.checkpoint";
    assert!(bench.files().contains(&name.to_string()));
    std::fs::remove_file(bench.path("left.2-of-2.part")).unwrap();
    let told = run("--shard 2/2 --resume").stdout;
    assert!(told.contains("resumed   ./left.2-of-2.checkpoint, 208 samples a pixel in"), "{told}");
    bench.run("merge left.2-of-2.part left.1-of-2.part -o a.exr").well();
    bench.run("render ball.scn --only left -o b.exr --samples 400").well();
    assert_same(bench.path("a.exr"), bench.path("b.exr"));
    // Another number of samples is another slice.
    let run = bench.run("render ball.scn --only left -o . --samples 500 --shard 2/2 --resume");
    run.ends(2).says("samples 192 to 399 of 400, not part 2 of 2, samples 256 to 499 of 500");
}
