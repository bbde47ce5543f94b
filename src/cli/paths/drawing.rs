//! Paths as lines over the picture.

use glam::DVec3;

use super::gathered::{Bright, Caustic, Gathered, luminance};
use super::options::By;
use crate::math::{Lines, Picture, Rgb, clipped, srgb};
use crate::render::World;
use crate::render::integrators::Source;

/// What the picture below the lines is multiplied by, so that they stand out.
const DIMMED: f32 = 0.5;
/// How thick lines are, in pixels.
const WIDTH: f64 = 1.2;
/// How much lines hide at least and at most: by the cube root of what they bring, against the one
/// that brings most.
const OPACITY: [f64; 2] = [0.1, 0.9];
/// How far lines go towards a light without a place, in world units: about the size of the scene.
const FAR: f64 = 4.0;
/// Half the side of the square around the pixel, in pixels.
const MARK: f64 = 3.0;

/// A colour with its name, in sRGB.
pub type Named = (&'static str, [u8; 3]);

const PINK: Named = ("pink", [255, 105, 180]);
const BLUE: Named = ("blue", [70, 130, 255]);
const GREY: Named = ("grey", [190, 190, 190]);
const WHITE: Named = ("white", [255, 255, 255]);
/// Colours that all eyes tell apart, by Okabe and Ito.
const PALETTE: [Named; 7] = [
    ("orange", [230, 159, 0]),
    ("sky blue", [86, 180, 233]),
    ("green", [0, 158, 115]),
    ("yellow", [240, 228, 66]),
    ("blue", [0, 114, 178]),
    ("red", [213, 94, 0]),
    ("purple", [204, 121, 167]),
];

/// The colour of a class of paths.
pub fn colour(all: &Gathered, class: usize, by: By) -> Named {
    match by {
        By::Class => PALETTE.get(class).copied().unwrap_or(GREY),
        By::Caustic => match all.classes[class].caustic {
            Caustic::Direct => PINK,
            Caustic::Indirect => BLUE,
            Caustic::No => GREY,
        },
    }
}

/// The picture below the lines: as it is shown, dimmed.
pub fn background(picture: &Picture, exposure: f64) -> Picture {
    let factor = exposure as f32;
    let shown = |pixel: &Rgb| {
        let [r, g, b] = pixel.to_array().map(|x| DIMMED * (factor * x).clamp(0.0, 1.0));
        Rgb::new(r, g, b)
    };
    Picture { pixels: picture.pixels.iter().map(shown).collect(), ..picture.clone() }
}

/// The lines of so many paths, those that are no caustics below the others, and a square around
/// the pixel.
pub fn lines(world: &World, all: &Gathered, pixel: [u64; 2], by: By, most: usize) -> Vec<Lines> {
    let mut paths = all.of_each(most);
    let brought = |path: &Bright| luminance(path.radiance);
    let largest = paths.iter().map(|(_, path)| brought(path)).fold(0.0, f64::max);
    paths.sort_by(|(_, a), (_, b)| brought(a).total_cmp(&brought(b)));
    // The order within stays that of what they bring.
    paths.sort_by_key(|(class, _)| match all.classes[*class].caustic {
        Caustic::No => 0,
        Caustic::Indirect => 1,
        Caustic::Direct => 2,
    });
    let mut drawn: Vec<Lines> = paths
        .into_iter()
        .map(|(class, path)| {
            let part = (brought(path) / largest).max(0.0).cbrt();
            let [r, g, b] = path.radiance;
            Lines {
                pieces: pieces(world, path),
                colour: linear(colour(all, class, by)),
                width: WIDTH,
                opacity: OPACITY[0] + part * (OPACITY[1] - OPACITY[0]),
                title: format!("{}: {r:.4e} {g:.4e} {b:.4e}", all.classes[class].word),
            }
        })
        .collect();
    let [x, y] = pixel.map(|n| n as f64 + 0.5);
    let corner = |i: usize| {
        let (across, down) = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)][i % 4];
        [x + MARK * across, y + MARK * down]
    };
    drawn.push(Lines {
        pieces: (0..4).map(|i| [corner(i), corner(i + 1)]).collect(),
        colour: linear(WHITE),
        width: 1.0,
        opacity: 1.0,
        title: format!("pixel ({}, {})", pixel[0], pixel[1]),
    });
    drawn
}

/// A path on the film, from the first surface on: the way to it from the eye is a point.
fn pieces(world: &World, path: &Bright) -> Vec<[[f64; 2]; 2]> {
    let mut places: Vec<DVec3> =
        path.traced.surfaces.iter().map(|(_, place)| place.as_dvec3()).collect();
    match (path.traced.source, places.last()) {
        (Source::Point(place), _) => places.push(place.as_dvec3()),
        (Source::Direction(towards), Some(last)) => places.push(*last + FAR * towards.as_dvec3()),
        (Source::Direction(_), None) => {}
    }
    let [width, height] = world.film.size.map(|n| n as f64);
    // A little beyond the edges, where ends would be seen.
    let bounds = [[-WIDTH, width + WIDTH], [-WIDTH, height + WIDTH]];
    let ways = places.windows(2);
    ways.filter_map(|way| clipped(world.camera.projected(way[0], way[1])?, bounds)).collect()
}

fn linear((_, colour): Named) -> Rgb {
    let [r, g, b] = colour.map(|byte| srgb::decode(f64::from(byte) / 255.0) as f32);
    Rgb::new(r, g, b)
}
