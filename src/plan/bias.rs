//! Settings that make a picture systematically wrong: what no number of samples mends.
//!
//! A new one is a [`Kind`], and a function that finds it.

use super::spectra;
use super::survey::Survey;
use crate::diag::Span;
use crate::load::Stage;
use crate::scene::{self, AreaLights, At, Integrator, Switch};

/// In which way a picture is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// No light is followed.
    Preview,
    /// Light that met more than one surface is missing.
    Depth,
    /// A light that is not followed to surfaces.
    ConstantLight,
    /// Surfaces hide no light.
    NoShadows,
    /// Lamps shine from their centres.
    LampCentres,
    /// Three channels are multiplied in place of two spectra.
    RgbForSpectra,
}

impl Kind {
    /// The word that machines read.
    pub fn word(self) -> &'static str {
        match self {
            Self::Preview => "preview",
            Self::Depth => "depth",
            Self::ConstantLight => "constant_light",
            Self::NoShadows => "no_shadows",
            Self::LampCentres => "lamp_centres",
            Self::RgbForSpectra => "rgb_for_spectra",
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
    match &integrator.value {
        Integrator::Preview(_) => vec![preview(integrator.span)],
        Integrator::Direct(direct) => {
            let mut all = Vec::new();
            all.extend(depth(&survey, integrator.span));
            all.extend(constant_lights(&survey));
            all.extend(no_shadows(&survey, direct));
            all.extend(lamp_centres(&survey, direct));
            all.extend(spectra::biases(&survey));
            all
        }
    }
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

/// None if no light can meet a second surface, or what it meets is black.
fn depth(survey: &Survey, at: Span) -> Option<Bias> {
    let brightest = survey.brightest()?;
    survey.shining()?;
    if !survey.scatters_twice() {
        return None;
    }
    let missing = "light that met more than one surface is missing";
    let bound = (brightest.albedo < 1.0).then_some(brightest.albedo);
    let percent = (1000.0 * brightest.albedo).ceil() / 10.0;
    let brief = match bound {
        Some(_) => format!("at most {percent} % of the light on surfaces is missing"),
        None => "any part of the light on surfaces may be missing".to_string(),
    };
    let effect = match bound {
        Some(_) => {
            let name = &*brightest.material.name;
            format!(
                "{missing}; by the albedo of `{name}`, the brightest, at most {percent} % of all \
                 that surfaces scatter"
            )
        }
        None => {
            let name = &*brightest.material.name;
            format!("{missing}, any part of all: `{name}` gives back all that it gets")
        }
    };
    Some(Bias {
        kind: Kind::Depth,
        setting: "`direct`".to_string(),
        at,
        effect,
        brief,
        bound,
        instead_write: "no integrator follows light further yet: render without `--unbiased`, and \
                        read the list of biases at the end",
        instead: None,
    })
}

/// None if all surfaces are black: it would light nothing.
fn constant_lights(survey: &Survey) -> Vec<Bias> {
    if survey.brightest().is_none() {
        return Vec::new();
    }
    let bias = |light: &&scene::Named<scene::Light>| Bias {
        kind: Kind::ConstantLight,
        setting: format!("`light {}: constant` under `direct`", *light.name),
        at: light.value.span,
        effect: "it is seen behind the scene, and lights no surface".to_string(),
        brief: "it lights no surface".to_string(),
        bound: None,
        instead_write: "leave the light out, or take a `directional` one or lamps in its place",
        instead: None,
    };
    survey.constant.iter().map(bias).collect()
}

/// None if there is nothing to hide.
fn no_shadows(survey: &Survey, direct: &scene::Direct) -> Option<Bias> {
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
fn lamp_centres(survey: &Survey, direct: &scene::Direct) -> Option<Bias> {
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
