//! Shares the progress of a search between its thread and the workbench.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// Progress at the end of a search, in thousandths.
const WHOLE: u32 = 1000;

/// The progress of a search, with a flag for cancelling it.
#[derive(Debug, Default)]
pub(crate) struct SearchProgress {
    /// The completed part, in thousandths.
    done: AtomicU32,
    /// `true` if the search is cancelled.
    is_left: AtomicBool,
}

impl SearchProgress {
    /// Reports the completed part, from 0 to 1. Returns `true` if the search should continue.
    pub(crate) fn tell(&self, part: f64) -> bool {
        let part = part.clamp(0.0, 1.0) * f64::from(WHOLE);
        self.done.store(part as u32, Ordering::Relaxed);
        !self.is_left.load(Ordering::Relaxed)
    }

    /// Returns the completed part in percent.
    pub(crate) fn percent(&self) -> u32 {
        self.done.load(Ordering::Relaxed) / (WHOLE / 100)
    }

    /// Cancels the search.
    pub(crate) fn leave(&self) {
        self.is_left.store(true, Ordering::Relaxed);
    }
}
