//! Everything about the meetings of several rays with triangles of the tree and spheres at once.
//!
//! By the operations of [`super::triangle::Face::surface`] in the same order, one ray a lane: f64
//! rounds each by itself, so the bits are the same. The axes of a triangle's parts are those of its
//! ray, [x, y, z] turned around; only sums along all three must be taken in the order of space.

use glam::{DVec2, Vec2, Vec3};

use super::Geometry;
use super::balls::Balls;
use super::best::{Meeting, Place};
use super::lanes::LANES;
use super::ray::{Hit, Ray, Sheet, Turn};
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

/// What the surfaces are made of, along the axes of each ray.
struct Faces {
    /// Which axis of space is the first.
    turns: [u8; MOST],
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
        let mut faces = Faces {
            turns: [0; MOST],
            origin: [zero; 3],
            direction: [zero; 3],
            corners: [[zero; 3]; 3],
        };
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
                    *hit = Some(surfaces.hit(geometry, lane % MOST, &faces, meeting));
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
    /// Takes a ray and what it meets.
    #[inline(always)]
    fn take(&mut self, geometry: &Geometry, lane: usize, ray: &Ray, place: usize) {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let order = Turn::of(ray.direction.abs().into()).axes();
        self.turns[lane] = order[0] as u8;
        let block = &geometry.tree.blocks[place / LANES];
        for (k, axis) in order.into_iter().enumerate() {
            self.origin[k][lane] = o[axis];
            self.direction[k][lane] = d[axis];
            let corners = block.coordinates(axis, place % LANES);
            self.corners[0][k][lane] = corners[0];
            self.corners[1][k][lane] = corners[1];
            self.corners[2][k][lane] = corners[2];
        }
    }
}

impl Surfaces {
    #[inline(always)]
    fn find<W: Wide>(&mut self, faces: &Faces) {
        for lane in 0..W::WIDTH {
            let [ox, oy, oz] = at(&faces.origin, lane);
            let [dx, dy, dz] = at(&faces.direction, lane);
            let [a, b, c] = &faces.corners;
            let [ax, ay, az] = at(a, lane);
            let [bx, by, bz] = at(b, lane);
            let [cx, cy, cz] = at(c, lane);
            let (sx, sy) = (dx / dz, dy / dz);
            // The parts, as from `Face::parts`.
            let (ad, bd, cd) = (az - oz, bz - oz, cz - oz);
            let (au, bu, cu) = (ax - ox - ad * sx, bx - ox - bd * sx, cx - ox - cd * sx);
            let (av, bv, cv) = (ay - oy - ad * sy, by - oy - bd * sy, cy - oy - cd * sy);
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
            // Added up from the x of space on.
            let turn = faces.turns[lane];
            let (xx, yy, zz) = (nx * nx, ny * ny, nz * nz);
            let (first, second, last) =
                (pick(turn, [xx, zz, yy]), pick(turn, [yy, xx, zz]), pick(turn, [zz, yy, xx]));
            let length = (first + second + last).sqrt();
            let scale = 1.0 / length;
            let some = (length > 0.0) & (length < f64::INFINITY);
            let up = [
                pick(turn, [0.0, 0.0, 1.0]),
                pick(turn, [0.0, 1.0, 0.0]),
                pick(turn, [1.0, 0.0, 0.0]),
            ];
            self.normal[0][lane] = if some { nx * scale } else { up[0] };
            self.normal[1][lane] = if some { ny * scale } else { up[1] };
            self.normal[2][lane] = if some { nz * scale } else { up[2] };
        }
    }

    #[inline(always)]
    fn hit(&self, geometry: &Geometry, lane: usize, faces: &Faces, meeting: &Meeting) -> Hit {
        let Meeting { t, primitive, .. } = *meeting;
        let index = primitive.index();
        let turn = faces.turns[lane];
        let [u, v, w] = [self.weights[0][lane], self.weights[1][lane], self.weights[2][lane]];
        let normal = turned(turn, &self.normal, lane);
        let ng = Vec3::new(normal[0] as f32, normal[1] as f32, normal[2] as f32);
        let ns = match geometry.shapes.corner_normals(index) {
            None => ng,
            Some([a, b, c]) => triangle::shading_normal(normal, [*a, *b, *c], [u, v, w]),
        };
        let position = Vec3::from_array(turned(turn, &self.position, lane));
        let weights = Vec2::new(v as f32, w as f32);
        let uv: DVec2 = match geometry.coordinates {
            true => geometry.shapes.coordinates.at(primitive, position, weights),
            false => weights.as_dvec2(),
        };
        let owner = geometry.shapes.triangle_owners[index];
        Hit {
            t,
            position,
            error: Vec3::from_array(turned(turn, &self.error, lane)),
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

/// The numbers of a lane along the axes of space, where the first is along axis `turn`.
#[inline(always)]
fn turned<T: Copy>(turn: u8, all: &[[T; MOST]; 3], lane: usize) -> [T; 3] {
    // Of x, y and z: where they are.
    let [x, y, z] = [[0, 1, 2], [2, 0, 1], [1, 2, 0]][usize::from(turn) % 3];
    [all[x][lane], all[y][lane], all[z][lane]]
}

/// A coordinate of the point that has these weights among the corners, and the bound of its error.
#[inline(always)]
fn place([a, b, c]: [f64; 3], [u, v, w]: [f64; 3]) -> (f32, f32) {
    let exact = a * u + b * v + c * w;
    (exact as f32, rounding::error_of(exact, a.abs() + b.abs() + c.abs()))
}

/// One of three numbers; by choices, not by memory.
#[inline(always)]
fn pick(which: u8, [a, b, c]: [f64; 3]) -> f64 {
    let later = if which == 1 { b } else { c };
    if which == 0 { a } else { later }
}
