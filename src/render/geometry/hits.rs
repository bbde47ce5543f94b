//! Everything about the meetings of several rays with triangles of the tree and spheres at once.
//!
//! By the operations of [`super::triangle::Face::surface`] in the same order, one ray a lane: f64
//! rounds each by itself, so the bits are the same. Only a triangle's parts have the axes of its ray,
//! [x, y, z] turned around; all else is along those of space.

use glam::{DVec2, Vec2, Vec3};

use super::Geometry;
use super::balls::Balls;
use super::best::{Meeting, Place};
use super::lanes::LANES;
use super::ray::{Hit, Ray, Sheet};
use super::rounding;
use super::triangle;
use super::wide::{Job, MOST, Wide, ones};

/// [`Geometry::hit_all`].
pub(super) struct HitAll<'a> {
    pub geometry: &'a Geometry,
    pub rays: &'a [Ray],
    pub met: &'a [Option<Meeting>],
    pub hits: &'a mut [Option<Hit>],
}

/// A number for each ray.
type Exact = [f64; MOST];
type Rounded = [f32; MOST];

/// The rays, and the corners of what they meet: along the axes of space.
struct Faces {
    origin: [Rounded; 3],
    direction: [Rounded; 3],
    /// Corner, then axis.
    corners: [[Rounded; 3]; 3],
}

/// What is known of the surfaces.
struct Surfaces {
    position: [Rounded; 3],
    error: [Rounded; 3],
    normal: [Exact; 3],
    weights: [Exact; 3],
}

impl Job for HitAll<'_> {
    #[inline(always)]
    fn run<W: Wide>(self, _: W) {
        let Self { geometry, rays, met, hits } = self;
        let zero = [0.0; MOST];
        let mut faces = Faces { origin: [zero; 3], direction: [zero; 3], corners: [[zero; 3]; 3] };
        let mut surfaces = Surfaces {
            position: [zero; 3],
            error: [zero; 3],
            normal: [[0.0; MOST]; 3],
            weights: [[0.0; MOST]; 3],
        };
        let mut balls = Balls::NONE;
        let all = rays.chunks(W::WIDTH).zip(met.chunks(W::WIDTH)).zip(hits.chunks_mut(W::WIDTH));
        for ((rays, met), hits) in all {
            for (lane, (ray, meeting)) in rays.iter().zip(met).enumerate() {
                if let Some(Meeting { place: Place::Tree(place), .. }) = meeting {
                    faces.take(geometry, lane % MOST, ray, *place as usize);
                }
            }
            surfaces.find::<W>(&faces);
            // Two loops: a hit that comes from elsewhere would be copied by way of memory, and so would
            // all others.
            let mut others = 0_u32;
            for (lane, (meeting, hit)) in met.iter().zip(hits.iter_mut()).enumerate() {
                if let Some(meeting) = meeting
                    && let Place::Tree(_) = meeting.place
                {
                    *hit = Some(surfaces.hit(geometry, lane % MOST, meeting));
                } else {
                    *hit = None;
                    others |= u32::from(meeting.is_some()) << lane;
                }
            }
            if others == 0 {
                continue;
            }
            for lane in ones(balls.hits::<W>(geometry, others, (rays, met), hits)) {
                hits[lane] = met[lane].map(|meeting| geometry.hit(&rays[lane], &meeting));
            }
        }
    }
}

impl Faces {
    /// Takes a ray and what it meets. Number by number, so that none has to wait for a vector or a list
    /// to be written before it is read.
    #[inline(always)]
    fn take(&mut self, geometry: &Geometry, lane: usize, ray: &Ray, place: usize) {
        let Self { origin: [ox, oy, oz], direction: [dx, dy, dz], corners: [a, b, c] } = self;
        (ox[lane], oy[lane], oz[lane]) = (ray.origin.x, ray.origin.y, ray.origin.z);
        (dx[lane], dy[lane], dz[lane]) = (ray.direction.x, ray.direction.y, ray.direction.z);
        let (block, at) = (&geometry.tree.blocks[place / LANES], place % LANES);
        [a[0][lane], b[0][lane], c[0][lane]] = block.coordinates(0, at);
        [a[1][lane], b[1][lane], c[1][lane]] = block.coordinates(1, at);
        [a[2][lane], b[2][lane], c[2][lane]] = block.coordinates(2, at);
    }
}

/// Which axis a ray's direction is longest along, as [`super::ray::Turn::of`] has it.
#[derive(Clone, Copy)]
struct Depth {
    is_y: bool,
    is_z: bool,
}

impl Depth {
    #[inline(always)]
    fn of([x, y, z]: [f64; 3]) -> Self {
        let (x, y, z) = (x.abs(), y.abs(), z.abs());
        let (x_y, y_z, z_x) = (x >= y, y >= z, z >= x);
        Self { is_y: y_z & !x_y, is_z: z_x & !y_z }
    }

    /// The numbers along the axes of the ray: the last is that of its depth, the first that of the
    /// next axis of space.
    #[inline(always)]
    fn turned(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [self.pick([y, z, x]), self.pick([z, x, y]), self.pick([x, y, z])]
    }

