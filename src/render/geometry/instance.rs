//! Meshes that stand at several places without being copied: what they are, and where.
//!
//! What is met is the copy all the same: corners are mapped in f64 and rounded to f32 as a copy's
//! would be, when a ray comes near them, and decided upon as any other triangle. So an instance has
//! the answers of a copy to the bit, with its watertightness and its bounds of error. What the
//! instances of a mesh share (template.rs) only throws out what a ray misses.

use std::sync::Arc;

use glam::{DMat3, DVec3, Vec3, Vec3A};

use super::Bounds;
use super::shapes::Owner;
use super::template::Template;
use super::triangle::Face;
use crate::math::{Mesh, Transform};

/// Where a mesh stands: a vertex p is at (`place`(p) − `centre`) · `scale`, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Before the map to world space.
    pub place: Transform,
    /// What becomes the origin of the world.
    pub centre: DVec3,
    /// World units a unit of where `place` leads.
    pub scale: f64,
}

impl Placement {
    /// Where a vertex is, in world units.
    #[inline(always)]
    pub fn vertex(&self, p: DVec3) -> Vec3 {
        self.exact(p).as_vec3()
    }

    fn exact(&self, p: DVec3) -> DVec3 {
        (self.place.point(p) - self.centre) * self.scale
    }

    /// Whether the way back can be told in f64.
    pub fn is_sound(&self) -> bool {
        let matrix = self.place.0.matrix3 * self.scale;
        let back = matrix.inverse();
        let id = back * matrix - DMat3::IDENTITY;
        back.is_finite() && id.to_cols_array().iter().all(|e| e.abs() < WORST)
    }
}

/// A map whose inverse is off by more is no map to turn back by.
const WORST: f64 = 1.0 / 64.0;

/// A mesh at a place.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The number of the mesh.
    pub mesh: u32,
    /// Where it stands; sound.
    pub placement: Placement,
    /// The box around its rounded corners, world units.
    pub bounds: Bounds,
    /// Number of the object in the scene.
    pub object: u32,
    /// Numbers of the materials in the world, by slot.
    pub materials: Vec<u32>,
}

/// Meshes, and where they stand.
#[derive(Clone, Debug, Default)]
pub(super) struct Instances {
    pub meshes: Vec<Arc<Mesh>>,
    pub all: Vec<Instance>,
}

impl Instances {
    /// The box around all.
    pub fn bounds(&self) -> Bounds {
        self.all.iter().fold(Bounds::EMPTY, |sum, instance| sum.union(instance.bounds))
    }
}

/// An instance, ready to be met.
pub(super) struct Standing {
    placement: Placement,
    mirrors: bool,
    object: u32,
    materials: Box<[u32]>,
    /// The number of its template.
    pub template: u32,
    /// From world space to the template's: `back` · (w − `origin`).
    pub back: DMat3,
    pub origin: DVec3,
    /// How far a rounded corner may be from that of the template, along each axis of the latter.
    pub off: DVec3,
}

/// Roundings of f32, and more than those of f64 on the way of a corner or a ray, in parts of the
/// magnitudes that are added up.
const ROUNDED: f64 = f32::EPSILON as f64;
const STEPS: f64 = 64.0 * f64::EPSILON;

impl Standing {
    pub fn new(instance: &Instance, template: &Template) -> Self {
        let placement = instance.placement;
        let place = placement.place.0;
        let matrix = place.matrix3 * (placement.scale / template.scale);
        let back = matrix.inverse();
        let origin = placement.exact(template.centre);
        // How far corners are off in world space, seen from the template; and what the way there
        // and back does not return of the template's own coordinates, which are within ±1.
        let farthest = instance.bounds.min.abs().max(instance.bounds.max.abs()).as_dvec3();
        let before = place.matrix3.abs() * template.farthest
            + place.translation.abs()
            + placement.centre.abs();
        let world = farthest * ROUNDED + (before * placement.scale + farthest) * STEPS;
        let lost = (back * matrix - DMat3::IDENTITY).abs() * DVec3::ONE;
        Self {
            placement,
            mirrors: placement.place.mirrors(),
            object: instance.object,
            materials: instance.materials.clone().into_boxed_slice(),
            template: instance.mesh,
            back,
            origin,
            off: back.abs() * world + lost + ROUNDED,
        }
    }

    /// One of its triangles, as a copy would be.
    #[inline(always)]
    pub fn face(&self, mesh: &Mesh, triangle: u32) -> Face {
        let [a, b, c] = mesh.triangles[triangle as usize];
        let [b, c] = if self.mirrors { [c, b] } else { [b, c] };
        let corner = |i: u32| self.placement.vertex(mesh.positions[i as usize]).to_array();
        Face { corners: [corner(a), corner(b), corner(c)] }
    }

    /// Whose a triangle is.
    pub fn owner(&self, mesh: &Mesh, triangle: u32) -> Owner {
        let slot = mesh.slot(triangle as usize);
        Owner { object: self.object, material: self.materials.get(slot).copied().unwrap_or(0) }
    }

    /// By what of two meetings at the same place the first is chosen, as among copies.
    pub fn rank(&self, triangle: u32) -> u64 {
        u64::from(self.object) << 32 | u64::from(triangle)
    }

    /// Shading normals at a triangle's corners, as a copy would have them.
    pub fn normals(&self, mesh: &Mesh, triangle: u32) -> Option<[Vec3; 3]> {
        let turned = |i: u32| self.normal(mesh.normals[i as usize]);
        let [a, b, c] = mesh.normals_of(triangle as usize)?;
        let [b, c] = if self.mirrors { [c, b] } else { [b, c] };
        Some([turned(a), turned(b), turned(c)])
    }

    fn normal(&self, normal: DVec3) -> Vec3 {
        let turned = self.placement.place.normal(normal);
        let front = if self.mirrors { -turned } else { turned };
        front.normalize_or_zero().as_vec3()
    }

    /// Texture coordinates by the weights of a triangle's second and third corner.
    pub fn coordinates(&self, mesh: &Mesh, triangle: u32, [u, v]: [f64; 2]) -> Option<glam::DVec2> {
        let [a, b, c] = mesh.coordinates_of(triangle as usize)?;
        let [b, c] = if self.mirrors { [c, b] } else { [b, c] };
        let [a, b, c] = [a, b, c].map(|i| mesh.coordinates[i as usize].as_dvec2());
        Some(a + u * (b - a) + v * (c - a))
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.materials)
    }

    /// `off` in f32, not below.
    pub fn off_f32(&self) -> Vec3A {
        super::rounding::up(self.off).into()
    }
}
