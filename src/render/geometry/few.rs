//! Scenes of a few triangles: all rays of a packet are asked about each triangle in turn, instead of
//! each ray going its own way through the tree.
//!
//! Where a leaf's box is missed by all, so are its triangles. Else f32 tells of each triangle which
//! rays certainly miss it, and which certainly meet it before whatever they met so far ([`Plate`]).
//! What remains is noted and decided in f64 at the end, by the same operations as for single rays.

use super::balls::Ball;
use super::best::{Meeting, Place};
use super::block::Block;
use super::crowd::Crowd;
use super::doubts::Doubts;
use super::lanes::{LANES, Portable};
use super::node::Below;
use super::packet::{NONE, Packet, parameter};
use super::plate::{Crossing, Plate};
use super::ray::{Probe, Ray};
use super::shapes::{Kind, Primitive, Shapes};
use super::tree::Tree;
use super::triangle::Face;
use super::wide::{MOST, Numbers, Row, Wide, ones};
use super::{Geometry, disk, plane};

/// More triangles than this are better met by way of the tree.
pub(super) const MOST_TRIANGLES: usize = 128;

/// More planes, spheres and disks likewise: each is met by one ray after the other.
const MOST_ROUND: usize = 4;

/// No triangle.
const NOTHING: u32 = u32::MAX;

/// All triangles of a scene that has few, and what else is in it.
#[derive(Default)]
pub(super) struct Few {
    leaves: Vec<Leaf>,
    plates: Vec<Plate>,
    exact: Vec<Exact>,
    balls: Vec<Ball>,
    /// Planes and disks.
    round: Vec<Primitive>,
    /// Whether there is nothing else: none of those, no instances.
    pub alone: bool,
}

/// A leaf of the tree: its box, and its plates.
struct Leaf {
    /// Axis, then lower and upper plane.
    planes: [[f32; 2]; 3],
    first: usize,
    end: usize,
}

/// What f64 wants of a triangle; the last stands for none.
struct Exact {
    normal: [f64; 3],
    corner: [f64; 3],
    primitive: Primitive,
    place: u32,
}

impl Few {
    /// Of a tree over shapes, if they are few and moderate.
    pub fn of(tree: &Tree, shapes: &Shapes, crowd: &Crowd) -> Option<Self> {
        let round = shapes.spheres.len() + shapes.disks.len() + shapes.planes.len();
        if tree.blocks.len() > MOST_TRIANGLES || round > MOST_ROUND || !tree.moderate {
            return None;
        }
        let mut few = Self::default();
        for node in &tree.nodes {
            for (lane, child) in node.children.iter().enumerate() {
                if let Below::Block(number) = child.below() {
                    let first = few.plates.len();
                    few.add(number, &tree.blocks[number]);
                    let planes = node.planes.map(|[lower, upper]| [lower[lane], upper[lane]]);
                    few.leaves.push(Leaf { planes, first, end: few.plates.len() });
                }
            }
        }
        few.exact.push(Exact {
            normal: [0.0; 3],
            corner: [0.0; 3],
            primitive: Primitive::new(Kind::Plane, 0),
            place: 0,
        });
        for primitive in shapes.primitives() {
            match primitive.kind() {
                Kind::Triangle => {}
                Kind::Sphere => {
                    let sphere = shapes.spheres[primitive.index()];
                    few.balls.push(Ball { sphere, primitive });
                }
                Kind::Disk | Kind::Plane => few.round.push(primitive),
            }
        }
        few.alone = few.round.is_empty() && crowd.is_empty();
        (few.plates.len() <= MOST_TRIANGLES).then_some(few)
    }

    /// Adds the triangles of a block, and those that are in one plane one after the other.
    fn add(&mut self, number: usize, block: &Block) {
        let mut first = self.plates.len();
        for lane in 0..LANES {
            let face = block.face(lane);
            if face.corners[0][0].is_nan() {
                continue;
            }
            let normal = face.exact_normal();
            self.plates.push(Plate::new(&face, normal.into(), block.primitive(lane)));
            self.exact.push(Exact {
                normal,
                corner: face.corners[0].map(f64::from),
                primitive: block.primitive(lane),
                place: super::best::place(number, lane) as u32,
            });
        }
        for nth in first + 1..self.plates.len() {
            let (before, rest) = self.plates.split_at_mut(nth);
            match rest.iter_mut().position(|plate| plate.join(&mut before[first])) {
                Some(other) => {
                    self.plates.swap(nth, nth + other);
                    self.exact.swap(nth, nth + other);
                }
                None => first = nth,
            }
        }
    }

