//! Solids by their distance: negative inside, positive outside, blended where they meet. Only the
//! four operations and square roots are used, so that every machine finds the same bits.

use glam::{DMat3, DVec3};

/// Half the side of the cube in which differences are taken, in the unit of the solids.
const STEP: f64 = 1e-4;
const TETRAHEDRON: [DVec3; 4] = [
    DVec3::new(1.0, 1.0, 1.0),
    DVec3::new(1.0, -1.0, -1.0),
    DVec3::new(-1.0, 1.0, -1.0),
    DVec3::new(-1.0, -1.0, 1.0),
];
/// Steps from near the surface onto it.
const PROJECTIONS: usize = 2;

/// A solid by its distance.
pub enum Shape {
    /// Around `center`, with half axes along the columns of `axes`, which stand at right angles.
    /// Its distance is right at the surface and to first order around it.
    Ellipsoid { center: DVec3, axes: DMat3, radii: DVec3 },
    /// Balls rolled along a way: all places and radii between one and the next.
    Limb(Vec<(DVec3, f64)>),
    /// A sheet: discs of the plane of the first two columns of `axes` through `center`, with a
    /// blend of `blend` between them, bent towards the third by `bend` times the square of the
    /// distance from the second, and as thick as twice `half` with a round edge.
    Sheet {
        center: DVec3,
        axes: DMat3,
        discs: Vec<([f64; 2], f64)>,
        blend: f64,
        bend: f64,
        half: f64,
    },
}

impl Shape {
    /// A ball.
    pub fn ball(center: DVec3, radius: f64) -> Shape {
        Shape::Limb(vec![(center, radius)])
    }

    /// A ball that holds it.
    fn ball_around(&self) -> (DVec3, f64) {
        match self {
            Shape::Ellipsoid { center, radii, .. } => (*center, radii.max_element()),
            Shape::Limb(balls) => {
                let places = balls.iter().map(|(place, _)| *place);
                let low = places.clone().fold(DVec3::INFINITY, DVec3::min);
                let middle = low.midpoint(places.fold(DVec3::NEG_INFINITY, DVec3::max));
                let reach = balls.iter().map(|&(place, r)| place.distance(middle) + r);
                (middle, reach.fold(0.0, f64::max))
            }
            Shape::Sheet { center, discs, bend, half, .. } => {
                let reach = discs.iter().map(|&([x, y], r)| (x * x + y * y).sqrt() + r);
                let reach = reach.fold(0.0, f64::max);
                (*center, reach + bend.abs() * reach * reach + half)
            }
        }
    }

    fn distance(&self, p: DVec3) -> f64 {
        match self {
            Shape::Ellipsoid { center, axes, radii } => {
                let local = (axes.transpose() * (p - center)) / radii;
                let (scaled, slope) = (local.length(), (local / radii).length());
                if slope > 0.0 { scaled * (scaled - 1.0) / slope } else { -radii.min_element() }
            }
            Shape::Limb(balls) if balls.len() == 1 => p.distance(balls[0].0) - balls[0].1,
            Shape::Limb(balls) => {
                let between = balls.windows(2).map(|pair| rolled(p, pair[0], pair[1]));
                between.fold(f64::INFINITY, f64::min)
            }
            Shape::Sheet { center, axes, discs, blend, bend, half } => {
                let [u, v, w] = (axes.transpose() * (p - center)).to_array();
                let disc = |&([x, y], r): &([f64; 2], f64)| {
                    ((u - x) * (u - x) + (v - y) * (v - y)).sqrt() - r
                };
                let flat = discs.iter().map(disc);
                let flat = flat.fold(f64::INFINITY, |a, b| union(a, b, *blend)).max(0.0);
                let off = w - bend * u * u;
                (flat * flat + off * off).sqrt() - half
            }
        }
    }
}

/// The distance to a ball that rolls straight from one place to another and grows evenly.
fn rolled(p: DVec3, (a, ra): (DVec3, f64), (b, rb): (DVec3, f64)) -> f64 {
    let length = a.distance(b);
    let axis = (b - a) / length;
    let along = (p - a).dot(axis);
    let across = (p - a - axis * along).length();
    // The ball that touches p's nearest point lies up the slope of the cone from p.
    let sine = ((ra - rb) / length).clamp(-0.99, 0.99);
    let at = (along - across * sine / (1.0 - sine * sine).sqrt()).clamp(0.0, length);
    (across * across + (along - at) * (along - at)).sqrt() - (ra + (rb - ra) * at / length)
}

