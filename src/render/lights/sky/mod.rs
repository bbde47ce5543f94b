//! A sky over level ground: a table of radiance by direction, sampled by what it gives to a surface
//! that faces so.
//!
//! The table lies over the square that [`warp::square_to_hemisphere`] bends into the sky, which
//! keeps areas: between its nodes radiance is bilinear.

mod guide;
mod search;

#[cfg(test)]
mod tests;

use std::f32::consts::{FRAC_1_PI, TAU};

use glam::{DVec3, Mat3, Vec2, Vec3, Vec4};

use super::choice::Gives;
use crate::math::{Rgb, random, warp};
use guide::{Cell, Guide, Guides};
pub(super) use search::{Search, from_sky};

/// Solid angle of half of all directions.
const HALF: f32 = TAU;

/// The light of a sky, and of ground below its horizon.
#[derive(Clone, Debug)]
pub struct Sky {
    /// From directions of the world to those of the place: east, north, up.
    to_place: Mat3,
    light: Table,
    /// Radiance below the horizon.
    ground: Rgb,
    /// Luminance, integrated over all directions.
    total: f32,
    gives: Gives,
    guides: Guides,
}

/// Radiance over the square of the sky.
#[derive(Clone, Debug)]
struct Table {
    /// Cells along a side.
    side: usize,
    /// At the corners of the cells, in light units, row by row; the fourth number is its luminance.
    nodes: Vec<Vec4>,
}

/// Where a direction chosen for a surface lies, before it is one.
#[derive(Clone, Copy)]
struct Chosen {
    /// If by the table.
    cell: Cell,
    /// If aside from it, the point of the square that the cosine to the normal, or the ground, is
    /// sampled by.
    aside: Vec2,
    by_table: bool,
}

impl Sky {
    /// A sky whose radiance, of a direction of the place, is `radiance` above the horizon and
    /// `ground` below. `to_place` turns directions of the world to it; `side` cells, 1 or more.
    /// Radiance is finite and not negative.
    pub fn new(to_place: Mat3, side: usize, radiance: impl Fn(Vec3) -> Rgb, ground: Rgb) -> Self {
        let light = Table::new(side, radiance);
        let guides = Guides::new(&light, ground);
        let (sum, sky) = light.sums();
        let below = f64::from(ground.luminance()) * f64::from(HALF);
        let total = sum + below;
        // Of light from all sides a surface gets a quarter, and half of what there is more of it on
        // its side than on the other: the first terms of a series whose next are small.
        let leaning = sky - DVec3::Z * (0.5 * below);
        let towards = 0.5 * (to_place.transpose().as_dmat3() * leaning);
        let even = 0.25 * total;
        let gives = Gives { most: total, even, towards, least: total / 64.0 };
        Self { to_place, light, ground, total: total as f32, gives, guides }
    }

    /// About the irradiance it gives.
    pub(super) fn gives(&self) -> Gives {
        self.gives
    }

    /// Luminance, integrated over all directions, in light units times sr.
    pub fn total(&self) -> f32 {
        self.total
    }

    /// Radiance from a direction of the world.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        let local = self.to_place * direction;
        self.seen(local.z, square_of(local))
    }

    /// Radiance from a place of the square, or from the ground if it is below the horizon.
    #[inline(always)]
    fn seen(&self, up: f32, square: Vec2) -> Rgb {
        if up < 0.0 { self.ground } else { self.light.at(square) }
    }

    /// A direction, with the radiance from there and its density in solid angle: about by what it
    /// gives to a surface of this normal, by luminance if that is zero. None of a black sky.
    pub(super) fn sample(&self, normal: Vec3, u: [f64; 2]) -> Option<(Vec3, Rgb, f32)> {
        if self.total <= 0.0 {
            return None;
        }
        let guide = self.guides.of(Guides::facing(self.to_place * normal));
        let u = [random::unit_f32(u[0]), random::unit_f32(u[1])];
        let wi = self.direction(normal, &guide.choose(u));
        let local = self.to_place * wi;
        let square = square_of(local);
        let density = self.density(normal, (wi, local.z), guide, square);
        Some((wi, self.seen(local.z, square), density))
    }

    /// The density in solid angle with which `sample` gives a direction.
    pub(super) fn pdf_w(&self, normal: Vec3, direction: Vec3) -> f32 {
        self.met(normal, direction).1
    }

    /// Radiance from a direction of the world, and that density.
    pub(super) fn met(&self, normal: Vec3, direction: Vec3) -> (Rgb, f32) {
        if self.total <= 0.0 {
            return (Rgb::BLACK, 0.0);
        }
        let guide = self.guides.of(Guides::facing(self.to_place * normal));
        let local = self.to_place * direction;
        let square = square_of(local);
        let density = self.density(normal, (direction, local.z), guide, square);
        (self.seen(local.z, square), density)
    }

    /// The direction that was chosen.
    #[inline(always)]
    fn direction(&self, normal: Vec3, chosen: &Chosen) -> Vec3 {
        let from_place = self.to_place.transpose();
        let by_table = warp::square_to_hemisphere(chosen.cell.point());
        let is_free = normal == Vec3::ZERO;
        // Any axis will do where there is no normal.
        let axis = if is_free { Vec3::Z } else { normal };
        let by_cosine = warp::about(axis, warp::square_to_cosine(chosen.aside));
        let below = -warp::square_to_hemisphere(chosen.aside);
        let local = if chosen.by_table { by_table } else { below };
        let wi = from_place * local;
        if chosen.by_table | is_free { wi } else { by_cosine }
    }

    #[inline(always)]
    fn density(&self, normal: Vec3, (wi, up): (Vec3, f32), guide: &Guide, square: Vec2) -> f32 {
        mix(normal, (wi, up), guide.part, guide.density(square))
    }
}

