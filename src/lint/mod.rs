//! Legal, but probably not what was meant: one rule, one file in `rules`.
//!
//! An error has no right picture; a lint has one, and a reason to doubt that it is the one that
//! was meant. So every finding is a warning, none fires on good practice, and a comment
//! `// lint: allow(rule) because "…"` keeps one that was meant.

mod allow;
mod errors;
mod fix;
mod inside;
mod rules;
mod selection;
mod view;

use std::collections::HashMap;

use glam::DVec3;

use crate::bodies::{self, Placed};
use crate::diag::{Code, Diagnostic, Span};
use crate::lang::outline::{Declared, Outline};
use crate::load::Stage;
use crate::scene::{At, Reflectance, Scene};

pub use allow::{Seen, allowed};
pub use fix::{Fixed, Mended, fixed};
pub use selection::Selection;

/// A rule: the code of what it finds, and how it looks for it.
struct Rule {
    /// The code; the heading of its page says in a few words what it finds.
    code: Code,
    /// How it looks.
    look: Look,
}

/// What a rule looks at.
enum Look {
    /// What the file declares.
    Text(fn(&Text, &mut Vec<Diagnostic>)),
    /// One render by itself; what several have in common is told once.
    Render(fn(&Shot, &mut Vec<Diagnostic>)),
    /// Renders that are drawn together: what is so of all that have it, or common to two. It holds
    /// of any part of a file's renders, too.
    Together(fn(&[Shot], &mut Vec<Diagnostic>)),
    /// All renders of a file: what none at all makes use of, what nearly all have.
    All(fn(&[Shot], &mut Vec<Diagnostic>)),
}

/// The words of a file.
pub struct Text<'a> {
    /// What it declares.
    pub outline: &'a Outline,
    /// Whether it has renders. One without is there for others to use.
    pub draws: bool,
}

impl<'a> Text<'a> {
    /// The declarations of the main file.
    fn declared(&self) -> impl Iterator<Item = &'a Declared> {
        let main = self.outline.files.first();
        self.outline.declared.iter().filter(move |said| Some(&said.at.file) == main)
    }

    /// Those that nothing mentions, and that no other file could be meant to use.
    fn unused(&self) -> impl Iterator<Item = &'a Declared> {
        let draws = self.draws;
        self.declared().filter(move |said| !said.used && (draws || said.inside))
    }
}

/// A render that has no errors, ready to be looked at.
pub struct Shot<'a> {
    name: At<String>,
    stage: &'a Stage,
    /// Whether the scene's own limits end the render, and not others in their place.
    own_limits: bool,
    things: Vec<Placed<'a>>,
}

impl<'a> Shot<'a> {
    /// A render by its name and stage. `own_limits`: whether the scene's limits end it, and not
    /// others in their place.
    pub fn new(name: At<String>, stage: &'a Stage, own_limits: bool) -> Self {
        Self { name, stage, own_limits, things: bodies::place(stage, &mut Vec::new()) }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name.value
    }

    /// Where its camera stands, in metres, and where that is said; None where nothing says it.
    fn eye(&self) -> Option<(DVec3, Span)> {
        bodies::eye(&self.stage.scene, &self.things)
    }

    /// What is said of light given back, with the name of the material or the texture.
    fn reflectances(&self) -> impl Iterator<Item = (&'a str, At<&'a Reflectance>)> {
        let scene: &Scene = &self.stage.scene;
        let plain = scene.materials.iter().filter_map(|material| {
            let said = material.value.value.reflectance()?;
            Some((material.name.value.as_str(), At::new(said.value.plain()?, said.span)))
        });
        let textures = scene.textures.iter().flat_map(|texture| {
            let colours = texture.value.value.colours().into_iter();
            let at = |said: &'a At<Reflectance>| At::new(&said.value, said.span);
            colours.map(move |said| (texture.name.value.as_str(), at(said)))
        });
        plain.chain(textures)
    }
}

/// What the rules find in the words of a file, and in its renders together. `all`: whether `shots`
/// are all of its renders.
pub fn of_file(text: &Text, shots: &[Shot], all: bool) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for rule in rules::RULES {
        match rule.look {
            Look::Text(look) => look(text, &mut found),
            Look::Together(look) => look(shots, &mut found),
            Look::All(look) if all => look(shots, &mut found),
            Look::All(_) | Look::Render(_) => {}
        }
    }
    found
}

/// What the rules find in one render.
pub fn of_render(shot: &Shot) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for rule in rules::RULES {
        if let Look::Render(look) = rule.look {
            look(shot, &mut found);
        }
    }
    found
}

/// What is wrong with a place in all renders that have it. `judge` gives the places of a render,
/// each with what is wrong there, if anything is.
fn everywhere(
    shots: &[Shot],
    judge: impl Fn(&Shot) -> Vec<(Span, Option<Diagnostic>)>,
) -> Vec<Diagnostic> {
    let mut places: Vec<(Span, Option<Diagnostic>)> = Vec::new();
    let mut known: HashMap<Span, usize> = HashMap::new();
    for (place, fault) in shots.iter().flat_map(judge) {
        match known.get(&place) {
            None => {
                known.insert(place, places.len());
                places.push((place, fault));
            }
            Some(at) if fault.is_none() => places[*at].1 = None,
            Some(_) => {}
        }
    }
    places.into_iter().filter_map(|(_, fault)| fault).collect()
}

/// Names that a message lists at most.
const NAMES: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::CODES;

    #[test]
    fn every_code_of_the_family_has_its_rule_and_every_rule_its_code() {
        let rules: Vec<_> = rules::RULES.iter().map(|rule| rule.code.name).collect();
        assert!(rules.is_sorted());
        let codes = CODES.iter().map(|code| code.name);
        let codes = codes.filter(|name| name.starts_with("lint/") && !name.contains("/allow-"));
        assert_eq!(rules, codes.collect::<Vec<_>>());
    }
}
