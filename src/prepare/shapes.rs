//! Placed objects → shapes in world space, in single precision, and the lamps among them.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};

use super::errors::{matter, scene as errors};
use super::instances::Meshes;
use super::lights::LampParts;
use super::materials::Table;
use super::space::Space;
use crate::bodies::{Body, Matter, Placed};
use crate::diag::{Code, Diagnostic, Level};
use crate::load::Stage;
use crate::math::{Mesh, Progress, Transform};
use crate::plan::{Feature, Plan};
use crate::render::geometry::{Disk, Owner, Plane, Primitive, Shapes, Sphere, Triangle};

/// What all objects became.
pub(super) struct Assembled {
    pub shapes: Shapes,
    /// In the order of (object, material).
    pub lamps: Vec<LampParts>,
    /// One for each object of the scene.
    pub objects: Vec<Counted>,
    /// Triangles dropped; those of instances are not looked for.
    pub slivers: u64,
}

/// What one object became.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counted {
    pub triangles: u64,
    /// Spheres, disks and planes.
    pub others: u64,
    /// Whether its triangles are those of an instance.
    pub instance: bool,
}

/// Least area of a triangle that is kept, in square world units: the least normal f32. Below it
/// areas, normals and densities lose their digits.
const LEAST_AREA: f64 = f32::MIN_POSITIVE as f64;

/// Objects smaller than so many steps of single precision at the place where they are have lost
/// their form.
const LEAST_STEPS: f64 = 16.0;

/// Clear matter of fewer steps loses more than one part in 5,000 of the light that goes through it; of
/// fewer than `LEAST_CLEAR` one part in 100, and at its rim a third.
const FEW_CLEAR: f64 = 2500.0;
const LEAST_CLEAR: f64 = 100.0;

/// More than this part of the triangles of clear matter are not lost.
const MOST_LOST: f64 = 0.01;

/// Distance of a plane from the middle of the scene, in world units: so far away it shows its
/// horizon and no more, and well before 2⁶⁰ rays do not meet it any more.
const FARTHEST_PLANE: f64 = 1e15;

/// Puts every body into world space.
pub(super) fn assemble(
    stage: &Stage,
    (bodies, matter): (&[Placed], &Matter),
    space: &Space,
    materials: &Table,
    plan: &Plan,
    progress: &dyn Progress,
    found: &mut Vec<Diagnostic>,
) -> Assembled {
    let count = bodies.last().map_or(0, |last| last.number as usize + 1);
    let shapes = Shapes::new();
    let normals = plan.builds(Feature::Normals);
    let mut all = Assembled {
        shapes: if normals { shapes.keeping_normals() } else { shapes },
        lamps: Vec::new(),
        objects: vec![Counted::default(); count],
        slivers: 0,
    };
    let mut meshes = Meshes::new(stage, plan, space);
    let placement = |meshes: &Meshes, rank: usize| {
        meshes.placement(&bodies[rank]).filter(|_| matter.is_even(rank))
    };
    let copied = (0..bodies.len()).filter(|rank| placement(&meshes, *rank).is_none());
    let copied = || copied.clone().map(|rank| &bodies[rank]);
    let triangles: usize = copied().map(|placed| placed.body.triangles()).sum();
    if triangles >= MOST_TRIANGLES {
        found.push(errors::too_many_triangles(triangles, MOST_TRIANGLES));
        return all;
    }
    let (vertices, corner_normals) = copied().fold((0, 0), |sum, placed| {
        let (vertices, normals) = vectors(&placed.body);
        (sum.0 + vertices, sum.1 + normals)
    });
    all.shapes.reserve(vertices, corner_normals, triangles);
    for (done, placed) in bodies.iter().enumerate() {
        progress.advance(done as u64, bodies.len() as u64);
        if let Some(placement) = placement(&meshes, done) {
            let number = |slot| materials.number(done, slot, matter.before(done, slot, 0));
            meshes.put(placed, placement, number, &mut all.shapes);
            let triangles = placed.body.triangles() as u64;
            let counted = Counted { triangles, instance: true, ..Counted::default() };
            all.objects[placed.number as usize] = counted;
            if let Some(fault) = too_small(stage, placed, space) {
                tell(fault, found);
            }
            continue;
        }
        let mut one = One {
            placed,
            rank: done,
            matter,
            space,
            materials,
            plan,
            all: &mut all,
            lamps: BTreeMap::new(),
            slivers: 0,
        };
        one.put(found);
        let (lamps, slivers) = (one.lamps, one.slivers);
        all.lamps.extend(lamps.into_values());
        all.slivers += slivers;
        match too_small(stage, placed, space) {
            Some(fault) if slivers == 0 || fault.level == Level::Error => tell(fault, found),
            None if slivers == 0 => {}
            _ if loses_light(stage, placed, slivers) => {
                let of = placed.body.triangles();
                tell(matter::lost_triangles(placed.name(), slivers, of), found);
            }
            _ => {
                found.push(errors::lost_triangles(placed.name(), slivers, placed.body.triangles()));
            }
        }
    }
    progress.advance(bodies.len() as u64, bodies.len() as u64);
    all
}

