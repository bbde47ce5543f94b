//! Help, lists and explanations.

use crate::bench::Bench;

#[test]
fn help_and_version_are_no_faults() {
    let bench = Bench::new();
    for command in [
        "",
        "render ",
        "lint ",
        "fmt ",
        "explain ",
        "list ",
        "new ",
        "paths ",
        "completions ",
        "man ",
    ] {
        let arguments = &format!("{command}--help");
        let run = bench.run(arguments).well();
        assert!(run.stdout.contains("Examples:"), "{arguments}:\n{}", run.stdout);
        assert!(run.stdout.lines().all(|line| line.chars().count() <= 100), "{}", run.stdout);
    }
    let version = format!("scn {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(bench.run("--version").well().stdout, version);
    bench.run("").ends(2).says("Usage: scn <COMMAND>");
    bench.run("rendr ball.scn").ends(2).says("'render'");
}

#[test]
fn every_code_is_listed_and_explained() {
    let bench = Bench::new();
    let all = bench.run("explain").well().stdout;
    for code in scn::diag::CODES {
        let row = all.lines().find(|line| line.trim_start().starts_with(code.name)).unwrap();
        assert!(row.trim().len() > code.name.len() + 3, "{row} has no title");
    }
    let first = scn::diag::CODES[0].name;
    let page = bench.run(&format!("explain {first}")).well().stdout;
    assert!(page.contains("\nWrong:\n") && page.contains("\nMended:\n"), "{page}");
    bench.run(&format!("explain error[{first}]:")).well();
    let mut wrong = first.to_string();
    wrong.pop();
    bench.run(&format!("explain {wrong}")).ends(2).says(&format!("`{first}`"));
    bench.run("explain zzz").ends(2).says("`scn explain` lists all of them");
}

#[test]
fn words_of_the_language_are_listed() {
    let bench = Bench::new();
    let all = bench.run("list").well().stdout;
    for kind in scn::scene::KINDS {
        assert!(all.contains(kind.word), "{} is not in:\n{all}", kind.word);
        bench.run(&format!("list {}", kind.word)).well();
    }
    assert!(bench.run("list diffuse").well().stdout.contains("albedo"));
    // What a word does not do is said where it is looked up.
    assert!(bench.run("list constant").well().stdout.contains("lights nothing"));
    assert!(bench.run("list direct").well().stdout.contains("lights nothing"));
    assert!(bench.run("list overview").well().stdout.contains("may be cut off"));
    assert!(bench.run("list mitchell").well().stdout.contains("0.56 / sqrt(samples)"));
    assert!(bench.run("list units").well().stdout.contains("W mW kW"));
    for words in
        ["render", "setup", "functions", "keywords", "rotate", "pi", "deg", "object sphere"]
    {
        bench.run(&format!("list {words}")).well();
    }
    bench.run("list camera sphere").ends(2).says("no `sphere` in `camera`");
    bench.run("list difuse").ends(2).says("no word `difuse`; did you mean `diffuse`");
}

#[test]
fn the_reference_is_what_the_language_has() {
    let made = Bench::new().run("list --format markdown").well().stdout;
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference.md");
    let there = std::fs::read_to_string(path).unwrap();
    let changed = made.lines().zip(there.lines()).find(|(made, there)| made != there);
    assert!(
        made == there,
        "docs/reference.md is stale; renew it:\n\n    cargo run -- list --format markdown > \
         docs/reference.md\n\n{changed:#?}"
    );
    Bench::new().run("list light --format markdown").ends(2).says("cannot be used with");
}

#[test]
fn options_of_other_programs_are_known() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn --spp 64").ends(2);
    run.says("a similar argument exists: '--samples'");
    bench.run("render ball.scn --size=64").ends(2).says("a similar argument exists: '--scale'");
    // What has no samples is offered none.
    let run = bench.run("compare a.exr b.exr --spp 64").ends(2);
    assert!(!run.stderr.contains("--samples"), "{}", run.stderr);
    bench.run("list Lambert").ends(2).says("what is meant may be the material `diffuse`");
}
