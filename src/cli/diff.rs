//! How a text would change, as a unified diff.

use std::path::Path;

use similar::TextDiff;

use super::terminal;
use crate::diag::harmless_text;

/// What changes from `old` to `new`, each as the file `path`: on a terminal in colour and without
/// what could harm it, elsewhere as `patch` wants it. Empty if nothing changes.
pub fn unified(path: &Path, old: &str, new: &str) -> String {
    let shown = path.to_string_lossy().replace(['\n', '\r'], "?");
    let diff = TextDiff::from_lines(old, new);
    let text = diff.unified_diff().context_radius(3).header(&shown, &shown).to_string();
    match terminal::stdout_is_terminal() {
        true => coloured(&harmless_text(&text), terminal::stdout_look().colour),
        false => text,
    }
}

fn coloured(text: &str, colour: bool) -> String {
    let mut all = String::new();
    for line in text.lines() {
        let code = match line.bytes().next() {
            _ if !colour => None,
            _ if line.starts_with("---") || line.starts_with("+++") => Some(1),
            Some(b'-') => Some(31),
            Some(b'+') => Some(32),
            Some(b'@') => Some(36),
            _ => None,
        };
        match code {
            Some(code) => all.push_str(&format!("\x1b[{code}m{line}\x1b[0m\n")),
            None => all.push_str(&format!("{line}\n")),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_lines_are_marked() {
        let shown = unified(Path::new("a.scn"), "a\nb\nc\n", "a\nB\nc\n");
        assert_eq!(shown, "--- a.scn\n+++ a.scn\n@@ -1,3 +1,3 @@\n a\n-b\n+B\n c\n");
        assert_eq!(unified(Path::new("a.scn"), "a\n", "a\n"), "");
        assert_eq!(coloured("-a\n b\n", true), "\x1b[31m-a\x1b[0m\n b\n");
        assert_eq!(coloured("-a\n", false), "-a\n");
    }
}