/// The union of two solids by their distances, rounded within `blend` of both.
fn union(a: f64, b: f64, blend: f64) -> f64 {
    let near = (blend - (a - b).abs()).max(0.0);
    if near == 0.0 { a.min(b) } else { a.min(b) - near * near * near / (6.0 * blend * blend) }
}

/// A shape of a figure.
pub struct Part {
    /// What it is.
    pub shape: Shape,
    /// Within this distance it melts into the parts before it.
    pub blend: f64,
    /// The index of its material.
    pub material: usize,
    /// A point and a direction: what lies beyond is cut away, with an edge so round.
    pub cut: Option<(DVec3, DVec3, f64)>,
}

impl Part {
    fn distance(&self, p: DVec3) -> f64 {
        let whole = self.shape.distance(p);
        match self.cut {
            Some((point, normal, round)) => -union(-whole, -(p - point).dot(normal), round),
            None => whole,
        }
    }
}

/// Parts made one solid.
pub struct Figure {
    /// In the order in which they are joined.
    parts: Vec<Part>,
    /// A ball around each.
    balls: Vec<(DVec3, f64)>,
}

impl Figure {
    /// Joins parts in their order.
    pub fn new(parts: Vec<Part>) -> Figure {
        let balls = parts.iter().map(|part| part.shape.ball_around()).collect();
        Figure { parts, balls }
    }

    /// How far the surface is, about; negative inside.
    pub fn distance(&self, p: DVec3) -> f64 {
        let mut distance = f64::INFINITY;
        for (part, &(center, radius)) in self.parts.iter().zip(&self.balls) {
            let reach = (distance + part.blend).max(0.0) + radius;
            if p.distance_squared(center) < reach * reach {
                distance = union(distance, part.distance(p), part.blend);
            }
        }
        distance
    }

    /// The point of the surface near `p`.
    pub fn projected(&self, p: DVec3) -> DVec3 {
        (0..PROJECTIONS).fold(p, |p, _| {
            let (distance, normal) = self.slope(p);
            p - normal * distance
        })
    }

    /// The distance and the way out, from the corners of a small tetrahedron.
    fn slope(&self, p: DVec3) -> (f64, DVec3) {
        let mut sum = 0.0;
        let mut way = DVec3::ZERO;
        for corner in TETRAHEDRON {
            let distance = self.distance(p + corner * STEP);
            sum += distance;
            way += corner * distance;
        }
        (sum / 4.0, way.normalize_or(DVec3::Y))
    }

    /// The material of the nearest part.
    pub fn material(&self, p: DVec3) -> usize {
        self.nearest(p).0
    }

    /// A point of the surface drawn onto the border of two materials, if one is within `reach`.
    pub fn on_border(&self, p: DVec3, reach: f64) -> DVec3 {
        let mut moved = p;
        for _ in 0..PROJECTIONS {
            let (material, gap) = self.nearest(moved);
            let towards = TETRAHEDRON.map(|corner| {
                let at = moved + corner * STEP;
                let (there, gap) = self.nearest(at);
                corner * if there == material { gap } else { -gap }
            });
            let slope = towards.into_iter().sum::<DVec3>() / (4.0 * STEP);
            if gap > reach * slope.length() {
                return p;
            }
            moved = self.projected(moved - slope * (gap / slope.length_squared()));
        }
        if moved.distance(p) < reach { moved } else { p }
    }

    /// The material of the nearest part, and by how much the nearest of another is farther.
    fn nearest(&self, p: DVec3) -> (usize, f64) {
        let (mut material, mut least, mut other) = (0, f64::INFINITY, f64::INFINITY);
        for (part, &(center, radius)) in self.parts.iter().zip(&self.balls) {
            if p.distance(center) - radius > other {
                continue;
            }
            let distance = part.distance(p);
            if part.material == material {
                least = least.min(distance);
            } else if distance < least {
                (material, least, other) = (part.material, distance, least);
            } else {
                other = other.min(distance);
            }
        }
        (material, other - least)
    }
}
