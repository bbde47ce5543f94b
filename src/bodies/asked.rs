//! The closed bodies of a scene without faults, for those who ask about them once more.

use super::matter::Matter;
use super::placed::Placed;
use super::solids::Solids;
use super::surfaces::{Media, Surfaces};
use super::yields::Yields;
use crate::load::Stage;
use crate::scene::{Medium, Named};

/// What is asked about.
pub(super) struct Bodies<'b, 's> {
    pub solids: &'b Solids<'s>,
    pub yields: &'b Yields,
}

/// The answer about a scene's bodies and its media by number; None if they are not closed.
pub(super) fn ask<'a, T>(
    stage: &'a Stage,
    placed: &'a [Placed<'a>],
    question: impl FnOnce(&Bodies, &[Option<&'a Named<Medium>>]) -> T,
) -> Option<T> {
    let mut media = Media::of(stage);
    let mut matter = Matter::of_media(&mut media, placed, 0);
    let mut surfaces = Surfaces::of(placed, &mut media);
    let (mut seams, closed) = matter.close(&mut surfaces, &mut Vec::new());
    if !closed || !surfaces.disks.is_empty() {
        return None;
    }
    let yields = Yields::of(placed);
    let solids = Solids::of(&surfaces, &mut seams, &yields);
    Some(question(&Bodies { solids: &solids, yields: &yields }, &media.all))
}
