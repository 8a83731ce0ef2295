//! Runs file I/O on a background thread, so that a slow disk never blocks input.
//!
//! One thread runs the file jobs in order. Each job returns a completion, which changes the
//! workbench on the UI thread. After giving a job, the UI thread waits briefly for it, so that on a
//! normal disk no job is pending between two keys. If a disk hangs, the workbench continues without
//! it.
//!
//! A search may take long and touches no file, so each has its own thread and delays no write.
//! Without threads, as in tests, a job runs where it is given.

use crate::wording::words;
use rustix::io::{Errno, read, write};
use std::collections::VecDeque;
use std::fmt;
use std::io::{self, Error};
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// The owner of jobs, which receives their completions.
pub(crate) trait JobOwner {
    /// Reports a job that panicked.
    fn fail(&mut self, error: &Error);
}

/// The completion of a job, to be run on its owner.
pub(crate) type Completion<T> = Box<dyn FnOnce(&mut T, Duration) + Send>;
/// A job, to be run on a background thread.
type Job<T> = Box<dyn FnOnce() -> Completion<T> + Send>;

/// Maximum time to wait for a job: too short to notice, but enough for a responsive disk.
const SYNC_WAIT: Duration = Duration::from_millis(60);
/// Maximum time to wait for pending writes at exit.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(1);

/// Runs jobs, in place or on background threads.
pub(crate) struct JobRunner<T> {
    desk: Option<WorkerThreads<T>>,
    /// The completions of jobs run in place.
    done: VecDeque<Completion<T>>,
}

impl<T> Default for JobRunner<T> {
    /// Creates a runner that runs jobs in place.
    fn default() -> Self {
        JobRunner {
            desk: None,
            done: VecDeque::new(),
        }
    }
}

/// The kind of thread that runs a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WorkerKind {
    /// The thread for file jobs, which runs them in order.
    Files,
    /// A thread for a single search.
    Search,
}

/// The background threads and their pending jobs.
struct WorkerThreads<T> {
    jobs: Sender<Job<T>>,
    out: ResultSender<T>,
    done: Receiver<(WorkerKind, Completion<T>)>,
    /// Becomes readable when a job is done.
    done_signal: UnixStream,
    /// Numbers of pending file jobs and searches, and the time until which to wait for them.
    files: usize,
    searches: usize,
    patience: Instant,
}

/// Sends completions to the UI thread and wakes it.
struct ResultSender<T> {
    finished: Sender<(WorkerKind, Completion<T>)>,
    waker: Arc<UnixStream>,
}

impl<T> Clone for ResultSender<T> {
    fn clone(&self) -> Self {
        ResultSender {
            finished: self.finished.clone(),
            waker: Arc::clone(&self.waker),
        }
    }
}

impl<T: JobOwner + 'static> ResultSender<T> {
    /// Runs a job and sends its completion. Returns `false` if the owner is gone.
    fn run_job(&self, distance: WorkerKind, job: Job<T>) -> bool {
        let then = catch_unwind(AssertUnwindSafe(job)).unwrap_or_else(|_| broken());
        // A full socket already wakes the UI thread.
        self.finished.send((distance, then)).is_ok() && rings(write(&*self.waker, &[1]))
    }
}

