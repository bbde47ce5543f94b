//! When a render ends: by samples, time or error, and tile by tile; and that the count it ended at
//! makes the same picture again.

mod by_hand;

use std::sync::Mutex;

use glam::{DVec3, dvec3};
use scn::measure::statistics::Moments;
use scn::prepare::Prepared;
use scn::render::film::Taken;
use scn::run::{self, Begin, Outcome, Rule, Settings, Stopped, Until, Watch};

use by_hand::{Hand, Patient, Ticking, direct, still_life};

fn render(prepared: &Prepared, seed: u64, until: Until, watch: &dyn Watch) -> Outcome {
    let Prepared { world, integrator, .. } = prepared;
    let settings = Settings { seed, until };
    run::render(world, integrator, &settings, Begin::new(world), watch)
}

fn until(rule: Rule) -> Until {
    Until::Rule(rule)
}

fn samples(samples: u64) -> Until {
    until(Rule { samples: Some(samples), ..Rule::default() })
}

/// The same picture, the same knowledge of it.
fn assert_same(a: &Outcome, b: &Outcome) {
    assert_eq!(a.picture, b.picture);
    assert_eq!(a.standard_error, b.standard_error);
    assert_eq!(a.noise, b.noise);
    assert_eq!(a.schedule, b.schedule);
    assert_eq!(a.taken, b.taken);
}

/// The still life, small, with one sample a round.
fn life() -> Prepared {
    still_life().size(20, 14).grid(1).prepared()
}

#[test]
fn an_error_ends_it_when_the_samples_have_doubled() {
    let prepared = life();
    let mut last = u64::MAX;
    for error in [0.02, 0.04, 0.08] {
        let rule = Rule { error: Some(error), ..Rule::default() };
        let outcome = render(&prepared, 5, until(rule), &Patient);
        assert_eq!(outcome.stopped, Stopped::Error);
        let count = outcome.samples;
        assert!(count >= 256 && (count / 256).is_power_of_two(), "{count}");
        assert!(count <= last);
        last = count;
        assert!(outcome.noise.unwrap().high.sqrt() <= error);
        if count > 256 {
            // It did not end at the check before.
            let before = render(&prepared, 5, samples(count / 2), &Patient);
            assert!(before.noise.unwrap().high.sqrt() > error);
        }
        assert_same(&outcome, &render(&prepared, 5, samples(count), &Patient));
    }
    assert_eq!(last, 256, "no error is looked at before");
}

#[test]
fn the_first_limit_to_be_reached_ends_it() {
    let prepared = life();
    let all = Rule { samples: Some(300), time: Some(1e9), error: Some(1e-6), adaptive: false };
    let ended = |rule: Rule, step: f64| {
        let outcome = render(&prepared, 1, until(rule), &Ticking::new(step, u64::MAX));
        (outcome.stopped, outcome.samples)
    };
    assert_eq!(ended(all, 1e-3), (Stopped::Samples, 300));
    assert_eq!(ended(Rule { error: Some(0.9), ..all }, 1e-3), (Stopped::Error, 256));
    let (stopped, count) = ended(Rule { time: Some(2.0), ..all }, 0.1);
    assert_eq!(stopped, Stopped::Time);
    assert!((1..300).contains(&count));
}

#[test]
fn time_ends_it_after_whole_passes() {
    let prepared = life();
    for (step, time) in [(0.01, 1.0), (0.1, 3.0), (0.3, 0.1)] {
        let rule = Rule { time: Some(time), ..Rule::default() };
        let outcome = render(&prepared, 2, until(rule), &Ticking::new(step, u64::MAX));
        assert_eq!(outcome.stopped, Stopped::Time);
        assert!(outcome.samples >= 1 && outcome.seconds >= time);
        assert_same(&outcome, &render(&prepared, 2, samples(outcome.samples), &Patient));
    }
}

/// Left half black, right half a lamp, the border within the middle of three columns of tiles; below
/// it a single row of tiles of black.
fn edge() -> Hand {
    Hand::new(direct())
        .size(64, 32)
        .grid(1)
        .material("lamp", 0.0, 1.0)
        .quad(dvec3(-0.5 + 0.1 / 32.0, 0.0, 0.0), 0.5 * DVec3::X, 2.0 * DVec3::Y, "lamp")
        .camera(DVec3::Z, DVec3::ZERO, 2.0 * 0.5_f64.atan().to_degrees())
}

