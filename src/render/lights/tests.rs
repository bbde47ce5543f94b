//! What is sampled of lamps follows the density that is told of it, and lights are chosen with the
//! probability that is told.

use glam::{Vec2, Vec3};

use super::*;
use crate::math::{chi_squared, random, warp};
use crate::render::geometry::{Disk, Owner, Primitive, Ray, Shapes, Sphere, Triangle};

/// Surfaces of one lamp, alone in the world.
struct Alone {
    shapes: Shapes,
    surfaces: Vec<Primitive>,
}

impl Alone {
    fn new() -> Self {
        Self { shapes: Shapes::new(), surfaces: Vec::new() }
    }

    fn triangle(mut self, corners: [Vec3; 3]) -> Self {
        let corners = corners.map(|corner| self.shapes.vertex(corner));
        let triangle = Triangle { corners, normals: None, owner: Owner::default() };
        self.surfaces.push(self.shapes.triangle(triangle));
        self
    }

    fn quad(self, corner: Vec3, u: Vec3, v: Vec3) -> Self {
        let (b, c, d) = (corner + u, corner + u + v, corner + v);
        self.triangle([corner, b, c]).triangle([corner, c, d])
    }

    fn sphere(mut self, centre: Vec3, radius: f32) -> Self {
        let sphere = Sphere { centre, radius, owner: Owner::default() };
        self.surfaces.push(self.shapes.sphere(sphere));
        self
    }

    fn disk(mut self, centre: Vec3, normal: Vec3, radius: f32) -> Self {
        let disk = Disk { centre, normal: normal.normalize(), radius, owner: Owner::default() };
        self.surfaces.push(self.shapes.disk(disk));
        self
    }

    fn lamp(self, both: bool) -> (Geometry, Lamp) {
        let geometry = Geometry::build(self.shapes);
        let centre = Centre::new(glam::DVec3::ZERO, glam::DVec3::Z, glam::DVec3::ONE);
        let lamp = Lamp::new((Rgb::ONE, both), self.surfaces, &geometry, centre);
        (geometry, lamp)
    }
}

fn site(position: Vec3, normal: Vec3) -> Site {
    Site { normal, ..Site::free(position) }
}

const SAMPLES: u64 = 20_000;
const POINTS: u64 = 200_000;
/// Bins by the cosine to the axis, and around it.
const BINS: [usize; 2] = [12, 16];

