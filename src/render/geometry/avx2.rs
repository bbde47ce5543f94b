//! Eight numbers at once on x86-64 with AVX2 and FMA.

use std::arch::x86_64::*;

use glam::Vec3A;

use super::lanes::{LANES, Lanes, Task};
use super::ray::Turn;

/// On x86-64 with AVX2 and FMA.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Avx2(());

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

/// All bits of one lane each.
static OUT: [[u16; LANES]; LANES] = {
    let mut out = [[0; LANES]; LANES];
    let mut lane = 0;
    while lane < LANES {
        out[lane][lane] = 0xFFFF;
        lane += 1;
    }
    out
};

/// Runs an instruction.
macro_rules! run {
    ($instruction:expr) => {
        // SAFETY: `found` alone makes an `Avx2`, where the processor has the instruction; what
        // is loaded or stored is an array of the vector's size.
        unsafe { $instruction }
    };
}

#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
#[inline(never)]
fn apart<T: Task>(lanes: Avx2, task: T) -> T::Answer {
    task.run(lanes)
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
    fn mul_add(self, a: __m256, b: __m256, c: __m256) -> __m256 {
        run!(_mm256_fmadd_ps(a, b, c))
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

    #[inline(always)]
    fn fetch(self, at: *const u8) {
        const LINE: usize = 64;
        // A block is five lines, a node four.
        for line in 0..5 {
            // Where nothing is to be read, an address alone does no harm.
            run!(_mm_prefetch::<_MM_HINT_T0>(at.wrapping_add(line * LINE).cast()));
        }
    }

    #[inline(always)]
    fn turned(self, a: Vec3A, turn: &Turn) -> Vec3A {
        let order = run!(_mm_loadu_si128(turn.order().as_ptr().cast()));
        run!(_mm_permutevar_ps(a.into(), order)).into()
    }

    #[inline(always)]
    fn either(self, numbers: &[u32; LANES], [a, b]: [u32; 2]) -> u32 {
        let all = run!(_mm256_loadu_si256(numbers.as_ptr().cast()));
        let a = run!(_mm256_cmpeq_epi32(all, _mm256_set1_epi32(a as i32)));
        let b = run!(_mm256_cmpeq_epi32(all, _mm256_set1_epi32(b as i32)));
        run!(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_or_si256(a, b)))) as u32
    }

    type Queue = __m128i;

    #[inline(always)]
    fn queue(self, near: __m256, far: __m256) -> __m128i {
        let missed = run!(_mm256_cmp_ps::<_CMP_NLE_UQ>(near, far));
        let all = run!(_mm256_castps_si256(_mm256_or_ps(near, missed)));
        let all = run!(_mm256_srli_epi32::<16>(all));
        let (low, high) =
            (run!(_mm256_castsi256_si128(all)), run!(_mm256_extracti128_si256::<1>(all)));
        run!(_mm_packus_epi32(low, high))
    }

    #[inline(always)]
    fn first(self, queue: __m128i) -> (u32, usize) {
        let least = run!(_mm_cvtsi128_si32(_mm_minpos_epu16(queue))) as u32;
        (least & 0xFFFF, (least >> 16) as usize % LANES)
    }

    #[inline(always)]
    fn without(self, queue: __m128i, lane: usize) -> __m128i {
        run!(_mm_or_si128(queue, _mm_loadu_si128(OUT[lane].as_ptr().cast())))
    }

    #[inline(always)]
    fn apart<T: Task>(self, task: T) -> T::Answer {
        run!(apart(self, task))
    }

    type Exact = __m256d;

    #[inline(always)]
    fn exact(self, [x, y, z]: [f32; 3]) -> __m256d {
        run!(_mm256_cvtps_pd(_mm_setr_ps(x, y, z, 0.0)))
    }

    #[inline(always)]
    fn exact_splat(self, value: f64) -> __m256d {
        run!(_mm256_set1_pd(value))
    }

    #[inline(always)]
    fn exact_store(self, a: __m256d) -> [f64; 3] {
        let low = run!(_mm256_castpd256_pd128(a));
        let high = run!(_mm256_extractf128_pd::<1>(a));
        let y = run!(_mm_unpackhi_pd(low, low));
        [run!(_mm_cvtsd_f64(low)), run!(_mm_cvtsd_f64(y)), run!(_mm_cvtsd_f64(high))]
    }

    #[inline(always)]
    fn exact_add(self, a: __m256d, b: __m256d) -> __m256d {
        run!(_mm256_add_pd(a, b))
    }

    #[inline(always)]
    fn exact_sub(self, a: __m256d, b: __m256d) -> __m256d {
        run!(_mm256_sub_pd(a, b))
    }

    #[inline(always)]
    fn exact_mul(self, a: __m256d, b: __m256d) -> __m256d {
        run!(_mm256_mul_pd(a, b))
    }

    #[inline(always)]
    fn exact_abs(self, a: __m256d) -> __m256d {
        run!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a))
    }

    #[inline(always)]
    fn exact_turn(self, a: __m256d) -> __m256d {
        run!(_mm256_permute4x64_pd::<0b11_00_10_01>(a))
    }

    #[inline(always)]
    fn exact_round(self, a: __m256d) -> [f32; 3] {
        let mut all = [0.0; 4];
        run!(_mm_storeu_ps(all.as_mut_ptr(), _mm256_cvtpd_ps(a)));
        let [x, y, z, _] = all;
        [x, y, z]
    }
}
