//! Faults that show when a scene is put together.

pub(super) mod scene;