/// Samples in bins over a cone that holds the lamp, against the density of what rays meet there.
/// Samples that bring nothing have a bin of their own.
fn assert_sampled(name: &str, (alone, both): (Alone, bool), site: Site, axis: Vec3, lack: f64) {
    let (geometry, lamp) = alone.lamp(both);
    let axis = axis.normalize();
    let (x, y) = axis.any_orthonormal_pair();
    let [rings, sectors] = BINS;
    let bin = |wi: Vec3| {
        let off = 0.5 * f64::from((wi - axis).length_squared()) / lack;
        let turn = f64::from(wi.dot(y).atan2(wi.dot(x))) / std::f64::consts::TAU + 0.5;
        let cell = |u: f64, n: usize| ((u * n as f64) as usize).min(n - 1);
        cell(off, rings) * sectors + cell(turn, sectors)
    };
    let mut counts = vec![0; rings * sectors + 1];
    for i in 0..SAMPLES {
        let u = random::unit_pair(random::at(7, i));
        let Some(arrival) = lamp.sample(&geometry, &site, u) else {
            counts[rings * sectors] += 1;
            continue;
        };
        assert!((arrival.wi.length() - 1.0).abs() < 1e-5, "{name}");
        assert!((arrival.irradiance.g * arrival.pdf_w - 1.0).abs() < 1e-4, "{name}");
        counts[bin(arrival.wi)] += 1;
        // What a ray meets there has the same density.
        if i < 500
            && let Some(hit) = geometry.closest(&Ray::new(site.point.position, arrival.wi))
        {
            let pdf_w = lamp.pdf_w(&site, &hit);
            let off = (pdf_w / arrival.pdf_w - 1.0).abs();
            assert!(off < 2e-2, "{name}: {pdf_w} for {}", arrival.pdf_w);
        }
    }
    let mut probabilities = vec![0.0; counts.len()];
    let solid_angle = std::f64::consts::TAU * lack;
    for i in 0..POINTS {
        let [u, v] =
            [0.754_877_666_246_693, 0.569_840_290_998_053].map(|step| (step * i as f64).fract());
        let off = lack * u;
        let (sin, cos) = (std::f64::consts::TAU * (v - 0.5)).sin_cos();
        let aside = (off * (2.0 - off)).sqrt() as f32;
        let wi = (1.0 - off) as f32 * axis + aside * (cos as f32 * x + sin as f32 * y);
        let Some(hit) = geometry.closest(&Ray::new(site.point.position, wi)) else { continue };
        if !both && hit.ng.dot(wi) >= 0.0 {
            continue;
        }
        let pdf_w = lamp.pdf_w(&site, &hit);
        probabilities[bin(wi)] += f64::from(pdf_w) * solid_angle / POINTS as f64;
    }
    let sum: f64 = probabilities.iter().sum();
    let lost = counts[rings * sectors] as f64 / SAMPLES as f64;
    assert!((sum + lost - 1.0).abs() < 0.015, "{name}: {sum} and {lost}");
    probabilities.iter_mut().for_each(|p| *p *= (1.0 - lost) / sum);
    *probabilities.last_mut().unwrap() = lost;
    chi_squared::assert_fits(&counts, &probabilities);
}

#[test]
fn directions_to_lamps_follow_their_density() {
    let here = || site(Vec3::ZERO, Vec3::ZERO);
    let facing = |normal: Vec3| site(Vec3::ZERO, normal.normalize());
    let one = |corners| (Alone::new().triangle(corners), true);
    let v = Vec3::new;
    // The triangle of the ground truths, a wide one close by, a thin one, a far one.
    let plain = [v(-1.0, 1.0, 2.0), v(2.0, 0.5, 1.0), v(0.3, -1.5, 1.5)];
    assert_sampled("triangle", one(plain), here(), Vec3::Z, 0.6);
    let wide = [v(-9.0, -5.0, 0.1), v(8.0, -7.0, 0.1), v(0.0, 9.0, 0.1)];
    assert_sampled("wide", one(wide), here(), Vec3::Z, 1.0);
    let thin = [v(-1.0, 0.0, 1.0), v(1.0, 0.02, 1.0), v(0.0, 0.1, 1.0)];
    assert_sampled("thin", one(thin), here(), Vec3::Z, 0.35);
    let far = plain.map(|corner| corner + v(0.0, 0.0, 4000.0));
    assert_sampled("far", one(far), here(), Vec3::Z, 2e-7);
    // Rectangles above, beside and all around; a parallelogram, which is two triangles.
    let quad = |corner, u, w| (Alone::new().quad(corner, u, w), true);
    let above = || quad(v(-1.0, -1.0, 1.0), v(2.0, 0.0, 0.0), v(0.0, 3.0, 0.0));
    assert_sampled("rectangle", above(), here(), Vec3::Z, 0.7);
    let beside = quad(v(0.5, -1.0, -0.2), v(0.0, 2.0, 0.0), v(0.0, 0.0, 2.0));
    assert_sampled("wall", beside, here(), Vec3::X, 1.0);
    let close = quad(v(-3.0, -2.0, -0.01), v(4.0, 0.0, 0.0), v(0.0, 5.0, 0.0));
    assert_sampled("close", close, here(), Vec3::NEG_Z, 1.0);
    let leaning = quad(v(-1.0, -1.0, 1.0), v(2.0, 0.5, 0.0), v(0.4, 2.0, 0.5));
    assert_sampled("parallelogram", leaning, facing(Vec3::Z), Vec3::Z, 0.8);
    // Disks near and far.
    let disk = |centre, radius| (Alone::new().disk(centre, v(0.1, 0.2, -1.0), radius), false);
    assert_sampled("disk", disk(v(0.2, 0.0, 0.5), 1.0), here(), Vec3::Z, 0.75);
    assert_sampled("far disk", disk(v(0.0, 0.0, 5.0), 1.0), here(), Vec3::Z, 0.03);
    // Spheres: near, far, touched, around a site of space and around one of a surface.
    let ball = |z, radius, both| (Alone::new().sphere(v(0.0, 0.0, z), radius), both);
    assert_sampled("ball", ball(2.0, 1.0, false), here(), Vec3::Z, 0.14);
    assert_sampled("close ball", ball(1.001, 1.0, false), here(), Vec3::Z, 1.0);
    assert_sampled("far ball", ball(500.0, 1.0, false), here(), Vec3::Z, 2.1e-6);
    assert_sampled("hollow ball", ball(0.5, 1.0, true), here(), Vec3::Z, 2.0);
    assert_sampled("in a ball", ball(0.5, 1.0, true), facing(v(1.0, 0.0, 1.0)), Vec3::Z, 2.0);
    // Several surfaces, some of which face away.
    let several = Alone::new()
        .quad(v(-1.0, -1.0, 1.0), v(2.0, 0.0, 0.0), v(0.0, 2.0, 0.0))
        .triangle([v(2.0, -1.0, 0.5), v(2.0, 1.0, 0.5), v(2.0, 0.0, 1.5)])
        .triangle([v(-2.0, -1.0, 0.5), v(-2.5, 1.0, 0.2), v(-2.0, 0.5, 1.5)])
        .triangle([v(-1.0, 2.0, 0.5), v(-1.5, 2.0, 0.2), v(-1.0, 2.5, 1.5)]);
    assert_sampled("several", (several, true), facing(v(0.2, 0.0, 1.0)), Vec3::Z, 1.0);
}

