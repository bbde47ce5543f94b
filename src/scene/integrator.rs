//! Integrators: how light is followed.

use super::Switch;
use super::vocabulary::vocabulary;

vocabulary! {
    /// How the light that reaches the camera is computed.
    pub enum Integrator: "integrator" {
        /// Light that went from a lamp or a `directional` light to a surface to the camera, and no
        /// further. A `constant` light is seen behind the scene, and lights nothing.
        "direct" => Direct {
            /// Whether surfaces hide lamps from each other.
            shadows: Switch = "on";
            /// Which points of a lamp with an area shine.
            area_lights: AreaLights = "random";
        }
        /// What is where: colours, shaded by a light at the camera. No lamps, no shadows.
        "preview" => Preview {}
    }
}

vocabulary! {
    /// Which points of a lamp with an area shine on a surface.
    pub words AreaLights: "choice of lamp points" {
        /// Its centre alone, with all its flux, as in Larsen's simplification: hard shadows, and
        /// wrong close to the lamp.
        "center" => Center
        /// A random point for every sample: right on average, soft shadows.
        "random" => Random
    }
}
