//! Points on lamps: on the surface, even, and of the right area.

use std::f64::consts::PI;

use glam::{DVec3, Vec3};

use super::meshes::Chance;
use crate::render::geometry::{Disk, Geometry, Owner, Plane, Primitive, Shapes, Sphere, Triangle};

const CORNERS: [DVec3; 3] =
    [DVec3::new(1.0, 2.0, 0.5), DVec3::new(4.0, 2.5, 0.0), DVec3::new(2.0, 5.0, 1.5)];

fn shapes(scale: f64) -> (Geometry, [Primitive; 4]) {
    let owner = Owner::default();
    let mut shapes = Shapes::new();
    let at = |p: DVec3| (p * scale).as_vec3();
    let corners = CORNERS.map(|p| shapes.vertex(at(p)));
    let triangle = shapes.triangle(Triangle { corners, normals: None, owner });
    let radius = (0.5 * scale) as f32;
    let sphere = shapes.sphere(Sphere { centre: at(CORNERS[0]), radius, owner });
    let normal = Vec3::new(2.0, -1.0, 2.0) / 3.0;
    let disk = shapes.disk(Disk { centre: at(CORNERS[1]), normal, radius, owner });
    let plane = shapes.plane(Plane { point: Vec3::ZERO, normal, owner });
    (Geometry::build(shapes), [triangle, sphere, disk, plane])
}

#[test]
fn areas_are_right_at_any_scale() {
    for scale in [1e-12, 1.0, 1e12] {
        let (geometry, [triangle, sphere, disk, plane]) = shapes(scale);
        let cross = (CORNERS[1] - CORNERS[0]).cross(CORNERS[2] - CORNERS[0]);
        for (shape, area) in [(triangle, 0.5 * cross.length()), (sphere, PI), (disk, 0.25 * PI)] {
            let area = area * scale * scale;
            assert!((geometry.area(shape) / area - 1.0).abs() < 1e-6, "{shape:?} × {scale}");
        }
        assert_eq!(geometry.area(plane), f64::INFINITY);
        assert_eq!(geometry.sample(plane, glam::Vec2::splat(0.5)), None);
    }
}

/// Means and second moments about the mean, against their values by calculus, at 5 standard errors.
#[test]
fn points_are_even_by_area() {
    const POINTS: usize = 200_000;
    let (geometry, [triangle, sphere, disk, _]) = shapes(1.0);
    let mean = (CORNERS[0] + CORNERS[1] + CORNERS[2]) / 3.0;
    let spread: f64 = CORNERS.iter().map(|c| (*c - mean).length_squared()).sum::<f64>() / 12.0;
    let mut chance = Chance::new(31);
    // Uniform by area: mean square distance from the mean is r² on a sphere, r²/2 on a disk.
    for (shape, mean, spread) in
        [(triangle, mean, spread), (sphere, CORNERS[0], 0.25), (disk, CORNERS[1], 0.125)]
    {
        let points: Vec<DVec3> = (0..POINTS)
            .map(|_| geometry.sample(shape, chance.square()).unwrap().position.as_dvec3())
            .collect();
        let n = POINTS as f64;
        let found = points.iter().sum::<DVec3>() / n;
        assert!((found - mean).length() < 5.0 * (spread / n).sqrt(), "{shape:?}: {found}");
        let squares = points.iter().map(|p| (*p - mean).length_squared());
        let found = squares.clone().sum::<f64>() / n;
        let variance = squares.map(|s| (s - spread).powi(2)).sum::<f64>() / n;
        let slack = 5.0 * (variance / n).sqrt() + 1e-6;
        assert!((found - spread).abs() < slack, "{shape:?}: {found} for {spread}");
    }
}

/// The bound of the error holds, measured across the surface.
#[test]
fn points_are_on_their_shapes_to_within_their_error() {
    let mut chance = Chance::new(32);
    for scale in [1e-9, 1.0, 1e7] {
        let (geometry, [triangle, sphere, disk, _]) = shapes(scale);
        for _ in 0..20_000 {
            let stored = |p: DVec3| (p * scale).as_vec3().as_dvec3();
            let p = geometry.sample(triangle, chance.square()).unwrap();
            let normal = p.ng.as_dvec3();
            let exact = (stored(CORNERS[1]) - stored(CORNERS[0]))
                .cross(stored(CORNERS[2]) - stored(CORNERS[0]))
                .normalize();
            assert!((normal - exact).length() < 1e-6);
            let off = (p.position.as_dvec3() - stored(CORNERS[0])).dot(exact).abs();
            assert!(off <= p.error.as_dvec3().dot(exact.abs()), "{off:e}");

            let p = geometry.sample(sphere, chance.square()).unwrap();
            let local = p.position.as_dvec3() - stored(CORNERS[0]);
            let off = (local.length() - f64::from((0.5 * scale) as f32)).abs();
            let bound = p.error.as_dvec3().dot(local.normalize().abs());
            assert!(off <= bound * (1.0 + 1e-6), "{off:e} beyond {bound:e}");

            let p = geometry.sample(disk, chance.square()).unwrap();
            let normal = (Vec3::new(2.0, -1.0, 2.0) / 3.0).as_dvec3();
            let off = (p.position.as_dvec3() - stored(CORNERS[1])).dot(normal).abs();
            assert!(off <= p.error.as_dvec3().dot(normal.abs()), "{off:e}");
        }
    }
}
