//! Lights asked by many sites at once, of which each gets what it would get alone.

#[cfg(test)]
mod tests;

use std::ops::Range;

use glam::Vec3;

use super::choice::Choices;
use super::loops;
use super::sky::{Search, from_sky};
use super::views::Views;
use super::{Arrival, Light, Lights, Point, Ray, Sight, Site, Surroundings};
use crate::math::Rgb;
use crate::render::geometry::{Geometry, Sheet};
use crate::render::lanes::{LANES, Row, Rows, get, put};
use crate::render::samplers::Fours;

/// Points that ask for light.
pub struct Sites {
    count: usize,
    /// The first so many ask.
    asking: usize,
    position: Rows,
    error: Rows,
    ng: Rows,
    sheet: Row<Sheet>,
    normal: Rows,
}

/// Light that arrives at them if nothing is in its way, each from one light: as [`Arrival`]s; black
/// where none does.
#[derive(Default)]
pub struct Arrivals {
    found: Found,
    views: Views,
    /// Which light, and by which chance.
    choices: Choices,
    part: Box<Part>,
}

/// Those that ask one light, side by side.
#[derive(Default)]
struct Part {
    lanes: Vec<usize>,
    sites: Sites,
    numbers: Numbers,
    found: Found,
}

/// Numbers that choose a point of a light.
struct Numbers([Row<f64>; 2]);

/// Light that was found: the fields of [`Arrival`].
pub(super) struct Found {
    pub wi: Rows,
    pub irradiance: Rows,
    pub pdf_w: Row,
    origin: Rows,
    direction: Rows,
    t_max: Row,
    leaves: Row<Sheet>,
    reaches: Row<Sheet>,
    pub search: Search,
}

impl Default for Sites {
    fn default() -> Self {
        let rows = [[0.0; LANES]; 3];
        Self {
            count: 0,
            asking: 0,
            position: rows,
            error: rows,
            ng: rows,
            sheet: [Sheet::NONE; LANES],
            normal: rows,
        }
    }
}

impl Default for Numbers {
    fn default() -> Self {
        Self([[0.0; LANES]; 2])
    }
}

impl Default for Found {
    fn default() -> Self {
        let (row, rows) = ([0.0; LANES], [[0.0; LANES]; 3]);
        Self {
            wi: rows,
            irradiance: rows,
            pdf_w: row,
            origin: rows,
            direction: rows,
            t_max: row,
            leaves: [Sheet::NONE; LANES],
            reaches: [Sheet::NONE; LANES],
            search: Search::default(),
        }
    }
}

impl Sites {
    /// Forgets them.
    pub fn clear(&mut self) {
        self.count = 0;
        self.asking = 0;
    }

    /// One more; [`LANES`] at most.
    #[inline(always)]
    pub fn push(&mut self, site: &Site) {
        self.add(site);
        self.asking = self.count;
    }

    /// One more that does not ask, after all that do.
    #[inline(always)]
    pub fn add(&mut self, site: &Site) {
        let lane = self.count;
        put(&mut self.position, lane, site.point.position);
        put(&mut self.error, lane, site.point.error);
        put(&mut self.ng, lane, site.point.ng);
        self.sheet[lane] = site.point.sheet;
        put(&mut self.normal, lane, site.normal);
        self.count = lane + 1;
    }

    /// The lanes of those that ask.
    pub fn lanes(&self) -> Range<usize> {
        0..self.asking
    }

    /// Their normals, as sites have them.
    pub(super) fn normals(&self) -> &Rows {
        &self.normal
    }

    /// The normal of a lane.
    #[inline(always)]
    pub fn normal(&self, lane: usize) -> Vec3 {
        get(&self.normal, lane)
    }

    /// The point of a lane.
    #[inline(always)]
    pub fn point(&self, lane: usize) -> Point {
        let (position, error) = (get(&self.position, lane), get(&self.error, lane));
        Point { position, error, ng: get(&self.ng, lane), sheet: self.sheet[lane] }
    }

    #[inline(always)]
    pub(super) fn at(&self, lane: usize) -> Site {
        Site { point: self.point(lane), normal: self.normal(lane) }
    }
}

impl Arrivals {
    /// Where light comes from to the site of a lane: unit length.
    #[inline(always)]
    pub fn wi(&self, lane: usize) -> Vec3 {
        get(&self.found.wi, lane)
    }

    /// The irradiance; black: nothing arrives.
    #[inline(always)]
    pub fn irradiance(&self, lane: usize) -> Rgb {
        let [r, g, b] = get(&self.found.irradiance, lane).to_array();
        Rgb::new(r, g, b)
    }

    /// The density of its direction, and the probability of its light.
    #[inline(always)]
    pub fn density(&self, lane: usize) -> (f32, f32) {
        (self.found.pdf_w[lane], self.choices.pmf[lane])
    }

    /// The ray that meets what is in the way.
    #[inline(always)]
    pub fn shadow(&self, lane: usize) -> Ray {
        self.found.shadow(lane)
    }
}

