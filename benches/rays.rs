//! How many rays a second one thread traces against the bunny standing in a box without its front:
//! rays of a camera, cosine-distributed rays from where they end, and shadow rays from there to a
//! lamp; by the processor's best instructions and by plain ones. And how long the tree takes.
//!
//! `cargo bench --bench rays`

use std::sync::LazyLock;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::{DVec3, Vec2, Vec3};
use scn::math::{random, warp};
use scn::render::geometry::{Geometry, Hit, Owner, Point, Ray, Shapes, Triangle, between};

/// Rays of the camera along each side of its picture.
const SIDE: u32 = 300;

/// Half the box's side; the bunny is 1 tall or wide.
const HALF: f32 = 0.7;

fn main() {
    divan::main();
}

/// What rays are met by.
const PORTABLE: [bool; 2] = [false, true];

struct Scene {
    geometry: [Geometry; 2],
    primary: Vec<Ray>,
    diffuse: Vec<Ray>,
    shadow: Vec<Ray>,
}

static SCENE: LazyLock<Scene> = LazyLock::new(|| {
    let geometry = PORTABLE.map(|portable| Geometry::build(shapes()).with_portable(portable));
    let primary: Vec<Ray> = (0..SIDE * SIDE).map(camera).collect();
    let hits: Vec<(Ray, Hit)> =
        primary.iter().filter_map(|ray| Some((*ray, geometry[0].closest(ray)?))).collect();
    let diffuse = (0..).zip(&hits).map(bounce).collect();
    let shadow = (0..).zip(&hits).map(to_lamp).collect();
    Scene { geometry, primary, diffuse, shadow }
});

#[divan::bench]
fn build(bencher: Bencher) {
    bencher.with_inputs(shapes).bench_local_values(Geometry::build);
}

#[divan::bench(args = PORTABLE)]
fn primary(bencher: Bencher, portable: bool) {
    closest(bencher, portable, &SCENE.primary);
}

#[divan::bench(args = PORTABLE)]
fn diffuse(bencher: Bencher, portable: bool) {
    closest(bencher, portable, &SCENE.diffuse);
}

#[divan::bench(args = PORTABLE)]
fn shadow(bencher: Bencher, portable: bool) {
    let (geometry, rays) = (&SCENE.geometry[usize::from(portable)], &SCENE.shadow);
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench_local(|| rays.iter().filter(|ray| geometry.occluded(black_box(ray))).count());
}

fn closest(bencher: Bencher, portable: bool, rays: &[Ray]) {
    let geometry = &SCENE.geometry[usize::from(portable)];
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        rays.iter().filter(|ray| black_box(geometry.closest(black_box(ray))).is_some()).count()
    });
}

fn camera(i: u32) -> Ray {
    let side = SIDE as f32;
    let (x, y) = ((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5);
    let film = Vec3::new(x / side - 0.5, 0.5 - y / side, -1.2);
    Ray::new(Vec3::new(0.0, 0.1, 2.2), film.normalize())
}

fn bounce((i, (ray, hit)): (u64, &(Ray, Hit))) -> Ray {
    let u = Vec2::from(random::unit_pair(random::mix(i)).map(random::unit_f32));
    let front = if hit.ng.dot(ray.direction) > 0.0 { -hit.ng } else { hit.ng };
    hit.ray((warp::square_to_sphere(u) + front).normalize_or(front))
}

fn to_lamp((i, (_, hit)): (u64, &(Ray, Hit))) -> Ray {
    let [x, z] = random::unit_pair(random::mix(i + (1 << 40)));
    let lamp = DVec3::new(0.4 * (x - 0.5), f64::from(HALF) - 0.01, 0.4 * (z - 0.5));
    between(&hit.point(), &Point::free(lamp.as_vec3()))
}

fn shapes() -> Shapes {
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    bunny(&mut shapes, owner);
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| HALF * axis);
    for (at, u, v) in [(-x, y, z), (x, z, y), (-y, z, x), (y, x, z), (-z, x, y)] {
        let corners = [-u - v, u - v, u + v, v - u].map(|side| shapes.vertex(at + side));
        shapes.quad(corners, owner);
    }
    shapes
}

/// The bunny, 1 at its longest, on the floor.
fn bunny(shapes: &mut Shapes, owner: Owner) {
    let text = include_str!("../models/bunny.obj");
    let rest = |kind: &'static str| text.lines().filter_map(move |line| line.strip_prefix(kind));
    let positions: Vec<Vec3> = rest("v ")
        .map(|line| {
            let mut numbers = line.split_whitespace().filter_map(|word| word.parse().ok());
            Vec3::from_array(std::array::from_fn(|_| numbers.next().unwrap_or(0.0)))
        })
        .collect();
    let low = positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let (middle, scale) = ((low + high) / 2.0, 1.0 / (high - low).max_element());
    let floor = Vec3::new(0.0, scale * (high.y - low.y) / 2.0 - HALF, 0.0);
    for p in &positions {
        shapes.vertex((*p - middle) * scale + floor);
    }
    for line in rest("f ") {
        let index = |word: &str| word.split('/').next()?.parse::<u32>().ok()?.checked_sub(1);
        let corners: Vec<u32> = line.split_whitespace().filter_map(index).collect();
        for k in 1..corners.len().saturating_sub(1) {
            let corners = [corners[0], corners[k], corners[k + 1]];
            shapes.triangle(Triangle { corners, normals: None, owner });
        }
    }
}
