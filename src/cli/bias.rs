//! What makes a picture systematically wrong: told beside it, or refused.

use super::options::Force;
use crate::diag::Diagnostic;
use crate::load::Stage;
use crate::plan::{self, Plan};

/// What a stage requires, or everything there is.
pub fn plan(stage: &Stage, force: Option<Force>) -> Plan {
    let plan = Plan::of(stage);
    match force {
        Some(Force::All) => plan.forced(),
        None => plan,
    }
}

/// What `--unbiased` refuses.
pub fn refused(stage: &Stage) -> Vec<Diagnostic> {
    plan::biases(stage).iter().map(plan::errors::biased).collect()
}
