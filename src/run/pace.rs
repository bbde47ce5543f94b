//! How many samples the next pass takes: one at first, so that something is there at once, then
//! as many as fit about a quarter of a second, so that a pass costs little beside its samples.

/// The length of passes, from how long they took.
pub(super) struct Pace {
    samples: u64,
    /// Samples a second, in the last pass.
    rate: f64,
}

/// Seconds a pass should take.
const PASS: f64 = 0.25;

/// How many times longer than the last one a pass may be: the first passes warm caches up, and
/// tell little.
const GROWTH: u64 = 4;

impl Pace {
    pub fn new() -> Self {
        Self { samples: 1, rate: f64::INFINITY }
    }

    /// Samples of each pixel in the next pass, at least 1. If only so many seconds are left, the
    /// pass is to end with them.
    pub fn samples(&self, left: Option<f64>) -> u64 {
        let fitting = left.map_or(u64::MAX, |seconds| (seconds * self.rate).round() as u64);
        self.samples.min(fitting).max(1)
    }

    /// A pass of so many samples took so many seconds.
    pub fn took(&mut self, samples: u64, seconds: f64) {
        // Clocks are others': one that stands still or lies gives the longest pass, no panic.
        self.rate = samples as f64 / seconds.max(f64::MIN_POSITIVE);
        self.samples = ((self.rate * PASS) as u64).clamp(1, samples.saturating_mul(GROWTH));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_grow_to_a_quarter_of_a_second_and_no_further() {
        let mut pace = Pace::new();
        assert_eq!(pace.samples(None), 1);
        pace.took(1, 0.01);
        assert_eq!(pace.samples(None), 4);
        pace.took(4, 0.04);
        assert_eq!(pace.samples(None), 16);
        pace.took(16, 0.16);
        assert_eq!(pace.samples(None), 25);
        pace.took(25, 100.0);
        assert_eq!(pace.samples(None), 1);
        for strange in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            pace.took(2, strange);
            assert!((1..=8).contains(&pace.samples(None)));
        }
    }
}