    /// Memory held, in bytes.
    pub fn bytes(&self) -> usize {
        self.leaves.capacity() * size_of::<Leaf>()
            + self.plates.capacity() * size_of::<Plate>()
            + self.exact.capacity() * size_of::<Exact>()
            + self.balls.capacity() * size_of::<Ball>()
            + self.round.capacity() * size_of::<Primitive>()
    }
}

/// What the rays of a packet meet first.
pub(super) struct Found {
    pub t: Row,
    pub primitive: [u32; MOST],
    /// Of triangles where they are kept.
    pub place: [u32; MOST],
    /// A bit for each ray that meets something.
    pub met: u32,
    /// A bit for each ray that was asked: others are to be asked alone.
    pub asked: u32,
}

impl Found {
    /// Stands for the place of other shapes.
    pub const NO_PLACE: u32 = u32::MAX;

    #[inline(always)]
    pub fn meeting(&self, lane: usize) -> Option<Meeting> {
        let bit = lane % MOST;
        let primitive = Primitive::from_bits(self.primitive[bit]);
        let place = match self.place[bit] {
            Self::NO_PLACE => Place::Shapes,
            place => Place::Tree(place),
        };
        let meeting = Meeting { t: self.t.0[bit], primitive, place };
        (self.met & 1 << bit != 0).then_some(meeting)
    }
}

/// What the rays of a packet met first so far.
struct First {
    /// Bounds of the parameter.
    least: Row,
    most: Row,
    /// The number of a plate, as bits.
    plate: Row,
}

impl Few {
    /// What the rays of a packet meet first, the parameters exact.
    #[inline(always)]
    pub fn first<W: Wide>(
        &self,
        wide: W,
        geometry: &Geometry,
        packet: &Packet,
        doubts: &mut Doubts,
    ) -> Found {
        let (zero, tiny) = (wide.splat(0.0), wide.splat(f32::MIN_POSITIVE));
        let [leaves, _] = &packet.left_out;
        let mut least = wide.load(&packet.end);
        let mut most = least;
        let mut plate = wide.splat(f32::from_bits(NOTHING));
        doubts.count = 0;
        let mut crossing = Crossing::none(wide);
        for leaf in &self.leaves {
            if packet.enters(wide, &leaf.planes, most) == 0 {
                continue;
            }
            for (number, one) in (leaf.first..).zip(&self.plates[leaf.first..leaf.end]) {
                if !one.joins {
                    crossing = one.cross(wide, &packet.beam);
                }
                let Crossing { low, high, .. } = crossing;
                let known = one.meet(wide, &crossing);
                let beyond = wide.or(wide.less(most, low), wide.less(high, zero));
                let missed = wide.or(known.outside, beyond);
                let missed = wide.or(missed, wide.same(leaves, one.primitive));
                let ahead = wide.and(wide.less(tiny, low), wide.less(high, least));
                let met = wide.and(known.inside, ahead);
                least = wide.select(met, low, least);
                most = wide.select(met, high, most);
                plate = wide.select(met, wide.splat(f32::from_bits(number as u32)), plate);
                let open = !(wide.bits(missed) | wide.bits(met)) & packet.active;
                doubts.note(number, open, wide.bits(known.inside));
            }
        }
        let mut first = First { least: NONE, most: NONE, plate: NONE };
        wide.store(least, &mut first.least);
        wide.store(most, &mut first.most);
        wide.store(plate, &mut first.plate);
        for doubt in doubts.of() {
            let number = usize::from(doubt.plate);
            let Exact { normal, corner, primitive, .. } = self.exact[number];
            let mut rays = u32::from(doubt.rays) & !packet.leaves_out::<W>(primitive);
            if rays == 0 {
                continue;
            }
            let t = packet.parameters::<W>(normal, corner);
            let mut before = 0;
            for lane in 0..W::WIDTH {
                let first = (t.0[lane] >= 0.0) & (t.0[lane] <= first.most.0[lane]);
                before |= u32::from(first) << lane;
            }
            rays &= before;
            while rays != 0 {
                let lane = rays.trailing_zeros() as usize % MOST;
                rays &= rays - 1;
                let inside = doubt.inside & 1 << lane != 0;
                self.offer(geometry, packet, &mut first, (lane, number, t.0[lane], inside));
            }
        }
        let mut found = self.settle::<W>(packet, &first);
        for ball in &self.balls {
            ball.come_first::<W>(packet, &mut found);
        }
        found
    }

