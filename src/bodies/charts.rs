//! Charts: the maps from metres to where textures lie on spheres, disks and planes.

use glam::{DAffine3, DMat3, DVec2, DVec3};

use crate::math::Transform;
use crate::scene;

/// A normal whose part along x leaves less than this of x in its plane is square to x.
const SQUARE: f64 = 1e-6;

/// A sphere: to the unit sphere.
pub fn sphere(place: Transform, sphere: &scene::Sphere) -> Transform {
    let shrink = DAffine3::from_scale(DVec3::splat(1.0 / sphere.radius.0));
    back(place, sphere.center.0).then(Transform(shrink))
}

/// A disk: 0 to 1 over the square around it.
pub fn disk(place: Transform, disk: &scene::Disk) -> Transform {
    let size = 2.0 * disk.radius.0;
    back(place, disk.center.0).then(flat(disk.normal.0, size, DVec2::splat(0.5)))
}

/// A plane: 1 for each tile.
pub fn plane(place: Transform, plane: &scene::Plane) -> Transform {
    back(place, plane.point.0).then(flat(plane.normal.0, plane.tile.0, DVec2::ZERO))
}

/// From metres to where the object is described, with this origin.
fn back(place: Transform, origin: DVec3) -> Transform {
    Transform(place.0.inverse()).then(Transform(DAffine3::from_translation(-origin)))
}

/// A plane through the origin: `unit` metres are 1 of u and of v; the origin is at `uv`.
fn flat(normal: DVec3, unit: f64, uv: DVec2) -> Transform {
    let u = along(normal);
    let axes = DMat3::from_cols(u, normal.cross(u), normal);
    let map = DMat3::from_diagonal(DVec3::splat(1.0 / unit)) * axes.transpose();
    Transform(DAffine3::from_mat3_translation(map, uv.extend(0.0)))
}

/// Where u goes on a plane of this normal: along x as far as it can; to the right, seen from the
/// front with y upward, on a plane square to x.
fn along(normal: DVec3) -> DVec3 {
    let u = DVec3::X - normal.x * normal;
    if u.length() > SQUARE { u.normalize() } else { DVec3::NEG_Z * normal.x.signum() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn textures_stand_upright_on_walls_whichever_way_they_face() {
        for normal in [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::new(0.6, 0.0, 0.8)] {
            let map = flat(normal, 2.0, DVec2::ZERO);
            assert!((map.point(DVec3::Y) - DVec3::Y / 2.0).length() < 1e-12, "{normal}");
            // To the right of who looks at the front.
            let right = DVec3::Y.cross(normal);
            assert!((map.point(right) - DVec3::X / 2.0).length() < 1e-12, "{normal}");
        }
        let floor = flat(DVec3::Y, 1.0, DVec2::ZERO);
        assert_eq!(floor.point(DVec3::X), DVec3::X);
        assert_eq!(floor.point(DVec3::NEG_Z), DVec3::Y);
    }
}
