//! Film: which pixels there are, and what samples become.

mod begun;
mod develop;
mod filter;
mod groups;
mod sums;
mod table;
mod taken;
mod window;

pub use begun::Begun;
pub use develop::{Developed, develop, layers, samples};
pub use filter::Filter;
pub use groups::Groups;
pub use taken::{Taken, TileMeans};
pub use window::{Tile, Window};

/// The picture that is to be taken.
#[derive(Clone, Debug)]
pub struct Film {
    /// Columns and rows of the whole film; their product fits u64.
    pub size: [u64; 2],
    /// The part of it that is wanted.
    pub window: Window,
    /// How samples around a pixel's centre are weighed.
    pub filter: Filter,
    /// Pictures beside it, each of the light of some paths.
    pub layers: usize,
}

impl Film {
    /// The number of a pixel in the whole film.
    pub fn index(&self, x: u64, y: u64) -> u64 {
        y * self.size[0] + x
    }

    /// The window, cut into tiles.
    pub fn tiles(&self) -> Vec<Tile> {
        self.window.tiles()
    }
}