    /// Offers a triangle whose plane a ray meets at t, not after what it met so far.
    #[cold]
    #[inline(never)]
    fn offer(
        &self,
        geometry: &Geometry,
        packet: &Packet,
        first: &mut First,
        (lane, number, t, inside): (usize, usize, f32, bool),
    ) {
        if !(inside || self.passes(geometry, packet, lane, number)) {
            return;
        }
        let best = first.plate.0[lane].to_bits();
        if t >= first.least.0[lane] {
            // Which is first must be told exactly.
            let Some(exact) = self.exact.get(best as usize) else { return };
            let ray = packet.ray(lane);
            let (origin, to) = (ray.origin.to_array(), ray.direction.to_array());
            let exact_t = parameter(exact.normal, exact.corner, origin, to);
            (first.least.0[lane], first.most.0[lane]) = (exact_t, exact_t);
            if t > exact_t || t == exact_t && self.exact[number].primitive > exact.primitive {
                return;
            }
        }
        (first.least.0[lane], first.most.0[lane]) = (t, t);
        first.plate.0[lane] = f32::from_bits(number as u32);
    }

    /// Whether a ray passes inside of the edges of a triangle.
    fn passes(&self, geometry: &Geometry, packet: &Packet, lane: usize, number: usize) -> bool {
        let place = self.exact[number].place as usize;
        let face: Face = geometry.tree.blocks[place / LANES].face(place % LANES);
        Probe::new(Portable, &packet.ray(lane), true)
            .is_some_and(|probe| face.meet(Portable, &probe, false).is_some())
    }

    /// Makes all parameters exact.
    ///
    /// A ray may truly meet what it is named not to; that is not asked before, since one that leaves
    /// or reaches a triangle never certainly meets it.
    #[inline(always)]
    fn settle<W: Wide>(&self, packet: &Packet, first: &First) -> Found {
        let mut found =
            Found { t: NONE, primitive: [0; MOST], place: [0; MOST], met: 0, asked: packet.active };
        let mut normals = [[0.0; MOST]; 3];
        let mut corners = [[0.0; MOST]; 3];
        for lane in 0..W::WIDTH {
            let exact = &self.exact[self.number(first.plate.0[lane])];
            for axis in 0..3 {
                normals[axis][lane] = exact.normal[axis];
                corners[axis][lane] = exact.corner[axis];
            }
            found.primitive[lane] = exact.primitive.bits();
            found.place[lane] = exact.place;
        }
        let [ox, oy, oz, _] = &packet.beam.origin;
        let [dx, dy, dz, _] = &packet.beam.direction;
        let [Numbers(leaves), Numbers(reaches)] = &packet.left_out;
        for lane in 0..W::WIDTH {
            let normal = [normals[0][lane], normals[1][lane], normals[2][lane]];
            let corner = [corners[0][lane], corners[1][lane], corners[2][lane]];
            let origin = [ox.0[lane], oy.0[lane], oz.0[lane]];
            let direction = [dx.0[lane], dy.0[lane], dz.0[lane]];
            found.t.0[lane] = parameter(normal, corner, origin, direction);
        }
        for lane in 0..W::WIDTH {
            let number = found.primitive[lane];
            let not_to_meet = (number == leaves[lane]) | (number == reaches[lane]);
            found.met |= u32::from(first.plate.0[lane].to_bits() != NOTHING) << lane;
            found.asked &= !(u32::from(not_to_meet) << lane);
        }
        found
    }

    /// A plate's number from its bits; that of the last for none.
    #[inline(always)]
    fn number(&self, bits: f32) -> usize {
        (bits.to_bits() as usize).min(self.plates.len())
    }

    /// What a ray meets first, with planes, disks and instances.
    #[inline(never)]
    pub fn among_others(
        &self,
        geometry: &Geometry,
        ray: &Ray,
        met: Option<Meeting>,
    ) -> Option<Meeting> {
        let mut met = met;
        self.ask_round(geometry, ray, |t, primitive| {
            let first = match &met {
                Some(best) => t < best.t || t == best.t && primitive < best.primitive,
                None => t < ray.t_max,
            };
            if first {
                met = Some(Meeting { t, primitive, place: Place::Shapes });
            }
        });
        match geometry.crowd.is_empty() {
            true => met,
            false => geometry.tree.walker.meet_crowd(geometry, ray, met),
        }
    }

