//! The next four numbers of many streams at once, of which each gets those it would get alone.

use super::{LEADING, MOST_POINTS, Spread, Stream, sobol};
use crate::math::random;
use crate::render::lanes::{LANES, Row, by_processor, padded};

/// Four numbers for each lane.
pub struct Fours {
    count: usize,
    numbers: [Row<f64>; 4],
    wants: Wants,
    scrambles: Row<u32>,
}

/// What lanes want.
struct Wants {
    /// [`NOTHING`], [`HASHES`] or [`POINT`].
    kind: Row<u32>,
    /// The streams' own numbers, their rounds and dimensions.
    own: Row<u64>,
    round: Row<u64>,
    dimension: Row<u64>,
    /// Points of `sobol`.
    point: Row<u32>,
}

/// Nothing, or what is there already.
const NOTHING: u32 = 0;
/// Hashes, each by itself.
const HASHES: u32 = 1;
/// A point of `sobol`.
pub(super) const POINT: u32 = 2;

impl Default for Fours {
    fn default() -> Self {
        let wants = Wants {
            kind: [NOTHING; LANES],
            own: [0; LANES],
            round: [0; LANES],
            dimension: [0; LANES],
            point: [0; LANES],
        };
        Self { count: 0, numbers: [[0.0; LANES]; 4], wants, scrambles: [0; LANES] }
    }
}

impl Fours {
    /// Forgets them.
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// The next four of a stream are wanted, of [`LANES`] at most. Without a jump for those that are
    /// hashes: paths on their way together are far from the camera or near to it, as it happens.
    #[inline(always)]
    pub fn push(&mut self, stream: &mut Stream) {
        let (lane, wants) = (self.count, &mut self.wants);
        self.count += 1;
        let (round, index) = match stream.spread {
            Spread::None => (0, u32::MAX),
            Spread::Sobol { round, index } => (round, index),
            Spread::Strata(_) => {
                wants.kind[lane] = NOTHING;
                let numbers = stream.four();
                (0..4).for_each(|i| self.numbers[i][lane] = numbers[i]);
                return;
            }
        };
        let is_point = (stream.dimension < LEADING) & (u64::from(index) < MOST_POINTS);
        wants.kind[lane] = if is_point { POINT } else { HASHES };
        wants.own[lane] = stream.own;
        wants.round[lane] = round;
        wants.dimension[lane] = stream.dimension;
        wants.point[lane] = index;
        stream.dimension += 1;
    }

    /// Nothing is wanted for a lane.
    pub fn skip(&mut self) {
        self.wants.kind[self.count] = NOTHING;
        self.count += 1;
    }

    /// A stream leaves its next four out.
    pub fn pass(&mut self, stream: &mut Stream) {
        stream.dimension += 1;
        self.skip();
    }

    /// Finds those of all streams; to be called after the last.
    pub fn draw(&mut self) {
        let Self { count, numbers, wants, scrambles } = self;
        let kinds = &wants.kind[..*count];
        if kinds.contains(&HASHES) {
            hash_all(*count, wants, numbers);
        }
        if kinds.contains(&POINT) {
            scramble_all(*count, wants, scrambles);
            sobol::fours(*count, &wants.point, scrambles, &wants.kind, numbers);
        }
    }

    /// Those of a lane, uniform in [0, 1)⁴.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> [f64; 4] {
        let [a, b, c, d] = &self.numbers;
        [a[lane], b[lane], c[lane], d[lane]]
    }

    /// Those of all lanes.
    pub fn rows(&self) -> &[Row<f64>; 4] {
        &self.numbers
    }
}

by_processor! {
    /// [`super::Fan::four`] of hashes, where they are wanted.
    #[inline(never)]
    fn hash_all(count: usize, wants: &Wants, numbers: &mut [Row<f64>; 4]) {
        let [first, second, third, fourth] = numbers;
        for lane in 0..padded(count) {
            let bits = random::at(wants.own[lane], wants.dimension[lane]);
            let ([a, b], [c, d]) = (random::unit_pair(bits), random::unit_pair(random::mix(bits)));
            let wanted = wants.kind[lane] == HASHES;
            first[lane] = if wanted { a } else { first[lane] };
            second[lane] = if wanted { b } else { second[lane] };
            third[lane] = if wanted { c } else { third[lane] };
            fourth[lane] = if wanted { d } else { fourth[lane] };
        }
    }
}

by_processor! {
    /// The scrambles of the lanes' dimensions in their rounds.
    #[inline(never)]
    fn scramble_all(count: usize, wants: &Wants, scrambles: &mut Row<u32>) {
        let places = wants.round.iter().zip(&wants.dimension);
        for (scramble, (round, dimension)) in scrambles.iter_mut().zip(places).take(padded(count)) {
            *scramble = random::at(*round, *dimension) as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Sampler;
    use super::*;

    #[test]
    fn numbers_drawn_together_are_those_drawn_alone() {
        let samplers = [
            Sampler::Independent,
            Sampler::Stratified { grid: 3 },
            Sampler::Sobol { round: 64 },
            Sampler::Sobol { round: 65_536 },
        ];
        for sampler in samplers {
            for count in [1, 7, LANES] {
                let stream = |i| sampler.stream(7, i / 40, 60_000 + 7 * i);
                let mut alone: Vec<Stream> = (0..count as u64).map(stream).collect();
                // Some are ahead of others.
                alone.iter_mut().step_by(3).for_each(|stream| _ = stream.fan(1));
                let mut together = alone.clone();
                let mut fours = Fours::default();
                for _ in 0..LEADING + 2 {
                    fours.clear();
                    together.iter_mut().for_each(|stream| fours.push(stream));
                    fours.draw();
                    for (lane, stream) in alone.iter_mut().enumerate() {
                        assert_eq!(fours.at(lane), stream.four(), "{sampler:?} {lane}");
                    }
                }
            }
        }
    }
}
