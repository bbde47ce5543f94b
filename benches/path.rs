//! What happens to a path between its rays: each material asked for directions and for what it
//! scatters, lights chosen and their points sampled, photons sent, and what they tell asked for; and
//! whole small pictures: of diffuse surfaces, as their plan builds them and with everything put in, and
//! of balls of silver and glass, with photons that guide paths and without.
//!
//! `cargo bench --bench path`

#[path = "../tests/shots/mod.rs"]
mod shots;

use std::sync::LazyLock;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::{DVec3, Vec2, Vec3};
use scn::math::{NoProgress, Rgb, random, warp};
use scn::plan::Plan;
use scn::prepare::{self, Prepared, Settings};
use scn::render::World;
use scn::render::film::Taken;
use scn::render::geometry::{self, Geometry, Hit, Owner, Primitive, Ray, Shapes};
use scn::render::guide::{Guide, Lobes};
use scn::render::lights::{Centre, Lamp, Light, Lights, PointLight, Site, Sites};
use scn::render::materials::{
    Bsdf, Conductor, Dielectric, Diffuse, Emission, Material, Mirror, Mixture, Part, Surface,
};
use scn::render::textures::Colour;
use scn::render::tiles::{Job, Threads};

/// Directions, sites and random numbers of a turn.
const TURN: u64 = 1000;

fn main() {
    divan::main();
}

fn numbers(place: u64) -> [f64; 4] {
    let bits = random::at(1, place);
    let ([a, b], [c, d]) = (random::unit_pair(bits), random::unit_pair(random::mix(bits)));
    [a, b, c, d]
}

fn direction(place: u64) -> Vec3 {
    let [a, b, ..] = numbers(place);
    warp::square_to_cosine(Vec2::new(random::unit_f32(a), random::unit_f32(b)))
}

// Materials.

const MATERIALS: [&str; 6] =
    ["diffuse", "mirror", "conductor", "conductor of a table", "dielectric", "mixture"];

fn surface(name: &str) -> Surface {
    let grey = |value| Colour::Plain(Rgb::grey(value));
    match name {
        "diffuse" => Surface::Diffuse(Diffuse { albedo: grey(0.5) }),
        "mirror" => Surface::Mirror(Mirror { reflectance: grey(0.9) }),
        "conductor" => Surface::Conductor(Conductor::Channels {
            n: [0.14, 0.43, 1.38],
            k: [3.697, 2.455, 1.914],
        }),
        "conductor of a table" => {
            let table = (0..64_u8).map(|i| Rgb::grey(1.0 - f32::from(i) / 100.0)).collect();
            Surface::Conductor(Conductor::Table(table))
        }
        "dielectric" => Surface::Dielectric(Dielectric { inside: 1.5, outside: 1.0 }),
        _ => Surface::Mixture(Mixture {
            parts: ["diffuse", "conductor", "dielectric"]
                .map(|part| (1.0 / 3.0, surface(part)))
                .to_vec(),
        }),
    }
}

/// A hit on a floor, from above.
fn floor() -> Hit {
    let mut shapes = Shapes::new();
    let corners = [Vec3::NEG_ONE, Vec3::new(3.0, -1.0, -1.0), Vec3::new(-1.0, 3.0, -1.0)];
    let corners = corners.map(|corner| shapes.vertex(corner));
    let owner = Owner::default();
    shapes.triangle(geometry::Triangle { corners, normals: None, owner });
    let hit = Geometry::build(shapes).closest(&Ray::new(Vec3::ZERO, Vec3::NEG_Z));
    hit.expect("a floor below")
}

fn material(name: &str) -> Material {
    let emission = Emission { radiance: Rgb::BLACK, both: false };
    Material { surface: surface(name), emission, before: 0, behind: None }
}

/// A material at hits from many sides.
fn seen(name: &str) -> Vec<Bsdf> {
    let (material, hit) = (material(name), floor());
    (0..TURN).map(|i| material.at(&hit, direction(i))).collect()
}

#[divan::bench(args = MATERIALS)]
fn material_at_a_hit(bencher: Bencher, name: &str) {
    let (material, hit) = (material(name), floor());
    let views: Vec<Vec3> = (0..TURN).map(direction).collect();
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        views.iter().for_each(|wo| _ = black_box(material.at(&hit, black_box(*wo))));
    });
}

