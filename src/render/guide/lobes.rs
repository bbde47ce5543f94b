//! Lobes about the directions from which some photons came: a density of directions.

use std::f32::consts::PI;
use std::f64::consts::TAU;

use glam::Vec3;

use super::photons::{Photon, around};
use crate::math::angles;

/// So many photons, and lobes, at most.
pub(super) const MOST: usize = 32;

/// A lobe is as wide as half of what lies between a photon's direction and its third neighbour's.
const NEIGHBOUR: usize = 3;
const WIDTH: f32 = 0.5;
/// Of a lobe that is as narrow as f32 tells directions apart, and of the widest.
const NARROWEST: f32 = 1e-6;
const WIDEST: f32 = 1.0;

/// The least and the largest part of all paths that are sent by lobes. If more are, the others weigh so
/// much more that after some surfaces their noise outweighs what is gained.
const LEAST_PART: f32 = 0.15;
const LARGEST_PART: f32 = 0.35;

/// What photons that landed near each other tell: a lobe about the direction from each to the last
/// mirror or glass it left. As seen from elsewhere, lobes turn towards these places.
///
/// Of the angle θ to its middle a lobe has the density s (2 + s) / (4π (1 − cos θ + s)²): broad enough
/// at its foot that nothing near it is never looked for. Numbers in place of structures, side by
/// side: they are asked all at once.
#[derive(Clone, Debug, PartialEq)]
pub struct Lobes {
    /// Where they are of use.
    low: Vec3,
    high: Vec3,
    /// The part of all paths that are to be sent by them, in (0, 1).
    part: f32,
    count: usize,
    /// What each of them turns to.
    x: [f32; MOST],
    y: [f32; MOST],
    z: [f32; MOST],
    /// Their widths s, as 1 − cos θ.
    width: [f32; MOST],
    /// What stands before the square, over how many they are; 0 of those beyond the last.
    scale: [f32; MOST],
}

impl Lobes {
    /// Of photons, [`MOST`] at most; `even` as in [`super::Guide::of`].
    pub(super) fn new(photons: &[Photon], even: f32) -> Self {
        let (low, high) = around(photons);
        let size = high - low;
        // A surface is flat, by and large: it is the product of the two larger sides.
        let area = size.x * size.y + size.y * size.z + size.z * size.x;
        let dense = photons.len() as f32 / area.max(f32::MIN_POSITIVE);
        let part = (1.0 / (1.0 + even / dense)).clamp(LEAST_PART, LARGEST_PART);
        let margin = Vec3::splat(0.5 * size.max_element());
        let mut lobes = Self {
            low: low - margin,
            high: high + margin,
            part,
            count: photons.len(),
            x: [0.0; MOST],
            y: [0.0; MOST],
            z: [0.0; MOST],
            width: [1.0; MOST],
            scale: [0.0; MOST],
        };
        let middle = 0.5 * (low + high);
        let ways: Vec<Vec3> =
            photons.iter().map(|photon| (photon.from - middle).normalize_or(Vec3::Z)).collect();
        for (lobe, (photon, way)) in photons.iter().zip(&ways).enumerate() {
            let mut apart: Vec<f32> =
                ways.iter().map(|other| 0.5 * (other - way).length_squared()).collect();
            let neighbour = match apart.len() > NEIGHBOUR {
                true => *apart.select_nth_unstable_by(NEIGHBOUR, f32::total_cmp).1,
                false => WIDEST,
            };
            let width = (WIDTH * neighbour).clamp(NARROWEST, WIDEST);
            [lobes.x[lobe], lobes.y[lobe], lobes.z[lobe]] = photon.from.to_array();
            lobes.width[lobe] = width;
            lobes.scale[lobe] = width * (2.0 + width) / (4.0 * PI * photons.len() as f32);
        }
        lobes
    }

    /// Whether a place is near enough to where the photons landed.
    pub(super) fn are_near(&self, place: Vec3) -> bool {
        place.cmpge(self.low).all() && place.cmple(self.high).all()
    }

    /// The part of all paths that are to be sent by them, in (0, 1).
    #[inline]
    pub fn part(&self) -> f32 {
        self.part
    }

    /// Density in solid angle of a direction as seen from a place. All lobes at once: the compiler makes
    /// vectors of it where it is part of a function [`by_processor`].
    ///
    /// [`by_processor`]: crate::render::lanes
    #[inline(always)]
    pub fn pdf_w(&self, from: Vec3, wi: Vec3) -> f32 {
        let mut each = [0.0; MOST];
        for (lobe, each) in each.iter_mut().enumerate() {
            let x = self.x[lobe] - from.x;
            let y = self.y[lobe] - from.y;
            let z = self.z[lobe] - from.z;
            let nearness = 1.0 / (x * x + y * y + z * z).sqrt().max(f32::MIN_POSITIVE);
            // By the chord: the cosine of small angles has lost their digits.
            let x = x * nearness - wi.x;
            let y = y * nearness - wi.y;
            let z = z * nearness - wi.z;
            let apart = 0.5 * (x * x + y * y + z * z) + self.width[lobe];
            *each = self.scale[lobe] / (apart * apart);
        }
        // By halves, in an order that vectors have too.
        let mut half = MOST / 2;
        while half > 0 {
            for lobe in 0..half {
                each[lobe] += each[lobe + half];
            }
            half /= 2;
        }
        each[0]
    }

