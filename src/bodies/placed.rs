//! Objects, placed in f64: where everything is, in metres.

use glam::{DAffine3, DVec2, DVec3};

use super::charts;
use super::errors::scene as errors;
use crate::diag::{Diagnostic, Span};
use crate::load::{Stage, StagedMesh};
use crate::math::{Bounds, Mesh, Transform};
use crate::scene::{self, At, Material, Named, Object};

/// An object where it stands.
pub struct Placed<'a> {
    /// Its number in the scene.
    pub number: u32,
    /// As the author said it.
    pub object: &'a Named<Object>,
    /// Its surface.
    pub body: Body<'a>,
    /// Materials of its slots; all but meshes have one.
    pub materials: Vec<&'a Named<Material>>,
    /// What each of them is made of, and the part of each.
    pub parts: Vec<Vec<(f64, &'a Named<Material>)>>,
    /// The box around it in metres; empty for a plane.
    bounds: Bounds,
}

/// A surface in metres. A mirrored one has its front where the mirror shows it.
pub enum Body<'a> {
    /// Triangles of a mesh.
    Mesh {
        /// In the units of its file.
        mesh: &'a Mesh,
        /// From there to metres.
        to_metres: Transform,
    },
    /// A flat face.
    Face {
        /// Three or four, counter-clockwise seen from the front.
        corners: Vec<DVec3>,
        /// Texture coordinates of each.
        coordinates: Vec<DVec2>,
    },
    /// A sphere.
    Sphere {
        /// Its centre.
        centre: DVec3,
        /// Its radius.
        radius: f64,
        /// From metres to where textures lie on it.
        chart: Transform,
    },
    /// A disk.
    Disk {
        /// Its centre.
        centre: DVec3,
        /// Unit length.
        normal: DVec3,
        /// Its radius.
        radius: f64,
        /// From metres to where textures lie on it.
        chart: Transform,
    },
    /// A plane without end.
    Plane {
        /// A point of it.
        point: DVec3,
        /// Unit length.
        normal: DVec3,
        /// From metres to where textures lie on it.
        chart: Transform,
    },
}

/// Coordinates and sizes in metres must lie below this, and sizes above its inverse: their
/// products of six stay far from the ends of f64.
const MOST: f64 = 1e40;

/// All objects of a stage that can be placed, in their order.
pub fn place<'a>(stage: &'a Stage, found: &mut Vec<Diagnostic>) -> Vec<Placed<'a>> {
    let scene = &*stage.scene;
    let mut all = Vec::new();
    for ((number, object), mesh) in scene.objects.iter().enumerate().zip(&stage.meshes) {
        let body = body(&object.name, &object.value, mesh.as_ref(), found);
        let Some(body) = body else { continue };
        let materials: Vec<&Named<Material>> = match (&object.value.value, mesh) {
            (Object::Mesh(_), Some(staged)) => staged.materials.iter().collect(),
            (other, _) => material(other).map(|m| scene.material(m)).into_iter().collect(),
        };
        let parts = materials.iter().map(|material| scene.parts(material)).collect();
        let bounds = body.bounds(mesh.as_ref());
        let placed = Placed { number: number as u32, object, body, materials, parts, bounds };
        if placed.is_within_numbers() {
            all.push(placed);
        } else {
            found.push(errors::beyond_numbers(&object.name, object.value.span));
        }
    }
    all
}

/// The one material of an object that is no mesh.
fn material(object: &Object) -> Option<&scene::Ref<Material>> {
    Some(match object {
        Object::Disk(disk) => &disk.material,
        Object::Mesh(_) => return None,
        Object::Plane(plane) => &plane.material,
        Object::Quad(quad) => &quad.material,
        Object::Sphere(sphere) => &sphere.material,
        Object::Triangle(triangle) => &triangle.material,
    })
}

fn body<'a>(
    name: &At<String>,
    object: &At<Object>,
    mesh: Option<&'a StagedMesh>,
    found: &mut Vec<Diagnostic>,
) -> Option<Body<'a>> {
    let mut placing = Placing { name, found };
    match &object.value {
        Object::Disk(disk) => {
            let (place, scale) = placing.evenly(&disk.place, "disk")?;
            Some(Body::Disk {
                centre: place.point(disk.center.0),
                normal: front(place, disk.normal.0),
                radius: scale * disk.radius.0,
                chart: charts::disk(place, disk),
            })
        }
        Object::Mesh(object) => {
            let place = placing.transform(&object.place)?;
            let unit = Transform(DAffine3::from_scale(DVec3::splat(object.unit.0)));
            Some(Body::Mesh { mesh: &mesh?.mesh, to_metres: unit.then(place) })
        }
        Object::Plane(plane) => {
            let place = placing.transform(&plane.place)?;
            let normal = front(place, plane.normal.0);
            let chart = charts::plane(place, plane);
            Some(Body::Plane { point: place.point(plane.point.0), normal, chart })
        }
        Object::Quad(quad) => {
            let place = placing.transform(&quad.place)?;
            let (corner, u, v) = (quad.corner.0, quad.u.0, quad.v.0);
            let spans = [quad.u.span, quad.v.span];
            placing.area(u, v, &spans, "its edges `u` and `v` point the same way")?;
            let corners = vec![corner, corner + u, corner + u + v, corner + v];
            placing.face(place, corners, vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y])
        }
        Object::Sphere(sphere) => {
            let (place, scale) = placing.evenly(&sphere.place, "sphere")?;
            let centre = place.point(sphere.center.0);
            let chart = charts::sphere(place, sphere);
            Some(Body::Sphere { centre, radius: scale * sphere.radius.0, chart })
        }
        Object::Triangle(triangle) => {
            let place = placing.transform(&triangle.place)?;
            let (a, b, c) = (triangle.a.0, triangle.b.0, triangle.c.0);
            let spans = [triangle.a.span, triangle.b.span, triangle.c.span];
            placing.area(b - a, c - a, &spans, "its corners lie on one line")?;
            placing.face(place, vec![a, b, c], vec![DVec2::ZERO, DVec2::X, DVec2::Y])
        }
    }
}