#[divan::bench(args = MATERIALS)]
fn material_sample(bencher: Bencher, name: &str) {
    let (seen, u): (_, Vec<_>) = (seen(name), (0..TURN).map(numbers).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        let asked = seen.iter().zip(&u);
        asked.for_each(|(bsdf, u)| _ = black_box(bsdf.sample(Part::All, black_box(*u))));
    });
}

#[divan::bench(args = MATERIALS)]
fn material_eval_and_pdf(bencher: Bencher, name: &str) {
    let (seen, wi): (_, Vec<_>) = (seen(name), (0..TURN).map(|i| direction(i + TURN)).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        for (bsdf, wi) in seen.iter().zip(&wi) {
            let wi = black_box(*wi);
            black_box((bsdf.scattered(wi), bsdf.pdf_w(Part::All, wi)));
        }
    });
}

// Lights.

fn sites() -> Vec<Site> {
    let site = |i| {
        let [a, b, c, _] = numbers(i).map(|u| u as f32);
        Site { normal: Vec3::Z, ..Site::free(Vec3::new(a - 0.5, b - 0.5, 0.1 * c)) }
    };
    (0..TURN).map(site).collect()
}

#[divan::bench(args = [1, 2, 16, 10_000])]
fn light_choice(bencher: Bencher, count: u64) {
    let bulb = |i| {
        let [a, b, c, _] = numbers(i).map(|u| u as f32);
        let position = Vec3::new(2.0 * a - 1.0, 2.0 * b - 1.0, 1.0 + c);
        Light::Point(PointLight { position, intensity: Rgb::ONE })
    };
    let lights = Lights::new((0..count).map(bulb).collect(), Vec::new(), Vec::new());
    let (sites, u): (_, Vec<_>) = (sites(), (0..TURN).map(|i| numbers(i)[0]).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        let asked = sites.iter().zip(&u);
        asked.for_each(|(site, u)| _ = black_box(lights.choose(black_box(site), *u)));
    });
}

const LAMPS: [&str; 5] = ["near rectangle", "far rectangle", "triangle", "disk", "sphere"];

fn lamp(name: &str) -> (Geometry, Light) {
    let mut shapes = Shapes::new();
    let owner = Owner::default();
    let (height, size) = if name == "far rectangle" { (20.0, 1.0) } else { (1.0, 0.8) };
    let mut triangle = |corners: [[f32; 2]; 3]| -> Primitive {
        let corners = corners.map(|[x, y]| shapes.vertex(Vec3::new(size * x, size * y, height)));
        shapes.triangle(geometry::Triangle { corners, normals: None, owner })
    };
    let surfaces = match name {
        "triangle" => vec![triangle([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]])],
        "disk" => vec![shapes.disk(geometry::Disk {
            centre: height * Vec3::Z,
            normal: Vec3::NEG_Z,
            radius: 0.5,
            owner,
        })],
        "sphere" => {
            vec![shapes.sphere(geometry::Sphere { centre: height * Vec3::Z, radius: 0.5, owner })]
        }
        _ => vec![
            triangle([[0.0, 0.0], [0.0, 1.0], [1.0, 1.0]]),
            triangle([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0]]),
        ],
    };
    let geometry = Geometry::build(shapes);
    let centre = Centre::new(f64::from(height) * DVec3::Z, DVec3::NEG_Z, DVec3::ONE);
    let lamp = Lamp::new((Rgb::ONE, false), surfaces, &geometry, centre);
    (geometry, Light::Lamp(Box::new(lamp)))
}

#[divan::bench(args = LAMPS)]
fn light_sample(bencher: Bencher, name: &str) {
    let (geometry, light) = lamp(name);
    let (sites, u): (_, Vec<_>) = (sites(), (0..TURN).map(numbers).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        for (site, [u, v, ..]) in sites.iter().zip(&u) {
            black_box(light.sample(&geometry, black_box(site), [*u, *v]));
        }
    });
}

// Photons that guide paths.

#[divan::bench(sample_count = 10, sample_size = 1)]
fn guide_build(bencher: Bencher) {
    let World { geometry, materials, lights, .. } = &BALLS[1].world;
    bencher.bench_local(|| Guide::build(geometry, materials, lights).is_some());
}

/// Places on the walls of the box that photons tell of, and what they tell.
fn told() -> Vec<(Vec3, &'static Lobes)> {
    let World { geometry, guide, .. } = &BALLS[1].world;
    let guide = guide.as_ref().expect("light by silver and glass");
    let seen = |i| geometry.closest(&Ray::new(Vec3::ZERO, warp::square_to_sphere(square(i))));
    let told = |place| Some((place, guide.lobes(guide.leaf(place), place)?));
    (0..).filter_map(seen).filter_map(|hit| told(hit.position)).take(TURN as usize).collect()
}