/// The density of a direction, of which this `part` is chosen by the table, with that density.
#[inline(always)]
fn mix(normal: Vec3, (wi, up): (Vec3, f32), part: f32, by_table: f32) -> f32 {
    let by_cosine = FRAC_1_PI * normal.dot(wi).max(0.0);
    let below = if up < 0.0 { 1.0 / HALF } else { 0.0 };
    let aside = if normal == Vec3::ZERO { below } else { by_cosine };
    let by_table = if up < 0.0 { 0.0 } else { by_table };
    part * by_table + (1.0 - part) * aside
}

/// Where a direction of the place lies on the square of the sky; if it is above the horizon.
#[inline(always)]
fn square_of(local: Vec3) -> Vec2 {
    warp::hemisphere_to_square(Vec3::new(local.x, local.y, local.z.max(0.0)))
}

/// A cell of a square grid of so many a side, and where in it a point lies.
#[inline(always)]
fn on_grid(square: Vec2, side: usize) -> ([usize; 2], Vec2) {
    let at = square * side as f32;
    let cell = |x: f32| (x as usize).min(side - 1);
    let (column, row) = (cell(at.x), cell(at.y));
    ([column, row], at - Vec2::new(column as f32, row as f32))
}

impl Table {
    fn new(side: usize, radiance: impl Fn(Vec3) -> Rgb) -> Self {
        let at = |i: usize| i as f32 / side as f32;
        let corners = (0..=side).flat_map(|y| (0..=side).map(move |x| Vec2::new(at(x), at(y))));
        let node = |u| {
            let light = radiance(warp::square_to_hemisphere(u));
            let [r, g, b] = light.to_array();
            Vec4::new(r, g, b, light.luminance())
        };
        Self { side, nodes: corners.map(node).collect() }
    }

    /// Radiance at a place of the square.
    #[inline(always)]
    fn at(&self, square: Vec2) -> Rgb {
        let [r, g, b, _] = self.between(square).to_array();
        Rgb::new(r, g, b)
    }

    #[inline(always)]
    fn between(&self, square: Vec2) -> Vec4 {
        let ([column, row], within) = on_grid(square, self.side);
        let first = row * (self.side + 1) + column;
        let next = first + self.side + 1;
        // Not by `map`: that is a call.
        let above = self.nodes[first] * (1.0 - within.x) + self.nodes[first + 1] * within.x;
        let below = self.nodes[next] * (1.0 - within.x) + self.nodes[next + 1] * within.x;
        above * (1.0 - within.y) + below * within.y
    }

    /// Luminance integrated over the sky, and its direction likewise.
    fn sums(&self) -> (f64, DVec3) {
        let (mut sum, mut leaning) = (0.0, DVec3::ZERO);
        let middle = |i: usize| (i as f32 + 0.5) / self.side as f32;
        for (row, column) in (0..self.side).flat_map(|y| (0..self.side).map(move |x| (y, x))) {
            // Of what is bilinear, the middle is the mean.
            let square = Vec2::new(middle(column), middle(row));
            let luminance = f64::from(self.between(square).w);
            sum += luminance;
            leaning += luminance * warp::square_to_hemisphere(square).as_dvec3();
        }
        let cell = f64::from(HALF) / (self.side * self.side) as f64;
        (cell * sum, cell * leaning)
    }
}
