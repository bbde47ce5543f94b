//! Rays a second of one thread, scn's and Embree's by turns, of the same triangles and rays.
//!
//! `peers-rays FILE SIDE TURNS`: triangles from FILE, SIDE² rays of the camera. A line of JSON for
//! each kind of rays: how many, the processor's seconds of each turn and program, and their hits.

mod sets;

use std::ffi::c_void;
use std::hint::black_box;
use std::path::Path;
use std::process::ExitCode;

use scn::render::geometry::{Geometry, Ray};

use sets::{Set, Triangles};

/// A ray as embree.cpp reads it.
#[repr(C)]
struct Plain {
    origin: [f32; 3],
    direction: [f32; 3],
    t_max: f32,
}

unsafe extern "C" {
    fn peer_seconds() -> f64;
    fn peer_build(
        points: *const f32,
        of_points: usize,
        faces: *const u32,
        of_faces: usize,
        robust: i32,
    ) -> *mut c_void;
    fn peer_closest(scene: *mut c_void, rays: *const Plain, count: usize, sum: *mut f64) -> usize;
    fn peer_occluded(scene: *mut c_void, rays: *const Plain, count: usize) -> usize;
    fn peer_closest_8(scene: *mut c_void, rays: *const Plain, count: usize, sum: *mut f64)
    -> usize;
    fn peer_occluded_8(scene: *mut c_void, rays: *const Plain, count: usize) -> usize;
}

