//! Two pictures that can be compared: of one size, with pixels, and every pixel a number.

use crate::math::Picture;

/// A test picture and the reference it is held against.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    test: &'a Picture,
    reference: &'a Picture,
}

/// Why two pictures cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unpaired {
    /// They have no pixels.
    Empty,
    /// Width and height of the test and of the reference.
    Sizes([usize; 2], [usize; 2]),
    /// A picture has pixels that are infinite or not a number. They are not left out: an error
    /// would be hidden, and the filters of FLIP and SSIM have no gaps.
    NotFinite {
        /// Whether it is the reference.
        reference: bool,
        /// How many of its pixels.
        count: usize,
        /// Column and row of the first.
        first: [usize; 2],
    },
}

impl<'a> Pair<'a> {
    /// Pairs a picture with its reference, if they can be compared.
    pub fn new(test: &'a Picture, reference: &'a Picture) -> Result<Self, Unpaired> {
        let [size_t, size_r] = [test, reference].map(|it| [it.width, it.height]);
        if size_t != size_r {
            return Err(Unpaired::Sizes(size_t, size_r));
        }
        if test.pixels.is_empty() {
            return Err(Unpaired::Empty);
        }
        for (picture, is_reference) in [(test, false), (reference, true)] {
            let mut bad = picture.pixels.iter().enumerate().filter(|(_, p)| !p.is_finite());
            if let Some((at, _)) = bad.next() {
                return Err(Unpaired::NotFinite {
                    reference: is_reference,
                    count: 1 + bad.count(),
                    first: [at % picture.width, at / picture.width],
                });
            }
        }
        Ok(Self { test, reference })
    }

    /// The picture that is judged.
    pub fn test(&self) -> &'a Picture {
        self.test
    }

    /// What it should be.
    pub fn reference(&self) -> &'a Picture {
        self.reference
    }

    /// Every component of every pixel: the test's and the reference's.
    pub(super) fn components(&self) -> impl Iterator<Item = [[f64; 3]; 2]> {
        let wide = |pixel: &crate::math::Rgb| pixel.to_array().map(f64::from);
        let both = self.test.pixels.iter().zip(&self.reference.pixels);
        both.map(move |(test, reference)| [wide(test), wide(reference)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn what_cannot_be_compared_is_told() {
        let good = Picture::black(4, 3);
        let wide = Picture::black(6, 2);
        let mut bad = Picture::black(4, 3);
        bad.pixels[6] = Rgb::new(0.0, f32::NAN, 0.0);
        bad.pixels[9] = Rgb::new(f32::INFINITY, 0.0, 0.0);
        let why = |test, reference| Pair::new(test, reference).unwrap_err();
        assert_eq!(why(&good, &wide), Unpaired::Sizes([4, 3], [6, 2]));
        for (pair, reference) in [((&good, &bad), true), ((&bad, &good), false)] {
            let wanted = Unpaired::NotFinite { reference, count: 2, first: [2, 1] };
            assert_eq!(why(pair.0, pair.1), wanted);
        }
        let none = Picture::black(0, 3);
        assert_eq!(why(&none, &none), Unpaired::Empty);
        assert!(Pair::new(&good, &good).is_ok());
    }
}