    /// Whether a ray meets any of those.
    #[inline(never)]
    pub fn others_occlude(&self, geometry: &Geometry, ray: &Ray) -> bool {
        let mut any = false;
        self.ask_round(geometry, ray, |t, _| any |= t < ray.t_max);
        let walker = geometry.tree.walker;
        any || !geometry.crowd.is_empty() && walker.occluded_by_crowd(geometry, ray)
    }

    /// Tells of each plane and disk that a ray meets, and where.
    fn ask_round(&self, geometry: &Geometry, ray: &Ray, mut tell: impl FnMut(f32, Primitive)) {
        let Some(probe) = Probe::new(Portable, ray, true) else { return };
        for primitive in &self.round {
            let (index, shapes) = (primitive.index(), &geometry.shapes);
            let t = match primitive.kind() {
                Kind::Disk => disk::meet(&probe, &shapes.disks[index]),
                Kind::Plane => plane::meet(&probe, &shapes.planes[index]),
                Kind::Triangle | Kind::Sphere => None,
            };
            if let Some(t) = t {
                tell(t, *primitive);
            }
        }
    }

    /// A bit for each ray of a packet that meets any triangle or sphere; and one for each that was
    /// asked.
    #[inline(always)]
    pub fn any<W: Wide>(
        &self,
        wide: W,
        geometry: &Geometry,
        packet: &Packet,
        doubts: &mut Doubts,
    ) -> (u32, u32) {
        let (zero, tiny) = (wide.splat(0.0), wide.splat(f32::MIN_POSITIVE));
        let [leaves, reaches] = &packet.left_out;
        let end = wide.load(&packet.end);
        let mut any = 0;
        let mut plate = wide.splat(f32::from_bits(NOTHING));
        doubts.count = 0;
        let mut crossing = Crossing::none(wide);
        for leaf in &self.leaves {
            if packet.enters(wide, &leaf.planes, end) & !any == 0 {
                continue;
            }
            for (number, one) in (leaf.first..).zip(&self.plates[leaf.first..leaf.end]) {
                if !one.joins {
                    crossing = one.cross(wide, &packet.beam);
                }
                let Crossing { low, high, .. } = crossing;
                let known = one.meet(wide, &crossing);
                let beyond = wide.or(wide.less(end, low), wide.less(high, zero));
                let missed = wide.or(known.outside, beyond);
                let missed = wide.or(missed, wide.same(leaves, one.primitive));
                let missed = wide.or(missed, wide.same(reaches, one.primitive));
                let ahead = wide.and(wide.less(tiny, low), wide.less(high, end));
                let met = wide.and(known.inside, ahead);
                plate = wide.select(met, wide.splat(f32::from_bits(number as u32)), plate);
                let open = !(wide.bits(missed) | wide.bits(met)) & packet.active;
                any |= wide.bits(met);
                doubts.note(number, open, wide.bits(known.inside));
            }
        }
        any &= packet.active;
        let mut last = NONE;
        wide.store(plate, &mut last);
        // As in `settle`.
        let mut asked = packet.active;
        for lane in ones(any) {
            let met = self.exact[self.number(last.0[lane % MOST])].primitive;
            asked &= !(u32::from(packet.is_left_out(lane, met)) << lane);
        }
        for doubt in doubts.of() {
            let number = usize::from(doubt.plate);
            let Exact { normal, corner, primitive, .. } = self.exact[number];
            let mut rays = u32::from(doubt.rays) & !any & !packet.leaves_out::<W>(primitive);
            if rays == 0 {
                continue;
            }
            let t = packet.parameters::<W>(normal, corner);
            let mut before = 0;
            for lane in 0..W::WIDTH {
                let first = (t.0[lane] >= 0.0) & (t.0[lane] < packet.end.0[lane]);
                before |= u32::from(first) << lane;
            }
            rays &= before;
            while rays != 0 {
                let lane = rays.trailing_zeros() as usize % MOST;
                rays &= rays - 1;
                let inside = doubt.inside & 1 << lane != 0;
                any |= u32::from(inside || self.passes(geometry, packet, lane, number)) << lane;
            }
        }
        for ball in &self.balls {
            any |= ball.occludes::<W>(packet);
        }
        (any, asked)
    }
}
