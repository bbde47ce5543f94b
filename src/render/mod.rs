//! World → samples. Knows light, not words. Cannot fail, cannot read, cannot print.

pub mod geometry;
