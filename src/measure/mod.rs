//! Images and estimates judged: error metrics, variance, confidence, statistical tests.
//!
//! Knows numbers and pictures, not where they come from. Everything is public: the test suite
//! decides with it whether a renderer is right.

pub mod statistics;
pub mod noise;
mod pair;
mod planes;
mod errors;
pub mod flip;
mod similarity;
mod metrics;
mod magma;

pub use errors::{Errors, MAPE_EPSILON, RELMSE_EPSILON, TRIMMED};
pub use magma::{in_magma, magma};
pub use metrics::{METRICS, Metric, Metrics, Settings};
pub use pair::{Pair, Unpaired};
pub use planes::Plane;
pub use similarity::ssim;
