//! All instances, a tree over them, and the way of a ray through it: from the world into the space of
//! a template, and back for every triangle that it may meet there.
//!
//! In a template's space the ray keeps its line: its parameter s is (t − `start`) · `pace`, and begins
//! shortly before the template, so that f32 is spent there. Boxes are widened by how far corners and
//! ray are off, blocks of triangles likewise; whatever may be met is mapped to the world and asked
//! there.

use glam::Vec3A;

use super::best::{Meeting, Place};
use super::block::Block;
use super::instance::{Instances, Standing};
use super::lanes::{LANES, Lanes};
use super::node::Node;
use super::ray::{Probe, Sheet, Surface};
use super::shapes::{Kind, Primitive, Shapes};
use super::template::Template;
use super::tree::Tree;
use super::walk::{Ends, Slabs, descend};
use super::{Bounds, Hit, Ray};

/// Instances, ready to be met.
#[derive(Default)]
pub(super) struct Crowd {
    templates: Vec<Template>,
    all: Vec<Standing>,
    /// Over `all`, by number.
    nodes: Vec<Node>,
}

impl Crowd {
    pub fn build(instances: &Instances) -> Self {
        let templates: Vec<_> = instances.meshes.iter().map(Template::new).collect();
        let all = instances.all.iter();
        let all = all.map(|one| Standing::new(one, &templates[one.mesh as usize])).collect();
        let boxes: Vec<Bounds> = instances.all.iter().map(|one| one.bounds).collect();
        Self { templates, all, nodes: Tree::over(&boxes) }
    }

    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// What the same would take as copies, in bytes.
    pub fn bytes_of_copies(&self) -> usize {
        let of = |one: &Standing| self.templates[one.template as usize].bytes_of_copy();
        self.all.iter().map(of).sum()
    }

    /// Memory held, in bytes; the meshes are part of it.
    pub fn bytes(&self) -> usize {
        self.templates.iter().map(Template::bytes).sum::<usize>()
            + self.all.iter().map(Standing::bytes).sum::<usize>()
            + self.nodes.capacity() * size_of::<Node>()
    }

    /// The first meeting of the ray, where `other` is the first that is no instance's, of `shapes`.
    #[inline(always)]
    pub fn first<L: Lanes>(
        &self,
        lanes: L,
        ray: &Ray,
        shapes: &Shapes,
        other: Option<Meeting>,
    ) -> Option<Meeting> {
        let Some(probe) = Probe::new(lanes, ray, true) else { return other };
        let rank = other.as_ref().map_or(0, |meeting| match meeting.primitive.kind() {
            Kind::Triangle => u64::from(shapes.owner(meeting.primitive).object) << 32,
            _ => u64::MAX,
        });
        let t = other.as_ref().map_or(ray.t_max, |meeting| meeting.t);
        let first = self.meet::<L, false>(lanes, &probe, First { t, rank, met: None });
        let Some((number, triangle)) = first.met else { return other };
        let primitive = Primitive::new(Kind::Triangle, triangle as usize);
        Some(Meeting { t: first.t, primitive, place: Place::Instance(number) })
    }

    /// Everything about a meeting with an instance, of a number. Without `coordinates`, there are
    /// weights of corners in their place.
    #[inline(never)]
    pub fn hit<L: Lanes>(
        &self,
        lanes: L,
        probe: &Probe,
        (number, meeting): (u32, &Meeting),
        coordinates: bool,
    ) -> Hit {
        let Meeting { t, primitive, .. } = *meeting;
        let triangle = primitive.index() as u32;
        let standing = &self.all[number as usize];
        let mesh = &*self.templates[standing.template as usize].mesh;
        let normals = standing.normals(mesh, triangle);
        let face = standing.face(mesh, triangle);
        let (Surface { point, ns, uv }, _) = face.surface(lanes, probe, normals);
        let weights = uv.as_dvec2();
        let laid = if coordinates {
            standing.coordinates(mesh, triangle, weights.to_array())
        } else {
            None
        };
        let owner = standing.owner(mesh, triangle);
        Hit {
            t,
            position: point.position,
            error: point.error,
            ng: point.ng,
            ns,
            uv: laid.unwrap_or(weights),
            primitive,
            sheet: Sheet::NONE,
            object: owner.object,
            material: owner.material,
        }
    }

    /// Whether the ray meets any instance.
    #[inline(always)]
    pub fn occluded<L: Lanes>(&self, lanes: L, ray: &Ray) -> bool {
        let Some(probe) = Probe::new(lanes, ray, true) else { return false };
        let first = First { t: ray.t_max, rank: 0, met: None };
        self.meet::<L, true>(lanes, &probe, first).met.is_some()
    }

    #[inline(always)]
    fn meet<L: Lanes, const ANY: bool>(&self, lanes: L, probe: &Probe, first: First) -> First {
        let slabs = Slabs::new(lanes, probe);
        let mut outside = Outside::<L, ANY> { crowd: self, probe, slabs, first };
        descend::<L, ANY, _>(lanes, &self.nodes, &mut outside);
        outside.first
    }
}

/// The first meeting so far.
struct First {
    t: f32,
    /// Of two meetings at the same t that of the least rank is the first.
    rank: u64,
    /// The number of the instance, and that of the triangle.
    met: Option<(u32, u32)>,
}

/// A ray among instances.
struct Outside<'a, L: Lanes, const ANY: bool> {
    crowd: &'a Crowd,
    probe: &'a Probe,
    slabs: Slabs<L>,
    first: First,
}

