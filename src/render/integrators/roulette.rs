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
/// surfaces on, what has met n goes on with a chance of (n / (n + 1))² at most: (LONG / n)² of all
/// paths come to the n-th, and weigh n²/LONG² times as much. So they come to an end, some LONG
/// surfaces later on average; and the variance stays finite among surfaces that take anything away,
/// however little. (A fixed chance q would not do: where more than √q is given back, weights grow
/// faster than paths become few, and pictures are too dark but for rare fireflies.)
const LONG: u32 = 256;

/// Stands for the largest chance of a path that is not to be ended.
pub const SAFE: f32 = f32::INFINITY;

/// The largest chance to go on after so many surfaces.
#[inline]
pub fn most(surfaces: u32) -> f32 {
    if surfaces < LONG {
        return 1.0;
    }
    let surfaces = f64::from(surfaces);
    (surfaces / (surfaces + 1.0)).powi(2) as f32
}

impl Roulette {
    /// The chance that a path goes on, at most `limit`. `reflectance` is what the last surface gave
    /// back, over the density of the direction; `throughput` what the path then has.
    #[inline(always)]
    pub fn survival(self, reflectance: Rgb, throughput: Rgb, limit: f32) -> f32 {
        let chance = match self {
            Self::Off => return 1.0,
            Self::Mean => reflectance.mean(),
            Self::Luminance => reflectance.luminance(),
            Self::Throughput => throughput.largest(),
        };
        // A chance of nothing ends all.
        let chance = chance.min(limit).max(0.0);
        if limit == SAFE { 1.0 } else { chance }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_long_paths_ever_fewer_go_on_and_the_variance_stays_finite() {
        // As many as come to the n-th surface, and their weight.
        let (mut alive, mut surfaces) = (1.0, 0.0);
        let of = |n: u32| f64::from(Roulette::Throughput.survival(Rgb::ONE, Rgb::ONE, most(n)));
        for n in 0..100_000 {
            surfaces += alive;
            alive *= of(n);
            let bound = (f64::from(LONG) / f64::from(n + 1)).powi(2).min(1.0);
            assert!((alive / bound - 1.0).abs() < 1e-3, "{n}: {alive}");
        }
        assert!((surfaces / f64::from(2 * LONG) - 1.0).abs() < 0.01, "{surfaces}");
    }

    #[test]
    fn chances_are_chances() {
        let red = Rgb::new(0.9, 0.0, 0.0);
        let of = |roulette: Roulette| roulette.survival(red, red * 0.5, most(3));
        assert_eq!(of(Roulette::Off), 1.0);
        assert!((of(Roulette::Mean) - 0.3).abs() < 1e-6);
        assert!((of(Roulette::Luminance) - 0.9 * 0.2126).abs() < 1e-6);
        assert_eq!(of(Roulette::Throughput), 0.45);
        let bright = Rgb::grey(7.0);
        for roulette in [Roulette::Mean, Roulette::Luminance, Roulette::Throughput] {
            assert_eq!(roulette.survival(bright, bright, most(0)), 1.0);
            assert!(roulette.survival(bright, bright, most(LONG)) < 1.0);
            assert_eq!(roulette.survival(Rgb::BLACK, Rgb::BLACK, most(0)), 0.0);
            assert_eq!(roulette.survival(Rgb::BLACK, Rgb::BLACK, SAFE), 1.0);
            let odd = roulette.survival(Rgb::grey(f32::NAN), Rgb::grey(f32::NAN), most(0));
            assert!((0.0..=1.0).contains(&odd));
        }
    }
}
