//! Numbers as people read them.

/// "1 render", "7 renders", "99,785 triangles".
pub fn counted(n: u64, word: &str) -> String {
    if n == 1 { format!("1 {word}") } else { format!("{} {word}s", grouped(n)) }
}

/// Digits in groups of three: "99,785".
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

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
        assert_eq!(counted(1, "render"), "1 render");
        assert_eq!(counted(0, "light"), "0 lights");
        assert_eq!(counted(1_099_785, "triangle"), "1,099,785 triangles");
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
