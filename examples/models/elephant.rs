//! An elephant, bald and rearing: our own, put together of round limbs, balls and sheets. Lengths
//! in centimetres, y up, facing z, standing on y = 0; its left is +x.

use glam::{DMat3, DVec3};

use crate::field::{Figure, Part, Shape};
use crate::{obj, sculpt};

/// The names of the materials, by the index that parts have.
const MATERIALS: [&str; 3] = ["skin", "ivory", "dark"];
const SKIN: usize = 0;
const IVORY: usize = 1;
const DARK: usize = 2;

/// The box it is made in, in centimetres.
const BOX: [DVec3; 2] = [DVec3::new(-14.13, -1.07, -13.11), DVec3::new(14.0, 33.0, 18.5)];
/// The side of a cell, in centimetres: eyes and ears are twice as thick.
const CELL: f64 = 0.3;
/// How many triangles it may have.
const TRIANGLES: usize = 12_000;
/// Digits after the point: hundredths of a millimetre, and normals to 0.03 degrees.
const DIGITS: [usize; 2] = [3, 3];

const MTL: &str = "\
# An elephant of our own: grey skin, ivory tusks, dark eyes and nails.
newmtl skin
Ka 0 0 0
Kd 0.5 0.48 0.48
Ks 0 0 0
illum 0

newmtl ivory
Ka 0 0 0
Kd 0.85 0.8 0.68
Ks 0 0 0
illum 0

newmtl dark
Ka 0 0 0
Kd 0.08 0.06 0.05
Ks 0 0 0
illum 0
";

/// Pieces that a bent limb has between two of its given balls.
const PIECES: usize = 5;

/// The files by name.
pub fn files() -> Vec<(&'static str, String)> {
    let mut elephant = sculpt::sculpt(&figure(), BOX, CELL, TRIANGLES);
    for position in &mut elephant.mesh.positions {
        position.y = position.y.max(0.0);
    }
    let groups = [0, 1, 2].map(|material| {
        let of_it = |&i: &usize| elephant.materials[i] == material;
        (MATERIALS[material], (0..elephant.materials.len()).filter(of_it).collect())
    });
    let text = obj::Smooth {
        comment: "A rearing elephant of our own; centimetres.",
        library: Some("elephant.mtl"),
        mesh: &elephant.mesh,
        normals: &elephant.mesh.smooth_normals(),
        digits: DIGITS,
        groups: &groups,
    }
    .text();
    vec![("elephant.obj", text), ("elephant.mtl", MTL.to_string())]
}

/// The whole of it.
fn figure() -> Figure {
    let mut parts = torso();
    parts.extend(head());
    for side in [1.0, -1.0] {
        parts.extend(ear(side));
    }
    // One of the raised legs is higher: it treads the air.
    parts.extend(leg(
        [[3.4, 17.6, 1.0], [5.0, 14.6, 5.0], [5.6, 15.0, 8.8], [5.7, 16.2, 10.9]],
        [3.6, 2.7, 2.1, 2.3],
        [-0.05, 0.62, 0.78],
        [0.3, -0.78, 0.6],
    ));
    parts.extend(leg(
        [[-3.4, 17.4, 1.0], [-5.0, 13.8, 4.6], [-5.2, 12.8, 8.2], [-5.1, 11.2, 10.2]],
        [3.6, 2.7, 2.1, 2.3],
        [0.05, -0.5, 0.86],
        [0.0, 0.86, 0.5],
    ));
    for side in [1.0, -1.0] {
        parts.extend(leg(
            [
                [side * 3.2, 9.4, -2.6],
                [side * 4.3, 6.0, 0.7],
                [side * 4.4, 2.6, -0.6],
                [side * 4.5, 0.0, 0.1],
            ],
            [4.6, 3.3, 2.5, 2.7],
            [0.0, -1.0, 0.0],
            [side * 0.25, 0.0, 1.0],
        ));
    }
    for side in [1.0, -1.0] {
        parts.push(whole(
            limb(&[
                ([side * 2.1, 23.0, 6.3], 0.95),
                ([side * 3.2, 21.0, 8.8], 0.85),
                ([side * 3.9, 20.3, 11.2], 0.66),
                ([side * 4.0, 21.2, 13.6], 0.4),
                ([side * 3.7, 22.4, 14.8], 0.2),
            ]),
            0.4,
            IVORY,
        ));
        parts.push(whole(Shape::ball(DVec3::new(side * 3.55, 25.3, 6.7), 0.72), 0.25, DARK));
    }
    Figure::new(parts)
}

fn torso() -> Vec<Part> {
    let back = limb(&[
        ([0.0, 9.6, -3.4], 5.6),
        ([0.0, 13.2, -2.0], 6.2),
        ([0.0, 17.4, -0.4], 5.4),
        ([0.0, 21.2, 1.4], 4.2),
        ([0.0, 24.0, 2.6], 3.6),
    ]);
    let tail = limb(&[
        ([0.0, 9.6, -8.2], 0.9),
        ([0.3, 7.6, -9.8], 0.6),
        ([0.9, 5.2, -10.5], 0.48),
        ([1.7, 3.6, -11.0], 0.45),
    ]);
    vec![
        whole(back, 0.0, SKIN),
        whole(tail, 1.0, SKIN),
        whole(Shape::ball(DVec3::new(1.9, 3.1, -11.2), 0.75), 0.6, SKIN),
    ]
}

