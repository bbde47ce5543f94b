//! Russian roulette: paths are ended by chance, and those that go on are weighed up by it.

use crate::math::Rgb;

/// By what chance a path goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Roulette {
    /// It always does.
    Off,
    /// The mean of the channels of the surface's reflectance.
    Mean,
    /// The luminance of the surface's reflectance.
    Luminance,
    /// The largest channel of the throughput, at most 1.
    Throughput,
}

/// Between mirrors that give all light back no chance of these would ever end a path. From so many
/// surfaces on it is at most [`MOST`].
const LONG: u32 = 64;
const MOST: f32 = 0.99;

impl Roulette {
    /// The chance that a path goes on after `surfaces`. `reflectance` is what the last of them gave
    /// back, over the density of the direction; `throughput` what the path then has.
    pub fn survival(self, reflectance: Rgb, throughput: Rgb, surfaces: u32) -> f32 {
        let chance = match self {
            Self::Off => return 1.0,
            Self::Mean => reflectance.mean(),
            Self::Luminance => reflectance.luminance(),
            Self::Throughput => throughput.largest(),
        };
        let most = if surfaces < LONG { 1.0 } else { MOST };
        // A chance of nothing ends all.
        chance.min(most).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chances_are_chances() {
        let red = Rgb::new(0.9, 0.0, 0.0);
        let of = |roulette: Roulette| roulette.survival(red, red * 0.5, 3);
        assert_eq!(of(Roulette::Off), 1.0);
        assert!((of(Roulette::Mean) - 0.3).abs() < 1e-6);
        assert!((of(Roulette::Luminance) - 0.9 * 0.2126).abs() < 1e-6);
        assert_eq!(of(Roulette::Throughput), 0.45);
        let bright = Rgb::grey(7.0);
        for roulette in [Roulette::Mean, Roulette::Luminance, Roulette::Throughput] {
            assert_eq!(roulette.survival(bright, bright, 0), 1.0);
            assert_eq!(roulette.survival(bright, bright, LONG), MOST);
            assert_eq!(roulette.survival(Rgb::BLACK, Rgb::BLACK, 0), 0.0);
            let odd = roulette.survival(Rgb::grey(f32::NAN), Rgb::grey(f32::NAN), 0);
            assert!((0.0..=1.0).contains(&odd));
        }
    }
}
