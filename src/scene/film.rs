//! Film: what the camera's light becomes.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{Exposure, Number, Size};

vocabulary! {
    /// The picture's size, and how samples become pixels.
    pub struct Film {
        /// Columns and rows, in pixels.
        size: Size = "(512, 512)", Range::between(1.0, 65_536.0);
        /// How samples around a pixel are weighed.
        filter: Filter = "box {}";
        /// Brightness of the PNG: +1 ev doubles. The EXR holds the light itself.
        exposure: Exposure = "0 ev", Range::between(-100.0, 100.0);
    }
}

vocabulary! {
    /// How samples around a pixel's centre are weighed; distances are in pixels.
    pub enum Filter: "filter" {
        /// All samples alike.
        "box" => BoxFilter {
            /// How far it reaches along x and y.
            radius: Number = "0.5", Range::between(0.01, 8.0);
        }
        /// A bell, cut off and lowered so that it ends at zero.
        "gaussian" => Gaussian {
            /// How far it reaches along x and y.
            radius: Number = "1.5", Range::between(0.01, 8.0);
            /// Its standard deviation.
            deviation: Number = "0.5", Range::between(0.01, 8.0);
        }
        /// The cubics of Mitchell and Netravali: sharp, with negative lobes, which add noise even
        /// to areas of one brightness, of a standard deviation of about 0.56 / sqrt(samples) of
        /// it, where samples fall at random. It wants many samples.
        "mitchell" => Mitchell {
            /// How far it reaches along x and y.
            radius: Number = "2", Range::between(0.01, 8.0);
            /// Their B: blur.
            b: Number = "0.3333333333333333", Range::between(0.0, 1.0);
            /// Their C: ringing.
            c: Number = "0.3333333333333333", Range::between(0.0, 1.0);
        }
        /// Falls in a straight line to zero.
        "tent" => Tent {
            /// How far it reaches along x and y.
            radius: Number = "1", Range::between(0.01, 8.0);
        }
    }
}