/// Points, spots and lamps here and there, some far, some bright, with a sun and a sky.
fn crowd(count: u64) -> (Geometry, Lights) {
    let mut shapes = Shapes::new();
    let mut lamps = Vec::new();
    let number = |i: u64, which: u64| {
        let [a, b] = random::unit_pair(random::at(random::at(31, i), which));
        [a as f32, b as f32]
    };
    let mut all = Vec::new();
    for i in 0..count {
        let ([a, b], [c, d], [e, f]) = (number(i, 0), number(i, 1), number(i, 2));
        let place = Vec3::new(2.0 * a - 1.0, 2.0 * b - 1.0, c);
        let way = warp::square_to_sphere(Vec2::new(e, f));
        let intensity = Rgb::grey(0.01 + d * d * d);
        let bulb = PointLight { position: place, intensity };
        match i % 4 {
            0 => all.push(Light::Point(bulb)),
            1 => {
                let angle = 0.05 + f64::from(a) * 2.0;
                all.push(Light::Spot(SpotLight::new(bulb, way, [0.5 * angle, angle])));
            }
            2 => {
                let owner = Owner::default();
                let ball = Sphere { centre: place, radius: 0.01 + 0.05 * d, owner };
                lamps.push((shapes.sphere(ball), false));
            }
            _ => {
                let (x, y) = way.any_orthonormal_pair();
                let corners = [place, place + 0.1 * x, place + 0.1 * y];
                let corners = corners.map(|corner| shapes.vertex(corner));
                let owner = Owner::default();
                let triangle = Triangle { corners, normals: None, owner };
                lamps.push((shapes.triangle(triangle), i % 8 == 3));
            }
        }
    }
    let geometry = Geometry::build(shapes);
    for (surface, both) in lamps {
        let centre = Centre::new(glam::DVec3::ZERO, glam::DVec3::Z, glam::DVec3::ONE);
        let lamp = Lamp::new((Rgb::grey(3.0), both), vec![surface], &geometry, centre);
        all.push(Light::Lamp(Box::new(lamp)));
    }
    all.push(Light::Directional(Directional { to_light: Vec3::X, irradiance: Rgb::ONE }));
    let sky = Surroundings { sight: Sight::Constant(Rgb::grey(0.1)), asked: None };
    all.push(Light::Surroundings(sky));
    (geometry, Lights::new(all, Vec::new(), Vec::new()))
}

