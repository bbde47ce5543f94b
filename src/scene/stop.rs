//! Stop rules: when a picture is done.

use super::Count;
use super::schema::Range;
use super::vocabulary::vocabulary;

vocabulary! {
    /// When the picture is done.
    pub struct Stop {
        /// After so many samples a pixel.
        samples: Count = "16", Range::between(1.0, 4_294_967_296.0);
    }
}
