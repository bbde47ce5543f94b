//! What can be wrong with the files a scene names: one function a fault, one file a family.

use crate::diag::Diagnostic;
use crate::diag::words::counted;

pub(super) mod file;
pub(super) mod mesh;
pub(super) mod mtl;
pub(super) mod texture;

/// Adds to the last fault of a file told that there are more.
pub(super) fn and_more(fault: Diagnostic, file: &str, more: u64) -> Diagnostic {
    let faults = counted(more, "further fault");
    fault.why(format!("`{file}` has {faults}, often of the same kinds."))
}

/// Names of a file that a fault tells at most.
const TOLD: usize = 8;