/// Sites among the lights and far away, on surfaces and on none.
fn sites() -> impl Iterator<Item = Site> {
    (0..24_u64).map(|i| {
        let [a, b] = random::unit_pair(random::at(5, i)).map(|u| u as f32);
        let [c, d] = random::unit_pair(random::at(6, i)).map(|u| u as f32);
        let scale = [1.0, 1.0, 0.2, 8.0][i as usize % 4];
        let normal = match i % 5 {
            0 => Vec3::ZERO,
            _ => warp::square_to_sphere(Vec2::new(c, d)),
        };
        site(scale * Vec3::new(2.0 * a - 1.0, 2.0 * b - 1.0, 2.0 * c - 1.0), normal)
    })
}

#[test]
fn lights_are_chosen_with_the_probability_that_is_told() {
    for count in [0, 1, 3, 200] {
        let (_, lights) = crowd(count);
        for site in sites() {
            for i in 0..200_u64 {
                let [u, _] = random::unit_pair(random::at(9, i));
                let Some((number, pmf)) = lights.choose(&site, u) else { continue };
                let told = lights.pmf(&site, number);
                assert!((pmf / told - 1.0).abs() < 1e-5, "{pmf} {told}");
            }
        }
        // None is chosen where a part of the crowd turns out to give nothing: the rest of 1.
        for site in sites().take(6) {
            let mut counts = vec![0; lights.all.len() + 1];
            for i in 0..20_000 {
                let [u, _] = random::unit_pair(random::at(9, i));
                let chosen = lights.choose(&site, u);
                counts[chosen.map_or(lights.all.len(), |(number, _)| number)] += 1;
            }
            let told = (0..lights.all.len()).map(|i| f64::from(lights.pmf(&site, i)));
            let mut told: Vec<_> = told.collect();
            let sum: f64 = told.iter().sum();
            assert!(sum < 1.0 + 1e-5, "{sum}");
            // Rounded to f32, all of them may be a little off 1.
            let rest = if sum > 1.0 - 1e-5 { 0.0 } else { 1.0 - sum };
            told.iter_mut().for_each(|p| *p *= (1.0 - rest) / sum);
            told.push(rest);
            chi_squared::assert_fits(&counts, &told);
        }
    }
}

#[test]
fn what_gives_a_site_light_may_be_chosen() {
    let (geometry, lights) = crowd(400);
    let mut lit = 0;
    for site in sites() {
        for (number, light) in lights.all.iter().enumerate() {
            for i in 0..4 {
                let u = random::unit_pair(random::at(11, i));
                let Some(arrival) = light.sample(&geometry, &site, u) else { continue };
                let counts = site.normal == Vec3::ZERO || site.normal.dot(arrival.wi) > 0.0;
                if counts && arrival.irradiance.g > 0.0 {
                    lit += 1;
                    assert!(lights.pmf(&site, number) > 0.0, "{light:?} at {site:?}");
                }
            }
        }
    }
    assert!(lit > 10_000, "{lit}");
}

#[test]
fn one_light_is_always_chosen() {
    let bulb = PointLight { position: Vec3::Z, intensity: Rgb::ONE };
    let lights = Lights::new(vec![Light::Point(bulb)], Vec::new(), Vec::new());
    for site in sites() {
        assert_eq!((lights.choose(&site, 0.7), lights.pmf(&site, 0)), (Some((0, 1.0)), 1.0));
    }
    assert_eq!(Lights::default().choose(&site(Vec3::ZERO, Vec3::ZERO), 0.5), None);
}

