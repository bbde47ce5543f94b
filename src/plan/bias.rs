//! Settings that make a picture systematically wrong: what no number of samples mends.
//!
//! A new one is a [`Kind`], and a function that finds it.

use super::paths::Chosen;
use super::survey::Survey;
use super::{dispersion, rare, spectra};
use crate::diag::Span;
use crate::load::Stage;
use crate::scene::{self, AreaLights, At, Integrator, Switch};

/// In which way a picture is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// No light is followed.
    Preview,
    /// Light that was scattered more often than is followed is missing.
    Depth,
    /// Light that was mirrored more often than is followed is missing.
    SpecularDepth,
    /// A light that is not followed to surfaces.
    ConstantLight,
    /// Lamps and lights do not shine on surfaces.
    LightsOff,
    /// Lights without extent are left to chance, which never meets them.
    NeverMet,
    /// Light that mirrors or glass send from lights without extent to surfaces is never found.
    Caustics,
    /// Light that mirrors or glass send from small lights to surfaces is hardly ever found.
    RareCaustics,
    /// Surfaces far away hide nothing of what surrounds the scene.
    AmbientDistance,
    /// Surfaces hide no light.
    NoShadows,
    /// Lamps shine from their centres.
    LampCentres,
    /// Three channels are multiplied in place of two spectra.
    RgbForSpectra,
    /// All light is refracted by one index.
    Dispersion,
    /// Only some paths of light are shown.
    Paths,
}

impl Kind {
    /// Whether samples mend it after all: what is rare is noise, of which the error may not know.
    pub fn is_noise(self) -> bool {
        self == Self::RareCaustics
    }

    /// The word that machines read.
    pub fn word(self) -> &'static str {
        match self {
            Self::Preview => "preview",
            Self::Depth => "depth",
            Self::SpecularDepth => "specular_depth",
            Self::ConstantLight => "constant_light",
            Self::LightsOff => "lights_off",
            Self::NeverMet => "never_met",
            Self::Caustics => "caustics",
            Self::RareCaustics => "rare_caustics",
            Self::AmbientDistance => "ambient_distance",
            Self::NoShadows => "no_shadows",
            Self::LampCentres => "lamp_centres",
            Self::RgbForSpectra => "rgb_for_spectra",
            Self::Dispersion => "dispersion",
            Self::Paths => "paths",
        }
    }
}

/// A setting that makes the picture systematically wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Bias {
    /// In which way.
    pub kind: Kind,
    /// The setting, as in a text.
    pub setting: String,
    /// Where it stands; of a default, the record that left it out.
    pub at: Span,
    /// What it does, without full stop.
    pub effect: String,
    /// The same in a few words.
    pub brief: String,
    /// The largest part that can be missing of the light that all surfaces scatter together, 0 to
    /// 1, if there is such a bound below 1.
    pub bound: Option<f64>,
    /// What to write in its place, or what else to do.
    pub instead_write: &'static str,
    /// The integrator without it, if there is one: what it costs can be measured then.
    pub instead: Option<Integrator>,
}

/// Everything about a stage that makes its picture systematically wrong.
pub fn biases(stage: &Stage) -> Vec<Bias> {
    let survey = Survey::of(stage);
    let integrator = &stage.scene.integrator;
    if let Integrator::Preview(_) = &integrator.value {
        return vec![preview(integrator.span)];
    }
    let mut all = Vec::new();
    all.extend(depth(&survey, integrator));
    all.extend(mirrored(&survey, integrator));
    all.extend(constant_lights(&survey, integrator));
    all.extend(lights_off(&survey, integrator));
    all.extend(never_met(&survey, integrator));
    all.extend(caustics(&survey, integrator));
    all.extend(rare::biases(stage, &survey, integrator));
    all.extend(near_ambient(&survey, integrator));
    all.extend(no_shadows(&survey, integrator));
    all.extend(lamp_centres(&survey, integrator));
    all.extend(spectra::biases(&survey));
    all.extend(dispersion::biases(stage, &survey));
    all.extend(some_paths(&survey, integrator));
    all
}

/// None if all paths are shown that there can be.
fn some_paths(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let shown = integrator.paths()?;
    if Chosen::of_survey(survey).is_some_and(|chosen| chosen.all) {
        return None;
    }
    Some(Bias {
        kind: Kind::Paths,
        setting: format!("`paths: \"{}\"`", shown.expression),
        at: shown.span,
        effect: "only the light of these paths is shown".to_string(),
        brief: "only the light of some paths is shown".to_string(),
        bound: None,
        instead_write: "take `paths` away, or show these paths as a layer beside the picture",
        instead: None,
    })
}

