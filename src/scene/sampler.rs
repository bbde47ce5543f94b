//! Samplers: where in a pixel, and where on a lamp, the random numbers fall.

use super::Count;
use super::schema::Range;
use super::vocabulary::vocabulary;

vocabulary! {
    /// Where the random numbers come from.
    pub enum Sampler: "sampler" {
        /// Every number by itself.
        "independent" => Independent {}
        /// Jittered: each pixel is cut into grid × grid cells, each sample falls somewhere in a
        /// cell of its own; after grid × grid samples it begins again.
        "stratified" => Stratified {
            /// Cells along each side of a pixel.
            grid: Count = "4", Range::between(1.0, 1024.0);
        }
    }
}
