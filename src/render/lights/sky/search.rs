//! A sky asked by many surfaces at once, of which each gets what it would get alone.

use glam::{Vec2, Vec3};

use super::super::together::{Found, Sites};
use super::guide::{Cell, Guides};
use super::{Chosen, Sky, mix, square_of};
use crate::math::random;
use crate::render::lanes::{LANES, Row, Rows, by_processor, get, padded, put};

/// What is known on the way to a direction.
#[derive(Clone)]
pub(in super::super) struct Search {
    facing: Row<u32>,
    /// As in [`Cell`] and [`Chosen`].
    corner: [Row; 2],
    parts: [Row; 2],
    corners: [Row; 4],
    aside: [Row; 2],
    by_table: Row<u32>,
    /// Height of the direction above the horizon, and its place on the square.
    up: Row,
    square: [Row; 2],
    /// The part that goes by the table, and the table's density.
    part: Row,
    density: Row,
    radiance: Rows,
}

impl Default for Search {
    fn default() -> Self {
        let row = [0.0; LANES];
        Self {
            facing: [0; LANES],
            corner: [row; 2],
            parts: [row; 2],
            corners: [row; 4],
            aside: [row; 2],
            by_table: [0; LANES],
            up: row,
            square: [row; 2],
            part: row,
            density: row,
            radiance: [row; 3],
        }
    }
}

impl Search {
    #[inline(always)]
    fn put(&mut self, lane: usize, Chosen { cell, aside, by_table }: &Chosen) {
        [self.corner[0][lane], self.corner[1][lane]] = [cell.column, cell.row];
        [self.parts[0][lane], self.parts[1][lane]] = cell.parts.to_array();
        for (row, corner) in self.corners.iter_mut().zip(cell.corners) {
            row[lane] = corner;
        }
        [self.aside[0][lane], self.aside[1][lane]] = aside.to_array();
        self.by_table[lane] = u32::from(*by_table);
    }

    #[inline(always)]
    fn chosen(&self, lane: usize) -> Chosen {
        let [a, b, c, d] = &self.corners;
        let cell = Cell {
            column: self.corner[0][lane],
            row: self.corner[1][lane],
            parts: pair(&self.parts, lane),
            corners: [a[lane], b[lane], c[lane], d[lane]],
        };
        let by_table = self.by_table[lane] != 0;
        Chosen { cell, aside: pair(&self.aside, lane), by_table }
    }
}

#[inline(always)]
fn pair(rows: &[Row; 2], lane: usize) -> Vec2 {
    Vec2::new(rows[0][lane], rows[1][lane])
}

/// For each site [`Sky::sample`].
pub(in super::super) fn from_sky(sky: &Sky, sites: &Sites, u: [&Row<f64>; 2], found: &mut Found) {
    if sky.total > 0.0 {
        look(sky, sites, u, found);
    } else {
        sites.lanes().for_each(|lane| put(&mut found.irradiance, lane, Vec3::ZERO));
    }
}

by_processor! {
    /// The same of a sky that is not black.
    #[inline(never)]
    fn look(sky: &Sky, sites: &Sites, u: [&Row<f64>; 2], found: &mut Found) {
        let (count, normals) = (padded(sites.lanes().len()), sites.normals());
        let search = &mut found.search;
        for lane in 0..count {
            search.facing[lane] = Guides::facing(sky.to_place * get(normals, lane));
        }
        for lane in 0..count {
            let guide = sky.guides.of(search.facing[lane]);
            let u = [random::unit_f32(u[0][lane]), random::unit_f32(u[1][lane])];
            search.put(lane, &guide.choose(u));
            search.part[lane] = guide.part;
        }
        for lane in 0..count {
            let direction = sky.direction(get(normals, lane), &search.chosen(lane));
            let local = sky.to_place * direction;
            let square = square_of(local);
            put(&mut found.wi, lane, direction);
            search.up[lane] = local.z;
            [search.square[0][lane], search.square[1][lane]] = [square.x, square.y];
        }
        for lane in 0..count {
            let square = pair(&search.square, lane);
            let [r, g, b] = sky.seen(search.up[lane], square).to_array();
            put(&mut search.radiance, lane, Vec3::new(r, g, b));
            search.density[lane] = sky.guides.of(search.facing[lane]).density(square);
        }
        for lane in 0..count {
            let wi = get(&found.wi, lane);
            let (part, by_table) = (search.part[lane], search.density[lane]);
            let density = mix(get(normals, lane), (wi, search.up[lane]), part, by_table);
            found.pdf_w[lane] = density;
            let given = get(&search.radiance, lane) / density;
            let given = if density > 0.0 { given } else { Vec3::ZERO };
            put(&mut found.irradiance, lane, given);
        }
        for lane in 0..count {
            let shadow = sites.point(lane).ray(get(&found.wi, lane));
            found.put_shadow(lane, &shadow);
        }
    }
}
