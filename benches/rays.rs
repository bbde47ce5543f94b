//! How many rays a second one thread traces against the bunny standing in a box without its front:
//! rays of a camera, cosine-distributed rays from where they end, and shadow rays from there to a
//! lamp; by the processor's best instructions and by plain ones. And how long the tree takes. And 64
//! bunnies in rows, as instances and as copies. And streams of 64 rays of each kind, against the bunny
//! and against two blocks in a box with a lamp, beside single rays.
//!
//! `cargo bench --bench rays`

use std::sync::{Arc, LazyLock};

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::{DAffine3, DVec3, Vec2, Vec3};
use scn::math::{Mesh, Transform, random, warp};
use scn::render::geometry::{
    Bounds, Geometry, Hit, Instance, Owner, Placement, Point, Ray, Shapes, Triangle, between,
};

/// Rays of the camera along each side of its picture.
const SIDE: u32 = 300;

/// Half the box's side; the bunny is 1 tall or wide.
const HALF: f32 = 0.7;

fn main() {
    divan::main();
}

/// What rays are met by: the processor's best instructions, or those that every one has.
const MEANS: [&str; 2] = ["best", "plain"];

struct Scene {
    geometry: [Geometry; 2],
    primary: Vec<Ray>,
    diffuse: Vec<Ray>,
    shadow: Vec<Ray>,
}

static SCENE: LazyLock<Scene> = LazyLock::new(|| of(shapes));
static BLOCKS: LazyLock<Scene> = LazyLock::new(|| of(blocks));

fn of(shapes: fn() -> Shapes) -> Scene {
    let geometry = MEANS.map(|means| Geometry::build(shapes()).with_portable(means == "plain"));
    let primary: Vec<Ray> = (0..SIDE * SIDE).map(camera).collect();
    let hits: Vec<(Ray, Hit)> =
        primary.iter().filter_map(|ray| Some((*ray, geometry[0].closest(ray)?))).collect();
    let diffuse = (0..).zip(&hits).map(bounce).collect();
    let shadow = (0..).zip(&hits).map(to_lamp).collect();
    Scene { geometry, primary, diffuse, shadow }
}

#[divan::bench]
fn build(bencher: Bencher) {
    bencher.with_inputs(shapes).bench_local_values(Geometry::build);
}

#[divan::bench(args = MEANS)]
fn primary(bencher: Bencher, means: &str) {
    closest(bencher, means, &SCENE.primary);
}

#[divan::bench(args = MEANS)]
fn diffuse(bencher: Bencher, means: &str) {
    closest(bencher, means, &SCENE.diffuse);
}

#[divan::bench(args = MEANS)]
fn shadow(bencher: Bencher, means: &str) {
    let (geometry, rays) = (&SCENE.geometry[usize::from(means == "plain")], &SCENE.shadow);
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench_local(|| rays.iter().filter(|ray| geometry.occluded(black_box(ray))).count());
}

fn closest(bencher: Bencher, means: &str, rays: &[Ray]) {
    meet(bencher, &SCENE.geometry[usize::from(means == "plain")], rays);
}

fn meet(bencher: Bencher, geometry: &Geometry, rays: &[Ray]) {
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        rays.iter().filter(|ray| black_box(geometry.closest(black_box(ray))).is_some()).count()
    });
}

/// Two blocks in a box with a lamp: 34 triangles.
fn blocks() -> Shapes {
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| HALF * axis);
    for (at, u, v) in [(-x, y, z), (x, z, y), (-y, z, x), (y, x, z), (-z, x, y)] {
        let corners = [-u - v, u - v, u + v, v - u].map(|side| shapes.vertex(at + side));
        shapes.quad(corners, owner);
    }
    let lamp = [(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)];
    let lamp = lamp.map(|(x, z)| shapes.vertex(Vec3::new(x, HALF - 0.01, z)));
    shapes.quad(lamp, owner);
    for (place, turn, height) in
        [(Vec3::new(-0.25, 0.0, -0.2), 0.3, 0.8), (Vec3::new(0.25, 0.0, 0.2), -0.3, 0.4)]
    {
        let corner = |side: usize, top: bool| {
            let (sin, cos) = (turn + side as f32 * std::f32::consts::FRAC_PI_2).sin_cos();
            let up = if top { height - HALF } else { -HALF };
            place + Vec3::new(0.28 * cos, up, 0.28 * sin)
        };
        let corners: Vec<u32> = [false, true]
            .iter()
            .flat_map(|top| (0..4).map(|side| corner(side, *top)).collect::<Vec<_>>())
            .map(|p| shapes.vertex(p))
            .collect();
        let side = |i: usize| [i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4].map(|k| corners[k]);
        for corners in [side(0), side(1), side(2), side(3), [4, 5, 6, 7].map(|k| corners[k])] {
            shapes.quad(corners, owner);
        }
    }
    shapes
}

/// Rays that are asked together.
const STREAM: usize = 64;

fn streamed(bencher: Bencher, geometry: &Geometry, rays: &[Ray]) {
    let (mut met, mut hits) = (vec![None; STREAM], vec![None; STREAM]);
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        for rays in rays.chunks(STREAM) {
            let (met, hits) = (&mut met[..rays.len()], &mut hits[..rays.len()]);
            geometry.meet_all(black_box(rays), met);
            geometry.hit_all(rays, met, hits);
            black_box(&hits);
        }
    });
}

const SCENES: [&str; 2] = ["blocks", "bunny"];

#[divan::bench(args = SCENES)]
fn stream_primary(bencher: Bencher, of: &str) {
    let scene = scene(of);
    streamed(bencher, &scene.geometry[0], &scene.primary);
}

#[divan::bench(args = SCENES)]
fn stream_diffuse(bencher: Bencher, of: &str) {
    let scene = scene(of);
    streamed(bencher, &scene.geometry[0], &scene.diffuse);
}

