//! Numbers as people read them, and how many names.

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
