//! Which of a file's renders a fault of a whole scene belongs to.

use crate::diag::Diagnostic;
use crate::diag::words::listed;

/// More names than this, and a fault tells their number.
const MOST: usize = 4;

/// What was found in each of some renders, each fault once. The first label of one that not all
/// of them have says which do: a scene may fit together in one render and not in another.
pub fn told(renders: Vec<(String, Vec<Diagnostic>)>) -> Vec<Diagnostic> {
    let all = renders.len();
    let mut faults: Vec<(Diagnostic, Vec<String>)> = Vec::new();
    for (name, found) in renders {
        for fault in found {
            match faults.iter_mut().find(|(known, _)| *known == fault) {
                Some((_, names)) if names.last() == Some(&name) => {}
                Some((_, names)) => names.push(name.clone()),
                None => faults.push((fault, vec![name.clone()])),
            }
        }
    }
    let named = faults.into_iter().map(|(mut fault, names)| {
        if names.len() < all
            && let Some(label) = fault.labels.first_mut()
        {
            let whose = match names.as_slice() {
                [one] => format!("in render {}", listed([one.as_str()], "and")),
                some if some.len() <= MOST => {
                    format!("in renders {}", listed(some.iter().map(String::as_str), "and"))
                }
                many => format!("in {} of the {all} renders", many.len()),
            };
            label.text.push_str(&format!(" ({whose})"));
        }
        fault
    });
    named.collect()
}
