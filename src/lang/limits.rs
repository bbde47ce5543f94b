//! How much a scene may ask for. Each limit has an error of its own, so that no text, however
//! made, costs more than a moment.

/// Bytes of one file.
pub const FILE_BYTES: usize = 8 << 20;
/// Bytes of all files of one scene.
pub const ALL_BYTES: usize = 32 << 20;
/// Faults told of one file; the others are counted.
pub const FAULTS: usize = 1000;
/// Files of one scene.
pub const FILES: usize = 256;
/// Brackets inside brackets, signs before a number, calls inside calls.
pub const DEPTH: usize = 64;
/// Values computed and items built.
pub const ITEMS: usize = 1_000_000;
/// Renders of one file.
pub const RENDERS: usize = 10_000;
/// Elements of a list or a range.
pub const ELEMENTS: usize = 100_000;
