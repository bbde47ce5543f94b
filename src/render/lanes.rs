//! Loops over many samples at once, which the compiler makes vectors of.
//!
//! What such a loop does is plain arithmetic on rows, one place for each sample, without jumps and
//! calls. Each operation is rounded by itself: so the numbers are those of one sample alone, and the
//! same on every processor, whatever its vectors hold.

use glam::Vec3;

/// So many samples are on their way together at most. Of fewer the packets of rays are less full; what
/// is known of more is ever farther from the processor.
pub const LANES: usize = 256;

/// A number of each sample.
pub type Row<T = f32> = [T; LANES];

/// A vector of each sample, coordinate by coordinate.
pub type Rows = [Row; 3];

/// The vector of a lane.
#[inline(always)]
pub fn get(rows: &Rows, lane: usize) -> Vec3 {
    Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane])
}

/// Gives a lane a vector.
#[inline(always)]
pub fn put(rows: &mut Rows, lane: usize, value: Vec3) {
    rows[0][lane] = value.x;
    rows[1][lane] = value.y;
    rows[2][lane] = value.z;
}

/// The lanes of which something is so, and the others, by number.
pub struct Parted {
    these: Row<u32>,
    others: Row<u32>,
}

impl Default for Parted {
    fn default() -> Self {
        Self { these: [0; LANES], others: [0; LANES] }
    }
}

impl Parted {
    /// Both of so many lanes, in their order. Found without jumps: no processor foretells which they
    /// are.
    #[inline(always)]
    pub fn by(&mut self, count: usize, is_so: impl Fn(usize) -> bool) -> [&[u32]; 2] {
        let count = count.min(LANES);
        let mut found = 0;
        for lane in 0..count {
            self.these[found.min(LAST)] = lane as u32;
            self.others[(lane - found).min(LAST)] = lane as u32;
            found += usize::from(is_so(lane));
        }
        [&self.these[..found], &self.others[..count - found]]
    }
}

/// No place is beyond; said where the compiler would ask.
const LAST: usize = LANES - 1;

/// How many lanes a loop takes for so many: whole vectors, so that none is left over. What the others
/// hold is no matter.
#[inline(always)]
pub fn padded(count: usize) -> usize {
    (count + VECTOR - 1).min(LANES) & !(VECTOR - 1)
}

/// No loop makes longer vectors of numbers of f64, and none of f32 alone much shorter ones.
const VECTOR: usize = 8;

/// Compiles a function for every processor of its kind, for those with AVX2, and for those with
/// AVX-512. It takes the best that there is.
macro_rules! by_processor {
    ($(#[$attribute:meta])* $vis:vis fn $name:ident($($arg:ident: $type:ty),* $(,)?) $body:block) => {
        $(#[$attribute])*
        $vis fn $name($($arg: $type),*) {
            #[inline(always)]
            fn plain($($arg: $type),*) $body

            #[cfg(all(target_arch = "x86_64", not(feature = "portable")))]
            {
                #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2")]
                fn widest($($arg: $type),*) {
                    plain($($arg),*);
                }

                #[target_feature(enable = "avx2")]
                fn wide($($arg: $type),*) {
                    plain($($arg),*);
                }

                match $crate::render::lanes::Vectors::found() {
                    // SAFETY: the processor has these instructions.
                    $crate::render::lanes::Vectors::Avx512 => return unsafe { widest($($arg),*) },
                    // SAFETY: as above.
                    $crate::render::lanes::Vectors::Avx2 => return unsafe { wide($($arg),*) },
                    $crate::render::lanes::Vectors::Plain => {}
                }
            }
            plain($($arg),*);
        }
    };
}

/// What vectors a processor has.
#[cfg(all(target_arch = "x86_64", not(feature = "portable")))]
#[derive(Clone, Copy)]
pub enum Vectors {
    Plain,
    Avx2,
    Avx512,
}

#[cfg(all(target_arch = "x86_64", not(feature = "portable")))]
impl Vectors {
    /// What this processor has; found out once.
    #[inline]
    pub fn found() -> Self {
        let avx2 = std::arch::is_x86_feature_detected!("avx2");
        let avx512 = avx2
            && std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512vl")
            && std::arch::is_x86_feature_detected!("avx512dq")
            && std::arch::is_x86_feature_detected!("avx512bw");
        match (avx512, avx2) {
            (true, _) => Self::Avx512,
            (_, true) => Self::Avx2,
            _ => Self::Plain,
        }
    }
}

pub(super) use by_processor;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_are_parted_in_their_order() {
        let mut parted = Parted::default();
        for count in [0, 1, 7, LANES] {
            let [these, others] = parted.by(count, |lane| lane % 3 == 1);
            let all: Vec<u32> = (0..count as u32).collect();
            let (one, two): (Vec<u32>, Vec<u32>) = all.iter().partition(|&lane| lane % 3 == 1);
            assert_eq!((these, others), (&*one, &*two));
        }
    }
}