impl<T: JobOwner + 'static> JobRunner<T> {
    /// Creates a runner with a thread for file jobs.
    ///
    /// # Errors
    /// Returns an error if the system creates no socket pair or thread.
    pub(crate) fn with_file_thread() -> io::Result<JobRunner<T>> {
        let (bell, rope) = UnixStream::pair()?;
        bell.set_nonblocking(true)?;
        rope.set_nonblocking(true)?;
        let (jobs, given) = channel::<Job<T>>();
        let (finished, done) = channel();
        let out = ResultSender {
            finished,
            waker: Arc::new(rope),
        };
        let tray = out.clone();
        let work = move || {
            for job in given {
                if !tray.run_job(WorkerKind::Files, job) {
                    return;
                }
            }
        };
        thread::Builder::new().name("files".into()).spawn(work)?;
        Ok(JobRunner {
            desk: Some(WorkerThreads {
                jobs,
                out,
                done,
                done_signal: bell,
                files: 0,
                searches: 0,
                patience: Instant::now(),
            }),
            done: VecDeque::new(),
        })
    }

    /// Submits a file job.
    pub(crate) fn submit(&mut self, job: impl FnOnce() -> Completion<T> + Send + 'static) {
        let Some(desk) = &mut self.desk else {
            self.done.push_back(job());
            return;
        };
        // The wait is not repeated with every key while a job hangs.
        if desk.files == 0 {
            desk.patience = Instant::now() + SYNC_WAIT;
        }
        match desk.jobs.send(Box::new(job)) {
            Ok(()) => desk.files += 1,
            Err(unsent) => self.done.push_back((unsent.0)()),
        }
    }

    /// Submits a search. The program does not wait for it at exit.
    pub(crate) fn search(&mut self, job: impl FnOnce() -> Completion<T> + Send + 'static) {
        let Some(desk) = &mut self.desk else {
            self.done.push_back(job());
            return;
        };
        desk.patience = Instant::now() + SYNC_WAIT;
        let tray = desk.out.clone();
        let job: Arc<Mutex<Option<Job<T>>>> = Arc::new(Mutex::new(Some(Box::new(job))));
        let given = Arc::clone(&job);
        let work = move || {
            if let Some(job) = taken(&given) {
                tray.run_job(WorkerKind::Search, job);
            }
        };
        if thread::Builder::new()
            .name("search".into())
            .spawn(work)
            .is_ok()
        {
            desk.searches += 1;
        } else if let Some(job) = taken(&job) {
            // The system creates no thread, so the job runs here.
            self.done.push_back(job());
        }
    }

    /// Returns the completion of the next finished job, after a short wait for it.
    pub(crate) fn next(&mut self) -> Option<Completion<T>> {
        if let Some(then) = self.done.pop_front() {
            return Some(then);
        }
        let desk = self.desk.as_mut();
        let desk = desk.filter(|desk| desk.files + desk.searches > 0)?;
        let patience = desk.patience.saturating_duration_since(Instant::now());
        desk.take(patience)
    }

    /// Clears the wake-up signal. Completions are sent before the signal.
    pub(crate) fn clear_signal(&self) {
        if let Some(desk) = &self.desk {
            let _ = read(&desk.done_signal, &mut [0; 64]);
        }
    }

    /// Returns a file descriptor that becomes readable when a job is done.
    pub(crate) fn bell(&self) -> Option<BorrowedFd<'_>> {
        self.desk.as_ref().map(|desk| desk.done_signal.as_fd())
    }
}

impl<T> WorkerThreads<T> {
    fn take(&mut self, patience: Duration) -> Option<Completion<T>> {
        let (distance, then) = self.done.recv_timeout(patience).ok()?;
        match distance {
            WorkerKind::Files => self.files -= 1,
            WorkerKind::Search => self.searches -= 1,
        }
        Some(then)
    }
}

impl<T> Drop for JobRunner<T> {
    /// Waits for pending file jobs, up to a time limit.
    fn drop(&mut self) {
        let end = Instant::now() + SHUTDOWN_TIMEOUT;
        while let Some(desk) = self.desk.as_mut().filter(|desk| desk.files > 0) {
            if desk
                .take(end.saturating_duration_since(Instant::now()))
                .is_none()
            {
                return;
            }
        }
    }
}

impl<T> fmt::Debug for JobRunner<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let open = self.desk.as_ref().map(|desk| (desk.files, desk.searches));
        f.debug_struct("Clerk").field("open", &open).finish()
    }
}

fn taken<T>(job: &Mutex<Option<T>>) -> Option<T> {
    job.lock().unwrap_or_else(PoisonError::into_inner).take()
}

fn rings(written: Result<usize, Errno>) -> bool {
    matches!(written, Ok(_) | Err(Errno::AGAIN | Errno::INTR))
}

/// Returns the completion of a panicked job. The thread continues with other jobs.
fn broken<T: JobOwner>() -> Completion<T> {
    Box::new(|client: &mut T, _| client.fail(&Error::other(words().broken_there())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    struct NullOwner;

    impl JobOwner for NullOwner {
        fn fail(&mut self, error: &Error) {
            panic!("{error}");
        }
    }

    /// The wake-up socket is full after several hundred bytes, and nobody reads it while a terminal
    /// line is stalled.
    #[test]
    fn jobs_run_while_wakeups_are_unread() {
        const JOBS: usize = 2000;
        let done = Arc::new(AtomicUsize::new(0));
        let mut clerk = JobRunner::<NullOwner>::with_file_thread().unwrap();
        for _ in 0..JOBS {
            let done = Arc::clone(&done);
            clerk.submit(move || {
                done.fetch_add(1, Ordering::Relaxed);
                Box::new(|_, _| {})
            });
        }
        drop(clerk);
        assert_eq!(done.load(Ordering::Relaxed), JOBS);
    }

    /// Regression: searches shared a queue with file jobs, and a file saved during a long search
    /// was lost on exit.
    #[test]
    fn searches_do_not_delay_file_jobs() {
        let mut clerk = JobRunner::<NullOwner>::with_file_thread().unwrap();
        let (end, until) = channel::<()>();
        clerk.search(move || {
            let _ = until.recv();
            Box::new(|_, _| {})
        });
        let is_written = Arc::new(AtomicUsize::new(0));
        let file = Arc::clone(&is_written);
        clerk.submit(move || {
            file.store(1, Ordering::Relaxed);
            Box::new(|_, _| {})
        });
        drop(clerk);
        assert_eq!(is_written.load(Ordering::Relaxed), 1);
        drop(end);
    }
}
