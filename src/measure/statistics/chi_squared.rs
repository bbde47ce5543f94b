//! Pearson's chi-squared test: do samples fall where their density says?

use std::fmt;

use super::distributions::chi_squared_survival;

/// Bins that expect fewer samples are pooled: below about five the statistic is not chi-squared.
pub const LEAST_EXPECTED: f64 = 5.0;

/// How far probabilities may sum above one, for the error of a numerical integral.
const SURPLUS: f64 = 1e-4;

/// What the test found; printed, it tells its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Σ (observed − expected)² / expected over the pooled bins.
    pub statistic: f64,
    /// Degrees of freedom: pooled bins less one.
    pub freedom: u64,
    /// How likely a right sampler does this badly or worse; 0 when it cannot be right.
    pub p: f64,
    /// Why no statistic was needed, or none could be formed.
    pub unfit: Option<Unfit>,
}

/// Why the test fails without a statistic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unfit {
    /// Samples fell into this bin, where the density is zero.
    Impossible {
        /// Which bin, from 0.
        bin: usize,
        /// How many samples it got.
        observed: u64,
    },
    /// More samples were counted in bins than were drawn.
    Miscounted,
    /// The density integrates to this over all bins: above one, negative somewhere, or no number.
    Improper(f64),
    /// Fewer than two bins are left after pooling: the test could not fail.
    TooFew,
}

impl Fit {
    /// Whether the sampler may be right, at the level `alpha`: a right one is refused with this
    /// chance. For several tests at once divide it by [`sidak`](super::sidak).
    pub fn accepts(&self, alpha: f64) -> bool {
        self.unfit.is_none() && self.p >= alpha
    }

    fn unfit(why: Unfit) -> Self {
        Self { statistic: f64::INFINITY, freedom: 0, p: 0.0, unfit: Some(why) }
    }
}

/// Tests `observed` counts of `samples` draws against the probability of each bin (the integral
/// of the density over it). What the probabilities leave of one is a bin of its own, "elsewhere",
/// so a sampler that rejects, or a density that integrates to less than one, is tested too.
///
/// # Panics
/// If the slices differ in length.
pub fn chi_squared(observed: &[u64], probabilities: &[f64], samples: u64) -> Fit {
    assert_eq!(observed.len(), probabilities.len(), "one probability a bin");
    let total: f64 = probabilities.iter().sum();
    if probabilities.iter().any(|p| !(0.0..).contains(p)) || total > 1.0 + SURPLUS {
        return Fit::unfit(Unfit::Improper(total));
    }
    let Some(elsewhere) = samples.checked_sub(observed.iter().sum()) else {
        return Fit::unfit(Unfit::Miscounted);
    };
    for (bin, (&n, &p)) in observed.iter().zip(probabilities).enumerate() {
        if n > 0 && p == 0.0 {
            return Fit::unfit(Unfit::Impossible { bin, observed: n });
        }
    }

    let draws = samples as f64;
    let mut bins: Vec<(f64, u64)> =
        probabilities.iter().zip(observed).map(|(&p, &n)| (p * draws, n)).collect();
    bins.push(((1.0 - total).max(0.0) * draws, elsewhere));
    let pooled = pool(bins);
    if pooled.len() < 2 {
        return Fit::unfit(Unfit::TooFew);
    }
    let statistic = pooled.iter().map(|&(e, n)| (n as f64 - e).powi(2) / e).sum();
    let freedom = pooled.len() as u64 - 1;
    let p = chi_squared_survival(statistic, freedom as f64);
    Fit { statistic, freedom, p, unfit: None }
}

