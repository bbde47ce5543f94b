//! Where to begin the fan of triangles that makes up a polygon.

use glam::DVec3;

/// The most corners tried: each costs a walk around the polygon.
const TRIED: usize = 32;

/// A corner from which all triangles of the fan turn the way the polygon turns, the first if it
/// is one; None if no corner tried is. A quadrilateral that does not cross itself has one.
pub fn start(corners: &[DVec3]) -> Option<usize> {
    if corners.len() <= 3 {
        return Some(0);
    }
    // Twice the polygon's vector area [Newell]; edges from one corner keep the digits.
    let origin = corners[0];
    let area =
        |i: usize, j: usize, k: usize| (corners[j] - corners[i]).cross(corners[k] - corners[i]);
    let normal: DVec3 = (1..corners.len() - 1).map(|i| area(0, i, i + 1)).sum();
    let size = corners.iter().map(|p| (*p - origin).abs().max_element()).fold(0.0, f64::max);
    // Rounding turns triangles on a line neither way.
    let slack = -1e-9 * normal.length() * size * size;
    let count = corners.len();
    (0..count.min(TRIED)).find(|&start| {
        (1..count - 1).all(|i| {
            let [j, k] = [(start + i) % count, (start + i + 1) % count];
            area(start, j, k).dot(normal) >= slack
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[f64; 2]]) -> Vec<DVec3> {
        corners.iter().map(|[x, y]| DVec3::new(*x, *y, 0.3 * x - y)).collect()
    }

    #[test]
    fn fans_begin_where_they_cover_the_polygon() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(start(&polygon(&square)), Some(0));
        // An arrowhead with its notch at corner 1, seen from either side.
        let arrow = [[1.0, 0.0], [0.2, 0.2], [0.0, 1.0], [0.0, 0.0]];
        assert_eq!(start(&polygon(&arrow)), Some(1));
        let mut turned = polygon(&arrow);
        turned.reverse();
        assert_eq!(start(&turned), Some(0));
        // A U has no corner that sees all of it.
        let u = [[0., 0.], [3., 0.], [3., 3.], [2., 3.], [2., 1.], [1., 1.], [1., 3.], [0., 3.]];
        assert_eq!(start(&polygon(&u)), None);
    }

    #[test]
    fn corners_on_a_line_do_not_matter() {
        let split = [[0.0, 0.0], [0.1, 0.0], [0.7, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(start(&polygon(&split)), Some(0));
        assert_eq!(start(&[DVec3::ONE; 6]), Some(0));
    }
}
