//! The shapes themselves, in plain arrays: what prepare pushes and the tree is built over.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec2, Vec3};

use super::Bounds;
use super::coordinates::Coordinates;
use super::instance::{Instance, Instances};
use super::{disk, sphere, triangle};
use crate::math::Mesh;

/// Whose a shape is: numbers that prepare gave out and hits carry back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Owner {
    /// Number of the object in the scene.
    pub object: u32,
    /// Number of the material in the world.
    pub material: u32,
}

/// A triangle over pushed vertices. Its front is where its corners go counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Indices of the corners.
    pub corners: [u32; 3],
    /// Indices of the shading normals at the corners, if there are any.
    pub normals: Option<[u32; 3]>,
    /// Whose it is.
    pub owner: Owner,
}

/// A sphere. Its front is outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// World units.
    pub centre: Vec3,
    /// World units, positive.
    pub radius: f32,
    /// Whose it is.
    pub owner: Owner,
}

/// A flat round disk. Its front is where its normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// World units.
    pub centre: Vec3,
    /// About unit length; defines the plane exactly as it is, rounding and all.
    pub normal: Vec3,
    /// World units, positive.
    pub radius: f32,
    /// Whose it is.
    pub owner: Owner,
}

/// A plane without end. Its front is where its normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of it, world units; best one near the scene.
    pub point: Vec3,
    /// About unit length; defines the plane exactly as it is, rounding and all.
    pub normal: Vec3,
    /// Whose it is.
    pub owner: Owner,
}

/// Names one primitive of a scene: its kind, and its number among those of its kind.
/// Ordered: triangles, spheres, disks, planes; each in the order they were pushed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Primitive(u32);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Triangle,
    Sphere,
    Disk,
    Plane,
}

/// The two highest bits of a [`Primitive`] are its kind.
const KIND_SHIFT: u32 = 30;

impl Primitive {
    pub(super) fn new(kind: Kind, index: usize) -> Self {
        assert!(index < Shapes::MOST, "prepare counts its shapes");
        Self((kind as u32) << KIND_SHIFT | index as u32)
    }

    /// As a number; the inverse of `from_bits`.
    #[inline]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline]
    pub(super) fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    #[inline]
    pub(super) fn kind(self) -> Kind {
        match self.0 >> KIND_SHIFT {
            0 => Kind::Triangle,
            1 => Kind::Sphere,
            2 => Kind::Disk,
            _ => Kind::Plane,
        }
    }

    #[inline]
    pub(super) fn index(self) -> usize {
        (self.0 & ((1 << KIND_SHIFT) - 1)) as usize
    }
}

/// Stands for the normals of a triangle that has none.
const NO_NORMALS: [u32; 3] = [u32::MAX; 3];

/// Collects the shapes of a scene. Coordinates must be finite; indices must have been given out.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    vertices: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// One for each triangle; empty as long as none has any, unless they are to be kept.
    triangle_normals: Vec<[u32; 3]>,
    keeps_normals: bool,
    pub(super) triangle_owners: Vec<Owner>,
    pub(super) spheres: Vec<Sphere>,
    pub(super) disks: Vec<Disk>,
    pub(super) planes: Vec<Plane>,
    pub(super) coordinates: Coordinates,
    pub(super) instances: Instances,
}

impl Shapes {
    /// The most shapes of one kind, and the most vertices or normals.
    pub const MOST: usize = 1 << KIND_SHIFT;

    /// Nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same, with room for normals in every triangle, whether any has some or not.
    pub fn keeping_normals(self) -> Self {
        Self { keeps_normals: true, ..self }
    }

    /// Makes room for so many vertices, normals and triangles, and no more than that.
    pub fn reserve(&mut self, vertices: usize, normals: usize, triangles: usize) {
        self.vertices.reserve_exact(vertices);
        self.normals.reserve_exact(normals);
        self.triangles.reserve_exact(triangles);
        self.triangle_owners.reserve_exact(triangles);
        if self.keeps_normals {
            self.triangle_normals.reserve_exact(triangles);
        }
    }

    /// Adds a vertex position, world units, and gives its index.
    pub fn vertex(&mut self, position: Vec3) -> u32 {
        assert!(self.vertices.len() < Self::MOST, "prepare counts its vertices");
        self.vertices.push(position);
        self.vertices.len() as u32 - 1
    }

    /// Adds a shading normal, about unit length (zero means none), and gives its index.
    pub fn normal(&mut self, normal: Vec3) -> u32 {
        assert!(self.normals.len() < Self::MOST, "prepare counts its normals");
        self.normals.push(normal);
        self.normals.len() as u32 - 1
    }

    /// Adds a triangle over vertices and normals added before.
    pub fn triangle(&mut self, triangle: Triangle) -> Primitive {
        let within = |indices: [u32; 3], length| indices.iter().all(|i| (*i as usize) < length);
        assert!(within(triangle.corners, self.vertices.len()), "a vertex is pushed before its use");
        let normals = triangle.normals;
        assert!(
            normals.is_none_or(|n| within(n, self.normals.len())),
            "a normal is pushed before its use"
        );
        if normals.is_some() && !self.keeps_normals {
            self.keeps_normals = true;
            self.triangle_normals = vec![NO_NORMALS; self.triangles.len()];
        }
        self.triangles.push(triangle.corners);
        if self.keeps_normals {
            self.triangle_normals.push(normals.unwrap_or(NO_NORMALS));
        }
        self.triangle_owners.push(triangle.owner);
        Primitive::new(Kind::Triangle, self.triangles.len() - 1)
    }

