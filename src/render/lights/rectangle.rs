//! Lamps that are rectangles: uniform points in the solid angle of one [Urena13].

use std::f64::consts::TAU;

use glam::{BVec3, DVec3};

use super::flat::{Flat, LEAST, Sampled, is_wide};
use super::{Geometry, Point, Site};
use crate::math::angles;
use crate::render::geometry::{Facet, Form, Primitive};

/// A rectangle as a site sees it, in a frame of its own: x and y along its edges, z away from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidRectangle {
    pub x: [f64; 2],
    pub y: [f64; 2],
    /// Of the site over its plane; negative behind it.
    pub height: f64,
    /// In sr.
    pub solid_angle: f64,
}

impl SolidRectangle {
    /// From x to x and from y to y, for a site at the origin, so high above its plane (or, if
    /// negative, below it), and not in it.
    #[inline(always)]
    pub fn new(x: [f64; 2], y: [f64; 2], height: f64) -> Self {
        let h = height.abs();
        // The sum of ±atan(xy / (h √(x² + y² + h²))) over the corners: the angle of the product of
        // as many complex numbers.
        let corner = |x: f64, y: f64| [h * (x * x + y * y + h * h).sqrt(), x * y];
        let apart =
            |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1]];
        let one = apart(corner(x[1], y[1]), corner(x[0], y[1]));
        let other = apart(corner(x[1], y[0]), corner(x[0], y[0]));
        let [real, imaginary] = apart(one, other);
        let angle = angles::atan2(imaginary, real);
        let above = (x[0] < 0.0) & (x[1] > 0.0) & (y[0] < 0.0) & (y[1] > 0.0);
        // Beside it no more than half of the half space is seen of it: what is negative is zero.
        let around = if above { angle + TAU } else { 0.0 };
        let solid_angle = if angle < 0.0 { around } else { angle };
        Self { x, y, height, solid_angle }
    }

    /// A point of it, x and y, uniform in solid angle.
    ///
    /// Written without `map`, which a compiler may not inline, and without jumps: a loop over it
    /// becomes vectors.
    #[inline(always)]
    pub fn sample(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let h_2 = self.height * self.height;
        // Sines of the angles between the frame's z and the planes through the origin and an edge:
        // z of their normals.
        let sine = |x: f64| x / (x * x + h_2).sqrt();
        let (x0, y0, y1) = (sine(self.x[0]), sine(self.y[0]), sine(self.y[1]));
        // Cosines and sines of the angles of the spherical rectangle at two of its corners.
        let (c2, c3) = (x0 * y1, -x0 * y0);
        let (s2, s3) = ((1.0 - c2 * c2).max(0.0).sqrt(), (1.0 - c3 * c3).max(0.0).sqrt());
        // What both lack of a full turn, and a part of the solid angle beyond it.
        let (cos_turn, sin_turn) = (c2 * c3 - s2 * s3, -(s2 * c3 + c2 * s3));
        let (sin, cos) = angles::sin_cos(u * self.solid_angle);
        let (sin, cos) = (sin * cos_turn + cos * sin_turn, cos * cos_turn - sin * sin_turn);
        // With f = n / sin, c of the paper is ±1 / √(f² + y0²), and x = c h / √(1 - c²).
        let n = -(cos * y0 + y1);
        let rest = n * n - sin * sin * (h_2 / (self.y[0] * self.y[0] + h_2));
        let x = self.height.abs() * sin / rest.max(f64::MIN_POSITIVE).sqrt();
        let x = if n < 0.0 { -x } else { x };
        let x = x.max(self.x[0]).min(self.x[1]);
        let d_2 = x * x + h_2;
        let sine = |y: f64| y / (d_2 + y * y).sqrt();
        let (h0, h1) = (sine(self.y[0]), sine(self.y[1]));
        let h = h0 + v * (h1 - h0);
        let y = h * (d_2 / (1.0 - h * h).max(f64::MIN_POSITIVE)).sqrt();
        [x, y.max(self.y[0]).min(self.y[1])]
    }

    /// The way from the site to a point of it, by the directions of the frame.
    #[inline(always)]
    pub fn way(&self, [x, y]: [f64; 2], axes: [DVec3; 2], normal: DVec3) -> DVec3 {
        x * axes[0] + y * axes[1] - self.height * normal
    }
}

/// A rectangle lamp as a point sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub solid: SolidRectangle,
    /// Whether it is so near that it is sampled by solid angle.
    pub is_wide: bool,
    /// Whether the point is over it.
    pub is_over: bool,
}

/// A place of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// In the frame of who sees it by solid angle.
    pub at: [f64; 2],
    /// Parts of its sides, from 0 to 1.
    pub parts: [f64; 2],
}

