//! One surface of a lamp, as a site sees it: points of it, and the density of their directions.
//!
//! Near surfaces are sampled by solid angle: their light has no more noise than the cosine at the
//! site gives it. Far ones are sampled by area: they fill so little that this is the same, costs
//! less, and needs no differences of nearly equal directions. What decides is the surface and the
//! site alone, so that the density of a direction that was found otherwise is known.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3, Vec2};

use super::rectangle::SolidRectangle;
use super::triangle::SolidTriangle;
use super::{Emitter, Geometry, Point, Site};
use crate::math::{random, warp};
use crate::render::geometry::{Form, Primitive};

/// A surface.
#[derive(Clone, Copy, Debug)]
pub(super) enum Patch {
    /// Of any form but a plane without end.
    One(Primitive),
    /// Two triangles that are a rectangle: with corners a, b, c and a, c, d.
    Rectangle([Primitive; 2]),
}

/// How points of a surface are found for a site.
enum Way {
    /// By area, of a flat surface: with its unit normal.
    Area {
        area: f64,
        normal: DVec3,
    },
    Triangle(SolidTriangle),
    /// With its frame.
    Rectangle(SolidRectangle, [DVec3; 3]),
    /// The rectangle around a disk, with its frame; points beyond the rim bring nothing.
    Disk(SolidRectangle, [DVec3; 3]),
    /// From outside of a sphere: the direction of its centre, the squared sine of the angle it
    /// fills, and one minus its cosine.
    Cone {
        towards: DVec3,
        sin_2: f64,
        lack: f64,
    },
    /// From inside of a sphere: as of what surrounds the scene.
    Inside,
}

/// A surface whose directions differ by less than this chord, squared, is sampled by area: its
/// distance and its cosine vary by a thousandth.
const NARROW: f64 = 1e-6;

/// Of less than this solid angle, in sr, what is sampled knows too few digits.
const LEAST: f64 = 1e-8;

/// Edges of a rectangle are square if the cosine between them is smaller, and its corners fit to
/// this part of its size: rounding moves them so far.
const SQUARE: f64 = 1e-6;

impl Patch {
    /// Surfaces of a lamp, with triangles joined to rectangles where two in a row are one.
    pub fn of(surfaces: &[Primitive], geometry: &Geometry) -> Vec<Self> {
        let mut all = Vec::new();
        let mut rest = surfaces;
        while let Some((first, after)) = rest.split_first() {
            let pair = after.first().map(|second| [*first, *second]);
            match pair.filter(|pair| rectangle(*pair, geometry).is_some()) {
                Some(pair) => {
                    all.push(Self::Rectangle(pair));
                    rest = &after[1..];
                }
                None => {
                    all.push(Self::One(*first));
                    rest = after;
                }
            }
        }
        all
    }

    /// The primitives it is made of.
    pub fn primitives(&self) -> impl Iterator<Item = Primitive> {
        let (first, second) = match self {
            Self::One(one) => (*one, None),
            Self::Rectangle([a, b]) => (*a, Some(*b)),
        };
        std::iter::once(first).chain(second)
    }

    /// What bounds it, of a radiance of 1.
    pub fn emitter(&self, geometry: &Geometry, both: bool) -> Emitter {
        let of = |primitive| match geometry.form(primitive) {
            Form::Triangle([a, b, c]) => {
                let normal = (b - a).cross(c - a);
                let corners = [a.min(b).min(c), a.max(b).max(c)];
                Emitter::flat(corners, normal, both, 0.5 * normal.length())
            }
            Form::Disk { centre, normal, radius } => {
                let reach = radius * (DVec3::ONE - normal * normal).max(DVec3::ZERO).map(f64::sqrt);
                let corners = [centre - reach, centre + reach];
                Emitter::flat(corners, normal, both, PI * radius * radius)
            }
            Form::Sphere { centre, radius } => {
                let corners = [centre - radius, centre + radius];
                Emitter::everywhere(corners, PI * radius * radius)
            }
            Form::Plane => Emitter::everywhere([DVec3::ZERO; 2], 0.0),
        };
        match self {
            Self::One(one) => of(*one),
            Self::Rectangle([a, b]) => of(*a).and(&of(*b)),
        }
    }