/// Where a front normal of unit length goes: still unit length, still on the front.
fn front(place: Transform, normal: DVec3) -> DVec3 {
    let turned = place.normal(normal).normalize_or(normal);
    if place.mirrors() { -turned } else { turned }
}

/// One object being placed, and what is wrong with it.
struct Placing<'a> {
    name: &'a At<String>,
    found: &'a mut Vec<Diagnostic>,
}

impl Placing<'_> {
    /// The steps as one map.
    fn transform(&mut self, place: &At<scene::Place>) -> Option<Transform> {
        let transform = place.transform();
        if transform.is_invertible() {
            return Some(transform);
        }
        // No factor is zero: their product was, or overflowed.
        self.found.push(errors::beyond_numbers(self.name, place.span));
        None
    }

    /// The steps as one map that keeps round things round, and its scale.
    fn evenly(&mut self, place: &At<scene::Place>, what: &str) -> Option<(Transform, f64)> {
        let transform = self.transform(place)?;
        let scale = transform.uniform_scale();
        if scale.is_none() {
            self.found.push(errors::uneven_scale(self.name, place.span, what));
        }
        Some((transform, scale?))
    }

    /// Refuses a face whose edges from one corner have no area between them, to within the
    /// rounding of their coordinates.
    fn area(&mut self, u: DVec3, v: DVec3, spans: &[Span], because: &str) -> Option<()> {
        let sine = u.normalize_or_zero().cross(v.normalize_or_zero()).length();
        if sine > 8.0 * f64::EPSILON {
            return Some(());
        }
        self.found.push(errors::no_area(self.name, spans, because));
        None
    }

    fn face<'b>(
        &self,
        place: Transform,
        corners: Vec<DVec3>,
        mut coordinates: Vec<DVec2>,
    ) -> Option<Body<'b>> {
        let mut corners: Vec<_> = corners.into_iter().map(|corner| place.point(corner)).collect();
        if place.mirrors() {
            corners.reverse();
            coordinates.reverse();
        }
        Some(Body::Face { corners, coordinates })
    }
}

impl Body<'_> {
    /// How many triangles it is.
    pub fn triangles(&self) -> usize {
        match self {
            Self::Mesh { mesh, .. } => mesh.triangles.len(),
            Self::Face { corners, .. } => corners.len() - 2,
            _ => 0,
        }
    }

    fn bounds(&self, staged: Option<&StagedMesh>) -> Bounds {
        match self {
            Body::Mesh { mesh, to_metres } => {
                staged.map_or(Bounds::EMPTY, |staged| staged.reach.bounds(mesh, *to_metres))
            }
            Body::Face { corners, .. } => Bounds::around(corners.iter().copied()),
            Body::Sphere { centre, radius, .. } => {
                Bounds { min: *centre - *radius, max: *centre + *radius }
            }
            Body::Disk { centre, normal, radius, .. } => {
                let reach =
                    *radius * (DVec3::ONE - *normal * *normal).max(DVec3::ZERO).map(f64::sqrt);
                Bounds { min: *centre - reach, max: *centre + reach }
            }
            Body::Plane { .. } => Bounds::EMPTY,
        }
    }
}

impl<'a> Placed<'a> {
    /// Its name.
    pub fn name(&self) -> &'a At<String> {
        &self.object.name
    }

    /// The steps that place it.
    pub fn place(&self) -> &'a At<scene::Place> {
        match &self.object.value.value {
            Object::Disk(it) => &it.place,
            Object::Mesh(it) => &it.place,
            Object::Plane(it) => &it.place,
            Object::Quad(it) => &it.place,
            Object::Sphere(it) => &it.place,
            Object::Triangle(it) => &it.place,
        }
    }

    /// What its materials are made of: parts of mixtures, and those that are none.
    pub fn all_parts(&self) -> impl Iterator<Item = &'a Named<Material>> {
        self.parts.iter().flatten().map(|(_, part)| *part)
    }

    /// Whether any of its surface shines.
    pub fn shines(&self) -> bool {
        self.all_parts().any(|part| part.value.shines())
    }

    /// Whether some part of it shines on both of its sides.
    pub fn shines_both_ways(&self) -> bool {
        let mut glow = self.materials.iter().filter_map(|material| material.value.glow());
        glow.any(|(emission, sides)| !emission.0.is_zero() && sides.value == scene::Sides::Both)
    }

    /// Whether light goes through some part of it.
    pub fn transmits(&self) -> bool {
        self.all_parts().any(|part| part.value.transmits())
    }

    /// Whether it has corners, and is not round or without end.
    pub(super) fn has_corners(&self) -> bool {
        matches!(self.body, Body::Mesh { .. } | Body::Face { .. })
    }

    /// The box around it in metres; empty for a plane.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn is_within_numbers(&self) -> bool {
        let near = |p: DVec3| p.abs().max_element() <= MOST;
        let size = |r: f64| (1.0 / MOST..=MOST).contains(&r);
        match &self.body {
            Body::Sphere { centre, radius, .. } | Body::Disk { centre, radius, .. } => {
                near(*centre) && size(*radius)
            }
            Body::Plane { point, .. } => near(*point),
            Body::Mesh { .. } | Body::Face { .. } => {
                let bounds = self.bounds;
                let extent = 2.0 * bounds.half().max_element();
                bounds.is_empty() || near(bounds.min) && near(bounds.max) && size(extent)
            }
        }
    }
}
