//! A pinhole camera.
//!
//! Rays are computed in f64 and rounded at the end. At the narrowest fields of view a pixel is
//! smaller than the rounding of a direction (2⁻²⁴ rad, or 3.4e-6 deg): below about 0.003 deg over
//! 1000 pixels neighbouring rays begin to coincide, and the picture shows steps.

use glam::DVec3;

use crate::render::geometry::Ray;

/// A pinhole camera in world space.
#[derive(Clone, Debug)]
pub struct Perspective {
    eye: DVec3,
    /// Unit length.
    forward: DVec3,
    /// To the right by one pixel, at distance 1.
    right: DVec3,
    /// Down by one pixel, at distance 1.
    down: DVec3,
    /// From the film's corner to the axis, in pixels.
    middle: [f64; 2],
    /// Radius about the origin beyond which there is nothing to meet but floors.
    reach: f64,
    floors: Vec<Floor>,
}

/// Lines are cut off before the camera, at so many parts of their larger distance.
const NEAR: f64 = 1e-6;

/// A plane without end, in f64: it can be met before the rest of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Floor {
    normal: DVec3,
    /// Distance from the origin along the normal.
    height: f64,
}

impl Floor {
    /// The plane through `point`, square to `normal`, of unit length.
    pub fn new(point: DVec3, normal: DVec3) -> Self {
        Self { normal, height: normal.dot(point) }
    }
}

impl Perspective {
    /// A camera at `eye` that looks along `forward`, with `up` upwards in the picture; both of
    /// unit length and not parallel. `fov_y`: vertical field of view from edge to edge, in
    /// radians, inside (0, π). `size`: columns and rows of the whole film.
    pub fn new(eye: DVec3, forward: DVec3, up: DVec3, fov_y: f64, size: [u64; 2]) -> Self {
        let [width, height] = size.map(|n| n as f64);
        let pixel = 2.0 * (0.5 * fov_y).tan() / height;
        let right = forward.cross(up).normalize();
        let down = forward.cross(right);
        Self {
            eye,
            forward,
            right: right * pixel,
            down: down * pixel,
            middle: [0.5 * width, 0.5 * height],
            reach: f64::INFINITY,
            floors: Vec::new(),
        }
    }

    /// The same camera for a scene within `reach` of the origin, but for `floors`: its rays begin
    /// where the scene does. A far eye's rays aim in f64 then, however far it is.
    pub fn starting(self, reach: f64, floors: Vec<Floor>) -> Self {
        Self { reach, floors, ..self }
    }

    /// The same camera, with a film of `size` pixels spread over a part of its own: the `extent`
    /// pixels from `corner` on.
    pub(super) fn over(&self, corner: [u64; 2], extent: [u64; 2], size: [u64; 2]) -> Self {
        let [x, y] = [0, 1].map(|i| extent[i] as f64 / size[i] as f64);
        let middle =
            [(self.middle[0] - corner[0] as f64) / x, (self.middle[1] - corner[1] as f64) / y];
        Self { right: self.right * x, down: self.down * y, middle, ..self.clone() }
    }

    /// The ray through a place on the film.
    pub(super) fn ray(&self, x: f64, y: f64) -> Ray {
        let aim =
            self.forward + self.right * (x - self.middle[0]) + self.down * (y - self.middle[1]);
        let direction = aim.normalize();
        let empty = self.empty(direction);
        let origin = if empty > 0.0 { self.eye + direction * empty } else { self.eye };
        Ray::new(origin.as_vec3(), direction.as_vec3())
    }

    /// Where the part of a line before the camera lies on the film.
    pub(super) fn projected(&self, from: DVec3, to: DVec3) -> Option<[[f64; 2]; 2]> {
        let ends = [from - self.eye, to - self.eye];
        let depths = ends.map(|end| self.forward.dot(end));
        // At the eye itself a line has no place on the film; short of it, one that is far away.
        let near = NEAR * ends[0].length().max(ends[1].length());
        if !(depths[0] > near || depths[1] > near) {
            return None;
        }
        let place = |end: usize| {
            let (mut point, mut depth) = (ends[end], depths[end]);
            if depth < near {
                let other = 1 - end;
                let part = (near - depth) / (depths[other] - depth);
                (point, depth) = (point.lerp(ends[other], part), near);
            }
            let along = |axis: DVec3| point.dot(axis) / axis.length_squared() / depth;
            [self.middle[0] + along(self.right), self.middle[1] + along(self.down)]
        };
        Some([place(0), place(1)])
    }

