//! Straight lines over a picture, antialiased.

use super::{Picture, Rgb};

/// What is drawn over a picture in one colour. Places are in pixels, x to the right, y down, from
/// the top left corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// From where to where, each.
    pub pieces: Vec<[[f64; 2]; 2]>,
    /// Linear, in [0, 1].
    pub colour: Rgb,
    /// How thick, in pixels.
    pub width: f64,
    /// How much of what is below they hide, 0 to 1.
    pub opacity: f64,
    /// What they are.
    pub title: String,
}

impl Lines {
    /// Draws them, by the distance of each pixel's centre.
    pub fn draw(&self, picture: &mut Picture) {
        let size = [picture.width as f64, picture.height as f64];
        let radius = 0.5 * self.width;
        for piece in &self.pieces {
            // A pixel is touched within half its side beyond the radius.
            let reach = radius + 0.5;
            let bounds = [[-reach, size[0] + reach], [-reach, size[1] + reach]];
            let Some(piece) = clipped(*piece, bounds) else { continue };
            let [low, high] = [0, 1].map(|end| piece[end][1]);
            let (low, high) = (low.min(high) - reach, low.max(high) + reach);
            for y in low.max(0.0) as usize..(high.max(0.0).ceil() as usize).min(picture.height) {
                let row = y as f64 + 0.5;
                let near = [[f64::NEG_INFINITY, f64::INFINITY], [row - reach, row + reach]];
                let Some([a, b]) = clipped(piece, near) else { continue };
                let (left, right) = (a[0].min(b[0]) - reach, a[0].max(b[0]) + reach);
                let columns =
                    left.max(0.0) as usize..(right.max(0.0).ceil() as usize).min(picture.width);
                for x in columns {
                    let distance = distance([x as f64 + 0.5, row], piece);
                    let covered = (reach - distance).clamp(0.0, self.width.min(1.0));
                    let part = (covered * self.opacity) as f32;
                    let pixel = &mut picture.pixels[y * picture.width + x];
                    *pixel = *pixel * (1.0 - part) + self.colour * part;
                }
            }
        }
    }
}

/// The part of a piece within bounds along x and y, ends included; None if there is none [Liang84].
pub fn clipped(piece: [[f64; 2]; 2], bounds: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let [from, to] = piece;
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = to[axis] - from[axis];
        for (bound, sign) in [(bounds[axis][0], 1.0), (bounds[axis][1], -1.0)] {
            // How far inside the ends are.
            let (a, along) = (sign * (from[axis] - bound), sign * step);
            if along == 0.0 {
                if a < 0.0 {
                    return None;
                }
            } else if along > 0.0 {
                first = first.max(-a / along);
            } else {
                last = last.min(-a / along);
            }
        }
    }
    let at = |t: f64| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
    let sound = first <= last && [from, to].as_flattened().iter().all(|x| x.is_finite());
    sound.then(|| {
        [if first == 0.0 { from } else { at(first) }, if last == 1.0 { to } else { at(last) }]
    })
}

/// From a point to a piece.
fn distance(point: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let away = [point[0] - from[0], point[1] - from[1]];
    let length2 = along[0] * along[0] + along[1] * along[1];
    let dot = away[0] * along[0] + away[1] * along[1];
    let t = if length2 > 0.0 { (dot / length2).clamp(0.0, 1.0) } else { 0.0 };
    (away[0] - t * along[0]).hypot(away[1] - t * along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(pieces: &[[[f64; 2]; 2]], width: f64, opacity: f64) -> Picture {
        let mut picture = Picture::black(20, 10);
        let colour = Rgb::new(1.0, 0.5, 0.0);
        let title = String::new();
        Lines { pieces: pieces.to_vec(), colour, width, opacity, title }.draw(&mut picture);
        picture
    }

    fn total(picture: &Picture) -> f64 {
        picture.pixels.iter().map(|pixel| f64::from(pixel.r)).sum()
    }

    #[test]
    fn lines_cover_as_much_as_they_are_long_and_wide() {
        for (piece, length) in [
            ([[2.0, 5.0], [18.0, 5.0]], 16.0),
            ([[5.5, 1.0], [5.5, 9.0]], 8.0),
            ([[3.0, 2.0], [15.0, 7.0]], 13.0),
            ([[15.0, 7.0], [3.0, 2.0]], 13.0),
        ] {
            for width in [1.0, 2.0, 3.0] {
                let ends = std::f64::consts::FRAC_PI_4 * width * width;
                let covered = total(&drawn(&[piece], width, 1.0));
                let expected = length * width + ends;
                assert!((covered / expected - 1.0).abs() < 0.06, "{piece:?} {width}: {covered}");
            }
        }
        let faint = total(&drawn(&[[[2.0, 5.0], [18.0, 5.0]]], 2.0, 0.25));
        let whole = total(&drawn(&[[[2.0, 5.0], [18.0, 5.0]]], 2.0, 1.0));
        assert!((faint / whole - 0.25).abs() < 1e-6);
    }

    #[test]
    fn what_lies_outside_is_left_out_however_far() {
        let far = 1e9;
        for piece in [
            [[-far, -far], [-1.0, far]],
            [[0.0, -5.0], [20.0, -5.0]],
            [[far, 0.0], [far, 10.0]],
            [[f64::NAN, 0.0], [5.0, 5.0]],
            [[0.0, f64::INFINITY], [5.0, 5.0]],
        ] {
            assert_eq!(total(&drawn(&[piece], 1.0, 1.0)), 0.0, "{piece:?}");
        }
        let long = drawn(&[[[-far, 5.0], [far, 5.0]]], 1.0, 1.0);
        assert!((total(&long) - 20.0).abs() < 1e-3);
        assert_eq!(long.at(7, 5), long.at(8, 5));
    }

    #[test]
    fn clipping_keeps_what_is_inside() {
        let bounds = [[0.0, 10.0], [0.0, 10.0]];
        assert_eq!(clipped([[1.0, 2.0], [3.0, 4.0]], bounds), Some([[1.0, 2.0], [3.0, 4.0]]));
        assert_eq!(clipped([[-5.0, 5.0], [15.0, 5.0]], bounds), Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(clipped([[-5.0, 1.0], [1.0, -5.0]], bounds), None);
        assert_eq!(clipped([[5.0, 5.0], [5.0, 5.0]], bounds), Some([[5.0, 5.0], [5.0, 5.0]]));
    }
}
