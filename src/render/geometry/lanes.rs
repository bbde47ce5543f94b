//! Eight numbers at a time, or three exact ones, by what the processor offers.
//!
//! What is computed with eight only ever throws out what a ray certainly misses and keeps what it
//! certainly meets, with bounds that hold whether products are rounded before they are added to or
//! not. Answers come from the exact ones, in f64. So every processor gives the same, to the bit.

use glam::swizzles::Vec3Swizzles;
use glam::{DVec3, Vec3, Vec3A, Vec4};

use super::ray::Turn;

/// Numbers in a vector: children a node, triangles a block.
pub(super) const LANES: usize = 8;

/// The higher half of a number that is not negative: no more than the number, and ordered alike.
#[inline(always)]
pub(super) fn sixteen(number: f32) -> u32 {
    number.to_bits() >> 16
}

/// More than [`sixteen`] of any number.
pub(super) const NONE_LEFT: u32 = 0xFFFF;

/// Something to do by a processor's instructions; to be inlined.
pub(super) trait Task {
    type Answer;

    fn run<L: Lanes>(self, lanes: L) -> Self::Answer;
}

/// Arithmetic on [`LANES`] numbers. An implementation is proof that the processor can do it.
pub(super) trait Lanes: Copy {
    /// The numbers.
    type Eight: Copy;

