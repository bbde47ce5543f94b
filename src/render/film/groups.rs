//! Which pixels share light: groups of them, in cells of a grid that is fixed on the film.
//!
//! Each sample has other groups, drawn at random in each cell, so that no two pixels have their noise
//! in common for long. They depend on the film, the seed and the sample alone: a part of a film that
//! is rendered by itself has those that the whole would have.

use super::window::TILE;
use super::{Film, Tile};
use crate::math::random;

/// Pixels along each side of a cell. What noise a cell has in common is seen as a square at its edges;
/// that of more pixels is less, and pixels far from each other share less light.
const CELL: u64 = 32;

impl Tile {
    /// The cell that a tile is in, by its column and row.
    pub fn cell(&self) -> [u64; 2] {
        [self.x0 / CELL, self.y0 / CELL]
    }
}

/// The groups of the cell that a tile is in.
pub struct Groups {
    /// Pixels of the cell.
    places: Vec<[u64; 2]>,
    /// The same in the order of a sample.
    turn: Vec<[u64; 2]>,
    /// Pixels of a group; the last one may have fewer.
    size: usize,
    /// Chooses the order.
    key: u64,
}

impl Groups {
    /// Groups of so many pixels, 1 or more, by a seed.
    pub fn new(film: &Film, tile: &Tile, size: usize, seed: u64) -> Self {
        let first = tile.cell().map(|nth| nth * CELL);
        let [width, height] = film.size;
        let columns = first[0]..width.min(first[0] + CELL);
        let rows = first[1]..height.min(first[1] + CELL);
        let places: Vec<[u64; 2]> =
            rows.flat_map(|y| columns.clone().map(move |x| [x, y])).collect();
        let key = random::at(random::mix(seed), film.index(first[0], first[1]));
        Self { turn: places.clone(), places, size, key }
    }

    /// The groups of a sample, by its number.
    pub fn of(&mut self, sample: u64) -> impl Iterator<Item = &[[u64; 2]]> {
        let key = random::at(self.key, sample);
        self.turn.copy_from_slice(&self.places);
        for nth in (1..self.turn.len()).rev() {
            let bits = random::mix(key.wrapping_add(nth as u64)) >> 32;
            self.turn.swap(nth, ((bits * (nth as u64 + 1)) >> 32) as usize);
        }
        self.turn.chunks(self.size)
    }
}

// No tile is in two cells.
const _: () = assert!(CELL.is_multiple_of(TILE));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::film::{Filter, Window};

    fn film(window: Window) -> Film {
        Film { size: [40, 24], window, filter: Filter::Box { radius: 0.5 }, layers: 0 }
    }

    fn groups(film: &Film, sample: u64) -> Vec<Vec<[u64; 2]>> {
        let of = |tile: &Tile| {
            let mut groups = Groups::new(film, tile, 7, 3);
            groups.of(sample).map(<[_]>::to_vec).collect::<Vec<_>>()
        };
        let mut cells: Vec<Tile> = film.tiles();
        cells.sort_by_key(Tile::cell);
        cells.dedup_by_key(|tile| tile.cell());
        cells.iter().flat_map(of).collect()
    }

    #[test]
    fn every_pixel_is_in_one_group_of_each_sample_and_in_others_of_the_next() {
        let whole = film(Window { x0: 0, y0: 0, x1: 40, y1: 24 });
        for sample in 0..3 {
            let mut all = groups(&whole, sample).concat();
            all.sort_unstable();
            let each: Vec<_> = (0..40).flat_map(|x| (0..24).map(move |y| [x, y])).collect();
            assert_eq!(all, each);
            assert!(groups(&whole, sample).iter().all(|group| (1..=7).contains(&group.len())));
        }
        assert_ne!(groups(&whole, 0), groups(&whole, 1));
    }

    #[test]
    fn a_part_of_a_film_has_the_groups_of_the_whole() {
        let whole = groups(&film(Window { x0: 0, y0: 0, x1: 40, y1: 24 }), 5);
        let part = groups(&film(Window { x0: 17, y0: 5, x1: 35, y1: 9 }), 5);
        assert!(part.iter().all(|group| whole.contains(group)));
    }
}
