//! Faults that show when a scene is put together.

pub(super) mod matter;
pub(super) mod paths;
pub(super) mod scene;
pub(super) mod texture;
