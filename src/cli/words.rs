//! Numbers as people read them, and how many names.

use std::path::{MAIN_SEPARATOR, Path};

/// Names that a message lists at most.
pub const NAMES: usize = 12;

/// Seconds with a unit that suits them: "12 ms", "0.17 s", "12 s", "3 min 20 s", "2 h 5 min".
pub fn duration(seconds: f64) -> String {
    if seconds < 0.000_5 {
        return "under 1 ms".to_string();
    }
    if seconds < 0.099_5 {
        return format!("{:.0} ms", seconds * 1000.0);
    }
    if seconds < 9.995 {
        return format!("{seconds:.2} s").replace(".00 s", " s");
    }
    let whole = seconds.round() as u64;
    match whole {
        0..=99 => format!("{whole} s"),
        100..=5999 => format!("{} min {} s", whole / 60, whole % 60),
        _ if seconds >= 3.6e9 => format!("{:.2e} h", seconds / 3600.0),
        _ => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
    }
}

/// Bytes with a unit that suits them: "7.3 MB".
pub fn size(bytes: u64) -> String {
    scaled(bytes as f64, &["bytes", "kB", "MB", "GB", "TB"])
}

/// Rays a second: "2.6 million rays a second".
pub fn rate(rays: u64, seconds: f64) -> String {
    let rate = rays as f64 / seconds.max(1e-9);
    format!("{} rays a second", scaled(rate, &["", "thousand", "million", "billion"]))
        .replace("  ", " ")
}

/// The name of a file as it is typed at a shell: in quotes where it needs them.
pub fn typed(path: &Path) -> String {
    let name = path.display().to_string();
    // What begins like an option would be taken for one.
    typed_word(&if name.starts_with('-') { format!("./{name}") } else { name })
}

/// The same of any argument.
pub fn typed_word(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+,:@%=".contains(c) || c == MAIN_SEPARATOR;
    match !word.is_empty() && word.chars().all(plain) {
        true => word.to_string(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

fn scaled(mut x: f64, units: &[&str]) -> String {
    let mut unit = 0;
    while x >= 999.5 && unit + 1 < units.len() {
        x /= 1000.0;
        unit += 1;
    }
    if unit == 0 || x >= 99.95 {
        format!("{x:.0} {}", units[unit])
    } else {
        format!("{x:.1} {}", units[unit])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_quoted_where_a_shell_needs_it() {
        for (name, shown) in [
            ("figures/scène-1.scn", "figures/scène-1.scn"),
            ("my scene.scn", "'my scene.scn'"),
            ("it's.scn", "'it'\\''s.scn'"),
            ("$x.scn", "'$x.scn'"),
            ("-x.scn", "./-x.scn"),
        ] {
            assert_eq!(typed(Path::new(name)), shown);
        }
        assert_eq!(typed_word("film.exposure=1 ev"), "'film.exposure=1 ev'");
        assert_eq!(typed_word("integrator.reuse=4"), "integrator.reuse=4");
        assert_eq!(typed_word(""), "''");
    }

    #[test]
    fn numbers_read_as_people_write_them() {
        assert_eq!(duration(0.000_1), "under 1 ms");
        assert_eq!(duration(0.099), "99 ms");
        assert_eq!(duration(0.168), "0.17 s");
        assert_eq!(duration(9.999), "10 s");
        assert_eq!(duration(3.0), "3 s");
        assert_eq!(duration(200.0), "3 min 20 s");
        assert_eq!(duration(7500.0), "2 h 5 min");
        assert_eq!(size(999), "999 bytes");
        assert_eq!(size(7_340_000), "7.3 MB");
        assert_eq!(size(999_999), "1.0 MB");
        assert_eq!(rate(524_288, 0.2), "2.6 million rays a second");
        assert_eq!(rate(10, 1.0), "10 rays a second");
    }
}
