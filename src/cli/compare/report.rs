//! The figures for a person: one column a picture.

use super::input::shown;
use super::remarks::harmless;
use super::{Comparison, remarks, undefined};
use crate::diag::print::wrapped;
use crate::measure::METRICS;

/// Digits that are shown of a figure.
const DIGITS: i32 = 4;

/// The report, ready to print; its notes in lines of `width` characters.
pub fn human(comparison: &Comparison, width: usize) -> String {
    let picture = &comparison.reference.picture;
    let layer =
        comparison.layer.map_or(String::new(), |layer| format!(", the layer {}", harmless(layer)));
    let mut text = format!(
        "Against {}, {} × {} pixels{layer}\n\n",
        comparison.reference.name, picture.width, picture.height
    );
    text.push_str(&table(comparison));
    text.push('\n');
    for line in legend(comparison) {
        text.push_str(&line);
        text.push('\n');
    }
    text.push_str(&files_table(comparison));
    for note in remarks::notes(comparison) {
        text.push('\n');
        for line in wrapped(&format!("note: {note}"), width) {
            text.push_str(&line);
            text.push('\n');
        }
    }
    if let Some(difference) = &comparison.difference {
        let path = shown(difference.path);
        text.push_str(&format!(
            "\n{} as a picture, black 0 to pale yellow 1: {path}\n",
            difference.shows
        ));
    }
    text
}

/// Every metric of every picture.
fn table(comparison: &Comparison) -> String {
    let mut rows = vec![vec![String::new(), String::new()]];
    rows[0].extend(comparison.tests.iter().map(|judged| judged.input.name.clone()));
    for metric in METRICS {
        let values = comparison
            .tests
            .iter()
            .map(|judged| (metric.value)(&judged.metrics).map_or_else(|| "–".to_string(), figure));
        let words = [metric.name.to_string(), metric.about.to_string()];
        rows.push(words.into_iter().chain(values).collect());
    }
    aligned(&rows, 2)
}

/// What has to be known to read the table.
fn legend(comparison: &Comparison) -> Vec<String> {
    let mut lines = vec![format!("ε of relmse is {}.", brief(comparison.settings.epsilon))];
    let first = &comparison.tests[0].metrics;
    let trimmed = first.errors.trimmed_pixels;
    lines.push(match trimmed {
        0 => "relmse_trimmed leaves out no pixel: there are fewer than a thousand.".to_string(),
        1 => "relmse_trimmed leaves out 1 pixel.".to_string(),
        n => format!("relmse_trimmed leaves out {n} pixels."),
    });
    let density = comparison.settings.pixels_per_degree;
    lines.push(format!("FLIP is for a display seen at {density:.1} pixels a degree."));
    if let Some(exposures) = first.exposures() {
        let [start, stop] = [exposures.start, exposures.stop].map(|ev| format!("{ev:+.1} stops"));
        lines.push(match start == stop {
            true => format!("flip_hdr looks at an exposure of {start}."),
            false => format!(
                "flip_hdr looks at {} exposures, from {} to {stop}.",
                exposures.count,
                start.trim_end_matches(" stops")
            ),
        });
    }
    for metric in METRICS {
        if (metric.value)(first).is_none() {
            lines.push(format!("{} is undefined: {}.", metric.name, undefined(metric, comparison)));
        }
    }
    lines
}

/// What the files tell differently of themselves, or nothing.
fn files_table(comparison: &Comparison) -> String {
    let tests = comparison.tests.iter().map(|judged| judged.input);
    let inputs: Vec<_> = tests.chain([comparison.reference]).collect();
    let differences = remarks::differences(&inputs);
    if differences.is_empty() {
        return String::new();
    }
    let mut rows = vec![vec![String::new()]];
    rows[0].extend(inputs.iter().map(|input| input.name.clone()));
    for difference in &differences {
        let key = difference.key.trim_start_matches("scn:");
        let said = |value: &Option<&str>| value.map_or_else(|| "–".to_string(), remarks::short);
        let mut row = vec![remarks::short(key)];
        row.extend(difference.values.iter().map(said));
        rows.push(row);
    }
    format!("\nThe files tell different things of themselves:\n\n{}", aligned(&rows, 1))
}

/// Rows in columns, the first `words` of them to the left and the others to the right.
fn aligned(rows: &[Vec<String>], words: usize) -> String {
    let width =
        |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            let width = *width;
            if column < words {
                line.push_str(&format!("  {cell:<width$}"));
            } else {
                line.push_str(&format!("  {cell:>width$}"));
            }
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// A figure of four digits: "0.01234", "1.234e-7", "0".
pub fn figure(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".to_string()
    } else if (1e-3..1e6).contains(&size) {
        let decimals = (DIGITS - 1 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.*e}", DIGITS as usize - 1)
    }
}

/// A setting of four digits at most: "0.01", "1.235e-7".
pub fn brief(value: f64) -> String {
    let figure = figure(value);
    let (digits, power) = figure.split_once('e').unwrap_or((&figure, ""));
    let digits = match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.'),
        false => digits,
    };
    if power.is_empty() { digits.to_string() } else { format!("{digits}e{power}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_four_digits() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.000"),
            (0.0123456, "0.01235"),
            (-0.5, "-0.5000"),
            (1234.56, "1235"),
            (99999.4, "99999"),
            (1e-3, "0.001000"),
            (1.23456e-7, "1.235e-7"),
            (2.5e9, "2.500e9"),
        ] {
            assert_eq!(figure(value), text);
        }
    }

    #[test]
    fn settings_have_four_digits_at_most() {
        for (value, text) in
            [(0.01, "0.01"), (2.000_567_9, "2.001"), (0.0, "0"), (5e-7, "5e-7"), (300.0, "300")]
        {
            assert_eq!(brief(value), text);
        }
    }

    #[test]
    fn columns_line_up() {
        let row = |cells: [&str; 3]| cells.map(String::from).to_vec();
        let text = aligned(&[row(["", "", "a.exr"]), row(["mse", "é", "1"])], 2);
        assert_eq!(text, "          a.exr\n  mse  é      1\n");
    }
}