/// Adds what is told of the size of an object, in place of what follows from it.
fn tell(fault: Diagnostic, found: &mut Vec<Diagnostic>) {
    let follows = |known: &Diagnostic| {
        let same = known.labels.iter().any(|label| Some(label.span) == fault.place());
        let codes = [Code::MATTER_COINCIDE, Code::MATTER_TOO_SMALL, Code::SCENE_TOO_SMALL];
        same && codes.contains(&known.code)
    };
    match fault.level {
        Level::Error => found.retain(|known| !follows(known)),
        Level::Warning if found.iter().any(follows) => return,
        Level::Warning => {}
    }
    found.push(fault);
}

/// Whether so many lost triangles of a body of clear matter let light through that they should
/// hold: single ones are joints of scanned meshes, and have no area.
fn loses_light(stage: &Stage, placed: &Placed, lost: u64) -> bool {
    let clear = stage.scene.integrator.follows_light() && placed.transmits();
    clear && lost as f64 > MOST_LOST * placed.body.triangles() as f64
}

/// How many vertices a body has, and how many normals at them.
fn vectors(body: &Body) -> (usize, usize) {
    match body {
        Body::Mesh { mesh, .. } => (mesh.positions.len(), mesh.normals.len()),
        Body::Face { corners, .. } => (corners.len(), 0),
        _ => (0, 0),
    }
}

/// Triangles beyond which a scene is refused: they would need some 20 GB.
const MOST_TRIANGLES: usize = Shapes::MOST / 8;

/// What single precision takes of an object's form, where that is told.
fn too_small(stage: &Stage, placed: &Placed, space: &Space) -> Option<Diagnostic> {
    let steps = space.steps(placed);
    let light_goes_through = stage.scene.integrator.follows_light() && placed.transmits();
    match steps {
        _ if light_goes_through && steps < LEAST_CLEAR => {
            Some(matter::too_small(placed.name(), steps, LEAST_CLEAR))
        }
        _ if light_goes_through && steps < FEW_CLEAR || steps < LEAST_STEPS => {
            Some(errors::too_small(placed.name(), steps, light_goes_through))
        }
        _ => None,
    }
}

impl Space {
    /// How many steps of single precision an object is across, at the place where it is.
    fn steps(&self, placed: &Placed) -> f64 {
        let bounds = placed.bounds();
        if bounds.is_empty() {
            return f64::INFINITY;
        }
        let farthest = self.point(bounds.min).abs().max(self.point(bounds.max).abs());
        let step = farthest.max_element() * f64::from(f32::EPSILON);
        2.0 * self.length(bounds.half().max_element()) / step
    }
}

/// One object on its way.
struct One<'a> {
    placed: &'a Placed<'a>,
    /// Its number among the placed objects.
    rank: usize,
    matter: &'a Matter<'a>,
    space: &'a Space,
    materials: &'a Table,
    plan: &'a Plan,
    all: &'a mut Assembled,
    /// By material.
    lamps: BTreeMap<u32, LampParts>,
    slivers: u64,
}

