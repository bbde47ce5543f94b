//! A sky over level ground: a table of radiance by direction, sampled by the luminance of what is
//! seen.
//!
//! The table lies over the square that [`warp::square_to_hemisphere`] bends into the sky, which
//! keeps areas: between its nodes radiance is bilinear, and so is the density of samples, exactly
//! the luminance of what a ray sees there.

use std::f32::consts::FRAC_1_PI;

use glam::{Mat3, Vec2, Vec3};

use crate::math::{Rgb, random, warp};

/// Solid angle of half of all directions.
const HALF: f32 = std::f32::consts::TAU;

/// The light of a sky, and of ground below its horizon.
#[derive(Clone, Debug)]
pub struct Sky {
    /// From directions of the world to those of the place: east, north, up.
    to_place: Mat3,
    /// Cells along a side of the square.
    side: usize,
    /// Radiance at the corners of the cells, in light units, row by row.
    nodes: Vec<Rgb>,
    /// Radiance below the horizon.
    ground: Rgb,
    /// Luminance of cells up to and including each row, and of each row up to and including each
    /// cell; its unit is that of a cell of luminance one.
    rows: Vec<f64>,
    cells: Vec<f64>,
    /// The part of samples that goes above the horizon.
    above: f64,
    /// Luminance, integrated over all directions.
    total: f32,
}

impl Sky {
    /// A sky whose radiance, of a direction of the place, is `radiance` above the horizon and
    /// `ground` below. `to_place` turns directions of the world to it; `side` cells, 1 or more.
    /// Radiance is finite and not negative.
    pub fn new(to_place: Mat3, side: usize, radiance: impl Fn(Vec3) -> Rgb, ground: Rgb) -> Self {
        let at = |i: usize| i as f32 / side as f32;
        let corners = (0..=side).flat_map(|y| (0..=side).map(move |x| Vec2::new(at(x), at(y))));
        let nodes: Vec<_> = corners.map(|u| radiance(warp::square_to_hemisphere(u))).collect();
        let mut rows = Vec::with_capacity(side);
        let mut cells = Vec::with_capacity(side * side);
        let mut sum = 0.0;
        for y in 0..side {
            let mut row = 0.0;
            for x in 0..side {
                let corners = corners_of(&nodes, side, x, y).map(|c| f64::from(c.luminance()));
                row += corners.iter().sum::<f64>() / 4.0;
                cells.push(row);
            }
            sum += row;
            rows.push(sum);
        }
        let mean = sum / (side * side) as f64;
        let below = f64::from(ground.luminance());
        let above = if mean + below > 0.0 { mean / (mean + below) } else { 0.0 };
        let total = HALF * (mean + below) as f32;
        Self { to_place, side, nodes, ground, rows, cells, above, total }
    }

    /// Luminance, integrated over all directions, in light units times sr.
    pub fn total(&self) -> f32 {
        self.total
    }