/// Two triangles that are a rectangle: with corners a, b, c and a, c, d.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    flat: Flat,
    triangles: [Primitive; 2],
    facets: [Facet; 2],
    /// From a to b, c and d: not quite a rectangle, by rounding.
    edges: [DVec3; 3],
    /// Along its sides, unit length, square to each other.
    axes: [DVec3; 2],
    /// Its sides.
    pub size: [f64; 2],
}

/// Edges of a rectangle are square if the cosine between them is smaller, and its corners fit to
/// this part of its size: rounding moves them so far.
const SQUARE: f64 = 1e-6;

impl Rectangle {
    /// None: they are no rectangle.
    pub fn of(triangles: [Primitive; 2], geometry: &Geometry) -> Option<Self> {
        let [first, second] = triangles;
        let (Form::Triangle([a, b, c]), Form::Triangle([a_too, c_too, d])) =
            (geometry.form(first), geometry.form(second))
        else {
            return None;
        };
        let edges @ [u, diagonal, v] = [b - a, c - a, d - a];
        let (long, wide) = (u.length(), v.length());
        let fits = (diagonal - (u + v)).length() <= SQUARE * long.min(wide);
        let square = u.dot(v).abs() <= SQUARE * long * wide;
        if !(a == a_too && c == c_too && fits && square) {
            return None;
        }
        let cross = u.cross(v);
        let normal = cross.try_normalize()?;
        let x = u.normalize();
        // Square to it even where the edges are not, by rounding.
        let y = normal.cross(x);
        Some(Self {
            flat: Flat { at: a, normal, area: cross.length() },
            triangles,
            facets: [Facet::of(first, [a, b, c]), Facet::of(second, [a, c, d])],
            edges,
            axes: [x, y],
            size: [long, v.dot(y)],
        })
    }

    pub fn triangles(&self) -> [Primitive; 2] {
        self.triangles
    }

    /// As a point sees it. Its front alone is seen, if not `both`.
    #[inline(always)]
    pub fn view(&self, from: &Point, both: bool) -> View {
        let (height, is_over) = self.flat.over(from, both);
        View { is_over, ..self.view_at(from.position.as_dvec3(), height) }
    }

    /// The same from a place of that height over its plane, which it is seen from.
    #[inline(always)]
    fn view_at(&self, from: DVec3, height: f64) -> View {
        let corner = self.flat.at - from;
        let (x, y) = (corner.dot(self.axes[0]), corner.dot(self.axes[1]));
        let [long, wide] = self.size;
        let (along, across) = (x + 0.5 * long, y + 0.5 * wide);
        let distance_2 = along * along + across * across + height * height;
        let solid = SolidRectangle::new([x, x + long], [y, y + wide], height);
        View { solid, is_wide: is_wide(long * long + wide * wide, distance_2), is_over: true }
    }

    /// A place of it, by `u` in [0, 1)².
    ///
    /// Both ways to find one are gone, and one of them taken: without jumps, so that a loop over it
    /// becomes vectors.
    #[inline(always)]
    pub fn place(&self, view: &View, u: [f64; 2]) -> Place {
        let View { solid, is_wide, .. } = *view;
        let [x, y] = solid.sample(u);
        let s = if is_wide { (x - solid.x[0]) / self.size[0] } else { u[0] };
        let t = if is_wide { (y - solid.y[0]) / self.size[1] } else { u[1] };
        Place { at: [x, y], parts: [s, t] }
    }

    /// The point at a place of it, and whether it is seen. Without jumps, too.
    #[inline(always)]
    pub fn see(&self, from: &Point, view: &View, place: &Place) -> (Sampled, bool) {
        let View { solid, is_wide, is_over } = *view;
        let point = self.point(place.parts);
        let near = solid.way(place.at, self.axes, self.flat.normal);
        let far = point.position.as_dvec3() - from.position.as_dvec3();
        let way = DVec3::select(BVec3::splat(is_wide), near, far);
        let inverse = 1.0 / way.length();
        let density = self.flat.density(way);
        let pdf_w = if is_wide { 1.0 / solid.solid_angle } else { density };
        let has_angle = !is_wide | (solid.solid_angle > LEAST);
        let is_there = (inverse > 0.0) & (inverse < f64::INFINITY) & (pdf_w > 0.0);
        (Sampled { point, wi: way * inverse, pdf_w }, is_over & has_angle & is_there)
    }

