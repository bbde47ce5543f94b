//! The next four numbers of many streams at once, of which each gets those it would get alone.

use super::{LEADING, MOST_POINTS, Spread, Stream, sobol};
use crate::math::random;
use crate::render::lanes::{LANES, Row};

/// Four numbers for each lane.
pub struct Fours {
    count: usize,
    numbers: [Row<f64>; 4],
    /// Points of `sobol` that are wanted, and their scrambles.
    points: Row<u32>,
    scrambles: Row<u32>,
    /// 1 where a lane wants one.
    wanted: Row<u32>,
    /// Whether any does.
    any: bool,
    /// The round and the dimension of the last scramble: most lanes share theirs.
    last: (u64, u64, u32),
}

impl Default for Fours {
    fn default() -> Self {
        Self {
            count: 0,
            numbers: [[0.0; LANES]; 4],
            points: [0; LANES],
            scrambles: [0; LANES],
            wanted: [0; LANES],
            any: false,
            last: (0, u64::MAX, 0),
        }
    }
}

impl Fours {
    /// Forgets them.
    pub fn clear(&mut self) {
        self.count = 0;
        self.any = false;
    }

    /// The next four of a stream are wanted, of [`LANES`] at most.
    #[inline(always)]
    pub fn push(&mut self, stream: &mut Stream) {
        let lane = self.count;
        self.count += 1;
        if let Spread::Sobol { round, index } = stream.spread
            && stream.dimension < LEADING
            && u64::from(index) < MOST_POINTS
        {
            let (last_round, last_dimension, mut scramble) = self.last;
            if (last_round, last_dimension) != (round, stream.dimension) {
                scramble = random::at(round, stream.dimension) as u32;
                self.last = (round, stream.dimension, scramble);
            }
            stream.dimension += 1;
            self.points[lane] = index;
            self.scrambles[lane] = scramble;
            self.wanted[lane] = 1;
            self.any = true;
            return;
        }
        self.wanted[lane] = 0;
        let numbers = stream.four();
        (0..4).for_each(|i| self.numbers[i][lane] = numbers[i]);
    }

    /// Nothing is wanted for a lane.
    pub fn skip(&mut self) {
        self.wanted[self.count] = 0;
        self.count += 1;
    }

    /// A stream leaves its next four out.
    pub fn pass(&mut self, stream: &mut Stream) {
        stream.dimension += 1;
        self.skip();
    }

    /// Finds those of all streams; to be called after the last.
    pub fn draw(&mut self) {
        if self.any {
            sobol::fours(
                self.count,
                &self.points,
                &self.scrambles,
                &self.wanted,
                &mut self.numbers,
            );
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
