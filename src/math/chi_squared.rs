//! Pearson's test for the suite: do counts follow their probabilities? Seeds are fixed, so a
//! verdict never changes by itself.

/// Panics unless `counts` are a likely draw from `probabilities`, which sum to 1. The statistic
/// may exceed its mean by five standard deviations: a chance of about 1e-5 or less.
pub(crate) fn assert_fits(counts: &[u64], probabilities: &[f64]) {
    assert_eq!(counts.len(), probabilities.len());
    let total = counts.iter().sum::<u64>() as f64;
    let sum: f64 = probabilities.iter().sum();
    assert!((sum - 1.0).abs() < 1e-9, "the density integrates to {sum}");
    // Bins that expect fewer than five are pooled: the statistic is not chi-squared there.
    let mut statistic = 0.0;
    let mut bins = 0;
    let mut pool = (0.0, 0.0);
    let mut add = |seen: f64, expected: f64| {
        statistic += (seen - expected).powi(2) / expected;
        bins += 1;
    };
    for (count, probability) in counts.iter().zip(probabilities) {
        let (seen, expected) = (*count as f64, probability * total);
        if expected >= 5.0 {
            add(seen, expected);
        } else {
            pool = (pool.0 + seen, pool.1 + expected);
        }
    }
    if pool.1 > 0.0 {
        add(pool.0, pool.1);
    } else {
        assert_eq!(pool.0, 0.0, "samples where the density is zero");
    }
    let freedom = f64::from((bins - 1).max(1));
    let bound = freedom + 5.0 * (2.0 * freedom).sqrt() + 10.0;
    assert!(statistic < bound, "chi-squared {statistic} over {freedom} degrees of freedom");
}

#[test]
#[should_panic(expected = "chi-squared")]
fn a_wrong_density_is_found() {
    assert_fits(&[5400, 4600, 5000, 5000], &[0.25; 4]);
}
