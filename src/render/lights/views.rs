//! A rectangle lamp as many points see it, one lane for each, and the place where each looks.

use super::rectangle::{Place, Rectangle, SolidRectangle, View};
use crate::render::lanes::{LANES, Row};

/// Views side by side.
pub(super) struct Views {
    corner: [Row<f64>; 2],
    height: Row<f64>,
    solid_angle: Row<f64>,
    is_wide: Row<u32>,
    is_over: Row<u32>,
    at: [Row<f64>; 2],
    parts: [Row<f64>; 2],
}

impl Default for Views {
    fn default() -> Self {
        let row = [0.0; LANES];
        Self {
            corner: [row; 2],
            height: row,
            solid_angle: row,
            is_wide: [0; LANES],
            is_over: [0; LANES],
            at: [row; 2],
            parts: [row; 2],
        }
    }
}

impl Views {
    /// Gives a lane its view.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, view: &View) {
        let View { solid, is_wide, is_over } = view;
        (self.corner[0][lane], self.corner[1][lane]) = (solid.x[0], solid.y[0]);
        self.height[lane] = solid.height;
        self.solid_angle[lane] = solid.solid_angle;
        self.is_wide[lane] = u32::from(*is_wide);
        self.is_over[lane] = u32::from(*is_over);
    }

    /// The view that a lane has of a rectangle.
    #[inline(always)]
    pub fn at(&self, lane: usize, rectangle: &Rectangle) -> View {
        let ([x, y], [long, wide]) = (&self.corner, rectangle.size);
        let solid = SolidRectangle {
            x: [x[lane], x[lane] + long],
            y: [y[lane], y[lane] + wide],
            height: self.height[lane],
            solid_angle: self.solid_angle[lane],
        };
        View { solid, is_wide: self.is_wide[lane] != 0, is_over: self.is_over[lane] != 0 }
    }

    /// Gives a lane the place where it looks.
    #[inline(always)]
    pub fn look(&mut self, lane: usize, place: &Place) {
        let Place { at: [x, y], parts: [s, t] } = *place;
        (self.at[0][lane], self.at[1][lane]) = (x, y);
        (self.parts[0][lane], self.parts[1][lane]) = (s, t);
    }

    /// The place where a lane looks.
    #[inline(always)]
    pub fn place(&self, lane: usize) -> Place {
        let ([x, y], [s, t]) = (&self.at, &self.parts);
        Place { at: [x[lane], y[lane]], parts: [s[lane], t[lane]] }
    }
}
