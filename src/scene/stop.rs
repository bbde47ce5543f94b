//! Stop rules: when a picture is done.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{Count, Number, Switch, Time};

vocabulary! {
    /// When the picture is done: the first limit that is reached ends the render. Without any it is
    /// done after 16 samples a pixel.
    pub struct Stop {
        /// So many samples a pixel; 16 where neither `samples` nor `time` nor `error` is said.
        samples: Option<Count>, Range::between(1.0, 4_294_967_296.0);
        /// So much time of rendering.
        time: Option<Time>, Range::above(0.0);
        /// So large an error: the upper end of the 95 % interval of √relMSE, from 256 samples on.
        error: Option<Number>, Range::inside(0.0, 1.0);
        /// Whether parts of the picture that have reached the error end before others.
        adaptive: Switch = "off";
    }
}

/// Samples a pixel of a picture that has no limit.
const SAMPLES: u64 = 16;

impl Stop {
    /// How many samples each pixel has at most.
    pub fn most_samples(&self) -> Option<u64> {
        let said = self.samples.as_ref().map(|samples| samples.0);
        said.or((self.time.is_none() && self.error.is_none()).then_some(SAMPLES))
    }
}
