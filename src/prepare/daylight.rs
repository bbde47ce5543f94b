//! `preetham` lights → a sky and a sun of the world, in light units.

use std::sync::Arc;

use glam::DVec3;

use super::errors::scene as errors;
use super::materials::as_f32;
use crate::diag::Diagnostic;
use crate::plan::daylight::{self, Daylight};
use crate::render::lights::{Directional, Disc, Sight, Sky};
use crate::scene::{Light, Named, Preetham, Scene, SunForm};

/// Cells along a side of a sky's table, half a degree wide or less: between its nodes a sky is
/// within 1 % of the model, and what it gives level ground within 1e-4.
const SIDE: usize = 256;

/// A sky and its sun, before they are tables.
pub(super) struct Day {
    light: Preetham,
    /// None where it was refused.
    worth: Option<Daylight>,
}

/// The `preetham` lights of a scene, without those that stand nowhere.
fn skies(scene: &Scene) -> impl Iterator<Item = (&Named<Light>, &Preetham)> {
    scene.lights.iter().filter_map(|light| match &light.value.value {
        Light::Preetham(sky) => Some((light, sky)),
        _ => None,
    })
}

/// What skies have that is wrong, or that may not be meant.
pub(super) fn check(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for (light, sky) in skies(scene) {
        match (&*sky.longitude, &*sky.zone) {
            (Some(_), None) => found.push(errors::half_a_clock("longitude", sky.longitude.span)),
            (None, Some(_)) => found.push(errors::half_a_clock("zone", sky.zone.span)),
            _ => {}
        }
        match Daylight::of(sky) {
            None => found.push(errors::north_is_up(sky.north.span, sky.up.span)),
            Some(day) if !day.shines() => {
                let below = day.sun.zenith.to_degrees() - 90.0;
                let hours = daylight::sun_hours(sky);
                found.push(errors::night(&light.name, sky.time.span, below, hours));
            }
            Some(_) => {}
        }
    }
}

/// The `preetham` lights of a scene.
pub(super) fn days(scene: &Scene) -> Vec<Day> {
    skies(scene).map(|(_, sky)| Day { light: sky.clone(), worth: Daylight::of(sky) }).collect()
}

/// The brightest that is seen of a sky or gets from it: its largest channel, in W/m²/sr or W/m².
pub(super) fn brightest(sky: &Preetham) -> f64 {
    let Some(day) = Daylight::of(sky) else { return 0.0 };
    let all = [day.level_irradiance(), day.sun_irradiance()];
    all.into_iter().flatten().fold(0.0, f64::max)
}

impl Day {
    /// Whether it shines on surfaces by its sun, and by its sky if that is asked for. Where it does
    /// not for another reason, at night, that was told: it counts as one that shines.
    pub fn shines(&self, by_sky: bool) -> bool {
        let dark = |day: &Daylight| day.shines() && day.sun_irradiance() == [0.0; 3];
        by_sky || !self.worth.as_ref().is_some_and(dark)
    }

    /// The sun, as a direction or as what is seen of it; None if there is none.
    pub fn sun(&self, light_unit: f64) -> Option<Sun> {
        let worth = self.worth.as_ref()?;
        let irradiance = worth.sun_irradiance();
        if irradiance == [0.0; 3] {
            return None;
        }
        let irradiance = as_f32(irradiance.map(|channel| channel / light_unit));
        let towards = worth.to_sun().as_vec3();
        match &self.light.sun.value {
            SunForm::SunDisc(disc) => {
                Some(Sun::Disc(Sight::Disc(Disc::new(towards, disc.half_angle.0, irradiance))))
            }
            SunForm::SunDirection(_) => {
                Some(Sun::Direction(Directional { to_light: towards, irradiance }))
            }
            SunForm::NoSun(_) => None,
        }
    }

    /// The sky; None at night.
    pub fn sky(&self, light_unit: f64) -> Option<Sight> {
        let worth = self.worth.as_ref().filter(|day| day.shines())?;
        let units = |radiance: [f64; 3]| as_f32(radiance.map(|channel| channel / light_unit));
        let to_place = worth.place.transpose().as_mat3();
        let radiance = |direction: glam::Vec3| {
            let direction = DVec3::from(direction).normalize();
            units(worth.sky_radiance(direction))
        };
        let sky = Sky::new(to_place, SIDE, radiance, units(worth.ground_radiance()));
        Some(Sight::Sky(Arc::new(sky)))
    }
}

/// A sun of the world.
pub(super) enum Sun {
    /// As a disc, which is seen.
    Disc(Sight),
    /// As a direction.
    Direction(Directional),
}