    /// A point of it that the site sees, the direction there, of unit length, and the density of
    /// that in solid angle. Its front alone is seen, if not `both`.
    pub fn sample(
        &self,
        geometry: &Geometry,
        (site, both): (&Site, bool),
        u: [f64; 2],
    ) -> Option<(Point, DVec3, f64)> {
        let from = site.point.position.as_dvec3();
        match self.way(geometry, site, both)? {
            Way::Area { area, normal } => {
                let point = self.by_area(geometry, u)?;
                let way = point.position.as_dvec3() - from;
                let wi = way.try_normalize()?;
                let cos = wi.dot(normal).abs();
                (cos > 0.0).then(|| (point, wi, way.length_squared() / (area * cos)))
            }
            Way::Triangle(solid) => {
                let Self::One(primitive) = self else { return None };
                let Form::Triangle([a, b, c]) = geometry.form(*primitive) else { return None };
                let wi = solid.sample(u);
                let normal = (b - a).cross(c - a);
                let t = normal.dot(a - from) / normal.dot(wi);
                let weights = within(weights([a, b, c], normal, from + t * wi));
                let exact = a + weights.x * (b - a) + weights.y * (c - a);
                let point = geometry.point(*primitive, exact);
                point.position.is_finite().then(|| (point, wi, 1.0 / solid.solid_angle))
            }
            Way::Rectangle(solid, [x, y, z]) => {
                let way = solid.way(solid.sample(u));
                let way = way.x * x + way.y * y + way.z * z;
                let point = self.on_rectangle(geometry, from + way)?;
                Some((point, way.try_normalize()?, 1.0 / solid.solid_angle))
            }
            Way::Disk(solid, [x, y, z]) => {
                let Self::One(primitive) = self else { return None };
                let Form::Disk { centre, radius, .. } = geometry.form(*primitive) else {
                    return None;
                };
                let way = solid.way(solid.sample(u));
                let way = way.x * x + way.y * y + way.z * z;
                let exact = from + way;
                if (exact - centre).length_squared() > radius * radius {
                    return None;
                }
                let point = geometry.point(*primitive, exact);
                Some((point, way.try_normalize()?, 1.0 / solid.solid_angle))
            }
            Way::Cone { towards, sin_2, lack } => {
                let Self::One(primitive) = self else { return None };
                let Form::Sphere { centre, radius } = geometry.form(*primitive) else {
                    return None;
                };
                let off = u[0] * lack;
                let sine_2 = off * (2.0 - off);
                let part = (sine_2 / sin_2).min(1.0);
                let (x, y) = towards.any_orthonormal_pair();
                let (sin, cos) = (TAU * u[1]).sin_cos();
                let aside = cos * x + sin * y;
                let wi = (1.0 - off) * towards + sine_2.sqrt() * aside;
                // At the centre, the angle between the site and the point.
                let cosine = sine_2 / sin_2.sqrt() + (1.0 - off) * (1.0 - part).sqrt();
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
                let exact = centre + radius * (sine * aside - cosine * towards);
                Some((geometry.point(*primitive, exact), wi, 1.0 / (TAU * lack)))
            }
            Way::Inside => {
                let Self::One(primitive) = self else { return None };
                let Form::Sphere { centre, radius } = geometry.form(*primitive) else {
                    return None;
                };
                let u = Vec2::from_array(u.map(random::unit_f32));
                let wi = match site.normal {
                    glam::Vec3::ZERO => warp::square_to_sphere(u),
                    normal => warp::about(normal, warp::square_to_cosine(u)),
                };
                let wi = wi.as_dvec3().normalize_or(DVec3::Z);
                let pdf_w = around(site, wi);
                let to_centre = centre - from;
                let along = to_centre.dot(wi);
                let depth = radius * radius - (to_centre - along * wi).length_squared();
                let exact = from + (along + depth.max(0.0).sqrt()) * wi;
                (pdf_w > 0.0).then(|| (geometry.point(*primitive, exact), wi, pdf_w))
            }
        }
    }

    /// Density with which `sample` gives the direction of a point of it.
    pub fn pdf_w(&self, geometry: &Geometry, (site, both): (&Site, bool), point: DVec3) -> f64 {
        let way = point - site.point.position.as_dvec3();
        match self.way(geometry, site, both) {
            None => 0.0,
            Some(Way::Area { area, normal }) => {
                let distance_2 = way.length_squared();
                let cos = way.dot(normal).abs() / distance_2.sqrt();
                if cos > 0.0 { distance_2 / (area * cos) } else { 0.0 }
            }
            Some(Way::Triangle(solid)) => 1.0 / solid.solid_angle,
            Some(Way::Rectangle(solid, _) | Way::Disk(solid, _)) => 1.0 / solid.solid_angle,
            Some(Way::Cone { lack, .. }) => 1.0 / (TAU * lack),
            Some(Way::Inside) => around(site, way.normalize_or_zero()),
        }
    }