impl<L: Lanes, const ANY: bool> Ends<L> for Outside<'_, L, ANY> {
    #[inline(always)]
    fn slabs(&self) -> &Slabs<L> {
        &self.slabs
    }

    #[inline(always)]
    fn blocks(&self) -> &[Block] {
        &[]
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.first.t
    }

    #[inline(always)]
    fn block(&mut self, _: L, _: usize, _: f32) -> bool {
        false
    }

    #[inline(always)]
    fn round(&mut self, lanes: L, primitive: Primitive) -> bool {
        let number = primitive.index();
        let standing = &self.crowd.all[number];
        let template = &self.crowd.templates[standing.template as usize];
        let Some(inner) = Inner::new(lanes, standing, self.probe) else { return false };
        let mut inside = Inside::<L, ANY> {
            slabs: Slabs::within(lanes, &inner.probe, inner.off),
            number: number as u32,
            standing,
            template,
            limit: inner.limit(self.first.t),
            inner,
            probe: self.probe,
            first: &mut self.first,
        };
        descend::<L, ANY, _>(lanes, &template.nodes, &mut inside);
        ANY && self.first.met.is_some()
    }
}

/// A ray in the space of a template.
struct Inner {
    probe: Probe,
    /// World parameter where it begins, and its own parameter per unit of the world's.
    start: f64,
    pace: f64,
    /// How far boxes and ray are off, along each axis; and how far corners and its line.
    off: Vec3A,
    corners_off: f32,
}

/// More than from the middle of a template to its corners.
const AROUND: f64 = 2.0;

/// What the rounding of a ray to f32 moves its points by, on its way through a template, in parts of
/// the template's size: for boxes, and for blocks, whose own bound doubles it; and what f64 loses on
/// the way of the origin.
const RAY_ERROR: f64 = 8.0 * f32::EPSILON as f64;
const LINE_ERROR: f64 = 4.0 * f32::EPSILON as f64;
const ORIGIN_ERROR: f64 = 64.0 * f64::EPSILON;

impl Inner {
    /// None: it passes the template.
    #[inline(always)]
    fn new<L: Lanes>(lanes: L, standing: &Standing, probe: &Probe) -> Option<Self> {
        let origin = standing.back * (probe.origin() - standing.origin);
        let direction = standing.back * probe.direction();
        let pace = direction.length();
        let direction = direction / pace;
        let way = -origin.dot(direction);
        let far =
            origin.abs().max_element().max((standing.back * standing.origin).abs().max_element());
        let loose = ORIGIN_ERROR * far;
        let around = AROUND + standing.off.max_element() + loose;
        let nearest = origin + way * direction;
        if nearest.length_squared() > around * around {
            return None;
        }
        let begin = (way - around).max(0.0);
        let origin = origin + begin * direction;
        let corners = standing.off_f32() + Vec3A::splat((LINE_ERROR * around + loose) as f32);
        let off = corners + Vec3A::splat((RAY_ERROR * around) as f32);
        let corners_off = corners.max_element();
        Some(Self {
            probe: Probe::rounded(lanes, origin, direction)?,
            start: begin / pace,
            pace,
            off,
            corners_off,
        })
    }

    /// The own parameter of a parameter in the world, or more.
    #[inline(always)]
    fn limit(&self, t: f32) -> f32 {
        const UP: f64 = 1.0 + 2.0 * f32::EPSILON as f64;
        let begin = (f64::from(t) * UP - self.start) * self.pace;
        (begin.max(0.0) * UP) as f32 + LEAST_LIMIT
    }
}

/// Keeps what lies where a ray in a template's space begins.
const LEAST_LIMIT: f32 = 1.0 / (1 << 20) as f32;

/// A ray among the triangles of a template.
struct Inside<'a, L: Lanes, const ANY: bool> {
    number: u32,
    standing: &'a Standing,
    template: &'a Template,
    inner: Inner,
    limit: f32,
    slabs: Slabs<L>,
    /// The ray in the world.
    probe: &'a Probe,
    first: &'a mut First,
}

impl<L: Lanes, const ANY: bool> Ends<L> for Inside<'_, L, ANY> {
    #[inline(always)]
    fn slabs(&self) -> &Slabs<L> {
        &self.slabs
    }

    #[inline(always)]
    fn blocks(&self) -> &[Block] {
        &self.template.blocks
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn block(&mut self, lanes: L, number: usize, span: f32) -> bool {
        let block: &Block = &self.template.blocks[number];
        let probe = &self.inner.probe;
        let (mut possible, mut inside, mut between) = (block.all(), 0, None);
        if !probe.extreme {
            let seen = block.seen_within(lanes, probe, span, Some(self.inner.corners_off));
            possible = seen.possible;
            if possible == 0 {
                return false;
            }
            let bounded = seen.bounded(lanes, probe);
            let [least, most] = bounded.between;
            (inside, between) = (bounded.inside, Some([lanes.store(least), lanes.store(most)]));
        }
        while possible != 0 {
            let lane = (possible.trailing_zeros() as usize) % LANES;
            possible &= possible - 1;
            let inside = inside & (1 << lane) != 0;
            if inside
                && let Some([least, most]) = &between
                && (most[lane] < 0.0 || least[lane] > self.limit)
            {
                continue;
            }
            let triangle = block.primitive(lane).index() as u32;
            let face = self.standing.face(&self.template.mesh, triangle);
            let Some(t) = face.meet(lanes, self.probe, inside) else { continue };
            let rank = self.standing.rank(triangle);
            if t < self.first.t || (t == self.first.t && rank < self.first.rank) {
                *self.first = First { t, rank, met: Some((self.number, triangle)) };
                if ANY {
                    return true;
                }
                self.limit = self.inner.limit(t);
            }
        }
        false
    }

    #[inline(always)]
    fn round(&mut self, _: L, _: Primitive) -> bool {
        false
    }
}
