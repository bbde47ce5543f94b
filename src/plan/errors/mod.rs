//! Faults that a plan shows.

mod scene;

pub use scene::biased;
