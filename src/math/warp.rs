//! Maps of the unit square onto shapes, uniform by area. Each has a chi-squared test.

use glam::{Vec2, Vec3};

/// The unit disk, by concentric squares [Shirley97]: neighbours stay neighbours.
#[inline(always)]
pub fn square_to_disk(u: Vec2) -> Vec2 {
    let p = 2.0 * u - Vec2::ONE;
    // By a choice of numbers, not of ways: no processor foretells which axis is nearer.
    let along_x = p.x.abs() > p.y.abs();
    let (radius, across) = if along_x { (p.x, p.y) } else { (p.y, p.x) };
    let part = if radius == 0.0 { 0.0 } else { across / radius };
    let (sin, cos) = sin_cos_of_eighth(part);
    let (near, far) = (radius * cos, radius * sin);
    if along_x { Vec2::new(near, far) } else { Vec2::new(far, near) }
}

/// Sine and cosine of a part from -1 to 1 of π/4, by their series: to the rounding of f32.
#[inline(always)]
fn sin_cos_of_eighth(part: f32) -> (f32, f32) {
    let x = std::f32::consts::FRAC_PI_4 * part;
    let s = x * x;
    let sin = 1.0 + s * (-1.0 / 6.0 + s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s / 362_880.0)));
    let cos = 1.0 + s * (-0.5 + s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s / 40_320.0)));
    (x * sin, cos)
}

/// The inverse of [`square_to_disk`].
#[inline(always)]
pub fn disk_to_square(p: Vec2) -> Vec2 {
    let radius = p.length();
    // The square's axis that is closer, and how far from it to the diagonal.
    let along_x = p.x.abs() > p.y.abs();
    let (along, across) = if along_x { (p.x, p.y) } else { (p.y, p.x) };
    let part = if radius == 0.0 { 0.0 } else { eighths_of_atan(across / along) };
    let (a, b) = (radius.copysign(along), radius.copysign(along) * part);
    let q = if along_x { Vec2::new(a, b) } else { Vec2::new(b, a) };
    (0.5 * q + 0.5).clamp(Vec2::ZERO, Vec2::ONE)
}

/// The arc tangent of a number from -1 to 1, as a part of π/4: by a polynomial fitted to it over
/// Chebyshev's nodes, to the rounding of f32.
#[inline(always)]
fn eighths_of_atan(tangent: f32) -> f32 {
    let s = tangent * tangent;
    let near = 0.135_431_36
        + s * (-0.095_434_98 + s * (0.054_224_226 + s * (-0.020_378_238 + s * 0.003_608_442_7)));
    tangent
        * (1.273_239_5 + s * (-0.424_409_8 + s * (0.254_552_2 + s * (-0.180_832_74 + s * near))))
}

/// The hemisphere about +z, by [`square_to_disk`]: its rim is the horizon.
#[inline(always)]
pub fn square_to_hemisphere(u: Vec2) -> Vec3 {
    let p = square_to_disk(u);
    let squared = p.length_squared().min(1.0);
    (p * (2.0 - squared).sqrt()).extend(1.0 - squared)
}

/// The inverse of [`square_to_hemisphere`], for z ≥ 0.
#[inline(always)]
pub fn hemisphere_to_square(w: Vec3) -> Vec2 {
    // The disk's radius is √(1 − z), the direction's √(1 − z²): without the difference that rounds.
    disk_to_square(Vec2::new(w.x, w.y) / (1.0 + w.z).sqrt())
}

/// The cone of directions within `half_angle` of +z. Their density is one over its solid angle,
/// 4π sin²(half_angle/2).
pub fn square_to_cone(u: Vec2, half_angle: f32) -> Vec3 {
    let p = square_to_disk(u);
    // 1 − cos θ is even; sin²(θ/2) is half of it, and the chord from the axis has no cancellation.
    let half_chord = (0.5 * half_angle).sin() * p.length();
    let sin = 2.0 * half_chord * (1.0 - half_chord * half_chord).sqrt();
    (p.normalize_or_zero() * sin).extend(1.0 - 2.0 * half_chord * half_chord)
}

