//! Instances answer as copies do, to the bit.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DQuat, DVec3, Vec2};

use super::NO_NUMBERS;
use super::meshes::{Chance, Mesh};
use crate::math::{self, Transform};
use crate::render::geometry::{
    Bounds, Disk, Geometry, Hit, Instance, Owner, Placement, Ray, Shapes, Sheet, Sphere, Triangle,
};

/// A mesh with normals, some of them missing, with coordinates and two slots.
fn mesh(level: u32, size: f64, offset: f64) -> Arc<math::Mesh> {
    let Mesh { positions, triangles } = Mesh::bumpy(level);
    let normals: Vec<DVec3> = positions.iter().map(|p| p.normalize()).collect();
    let coordinates = positions.iter().map(|p| Vec2::new(p.x as f32, p.y as f32)).collect();
    let count = triangles.len() as u32;
    let normal_indices = triangles.iter().enumerate().map(|(number, corners)| match number % 7 {
        0 => [math::Mesh::NO_NORMAL; 3],
        _ => *corners,
    });
    Arc::new(math::Mesh {
        positions: positions.iter().map(|p| *p * size + offset).collect(),
        normals,
        normal_indices: normal_indices.collect(),
        coordinate_indices: triangles.clone(),
        coordinates,
        slots: (0..count).map(|i| i % 2).collect(),
        material_names: vec!["a".into(), "b".into()],
        triangles,
    })
}

/// Instances of meshes, and what else there is.
struct Scene {
    meshes: Vec<Arc<math::Mesh>>,
    all: Vec<(usize, Placement)>,
    others: Shapes,
}

const OBJECTS: u32 = 10;

impl Scene {
    fn corners(&self, (mesh, placement): &(usize, Placement)) -> Vec<glam::Vec3> {
        self.meshes[*mesh].positions.iter().map(|p| placement.vertex(*p)).collect()
    }

    fn instanced(&self) -> Geometry {
        let mut shapes = self.others.clone();
        let numbers: Vec<u32> = self.meshes.iter().map(|mesh| shapes.mesh(mesh.clone())).collect();
        for (object, one) in (OBJECTS..).zip(&self.all) {
            let corners = self.corners(one);
            let bounds =
                corners.iter().fold(Bounds::EMPTY, |sum, p| sum.union(Bounds { min: *p, max: *p }));
            assert!(one.1.is_sound());
            let materials = vec![object, object + 100];
            let (mesh, placement) = (numbers[one.0], one.1);
            shapes.instance(Instance { mesh, placement, bounds, object, materials });
        }
        Geometry::build(shapes)
    }

    fn copied(&self) -> Geometry {
        let mut shapes = self.others.clone();
        for (object, one) in (OBJECTS..).zip(&self.all) {
            let (mesh, place) = (&*self.meshes[one.0], one.1.place);
            let corners: Vec<u32> = self.corners(one).iter().map(|p| shapes.vertex(*p)).collect();
            let front = if place.mirrors() { -1.0 } else { 1.0 };
            let normals: Vec<u32> = mesh
                .normals
                .iter()
                .map(|n| shapes.normal((front * place.normal(*n)).normalize_or_zero().as_vec3()))
                .collect();
            let laid: Vec<u32> = mesh.coordinates.iter().map(|uv| shapes.coordinate(*uv)).collect();
            for (number, triangle) in mesh.triangles.iter().enumerate() {
                let turned = |[a, b, c]: [u32; 3]| if front < 0.0 { [a, c, b] } else { [a, b, c] };
                let triangle = turned(*triangle);
                let of = |all: &[u32]| triangle.map(|i| all[i as usize]);
                let given = (number % 7 != 0).then(|| of(&normals));
                let material = object + 100 * (number as u32 % 2);
                let primitive = shapes.triangle(Triangle {
                    corners: of(&corners),
                    normals: given,
                    owner: Owner { object, material },
                });
                shapes.lay(primitive, of(&laid));
            }
        }
        Geometry::build(shapes)
    }
}

/// All but the number of the primitive and its name, which a copy has of its own.
fn told(hit: Option<Hit>) -> Option<Hit> {
    let nobody = crate::render::geometry::Primitive::new(super::super::Kind::Plane, 0);
    hit.map(|hit| Hit { primitive: nobody, sheet: Sheet::NONE, ..hit })
}

