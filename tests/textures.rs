//! Textures, end to end: each place of a surface has the colour that its texture has there.

mod shots;

use scn::math::Picture;
use shots::Shot;

/// The one render of a text, as if it stood in a folder.
fn open(folder: &std::path::Path, text: &str) -> Result<Shot, String> {
    let text = format!("scn 1 in m\nsampler: independent\nstop: {{ samples: 4 }}\n{text}");
    shots::open_text(&folder.join("it.scn"), &text, &[]).map(|mut all| all.remove(0))
}

/// A picture of what the surfaces give back of a light that is the same everywhere: their albedos.
fn albedos(body: &str, size: (u32, u32)) -> Picture {
    picture(std::path::Path::new("."), body, size)
}

fn picture(folder: &std::path::Path, body: &str, (width, height): (u32, u32)) -> Picture {
    let text = format!(
        "film: {{ size: ({width}, {height}), filter: box {{}} }}\n\
         light around: constant {{ radiance: 1 W/m^2/sr }}\n\
         integrator: direct {{ environment: on }}\n{body}"
    );
    let shot = open(folder, &text).unwrap_or_else(|report| panic!("{report}"));
    shot.picture(&shot.prepare(1.0), 0)
}

/// A camera far away that sees 2 × 2 metres about the origin, z towards it and y upward.
const FRONT: &str =
    "camera: perspective { eye: (0, 0, 2000), look_at: (0, 0, 0), fov_y: 0.0572957767 deg }\n";

fn grey(picture: &Picture, x: usize, y: usize) -> f32 {
    picture.at(x, y).g
}

#[test]
fn a_checker_has_its_squares_where_it_says() {
    let quad =
        "object board: quad { corner: (-1, -1, 0), u: (2, 0, 0), v: (0, 2, 0), material: it }\n";
    let checker =
        "material it: diffuse { albedo: checker { a: 0.75, b: 0.25, squares: (4, 2) } }\n";
    let seen = albedos(&format!("{FRONT}{quad}{checker}"), (8, 8));
    for y in 0..8 {
        for x in 0..8 {
            // Rows go down, v goes up.
            let odd = (x / 2 + (7 - y) / 4) % 2 == 1;
            let expected = if odd { 0.25 } else { 0.75 };
            assert!((grey(&seen, x, y) - expected).abs() < 1e-5, "{x} {y}: {}", grey(&seen, x, y));
        }
    }
}
