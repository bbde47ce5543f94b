//! Where faults are told: each once, and none that follows from another.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashSet};

use super::faults::Faults;
use crate::diag::{Code, Diagnostic, FileId, Level, Span};

/// What has been told so far.
#[derive(Default)]
pub struct Reports {
    /// By the text they stand in.
    told: RefCell<BTreeMap<Option<FileId>, Faults>>,
    seen: RefCell<HashSet<(Code, Option<Span>)>>,
    muted: RefCell<Vec<Span>>,
    broken: RefCell<HashSet<String>>,
    no_kinds: RefCell<HashSet<String>>,
    incomplete: Cell<bool>,
    used: Cell<Option<Span>>,
    errors: Cell<usize>,
}

impl Reports {
    /// Tells a fault, unless it was told or stands where a text was repaired.
    pub fn tell(&self, mut diagnostic: Diagnostic) {
        if diagnostic.level == Level::Error {
            self.errors.set(self.errors.get() + 1);
        }
        diagnostic.labels.retain(|label| !super::defaults::is_nowhere(label.span));
        let place = diagnostic.place();
        if super::parse::within(&diagnostic, &self.muted.borrow()) {
            return;
        }
        if let (Some(used), Some(place)) = (self.used.get(), place) {
            let inside =
                used.file == place.file && used.start <= place.start && place.end <= used.end;
            if !inside && diagnostic.labels.iter().all(|label| label.span != used) {
                diagnostic = diagnostic.label(used, "used here");
            }
        }
        if self.seen.borrow_mut().insert((diagnostic.code, place)) {
            self.told.borrow_mut().entry(place.map(|p| p.file)).or_default().push(diagnostic);
        }
    }

    /// Tells the fault of `place`, which is built only if it will be told: for faults of which a
    /// text may have a great many, each found once.
    pub fn tell_with(&self, place: Span, build: impl FnOnce() -> Diagnostic) {
        let full = self.told.borrow().get(&Some(place.file)).is_some_and(Faults::is_full);
        match full {
            false => self.tell(build()),
            true => {
                self.errors.set(self.errors.get() + 1);
                let mut told = self.told.borrow_mut();
                told.entry(Some(place.file)).or_default().push_with(build);
            }
        }
    }

    /// From here on, faults of values written elsewhere say that they are used at `place`; gives
    /// the place before.
    pub fn used_at(&self, place: Option<Span>) -> Option<Span> {
        self.used.replace(place)
    }

    /// Tells that a name is not known, unless what could not be read may have defined it.
    pub fn tell_unknown(&self, name: &str, diagnostic: Diagnostic) {
        if self.may_exist(name) {
            self.errors.set(self.errors.get() + 1);
        } else {
            self.tell(diagnostic);
        }
    }

    /// The same, built only if it will be told, as by [`Self::tell_with`].
    pub fn tell_unknown_with(&self, name: &str, place: Span, build: impl FnOnce() -> Diagnostic) {
        if self.may_exist(name) {
            self.errors.set(self.errors.get() + 1);
        } else {
            self.tell_with(place, build);
        }
    }

    /// Whether a name may be defined by something that could not be read.
    pub fn may_exist(&self, name: &str) -> bool {
        self.incomplete.get() || self.broken.borrow().contains(name)
    }

    /// Tells faults of a text as they are.
    pub fn tell_text(&self, text: FileId, faults: Faults) {
        self.errors.set(self.errors.get() + faults.len());
        self.seen.borrow_mut().extend(faults.kept.iter().map(|d| (d.code, d.place())));
        self.told.borrow_mut().entry(Some(text)).or_default().append(faults);
    }

    /// From here on, nothing that stands there is told.
    pub fn mute(&self, places: Vec<Span>) {
        self.muted.borrow_mut().extend(places);
    }

    /// These words may be names of something that could not be read.
    pub fn poison(&self, words: impl IntoIterator<Item = String>) {
        self.broken.borrow_mut().extend(words);
    }

    /// This word is no kind; true if that is new.
    pub fn is_no_kind(&self, word: &str) -> bool {
        self.no_kinds.borrow_mut().insert(word.to_string())
    }

    /// A file could not be read: any name may be its.
    pub fn file_is_missing(&self) {
        self.incomplete.set(true);
    }

    /// How many errors there were, those not told included.
    pub fn errors(&self) -> usize {
        self.errors.get()
    }

    /// Everything told, in the order of the texts.
    pub fn finish(self) -> Vec<Diagnostic> {
        let told = self.told.into_inner();
        let mut told: Vec<_> = told.into_values().flat_map(Faults::finish).collect();
        told.sort_by_key(|d| d.place().map(|span| (span.file, span.start)));
        told
    }
}
