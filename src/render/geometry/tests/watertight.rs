//! Closed meshes lose no ray, least of all one aimed at an edge or a corner.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use super::meshes::{Chance, Mesh};
use super::towards;
use crate::render::geometry::{Geometry, Owner, Ray, Shapes, Triangle};

/// Slack of a meeting's place, as a part of the mesh's size: a hole would show its far side.
const SLACK: f64 = 0.05;

/// Scale and offset of the tries; 14 of them with two meshes.
const PLACES: [(f64, f64); 7] =
    [(1e-9, 0.0), (1e-6, 0.0), (1e-3, 0.0), (1.0, 0.0), (1e7, 0.0), (1.0, 1e3), (1.0, 1e5)];

/// A mesh with its corners rounded, and what lies around its edges and corners.
struct Target {
    corners: Vec<DVec3>,
    edges: Vec<(u32, u32)>,
    /// Normals of the triangles at each edge and at each corner.
    edge_normals: Vec<Vec<DVec3>>,
    corner_normals: Vec<Vec<DVec3>>,
}

impl Target {
    fn new(mesh: &Mesh) -> Self {
        let corners: Vec<DVec3> = mesh.positions.iter().map(|p| p.as_vec3().as_dvec3()).collect();
        let mut edges: HashMap<(u32, u32), Vec<DVec3>> = HashMap::new();
        let mut corner_normals = vec![Vec::new(); corners.len()];
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|i| corners[i as usize]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            for k in 0..3 {
                let (i, j) = (triangle[k], triangle[(k + 1) % 3]);
                edges.entry((i.min(j), i.max(j))).or_default().push(normal);
                corner_normals[i as usize].push(normal);
            }
        }
        let mut edges: Vec<_> = edges.into_iter().collect();
        edges.sort_by_key(|(edge, _)| *edge);
        let (edges, edge_normals) = edges.into_iter().unzip();
        Self { corners, edges, edge_normals, corner_normals }
    }

    /// A point of an edge or a corner, with the normals around it.
    fn pick(&self, chance: &mut Chance) -> (DVec3, &[DVec3]) {
        if chance.bits() & 1 == 0 {
            let i = chance.below(self.corners.len());
            (self.corners[i], &self.corner_normals[i])
        } else {
            let i = chance.below(self.edges.len());
            let (a, b) = self.edges[i];
            // Not so near a corner that rounding the ray leads past it: corners have rims of their
            // own, and are picked themselves.
            let along = 1e-3 + 0.998 * chance.unit();
            let p = self.corners[a as usize].lerp(self.corners[b as usize], along);
            (p, &self.edge_normals[i])
        }
    }
}

/// How many of so many rays at edges and corners pass through, from inside and from outside.
fn lost(mesh: &Mesh, scale: f64, offset: f64, rays: usize, seed: u64) -> usize {
    let centre = DVec3::new(offset, -offset, 0.5 * offset);
    let mesh = mesh.clone().placed(scale, centre);
    let target = Target::new(&mesh);
    let geometry = Geometry::build(mesh.shapes());
    let mut chance = Chance::new(seed);
    let mut tried = 0;
    let mut lost = 0;
    while tried < rays {
        let (point, normals) = target.pick(&mut chance);
        let inside = tried % 2 == 0;
        let from = if inside {
            centre + 0.05 * scale * chance.cube()
        } else {
            centre + 3.0 * scale * chance.direction().as_dvec3()
        };
        let (ray, distance) = towards(from.as_vec3(), point);
        // From outside only what is seen from the front: past a rim a ray may go on.
        let faces = |n: &DVec3| n.dot(ray.direction.as_dvec3()) < -0.1;
        if !inside && !normals.iter().all(faces) {
            continue;
        }
        tried += 1;
        let met = geometry
            .closest(&ray)
            .is_some_and(|h| f64::from(h.t) < distance + SLACK * scale && h.position.is_finite());
        lost += usize::from(!met);
    }
    lost
}

fn lost_everywhere(rays: usize) -> usize {
    let meshes = [Mesh::icosphere(3), Mesh::bumpy(3)];
    let mut all = 0;
    for (seed, (scale, offset)) in (0..).zip(PLACES) {
        for mesh in &meshes {
            all += lost(mesh, scale, offset, rays / (2 * PLACES.len()), seed);
        }
    }
    all
}

#[test]
fn a_closed_mesh_loses_none_of_a_million_rays() {
    assert_eq!(lost_everywhere(1_000_000), 0);
}

#[test]
#[ignore = "a hundred million rays: some minutes, in release"]
fn a_closed_mesh_loses_none_of_a_hundred_million_rays() {
    assert_eq!(lost_everywhere(100_000_000), 0);
}