    /// Adds a flat four-sided face as two triangles that share the edge from its first corner to
    /// its third. Corners go counter-clockwise seen from the front.
    pub fn quad(&mut self, corners: [u32; 4], owner: Owner) -> [Primitive; 2] {
        let [a, b, c, d] = corners;
        [[a, b, c], [a, c, d]]
            .map(|corners| self.triangle(Triangle { corners, normals: None, owner }))
    }

    /// Adds a sphere.
    pub fn sphere(&mut self, sphere: Sphere) -> Primitive {
        self.spheres.push(sphere);
        Primitive::new(Kind::Sphere, self.spheres.len() - 1)
    }

    /// Adds a disk.
    pub fn disk(&mut self, disk: Disk) -> Primitive {
        self.disks.push(disk);
        Primitive::new(Kind::Disk, self.disks.len() - 1)
    }

    /// Adds an infinite plane.
    pub fn plane(&mut self, plane: Plane) -> Primitive {
        self.planes.push(plane);
        Primitive::new(Kind::Plane, self.planes.len() - 1)
    }

    /// Adds a mesh that instances may be of, and gives its number.
    pub fn mesh(&mut self, mesh: Arc<Mesh>) -> u32 {
        self.instances.meshes.push(mesh);
        self.instances.meshes.len() as u32 - 1
    }

    /// Puts a mesh that was added before somewhere.
    pub fn instance(&mut self, instance: Instance) {
        assert!((instance.mesh as usize) < self.instances.meshes.len(), "a mesh comes first");
        assert!(self.instances.all.len() < Self::MOST, "prepare counts its instances");
        self.instances.all.push(instance);
    }

    /// Adds texture coordinates of a corner, and gives their index.
    pub fn coordinate(&mut self, uv: Vec2) -> u32 {
        self.coordinates.corner(uv)
    }

    /// Gives a triangle the texture coordinates of its corners, by index. Triangles get theirs in the
    /// order in which they were pushed.
    pub fn lay(&mut self, triangle: Primitive, corners: [u32; 3]) {
        self.coordinates.lay(triangle, corners);
    }

    /// Gives a sphere, disk or plane its chart: the map from world space to the unit sphere with
    /// its poles on y and the middle of textures at z, or to texture coordinates as x and y.
    pub fn chart(&mut self, primitive: Primitive, chart: DAffine3) {
        self.coordinates.chart(primitive, chart);
    }

    /// All vertex positions.
    pub(super) fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// Corner positions of a triangle.
    #[inline]
    pub(super) fn corners(&self, triangle: usize) -> [Vec3; 3] {
        let [a, b, c] = self.triangles[triangle];
        [self.vertices[a as usize], self.vertices[b as usize], self.vertices[c as usize]]
    }

    /// The same in f64.
    #[inline]
    pub(super) fn exact_corners(&self, triangle: usize) -> [DVec3; 3] {
        let [a, b, c] = self.corners(triangle);
        [a.as_dvec3(), b.as_dvec3(), c.as_dvec3()]
    }

    /// Shading normals at a triangle's corners.
    #[inline(always)]
    pub(super) fn corner_normals(&self, triangle: usize) -> Option<[&Vec3; 3]> {
        let indices @ [a, b, c] = *self.triangle_normals.get(triangle)?;
        if indices == NO_NORMALS {
            return None;
        }
        Some([&self.normals[a as usize], &self.normals[b as usize], &self.normals[c as usize]])
    }

    /// Every primitive, in order.
    pub fn primitives(&self) -> impl Iterator<Item = Primitive> + '_ {
        let all = |kind, count| (0..count).map(move |index| Primitive::new(kind, index));
        all(Kind::Triangle, self.triangles.len())
            .chain(all(Kind::Sphere, self.spheres.len()))
            .chain(all(Kind::Disk, self.disks.len()))
            .chain(all(Kind::Plane, self.planes.len()))
    }

    /// Whose a primitive is.
    pub fn owner(&self, primitive: Primitive) -> Owner {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => self.triangle_owners[index],
            Kind::Sphere => self.spheres[index].owner,
            Kind::Disk => self.disks[index].owner,
            Kind::Plane => self.planes[index].owner,
        }
    }

    /// The box around a primitive; none for a plane.
    pub(super) fn bounds_of(&self, primitive: Primitive) -> Option<Bounds> {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Triangle => Some(triangle::bounds(self.corners(index))),
            Kind::Sphere => Some(sphere::bounds(&self.spheres[index])),
            Kind::Disk => Some(disk::bounds(&self.disks[index])),
            Kind::Plane => None,
        }
    }

    /// The box around everything bounded.
    pub(super) fn bounds(&self) -> Bounds {
        let boxes = self.primitives().filter_map(|p| self.bounds_of(p));
        boxes.fold(self.instances.bounds(), Bounds::union)
    }

    /// Memory held, in bytes.
    pub(super) fn bytes(&self) -> usize {
        fn of<T>(all: &Vec<T>) -> usize {
            all.capacity() * size_of::<T>()
        }
        of(&self.vertices)
            + of(&self.normals)
            + of(&self.triangles)
            + of(&self.triangle_normals)
            + of(&self.triangle_owners)
            + of(&self.spheres)
            + of(&self.disks)
            + of(&self.planes)
            + self.coordinates.bytes()
    }
}