    /// One of three numbers; by choices, not by memory.
    #[inline(always)]
    fn pick(self, [for_x, for_y, for_z]: [f64; 3]) -> f64 {
        let others = if self.is_y { for_y } else { for_x };
        if self.is_z { for_z } else { others }
    }
}

impl Surfaces {
    #[inline(always)]
    fn find<W: Wide>(&mut self, faces: &Faces) {
        for lane in 0..W::WIDTH {
            let [ox, oy, oz] = at(&faces.origin, lane);
            let direction = at(&faces.direction, lane);
            let [a, b, c] = &faces.corners;
            let [ax, ay, az] = at(a, lane);
            let [bx, by, bz] = at(b, lane);
            let [cx, cy, cz] = at(c, lane);
            // The parts, as from `Face::parts`.
            let depth = Depth::of(direction);
            let [dx, dy, dz] = depth.turned(direction);
            let (sx, sy) = (dx / dz, dy / dz);
            let [au, av, ad] = depth.turned([ax - ox, ay - oy, az - oz]);
            let [bu, bv, bd] = depth.turned([bx - ox, by - oy, bz - oz]);
            let [cu, cv, cd] = depth.turned([cx - ox, cy - oy, cz - oz]);
            let (au, bu, cu) = (au - ad * sx, bu - bd * sx, cu - cd * sx);
            let (av, bv, cv) = (av - ad * sy, bv - bd * sy, cv - cd * sy);
            let u = (cu * bv - cv * bu).abs();
            let v = (au * cv - av * cu).abs();
            let w = (bu * av - bv * au).abs();
            let sum = u + v + w;
            let scale = 1.0 / sum;
            let third = 1.0 / 3.0;
            let u = if sum > 0.0 { u * scale } else { third };
            let v = if sum > 0.0 { v * scale } else { third };
            let w = if sum > 0.0 { w * scale } else { third };
            self.weights[0][lane] = u;
            self.weights[1][lane] = v;
            self.weights[2][lane] = w;
            let weights = [u, v, w];
            (self.position[0][lane], self.error[0][lane]) = place([ax, bx, cx], weights);
            (self.position[1][lane], self.error[1][lane]) = place([ay, by, cy], weights);
            (self.position[2][lane], self.error[2][lane]) = place([az, bz, cz], weights);
            let (ex, ey, ez) = (bx - ax, by - ay, bz - az);
            let (fx, fy, fz) = (cx - ax, cy - ay, cz - az);
            let nx = ey * fz - ez * fy;
            let ny = ez * fx - ex * fz;
            let nz = ex * fy - ey * fx;
            let length = (nx * nx + ny * ny + nz * nz).sqrt();
            let scale = 1.0 / length;
            let some = (length > 0.0) & (length < f64::INFINITY);
            self.normal[0][lane] = if some { nx * scale } else { 0.0 };
            self.normal[1][lane] = if some { ny * scale } else { 0.0 };
            self.normal[2][lane] = if some { nz * scale } else { 1.0 };
        }
    }

    #[inline(always)]
    fn hit(&self, geometry: &Geometry, lane: usize, meeting: &Meeting) -> Hit {
        let Meeting { t, primitive, .. } = *meeting;
        let index = primitive.index();
        let [u, v, w] = [self.weights[0][lane], self.weights[1][lane], self.weights[2][lane]];
        let normal = [self.normal[0][lane], self.normal[1][lane], self.normal[2][lane]];
        let ng = Vec3::new(normal[0] as f32, normal[1] as f32, normal[2] as f32);
        let ns = match geometry.shapes.corner_normals(index) {
            None => ng,
            Some([a, b, c]) => triangle::shading_normal(normal, [*a, *b, *c], [u, v, w]),
        };
        let [x, y, z] = &self.position;
        let position = Vec3::new(x[lane], y[lane], z[lane]);
        let [x, y, z] = &self.error;
        let error = Vec3::new(x[lane], y[lane], z[lane]);
        let weights = Vec2::new(v as f32, w as f32);
        let uv: DVec2 = match geometry.coordinates {
            true => geometry.shapes.coordinates.at(primitive, position, weights),
            false => weights.as_dvec2(),
        };
        let owner = geometry.shapes.triangle_owners[index];
        Hit {
            t,
            position,
            error,
            ng,
            ns,
            uv,
            primitive,
            sheet: Sheet::of(primitive),
            object: owner.object,
            material: owner.material,
        }
    }
}

/// The numbers of a lane, exactly.
#[inline(always)]
fn at([x, y, z]: &[Rounded; 3], lane: usize) -> [f64; 3] {
    [f64::from(x[lane]), f64::from(y[lane]), f64::from(z[lane])]
}

/// A coordinate of the point that has these weights among the corners, and the bound of its error.
#[inline(always)]
fn place([a, b, c]: [f64; 3], [u, v, w]: [f64; 3]) -> (f32, f32) {
    let exact = a * u + b * v + c * w;
    (exact as f32, rounding::error_of(exact, a.abs() + b.abs() + c.abs()))
}
