//! Every processor's instructions give the same answers, to the bit.

use glam::{DVec3, Vec3};

use super::meshes::{Chance, Mesh};
use crate::render::geometry::{Disk, Geometry, Owner, Plane, Ray, Sphere};

/// A bumpy mesh with round shapes and a plane, of a size, somewhere.
pub(super) fn mixed(chance: &mut Chance, scale: f64, offset: f64) -> Geometry {
    let mut shapes = Mesh::bumpy(4).placed(scale, DVec3::splat(offset)).shapes();
    let owner = Owner::default();
    let place = |p: DVec3| (p * scale + offset).as_vec3();
    for _ in 0..20 {
        let radius = (0.2 * scale) as f32;
        shapes.sphere(Sphere { centre: place(chance.cube()), radius, owner });
        let normal = chance.direction();
        shapes.disk(Disk { centre: place(2.0 * chance.cube()), normal, radius, owner });
    }
    let point = place(DVec3::new(0.0, 0.0, -3.0));
    shapes.plane(Plane { point, normal: Vec3::new(0.1, 0.2, 1.0), owner });
    Geometry::build(shapes)
}

#[test]
fn plain_instructions_give_the_same_bits() {
    let mut chance = Chance::new(31);
    for (scale, offset) in [(1.0, 0.0), (1e-9, 0.0), (1e7, 0.0), (1.0, 1e3)] {
        let seed = chance.bits();
        let geometry = mixed(&mut Chance::new(seed), scale, offset).with_portable(false);
        let plain = mixed(&mut Chance::new(seed), scale, offset).with_portable(true);
        for _ in 0..8000 {
            let origin = (2.0 * chance.cube() * scale + offset).as_vec3();
            let direction = match chance.below(8) {
                0 => [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z][chance.below(6)],
                _ => chance.direction(),
            };
            let ray = Ray::new(origin, direction);
            let hit = geometry.closest(&ray);
            assert_eq!(hit, plain.closest(&ray), "{ray:?}");
            assert_eq!(geometry.occluded(&ray), plain.occluded(&ray), "{ray:?}");
            let Some(hit) = hit else { continue };
            // From surface to surface, where f32 alone can't tell.
            let ray = hit.ray(chance.direction());
            assert_eq!(geometry.closest(&ray), plain.closest(&ray), "{ray:?}");
            assert_eq!(geometry.occluded(&ray), plain.occluded(&ray), "{ray:?}");
        }
    }
}
