//! Cameras: where a picture is taken from.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{Angle, Direction, Number, Point};

/// Fields of view.
const FIELD_OF_VIEW: Range =
    Range::at_least(1e-9_f64.to_radians()).below(std::f64::consts::PI).because(
        "In a narrower view the rays of neighbouring pixels begin to be one, even in double \
         precision; 180 deg are all that is before the eye.",
        "",
    );

vocabulary! {
    /// Where the picture is taken from.
    pub enum Camera: "camera" {
        /// A pinhole that looks at the centre of the bounding box of all bounded objects, from so
        /// many radii of the box's bounding sphere away. By its defaults, those of the course, a
        /// sphere of 0.78 of that radius fits the height of the picture: corners of the box may be
        /// cut off. On a square film `distance: 2.24` fits all of it.
        "overview" => Overview {
            /// The direction it looks along.
            look: Direction = "-z";
            /// The direction that is up in the picture.
            up: Direction = "y";
            /// Distance from the centre, in radii of the bounding sphere.
            distance: Number = "1.75", Range::above(0.0);
            /// Vertical field of view, from edge to edge.
            fov_y: Angle = "53.13010235415598 deg", FIELD_OF_VIEW;
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
            fov_y: Angle, FIELD_OF_VIEW;
        }
    }
}
