//! Media of the scene → media of the world.

use super::errors::matter as errors;
use super::materials::as_f32;
use super::space::Space;
use crate::bodies::Matter;
use crate::diag::Diagnostic;
use crate::math::Rgb;
use crate::optics::colour;
use crate::render::media::Medium;
use crate::scene::{self, Coefficient, Integrator, Phase};

/// Media as the world has them, and what about them cannot be rendered.
pub(super) fn prepare(
    matter: &Matter,
    integrator: &Integrator,
    space: &Space,
    found: &mut Vec<Diagnostic>,
) -> Vec<Medium> {
    let mut medium = |named: &Option<&scene::Named<scene::Medium>>| {
        let Some(named) = named else { return CLEAR };
        let scene::Medium::Homogeneous(said) = &named.value.value;
        if said.ior.absorbs() && !said.absorption.0.is_zero() {
            found.push(errors::absorbs_twice(&named.name, said.ior.span, said.absorption.span));
        } else if integrator.follows_light() && said.ior.absorbs() {
            found.push(errors::not_followed(&named.name, said.ior.span, "absorbs", true));
        } else if integrator.follows_light() && said.scatters() {
            found.push(errors::not_followed(&named.name, said.scattering.span, "scatters", false));
        } else if integrator.follows_light() && said.absorbs() {
            found.push(errors::not_followed(&named.name, said.absorption.span, "absorbs", false));
        }
        // Where a world unit is so many metres light is lost that much more often.
        let metres = 1.0 / space.length(1.0);
        let each = |of: &Coefficient| as_f32(colour::reflected(&of.0).map(|c| c * metres));
        Medium {
            absorption: each(&said.absorption),
            scattering: each(&said.scattering),
            asymmetry: match &said.phase.value {
                Phase::HenyeyGreenstein(phase) => phase.g.0 as f32,
                Phase::Isotropic(_) => 0.0,
            },
        }
    };
    matter.media.iter().map(&mut medium).collect()
}

const CLEAR: Medium = Medium { absorption: Rgb::BLACK, scattering: Rgb::BLACK, asymmetry: 0.0 };
