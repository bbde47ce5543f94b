//! The log: for people, for machines, and silent.

use std::collections::BTreeSet;

use crate::bench::{Bench, Run};

/// Event and fields of each row of the table in docs/log.md.
fn documented() -> Vec<(String, BTreeSet<String>)> {
    let page = include_str!("../../docs/log.md");
    let words = |cell: &str| -> Vec<String> {
        cell.split('`').skip(1).step_by(2).map(str::to_string).collect()
    };
    page.lines()
        .filter(|line| line.starts_with("| `"))
        .map(|line| {
            let cells: Vec<&str> = line.split('|').collect();
            (words(cells[1])[0].clone(), words(cells[3]).into_iter().collect())
        })
        .collect()
}

#[test]
fn each_line_for_machines_is_a_documented_object() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn --log json --samples 2").well();
    let events = run.events();
    let pages = documented();
    for event in &events {
        let name = event["event"].as_str().unwrap();
        let (_, fields) = pages
            .iter()
            .find(|(documented, _)| documented == name)
            .unwrap_or_else(|| panic!("docs/log.md does not know {name}"));
        for field in event.as_object().unwrap().keys().filter(|field| *field != "event") {
            assert!(fields.contains(field), "docs/log.md does not know {name}.{field}");
        }
    }
    let names: Vec<_> = events
        .iter()
        .map(|event| event["event"].as_str().unwrap())
        .filter(|name| *name != "progress")
        .collect();
    let one = ["built", "rendering", "rendered", "bias", "bias", "written", "written"];
    assert_eq!(names, [&["loaded"][..], &one, &one, &["done"]].concat());
    let rendered = events.iter().find(|event| event["event"] == "rendered").unwrap();
    assert_eq!(rendered["render"], "left");
    assert_eq!(rendered["samples"], 2);
    assert_eq!(rendered["rays"], 32 * 24 * 2);
    assert!(events.iter().any(|event| event["event"] == "progress"));
}

#[test]
fn machines_are_told_of_faults_too() {
    let bench = Bench::new();
    bench.put("bad.scn", "scn 1 in m\nfilm: { size: (0, 1) }\nintegrator: preview\n");
    let run = bench.run("render bad.scn --log json").ends(1);
    let events = run.events();
    assert_eq!(events.len(), 1, "{}", run.stdout);
    assert_eq!(events[0]["event"], "diagnostics");
    assert!(events[0]["errors"].as_u64().unwrap() >= 1);
    assert!(run.stderr.contains("error["));
}

#[test]
fn quiet_says_nothing_but_errors() {
    let bench = Bench::new();
    for form in ["human", "json"] {
        let run = bench.run(&format!("render ball.scn --quiet --log {form}")).well();
        assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""));
    }
    bench.run("render bell.scn --quiet").ends(2).says("does not exist");
}

#[test]
fn people_read_what_was_done() {
    let bench = Bench::new();
    let run = bench.run("render ball.scn --only left --crop 0,0,8,8").well();
    for words in [
        "ball.scn: 1 render, loaded in",
        "left\n",
        "2 shapes, 1 material, 2 lights",
        "8 × 8, 4 samples a pixel",
        "256 camera rays",
        "wrote     out/ball/left.exr",
        "1 picture in",
    ] {
        assert!(run.stdout.contains(words), "{words:?} is not in:\n{}", run.stdout);
    }
    assert!(!run.stdout.contains('\x1b'), "{:?}", run.stdout);
}

#[cfg(unix)]
#[test]
fn a_name_of_two_lines_stays_on_one() {
    let bench = Bench::new();
    let mut command = bench.command("render ball.scn --only left --samples 1 -o");
    let run = Run::new(command.arg("a\nb.exr").output().unwrap()).well();
    assert!(run.stdout.contains("wrote     a\u{240a}b.exr\n"), "{}", run.stdout);
    assert!(bench.files().contains(&"a\nb.exr".to_string()));
    // Machines are told the name as it is.
    let mut command = bench.command("render ball.scn --only left --samples 1 --log json -o");
    let run = Run::new(command.arg("a\nb.exr").output().unwrap()).well();
    let events = run.events();
    assert!(events.iter().any(|event| event["file"] == "a\nb.exr"), "{events:?}");
}
