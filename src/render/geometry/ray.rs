//! Rays, the points where they begin and end, and what is known where they meet a surface.

use glam::{BVec3, DVec2, DVec3, Vec2, Vec3, Vec3A, Vec3Swizzles};

use super::block::Across;
use super::lanes::Lanes;
use super::rounding::{above, below, gamma_32};
use super::shapes::{Kind, Primitive};

/// A ray. It meets surfaces at t in the open interval (0, `t_max`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// World units. It need not be off the surface it leaves by more than [`Point::leave`] does.
    pub origin: Vec3,
    /// Unit length, to within rounding.
    pub direction: Vec3,
    /// World units; may be +∞.
    pub t_max: f32,
    /// What it leaves, and is not asked about again.
    pub leaves: Sheet,
    /// What it ends before, and is not asked about either.
    pub reaches: Sheet,
}

impl Ray {
    /// A ray without end, from no surface that is known.
    #[inline]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        let (leaves, reaches) = (Sheet::NONE, Sheet::NONE);
        Self { origin, direction, t_max: f32::INFINITY, leaves, reaches }
    }
}

/// Names the triangle that a point is on, if it is on one. A ray that begins off a triangle on the
/// side that it goes to never meets it; named, the triangle is left out without deciding that anew.
/// Those of instances have no names, nor have surfaces that are met twice, such as spheres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sheet(u32);

impl Sheet {
    /// No triangle, or one without a name.
    pub const NONE: Self = Self(u32::MAX);

    /// A primitive of the geometry itself, not of an instance.
    #[inline(always)]
    pub fn of(primitive: Primitive) -> Self {
        if primitive.kind() == Kind::Triangle { Self(primitive.bits()) } else { Self::NONE }
    }

    /// As a number: that of a triangle, or one that no triangle has.
    #[inline]
    pub(super) fn bits(self) -> u32 {
        self.0
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
    /// The triangle it is on.
    pub sheet: Sheet,
}

impl Point {
    /// A point on no surface: a camera, or a lamp without extent.
    #[inline]
    pub const fn free(position: Vec3) -> Self {
        Self { position, error: Vec3::ZERO, ng: Vec3::ZERO, sheet: Sheet::NONE }
    }

    /// The origin of a ray that leaves along `direction` (any length): the point itself, moved
    /// along ±`ng` to where it is certainly on the side the ray goes to [Pharr23, ch. 6.8].
    #[inline(always)]
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

    /// The ray that leaves along `direction` (unit), without end.
    #[inline]
    pub fn ray(&self, direction: Vec3) -> Ray {
        Ray { leaves: self.sheet, ..Ray::new(self.leave(direction), direction) }
    }
}

impl Point {
    /// [`Self::leave`] coordinate by coordinate, to the same bits: for loops over many points.
    #[inline(always)]
    pub fn left(&self, direction: Vec3) -> Vec3 {
        let (ng, position) = (self.ng, self.position);
        let distance = ng.abs().dot(self.error);
        let side = if direction.dot(ng) < 0.0 { -distance } else { distance };
        let coordinate = |position: f32, ng: f32| {
            let offset = side * ng;
            let moved = position + offset;
            let step = (moved.abs() * f32::EPSILON + f32::MIN_POSITIVE).copysign(offset);
            moved + if offset == 0.0 { 0.0 } else { step }
        };
        Vec3::new(
            coordinate(position.x, ng.x),
            coordinate(position.y, ng.y),
            coordinate(position.z, ng.z),
        )
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
    /// The name of that, for rays that leave it.
    pub sheet: Sheet,
    /// Number of the object it belongs to.
    pub object: u32,
    /// Number of its material.
    pub material: u32,
}

impl Hit {
    /// The point of the surface alone.
    #[inline]
    pub fn point(&self) -> Point {
        Point { position: self.position, error: self.error, ng: self.ng, sheet: self.sheet }
    }

    /// The origin of a ray that leaves along `direction`; see [`Point::leave`].
    #[inline]
    pub fn leave(&self, direction: Vec3) -> Vec3 {
        self.point().leave(direction)
    }

