//! Streams answer as single questions do, to the bit.

use glam::DVec3;

use super::instances;
use super::meshes::Chance;
use super::processors::mixed;
use crate::render::geometry::{Geometry, Ray, between};

/// Rays into a geometry, from its surfaces, and between them; some end early, some are none.
fn rays(chance: &mut Chance, geometry: &Geometry, count: usize) -> Vec<Ray> {
    let mut rays = Vec::new();
    while rays.len() < count {
        let ray = Ray::new((2.0 * chance.cube()).as_vec3(), chance.direction());
        rays.push(ray);
        let Some(hit) = geometry.closest(&ray) else { continue };
        let next = hit.ray(chance.direction());
        let end = geometry.closest(&next);
        rays.extend([next, Ray { t_max: hit.t, ..ray }]);
        rays.extend(end.map(|end| between(&hit.point(), &end.point())));
        if chance.below(16) == 0 {
            rays.push(Ray { t_max: 0.0, ..next });
            rays.push(Ray::new(ray.origin, DVec3::ZERO.as_vec3()));
        }
    }
    rays.truncate(count);
    rays
}

#[test]
fn streams_answer_as_single_questions_do() {
    let mut chance = Chance::new(60);
    let of_shapes = |portable| mixed(&mut Chance::new(61), 1.0, 0.0).with_portable(portable);
    let crowd = |portable| instances::crowd(62, 2).with_portable(portable);
    for geometry in [of_shapes(false), of_shapes(true), crowd(false), crowd(true)] {
        for count in [0, 1, 7, 8, 9, 64, 1000] {
            let rays = rays(&mut chance, &geometry, count);
            // What was there before must not matter.
            let stale = geometry.meet(&Ray::new(glam::Vec3::Z * 4.0, -glam::Vec3::Z));
            assert!(stale.is_some());
            let mut met = vec![stale; count];
            geometry.meet_all(&rays, &mut met);
            let mut hits = vec![None; count];
            geometry.hit_all(&rays, &met, &mut hits);
            let mut occluded = vec![true; count];
            geometry.occluded_all(&rays, &mut occluded);
            for (i, ray) in rays.iter().enumerate() {
                assert_eq!(met[i], geometry.meet(ray), "{ray:?}");
                assert_eq!(hits[i], geometry.closest(ray), "{ray:?}");
                assert_eq!(occluded[i], geometry.occluded(ray), "{ray:?}");
                let told = |hit: &crate::render::geometry::Hit| (hit.t, hit.primitive);
                assert_eq!(met[i].map(|m| (m.t, m.primitive)), hits[i].as_ref().map(told));
            }
        }
    }
}
