//! Lambert's law: the same radiance in every direction, on both sides of the surface.
//!
//! Light is weighed at the shading normal, and what comes from below the surface is left out. So
//! where the two normals are an angle δ apart, (1 + cos δ)/2 of the albedo is scattered: in even
//! light a smooth mesh is darker by δ²/4 at most than what it stands for.

use std::f32::consts::FRAC_1_PI;

use glam::{DVec2, Vec2, Vec3};

use super::{Event, Facing, Scattered};
use crate::math::{Rgb, random, warp};
use crate::render::textures::Colour;

/// A diffuse surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Diffuse {
    /// The part of the light that is scattered back, on either side.
    pub albedo: Colour,
}

impl Diffuse {
    /// The surface at a hit.
    #[inline]
    pub(super) fn at(&self, uv: DVec2, facing: &Facing) -> Lambert {
        Lambert { albedo: self.albedo.at(uv), ..Lambert::black(facing) }
    }
}

/// A diffuse surface at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Lambert {
    pub(super) albedo: Rgb,
    /// Geometric normal on the viewer's side.
    pub(super) ng: Vec3,
    /// Shading normal on the same side.
    pub(super) ns: Vec3,
}

impl Lambert {
    /// One that scatters nothing.
    #[inline]
    pub(super) fn black(facing: &Facing) -> Self {
        Self { albedo: Rgb::BLACK, ng: facing.ng, ns: facing.ns }
    }

    /// albedo/π times the cosine at the shading normal.
    #[inline(always)]
    pub(super) fn scattered(&self, wi: Vec3) -> Rgb {
        self.albedo * (FRAC_1_PI * self.ns.dot(wi).max(0.0))
    }

    /// Whether `wi` is on the viewer's side of the geometric surface.
    #[inline(always)]
    pub(super) fn faces(&self, wi: Vec3) -> bool {
        self.ng.dot(wi) > 0.0
    }

    /// See [`super::Bsdf::side`].
    #[inline]
    pub fn side(&self) -> Vec3 {
        self.ns
    }

    /// Geometric normal on the viewer's side.
    #[inline]
    pub fn normal(&self) -> Vec3 {
        self.ng
    }

    /// The part of the light that is scattered back.
    #[inline]
    pub fn albedo(&self) -> Rgb {
        self.albedo
    }

    /// By the cosine to the shading normal; None below the surface, or black.
    #[inline(always)]
    pub(super) fn sample(&self, u: [f64; 2]) -> Option<Scattered> {
        let (way, some) = self.way(u);
        some.then_some(way)
    }

    /// The same, and whether it is one: without jumps, so that a loop over it becomes vectors.
    #[inline(always)]
    pub(super) fn way(&self, u: [f64; 2]) -> (Scattered, bool) {
        let u = Vec2::new(random::unit_f32(u[0]), random::unit_f32(u[1]));
        self.towards(warp::about(self.ns, warp::square_to_cosine(u)))
    }

    /// A direction as if the cosine had chosen it, and whether light goes there.
    #[inline(always)]
    pub fn towards(&self, wi: Vec3) -> (Scattered, bool) {
        let (weight, pdf_w) = (self.albedo, self.pdf_w(wi));
        let some = (pdf_w > 0.0) & self.faces(wi) & !weight.is_black();
        (Scattered { wi, weight, squeeze: 1.0, pdf_w, event: Event::DiffuseReflection }, some)
    }

    /// cos θ/π.
    #[inline(always)]
    pub fn pdf_w(&self, wi: Vec3) -> f32 {
        FRAC_1_PI * self.ns.dot(wi).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::geometry::{Geometry, Hit, Owner, Ray, Shapes, Triangle};

    /// A hit from above on a triangle that faces up, with a shading normal tilted towards +x.
    fn tilted() -> Hit {
        let mut shapes = Shapes::new();
        let corners = [Vec3::NEG_ONE, Vec3::new(2.0, -1.0, -1.0), Vec3::new(-1.0, 2.0, -1.0)];
        let corners = corners.map(|corner| shapes.vertex(corner));
        let normal = shapes.normal(Vec3::new(0.6, 0.0, 0.8));
        let normals = Some([normal; 3]);
        shapes.triangle(Triangle { corners, normals, owner: Owner::default() });
        let geometry = Geometry::build(shapes);
        geometry.closest(&Ray::new(Vec3::new(-0.5, -0.5, 2.0), Vec3::NEG_Z)).unwrap()
    }

    #[test]
    fn light_is_weighed_at_the_shading_normal_and_hidden_by_the_surface_itself() {
        let diffuse = Diffuse { albedo: Colour::Plain(Rgb::grey(0.5)) };
        let hit = tilted();
        let cases = [
            // Above both.
            (Vec3::Z, 0.8, true),
            (Vec3::new(0.6, 0.0, 0.8), 1.0, true),
            // Above the surface, below the shading normal.
            (Vec3::new(-0.96, 0.0, 0.28), 0.0, true),
            // Above the shading normal, below the surface.
            (Vec3::new(0.96, 0.0, -0.28), 0.352, false),
        ];
        for (wi, cos, faces) in cases {
            let above = diffuse.at(hit.uv, &Facing::new(&hit, Vec3::Z));
            let scattered = above.scattered(wi).g;
            assert!((scattered - 0.5 * FRAC_1_PI * cos).abs() < 1e-6, "{wi}: {scattered}");
            assert_eq!(above.faces(wi), faces);
            // From behind everything is as if the surface were turned round.
            let behind = diffuse.at(hit.uv, &Facing::new(&hit, Vec3::NEG_Z));
            assert_eq!((behind.scattered(-wi).g, behind.faces(-wi)), (scattered, faces));
        }
    }

    #[test]
    fn of_even_light_as_much_is_scattered_as_normals_agree() {
        for degrees in [0.0_f32, 10.0, 30.0, 60.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let ns = Vec3::new(sin, 0.0, cos);
            let facing = Facing { wo: Vec3::Z, ng: Vec3::Z, ns, front: true };
            let lambert = Lambert { albedo: Rgb::ONE, ..Lambert::black(&facing) };
            let side = 400;
            let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(side);
            let grid = (0..side * side).map(|i| [middle(i / side), middle(i % side)]);
            let ways = grid.filter_map(|u| lambert.sample(u));
            let sum: f64 = ways.map(|way| f64::from(way.weight.g)).sum();
            let (found, truth) = (sum / f64::from(side * side), 0.5 * f64::from(1.0 + cos));
            assert!((found - truth).abs() < 1e-3, "{degrees}: {found}, not {truth}");
        }
    }

    #[test]
    fn light_goes_either_way_alike() {
        let (a, b) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, -0.28, 0.96));
        let scattered = |wo: Vec3, wi: Vec3| {
            let facing = Facing { wo, ng: Vec3::Z, ns: Vec3::Z, front: true };
            let lambert = Lambert { albedo: Rgb::grey(0.7), ..Lambert::black(&facing) };
            lambert.scattered(wi).g / wi.z
        };
        assert!((scattered(a, b) - scattered(b, a)).abs() < 1e-7);
    }
}
