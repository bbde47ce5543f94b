//! Plans as people read them, in 80 columns.

use super::forecast::{Limit, MOST_SAMPLES, Reached};
use super::{Planned, RULE};
use crate::cli::limits::percent;
use crate::cli::words::{duration, rate, size};
use crate::diag::words::counted;
use crate::plan::Need;
use crate::run::LEAST_FOR_ERROR;

/// Columns of a line.
const WIDTH: usize = 80;
/// Where the text of a line begins.
const INDENT: usize = 12;

/// Objects whose memory is told one by one.
const MOST_OBJECTS: usize = 6;

/// All about one render.
pub fn report(planned: &Planned) -> String {
    let mut text = format!("\n{}\n", planned.render);
    let mut put = |about: &str, lines: Vec<String>| {
        for (nth, line) in lines.iter().enumerate() {
            let about = if nth == 0 { about } else { "" };
            text.push_str(&wrapped(&format!("  {about:<10}"), line));
        }
    };
    let features = |built: bool| {
        let wanted = planned.features.iter().filter(move |feature| feature.built == built);
        wanted
            .map(|feature| {
                let forced = if feature.built && feature.need != Need::Required {
                    "not required, but forced: "
                } else {
                    ""
                };
                format!("{}: {forced}{}", feature.feature.name(), feature.why)
            })
            .collect()
    };
    put("requires", features(true));
    put("left out", features(false));
    put("memory", memory(planned));
    put("pilot", vec![pilot(planned)]);
    put("limits", limits(planned));
    put("error", targets(planned));
    put("bias", planned.biases.iter().map(|bias| bias.line()).collect());
    text
}

fn memory(planned: &Planned) -> Vec<String> {
    let memory = &planned.memory;
    let textures = match memory.textures {
        0 => String::new(),
        bytes => format!("textures {}, ", size(bytes)),
    };
    let copied = match memory.instances {
        0 => String::new(),
        _ => format!(" (without instances about {})", size(memory.copied)),
    };
    let mut all = vec![format!(
        "geometry {}{copied}, {textures}film {}; the process {} at most",
        size(memory.geometry),
        size(memory.film),
        memory.peak.map_or("an unknown amount".to_string(), size)
    )];
    let mut objects: Vec<_> = memory.objects.iter().collect();
    if objects.len() > 1 {
        objects.sort_by_key(|object| std::cmp::Reverse(object.bytes));
        let told = |object: &&super::OfObject| format!("{} {}", object.name, size(object.bytes));
        let mut line =
            objects.iter().take(MOST_OBJECTS).map(told).collect::<Vec<String>>().join(", ");
        if objects.len() > MOST_OBJECTS {
            line.push_str(&format!(" and {} more", objects.len() - MOST_OBJECTS));
        }
        all.push(line);
    }
    all
}

fn pilot(planned: &Planned) -> String {
    let pilot = &planned.pilot;
    let rays = pilot.samples_per_second * (1.0 + pilot.shadow_rays_per_sample);
    let mut text = rate(rays as u64, 1.0);
    match pilot.error {
        Some(error) => {
            let bound = if pilot.bound && error > 0.0 { "about " } else { "" };
            let samples = counted(pilot.samples, "sample");
            text.push_str(&format!("; error {bound}{} after {samples} a pixel", percent(error)));
        }
        None => text.push_str("; nothing is known of the error"),
    }
    text
}

/// A time that is not to be taken to the second.
fn about(seconds: f64) -> String {
    let told = duration(seconds);
    if told.starts_with("under") { told } else { format!("about {told}") }
}

/// What is reached, in words.
fn told(reached: &Reached) -> String {
    let seconds = about(reached.seconds);
    match reached.error {
        Some(error) => format!("{seconds}, error {}", percent(error)),
        None => seconds,
    }
}

/// Why it is not told what a limit leads to.
fn none(planned: &Planned) -> String {
    match planned.pilot.error {
        None => "not to be told".to_string(),
        Some(_) => format!("out of reach: over {} a pixel", counted(MOST_SAMPLES, "sample")),
    }
}

fn limits(planned: &Planned) -> Vec<String> {
    let forecast = &planned.forecast;
    let line = |limit: &Limit| {
        let what = match limit.limit {
            "samples" => format!("{} a pixel", counted(limit.value as u64, "sample")),
            "time" => duration(limit.value),
            _ => format!("an error of {}", percent(limit.value)),
        };
        let then = match (&limit.reached, limit.limit) {
            (None, _) => none(planned),
            (Some(reached), "samples") => told(reached),
            (Some(reached), "time") => {
                let error = reached.error.map(|error| format!(", error {}", percent(error)));
                let samples = counted(reached.samples, "sample");
                format!("about {samples} a pixel{}", error.unwrap_or_default())
            }
            (Some(reached), _) => {
                let samples = counted(reached.samples, "sample");
                format!("about {samples} a pixel, {}", duration(reached.seconds))
            }
        };
        format!("{what}: {then}")
    };
    let mut all: Vec<String> = forecast.limits.iter().map(line).collect();
    if let (Some(first), true) = (forecast.first, forecast.limits.len() > 1) {
        all.push(format!("ends by {first}"));
    }
    all
}

fn targets(planned: &Planned) -> Vec<String> {
    let line = |limit: &Limit| {
        let Some(reached) = limit.reached else {
            let known = planned.pilot.error.is_some();
            return known.then(|| format!("{} is {}", percent(limit.value), none(planned)));
        };
        let samples = counted(reached.samples, "sample");
        let seconds = about(reached.seconds);
        let mut text = format!("{} takes {samples} a pixel, {seconds}", percent(limit.value));
        if reached.samples < LEAST_FOR_ERROR {
            text.push_str(&format!(" (by --error: {LEAST_FOR_ERROR})"));
        }
        Some(text)
    };
    let mut all: Vec<String> = planned.forecast.targets.iter().filter_map(line).collect();
    if !all.is_empty() {
        all.push(RULE.to_string());
        if planned.cautious {
            all.push("cautious: samples spread evenly may need fewer".to_string());
        }
    }
    all
}

/// A line that begins so, broken between words; what follows is indented.
fn wrapped(begin: &str, text: &str) -> String {
    let mut all = String::new();
    let mut line = begin.to_string();
    let mut empty = true;
    // A number stays with its sign and its unit.
    let glued = text.replace(" %", "\u{a0}%").replace("± ", "±\u{a0}");
    for word in glued.split(' ') {
        if !empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
            all.push_str(&line);
            all.push('\n');
            line = " ".repeat(INDENT);
            empty = true;
        }
        if !empty {
            line.push(' ');
        }
        line.push_str(&word.replace('\u{a0}', " "));
        empty = false;
    }
    all + &line + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let text = wrapped("  requires  ", &"word ".repeat(30));
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        assert!(text.lines().skip(1).all(|line| line.starts_with("            word")), "{text}");
        assert_eq!(text.matches("word").count(), 30);
        let cost = wrapped("  bias      ", &format!("{} 1.3 ± 0.2 % more", "x".repeat(58)));
        assert!(cost.contains("\n            ± 0.2 % more\n"), "{cost}");
        let long = "x".repeat(100);
        assert_eq!(wrapped("  memory    ", &long), format!("  memory    {long}\n"));
    }
}