#[test]
fn tiles_end_one_by_one_but_not_beside_unfinished_ones() {
    let prepared = edge().prepared();
    let rule = Rule { error: Some(0.02), adaptive: true, ..Rule::default() };
    let outcome = render(&prepared, 0, until(rule), &Patient);
    assert_eq!(outcome.stopped, Stopped::Error);
    let schedule = outcome.schedule.clone().unwrap();
    // Two rows of four tiles; the border goes through the third column.
    let most = outcome.samples;
    assert!(most > 256);
    let row = [256, most, most, most];
    assert_eq!(schedule, [row, row].concat());
    assert!(outcome.noise.unwrap().high.sqrt() <= 0.02);
    assert_same(&outcome, &render(&prepared, 0, Until::Schedule(schedule), &Patient));
}

#[test]
fn ending_tiles_early_shifts_nothing_beyond_the_noise() {
    let prepared = edge().prepared();
    let rule = Rule { error: Some(0.0213), adaptive: true, ..Rule::default() };
    let mut column = Moments::default();
    let mut schedules = Vec::new();
    for seed in 0..24 {
        let outcome = render(&prepared, seed, until(rule), &Patient);
        column.extend((0..32).map(|y| f64::from(outcome.picture.at(32, y).g)));
        schedules.push(outcome.samples);
    }
    // The border covers a tenth of the column.
    let z = (column.mean() - 0.1) / column.standard_error();
    assert!(z.abs() < 4.0, "{z}");
    assert!(column.standard_error() < 0.1 * 0.01);
    schedules.sort_unstable();
    schedules.dedup();
    assert!(schedules.len() > 1, "the seeds decide when it ends: {schedules:?}");
}

/// Keeps what was taken after so many passes, and asks for an end then.
struct Keeping {
    passes: Mutex<u64>,
    kept: Mutex<Option<Taken>>,
}

impl Keeping {
    fn new(passes: u64) -> Self {
        Self { passes: Mutex::new(passes), kept: Mutex::default() }
    }
}

impl Watch for Keeping {
    fn cancelled(&self) -> bool {
        self.kept.lock().unwrap().is_some()
    }

    fn now(&self) -> f64 {
        0.0
    }

    fn progress(&self, _done: u64, _total: u64) {}

    fn passed(&self, taken: &Taken, _seconds: f64) {
        let mut passes = self.passes.lock().unwrap();
        *passes -= 1;
        if *passes == 0 {
            *self.kept.lock().unwrap() = Some(taken.clone());
        }
    }
}

#[test]
fn what_was_kept_between_passes_is_gone_on_from_to_the_same_bits() {
    let stratified = still_life().size(20, 14).grid(3).prepared();
    let adaptive = Rule { error: Some(0.02), adaptive: true, ..Rule::default() };
    for (prepared, until) in [
        (&life(), samples(200)),
        (&stratified, samples(163)),
        (&edge().prepared(), until(adaptive)),
    ] {
        let whole = render(prepared, 3, until.clone(), &Patient);
        for passes in [1, 2, 3, 5] {
            let keeping = Keeping::new(passes);
            render(prepared, 3, until.clone(), &keeping);
            let kept = keeping.kept.into_inner().unwrap();
            let Some(taken) = kept else { panic!("fewer than {passes} passes") };
            assert!(taken.fits(&prepared.world.film.window, 0, prepared.world.sampler.rhythm()));
            let settings = Settings { seed: 3, until: until.clone() };
            let Prepared { world, integrator, .. } = prepared;
            let begin = Begin { taken, seconds: 1.0 };
            let resumed = run::render(world, integrator, &settings, begin, &Patient);
            assert_same(&resumed, &whole);
        }
    }
}

#[test]
fn the_time_of_earlier_parts_counts() {
    let prepared = life();
    let first = render(&prepared, 0, samples(9), &Patient);
    let Prepared { world, integrator, .. } = &prepared;
    let rule = Rule { time: Some(60.0), ..Rule::default() };
    let settings = Settings { seed: 0, until: until(rule) };
    let begin = Begin { taken: first.taken.clone(), seconds: 61.0 };
    let resumed = run::render(world, integrator, &settings, begin, &Ticking::new(1.0, u64::MAX));
    assert_eq!((resumed.stopped, resumed.samples), (Stopped::Time, 9));
    assert!(resumed.seconds > 61.0);
}

#[test]
fn one_sample_knows_nothing_of_its_error() {
    let outcome = render(&life(), 0, samples(1), &Patient);
    assert_eq!((outcome.noise, outcome.standard_error), (None, None));
    let two = render(&life(), 0, samples(2), &Patient);
    assert!(two.noise.unwrap().relmse > 0.0 && two.standard_error.is_some());
}
