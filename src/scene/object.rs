//! Objects: what there is to be seen.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{At, Direction, FileName, Length, Material, NameOf, Place, Point, Ref};
use crate::diag::Span;

vocabulary! {
    /// A surface, or many.
    pub enum Object: "object" {
        /// A flat round disk; its front is where the normal points.
        "disk" => Disk {
            /// Its centre.
            center: Point;
            /// Square to it, on its front side.
            normal: Direction;
            /// Its radius.
            radius: Length, Range::above(0.0);
            /// What its surface does with light.
            material: Ref<Material>;
            /// Where it is moved to, step by step; scales must be even.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
        /// Triangles from a Wavefront file. Faces are counter-clockwise seen from their front.
        "mesh" => Mesh {
            /// The .obj file.
            file: FileName;
            /// The length of one unit of the file.
            unit: Length, Range::above(0.0);
            /// A .mtl file to take materials from, in place of those the .obj file names.
            mtl: Option<FileName>;
            /// Replaces all materials of the file.
            material: Option<Ref<Material>>;
            /// Replaces materials of the file by the name they have there.
            materials: Vec<(At<String>, At<Ref<Material>>)> = "{}";
            /// Cracks and holes of the surface around a medium are closed that are no wider than this.
            mend: Length = "0 m", Range::at_least(0.0);
            /// What a Ka in the .mtl file means; must be said where one is not zero.
            ambient: Option<KaMeans>;
            /// Where it is moved to, step by step.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
        /// A plane without end; its front is where the normal points.
        "plane" => Plane {
            /// A point of it.
            point: Point;
            /// Square to it, on its front side.
            normal: Direction;
            /// What its surface does with light.
            material: Ref<Material>;
            /// The side of the square that is 1 of u and 1 of v for textures, whose origin is
            /// `point`. There u goes along x as far as the plane does, and -z or z where it is
            /// square to x; v is upward, or away on a floor.
            tile: Length = "1 m", Range::above(0.0);
            /// Where it is moved to, step by step.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
        /// A parallelogram: `corner`, `corner + u`, `corner + u + v`, `corner + v`; its front is
        /// where u × v points.
        "quad" => Quad {
            /// The first corner.
            corner: Point;
            /// The edge from the first corner to the second.
            u: Point;
            /// The edge from the first corner to the fourth.
            v: Point;
            /// What its surface does with light.
            material: Ref<Material>;
            /// Where it is moved to, step by step.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
        /// A true sphere; its front is outside.
        "sphere" => Sphere {
            /// Its centre.
            center: Point;
            /// Its radius.
            radius: Length, Range::above(0.0);
            /// What its surface does with light.
            material: Ref<Material>;
            /// Where it is moved to, step by step; scales must be even.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
        /// A single triangle; its front sees a, b, c counter-clockwise.
        "triangle" => Triangle {
            /// The first corner.
            a: Point;
            /// The second corner.
            b: Point;
            /// The third corner.
            c: Point;
            /// What its surface does with light.
            material: Ref<Material>;
            /// Where it is moved to, step by step.
            place: Place = "[]";
            /// An object at whose surface what is inside of this one ends, as a drink ends at its glass.
            yields_to: Option<NameOf<Object>>;
        }
    }
}

impl Object {
    /// Where it says how far points of its open edges may lie apart and are joined.
    pub fn mend(&self) -> Option<Span> {
        match self {
            Self::Mesh(it) => Some(it.mend.span),
            _ => None,
        }
    }

    /// The object it yields to.
    pub fn yields_to(&self) -> &At<Option<NameOf<Object>>> {
        match self {
            Self::Disk(it) => &it.yields_to,
            Self::Mesh(it) => &it.yields_to,
            Self::Plane(it) => &it.yields_to,
            Self::Quad(it) => &it.yields_to,
            Self::Sphere(it) => &it.yields_to,
            Self::Triangle(it) => &it.yields_to,
        }
    }
}

vocabulary! {
    /// What a Ka in a .mtl file means. Programs write it for anything.
    pub words KaMeans: "meaning of Ka" {
        /// The radiance the surface emits, in W/m²/sr.
        "emission" => Emission
        /// Nothing.
        "ignored" => Ignored
    }
}
