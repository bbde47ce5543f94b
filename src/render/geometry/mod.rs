//! What a ray can meet: triangles, spheres, disks and infinite planes, and where it meets them.
//!
//! The promise: a closed mesh loses no ray, a ray that leaves a surface never meets it again by
//! rounding, and an answer depends on the shapes alone, never on the order of the tree over them.
//! There is no epsilon in scene units anywhere: every tolerance follows from float arithmetic
//! (rounding.rs has the derivation).

mod ask;
#[cfg(target_arch = "x86_64")]
mod avx2;
mod balls;
mod best;
mod block;
mod build;
mod coordinates;
mod crowd;
mod disk;
mod doubts;
mod few;
mod fleet;
mod hits;
mod instance;
mod lanes;
mod leaf;
mod node;
mod packet;
mod pages;
mod plane;
mod plate;
mod ray;
mod rounding;
mod sample;
mod shapes;
mod sphere;
mod stream;
mod template;
mod tree;
mod triangle;
mod walk;
mod way;
mod wide;

#[cfg(test)]
mod tests;

use glam::Vec3;

pub use best::Meeting;
pub use instance::{Instance, Placement};
pub use ray::{Hit, Point, Ray, Sheet, between};
pub use sample::{Facet, Form};
pub use shapes::{Disk, Owner, Plane, Primitive, Shapes, Sphere, Triangle};

use ask::Walker;
use best::{Best, Place};
use crowd::Crowd;
use few::Few;
use lanes::{LANES, Lanes};
use ray::Probe;
use shapes::Kind;
use tree::Tree;

/// An axis-aligned box, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner of least coordinates; all +∞ if the box is empty.
    pub min: Vec3,
    /// The corner of greatest coordinates; all −∞ if the box is empty.
    pub max: Vec3,
}

impl Bounds {
    /// The box of nothing.
    pub const EMPTY: Self =
        Self { min: Vec3::splat(f32::INFINITY), max: Vec3::splat(f32::NEG_INFINITY) };

    /// Whether nothing is inside.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The smallest box around both.
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }
}

/// The shapes of a scene, ready to be met by rays.
pub struct Geometry {
    shapes: Shapes,
    tree: Tree,
    crowd: Crowd,
    /// The triangles once more, where they are few.
    few: Option<Few>,
    bounds: Bounds,
    /// Whether hits tell where on their surface they lie.
    coordinates: bool,
}

impl Geometry {
    /// Never fails: a shape without area is never met, and does no harm.
    pub fn build(mut shapes: Shapes) -> Self {
        shapes.coordinates.sort();
        let (tree, bounds) = (Tree::build(&shapes), shapes.bounds());
        let crowd = Crowd::build(&std::mem::take(&mut shapes.instances));
        let few = Few::of(&tree, &shapes, &crowd);
        Self { tree, crowd, few, bounds, shapes, coordinates: true }
    }

    /// The same, with `Hit::uv` or with zero in its place, weights of corners in a triangle's.
    pub fn with_coordinates(self, coordinates: bool) -> Self {
        Self { coordinates, ..self }
    }

    /// The same, or one whose rays are met by instructions that every processor has. Their answers
    /// are the same, to the bit.
    pub fn with_portable(mut self, portable: bool) -> Self {
        self.tree.walker = if portable { Walker::PORTABLE } else { Walker::found() };
        self
    }

    /// The first surface the ray meets at t in (0, `t_max`). At equal t the least primitive.
    #[inline]
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        match self.crowd.is_empty() {
            true => self.tree.walker.closest(self, ray),
            false => self.meet(ray).map(|meeting| self.hit(ray, &meeting)),
        }
    }

    /// Which surface is the [`Self::closest`], and where.
    #[inline]
    pub fn meet(&self, ray: &Ray) -> Option<Meeting> {
        let met = self.tree.walker.meet(self, ray);
        if self.crowd.is_empty() { met } else { self.tree.walker.meet_crowd(self, ray, met) }
    }

    /// Everything about a meeting of the same ray.
    #[inline]
    pub fn hit(&self, ray: &Ray, meeting: &Meeting) -> Hit {
        self.tree.walker.hit(self, ray, meeting)
    }

    /// Whether the ray meets any surface at t in (0, `t_max`).
    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        let walker = self.tree.walker;
        walker.occluded(self, ray) || !self.crowd.is_empty() && walker.occluded_by_crowd(self, ray)
    }

    /// The box around everything bounded; infinite planes don't count.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        let few = self.few.as_ref().map_or(0, Few::bytes);
        self.shapes.bytes() + self.tree.bytes() + self.crowd.bytes() + few
    }

    /// The part of it that instances and their meshes hold; and what they would hold as copies.
    pub fn bytes_of_instances(&self) -> [usize; 2] {
        [self.crowd.bytes(), self.crowd.bytes_of_copies()]
    }

    /// The shapes it was built from.
    pub fn shapes(&self) -> &Shapes {
        &self.shapes
    }

    /// Planes have no box: each ray asks them all.
    #[inline(always)]
    fn meet_planes(&self, probe: &Probe, best: &mut Best) {
        if !self.shapes.planes.is_empty() {
            self.meet_all_planes(probe, best);
        }
    }

    #[inline(never)]
    fn meet_all_planes(&self, probe: &Probe, best: &mut Best) {
        for (index, plane) in self.shapes.planes.iter().enumerate() {
            if let Some(t) = plane::meet(probe, plane) {
                best.offer(t, Primitive::new(Kind::Plane, index));
            }
        }
    }

    /// Everything about a meeting; of a triangle of the tree, the parameter too.
    #[inline(always)]
    fn hit_of<L: Lanes>(&self, lanes: L, probe: &Probe, meeting: &Meeting) -> Hit {
        let Meeting { primitive, .. } = *meeting;
        let (surface, t, owner) = match meeting.place {
            Place::Tree(place) => {
                let (block, lane) = (place as usize / LANES, place as usize % LANES);
                let face = self.tree.blocks[block].face(lane);
                let normals = self.shapes.corner_normals(primitive.index());
                let normals = normals.map(|[a, b, c]| [*a, *b, *c]);
                let (surface, t) = face.surface(lanes, probe, normals);
                (surface, t, self.shapes.triangle_owners[primitive.index()])
            }
            Place::Instance(number) => {
                return self.crowd.hit(lanes, probe, (number, meeting), self.coordinates);
            }
            Place::Shapes => {
                (self.surface(probe, primitive), meeting.t, self.shapes.owner(primitive))
            }
        };
        let ray::Surface { point, ns, uv } = surface;
        let uv = match self.coordinates {
            true => self.shapes.coordinates.at(primitive, point.position, uv),
            false => uv.as_dvec2(),
        };
        Hit {
            t,
            position: point.position,
            error: point.error,
            ng: point.ng,
            ns,
            uv,
            primitive,
            sheet: Sheet::of(primitive),
            object: owner.object,
            material: owner.material,
        }
    }

    /// Where a ray meets a primitive that is no face of the tree's.
    #[inline(never)]
    fn surface(&self, probe: &Probe, primitive: Primitive) -> ray::Surface {
        let index = primitive.index();
        match primitive.kind() {
            Kind::Sphere => sphere::surface(probe, &self.shapes.spheres[index]),
            Kind::Disk => disk::surface(probe, &self.shapes.disks[index]),
            Kind::Plane => plane::surface(probe, &self.shapes.planes[index]),
            Kind::Triangle => unreachable!("triangles are faces"),
        }
    }
}
