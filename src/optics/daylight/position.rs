//! Where the sun stands [Preetham99, appendix A.6].
//!
//! The formulas are coarse: within 0.8° of the sun's true place in the sky, most of it by an
//! equation of time that is some minutes off, and without refraction.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

/// Where the sun stands in the sky of a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// From the zenith: 0 to π.
    pub zenith: f64,
    /// From north through east: 0 to 2π. 0 where the sun is in the zenith.
    pub azimuth: f64,
}

impl Sun {
    /// At a latitude (north is positive), on a day of the year (1 is the first of January) and at
    /// hours of solar time: at 12 the sun is highest.
    pub fn at(latitude: f64, day: f64, solar_time: f64) -> Self {
        let (sin_l, cos_l) = latitude.sin_cos();
        let (sin_d, cos_d) = declination(day).sin_cos();
        let (sin_h, cos_h) = (PI * (solar_time - 12.0) / 12.0).sin_cos();
        // As a vector: no quotient whose sign or quadrant could go wrong.
        let east = -cos_d * sin_h;
        let north = cos_l * sin_d - sin_l * cos_d * cos_h;
        let up = sin_l * sin_d + cos_l * cos_d * cos_h;
        let level = east.hypot(north);
        let azimuth = if level < 1e-12 { 0.0 } else { east.atan2(north).rem_euclid(TAU) };
        Self { zenith: level.atan2(up), azimuth }
    }

    /// Towards it: east, north, up; of unit length.
    pub fn direction(&self) -> DVec3 {
        let (sin, cos) = self.zenith.sin_cos();
        let (east, north) = self.azimuth.sin_cos();
        DVec3::new(sin * east, sin * north, cos)
    }

    /// Whether its centre is at the horizon or above.
    pub fn is_up(&self) -> bool {
        self.zenith <= FRAC_PI_2
    }
}

/// How far north of the equator the sun stands on a day of the year.
pub fn declination(day: f64) -> f64 {
    0.4093 * (TAU * (day - 81.0) / 368.0).sin()
}

/// Solar time in hours of a clock that is `zone` hours ahead of Greenwich, at a longitude (east is
/// positive).
pub fn solar_time(clock: f64, day: f64, longitude: f64, zone: f64) -> f64 {
    let equation = 0.170 * (2.0 * TAU * (day - 80.0) / 373.0).sin()
        - 0.129 * (TAU * (day - 8.0) / 355.0).sin();
    clock + equation + longitude * 12.0 / PI - zone
}

/// How much stronger the sun shines on a day of the year than at its mean distance: the square of
/// one distance by the other (Spencer's series) [Bird86, eq. 2].
pub fn distance_factor(day: f64) -> f64 {
    let angle = TAU * (day - 1.0) / 365.0;
    let (sin, cos) = angle.sin_cos();
    let (sin_2, cos_2) = (2.0 * angle).sin_cos();
    1.00011 + 0.034221 * cos + 0.00128 * sin + 0.000719 * cos_2 + 0.000077 * sin_2
}

#[cfg(test)]
mod tests {
    use super::*;

    fn civil(latitude: f64, longitude: f64, day: f64, clock: f64, zone: f64) -> [f64; 2] {
        let solar = solar_time(clock, day, longitude.to_radians(), zone);
        let sun = Sun::at(latitude.to_radians(), day, solar);
        [sun.zenith.to_degrees(), sun.azimuth.to_degrees()]
    }

    /// Golden (Colorado) on 17 October 2003, Aarhus on 21 June 2025: by the formulas, and as
    /// exact algorithms have it. Longitudes west and east, zones before and behind.
    #[test]
    fn the_sun_stands_where_it_is_known_to() {
        let golden = civil(39.742476, -105.1786, 290.0, 12.0 + 30.5 / 60.0, -7.0);
        let aarhus = civil(56.1629, 10.2039, 172.0, 14.0, 2.0);
        for (found, formula, truth) in [
            (golden, [50.516, 194.26], [50.1116, 194.3402]),
            (aarhus, [33.506, 196.52], [33.4987, 196.3338]),
        ] {
            for i in 0..2 {
                assert!((found[i] - formula[i]).abs() < 0.006, "{found:?}, not {formula:?}");
                assert!((found[i] - truth[i]).abs() < 0.8, "{found:?}, in truth {truth:?}");
            }
        }
    }

    /// The paper's quotient for the azimuth, with the plus that its formula wants: with a minus, as
    /// it is often copied, the sun of Golden would be 7° off.
    #[test]
    fn azimuths_are_those_of_the_formula_with_a_plus() {
        for (latitude, day, time) in
            [(0.97_f64, 255.0, 7.0), (0.6, 20.0, 15.5), (-0.7, 100.0, 10.0)]
        {
            let d = declination(day);
            let (sin_t, cos_t) = (PI * time / 12.0).sin_cos();
            let west = -d.cos() * sin_t;
            let north = latitude.cos() * d.sin() + latitude.sin() * d.cos() * cos_t;
            let expected = (-west).atan2(north).rem_euclid(TAU);
            let found = Sun::at(latitude, day, time).azimuth;
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    #[test]
    fn the_sun_rises_in_the_east_and_sets_in_the_west() {
        let at = |time| Sun::at(55.77_f64.to_radians(), 255.0, time);
        assert!(at(7.0).direction().x > 0.9 && at(17.0).direction().x < -0.9);
        assert!(at(12.0).direction().y < 0.0 && at(12.0).direction().x.abs() < 1e-12);
        assert!(at(7.0).is_up() && !at(4.0).is_up());
        // Noon is highest, by latitude and declination.
        let noon = 55.77_f64.to_radians() - declination(255.0);
        assert!((at(12.0).zenith - noon).abs() < 1e-12);
        // South of the equator it passes in the north; at a pole it circles.
        assert!(Sun::at(-0.6, 255.0, 12.0).direction().y > 0.0);
        let pole = |time| Sun::at(FRAC_PI_2, 172.0, time).zenith;
        assert!((pole(3.0) - pole(20.0)).abs() < 1e-12);
    }

    #[test]
    fn the_sun_is_closest_in_january() {
        assert!((distance_factor(3.0) - 1.0350).abs() < 2e-4, "{}", distance_factor(3.0));
        assert!((distance_factor(185.0) - 0.9666).abs() < 2e-4, "{}", distance_factor(185.0));
    }

    #[test]
    fn a_sun_in_the_zenith_has_an_azimuth_that_is_a_number() {
        let sun = Sun::at(declination(172.0), 172.0, 12.0);
        assert!(sun.zenith < 1e-7 && sun.azimuth.is_finite());
        assert!((sun.direction() - DVec3::Z).length() < 1e-7);
    }
}
