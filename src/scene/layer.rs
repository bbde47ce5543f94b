//! Layers: the light of some paths, in a picture of its own beside the whole.

use super::Only;
use super::vocabulary::vocabulary;

vocabulary! {
    /// Part of the light of a picture, in the EXR beside the picture as channels `NAME.R`,
    /// `NAME.G`, `NAME.B`. Each path belongs to one layer at most, so with `others` among them
    /// they add up to the picture.
    pub enum Layer: "layer" {
        /// The light of some paths. The first layer of the text that means a path takes it; layers
        /// of imported files come last.
        "paths" => PathsLayer {
            /// Which paths: `"L S+ D E"` are caustics.
            only: Only;
        }
    }
}