/// Rays from outside, between the surfaces, and along the axes.
fn compare(scene: &Scene, chance: &mut Chance, rays: usize, size: f64) -> usize {
    let (instanced, copied) = (scene.instanced(), scene.copied());
    assert_eq!(instanced.bounds(), copied.bounds());
    let mut met = 0;
    for number in 0..rays {
        let target = scene.all[chance.below(scene.all.len())];
        let corner = scene.meshes[target.0].positions[chance.below(40)];
        let target = target.1.vertex(corner).as_dvec3();
        let origin = match number % 3 {
            0 => (3.0 * chance.cube()).as_vec3(),
            1 => (target + size * chance.cube()).as_vec3(),
            _ => (target + 1e4 * size * chance.cube()).as_vec3(),
        };
        // At edges and corners exactly, and near them.
        let near = target + if number % 2 == 0 { DVec3::ZERO } else { 0.3 * size * chance.cube() };
        let direction = match chance.below(8) {
            0 => [DVec3::X, DVec3::NEG_Y, DVec3::Z][chance.below(3)],
            _ => near - origin.as_dvec3(),
        };
        let ray = Ray::new(origin, direction.normalize_or(DVec3::X).as_vec3());
        let expected = copied.closest(&ray);
        assert_eq!(told(instanced.closest(&ray)), told(expected), "{ray:?}");
        assert_eq!(instanced.occluded(&ray), copied.occluded(&ray), "{ray:?}");
        let Some(hit) = expected else { continue };
        met += 1;
        let short = Ray { t_max: hit.t, ..ray };
        assert_eq!(instanced.occluded(&short), copied.occluded(&short), "{ray:?}");
        // Off the surface that was met.
        let ray = hit.ray(chance.direction());
        assert_eq!(told(instanced.closest(&ray)), told(copied.closest(&ray)), "{ray:?}");
        assert_eq!(instanced.occluded(&ray), copied.occluded(&ray), "{ray:?}");
    }
    met
}

fn turned(chance: &mut Chance) -> DMat3 {
    DMat3::from_quat(DQuat::from_axis_angle(
        chance.direction().as_dvec3().normalize(),
        3.0 * chance.signed(),
    ))
}

fn placement(matrix3: DMat3, at: DVec3) -> Placement {
    // From millimetres around a point far away.
    let centre = DVec3::new(20.0, -7.0, 3.0);
    let place = DAffine3 { matrix3: matrix3 * 4.0, translation: centre + 4.0 * at };
    Placement { place: Transform(place), centre, scale: 0.25 }
}

#[test]
fn instances_answer_as_copies_do() {
    let mut chance = Chance::new(50);
    let stretches = [
        DVec3::ONE,
        DVec3::new(-1.0, 1.0, 1.0),
        DVec3::new(1.0, 0.2, 3.0),
        DVec3::new(0.3, -2.0, -0.01),
        DVec3::new(-0.5, -0.5, -0.5),
    ];
    let mut scene = Scene {
        meshes: vec![mesh(2, 1.0, 0.0), mesh(3, 1e-3, 5e-3)],
        all: Vec::new(),
        others: Shapes::new(),
    };
    for (number, stretch) in stretches.iter().cycle().take(30).enumerate() {
        let which = number % 2;
        let size = [0.2, 200.0][which] * 10_f64.powf(0.5 * chance.signed());
        let matrix = turned(&mut chance) * DMat3::from_diagonal(*stretch * size);
        scene.all.push((which, placement(matrix, chance.cube())));
    }
    let owner = Owner { object: 3, material: 4 };
    for _ in 0..5 {
        let centre = chance.cube().as_vec3();
        scene.others.sphere(Sphere { centre, radius: 0.2, owner });
        let centre = chance.cube().as_vec3();
        scene.others.disk(Disk { centre, normal: chance.direction(), radius: 0.3, owner });
    }
    Mesh::bumpy(2).placed(0.3, DVec3::splat(0.2)).push(&mut scene.others, owner);
    let met = compare(&scene, &mut chance, 12_000, 0.3);
    assert!(met > 6000, "{met}");
}

