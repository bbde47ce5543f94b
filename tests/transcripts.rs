//! What the pages say that a command prints is what it prints: blocks of docs/ that begin with
//! `$ scn …`. Times, speeds and bytes are those of another machine, figures of noise may be off by
//! a quarter; a line `…` stands for any number of lines.

use std::path::PathBuf;
use std::process::Command;

mod shots;

/// By how much a number may differ, as a factor.
const NEAR: f64 = 1.25;
/// The same for a standard error, which depends on how long was measured.
const NEAR_ERROR: f64 = 4.0;
/// Words before which a number is one of bytes.
const BYTES: [&str; 4] = ["bytes", "kB", "MB", "GB"];

/// A page, the command it shows, and what stands below.
struct Transcript {
    page: PathBuf,
    command: String,
    shown: String,
}

fn transcripts() -> Vec<Transcript> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(shots::path("docs")).unwrap() {
        let page = entry.unwrap().path();
        if page.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let text = std::fs::read_to_string(&page).unwrap();
        for block in text.split("```text\n$ scn ").skip(1) {
            let block = block.split("```").next().unwrap();
            let (command, shown) = block.split_once('\n').unwrap();
            let (command, shown) = (command.to_string(), shown.to_string());
            all.push(Transcript { page: page.clone(), command, shown });
        }
    }
    all
}

/// What the command prints, run where its scene is at home; its drawings go away.
fn printed(command: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = command.split_whitespace().find(|word| word.ends_with(".scn")).expect("a scene");
    let homes = [".", "scenes/tour", "scenes"];
    let home = homes.iter().find(|home| shots::path(home).join(file).exists());
    let mut run = Command::new(env!("CARGO_BIN_EXE_scn"));
    run.current_dir(shots::path(home.unwrap_or_else(|| panic!("there is no {file}"))));
    run.args(command.split_whitespace());
    if command.starts_with("paths ") {
        run.arg("-o").arg(folder.path().join("it.png"));
    }
    let output = run.output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "scn {command}\n{error}");
    String::from_utf8(output.stdout).unwrap()
}

/// The words of a text without what is another machine's: times, speeds, bytes.
fn words(text: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut in_time = false;
    for word in text.split_whitespace() {
        let bare = word.trim_end_matches([',', ';', ':', ')']);
        if in_time && (bare.parse::<f64>().is_ok() || ["s", "ms", "min", "h"].contains(&bare)) {
            in_time = bare == word;
            continue;
        }
        in_time = word == "about";
        if BYTES.contains(&bare) || bare == "rays" {
            while all.last().is_some_and(|last| number(last).is_some() || illion(last)) {
                all.pop();
            }
        }
        all.push(if BYTES.contains(&bare) { "bytes".to_string() } else { word.to_string() });
    }
    all
}

fn illion(word: &str) -> bool {
    ["thousand", "million", "billion"].contains(&word)
}

fn number(word: &str) -> Option<f64> {
    word.trim_end_matches([',', ';', ':', ')', '%']).replace(',', "").parse().ok()
}

/// The first place where the two differ by more than they may.
fn difference(shown: &[String], printed: &[String]) -> Option<String> {
    for (i, (shown, found)) in shown.iter().zip(printed).enumerate() {
        let near = match (number(shown), number(found)) {
            (Some(a), Some(b)) => {
                let most = if i > 0 && printed[i - 1] == "±" { NEAR_ERROR } else { NEAR };
                a == b || (a > 0.0 && b > 0.0 && (a / b).max(b / a) < most)
            }
            _ => shown == found,
        };
        if !near {
            return Some(format!("shows `{shown}`, and `{found}` is printed"));
        }
    }
    None
}

/// What is wrong with a transcript. Each part between lines `…` stands somewhere below the last.
fn wrong_with(shown: &str, printed: &str) -> Option<String> {
    let parts: Vec<Vec<String>> = shown.split("…\n").map(words).collect();
    let mut rest = &words(printed)[..];
    for (i, part) in parts.iter().enumerate() {
        let starts = 0..rest.len().saturating_sub(part.len()) + 1;
        let fits = |start: &usize| difference(part, &rest[*start..]).is_none();
        let found = match i {
            0 => Some(0).filter(fits),
            _ => starts.clone().find(fits),
        };
        match found {
            Some(start) if rest.len() >= start + part.len() => rest = &rest[start + part.len()..],
            _ => return Some(difference(part, rest).unwrap_or_else(|| "shows too much".into())),
        }
    }
    let whole = parts.last().is_some_and(Vec::is_empty) || rest.is_empty();
    (!whole).then(|| format!("lacks `{}`", rest.join(" ")))
}

#[test]
fn what_the_pages_show_is_printed() {
    let all = transcripts();
    assert!(all.len() >= 4, "{}", all.len());
    for Transcript { page, command, shown } in all {
        let printed = printed(&command);
        if let Some(wrong) = wrong_with(&shown, &printed) {
            panic!("{}: {wrong}; `scn {command}` prints:\n{printed}", page.display());
        }
    }
}

#[test]
fn differences_are_found_and_those_of_machines_are_not() {
    let printed = "a\n\nb  5.4 kB, film 62.9 MB\n  4.2 million rays a second; error 2.45 %\n  \
                   about 1 min 2 s, 9 ± 0.1 %\n";
    let same = |shown: &str| wrong_with(shown, printed);
    assert_eq!(same(printed), None);
    assert_eq!(same(&printed.replace("5.4 kB", "1 MB")), None);
    assert_eq!(same(&printed.replace("4.2 million", "516 thousand")), None);
    assert_eq!(same(&printed.replace("1 min 2 s", "9 ms")), None);
    assert_eq!(same(&printed.replace("0.1", "0.2")), None);
    assert_eq!(same(&printed.replace("2.45", "2.2")), None);
    assert_eq!(same("a\n…\n  error 2.45 %\n…\n"), None);
    assert!(same(&printed.replace("2.45", "3.45")).is_some());
    assert!(same(&printed.replace("film", "Film")).is_some());
    assert!(same("a\n…\n  eror 2.45 %\n…\n").is_some());
    assert!(same("b\n…\n").is_some());
    assert!(same("a\n").is_some());
    assert!(same(&format!("{printed}more\n")).is_some());
}
