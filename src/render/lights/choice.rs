//! Which light is asked, by how much it may give: the crowd of those that are somewhere, and each
//! of those that are infinitely far away.
//!
//! Half of the choice goes by irradiance: what the far ones give to a surface that faces so, and
//! what the crowd as a whole may give to the site. That is a rough estimate for the crowd, one member
//! of which may be very near; so the other half of the choice is even.
//!
//! The parts of the choice end at whole steps: four numbers that are spread evenly choose between two
//! lights as often as they should, not about as often.

use glam::{DVec3, Vec3};

use super::crowd::Crowd;
use super::{Light, Lights, Site, Sites};
use crate::render::lanes::{LANES, Row, by_processor, get, padded};

/// How lights are chosen.
#[derive(Clone, Debug, Default)]
pub(super) struct Choice {
    far: Vec<Far>,
    crowd: Option<Crowd>,
    /// Of each member of the crowd: its number among all lights.
    members: Vec<u32>,
    /// Of each light: where it is.
    places: Vec<Place>,
    /// Where a part of the choice ends is a multiple of one over this.
    steps: f64,
}

/// A light that is infinitely far away.
#[derive(Clone, Copy, Debug)]
struct Far {
    /// Among all lights.
    number: u32,
    gives: Gives,
}

/// About what a light that is infinitely far away gives to a surface that faces so: irradiance, in
/// light units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gives {
    /// Square to the brightest of it: what counts on no surface.
    pub most: f64,
    /// This much to a surface that faces any way, and this vector's part along its normal more.
    pub even: f64,
    pub towards: DVec3,
    /// And at least so much. 0: none at all, if the rest is not above.
    pub least: f64,
}

#[derive(Clone, Copy, Debug)]
enum Place {
    Far(u32),
    Crowd(u32),
}

impl Gives {
    /// The same to whatever faces any way.
    pub fn evenly(irradiance: f64) -> Self {
        Self { most: irradiance, even: irradiance, towards: DVec3::ZERO, least: 0.0 }
    }

    /// From this direction alone, or close to it: sides that are turned away further than by the
    /// sine `beyond` get nothing.
    pub fn from(to_light: Vec3, irradiance: f64, beyond: f64) -> Self {
        let towards = irradiance * to_light.as_dvec3();
        Self { most: irradiance, even: irradiance * beyond, towards, least: 0.0 }
    }

    #[inline(always)]
    fn to(&self, normal: Vec3) -> f64 {
        let facing = (self.even + self.towards.dot(normal.as_dvec3())).max(self.least);
        if normal == Vec3::ZERO { self.most } else { facing }
    }
}

impl Choice {
    pub fn new(all: &[Light]) -> Self {
        let mut choice = Self::default();
        let mut emitters = Vec::new();
        for (number, light) in (0..).zip(all) {
            let gives = match light {
                Light::Directional(sun) => sun.gives(),
                Light::Surroundings(around) => around.gives(),
                Light::Lamp(_) | Light::Point(_) | Light::Spot(_) => {
                    choice.places.push(Place::Crowd(emitters.len() as u32));
                    choice.members.push(number);
                    emitters.extend(light.emitter());
                    continue;
                }
            };
            choice.places.push(Place::Far(choice.far.len() as u32));
            choice.far.push(Far { number, gives });
        }
        choice.crowd = Crowd::new(&emitters);
        let parts = choice.far.len() + usize::from(choice.crowd.is_some());
        // No part is less than half of an even one: that is a whole step.
        choice.steps = 2.0 * parts.next_power_of_two() as f64;
        choice
    }

    /// A light for a site, with its probability.
    pub fn choose(&self, site: &Site, u: f64) -> Option<(usize, f64)> {
        let shares = self.shares(site);
        let mut cut = Cut::default();
        for far in &self.far {
            cut.take(far.number, shares.part(far.gives.to(site.normal)), self.steps, u);
        }
        if cut.pmf > 0.0 {
            return Some((cut.number as usize, cut.pmf));
        }
        let crowd = self.crowd.as_ref().filter(|_| shares.crowd > 0.0)?;
        let part = 1.0 - cut.from;
        let within = ((u - cut.from) / part).clamp(0.0, 1.0 - f64::EPSILON);
        let chosen = crowd.choose(site, within)?;
        Some((self.members[chosen.number] as usize, part * chosen.pmf))
    }

    /// Lights for many sites, by a number in [0, 1) of each.
    pub fn choose_all(&self, sites: &Sites, u: &Row<f64>, choices: &mut Choices) {
        if self.crowd.is_none() {
            choose_far(&self.far, self.steps, sites, u, choices);
            return;
        }
        for lane in sites.lanes() {
            let chosen = self.choose(&sites.at(lane), u[lane]);
            let (number, pmf) = chosen.unwrap_or((Lights::NONE as usize, 0.0));
            (choices.number[lane], choices.pmf[lane]) = (number as u32, pmf as f32);
        }
    }