#[divan::bench(args = SCENES)]
fn stream_shadow(bencher: Bencher, of: &str) {
    let scene = scene(of);
    let (geometry, rays) = (&scene.geometry[0], &scene.shadow);
    let mut occluded = [false; STREAM];
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        for rays in rays.chunks(STREAM) {
            let occluded = &mut occluded[..rays.len()];
            geometry.occluded_all(black_box(rays), occluded);
            black_box(&occluded);
        }
    });
}

#[divan::bench]
fn blocks_diffuse(bencher: Bencher) {
    let scene = scene("blocks");
    meet(bencher, &scene.geometry[0], &scene.diffuse);
}

fn scene(of: &str) -> &'static Scene {
    if of == "blocks" { &BLOCKS } else { &SCENE }
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
    let (positions, triangles) = bunny();
    let lowest = positions.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
    let floor = Vec3::new(0.0, -lowest as f32 - HALF, 0.0);
    let corners: Vec<u32> = positions.iter().map(|p| shapes.vertex(p.as_vec3() + floor)).collect();
    for triangle in triangles {
        let corners = triangle.map(|i| corners[i as usize]);
        shapes.triangle(Triangle { corners, normals: None, owner });
    }
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| HALF * axis);
    for (at, u, v) in [(-x, y, z), (x, z, y), (-y, z, x), (y, x, z), (-z, x, y)] {
        let corners = [-u - v, u - v, u + v, v - u].map(|side| shapes.vertex(at + side));
        shapes.quad(corners, owner);
    }
    shapes
}

/// A geometry, rays of a camera, and rays from where they end.
type Rows = (Geometry, Vec<Ray>, Vec<Ray>);

/// Rows of bunnies, [`ROWS`]³ of them, in a cube of side 2.
static ROWS_OF_BUNNIES: LazyLock<[Rows; 2]> = LazyLock::new(|| [true, false].map(rows));

const ROWS: u32 = 4;

#[divan::bench(args = ["instances", "copies"])]
fn rows_primary(bencher: Bencher, as_what: &str) {
    let (geometry, primary, _) = &ROWS_OF_BUNNIES[usize::from(as_what == "copies")];
    meet(bencher, geometry, primary);
}

#[divan::bench(args = ["instances", "copies"])]
fn rows_diffuse(bencher: Bencher, as_what: &str) {
    let (geometry, _, diffuse) = &ROWS_OF_BUNNIES[usize::from(as_what == "copies")];
    meet(bencher, geometry, diffuse);
}

/// With the rays of the camera, and those from where they end.
fn rows(as_instances: bool) -> Rows {
    let mut shapes = Shapes::new();
    let (positions, triangles) = bunny();
    let mesh = shapes.mesh(Arc::new(Mesh { positions, triangles, ..Mesh::default() }));
    let (positions, triangles) = bunny();
    for number in 0..ROWS.pow(3) {
        let at = [number % ROWS, number / ROWS % ROWS, number / (ROWS * ROWS)];
        let at = DVec3::from_array(at.map(|i| (f64::from(i) + 0.5) * 2.0 / f64::from(ROWS) - 1.0));
        let turn = DAffine3::from_rotation_y(f64::from(number));
        let place = DAffine3::from_translation(at) * DAffine3::from_scale(DVec3::splat(0.4)) * turn;
        let (centre, scale) = (DVec3::ZERO, 1.0);
        let placement = Placement { place: Transform(place), centre, scale };
        let corners: Vec<Vec3> = positions.iter().map(|p| placement.vertex(*p)).collect();
        if as_instances {
            let bounds = corners.iter().map(|p| Bounds { min: *p, max: *p });
            let bounds = bounds.fold(Bounds::EMPTY, Bounds::union);
            let materials = vec![0];
            shapes.instance(Instance { mesh, placement, bounds, object: number, materials });
        } else {
            let owner = Owner { object: number, material: 0 };
            let corners: Vec<u32> = corners.into_iter().map(|p| shapes.vertex(p)).collect();
            for triangle in &triangles {
                let corners = triangle.map(|i| corners[i as usize]);
                shapes.triangle(Triangle { corners, normals: None, owner });
            }
        }
    }
    let geometry = Geometry::build(shapes);
    let primary: Vec<Ray> = (0..SIDE * SIDE).map(camera).collect();
    let hits: Vec<(Ray, Hit)> =
        primary.iter().filter_map(|ray| Some((*ray, geometry.closest(ray)?))).collect();
    let diffuse = (0..).zip(&hits).map(bounce).collect();
    (geometry, primary, diffuse)
}

/// Vertices and triangles of the bunny, 1 at its longest, around the origin.
fn bunny() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let text = include_str!("../models/bunny.obj");
    let rest = |kind: &'static str| text.lines().filter_map(move |line| line.strip_prefix(kind));
    let positions: Vec<DVec3> = rest("v ")
        .map(|line| {
            let mut numbers = line.split_whitespace().filter_map(|word| word.parse().ok());
            DVec3::from_array(std::array::from_fn(|_| numbers.next().unwrap_or(0.0)))
        })
        .collect();
    let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = positions.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let (middle, scale) = ((low + high) / 2.0, 1.0 / (high - low).max_element());
    let positions = positions.into_iter().map(|p| (p - middle) * scale).collect();
    let mut triangles = Vec::new();
    for line in rest("f ") {
        let index = |word: &str| word.split('/').next()?.parse::<u32>().ok()?.checked_sub(1);
        let corners: Vec<u32> = line.split_whitespace().filter_map(index).collect();
        triangles.extend(corners.windows(2).skip(1).map(|edge| [corners[0], edge[0], edge[1]]));
    }
    (positions, triangles)
}
