//! How a texture lies on the coordinates of a surface.

use glam::{DAffine2, DMat2, DVec2};

/// The map from coordinates of a surface to those of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout(DAffine2);

impl Layout {
    /// Repeated so often in 1 of u and of v, turned by an angle of this cosine and sine from u to
    /// v, then moved.
    pub fn new(times: DVec2, (cos, sin): (f64, f64), offset: DVec2) -> Self {
        let back = DMat2::from_cols(DVec2::new(cos, -sin), DVec2::new(sin, cos));
        let map = DMat2::from_diagonal(times) * back;
        Self(DAffine2::from_mat2_translation(map, -(map * offset)))
    }

    /// The place on the texture.
    pub(super) fn place(&self, uv: DVec2) -> DVec2 {
        self.0.transform_point2(uv)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_is_made_smaller_then_turned_then_moved() {
        // A quarter turn from u to v, then along u.
        let layout = Layout::new(DVec2::new(4.0, 2.0), (0.0, 1.0), DVec2::new(3.0, 0.0));
        assert_eq!(layout.place(DVec2::new(3.0, 0.0)), DVec2::ZERO);
        // What was 1 along the pattern's own u is a quarter, and points along v.
        assert_eq!(layout.place(DVec2::new(3.0, 0.25)), DVec2::X);
        assert_eq!(layout.place(DVec2::new(2.5, 0.0)), DVec2::Y);
    }
}
