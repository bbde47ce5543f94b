//! Random numbers as a pure function of their place: (seed, pixel, sample, dimension).
//!
//! Nothing is drawn in order, so no thread, pass or tile can change what another one sees.

/// A 64-bit finaliser (SplitMix64 [Steele14]): every input bit reaches every output bit.
#[inline]
pub fn mix(input: u64) -> u64 {
    let mut z = input.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The bits at one more coordinate of a place: `at(at(mix(seed), pixel), sample)` and so on.
#[inline]
pub fn at(place: u64, coordinate: u64) -> u64 {
    mix(place ^ mix(coordinate))
}

/// Two numbers in [0, 1), of 32 bits each: exact in f64, and never 1.
#[inline]
pub fn unit_pair(bits: u64) -> [f64; 2] {
    const STEP: f64 = 1.0 / 4_294_967_296.0;
    [(bits >> 32) as f64 * STEP, (bits & 0xffff_ffff) as f64 * STEP]
}

/// The nearest f32 that is not 1: of a number in [0, 1), which rounding alone would make 1.
#[inline]
pub fn unit_f32(unit: f64) -> f32 {
    (unit as f32).min(1.0 - f32::EPSILON / 2.0)
}

/// Rounds of the shuffle: after ten, the places of two indices show no pattern in a million keys.
const ROUNDS: u64 = 10;

/// Where `index` goes in a shuffle of `0..length` that `key` chooses.
///
/// The swap-or-not shuffle [Hoang12]: each round pairs all indices, by a random sum, and swaps
/// each pair or not. A random turn at the end sends each index to each place with the same chance,
/// to within 2⁻³² · `length`, however few the rounds.
pub fn shuffled(index: u32, length: u32, key: u64) -> u32 {
    debug_assert!(index < length);
    let below = |bits: u64| ((bits >> 32) * u64::from(length)) >> 32;
    let turned = |from: u64, by: u64| {
        if by > from { by - from - 1 } else { by + u64::from(length) - from - 1 }
    };
    let mut place = u64::from(index);
    for round in 0..ROUNDS {
        let bits = mix(key.wrapping_add(round));
        let partner = turned(place, below(bits));
        // A bit that the two of a pair share: the top one of a product hash of the larger.
        let shared = place.max(partner) as u32;
        if (shared ^ bits as u32).wrapping_mul(bits as u32 | 1) >> 31 == 1 {
            place = partner;
        }
    }
    turned(place, below(mix(key.wrapping_add(ROUNDS)))) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::chi_squared;

    #[test]
    fn the_unit_interval_is_half_open() {
        assert_eq!(unit_pair(0), [0.0, 0.0]);
        let [high, low] = unit_pair(u64::MAX);
        assert!(high < 1.0 && low < 1.0);
        assert!(unit_f32(high) < 1.0);
        assert_eq!(unit_f32(0.25), 0.25);
    }

    #[test]
    fn a_shuffle_loses_nothing() {
        for length in [1, 2, 3, 4, 9, 16, 100, 257, 4096] {
            for key in 0..20 {
                let key = mix(key);
                let mut seen = vec![false; length as usize];
                (0..length).for_each(|i| seen[shuffled(i, length, key) as usize] = true);
                assert!(seen.iter().all(|s| *s), "{length}");
            }
        }
    }

    #[test]
    fn every_index_goes_everywhere_alike_and_so_does_every_pair() {
        for length in [2_u32, 3, 4, 9, 16] {
            let n = length as usize;
            let mut firsts = vec![0_u64; n];
            let mut pairs = vec![0_u64; n * (n - 1)];
            for key in 0..60_000 {
                let key = mix(key ^ 0xabcd);
                let a = shuffled(0, length, key) as usize;
                let b = shuffled(length - 1, length, key) as usize;
                firsts[a] += 1;
                pairs[a * (n - 1) + b - usize::from(b > a)] += 1;
            }
            let even = |bins: usize| vec![1.0 / bins as f64; bins];
            chi_squared::assert_fits(&firsts, &even(n));
            chi_squared::assert_fits(&pairs, &even(n * (n - 1)));
        }
    }

    #[test]
    fn neighbouring_places_are_independent() {
        // Joint histogram of the first numbers of two neighbours, along each coordinate.
        let value = |p: [u64; 4]| {
            let [x, _] = unit_pair(at(at(at(mix(p[0]), p[1]), p[2]), p[3]));
            (x * 8.0) as usize
        };
        for axis in 0..4 {
            let mut bins = vec![0; 64];
            for i in 0..40_000_u64 {
                let place = [i % 7, i % 1021, i / 1021, i % 3];
                let mut next = place;
                next[axis] += 1;
                bins[value(place) * 8 + value(next)] += 1;
            }
            chi_squared::assert_fits(&bins, &[1.0 / 64.0; 64]);
        }
    }
}
