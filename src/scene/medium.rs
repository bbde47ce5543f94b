//! Media: what fills space.

use super::Index;
use super::vocabulary::vocabulary;

vocabulary! {
    /// What fills space, behind surfaces of `dielectric` materials.
    pub enum Medium: "medium" {
        /// The same everywhere.
        "homogeneous" => Homogeneous {
            /// Its index of refraction.
            ior: Index = "1";
        }
    }
}
