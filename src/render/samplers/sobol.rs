//! Points of the Sobol sequence, scrambled as sobol_burley scrambles them [Burley20], for many lanes
//! at once. Their numbers are the crate's own, to the bit.

use std::sync::LazyLock;

use sobol_burley::parts;

use super::fours::POINT;
use crate::render::lanes::{LANES, Row, by_processor, padded};

/// Four numbers of a point, uniform in [0, 1)⁴: points of one scramble are spread evenly.
#[inline]
pub fn four(point: u32, scramble: u32) -> [f64; 4] {
    sobol_burley::sample_4d(point, 0, scramble).map(f64::from)
}

/// Bits of a point's number that count.
const BITS: usize = 16;

/// What each bit of a shuffled number, from the highest on, adds to the four coordinates.
static DIRECTIONS: LazyLock<[[u32; 4]; BITS]> = LazyLock::new(|| {
    let bit = |bit: u32| [0, 1, 2, 3].map(|axis| parts::sobol_rev(1 << (31 - bit), axis));
    std::array::from_fn(|nth| bit(nth as u32))
});

/// What a scramble is mixed with for the order of the points, and for each coordinate.
const ORDER: u32 = 0x79c6_8e4a;
const MIXER: u32 = 0x9c8f_2d3b;
const COORDINATES: [u32; 4] = [0x912f_69ba, 0x174f_18ab, 0x691e_72ca, 0xb40c_c1b8];

by_processor! {
    /// [`four`] of so many lanes, where a point is wanted; other numbers stay.
    pub fn fours(
        count: usize,
        points: &Row<u32>,
        scrambles: &Row<u32>,
        kinds: &Row<u32>,
        numbers: &mut [Row<f64>; 4],
    ) {
        // Two small loops: each becomes vectors. Sums stay in registers.
        let (count, directions) = (padded(count), &*DIRECTIONS);
        let mut sums = [[0; LANES]; 4];
        let [a, b, c, d] = &mut sums;
        for lane in 0..count {
            let order = parts::hash(scrambles[lane] ^ ORDER);
            let place = parts::owen_scramble_rev(points[lane].reverse_bits(), order) as i32;
            let (mut first, mut second, mut third, mut fourth) = (0, 0, 0, 0);
            for (bit, direction) in directions.iter().enumerate() {
                // All bits, if that one is set.
                let mask = ((place << bit) >> 31) as u32;
                first ^= direction[0] & mask;
                second ^= direction[1] & mask;
                third ^= direction[2] & mask;
                fourth ^= direction[3] & mask;
            }
            (a[lane], b[lane], c[lane], d[lane]) = (first, second, third, fourth);
        }
        for ((sums, mixer), numbers) in sums.iter().zip(COORDINATES).zip(numbers) {
            for lane in 0..count {
                let scramble = parts::hash(scrambles[lane].wrapping_mul(MIXER) ^ mixer);
                let bits = parts::owen_scramble_rev(sums[lane], scramble).reverse_bits();
                let number = f64::from(parts::u32_to_f32_norm(bits));
                numbers[lane] = if kinds[lane] == POINT { number } else { numbers[lane] };
            }
        }
    }
}
