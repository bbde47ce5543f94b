//! What is on the two sides of every surface.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::closing::{self, Reach, moved};
use super::crossing;
use super::errors::matter as errors;
use super::flush::{self, Flush, Pushed};
use super::overlaps::Overlaps;
use super::placed::{Body, Placed};
use super::seams::{Open, Seams};
use super::solids::Solids;
use super::surfaces::{Media, SURROUNDINGS, Skin, Surfaces};
use super::thin;
use super::view;
use super::yields::Yields;
use crate::diag::Diagnostic;
use crate::load::Stage;
use crate::scene::{At, Medium, Named};

/// Media, and where they are.
pub struct Matter<'a> {
    /// By number; None is a vacuum. The first is what surrounds everything.
    pub media: Vec<Option<&'a Named<Medium>>>,
    /// What is before the surfaces of each placed object.
    before: Vec<Before>,
    /// Around the points that were asked for.
    pub at: Vec<u32>,
    /// Points of meshes and faces that moved to close their surface: of the n-th placed object,
    /// the corner of this number.
    moved: HashMap<(u32, u32), DVec3>,
    /// Bodies that overlap.
    pub overlaps: Overlaps,
}

/// What is before the surfaces of an object.
#[derive(Clone, Debug, Default)]
struct Before {
    slots: Vec<u32>,
    /// Where it is not the same all over a slot: of each triangle.
    triangles: Vec<u32>,
}

