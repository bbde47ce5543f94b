//! A ray that leaves a surface never meets it by rounding, and never skips another one close by.

use glam::{DVec3, Vec3};

use super::meshes::{Chance, Mesh};
use crate::render::geometry::{
    Disk, Geometry, Hit, Owner, Plane, Point, Primitive, Ray, Shapes, Sphere, Triangle, between,
};

const SCALES: [f64; 6] = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e7];
/// Offsets, in sizes of the shape.
const OFFSETS: [f64; 4] = [0.0, 1.0, 1e3, 1e5];

/// One flat shape, of about unit size, to be met from `from` around its normal.
#[derive(Clone, Copy, Debug)]
enum Flat {
    Triangle,
    Disk,
    Plane,
}

fn flat(kind: Flat, chance: &mut Chance, scale: f64, centre: DVec3) -> (Geometry, Vec3) {
    let owner = Owner::default();
    let normal = chance.direction();
    let mut shapes = Shapes::new();
    let place = centre.as_vec3();
    match kind {
        Flat::Triangle => {
            let corners = [(); 3].map(|()| centre + scale * chance.cube());
            let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            let corners = corners.map(|p| shapes.vertex(p.as_vec3()));
            shapes.triangle(Triangle { corners, normals: None, owner });
            return (Geometry::build(shapes), middle.as_vec3());
        }
        Flat::Disk => {
            shapes.disk(Disk { centre: place, normal, radius: scale as f32, owner });
        }
        Flat::Plane => {
            shapes.plane(Plane { point: place, normal, owner });
        }
    }
    (Geometry::build(shapes), place)
}

/// A unit direction at an angle of this cosine to the normal (negative: behind).
fn at_cosine(chance: &mut Chance, normal: Vec3, cosine: f64) -> Vec3 {
    let n = normal.as_dvec3().normalize();
    let side = chance.direction().as_dvec3().cross(n).normalize_or(n.any_orthonormal_vector());
    (side * (1.0 - cosine * cosine).sqrt() + n * cosine).normalize().as_vec3()
}

/// Steep and grazing, in front and behind.
fn cosine(chance: &mut Chance) -> f64 {
    let grazing = 10_f64.powf(-6.0 * chance.unit());
    if chance.bits() & 1 == 0 { grazing } else { -grazing }
}

fn meet(geometry: &Geometry, chance: &mut Chance, aim: Vec3, scale: f64) -> Option<Hit> {
    let origin = (aim.as_dvec3() + scale * 2.0 * chance.cube()).as_vec3();
    let (ray, _) = super::towards(origin, aim.as_dvec3() + 0.05 * scale * chance.cube());
    geometry.closest(&ray)
}

// Rays in these tests don't know what they leave, but where it is said.

#[test]
fn flat_shapes_are_left_for_good() {
    let mut chance = Chance::new(11);
    for kind in [Flat::Triangle, Flat::Disk, Flat::Plane] {
        let mut left = 0;
        for (scale, offset) in SCALES.iter().flat_map(|s| OFFSETS.map(|o| (*s, o))) {
            for _ in 0..20 {
                let centre = scale * offset * chance.cube();
                let (geometry, aim) = flat(kind, &mut chance, scale, centre);
                for _ in 0..50 {
                    let Some(hit) = meet(&geometry, &mut chance, aim, scale) else { continue };
                    let cosine = cosine(&mut chance);
                    let ray = super::unnamed(hit.ray(at_cosine(&mut chance, hit.ng, cosine)));
                    assert!(!geometry.occluded(&ray), "{kind:?} × {scale}, cosine {cosine}");
                    left += 1;
                }
            }
        }
        assert!(left > 10_000, "only {left} rays left a {kind:?}");
    }
}

/// A hit at zero has no ulp to be off by; what is left is what f64 lost on the way there.
#[test]
fn a_triangle_through_the_origin_is_left_there_for_good() {
    let mut chance = Chance::new(17);
    for _ in 0..300 {
        let mut shapes = Shapes::new();
        let [a, b] = [(); 2].map(|()| chance.cube().as_vec3());
        let corners = [a, b, -a, -b].map(|p| shapes.vertex(p));
        shapes.quad(corners, Owner::default());
        let geometry = Geometry::build(shapes);
        for _ in 0..50 {
            let direction = chance.direction();
            // Exactly towards the origin, since a power of two moves no digit.
            let Some(hit) = geometry.closest(&Ray::new(-4.0 * direction, direction)) else {
                continue;
            };
            assert!(hit.position.length() < 1e-12, "{hit:?}");
            let cosine = cosine(&mut chance);
            let ray = super::unnamed(hit.ray(at_cosine(&mut chance, hit.ng, cosine)));
            assert!(!geometry.occluded(&ray), "{hit:?}, cosine {cosine}");
        }
    }
}

