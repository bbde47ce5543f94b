//! Daylight: where the sun stands, what of its light comes through the air, and the sky around it
//! [Preetham99]; beside it another model of the same light [Bird86].
//!
//! Angles are in radians, wavelengths in nm. Directions at a place are east, north, up; azimuths
//! are counted from north through east. A spectrum in watts for each nm is weighed by the eye to
//! three channels in watts, as everywhere here: 1 W of luminance is 683 lm.

pub mod air;
pub mod bird_riordan;
pub mod position;
pub mod sky;
pub mod sun;

pub use air::Air;
pub use position::Sun;
pub use sky::Sky;

/// Turbidities for which the sky is a sky: how much thicker the whole air is than pure air. Below,
/// and with a low sun above, the formulas turn negative or without bound [Zotti07]. They were fitted
/// from 2 on; below 2 the horizon brightens as air gets thinner, against nature.
pub const TURBIDITIES: std::ops::RangeInclusive<f64> = 1.7..=10.0;
