//! A clock for work of which nothing is kept: Ctrl-C ends the process.

use std::time::Instant;

use crate::run::Watch;

/// Tells the seconds since its moment, and nothing to anybody.
pub struct Clock(pub Instant);

impl Watch for Clock {
    fn cancelled(&self) -> bool {
        false
    }

    fn now(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }

    fn progress(&self, _done: u64, _total: u64) {}
}
