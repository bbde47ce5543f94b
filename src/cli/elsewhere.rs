//! Options of other renderers, and what they are called here: offered, never obeyed.

use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};

use super::options::Options;

/// An option of elsewhere, and the one it most likely stands for.
const ELSEWHERE: &[(&str, &str)] = &[
    ("--max-time", "--time"),
    ("--noise", "--error"),
    ("--nthreads", "--threads"),
    ("--out", "--output"),
    ("--outfile", "--output"),
    ("--region", "--crop"),
    ("--res", "--scale"),
    ("--resolution", "--scale"),
    ("--sample-count", "--samples"),
    ("--size", "--scale"),
    ("--spp", "--samples"),
    ("--timeout", "--time"),
    ("--width", "--scale"),
];

/// A fault of the command line, with what an unknown option is called here if the command has it.
pub fn offered(mut fault: clap::Error) -> clap::Error {
    let Some(ContextValue::String(said)) = fault.get(ContextKind::InvalidArg) else { return fault };
    let said = said.split(['=', ' ']).next().unwrap_or(said);
    let Some((_, meant)) = ELSEWHERE.iter().find(|(known, _)| *known == said) else { return fault };
    let Some(command) = std::env::args().nth(1) else { return fault };
    let all = Options::command();
    let command = all.find_subcommand(command);
    if command.is_some_and(|it| it.get_arguments().any(|arg| arg.get_long() == meant.get(2..))) {
        fault.remove(ContextKind::Suggested);
        fault.insert(ContextKind::SuggestedArg, ContextValue::String(meant.to_string()));
    }
    fault
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_offered_is_an_option_and_what_is_said_is_none() {
        let command = Options::command();
        let render = command.find_subcommand("render").unwrap();
        let known = |long: &str| render.get_arguments().any(|it| it.get_long() == Some(&long[2..]));
        for (said, meant) in ELSEWHERE {
            assert!(known(meant) && !known(said), "{said} → {meant}");
        }
        assert!(ELSEWHERE.is_sorted());
    }
}
