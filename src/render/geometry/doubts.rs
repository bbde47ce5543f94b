//! What f32 leaves open about the triangles that a packet of rays was asked about, until f64 decides.

use super::few::MOST_TRIANGLES;

/// Rays that are not sure about a triangle.
#[derive(Clone, Copy)]
pub(super) struct Doubt {
    pub plate: u16,
    /// A bit for each of these rays.
    pub rays: u16,
    /// A bit for each that is known to pass inside of the edges.
    pub inside: u16,
}

/// Doubts of a packet, in the order in which they came.
pub(super) struct Doubts {
    all: [Doubt; MOST_TRIANGLES],
    pub count: usize,
}

impl Doubts {
    pub const NONE: Self =
        Self { all: [Doubt { plate: 0, rays: 0, inside: 0 }; MOST_TRIANGLES], count: 0 };

    #[inline(always)]
    pub fn note(&mut self, plate: usize, rays: u32, inside: u32) {
        let doubt = Doubt { plate: plate as u16, rays: rays as u16, inside: inside as u16 };
        self.all[self.count % MOST_TRIANGLES] = doubt;
        self.count += usize::from(rays != 0);
    }

    /// Those that may concern some of the rays.
    pub fn of(&self) -> &[Doubt] {
        &self.all[..self.count.min(MOST_TRIANGLES)]
    }
}
