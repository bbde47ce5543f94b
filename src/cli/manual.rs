//! `scn man` and `scn completions`: what is known of the options, for `man` and for shells.

use clap::CommandFactory;

use super::options::{Completions, Man, Options};
use super::{End, terminal};
use crate::diag::near;
use crate::diag::words::did_you_mean;

/// A page for `man`.
pub fn page(options: &Man) -> End {
    let mut command = Options::command();
    command.build();
    if let Some(name) = &options.command {
        let Some(found) = command.find_subcommand(name) else {
            let all: Vec<_> = command.get_subcommands().map(|c| c.get_name()).collect();
            let nearest = near(name, all.iter().copied());
            let hint = match nearest.as_slice() {
                [] => "`scn --help` lists all of them".to_string(),
                nearest => did_you_mean(nearest.iter().copied()),
            };
            terminal::fail(&format!("there is no command `{name}`; {hint}"));
            return End::NotDone;
        };
        command = found.clone();
    }
    let title = command.get_display_name().unwrap_or("scn").to_string();
    let mut text = Vec::new();
    if let Err(error) = clap_mangen::Man::new(command).title(title).render(&mut text) {
        terminal::fail(&format!("the page could not be written: {error}"));
        return End::NotDone;
    }
    terminal::say(&String::from_utf8_lossy(&text));
    End::Well
}

/// A script that completes what is typed after `scn`.
pub fn completions(options: &Completions) -> End {
    let mut text = Vec::new();
    clap_complete::generate(options.shell, &mut Options::command(), "scn", &mut text);
    terminal::say(&String::from_utf8_lossy(&text));
    End::Well
}
