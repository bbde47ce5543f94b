//! Vectors of f64 as four numbers, the fourth zero: the compiler makes vector instructions of them
//! where the processor has them. Each operation is rounded as of single numbers, so the bits are the
//! same everywhere.

use std::ops::{Add, Mul, Sub};

use glam::{DVec3, Vec3};

/// Three numbers and a zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exact([f64; 4]);

impl Exact {
    #[inline(always)]
    pub fn new(x: f64, y: f64, z: f64) -> Self {
        Self([x, y, z, 0.0])
    }

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; 3] {
        let Self([x, y, z, _]) = self;
        [x, y, z]
    }

    /// From (x, y, z) to (y, z, x).
    #[inline(always)]
    pub fn turned(self) -> Self {
        let Self([x, y, z, w]) = self;
        Self([y, z, x, w])
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        let Self([x, y, z, w]) = self;
        Self([x.abs(), y.abs(), z.abs(), w.abs()])
    }

    /// Each number, or zero if that is greater.
    #[inline(always)]
    pub fn positive(self) -> Self {
        let Self(all) = self;
        let [x, y, z, w] = all;
        let or_zero = |x: f64| if x > 0.0 { x } else { 0.0 };
        Self([or_zero(x), or_zero(y), or_zero(z), or_zero(w)])
    }

    #[inline(always)]
    pub fn sum(self) -> f64 {
        let Self([x, y, z, _]) = self;
        x + y + z
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> f64 {
        (self * other).sum()
    }

    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        (self * other.turned() - self.turned() * other).turned()
    }

    #[inline(always)]
    pub fn to_f32(self) -> Vec3 {
        let Self([x, y, z, _]) = self;
        Vec3::new(x as f32, y as f32, z as f32)
    }
}

impl From<DVec3> for Exact {
    #[inline(always)]
    fn from(v: DVec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl Add for Exact {
    type Output = Self;

    #[inline(always)]
    fn add(self, Self([bx, by, bz, bw]): Self) -> Self {
        let Self([x, y, z, w]) = self;
        Self([x + bx, y + by, z + bz, w + bw])
    }
}

impl Sub for Exact {
    type Output = Self;

    #[inline(always)]
    fn sub(self, Self([bx, by, bz, bw]): Self) -> Self {
        let Self([x, y, z, w]) = self;
        Self([x - bx, y - by, z - bz, w - bw])
    }
}

impl Mul for Exact {
    type Output = Self;

    #[inline(always)]
    fn mul(self, Self([bx, by, bz, bw]): Self) -> Self {
        let Self([x, y, z, w]) = self;
        Self([x * bx, y * by, z * bz, w * bw])
    }
}

impl Mul<f64> for Exact {
    type Output = Self;

    #[inline(always)]
    fn mul(self, scale: f64) -> Self {
        self * Self::splat(scale)
    }
}
