//! `scn lint`: what counts, who reads it, what is mended.

use std::io::Write;
use std::process::Stdio;

use crate::bench::{BALL, Bench, Run};

/// The ball with a material that nothing has, and a comment that is not needed.
fn doubtful() -> String {
    format!(
        "{BALL}\nmaterial spare: diffuse {{ albedo: 0.5 }}\nlet used = 1 ev // lint: \
         allow(unused-let) because \"once\"\nrender third {{ film.exposure: used }}\n"
    )
}

#[test]
fn warnings_count_where_they_are_denied() {
    let bench = Bench::new();
    bench.put("my.scn", doubtful());
    let told = bench.run("lint my.scn").ends(0).stdout;
    assert!(told.contains("warning[lint/unused-material]"), "{told}");
    assert!(told.contains("warning[lint/allow-unused]"), "{told}");
    assert!(told.contains("2 warnings in my.scn\n1 of these can be mended by --fix\n"), "{told}");
    bench.run("lint my.scn --deny warnings").ends(1);
    bench.run("lint my.scn --deny unused-material").ends(1);
    bench.run("lint my.scn --deny mesh,lint/unused-let").ends(0);
    bench.run("lint my.scn --deny warnings --ignore lint").ends(0);
    bench.run("lint my.scn --deny warnings --select mesh,mtl").ends(0);
    bench.run("lint my.scn missing.scn --deny warnings").ends(2);
    let told = bench.run("lint my.scn --select unused-material --format short").ends(0).stdout;
    let line = "my.scn:16:10: warning[lint/unused-material]: nothing has the material `spare`\n";
    assert_eq!(told, line);
    let run = bench.run("lint my.scn --ignore unused-materail").ends(2);
    run.says("no code is `unused-materail`").says("did you mean `unused-material`");
}

#[test]
fn the_form_changes_no_exit_status() {
    let bench = Bench::new();
    bench.put("my.scn", doubtful());
    bench.put("bad.scn", BALL.replace("albedo: 0.8", "albedo: -0.8"));
    for form in ["human", "short", "json", "sarif", "github"] {
        let run = |rest: &str| bench.run(&format!("lint --format {form} {rest}"));
        assert!(run("my.scn").ends(0).stdout.contains("lint/unused-material"));
        run("my.scn --deny warnings").ends(1);
        run("my.scn bad.scn").ends(1);
        run("bad.scn missing.scn").ends(2);
        let clean = run("ball.scn").ends(0).stdout;
        assert!(clean.is_empty() || clean.starts_with('{'), "{clean}");
    }
}

#[test]
fn mends_that_are_safe_are_made() {
    let bench = Bench::new();
    let before = doubtful();
    bench.put("my.scn", &before);
    let diff = bench.run("lint my.scn --diff").ends(0).stdout;
    assert!(diff.starts_with("--- my.scn\n+++ my.scn\n@@ "), "{diff}");
    assert!(diff.contains("-let used = 1 ev // lint:") && diff.contains("+let used = 1 ev\n"));
    assert_eq!(std::fs::read_to_string(bench.path("my.scn")).unwrap(), before);

    let run = bench.run("lint my.scn --fix").ends(0).says("my.scn: 1 mend\n  my.scn:17: ");
    assert!(run.stdout.contains("1 warning in my.scn"), "{}", run.stdout);
    let after = std::fs::read_to_string(bench.path("my.scn")).unwrap();
    assert_eq!(after, before.replace(" // lint: allow(unused-let) because \"once\"", ""));
    // Nothing is left to be done.
    assert_eq!(bench.run("lint my.scn --diff").ends(0).stdout, "");
    bench.run("lint my.scn --fix --deny warnings").ends(1);
    assert_eq!(std::fs::read_to_string(bench.path("my.scn")).unwrap(), after);
}

