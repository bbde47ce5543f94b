//! Nothing, too much, too many of the same, and numbers that prepare would never let through.

use glam::{DVec3, Vec3};

use super::meshes::{Chance, Mesh};
use super::{NO_NUMBERS, by_hand};
use crate::render::geometry::tree::Tree;
use crate::render::geometry::{
    Bounds, Disk, Geometry, Owner, Plane, Ray, Shapes, Sphere, Triangle,
};

fn owner(object: u32) -> Owner {
    Owner { object, material: object }
}

fn push(shapes: &mut Shapes, corners: [Vec3; 3], object: u32) {
    let corners = corners.map(|p| shapes.vertex(p));
    shapes.triangle(Triangle { corners, normals: None, owner: owner(object) });
}

const CORNERS: [Vec3; 3] = [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::Y];

#[test]
fn nothing_is_met_where_nothing_is() {
    let geometry = Geometry::build(Shapes::new());
    let ray = Ray::new(Vec3::ZERO, Vec3::Z);
    assert!(geometry.closest(&ray).is_none() && !geometry.occluded(&ray));
    assert!(geometry.bounds().is_empty());

    let mut shapes = Shapes::new();
    shapes.plane(Plane { point: Vec3::ZERO, normal: Vec3::Y, owner: owner(0) });
    let geometry = Geometry::build(shapes);
    assert!(geometry.bounds().is_empty());
    assert!(geometry.closest(&Ray::new(Vec3::Y, -Vec3::Y)).is_some());
}

#[test]
fn one_shape_is_enough() {
    let mut shapes = Shapes::new();
    push(&mut shapes, CORNERS, 5);
    let geometry = Geometry::build(shapes);
    assert_eq!(geometry.bounds(), Bounds { min: CORNERS[0], max: Vec3::new(1.0, 1.0, 0.0) });
    let hit = geometry.closest(&Ray::new(Vec3::Z, -Vec3::Z)).unwrap();
    assert_eq!((hit.t, hit.position, hit.ng, hit.ns), (1.0, Vec3::ZERO, Vec3::Z, Vec3::Z));
    assert_eq!((hit.object, hit.material), (5, 5));
    assert!(geometry.closest(&Ray::new(-Vec3::Z, -Vec3::Z)).is_none());
    assert!(geometry.bytes() > 0);
}

/// The least primitive wins, wherever the tree puts it.
#[test]
fn of_copies_the_first_is_met() {
    for copies in [2, 5, 17, 100_000] {
        let mut shapes = Shapes::new();
        push(&mut shapes, CORNERS.map(|p| p - 2.0 * Vec3::Z), 99);
        for object in 0..copies {
            push(&mut shapes, CORNERS, object);
        }
        shapes.disk(Disk { centre: Vec3::ZERO, normal: Vec3::Z, radius: 1.0, owner: owner(77) });
        let geometry = Geometry::build(shapes);
        let up = geometry.closest(&Ray::new(Vec3::Z, -Vec3::Z)).unwrap();
        assert_eq!((up.object, up.t), (0, 1.0));
        let down = geometry.closest(&Ray::new(-Vec3::Z, Vec3::Z)).unwrap();
        assert_eq!(down.object, 0);
    }
}

#[test]
fn copies_of_spheres_and_of_points_build_too() {
    let mut shapes = Shapes::new();
    for object in 0..20_000 {
        shapes.sphere(Sphere { centre: Vec3::X, radius: 0.5, owner: owner(object) });
        push(&mut shapes, [Vec3::ONE; 3], object);
    }
    let geometry = Geometry::build(shapes);
    let hit = geometry.closest(&Ray::new(Vec3::ZERO, Vec3::X)).unwrap();
    assert_eq!((hit.object, hit.t), (0, 0.5));
    assert!(geometry.closest(&Ray::new(Vec3::ZERO, Vec3::ONE.normalize())).is_none());
}

/// A tree too deep for its stack is finished by halving, and answers as before.
#[test]
fn a_tree_cut_short_gives_the_same_answers() {
    let mut shapes = Mesh::bumpy(3).shapes();
    for object in 0..40 {
        let centre = Vec3::splat(0.1 * object as f32 - 2.0);
        shapes.sphere(Sphere { centre, radius: 0.3, owner: owner(object) });
    }
    let whole = Geometry::build(shapes.clone());
    let mut chance = Chance::new(23);
    let rays: Vec<Ray> =
        (0..2000).map(|_| Ray::new(chance.cube().as_vec3(), chance.direction())).collect();
    for followed in 1..6 {
        let tree = Tree::followed(&shapes, followed);
        let cut = Geometry { tree, ..Geometry::build(shapes.clone()) };
        for ray in &rays {
            assert_eq!(cut.closest(ray), whole.closest(ray), "{ray:?}");
            assert_eq!(cut.occluded(ray), whole.occluded(ray), "{ray:?}");
        }
    }
}

