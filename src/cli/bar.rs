//! A bar with an estimate for work that takes longer than a second, on a terminal alone.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::log::{Event, Log};
use super::stop;
use super::words::duration;
use crate::math::Progress;
use crate::run::Watch;

/// Work shorter than this has no bar; in milliseconds.
const PATIENCE: u64 = 1000;
/// Time between two changes of the bar, in milliseconds.
const PAUSE: u64 = 100;
/// Time between two lines on progress in the log for machines, in milliseconds.
const LOG_PAUSE: u64 = 1000;

/// Shows how far the work is. Workers call it often: most calls are one look at the clock.
pub struct Bar {
    shown: bool,
    clock: Instant,
    /// When the work that is shown began, in milliseconds on the clock.
    begun: AtomicU64,
    /// When the bar may change next, in milliseconds on the clock.
    next: AtomicU64,
    /// What was done when it began: by an earlier part of the work.
    before: AtomicU64,
    bar: Mutex<ProgressBar>,
}

impl Bar {
    /// A bar that shows itself only if `shown`.
    pub fn new(shown: bool) -> Self {
        Self {
            shown,
            clock: Instant::now(),
            begun: AtomicU64::new(0),
            next: AtomicU64::new(PATIENCE),
            before: AtomicU64::new(u64::MAX),
            bar: Mutex::new(ProgressBar::hidden()),
        }
    }

    /// Seconds since the bar was made.
    pub fn seconds(&self) -> f64 {
        self.clock.elapsed().as_secs_f64()
    }

    /// Work of this name begins; what was shown before goes away.
    pub fn begin(&self, work: &str) {
        if !self.shown {
            return;
        }
        let style = ProgressStyle::with_template("{prefix}  {bar:30}  {percent:>3} %  {msg}")
            .expect("the template is right");
        let bar = ProgressBar::hidden().with_style(style).with_prefix(work.to_string());
        self.replace(bar);
        let now = self.now();
        self.begun.store(now, Ordering::Relaxed);
        self.before.store(u64::MAX, Ordering::Relaxed);
        self.next.store(now + PATIENCE, Ordering::Relaxed);
    }

    /// The work is done; the bar goes away.
    pub fn end(&self) {
        if self.shown {
            self.replace(ProgressBar::hidden());
            self.next.store(u64::MAX, Ordering::Relaxed);
        }
    }

    fn now(&self) -> u64 {
        self.clock.elapsed().as_millis() as u64
    }

    fn replace(&self, bar: ProgressBar) {
        let mut current = self.bar.lock().unwrap_or_else(PoisonError::into_inner);
        current.finish_and_clear();
        *current = bar;
    }
}

impl Progress for Bar {
    fn cancelled(&self) -> bool {
        stop::asked()
    }

    fn advance(&self, done: u64, total: u64) {
        if !self.shown {
            return;
        }
        let before = self.before.fetch_min(done, Ordering::Relaxed);
        let now = self.now();
        if !due(&self.next, now, PAUSE) || done <= before {
            return;
        }
        let bar = self.bar.lock().unwrap_or_else(PoisonError::into_inner);
        if bar.is_hidden() {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        bar.set_length(total);
        bar.set_position(done);
        let elapsed = (now - self.begun.load(Ordering::Relaxed)) as f64 / 1000.0;
        let left = elapsed * total.saturating_sub(done) as f64 / (done - before) as f64;
        bar.set_message(format!("about {} left", duration(left.ceil())));
    }
}

/// Watches one render: for the bar, for the log, and for Ctrl-C.
pub struct Watcher<'a> {
    bar: &'a Bar,
    log: Log,
    render: &'a str,
    /// When the log is told next, in milliseconds on the bar's clock.
    next: AtomicU64,
}

impl<'a> Watcher<'a> {
    /// Of the render of that name.
    pub fn new(bar: &'a Bar, log: Log, render: &'a str) -> Self {
        Self { bar, log, render, next: AtomicU64::new(0) }
    }
}

impl Watch for Watcher<'_> {
    fn cancelled(&self) -> bool {
        stop::asked()
    }

    fn now(&self) -> f64 {
        self.bar.seconds()
    }

    fn progress(&self, done: u64, total: u64) {
        self.bar.advance(done, total);
        if self.log.tells_progress() && due(&self.next, self.bar.now(), LOG_PAUSE) {
            self.log.tell(&Event::Progress { render: self.render.to_string(), done, total });
        }
    }
}

/// Whether it is time for what is done every `pause` milliseconds; true for one caller alone.
fn due(next: &AtomicU64, now: u64, pause: u64) -> bool {
    let at = next.load(Ordering::Relaxed);
    let order = Ordering::Relaxed;
    now >= at && next.compare_exchange(at, now + pause, order, order).is_ok()
}
