//! The Cornell box, from the measurements published by Cornell University's Program of Computer
//! Graphics ("Cornell Box Data"), in millimetres: x to the left as the camera sees it, y up, z
//! into the box. As the course models it: no front, a whole ceiling with the lamp 0.1 mm under
//! it, blocks that are closed at the bottom, and its plain colours.

use crate::obj::{self, Group};

/// The floor, seen from above.
const FLOOR: [[f64; 3]; 4] =
    [[552.8, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 559.2], [549.6, 0.0, 559.2]];
/// The lamp, facing down: 130 mm × 105 mm.
const LIGHT: [[f64; 3]; 4] =
    [[343.0, 548.7, 227.0], [343.0, 548.7, 332.0], [213.0, 548.7, 332.0], [213.0, 548.7, 227.0]];
const CEILING: [[f64; 3]; 4] =
    [[556.0, 548.8, 0.0], [556.0, 548.8, 559.2], [0.0, 548.8, 559.2], [0.0, 548.8, 0.0]];
const BACK_WALL: [[f64; 3]; 4] =
    [[549.6, 0.0, 559.2], [0.0, 0.0, 559.2], [0.0, 548.8, 559.2], [556.0, 548.8, 559.2]];
const RIGHT_WALL: [[f64; 3]; 4] =
    [[0.0, 0.0, 559.2], [0.0, 0.0, 0.0], [0.0, 548.8, 0.0], [0.0, 548.8, 559.2]];
const LEFT_WALL: [[f64; 3]; 4] =
    [[552.8, 0.0, 0.0], [549.6, 0.0, 559.2], [556.0, 548.8, 559.2], [556.0, 548.8, 0.0]];

/// The blocks: corners (x, z) of the top, counter-clockwise seen from above, and the height.
const SHORT_BLOCK: ([[f64; 2]; 4], f64) =
    ([[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]], 165.0);
const TALL_BLOCK: ([[f64; 2]; 4], f64) =
    ([[423.0, 247.0], [265.0, 296.0], [314.0, 456.0], [472.0, 406.0]], 330.0);

/// What the surfaces are: Ka is the lamp's radiance in W/m²/sr.
const BOX_MATERIALS: &str = "\
# The course's colours for the Cornell box. Ka is radiance: only the light shines.
newmtl white
Ka 0 0 0
Kd 0.9 0.9 0.9
Ks 0 0 0
illum 0

newmtl red
Ka 0 0 0
Kd 0.9 0 0
Ks 0 0 0
illum 0

newmtl green
Ka 0 0 0
Kd 0 0.9 0
Ks 0 0 0
illum 0

newmtl light
Ka 36.8 31.2 16
Kd 0 0 0
Ks 0 0 0
illum 1
";

const BLOCK_MATERIALS: &str = "\
# The blocks are as white as the walls.
newmtl white
Ka 0 0 0
Kd 0.9 0.9 0.9
Ks 0 0 0
illum 0
";

/// The files by name.
pub fn files() -> Vec<(&'static str, String)> {
    let wall = |name, material, quad: [[f64; 3]; 4]| Group { name, material, quads: vec![quad] };
    let walls = [
        wall("floor", "white", FLOOR),
        wall("light", "light", LIGHT),
        wall("ceiling", "white", CEILING),
        wall("back_wall", "white", BACK_WALL),
        wall("right_wall", "green", RIGHT_WALL),
        wall("left_wall", "red", LEFT_WALL),
    ];
    let blocks = [block("short_block", SHORT_BLOCK), block("tall_block", TALL_BLOCK)];
    let source = "from the measurements published by Cornell University; millimetres.";
    vec![
        (
            "cornell_box.obj",
            obj::text(&format!("The Cornell box, {source}"), "cornell_box.mtl", &walls),
        ),
        ("cornell_box.mtl", BOX_MATERIALS.to_string()),
        (
            "cornell_blocks.obj",
            obj::text(&format!("Cornell's blocks, {source}"), "cornell_blocks.mtl", &blocks),
        ),
        ("cornell_blocks.mtl", BLOCK_MATERIALS.to_string()),
    ]
}

/// A block standing on the floor, closed all around, its faces outward.
fn block(name: &'static str, (corners, height): ([[f64; 2]; 4], f64)) -> Group {
    let at = |i: usize, y: f64| [corners[i % 4][0], y, corners[i % 4][1]];
    let mut quads = vec![[at(0, height), at(1, height), at(2, height), at(3, height)]];
    quads.extend((0..4).map(|i| [at(i, 0.0), at(i + 1, 0.0), at(i + 1, height), at(i, height)]));
    quads.push([at(0, 0.0), at(3, 0.0), at(2, 0.0), at(1, 0.0)]);
    Group { name, material: "white", quads }
}