    /// Radiance from a direction of the world.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        let local = self.to_place * direction;
        if local.z < 0.0 {
            return self.ground;
        }
        let [x, y] = warp::hemisphere_to_square(local).to_array().map(|u| u * self.side as f32);
        let cell = |x: f32| (x as usize).min(self.side - 1);
        let (column, row) = (cell(x), cell(y));
        let (x, y) = (x - column as f32, y - row as f32);
        let [a, b, c, d] = corners_of(&self.nodes, self.side, column, row);
        (a * (1.0 - x) + b * x) * (1.0 - y) + (c * (1.0 - x) + d * x) * y
    }

    /// A direction, with the radiance from there and its density in solid angle: by luminance; for
    /// a surface, whose normal is not zero, half of them by the cosine to it, for what is bright
    /// may be behind the surface. None of a black sky.
    pub(super) fn sample(&self, normal: Vec3, u: [f64; 2]) -> Option<(Vec3, Rgb, f32)> {
        if self.total <= 0.0 {
            return None;
        }
        let wi = match u[0] {
            first if normal == Vec3::ZERO => self.by_luminance([first, u[1]]),
            first if first < 0.5 => self.by_luminance([2.0 * first, u[1]]),
            first => {
                let u = [2.0 * first - 1.0, u[1]].map(random::unit_f32);
                warp::about(normal, warp::square_to_cosine(Vec2::from_array(u)))
            }
        };
        let radiance = self.radiance(wi);
        Some((wi, radiance, self.density(normal, wi, radiance)))
    }

    /// The density in solid angle with which `sample` gives a direction.
    pub(super) fn pdf_w(&self, normal: Vec3, direction: Vec3) -> f32 {
        self.density(normal, direction, self.radiance(direction))
    }

    fn density(&self, normal: Vec3, direction: Vec3, radiance: Rgb) -> f32 {
        if self.total <= 0.0 {
            return 0.0;
        }
        let by_luminance = radiance.luminance() / self.total;
        if normal == Vec3::ZERO {
            return by_luminance;
        }
        0.5 * (by_luminance + FRAC_1_PI * normal.dot(direction).max(0.0))
    }

    fn by_luminance(&self, u: [f64; 2]) -> Vec3 {
        let local = if u[0] < self.above {
            warp::square_to_hemisphere(self.point(u[0] / self.above, u[1]))
        } else {
            let u = [(u[0] - self.above) / (1.0 - self.above), u[1]];
            -warp::square_to_hemisphere(Vec2::from_array(u.map(random::unit_f32)))
        };
        self.to_place.transpose() * local
    }

    /// A point of the square by bilinear luminance: one number chooses row and height, the other
    /// the column and where in it, so that stratified numbers stay stratified.
    fn point(&self, u: f64, v: f64) -> Vec2 {
        let (row, u) = choose(&self.rows, u);
        let (column, v) = choose(&self.cells[row * self.side..][..self.side], v);
        let [a, b, c, d] =
            corners_of(&self.nodes, self.side, column, row).map(|c| f64::from(c.luminance()));
        let y = on_line(a + b, c + d, u);
        let x = on_line(a + (c - a) * y, b + (d - b) * y, v);
        let at = |cell: usize, within: f64| ((cell as f64 + within) / self.side as f64) as f32;
        Vec2::new(at(column, x), at(row, y))
    }
}

/// The corners of a cell: at (0, 0), (1, 0), (0, 1), (1, 1).
fn corners_of(nodes: &[Rgb], side: usize, x: usize, y: usize) -> [Rgb; 4] {
    let first = y * (side + 1) + x;
    [nodes[first], nodes[first + 1], nodes[first + side + 1], nodes[first + side + 2]]
}

/// Which of the parts of a sum, told up to and including each, holds the fraction `u` of it, and
/// where in that part, again in [0, 1).
fn choose(sums: &[f64], u: f64) -> (usize, f64) {
    let last = sums.len() - 1;
    let reached = u * sums[last];
    let index = sums.partition_point(|up_to| *up_to <= reached).min(last);
    let before = if index == 0 { 0.0 } else { sums[index - 1] };
    let part = sums[index] - before;
    let within = if part > 0.0 { (reached - before) / part } else { 0.0 };
    (index, within.clamp(0.0, 1.0 - f64::EPSILON))
}

