//! More faults in one file than are told.

use crate::diag::Diagnostic;
use crate::diag::words::grouped;
use crate::lang::limits;

/// Faults beyond the limit: how many, where they were counted, and the code of the last one told,
/// which is most likely theirs.
pub fn more_faults(more: Option<usize>, last: &Diagnostic) -> Diagnostic {
    let headline = match more {
        Some(1) => "1 more fault of this file is not told".to_string(),
        Some(more) => format!("{} more faults of this file are not told", grouped(more as u64)),
        None => "this file has more faults, which are not told".to_string(),
    };
    let told = Diagnostic::error(last.code, headline)
        .why(format!("Of each file the first {} are told.", grouped(limits::FAULTS as u64)))
        .help("mend those that are told, the first ones first, and look again");
    match last.place() {
        Some(last) => told.label(last.after(), "after this"),
        None => told,
    }
}