#[test]
fn tiny_huge_and_flat_instances_answer_as_copies_do() {
    let mut chance = Chance::new(51);
    for (size, stretch) in [
        (1e-6, DVec3::ONE),
        (1e-3, DVec3::new(1.0, 1.0, -1.0)),
        (1e6, DVec3::ONE),
        (1.0, DVec3::new(1.0, 1.0, 1e-7)),
        (1.0, DVec3::new(1e-6, 1e-3, 1.0)),
    ] {
        // The mesh is as much larger as the instance is smaller, and so is the rest.
        for of_file in [1.0, 1e-9, 1e9] {
            let mut scene =
                Scene { meshes: vec![mesh(2, of_file, 0.0)], all: vec![], others: Shapes::new() };
            for _ in 0..4 {
                let scale = DMat3::from_diagonal(stretch * (size / of_file));
                let at = size.max(1.0) * chance.cube();
                scene.all.push((0, placement(turned(&mut chance) * scale, at)));
            }
            let met = compare(&scene, &mut chance, 600, size * stretch.x);
            assert!(met > 150, "{met} of {size} {stretch}");
        }
    }
}

/// The same instance twice: the first of both is met, whatever else is there.
#[test]
fn of_instances_at_one_place_the_first_is_met() {
    let mut chance = Chance::new(52);
    let place = placement(DMat3::from_diagonal(DVec3::splat(0.5)), DVec3::ZERO);
    let all = vec![(0, place); 3];
    let mut scene = Scene { meshes: vec![mesh(2, 1.0, 0.0)], all, others: Shapes::new() };
    for object in [OBJECTS - 1, OBJECTS + 50] {
        scene.others = Shapes::new();
        let owner = Owner { object, material: 0 };
        let corners = scene.corners(&scene.all[0]);
        let first: Vec<u32> = corners.iter().map(|p| scene.others.vertex(*p)).collect();
        for triangle in &scene.meshes[0].triangles {
            let corners = triangle.map(|i| first[i as usize]);
            scene.others.triangle(Triangle { corners, normals: None, owner });
        }
        let geometry = scene.instanced();
        for _ in 0..500 {
            let from = chance.direction();
            let hit = geometry.closest(&Ray::new(2.0 * from, -from)).unwrap();
            assert_eq!(hit.object, object.min(OBJECTS));
        }
    }
}

/// Twenty instances, that cross each other, and a mesh that is none.
pub(super) fn crowd(seed: u64, level: u32) -> Geometry {
    let mut chance = Chance::new(seed);
    let mut scene = Scene { meshes: vec![mesh(3, 1.0, 0.0)], all: vec![], others: Shapes::new() };
    Mesh::bumpy(level).placed(0.3, DVec3::splat(0.2)).push(&mut scene.others, Owner::default());
    for _ in 0..20 {
        let matrix = turned(&mut chance) * DMat3::from_diagonal(chance.cube());
        scene.all.push((0, placement(matrix, chance.cube())));
    }
    scene.instanced()
}

#[test]
fn a_crowd_answers_alike_by_any_instructions() {
    let mut chance = Chance::new(53);
    let (best, plain) = (crowd(54, 2).with_portable(false), crowd(54, 2).with_portable(true));
    for _ in 0..4000 {
        let ray = Ray::new((2.0 * chance.cube()).as_vec3(), chance.direction());
        assert_eq!(best.closest(&ray), plain.closest(&ray), "{ray:?}");
        assert_eq!(best.occluded(&ray), plain.occluded(&ray), "{ray:?}");
    }
}

/// Rays whose end is no number meet nothing, and come to an end.
#[test]
fn in_a_crowd_a_ray_without_an_interval_ends() {
    let crowd = crowd(55, 2);
    let mut chance = Chance::new(56);
    for t_max in NO_NUMBERS.into_iter().chain([0.0, -1.0, f32::NEG_INFINITY]) {
        for _ in 0..100 {
            let (origin, direction) = ((2.0 * chance.cube()).as_vec3(), chance.direction());
            let ray = Ray { t_max, ..Ray::new(origin, direction) };
            assert!(crowd.closest(&ray).is_none() && !crowd.occluded(&ray), "{ray:?}");
        }
    }
}