impl One<'_> {
    fn put(&mut self, found: &mut Vec<Diagnostic>) {
        match &self.placed.body {
            Body::Mesh { mesh, to_metres } => self.mesh(mesh, *to_metres),
            Body::Face { corners, coordinates } => {
                let corner = |(i, corner): (usize, &DVec3)| {
                    let metres = self.matter.moved(self.rank, i as u32).unwrap_or(*corner);
                    self.space.point(metres).as_vec3()
                };
                let corners: Vec<_> = corners.iter().enumerate().map(corner).collect();
                let indices: Vec<_> =
                    corners.iter().map(|corner| self.all.shapes.vertex(*corner)).collect();
                let laid: Option<Vec<_>> = self.is_charted(0).then(|| {
                    let corners = coordinates.iter().map(|uv| uv.as_vec2());
                    corners.map(|uv| self.all.shapes.coordinate(uv)).collect()
                });
                for i in 1..corners.len() - 1 {
                    let of = [0, i, i + 1];
                    let triangle = self.triangle(
                        of.map(|i| corners[i]),
                        of.map(|i| indices[i]),
                        None,
                        (0, i - 1),
                    );
                    if let (Some(triangle), Some(laid)) = (triangle, &laid) {
                        self.all.shapes.lay(triangle, of.map(|i| laid[i]));
                    }
                }
            }
            Body::Sphere { centre, radius, chart } => {
                let centre = self.space.point(*centre);
                let radius = self.space.length(*radius);
                let shape = Sphere {
                    centre: centre.as_vec3(),
                    radius: radius as f32,
                    owner: self.owner(0, 0),
                };
                if self.has_area(radius) {
                    let primitive = self.all.shapes.sphere(shape);
                    self.chart(primitive, *chart);
                    let area = 4.0 * std::f64::consts::PI * radius * radius;
                    // It faces every way.
                    self.shines(
                        shape.owner,
                        primitive,
                        area,
                        centre,
                        DVec3::ZERO,
                        centre.abs() + radius,
                    );
                }
            }
            Body::Disk { centre, normal, radius, chart } => {
                let centre = self.space.point(*centre);
                let radius = self.space.length(*radius);
                let shape = Disk {
                    centre: centre.as_vec3(),
                    normal: normal.as_vec3(),
                    radius: radius as f32,
                    owner: self.owner(0, 0),
                };
                if self.has_area(radius) {
                    let primitive = self.all.shapes.disk(shape);
                    self.chart(primitive, *chart);
                    let area = std::f64::consts::PI * radius * radius;
                    self.shines(
                        shape.owner,
                        primitive,
                        area,
                        centre,
                        *normal * area,
                        centre.abs() + radius,
                    );
                }
            }
            Body::Plane { point, normal, chart } => {
                // The point of the plane that is nearest to the middle of the scene.
                let point = *normal * normal.dot(self.space.point(*point));
                if point.length() > FARTHEST_PLANE {
                    found.push(errors::beyond_scene(self.placed.name(), FARTHEST_PLANE));
                    return;
                }
                let shape = Plane {
                    point: point.as_vec3(),
                    normal: normal.as_vec3(),
                    owner: self.owner(0, 0),
                };
                let primitive = self.all.shapes.plane(shape);
                self.chart(primitive, *chart);
                self.count().others += 1;
                let endless = f64::INFINITY;
                self.shines(shape.owner, primitive, endless, point, *normal, point.abs());
            }
        }
    }

    fn mesh(&mut self, mesh: &Mesh, to_metres: Transform) {
        const UNUSED: u32 = u32::MAX;
        let mut corners = vec![(UNUSED, Vec3::ZERO); mesh.positions.len()];
        let mut normals = vec![UNUSED; mesh.normals.len()];
        let mut laid = vec![UNUSED; mesh.coordinates.len()];
        let mirrors = to_metres.mirrors();
        for (number, triangle) in mesh.triangles.iter().enumerate() {
            let mut at = triangle.map(|i| {
                let (index, position) = &mut corners[i as usize];
                if *index == UNUSED {
                    let metres = self.matter.moved(self.rank, i);
                    let metres =
                        metres.unwrap_or_else(|| to_metres.point(mesh.positions[i as usize]));
                    *position = self.space.point(metres).as_vec3();
                    *index = self.all.shapes.vertex(*position);
                }
                (*index, *position)
            });
            let of_corners = mesh.normal_indices.get(number).copied();
            let given = of_corners.filter(|of| !of.contains(&Mesh::NO_NORMAL));
            let mut smooth = given.map(|of| {
                of.map(|i| {
                    let index = &mut normals[i as usize];
                    if *index == UNUSED {
                        let turned = to_metres.normal(mesh.normals[i as usize]);
                        let front = if mirrors { -turned } else { turned };
                        *index = self.all.shapes.normal(front.normalize_or_zero().as_vec3());
                    }
                    *index
                })
            });
            if mirrors {
                at.swap(1, 2);
                smooth = smooth.map(|[a, b, c]| [a, c, b]);
            }
            let slot = mesh.slots.get(number).copied().unwrap_or(0) as usize;
            let triangle =
                self.triangle(at.map(|(_, p)| p), at.map(|(i, _)| i), smooth, (slot, number));
            let given = mesh.coordinates_of(number).filter(|_| self.is_charted(slot));
            if let (Some(triangle), Some(of)) = (triangle, given) {
                let [a, b, c] = of.map(|i| {
                    let index = &mut laid[i as usize];
                    if *index == UNUSED {
                        *index = self.all.shapes.coordinate(mesh.coordinates[i as usize]);
                    }
                    *index
                });
                let of = if mirrors { [a, c, b] } else { [a, b, c] };
                self.all.shapes.lay(triangle, of);
            }
        }
    }

    /// Adds a triangle; None: it has no area.
    fn triangle(
        &mut self,
        at: [Vec3; 3],
        corners: [u32; 3],
        normals: Option<[u32; 3]>,
        (slot, number): (usize, usize),
    ) -> Option<Primitive> {
        // Differences and products of f32 are exact in f64, so no area is exactly no area.
        let [a, b, c] = at.map(|corner| corner.as_dvec3());
        let facing = 0.5 * (b - a).cross(c - a);
        let area = facing.length();
        if area < LEAST_AREA {
            self.slivers += 1;
            return None;
        }
        let owner = self.owner(slot, number);
        let primitive = self.all.shapes.triangle(Triangle { corners, normals, owner });
        self.count().triangles += 1;
        let reach = a.abs().max(b.abs()).max(c.abs());
        self.shines(owner, primitive, area, (a + b + c) / 3.0, facing, reach);
        Some(primitive)
    }

    /// Whether coordinates are kept of surfaces of this slot.
    fn is_charted(&self, slot: usize) -> bool {
        let mut parts = self.placed.parts[slot].iter();
        let textured = parts.any(|(_, part)| part.value.texture().is_some());
        self.plan.builds(Feature::Coordinates) && (textured || self.plan.forced)
    }

    fn chart(&mut self, primitive: Primitive, from_metres: Transform) {
        if self.is_charted(0) {
            let to_metres = Transform(self.space.to_metres());
            self.all.shapes.chart(primitive, to_metres.then(from_metres).0);
        }
    }

    /// Counts a round shape, if it has an area that single precision can tell.
    fn has_area(&mut self, radius: f64) -> bool {
        let kept = radius * radius >= LEAST_AREA;
        self.count().others += u64::from(kept);
        kept
    }

    /// Adds a surface to the lamp it belongs to, if its material shines.
    fn shines(
        &mut self,
        owner: Owner,
        primitive: Primitive,
        area: f64,
        centroid: DVec3,
        facing: DVec3,
        reach: DVec3,
    ) {
        if self.materials.emission(owner.material).is_some() {
            let lamp = self.lamps.entry(owner.material).or_insert_with(|| LampParts::new(owner));
            lamp.add(primitive, area, centroid, facing, reach);
        }
    }

    /// Of a triangle of a slot, or a round shape.
    fn owner(&self, slot: usize, triangle: usize) -> Owner {
        let before = self.matter.before(self.rank, slot, triangle);
        let material = self.materials.number(self.rank, slot, before);
        Owner { object: self.placed.number, material }
    }

    fn count(&mut self) -> &mut Counted {
        &mut self.all.objects[self.placed.number as usize]
    }
}
