//! Where the objects of a render are, in metres. What cannot be placed is told by `prepare`, and
//! left out here.

use glam::{DAffine3, DVec3};

use crate::load::{Stage, StagedMesh};
use crate::math::{Bounds, Mesh, Transform};
use crate::scene::{self, At, Material, Named, Object};

/// An object where it stands.
pub(super) struct Thing<'a> {
    /// As the author said it.
    pub object: &'a Named<Object>,
    /// Its surface.
    pub body: Body<'a>,
    /// Materials of its slots; all but meshes have one.
    pub materials: Vec<&'a Named<Material>>,
    /// What they are made of: parts of mixtures, and those that are none.
    pub parts: Vec<&'a Named<Material>>,
    /// The box around it; empty for a plane.
    bounds: Bounds,
}

/// A surface in metres; a mirrored one has its front where the mirror shows it.
pub(super) enum Body<'a> {
    /// Triangles of a mesh, and the map from its file to metres.
    Mesh { mesh: &'a Mesh, to_metres: Transform },
    /// A flat face of three or four corners, counter-clockwise seen from its front.
    Face { corners: Vec<DVec3> },
    /// A sphere.
    Sphere { centre: DVec3, radius: f64 },
    /// A disk; `normal` has unit length.
    Disk { centre: DVec3, normal: DVec3, radius: f64 },
    /// A plane without end; `normal` has unit length.
    Plane { point: DVec3, normal: DVec3 },
}

/// The objects of a stage that can be placed.
pub(super) fn things(stage: &Stage) -> Vec<Thing<'_>> {
    let scene = &*stage.scene;
    let placed = |(object, mesh)| thing(scene, object, mesh);
    scene.objects.iter().zip(stage.meshes.iter().map(Option::as_ref)).filter_map(placed).collect()
}

fn thing<'a>(
    scene: &'a scene::Scene,
    object: &'a Named<Object>,
    staged: Option<&'a StagedMesh>,
) -> Option<Thing<'a>> {
    let (place, material) = match &object.value.value {
        Object::Disk(it) => (&it.place, Some(&it.material)),
        Object::Mesh(it) => (&it.place, None),
        Object::Plane(it) => (&it.place, Some(&it.material)),
        Object::Quad(it) => (&it.place, Some(&it.material)),
        Object::Sphere(it) => (&it.place, Some(&it.material)),
        Object::Triangle(it) => (&it.place, Some(&it.material)),
    };
    let map = place.transform();
    let materials = match material {
        Some(material) => vec![scene.material(material)],
        None => staged?.materials.iter().collect(),
    };
    let parts = materials.iter().flat_map(|material| scene.parts(material));
    let parts = parts.map(|(_, part)| part).collect();
    let body = map.is_invertible().then(|| body(&object.value, staged, map))??;
    let bounds = body.bounds();
    let thing = Thing { object, body, materials, parts, bounds };
    thing.is_finite().then_some(thing)
}

fn body<'a>(
    object: &At<Object>,
    staged: Option<&'a StagedMesh>,
    map: Transform,
) -> Option<Body<'a>> {
    let front = |normal: DVec3| {
        let turned = map.normal(normal).normalize_or(normal);
        if map.mirrors() { -turned } else { turned }
    };
    let face = |mut corners: Vec<DVec3>| {
        corners.iter_mut().for_each(|corner| *corner = map.point(*corner));
        if map.mirrors() {
            corners.reverse();
        }
        Body::Face { corners }
    };
    Some(match &object.value {
        Object::Disk(it) => Body::Disk {
            centre: map.point(it.center.0),
            normal: front(it.normal.0),
            radius: map.uniform_scale()? * it.radius.0,
        },
        Object::Mesh(it) => {
            let unit = Transform(DAffine3::from_scale(DVec3::splat(it.unit.0)));
            Body::Mesh { mesh: &staged?.mesh, to_metres: unit.then(map) }
        }
        Object::Plane(it) => {
            Body::Plane { point: map.point(it.point.0), normal: front(it.normal.0) }
        }
        Object::Quad(it) => {
            let (corner, u, v) = (it.corner.0, it.u.0, it.v.0);
            face(vec![corner, corner + u, corner + u + v, corner + v])
        }
        Object::Sphere(it) => Body::Sphere {
            centre: map.point(it.center.0),
            radius: map.uniform_scale()? * it.radius.0,
        },
        Object::Triangle(it) => face(vec![it.a.0, it.b.0, it.c.0]),
    })
}

impl Body<'_> {
    /// The box around it; empty for a plane.
    fn bounds(&self) -> Bounds {
        match self {
            Body::Mesh { mesh, to_metres } => {
                let corners = mesh.triangles.iter().flatten();
                Bounds::around(corners.map(|i| to_metres.point(mesh.positions[*i as usize])))
            }
            Body::Face { corners } => Bounds::around(corners.iter().copied()),
            Body::Sphere { centre, radius } => {
                Bounds { min: *centre - *radius, max: *centre + *radius }
            }
            Body::Disk { centre, normal, radius } => {
                let reach =
                    *radius * (DVec3::ONE - *normal * *normal).max(DVec3::ZERO).map(f64::sqrt);
                Bounds { min: *centre - reach, max: *centre + reach }
            }
            Body::Plane { .. } => Bounds::EMPTY,
        }
    }
}

impl Thing<'_> {
    /// Whether some part of it shines on both of its sides.
    pub fn shines_both_ways(&self) -> bool {
        let glow = self.materials.iter().filter_map(|material| material.value.glow());
        glow.into_iter()
            .any(|(emission, sides)| !emission.0.is_zero() && sides.value == scene::Sides::Both)
    }

    /// Whether light goes through some part of it.
    pub fn transmits(&self) -> bool {
        self.parts.iter().any(|part| part.value.transmits())
    }

    /// Its name.
    pub fn name(&self) -> &At<String> {
        &self.object.name
    }

    /// The steps that place it.
    pub fn place(&self) -> &At<scene::Place> {
        match &self.object.value.value {
            Object::Disk(it) => &it.place,
            Object::Mesh(it) => &it.place,
            Object::Plane(it) => &it.place,
            Object::Quad(it) => &it.place,
            Object::Sphere(it) => &it.place,
            Object::Triangle(it) => &it.place,
        }
    }

    /// Whether any of its surface shines.
    pub fn shines(&self) -> bool {
        self.parts.iter().any(|part| shines(part))
    }

    /// The box around it; empty for a plane.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Whether its coordinates can be reckoned with.
    fn is_finite(&self) -> bool {
        // Their products of six stay far from the ends of f64.
        const MOST: f64 = 1e40;
        let near = |p: DVec3| p.is_finite() && p.abs().max_element() <= MOST;
        match &self.body {
            Body::Plane { point, .. } => near(*point),
            _ => {
                let bounds = self.bounds;
                near(bounds.min) && near(bounds.max) && bounds.size() >= 1.0 / MOST
            }
        }
    }
}

/// Whether a material shines of itself.
pub(super) fn shines(material: &Named<Material>) -> bool {
    material.value.shines()
}