/// The variance of a picture of one sample, as a part of its squared mean, on average over sites
/// below ten thousand points: by the probability that is told, or by even chances.
fn variance(lights: &Lights, even: bool) -> f64 {
    let sites = (0..40_u64).map(|k| {
        let [a, b] = random::unit_pair(random::at(4, k)).map(|u| u as f32);
        site(Vec3::new(a, b, 0.02 + 0.005 * k as f32), Vec3::NEG_Z)
    });
    let parts = sites.map(|at| {
        let (mut sum, mut second) = (0.0, 0.0);
        for (number, light) in lights.all.iter().enumerate() {
            let Light::Point(point) = light else { panic!("a point") };
            let arrival = point.arrive(&at.point).unwrap();
            let gives = f64::from(arrival.irradiance.g * arrival.wi.dot(at.normal).max(0.0));
            let pmf = f64::from(lights.pmf(&at, number));
            sum += gives;
            second += gives * gives / if even { 1.0 / lights.all.len() as f64 } else { pmf };
        }
        second / (sum * sum) - 1.0
    });
    parts.sum::<f64>() / 40.0
}

#[test]
fn of_ten_thousand_lights_the_near_ones_are_chosen() {
    let bulb = |i: u64| {
        let [a, b] = random::unit_pair(random::at(3, i)).map(|u| u as f32);
        PointLight { position: Vec3::new(a, b, 0.0), intensity: Rgb::ONE }
    };
    let lights = Lights::new((0..10_000).map(|i| Light::Point(bulb(i))).collect(), vec![], vec![]);
    let (by_crowd, even) = (variance(&lights, false), variance(&lights, true));
    assert!(by_crowd * 8.0 < even, "{by_crowd} {even}");
}

/// One of each kind of what surrounds a scene, after the one that was last: the compiler asks for a
/// new one.
fn next_sight(last: Option<&Sight>) -> Option<Sight> {
    let Some(last) = last else { return Some(Sight::Constant(Rgb::grey(0.7))) };
    match last {
        Sight::Constant(_) => {
            let towards = Vec3::new(0.3, -0.4, 0.8).normalize();
            Some(Sight::Disc(Disc::new(towards, 0.4, Rgb::ONE)))
        }
        Sight::Disc(_) => {
            let radiance = |w: Vec3| Rgb::new(w.z, 0.1 + w.x * w.x, 0.3);
            let ground = Rgb::grey(0.1);
            Some(Sight::Sky(std::sync::Arc::new(Sky::new(
                glam::Mat3::IDENTITY,
                32,
                radiance,
                ground,
            ))))
        }
        Sight::Sky(_) => None,
    }
}

#[test]
fn directions_of_all_that_surrounds_a_scene_follow_their_density() {
    let bin = |w: Vec3| {
        let level = ((0.5 * (w.z + 1.0) * 10.0) as usize).min(9);
        let turn = w.y.atan2(w.x) / std::f32::consts::TAU + 0.5;
        level * 12 + ((turn * 12.0) as usize).min(11)
    };
    for sight in std::iter::successors(next_sight(None), |last| next_sight(Some(last))) {
        for normal in [Vec3::ZERO, Vec3::Z, Vec3::new(0.6, 0.0, -0.8)] {
            let light = Surroundings { sight: sight.clone(), asked: Some(0) };
            let site = site(Vec3::ZERO, normal);
            let mut counts = vec![0; 121];
            for i in 0..SAMPLES {
                let u = random::unit_pair(random::at(13, i));
                let Some(arrival) = light.sample(&site, u) else {
                    counts[120] += 1;
                    continue;
                };
                assert!(
                    (arrival.wi.length() - 1.0).abs() < 1e-5 && arrival.shadow.t_max.is_infinite()
                );
                let told = light.pdf_w(&site, arrival.wi);
                // On the rim of a disc rounding may put it outside.
                assert!((told / arrival.pdf_w - 1.0).abs() < 1e-4 || told == 0.0, "{sight:?}");
                let truth = light.radiance(arrival.wi).g / arrival.pdf_w;
                assert!((arrival.irradiance.g - truth).abs() < 1e-3 * truth || told == 0.0);
                counts[bin(arrival.wi)] += 1;
            }
            let mut probabilities = vec![0.0; 121];
            let points = 10 * POINTS;
            for i in 0..points {
                let u = [0.754_877_666_246_693, 0.569_840_290_998_053]
                    .map(|step| (step * i as f64).fract() as f32);
                let wi = warp::square_to_sphere(Vec2::from_array(u));
                let pdf_w = f64::from(light.pdf_w(&site, wi));
                probabilities[bin(wi)] += pdf_w * 2.0 * std::f64::consts::TAU / points as f64;
            }
            let sum: f64 = probabilities.iter().sum();
            let lost = counts[120] as f64 / SAMPLES as f64;
            assert!((sum + lost - 1.0).abs() < 2e-3, "{sight:?}: {sum} and {lost}");
            probabilities.iter_mut().for_each(|p| *p *= (1.0 - lost) / sum);
            probabilities[120] = lost;
            chi_squared::assert_fits(&counts, &probabilities);
        }
    }
}

