//! Cameras: where a picture is taken from.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{Angle, Direction, Number, Point};

vocabulary! {
    /// Where the picture is taken from.
    pub enum Camera: "camera" {
        /// A pinhole that sees the whole scene: it looks at the centre of the bounding box of all
        /// bounded objects, from so many bounding-sphere radii away.
        "overview" => Overview {
            /// The direction it looks along.
            look: Direction = "-z";
            /// The direction that is up in the picture.
            up: Direction = "y";
            /// Distance from the centre, in radii of the bounding sphere.
            distance: Number = "1.75", Range::above(0.0);
            /// Vertical field of view, from edge to edge.
            fov_y: Angle = "53.13010235415598 deg", Range::inside(0.0, std::f64::consts::PI);
        }
        /// A pinhole: everything is sharp.
        "perspective" => Perspective {
            /// Where it stands.
            eye: Point;
            /// The point in the middle of the picture.
            look_at: Point;
            /// The direction that is up in the picture.
            up: Direction = "y";
            /// Vertical field of view, from edge to edge.
            fov_y: Angle, Range::inside(0.0, std::f64::consts::PI);
        }
    }
}