fn head() -> Vec<Part> {
    let ellipsoid = |center: [f64; 3], radii: [f64; 3]| Shape::Ellipsoid {
        center: center.into(),
        axes: DMat3::IDENTITY,
        radii: radii.into(),
    };
    let trunk = limb(&[
        ([0.0, 25.0, 5.6], 3.0),
        ([0.0, 23.2, 8.6], 2.3),
        ([0.1, 22.2, 11.4], 1.85),
        ([0.5, 22.8, 14.2], 1.6),
        ([1.0, 25.2, 16.0], 1.4),
        ([1.4, 28.0, 15.8], 1.22),
        ([1.6, 30.0, 14.4], 1.1),
    ]);
    let mut parts = vec![
        whole(ellipsoid([0.0, 25.4, 4.0], [4.0, 4.2, 4.2]), 1.5, SKIN),
        whole(trunk, 1.4, SKIN),
        whole(
            limb(&[([0.0, 21.6, 4.6], 1.9), ([0.0, 20.2, 7.6], 1.15), ([0.0, 20.4, 8.8], 0.75)]),
            0.5,
            SKIN,
        ),
    ];
    for side in [1.0, -1.0] {
        parts.push(whole(ellipsoid([side * 1.7, 27.7, 3.9], [2.4, 2.4, 2.8]), 1.2, SKIN));
        // Cheek, and the brow over the eye.
        parts.push(whole(Shape::ball(DVec3::new(side * 2.0, 23.3, 6.1), 1.6), 1.5, SKIN));
        parts.push(whole(
            limb(&[
                ([side * 2.4, 26.95, 6.9], 0.5),
                ([side * 3.5, 26.95, 6.2], 0.5),
                ([side * 4.1, 26.1, 5.2], 0.4),
            ]),
            0.5,
            SKIN,
        ));
    }
    parts
}

/// An ear: a fan hung at the back of the head, its rim bent forward.
fn ear(side: f64) -> Vec<Part> {
    let out = DVec3::new(side * 0.93, 0.05, -0.36).normalize();
    let up = DVec3::new(-side * 0.1, 1.0, -0.05);
    let up = (up - out * up.dot(out)).normalize();
    let front = out.cross(up) * side;
    let fan = Shape::Sheet {
        center: DVec3::new(side * 3.4, 26.2, 2.4),
        axes: DMat3::from_cols(out, up, front),
        discs: vec![
            ([0.4, 0.2], 2.4),
            ([3.6, 1.7], 3.5),
            ([5.2, 0.4], 3.6),
            ([4.6, -2.4], 3.0),
            ([4.2, -4.0], 1.9),
            ([0.9, -2.6], 2.2),
        ],
        blend: 1.6,
        bend: 0.035,
        half: 0.4,
    };
    vec![whole(fan, 0.9, SKIN)]
}

/// A leg from the body to its sole, through balls at `places` with `radii`; `down` is where the
/// sole looks, `ahead` where the middle nail is.
fn leg(places: [[f64; 3]; 4], radii: [f64; 4], down: [f64; 3], ahead: [f64; 3]) -> Vec<Part> {
    let (down, sole) = (DVec3::from(down).normalize(), DVec3::from(places[3]));
    let ahead = DVec3::from(ahead);
    let ahead = (ahead - down * ahead.dot(down)).normalize();
    let aside = down.cross(ahead);
    let cut = Some((sole, down, 0.3));
    let mut balls: Vec<([f64; 3], f64)> = places.into_iter().zip(radii).collect();
    balls.push(((sole + down * 0.8).to_array(), radii[3]));
    let mut parts = vec![Part { shape: limb(&balls), blend: 1.6, material: SKIN, cut }];
    for turn in [-1.0, 0.0, 1.0] {
        let to = (ahead + aside * turn * 0.9).normalize();
        let center = sole - down * 0.55 + to * (radii[3] - 0.2);
        let shape = Shape::ball(center, 0.72);
        parts.push(Part { shape, blend: 0.3, material: DARK, cut });
    }
    parts
}

fn whole(shape: Shape, blend: f64, material: usize) -> Part {
    Part { shape, blend, material, cut: None }
}

/// A limb through balls, bent smoothly [Catmull74].
fn limb(balls: &[([f64; 3], f64)]) -> Shape {
    let balls: Vec<glam::DVec4> =
        balls.iter().map(|&(place, radius)| DVec3::from(place).extend(radius)).collect();
    let at = |i: isize| balls[i.clamp(0, balls.len() as isize - 1) as usize];
    let mut way = Vec::new();
    for i in 0..balls.len() as isize - 1 {
        let [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
        for piece in 0..PIECES {
            let t = piece as f64 / PIECES as f64;
            way.push(
                (b * 2.0
                    + (c - a) * t
                    + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t)
                    + (b * 3.0 - a - c * 3.0 + d) * (t * t * t))
                    * 0.5,
            );
        }
    }
    way.push(balls[balls.len() - 1]);
    Shape::Limb(way.into_iter().map(|ball| (ball.truncate(), ball.w)).collect())
}
