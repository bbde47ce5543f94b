//! Stage → what bounds what: objects where they stand, in metres and f64.

mod charts;
mod errors;
mod placed;

pub use placed::{Body, Placed, place};
