//! Meshes that stand at several places, and whether to keep each of them once.
//!
//! A ray takes longer to meet an instance than a copy, so what a mesh takes must be worth it. Meshes
//! with a part that shines are copied: lamps are lists of triangles of the world.

use std::collections::{BTreeMap, BTreeSet};
use std::ptr;
use std::sync::Arc;

use super::features::Need;
use super::survey::Survey;
use crate::diag::Span;
use crate::load::Stage;
use crate::math::Mesh;
use crate::scene::{Named, Object};

/// Triangles that must be saved for a mesh to be kept once: some 25 MB.
const WORTH: u64 = 250_000;

/// Objects that are of one mesh, none of which shines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Copies {
    /// Their numbers in the scene, ascending.
    pub objects: Vec<usize>,
    /// Triangles of the mesh.
    pub triangles: u64,
}

impl Copies {
    /// Triangles that are not copied if the mesh is kept once.
    pub fn saved(&self) -> u64 {
        self.triangles * (self.objects.len() as u64 - 1)
    }

    /// Whether that is more than the time that it costs.
    pub fn is_worth_it(&self) -> bool {
        self.saved() >= WORTH
    }
}

/// All meshes that no lamp is of, in the order of their first objects.
pub(super) fn copies(survey: &Survey) -> Vec<Copies> {
    let mut all: Vec<Copies> = Vec::new();
    let mut known: BTreeMap<*const Mesh, usize> = BTreeMap::new();
    let lamps = survey.surfaces.iter().filter(|it| it.shines);
    let lamps: BTreeSet<*const Named<Object>> = lamps.map(|it| ptr::from_ref(it.object)).collect();
    let stage = survey.stage;
    for (number, (object, mesh)) in stage.scene.objects.iter().zip(&stage.meshes).enumerate() {
        let Some(staged) = mesh else { continue };
        if lamps.contains(&ptr::from_ref(object)) {
            continue;
        }
        let at = *known.entry(Arc::as_ptr(&staged.mesh)).or_insert(all.len());
        if at == all.len() {
            let triangles = staged.mesh.triangles.len() as u64;
            all.push(Copies { objects: Vec::new(), triangles });
        }
        all[at].objects.push(number);
    }
    all
}

/// Whether any mesh is kept once, and why.
pub(super) fn answer(stage: &Stage, copies: &[Copies]) -> (Need, String, Option<Span>) {
    // The first of equals.
    let most = copies.iter().rev().max_by_key(|copies| copies.saved());
    let Some(most) = most.filter(|most| most.objects.len() > 1) else {
        return (Need::Unneeded, "no mesh stands at two places".to_string(), None);
    };
    let object = &stage.scene.objects[most.objects[0]];
    let file = match &object.value.value {
        Object::Mesh(mesh) => mesh.file.text.as_str(),
        _ => object.name.as_str(),
    };
    let (count, at) = (most.objects.len(), Some(object.name.span));
    if !most.is_worth_it() {
        let why = format!("`{file}` stands at {count} places, but is small enough to be copied");
        return (Need::Unneeded, why, at);
    }
    let rest = copies.iter().filter(|copies| copies.is_worth_it()).count() - 1;
    let more = match rest {
        0 => String::new(),
        1 => ", and another mesh at several".to_string(),
        _ => format!(", and {rest} other meshes at several"),
    };
    (Need::Required, format!("`{file}` stands at {count} places{more}"), at)
}
