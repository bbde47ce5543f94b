//! Spheres met by packets of rays, and everything about where several rays meet spheres.
//!
//! By the operations of [`super::sphere`], one ray a lane: f64 rounds each by itself, so the bits are
//! the same.

use glam::{DVec2, Vec2, Vec3};

use super::best::{Meeting, Place};
use super::few::Found;
use super::packet::{NONE, Packet};
use super::ray::{Hit, Ray, Sheet};
use super::shapes::{Kind, Primitive, Sphere};
use super::wide::{MOST, Row, Wide, ones};
use super::{Geometry, sphere};

/// A sphere, and its name.
pub(super) struct Ball {
    pub sphere: Sphere,
    pub primitive: Primitive,
}

impl Ball {
    /// Where the rays of a packet meet it; -1 if they don't.
    #[inline(always)]
    fn parameters<W: Wide>(&self, packet: &Packet) -> Row {
        let [ox, oy, oz, _] = &packet.beam.origin;
        let [dx, dy, dz, _] = &packet.beam.direction;
        let round = sphere::round(&self.sphere);
        let mut all = NONE;
        for lane in 0..W::WIDTH {
            let origin = Vec3::new(ox.0[lane], oy.0[lane], oz.0[lane]);
            let direction = Vec3::new(dx.0[lane], dy.0[lane], dz.0[lane]);
            let t = sphere::root(origin.as_dvec3(), direction.as_dvec3(), round);
            all.0[lane] = if t > 0.0 { t as f32 } else { -1.0 };
        }
        all
    }

    /// Whatever of what the rays of a packet met first is behind it gives way to it.
    #[inline(always)]
    pub fn come_first<W: Wide>(&self, packet: &Packet, found: &mut Found) {
        let t = self.parameters::<W>(packet);
        let mut first = 0;
        for lane in 0..W::WIDTH {
            let is_met = found.met & 1 << lane != 0;
            let end = if is_met { found.t.0[lane] } else { packet.end.0[lane] };
            first |= u32::from((t.0[lane] >= 0.0) & (t.0[lane] < end)) << lane;
        }
        for lane in ones(first & packet.active) {
            let lane = lane % MOST;
            found.t.0[lane] = t.0[lane];
            found.primitive[lane] = self.primitive.bits();
            found.place[lane] = Found::NO_PLACE;
        }
        found.met |= first & packet.active;
    }

    /// A bit for each ray of a packet that meets it.
    #[inline(always)]
    pub fn occludes<W: Wide>(&self, packet: &Packet) -> u32 {
        let t = self.parameters::<W>(packet);
        let mut met = 0;
        for lane in 0..W::WIDTH {
            met |= u32::from((t.0[lane] >= 0.0) & (t.0[lane] < packet.end.0[lane])) << lane;
        }
        met & packet.active
    }
}

/// Coordinates of each ray, along the axes of space.
type Rows<T> = [[T; MOST]; 3];

/// Rays, spheres that they meet, and where.
pub(super) struct Balls {
    origin: Rows<f32>,
    direction: Rows<f32>,
    centre: Rows<f32>,
    radius: [f32; MOST],
    position: Rows<f32>,
    error: Rows<f32>,
    normal: Rows<f32>,
}

impl Balls {
    pub const NONE: Self = Self {
        origin: [[0.0; MOST]; 3],
        direction: [[0.0; MOST]; 3],
        centre: [[0.0; MOST]; 3],
        radius: [0.0; MOST],
        position: [[0.0; MOST]; 3],
        error: [[0.0; MOST]; 3],
        normal: [[0.0; MOST]; 3],
    };

    /// The hits of those rays that meet spheres, by a bit for each; a bit for each of the others.
    #[inline(always)]
    pub fn hits<W: Wide>(
        &mut self,
        geometry: &Geometry,
        mut asked: u32,
        (rays, met): (&[Ray], &[Option<Meeting>]),
        hits: &mut [Option<Hit>],
    ) -> u32 {
        let mut others = 0;
        for lane in ones(asked) {
            match met[lane] {
                Some(Meeting { primitive, place: Place::Shapes, .. })
                    if primitive.kind() == Kind::Sphere =>
                {
                    self.take(lane % MOST, &rays[lane], &geometry.shapes.spheres[primitive.index()])
                }
                _ => others |= 1 << lane,
            }
        }
        asked &= !others;
        if asked == 0 {
            return others;
        }
        self.find::<W>();
        for lane in ones(asked) {
            hits[lane] = met[lane].map(|meeting| self.hit(geometry, lane % MOST, &meeting));
        }
        others
    }

    #[inline(always)]
    fn take(&mut self, lane: usize, ray: &Ray, sphere: &Sphere) {
        put(&mut self.origin, lane, ray.origin);
        put(&mut self.direction, lane, ray.direction);
        put(&mut self.centre, lane, sphere.centre);
        self.radius[lane] = sphere.radius;
    }

    #[inline(always)]
    fn find<W: Wide>(&mut self) {
        for lane in 0..W::WIDTH {
            let sphere = (get(&self.centre, lane), self.radius[lane]);
            let (origin, direction) = (get(&self.origin, lane), get(&self.direction, lane));
            let normal = sphere::normal(origin.as_dvec3(), direction.as_dvec3(), sphere);
            let (position, error) = sphere::place(sphere, normal);
            put(&mut self.position, lane, position);
            put(&mut self.error, lane, error);
            put(&mut self.normal, lane, normal.as_vec3());
        }
    }

    #[inline(always)]
    fn hit(&self, geometry: &Geometry, lane: usize, meeting: &Meeting) -> Hit {
        let Meeting { t, primitive, .. } = *meeting;
        let position = get(&self.position, lane);
        let uv = match geometry.coordinates {
            true => geometry.shapes.coordinates.at(primitive, position, Vec2::ZERO),
            false => DVec2::ZERO,
        };
        let ng = get(&self.normal, lane);
        let owner = geometry.shapes.spheres[primitive.index()].owner;
        Hit {
            t,
            position,
            error: get(&self.error, lane),
            ng,
            ns: ng,
            uv,
            primitive,
            sheet: Sheet::NONE,
            object: owner.object,
            material: owner.material,
        }
    }
}

#[inline(always)]
fn get([x, y, z]: &Rows<f32>, lane: usize) -> Vec3 {
    Vec3::new(x[lane], y[lane], z[lane])
}

#[inline(always)]
fn put([x, y, z]: &mut Rows<f32>, lane: usize, value: Vec3) {
    (x[lane], y[lane], z[lane]) = value.into();
}
