//! Samplers: where in a pixel, and where on a lamp, the random numbers fall.

use super::Count;
use super::schema::Range;
use super::vocabulary::vocabulary;

vocabulary! {
    /// Where the random numbers come from.
    pub enum Sampler: "sampler" {
        /// Every number by itself.
        "independent" => Independent {}
        /// Owen-scrambled Sobol points: after every power of two samples each pixel, and each lamp,
        /// is covered evenly in all directions; after a round it begins again with another
        /// scramble.
        "sobol" => Sobol {
            /// Samples of a round, best a power of two. Long rounds err less; at least two of them
            /// are needed to know by how much.
            round: Count = "64", Range::between(1.0, 65536.0);
        }
        /// Jittered: each pixel is cut into grid × grid cells, each sample falls somewhere in a
        /// cell of its own; after grid × grid samples it begins again.
        "stratified" => Stratified {
            /// Cells along each side of a pixel.
            grid: Count = "4", Range::between(1.0, 1024.0);
        }
    }
}
