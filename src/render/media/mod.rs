//! Media: what happens to light on its way.

use crate::math::Rgb;

/// What fills space, the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// The part of the light that is lost on each world unit of way.
    pub absorption: Rgb,
    /// The part of the light that goes on in another direction, on each world unit of way.
    pub scattering: Rgb,
    /// Mean cosine of the angle by which scattered light is turned, by Henyey and Greenstein's
    /// formula; 0 is the same to all sides.
    pub asymmetry: f32,
}
