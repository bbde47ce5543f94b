//! `scn explain`: the page of a fault.

use super::options::Explain;
use super::{End, terminal};
use crate::diag::words::did_you_mean;
use crate::diag::{self, CODES, near};

pub fn run(options: &Explain) -> End {
    let Some(name) = &options.code else {
        terminal::say(&all(|_| true));
        return End::Well;
    };
    // As a report shows it, `error[family/what]`, is as good as the code alone.
    let bare = name.split_once('[').map_or(name.as_str(), |(_, rest)| rest);
    let bare = bare.trim_matches([']', '[', ':', ' ']);
    match diag::find(bare) {
        Some(code) => {
            terminal::say(&page(code.page));
            End::Well
        }
        None => {
            let family = all(|name| name.split('/').next() == Some(bare.trim_end_matches('/')));
            if !family.is_empty() {
                terminal::say(&family);
                return End::Well;
            }
            let hint = match near(bare, CODES.iter().map(|code| code.name)).as_slice() {
                [] => "`scn explain` lists all of them".to_string(),
                codes => {
                    format!(
                        "{} `scn explain` lists all of them",
                        did_you_mean(codes.iter().copied())
                    )
                }
            };
            terminal::fail(&format!("there is no fault with the code `{bare}`; {hint}"));
            End::NotDone
        }
    }
}

/// Every such code with its title; nothing, if none is.
fn all(such: impl Fn(&str) -> bool) -> String {
    let codes = || CODES.iter().filter(|code| such(code.name));
    let Some(width) = codes().map(|code| code.name.len()).max() else { return String::new() };
    let mut text = String::from("Faults. `scn explain CODE` shows the page of one.\n");
    let mut family = "";
    for code in codes() {
        let this = code.name.split('/').next().unwrap_or("");
        if this != family {
            text.push('\n');
            family = this;
        }
        text.push_str(&format!("  {:width$}  {}\n", code.name, code.title()));
    }
    text
}

/// A page as it is read on a terminal: its examples are set in, each under what it is.
fn page(page: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for line in page.lines() {
        if let Some(info) = line.strip_prefix("```") {
            inside = !inside;
            let heading = match info.trim().trim_end_matches(" --unbiased") {
                _ if !inside => continue,
                "scn" => "Wrong:".to_string(),
                "scn-ok" => "Mended:".to_string(),
                "scn-near" => "Not told of:".to_string(),
                other => match other.strip_prefix("file ") {
                    Some(name) => format!("File {name}:"),
                    None => continue,
                },
            };
            if !text.ends_with("\n\n") {
                text.push('\n');
            }
            text.push_str(&format!("{heading}\n\n"));
        } else if inside && !line.is_empty() {
            text.push_str(&format!("    {line}\n"));
        } else {
            text.push_str(&format!("{line}\n"));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_says_which_example_is_wrong_and_which_is_mended() {
        let told = "# A\n\nWhat.\n\n```scn\nscn 1\n\nuse \"b.obj\"\n```\n```file b.obj\nv 1\n```\n\nDo.\n\n\
                    ```scn-ok\nscn 1 in m\n```\n";
        let shown = "# A\n\nWhat.\n\nWrong:\n\n    scn 1\n\n    use \"b.obj\"\n\nFile b.obj:\n\n    v 1\n\n\
                     Do.\n\nMended:\n\n    scn 1 in m\n";
        assert_eq!(page(told), shown);
    }

    #[test]
    fn no_fence_is_shown() {
        for code in CODES {
            let shown = page(code.page);
            assert!(!shown.contains("```"), "{}", code.name);
            assert!(shown.contains("\nWrong:\n") && shown.contains("\nMended:\n"), "{shown}");
        }
    }
}
