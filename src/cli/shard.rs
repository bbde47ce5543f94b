//! Shards: a render cut into slices of its samples, whole blocks each, for several machines.

use serde::{Deserialize, Serialize};

use crate::diag::words::counted;

/// `--shard i/n`: one of so many slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    pub index: u64,
    /// Of so many.
    pub of: u64,
}

/// More parts than anybody has machines are a mistake.
const MOST: u64 = 1_000_000;

/// Of the command line.
pub fn parse(text: &str) -> Result<Shard, String> {
    let numbers = text.split_once('/').map(|(i, n)| (i.trim().parse(), n.trim().parse()));
    match numbers {
        Some((Ok(index), Ok(of))) if index >= 1 && index <= of && of <= MOST => {
            Ok(Shard { index, of })
        }
        Some((Ok(index), Ok(of))) if of > MOST || index <= of => {
            Err(format!("write 1/{MOST} to {MOST}/{MOST} at most, and count from 1"))
        }
        Some((Ok(index), Ok(of))) => Err(format!("there is no shard {index} of {of}")),
        _ => Err("write which of how many, such as `1/4` to `4/4`".to_string()),
    }
}

impl Shard {
    /// How the names of its files go on: `left.3-of-7.part`.
    pub fn suffix(&self, kind: &str) -> String {
        format!("{}-of-{}.{kind}", self.index, self.of)
    }

    /// Its samples of so many in blocks of so many.
    pub fn slice(self, samples: u64, block: u64) -> Result<Slice, String> {
        let Self { index, of } = self;
        let blocks = samples.div_ceil(block);
        if blocks < of {
            return Err(format!(
                "{} a pixel are {} of {block}, too few for {of} shards\n  ask for at least {} \
                 samples, or for {} at most",
                counted(samples, "sample"),
                counted(blocks, "block"),
                (of - 1) * block + 1,
                counted(blocks, "shard"),
            ));
        }
        let cut = |i: u64| (u128::from(blocks) * u128::from(i) / u128::from(of)) as u64 * block;
        let (first, end) = (cut(index - 1), cut(index).min(samples));
        Ok(Slice { index, of, samples, first, end })
    }
}

/// Samples of a shard, of each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Slice {
    /// Which shard, from 1.
    pub index: u64,
    /// Of so many.
    pub of: u64,
    /// Samples of all shards together.
    pub samples: u64,
    /// The first one.
    pub first: u64,
    /// One past the last.
    pub end: u64,
}

impl Slice {
    /// Whether its numbers agree: to be asked of what was read from a file.
    pub fn is_sound(&self) -> bool {
        let Self { index, of, samples, first, end } = *self;
        (1..=of).contains(&index) && of <= MOST && first < end && end <= samples
    }

    /// In words: "part 3 of 7, samples 384 to 575".
    pub fn told(&self) -> String {
        let Self { index, of, first, end, .. } = self;
        format!("part {index} of {of}, samples {first} to {}", end - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_are_whole_blocks_and_cover_everything_once() {
        for (samples, block, of) in [(1000, 64, 7), (64, 64, 1), (449, 64, 8), (1 << 32, 64, 9)] {
            let mut next = 0;
            for index in 1..=of {
                let slice = Shard { index, of }.slice(samples, block).unwrap();
                assert!(slice.is_sound(), "{slice:?}");
                assert_eq!((slice.first, slice.first % block), (next, 0));
                next = slice.end;
            }
            assert_eq!(next, samples);
        }
        let told = Shard { index: 1, of: 8 }.slice(448, 64).unwrap_err();
        assert_eq!(
            told,
            "448 samples a pixel are 7 blocks of 64, too few for 8 shards\n  \
             ask for at least 449 samples, or for 7 shards at most"
        );
    }

    #[test]
    fn shards_are_counted_from_one() {
        assert_eq!(parse("3/7"), Ok(Shard { index: 3, of: 7 }));
        for (text, words) in [
            ("0/7", "count from 1"),
            ("8/7", "there is no shard 8 of 7"),
            ("3", "such as `1/4`"),
            ("-1/4", "such as `1/4`"),
            ("1/2000000", "at most"),
        ] {
            assert!(parse(text).unwrap_err().contains(words), "{text}: {:?}", parse(text));
        }
    }
}