impl Found {
    #[inline(always)]
    pub fn put(&mut self, lane: usize, arrival: &Arrival) {
        put(&mut self.wi, lane, arrival.wi);
        put(&mut self.irradiance, lane, Vec3::from_array(arrival.irradiance.to_array()));
        self.pdf_w[lane] = arrival.pdf_w;
        self.put_shadow(lane, &arrival.shadow);
    }

    #[inline(always)]
    pub fn put_shadow(&mut self, lane: usize, shadow: &Ray) {
        put(&mut self.origin, lane, shadow.origin);
        put(&mut self.direction, lane, shadow.direction);
        self.t_max[lane] = shadow.t_max;
        self.leaves[lane] = shadow.leaves;
        self.reaches[lane] = shadow.reaches;
    }

    #[inline(always)]
    fn put_or_black(&mut self, lane: usize, arrival: Option<&Arrival>) {
        match arrival {
            Some(arrival) => self.put(lane, arrival),
            None => put(&mut self.irradiance, lane, Vec3::ZERO),
        }
    }

    #[inline(always)]
    fn shadow(&self, lane: usize) -> Ray {
        Ray {
            origin: get(&self.origin, lane),
            direction: get(&self.direction, lane),
            t_max: self.t_max[lane],
            leaves: self.leaves[lane],
            reaches: self.reaches[lane],
        }
    }

    #[inline(always)]
    fn at(&self, lane: usize) -> Arrival {
        let [r, g, b] = get(&self.irradiance, lane).to_array();
        Arrival {
            wi: get(&self.wi, lane),
            irradiance: Rgb::new(r, g, b),
            pdf_w: self.pdf_w[lane],
            shadow: self.shadow(lane),
        }
    }
}

impl Lights {
    /// Whether a light takes numbers; or one that is chosen, by None.
    pub fn takes_numbers(&self, asked: Option<usize>) -> bool {
        let light = asked.and_then(|number| self.all.get(number));
        !matches!(light, Some(Light::Directional(_) | Light::Point(_) | Light::Spot(_)))
    }

    /// For each site that asks, light from one point of a light, by its four numbers: of the light
    /// that is asked, or by None of one that they choose.
    pub fn sample_all(
        &self,
        geometry: &Geometry,
        (sites, fours): (&Sites, &Fours),
        asked: Option<usize>,
        arrivals: &mut Arrivals,
    ) {
        let Arrivals { found, views, choices, part } = arrivals;
        let [u, v, choice, _] = fours.rows();
        let only = if self.all.len() == 1 { Some(0) } else { None };
        if let Some(light) = asked.or(only).and_then(|number| self.all.get(number)) {
            choices.pmf = [1.0; LANES];
            light.sample_all(geometry, sites, [u, v], (views, found));
            return;
        }
        self.choice.choose_all(sites, choice, choices);
        let mut done = [false; LANES];
        for lane in sites.lanes() {
            let number = choices.number[lane];
            if done[lane] {
                continue;
            }
            let Some(light) = self.all.get(number as usize) else {
                found.put_or_black(lane, None);
                continue;
            };
            if !light.has_loop() {
                let arrival = light.sample(geometry, &sites.at(lane), [u[lane], v[lane]]);
                found.put_or_black(lane, arrival.as_ref());
                continue;
            }
            part.lanes.clear();
            part.lanes
                .extend((lane..sites.asking).filter(|&other| choices.number[other] == number));
            part.sites.clear();
            for (nth, &lane) in part.lanes.iter().enumerate() {
                done[lane] = true;
                part.sites.push(&sites.at(lane));
                let Numbers([first, second]) = &mut part.numbers;
                (first[nth], second[nth]) = (u[lane], v[lane]);
            }
            let Numbers([u, v]) = &part.numbers;
            light.sample_all(geometry, &part.sites, [u, v], (views, &mut part.found));
            for (nth, &lane) in part.lanes.iter().enumerate() {
                found.put(lane, &part.found.at(nth));
            }
        }
    }
}

impl Light {
    /// Whether many sites ask it in a loop of vectors.
    fn has_loop(&self) -> bool {
        match self {
            Self::Directional(_) => true,
            Self::Lamp(lamp) => lamp.rectangle().is_some(),
            Self::Surroundings(around) => matches!(around.sight, Sight::Sky(_)),
            Self::Point(_) | Self::Spot(_) => false,
        }
    }

    /// [`Light::sample`] of many sites.
    fn sample_all(
        &self,
        geometry: &Geometry,
        sites: &Sites,
        u: [&Row<f64>; 2],
        (views, found): (&mut Views, &mut Found),
    ) {
        match self {
            Self::Directional(directional) => loops::from_direction(directional, sites, found),
            Self::Lamp(lamp) if let Some(rectangle) = lamp.rectangle() => {
                loops::from_rectangle(rectangle, lamp, sites, u, views, found);
            }
            Self::Surroundings(Surroundings { sight: Sight::Sky(sky), .. }) => {
                from_sky(sky, sites, u, found);
            }
            _ => {
                for lane in sites.lanes() {
                    let u = [u[0][lane], u[1][lane]];
                    let arrival = self.sample(geometry, &sites.at(lane), u);
                    found.put_or_black(lane, arrival.as_ref());
                }
            }
        }
    }
}