fn preview(at: Span) -> Bias {
    Bias {
        kind: Kind::Preview,
        setting: "`preview`".to_string(),
        at,
        effect: "no light is followed: the picture shows what is where, not how bright it is"
            .to_string(),
        brief: "no light is followed".to_string(),
        bound: None,
        instead_write: "follow light: write `integrator: direct`",
        instead: None,
    }
}

/// None if no light can be scattered more often than is followed, or what it meets is black.
fn depth(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let most = integrator.scatterings()?;
    let brightest = survey.brightest()?;
    survey.lit_by(integrator)?;
    if !survey.scatters_twice() {
        return None;
    }
    let (setting, at, missing) = match &integrator.value {
        Integrator::Path(path) => (
            format!("`depth: {most}`"),
            path.depth.span,
            format!("light that was scattered more than {} is missing", times(most)),
        ),
        other => {
            let word = if let Integrator::Ambient(_) = other { "ambient" } else { "direct" };
            let missing = "light that met more than one surface is missing".to_string();
            (format!("`{word}`"), integrator.span, missing)
        }
    };
    // Mirrors and glass may gather light: no albedo bounds what comes by them.
    let bound = (survey.specular().is_none() && brightest.albedo < 1.0)
        .then(|| brightest.albedo.powf(most as f64));
    let percent = bound.map(|bound| (1000.0 * bound).ceil() / 10.0);
    let brief = match percent {
        Some(percent) => format!("at most {percent} % of the light on surfaces is missing"),
        None => "any part of the light on surfaces may be missing".to_string(),
    };
    let name = &*brightest.material.name;
    let effect = match percent {
        Some(percent) => format!(
            "{missing}; by the albedo of `{name}`, the brightest, at most {percent} % of all that \
             surfaces scatter"
        ),
        None if survey.specular().is_some() => format!("{missing}, any part of all"),
        None => format!("{missing}, any part of all: `{name}` gives back all that it gets"),
    };
    Some(Bias {
        kind: Kind::Depth,
        setting,
        at,
        effect,
        brief,
        bound,
        instead_write: "follow light further: write `integrator: path`",
        instead: None,
    })
}

/// None if there are no mirrors, or light is followed by them however often.
fn mirrored(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let depth = match &integrator.value {
        Integrator::Ambient(ambient) => &ambient.specular_depth,
        Integrator::Direct(direct) => &direct.specular_depth,
        Integrator::Path(_) | Integrator::Preview(_) => return None,
    };
    let most = depth.most()?;
    let mirror = survey.specular()?;
    let name = &*mirror.material.name;
    Some(Bias {
        kind: Kind::SpecularDepth,
        setting: format!("`specular_depth: {most}`"),
        at: depth.span,
        effect: format!(
            "light that mirrors, glass and metal, such as `{name}`, sent on more than {} is missing",
            times(most)
        ),
        brief: format!("light mirrored or refracted more than {} is missing", times(most)),
        bound: None,
        instead_write: "write `specular_depth: unlimited`",
        instead: None,
    })
}

/// None if all surfaces are black: it would light nothing.
fn constant_lights(survey: &Survey, integrator: &At<Integrator>) -> Vec<Bias> {
    if integrator.lit_by_surroundings() || survey.brightest().is_none() {
        return Vec::new();
    }
    let bias = |light: &&scene::Named<scene::Light>| {
        let (word, what) = match &light.value.value {
            scene::Light::Preetham(_) => ("preetham", "its sky"),
            _ => ("constant", "it"),
        };
        Bias {
            kind: Kind::ConstantLight,
            setting: format!("`light {}: {word}` under `direct`", *light.name),
            at: light.value.span,
            effect: format!("{what} is seen behind the scene, and lights no surface"),
            brief: format!("{what} lights no surface"),
            bound: None,
            instead_write: "write `environment: on` in the integrator, or leave the light out",
            instead: None,
        }
    };
    survey.surroundings.iter().map(bias).collect()
}

/// None if lights shine on surfaces, or there are none.
fn lights_off(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let at = integrator.lit_by_lights().err()?;
    survey.brightest()?;
    let light = survey.shining()?;
    Some(Bias {
        kind: Kind::LightsOff,
        setting: "`direct: off`".to_string(),
        at,
        effect: format!("lights such as `{}` are not followed to surfaces", **light),
        brief: "no lamp or light shines on surfaces".to_string(),
        bound: None,
        instead_write: "write `direct: on`",
        instead: None,
    })
}