    /// None: no point of it can be seen.
    fn way(&self, geometry: &Geometry, site: &Site, both: bool) -> Option<Way> {
        match self {
            Self::One(primitive) => match geometry.form(*primitive) {
                Form::Triangle(corners) => triangle_way(corners, site, both),
                Form::Disk { centre, normal, radius } => {
                    disk_way((centre, normal, radius), site, both)
                }
                Form::Sphere { centre, radius } => sphere_way(centre, radius, site, both),
                Form::Plane => None,
            },
            Self::Rectangle(pair) => {
                let [corner, u, v] = rectangle(*pair, geometry)?;
                rectangle_way([corner, u, v], site, both)
            }
        }
    }

    /// A point, uniform by area.
    fn by_area(&self, geometry: &Geometry, u: [f64; 2]) -> Option<Point> {
        match self {
            Self::One(primitive) => {
                geometry.sample(*primitive, Vec2::from_array(u.map(random::unit_f32)))
            }
            Self::Rectangle(pair) => {
                let [corner, x, y] = rectangle(*pair, geometry)?;
                self.on_rectangle(geometry, corner + u[0] * x + u[1] * y)
            }
        }
    }

    /// The point of its triangles that a point of a rectangle stands for.
    fn on_rectangle(&self, geometry: &Geometry, exact: DVec3) -> Option<Point> {
        let Self::Rectangle([first, second]) = self else { return None };
        let [corner, x, y] = rectangle([*first, *second], geometry)?;
        let part =
            |edge: DVec3| ((exact - corner).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        let (s, t) = (part(x), part(y));
        // Corners a, b, c and a, c, d.
        let (primitive, weights) = match s >= t {
            true => (*first, DVec2::new(s - t, t)),
            false => (*second, DVec2::new(s, t - s)),
        };
        let Form::Triangle([a, b, c]) = geometry.form(primitive) else { return None };
        Some(geometry.point(primitive, a + weights.x * (b - a) + weights.y * (c - a)))
    }
}

/// The height of a site over a plane, along its unit normal. None: it is in it, to within rounding,
/// or behind it and that is dark.
fn height(point: DVec3, normal: DVec3, site: &Site, both: bool) -> Option<f64> {
    let height = (site.point.position.as_dvec3() - point).dot(normal);
    let error = normal.abs().dot(site.point.error.as_dvec3());
    let seen = if both { height.abs() } else { height };
    (seen > error).then_some(height)
}

fn triangle_way(corners: [DVec3; 3], site: &Site, both: bool) -> Option<Way> {
    let [a, b, c] = corners;
    let cross = (b - a).cross(c - a);
    let normal = cross.try_normalize()?;
    height(a, normal, site, both)?;
    let ways = corners.map(|corner| corner - site.point.position.as_dvec3());
    let lengths = ways.map(DVec3::length);
    let towards: [DVec3; 3] = std::array::from_fn(|i| ways[i] / lengths[i]);
    if is_wide([towards[0], towards[1], towards[2], towards[0]]) {
        // Its differences are of corners, and exact: no digits are lost.
        let determinant = ways[0].dot(cross) / (lengths[0] * lengths[1] * lengths[2]);
        let solid = SolidTriangle::new(towards, determinant);
        if solid.solid_angle > LEAST {
            return Some(Way::Triangle(solid));
        }
    }
    Some(Way::Area { area: 0.5 * cross.length(), normal })
}

fn rectangle_way([corner, u, v]: [DVec3; 3], site: &Site, both: bool) -> Option<Way> {
    let cross = u.cross(v);
    let normal = cross.try_normalize()?;
    let height = height(corner, normal, site, both)?;
    let from = site.point.position.as_dvec3();
    let ways = [corner, corner + u, corner + u + v, corner + v].map(|p| (p - from).normalize());
    if is_wide(ways) {
        let (solid, frame) = solid(corner - from, (u, v), normal, height);
        if solid.solid_angle > LEAST {
            return Some(Way::Rectangle(solid, frame));
        }
    }
    Some(Way::Area { area: cross.length(), normal })
}

fn disk_way((centre, normal, radius): (DVec3, DVec3, f64), site: &Site, both: bool) -> Option<Way> {
    let height = height(centre, normal, site, both)?;
    let way = centre - site.point.position.as_dvec3();
    // Further away than its radius, light by area has less noise than misses of the square make.
    let beyond_rim = (way - way.dot(normal) * normal).length() - radius;
    if height.hypot(beyond_rim.max(0.0)) < radius {
        let (x, y) = normal.any_orthonormal_pair();
        let corner = way - radius * x - radius * y;
        let edges = (2.0 * radius * x, 2.0 * radius * y);
        let (solid, frame) = solid(corner, edges, normal, height);
        if solid.solid_angle > LEAST {
            return Some(Way::Disk(solid, frame));
        }
    }
    Some(Way::Area { area: PI * radius * radius, normal })
}

fn sphere_way(centre: DVec3, radius: f64, site: &Site, both: bool) -> Option<Way> {
    let way = centre - site.point.position.as_dvec3();
    let distance = way.length();
    // On the sphere itself, the side that asks tells.
    let on = (distance - radius).abs() <= site.point.error.as_dvec3().length();
    let inside = match site.normal {
        normal if on && normal != glam::Vec3::ZERO => way.dot(normal.as_dvec3()) > 0.0,
        _ => distance < radius,
    };
    if inside {
        return both.then_some(Way::Inside);
    }
    if on {
        return None;
    }
    let sin_2 = (radius / distance).powi(2);
    let cos_2 = (distance - radius) * (distance + radius) / (distance * distance);
    // 1 - cos, for small angles too.
    let lack = sin_2 / (1.0 + cos_2.sqrt());
    Some(Way::Cone { towards: way / distance, sin_2, lack })
}

/// A rectangle by the way to its corner and by its edges, and its frame.
fn solid(
    corner: DVec3,
    (u, v): (DVec3, DVec3),
    normal: DVec3,
    height: f64,
) -> (SolidRectangle, [DVec3; 3]) {
    let x = u.normalize();
    // Square to it even where the edges are not, by rounding.
    let up = normal.cross(x);
    // Away from the surface.
    let z = if height < 0.0 { -normal } else { normal };
    let (left, low) = (corner.dot(x), corner.dot(up));
    let rectangle =
        SolidRectangle::new([left, left + u.length()], [low, low + v.dot(up)], height.abs());
    (rectangle, [x, up, z])
}

/// Corner and edges of two triangles, if they are a rectangle.
fn rectangle([first, second]: [Primitive; 2], geometry: &Geometry) -> Option<[DVec3; 3]> {
    let (Form::Triangle([a, b, c]), Form::Triangle([a_too, c_too, d])) =
        (geometry.form(first), geometry.form(second))
    else {
        return None;
    };
    let (u, v) = (b - a, d - a);
    let (long, wide) = (u.length(), v.length());
    let fits = (c - (b + v)).length() <= SQUARE * long.min(wide);
    let square = u.dot(v).abs() <= SQUARE * long * wide;
    (a == a_too && c == c_too && fits && square).then_some([a, u, v])
}

/// Whether directions to corners, each to the next, differ by much.
fn is_wide<const N: usize>(towards: [DVec3; N]) -> bool {
    towards.windows(2).any(|pair| (pair[1] - pair[0]).length_squared() > NARROW)
}

/// Weights of the second and third corner of a triangle at a point of its plane.
fn weights([a, b, c]: [DVec3; 3], normal: DVec3, point: DVec3) -> DVec2 {
    let p = point - a;
    DVec2::new(p.cross(c - a).dot(normal), (b - a).cross(p).dot(normal)) / normal.length_squared()
}

/// The nearest weights of a point that rounding has put beyond an edge.
fn within(weights: DVec2) -> DVec2 {
    let weights = weights.max(DVec2::ZERO);
    weights / weights.element_sum().max(1.0)
}

/// The density of a direction of what surrounds a site: for a surface by the cosine, else uniform.
fn around(site: &Site, wi: DVec3) -> f64 {
    match site.normal {
        glam::Vec3::ZERO => 0.25 / PI,
        normal => normal.as_dvec3().dot(wi).max(0.0) / PI,
    }
}
