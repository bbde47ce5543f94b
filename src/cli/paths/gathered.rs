//! The paths through a pixel, by class, and those that bring most.

use std::collections::HashMap;

use crate::math::Rgb;
use crate::math::paths::{Automaton, End, Event, Expression, Which};
use crate::prepare::Prepared;
use crate::render::integrators::Traced;

/// Caustics straight from the light.
pub const DIRECT: &str = "L (S | G)+ D (S | G)* E";
/// Caustics of light that was scattered before.
pub const INDIRECT: &str = "L .* D (S | G)+ D (S | G)* E";

/// Whether a path is a caustic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Caustic {
    Direct,
    Indirect,
    No,
}

/// All paths of a pixel.
pub struct Gathered {
    /// The samples that were followed.
    pub samples: u64,
    /// How many paths there are.
    pub paths: u64,
    /// What they bring together, in W/m²/sr.
    pub radiance: [f64; 3],
    /// Those that bring most first.
    pub classes: Vec<Class>,
}

/// All paths of one word.
#[derive(Clone, Debug)]
pub struct Class {
    /// From the light to the eye: `L S_t S_t D E`.
    pub word: String,
    pub caustic: Caustic,
    pub paths: u64,
    /// What they bring to the pixel together, in W/m²/sr.
    pub radiance: [f64; 3],
    /// Some of them, those that bring most first.
    pub brightest: Vec<Bright>,
}

/// One path.
#[derive(Clone, Debug)]
pub struct Bright {
    pub sample: u64,
    /// What it brings to the pixel, in W/m²/sr.
    pub radiance: [f64; 3],
    pub traced: Traced,
}

impl Gathered {
    /// Follows so many samples of a pixel, and keeps so many paths of each class themselves.
    pub fn new(prepared: &Prepared, seed: u64, pixel: [u64; 2], samples: u64, kept: usize) -> Self {
        let caustics = Caustics::new();
        let mut numbers: HashMap<Vec<Event>, usize> = HashMap::new();
        let mut all = Self { samples, paths: 0, radiance: [0.0; 3], classes: Vec::new() };
        let world = &prepared.world;
        let scale = world.light_unit / samples as f64;
        for sample in 0..samples {
            prepared.integrator.trace(world, seed, pixel, sample, |weight, traced| {
                let radiance = traced.radiance.to_array().map(|x| scale * weight * f64::from(x));
                let events: Vec<Event> = traced.surfaces.iter().map(|(event, _)| *event).collect();
                let number = *numbers.entry(events).or_insert_with_key(|events| {
                    all.classes.push(Class::new(events, &caustics));
                    all.classes.len() - 1
                });
                let class = &mut all.classes[number];
                all.paths += 1;
                class.paths += 1;
                add(&mut all.radiance, radiance);
                add(&mut class.radiance, radiance);
                class.brightest.push(Bright { sample, radiance, traced });
                if class.brightest.len() >= 2 * kept + 16 {
                    class.keep(kept);
                }
            });
        }
        all.classes.iter_mut().for_each(|class| class.keep(kept));
        all.classes.sort_by(|a, b| luminance(b.radiance).total_cmp(&luminance(a.radiance)));
        all
    }

    /// So many paths, those that bring most first, with the numbers of their classes.
    pub fn brightest(&self, count: usize) -> Vec<(usize, &Bright)> {
        let mut all: Vec<(usize, &Bright)> = Vec::new();
        for (number, class) in self.classes.iter().enumerate() {
            all.extend(class.brightest.iter().map(|path| (number, path)));
        }
        all.sort_by(|(_, a), (_, b)| luminance(b.radiance).total_cmp(&luminance(a.radiance)));
        all.truncate(count);
        all
    }

    /// So many paths with the numbers of their classes: of each class the one that brings most,
    /// then of each the next, so that none is left out for another.
    pub fn of_each(&self, count: usize) -> Vec<(usize, &Bright)> {
        let longest = self.classes.iter().map(|class| class.brightest.len()).max().unwrap_or(0);
        let nth = |nth: usize| {
            let classes = self.classes.iter().enumerate();
            classes.filter_map(move |(number, class)| Some((number, class.brightest.get(nth)?)))
        };
        (0..longest).flat_map(nth).take(count).collect()
    }

    /// The part of the pixel's luminance that is this much radiance.
    pub fn part(&self, radiance: [f64; 3]) -> f64 {
        let whole = luminance(self.radiance);
        if whole == 0.0 { 0.0 } else { luminance(radiance) / whole }
    }
}

impl Class {
    fn new(events: &[Event], caustics: &Caustics) -> Self {
        Self {
            word: word(events),
            caustic: caustics.of(events),
            paths: 0,
            radiance: [0.0; 3],
            brightest: Vec::new(),
        }
    }

    /// Drops all but so many of the paths themselves.
    fn keep(&mut self, kept: usize) {
        self.brightest.sort_by(|a, b| luminance(b.radiance).total_cmp(&luminance(a.radiance)));
        self.brightest.truncate(kept);
    }
}

/// Adds one colour to another.
pub fn add(sum: &mut [f64; 3], added: [f64; 3]) {
    sum.iter_mut().zip(added).for_each(|(sum, added)| *sum += added);
}

/// Y of a linear colour.
pub fn luminance([r, g, b]: [f64; 3]) -> f64 {
    let weights = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 1.0, 0.0), Rgb::new(0.0, 0.0, 1.0)];
    let [red, green, blue] = weights.map(|channel| f64::from(channel.luminance()));
    red * r + green * g + blue * b
}

/// A path in letters, of events from the eye on. Diffuse and glossy scatterings are reflections
/// where nothing is said.
fn word(events: &[Event]) -> String {
    let mut text = "L ".to_string();
    for event in events.iter().rev() {
        text.push_str(letter(*event));
        text.push(' ');
    }
    text + "E"
}

/// How a scattering is written in a word.
pub fn letter(event: Event) -> &'static str {
    match event {
        Event::DiffuseReflection => "D",
        Event::GlossyReflection => "G",
        other => other.letter(),
    }
}

/// Tells caustics apart.
struct Caustics(Option<Automaton>);

impl Caustics {
    fn new() -> Self {
        let expressions = [DIRECT, INDIRECT].map(Expression::parse);
        let [Ok(direct), Ok(indirect)] = &expressions else { return Self(None) };
        Self(Automaton::new(None, &[Which::Only(direct), Which::Only(indirect)]).ok())
    }

    fn of(&self, events: &[Event]) -> Caustic {
        match self.0.as_ref().map(|it| it.of(events.iter().copied())) {
            Some(End::Layer(0)) => Caustic::Direct,
            Some(End::Layer(_)) => Caustic::Indirect,
            _ => Caustic::No,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Event::{DiffuseReflection as D, SpecularReflection as R, SpecularTransmission as T};

    #[test]
    fn words_and_caustics_are_read_from_the_light() {
        let caustics = Caustics::new();
        for (events, expected, caustic) in [
            (&[][..], "L E", Caustic::No),
            (&[D], "L D E", Caustic::No),
            (&[D, T, T], "L S_t S_t D E", Caustic::Direct),
            (&[R, D, R], "L S_r D S_r E", Caustic::Direct),
            (&[D, R, D], "L D S_r D E", Caustic::Indirect),
            (&[D, D, R], "L S_r D D E", Caustic::No),
            (&[T, T, D], "L D S_t S_t E", Caustic::No),
        ] {
            assert_eq!((word(events), caustics.of(events)), (expected.to_string(), caustic));
        }
    }
}
