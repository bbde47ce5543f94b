//! Materials: what a surface does with light.

use super::vocabulary::vocabulary;
use super::{Radiance, Reflectance};

vocabulary! {
    /// What a surface does with light.
    pub enum Material: "material" {
        /// Lambert's: the same radiance in every direction.
        "diffuse" => Diffuse {
            /// The part of the light that is scattered back.
            albedo: Reflectance;
            /// What the front side shines of itself. A surface with an emission is a lamp.
            emission: Radiance = "0 W/m^2/sr";
        }
    }
}
