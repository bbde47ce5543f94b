//! Mean and variance of a stream of numbers in f64, mergeable in any fixed tree [Welford62, Chan83].
//!
//! Σx² − (Σx)²/n is left out on purpose: it cancels, even to a negative variance.

use super::distributions::student_t_quantile;

/// Count, mean and spread of the values seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    squares: f64,
}

impl Moments {
    /// Takes in one value.
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        let from_old = value - self.mean;
        self.mean += from_old / self.count as f64;
        self.squares += from_old * (value - self.mean);
    }

    /// The moments of both sets of values together. Merging in a fixed order gives fixed bits.
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        if self.count == 0 {
            *self = *other;
            return;
        }
        let (n, m) = (self.count as f64, other.count as f64);
        let apart = other.mean - self.mean;
        self.count += other.count;
        let all = self.count as f64;
        self.mean += apart * (m / all);
        self.squares += other.squares + apart * apart * (n * (m / all));
    }

    /// How many values were taken in.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Their mean; 0 of none.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Unbiased variance of one value. Infinite below two values: nothing is known then.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::INFINITY } else { self.squares / (self.count - 1) as f64 }
    }

    /// Standard deviation of the mean. Infinite below two values.
    pub fn standard_error(&self) -> f64 {
        (self.variance() / self.count.max(1) as f64).sqrt()
    }

    /// The interval that holds the true mean with this confidence in (0, 1), by Student's t:
    /// right for values near normal, such as the means of batches of many samples.
    pub fn interval(&self, confidence: f64) -> (f64, f64) {
        if self.count < 2 {
            return (f64::NEG_INFINITY, f64::INFINITY);
        }
        let freedom = (self.count - 1) as f64;
        let half = student_t_quantile(0.5 + 0.5 * confidence, freedom) * self.standard_error();
        (self.mean - half, self.mean + half)
    }
}

impl Extend<f64> for Moments {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, values: I) {
        for value in values {
            self.add(value);
        }
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut moments = Self::default();
        moments.extend(values);
        moments
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn four_numbers_by_hand() {
        let m: Moments = [2.0, 4.0, 4.0, 10.0].into_iter().collect();
        assert_eq!((m.count(), m.mean()), (4, 5.0));
        assert!((m.variance() - 12.0).abs() < 1e-14);
        assert!((m.standard_error() - 3f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn the_interval_is_students() {
        let m: Moments = (0..16).map(f64::from).collect();
        // t(0.975, 15) = 2.131449545559776; variance of 0..15 is 68/3.
        let half = 2.131_449_545_559_776 * (68.0f64 / 3.0 / 16.0).sqrt();
        let (low, high) = m.interval(0.95);
        assert!((low - (7.5 - half)).abs() < 1e-9 && (high - (7.5 + half)).abs() < 1e-9);
    }

    #[test]
    fn one_value_knows_nothing_of_its_error() {
        let m: Moments = [3.0].into_iter().collect();
        assert_eq!(m.variance(), f64::INFINITY);
        assert_eq!(m.standard_error(), f64::INFINITY);
        assert_eq!(m.interval(0.95), (f64::NEG_INFINITY, f64::INFINITY));
        assert_eq!(Moments::default().standard_error(), f64::INFINITY);
    }

    #[test]
    fn a_small_variance_on_a_large_mean_survives() {
        // Values 1e8 ± 1 in f64: the sum of squares alone would have lost the ±1.
        let m: Moments =
            (0..1_000_000).map(|i| 1e8 + if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert!((m.variance() - 1.0).abs() < 1e-5, "{}", m.variance());
    }

    proptest! {
        #[test]
        fn merged_parts_equal_the_whole(
            values in prop::collection::vec(-1e3f64..1e3, 0..60),
            cuts in prop::collection::vec(0usize..60, 0..4),
        ) {
            let whole: Moments = values.iter().copied().collect();
            let mut cuts: Vec<usize> = cuts.into_iter().map(|c| c.min(values.len())).collect();
            cuts.extend([0, values.len()]);
            cuts.sort_unstable();
            let mut merged = Moments::default();
            for pair in cuts.windows(2) {
                merged.merge(&values[pair[0]..pair[1]].iter().copied().collect());
            }
            prop_assert_eq!(merged.count(), whole.count());
            prop_assert!((merged.mean() - whole.mean()).abs() <= 1e-9);
            if whole.count() > 1 {
                prop_assert!((merged.variance() - whole.variance()).abs() <= 1e-7);
            }
        }
    }
}
