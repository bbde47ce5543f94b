//! How long work tells that it moves on, and hears that it is not wanted any more. Handed down from whoever shows it.

/// Told how far a piece of work is. Called from any thread, often: must be cheap.
pub trait Progress: Sync {
    /// `done` of `total` units are done; the unit is the caller's affair.
    fn advance(&self, done: u64, total: u64);

    /// Whether the work is no longer wanted: what it comes to then is thrown away. Must be cheap.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Shows nothing.
pub struct NoProgress;

impl Progress for NoProgress {
    fn advance(&self, _done: u64, _total: u64) {}
}