fn square(place: u64) -> Vec2 {
    let [a, b, ..] = numbers(place);
    Vec2::new(random::unit_f32(a), random::unit_f32(b))
}

#[divan::bench]
fn guide_look_up(bencher: Bencher) {
    let guide = BALLS[1].world.guide.as_ref().expect("light by silver and glass");
    let places: Vec<Vec3> = told().into_iter().map(|(place, _)| place).collect();
    // So many at a time, as a render has.
    let mut sites: Vec<Sites> = Vec::new();
    for places in places.chunks(100) {
        let mut some = Sites::default();
        places.iter().for_each(|place| some.push(&Site::free(*place)));
        sites.push(some);
    }
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        sites.iter().for_each(|some| {
            black_box(guide.leaves(some, some.lanes().len()));
        });
    });
}

#[divan::bench]
fn guide_sample(bencher: Bencher) {
    let (told, u): (_, Vec<_>) = (told(), (0..TURN).map(numbers).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        for ((place, lobes), [choice, u, v, _]) in told.iter().zip(&u) {
            black_box(lobes.sample(black_box(*place), *choice, [*u, *v]));
        }
    });
}

#[divan::bench]
fn guide_pdf(bencher: Bencher) {
    let (told, wi): (_, Vec<_>) = (told(), (0..TURN).map(direction).collect());
    bencher.counter(ItemsCount::new(TURN)).bench_local(|| {
        for ((place, lobes), wi) in told.iter().zip(&wi) {
            black_box(lobes.pdf_w(black_box(*place), black_box(*wi)));
        }
    });
}

// Whole pictures.

/// A small picture of a setup of the box, by an integrator.
fn picture(setup: &str, integrator: &str, forced: bool) -> Prepared {
    let text = format!(
        "scn 1 in mm\nuse \"scenes/lib/cornell.scn\"\nfilm: {{ size: (48, 48) }}\n\
         integrator: {integrator}\nrender picture: {setup} {{}}\n"
    );
    let shots = shots::open_text(&shots::path("bench.scn"), &text, &[]);
    let shots = shots.unwrap_or_else(|report| panic!("{report}"));
    let plan = Plan::of(&shots[0].stage);
    let plan = if forced { plan.forced() } else { plan };
    let (prepared, _) =
        prepare::prepare_by(&plan, &shots[0].stage, &Settings::default(), &NoProgress);
    prepared.expect("a scene without faults")
}

/// As their plan builds them, with everything put in, and where pixels share light.
static BLOCKS: LazyLock<[Prepared; 3]> = LazyLock::new(|| {
    [("path", false), ("path", true), ("path { reuse: 16 }", false)]
        .map(|(integrator, forced)| picture("blocks", integrator, forced))
});

const WAYS: [&str; 3] = ["as planned", "everything put in", "sharing light"];

/// By chance alone, and guided by photons.
static BALLS: LazyLock<[Prepared; 2]> = LazyLock::new(|| {
    ["path", "path { guide: photons }"].map(|integrator| picture("spheres", integrator, false))
});

#[divan::bench(args = WAYS)]
fn blocks(bencher: Bencher, how: &str) {
    let way = WAYS.iter().position(|way| *way == how).unwrap_or(0);
    pass(bencher, &BLOCKS[way]);
}

#[divan::bench(args = ["by chance", "guided"])]
fn balls(bencher: Bencher, how: &str) {
    pass(bencher, &BALLS[usize::from(how != "by chance")]);
}

fn pass(bencher: Bencher, Prepared { world, integrator, .. }: &Prepared) {
    let taken = Taken::new(&world.film, world.sampler.rhythm(), 0);
    let tiles: Vec<usize> = (0..taken.tiles()).collect();
    let samples = 0..8;
    let paths = world.film.window.pixels() * samples.end;
    let job = Job {
        seed: 1,
        samples,
        tiles: &tiles,
        taken: &taken,
        cancelled: &|_| false,
        advance: &|_| (),
    };
    let thread = Threads::new(1).expect("a thread");
    bencher.counter(ItemsCount::new(paths)).bench_local(|| {
        black_box(thread.run(|| integrator.pass(world, &job)));
    });
}
