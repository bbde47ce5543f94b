//! The clear sky of [Preetham99]: luminance and colour of every direction above the horizon, as
//! Perez's formula fits them to simulations of air.
//!
//! Outside [`TURBIDITIES`](super::TURBIDITIES) the formula has negative luminances and poles; what
//! is known against it inside stands in [Zotti07].

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use crate::data::daylight;
use crate::optics::colour;

/// A sky above the horizon.
#[derive(Clone, Debug)]
pub struct Sky {
    /// Luminance in cd/m², and the chromaticities x and y; likewise below.
    parts: [Part; 3],
}

/// A quantity spread over the sky: (1 + A e^(B/cos θ)) (1 + C e^(Dγ) + E cos² γ) times a constant,
/// which gives the zenith what it has.
#[derive(Clone, Copy, Debug)]
struct Part {
    constant: f64,
    perez: [f64; 5],
}

impl Part {
    /// θ from the zenith, γ from the sun.
    fn at(&self, cos_zenith: f64, cos_sun: f64) -> f64 {
        let [a, b, c, d, e] = self.perez;
        // B is negative for every turbidity allowed: at the horizon the exponential is zero.
        let level = 1.0 + a * (b / cos_zenith).exp();
        let around = 1.0 + c * (d * cos_sun.acos()).exp() + e * cos_sun * cos_sun;
        self.constant * level * around
    }
}

impl Sky {
    /// The sky of a turbidity within [`TURBIDITIES`](super::TURBIDITIES), and of a sun that is up:
    /// its zenith angle is 0 to π/2.
    pub fn new(turbidity: f64, sun_zenith: f64) -> Self {
        debug_assert!(super::TURBIDITIES.contains(&turbidity), "turbidity {turbidity}");
        debug_assert!((0.0..=FRAC_PI_2).contains(&sun_zenith), "zenith angle {sun_zenith}");
        let zenith = at_zenith(turbidity, sun_zenith);
        let tables = [daylight::LUMINANCE, daylight::CHROMATICITY_X, daylight::CHROMATICITY_Y];
        let part = |i: usize| {
            let perez = tables[i].map(|[slope, offset]| slope * turbidity + offset);
            let relative = Part { constant: 1.0, perez };
            Part { constant: zenith[i] / relative.at(1.0, sun_zenith.cos()), perez }
        };
        Self { parts: [0, 1, 2].map(part) }
    }

    /// Luminance in cd/m², and chromaticities x and y, by the cosines of the angles from the zenith
    /// (0 at the horizon to 1) and from the sun (−1 to 1).
    pub fn luminance_and_chromaticity(&self, cos_zenith: f64, cos_sun: f64) -> [f64; 3] {
        let (cos_zenith, cos_sun) = (cos_zenith.clamp(0.0, 1.0), cos_sun.clamp(-1.0, 1.0));
        self.parts.map(|part| part.at(cos_zenith, cos_sun))
    }

    /// The same as three channels, in W/m²/sr. A colour more saturated than sRGB keeps its
    /// luminance.
    pub fn radiance(&self, cos_zenith: f64, cos_sun: f64) -> [f64; 3] {
        let [luminance, x, y] = self.luminance_and_chromaticity(cos_zenith, cos_sun);
        colour::of_chromaticity(luminance / colour::LUMENS_A_WATT, x, y)
    }

    /// The irradiance it gives level ground, with the sun at a zenith angle, as three channels, in
    /// W/m²: without the sun's own. Good to 1e-4.
    pub fn irradiance(&self, sun_zenith: f64) -> [f64; 3] {
        // The midpoint rule over cos² of the zenith angle and half the turn from the sun's side.
        const LEVELS: u32 = 256;
        const TURNS: u32 = 64;
        let sun = DVec3::new(sun_zenith.sin(), 0.0, sun_zenith.cos());
        let mut sum = [0.0; 3];
        for level in 0..LEVELS {
            let cos = ((f64::from(level) + 0.5) / f64::from(LEVELS)).sqrt();
            let sin = (1.0 - cos * cos).sqrt();
            for turn in 0..TURNS {
                let azimuth = PI * (f64::from(turn) + 0.5) / f64::from(TURNS);
                let direction = DVec3::new(sin * azimuth.cos(), sin * azimuth.sin(), cos);
                let radiance = self.radiance(cos, direction.dot(sun));
                (0..3).for_each(|i| sum[i] += radiance[i]);
            }
        }
        // cos dω is half of d(cos²) dφ.
        sum.map(|sum| sum * TAU / 2.0 / f64::from(LEVELS * TURNS))
    }
}