impl<'a> Matter<'a> {
    /// What surfaces say, and where they say nothing what surrounds everything.
    pub fn said(stage: &'a Stage, placed: &[Placed<'a>], points: usize) -> Self {
        Self::of_media(&mut Media::of(stage), placed, points)
    }

    /// The same with the media known so far; all that surfaces name come to them.
    pub(super) fn of_media(media: &mut Media<'a>, placed: &[Placed<'a>], points: usize) -> Self {
        let before = placed.iter().map(|object| Before::said(object, media)).collect();
        for part in placed.iter().flat_map(Placed::all_parts) {
            part.value.value.sides().map(|(inside, _)| media.number(inside));
        }
        let at = vec![SURROUNDINGS; points];
        Self {
            media: media.all.clone(),
            before,
            at,
            moved: HashMap::new(),
            overlaps: Overlaps::default(),
        }
    }

    /// Joins surfaces to bodies, and tells what is around them and around `points`, in metres; the
    /// first of these is the camera's.
    pub fn of(
        stage: &'a Stage,
        placed: &[Placed<'a>],
        points: &[DVec3],
        found: &mut Vec<Diagnostic>,
    ) -> Self {
        let mut media = Media::of(stage);
        let mut matter = Self::of_media(&mut media, placed, points.len());
        let mut surfaces = Surfaces::of(placed, &mut media);
        if surfaces.is_empty() {
            return matter;
        }
        for skin in &surfaces.disks {
            let owner = surfaces.owner(&surfaces.skins[*skin as usize]);
            found.push(errors::disk(owner.name()));
        }
        let yields = Yields::of(placed);
        let together = view::together(&stage.scene.camera.value, placed);
        let (mut seams, closed) = matter.close(&mut surfaces, found);
        if !closed || !surfaces.disks.is_empty() {
            return matter;
        }
        if let Err(flush) = matter.part(&mut surfaces, &mut seams, &yields, together) {
            let names = flush.objects.map(|object| placed[object as usize].name());
            found.push(errors::flush(names, flush.at));
            return matter;
        }
        let solids = Solids::of(&surfaces, &mut seams, &yields);
        let thin = thin::find(&solids, view::extent(&stage.scene.camera.value, placed).centre());
        for thin in &thin {
            let owner = surfaces.owner(&surfaces.skins[thin.skin as usize]);
            found.push(errors::thin(owner.name(), thin));
        }
        if thin.iter().any(|thin| thin.steps < thin::LEAST) {
            return matter;
        }
        let may = |one: u32, other: u32| {
            let [one, other] = [one, other].map(|skin| surfaces.skins[skin as usize].object);
            one != other && yields.are_related(one, other)
        };
        if solids.could_meet(together)
            && let Some(meeting) = crossing::find(&solids, &may, together)
        {
            let skins = meeting.skins.map(|skin| &surfaces.skins[skin as usize]);
            let names = skins.map(|skin| surfaces.owner(skin).name());
            let inside = medium_name(&matter.media, skins[0].inside);
            let flat = skins.iter().any(|skin| surfaces.owner(skin).has_corners());
            found.push(match meeting.coincide {
                true => errors::coincide(names, (inside, flat), meeting.at, together),
                false => errors::cross(names, meeting.at),
            });
            return matter;
        }
        if let Some(solid) = solids.inside_out() {
            let owner = surfaces.owner(&surfaces.skins[solid.skin as usize]);
            let name = medium_name(&matter.media, solid.medium);
            found.push(errors::inside_out(name, owner.name()));
            return matter;
        }
        if !yields.is_empty() {
            match Overlaps::of(&solids) {
                Some(overlaps) => matter.overlaps = overlaps,
                None => found.push(errors::too_many(yields.first(placed), Overlaps::MOST)),
            }
            if let Some(eye) = points.first() {
                matter.overlaps.camera = matter.overlaps.bits(&solids, solids.all_around(*eye));
            }
        }
        matter.surround(&surfaces, &solids, &mut seams);
        matter.surround_others(placed, &solids);
        matter.at = points.iter().map(|p| solids.medium(&solids.around(*p), *p)).collect();
        matter
    }

    /// What is before a triangle of a placed object's slot; of round ones the triangle is none.
    pub fn before(&self, object: usize, slot: usize, triangle: usize) -> u32 {
        let before = &self.before[object];
        before.triangles.get(triangle).or(before.slots.get(slot)).copied().unwrap_or(SURROUNDINGS)
    }

    /// Whether a placed object has the same before all of a slot, and its corners where they were.
    pub fn is_even(&self, object: usize) -> bool {
        let stays = || self.moved.keys().all(|(of, _)| *of as usize != object);
        self.before[object].triangles.is_empty() && stays()
    }

    /// All that is before the surfaces of a placed object's slot.
    pub fn all_before(&self, object: usize, slot: usize) -> Vec<u32> {
        let before = &self.before[object];
        let mut all = match before.triangles.as_slice() {
            [] => vec![before.slots[slot]],
            triangles => triangles.to_vec(),
        };
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The number of a medium that some surface names.
    pub fn number(&self, name: &str) -> Option<u32> {
        let same = |it: &Option<&Named<Medium>>| it.is_some_and(|it| *it.name == name);
        self.media.iter().position(same).map(|number| number as u32)
    }

    /// Where a corner is that was moved, in metres.
    pub fn moved(&self, object: usize, corner: u32) -> Option<DVec3> {
        match self.moved.is_empty() {
            true => None,
            false => self.moved.get(&(object as u32, corner)).copied(),
        }
    }

    /// Joins what lies near enough to be joined, and tells of what stays open.
    pub(super) fn close(
        &mut self,
        surfaces: &mut Surfaces,
        found: &mut Vec<Diagnostic>,
    ) -> (Seams, bool) {
        let mut seams = Seams::of(surfaces);
        if !seams.open.is_empty() {
            let moves = Reach::of(surfaces, &seams.open).moves(&seams.open);
            if let Some((object, wide)) = closing::too_wide(surfaces, &moves) {
                let Placed { object, .. } = &surfaces.placed[object as usize];
                found.push(errors::wide_mend(&object.name, object.value.value.mend(), wide));
                return (seams, false);
            }
            if !moves.is_empty() {
                for face in &mut surfaces.faces {
                    face.corners = face.corners.map(|corner| moved(&moves, corner));
                }
                for (object, numbers) in &surfaces.numbers {
                    for (corner, number) in numbers.iter().enumerate() {
                        if let Some(to) = moves.get(number) {
                            let to = surfaces.points[*to as usize];
                            self.moved.insert((*object, corner as u32), to);
                        }
                    }
                }
                seams = Seams::of(surfaces);
            }
        }
        let mut media: Vec<u32> =
            seams.open.iter().chain(&seams.turned).map(|edge| edge.medium).collect();
        media.sort_unstable();
        media.dedup();
        for medium in &media {
            let of = |edges: &[Open]| -> Vec<Open> {
                edges.iter().filter(|edge| edge.medium == *medium).copied().collect()
            };
            let name = medium_name(&self.media, *medium);
            let (open, turned) = (of(&seams.open), of(&seams.turned));
            found.push(match open.as_slice() {
                [] => {
                    let (objects, at) = whose(surfaces, &turned);
                    let skins = Open::skins(&turned, surfaces);
                    let both = skins.iter().find(|skin| skin.outside.is_some());
                    let swap = both.map(|skin| surfaces.material(skin).name.as_str());
                    errors::turned(name, &objects, turned.len(), at, swap)
                }
                open => {
                    let (objects, at) = whose(surfaces, open);
                    let within = open.iter().all(|edge| edge.faces > 2);
                    match Reach::of(surfaces, open).gap(open) {
                        _ if within => {
                            errors::wall_within(name, &objects, (open[0].faces, open.len()), at)
                        }
                        Some(width) => errors::gap(name, &objects, width, at),
                        None => {
                            let skins = Open::skins(open, surfaces);
                            let wall = skins
                                .iter()
                                .find(|skin| skin.inside != *medium && skin.outside.is_none());
                            let wall = wall.map(|skin| {
                                let inside = medium_name(&self.media, skin.inside);
                                (surfaces.material(skin).name.as_str(), inside)
                            });
                            let of = surfaces.owner(surfaces.skin(open[0].face as usize));
                            let scanned =
                                objects.len() == 1 && matches!(of.body, Body::Mesh { .. });
                            errors::open(name, &objects, open.len(), (at, scanned), wall)
                        }
                    }
                }
            });
        }
        (seams, media.is_empty())
    }

    /// Parts surfaces that lie on each other, where one of the two bodies ends at the other; or tells
    /// of one where that cannot be.
    fn part(
        &mut self,
        surfaces: &mut Surfaces,
        seams: &mut Seams,
        yields: &Yields,
        together: f64,
    ) -> Result<(), Flush> {
        if yields.is_empty() {
            return Ok(());
        }
        let solids = Solids::of(surfaces, seams, yields);
        let all = flush::find(&solids, yields, together);
        let Some(first) = all.first() else { return Ok(()) };
        let pushed = Pushed::of(&solids, &all, together)?;
        pushed.push(surfaces, |corner, to| {
            self.moved.insert(corner, to);
        });
        *seams = Seams::of(surfaces);
        if !seams.open.is_empty() {
            return Err(*first);
        }
        let solids = Solids::of(surfaces, seams, yields);
        flush::find(&solids, yields, together).first().map_or(Ok(()), |flush| Err(*flush))
    }

    /// Finds what is before surfaces that do not say it.
    fn surround(&mut self, surfaces: &Surfaces, solids: &Solids, seams: &mut Seams) {
        let patches: Vec<usize> =
            (0..surfaces.faces.len()).map(|face| seams.patches.least(face)).collect();
        let unsaid = |face: &usize| surfaces.skin(*face).outside.is_none();
        let firsts: Vec<usize> =
            (0..patches.len()).filter(|face| patches[*face] == *face).filter(unsaid).collect();
        let medium = |item: usize| solids.medium(&solids.before(item).0, solids.place(item));
        let media: HashMap<usize, u32> =
            firsts.par_iter().map(|face| (*face, medium(*face))).collect();
        let mut pieces: HashMap<(u32, u32), u32> = HashMap::new();
        let mut differ: Vec<u32> = Vec::new();
        for face in (0..patches.len()).filter(unsaid) {
            let Skin { object, slot, .. } = *surfaces.skin(face);
            let medium = media[&patches[face]];
            if *pieces.entry((object, slot)).or_insert(medium) != medium {
                differ.push(object);
            }
        }
        for ((object, slot), medium) in pieces {
            self.before[object as usize].slots[slot as usize] = medium;
        }
        differ.sort_unstable();
        differ.dedup();
        for object in differ {
            self.before[object as usize].spread(&surfaces.placed[object as usize]);
        }
        for face in (0..patches.len()).filter(unsaid) {
            let before = &mut self.before[surfaces.skin(face).object as usize];
            if let Some(of) = before.triangles.get_mut(surfaces.faces[face].triangle as usize) {
                *of = media[&patches[face]];
            }
        }
        for (i, ball) in surfaces.balls.iter().enumerate() {
            let skin = &surfaces.skins[ball.skin as usize];
            if skin.outside.is_none() {
                let medium = medium(surfaces.faces.len() + i);
                self.before[skin.object as usize].slots[skin.slot as usize] = medium;
            }
        }
        for (i, wall) in surfaces.walls.iter().enumerate() {
            let skin = &surfaces.skins[wall.skin as usize];
            if skin.outside.is_none() {
                let medium = solids.before_wall(i);
                self.before[skin.object as usize].slots[skin.slot as usize] = medium;
            }
        }
    }

    /// Finds what is before surfaces that bound nothing. What several media surround is told
    /// triangle by triangle; a round shape has the medium at its middle.
    fn surround_others(&mut self, placed: &[Placed], solids: &Solids) {
        for (object, before) in placed.iter().zip(&mut self.before) {
            let opaque: Vec<usize> = (0..object.parts.len())
                .filter(|slot| !object.parts[*slot].iter().any(|(_, part)| part.value.transmits()))
                .collect();
            if opaque.is_empty() {
                continue;
            }
            let at = |p: DVec3| solids.medium(&solids.around(p), p);
            let bounds = object.bounds();
            if !bounds.is_empty() && !solids.cut(&bounds) {
                let medium = at(bounds.centre());
                opaque.iter().for_each(|slot| before.slots[*slot] = medium);
                continue;
            }
            match &object.body {
                Body::Mesh { mesh, to_metres } => {
                    before.spread(object);
                    let slots = &mesh.slots;
                    before.triangles.par_iter_mut().enumerate().for_each(|(i, medium)| {
                        let slot = slots.get(i).copied().unwrap_or(0) as usize;
                        if opaque.contains(&slot) {
                            let corners = mesh.triangles[i]
                                .map(|i| to_metres.point(mesh.positions[i as usize]));
                            *medium = at(corners.into_iter().sum::<DVec3>() / 3.0);
                        }
                    });
                }
                Body::Plane { point, .. } => before.slots[0] = at(*point),
                Body::Face { .. } | Body::Sphere { .. } | Body::Disk { .. } => {
                    before.slots[0] = at(bounds.centre());
                }
            }
        }
    }
}

impl Before {
    /// What materials say, and what surrounds everything where they say nothing.
    fn said(object: &Placed, media: &mut Media) -> Self {
        let slots = object.parts.iter().map(|parts| {
            let outside = parts.iter().find_map(|(_, part)| part.value.value.sides()?.1);
            outside.map_or(SURROUNDINGS, |name| media.number(name))
        });
        Self { slots: slots.collect(), triangles: Vec::new() }
    }

    /// Tells it triangle by triangle.
    fn spread(&mut self, object: &Placed) {
        if self.triangles.is_empty() {
            self.triangles = match &object.body {
                Body::Mesh { mesh, .. } => {
                    let slot = |i: usize| mesh.slots.get(i).copied().unwrap_or(0) as usize;
                    (0..mesh.triangles.len()).map(|i| self.slots[slot(i)]).collect()
                }
                other => vec![self.slots[0]; other.triangles()],
            };
        }
    }
}

fn medium_name<'m>(media: &[Option<&'m Named<Medium>>], number: u32) -> &'m str {
    media[number as usize].map_or("vacuum", |medium| medium.name.as_str())
}

/// The objects that edges belong to, each once, and the middle of the first edge.
fn whose<'a>(surfaces: &Surfaces<'a>, edges: &[Open]) -> (Vec<&'a At<String>>, DVec3) {
    let mut names: Vec<&At<String>> = Vec::new();
    for edge in edges {
        let name = surfaces.owner(surfaces.skin(edge.face as usize)).name();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    (names, edges[0].place(&surfaces.points))
}
