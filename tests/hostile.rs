//! Texts made to exhaust the reader, or to harm who reads its reports: each gets a clear error,
//! and few of them.

use std::path::{Path, PathBuf};

use scn::cli::Disk;
use scn::diag::{Diagnostic, Sources, print};
use scn::lang::{self, Library};

fn told(text: &str) -> (Vec<Diagnostic>, Sources) {
    let mut sources = Sources::new();
    let path = Path::new("scene.scn");
    let compiled = lang::compile(path, text, &[], &[], &Disk, &mut sources);
    (compiled.diagnostics, sources)
}

fn headlines(text: &str) -> Vec<String> {
    told(text).0.into_iter().map(|told| told.headline).collect()
}

/// The only fault of a text.
fn only(text: &str) -> (String, (usize, usize)) {
    let (told, sources) = told(text);
    assert_eq!(told.len(), 1, "{told:#?}");
    (told[0].headline.clone(), sources.line_column(told[0].place().unwrap()))
}

#[test]
fn a_file_of_faults_costs_a_thousand_reports_and_a_count() {
    let n = 6_000;
    let many = |line: &str| format!("scn 1 in m\nintegrator: preview\n{}", line.repeat(n));
    let bases: Vec<_> = (0..n).map(|i| format!("b{i}")).collect();
    for text in [
        many("foo: 1\n"),
        many("$\na: 1\n"),
        many("film: { siz: 1 }\n"),
        many("let a = 1\n"),
        many("a: 1 "),
        format!("{}film: {{ {} }}", many(""), "a $ 1\n".repeat(n)),
        format!("{}render a: {} {{}}\n", many(""), bases.join(" + ")),
        format!("{}let a = \"{}\"\n", many(""), "\\q".repeat(n)),
    ] {
        let told = headlines(&text);
        let counts: Vec<_> =
            told.iter().filter(|told| told.ends_with("of this file are not told")).collect();
        assert_eq!((told.len(), counts.len()), (1001, 1), "{}", &text[..60]);
        assert!(counts[0].starts_with(|c: char| c.is_ascii_digit()), "{counts:?}");
    }
    let told = headlines(&many("foo: 1\n"));
    assert!(told.contains(&"5,000 more faults of this file are not told".to_string()));
}

#[test]
fn where_brackets_and_quotes_are_hopeless_reading_stops() {
    for line in ["\"\n", "}\n", ")", "a {\n", "(\n"] {
        let told = headlines(&format!("scn 1 in m\n{}", line.repeat(30_000)));
        assert!(told.len() == 1 || told.len() == 1001, "{line}: {}", told.len());
        assert!(told.len() == 1 || told.last().unwrap().starts_with("this file has more faults"));
    }
}

#[test]
fn braces_that_nest_in_a_string_are_told() {
    let told = headlines(&format!("scn 1 in m\nlet a = \"{}\"\n", "{a ".repeat(20_000)));
    assert_eq!(told.len(), 1001);
    assert!(told[0].contains("a single `{` in a string"), "{}", told[0]);
}

#[test]
fn brackets_and_signs_a_million_deep_are_one_fault() {
    let n = 1_000_000;
    for text in [
        format!("let a = {}1{}", "(".repeat(n), ")".repeat(n)),
        format!("let a = {}1{}", "[".repeat(n), "]".repeat(n)),
        format!("{}{}", "a {".repeat(n), "}".repeat(n)),
        format!("let a = {}1", "-".repeat(n)),
    ] {
        let (headline, (line, _)) = only(&format!("scn 1 in m\n{text}\n"));
        assert_eq!(headline, "more than 64 brackets or signs inside each other");
        assert_eq!(line, 2);
    }
}

#[test]
fn numbers_at_the_end_of_numbers_are_told_in_few_digits() {
    let told = headlines(
        "scn 1 in m\nintegrator: preview\nfilm.exposure: 1e308 * 1e308 ev\nstop.samples: 1e308\n\
         let a = 1e309\nsampler: stratified { grid: 1e308 }\n",
    );
    assert_eq!(
        told,
        [
            "this has no finite value",
            "`stop.samples` is a count, and `1e308` is none",
            "`1e309` is too large for a number",
            "`sampler.grid` is a count, and `1e308` is none",
        ]
    );
}

#[test]
fn a_fault_at_the_end_of_a_long_line_is_told_there() {
    let many: Vec<_> =
        (0..24_000).map(|i| format!("material m{i}: diffuse {{ albedo: 0.5 }}")).collect();
    let text =
        format!("scn 1 in m integrator: preview, {}, film: {{ siz: (8, 8) }}", many.join(", "));
    assert!(text.len() > 900_000);
    let (headline, (line, column)) = only(&text);
    assert_eq!(headline, "`film` has no field `siz`");
    assert_eq!((line, column), (1, text.find("siz").unwrap() + 1));
    let (found, sources) = told(&text);
    let report = print::report(&found, &sources, "scene.scn", print::Look::PLAIN);
    assert!(report.lines().all(|line| line.chars().count() < 140), "{report}");
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_no_file_is_not_used() {
    for (name, why) in [
        ("/dev/zero", "is a device"),
        ("/dev/null", "is a device"),
        ("/tmp", "is a folder"),
        (".", "is a folder"),
        ("nothing.scn", "does not exist"),
        ("", "does not exist"),
        ("a\\u{0}b", "cannot be used"),
    ] {
        let (headline, (line, _)) = only(&format!("scn 1 in m\nuse \"{name}\"\n"));
        assert!(headline.contains(why), "{name}: {headline}");
        assert_eq!(line, 2);
    }
}

/// The same long text under every name.
struct Long;

impl Library for Long {
    fn read(&self, _: &Path) -> Result<String, String> {
        Ok(format!("scn 1\n{}", "//\n".repeat(2_500_000)))
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

#[test]
fn all_files_together_have_a_limit() {
    let uses: String = (0..6).map(|i| format!("use \"f{i}.scn\"\n")).collect();
    let mut sources = Sources::new();
    let text = format!("scn 1\nintegrator: preview\n{uses}");
    let compiled = lang::compile(Path::new("a.scn"), &text, &[], &[], &Long, &mut sources);
    let told: Vec<_> = compiled.diagnostics.iter().map(|told| told.headline.clone()).collect();
    let too_much =
        |i| format!("the files of a scene may have 32 MB together, and `f{i}.scn` is too much");
    assert_eq!(told, [too_much(4), too_much(5)]);
}

#[test]
fn control_characters_do_not_reach_a_terminal() {
    let (told, sources) = told(
        "scn 1 in m\nintegrator: preview\nmaterial \"a\\u{1b}[31m\\u{202e}\": diffuse { albedo: 2 }\n\
         render \"\\u{7}\" {}\nmaterial \x1b: 1\nobject \"\x07\x1b[2J\": sphere { radus: 1 }\nuse \"\x1b]0;\"\n",
    );
    assert!(told.len() >= 4);
    let report = print::report(&told, &sources, "a.scn", print::Look::PLAIN);
    let harmful = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
    assert!(!report.contains(harmful), "{report:?}");
}