/// Each half the size of the one before, towards a point: a tree as deep as floats allow.
#[test]
fn towers_of_ever_smaller_shapes_are_met() {
    let mut shapes = Shapes::new();
    for k in 0..120 {
        let size = 0.5_f32.powi(k);
        push(&mut shapes, CORNERS.map(|p| p * size + Vec3::new(0.0, 0.0, size)), k as u32);
        shapes.sphere(Sphere {
            centre: Vec3::new(4.0 * size, 0.0, 0.0),
            radius: 0.5 * size,
            owner: owner(1000 + k as u32),
        });
    }
    let geometry = Geometry::build(shapes);
    let hit = geometry.closest(&Ray::new(Vec3::new(0.0, 0.0, 2.0), -Vec3::Z)).unwrap();
    assert_eq!((hit.object, hit.t), (0, 1.0));
    // From the point they shrink to, the smallest is met first.
    let hit = geometry.closest(&Ray::new(Vec3::ZERO, Vec3::Z)).unwrap();
    assert_eq!((hit.object, hit.t), (119, 0.5_f32.powi(119)));
    let mut chance = Chance::new(21);
    for _ in 0..2000 {
        let (ray, _) = super::towards(chance.cube().as_vec3(), 0.1 * chance.cube());
        let found = geometry.closest(&ray).map(|hit| (hit.t, hit.primitive));
        assert_eq!(found, by_hand(&geometry, &ray), "{ray:?}");
    }
}

#[test]
fn the_tiny_beside_the_huge_is_met() {
    let mut shapes = Shapes::new();
    push(&mut shapes, CORNERS.map(|p| p * 1e7), 1);
    let tiny = DVec3::new(0.3, 0.2, 0.1);
    Mesh::icosphere(1).placed(1e-4, tiny).push(&mut shapes, owner(2));
    let geometry = Geometry::build(shapes);
    let mut chance = Chance::new(22);
    for _ in 0..5000 {
        let (ray, _) = super::towards(chance.cube().as_vec3() + 3.0 * Vec3::Z, tiny);
        let hit = geometry.closest(&ray).unwrap();
        assert_eq!(hit.object, 2);
        let (ray, _) = super::towards(chance.cube().as_vec3() + 3.0 * Vec3::Z, DVec3::ZERO);
        assert!(geometry.closest(&ray).is_some());
    }
}

#[test]
fn a_plane_ends_where_numbers_do() {
    let mut shapes = Shapes::new();
    shapes.plane(Plane { point: Vec3::ZERO, normal: Vec3::Y, owner: owner(0) });
    let geometry = Geometry::build(shapes);
    let mut met = 0;
    for k in 0..45 {
        let direction = Vec3::new(1.0, -(10_f64.powi(-k) as f32), 0.3).normalize();
        if let Some(hit) = geometry.closest(&Ray::new(Vec3::Y, direction)) {
            assert!(hit.t * hit.t < f32::INFINITY && hit.position.is_finite());
            assert!(hit.position.y.abs() <= hit.error.y);
            met += 1;
        }
    }
    assert!(met > 15);
}

#[test]
fn numbers_that_are_none_do_no_harm() {
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE, 0.0];
    let mut shapes = Shapes::new();
    for x in bad {
        for y in bad {
            push(&mut shapes, [Vec3::new(x, y, 1.0), Vec3::splat(y), CORNERS[2]], 1);
            let centre = Vec3::new(x, 0.0, y);
            shapes.sphere(Sphere { centre, radius: y, owner: owner(1) });
            shapes.disk(Disk { centre, normal: Vec3::splat(x), radius: y, owner: owner(1) });
            shapes.plane(Plane { point: centre, normal: Vec3::splat(y), owner: owner(1) });
        }
    }
    push(&mut shapes, CORNERS, 0);
    let geometry = Geometry::build(shapes);
    for x in bad {
        for direction in [Vec3::Z, Vec3::ZERO, Vec3::splat(x), Vec3::new(0.0, x, 1.0)] {
            for origin in [Vec3::NEG_Z, Vec3::splat(x)] {
                for t_max in bad.into_iter().chain(NO_NUMBERS) {
                    let ray = Ray { t_max, ..Ray::new(origin, direction) };
                    geometry.closest(&ray);
                    geometry.occluded(&ray);
                }
            }
        }
    }
}

/// Normals at the corners bend the shading normal; those that are none, or contrary, don't.
#[test]
fn shading_normals_stay_on_the_front() {
    let tilted = Vec3::new(0.6, 0.0, 0.8);
    let meet = |normal: Vec3| {
        let mut shapes = Shapes::new();
        let corners = CORNERS.map(|p| shapes.vertex(p));
        let normals = Some([(); 3].map(|()| shapes.normal(normal)));
        shapes.triangle(Triangle { corners, normals, owner: owner(0) });
        Geometry::build(shapes).closest(&Ray::new(-Vec3::Z, Vec3::Z)).unwrap()
    };
    assert!((meet(tilted).ns - tilted).length() < 1e-6);
    assert!((meet(-tilted).ns - tilted).length() < 1e-6);
    assert_eq!(meet(Vec3::ZERO).ns, Vec3::Z);
    assert_eq!(meet(Vec3::X).ns, Vec3::Z);
    assert_eq!(meet(Vec3::NAN).ns, Vec3::Z);
    assert_eq!(meet(tilted).ng, Vec3::Z);
}
