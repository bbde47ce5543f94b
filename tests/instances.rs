//! Meshes that are kept once make the pictures that copies of them make.

mod by_hand;
mod shots;

use scn::load::Stage;
use scn::math::{NoProgress, Picture};
use scn::plan::{Feature, Need, Plan};
use scn::prepare::{self, Prepared, Settings};
use scn::render::tiles::Threads;

use by_hand::{Patient, render};

/// Bunnies: as it is, mirrored, stretched and tiny; of the file's materials and of others, smooth
/// and with a texture; and one that shines, beside a wall of its own.
const BUNNIES: &str = r#"
scn 1 in m
film: { size: (48, 32) }
stop: { samples: 4 }
integrator: path
camera: perspective { eye: (1, 1.5, 5), look_at: (0.4, 0.4, 0), fov_y: 40 deg }
material grey: diffuse { albedo: 0.5 }
material tiles: diffuse { albedo: checker { a: 0.9, b: 0.1, squares: (8, 8) } }
material glow: diffuse { albedo: 0.5, emission: 4 W/m^2/sr }
light sky: constant { radiance: 1 W/m^2/sr }
object wall: quad { corner: (-3, -1, -2), u: (6, 0, 0), v: (0, 4, 0), material: tiles }
let bunny(material, place) = mesh { file: "BUNNY", unit: 1 m, material: material, place: place }
object a: bunny(grey, [])
object b: bunny(grey, [scale(-1, 1, 1), move(1, 0, 0)])
object c: bunny(grey, [scale(0.5, 2, 0.3), rotate(y, 70 deg), move(-1, 0, 0.5)])
object d: bunny(grey, [scale(0.02), move(0.5, 0.5, 3)])
object e: bunny(glow, [scale(0.4), move(1.8, 0, 1)])
"#;

fn stage() -> Stage {
    let text = BUNNIES.replace("BUNNY", "../models/bunny.obj");
    let all = shots::open_text(&shots::path("scenes/bunnies.scn"), &text, &[]);
    all.unwrap_or_else(|report| panic!("{report}")).swap_remove(0).stage
}

fn prepared(plan: &Plan, stage: &Stage) -> Prepared {
    let (prepared, found) = prepare::prepare_by(plan, stage, &Settings::default(), &NoProgress);
    prepared.unwrap_or_else(|| panic!("{found:?}"))
}

fn picture(prepared: &Prepared, threads: usize) -> Picture {
    let threads = Threads::new(threads).unwrap();
    threads.run(|| render(prepared, 3, 4, &Patient).picture)
}

#[test]
fn a_mesh_at_several_places_is_kept_once_and_looks_the_same() {
    let stage = stage();
    let plan = Plan::of(&stage);
    let answer = plan.answers.iter().find(|it| it.feature == Feature::Instances).unwrap();
    assert_eq!(answer.need, Need::Required);
    assert_eq!(answer.why, "`../models/bunny.obj` stands at 4 places");
    let names = stage.scene.objects.iter().map(|object| object.name.value.as_str()).enumerate();
    let instances = names.filter(|(number, _)| plan.is_instance(*number));
    let instances: Vec<&str> = instances.map(|(_, name)| name).collect();
    assert_eq!(instances, ["a", "b", "c", "d"], "neither the wall nor what shines");

    let copying = Plan { copies: Vec::new(), ..plan.clone() };
    let (once, copied) = (prepared(&plan, &stage), prepared(&copying, &stage));
    assert_eq!((once.summary.instances, copied.summary.instances), (4, 0));
    assert_eq!(once.summary.triangles, copied.summary.triangles);
    let all = once.summary.bytes_of_copies.abs_diff(copied.summary.bytes);
    assert!(all * 10 < copied.summary.bytes, "{:?} {:?}", once.summary, copied.summary);
    assert!(once.summary.bytes * 2 < copied.summary.bytes);
    let told: u64 = once.objects.iter().map(|object| object.bytes).sum();
    assert!(told.abs_diff(once.summary.bytes) < 10);

    let expected = picture(&copied, 2);
    assert!(expected.pixels.iter().all(|pixel| pixel.g > 0.0));
    for threads in [1, 3] {
        assert_eq!(picture(&once, threads), expected);
    }
}

#[test]
fn a_small_mesh_is_copied() {
    let text = BUNNIES.replace("BUNNY", "../models/cornell_blocks.obj");
    let all = shots::open_text(&shots::path("scenes/blocks.scn"), &text, &[]);
    let stage = all.unwrap_or_else(|report| panic!("{report}")).swap_remove(0).stage;
    let plan = Plan::of(&stage);
    let count = |plan: &Plan| (0..6).filter(|object| plan.is_instance(*object)).count();
    assert!(!plan.builds(Feature::Instances));
    assert_eq!((count(&plan), count(&plan.forced())), (0, 4));
}