    /// A point of it that the site sees.
    #[inline(always)]
    pub fn sample(&self, (site, both): (&Site, bool), u: [f64; 2]) -> Option<Sampled> {
        let view = self.view(&site.point, both);
        let (sampled, is_seen) = self.see(&site.point, &view, &self.place(&view, u));
        is_seen.then_some(sampled)
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, (site, both): (&Site, bool), way: DVec3) -> f64 {
        let Some(height) = self.flat.height(site, both) else { return 0.0 };
        let View { solid, is_wide, .. } = self.view_at(site.point.position.as_dvec3(), height);
        match is_wide {
            false => self.flat.density(way),
            true if solid.solid_angle > LEAST => 1.0 / solid.solid_angle,
            true => 0.0,
        }
    }

    /// The point of its triangles at these parts of its sides, 0 to 1.
    #[inline(always)]
    fn point(&self, [s, t]: [f64; 2]) -> Point {
        let (s, t) = (s.clamp(0.0, 1.0), t.clamp(0.0, 1.0));
        let [b, c, d] = self.edges;
        // By a choice of numbers, not of ways: no processor foretells which triangle it is.
        let second = s < t;
        let edge = DVec3::select(BVec3::splat(second), d, b);
        let facet = self.facets[0].or(&self.facets[1], second);
        facet.point(self.flat.at + s.min(t) * c + (s - t).abs() * edge)
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::math::random;
    use crate::render::geometry::{Owner, Ray, Shapes};

    /// The sum of four arcs, as it is commonly written.
    fn by_arcs(x: [f64; 2], y: [f64; 2], height: f64) -> f64 {
        let part =
            |x: f64, y: f64| (x * y / (height * (x * x + y * y + height * height).sqrt())).atan();
        part(x[1], y[1]) - part(x[0], y[1]) - part(x[1], y[0]) + part(x[0], y[0])
    }

    #[test]
    fn the_solid_angle_is_the_sum_of_four_arcs() {
        for i in 0..20_000 {
            let [a, b] = random::unit_pair(random::at(41, i)).map(|u| 4.0 * u - 2.0);
            let [c, d] = random::unit_pair(random::at(42, i)).map(|u| 1e-3 + 3.0 * u * u);
            let [e, _] = random::unit_pair(random::at(43, i)).map(|u| 1e-7_f64.powf(u));
            let (x, y) = ([a, a + c], [b, b + d]);
            let found = SolidRectangle::new(x, y, -e).solid_angle;
            let truth = by_arcs(x, y, e);
            assert!(
                (found - truth).abs() < 1e-13 + 1e-12 * truth,
                "{x:?} {y:?} {e}: {found} {truth}"
            );
        }
    }

    #[test]
    fn parts_of_the_solid_angle_are_where_they_should_be() {
        // By the definition: what is left of a sampled point has the part u of the solid angle, and
        // of the line through it what is below has the part v of its sines.
        for i in 0..5000 {
            let [a, b] = random::unit_pair(random::at(44, i)).map(|u| 4.0 * u - 2.0);
            let [c, d] = random::unit_pair(random::at(45, i)).map(|u| 0.05 + 2.0 * u);
            let [u, v] = random::unit_pair(random::at(46, i));
            let [height, _] = random::unit_pair(random::at(47, i)).map(|u| 0.01 + 2.0 * u);
            let solid = SolidRectangle::new([a, a + c], [b, b + d], height);
            let [x, y] = solid.sample([u, v]);
            let left = by_arcs([a, x], [b, b + d], height) / solid.solid_angle;
            assert!((left - u).abs() < 1e-9, "{left} for {u}");
            let sine = |y: f64| y / (x * x + y * y + height * height).sqrt();
            let below = (sine(y) - sine(b)) / (sine(b + d) - sine(b));
            assert!((below - v).abs() < 1e-9, "{below} for {v}");
        }
    }

    #[test]
    fn points_name_the_triangle_that_they_are_of() {
        let mut shapes = Shapes::new();
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[x, z]| shapes.vertex(Vec3::new(x, 1.0, z)));
        let triangles = shapes.quad(corners, Owner::default());
        let geometry = Geometry::build(shapes);
        let rectangle = Rectangle::of(triangles, &geometry).unwrap();
        for (i, below) in (0..1000).flat_map(|i| [1.0, 50.0].map(|below| (i, below))) {
            let from = Point::free(Vec3::new(0.3, 1.0 - below, -0.2));
            let view = rectangle.view(&from, true);
            let place = rectangle.place(&view, random::unit_pair(random::at(48, i)));
            let (sampled, _) = rectangle.see(&from, &view, &place);
            let Point { position, sheet, .. } = sampled.point;
            if (position.x - position.z).abs() > 1e-3 {
                let way = sampled.wi.as_vec3();
                let hit = geometry.closest(&Ray::new(from.position, way)).unwrap();
                assert_eq!(sheet, hit.sheet, "{position}");
            }
        }
    }
}
