//! Numbers of several rays side by side, as many as the processor has room for.
//!
//! As in lanes.rs, they only ever throw out what a ray certainly misses and keep what it certainly
//! meets; f64 decides the rest. So neither the width nor how products are rounded changes an answer.

use glam::{BVec4A, Vec4};

use super::lanes::Portable;

/// The most rays side by side.
pub(super) const MOST: usize = 16;

/// One number for each of up to [`MOST`] rays.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Row(pub [f32; MOST]);

/// The same of whole numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Numbers(pub [u32; MOST]);

/// Something to do by a processor's instructions; to be inlined.
pub(super) trait Job {
    fn run<W: Wide>(self, wide: W);
}

/// Arithmetic on [`Wide::WIDTH`] numbers. An implementation is proof that the processor can do it.
pub(super) trait Wide: Copy {
    /// Rays side by side.
    const WIDTH: usize;
    type Values: Copy;
    type Mask: Copy;

    fn splat(self, value: f32) -> Self::Values;
    /// The first [`Self::WIDTH`] of a row.
    fn load(self, row: &Row) -> Self::Values;
    fn store(self, a: Self::Values, row: &mut Row);
    fn add(self, a: Self::Values, b: Self::Values) -> Self::Values;
    fn sub(self, a: Self::Values, b: Self::Values) -> Self::Values;
    fn mul(self, a: Self::Values, b: Self::Values) -> Self::Values;
    fn div(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// a·b + c, rounded once or twice.
    fn mul_add(self, a: Self::Values, b: Self::Values, c: Self::Values) -> Self::Values;
    /// c − a·b, rounded once or twice.
    fn sub_mul(self, a: Self::Values, b: Self::Values, c: Self::Values) -> Self::Values;
    /// The lesser; where one is no number, `b`.
    fn min(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// The greater; where one is no number, `b`.
    fn max(self, a: Self::Values, b: Self::Values) -> Self::Values;
    fn abs(self, a: Self::Values) -> Self::Values;

    /// Where a < b; nowhere where one is no number.
    fn less(self, a: Self::Values, b: Self::Values) -> Self::Mask;
    /// Where a number is this one.
    fn same(self, numbers: &Numbers, number: u32) -> Self::Mask;
    fn and(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    fn or(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// A bit for each ray.
    fn bits(self, mask: Self::Mask) -> u32;
    /// `a` where the mask is set, elsewhere `b`.
    fn select(self, mask: Self::Mask, a: Self::Values, b: Self::Values) -> Self::Values;

    /// Does something in a function of its own, compiled for these instructions.
    fn apart<J: Job>(self, job: J);
}

/// The places of the bits that are set.
#[inline(always)]
pub(super) fn ones(bits: u32) -> impl Iterator<Item = usize> {
    let some = (bits != 0).then_some(bits);
    std::iter::successors(some, move |bits| Some(bits & (bits - 1)).filter(|left| *left != 0))
        .map(|bits| bits.trailing_zeros() as usize)
}

impl Wide for Portable {
    const WIDTH: usize = 4;
    type Values = Vec4;
    type Mask = BVec4A;

    #[inline(always)]
    fn splat(self, value: f32) -> Vec4 {
        Vec4::splat(value)
    }

    #[inline(always)]
    fn load(self, row: &Row) -> Vec4 {
        Vec4::from_slice(&row.0)
    }

    #[inline(always)]
    fn store(self, a: Vec4, row: &mut Row) {
        a.write_to_slice(&mut row.0);
    }

    #[inline(always)]
    fn add(self, a: Vec4, b: Vec4) -> Vec4 {
        a + b
    }

    #[inline(always)]
    fn sub(self, a: Vec4, b: Vec4) -> Vec4 {
        a - b
    }

    #[inline(always)]
    fn mul(self, a: Vec4, b: Vec4) -> Vec4 {
        a * b
    }

    #[inline(always)]
    fn div(self, a: Vec4, b: Vec4) -> Vec4 {
        a / b
    }

    #[inline(always)]
    fn mul_add(self, a: Vec4, b: Vec4, c: Vec4) -> Vec4 {
        a * b + c
    }

    #[inline(always)]
    fn sub_mul(self, a: Vec4, b: Vec4, c: Vec4) -> Vec4 {
        c - a * b
    }

    #[inline(always)]
    fn min(self, a: Vec4, b: Vec4) -> Vec4 {
        Vec4::select(a.cmplt(b), a, b)
    }

    #[inline(always)]
    fn max(self, a: Vec4, b: Vec4) -> Vec4 {
        Vec4::select(a.cmpgt(b), a, b)
    }

    #[inline(always)]
    fn abs(self, a: Vec4) -> Vec4 {
        a.abs()
    }

    #[inline(always)]
    fn less(self, a: Vec4, b: Vec4) -> BVec4A {
        a.cmplt(b)
    }

    #[inline(always)]
    fn same(self, Numbers([a, b, c, d, ..]): &Numbers, number: u32) -> BVec4A {
        BVec4A::new(*a == number, *b == number, *c == number, *d == number)
    }

    #[inline(always)]
    fn and(self, a: BVec4A, b: BVec4A) -> BVec4A {
        a & b
    }

    #[inline(always)]
    fn or(self, a: BVec4A, b: BVec4A) -> BVec4A {
        a | b
    }

    #[inline(always)]
    fn bits(self, mask: BVec4A) -> u32 {
        mask.bitmask()
    }

    #[inline(always)]
    fn select(self, mask: BVec4A, a: Vec4, b: Vec4) -> Vec4 {
        Vec4::select(mask, a, b)
    }

    #[inline(never)]
    fn apart<J: Job>(self, job: J) {
        job.run(self);
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) use x86::Avx512;

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;

    use super::{Job, MOST, Numbers, Row, Wide};
    use crate::render::geometry::avx2::Avx2;

    /// Runs an instruction.
    macro_rules! run {
        ($instruction:expr) => {
            // SAFETY: an `Avx2` or an `Avx512` is made only where the processor has the instruction;
            // what is loaded or stored is no longer than a row.
            unsafe { $instruction }
        };
    }

    #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    #[inline(never)]
    fn apart_by_avx2<J: Job>(wide: Avx2, job: J) {
        job.run(wide);
    }

    impl Wide for Avx2 {
        const WIDTH: usize = 8;
        type Values = __m256;
        type Mask = __m256;

        #[inline(always)]
        fn splat(self, value: f32) -> __m256 {
            run!(_mm256_set1_ps(value))
        }

        #[inline(always)]
        fn load(self, row: &Row) -> __m256 {
            run!(_mm256_load_ps(row.0.as_ptr()))
        }

        #[inline(always)]
        fn store(self, a: __m256, row: &mut Row) {
            run!(_mm256_store_ps(row.0.as_mut_ptr(), a))
        }

        #[inline(always)]
        fn add(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_add_ps(a, b))
        }

        #[inline(always)]
        fn sub(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_sub_ps(a, b))
        }

        #[inline(always)]
        fn mul(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_mul_ps(a, b))
        }

        #[inline(always)]
        fn div(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_div_ps(a, b))
        }

        #[inline(always)]
        fn mul_add(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            run!(_mm256_fmadd_ps(a, b, c))
        }

        #[inline(always)]
        fn sub_mul(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            run!(_mm256_fnmadd_ps(a, b, c))
        }

        #[inline(always)]
        fn min(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_min_ps(a, b))
        }