#[test]
fn a_fine_mesh_loses_no_ray() {
    let mesh = Mesh::bumpy(6);
    assert_eq!(lost(&mesh, 1.0, 0.0, 50_000, 9) + lost(&mesh, 1e-7, 0.0, 50_000, 10), 0);
}

/// A cube of 2·n by 2·n cells a side about the origin, each cell of two triangles.
pub(super) fn cube(n: i32, scale: f32) -> Shapes {
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    for axis in 0..3 {
        for side in [-n, n] {
            for (i, j) in (-n..n).flat_map(|i| (-n..n).map(move |j| (i, j))) {
                let at = |i: i32, j: i32| {
                    let mut p = [0.0; 3];
                    p[axis] = side as f32 * scale;
                    p[(axis + 1) % 3] = i as f32 * scale;
                    p[(axis + 2) % 3] = j as f32 * scale;
                    Vec3::from_array(p)
                };
                let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let corners = corners.map(|corner| shapes.vertex(corner));
                shapes.quad(corners, owner);
            }
        }
    }
    shapes
}

/// Along the axes, with every sign of zero, through the corners, edges and middles of a grid.
#[test]
fn rays_along_the_axes_meet_what_they_run_into() {
    for scale in [1e-9_f32, 1.0, 1e7] {
        let geometry = Geometry::build(cube(3, scale));
        for (axis, sign) in [(0, 1.0), (1, 1.0), (2, 1.0), (0, -1.0), (1, -1.0), (2, -1.0)] {
            for zeros in 0..4 {
                let zero = |bit: u32| if zeros >> bit & 1 == 0 { 0.0 } else { -0.0 };
                let mut direction = [zero(0), zero(1), zero(0)];
                direction[axis] = sign;
                if axis == 1 {
                    direction[2] = zero(1);
                }
                for (i, j) in (-6..=6).flat_map(|i| (-6..=6).map(move |j| (i, j))) {
                    let mut origin = [0.0_f32; 3];
                    origin[(axis + 1) % 3] = 0.5 * i as f32 * scale;
                    origin[(axis + 2) % 3] = 0.5 * j as f32 * scale;
                    let ray = Ray::new(origin.into(), direction.into());
                    let t = geometry.closest(&ray).map(|hit| hit.t);
                    assert_eq!(t, Some(3.0 * scale), "{ray:?}");
                    assert!(geometry.occluded(&ray));
                }
            }
        }
    }
}

/// What a plain slab test with a clamped inverse loses.
#[test]
fn a_far_quad_is_met_from_straight_above() {
    let mut shapes = Shapes::new();
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let corners = corners.map(|(x, y)| shapes.vertex(Vec3::new(x, y, 0.0)));
    shapes.quad(corners, Owner::default());
    let geometry = Geometry::build(shapes);
    for x in [0.0, 0.5, 0.999, 1.0] {
        for z in [1e3, 1e4, 1e7] {
            for zero in [0.0, -0.0, -1e-30, -1e-45] {
                let ray = Ray::new(Vec3::new(x, 0.25, z), Vec3::new(zero, zero, -1.0));
                assert_eq!(geometry.closest(&ray).map(|hit| hit.t), Some(z), "{ray:?}");
            }
        }
    }
}

/// A fan of slivers around a corner, closed below: rays at the corner and along the blades.
#[test]
fn slivers_close_too() {
    const BLADES: u32 = 2000;
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    let top = shapes.vertex(Vec3::new(0.1, 0.2, 1.0));
    let bottom = shapes.vertex(Vec3::new(0.0, 0.0, -1.0));
    let point = |i: u32| {
        let (y, x) = (f64::from(i) / f64::from(BLADES) * std::f64::consts::TAU).sin_cos();
        DVec3::new(x, y, 0.3 * x * y).as_vec3()
    };
    let rim: Vec<u32> = (0..BLADES).map(|i| shapes.vertex(point(i))).collect();
    for i in 0..BLADES as usize {
        let (a, b) = (rim[i], rim[(i + 1) % BLADES as usize]);
        shapes.triangle(Triangle { corners: [top, a, b], normals: None, owner });
        shapes.triangle(Triangle { corners: [bottom, b, a], normals: None, owner });
    }
    let geometry = Geometry::build(shapes);
    let mut chance = Chance::new(3);
    for i in 0..40_000 {
        let from = (0.2 * chance.cube()).as_vec3();
        let rim = point(chance.below(BLADES as usize) as u32).as_dvec3();
        let tip = if i % 2 == 0 { DVec3::new(0.1, 0.2, 1.0) } else { DVec3::NEG_Z };
        let target = tip.as_vec3().as_dvec3().lerp(rim, chance.unit());
        let (ray, distance) = towards(from, target);
        let t = geometry.closest(&ray).map(|hit| f64::from(hit.t));
        assert!(t.is_some_and(|t| t < distance + SLACK), "{ray:?}");
    }
}
