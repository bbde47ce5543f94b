//! Packets of rays answer as single rays do, to the bit, whatever instructions they are met by.

use glam::{DVec3, Vec3};

use super::NO_NUMBERS;
use super::agreement::{add_round, ray, soup};
use super::instances;
use super::meshes::{Chance, Mesh};
use super::watertight::cube;
use crate::render::geometry::hits::HitAll;
use crate::render::geometry::lanes::Portable;
use crate::render::geometry::stream::{MeetAll, OccludedAll};
use crate::render::geometry::wide::{Job, Wide};
use crate::render::geometry::{Geometry, Owner, Ray, Shapes, Sphere, Triangle, between};

/// Does something by all instructions this processor has.
fn by_each(mut job: impl FnMut(&dyn Fn(Question))) {
    job(&|question| question.ask(Portable));
    #[cfg(target_arch = "x86_64")]
    {
        use crate::render::geometry::avx2::Avx2;
        use crate::render::geometry::wide::Avx512;
        if let Some(wide) = Avx2::found() {
            job(&|question| question.ask(wide));
        }
        if let Some(wide) = Avx512::found() {
            job(&|question| question.ask(wide));
        }
    }
}

enum Question<'a> {
    Meet(MeetAll<'a>),
    Occluded(OccludedAll<'a>),
    Hit(HitAll<'a>),
}

impl Question<'_> {
    fn ask<W: Wide>(self, wide: W) {
        fn run<W: Wide, J: Job>(wide: W, job: J) {
            wide.apart(job);
        }
        match self {
            Self::Meet(job) => run(wide, job),
            Self::Occluded(job) => run(wide, job),
            Self::Hit(job) => run(wide, job),
        }
    }
}

/// How many of the rays meet something; all answers are those of single rays, in full packets and in
/// such as lack some.
fn agree(geometry: &Geometry, rays: &[Ray]) -> usize {
    for rays in
        rays[..rays.len().min(600)].chunks(15).flat_map(|some| [some, &some[..some.len() / 2]])
    {
        agree_in_one(geometry, rays);
    }
    agree_in_one(geometry, rays)
}

fn agree_in_one(geometry: &Geometry, rays: &[Ray]) -> usize {
    let few = geometry.few.as_ref().expect("a scene of few triangles");
    let expected: Vec<_> = rays.iter().map(|ray| geometry.meet(ray)).collect();
    by_each(|ask| {
        let mut met = vec![None; rays.len()];
        ask(Question::Meet(MeetAll { geometry, few, rays, met: &mut met }));
        let mut any = vec![false; rays.len()];
        let mut hits = vec![None; rays.len()];
        ask(Question::Hit(HitAll { geometry, rays, met: &expected, hits: &mut hits }));
        ask(Question::Occluded(OccludedAll { geometry, few, rays, occluded: &mut any }));
        for (i, ray) in rays.iter().enumerate() {
            assert_eq!(met[i], expected[i], "{ray:?}");
            assert_eq!(hits[i], geometry.closest(ray), "{ray:?}");
            assert_eq!(any[i], geometry.occluded(ray), "{ray:?}");
        }
    });
    expected.iter().flatten().count()
}

/// The same of rays, of the ways on from where they end, and of what just reaches what they meet.
fn agree_onwards(geometry: &Geometry, rays: Vec<Ray>, chance: &mut Chance) -> usize {
    let mut all = rays.clone();
    for ray in rays {
        let Some(hit) = geometry.closest(&ray) else { continue };
        let next = hit.ray(chance.direction());
        all.push(next);
        // What it is not to meet stands in its way.
        all.push(Ray { leaves: hit.sheet, ..ray });
        all.push(Ray { reaches: hit.sheet, ..ray });
        let ends = [hit.t, hit.t.next_up(), hit.t.next_down(), 0.5 * hit.t, 0.0, f32::NAN];
        all.push(Ray { t_max: ends[chance.below(ends.len())], ..ray });
        if let Some(end) = geometry.closest(&next) {
            all.push(between(&hit.point(), &end.point()));
        }
    }
    agree(geometry, &all)
}

#[test]
fn packets_answer_as_single_rays_do() {
    let mut chance = Chance::new(70);
    for (triangles, size, far) in
        [(1, 1.0, 2.0), (5, 1.0, 2.0), (40, 0.3, 2.0), (100, 1e-3, 1.5), (100, 0.1, 1e4)]
    {
        for round in [0, 1] {
            let mut shapes = soup(&mut chance, triangles, size);
            add_round(&mut chance, &mut shapes, round);
            let geometry = Geometry::build(shapes);
            let rays = (0..3000).map(|_| ray(&mut chance, far)).collect();
            agree_onwards(&geometry, rays, &mut chance);
        }
    }
}

/// Normals and coordinates at the corners, of some triangles.
#[test]
fn packets_find_out_all_about_their_hits() {
    let mut chance = Chance::new(77);
    let mut shapes = Shapes::new();
    for number in 0..60 {
        let corners = [(); 3].map(|()| shapes.vertex(chance.cube().as_vec3()));
        let turned = [(); 3].map(|()| shapes.normal(chance.direction()));
        let normals = (number % 3 != 0).then_some(turned);
        let owner = Owner { object: number, material: number + 1 };
        let triangle = shapes.triangle(Triangle { corners, normals, owner });
        if number % 2 == 0 {
            let laid = [(); 3].map(|()| shapes.coordinate(chance.square()));
            shapes.lay(triangle, laid);
        }
    }
    for coordinates in [true, false] {
        let geometry = Geometry::build(shapes.clone()).with_coordinates(coordinates);
        let rays = (0..3000).map(|_| ray(&mut chance, 1.0)).collect();
        assert!(agree_onwards(&geometry, rays, &mut chance) > 3000);
    }
}

/// At corners and edges, from inside and from outside, where f32 can't tell.
#[test]
fn packets_lose_no_ray_at_edges_and_corners() {
    let mut chance = Chance::new(71);
    for (scale, offset) in
        [(1e-30, 0.0), (1e-9, 0.0), (1.0, 0.0), (1e7, 0.0), (1.0, 1e3), (1.0, 1e5)]
    {
        let centre = DVec3::new(offset, -offset, 0.5 * offset);
        let mesh = Mesh::icosphere(1).placed(scale, centre);
        let geometry = Geometry::build(mesh.shapes());
        let mut rays = Vec::new();
        for i in 0..4000 {
            let [a, b, _] = mesh.triangles[chance.below(mesh.triangles.len())];
            let (a, b) = (mesh.positions[a as usize], mesh.positions[b as usize]);
            let along = [0.0, 0.5, chance.unit()][i % 3];
            let (a, b) = (a.as_vec3().as_dvec3(), b.as_vec3().as_dvec3());
            let from = if i % 2 == 0 { 0.1 * chance.cube() } else { 3.0 * chance.cube() };
            let from = (centre + scale * from).as_vec3();
            rays.push(super::towards(from, a.lerp(b, along)).0);
        }
        let inside: Vec<Ray> = rays.iter().step_by(2).copied().collect();
        assert_eq!(agree(&geometry, &inside), inside.len());
        agree_onwards(&geometry, rays, &mut chance);
    }
}

/// Along the axes and along the faces, with every sign of zero.
#[test]
fn packets_run_along_the_axes() {
    let mut chance = Chance::new(72);
    for scale in [1e-9_f32, 1.0, 1e7] {
        let geometry = Geometry::build(cube(1, scale));
        let mut rays = Vec::new();
        for axis in 0..3 {
            for (i, j, k) in (0..1000).map(|n| (n % 10, n / 10 % 10, n / 100)) {
                let mut direction = [[0.0, -0.0][i % 2], 0.0, [0.0, -0.0][j % 2]];
                direction[axis] = [1.0, -1.0][k % 2];
                let origin = [i, j, k].map(|at| (0.5 * at as f32 - 2.0) * scale);
                rays.push(Ray::new(origin.into(), direction.into()));
            }
        }
        let met = agree_onwards(&geometry, rays, &mut chance);
        assert!(met > 500, "{met}");
    }
}

/// Where several triangles are met at once, the least is; from whichever end they are told.
#[test]
fn of_copies_packets_meet_the_first() {
    let mut chance = Chance::new(73);
    let mut shapes = Shapes::new();
    for number in 0..100 {
        // Corners in every order: the planes are made of other numbers.
        let turn = number as usize % 3;
        let mut corners = [Vec3::new(-1.0, -1.1, 0.3), Vec3::new(1.0, -0.9, 0.1), Vec3::Y];
        corners.rotate_left(turn);
        let corners = corners.map(|p| shapes.vertex(p));
        let owner = Owner { object: number, material: 0 };
        shapes.triangle(Triangle { corners, normals: None, owner });
    }
    shapes.sphere(Sphere { centre: Vec3::Z, radius: 0.2, owner: Owner::default() });
    let geometry = Geometry::build(shapes);
    let rays = (0..2000).map(|_| ray(&mut chance, 1.0)).collect();
    assert!(agree_onwards(&geometry, rays, &mut chance) > 300);
}

/// Sheets as close as f32 can have them, and through each other: f64 alone tells which is first.
#[test]
fn of_sheets_close_together_packets_meet_the_first() {
    let mut chance = Chance::new(78);
    let mut met = 0;
    for _ in 0..60 {
        let mut shapes = Shapes::new();
        let slopes = chance.cube();
        for _ in 0..4 {
            let corners = [(-1.0, -1.1), (1.0, -0.9), (0.1, 1.0)].map(|(x, y)| {
                let (x, y) = (x + 0.1 * chance.unit(), y + 0.1 * chance.unit());
                let z = (0.3 + slopes.x * x + slopes.y * y) as f32;
                let z = (0..chance.below(6)).fold(z, |z, _| z.next_up());
                shapes.vertex(Vec3::new(x as f32, y as f32, z))
            });
            shapes.triangle(Triangle { corners, normals: None, owner: Owner::default() });
        }
        let geometry = Geometry::build(shapes);
        let rays: Vec<_> = (0..100).map(|_| ray(&mut chance, 1.0)).collect();
        met += agree_onwards(&geometry, rays, &mut chance);
    }
    assert!(met > 1000, "{met}");
}

#[test]
fn packets_meet_instances_too() {
    let mut chance = Chance::new(74);
    let geometry = instances::crowd(75, 1);
    let rays =
        (0..1000).map(|_| Ray::new((2.0 * chance.cube()).as_vec3(), chance.direction())).collect();
    assert!(agree_onwards(&geometry, rays, &mut chance) > 500);
}

/// Rays that are none, of other lengths, and far off, beside usual ones.
#[test]
fn odd_rays_do_a_packet_no_harm() {
    let mut chance = Chance::new(76);
    let bad = [f32::INFINITY, -f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, 0.0, 1e25];
    let bad = [&bad[..], &NO_NUMBERS].concat();
    for extreme in [false, true] {
        let mut shapes = soup(&mut chance, 30, 1.0);
        if extreme {
            let corners = [Vec3::splat(1e30), Vec3::X * 1e36, Vec3::Y].map(|p| shapes.vertex(p));
            shapes.triangle(Triangle { corners, normals: None, owner: Owner::default() });
        }
        let geometry = Geometry::build(shapes);
        assert_eq!(geometry.few.is_some(), !extreme);
        let mut rays = Vec::new();
        for i in 0..6000 {
            let usual = ray(&mut chance, 2.0);
            let Ray { origin, direction, .. } = usual;
            let odd = bad[chance.below(bad.len())];
            rays.push(match i % 6 {
                0 => Ray::new(Vec3::new(odd, 0.0, 1.0), direction),
                1 => Ray::new(origin, Vec3::new(0.5, odd, 1.0)),
                2 => Ray { t_max: odd, ..usual },
                3 => Ray::new(origin, direction * 10_f64.powf(30.0 * chance.signed()) as f32),
                _ => usual,
            });
        }
        if !extreme {
            agree(&geometry, &rays);
        }
        for count in [0, 1, 2, 3, 15, 16, 17, 64, 6000] {
            let rays = &rays[..count];
            let (mut met, mut any) = (vec![None; count], vec![true; count]);
            geometry.meet_all(rays, &mut met);
            geometry.occluded_all(rays, &mut any);
            for (i, ray) in rays.iter().enumerate() {
                assert_eq!(
                    (met[i], any[i]),
                    (geometry.meet(ray), geometry.occluded(ray)),
                    "{ray:?}"
                );
            }
        }
    }
}