/// None if lights are asked, or all have an extent.
fn never_met(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let Integrator::Path(path) = &integrator.value else { return None };
    let light = survey.sharp.first().filter(|_| !path.next_event.0)?;
    survey.brightest()?;
    Some(Bias {
        kind: Kind::NeverMet,
        setting: "`next_event: off`".to_string(),
        at: path.next_event.span,
        effect: format!(
            "no path meets {} `{}`, which has no extent: it lights nothing",
            if let scene::Light::Preetham(_) = &light.value.value {
                "the sun of"
            } else {
                "the light"
            },
            *light.name
        ),
        brief: "lights without extent are never met".to_string(),
        bound: None,
        instead_write: "write `next_event: on`",
        instead: None,
    })
}

/// One for each light without extent; none if nothing sends light on in one direction alone. Where
/// lights are not asked, all of their light is missing, and that is told.
fn caustics(survey: &Survey, integrator: &At<Integrator>) -> Vec<Bias> {
    let Integrator::Path(path) = &integrator.value else { return Vec::new() };
    let (mirrors, Some(lit)) = (survey.mirrors(), survey.brightest()) else {
        return Vec::new();
    };
    let (mirrors, send, between) = match mirrors.as_slice() {
        [] => return Vec::new(),
        [one] => (format!("`{one}`"), "sends", " and"),
        [first, second] => (format!("`{first}` and `{second}`"), "send", ","),
        [first, second, rest @ ..] => {
            (format!("`{first}`, `{second}` and {} more", rest.len()), "send", ",")
        }
    };
    let sharp = survey.sharp.iter().filter(|_| path.next_event.0);
    let bias = |light: &str| Bias {
        kind: Kind::Caustics,
        setting: format!("`light {light}`{between} {mirrors} under `path`"),
        at: integrator.span,
        effect: format!(
            "light of `{light}`, which has no extent, that {mirrors} {send} to surfaces such as \
             `{}` is never found",
            *lit.object.name
        ),
        brief: format!("caustics of `{light}` are missing"),
        bound: None,
        instead_write: "give the light an extent: a lamp in its place, that is a surface with an \
                        `emission`",
        instead: None,
    };
    sharp.map(|light| bias(&light.name)).collect()
}

/// None if surfaces hide what surrounds the scene however far away they are.
fn near_ambient(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let Integrator::Ambient(ambient) = &integrator.value else { return None };
    ambient.distance.as_ref()?;
    survey.brightest()?;
    survey.surroundings.first()?;
    Some(Bias {
        kind: Kind::AmbientDistance,
        setting: "`distance` of `ambient`".to_string(),
        at: ambient.distance.span,
        effect: "surfaces that are further away hide nothing of what surrounds the scene"
            .to_string(),
        brief: "surfaces far away hide nothing".to_string(),
        bound: None,
        instead_write: "leave `distance` out",
        instead: None,
    })
}

/// None if there is nothing to hide.
fn no_shadows(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let Integrator::Direct(direct) = &integrator.value else { return None };
    survey.brightest()?;
    survey.shining()?;
    if direct.shadows.0 || survey.only_convex().is_some() {
        return None;
    }
    let shadows = At::new(Switch(true), direct.shadows.span);
    Some(Bias {
        kind: Kind::NoShadows,
        setting: "`shadows: off`".to_string(),
        at: direct.shadows.span,
        effect: "surfaces get light that others hide".to_string(),
        brief: "surfaces hide no light".to_string(),
        bound: None,
        instead_write: "write `shadows: on`",
        instead: Some(Integrator::Direct(scene::Direct { shadows, ..direct.clone() })),
    })
}

/// None if no lamp lights anything.
fn lamp_centres(survey: &Survey, integrator: &At<Integrator>) -> Option<Bias> {
    let Integrator::Direct(direct) = &integrator.value else { return None };
    survey.brightest()?;
    survey.lamp()?;
    if direct.area_lights.value == AreaLights::Random {
        return None;
    }
    let area_lights = At::new(AreaLights::Random, direct.area_lights.span);
    Some(Bias {
        kind: Kind::LampCentres,
        setting: "`area_lights: center`".to_string(),
        at: direct.area_lights.span,
        effect: "lamps shine from their centres: no half-shadows, and too bright or too dark near \
                 a lamp"
            .to_string(),
        brief: "lamps shine from their centres".to_string(),
        bound: None,
        instead_write: "write `area_lights: random`",
        instead: Some(Integrator::Direct(scene::Direct { area_lights, ..direct.clone() })),
    })
}

/// "once", "3 times".
fn times(count: u64) -> String {
    match count {
        1 => "once".to_string(),
        2 => "twice".to_string(),
        more => format!("{more} times"),
    }
}
