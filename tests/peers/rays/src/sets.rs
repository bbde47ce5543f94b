//! Triangles from a file of the harness, and the rays that are traced against them: of a camera,
//! cosine-distributed from where those end and from where these end, and to points on a lamp.
//!
//! The tests of scn compile this file, too: it must not fall behind.

use std::io;
use std::path::Path;

use glam::{DVec3, Vec2, Vec3};
use scn::math::{random, warp};
use scn::render::geometry::{Geometry, Hit, Owner, Point, Ray, Shapes, Triangle, between};

/// Where the camera is, before the open side of a box from -0.7 to 0.7.
const EYE: Vec3 = Vec3::new(0.0, 0.1, 2.2);
/// How high the lamp hangs, and its side.
const LAMP: [f64; 2] = [0.69, 0.4];

/// Corners of triangles, and their numbers.
pub struct Triangles {
    pub points: Vec<[f32; 3]>,
    pub faces: Vec<[u32; 3]>,
}

/// The rays of one kind, and whether any hit will do.
pub struct Set {
    pub name: &'static str,
    pub any: bool,
    pub rays: Vec<Ray>,
}

impl Triangles {
    /// Reads little-endian words: how many points and triangles, and each as three words.
    pub fn read(path: &Path) -> io::Result<Self> {
        let bytes = std::fs::read(path)?;
        let words: Vec<[u8; 4]> = bytes.chunks_exact(4).map(|w| [w[0], w[1], w[2], w[3]]).collect();
        let count = |i: usize| words.get(i).map_or(0, |word| u32::from_le_bytes(*word) as usize);
        let (of_points, of_faces) = (count(0), count(1));
        if words.len() != 2 + 3 * (of_points + of_faces) {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "of another length"));
        }
        let (points, faces) = words[2..].split_at(3 * of_points);
        let three = |words: &[[u8; 4]]| [words[0], words[1], words[2]];
        Ok(Self {
            points: points.chunks(3).map(|w| three(w).map(f32::from_le_bytes)).collect(),
            faces: faces.chunks(3).map(|w| three(w).map(u32::from_le_bytes)).collect(),
        })
    }

    pub fn geometry(&self) -> Geometry {
        let mut shapes = Shapes::new();
        for point in &self.points {
            shapes.vertex((*point).into());
        }
        for corners in &self.faces {
            let owner = Owner::default();
            shapes.triangle(Triangle { corners: *corners, normals: None, owner });
        }
        Geometry::build(shapes)
    }
}

/// All rays of a picture of so many pixels along a side.
pub fn sets(geometry: &Geometry, side: u32) -> Vec<Set> {
    let primary: Vec<Ray> = (0..side * side).map(|i| camera(i, side)).collect();
    let first = hits(geometry, &primary);
    let diffuse = bounces(&first, 1 << 40);
    let next = hits(geometry, &diffuse);
    let second = bounces(&next, 1 << 41);
    let shadow =
        (0..).zip(first.iter().chain(&next)).map(|(i, (_, hit))| to_lamp(i, hit)).collect();
    vec![
        Set { name: "primary", any: false, rays: primary },
        Set { name: "diffuse", any: false, rays: diffuse },
        Set { name: "second", any: false, rays: second },
        Set { name: "shadow", any: true, rays: shadow },
    ]
}

fn camera(i: u32, side: u32) -> Ray {
    let (x, y, side) = ((i % side) as f32 + 0.5, (i / side) as f32 + 0.5, side as f32);
    Ray::new(EYE, Vec3::new(x / side - 0.5, 0.5 - y / side, -1.2).normalize())
}

fn hits(geometry: &Geometry, rays: &[Ray]) -> Vec<(Vec3, Hit)> {
    rays.iter().filter_map(|ray| Some((ray.direction, geometry.closest(ray)?))).collect()
}

fn bounces(from: &[(Vec3, Hit)], salt: u64) -> Vec<Ray> {
    let bounce = |(i, (direction, hit)): (u64, &(Vec3, Hit))| {
        let u = Vec2::from(random::unit_pair(random::mix(i + salt)).map(random::unit_f32));
        let front = if hit.ng.dot(*direction) > 0.0 { -hit.ng } else { hit.ng };
        hit.ray((warp::square_to_sphere(u) + front).normalize_or(front))
    };
    (0..).zip(from).map(bounce).collect()
}

fn to_lamp(i: u64, hit: &Hit) -> Ray {
    let [x, z] = random::unit_pair(random::mix(i + (1 << 42)));
    let [height, side] = LAMP;
    let lamp = DVec3::new(side * (x - 0.5), height, side * (z - 0.5));
    between(&hit.point(), &Point::free(lamp.as_vec3()))
}
