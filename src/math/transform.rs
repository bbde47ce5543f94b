//! Placing things: affine maps in f64.

use glam::{DAffine3, DMat3, DVec3};

/// An affine map. Points, directions and normals go through it differently.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform(pub DAffine3);

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self(DAffine3::IDENTITY);

    /// First `self`, then `next`.
    pub fn then(self, next: Self) -> Self {
        Self(next.0 * self.0)
    }

    /// Where a point goes.
    #[inline]
    pub fn point(self, p: DVec3) -> DVec3 {
        self.0.transform_point3(p)
    }

    /// Where a direction or an edge goes; its length changes with the scale.
    pub fn vector(self, v: DVec3) -> DVec3 {
        self.0.transform_vector3(v)
    }

    /// The map of normals: the cofactor matrix, which exists for flat scales too. Not unit length.
    pub fn normal(self, n: DVec3) -> DVec3 {
        let m = self.0.matrix3;
        let cofactors = DMat3::from_cols(
            m.y_axis.cross(m.z_axis),
            m.z_axis.cross(m.x_axis),
            m.x_axis.cross(m.y_axis),
        );
        cofactors * n
    }

    /// Whether it turns front faces into back faces.
    pub fn mirrors(self) -> bool {
        self.0.matrix3.determinant() < 0.0
    }

    /// Whether it has an inverse, in finite numbers.
    pub fn is_invertible(self) -> bool {
        let determinant = self.0.matrix3.determinant();
        determinant != 0.0 && determinant.is_finite() && self.0.is_finite()
    }

    /// Its scale, if it is the same in every direction to within rounding.
    pub fn uniform_scale(self) -> Option<f64> {
        let m = self.0.matrix3;
        let scale = m.x_axis.length();
        let gram = m.transpose() * m;
        let ideal = DMat3::from_diagonal(DVec3::splat(scale * scale));
        let near = (gram - ideal).abs().to_cols_array().iter().all(|e| *e <= 1e-12 * scale * scale);
        near.then_some(scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_stay_square_to_surfaces() {
        let stretch = Transform(DAffine3::from_scale(DVec3::new(2.0, 1.0, 0.5)));
        let (edge, normal) = (DVec3::new(1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 0.0));
        assert!(stretch.vector(edge).dot(stretch.normal(normal)).abs() < 1e-15);
        assert_eq!(stretch.uniform_scale(), None);
        let mirrored = Transform(DAffine3::from_scale(DVec3::new(-3.0, 3.0, 3.0)));
        assert!(mirrored.mirrors());
        assert_eq!(mirrored.uniform_scale(), Some(3.0));
    }
}
