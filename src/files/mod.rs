//! The only room that touches the disk.
//!
//! Whatever comes from outside is hostile until checked: only regular files are opened, sizes are
//! bounded before anything is allocated. Whatever goes out appears whole or not at all.
//!
//! Left out: glTF, until a scene needs it. It will be read here, its own buffers and pictures
//! resolved by us, never by the crate.

mod failure;
pub mod memory;
mod lines;
pub mod regular;
pub mod text;
pub mod whole;
pub mod hold;
pub mod exr;
pub mod png;
pub mod svg;
pub mod texture;
pub mod checkpoint;
pub mod obj;
pub mod mtl;

pub use failure::Failure;

/// What is told about a picture, key and value; ours begin with `scn:`.
pub type Metadata = Vec<(String, String)>;

/// Two files at once, where there are threads for both.
pub fn both<A: Send, B: Send>(
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    rayon::join(one, other)
}
