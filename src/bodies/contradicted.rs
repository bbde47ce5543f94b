//! Surfaces that say what is before them, and stand in something else.

use super::asked::ask;
use super::placed::Placed;
use super::seams::side;
use super::surfaces::Skin;
use crate::load::Stage;
use crate::scene::{Material, Medium, Named, Ref};

/// What an object's material says of the medium before it, and what is there.
pub struct Contradicted<'a> {
    /// Whose surface.
    pub object: &'a Placed<'a>,
    /// Of which it is made.
    pub material: &'a Named<Material>,
    /// The medium that its `outside` names.
    pub said: &'a Named<Medium>,
    /// Inside of the innermost body around it; None: a vacuum.
    pub around: Option<&'a Named<Medium>>,
}

/// All of a scene without faults, each surface with a medium once. Objects that yield are left
/// out: where they end another one's material is met.
pub fn contradicted<'a>(stage: &'a Stage, placed: &'a [Placed<'a>]) -> Vec<Contradicted<'a>> {
    let says = |part: &Named<_>| outside(part).is_some();
    if !placed.iter().flat_map(Placed::all_parts).any(says) {
        return Vec::new();
    }
    let all = ask(stage, placed, |bodies, media| {
        let (solids, surfaces, yields) = (bodies.solids, bodies.solids.surfaces, bodies.yields);
        let mut all = Vec::new();
        let mut add = |skin: u32, around: &dyn Fn() -> u32| {
            let Skin { object, slot, outside: Some(said), .. } = surfaces.skins[skin as usize]
            else {
                return;
            };
            let related = |other| yields.are_related(object, other);
            let around = around();
            if around == said || (0..placed.len() as u32).any(related) {
                return;
            }
            let object = &placed[object as usize];
            let mut parts = object.parts[slot as usize].iter().map(|(_, part)| *part);
            if let Some(said) = media[said as usize]
                && let Some(material) = parts.find(|part| outside(part).is_some())
            {
                all.push(Contradicted { object, material, said, around: media[around as usize] });
            }
        };
        let innermost = |item| solids.medium(&solids.before(item).0, solids.place(item));
        // No surface goes through another: before all faces of one there is the same.
        let mut known: Vec<(u32, u32)> = Vec::new();
        for (face, triangle) in surfaces.faces.iter().enumerate() {
            let of = (triangle.skin, solids.of_side(side(face, true)));
            if surfaces.skin(face).outside.is_some() && !known.contains(&of) {
                known.push(of);
                add(triangle.skin, &|| innermost(face));
            }
        }
        for (i, ball) in surfaces.balls.iter().enumerate() {
            add(ball.skin, &|| innermost(surfaces.faces.len() + i));
        }
        for (i, wall) in surfaces.walls.iter().enumerate() {
            add(wall.skin, &|| solids.before_wall(i));
        }
        all
    });
    all.unwrap_or_default()
}

/// What a material says of what is before it.
fn outside(material: &Named<Material>) -> Option<&Ref<Medium>> {
    material.value.value.sides()?.1
}
