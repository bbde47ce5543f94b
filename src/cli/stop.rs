//! Ctrl-C: the first one asks the work to end well, a later one ends it.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::terminal;

/// Exit code of a process that was interrupted, by the convention of shells.
pub const INTERRUPTED: u8 = 130;

static ASKED: AtomicU32 = AtomicU32::new(0);
/// When the first one came.
static SINCE: Mutex<Option<Instant>> = Mutex::new(None);
/// A second one that comes sooner is the first one once more: some tools send it to a process and
/// then to its whole group. No finger presses twice in this time.
const ECHO: Duration = Duration::from_millis(80);
/// Held while a file is written, so that the end comes before or after it.
static WRITING: Mutex<()> = Mutex::new(());

/// Listens from now on to Ctrl-C, and to a polite request to terminate.
pub fn listen(quiet: bool) {
    let heard = ctrlc::set_handler(move || {
        let mut since = SINCE.lock().unwrap_or_else(PoisonError::into_inner);
        let first = *since.get_or_insert_with(Instant::now);
        drop(since);
        if ASKED.fetch_add(1, Ordering::SeqCst) > 0 {
            if is_echo(first.elapsed()) {
                return;
            }
            let _writing = writing();
            std::process::exit(i32::from(INTERRUPTED));
        }
        if !quiet {
            terminal::tell("\nStopping, and keeping what is done; once more ends at once.\n");
        }
    });
    // Without a handler the system ends the process at Ctrl-C, and files are whole all the same.
    drop(heard);
}

/// Whether a second one that comes so long after the first is the same once more.
fn is_echo(after: Duration) -> bool {
    after < ECHO
}

/// Whether the work was asked to end.
pub fn asked() -> bool {
    ASKED.load(Ordering::Relaxed) > 0
}

/// To be held while a file is written.
pub fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fingers_that_press_twice_in_haste_are_heard_and_the_echo_of_one_press_is_not() {
        // The fastest fingers press about eight times a second; an echo takes some milliseconds.
        assert!(!is_echo(Duration::from_millis(1000 / 8)));
        assert!(is_echo(Duration::from_millis(10)));
    }
}
