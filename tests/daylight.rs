//! Pictures under the sky to the light that is known of it, from the model to the pixel.

mod by_hand;

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use scn::math::{Rgb, Spectrum};
use scn::measure::statistics::{Moments, agrees};
use scn::optics::colour;
use scn::optics::daylight::{Air, Sky, Sun, bird_riordan, position, sun};
use scn::plan::daylight::Daylight;
use scn::scene::{
    self, Ambient, AreaLights, Depth, Integrator, NoSun, Path, Preetham, SunDirection, SunDisc,
    SunForm, Switch,
};

use by_hand::{Hand, Patient, at, direct, integrator, path, render, splits};

const ALBEDO: f64 = 0.5;

/// The sky of a turbidity whose sun is at a zenith angle in degrees, in the south; north is -z and
/// up is y.
fn sky(turbidity: f64, degrees: f64, sun: SunForm) -> Preetham {
    let day = 255;
    let latitude = position::declination(day as f64) + degrees.to_radians();
    Preetham {
        turbidity: at(scene::Number(turbidity)),
        latitude: at(scene::Angle(latitude)),
        day: at(scene::Count(day)),
        time: at(scene::Time(12.0 * 3600.0)),
        longitude: at(None),
        zone: at(None),
        north: at(scene::Direction(DVec3::NEG_Z)),
        up: at(scene::Direction(DVec3::Y)),
        sun: at(sun),
        ground: at(scene::Reflectance(Spectrum::Constant(0.0))),
    }
}

fn disc(half_angle: f64) -> SunForm {
    SunForm::SunDisc(SunDisc { half_angle: at(scene::Angle(half_angle)) })
}

fn direction() -> SunForm {
    SunForm::SunDirection(SunDirection {})
}

fn no_sun() -> SunForm {
    SunForm::NoSun(NoSun {})
}

fn under(mut hand: Hand, sky: Preetham) -> Hand {
    let light = scene::Light::Preetham(sky);
    hand.scene.lights.push(scene::Named { name: at("sky".to_string()), value: at(light) });
    hand
}

/// One pixel of a small floor in the open, whose normal is given.
fn floor(integrator: Integrator, normal: DVec3, sky: Preetham) -> Hand {
    let (u, v) = normal.normalize().any_orthonormal_pair();
    let eye = 0.1 * normal.normalize() + 0.05 * u + 0.03 * v;
    let hand = Hand::new(integrator)
        .material("grey", ALBEDO, 0.0)
        .quad(DVec3::ZERO, 0.01 * u, 0.01 * v, "grey")
        .camera(eye, DVec3::ZERO, 1e-3)
        .grid(32);
    under(hand, sky)
}

/// Direct light, that of the sky included.
fn in_the_open(area_lights: AreaLights) -> Integrator {
    let Integrator::Direct(mut direct) = integrator(true, area_lights) else { unreachable!() };
    direct.environment = at(Switch(true));
    Integrator::Direct(direct)
}

fn tracer(change: impl Fn(&mut Path)) -> Integrator {
    let mut path = path();
    change(&mut path);
    Integrator::Path(path)
}

fn ambient(rays: u64, direct: bool) -> Integrator {
    Integrator::Ambient(Ambient {
        rays: at(scene::Count(rays)),
        distance: at(None),
        direct: at(Switch(direct)),
        lights: at(scene::LightCount::All),
        light_samples: at(scene::Count(1)),
        specular_depth: at(Depth::Most(10)),
        splits: at(splits(0, 0, 1)),
        roulette: at(scene::Roulette::Throughput),
        paths: at(None),
    })
}

/// The irradiance in klx that lights a floor so, over 16 seeds.
fn klx(hand: &Hand, samples: u64) -> Moments {
    let prepared = hand.prepared();
    let mut moments = Moments::default();
    for seed in 0..16 {
        let Rgb { r, g, b } = render(&prepared, seed, samples, &Patient).picture.pixels[0];
        let luminance = colour::luminance([r, g, b].map(f64::from));
        moments.add(luminance * PI / ALBEDO * colour::LUMENS_A_WATT / 1000.0);
    }
    moments
}

fn assert_near(found: &Moments, truth: f64, tolerance: f64, what: &str) {
    let verdict = agrees(found.mean(), found.standard_error(), truth, tolerance * truth);
    assert!(verdict.holds(), "{what}: {verdict}");
}