/// Who traces.
enum Program<'a> {
    Scn(&'a Geometry),
    /// What is met and where alone, as Embree tells.
    ScnMeet(&'a Geometry),
    /// By streams of [`STREAM`] rays.
    ScnStreams(&'a Geometry),
    /// What is met and where alone, by streams.
    ScnStreamsMeet(&'a Geometry),
    Embree(*mut c_void),
    /// By packets of eight.
    EmbreePackets(*mut c_void),
}

/// Rays that are asked together: as many as a wave of paths has.
const STREAM: usize = 256;

impl Program<'_> {
    fn build(triangles: &Triangles, robust: bool) -> *mut c_void {
        let (points, faces) = (&triangles.points, &triangles.faces);
        // SAFETY: both are read as so many triples, and copied.
        unsafe {
            peer_build(
                points.as_ptr().cast(),
                points.len(),
                faces.as_ptr().cast(),
                faces.len(),
                i32::from(robust),
            )
        }
    }

    /// How many of the rays meet something.
    fn hits(&self, set: &Set, plain: &[Plain]) -> usize {
        let mut sum = 0.0;
        let hits = match self {
            Self::Scn(geometry) | Self::ScnMeet(geometry) if set.any => {
                set.rays.iter().filter(|ray| geometry.occluded(ray)).count()
            }
            Self::Scn(geometry) => {
                let met = set.rays.iter().filter_map(|ray| geometry.closest(ray));
                met.inspect(|hit| sum += f64::from(hit.t + hit.ng.x)).count()
            }
            Self::ScnMeet(geometry) => {
                let met = set.rays.iter().filter_map(|ray| geometry.meet(ray));
                met.inspect(|meeting| sum += f64::from(meeting.t)).count()
            }
            Self::ScnStreams(geometry) | Self::ScnStreamsMeet(geometry) if set.any => {
                let mut occluded = [false; STREAM];
                let count = |rays: &[Ray]| {
                    let occluded = &mut occluded[..rays.len()];
                    geometry.occluded_all(rays, occluded);
                    occluded.iter().filter(|occluded| **occluded).count()
                };
                set.rays.chunks(STREAM).map(count).sum()
            }
            Self::ScnStreams(geometry) => {
                let (mut met, mut hits) = ([None; STREAM], [None; STREAM]);
                let mut count = 0;
                for rays in set.rays.chunks(STREAM) {
                    let (met, hits) = (&mut met[..rays.len()], &mut hits[..rays.len()]);
                    geometry.meet_all(rays, met);
                    geometry.hit_all(rays, met, hits);
                    let all = hits.iter().flatten();
                    count += all.inspect(|hit| sum += f64::from(hit.t + hit.ng.x)).count();
                }
                count
            }
            Self::ScnStreamsMeet(geometry) => {
                let mut met = [None; STREAM];
                let mut count = 0;
                for rays in set.rays.chunks(STREAM) {
                    let met = &mut met[..rays.len()];
                    geometry.meet_all(rays, met);
                    let all = met.iter().flatten();
                    count += all.inspect(|meeting| sum += f64::from(meeting.t)).count();
                }
                count
            }
            // SAFETY: the scene stands, and `plain` has so many rays.
            Self::Embree(scene) if set.any => unsafe {
                peer_occluded(*scene, plain.as_ptr(), plain.len())
            },
            Self::Embree(scene) => unsafe {
                peer_closest(*scene, plain.as_ptr(), plain.len(), &raw mut sum)
            },
            // SAFETY: as above.
            Self::EmbreePackets(scene) if set.any => unsafe {
                peer_occluded_8(*scene, plain.as_ptr(), plain.len())
            },
            Self::EmbreePackets(scene) => unsafe {
                peer_closest_8(*scene, plain.as_ptr(), plain.len(), &raw mut sum)
            },
        };
        black_box(sum);
        hits
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, file, side, turns] = &arguments[..] else {
        eprintln!("peers-rays FILE SIDE TURNS");
        return ExitCode::from(2);
    };
    let (Ok(side), Ok(turns)) = (side.parse(), turns.parse::<usize>()) else {
        eprintln!("SIDE and TURNS are whole numbers");
        return ExitCode::from(2);
    };
    let triangles = match Triangles::read(Path::new(file)) {
        Ok(triangles) => triangles,
        Err(error) => {
            eprintln!("{file}: {error}");
            return ExitCode::from(2);
        }
    };
    let geometry = triangles.geometry();
    let sets = sets::sets(&geometry, side);
    let [fast, robust] = [false, true].map(|robust| Program::build(&triangles, robust));
    let programs = [
        ("scn", Program::Scn(&geometry)),
        ("scn meet", Program::ScnMeet(&geometry)),
        ("scn streams", Program::ScnStreams(&geometry)),
        ("scn streams meet", Program::ScnStreamsMeet(&geometry)),
        ("embree", Program::Embree(fast)),
        ("embree packets", Program::EmbreePackets(fast)),
        ("embree robust", Program::Embree(robust)),
    ];
    for set in &sets {
        measure(set, &programs, turns);
    }
    ExitCode::SUCCESS
}

fn measure(set: &Set, programs: &[(&str, Program<'_>)], turns: usize) {
    let plain: Vec<Plain> = set.rays.iter().map(plain).collect();
    let mut seconds = vec![Vec::new(); programs.len()];
    let mut hits = vec![0; programs.len()];
    for turn in 0..turns {
        // Who begins changes.
        for k in (0..programs.len()).map(|k| (k + turn) % programs.len()) {
            // SAFETY: it reads a clock.
            let begun = unsafe { peer_seconds() };
            hits[k] = programs[k].1.hits(set, &plain);
            seconds[k].push(unsafe { peer_seconds() } - begun);
        }
    }
    let all: Vec<String> = programs
        .iter()
        .zip(seconds.iter().zip(&hits))
        .map(|((name, _), (seconds, hits))| {
            format!("\"{name}\": {{\"hits\": {hits}, \"seconds\": {seconds:?}}}")
        })
        .collect();
    let (name, count) = (set.name, set.rays.len());
    println!("{{\"set\": \"{name}\", \"rays\": {count}, \"programs\": {{{}}}}}", all.join(", "));
}

fn plain(ray: &Ray) -> Plain {
    Plain { origin: ray.origin.into(), direction: ray.direction.into(), t_max: ray.t_max }
}
