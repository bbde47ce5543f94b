//! What is rendered, and where it goes.

use crate::bench::{BALL, Bench, bits, word};

#[test]
fn pictures_go_to_a_folder_named_like_the_scene() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn").well();
    let made = ["left.exr", "left.png", "right.exr", "right.png"].map(|n| format!("out/ball/{n}"));
    assert_eq!(bench.files(), [&["ball.scn".to_string()][..], &made].concat());
    for name in &made {
        assert!(run.stdout.contains(name.as_str()), "{name} is not in:\n{}", run.stdout);
    }
    assert_eq!(run.stderr, "");
    assert_ne!(bits(bench.path(&made[0])), bits(bench.path(&made[2])));
}

#[test]
fn pictures_tell_how_they_were_made() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left --seed 7 --scale 0.5").well();
    let told = |key| word(bench.path("out/ball/left.png"), key);
    assert_eq!(told("scn:scene").as_deref(), Some("ball.scn"));
    assert_eq!(told("scn:render").as_deref(), Some("left"));
    assert_eq!(told("scn:seed").as_deref(), Some("7"));
    assert_eq!(told("scn:samples").as_deref(), Some("4"));
    assert_eq!(told("scn:version").as_deref(), Some(env!("CARGO_PKG_VERSION")));
    assert_eq!(told("scn:caption").as_deref(), Some("Light from the right."));
    assert_eq!(told("scn:scale").as_deref(), Some("0.5"));
    assert_eq!(told("scn:crop"), None);
    assert_eq!(told("scn:hash").unwrap().len(), 64);
    assert!(told("scn:time").unwrap().parse::<f64>().unwrap() >= 0.0);
    let (layers, words) = scn::files::exr::read(&bench.path("out/ball/left.exr")).unwrap();
    assert_eq!(layers.film, [16, 12]);
    assert!(words.contains(&("scn:seed".to_string(), "7".to_string())));
}

#[test]
fn one_render_goes_to_one_file_of_the_kind_asked_for() {
    let bench = Bench::new();
    bench.run("render ball.scn --only right -o a/b.exr").well();
    bench.run("render ball.scn --only right -o b.PNG").well();
    bench.run("render ball.scn --only right -o pictures").well();
    let made = ["a/b.exr", "b.PNG", "ball.scn", "pictures/right.exr", "pictures/right.png"];
    assert_eq!(bench.files(), made);
    assert_eq!(bits(bench.path("a/b.exr")), bits(bench.path("pictures/right.exr")));
}

#[test]
fn a_file_for_several_renders_is_refused() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn -o a.png").ends(2);
    run.says("`a.png` holds one picture, but 2 renders").says("--only").says("`left` and `right`");
    bench.run("render ball.scn -o a.jpg").ends(2).says("written as .exr or .png, not as .jpg");
    assert_eq!(bench.files(), ["ball.scn"]);
    // A folder may be called so.
    bench.run("render ball.scn --only left -o a.jpg/").well();
    bench.run("render ball.scn --only right -o a.jpg").well();
    assert_eq!(bench.files().len(), 5);
}

#[test]
fn only_names_renders_that_exist() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn --only lift").ends(2);
    run.says("no render `lift`").says("did you mean `left`?").says("`left` and `right`");
    assert_eq!(bench.files(), ["ball.scn"]);
}

#[test]
fn a_changed_scene_is_another_picture() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left -o a.exr").well();
    let mut command = bench.command("render ball.scn --only left -o b.exr --set");
    let done = command.arg("light sun.direction: (1, -1, -1)").output().unwrap();
    // The value stands behind an equals sign.
    assert_ne!(done.status.code(), Some(0));
    let mut command = bench.command("render ball.scn --only left -o b.exr --set");
    let done = command.arg("light sun.direction=(1, -1, -1)").output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    bench.run("render ball.scn --only right -o c.exr").well();
    assert_ne!(bits(bench.path("a.exr")), bits(bench.path("b.exr")));
    assert_eq!(bits(bench.path("b.exr")), bits(bench.path("c.exr")));
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let bench = Bench::new();
    let picture = |threads: u32| {
        let options = format!("-o {threads}.exr --only left --threads {threads} --samples 9");
        bench.run(&format!("render ball.scn {options}")).well();
        bits(bench.path(format!("{threads}.exr")))
    };
    let one = picture(1);
    assert_eq!(one, picture(2));
    assert_eq!(one, picture(7));
    bench.run("render ball.scn -o seed.exr --only left --samples 9 --seed 1").well();
    assert_ne!(one, bits(bench.path("seed.exr")));
}

#[test]
fn a_crop_is_part_of_the_whole() {
    let bench = Bench::new();
    bench.run("render ball.scn --only left -o whole.exr").well();
    bench.run("render ball.scn --only left -o part.exr --crop 10,5,20,24").well();
    let (whole, _) = scn::files::exr::read(&bench.path("whole.exr")).unwrap();
    let (part, _) = scn::files::exr::read(&bench.path("part.exr")).unwrap();
    assert_eq!((part.film, part.origin), ([32, 24], [10, 5]));
    assert_eq!((part.main.width, part.main.height), (10, 19));
    for (x, y) in (0..10).flat_map(|x| (0..19).map(move |y| (x, y))) {
        assert_eq!(part.main.at(x, y), whole.main.at(x + 10, y + 5));
    }
    let run = bench.run("render ball.scn --only left --crop 10,5,33,24").ends(2);
    run.says("the crop 10,5,33,24 reaches beyond the film of 32 × 24");
    bench.run("render ball.scn --scale 0.001").ends(2).says("has no pixel");
}

#[test]
fn exposure_changes_the_png_and_not_the_light() {
    let bench = Bench::new();
    bench.put("bright.scn", BALL.replace("(32, 24)", "(32, 24), exposure: 2 ev"));
    bench.run("render ball.scn --only left -o a").well();
    bench.run("render bright.scn --only left -o b").well();
    assert_eq!(bits(bench.path("a/left.exr")), bits(bench.path("b/left.exr")));
    let png = |name| std::fs::read(bench.path(name)).unwrap();
    assert_ne!(png("a/left.png"), png("b/left.png"));
}
