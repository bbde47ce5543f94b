//! Faults that show when objects are placed and joined to bodies.

pub(super) mod matter;
pub(super) mod scene;