/// Joins bins of few expected samples until each expects enough. Smallest first, so that the
/// fewest are joined; what is left over joins the last pool of small ones, or the next large bin.
fn pool(mut bins: Vec<(f64, u64)>) -> Vec<(f64, u64)> {
    bins.sort_by(|a, b| a.0.total_cmp(&b.0));
    let large = bins.partition_point(|bin| bin.0 < LEAST_EXPECTED);
    let mut pooled: Vec<(f64, u64)> = Vec::new();
    let mut rest = (0.0, 0);
    for (expected, n) in bins.drain(..large) {
        rest = (rest.0 + expected, rest.1 + n);
        if rest.0 >= LEAST_EXPECTED {
            pooled.push(std::mem::take(&mut rest));
        }
    }
    if let Some(last) = pooled.last_mut().or(bins.first_mut()) {
        *last = (last.0 + rest.0, last.1 + rest.1);
    }
    pooled.extend(bins);
    pooled
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.unfit {
            None => write!(
                f,
                "chi-squared {:.1} with {} degrees of freedom: a right sampler does as badly \
                 with probability {:.2e}",
                self.statistic, self.freedom, self.p
            ),
            Some(Unfit::Impossible { bin, observed }) => {
                write!(f, "{observed} samples fell into bin {bin}, where the density is zero")
            }
            Some(Unfit::Miscounted) => write!(f, "more samples were counted than were drawn"),
            Some(Unfit::Improper(total)) => {
                write!(f, "the density is improper: over all bins it integrates to {total}")
            }
            Some(Unfit::TooFew) => write!(
                f,
                "fewer than two bins expect {LEAST_EXPECTED} samples or more: draw more samples \
                 or take fewer bins"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random;

    /// Counts of `samples` numbers u² in ten equal bins of [0, 1).
    fn squares(samples: u64, seed: u64) -> Vec<u64> {
        let mut counts = vec![0; 10];
        for i in 0..samples {
            let u = (random::mix(seed ^ (i << 20)) >> 11) as f64 / (1u64 << 53) as f64;
            counts[(u * u * 10.0) as usize] += 1;
        }
        counts
    }

    fn square_density() -> Vec<f64> {
        (0..10).map(|i| ((i + 1) as f64 / 10.0).sqrt() - (i as f64 / 10.0).sqrt()).collect()
    }

    #[test]
    fn the_statistic_by_hand() {
        let fit = chi_squared(&[44, 56], &[0.5, 0.5], 100);
        assert!((fit.statistic - 1.44).abs() < 1e-12 && fit.freedom == 1, "{fit}");
        // chi2.sf(1.44, 1) of SciPy
        assert!((fit.p - 0.230_139_340_443_410_93).abs() < 1e-9, "{fit}");
    }

    #[test]
    fn a_right_sampler_passes_at_the_stated_rate() {
        let refused = (0..400)
            .filter(|seed| {
                !chi_squared(&squares(2000, *seed), &square_density(), 2000).accepts(0.05)
            })
            .count();
        // Binomial(400, 0.05): 20 ± 4.4.
        assert!((7..=34).contains(&refused), "{refused} of 400 refused at 5 %");
    }

    #[test]
    fn a_wrong_sampler_is_refused() {
        let uniform = vec![0.1; 10];
        let fit = chi_squared(&squares(2000, 1), &uniform, 2000);
        assert!(!fit.accepts(1e-6), "{fit}");
    }

    #[test]
    fn lost_samples_are_seen() {
        let mut counts = squares(20_000, 3);
        let lost = counts[4];
        counts[4] = 0;
        let without: Vec<f64> = square_density()
            .iter()
            .enumerate()
            .map(|(i, p)| if i == 4 { 0.0 } else { *p })
            .collect();
        // Said to be elsewhere, they are a bin like another …
        assert!(chi_squared(&counts, &without, 20_000).accepts(1e-3));
        // … not said, their absence shows.
        assert!(lost > 100 && !chi_squared(&counts, &square_density(), 20_000).accepts(1e-6));
    }

    #[test]
    fn small_bins_are_pooled() {
        // Expected: 2, 2, 2 join into 6; 4 is left over and joins them.
        assert_eq!(
            pool(vec![(90.0, 91), (2.0, 1), (2.0, 3), (2.0, 2), (4.0, 3)]),
            [(10.0, 9), (90.0, 91)]
        );
        assert_eq!(pool(vec![(1.0, 2), (50.0, 49), (49.0, 49)]), [(50.0, 51), (50.0, 49)]);
        assert_eq!(pool(vec![(3.0, 2), (6.0, 7), (3.0, 4)]), [(6.0, 6), (6.0, 7)]);
        assert_eq!(pool(vec![]), []);
    }

    #[test]
    fn what_cannot_be_right_is_named() {
        assert_eq!(
            chi_squared(&[1, 99], &[0.0, 1.0], 100).unfit,
            Some(Unfit::Impossible { bin: 0, observed: 1 })
        );
        assert_eq!(chi_squared(&[60, 60], &[0.5, 0.5], 100).unfit, Some(Unfit::Miscounted));
        assert_eq!(chi_squared(&[50, 50], &[0.5, 0.6], 100).unfit, Some(Unfit::Improper(1.1)));
        assert!(!chi_squared(&[50, 50], &[f64::NAN, 0.5], 100).accepts(0.0));
        assert_eq!(chi_squared(&[2, 2], &[0.5, 0.5], 4).unfit, Some(Unfit::TooFew));
        assert_eq!(chi_squared(&[], &[], 0).unfit, Some(Unfit::TooFew));
    }
}
