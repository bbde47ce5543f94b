//! Pictures: texels beside each other, read by the nearest or between four.

use std::sync::Arc;

use glam::DVec2;

use super::Layout;
use crate::math::{Rgb, Texels, Values};

/// A picture that fills the square from 0 to 1 of the texture, its first row on top.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// How it lies.
    pub layout: Layout,
    /// Its texels.
    pub texels: Arc<Texels>,
    /// Linear values of whole numbers: as many as the texels' bits can hold; none for floats.
    pub decoded: Arc<[f32]>,
    /// What every colour is multiplied by.
    pub tint: Rgb,
    /// What lies beyond its edges.
    pub wrap: Wrap,
    /// How it is read between texels.
    pub filter: Filter,
}

/// What lies beyond the edges of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The picture again.
    Repeat,
    /// The texels of its edge.
    Clamp,
    /// The picture mirrored, and again.
    Mirror,
}

/// How a picture is read between the centres of its texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The texel that the place lies in.
    Nearest,
    /// Between the four around the place, in linear light.
    Linear,
}

impl Wrap {
    /// A coordinate within a period, so that nothing overflows: 0 for what is no number.
    fn reduced(self, x: f64) -> f64 {
        if !x.is_finite() {
            return 0.0;
        }
        match self {
            Self::Repeat => x - x.floor(),
            Self::Clamp => x.clamp(0.0, 1.0),
            Self::Mirror => x - 2.0 * (0.5 * x).floor(),
        }
    }

    /// The texel of a number, of `count` in a row.
    fn texel(self, number: i64, count: i64) -> usize {
        let number = match self {
            Self::Repeat => number.rem_euclid(count),
            Self::Clamp => number.clamp(0, count - 1),
            Self::Mirror => {
                let number = number.rem_euclid(2 * count);
                number.min(2 * count - 1 - number)
            }
        };
        number as usize
    }
}

impl Image {
    pub(super) fn at(&self, uv: DVec2) -> Rgb {
        let place = self.layout.place(uv);
        let (columns, rows) = (i64::from(self.texels.width), i64::from(self.texels.height));
        // In texels from the lower left corner.
        let x = self.wrap.reduced(place.x) * columns as f64;
        let y = self.wrap.reduced(place.y) * rows as f64;
        let texel =
            |i: i64, j: i64| self.texel(self.wrap.texel(i, columns), self.wrap.texel(j, rows));
        let colour = match self.filter {
            Filter::Nearest => texel(x.floor() as i64, y.floor() as i64),
            Filter::Linear => {
                // Texels have their colours at their centres.
                let (x, y) = (x - 0.5, y - 0.5);
                let (i, j) = (x.floor(), y.floor());
                let (right, up) = ((x - i) as f32, (y - j) as f32);
                let (i, j) = (i as i64, j as i64);
                let below = between(texel(i, j), texel(i + 1, j), right);
                let above = between(texel(i, j + 1), texel(i + 1, j + 1), right);
                between(below, above, up)
            }
        };
        colour * self.tint
    }

    /// The colour in a column of a row counted from below.
    fn texel(&self, column: usize, row: usize) -> Rgb {
        let (width, height) = (self.texels.width as usize, self.texels.height as usize);
        let at = (height - 1 - row) * width + column;
        let decoded = |value: usize| self.decoded[value];
        match &self.texels.values {
            Values::Grey8(all) => Rgb::grey(decoded(all[at].into())),
            Values::Grey16(all) => Rgb::grey(decoded(all[at].into())),
            Values::Rgb8(all) => rgb(all[at].map(|value| decoded(value.into()))),
            Values::Rgb16(all) => rgb(all[at].map(|value| decoded(value.into()))),
            Values::Float(all) => rgb(all[at]),
        }
    }
}

fn rgb([r, g, b]: [f32; 3]) -> Rgb {
    Rgb::new(r, g, b)
}

