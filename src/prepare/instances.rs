//! Meshes that the plan keeps once: where they stand.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::space::Space;
use crate::bodies::{Body, Placed};
use crate::load::Stage;
use crate::math::Mesh;
use crate::plan::Plan;
use crate::render::geometry::{Bounds, Instance, Placement, Shapes};

/// The meshes of a stage that stand somewhere without being copied.
pub(super) struct Meshes<'a> {
    stage: &'a Stage,
    plan: &'a Plan,
    space: &'a Space,
    /// Their numbers among the shapes.
    numbers: BTreeMap<*const Mesh, u32>,
}

impl<'a> Meshes<'a> {
    /// None yet.
    pub fn new(stage: &'a Stage, plan: &'a Plan, space: &'a Space) -> Self {
        Self { stage, plan, space, numbers: BTreeMap::new() }
    }

    /// Where an object stands; None if it is to be copied.
    pub fn placement(&self, placed: &Placed) -> Option<Placement> {
        let Body::Mesh { to_metres, .. } = &placed.body else { return None };
        if !self.plan.is_instance(placed.number as usize) {
            return None;
        }
        let (centre, scale) = (self.space.centre(), self.space.length(1.0));
        Some(Placement { place: *to_metres, centre, scale }).filter(Placement::is_sound)
    }

    /// Puts an object there; `of_slot` has the material of each of its slots.
    pub fn put(
        &mut self,
        placed: &Placed,
        placement: Placement,
        of_slot: impl Fn(usize) -> u32,
        shapes: &mut Shapes,
    ) {
        let object = placed.number;
        let Some(staged) = &self.stage.meshes[object as usize] else { return };
        let number = self.numbers.entry(Arc::as_ptr(&staged.mesh));
        let mesh = *number.or_insert_with(|| shapes.mesh(staged.mesh.clone()));
        // Rounding keeps order, so this is the box of the rounded corners.
        let box_of = placed.bounds();
        let [min, max] = [box_of.min, box_of.max].map(|p| self.space.point(p).as_vec3());
        let slots = 0..staged.materials.len();
        let materials = slots.map(of_slot).collect();
        let bounds = Bounds { min, max };
        shapes.instance(Instance { mesh, placement, bounds, object, materials });
    }
}