        #[inline(always)]
        fn max(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_max_ps(a, b))
        }

        #[inline(always)]
        fn abs(self, a: __m256) -> __m256 {
            run!(_mm256_andnot_ps(_mm256_set1_ps(-0.0), a))
        }

        #[inline(always)]
        fn less(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b))
        }

        #[inline(always)]
        fn same(self, numbers: &Numbers, number: u32) -> __m256 {
            let all = run!(_mm256_load_si256(numbers.0.as_ptr().cast()));
            let same = run!(_mm256_cmpeq_epi32(all, _mm256_set1_epi32(number as i32)));
            run!(_mm256_castsi256_ps(same))
        }

        #[inline(always)]
        fn and(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_and_ps(a, b))
        }

        #[inline(always)]
        fn or(self, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_or_ps(a, b))
        }

        #[inline(always)]
        fn bits(self, mask: __m256) -> u32 {
            run!(_mm256_movemask_ps(mask)) as u32
        }

        #[inline(always)]
        fn select(self, mask: __m256, a: __m256, b: __m256) -> __m256 {
            run!(_mm256_blendv_ps(b, a, mask))
        }

        #[inline(always)]
        fn apart<J: Job>(self, job: J) {
            run!(apart_by_avx2(self, job))
        }
    }

    /// On x86-64 with AVX-512.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Avx512(());

    impl Avx512 {
        /// If this processor is one.
        pub fn found() -> Option<Self> {
            let all = Avx2::found().is_some()
                && is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512bw");
            all.then_some(Self(()))
        }
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
    #[inline(never)]
    fn apart_by_avx512<J: Job>(wide: Avx512, job: J) {
        job.run(wide);
    }

    impl Wide for Avx512 {
        const WIDTH: usize = MOST;
        type Values = __m512;
        type Mask = __mmask16;

        #[inline(always)]
        fn splat(self, value: f32) -> __m512 {
            run!(_mm512_set1_ps(value))
        }

        #[inline(always)]
        fn load(self, row: &Row) -> __m512 {
            run!(_mm512_load_ps(row.0.as_ptr()))
        }

        #[inline(always)]
        fn store(self, a: __m512, row: &mut Row) {
            run!(_mm512_store_ps(row.0.as_mut_ptr(), a))
        }

        #[inline(always)]
        fn add(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_add_ps(a, b))
        }

        #[inline(always)]
        fn sub(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_sub_ps(a, b))
        }

        #[inline(always)]
        fn mul(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_mul_ps(a, b))
        }

        #[inline(always)]
        fn div(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_div_ps(a, b))
        }

        #[inline(always)]
        fn mul_add(self, a: __m512, b: __m512, c: __m512) -> __m512 {
            run!(_mm512_fmadd_ps(a, b, c))
        }

        #[inline(always)]
        fn sub_mul(self, a: __m512, b: __m512, c: __m512) -> __m512 {
            run!(_mm512_fnmadd_ps(a, b, c))
        }

        #[inline(always)]
        fn min(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_min_ps(a, b))
        }

        #[inline(always)]
        fn max(self, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_max_ps(a, b))
        }

        #[inline(always)]
        fn abs(self, a: __m512) -> __m512 {
            run!(_mm512_abs_ps(a))
        }

        #[inline(always)]
        fn less(self, a: __m512, b: __m512) -> __mmask16 {
            run!(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b))
        }

        #[inline(always)]
        fn same(self, numbers: &Numbers, number: u32) -> __mmask16 {
            let all = run!(_mm512_load_si512(numbers.0.as_ptr().cast()));
            run!(_mm512_cmpeq_epi32_mask(all, _mm512_set1_epi32(number as i32)))
        }

        #[inline(always)]
        fn and(self, a: __mmask16, b: __mmask16) -> __mmask16 {
            a & b
        }

        #[inline(always)]
        fn or(self, a: __mmask16, b: __mmask16) -> __mmask16 {
            a | b
        }

        #[inline(always)]
        fn bits(self, mask: __mmask16) -> u32 {
            u32::from(mask)
        }

        #[inline(always)]
        fn select(self, mask: __mmask16, a: __m512, b: __m512) -> __m512 {
            run!(_mm512_mask_blend_ps(mask, b, a))
        }

        #[inline(always)]
        fn apart<J: Job>(self, job: J) {
            run!(apart_by_avx512(self, job))
        }
    }
}
