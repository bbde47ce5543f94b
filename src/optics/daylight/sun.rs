//! The sun's own light, outside the atmosphere and below it [Preetham99].

use std::f64::consts::PI;
use std::sync::OnceLock;

use super::air::{self, Air};
use crate::data::daylight;
use crate::math::{Spectrum, Table};
use crate::optics::colour;

/// Half the angle that the sun's disc fills at its mean distance.
pub const HALF_ANGLE: f64 = 0.00465;

/// The solid angle of a disc of a half angle: 2π (1 − cos), without the difference that rounds.
pub fn solid_angle(half_angle: f64) -> f64 {
    4.0 * PI * (0.5 * half_angle).sin().powi(2)
}

/// The sun's spectral radiance outside the atmosphere, in W/m²/sr/nm, every 10 nm from 380 to
/// 750 nm; the last value is held beyond, where eyes see little.
pub fn outside() -> &'static Table {
    static OUTSIDE: OnceLock<Table> = OnceLock::new();
    OUTSIDE.get_or_init(|| {
        let known = daylight::preetham_sun().iter().filter(|row| row[1] > 0.0);
        Table::new(known.map(|row| (row[0], row[1])).collect()).expect("wavelengths rise")
    })
}

/// Its mean spectral radiance below the atmosphere, in W/m²/sr/nm, from 380 to 780 nm every 5 nm.
/// Zero for a sun below the horizon.
pub fn spectrum(air: &Air, zenith: f64) -> Table {
    let mass = air::mass(zenith);
    let rows = daylight::preetham_sun();
    let absorption = [2, 3, 4].map(|column| {
        let column = rows.iter().map(|row| (row[0], row[column])).collect();
        Table::new(column).expect("wavelengths rise")
    });
    let at = |nm: f64| {
        if mass.is_infinite() {
            return 0.0;
        }
        let [ozone, water, gases] = [0, 1, 2].map(|i: usize| absorption[i].at(nm));
        outside().at(nm)
            * air::past_molecules(nm, mass)
            * air.past_aerosol(nm, mass)
            * air.past_ozone(ozone, mass)
            * air.past_water(water, mass)
            * air::past_gases(gases, mass)
    };
    let nodes = (0..=80).map(|i| 380.0 + 5.0 * f64::from(i));
    Table::new(nodes.map(|nm| (nm, at(nm))).collect()).expect("wavelengths rise")
}

/// Its mean radiance below the atmosphere as three channels, in W/m²/sr.
pub fn radiance(air: &Air, zenith: f64) -> [f64; 3] {
    channels(spectrum(air, zenith))
}

/// The irradiance it gives a surface square to it, as three channels, in W/m²: its radiance over
/// the whole of its disc.
pub fn irradiance(air: &Air, zenith: f64) -> [f64; 3] {
    radiance(air, zenith).map(|channel| channel * solid_angle(HALF_ANGLE))
}

/// The irradiance from a sun of a radiance, E = L A / (4 r²), by the round numbers of a first course:
/// a surface of 6.07e18 m² at 1.5e11 m. It is [`solid_angle`] in other words, 0.7 % less of it.
pub fn irradiance_by_area(radiance: f64) -> f64 {
    const AREA: f64 = 6.07e18;
    const DISTANCE: f64 = 1.5e11;
    radiance * AREA / (4.0 * DISTANCE * DISTANCE)
}

/// A spectrum in watts for each nm, as three channels in watts.
pub(super) fn channels(spectrum: Table) -> [f64; 3] {
    colour::emitted(&Spectrum::Table(spectrum)).map(|channel| channel * colour::eye_width())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Illuminance in klx on a surface square to the sun.
    fn klx(turbidity: f64, degrees: f64) -> f64 {
        let air = Air::of_turbidity(turbidity);
        0.683 * colour::luminance(irradiance(&air, degrees.to_radians()))
    }

    #[test]
    fn the_disc_is_of_its_true_size() {
        assert!((solid_angle(HALF_ANGLE) - 6.792896e-5).abs() < 1e-10);
        assert!((solid_angle(1e-9) / (PI * 1e-18) - 1.0).abs() < 1e-12);
        assert!((solid_angle(PI) - 4.0 * PI).abs() < 1e-12);
        assert!((irradiance_by_area(1.0) / solid_angle(HALF_ANGLE) - 0.9929).abs() < 2e-4);
    }

    #[test]
    fn the_sun_outside_the_atmosphere_is_as_bright_as_it_is_known_to_be() {
        let luminance = 683.0 * colour::luminance(channels(outside().clone()));
        assert!((luminance / 1.882e9 - 1.0).abs() < 2e-3, "{luminance}");
        let illuminance = luminance * solid_angle(HALF_ANGLE);
        assert!((illuminance / 128e3 - 1.0).abs() < 3e-3, "{illuminance}");
    }

    #[test]
    fn the_sun_below_it_is_weaker_the_more_air_there_is() {
        for (turbidity, degrees, expected) in [
            (2.0, 0.0, 101.8),
            (2.0, 60.0, 81.2),
            (2.0, 80.0, 36.1),
            (4.0, 0.0, 83.5),
            (4.0, 60.0, 54.8),
            (4.0, 80.0, 12.2),
        ] {
            let found = klx(turbidity, degrees);
            assert!((found / expected - 1.0).abs() < 5e-3, "{found} klx, not {expected}");
        }
    }

    #[test]
    fn the_sun_reddens_towards_the_horizon_and_ends_below_it() {
        let air = Air::of_turbidity(2.4);
        let redness = |degrees: f64| {
            let [red, _, blue] = radiance(&air, degrees.to_radians());
            red / blue
        };
        assert!(redness(0.0) < 1.4 && redness(60.0) > redness(0.0) && redness(85.0) > 5.0);
        let last = radiance(&air, std::f64::consts::FRAC_PI_2);
        assert!(last.iter().all(|c| c.is_finite() && *c >= 0.0) && last[0] > 0.0, "{last:?}");
        assert_eq!(radiance(&air, 1.6), [0.0; 3]);
    }
}
