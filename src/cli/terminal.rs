//! Where the command runs: what the two streams can show, writing to them without minding a closed
//! pipe, and what the environment asks for.

use std::io::{self, ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;

use crate::diag::harmless_text;
use crate::diag::print::Look;

/// How things look on stderr.
pub fn stderr_look() -> Look {
    let size = terminal_size::terminal_size_of(io::stderr());
    look(io::stderr().is_terminal(), size, &|name| std::env::var(name).ok())
}

/// Whether plain instructions are asked for, by a variable `SCN_PORTABLE` that is not empty.
pub fn portable() -> bool {
    std::env::var_os("SCN_PORTABLE").is_some_and(|value| !value.is_empty())
}

/// Whether somebody watches stderr.
pub fn stderr_is_terminal() -> bool {
    io::stderr().is_terminal()
}

/// Whether somebody watches stdout.
pub fn stdout_is_terminal() -> bool {
    io::stdout().is_terminal()
}

/// How things look on stdout.
pub fn stdout_look() -> Look {
    let size = terminal_size::terminal_size_of(io::stdout());
    look(stdout_is_terminal(), size, &|name| std::env::var(name).ok())
}

type Size = (terminal_size::Width, terminal_size::Height);

fn look(terminal: bool, size: Option<Size>, variable: &dyn Fn(&str) -> Option<String>) -> Look {
    if !terminal {
        return Look::PLAIN;
    }
    let set = |name: &str| variable(name).filter(|value| !value.is_empty());
    let dumb = set("TERM").is_some_and(|term| term == "dumb");
    // The first of them that is set decides; a plain C locale knows no character beyond ASCII.
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(set);
    let ascii = locale.is_some_and(|locale| locale == "C" || locale == "POSIX");
    let width = size.map_or(Look::PLAIN.width, |(width, _)| width.0 as usize);
    // https://no-color.org: any value but an empty one.
    Look { colour: !dumb && set("NO_COLOR").is_none(), unicode: !dumb && !ascii, width }
}

/// Why stdout did not take all that was written to it.
static LOST: OnceLock<String> = OnceLock::new();

/// Writes to stdout; [`lost`] tells whether that went well.
pub fn say(text: &str) {
    let mut stream = io::stdout().lock();
    note(stream.write_all(text.as_bytes()).and_then(|()| stream.flush()));
}

/// Remembers why stdout did not take a text. A reader that has gone away has seen enough.
pub fn note(written: io::Result<()>) {
    if let Err(error) = written
        && error.kind() != ErrorKind::BrokenPipe
    {
        LOST.get_or_init(|| error.to_string());
    }
}

/// Why stdout did not take all that was written to it, if it did not.
pub fn lost() -> Option<&'static str> {
    LOST.get().map(String::as_str)
}

/// Writes to stderr.
pub fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Tells why the tool cannot do its work: "error: …".
pub fn fail(text: &str) {
    let mark = if stderr_look().colour { "\x1b[31merror:\x1b[0m" } else { "error:" };
    tell(&format!("{mark} {}\n", harmless_text(text)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use terminal_size::{Height, Width};

    fn seen(variables: &[(&str, &str)]) -> Look {
        look(true, Some((Width(80), Height(24))), &|name| {
            variables.iter().find(|(n, _)| *n == name).map(|(_, value)| value.to_string())
        })
    }

    #[test]
    fn colour_only_on_a_terminal_that_wants_it() {
        assert!(seen(&[("TERM", "xterm"), ("NO_COLOR", "")]).colour);
        assert!(!seen(&[("NO_COLOR", "1")]).colour);
        assert!(!seen(&[("TERM", "dumb")]).colour);
        assert!(!look(false, None, &|_| None).colour);
        assert_eq!(look(false, None, &|_| None).width, 100);
        assert_eq!(seen(&[]).width, 80);
    }

    #[test]
    fn a_plain_locale_gets_ascii() {
        assert!(seen(&[("LANG", "C.UTF-8")]).unicode);
        assert!(!seen(&[("LC_ALL", "C"), ("LANG", "en_GB.UTF-8")]).unicode);
    }
}