#[test]
fn level_ground_gets_of_the_sky_what_is_known() {
    let integrators = [
        ("direct", in_the_open(AreaLights::Random)),
        ("lamps at their centres", in_the_open(AreaLights::Center)),
        ("path", tracer(|_| ())),
        ("without mis", tracer(|path| path.mis = at(Switch(false)))),
        ("by chance", tracer(|path| path.next_event = at(Switch(false)))),
        ("ambient", ambient(4, true)),
        ("ambient alone", ambient(4, false)),
    ];
    for (turbidity, degrees, truth) in
        [(2.0, 45.0, 25.1643), (3.0, 60.0, 24.0041), (6.0, 30.0, 56.0743)]
    {
        for (name, integrator) in &integrators {
            let sky = sky(turbidity, degrees, no_sun());
            let found = klx(&floor(integrator.clone(), DVec3::Y, sky), 1024);
            assert_near(&found, truth, 0.01, &format!("{name}, turbidity {turbidity}"));
        }
    }
}

/// Every channel, against the model's own integral, which sums other points.
#[test]
fn level_ground_has_the_colour_of_sky_and_sun() {
    for form in [no_sun(), disc(sun::HALF_ANGLE), disc(0.2), direction()] {
        let sky = sky(2.4, 52.0, form);
        let truth = Daylight::of(&sky).unwrap().level_irradiance();
        let prepared = floor(tracer(|_| ()), DVec3::Y, sky).prepared();
        for channel in 0..3 {
            let mut moments = Moments::default();
            for seed in 0..16 {
                let Rgb { r, g, b } = render(&prepared, seed, 1024, &Patient).picture.pixels[0];
                moments.add(f64::from([r, g, b][channel]) * PI / ALBEDO);
            }
            assert_near(&moments, truth[channel], 0.005, &format!("channel {channel}"));
        }
    }
}

/// By direct light alone the sky lights nothing: what is left is the sun's. Illuminances on a
/// surface square to it are those of the data [Preetham99, table 2].
#[test]
fn a_disc_gives_the_same_light_as_a_direction_whatever_its_size() {
    for (turbidity, degrees, truth) in [(2.0, 0.0, 101.8), (2.0, 60.0, 81.2), (4.0, 80.0, 12.2)] {
        let square = Daylight::of(&sky(turbidity, degrees, direction())).unwrap().to_sun();
        for normal in [square, DVec3::Y, dvec3(0.4, 1.0, 0.8)] {
            let cos = normal.normalize().dot(square);
            for form in [direction(), disc(sun::HALF_ANGLE), disc(1e-4)] {
                let found = klx(&floor(direct(), normal, sky(turbidity, degrees, form)), 64);
                assert_near(&found, truth * cos, 0.005, &format!("{turbidity} {degrees} {normal}"));
            }
        }
    }
}

#[test]
fn a_path_finds_the_sun_by_asking_as_well_as_by_chance() {
    let truth = 81.2 * 60_f64.to_radians().cos();
    // A disc so large that rays find it by chance; with and without weights.
    for (mis, next_event) in [(true, true), (false, true), (true, false)] {
        let tracer = tracer(|path| {
            path.mis = at(Switch(mis));
            path.next_event = at(Switch(next_event));
        });
        let bright = sky(2.0, 60.0, disc(0.3));
        let with = klx(&floor(tracer.clone(), DVec3::Y, bright), 8192);
        let without = klx(&floor(tracer, DVec3::Y, sky(2.0, 60.0, no_sun())), 8192);
        let error = with.standard_error().hypot(without.standard_error());
        let verdict = agrees(with.mean() - without.mean(), error, truth, 0.03 * truth);
        assert!(verdict.holds(), "{mis} {next_event}: {verdict}");
    }
}

/// What a camera sees that looks into the sky.
fn seen(sky: Preetham, towards: DVec3) -> [f64; 3] {
    let hand = Hand::new(tracer(|_| ()))
        .material("grey", ALBEDO, 0.0)
        .quad(DVec3::NEG_Y * 9.0, DVec3::X, DVec3::Z, "grey")
        .camera(DVec3::ZERO, towards, 1e-3);
    let Rgb { r, g, b } = under(hand, sky).picture().pixels[0];
    [r, g, b].map(f64::from)
}

#[test]
fn the_sky_is_seen_as_the_model_has_it() {
    for (turbidity, degrees) in [(2.0, 45.0), (6.0, 10.0), (10.0, 90.0 - 1e-9)] {
        let light = sky(turbidity, degrees, direction());
        let day = Daylight::of(&light).unwrap();
        for towards in [
            DVec3::Y,
            dvec3(1.0, 0.001, 0.2),
            dvec3(0.3, 0.2, 1.0),
            dvec3(-0.5, 0.6, -0.1),
            day.to_sun() + 0.02 * DVec3::X + 0.001 * DVec3::Y,
        ] {
            let towards = towards.normalize();
            let truth = day.sky_radiance(day.place.transpose() * towards);
            for (found, truth) in seen(light.clone(), towards).into_iter().zip(truth) {
                let off = found / truth - 1.0;
                assert!(off.abs() < 0.01, "{turbidity} {degrees} {towards}: {off}");
            }
        }
    }
}

