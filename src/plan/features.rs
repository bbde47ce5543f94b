//! The features of the renderer, and which of them a scene requires.

use super::instances::{self, Copies};
use super::survey::Survey;
use crate::diag::Span;
use crate::load::Stage;
use crate::scene::Integrator;

/// Something that the renderer does only where it has to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Lights and lamps are gathered, and asked at every hit.
    Lights,
    /// Rays from surfaces to lights, to see what is hidden.
    ShadowRays,
    /// Random numbers for each light at every hit.
    LampPoints,
    /// A mesh that stands at several places is kept once.
    Instances,
    /// Normals at the corners of triangles are kept, and read at every hit.
    Normals,
    /// Where on its surface a hit lies.
    Coordinates,
    /// Surfaces that name media are joined to bodies, to know what is around what.
    Bodies,
    /// Surfaces of any material, not diffuse ones alone.
    Materials,
    /// Photons are sent before the picture, to tell paths where light comes from.
    Guide,
    /// Pixels share what they find of the light between surfaces.
    Reuse,
    /// For each path of light, to which layer it belongs, or whether it is shown at all.
    Paths,
}

impl Feature {
    /// All of them, in the order in which they are told.
    pub const ALL: [Self; 11] = [
        Self::Lights,
        Self::ShadowRays,
        Self::LampPoints,
        Self::Instances,
        Self::Normals,
        Self::Coordinates,
        Self::Bodies,
        Self::Materials,
        Self::Guide,
        Self::Reuse,
        Self::Paths,
    ];

    /// The word that machines read.
    pub fn word(self) -> &'static str {
        match self {
            Self::Lights => "lights",
            Self::ShadowRays => "shadow_rays",
            Self::LampPoints => "lamp_points",
            Self::Instances => "instances",
            Self::Normals => "normals",
            Self::Coordinates => "coordinates",
            Self::Bodies => "bodies",
            Self::Materials => "materials",
            Self::Guide => "guide",
            Self::Reuse => "reuse",
            Self::Paths => "paths",
        }
    }

    /// Its name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lights => "light on surfaces",
            Self::ShadowRays => "shadow rays",
            Self::LampPoints => "points on lamps",
            Self::Instances => "instances",
            Self::Normals => "smooth normals",
            Self::Coordinates => "texture coordinates",
            Self::Bodies => "bodies of matter",
            Self::Materials => "materials of any kind",
            Self::Guide => "photons that guide paths",
            Self::Reuse => "light that pixels share",
            Self::Paths => "paths told apart",
        }
    }
}

/// Whether a scene asks for a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// The picture would differ without it.
    Required,
    /// The picture is the same without it.
    Unneeded,
    /// A setting leaves it out, and the picture is another for it.
    SwitchedOff,
}

/// Whether a scene asks for a feature, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The feature.
    pub feature: Feature,
    /// Whether.
    pub need: Need,
    /// Why: a sentence without a full stop, which names what decides.
    pub why: String,
    /// What decides, if it stands somewhere.
    pub at: Option<Span>,
}

/// What a scene requires, and what is built for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// One for each feature, in their order.
    pub answers: Vec<Answer>,
    /// Objects whose meshes can be kept once, mesh by mesh.
    pub copies: Vec<Copies>,
    /// Whether what the scene does not need is built all the same.
    pub forced: bool,
}

impl Plan {
    /// What a stage requires.
    pub fn of(stage: &Stage) -> Self {
        Self::with(stage, &stage.scene.integrator)
    }

    /// What a stage would require with another integrator.
    pub fn with(stage: &Stage, integrator: &Integrator) -> Self {
        let (survey, at) = (Survey::of(stage), stage.scene.integrator.span);
        let copies = instances::copies(&survey);
        let asked = Asked { survey, integrator, at };
        let answers = Feature::ALL.map(|feature| {
            let (need, why, at) = match feature {
                Feature::Lights => asked.lights(),
                Feature::ShadowRays => asked.shadow_rays(),
                Feature::LampPoints => asked.lamp_points(),
                Feature::Instances => instances::answer(stage, &copies),
                Feature::Normals => normals(stage),
                Feature::Coordinates => asked.coordinates(),
                Feature::Bodies => asked.bodies(),
                Feature::Materials => asked.materials(),
                Feature::Guide => asked.guide(),
                Feature::Reuse => asked.reuse(),
                Feature::Paths => paths(stage, integrator),
            };
            Answer { feature, need, why, at }
        });
        Self { answers: answers.to_vec(), copies, forced: false }
    }

