//! Planes without end that media end at: they lie above each other, and part all of space.

use glam::DVec3;

use super::surfaces::Surfaces;

/// Planes that are parallel, and the gaps between them: gap n is above n of them.
pub(super) struct Layers {
    up: DVec3,
    /// From the lowest plane up: its height, its number, and whether its front looks up.
    planes: Vec<(f64, usize, bool)>,
    /// Media, and the first and the last of the gaps side by side that each fills.
    spans: Vec<(u32, [usize; 2])>,
}

impl Layers {
    /// Of planes that are parallel.
    pub fn of(surfaces: &Surfaces) -> Self {
        let walls = &surfaces.walls;
        let up = walls.first().map_or(DVec3::Y, |wall| wall.normal);
        let mut planes: Vec<_> = walls
            .iter()
            .enumerate()
            .map(|(i, wall)| (up.dot(wall.point), i, wall.normal.dot(up) > 0.0))
            .collect();
        planes.sort_by(|a, b| a.0.total_cmp(&b.0));
        // By how much each medium is there more often above a plane than below it.
        let step = |(_, wall, faces_up): &(f64, usize, bool), medium: u32| {
            let skin = surfaces.skins[walls[*wall].skin as usize];
            let (above, below) = match faces_up {
                true => (skin.outside, Some(skin.inside)),
                false => (Some(skin.inside), skin.outside),
            };
            i32::from(above == Some(medium)) - i32::from(below == Some(medium))
        };
        let skins = walls.iter().map(|wall| surfaces.skins[wall.skin as usize]);
        let mut media: Vec<u32> =
            skins.flat_map(|skin| [Some(skin.inside), skin.outside]).flatten().collect();
        media.sort_unstable();
        media.dedup();
        let mut spans: Vec<(u32, [usize; 2])> = Vec::new();
        for medium in media {
            let mut there = vec![0];
            for plane in &planes {
                there.push(there[there.len() - 1] + step(plane, medium));
            }
            // Where it is least it is not at all.
            let none = there.iter().copied().min().unwrap_or(0);
            for gap in (0..there.len()).filter(|gap| there[*gap] > none) {
                match spans.last_mut() {
                    Some((known, [_, last])) if *known == medium && *last + 1 == gap => *last = gap,
                    _ => spans.push((medium, [gap, gap])),
                }
            }
        }
        Self { up, planes, spans }
    }

    /// The medium of the innermost layer at a point.
    pub fn at(&self, place: DVec3) -> Option<u32> {
        let height = self.up.dot(place);
        self.in_gap(self.planes.partition_point(|plane| plane.0 < height))
    }

    /// The medium of the innermost layer before a plane.
    pub fn before(&self, wall: usize) -> Option<u32> {
        let rank = self.planes.iter().position(|plane| plane.1 == wall)?;
        self.in_gap(if self.planes[rank].2 { rank + 1 } else { rank })
    }

    fn in_gap(&self, gap: usize) -> Option<u32> {
        let around = self.spans.iter().filter(|(_, [first, last])| (*first..=*last).contains(&gap));
        around.min_by_key(|(_, [first, last])| last - first).map(|(medium, _)| *medium)
    }
}