/// Exactly `a` where both are the same.
fn between(a: Rgb, b: Rgb, part: f32) -> Rgb {
    a + (b - a) * part
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows of three texels; the value is 10 × row from below + column.
    fn image(wrap: Wrap, filter: Filter) -> Image {
        let values = [10.0, 11.0, 12.0, 0.0, 1.0, 2.0].map(|x| [x; 3]).to_vec();
        let texels = Texels { width: 3, height: 2, values: Values::Float(values) };
        Image {
            layout: Layout::new(DVec2::ONE, (1.0, 0.0), DVec2::ZERO),
            texels: Arc::new(texels),
            decoded: Arc::new([]),
            tint: Rgb::ONE,
            wrap,
            filter,
        }
    }

    #[test]
    fn texels_fill_their_squares_and_edges_belong_to_what_is_right_and_above() {
        let image = image(Wrap::Repeat, Filter::Nearest);
        for row in 0..2 {
            for column in 0..3 {
                let at = |x: f64, y: f64| {
                    let uv = DVec2::new((f64::from(column) + x) / 3.0, (f64::from(row) + y) / 2.0);
                    image.at(uv).g
                };
                let expected = (10 * row + column) as f32;
                assert_eq!([at(0.01, 0.0), at(0.5, 0.5), at(0.99, 0.99)], [expected; 3]);
            }
        }
        assert_eq!(image.at(DVec2::ZERO).g, 0.0);
        assert_eq!(image.at(DVec2::ONE).g, 0.0);
        assert_eq!(image.at(DVec2::new(-1e-30, -1e-30)).g, 0.0);
        assert_eq!(image.at(DVec2::new(1e15, 7.75)).g, 10.0);
    }

    #[test]
    fn between_texels_colours_go_in_straight_lines_from_centre_to_centre() {
        let image = image(Wrap::Clamp, Filter::Linear);
        let at = |x: f64, y: f64| image.at(DVec2::new(x / 3.0, y / 2.0)).g;
        assert_eq!([at(0.5, 0.5), at(1.5, 0.5), at(2.5, 1.5)], [0.0, 1.0, 12.0]);
        assert!((at(1.0, 0.5) - 0.5).abs() < 1e-6 && (at(1.25, 1.0) - 5.75).abs() < 1e-6);
        // Beyond the outer centres nothing changes.
        assert_eq!([at(0.0, 0.0), at(-9.0, 0.2), at(3.0, 2.0), at(99.0, 99.0)], [0., 0., 12., 12.]);
    }

    #[test]
    fn beyond_its_edges_a_picture_goes_on_as_it_is_told() {
        let row = |wrap| {
            let image = image(wrap, Filter::Nearest);
            let at = |i: i32| image.at(DVec2::new((f64::from(i) + 0.5) / 3.0, 0.25)).g;
            (-4..8).map(at).collect::<Vec<_>>()
        };
        assert_eq!(row(Wrap::Repeat), [2., 0., 1., 2., 0., 1., 2., 0., 1., 2., 0., 1.]);
        assert_eq!(row(Wrap::Clamp), [0., 0., 0., 0., 0., 1., 2., 2., 2., 2., 2., 2.]);
        assert_eq!(row(Wrap::Mirror), [2., 2., 1., 0., 0., 1., 2., 2., 1., 0., 0., 1.]);
        // From the last texel to the first of the next picture.
        let seam = |wrap| image(wrap, Filter::Linear).at(DVec2::new(1.0, 0.25)).g;
        assert_eq!([seam(Wrap::Repeat), seam(Wrap::Clamp), seam(Wrap::Mirror)], [1.0, 2.0, 2.0]);
    }

    #[test]
    fn no_place_is_without_a_colour() {
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
            for filter in [Filter::Nearest, Filter::Linear] {
                let image = image(wrap, filter);
                for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, 1e-320] {
                    let colour = image.at(DVec2::new(x, -x));
                    assert!(colour.is_finite() && colour.g <= 12.0, "{wrap:?} {x}");
                }
            }
        }
    }
}