/// The triangle, as weights of its second and third corner [Shirley97].
pub fn square_to_triangle(u: Vec2) -> Vec2 {
    let s = u.x.sqrt();
    Vec2::new(s * (1.0 - u.y), s * u.y)
}

/// The unit sphere.
pub fn square_to_sphere(u: Vec2) -> Vec3 {
    let z = 1.0 - 2.0 * u.x;
    let r = (1.0 - z * z).max(0.0).sqrt();
    let (sin, cos) = (std::f32::consts::TAU * u.y).sin_cos();
    Vec3::new(r * cos, r * sin, z)
}

/// The hemisphere about +z, with a density of cos θ/π.
#[inline(always)]
pub fn square_to_cosine(u: Vec2) -> Vec3 {
    let p = square_to_disk(u);
    p.extend((1.0 - p.length_squared()).max(0.0).sqrt())
}

/// A direction of the frame about +z as one of a frame about `axis`, of unit length [Duff17].
#[inline(always)]
pub fn about(axis: Vec3, local: Vec3) -> Vec3 {
    let (x, y) = axis.any_orthonormal_pair();
    local.x * x + local.y * y + local.z * axis
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{chi_squared, random};

    const SAMPLES: u64 = 100_000;

    fn square(i: u64) -> Vec2 {
        let [x, y] = random::unit_pair(random::at(17, i));
        Vec2::new(random::unit_f32(x), random::unit_f32(y))
    }

    /// Counts samples in bins; a warp is uniform by area when bins of one area fill alike.
    fn assert_uniform(bins: usize, bin: impl Fn(Vec2) -> usize) {
        let mut counts = vec![0; bins];
        (0..SAMPLES).for_each(|i| counts[bin(square(i)).min(bins - 1)] += 1);
        chi_squared::assert_fits(&counts, &vec![1.0 / bins as f64; bins]);
    }

    fn turn(x: f32, y: f32) -> f32 {
        y.atan2(x) / std::f32::consts::TAU + 0.5
    }

    #[test]
    fn the_disk_is_filled_evenly() {
        // Rings of one area (r² is even) by sectors of one angle.
        assert_uniform(8 * 12, |u| {
            let p = square_to_disk(u);
            assert!(p.length() <= 1.000_001);
            let ring = ((p.length_squared() * 8.0) as usize).min(7);
            ring * 12 + ((turn(p.x, p.y) * 12.0) as usize).min(11)
        });
    }

    #[test]
    fn sines_and_cosines_are_as_the_library_has_them() {
        for i in -1000..=1000_i16 {
            let part = f32::from(i) / 1000.0;
            let (sin, cos) = sin_cos_of_eighth(part);
            let truth = (std::f64::consts::FRAC_PI_4 * f64::from(part)).sin_cos();
            let off = [f64::from(sin) - truth.0, f64::from(cos) - truth.1];
            assert!(off.iter().all(|off| off.abs() < 1.2e-7), "{part}: {off:?}");
        }
    }

    #[test]
    fn arc_tangents_are_as_the_library_has_them() {
        for i in -1000..=1000_i16 {
            let tangent = f32::from(i) / 1000.0;
            let truth = f64::from(tangent).atan() / std::f64::consts::FRAC_PI_4;
            let off = f64::from(eighths_of_atan(tangent)) - truth;
            assert!(off.abs() < 2e-7, "{tangent}: {off:e}");
        }
    }

    #[test]
    fn squares_come_back_from_disks_and_hemispheres() {
        let mut most = Vec2::ZERO;
        for i in 0..10_000 {
            // Corners, edges, diagonals and the centre first.
            let u = match i {
                0..25 => Vec2::new((i / 5) as f32, (i % 5) as f32) / 4.0,
                _ => square(i),
            };
            let off = disk_to_square(square_to_disk(u)) - u;
            most = most.max(off.abs());
            let off = hemisphere_to_square(square_to_hemisphere(u)) - u;
            most = most.max(off.abs());
        }
        assert!(most.max_element() < 3e-6, "{most}");
    }

    #[test]
    fn the_hemisphere_is_filled_evenly() {
        assert_uniform(10 * 12, |u| {
            let p = square_to_hemisphere(u);
            assert!((p.length() - 1.0).abs() < 1e-5 && p.z >= 0.0);
            ((p.z * 10.0) as usize).min(9) * 12 + ((turn(p.x, p.y) * 12.0) as usize).min(11)
        });
    }

    #[test]
    fn cones_are_filled_evenly_however_small() {
        for half_angle in [1e-4_f32, 0.00465, 1.0, 3.0] {
            assert_uniform(8 * 12, |u| {
                let p = square_to_cone(u, half_angle);
                assert!((p.length() - 1.0).abs() < 1e-6);
                // Half the chord from the axis, squared, is even.
                let within = ((p - Vec3::Z).length() / 2.0 / (half_angle / 2.0).sin()).powi(2);
                assert!(within < 1.001, "{within}");
                ((within * 8.0) as usize).min(7) * 12 + ((turn(p.x, p.y) * 12.0) as usize).min(11)
            });
        }
    }

    #[test]
    fn the_triangle_is_filled_evenly() {
        // A grid over the square; its upper right half is folded onto the lower left one, whose
        // cells on the diagonal are halves.
        const N: usize = 10;
        let mut counts = vec![0; N * N];
        for i in 0..SAMPLES {
            let p = square_to_triangle(square(i));
            assert!(p.min_element() >= 0.0 && p.x + p.y <= 1.000_001);
            let cell = |x: f32| ((x * N as f32) as usize).min(N - 1);
            counts[cell(p.y) * N + cell(p.x)] += 1;
        }
        let cells = (0..N * N).map(|i| match (i % N + i / N).cmp(&(N - 1)) {
            std::cmp::Ordering::Less => 2.0 / (N * N) as f64,
            std::cmp::Ordering::Equal => 1.0 / (N * N) as f64,
            std::cmp::Ordering::Greater => 0.0,
        });
        // Rounding may put a sample on the far side of the diagonal.
        let beyond: u64 = (0..N * N).filter(|i| i % N + i / N >= N).map(|i| counts[i]).sum();
        assert!(beyond <= 2, "{beyond}");
        let (kept, expected): (Vec<_>, Vec<_>) =
            counts.iter().zip(cells).filter(|(_, p)| *p > 0.0).map(|(c, p)| (*c, p)).unzip();
        chi_squared::assert_fits(&kept, &expected);
    }

    #[test]
    fn the_sphere_is_filled_evenly() {
        // Zones of one height have one area [Archimedes].
        assert_uniform(10 * 12, |u| {
            let p = square_to_sphere(u);
            assert!((p.length() - 1.0).abs() < 1e-5);
            let zone = (((p.z + 1.0) * 5.0) as usize).min(9);
            zone * 12 + ((turn(p.x, p.y) * 12.0) as usize).min(11)
        });
    }

    #[test]
    fn frames_are_square_about_every_axis_and_most_of_all_about_minus_z() {
        let near = |i: u64| {
            let p = square(i) - Vec2::splat(0.5);
            let aside = 10.0_f32.powi(-((i % 12) as i32));
            Vec3::new(aside * p.x, aside * p.y, if i.is_multiple_of(2) { -1.0 } else { 1.0 })
        };
        let poles = [Vec3::Z, Vec3::NEG_Z, Vec3::new(0.0, -0.0, -1.0), Vec3::new(-0.0, 0.0, -1.0)];
        for axis in poles.into_iter().chain((0..100_000).map(|i| near(i).normalize())) {
            let [x, y, z] = Vec3::AXES.map(|local| about(axis, local));
            assert_eq!(z, axis);
            for (one, other) in [(x, y), (y, z), (z, x)] {
                assert!(one.dot(other).abs() < 1e-6, "{axis}: {x} {y}");
                assert!((one.length() - 1.0).abs() < 1e-6, "{axis}: {x} {y}");
            }
            // Right-handed.
            assert!((x.cross(y) - z).length() < 2e-6, "{axis}");
        }
    }
}
