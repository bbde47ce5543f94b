//! Who watches a render in a test.

use std::sync::atomic::{AtomicU64, Ordering};

use scn::run::Watch;

/// Never stops anything; its clock stands still.
pub struct Patient;

impl Watch for Patient {
    fn cancelled(&self) -> bool {
        false
    }
    fn now(&self) -> f64 {
        0.0
    }
    fn progress(&self, _done: u64, _total: u64) {}
}

/// A clock on which each reading is `step` seconds after the last, and patience for so many
/// questions.
pub struct Ticking {
    step: f64,
    readings: AtomicU64,
    patience: AtomicU64,
    pub last: AtomicU64,
}

impl Ticking {
    pub fn new(step: f64, patience: u64) -> Self {
        let readings = AtomicU64::new(0);
        Self { step, readings, patience: AtomicU64::new(patience), last: AtomicU64::new(0) }
    }
}

impl Watch for Ticking {
    fn cancelled(&self) -> bool {
        let one_less = |left: u64| left.checked_sub(1);
        self.patience.fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_less).is_err()
    }
    fn now(&self) -> f64 {
        self.readings.fetch_add(1, Ordering::Relaxed) as f64 * self.step
    }
    fn progress(&self, done: u64, total: u64) {
        assert!(done <= total);
        self.last.fetch_max(done, Ordering::Relaxed);
    }
}
