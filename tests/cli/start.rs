//! What one begins with: a new scene, completions, pages for `man`.

use crate::bench::Bench;

#[test]
fn a_new_scene_has_no_fault_is_in_the_style_and_renders() {
    let bench = Bench::new();
    let said = bench.run("new balls").well().stdout;
    let told = [
        "wrote balls.scn",
        "  its pictures    scn render balls.scn",
        "  all words       scn list",
        "  the first hour  docs/tour.md",
    ];
    assert_eq!(said.lines().collect::<Vec<_>>(), told);
    let tour = told[3].split_whitespace().last().unwrap();
    assert!(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(tour).exists());
    assert!(bench.run("lint balls.scn").well().stderr.is_empty());
    bench.run("fmt --check balls.scn").well();
    let run = bench.run("render balls.scn --scale 0.05 --samples 1").well();
    assert_eq!(run.stderr, "");
    assert!(!run.stdout.contains("bias"), "{}", run.stdout);
    assert!(bench.files().contains(&"out/balls/evening.png".to_string()), "{:?}", bench.files());
}

#[test]
fn nothing_is_written_over() {
    let bench = Bench::new();
    let before = std::fs::read(bench.path("ball.scn")).unwrap();
    bench.run("new ball").ends(2).says("the scene file `ball.scn` is there already");
    bench.run("new ball.scn").ends(2).says("is there already");
    assert_eq!(std::fs::read(bench.path("ball.scn")).unwrap(), before);
    bench.run("new").well();
    bench.run("new deep/er/a").well();
    assert_eq!(bench.files(), ["ball.scn", "deep/er/a.scn", "scene.scn"]);
    for nameless in [".", "..", "x1/", "x1/.", ".scn", "x."] {
        bench.run(&format!("new {nameless}")).ends(2).says(&format!("`{nameless}` names no file"));
    }
    bench.run("new ball.scn/a").ends(2).says("a file is in its way");
}

#[test]
fn shells_and_man_know_every_command() {
    let bench = Bench::new();
    let commands = ["render", "lint", "fmt", "compare", "explain", "list", "new"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = bench.run(&format!("completions {shell}")).well().stdout;
        assert!(commands.iter().all(|command| script.contains(command)), "{shell}");
    }
    bench.run("completions dos").ends(2).says("possible values: bash");
    let page = bench.run("man").well().stdout;
    assert!(page.contains(".TH scn 1") && commands.iter().all(|c| page.contains(c)), "{page}");
    let page = bench.run("man render").well().stdout;
    assert!(page.contains(".TH scn-render 1") && page.contains("samples"), "{page}");
    bench.run("man rendr").ends(2).says("did you mean `render`?");
}
