//! Media: what fills space.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{At, Coefficient, Index, Number};
use crate::math::Spectrum;

vocabulary! {
    /// What fills space, behind surfaces of `dielectric` materials.
    pub enum Medium: "medium" {
        /// The same everywhere.
        "homogeneous" => Homogeneous {
            /// Its index of refraction; a complex one absorbs.
            ior: Index = "1";
            /// The part of the light that is lost on each length of way.
            absorption: Coefficient = "0 / m";
            /// The part of the light that goes on in another direction, on each length of way. Of
            /// an extinction `t` and an albedo `a` it is `t * a`, and the absorption `t * (1 - a)`.
            scattering: Coefficient = "0 / m";
            /// Where scattered light goes.
            phase: Phase = "isotropic";
        }
    }
}

vocabulary! {
    /// Where light goes that a medium scatters.
    pub enum Phase: "phase function" {
        /// By Henyey and Greenstein's formula: mostly forward, or mostly back.
        "henyey_greenstein" => HenyeyGreenstein {
            /// The mean cosine of the angle by which light is turned: 1 is straight on, -1 back.
            g: Number, Range::between(-1.0, 1.0);
        }
        /// As much to each side.
        "isotropic" => Isotropic {}
    }
}

/// The words by which a medium of a shelf is said.
pub struct Measured {
    /// The variant of medium.
    pub medium: &'static str,
    /// Its index, of refraction.
    pub ior: &'static str,
    /// Its absorption, a coefficient.
    pub absorption: &'static str,
    /// Its scattering, a coefficient.
    pub scattering: &'static str,
    /// Where scattered light goes,
    pub phase: &'static str,
    /// if not to all sides alike,
    pub turned: &'static str,
    /// and then by this mean cosine.
    pub cosine: &'static str,
}

/// How a medium of a shelf is said.
pub const MEASURED: Measured = Measured {
    medium: "homogeneous",
    ior: "ior",
    absorption: "absorption",
    scattering: "scattering",
    phase: "phase",
    turned: "henyey_greenstein",
    cosine: "g",
};

impl Homogeneous {
    /// Of an index, and nothing else.
    pub fn clear(ior: At<Index>) -> Self {
        let none = || At { usual: true, ..At::new(Coefficient(Spectrum::Constant(0.0)), ior.span) };
        let phase = At { usual: true, ..At::new(Phase::Isotropic(Isotropic {}), ior.span) };
        Self { absorption: none(), scattering: none(), phase, ior }
    }

    /// Whether light is lost in it.
    pub fn absorbs(&self) -> bool {
        self.ior.absorbs() || !self.absorption.0.is_zero()
    }

    /// Whether light goes on in another direction in it.
    pub fn scatters(&self) -> bool {
        !self.scattering.0.is_zero()
    }
}
