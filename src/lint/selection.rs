//! Which findings are told, and which of them count: `--select`, `--ignore`, `--deny`.

use crate::diag::{CODES, Code, Diagnostic, Level};

/// What was asked for. Names are codes, beginnings of codes such as `mesh`, or rules without their
/// `lint/`. Errors are always told, and always count.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Warnings told; empty: all.
    pub select: Vec<String>,
    /// Warnings not told.
    pub ignore: Vec<String>,
    /// Warnings that count like errors; `warnings` are all of them.
    pub deny: Vec<String>,
}

/// The word that stands for every warning.
pub const WARNINGS: &str = "warnings";

impl Selection {
    /// The names that mean nothing.
    pub fn unknown(&self) -> Vec<&str> {
        let all = self.select.iter().chain(&self.ignore).chain(&self.deny);
        let known =
            |name: &&str| *name == WARNINGS || CODES.iter().any(|code| matches(name, *code));
        all.map(String::as_str).filter(|name| !known(name)).collect()
    }

    /// Whether a finding is told.
    pub fn tells(&self, diagnostic: &Diagnostic) -> bool {
        diagnostic.level == Level::Error
            || (self.select.is_empty() || any(&self.select, diagnostic.code))
                && !any(&self.ignore, diagnostic.code)
    }

    /// Whether a finding counts like an error.
    pub fn denies(&self, diagnostic: &Diagnostic) -> bool {
        diagnostic.level == Level::Error || any(&self.deny, diagnostic.code)
    }
}

fn any(names: &[String], code: Code) -> bool {
    names.iter().any(|name| name == WARNINGS || matches(name, code))
}

/// Whether a name means a code: it is the code, or the beginning of it.
fn matches(name: &str, code: Code) -> bool {
    let rule = code.name.strip_prefix("lint/");
    !name.is_empty() && (code.name.starts_with(name) || rule == Some(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(all: &[&str]) -> Vec<String> {
        all.iter().map(|name| name.to_string()).collect()
    }

    #[test]
    fn warnings_are_chosen_by_codes_and_beginnings() {
        let warning = |code| Diagnostic::warning(code, "");
        let mesh = warning(Code::MESH_NOT_RENDERED);
        let rule = warning(Code::LINT_UNUSED_LET);
        let error = Diagnostic::error(Code::MESH_NO_FACES, "");
        let told = |select: &[&str], ignore: &[&str]| {
            let (select, ignore) = (names(select), names(ignore));
            let selection = Selection { select, ignore, deny: Vec::new() };
            assert!(selection.tells(&error) && selection.denies(&error));
            (selection.tells(&mesh), selection.tells(&rule))
        };
        assert_eq!(told(&[], &[]), (true, true));
        assert_eq!(told(&["lint"], &[]), (false, true));
        assert_eq!(told(&["unused-let"], &[]), (false, true));
        assert_eq!(told(&["mesh/"], &["mesh/not-rendered"]), (false, false));
        assert_eq!(told(&["warnings"], &["lint/unused-"]), (true, false));
        let deny = |name: &str| Selection { deny: names(&[name]), ..Selection::default() };
        assert!(deny("warnings").denies(&mesh) && deny("mesh").denies(&mesh));
        assert!(!deny("mesh").denies(&rule) && !Selection::default().denies(&rule));
        assert_eq!(deny("mash").unknown(), ["mash"]);
        assert!(deny("warnings").unknown().is_empty() && deny("mesh").unknown().is_empty());
        assert_eq!(deny("").unknown(), [""]);
    }
}
