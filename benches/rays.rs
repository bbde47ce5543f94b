//! How many million rays a second one thread traces against a bumpy closed mesh of 82k triangles
//! standing in an open box: camera rays, diffuse bounces, shadow rays.
//!
//! `cargo bench --bench rays`

use std::hint::black_box;
use std::time::Instant;

use glam::{DVec3, Vec2, Vec3};
use scn::math::{random, warp};
use scn::render::geometry::{Geometry, Hit, Owner, Point, Ray, Shapes, Triangle, between};

const SIDE: u32 = 1000;
const PASSES: u32 = 5;

fn main() {
    let shapes = scene();
    let start = Instant::now();
    let geometry = Geometry::build(shapes);
    println!("built in {:.3} s, {:.1} MB", seconds(start), geometry.bytes() as f64 / 1e6);

    let camera = |i: u32| {
        let (x, y) = ((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5);
        let film = Vec3::new(x / SIDE as f32 - 0.5, 0.5 - y / SIDE as f32, -1.2);
        Ray::new(Vec3::new(0.0, 0.3, 3.2), film.normalize())
    };
    let first: Vec<Ray> = (0..SIDE * SIDE).map(camera).collect();
    let hits = closest("camera", &geometry, &first);

    let bounce = |(i, hit): (u32, &Hit)| {
        let u = Vec2::from(random::unit_pair(random::mix(u64::from(i))).map(random::unit_f32));
        let up = warp::square_to_sphere(u) + hit.ng * if hit.ng.z < 0.0 { -1.0 } else { 1.0 };
        hit.ray(up.normalize_or(hit.ng))
    };
    let second: Vec<Ray> = (0..).zip(&hits).map(bounce).collect();
    closest("diffuse", &geometry, &second);

    let shadow = |(i, hit): (u32, &Hit)| {
        let [x, z] = random::unit_pair(random::mix(u64::from(i) + (1 << 40)));
        let lamp = DVec3::new(x - 0.5, 1.9, z - 0.5);
        between(&hit.point(), &Point::free(lamp.as_vec3()))
    };
    let shadows: Vec<Ray> = (0..).zip(&hits).map(shadow).collect();
    report("shadow", &shadows, |ray| geometry.occluded(ray));
}

fn closest(name: &str, geometry: &Geometry, rays: &[Ray]) -> Vec<Hit> {
    report(name, rays, |ray| black_box(geometry.closest(ray)).is_some());
    rays.iter().filter_map(|ray| geometry.closest(ray)).collect()
}

/// The best of several passes: what else the machine does only ever slows one down.
fn report(name: &str, rays: &[Ray], meets: impl Fn(&Ray) -> bool) {
    let mut best = f64::INFINITY;
    let mut met = 0;
    for _ in 0..PASSES {
        let start = Instant::now();
        met = rays.iter().filter(|ray| meets(black_box(ray))).count();
        best = best.min(seconds(start));
    }
    let rate = rays.len() as f64 / best / 1e6;
    let part = met as f64 / rays.len() as f64 * 100.0;
    println!("{name:8} {rate:6.2} M rays/s, {part:.0} % meet something");
}

fn seconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64()
}

/// A sphere with bumps by longitude and latitude, in a box without its front.
fn scene() -> Shapes {
    const AROUND: u32 = 288;
    const DOWN: u32 = 144;
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    let mut corner = |i: u32, j: u32| {
        let (sin, cos) = (f64::from(j) / f64::from(DOWN) * std::f64::consts::PI).sin_cos();
        let (y, x) = (f64::from(i) / f64::from(AROUND) * std::f64::consts::TAU).sin_cos();
        let p = DVec3::new(x * sin, cos, y * sin);
        let waves = (9.0 * p.x).sin() * (11.0 * p.y + 1.0).sin() * (7.0 * p.z + 2.0).cos();
        shapes.vertex((p * (0.7 + 0.2 * waves)).as_vec3())
    };
    let grid: Vec<Vec<u32>> =
        (0..=DOWN).map(|j| (0..AROUND).map(|i| corner(i, j)).collect()).collect();
    for j in 0..DOWN as usize {
        for i in 0..AROUND as usize {
            let next = (i + 1) % AROUND as usize;
            let (a, b, c, d) = (grid[j][i], grid[j][next], grid[j + 1][next], grid[j + 1][i]);
            shapes.triangle(Triangle { corners: [a, b, c], normals: None, owner });
            shapes.triangle(Triangle { corners: [a, c, d], normals: None, owner });
        }
    }
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| 2.0 * axis);
    for (at, u, v) in [(-x, y, z), (x, z, y), (-y, z, x), (y, x, z), (-z, x, y)] {
        let corners = [-u - v, u - v, u + v, v - u].map(|side| shapes.vertex(at + side));
        shapes.quad(corners, owner);
    }
    shapes
}
