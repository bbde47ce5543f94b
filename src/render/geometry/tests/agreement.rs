//! The tree answers as asking every shape does, and as textbook formulas in f64 do.

use glam::{DVec3, Vec3};

use super::by_hand;
use super::meshes::{Chance, Mesh};
use crate::render::geometry::{Disk, Geometry, Owner, Plane, Ray, Shapes, Sphere, Triangle};

/// Triangles of all sizes and shapes, a third of them slivers, and some that share edges.
pub(super) fn soup(chance: &mut Chance, triangles: usize, size: f64) -> Shapes {
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    for i in 0..triangles {
        let centre = chance.cube();
        let size = size * 10_f64.powf(2.0 * chance.signed());
        let thin = if i % 3 == 0 { 1e-4 } else { 1.0 };
        let side = chance.cube() * size;
        let corners = [centre, centre + side, centre + chance.cube() * size * thin + 0.5 * side];
        let [a, b, c] = corners.map(|p| shapes.vertex(p.as_vec3()));
        shapes.triangle(Triangle { corners: [a, b, c], normals: None, owner });
        if i % 5 == 0 {
            let d = shapes.vertex((centre + chance.cube() * size).as_vec3());
            shapes.triangle(Triangle { corners: [c, b, d], normals: None, owner });
        }
    }
    shapes
}

pub(super) fn add_round(chance: &mut Chance, shapes: &mut Shapes, count: usize) {
    let owner = Owner::default();
    for _ in 0..count {
        let centre = chance.cube().as_vec3();
        let radius = 10_f64.powf(chance.signed() - 1.5) as f32;
        shapes.sphere(Sphere { centre, radius, owner });
        let (centre, normal) = (chance.cube().as_vec3(), chance.direction());
        shapes.disk(Disk { centre, normal, radius, owner });
    }
    shapes.plane(Plane { point: 3.0 * chance.direction(), normal: chance.direction(), owner });
}

pub(super) fn ray(chance: &mut Chance, far: f64) -> Ray {
    let origin = (far * chance.cube()).as_vec3();
    let direction = match chance.below(8) {
        0 => [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z][chance.below(6)],
        1 => (chance.cube() * DVec3::new(1.0, 1.0, 0.0)).as_vec3().normalize(),
        2 => (chance.cube() * DVec3::new(1.0, 1e-12, 1e-25)).as_vec3().normalize_or(Vec3::X),
        _ => (chance.cube().as_vec3() - origin).normalize(),
    };
    Ray::new(origin, direction)
}

/// The same meeting to the bit, and the same answer about shadows, for any length of the ray.
fn agrees(geometry: &Geometry, ray: Ray) {
    let expected = by_hand(geometry, &ray);
    let found = geometry.closest(&ray).map(|hit| (hit.t, hit.primitive));
    assert_eq!(found, expected, "{ray:?}");
    assert_eq!(geometry.occluded(&ray), expected.is_some(), "{ray:?}");
    if let Some((t, _)) = expected {
        let up_to = |t_max| Ray { t_max, ..ray };
        assert!(!geometry.occluded(&up_to(t)), "nothing before the first: {ray:?}");
        assert!(geometry.closest(&up_to(t)).is_none());
        assert!(geometry.occluded(&up_to(t.next_up())), "{ray:?}");
        assert!(geometry.closest(&up_to(t.next_up())).is_some());
    }
}

#[test]
fn the_tree_changes_no_answer() {
    let mut chance = Chance::new(1);
    for (triangles, size, far) in
        [(1, 1.0, 2.0), (5, 1.0, 2.0), (300, 0.3, 2.0), (300, 1e-4, 1.5), (1000, 0.1, 1e4)]
    {
        let mut shapes = soup(&mut chance, triangles, size);
        add_round(&mut chance, &mut shapes, triangles / 10);
        let geometry = Geometry::build(shapes);
        for _ in 0..2000 {
            agrees(&geometry, ray(&mut chance, far));
        }
    }
}

#[test]
fn the_tree_changes_no_answer_at_any_scale_and_offset() {
    let mut chance = Chance::new(2);
    for scale in [1e-9, 1e-4, 1e7] {
        let mesh = Mesh::bumpy(2).placed(scale, DVec3::ZERO);
        let geometry = Geometry::build(mesh.shapes());
        for _ in 0..3000 {
            let Ray { origin, direction, .. } = ray(&mut chance, 1.5);
            agrees(&geometry, Ray::new(origin * scale as f32, direction));
        }
    }
    for offset in [1e3, 1e5] {
        let mesh = Mesh::bumpy(2).placed(1.0, DVec3::splat(offset));
        let geometry = Geometry::build(mesh.shapes());
        for _ in 0..3000 {
            let Ray { origin, direction, .. } = ray(&mut chance, 1.5);
            agrees(&geometry, Ray::new(origin + offset as f32, direction));
        }
    }
}

/// Möller and Trumbore's test, which shares nothing with ours: t, and the least weight.
fn textbook(ray: &Ray, [a, b, c]: [DVec3; 3]) -> Option<(f64, f64)> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (e, f) = (b - a, c - a);
    let p = d.cross(f);
    let det = e.dot(p);
    if det.abs() < 1e-9 * e.length() * f.length() {
        return None;
    }
    let s = o - a;
    let u = s.dot(p) / det;
    let q = s.cross(e);
    let v = d.dot(q) / det;
    let t = f.dot(q) / det;
    (t > 0.0).then_some((t, u.min(v).min(1.0 - u - v)))
}

