//! Eight numbers at a time, by what the processor offers.
//!
//! What is computed here only ever throws out what a ray certainly misses, with bounds that hold
//! whether products are rounded before they are added to or not. So every processor gives the same
//! answers, to the bit.

use glam::Vec4;

/// Numbers in a vector: children a node, triangles a block.
pub(super) const LANES: usize = 8;

/// Arithmetic on [`LANES`] numbers. An implementation is proof that the processor can do it.
pub(super) trait Lanes: Copy {
    /// The numbers.
    type Eight: Copy;

    fn splat(self, value: f32) -> Self::Eight;
    fn load(self, values: &[f32; LANES]) -> Self::Eight;
    /// Whole numbers, exactly.
    fn whole(self, values: &[u16; LANES]) -> Self::Eight;
    fn store(self, a: Self::Eight) -> [f32; LANES];
    fn add(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn sub(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn mul(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    fn div(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
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
    fn whole(self, values: &[u16; LANES]) -> Pair {
        self.load(&values.map(f32::from))
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
}

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use std::arch::x86_64::*;

    use super::{LANES, Lanes};

    /// On x86-64 with AVX2 and FMA.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Avx2(());

    impl Avx2 {
        /// If this processor is one.
        pub fn found() -> Option<Self> {
            let all = is_x86_feature_detected!("avx2")
                && is_x86_feature_detected!("fma")
                && is_x86_feature_detected!("bmi1")
                && is_x86_feature_detected!("bmi2")
                && is_x86_feature_detected!("lzcnt")
                && is_x86_feature_detected!("popcnt");
            all.then_some(Self(()))
        }
    }

    /// Runs an instruction.
    macro_rules! run {
        ($instruction:expr) => {
            // SAFETY: `found` alone makes an `Avx2`, where the processor has the instruction; what
            // is loaded or stored is an array of the vector's size.
            unsafe { $instruction }
        };
    }

    impl Lanes for Avx2 {
        type Eight = __m256;

        #[inline(always)]
        fn splat(self, value: f32) -> __m256 {
            run!(_mm256_set1_ps(value))
        }

        #[inline(always)]
        fn load(self, values: &[f32; LANES]) -> __m256 {
            run!(_mm256_loadu_ps(values.as_ptr()))
        }

        #[inline(always)]
        fn whole(self, values: &[u16; LANES]) -> __m256 {
            run!(_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(values.as_ptr().cast()))))
        }

        #[inline(always)]
        fn store(self, a: __m256) -> [f32; LANES] {
            let mut all = [0.0; LANES];
            run!(_mm256_storeu_ps(all.as_mut_ptr(), a));
            all
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
        fn mul_sub(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            run!(_mm256_fmsub_ps(a, b, c))
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
        fn at_most(self, a: __m256, b: __m256) -> u32 {
            run!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b))) as u32
        }
    }
}