    /// The same with everything put in that does not change the picture.
    pub fn forced(self) -> Self {
        Self { forced: true, ..self }
    }

    /// Whether an object is an instance: its mesh is kept once, for all that are of it.
    pub fn is_instance(&self, object: usize) -> bool {
        let of = |copies: &&Copies| copies.objects.binary_search(&object).is_ok();
        let copies = self.copies.iter().find(of);
        copies.is_some_and(|copies| self.forced || copies.is_worth_it())
    }

    /// Whether a scene asks for a feature.
    pub fn requires(&self, feature: Feature) -> bool {
        let mut answers = self.answers.iter().filter(|answer| answer.feature == feature);
        answers.any(|answer| answer.need == Need::Required)
    }

    /// Whether a feature is put in.
    pub fn builds(&self, feature: Feature) -> bool {
        let need = self.answers.iter().find(|answer| answer.feature == feature);
        need.is_none_or(|answer| match answer.need {
            Need::Required => true,
            Need::Unneeded => self.forced,
            Need::SwitchedOff => false,
        })
    }
}

type Reason = (Need, String, Option<Span>);

/// A stage with an integrator, which stands there.
struct Asked<'a> {
    survey: Survey<'a>,
    integrator: &'a Integrator,
    at: Span,
}

impl Asked<'_> {
    fn lights(&self) -> Reason {
        let (survey, integrator) = (&self.survey, self.integrator);
        if !integrator.follows_light() {
            return (Need::Unneeded, "`preview` follows no light".to_string(), Some(self.at));
        }
        if let Err(at) = integrator.asks_lights() {
            let why = match integrator {
                Integrator::Path(_) => "`next_event: off`",
                _ => "`direct: off`",
            };
            return (Need::SwitchedOff, why.to_string(), Some(at));
        }
        match (survey.asked(integrator), survey.brightest()) {
            (None, _) => (Need::Unneeded, "nothing shines on surfaces".to_string(), None),
            (_, None) => (Need::Unneeded, "no surface scatters light".to_string(), None),
            (Some(light), Some(lit)) => {
                let (light, lit) = (light, &lit.object.name);
                let why = match light.value == lit.value {
                    true => format!("`{}` shines, and gives light back", **light),
                    false => format!("`{}` shines, `{}` gives light back", **light, **lit),
                };
                (Need::Required, why, Some(light.span))
            }
        }
    }

    /// Why no light is asked for by surfaces, or none.
    fn unlit(&self) -> Option<Reason> {
        let (need, _, at) = self.lights();
        let why = "no light is asked for by surfaces";
        (need != Need::Required).then(|| (Need::Unneeded, why.to_string(), at))
    }

    fn shadow_rays(&self) -> Reason {
        if let Some(unlit) = self.unlit() {
            return unlit;
        }
        if let Err(at) = self.integrator.shadows() {
            return (Need::SwitchedOff, "`shadows: off`".to_string(), Some(at));
        }
        if let Some(only) = self.survey.only_convex() {
            let why = format!("`{}` is all there is, and hides no light from itself", *only.name);
            return (Need::Unneeded, why, Some(only.name.span));
        }
        let light = self.survey.asked(self.integrator);
        let name = light.map_or("light", |light| light.value.as_str());
        let why = format!("surfaces may hide `{name}`");
        (Need::Required, why, light.map(|light| light.span))
    }

    fn lamp_points(&self) -> Reason {
        if let Some(unlit) = self.unlit() {
            return unlit;
        }
        // A direction is chosen even where lamps are taken for points.
        let around = self.survey.surroundings.first();
        if let Some(light) = around.filter(|_| self.integrator.asks_surroundings()) {
            let why = format!("`{}` shines from everywhere around", *light.name);
            return (Need::Required, why, Some(light.name.span));
        }
        if let Err(at) = self.integrator.lamp_points() {
            let why = "`area_lights: center` takes each lamp for a point";
            return (Need::Unneeded, why.to_string(), Some(at));
        }
        if let Some(lamp) = self.survey.lamp() {
            let why = format!("the lamp `{}` has an area", *lamp.object.name);
            return (Need::Required, why, Some(lamp.object.name.span));
        }
        match self.survey.discs.first() {
            Some(light) => {
                let why = format!("the sun of `{}` is a disc", *light.name);
                (Need::Required, why, Some(light.name.span))
            }
            None => (Need::Unneeded, "no light has an extent".to_string(), None),
        }
    }
}