#[test]
fn meetings_are_where_the_textbook_has_them() {
    let mut chance = Chance::new(3);
    let mut clear = 0;
    for _ in 0..60_000 {
        let corners = [(); 3].map(|()| chance.cube().as_vec3());
        let mut shapes = Shapes::new();
        let indices = corners.map(|p| shapes.vertex(p));
        let owner = Owner { object: 7, material: 3 };
        shapes.triangle(Triangle { corners: indices, normals: None, owner });
        let geometry = Geometry::build(shapes);
        let ray = ray(&mut chance, 3.0);
        let found = geometry.closest(&ray);
        let corners = corners.map(|p| p.as_dvec3());
        let Some((t, least)) = textbook(&ray, corners) else { continue };
        if least.abs() < 1e-9 {
            continue;
        }
        assert_eq!(found.is_some(), least > 0.0, "{ray:?}");
        let Some(hit) = found else { continue };
        clear += 1;
        assert!((f64::from(hit.t) - t).abs() <= 1e-6 * t, "{ray:?}");
        let place = ray.origin.as_dvec3() + t * ray.direction.as_dvec3();
        assert!((hit.position.as_dvec3() - place).length() < 1e-6, "{ray:?}");
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        assert!((hit.ng.as_dvec3() - normal).length() < 1e-6);
        let off = (hit.position.as_dvec3() - corners[0]).dot(normal).abs();
        assert!(off <= hit.error.as_dvec3().dot(normal.abs()), "{off} beyond {}", hit.error);
        let [u, v] = hit.uv.to_array();
        let again = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
        assert!((hit.position.as_dvec3() - again).length() < 1e-6);
        assert_eq!((hit.object, hit.material), (7, 3));
    }
    assert!(clear > 2000, "only {clear} rays met their triangle");
}

/// From far away, from near, from within; big and small.
#[test]
fn spheres_are_met_where_they_are() {
    let mut chance = Chance::new(4);
    for scale in [1e-6, 1.0, 1e7] {
        for (far, least) in [(0.5, 1.0), (3.0, 0.5), (1e5, 0.5)] {
            let radius = scale as f32;
            let centre = (scale * chance.cube()).as_vec3();
            let mut shapes = Shapes::new();
            shapes.sphere(Sphere { centre, radius, owner: Owner::default() });
            let geometry = Geometry::build(shapes);
            for _ in 0..2000 {
                let origin = centre + chance.direction() * (far * scale) as f32;
                let side = chance.cube() * (least * scale) / 3_f64.sqrt();
                let (ray, _) = super::towards(origin, centre.as_dvec3() + side);
                let hit = geometry.closest(&ray).unwrap_or_else(|| panic!("{ray:?} misses"));
                let local = hit.position.as_dvec3() - centre.as_dvec3();
                let off = (local.length() - f64::from(radius)).abs();
                assert!(off <= hit.error.as_dvec3().length(), "{off:e} off: {ray:?}");
                assert!((local.normalize() - hit.ng.as_dvec3()).length() < 1e-5 * far.max(1.0));
                let inside = far < 1.0;
                assert_eq!(hit.ng.dot(ray.direction) > 0.0, inside, "{ray:?}");
                let at = origin.as_dvec3() + f64::from(hit.t) * ray.direction.as_dvec3();
                let slack = 1e-6 * scale * far.max(1.0);
                assert!((at - hit.position.as_dvec3()).length() < slack, "{ray:?}");
            }
        }
    }
}

/// Where b² − a·c has lost all that tells a hit from a miss.
#[test]
fn a_far_sphere_is_met_from_straight_above() {
    let mut shapes = Shapes::new();
    shapes.sphere(Sphere { centre: Vec3::ZERO, radius: 1.0, owner: Owner::default() });
    let geometry = Geometry::build(shapes);
    for z in [1e3, 1e6, 1e9, 1e12] {
        for (x, height) in [(0.0, 1.0), (0.6, 0.8), (0.8, 0.6), (1.0_f32.next_down(), 0.0)] {
            let hit = geometry.closest(&Ray::new(Vec3::new(x, 0.0, z), Vec3::NEG_Z)).unwrap();
            assert!((hit.position - Vec3::new(x, 0.0, height)).length() < 1e-3, "{hit:?}");
        }
        let past = Ray::new(Vec3::new(1.0_f32.next_up(), 0.0, z), Vec3::NEG_Z);
        assert_eq!(geometry.closest(&past), None);
    }
}

#[test]
fn disks_end_at_their_rims_and_planes_never() {
    let owner = Owner::default();
    let normal = Vec3::new(1.0, 2.0, -2.0) / 3.0;
    let centre = Vec3::new(0.5, -1.0, 2.0);
    let (x, y) = normal.any_orthonormal_pair();
    let mut shapes = Shapes::new();
    let disk = shapes.disk(Disk { centre, normal, radius: 2.0, owner });
    let plane = shapes.plane(Plane { point: centre - 0.5 * normal, normal, owner });
    let geometry = Geometry::build(shapes);
    for (reach, met) in [(0.0, disk), (1.99999, disk), (2.00001, plane), (1e6, plane)] {
        for turn in 0..16 {
            let side = x * (turn as f32).cos() + y * (turn as f32).sin();
            let above = centre + side * reach + normal;
            let hit = geometry.closest(&Ray::new(above, -normal)).unwrap();
            assert_eq!(hit.primitive, met, "at {reach}");
            assert!((hit.ng - normal).length() < 1e-6);
            let t = if met == disk { 1.0 } else { 1.5 };
            assert!((hit.t - t).abs() < 1e-6 * reach.max(1.0));
            let away = geometry.closest(&Ray::new(above, normal));
            assert_eq!(away.map(|hit| hit.primitive), None);
        }
    }
}
