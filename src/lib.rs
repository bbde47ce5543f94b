//! scn: a scene language, its compiler, and the physically based renderer behind it.
//!
//! The rooms of the house, in the order a scene passes them. docs/architecture.md says who may
//! know whom; tests/architecture.rs holds them to it.

pub mod cli;
pub mod lang;
pub mod scene;
pub mod load;
pub mod bodies;
pub mod plan;
pub mod lint;
pub mod prepare;
pub mod render;
pub mod run;
pub mod measure;
pub mod files;
pub mod optics;
pub mod diag;
pub mod data;
pub mod math;
