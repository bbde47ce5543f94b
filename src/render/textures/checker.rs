//! Squares of two colours in turn.

use glam::DVec2;

use super::Layout;
use crate::math::Rgb;

/// Squares of side 1 on the texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker {
    /// How they lie.
    pub layout: Layout,
    /// The square between 0 and 1.
    pub a: Rgb,
    /// Its neighbours.
    pub b: Rgb,
}

impl Checker {
    pub(super) fn at(&self, uv: DVec2) -> Rgb {
        // Halves of whole numbers are exact, however large these are.
        let odd = |x: f64| (0.5 * x.floor()).fract() != 0.0;
        let place = self.layout.place(uv);
        if odd(place.x) == odd(place.y) { self.a } else { self.b }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_alternate_and_their_edges_are_exact_far_away() {
        let layout = Layout::new(DVec2::ONE, (1.0, 0.0), DVec2::ZERO);
        let checker = Checker { layout, a: Rgb::ONE, b: Rgb::BLACK };
        let at = |u: f64, v: f64| checker.at(DVec2::new(u, v)) == Rgb::ONE;
        assert!(at(0.5, 0.5) && !at(1.5, 0.5) && !at(0.5, -0.5) && at(-0.5, -0.5));
        for edge in [0.0, 1.0, -7.0, 1e6, -1e9, 4e15] {
            let even = (edge / 2.0_f64).fract() == 0.0;
            assert_eq!((at(edge, 0.5), at(edge.next_down(), 0.5)), (even, !even), "{edge}");
        }
    }

    #[test]
    fn what_is_no_number_has_a_colour_too() {
        let layout = Layout::new(DVec2::splat(1e9), (0.6, 0.8), DVec2::ONE);
        let checker = Checker { layout, a: Rgb::ONE, b: Rgb::grey(0.5) };
        for u in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -1e300] {
            assert!(checker.at(DVec2::new(u, 0.3)).is_finite());
        }
    }
}