    /// A direction as seen from a place, of unit length: of the lobe that `choice` in [0, 1) says, by
    /// `u` in [0, 1)².
    pub fn sample(&self, from: Vec3, choice: f64, u: [f64; 2]) -> Vec3 {
        let lobe = ((choice * self.count as f64) as usize).min(self.count - 1);
        let axis = Vec3::new(self.x[lobe], self.y[lobe], self.z[lobe]) - from;
        let axis = axis.normalize_or(Vec3::Z);
        let width = f64::from(self.width[lobe]);
        // The inverse of the integral over 1 − cos θ.
        let apart = width * (2.0 + width) / (2.0 * (1.0 - u[0]) + width) - width;
        let apart = apart.clamp(0.0, 2.0);
        let sin = (apart * (2.0 - apart)).sqrt();
        let (turn_sin, turn_cos) = angles::sin_cos(TAU * u[1]);
        let (x, y) = axis.any_orthonormal_pair();
        let local = [1.0 - apart, sin * turn_cos, sin * turn_sin].map(|part| part as f32);
        (local[0] * axis + local[1] * x + local[2] * y).normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{chi_squared, random};

    /// Photons that landed on a piece of floor by way of places above it.
    fn photons(count: u64) -> Vec<Photon> {
        let photon = |i| {
            let [a, b] = random::unit_pair(random::at(41, i));
            let [c, d] = random::unit_pair(random::at(42, i));
            let at = Vec3::new(0.1 * a as f32, 0.0, 0.1 * b as f32);
            Photon { at, from: Vec3::new(0.3 * c as f32, 0.8, 0.4 * d as f32) }
        };
        (0..count).map(photon).collect()
    }

    /// Of few photons and of many: bins of one solid angle about a direction between them.
    #[test]
    fn directions_follow_their_density_and_it_is_one_in_all() {
        const RINGS: usize = 40;
        const SECTORS: usize = 16;
        for count in [1, 3, MOST as u64] {
            let lobes = Lobes::new(&photons(count), 1.0);
            let from = Vec3::new(0.04, 0.0, 0.05);
            let axis = Vec3::new(0.1, 0.8, 0.15).normalize();
            let (x, y) = axis.any_orthonormal_pair();
            // Rings are the narrower the nearer they are to the axis, where lobes are.
            let ring_of = |apart: f32| (apart / 2.0).powf(0.25) * RINGS as f32;
            let edge = |ring: usize| 2.0 * (ring as f64 / RINGS as f64).powi(4);
            let mut counts = vec![0; RINGS * SECTORS];
            for i in 0..100_000 {
                let [a, b] = random::unit_pair(random::at(43, i));
                let [c, _] = random::unit_pair(random::at(44, i));
                let wi = lobes.sample(from, c, [a, b]);
                assert!((wi.length() - 1.0).abs() < 1e-6);
                let ring = (ring_of(0.5 * (wi - axis).length_squared()) as usize).min(RINGS - 1);
                let turn = wi.dot(y).atan2(wi.dot(x)) / std::f32::consts::TAU + 0.5;
                counts[ring * SECTORS + ((turn * SECTORS as f32) as usize).min(SECTORS - 1)] += 1;
            }
            let mut expected = Vec::new();
            for ring in 0..RINGS {
                for sector in 0..SECTORS {
                    // Midpoints of a grid within the bin.
                    const FINE: usize = 16;
                    let (low, high) = (edge(ring), edge(ring + 1));
                    let mut sum = 0.0;
                    for i in 0..FINE * FINE {
                        let part = |n: usize| (n as f64 + 0.5) / FINE as f64;
                        let cos = 1.0 - (low + (high - low) * part(i / FINE));
                        let turn = (sector as f64 + part(i % FINE)) / SECTORS as f64;
                        let (sin, along) = (TAU * (turn - 0.5)).sin_cos();
                        let out = (1.0 - cos * cos).max(0.0).sqrt();
                        let wi =
                            (cos as f32) * axis + (out * along) as f32 * x + (out * sin) as f32 * y;
                        sum += f64::from(lobes.pdf_w(from, wi));
                    }
                    let solid_angle = TAU / SECTORS as f64 * (high - low);
                    expected.push(sum / (FINE * FINE) as f64 * solid_angle);
                }
            }
            let whole: f64 = expected.iter().sum();
            assert!((whole - 1.0).abs() < 0.01, "{count}: {whole}");
            expected.iter_mut().for_each(|part| *part /= whole);
            chi_squared::assert_fits(&counts, &expected);
        }
    }

    #[test]
    fn nothing_that_f32_holds_makes_them_fail() {
        let same = vec![Photon { at: Vec3::ONE, from: Vec3::ONE }; MOST];
        let far = photons(MOST as u64).into_iter().map(|it| Photon { from: 1e18 * it.from, ..it });
        for photons in [same, far.collect(), photons(1)] {
            let lobes = Lobes::new(&photons, 1e-30);
            assert!((LEAST_PART..=LARGEST_PART).contains(&lobes.part()));
            for from in [Vec3::ONE, Vec3::ZERO, Vec3::splat(-1e6)] {
                for u in [[0.0; 2], [0.5; 2], [1.0 - 1e-16; 2]] {
                    let wi = lobes.sample(from, u[0], u);
                    assert!((wi.length() - 1.0).abs() < 1e-5, "{wi}");
                    let pdf_w = lobes.pdf_w(from, wi);
                    assert!(pdf_w.is_finite() && pdf_w > 0.0, "{pdf_w}");
                }
            }
        }
    }
}