/// Where on [0, 1] the fraction `u` of a density ends that runs straight from `a` to `b`, both not
/// negative: the root of a quadratic, without the difference that rounds.
fn on_line(a: f64, b: f64, u: f64) -> f64 {
    if a + b <= 0.0 {
        return u;
    }
    let root = (a * a + u * (b * b - a * a)).max(0.0).sqrt();
    // Both are zero only at the dark end of a line, for the fraction zero.
    if a + root > 0.0 { (u * (a + b) / (a + root)).min(1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::chi_squared;

    const SAMPLES: u64 = 200_000;

    /// East to the left, north away, and up: as a viewer has it who looks along −z with y up and
    /// the sun behind.
    fn turned() -> Mat3 {
        Mat3::from_cols(Vec3::new(0.6, 0.8, 0.0), Vec3::Z, Vec3::new(0.8, -0.6, 0.0)).transpose()
    }

    /// A sky with a bright side, a horizon, a dark patch, and colours.
    fn sky(side: usize, ground: Rgb) -> Sky {
        let radiance = |w: Vec3| {
            let bright = (8.0 * (w.dot(Vec3::new(0.6, 0.0, 0.8)) - 1.0)).exp();
            let patch = if w.x < -0.2 && w.y > 0.1 { 0.0 } else { 1.0 };
            Rgb { r: 3.0 * bright, g: 0.2 * patch, b: 1.0 - w.z }
        };
        Sky::new(turned(), side, radiance, ground)
    }

    fn numbers(i: u64) -> [f64; 2] {
        random::unit_pair(random::at(23, i))
    }

    /// Bins of one solid angle over all directions.
    fn bin(w: Vec3) -> usize {
        let level = (((w.z + 1.0) * 10.0) as usize).min(19);
        let turn = w.y.atan2(w.x) / HALF + 0.5;
        level * 24 + ((turn * 24.0) as usize).min(23)
    }

    #[test]
    fn samples_follow_the_luminance_that_is_seen() {
        let across = Vec3::new(0.1, -0.2, -0.6).normalize();
        for (side, ground, normal) in [
            (1, Rgb::BLACK, Vec3::ZERO),
            (7, Rgb::grey(0.3), Vec3::ZERO),
            (64, Rgb::grey(0.05), Vec3::ZERO),
            (64, Rgb::BLACK, across),
        ] {
            let sky = sky(side, ground);
            let mut counts = vec![0; 480];
            for i in 0..SAMPLES {
                let (wi, radiance, pdf_w) = sky.sample(normal, numbers(i)).unwrap();
                assert!((wi.length() - 1.0).abs() < 1e-5);
                assert_eq!((radiance, pdf_w), (sky.radiance(wi), sky.pdf_w(normal, wi)));
                counts[bin(sky.to_place * wi)] += 1;
            }
            // What each bin should hold, by many points spread evenly.
            let mut probabilities = vec![0.0; 480];
            let points = 4_000_000_u64;
            for i in 0..points {
                let u =
                    [0.5, 0.755_877_666, 0.569_840_291].map(|step: f64| (step * i as f64).fract());
                let wi = warp::square_to_sphere(Vec2::new(u[1] as f32, u[2] as f32));
                probabilities[bin(sky.to_place * wi)] += f64::from(sky.pdf_w(normal, wi));
            }
            let sphere = f64::from(2.0 * HALF) / points as f64;
            probabilities.iter_mut().for_each(|p| *p *= sphere);
            let sum: f64 = probabilities.iter().sum();
            assert!((sum - 1.0).abs() < 1e-4, "the density integrates to {sum}");
            probabilities.iter_mut().for_each(|p| *p /= sum);
            chi_squared::assert_fits(&counts, &probabilities);
        }
    }

    #[test]
    fn a_sky_of_one_colour_has_that_everywhere_and_even_samples() {
        let sky = Sky::new(Mat3::IDENTITY, 5, |_| Rgb::grey(2.0), Rgb::grey(2.0));
        assert!((sky.total() / (4.0 * HALF) - 1.0).abs() < 1e-6);
        for i in 0..1000 {
            let (wi, radiance, pdf_w) = sky.sample(Vec3::ZERO, numbers(i)).unwrap();
            assert!((radiance.g - 2.0).abs() < 1e-6);
            assert!((pdf_w - 0.5 / HALF).abs() < 1e-7);
            assert!(wi.is_normalized());
        }
    }

    #[test]
    fn up_is_the_sky_and_down_is_the_ground() {
        let sky =
            Sky::new(turned(), 8, |w| Rgb { r: w.x.max(0.0), g: w.y.max(0.0), b: w.z }, Rgb::BLACK);
        let seen = |east: f32, north: f32, up: f32| {
            sky.radiance(turned().transpose() * Vec3::new(east, north, up).normalize())
        };
        assert!((seen(0.0, 0.0, 1.0).b - 1.0).abs() < 1e-6);
        assert!((seen(1.0, 0.0, 1e-7).r - 1.0).abs() < 1e-3);
        assert!((seen(0.0, 1.0, 1e-7).g - 1.0).abs() < 1e-3);
        assert_eq!(seen(0.3, 0.4, -1e-3), Rgb::BLACK);
    }

    #[test]
    fn a_black_sky_gives_no_light() {
        let sky = Sky::new(Mat3::IDENTITY, 4, |_| Rgb::BLACK, Rgb::BLACK);
        assert!(sky.sample(Vec3::X, [0.3, 0.7]).is_none());
        assert_eq!((sky.pdf_w(Vec3::X, Vec3::Z), sky.radiance(Vec3::Z)), (0.0, Rgb::BLACK));
    }

    #[test]
    fn a_line_is_cut_where_its_part_ends() {
        for (a, b) in [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (0.2, 3.0), (0.0, 0.0), (1e-30, 2e-30)] {
            for u in [0.0, 0.3, 0.999] {
                let x = on_line(a, b, u);
                let part =
                    if a + b > 0.0 { (a * x + 0.5 * (b - a) * x * x) / (0.5 * (a + b)) } else { x };
                assert!((part - u).abs() < 1e-12, "{a} {b} {u}: {x}");
            }
        }
    }
}