    /// The ray that leaves along `direction` (unit), without end.
    #[inline]
    pub fn ray(&self, direction: Vec3) -> Ray {
        self.point().ray(direction)
    }
}

/// What rounding can move the end of a way by, for its size.
const OF_A_WAY: f64 = gamma_32(4);

/// A shadow ray between two points, both ends kept off their surfaces by their error bounds.
///
/// The far end is kept off further by what rounding the direction and the length can move it:
/// γ₃₂(4) of the way, per coordinate. Two points at the same place give a ray of no length.
///
/// Without jumps and vectors of its own, so that a loop over it becomes vectors.
#[inline(always)]
pub fn between(from: &Point, to: &Point) -> Ray {
    let origin = from.left(to.position - from.position);
    let start = origin.as_dvec3();
    let way = to.position.as_dvec3() - start;
    let error = above(to.error.as_dvec3() + way.abs() * OF_A_WAY);
    let end = Point { error, ..*to }.left(-way.as_vec3());
    let span = end.as_dvec3() - start;
    let length = span.length();
    let inverse = 1.0 / length;
    let apart = (inverse > 0.0) & (inverse < f64::INFINITY);
    let direction = (span * inverse).as_vec3();
    let direction = Vec3::select(BVec3::splat(apart), direction, Vec3::Z);
    let t_max = if apart { below(length as f32) } else { 0.0 };
    Ray { origin, direction, t_max, leaves: from.sheet, reaches: to.sheet }
}

/// A ray as the shapes want it: in f64, where f32 coordinates and their differences are exact, and
/// in f32 for the quick tests.
pub(super) struct Probe {
    /// In f32; the fourth coordinate means nothing.
    pub near_origin: Vec3A,
    pub near_direction: Vec3A,
    /// See [`inverse`].
    pub inverse: Vec3A,
    /// By it the direction is longest along the last axis, the depth of the triangles' test.
    pub turn: &'static Turn,
    /// The origin along these axes.
    pub turned: Vec3A,
    /// Slope of the direction along the first two of them, as the depth grows; at most ±1.
    pub shear: Vec3A,
    /// The parameter per unit of depth.
    pub per_depth: f32,
    /// Triangles that are not met, by their numbers.
    pub left_out: [u32; 2],
    /// Whether coordinates are so great that their squares may be no numbers in f32.
    pub extreme: bool,
}

/// Coordinates below this have squares that f32 can hold, even of their differences.
pub(super) const MODERATE: f32 = (1_u64 << 60) as f32;

impl Probe {
    /// For a ray, if it is one, among shapes whose coordinates are below [`MODERATE`] or not. One whose
    /// end is no number is none: a walk is over when boxes come later than that, which they never do.
    #[inline(always)]
    pub fn new<L: Lanes>(lanes: L, ray: &Ray, moderate: bool) -> Option<Self> {
        let (near_origin, near_direction) = (Vec3A::from(ray.origin), Vec3A::from(ray.direction));
        let (place, size) = (near_origin.abs(), near_direction.abs());
        let usual = place.cmplt(Vec3A::splat(MODERATE)) & size.cmplt(Vec3A::INFINITY);
        let extreme = !(moderate && usual.all());
        if extreme && !(near_origin.is_finite() && near_direction.is_finite())
            || size.cmplt(Vec3A::splat(LEAST)).all()
            || ray.t_max.is_nan()
        {
            return None;
        }
        let turn = Turn::of(size);
        let inverse = inverse(near_direction);
        let per_depth = lanes.turned(inverse, turn).z;
        Some(Self {
            near_origin,
            near_direction,
            inverse,
            turn,
            turned: lanes.turned(near_origin, turn),
            shear: lanes.turned(near_direction, turn) * per_depth,
            per_depth,
            left_out: [ray.leaves.bits(), ray.reaches.bits()],
            extreme,
        })
    }

    /// Of a ray that f32 only rounds, among moderate shapes.
    #[inline(always)]
    pub fn rounded<L: Lanes>(lanes: L, origin: DVec3, direction: DVec3) -> Option<Self> {
        Self::new(lanes, &Ray::new(origin.as_vec3(), direction.as_vec3()), true)
    }