    /// The probability of a light for a site.
    pub fn pmf(&self, site: &Site, light: usize) -> f64 {
        let shares = self.shares(site);
        let ends = |far: &[Far]| {
            let parts = far.iter().map(|far| shares.part(far.gives.to(site.normal)));
            end(parts.fold(0.0, |sum, part| sum + part), self.steps)
        };
        match (self.places[light], &self.crowd) {
            (Place::Far(index), _) => {
                let index = index as usize;
                ends(&self.far[..=index]) - ends(&self.far[..index])
            }
            (Place::Crowd(member), Some(crowd)) if shares.crowd > 0.0 => {
                (1.0 - ends(&self.far)) * crowd.pmf(site, member as usize)
            }
            (Place::Crowd(_), _) => 0.0,
        }
    }

    #[inline(always)]
    fn shares(&self, site: &Site) -> Shares {
        let crowd = self.crowd.as_ref().map_or(0.0, |crowd| crowd.importance(site));
        let mut shares = Shares { count: 0.0, irradiance: 0.0, crowd };
        shares.add(crowd);
        self.far.iter().for_each(|far| shares.add(far.gives.to(site.normal)));
        shares
    }
}

/// Lights that were chosen.
pub(super) struct Choices {
    /// [`Lights::NONE`] if none was.
    pub number: Row<u32>,
    pub pmf: Row,
    /// Of the way there.
    shares: [Row<f64>; 2],
    cuts: [Row<f64>; 2],
}

impl Default for Choices {
    fn default() -> Self {
        let row = [0.0; LANES];
        Self { number: [Lights::NONE; LANES], pmf: [0.0; LANES], shares: [row; 2], cuts: [row; 2] }
    }
}

by_processor! {
    /// [`Choice::choose`] for many sites, where all lights are far away.
    #[inline(never)]
    fn choose_far(far: &[Far], steps: f64, sites: &Sites, u: &Row<f64>, choices: &mut Choices) {
        let count = padded(sites.lanes().len());
        let Choices { number, pmf, shares: [counts, irradiance], cuts: [reached, from] } = choices;
        for lane in 0..count {
            (number[lane], pmf[lane]) = (Lights::NONE, 0.0);
            (counts[lane], irradiance[lane]) = (0.0, 0.0);
            (reached[lane], from[lane]) = (0.0, 0.0);
        }
        for one in far {
            for lane in 0..count {
                let (count, sum) = (counts[lane], irradiance[lane]);
                let mut shares = Shares { count, irradiance: sum, crowd: 0.0 };
                shares.add(one.gives.to(get(sites.normals(), lane)));
                (counts[lane], irradiance[lane]) = (shares.count, shares.irradiance);
            }
        }
        for one in far {
            for lane in 0..count {
                let (count, sum) = (counts[lane], irradiance[lane]);
                let shares = Shares { count, irradiance: sum, crowd: 0.0 };
                let mut cut = Cut {
                    reached: reached[lane],
                    from: from[lane],
                    number: number[lane],
                    pmf: f64::from(pmf[lane]),
                };
                let part = shares.part(one.gives.to(get(sites.normals(), lane)));
                cut.take(one.number, part, steps, u[lane]);
                (reached[lane], from[lane]) = (cut.reached, cut.from);
                (number[lane], pmf[lane]) = (cut.number, cut.pmf as f32);
            }
        }
    }
}

/// A number in [0, 1) on its way through the parts of the choice.
#[derive(Clone, Copy)]
struct Cut {
    /// Where the last part ends, about and in steps.
    reached: f64,
    from: f64,
    /// The light whose part has it, and the size of that; 0 if none has.
    number: u32,
    pmf: f64,
}

impl Default for Cut {
    fn default() -> Self {
        Self { reached: 0.0, from: 0.0, number: Lights::NONE, pmf: 0.0 }
    }
}

impl Cut {
    /// The next light, and about its part.
    #[inline(always)]
    fn take(&mut self, number: u32, part: f64, steps: f64, u: f64) {
        self.reached += part;
        let to = end(self.reached, steps);
        let has = (self.from <= u) & (u < to);
        self.number = if has { number } else { self.number };
        self.pmf = if has { to - self.from } else { self.pmf };
        self.from = to;
    }
}

/// Where the part ends that ends at about `reached`.
#[inline(always)]
fn end(reached: f64, steps: f64) -> f64 {
    f64::from((reached * steps + 0.5) as i32) / steps
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
    #[inline(always)]
    fn add(&mut self, irradiance: f64) {
        self.count += if irradiance > 0.0 { 1.0 } else { 0.0 };
        self.irradiance += irradiance.max(0.0);
    }

    /// The probability of one of that importance.
    #[inline(always)]
    fn part(self, importance: f64) -> f64 {
        let part = 0.5 * importance / self.irradiance + 0.5 / self.count;
        if importance > 0.0 { part } else { 0.0 }
    }
}
