//! When a picture is done: the limits of the scene, or those of the command line in their place.

use super::options::Render;
use super::words::duration;
use crate::diag::words::counted;
use crate::run::Rule;
use crate::scene::Stop;

/// Whether the command line gives limits.
pub fn given(options: &Render) -> bool {
    options.samples.is_some() || options.time.is_some() || options.error.is_some()
}

/// The limits of a render. If any is given on the command line, those of the scene do not count.
pub fn limits(options: &Render, stop: &Stop) -> Rule {
    of(options.samples, options.time, options.error, stop)
}

/// The same, from --samples, --time and --error.
pub fn of(samples: Option<u64>, time: Option<f64>, error: Option<f64>, stop: &Stop) -> Rule {
    if samples.is_some() || time.is_some() || error.is_some() {
        let adaptive = error.is_some() && stop.adaptive.0;
        return Rule { samples, time, error, adaptive };
    }
    Rule {
        samples: stop.most_samples(),
        time: stop.time.as_ref().map(|time| time.0),
        error: stop.error.as_ref().map(|error| error.0),
        adaptive: stop.adaptive.0,
    }
}

/// The limits in words: `16 samples a pixel or 60 s or an error of 1 %`.
pub fn told(rule: &Rule) -> String {
    let samples = rule.samples.map(|samples| format!("{} a pixel", counted(samples, "sample")));
    let time = rule.time.map(duration);
    let error = rule.error.map(|error| format!("an error of {}", percent(error)));
    let all: Vec<String> = [samples, time, error].into_iter().flatten().collect();
    all.join(" or ")
}

/// Whether it is worth telling which one was reached.
pub fn several(rule: &Rule) -> bool {
    let limits = [rule.samples.is_some(), rule.time.is_some(), rule.error.is_some()];
    limits.into_iter().filter(|limit| *limit).count() > 1
}

/// A part in percent, to three digits.
pub fn percent(part: f64) -> String {
    let percent = part * 100.0;
    match percent {
        p if !p.is_finite() => "over any bound".to_string(),
        0.0 => "0 %".to_string(),
        p if p < 1e-9 => format!("{p:.2e} %"),
        p if p >= 100.0 => format!("{p:.0} %"),
        p => {
            let digits = (2 - p.abs().log10().floor() as i32).clamp(0, 12) as usize;
            let text = format!("{p:.digits$}");
            let text = text.trim_end_matches('0').trim_end_matches('.');
            format!("{text} %")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_told_in_percent_to_three_digits() {
        for (part, words) in [
            (0.0, "0 %"),
            (0.01, "1 %"),
            (0.012345, "1.23 %"),
            (0.9999, "100 %"),
            (12.3456, "1235 %"),
            (1.23456e-5, "0.00123 %"),
            (1e-300, "1.00e-298 %"),
            (f64::INFINITY, "over any bound"),
        ] {
            assert_eq!(percent(part), words);
        }
    }

    #[test]
    fn limits_are_told_in_one_breath() {
        let rule =
            Rule { samples: Some(1024), time: Some(60.0), error: Some(0.01), adaptive: false };
        assert_eq!(told(&rule), "1,024 samples a pixel or 60 s or an error of 1 %");
    }
}
