//! World → samples. Knows light, not words. Cannot fail, cannot read, cannot print.
//!
//! Inside: integrators → {world film samplers tiles} → guide → {cameras lights materials} →
//! {textures geometry}.

mod lanes;
pub mod integrators;
pub mod tiles;
mod world;
pub mod film;
pub mod samplers;
pub mod cameras;
pub mod guide;
pub mod lights;
pub mod materials;
pub mod media;
pub mod textures;
pub mod overlaps;
pub mod geometry;

pub use world::World;
