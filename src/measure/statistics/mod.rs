//! What a random estimate is worth: moments, distributions, and tests with a stated confidence.
//!
//! No test here says "equal": each says that a difference as large as the one seen would be rarer
//! than the level asked for, or that it would not.

mod agreement;
mod chi_squared;
mod distributions;
mod estimate;
mod moments;
mod tiles;

pub use agreement::{Figures, Verdict, agrees};
pub use chi_squared::{Fit, LEAST_EXPECTED, Unfit, chi_squared};
pub use distributions::{
    chi_squared_survival, normal_quantile, normal_two_sided, sidak, student_t_quantile,
    student_t_two_sided,
};
pub use estimate::{Estimate, ROUNDING};
pub use moments::Moments;
pub use tiles::{Extreme, Outcome, welch, welch_tiles, z_blocks};
