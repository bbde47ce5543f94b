//! Rays, the points where they begin and end, and what is known where they meet a surface.

use glam::{DVec2, DVec3, Vec2, Vec3, Vec3A};

use super::rounding::{above, gamma_32};
use super::shapes::Primitive;

/// A ray. It meets surfaces at t in the open interval (0, `t_max`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// World units. It need not be off the surface it leaves by more than [`Point::leave`] does.
    pub origin: Vec3,
    /// Unit length, to within rounding.
    pub direction: Vec3,
    /// World units; may be +∞.
    pub t_max: f32,
}

impl Ray {
    /// A ray without end.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction, t_max: f32::INFINITY }
    }
}

/// A point of a surface, and how far it may be off it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// World units.
    pub position: Vec3,
    /// Bound of the distance to the surface, per coordinate, world units, not negative.
    pub error: Vec3,
    /// Geometric normal, unit length, on the front side; zero for a point on no surface.
    pub ng: Vec3,
}

impl Point {
    /// A point on no surface: a camera, or a lamp without extent.
    pub fn free(position: Vec3) -> Self {
        Self { position, error: Vec3::ZERO, ng: Vec3::ZERO }
    }

    /// The origin of a ray that leaves along `direction` (any length): the point itself, moved
    /// along ±`ng` to where it is certainly on the side the ray goes to [Pharr23, ch. 6.8].
    #[inline]
    pub fn leave(&self, direction: Vec3) -> Vec3 {
        let (ng, position) = (Vec3A::from(self.ng), Vec3A::from(self.position));
        let distance = ng.abs().dot(self.error.into());
        let side = if direction.dot(self.ng) < 0.0 { -distance } else { distance };
        let offset = side * ng;
        let moved = position + offset;
        // One step of f32 further at least, where it moves at all.
        let step = moved.abs() * f32::EPSILON + Vec3A::splat(f32::MIN_POSITIVE);
        let step = Vec3A::select(offset.cmpeq(Vec3A::ZERO), Vec3A::ZERO, step.copysign(offset));
        (moved + step).into()
    }
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Distance along the ray.
    pub t: f32,
    /// A point of the surface to within `error`, better than origin + t·direction.
    pub position: Vec3,
    /// Bound of the distance to the surface, per coordinate, world units.
    pub error: Vec3,
    /// Geometric normal, unit length, on the front side, whichever side the ray came from.
    pub ng: Vec3,
    /// Shading normal, unit length, on the same side as `ng`.
    pub ns: Vec3,
    /// Coordinates on its surface, by which textures are laid on. Of a triangle without any, the
    /// weights of its second and third corner; of other shapes without a chart, zero.
    pub uv: DVec2,
    /// What was met; of an instance, the triangle by its number in the mesh.
    pub primitive: Primitive,
    /// Number of the object it belongs to.
    pub object: u32,
    /// Number of its material.
    pub material: u32,
}

impl Hit {
    /// The point of the surface alone.
    #[inline]
    pub fn point(&self) -> Point {
        Point { position: self.position, error: self.error, ng: self.ng }
    }

    /// The origin of a ray that leaves along `direction`; see [`Point::leave`].
    #[inline]
    pub fn leave(&self, direction: Vec3) -> Vec3 {
        self.point().leave(direction)
    }

    /// The ray that leaves along `direction` (unit), without end.
    #[inline]
    pub fn ray(&self, direction: Vec3) -> Ray {
        Ray::new(self.leave(direction), direction)
    }
}