#[test]
fn faults_with_one_reading_are_mended_too() {
    let bench = Bench::new();
    let wrong = BALL.replace("samples: 4", "samples= 4").replace("albedo: 0.8", "albedo: .8");
    bench.put("my.scn", wrong);
    bench.run("lint my.scn").ends(1);
    let diff = bench.run("lint my.scn --diff").ends(1).stdout;
    assert_eq!(bench.run("lint my.scn --diff --fix").ends(1).stdout, diff);
    let run = bench.run("lint my.scn --fix").ends(0).says("my.scn: 2 mends\n");
    run.says("  my.scn:6: write `:`\n  my.scn:9: write `0.8`\n");
    assert_eq!(std::fs::read_to_string(bench.path("my.scn")).unwrap(), BALL);
    // What can be meant in several ways is left to people.
    let wrong = BALL.replace("material: white", "material: whit");
    bench.put("my.scn", &wrong);
    bench.run("lint my.scn --fix").ends(1).says("my.scn: nothing that --fix mends\n");
    assert_eq!(std::fs::read_to_string(bench.path("my.scn")).unwrap(), wrong);
}

#[test]
fn habits_of_other_languages_are_mended_as_one_would_write_it() {
    let bench = Bench::new();
    let wrong = BALL
        .replace("scn 1 in m\n", "scn 1 in m;\n")
        .replace("samples: 4", "samples  =  4")
        .replace("film: {", "film={")
        .replace("direction: (1,", "direction=(1,");
    bench.put("my.scn", format!("{wrong}let x: 3 // lint: allow(unused-let) because \"so\"\n"));
    bench.run("lint my.scn --fix").ends(0);
    let after = std::fs::read_to_string(bench.path("my.scn")).unwrap();
    let last = "let x = 3 // lint: allow(unused-let) because \"so\"\n";
    assert_eq!(after, format!("{BALL}{last}"));
    // One count, and what came of it.
    let several = BALL.replace("\n", ";\n");
    bench.put("my.scn", several);
    let told = bench.run("lint my.scn").ends(1).stdout;
    assert!(told.contains("\n1 of these can be mended by --fix\n"), "{told}");
}

#[test]
fn what_is_not_told_is_not_mended() {
    let bench = Bench::new();
    bench.put("my.scn", doubtful());
    bench.run("lint my.scn --fix --ignore allow-unused").ends(0);
    assert_eq!(std::fs::read_to_string(bench.path("my.scn")).unwrap(), doubtful());
}

#[test]
fn rendering_tells_of_warnings_in_a_line_each() {
    let bench = Bench::new();
    bench.put("my.scn", doubtful());
    let run = bench.run("render my.scn --only left --samples 1").well();
    let line = "my.scn:16:10: warning[lint/unused-material]: nothing has the material `spare`\n";
    assert!(run.stderr.contains(line), "{}", run.stderr);
    assert!(run.stderr.contains("`scn lint my.scn` tells more\n"), "{}", run.stderr);
    // Of the renders that are not made nothing is known.
    assert!(!run.stderr.contains("allow-unused"), "{}", run.stderr);
    let quiet = bench.run("render my.scn --only left --samples 1 --quiet").well();
    assert_eq!(quiet.stderr, "");
}

#[test]
fn more_is_told_of_the_scene_as_it_was_changed() {
    let bench = Bench::new();
    let set = ["--set", "material white.albedo=1.5"];
    let changed = |command: &str| Run::new(bench.command(command).args(set).output().unwrap());
    let run = changed("render ball.scn --only left --samples 1").well();
    assert!(run.stderr.contains("warning[lint/albedo-above-one]"), "{}", run.stderr);
    let more = "\n`scn lint ball.scn --set 'material white.albedo=1.5'` tells more\n";
    assert!(run.stderr.contains(more), "{}", run.stderr);
    let told = changed("lint ball.scn").well().stdout;
    assert!(told.contains("warning[lint/albedo-above-one]"), "{told}");
}