/// One of each kind of light, after the one that was last.
fn next_light(last: Option<&Light>, lamp: &Lamp) -> Option<Light> {
    let bulb = PointLight { position: Vec3::new(0.2, 0.1, 1.5), intensity: Rgb::ONE };
    let Some(last) = last else {
        return Some(Light::Directional(Directional { to_light: Vec3::Z, irradiance: Rgb::ONE }));
    };
    match last {
        Light::Directional(_) => Some(Light::Lamp(Box::new(lamp.clone()))),
        Light::Lamp(_) => Some(Light::Point(bulb)),
        Light::Point(_) => Some(Light::Spot(SpotLight::new(bulb, Vec3::NEG_Z, [0.5, 0.9]))),
        Light::Spot(_) => {
            let sight = Sight::Constant(Rgb::ONE);
            Some(Light::Surroundings(Surroundings { sight, asked: None }))
        }
        Light::Surroundings(_) => None,
    }
}

/// What a light tells of a sample is what can be seen of it: the way is open up to the light and no
/// further, and no light without extent has a density.
#[test]
fn every_light_sends_shadow_rays_that_end_at_it() {
    let v = Vec3::new;
    let alone = Alone::new().quad(v(-0.5, -0.5, 1.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0));
    let (geometry, lamp) = alone.lamp(true);
    let here = site(Vec3::ZERO, Vec3::Z);
    for light in
        std::iter::successors(next_light(None, &lamp), |last| next_light(Some(last), &lamp))
    {
        for i in 0..1000 {
            let u = random::unit_pair(random::at(17, i));
            let arrival = light.sample(&geometry, &here, u).expect("seen from there");
            let Arrival { wi, irradiance, pdf_w, shadow } = arrival;
            assert!((wi.length() - 1.0).abs() < 1e-5 && irradiance.is_finite(), "{light:?}");
            let extended = matches!(light, Light::Lamp(_) | Light::Surroundings(_));
            assert_eq!(pdf_w > 0.0, extended, "{light:?}");
            match light {
                Light::Lamp(_) => assert!(!geometry.occluded(&shadow)),
                Light::Point(_) | Light::Spot(_) => {
                    // The lamp is in the way of what is above it, where it is.
                    let at = wi / wi.z;
                    let behind = at.x.abs() < 0.499 && at.y.abs() < 0.499;
                    assert!(!behind || geometry.occluded(&shadow), "{light:?}");
                    let end = shadow.origin + shadow.t_max * shadow.direction;
                    assert!((end - v(0.2, 0.1, 1.5)).length() < 1e-4, "{light:?}: {end}");
                }
                Light::Directional(_) | Light::Surroundings(_) => {
                    assert!(shadow.t_max.is_infinite());
                }
            }
        }
    }
}
