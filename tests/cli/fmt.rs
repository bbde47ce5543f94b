//! `scn fmt`: what it rewrites, what it shows, and what it leaves alone.

use std::io::Write;
use std::process::Stdio;

use crate::bench::{BALL, Bench, Run};

const UNTIDY: &str = "scn 1 in m\nfilm:{size:(8,8)}\n";
const TIDY: &str = "scn 1 in m\nfilm: { size: (8, 8) }\n";

fn text(bench: &Bench, name: &str) -> String {
    std::fs::read_to_string(bench.path(name)).unwrap()
}

#[test]
fn only_files_that_change_are_written() {
    let bench = Bench::new();
    bench.put("a.scn", UNTIDY);
    let modified = || std::fs::metadata(bench.path("ball.scn")).unwrap().modified().unwrap();
    let before = modified();
    let run = bench.run("fmt ball.scn a.scn").well();
    assert_eq!(run.stdout, "formatted a.scn\n");
    assert_eq!((text(&bench, "a.scn"), text(&bench, "ball.scn")), (TIDY.into(), BALL.into()));
    assert_eq!(modified(), before);
    assert_eq!(bench.run("fmt ball.scn a.scn").well().stdout, "");
    assert_eq!(bench.files(), ["a.scn", "ball.scn"]);
}

#[test]
fn check_and_diff_write_nothing() {
    let bench = Bench::new();
    bench.put("a.scn", UNTIDY);
    assert_eq!(bench.run("fmt --check ball.scn a.scn").ends(1).stdout, "a.scn\n");
    assert_eq!(bench.run("fmt --check ball.scn").well().stdout, "");
    let shown = "--- a.scn\n+++ a.scn\n@@ -1,2 +1,2 @@\n scn 1 in m\n-film:{size:(8,8)}\n\
                 +film: { size: (8, 8) }\n";
    assert_eq!(bench.run("fmt --diff a.scn ball.scn").well().stdout, shown);
    assert_eq!(bench.run("fmt --diff --check a.scn").ends(1).stdout, shown);
    assert_eq!(text(&bench, "a.scn"), UNTIDY);
}

#[test]
fn a_file_with_faults_of_syntax_is_left_alone() {
    let bench = Bench::new();
    let faulty = "scn 1 in m\nfilm:{size:(8,8}\nstop: \n";
    bench.put("bad.scn", faulty);
    bench.put("a.scn", UNTIDY);
    let run = bench.run("fmt bad.scn a.scn").ends(1).says("`(` is never closed");
    run.says("2 errors in bad.scn, which stays as it is");
    assert_eq!((text(&bench, "bad.scn"), text(&bench, "a.scn")), (faulty.into(), TIDY.into()));
    bench.run("fmt nothing.scn a.scn").ends(2).says("`nothing.scn` does not exist");
    bench.run("fmt").ends(2).says("<FILE>");
}

#[test]
fn marks_and_other_line_ends_go_away() {
    let bench = Bench::new();
    bench.put("a.scn", "\u{feff}scn 1 in m\r\nfilm: { size: (8, 8) } // caf\u{e9}");
    bench.run("fmt --check a.scn").ends(1);
    bench.run("fmt a.scn").well();
    assert_eq!(text(&bench, "a.scn"), "scn 1 in m\nfilm: { size: (8, 8) } // caf\u{e9}\n");
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let bench = Bench::new();
    bench.put("a.scn", UNTIDY);
    std::fs::set_permissions(bench.path("a.scn"), PermissionsExt::from_mode(0o600)).unwrap();
    symlink("a.scn", bench.path("link.scn")).unwrap();
    bench.run("fmt link.scn").well();
    assert_eq!(text(&bench, "a.scn"), TIDY);
    assert!(std::fs::symlink_metadata(bench.path("link.scn")).unwrap().is_symlink());
    let mode = std::fs::metadata(bench.path("a.scn")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
}

fn piped(bench: &Bench, arguments: &str, text: &str) -> Run {
    let mut command = bench.command(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    Run::new(child.wait_with_output().unwrap())
}

#[test]
fn stdin_goes_to_stdout() {
    let bench = Bench::new();
    assert_eq!(piped(&bench, "fmt -", UNTIDY).well().stdout, TIDY);
    assert_eq!(piped(&bench, "fmt --check -", UNTIDY).ends(1).stdout, "stdin\n");
    assert_eq!(piped(&bench, "fmt --check -", TIDY).well().stdout, "");
    let run = piped(&bench, "fmt -", "scn 1 in m\nfilm: (\n").ends(1).says("stdin:2:7");
    assert_eq!(run.stdout, "");
    piped(&bench, "fmt - ball.scn", "").ends(2).says("takes no files beside it");
}

#[test]
fn the_scenes_of_the_project_are_in_the_style() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let scenes = |folder: &str| {
        let entries = std::fs::read_dir(root.join(folder)).unwrap();
        entries
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension() == Some("scn".as_ref()))
    };
    let paths: Vec<_> = scenes("scenes").chain(scenes("scenes/lib")).collect();
    assert!(paths.len() >= 3);
    let bench = Bench::new();
    let run = Run::new(bench.command("fmt --diff --check").args(&paths).output().unwrap());
    assert_eq!(run.stdout, "", "run `scn fmt` on them");
    run.well();
}