#[test]
fn spheres_are_left_outwards_for_good_and_inwards_to_the_far_side() {
    let mut chance = Chance::new(12);
    for (scale, offset) in SCALES.iter().flat_map(|s| [0.0, 1.0, 1e3].map(|o| (*s, o))) {
        let centre = (scale * offset * chance.cube()).as_vec3();
        let mut shapes = Shapes::new();
        shapes.sphere(Sphere { centre, radius: scale as f32, owner: Owner::default() });
        let geometry = Geometry::build(shapes);
        for _ in 0..3000 {
            let Some(hit) = meet(&geometry, &mut chance, centre, scale) else { continue };
            let cosine = cosine(&mut chance);
            let again =
                geometry.closest(&super::unnamed(hit.ray(at_cosine(&mut chance, hit.ng, cosine))));
            if cosine > 0.0 {
                assert_eq!(again, None, "× {scale} + {offset}, cosine {cosine}");
            } else if cosine < -1e-3 {
                // The chord, to within what positions so far from the origin can tell.
                let chord = -2.0 * cosine * scale;
                let slack = 1e-6 * scale * (1.0 + offset) / -cosine;
                let t = f64::from(again.unwrap_or_else(|| panic!("leaks, {cosine}")).t);
                assert!((t - chord).abs() <= slack, "{t} for {chord} × {scale} + {offset}");
            }
        }
    }
}

/// Two sheets so close that an epsilon would take a ray through the other.
#[test]
fn a_sheet_close_above_is_never_skipped() {
    let mut chance = Chance::new(13);
    for scale in SCALES {
        for _ in 0..50 {
            let n = chance.direction().as_dvec3();
            let (x, y) = n.any_orthonormal_pair();
            let mut shapes = Shapes::new();
            // 32 ulps of the coordinates.
            let gap = 32.0 * f64::from(f32::EPSILON);
            let sheets = [0.0, gap].map(|height| {
                let corners = [x + y, y - x, -x - y, x - y]
                    .map(|side| shapes.vertex((scale * (side + height * n)).as_vec3()));
                shapes.quad(corners, Owner::default())
            });
            let geometry = Geometry::build(shapes);
            for _ in 0..40 {
                let middle = (scale * 0.3 * chance.signed() * x).as_vec3();
                let origin = middle + (n * scale).as_vec3() * [1.0, -1.0][chance.below(2)];
                let (ray, _) = super::towards(origin, middle.as_dvec3());
                let Some(hit) = geometry.closest(&ray) else { panic!("{ray:?} misses") };
                let on = |sheet: [Primitive; 2]| sheet.contains(&hit.primitive);
                let into = if on(sheets[0]) { hit.ng } else { -hit.ng };
                let cosine = 10_f64.powf(-2.0 * chance.unit());
                let between = super::unnamed(hit.ray(at_cosine(&mut chance, into, cosine)));
                let other = geometry.closest(&between).expect("the other sheet is there");
                assert_ne!(on(sheets[0]), sheets[0].contains(&other.primitive), "{between:?}");
            }
        }
    }
}

/// From inside a closed mesh that wraps another one tightly, nothing gets out.
#[test]
fn a_skin_close_around_a_mesh_is_never_skipped() {
    let mut chance = Chance::new(14);
    for scale in [1e-6, 1.0, 1e7] {
        let mesh = Mesh::bumpy(4);
        let mut shapes = Shapes::new();
        mesh.clone().placed(scale, DVec3::ZERO).push(&mut shapes, Owner::default());
        let skin = Owner { object: 1, material: 0 };
        mesh.placed(scale * (1.0 + 1e-5), DVec3::ZERO).push(&mut shapes, skin);
        let geometry = Geometry::build(shapes);
        let mut tried = 0;
        while tried < 20_000 {
            let ray = Ray::new(Vec3::ZERO, chance.direction());
            let hit = geometry.closest(&ray).expect("the mesh is closed");
            assert_eq!(hit.object, 0);
            let cosine = 0.05 + 0.95 * chance.unit();
            let out = at_cosine(&mut chance, hit.ng, cosine);
            let next = geometry.closest(&super::unnamed(hit.ray(out))).expect("the skin is closed");
            tried += 1;
            assert!(next.t > 0.0);
        }
    }
}

