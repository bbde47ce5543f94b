//! `scn explain`: the page of a fault.

use super::near::{either, near};
use super::options::Explain;
use super::{End, terminal};
use crate::diag::{self, CODES};

pub fn run(options: &Explain) -> End {
    let Some(name) = &options.code else {
        terminal::say(&all());
        return End::Well;
    };
    // As a report shows it, `error[family/what]`, is as good as the code alone.
    let bare = name.split_once('[').map_or(name.as_str(), |(_, rest)| rest);
    let bare = bare.trim_matches([']', '[', ':', ' ']);
    match diag::find(bare) {
        Some(code) => {
            terminal::say(code.page);
            End::Well
        }
        None => {
            let family: Vec<_> = CODES
                .iter()
                .map(|code| code.name)
                .filter(|code| code.split('/').next() == Some(bare.trim_end_matches('/')))
                .collect();
            let mut nearest = near(bare, CODES.iter().map(|code| code.name));
            if !family.is_empty() {
                nearest = family;
            }
            let hint = match nearest.as_slice() {
                [] => "`scn explain` lists all of them".to_string(),
                codes => format!("did you mean {}? `scn explain` lists all of them", either(codes)),
            };
            terminal::fail(&format!("there is no fault with the code `{bare}`; {hint}"));
            End::NotDone
        }
    }
}

/// Every code with its title.
fn all() -> String {
    let width = CODES.iter().map(|code| code.name.len()).max().unwrap_or(0);
    let mut text = String::from("Faults. `scn explain CODE` shows the page of one.\n");
    let mut family = "";
    for code in CODES {
        let this = code.name.split('/').next().unwrap_or("");
        if this != family {
            text.push('\n');
            family = this;
        }
        text.push_str(&format!("  {:width$}  {}\n", code.name, title(code.page)));
    }
    text
}

/// The heading of a page.
fn title(page: &str) -> &str {
    page.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or("")
}