    fn splat(self, value: f32) -> Self::Eight;
    fn load(self, values: &[f32; LANES]) -> Self::Eight;
    fn store(self, a: Self::Eight) -> [f32; LANES];
    fn add(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn sub(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn mul(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn div(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// a·b + c, rounded once or twice.
    fn mul_add(self, a: Self::Eight, b: Self::Eight, c: Self::Eight) -> Self::Eight;
    /// a·b − c, rounded once or twice.
    fn mul_sub(self, a: Self::Eight, b: Self::Eight, c: Self::Eight) -> Self::Eight;
    /// c − a·b, rounded once or twice.
    fn sub_mul(self, a: Self::Eight, b: Self::Eight, c: Self::Eight) -> Self::Eight;
    /// The lesser; where one is no number, `b`.
    fn min(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// The greater; where one is no number, `b`.
    fn max(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn abs(self, a: Self::Eight) -> Self::Eight;
    /// A bit for each lane where a ≤ b.
    fn at_most(self, a: Self::Eight, b: Self::Eight) -> u32;

    /// Asks memory for a node or a block, if there is one. Nothing is read of it.
    fn fetch(self, at: *const u8);

    /// Coordinates in another order.
    fn turned(self, a: Vec3A, turn: &Turn) -> Vec3A;

    /// A bit for each number that is one of two.
    fn either(self, numbers: &[u32; LANES], two: [u32; 2]) -> u32;

    /// Which lanes remain, and what comes first of them.
    type Queue: Copy;

    /// The lanes where near ≤ far; near is not negative.
    fn queue(self, near: Self::Eight, far: Self::Eight) -> Self::Queue;
    /// The lane of the least number, and [`sixteen`] of that; [`NONE_LEFT`] if none remains.
    fn first(self, queue: Self::Queue) -> (u32, usize);
    /// Without a lane.
    fn without(self, queue: Self::Queue, lane: usize) -> Self::Queue;

    /// Does something in a function of its own, compiled for these instructions.
    fn apart<T: Task>(self, task: T) -> T::Answer;

    /// Three numbers of f64 and a zero. Each operation is rounded by itself, the same everywhere.
    type Exact: Copy;

    fn exact(self, values: [f32; 3]) -> Self::Exact;
    fn exact_splat(self, value: f64) -> Self::Exact;
    fn exact_store(self, a: Self::Exact) -> [f64; 3];
    fn exact_add(self, a: Self::Exact, b: Self::Exact) -> Self::Exact;
    fn exact_sub(self, a: Self::Exact, b: Self::Exact) -> Self::Exact;
    fn exact_mul(self, a: Self::Exact, b: Self::Exact) -> Self::Exact;
    fn exact_abs(self, a: Self::Exact) -> Self::Exact;
    /// From (x, y, z) to (y, z, x).
    fn exact_turn(self, a: Self::Exact) -> Self::Exact;
    /// Rounded to f32.
    fn exact_round(self, a: Self::Exact) -> [f32; 3];

    #[inline(always)]
    fn exact_scale(self, a: Self::Exact, scale: f64) -> Self::Exact {
        self.exact_mul(a, self.exact_splat(scale))
    }

    /// x + y + z, added from the left.
    #[inline(always)]
    fn exact_sum(self, a: Self::Exact) -> f64 {
        let [x, y, z] = self.exact_store(a);
        x + y + z
    }

    #[inline(always)]
    fn exact_dot(self, a: Self::Exact, b: Self::Exact) -> f64 {
        self.exact_sum(self.exact_mul(a, b))
    }

    #[inline(always)]
    fn exact_cross(self, a: Self::Exact, b: Self::Exact) -> Self::Exact {
        let (next, last) = (self.exact_turn(a), self.exact_turn(b));
        self.exact_turn(self.exact_sub(self.exact_mul(a, last), self.exact_mul(next, b)))
    }
}

/// On any processor: two vectors of four, which most have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Portable;

type Pair = [Vec4; 2];

#[inline(always)]
fn both(a: Pair, b: Pair, f: impl Fn(Vec4, Vec4) -> Vec4) -> Pair {
    [f(a[0], b[0]), f(a[1], b[1])]
}

impl Lanes for Portable {
    type Eight = Pair;

    #[inline(always)]
    fn splat(self, value: f32) -> Pair {
        [Vec4::splat(value); 2]
    }

    #[inline(always)]
    fn load(self, values: &[f32; LANES]) -> Pair {
        [Vec4::from_slice(&values[..4]), Vec4::from_slice(&values[4..])]
    }

    #[inline(always)]
    fn store(self, a: Pair) -> [f32; LANES] {
        let mut all = [0.0; LANES];
        a[0].write_to_slice(&mut all[..4]);
        a[1].write_to_slice(&mut all[4..]);
        all
    }

    #[inline(always)]
    fn add(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| a + b)
    }

    #[inline(always)]
    fn sub(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| a - b)
    }

    #[inline(always)]
    fn mul(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| a * b)
    }

    #[inline(always)]
    fn div(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| a / b)
    }

    #[inline(always)]
    fn mul_add(self, a: Pair, b: Pair, c: Pair) -> Pair {
        self.add(self.mul(a, b), c)
    }

    #[inline(always)]
    fn mul_sub(self, a: Pair, b: Pair, c: Pair) -> Pair {
        self.sub(self.mul(a, b), c)
    }

    #[inline(always)]
    fn sub_mul(self, a: Pair, b: Pair, c: Pair) -> Pair {
        self.sub(c, self.mul(a, b))
    }

    #[inline(always)]
    fn min(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| Vec4::select(a.cmplt(b), a, b))
    }

    #[inline(always)]
    fn max(self, a: Pair, b: Pair) -> Pair {
        both(a, b, |a, b| Vec4::select(a.cmpgt(b), a, b))
    }

    #[inline(always)]
    fn abs(self, a: Pair) -> Pair {
        [a[0].abs(), a[1].abs()]
    }

    #[inline(always)]
    fn at_most(self, a: Pair, b: Pair) -> u32 {
        a[0].cmple(b[0]).bitmask() | a[1].cmple(b[1]).bitmask() << 4
    }

    /// Nothing that every processor has.
    #[inline(always)]
    fn fetch(self, _: *const u8) {}

    #[inline(always)]
    fn turned(self, a: Vec3A, turn: &Turn) -> Vec3A {
        let [x, y, z] = turn.axes();
        let a = a.to_array();
        Vec3A::new(a[x], a[y], a[z])
    }

    #[inline(always)]
    fn either(self, numbers: &[u32; LANES], [a, b]: [u32; 2]) -> u32 {
        let bit = |(lane, number): (usize, &u32)| u32::from(*number == a || *number == b) << lane;
        numbers.iter().enumerate().map(bit).sum()
    }

    type Queue = [u16; LANES];

    #[inline(always)]
    fn queue(self, near: Pair, far: Pair) -> [u16; LANES] {
        let met = self.at_most(near, far);
        let mut queue = self.store(near).map(|near| sixteen(near) as u16);
        for (lane, left) in queue.iter_mut().enumerate() {
            if met & (1 << lane) == 0 {
                *left = NONE_LEFT as u16;
            }
        }
        queue
    }

    #[inline(always)]
    fn first(self, queue: [u16; LANES]) -> (u32, usize) {
        let mut least = (queue[0], 0);
        for (lane, left) in queue.into_iter().enumerate() {
            if left < least.0 {
                least = (left, lane);
            }
        }
        (u32::from(least.0), least.1)
    }

    #[inline(always)]
    fn without(self, mut queue: [u16; LANES], lane: usize) -> [u16; LANES] {
        queue[lane] = NONE_LEFT as u16;
        queue
    }

    #[inline(never)]
    fn apart<T: Task>(self, task: T) -> T::Answer {
        task.run(self)
    }

    type Exact = DVec3;

    #[inline(always)]
    fn exact(self, values: [f32; 3]) -> DVec3 {
        Vec3::from_array(values).as_dvec3()
    }

    #[inline(always)]
    fn exact_splat(self, value: f64) -> DVec3 {
        DVec3::splat(value)
    }

    #[inline(always)]
    fn exact_store(self, a: DVec3) -> [f64; 3] {
        a.to_array()
    }

    #[inline(always)]
    fn exact_add(self, a: DVec3, b: DVec3) -> DVec3 {
        a + b
    }

    #[inline(always)]
    fn exact_sub(self, a: DVec3, b: DVec3) -> DVec3 {
        a - b
    }

    #[inline(always)]
    fn exact_mul(self, a: DVec3, b: DVec3) -> DVec3 {
        a * b
    }

    #[inline(always)]
    fn exact_abs(self, a: DVec3) -> DVec3 {
        a.abs()
    }

    #[inline(always)]
    fn exact_turn(self, a: DVec3) -> DVec3 {
        a.yzx()
    }

    #[inline(always)]
    fn exact_round(self, a: DVec3) -> [f32; 3] {
        a.as_vec3().to_array()
    }
}