    /// Length of the way from the eye on which there is nothing to meet.
    fn empty(&self, direction: DVec3) -> f64 {
        let mut empty = -self.eye.dot(direction) - self.reach;
        if empty > 0.0 {
            for floor in &self.floors {
                let met = (floor.height - floor.normal.dot(self.eye)) / floor.normal.dot(direction);
                // Short of it by far more than its rounding in the world.
                if met > 0.0 {
                    empty = empty.min(0.999 * met);
                }
            }
        }
        empty
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(fov_deg: f64, size: [u64; 2]) -> Perspective {
        let eye = DVec3::new(0.0, 0.0, 3.0);
        Perspective::new(eye, DVec3::NEG_Z, DVec3::Y, fov_deg.to_radians(), size)
    }

    #[test]
    fn lines_are_projected_where_their_rays_are_and_cut_behind_the_camera() {
        let camera = camera(50.0, [40, 30]);
        let on = |x: f64, y: f64, t: f64| {
            let ray = camera.ray(x, y);
            ray.origin.as_dvec3() + t * ray.direction.as_dvec3()
        };
        let [a, b] = camera.projected(on(3.0, 29.0, 2.0), on(50.0, -4.0, 9.0)).unwrap();
        for (found, expected) in [(a, [3.0, 29.0]), (b, [50.0, -4.0])] {
            assert!((0..2).all(|i| (found[i] - expected[i]).abs() < 1e-4), "{found:?}");
        }
        assert_eq!(camera.projected(on(3.0, 4.0, -1.0), on(5.0, 4.0, -2.0)), None);
        // From before the camera past it: to the right, however far.
        let beside = camera.eye + DVec3::new(1.0, 0.0, 1.0);
        let [a, b] = camera.projected(on(20.0, 15.0, 2.0), beside).unwrap();
        assert!((a[0] - 20.0).abs() < 1e-4 && b[0] > 1e5 && (b[1] - 15.0).abs() < 1.0, "{b:?}");
    }

    #[test]
    fn right_is_right_and_up_is_up() {
        let camera = camera(90.0, [4, 2]);
        let corner = camera.ray(4.0, 0.0).direction;
        let expected = glam::Vec3::new(2.0, 1.0, -1.0).normalize();
        assert!((corner - expected).length() < 1e-6, "{corner}");
        assert_eq!(camera.ray(2.0, 1.0).direction, glam::Vec3::NEG_Z);
        assert_eq!(camera.ray(2.0, 1.0).origin, glam::Vec3::new(0.0, 0.0, 3.0));
    }

    #[test]
    fn another_film_over_a_window_sees_what_is_in_it() {
        let camera = camera(70.0, [40, 20]);
        let small = camera.over([4, 2], [30, 16], [10, 4]);
        for (u, v) in [(0.0, 0.0), (0.3, 0.9), (1.0, 1.0)] {
            let there = camera.ray(4.0 + 30.0 * u, 2.0 + 16.0 * v).direction;
            let here = small.ray(10.0 * u, 4.0 * v).direction;
            assert!((there - here).length() < 1e-6, "{there} {here}");
        }
    }

    #[test]
    fn extreme_fields_of_view_and_films_give_unit_directions() {
        for (fov, size) in
            [(1e-3, [512, 512]), (179.9, [512, 512]), (60.0, [1, 65_535]), (60.0, [65_535, 1])]
        {
            let camera = camera(fov, size);
            for (x, y) in [(0.0, 0.0), (0.5, 0.5), (size[0] as f64, size[1] as f64), (-8.0, 1e5)] {
                let direction = camera.ray(x, y).direction;
                assert!((direction.length() - 1.0).abs() < 1e-6, "{fov} {size:?} {direction}");
            }
        }
        // The top edge lies at half the field of view.
        let top = camera(179.9, [512, 512]).ray(256.0, 0.0).direction;
        let angle = f64::from(top.y).atan2(-f64::from(top.z)).to_degrees();
        assert!((angle - 89.95).abs() < 1e-4, "{angle}");
    }

    #[test]
    fn narrow_views_lose_no_more_than_rounding() {
        let camera = camera(1e-3, [1000, 1000]);
        let edge = camera.ray(1000.0, 500.0).direction;
        assert!((f64::from(edge.x) / (0.5e-3_f64).to_radians() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_far_eye_is_brought_close() {
        let eye = DVec3::new(1e9, 2e9, 3e9);
        let forward = -eye.normalize();
        let camera = Perspective::new(eye, forward, DVec3::Y, 1e-9, [100, 100]);
        let camera = camera.starting(2.0, Vec::new());
        // One pixel spans 1e-11 rad · 3.7e9 = 0.037 units where the scene is.
        let (a, b) = (camera.ray(50.0, 50.0), camera.ray(60.0, 50.0));
        let step = (b.origin - a.origin).length();
        assert!(a.origin.length() < 2.01);
        assert!((step / (10.0 * 1e-11 * eye.length() as f32) - 1.0).abs() < 1e-3, "{step}");
        // A floor in between is not jumped over.
        let height = DVec3::new(0.0, 1e9, 0.0);
        let camera = camera.starting(2.0, vec![Floor::new(height, DVec3::Y)]);
        assert!(camera.ray(50.0, 50.0).origin.y > 1e9);
    }
}
