//! How far float arithmetic can err, after Higham's γ.
//!
//! A sum or product of floats is the exact one times (1 + δ), |δ| ≤ u, where u is half the gap
//! between 1 and the next float; n of them in a row are within γ(n) = n·u / (1 − n·u)
//! [Higham02, lemma 3.1].
//!
//! Hit positions are computed in f64 from f32 data and rounded once. So each coordinate of a hit
//! is off its surface by at most
//!
//! * half an f32 ulp of itself, u₃₂·|p|, from that one rounding, and
//! * γ₆₄(n)·(the magnitudes that were added up to make it), from the arithmetic before.
//!
//! The same bound covers the next ray's own arithmetic: whether an origin o is above a surface is
//! decided in f64 by the sign of n·(v − o), which errs by γ₆₄(4)·Σ|nᵢ|·|vᵢ − oᵢ|, no more than
//! γ₆₄(4)·Σ|nᵢ|·(|vᵢ| + |pᵢ| + the offset). With n counted for both, an origin displaced along n
//! by Σ|nᵢ|·errorᵢ and then rounded outwards is certainly, and is certainly seen to be, on its side.

use glam::{DVec3, Vec3};

use super::lanes::Lanes;

/// Unit roundoff of f32: 2⁻²⁴.
const UNIT_32: f64 = f32::EPSILON as f64 / 2.0;
/// Unit roundoff of f64: 2⁻⁵³.
const UNIT_64: f64 = f64::EPSILON / 2.0;

/// Operations in f64, with room to spare, between stored f32 data and a position, and again from
/// a position to the sign of its side: sums of three products of differences and a division.
const STEPS: f64 = 32.0;

/// Bound of the relative error of `n` operations of f32.
pub(super) const fn gamma_32(n: u32) -> f64 {
    let nu = n as f64 * UNIT_32;
    nu / (1.0 - nu)
}

/// A position rounded to f32 and the bound of its error per coordinate. `magnitude`: the sum of
/// the magnitudes it was made of, per coordinate.
#[inline(always)]
pub(super) fn position(exact: DVec3, magnitude: DVec3) -> (Vec3, Vec3) {
    let error = exact.abs() * UNIT_32 + magnitude * (STEPS * UNIT_64);
    (exact.as_vec3(), above(error))
}

/// The same by a processor's instructions.
#[inline(always)]
pub(super) fn near<L: Lanes>(lanes: L, exact: L::Exact, magnitude: L::Exact) -> (Vec3, Vec3) {
    let error = lanes.exact_add(
        lanes.exact_scale(lanes.exact_abs(exact), UNIT_32),
        lanes.exact_scale(magnitude, STEPS * UNIT_64),
    );
    let [x, y, z] = lanes.exact_round(error);
    (lanes.exact_round(exact).into(), Vec3::new(next(x), next(y), next(z)))
}

/// The bound of the error of a coordinate that is rounded to f32, as [`position`] has it.
#[inline(always)]
pub(super) fn error_of(exact: f64, magnitude: f64) -> f32 {
    next((exact.abs() * UNIT_32 + magnitude * (STEPS * UNIT_64)) as f32)
}

/// The next f32 above one that is not negative.
#[inline(always)]
fn next(x: f32) -> f32 {
    let x = if x < f32::MAX { x } else { f32::MAX };
    f32::from_bits(x.to_bits() + 1)
}

/// The next f32 below one that is positive; 0 of what is not.
#[inline(always)]
pub(super) fn below(x: f32) -> f32 {
    let below = f32::from_bits(x.to_bits().wrapping_sub(1));
    if x > 0.0 { below } else { 0.0 }
}

/// The next f32 above each coordinate, none of them negative.
#[inline(always)]
pub(super) fn above(x: DVec3) -> Vec3 {
    let x = x.as_vec3();
    Vec3::new(next(x.x), next(x.y), next(x.z))
}

/// The next f32 above each coordinate. Of zero it is more than zero, and so covers gradual
/// underflow too.
pub(super) fn up(x: DVec3) -> Vec3 {
    let x = x.as_vec3();
    Vec3::new(x.x.next_up(), x.y.next_up(), x.z.next_up())
}

/// The next f32 below each coordinate.
pub(super) fn down(x: DVec3) -> Vec3 {
    -up(-x)
}