#[test]
fn the_disc_of_the_sun_is_seen_where_it_stands() {
    let light = sky(2.4, 52.0, disc(sun::HALF_ANGLE));
    let day = Daylight::of(&light).unwrap();
    let (east, _) = day.to_sun().any_orthonormal_pair();
    let brightness = |angle: f64| seen(light.clone(), day.to_sun() + angle * east)[1];
    let inside = day.sun_irradiance()[1] / sun::solid_angle(sun::HALF_ANGLE);
    assert!((brightness(0.0) / inside - 1.0).abs() < 1e-3, "{}", brightness(0.0));
    assert!((brightness(0.95 * sun::HALF_ANGLE) / inside - 1.0).abs() < 1e-3);
    assert!(brightness(1.05 * sun::HALF_ANGLE) < 1e-4 * inside);
    // As a direction it lights, and is not seen.
    assert!(seen(sky(2.4, 52.0, direction()), day.to_sun())[1] < 1e-4 * inside);
}

#[test]
fn ground_below_the_horizon_is_black_unless_it_has_an_albedo() {
    let mut light = sky(2.4, 52.0, direction());
    let down = dvec3(0.3, -0.2, 1.0);
    assert_eq!(seen(light.clone(), down), [0.0; 3]);
    let level = Daylight::of(&light).unwrap().level_irradiance();
    light.ground = at(scene::Reflectance(Spectrum::Rgb([0.2, 0.4, 0.1])));
    let found = seen(light.clone(), down);
    for (channel, albedo) in [0.2, 0.4, 0.1].into_iter().enumerate() {
        let truth = albedo * level[channel] / PI;
        assert!((found[channel] / truth - 1.0).abs() < 1e-5, "{found:?}");
    }
    // It lights what faces down, as much as it is bright.
    light.sun = at(no_sun());
    let [r, g, b] = Daylight::of(&light).unwrap().ground_radiance();
    let truth = PI * colour::luminance([r, g, b]) * colour::LUMENS_A_WATT / 1000.0;
    for integrator in [in_the_open(AreaLights::Random), tracer(|_| ())] {
        let found = klx(&floor(integrator, DVec3::NEG_Y, light.clone()), 4096);
        assert_near(&found, truth, 0.01, "from below");
    }
}

#[test]
fn at_the_horizon_there_is_light_and_below_it_night() {
    for (degrees, bright) in [(90.0 - 1e-9, true), (90.0 + 1e-6, false), (140.0, false)] {
        for form in [disc(sun::HALF_ANGLE), direction(), no_sun()] {
            let sky = sky(2.4, degrees, form);
            let hand = floor(tracer(|_| ()), DVec3::Y, sky).samples(64);
            assert_eq!(hand.codes().contains(&"scene/night"), !bright, "{degrees}");
            let Rgb { r, g, b } = hand.picture().pixels[0];
            assert!([r, g, b].iter().all(|c| c.is_finite() && (*c > 0.0) == bright), "{r} {g} {b}");
        }
    }
}

#[test]
fn the_sun_rises_where_east_is() {
    // Up along z and north along y, as on a map; then as seen by one who looks along -z.
    for (north, up, east) in [(DVec3::Y, DVec3::Z, DVec3::X), (DVec3::X, DVec3::Y, DVec3::Z)] {
        let at_hour = |hour: f64| {
            let mut light = sky(2.4, 52.0, direction());
            light.north = at(scene::Direction((north + 0.5 * up).normalize()));
            light.up = at(scene::Direction(up));
            light.time = at(scene::Time(hour * 3600.0));
            Daylight::of(&light).unwrap().to_sun()
        };
        assert!(at_hour(7.0).dot(east) > 0.9 && at_hour(17.0).dot(east) < -0.9);
        assert!(at_hour(12.0).dot(north) < -0.7 && at_hour(12.0).dot(up) > 0.6);
    }
}

