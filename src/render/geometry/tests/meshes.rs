//! Closed meshes made in code, and chance that is the same in every run.

use std::collections::HashMap;

use glam::{DVec3, Vec2, Vec3};

use crate::math::{random, warp};
use crate::render::geometry::{Owner, Shapes, Triangle};

/// A mesh in f64, to be scaled and moved before it is rounded.
#[derive(Clone)]
pub struct Mesh {
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A sphere of radius 1: an icosahedron whose triangles are cut into four, `level` times.
    pub fn icosphere(level: u32) -> Self {
        let g = (1.0 + 5_f64.sqrt()) / 2.0;
        let corners = [
            (-1.0, g, 0.0),
            (1.0, g, 0.0),
            (-1.0, -g, 0.0),
            (1.0, -g, 0.0),
            (0.0, -1.0, g),
            (0.0, 1.0, g),
            (0.0, -1.0, -g),
            (0.0, 1.0, -g),
            (g, 0.0, -1.0),
            (g, 0.0, 1.0),
            (-g, 0.0, -1.0),
            (-g, 0.0, 1.0),
        ];
        let mut positions: Vec<DVec3> =
            corners.iter().map(|(x, y, z)| DVec3::new(*x, *y, *z).normalize()).collect();
        let mut triangles: Vec<[u32; 3]> = vec![
            [0, 11, 5],
            [0, 5, 1],
            [0, 1, 7],
            [0, 7, 10],
            [0, 10, 11],
            [1, 5, 9],
            [5, 11, 4],
            [11, 10, 2],
            [10, 7, 6],
            [7, 1, 8],
            [3, 9, 4],
            [3, 4, 2],
            [3, 2, 6],
            [3, 6, 8],
            [3, 8, 9],
            [4, 9, 5],
            [2, 4, 11],
            [6, 2, 10],
            [8, 6, 7],
            [9, 8, 1],
        ];
        for _ in 0..level {
            let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
            let mut finer = Vec::with_capacity(4 * triangles.len());
            for [a, b, c] in triangles {
                let mut middle = |i: u32, j: u32| {
                    *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                        let m = positions[i as usize] + positions[j as usize];
                        positions.push(m.normalize());
                        positions.len() as u32 - 1
                    })
                };
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            triangles = finer;
        }
        Self { positions, triangles }
    }

    /// The same with bumps and folds, seen whole from its centre still.
    pub fn bumpy(level: u32) -> Self {
        let mut mesh = Self::icosphere(level);
        for p in &mut mesh.positions {
            let waves = (9.0 * p.x).sin() * (11.0 * p.y + 1.0).sin() * (7.0 * p.z + 2.0).cos();
            let ripples = (61.0 * p.x + 3.0).sin() * (53.0 * p.y).sin() * (47.0 * p.z).cos();
            *p *= 1.0 + 0.3 * waves + 0.02 * ripples;
        }
        mesh
    }

    /// Scaled about the centre, then moved.
    pub fn placed(mut self, scale: f64, offset: DVec3) -> Self {
        self.positions.iter_mut().for_each(|p| *p = *p * scale + offset);
        self
    }

    /// Pushes it, rounded.
    pub fn push(&self, shapes: &mut Shapes, owner: Owner) {
        let first = self.positions.iter().map(|p| shapes.vertex(p.as_vec3())).min().unwrap_or(0);
        for corners in &self.triangles {
            let corners = corners.map(|i| first + i);
            shapes.triangle(Triangle { corners, normals: None, owner });
        }
    }

    /// Alone.
    pub fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::new();
        self.push(&mut shapes, Owner::default());
        shapes
    }
}

/// A stream of random numbers.
pub struct Chance(u64);

impl Chance {
    pub fn new(seed: u64) -> Self {
        Self(random::mix(seed))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(1);
        random::mix(self.0)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In [-1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// In [0, 1)², of f32.
    pub fn square(&mut self) -> Vec2 {
        Vec2::from(random::unit_pair(self.bits()).map(random::unit_f32))
    }

    /// On the unit sphere.
    pub fn direction(&mut self) -> Vec3 {
        warp::square_to_sphere(self.square()).normalize()
    }

    /// One of `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// In the cube [-1, 1)³.
    pub fn cube(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }
}
