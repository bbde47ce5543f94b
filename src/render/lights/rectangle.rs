//! Uniform points in the solid angle of a rectangle [Urena13].

use std::f64::consts::TAU;

use glam::DVec3;

/// A rectangle as a site sees it, in a frame of its own: x and y along its edges, z away from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidRectangle {
    x: [f64; 2],
    y: [f64; 2],
    /// Of its plane; negative.
    z: f64,
    /// Of each edge along x: its y over its distance from the x axis through the site.
    edges: [f64; 2],
    /// What the third and fourth corner's angles lack of a full turn.
    turn: f64,
    /// In sr.
    pub solid_angle: f64,
}

impl SolidRectangle {
    /// From x to x and from y to y, at this height above (or, if negative, below) the site, which
    /// is the origin and not in its plane.
    pub fn new(x: [f64; 2], y: [f64; 2], height: f64) -> Self {
        let z = -height.abs();
        // Sines of the angles between the frame's z and the planes through the origin and an edge:
        // z of their normals.
        let [x0, _] = x.map(|x| x / z.hypot(x));
        let [y0, y1] = y.map(|y| y / z.hypot(y));
        // Angles of the spherical rectangle at two of its corners.
        let (g2, g3) = ((x0 * y1).clamp(-1.0, 1.0).acos(), (-x0 * y0).clamp(-1.0, 1.0).acos());
        let part = |x: f64, y: f64| (x * y / (-z * (x * x + y * y + z * z).sqrt())).atan();
        let solid_angle = part(x[1], y[1]) - part(x[0], y[1]) - part(x[1], y[0]) + part(x[0], y[0]);
        Self { x, y, z, edges: [y0, y1], turn: TAU - g2 - g3, solid_angle }
    }

    /// A point of it, x and y, uniform in solid angle.
    pub fn sample(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [b0, b1] = [-self.edges[0], self.edges[1]];
        let angle = u * self.solid_angle + self.turn;
        let f = (angle.cos() * b0 - b1) / angle.sin();
        let c = (1.0 / f.hypot(b0)).copysign(f).clamp(-1.0, 1.0);
        let x = -c * self.z / (1.0 - c * c).max(f64::MIN_POSITIVE).sqrt();
        let x = x.clamp(self.x[0], self.x[1]);
        let d_2 = x * x + self.z * self.z;
        let [h0, h1] = self.y.map(|y| y / (d_2 + y * y).sqrt());
        let h = h0 + v * (h1 - h0);
        let y = h * (d_2 / (1.0 - h * h).max(f64::MIN_POSITIVE)).sqrt();
        [x, y.clamp(self.y[0], self.y[1])]
    }

    /// Where a point of it is, seen from the site, in its frame.
    pub fn way(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new(x, y, self.z)
    }
}
