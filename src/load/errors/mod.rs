//! What can be wrong with the files a scene names: one function a fault, one file a family.

use crate::diag::Diagnostic;

pub(super) mod file;
pub(super) mod mesh;
pub(super) mod mtl;
pub(super) mod texture;

/// Adds to the last fault of a file told that there are more.
pub(super) fn and_more(fault: Diagnostic, file: &str, more: u64) -> Diagnostic {
    let faults = counted(more, "further fault", "further faults");
    fault.why(format!("`{file}` has {faults}, often of the same kinds."))
}

/// The name nearest to `word`, if one is near.
fn nearest<'n>(word: &str, names: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    const NEAR: f64 = 0.6;
    let likeness = |name: &str| {
        strsim::normalized_damerau_levenshtein(&word.to_lowercase(), &name.to_lowercase())
    };
    let all = names.into_iter().map(|name| (likeness(name), name));
    all.filter(|(likeness, _)| *likeness >= NEAR).max_by(|a, b| a.0.total_cmp(&b.0)).map(|it| it.1)
}

/// Names in a sentence: "`a`, `b` and `c`"; of many, the first few and how many more.
fn listed<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    const TOLD: usize = 8;
    let quoted: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    match quoted.as_slice() {
        [] => "none".into(),
        [one] => one.clone(),
        all if all.len() > TOLD + 1 => {
            format!("{} and {} more", all[..TOLD].join(", "), all.len() - TOLD)
        }
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}

/// A count with its word: "1 triangle", "2,000 triangles".
fn counted(count: u64, one: &str, many: &str) -> String {
    let digits = count.to_string();
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    format!("{grouped} {}", if count == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_counts_read_well() {
        assert_eq!(listed(["a"]), "`a`");
        assert_eq!(listed(["a", "b", "c"]), "`a`, `b` and `c`");
        assert_eq!(listed(["x"; 20]), format!("{} and 12 more", ["`x`"; 8].join(", ")));
        assert_eq!(counted(1, "face", "faces"), "1 face");
        assert_eq!(counted(1234567, "face", "faces"), "1,234,567 faces");
        assert_eq!(nearest("whte", ["red", "white"]), Some("white"));
        assert_eq!(nearest("gold", ["red", "white"]), None);
    }
}
