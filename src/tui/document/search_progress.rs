//! How far a search has come, as both who searches and who waits see it.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// What is done at the end of a search, in parts of a thousand.
const WHOLE: u32 = 1000;

/// How far a search has come, and whether somebody still waits for it.
#[derive(Debug, Default)]
pub(crate) struct SearchProgress {
    /// What is done, in parts of a thousand.
    done: AtomicU32,
    /// Nobody waits any more.
    is_left: AtomicBool,
}

impl SearchProgress {
    /// A part of the search is done; whether it is to go on.
    pub(crate) fn tell(&self, part: f64) -> bool {
        let part = part.clamp(0.0, 1.0) * f64::from(WHOLE);
        self.done.store(part as u32, Ordering::Relaxed);
        !self.is_left.load(Ordering::Relaxed)
    }

    /// What is done, in percent.
    pub(crate) fn percent(&self) -> u32 {
        self.done.load(Ordering::Relaxed) / (WHOLE / 100)
    }

    /// Nobody waits for it any more.
    pub(crate) fn leave(&self) {
        self.is_left.store(true, Ordering::Relaxed);
    }
}