/// A shadow ray between two points, both ends kept off their surfaces by their error bounds.
///
/// The far end is kept off further by what rounding the direction and the length can move it:
/// γ₃₂(4) of the way, per coordinate. Two points at the same place give a ray of no length.
#[inline]
pub fn between(from: &Point, to: &Point) -> Ray {
    let origin = from.leave(to.position - from.position);
    let start = origin.as_dvec3();
    let way = to.position.as_dvec3() - start;
    let error = above(to.error.as_dvec3() + way.abs() * gamma_32(4));
    let end = Point { error, ..*to }.leave(-way.as_vec3());
    let span = end.as_dvec3() - start;
    let length = span.length();
    let Some(direction) = span.try_normalize() else {
        return Ray { origin, direction: Vec3::Z, t_max: 0.0 };
    };
    Ray { origin, direction: direction.as_vec3(), t_max: (length as f32).next_down().max(0.0) }
}

/// A ray as the shapes want it: in f64, where f32 coordinates and their differences are exact, and
/// in f32 for the quick tests.
pub(super) struct Probe {
    /// In f32, for boxes; the fourth coordinate means nothing.
    pub near_origin: Vec3A,
    pub near_direction: Vec3A,
    /// The last one is that along which the direction is longest, the depth of the triangles' test;
    /// before it the two that follow it.
    pub axes: [usize; 3],
    /// Slope of the direction along the first two axes, as the depth grows; at most ±1.
    pub shear: [f64; 2],
    /// Where the ray is along the first two axes, at depth zero.
    pub sheared: [f64; 2],
    /// The shear in f32.
    pub near_shear: [f32; 2],
    /// The origin's depth, and the parameter per unit of depth.
    pub near_depth: [f32; 2],
    /// The origin's greatest coordinate, without its sign.
    pub size: f32,
}

impl Probe {
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        let size = ray.direction.abs();
        let z = if size.y > size.x { 1 } else { 0 };
        let z = if size.z > size.x.max(size.y) { 2 } else { z };
        let x = if z == 2 { 0 } else { z + 1 };
        let axes = [x, 3 - x - z, z];
        let [x, y, z] = axes;
        let depth = f64::from(ray.direction[z]);
        let shear = [f64::from(ray.direction[x]) / depth, f64::from(ray.direction[y]) / depth];
        let back = f64::from(ray.origin[z]);
        Self {
            near_origin: ray.origin.into(),
            near_direction: ray.direction.into(),
            axes,
            shear,
            sheared: [
                f64::from(ray.origin[x]) - shear[0] * back,
                f64::from(ray.origin[y]) - shear[1] * back,
            ],
            near_shear: [shear[0] as f32, shear[1] as f32],
            near_depth: [ray.origin[z], 1.0 / ray.direction[z]],
            size: Vec3A::from(ray.origin).abs().max_element(),
        }
    }

    /// Of a ray that f32 only rounds: what is in f64 is by its exact numbers.
    #[inline(always)]
    pub fn exact(origin: DVec3, direction: DVec3) -> Self {
        let near = Ray::new(origin.as_vec3(), direction.as_vec3());
        let probe = Self::new(&near);
        let [x, y, z] = probe.axes;
        let shear = [direction[x] / direction[z], direction[y] / direction[z]];
        Self {
            shear,
            sheared: [origin[x] - shear[0] * origin[z], origin[y] - shear[1] * origin[z]],
            near_shear: [shear[0] as f32, shear[1] as f32],
            ..probe
        }
    }

    /// Whether it is a ray at all: one that is not meets nothing.
    #[inline(always)]
    pub fn is_sound(&self) -> bool {
        let (o, d) = (self.near_origin.abs(), self.near_direction.abs());
        (o.cmplt(Vec3A::INFINITY) & d.cmplt(Vec3A::INFINITY)).all() && d.cmpgt(Vec3A::ZERO).any()
    }

    pub fn origin(&self) -> DVec3 {
        self.near_origin.as_dvec3()
    }

    pub fn direction(&self) -> DVec3 {
        self.near_direction.as_dvec3()
    }
}

/// What a shape knows of the place where it was met.
pub(super) struct Surface {
    pub point: Point,
    pub ns: Vec3,
    /// Of a triangle, the weights of its second and third corner; else zero.
    pub uv: Vec2,
}