#[test]
fn every_rule_is_listed() {
    let bench = Bench::new();
    let list = bench.run("lint --list").well().stdout;
    for code in scn::diag::CODES.iter().filter(|code| code.name.starts_with("lint/")) {
        let row = list.lines().find(|line| line.trim_start().starts_with(code.name)).unwrap();
        assert!(row.contains(code.title()) && row.chars().count() <= 100, "{row}");
    }
    assert_eq!(bench.run("list lints").well().stdout, list);
}

#[test]
fn limits_of_the_command_line_leave_nothing_to_say_of_the_scenes() {
    let bench = Bench::new();
    let said =
        "stop: { samples: 16, error: 1 % } // lint: allow(unreachable-error) because \"so\"\n";
    for (sampler, stop, rule) in [
        ("stratified { grid: 3 }", "stop: { samples: 16 }\n", "unfinished-round"),
        ("independent", "stop: { samples: 16, error: 1 % }\n", "unreachable-error"),
        ("independent", said, ""),
    ] {
        let scene = BALL.replace("stop: { samples: 4 }\n", stop);
        bench.put("my.scn", scene.replace("stratified {}", sampler));
        let told = bench.run("render my.scn --only right").ends(0).stderr;
        assert_eq!(told.contains("warning["), !rule.is_empty(), "{told}");
        assert!(told.contains(rule), "{told}");
        let told = bench.run("render my.scn --only right --samples 9").ends(0).stderr;
        assert!(!told.contains("warning["), "{told}");
    }
}

/// Doubtful in five ways that show only in renders, or in several of them together.
fn doubtful_together() -> String {
    let mut text = BALL.replace("direct\n", "direct\nlayer far: paths { only: \"L .* D D E\" }\n");
    text.push_str(
        "light dark: point { position: (0, 3, 0), intensity: 0 W/sr }\n\
         light low: point { position: (0, -3, 0), intensity: 1 W/sr }\n\
         render third: left { film.exposure: 1 ev }\n\
         render fourth: right { caption: \"Light from the left.\" }\n",
    );
    text
}

const TOGETHER: [&str; 5] =
    ["dark-light", "empty-layer", "light-behind-plane", "same-caption", "same-picture"];

#[test]
fn a_scene_that_is_changed_is_doubted_as_changed() {
    let bench = Bench::new();
    bench.put("my.scn", doubtful_together());
    let rules = |arguments: &str| -> Vec<&str> {
        let run = bench.run(&format!("{arguments} my.scn")).ends(0);
        let told = run.stdout + &run.stderr;
        TOGETHER.into_iter().filter(|rule| told.contains(&format!("lint/{rule}]"))).collect()
    };
    assert_eq!(rules("lint"), TOGETHER);
    assert_eq!(rules("lint --set sampler=sobol"), TOGETHER);
    assert_eq!(rules("render --samples 1 -o out --set sampler=sobol"), TOGETHER);
    // Of a part of the renders only what holds of them alone.
    let one = rules("render --samples 1 -o out --only left");
    assert_eq!(one, ["empty-layer", "light-behind-plane"]);
    let two = rules("render --samples 1 -o out --only right --only fourth");
    assert_eq!(two, ["empty-layer", "light-behind-plane", "same-picture"]);
}

#[test]
fn what_comes_by_stdin_is_looked_at() {
    let bench = Bench::new();
    let told = |arguments: &str, text: &str| {
        let mut child = bench.command(arguments);
        child.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = child.spawn().unwrap();
        // What is not read to its end is not missed.
        let _ = child.stdin.take().unwrap().write_all(text.as_bytes());
        Run::new(child.wait_with_output().unwrap())
    };
    assert_eq!(told("lint -", BALL).well().stdout, "");
    let wrong = BALL.replace("samples: 4", "samples= 4");
    let run = told("lint - --format short", &wrong).ends(1);
    assert!(run.stdout.starts_with("stdin:6:"), "{}", run.stdout);
    assert!(told("lint - --diff", &wrong).ends(1).stdout.contains("+stop: { samples: 4 }"));
    told("lint - --fix", &wrong).ends(2).says("stdin is read, not written");
    told("lint - -", &wrong).ends(2).says("can be read once only");
}
