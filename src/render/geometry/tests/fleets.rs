//! Rays that go through a large tree at once answer as single rays do, to the bit.

use glam::Vec3;

use super::NO_NUMBERS;
use super::agreement::{add_round, ray, soup};
use super::meshes::Chance;
use crate::render::geometry::{Geometry, Owner, Ray, Shapes, Triangle, between};

/// How many of the rays meet something; all answers are those of single rays, in streams of any
/// length, by any instructions.
fn agree(shapes: &Shapes, rays: &[Ray]) -> usize {
    let mut count = 0;
    for portable in [false, true] {
        let geometry = Geometry::build(shapes.clone()).with_portable(portable);
        assert!(geometry.few.is_none(), "a scene of many triangles");
        let expected: Vec<_> =
            rays.iter().map(|ray| (geometry.meet(ray), geometry.occluded(ray))).collect();
        count = expected.iter().filter(|(met, _)| met.is_some()).count();
        for length in [31, 32, 33, 63, 64, 65, 300, rays.len()] {
            for (rays, expected) in rays.chunks(length).zip(expected.chunks(length)).take(9) {
                let (mut met, mut occluded) = (vec![None; rays.len()], vec![true; rays.len()]);
                geometry.meet_all(rays, &mut met);
                geometry.occluded_all(rays, &mut occluded);
                for (i, ray) in rays.iter().enumerate() {
                    assert_eq!((met[i], occluded[i]), expected[i], "{ray:?}");
                }
            }
        }
    }
    count
}

/// Rays, the ways on from where they end, and what just reaches what they meet.
fn onwards(chance: &mut Chance, geometry: &Geometry, count: usize, far: f64) -> Vec<Ray> {
    let mut rays = Vec::new();
    while rays.len() < count {
        let one = ray(chance, far);
        rays.push(one);
        let Some(hit) = geometry.closest(&one) else { continue };
        let next = hit.ray(chance.direction());
        let ends = [hit.t, hit.t.next_up(), hit.t.next_down(), 0.5 * hit.t, 0.0, f32::NAN];
        rays.extend([next, Ray { reaches: hit.sheet, ..one }]);
        rays.push(Ray { t_max: ends[chance.below(ends.len())], ..one });
        let end = geometry.closest(&next);
        rays.extend(end.map(|end| between(&hit.point(), &end.point())));
    }
    rays
}

#[test]
fn fleets_answer_as_single_rays_do() {
    let mut chance = Chance::new(90);
    for (triangles, size, far) in [(300, 0.3, 2.0), (1000, 0.1, 1e4), (3000, 0.03, 1.5)] {
        for round in [0, 20] {
            let mut shapes = soup(&mut chance, triangles, size);
            add_round(&mut chance, &mut shapes, round);
            let rays = onwards(&mut chance, &Geometry::build(shapes.clone()), 3000, far);
            assert!(agree(&shapes, &rays) > 1000);
        }
    }
}

/// Where several triangles are met at once, the least is, in whichever order they are come to.
#[test]
fn of_copies_fleets_meet_the_first() {
    let mut chance = Chance::new(91);
    let mut shapes = Shapes::new();
    for number in 0..200 {
        let mut corners = [Vec3::new(-1.0, -1.1, 0.3), Vec3::new(1.0, -0.9, 0.1), Vec3::Y];
        corners.rotate_left(number as usize % 3);
        let corners = corners.map(|p| shapes.vertex(p));
        let owner = Owner { object: number, material: 0 };
        shapes.triangle(Triangle { corners, normals: None, owner });
    }
    let rays = onwards(&mut chance, &Geometry::build(shapes.clone()), 2000, 1.0);
    assert!(agree(&shapes, &rays) > 200);
}

/// Rays that are none, of other lengths, and so far off that they go alone, beside usual ones.
#[test]
fn odd_rays_do_a_fleet_no_harm() {
    let mut chance = Chance::new(92);
    let bad = [f32::INFINITY, -f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, 0.0, 1e25];
    let bad = [&bad[..], &NO_NUMBERS].concat();
    for extreme in [false, true] {
        let mut shapes = soup(&mut chance, 300, 1.0);
        if extreme {
            // Parts of it are no numbers in f32.
            let corners = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)];
            let corners = corners.map(|(x, y)| shapes.vertex(Vec3::new(1e25 * x, 1e25 * y, 0.3)));
            shapes.triangle(Triangle { corners, normals: None, owner: Owner::default() });
        }
        let odd = |i: usize| {
            let usual = ray(&mut chance, 2.0);
            let Ray { origin, direction, .. } = usual;
            let odd = bad[chance.below(bad.len())];
            match i % 6 {
                0 => Ray::new(Vec3::new(odd, 0.0, 1.0), direction),
                1 => Ray::new(origin, Vec3::new(0.5, odd, 1.0)),
                2 => Ray { t_max: odd, ..usual },
                3 => Ray::new(origin, direction * 10_f64.powf(30.0 * chance.signed()) as f32),
                _ => usual,
            }
        };
        let rays: Vec<_> = (0..3000).map(odd).collect();
        assert!(agree(&shapes, &rays) > 1000);
    }
}
