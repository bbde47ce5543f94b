//! Lights: what shines without being the surface of an object.

use super::vocabulary::vocabulary;
use super::{Direction, Irradiance, Radiance};

vocabulary! {
    /// Light that comes from no surface. Lamps with a surface are objects with an emission.
    pub enum Light: "light" {
        /// The same radiance from everywhere around the scene. With the integrator `direct` it is
        /// seen behind the scene, and lights nothing.
        "constant" => Constant {
            /// What is seen of it.
            radiance: Radiance;
        }
        /// Parallel light from infinitely far away.
        "directional" => Directional {
            /// Where the light goes.
            direction: Direction;
            /// On a surface square to it.
            irradiance: Irradiance;
        }
    }
}