/// Any two points of a convex room see each other, until something stands between.
#[test]
fn shadow_rays_see_whatever_is_there_to_see() {
    let mut chance = Chance::new(15);
    for (scale, offset) in SCALES.iter().flat_map(|s| [0.0, 1.0, 100.0].map(|o| (*s, o))) {
        let centre = scale * offset * chance.cube();
        let room = Mesh::icosphere(2).placed(scale, centre);
        let mut shapes = room.shapes();
        let radius = (3.0 * scale) as f32;
        let owner = Owner::default();
        let sphere = shapes.sphere(Sphere { centre: centre.as_vec3(), radius, owner });
        let walls: Vec<Primitive> = shapes.primitives().filter(|p| *p != sphere).collect();
        let open = Geometry::build(shapes);
        let mut seen = 0;
        for _ in 0..3000 {
            let [from, to] = [(); 2].map(|()| {
                let wall = walls[chance.below(walls.len())];
                open.sample(wall, chance.square()).unwrap()
            });
            let way = to.position - from.position;
            let steep = |p: &Point| way.normalize_or_zero().dot(p.ng).abs() > 0.01;
            if steep(&from) && steep(&to) && way.length() as f64 > 0.1 * scale {
                assert!(!open.occluded(&super::unnamed(between(&from, &to))), "{from:?} {to:?}");
                seen += 1;
            }
            let lamp = Point::free((centre + 0.3 * scale * chance.cube()).as_vec3());
            assert!(!open.occluded(&super::unnamed(between(&from, &lamp))));
            assert!(!open.occluded(&super::unnamed(between(&lamp, &to))));
            let outside = open.sample(sphere, chance.square()).unwrap();
            assert!(open.occluded(&super::unnamed(between(&lamp, &outside))), "through a wall");
        }
        assert!(seen > 1500, "only {seen}");
    }
}

/// Where coordinates are small their errors are too, and the direction's rounding is what is left.
#[test]
fn a_long_shadow_ray_ends_before_a_surface_through_the_origin() {
    let mut chance = Chance::new(16);
    let owner = Owner::default();
    for scale in SCALES {
        let mut shapes = Shapes::new();
        let normal = chance.direction();
        let radius = scale as f32;
        let lamp = shapes.disk(Disk { centre: Vec3::ZERO, normal, radius, owner });
        let geometry = Geometry::build(shapes);
        for _ in 0..3000 {
            let u = 1e-3 * chance.square() + 0.5;
            let to = geometry.sample(lamp, u).unwrap();
            let cosine = cosine(&mut chance);
            if cosine.abs() < 1e-3 {
                continue;
            }
            let away = at_cosine(&mut chance, normal, cosine) * (50.0 * scale) as f32;
            let from = Point::free(to.position + away);
            assert!(
                !geometry.occluded(&super::unnamed(between(&from, &to))),
                "cosine {cosine} × {scale}"
            );
        }
    }
}

#[test]
fn points_at_one_place_have_nothing_between_them() {
    let at = Point::free(Vec3::new(1.0, 2.0, 3.0));
    let ray = between(&at, &at);
    assert_eq!(ray.t_max, 0.0);
    assert!((ray.direction.length() - 1.0).abs() < 1e-6);
    let geometry = Geometry::build(Mesh::icosphere(0).shapes());
    assert!(!geometry.occluded(&ray));
}

/// A name changes no answer: what it leaves out is not met.
#[test]
fn names_of_surfaces_left_and_reached_change_no_answer() {
    let mut chance = Chance::new(18);
    for (scale, offset) in SCALES.iter().flat_map(|s| OFFSETS.map(|o| (*s, o))) {
        let centre = scale * offset * chance.cube();
        let geometry = Geometry::build(Mesh::bumpy(3).placed(scale, centre).shapes());
        let mut named = 0;
        for _ in 0..300 {
            let aim = (centre + 0.3 * scale * chance.cube()).as_vec3();
            let Some(from) = meet(&geometry, &mut chance, aim, scale) else { continue };
            let cosine = cosine(&mut chance);
            let ray = from.ray(at_cosine(&mut chance, from.ng, cosine));
            assert_eq!(geometry.closest(&ray), geometry.closest(&super::unnamed(ray)), "{ray:?}");
            let Some(to) = meet(&geometry, &mut chance, aim, scale) else { continue };
            let ray = between(&from.point(), &to.point());
            let expected = geometry.occluded(&super::unnamed(ray));
            assert_eq!(geometry.occluded(&ray), expected, "{ray:?}");
            named += usize::from([ray.leaves, ray.reaches] == [from.sheet, to.sheet]);
        }
        assert!(named > 100, "{named}");
    }
}