    /// The shear in f64.
    #[inline(always)]
    pub fn exact_shear(&self) -> [f64; 2] {
        let [x, y, z] = self.turn.axes();
        let d = self.near_direction.to_array();
        let depth = f64::from(d[z]);
        [f64::from(d[x]) / depth, f64::from(d[y]) / depth]
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

/// An axis of space. As a number it needs no check where it is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

/// An order of the axes: the last is the one before, and then the next again.
pub(super) struct Turn {
    axes: [Axis; 3],
    /// The same as numbers, and another.
    order: [u32; 4],
    /// Where a block has the corners' coordinates along them.
    pub across: [Across; 3],
}

impl Turn {
    const fn new(axes: [Axis; 3]) -> Self {
        let [x, y, z] = axes;
        let across = [Across::of(x), Across::of(y), Across::of(z)];
        Self { axes, order: [x as u32, y as u32, z as u32, 3], across }
    }

    /// That by which the last is the greatest.
    #[inline(always)]
    pub fn of(size: Vec3A) -> &'static Self {
        static TURNS: [Turn; 8] = {
            const X: Turn = Turn::new([Axis::Y, Axis::Z, Axis::X]);
            const Y: Turn = Turn::new([Axis::Z, Axis::X, Axis::Y]);
            const Z: Turn = Turn::new([Axis::X, Axis::Y, Axis::Z]);
            [X, X, Y, X, Z, Z, Y, X]
        };
        // Which are no less than the next.
        &TURNS[size.cmpge(size.yzx()).bitmask() as usize % 8]
    }

    /// Numbers of the axes.
    #[inline(always)]
    pub fn axes(&self) -> [usize; 3] {
        let [x, y, z] = self.axes;
        [x as usize, y as usize, z as usize]
    }

    /// Which number comes where, of four.
    #[inline(always)]
    pub fn order(&self) -> &[u32; 4] {
        &self.order
    }
}

/// 2⁻¹⁰⁰: less is no direction, and beside something greater it is as good as nothing.
pub(super) const LEAST: f32 = 1.0 / (1_u128 << 100) as f32;

/// 1/d, finite: a coordinate within ±[`LEAST`] stands for one of that size, which moves the ray by less
/// than boxes are padded. −0 goes the same way as +0.
#[inline(always)]
fn inverse(direction: Vec3A) -> Vec3A {
    let size = direction.abs().max(Vec3A::splat(LEAST));
    size.copysign(direction + Vec3A::ZERO).recip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_left_alike_by_vectors_and_by_numbers() {
        use crate::math::random;
        for i in 0..20_000 {
            let three = |place: u64| {
                let [x, y] = random::unit_pair(random::at(61, 10 * i + place));
                let [z, _] = random::unit_pair(random::at(62, 10 * i + place));
                Vec3::new(x as f32, y as f32, z as f32) - 0.5
            };
            let flat = if i % 4 == 0 { Vec3::new(0.0, 1.0, 0.0) } else { Vec3::ONE };
            let ng = (three(0) * flat).normalize_or_zero();
            let point = Point {
                position: three(1),
                error: three(2).abs() * 1e-6,
                ng,
                ..Point::free(Vec3::ZERO)
            };
            assert_eq!(point.left(three(3)), point.leave(three(3)));
        }
        let free = Point::free(Vec3::new(0.0, -0.0, 3.0));
        assert_eq!(free.left(Vec3::X), free.position);
    }

    #[test]
    fn inverses_are_finite_and_zeros_alike() {
        let inverse = |d: f32| inverse(Vec3A::splat(d)).x;
        assert_eq!(inverse(-0.5), -2.0);
        assert_eq!(inverse(0.0), inverse(-0.0));
        for d in [0.0, 1e-45, -1e-45, 1e-38, -1e-30, 1.0] {
            let i = inverse(d);
            assert!(i.is_finite() && i * d >= 0.0, "{d}");
        }
    }
}
