//! Ctrl-C in the middle of a render.
#![cfg(unix)]

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Command, Stdio};

use crate::bench::{BALL, Bench, word};

fn send(signal: &str, child: &Child) {
    // Before `wait` the process is at least a name, so the signal always finds it.
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Renders something that takes far longer than anybody waits, and stops it once the first
/// samples are there. Returns the events.
fn stopped(bench: &Bench, signals: &[&str]) -> Vec<serde_json::Value> {
    bench.put("long.scn", BALL.replace("(32, 24)", "(320, 240)"));
    let mut child = bench
        .command("render long.scn --log json --samples 4000000000")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut events: Vec<serde_json::Value> = Vec::new();
    for line in lines.by_ref() {
        events.push(serde_json::from_str(&line.unwrap()).unwrap());
        if events.last().unwrap()["event"] == "progress" {
            signals.iter().for_each(|signal| send(signal, &child));
            break;
        }
    }
    events.extend(lines.map(|line| serde_json::from_str(&line.unwrap()).unwrap()));
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{said}");
    assert!(said.contains("keeping what is done"), "{said}");
    events
}

#[test]
fn what_is_done_is_written_and_the_rest_is_left() {
    for signal in ["-INT", "-TERM"] {
        let bench = Bench::new();
        let events = stopped(&bench, &[signal]);
        let named = |name: &str| events.iter().filter(|e| e["event"] == name).collect::<Vec<_>>();
        let interrupted = named("interrupted");
        assert_eq!(interrupted.len(), 1, "{events:?}");
        assert_eq!(interrupted[0]["render"], "left");
        assert!(named("done").is_empty());
        assert_eq!(named("written").len(), 2);

        assert_eq!(bench.files()[2..], ["out/long/left.exr", "out/long/left.png"]);
        let (layers, _) = scn::files::exr::read(&bench.path("out/long/left.exr")).unwrap();
        assert_eq!((layers.main.width, layers.main.height), (320, 240));
        assert!(layers.main.pixels.iter().any(|pixel| pixel.to_array() != [0.0; 3]));
        let told = |key| word(bench.path("out/long/left.png"), key).unwrap();
        assert_eq!(told("scn:samples"), interrupted[0]["samples"].to_string());
        assert!(told("scn:interrupted").contains(" of "));
    }
}

/// From inside of a white ball no path comes out: each sample takes about a second.
const ENDLESS: &str = "\
scn 1 in m
film: { size: (4, 4) }
camera: perspective { eye: (0, 0, 0), look_at: (0, 0, -1), fov_y: 40 deg }
integrator: path { roulette: off, depth: 1000000, next_event: off }
stop: { samples: 1 }
object ball: sphere { center: (0, 0, 0), radius: 1 m, material: diffuse { albedo: 1 } }
light sky: constant { radiance: 1 W/m^2/sr }
";

#[test]
fn a_long_sample_is_given_up() {
    let bench = Bench::new();
    bench.put("endless.scn", ENDLESS);
    let mut child = bench
        .command("render endless.scn --log json")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let began = lines.by_ref().any(|line| line.unwrap().contains("\"event\":\"rendering\""));
    assert!(began);
    send("-INT", &child);
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{said}");
    assert!(said.contains("once more ends at once"), "{said}");
    assert_eq!(bench.files(), ["ball.scn", "endless.scn"]);

    // The time ends it as well.
    bench.run("render endless.scn -q --time 10ms").ends(130);
}

#[test]
fn a_second_one_ends_at_once_and_leaves_nothing_half_written() {
    let bench = Bench::new();
    stopped(&bench, &["-INT", "-INT"]);
    // Whether the pictures were written before the second one came is a matter of time; if they
    // were, they are whole.
    for name in bench.files() {
        match name.rsplit('.').next() {
            Some("exr") => drop(scn::files::exr::read(&bench.path(name)).unwrap()),
            Some("png") => drop(word(bench.path(name), "scn:interrupted").unwrap()),
            ending => assert_eq!(ending, Some("scn"), "{name}"),
        }
    }
}
