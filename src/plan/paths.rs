//! Which of the paths that a picture or a layer is to show there can be at all.

use super::survey::Survey;
use crate::load::Stage;
use crate::math::paths::{Automaton, End, Event, Expression};
use crate::scene::Integrator;

/// Why no light comes to a picture or a layer of chosen paths.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unmet {
    /// Layers before take all that it means, or the picture shows none of it.
    Taken,
    /// The integrator follows no light so far.
    NotFollowed,
    /// No surface scatters so; what they do is this.
    NoSurface(Vec<Event>),
}

/// What there is of chosen paths.
pub struct Chosen {
    /// Why the picture is black, if its paths make it so.
    pub picture: Option<Unmet>,
    /// Whether the picture shows all paths that there can be.
    pub all: bool,
    /// The same for each layer.
    pub layers: Vec<Option<Unmet>>,
}

impl Chosen {
    /// What there is of the chosen paths of a stage. None: they cannot be told apart, which
    /// `prepare` tells.
    pub fn of(stage: &Stage) -> Option<Self> {
        Self::of_survey(&Survey::of(stage))
    }

    pub(super) fn of_survey(survey: &Survey) -> Option<Self> {
        let scene = &survey.stage.scene;
        let (picture, which) = scene.which_paths();
        let made = Automaton::new(picture, &which).ok()?;
        let every = Automaton::new(None, &[]).ok()?;
        let followed = followed(&scene.integrator);
        let followed = match &followed {
            Followed::Only(paths) => Some(Automaton::new(Some(paths), &[]).ok()?),
            Followed::All => Some(every.clone()),
            Followed::Nothing => None,
        };
        let mut events: Vec<Event> =
            survey.surfaces.iter().flat_map(|it| it.material.value.events()).copied().collect();
        events.sort_unstable();
        events.dedup();

        // By what all surfaces could do, by what the integrator follows of it, and by what the
        // surfaces do that there are.
        let meant = made.ends(&Event::ALL, &every);
        let met = followed.as_ref().map(|it| made.ends(&Event::ALL, it)).unwrap_or_default();
        let there = followed.as_ref().map(|it| made.ends(&events, it)).unwrap_or_default();
        let unmet = |goes: &dyn Fn(&End) -> bool| match () {
            () if !meant.iter().any(goes) => Some(Unmet::Taken),
            () if !met.iter().any(goes) => Some(Unmet::NotFollowed),
            () if !there.iter().any(goes) => Some(Unmet::NoSurface(events.clone())),
            () => None,
        };
        let layer = |number| unmet(&|end| *end == End::Layer(number));
        Some(Self {
            picture: picture.and_then(|_| unmet(&|end| *end != End::Outside)),
            all: !there.contains(&End::Outside),
            // There are at most 64.
            layers: (0..which.len()).map(|number| layer(number as u8)).collect(),
        })
    }
}

/// Which paths an integrator follows.
enum Followed {
    Nothing,
    Only(Expression),
    All,
}

fn followed(integrator: &Integrator) -> Followed {
    let paths = match integrator {
        Integrator::Preview(_) => return Followed::Nothing,
        Integrator::Ambient(_) | Integrator::Direct(_) => "L (D | G)? S* E",
        Integrator::Path(_) => return Followed::All,
    };
    Expression::parse(paths).map_or(Followed::All, Followed::Only)
}