/// Luminance in cd/m² and chromaticities x, y at the zenith.
fn at_zenith(turbidity: f64, sun: f64) -> [f64; 3] {
    let [a, b, c, d] = daylight::ZENITH_LUMINANCE;
    let chi = (4.0 / 9.0 - turbidity / 120.0) * (PI - 2.0 * sun);
    let luminance = 1000.0 * ((a * turbidity + b) * chi.tan() + c * turbidity + d);
    let chromaticity = |rows: [[f64; 4]; 3]| {
        let row = |row: [f64; 4]| row.into_iter().fold(0.0, |sum, term| sum * sun + term);
        rows.map(row).into_iter().fold(0.0, |sum, term| sum * turbidity + term)
    };
    [luminance, chromaticity(daylight::ZENITH_X), chromaticity(daylight::ZENITH_Y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: [f64; 3], expected: [f64; 3], most: f64) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < most, "{found}, not {expected}");
        }
    }

    /// In kcd/m².
    fn seen(turbidity: f64, sun: f64, zenith: f64, turn: f64) -> [f64; 3] {
        let [sun, zenith, turn] = [sun, zenith, turn].map(f64::to_radians);
        let cos_sun = sun.cos() * zenith.cos() + sun.sin() * zenith.sin() * turn.cos();
        let [y, rest @ ..] =
            Sky::new(turbidity, sun).luminance_and_chromaticity(zenith.cos(), cos_sun);
        [y / 1000.0, rest[0], rest[1]]
    }

    #[test]
    fn zeniths_are_as_bright_and_blue_as_known() {
        for (turbidity, sun, expected) in [
            (2.0, 0.0, [15.5007, 0.26674, 0.27720]),
            (2.0, 45.0, [4.46964, 0.24095, 0.24372]),
            (2.0, 75.0, [2.69886, 0.24966, 0.25935]),
            (3.0, 60.0, [5.13916, 0.24493, 0.25257]),
            (6.0, 30.0, [22.0667, 0.26313, 0.27599]),
            (10.0, 85.0, [2.50345, 0.31068, 0.33744]),
        ] {
            near(seen(turbidity, sun, 0.0, 0.0), expected, 1e-4);
        }
    }

    #[test]
    fn other_directions_are_as_bright_and_blue_as_known() {
        near(seen(3.0, 60.0, 60.0, 180.0), [5.23311, 0.24932, 0.26498], 1e-4);
        near(seen(6.0, 30.0, 75.0, 45.0), [14.92808, 0.30673, 0.32407], 1e-4);
    }

    #[test]
    fn level_ground_is_lit_as_known() {
        for (turbidity, sun, klx) in
            [(2.0, 45.0, 25.1643), (3.0, 60.0, 24.0041), (6.0, 30.0, 56.0743)]
        {
            let sun = f64::to_radians(sun);
            let irradiance = Sky::new(turbidity, sun).irradiance(sun);
            let found = 0.683 * colour::luminance(irradiance);
            assert!((found / klx - 1.0).abs() < 1e-3, "{found} klx, not {klx}");
        }
    }

    /// Every turbidity allowed, sun and direction, the horizon among them: positive, and a colour.
    #[test]
    fn nothing_of_the_sky_is_dark_or_endless() {
        for tenths in 17..=100 {
            for sun in (0..=90).step_by(6).map(|degrees| f64::from(degrees).to_radians()) {
                let sky = Sky::new(f64::from(tenths) / 10.0, sun.min(FRAC_PI_2));
                for cos in [0.0, 1e-300, 1e-3, 0.05, 0.3, 0.7, 1.0] {
                    let sin = f64::sqrt(1.0 - cos * cos);
                    for turn in 0..8 {
                        let turn = f64::from(turn) * PI / 7.0;
                        let cos_sun = sun.cos() * cos + sun.sin() * sin * turn.cos();
                        let [y, cx, cy] = sky.luminance_and_chromaticity(cos, cos_sun);
                        assert!(y > 0.0 && y < 5e6, "{tenths} {sun} {cos}: {y}");
                        assert!(cx > 0.0 && cy > 0.0 && cx + cy < 1.0, "{cx} {cy}");
                        assert!(sky.radiance(cos, cos_sun).iter().all(|c| *c >= 0.0));
                    }
                }
            }
        }
    }
}
