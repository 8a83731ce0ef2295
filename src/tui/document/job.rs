//! Computations on a background thread, with progress, cancelling and a result.

use crate::tui::document::io_thread::{JobOwner, JobRunner};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::Duration;

/// Progress at the end of a job, in thousandths.
const FULL_PROGRESS: u32 = 1000;

/// The progress of a job, shared with its thread.
#[derive(Debug, Default)]
pub(crate) struct JobProgress {
    /// The completed part, in thousandths.
    done: AtomicU32,
    is_cancelled: AtomicBool,
}

impl JobProgress {
    /// Reports the completed part, from 0 to 1. Returns `true` if the job should continue.
    pub(crate) fn report(&self, part: f64) -> bool {
        let part = part.clamp(0.0, 1.0) * f64::from(FULL_PROGRESS);
        self.done.store(part as u32, Ordering::Relaxed);
        !self.is_cancelled()
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }
}

/// A computation on a background thread. Dropping it cancels the computation.
#[derive(Debug)]
pub(crate) struct BackgroundJob<R> {
    progress: Arc<JobProgress>,
    /// The result, once it has arrived.
    pub(crate) result: Option<R>,
}

impl<R: Send + 'static> BackgroundJob<R> {
    /// Starts a computation. `finish` takes its result to its owner, unless the job was dropped
    /// meanwhile.
    pub(crate) fn start<T: JobOwner + 'static>(
        runner: &mut JobRunner<T>,
        work: impl FnOnce(&JobProgress) -> R + Send + 'static,
        finish: fn(&mut T, R, Duration),
    ) -> BackgroundJob<R> {
        let progress = Arc::new(JobProgress::default());
        let shared = Arc::clone(&progress);
        runner.search(move || {
            let result = work(&shared);
            Box::new(move |owner, now| {
                if !shared.is_cancelled() {
                    finish(owner, result, now);
                }
            })
        });
        BackgroundJob {
            progress,
            result: None,
        }
    }
}

impl<R> BackgroundJob<R> {
    /// Returns the progress in percent; `None` once the result has arrived.
    pub(crate) fn percent(&self) -> Option<u32> {
        let done = || self.progress.done.load(Ordering::Relaxed);
        self.result
            .is_none()
            .then(|| done() / (FULL_PROGRESS / 100))
    }
}

impl<R> Drop for BackgroundJob<R> {
    fn drop(&mut self) {
        self.progress.is_cancelled.store(true, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The results that have arrived.
    #[derive(Default)]
    struct ArrivedResults(Vec<u32>);

    impl JobOwner for ArrivedResults {
        fn fail(&mut self, error: &std::io::Error) {
            panic!("{error}");
        }
    }

    #[test]
    fn dropped_job_is_cancelled_and_delivers_nothing() {
        let (mut runner, mut owner) = (JobRunner::default(), ArrivedResults::default());
        let start = |runner: &mut JobRunner<ArrivedResults>, value: u32| {
            let work = move |progress: &JobProgress| {
                assert!(progress.report(0.5));
                value
            };
            BackgroundJob::start(runner, work, |owner: &mut ArrivedResults, value, _| {
                owner.0.push(value);
            })
        };
        let (mut kept, left) = (start(&mut runner, 1), start(&mut runner, 2));
        assert_eq!(kept.percent(), Some(50));
        let progress = Arc::clone(&left.progress);
        drop(left);
        assert!(!progress.report(0.6), "its thread stops");
        while let Some(then) = runner.next() {
            then(&mut owner, Duration::ZERO);
        }
        assert_eq!(owner.0, [1]);
        kept.result = owner.0.pop();
        assert_eq!(kept.percent(), None);
    }
}