fn paths(stage: &Stage, integrator: &Integrator) -> Reason {
    match (integrator.paths(), stage.scene.layers.first()) {
        (Some(shown), _) => {
            let why = format!("only `{}` is shown", shown.expression);
            (Need::Required, why, Some(shown.span))
        }
        (None, Some(layer)) => {
            let why = format!("the layer `{}` shows some of them", *layer.name);
            (Need::Required, why, Some(layer.name.span))
        }
        (None, None) => (Need::Unneeded, "all of them go to the picture".to_string(), None),
    }
}

impl Asked<'_> {
    fn coordinates(&self) -> Reason {
        let Some((surface, texture)) = self.survey.textured() else {
            return (Need::Unneeded, "no material reads a texture".to_string(), None);
        };
        let (material, name) = (&surface.material.name, &surface.object.name);
        let why = format!("`{}` on `{}` reads the texture `{texture}`", **material, **name);
        (Need::Required, why, Some(name.span))
    }

    fn materials(&self) -> Reason {
        let Some(surface) = self.survey.special() else {
            return (Need::Unneeded, "all surfaces are diffuse".to_string(), None);
        };
        let (material, name) = (&surface.material.name, &surface.object.name);
        let why = format!("`{}` on `{}` is not simply diffuse", **material, **name);
        (Need::Required, why, Some(name.span))
    }
}

impl Asked<'_> {
    /// What a guide is for: light that goes from a lamp or a sun by a mirror to what scatters it.
    fn guide(&self) -> Reason {
        let unneeded = |why: &str| (Need::Unneeded, why.to_string(), None);
        let guide = match self.integrator {
            Integrator::Path(path) if self.integrator.is_guided() => &path.guide,
            _ => return unneeded("no `guide: photons`"),
        };
        let Some(mirror) = self.survey.specular() else {
            return unneeded("no surface mirrors or refracts");
        };
        let lamp = self.survey.lamp().map(|lamp| &lamp.object.name);
        let Some(light) = lamp.or_else(|| self.survey.discs.first().map(|sun| &sun.name)) else {
            return unneeded("no light has an extent and a place of its own");
        };
        if self.survey.brightest().is_none() {
            return unneeded("no surface scatters light");
        }
        let why = format!("light of `{}` may come by way of `{}`", **light, *mirror.object.name);
        (Need::Required, why, Some(guide.span))
    }
}

impl Asked<'_> {
    /// What pixels have to share: light that goes straight from one diffuse surface to another.
    fn reuse(&self) -> Reason {
        let unneeded = |why: &str, at| (Need::Unneeded, why.to_string(), at);
        let path = match self.integrator {
            Integrator::Path(path) if path.reuse.0 > 1 => path,
            _ => return unneeded("no `reuse`", None),
        };
        if path.depth.most().is_some_and(|most| most < 2) {
            return unneeded("no light may be scattered twice, by `depth`", Some(path.depth.span));
        }
        match self.survey.shared() {
            None => unneeded("no light goes from one simply diffuse surface to another", None),
            Some(surface) => {
                let (pixels, name) = (path.reuse.0, &surface.object.name);
                let why =
                    format!("{pixels} pixels share the light of surfaces such as `{}`", **name);
                (Need::Required, why, Some(path.reuse.span))
            }
        }
    }
}

impl Asked<'_> {
    fn bodies(&self) -> Reason {
        if !self.integrator.follows_light() {
            return (Need::Unneeded, "`preview` follows no light".to_string(), Some(self.at));
        }
        let mut surfaces = self.survey.surfaces.iter();
        match surfaces.find(|surface| surface.material.value.transmits()) {
            Some(surface) => {
                let (material, name) = (&surface.material.name, &surface.object.name);
                let why = format!("`{}` of `{}` lets light through", **material, **name);
                (Need::Required, why, Some(name.span))
            }
            None => (Need::Unneeded, "no surface lets light through".to_string(), None),
        }
    }
}

fn normals(stage: &Stage) -> Reason {
    let smooth = stage.scene.objects.iter().zip(&stage.meshes).find(|(_, mesh)| {
        mesh.as_ref().is_some_and(|staged| !staged.mesh.normal_indices.is_empty())
    });
    match smooth {
        Some((object, _)) => {
            let why = format!("`{}` has normals at its corners", *object.name);
            (Need::Required, why, Some(object.name.span))
        }
        None => (Need::Unneeded, "no mesh has normals at its corners".to_string(), None),
    }
}
