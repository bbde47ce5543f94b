//! What a `preetham` light is worth: where its sun stands in the scene, how bright sun, sky and
//! ground are.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use crate::optics::colour;
use crate::optics::daylight::{Air, Sky, Sun, position, sun};
use crate::scene::{Preetham, SunForm};

/// Seconds of an hour.
const HOUR: f64 = 3600.0;

/// North may be so close to up, as a sine, and no closer: it would point nowhere on the ground.
const NOWHERE: f64 = 1e-6;

/// The daylight of a place at a time.
#[derive(Clone, Debug)]
pub struct Daylight {
    /// Where the sun stands.
    pub sun: Sun,
    /// Columns are east, north and up in the scene.
    pub place: DMat3,
    /// None where the sun is below the horizon: the model has no twilight.
    sky: Option<Sky>,
    /// The irradiance that the sun, if it is asked for, gives a surface square to it; W/m².
    sun_irradiance: [f64; 3],
    /// Radiance of the ground below the horizon, W/m²/sr.
    ground: [f64; 3],
}

impl Daylight {
    /// Of a light of the scene. None if its `north` points along its `up`.
    pub fn of(light: &Preetham) -> Option<Self> {
        let place = place(light)?;
        let day = light.day.0 as f64;
        let sun = Sun::at(light.latitude.0, day, solar_time(light));
        let sky = sun.is_up().then(|| Sky::new(light.turbidity.0, sun.zenith));
        let sun_irradiance = match light.sun.value {
            SunForm::NoSun(_) => [0.0; 3],
            _ => sun::irradiance(&Air::of_turbidity(light.turbidity.0), sun.zenith),
        };
        let mut day = Self { sun, place, sky, sun_irradiance, ground: [0.0; 3] };
        let albedo = colour::reflected(&light.ground.0);
        if albedo != [0.0; 3] {
            let level = day.level_irradiance();
            day.ground = std::array::from_fn(|i| albedo[i] * level[i] / PI);
        }
        Some(day)
    }

    /// Whether there is any light.
    pub fn shines(&self) -> bool {
        self.sky.is_some()
    }

    /// Towards the sun, in the scene.
    pub fn to_sun(&self) -> DVec3 {
        self.place * self.sun.direction()
    }

    /// The irradiance that the sun gives a surface square to it, as three channels in W/m²; zero
    /// if it is below the horizon, or not asked for.
    pub fn sun_irradiance(&self) -> [f64; 3] {
        self.sun_irradiance
    }

    /// The radiance of the sky in a direction of the place (east, north, up; of unit length, not
    /// below the horizon), as three channels in W/m²/sr.
    pub fn sky_radiance(&self, direction: DVec3) -> [f64; 3] {
        match &self.sky {
            Some(sky) => sky.radiance(direction.z, direction.dot(self.sun.direction())),
            None => [0.0; 3],
        }
    }

    /// The radiance of the ground below the horizon, likewise.
    pub fn ground_radiance(&self) -> [f64; 3] {
        self.ground
    }

    /// The irradiance on level ground, as three channels in W/m²: of the sky, and of the sun if it
    /// is asked for.
    pub fn level_irradiance(&self) -> [f64; 3] {
        let Some(sky) = &self.sky else { return [0.0; 3] };
        let of_sky = sky.irradiance(self.sun.zenith);
        let cos = self.sun.zenith.cos();
        std::array::from_fn(|i| of_sky[i] + self.sun_irradiance[i] * cos)
    }
}

/// Hours of solar time.
pub fn solar_time(light: &Preetham) -> f64 {
    let clock = light.time.0 / HOUR;
    match (&*light.longitude, &*light.zone) {
        (Some(longitude), Some(zone)) => {
            position::solar_time(clock, light.day.0 as f64, longitude.0, zone.0 / HOUR)
        }
        _ => clock,
    }
}

/// When a sun is above the horizon on a day.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SunHours {
    /// All day.
    Always,
    /// From one time to another, in hours of the light's own time; may go past midnight.
    Between(f64, f64),
    /// Not at all.
    Never,
}

/// When the sun of a light is up.
pub fn sun_hours(light: &Preetham) -> SunHours {
    let declination = position::declination(light.day.0 as f64);
    let cos = -light.latitude.0.tan() * declination.tan();
    if cos >= 1.0 {
        return SunHours::Never;
    }
    if cos <= -1.0 {
        return SunHours::Always;
    }
    let half = cos.acos() * 12.0 / PI;
    let noon = 12.0 - (solar_time(light) - light.time.0 / HOUR);
    SunHours::Between(noon - half, noon + half)
}

fn place(light: &Preetham) -> Option<DMat3> {
    let up = light.up.0;
    let level = light.north.0 - up * up.dot(light.north.0);
    if level.length() < NOWHERE {
        return None;
    }
    let north = level.normalize();
    Some(DMat3::from_cols(north.cross(up), north, up))
}