#[test]
fn clocks_count_by_zone_and_longitude() {
    let at_place = |longitude: f64, zone: f64| {
        let mut light = sky(2.4, 52.0, direction());
        light.longitude = at(Some(scene::Angle(longitude.to_radians())));
        light.zone = at(Some(scene::Time(zone * 3600.0)));
        Daylight::of(&light).unwrap().sun
    };
    // A quarter of a turn east the sun is six hours ahead; so is the zone.
    let (here, there) = (at_place(0.0, 0.0), at_place(90.0, 6.0));
    assert!((here.zenith - there.zenith).abs() < 1e-9);
    // 15° west of the middle of a zone it is an hour behind: still in the east at noon.
    assert!(at_place(-15.0, 0.0).azimuth < at_place(0.0, 0.0).azimuth - 0.2);
}

#[test]
fn north_along_up_and_half_a_clock_are_refused() {
    let mut light = sky(2.4, 52.0, direction());
    light.up = at(scene::Direction(DVec3::Z));
    assert_eq!(floor(direct(), DVec3::Y, light).codes(), ["scene/north-is-up"]);
    let mut light = sky(2.4, 52.0, direction());
    light.zone = at(Some(scene::Time(3600.0)));
    assert_eq!(floor(direct(), DVec3::Y, light).codes(), ["scene/half-a-clock"]);
}

/// The numbers of docs/daylight.md.
#[test]
fn the_page_tells_what_the_models_give() {
    let page = std::fs::read_to_string("docs/daylight.md").unwrap();
    let mut light = sky(2.4, 52.0, direction());
    light.latitude = at(scene::Angle(55.77_f64.to_radians()));
    let day = Daylight::of(&light).unwrap();
    let zenith = day.sun.zenith;
    let klx = |rgb| colour::LUMENS_A_WATT / 1000.0 * colour::luminance(rgb);
    let row = |name: &str, rgb: [f64; 3]| {
        let [r, g, b] = rgb;
        format!("| {name} | {r:.1} | {g:.1} | {b:.1} | {:.1} |", klx(rgb))
    };
    let air = Air::of_turbidity(2.4);
    let journal = sun::radiance(&air, zenith).map(sun::irradiance_by_area);
    let other = bird_riordan::Irradiance::new(&air, 0.2, 255.0, zenith);
    let sky_alone = Sky::new(2.4, zenith).irradiance(zenith);
    let level = day.sun_irradiance().map(|channel| channel * zenith.cos());
    for told in [
        row("Lₑ A / (4 r²), Lₑ behind the air", journal),
        row("Preetham's table 2, over the disc", day.sun_irradiance()),
        row("Bird and Riordan", other.direct_channels()),
        format!("the sun\n{:.0}° high", 90.0 - zenith.to_degrees()),
        format!("{:.1} klx of the sun and {:.1} klx of the sky", klx(level), klx(sky_alone)),
        format!("ground {:.1} klx at that noon", klx(other.diffuse_channels())),
        format!("{:.0} W/m²/sr, so", colour::luminance(day.level_irradiance()) / PI),
    ] {
        assert!(page.contains(&told), "docs/daylight.md lacks: {told}");
    }
}

/// The table of docs/worksheets.md.
#[test]
fn the_worksheets_tell_the_light_of_the_day() {
    let page = std::fs::read_to_string("docs/worksheets.md").unwrap();
    let klx = |rgb| colour::LUMENS_A_WATT / 1000.0 * colour::luminance(rgb);
    for (morning, afternoon) in [(7.0, 17.0), (9.0, 15.0), (11.0, 13.0)] {
        for hour in [morning, afternoon] {
            let sun = Sun::at(55.77_f64.to_radians(), 255.0, hour);
            let light = sun::irradiance(&Air::of_turbidity(2.4), sun.zenith);
            let row = format!(
                "| {morning}, {afternoon} | {:.1}° | {:.1} | {:.2} | {:.1} |",
                90.0 - sun.zenith.to_degrees(),
                klx(light),
                light[0] / light[2],
                klx(Sky::new(2.4, sun.zenith).irradiance(sun.zenith)),
            );
            assert!(page.contains(&row), "docs/worksheets.md lacks: {row}");
        }
    }
}

/// Rays that look around leave the sun to the lights that are asked.
#[test]
fn ambient_light_is_that_of_the_sky_without_its_sun() {
    let bright = floor(ambient(16, false), DVec3::Y, sky(2.0, 45.0, disc(0.3)));
    assert_near(&klx(&bright, 256), 25.1643, 0.01, "without the sun");
    let both = floor(ambient(16, true), DVec3::Y, sky(2.0, 45.0, disc(0.3)));
    let level = Daylight::of(&sky(2.0, 45.0, direction())).unwrap().level_irradiance();
    let truth = colour::luminance(level) * colour::LUMENS_A_WATT / 1000.0;
    assert_near(&klx(&both, 256), truth, 0.01, "with the sun");
}
