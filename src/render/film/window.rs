//! The part of the film that is rendered, and its tiles.

use serde::{Deserialize, Serialize};

/// Pixels of the film, ends not included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Window {
    /// Leftmost column.
    pub x0: u64,
    /// Topmost row.
    pub y0: u64,
    /// One past the rightmost column.
    pub x1: u64,
    /// One past the lowest row.
    pub y1: u64,
}

/// A part of the window that one thread works on.
pub type Tile = Window;

/// Pixels along each side of a tile: enough work to pay for handing it out, few enough that the
/// last ones end together. Tiles begin at multiples of it on the whole film.
pub(super) const TILE: u64 = 16;

/// Columns or rows of no film are more than so many.
const MOST_SIDE: u64 = 1 << 32;

impl Window {
    /// Columns.
    pub fn width(&self) -> u64 {
        self.x1 - self.x0
    }

    /// Rows.
    pub fn height(&self) -> u64 {
        self.y1 - self.y0
    }

    /// Columns times rows.
    pub fn pixels(&self) -> u64 {
        self.width() * self.height()
    }

    /// Every pixel, row by row from the top left.
    pub fn places(&self) -> impl Iterator<Item = (u64, u64)> + use<> {
        let Self { x0, y0, x1, y1 } = *self;
        (y0..y1).flat_map(move |y| (x0..x1).map(move |x| (x, y)))
    }

    /// Tiles in each row of them.
    pub fn tile_columns(&self) -> usize {
        tiles(self.x0, self.x1) as usize
    }

    /// Whether it has pixels, within what a film may have, and so many tiles: to be asked of what
    /// was read from a file.
    pub fn has_tiles(&self, count: usize) -> bool {
        let sides = [(self.x0, self.x1), (self.y0, self.y1)];
        sides.iter().all(|(from, to)| from < to && *to <= MOST_SIDE)
            && sides.map(|(from, to)| tiles(from, to)).iter().product::<u64>() == count as u64
    }

    /// Tiles that cover it, row by row.
    pub(super) fn tiles(&self) -> Vec<Tile> {
        let steps = |from: u64, to: u64| {
            let cuts = (from / TILE * TILE..to).step_by(TILE as usize);
            cuts.map(move |cut| (cut.max(from), (cut + TILE).min(to)))
        };
        steps(self.y0, self.y1)
            .flat_map(|(y0, y1)| {
                steps(self.x0, self.x1).map(move |(x0, x1)| Tile { x0, y0, x1, y1 })
            })
            .collect()
    }

    /// The number of a pixel among [`Self::places`]; None: it is outside.
    pub fn index(&self, [x, y]: [u64; 2]) -> Option<usize> {
        let is_in = (self.x0..self.x1).contains(&x) && (self.y0..self.y1).contains(&y);
        is_in.then(|| ((y - self.y0) * self.width() + (x - self.x0)) as usize)
    }
}

/// Tiles along a side of pixels, the last not included.
fn tiles(from: u64, to: u64) -> u64 {
    to.div_ceil(TILE) - from / TILE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_the_window_once() {
        let window = Window { x0: 3, y0: 7, x1: 50, y1: 40 };
        let mut seen: Vec<_> = window.tiles().iter().flat_map(Window::places).collect();
        seen.sort_by_key(|(x, y)| (*y, *x));
        assert_eq!(seen, window.places().collect::<Vec<_>>());
        assert_eq!(seen.len() as u64, window.pixels());
        assert!(window.has_tiles(window.tiles().len()));
        assert_eq!(window.tile_columns(), 4);
        assert!(window.tiles().iter().all(|tile| tile.x0 / TILE == (tile.x1 - 1) / TILE));
        for (nth, (x, y)) in window.places().enumerate() {
            assert_eq!(window.index([x, y]), Some(nth));
        }
        assert_eq!((window.index([2, 7]), window.index([3, 40])), (None, None));
    }
}
