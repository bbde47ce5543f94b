//! Media whose index varies with the wavelength: three channels are refracted by one index.

use std::collections::HashSet;

use super::bias::{Bias, Kind};
use super::survey::Survey;
use crate::load::Stage;
use crate::optics;
use crate::scene::{Material, Medium};

/// Wavelengths in nm between which catalogues tell how far an index varies: the blue and the red
/// line of hydrogen.
const LINES: [f64; 2] = [486.1, 656.3];

/// An index that varies by less parts colours by less than a quarter of a minute of arc.
const LEAST: f64 = 1e-4;

/// One for each medium in use that parts colours.
pub(super) fn biases(stage: &Stage, survey: &Survey) -> Vec<Bias> {
    let mut known = HashSet::new();
    let mut found = Vec::new();
    for surface in &survey.surfaces {
        let Material::Dielectric(dielectric) = &surface.material.value.value else { continue };
        for name in [Some(&dielectric.inside.value), dielectric.outside.as_ref()] {
            let Some(medium) = name.map(|name| stage.medium(name)) else { continue };
            if known.insert(&*medium.name.value) {
                found.extend(bias(&medium.name, &medium.value));
            }
        }
    }
    found
}

fn bias(name: &str, medium: &Medium) -> Option<Bias> {
    let Medium::Homogeneous(homogeneous) = medium;
    let ior = &homogeneous.ior;
    let at = |nm: f64| optics::at(&ior.n, nm);
    let [blue, red] = LINES.map(at);
    if (blue - red).abs() <= LEAST {
        return None;
    }
    let middle = at(optics::MIDDLE);
    Some(Bias {
        kind: Kind::Dispersion,
        setting: format!("the index of `{name}`"),
        at: ior.span,
        effect: format!(
            "all light is refracted by {middle:.4}, its index in yellow; it is {blue:.4} in blue \
             and {red:.4} in red, so that colours part"
        ),
        brief: format!(
            "colours do not part: {:.2} % of the index",
            100.0 * (blue - red).abs() / middle
        ),
        bound: None,
        instead_write: "rendering by wavelengths is yet to come. A plain number as the index says \
                        that one is meant",
        instead: None,
    })
}
