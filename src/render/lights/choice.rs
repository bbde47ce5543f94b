//! Which light is asked, by how much it may give: the crowd of those that are somewhere, and each
//! of those that are infinitely far away.
//!
//! Half of the choice goes by irradiance: what the far ones give, and what the crowd as a whole may
//! give to the site. That is a rough estimate for the crowd, one member of which may be very near;
//! so the other half of the choice is even.

use glam::Vec3;

use super::crowd::Crowd;
use super::{Light, Site};

/// How lights are chosen.
#[derive(Clone, Debug, Default)]
pub(super) struct Choice {
    far: Vec<Far>,
    crowd: Option<Crowd>,
    /// Of each member of the crowd: its number among all lights.
    members: Vec<u32>,
    /// Of each light: where it is.
    places: Vec<Place>,
}

/// A light that is infinitely far away.
#[derive(Clone, Copy, Debug)]
struct Far {
    /// Among all lights.
    number: u32,
    /// About what it gives a surface that faces it, in light units.
    irradiance: f64,
    /// Where it is, if that is a single direction.
    to_light: Option<Vec3>,
}

#[derive(Clone, Copy, Debug)]
enum Place {
    Far(u32),
    Crowd(u32),
}

impl Choice {
    pub fn new(all: &[Light]) -> Self {
        let mut choice = Self::default();
        let mut emitters = Vec::new();
        for (number, light) in (0..).zip(all) {
            if let Some(emitter) = light.emitter() {
                choice.places.push(Place::Crowd(emitters.len() as u32));
                choice.members.push(number);
                emitters.push(emitter);
                continue;
            }
            choice.places.push(Place::Far(choice.far.len() as u32));
            let (irradiance, to_light) = match light {
                Light::Directional(sun) => {
                    (f64::from(sun.irradiance.luminance()), Some(sun.to_light))
                }
                Light::Surroundings(around) => (around.irradiance(), None),
                Light::Lamp(_) | Light::Point(_) | Light::Spot(_) => (0.0, None),
            };
            choice.far.push(Far { number, irradiance, to_light });
        }
        choice.crowd = Crowd::new(&emitters);
        choice
    }

    /// A light for a site, with its probability.
    pub fn choose(&self, site: &Site, u: f64) -> Option<(usize, f64)> {
        let shares = self.shares(site);
        let mut rest = u;
        let mut last = None;
        for far in &self.far {
            let part = shares.part(far.importance(site));
            if rest < part {
                return Some((far.number as usize, part));
            }
            rest -= part;
            last = (part > 0.0).then_some((far.number as usize, part)).or(last);
        }
        let part = shares.part(shares.crowd);
        match &self.crowd {
            Some(crowd) if part > 0.0 => {
                let within = (rest / part).clamp(0.0, 1.0 - f64::EPSILON);
                let chosen = crowd.choose(site, within)?;
                Some((self.members[chosen.number] as usize, part * chosen.pmf))
            }
            // Rounding has left a rest.
            _ => last,
        }
    }

    /// The probability of a light for a site.
    pub fn pmf(&self, site: &Site, light: usize) -> f64 {
        let shares = self.shares(site);
        match (self.places[light], &self.crowd) {
            (Place::Far(index), _) => shares.part(self.far[index as usize].importance(site)),
            (Place::Crowd(member), Some(crowd)) => {
                shares.part(shares.crowd) * crowd.pmf(site, member as usize)
            }
            (Place::Crowd(_), None) => 0.0,
        }
    }

    fn shares(&self, site: &Site) -> Shares {
        let crowd = self.crowd.as_ref().map_or(0.0, |crowd| crowd.importance(site));
        let all = self.far.iter().map(|far| far.importance(site)).chain([crowd]);
        let (mut irradiance, mut count) = (0.0, 0_u32);
        for importance in all.filter(|importance| *importance > 0.0) {
            irradiance += importance;
            count += 1;
        }
        Shares { count: f64::from(count), irradiance, crowd }
    }
}

/// What may give a site any light.
#[derive(Clone, Copy)]
struct Shares {
    count: f64,
    /// Of all together.
    irradiance: f64,
    /// Of the crowd.
    crowd: f64,
}

impl Shares {
    /// The probability of one of that importance.
    fn part(self, importance: f64) -> f64 {
        match importance > 0.0 {
            true if self.count == 1.0 => 1.0,
            true => 0.5 * importance / self.irradiance + 0.5 / self.count,
            false => 0.0,
        }
    }
}

impl Far {
    /// Its irradiance; 0 if it comes from behind the site.
    fn importance(&self, site: &Site) -> f64 {
        let behind = self.to_light.is_some_and(|to_light| site.normal.dot(to_light) < 0.0);
        if behind { 0.0 } else { self.irradiance }
    }
}
