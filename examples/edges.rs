//! How far the edges of figure 4 are from smooth, by rays a pixel: the table in
//! docs/worksheets.md.
//!
//! `cargo run --release --example edges`

#[path = "../tests/shots/mod.rs"]
mod shots;

use scn::math::Picture;

const SCENE: &str = "scenes/w01_first_pictures.scn";
const RENDER: &str = "fig04";
/// Cells along a side of a pixel.
const GRIDS: [u64; 6] = [1, 2, 3, 4, 6, 8];
/// The picture that the others are held to, of another seed.
const REFERENCE: u64 = 32;
/// A pixel is on an edge if it differs by so much from one beside it.
const STEP: f32 = 0.2;

fn main() {
    let truth = picture("stratified", REFERENCE, 1);
    let edges = edges(&truth);
    let share = edges.len() as f64 / truth.pixels.len() as f64;
    println!("{} pixels on edges, {:.1} % of all", edges.len(), 100.0 * share);
    println!("rays  jittered  independent");
    for grid in GRIDS {
        let [jittered, independent] = ["stratified", "independent"]
            .map(|sampler| error(&picture(sampler, grid, 0), &truth, &edges));
        println!("{:4}  {jittered:.4}    {independent:.4}", grid * grid);
    }
}

/// The render with `grid` × `grid` samples a pixel.
fn picture(sampler: &str, grid: u64, seed: u64) -> Picture {
    let sampler = match sampler {
        "stratified" => format!("sampler=stratified {{ grid: {grid} }}"),
        other => format!("sampler={other}"),
    };
    let shots = shots::open_with(SCENE, &[sampler, format!("stop.samples={}", grid * grid)]);
    let shot = shots.iter().find(|shot| shot.name == RENDER).expect("the scene has it");
    shot.picture(&shot.prepare(1.0), seed)
}

/// The numbers of the pixels that differ from one on the right or below, and of those.
fn edges(picture: &Picture) -> Vec<usize> {
    let mut found = std::collections::BTreeSet::new();
    for y in 0..picture.height - 1 {
        for x in 0..picture.width - 1 {
            let here = picture.at(x, y).to_array();
            for (x2, y2) in [(x + 1, y), (x, y + 1)] {
                let there = picture.at(x2, y2).to_array();
                let differs = here.iter().zip(there).any(|(a, b)| (a - b).abs() > STEP);
                if differs {
                    found.extend([y * picture.width + x, y2 * picture.width + x2]);
                }
            }
        }
    }
    found.into_iter().collect()
}

/// The root of the mean square over pixels and channels.
fn error(picture: &Picture, truth: &Picture, pixels: &[usize]) -> f64 {
    let square = |i: usize| -> f64 {
        let (a, b) = (picture.pixels[i].to_array(), truth.pixels[i].to_array());
        a.iter().zip(b).map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>() / 3.0
    };
    (pixels.iter().map(|&i| square(i)).sum::<f64>() / pixels.len() as f64).sqrt()
}
