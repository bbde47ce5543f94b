//! What stands in a scene made by hand.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{DVec3, dvec3};
use scn::load::StagedMesh;
use scn::math::{Mesh, Reach, Spectrum};
use scn::scene::{self, Named, Place, Step};

use super::{Hand, at, diffuse};

impl Hand {
    /// A parallelogram about its centre, with half its edges.
    pub fn quad(self, centre: DVec3, u: DVec3, v: DVec3, material: &str) -> Self {
        self.object(scene::Object::Quad(scene::Quad {
            corner: at(scene::Point(centre - u - v)),
            u: at(scene::Point(2.0 * u)),
            v: at(scene::Point(2.0 * v)),
            material: at(scene::Ref::new(material)),
            place: at(Place::default()),
            yields_to: at(None),
        }))
    }

    pub fn triangle(self, [a, b, c]: [DVec3; 3], material: &str) -> Self {
        self.object(scene::Object::Triangle(scene::Triangle {
            a: at(scene::Point(a)),
            b: at(scene::Point(b)),
            c: at(scene::Point(c)),
            material: at(scene::Ref::new(material)),
            place: at(Place::default()),
            yields_to: at(None),
        }))
    }

    pub fn sphere(self, centre: DVec3, radius: f64, material: &str) -> Self {
        self.object(scene::Object::Sphere(scene::Sphere {
            center: at(scene::Point(centre)),
            radius: at(scene::Length(radius)),
            material: at(scene::Ref::new(material)),
            place: at(Place::default()),
            yields_to: at(None),
        }))
    }

    pub fn disk(self, centre: DVec3, normal: DVec3, radius: f64, material: &str) -> Self {
        self.object(scene::Object::Disk(scene::Disk {
            center: at(scene::Point(centre)),
            normal: at(scene::Direction(normal.normalize())),
            radius: at(scene::Length(radius)),
            material: at(scene::Ref::new(material)),
            place: at(Place::default()),
            yields_to: at(None),
        }))
    }

    pub fn plane(self, point: DVec3, normal: DVec3, material: &str) -> Self {
        self.object(scene::Object::Plane(scene::Plane {
            point: at(scene::Point(point)),
            normal: at(scene::Direction(normal.normalize())),
            material: at(scene::Ref::new(material)),
            tile: at(scene::Length(1.0)),
            place: at(Place::default()),
            yields_to: at(None),
        }))
    }

    /// A mesh with one diffuse material of its own.
    pub fn mesh(mut self, mesh: Mesh, unit: f64, albedo: f64) -> Self {
        let name = format!("mesh{}", self.meshes.len());
        let materials = vec![diffuse(&name, Spectrum::Constant(albedo), 0.0)];
        self = self.object(scene::Object::Mesh(scene::Mesh {
            file: at(scene::FileName { text: "by hand".into(), path: PathBuf::from("by hand") }),
            unit: at(scene::Length(unit)),
            mtl: at(None),
            material: at(None),
            materials: at(Vec::new()),
            ambient: at(None),
            place: at(Place::default()),
            mend: at(scene::Length(0.0)),
            yields_to: at(None),
        }));
        let (reach, mesh) = (Arc::new(Reach::of(&mesh)), Arc::new(mesh));
        *self.meshes.last_mut().unwrap() = Some(StagedMesh { mesh, reach, materials });
        self
    }

    fn object(mut self, object: scene::Object) -> Self {
        let name = at(format!("object{:03}", self.meshes.len()));
        self.scene.objects.push(Named { name, value: at(object) });
        self.meshes.push(None);
        self
    }

    /// Places the last object by one more step.
    pub fn placed(mut self, step: Step) -> Self {
        let object = &mut self.scene.objects.last_mut().unwrap().value.value;
        let place = match object {
            scene::Object::Disk(it) => &mut it.place,
            scene::Object::Mesh(it) => &mut it.place,
            scene::Object::Plane(it) => &mut it.place,
            scene::Object::Quad(it) => &mut it.place,
            scene::Object::Sphere(it) => &mut it.place,
            scene::Object::Triangle(it) => &mut it.place,
        };
        place.value.0.push(step);
        self
    }
}

/// A bumpy ball of 2 · 4ⁿ · 4 triangles or so with smooth normals, about the origin.
pub fn bumpy_ball(rings: usize) -> Mesh {
    let mut mesh = Mesh { material_names: vec!["clay".into()], ..Mesh::default() };
    let around = 2 * rings;
    let point = |i: usize, j: usize| {
        let (a, b) = (
            std::f64::consts::PI * i as f64 / rings as f64,
            std::f64::consts::TAU * (j % around) as f64 / around as f64,
        );
        let sphere = dvec3(a.sin() * b.cos(), a.cos(), a.sin() * b.sin());
        sphere * (1.0 + 0.1 * (5.0 * a).sin() * (3.0 * b).sin())
    };
    for i in 0..=rings {
        for j in 0..around {
            mesh.positions.push(point(i, j));
            mesh.normals.push(point(i, j).normalize());
        }
    }
    let index = |i: usize, j: usize| (i * around + j % around) as u32;
    for i in 0..rings {
        for j in 0..around {
            let (a, b, c, d) = (index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j));
            if i > 0 {
                mesh.triangles.push([a, b, c]);
            }
            if i + 1 < rings {
                mesh.triangles.push([a, c, d]);
            }
        }
    }
    mesh.normal_indices = mesh.triangles.clone();
    mesh.slots = vec![0; mesh.triangles.len()];
    mesh
}
