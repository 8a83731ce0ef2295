//! What is done to files, apart from the screen: a disk that hangs keeps no key waiting.
//!
//! A job is done by a thread, one after the other; what follows from it comes back as something to do to the
//! workbench. Whoever gives a job waits a moment for it, so that on a disk as they are nothing is ever half
//! done between two keys; on one that hangs everything else goes on. A search, which may take long and touches
//! no file, has a thread of its own, so that nothing to be written waits behind it. Without threads, as tests
//! have it, a job is done where it is given.

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

/// Whoever gives jobs.
pub(crate) trait Client {
    /// A job ended as it never should.
    fn fail(&mut self, error: &Error);
}

/// What follows from a job, for whoever gave it.
pub(crate) type Then<T> = Box<dyn FnOnce(&mut T, Duration) + Send>;
/// What is done apart from the screen.
type Job<T> = Box<dyn FnOnce() -> Then<T> + Send>;

/// How long a job is waited for: too short to be felt, and long enough for a disk that does not hang.
const GRACE: Duration = Duration::from_millis(60);
/// How long leaving waits for what is still being written.
const FAREWELL: Duration = Duration::from_secs(1);

/// Does jobs, here or apart.
pub(crate) struct Clerk<T> {
    desk: Option<Desk<T>>,
    /// What was done here.
    done: VecDeque<Then<T>>,
}

impl<T> Default for Clerk<T> {
    /// Jobs are done where they are given.
    fn default() -> Self {
        Clerk {
            desk: None,
            done: VecDeque::new(),
        }
    }
}

/// Which thread a job was given to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Apart {
    /// The one that does what is done to files, in order.
    Files,
    /// One of its own.
    Search,
}

/// Where jobs are done apart.
struct Desk<T> {
    jobs: Sender<Job<T>>,
    out: OutTray<T>,
    done: Receiver<(Apart, Then<T>)>,
    /// Rings when a job is done.
    bell: UnixStream,
    /// Jobs on files and searches that are not done yet, and until when they are waited for.
    files: usize,
    searches: usize,
    patience: Instant,
}

/// Where what follows from a job is laid, with the rope of the bell.
struct OutTray<T> {
    finished: Sender<(Apart, Then<T>)>,
    rope: Arc<UnixStream>,
}

impl<T> Clone for OutTray<T> {
    fn clone(&self) -> Self {
        OutTray {
            finished: self.finished.clone(),
            rope: Arc::clone(&self.rope),
        }
    }
}

impl<T: Client + 'static> OutTray<T> {
    /// Does a job and lays down what follows; whether anybody still wants to know.
    fn serve(&self, apart: Apart, job: Job<T>) -> bool {
        let then = catch_unwind(AssertUnwindSafe(job)).unwrap_or_else(|_| broken());
        // A bell that is full rings already; whoever has left wants to know of nothing more.
        self.finished.send((apart, then)).is_ok() && rings(write(&*self.rope, &[1]))
    }
}

impl<T: Client + 'static> Clerk<T> {
    /// With a thread of its own.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn apart() -> io::Result<Clerk<T>> {
        let (bell, rope) = UnixStream::pair()?;
        bell.set_nonblocking(true)?;
        rope.set_nonblocking(true)?;
        let (jobs, given) = channel::<Job<T>>();
        let (finished, done) = channel();
        let out = OutTray {
            finished,
            rope: Arc::new(rope),
        };
        let tray = out.clone();
        let work = move || {
            for job in given {
                if !tray.serve(Apart::Files, job) {
                    return;
                }
            }
        };
        thread::Builder::new().name("files".into()).spawn(work)?;
        Ok(Clerk {
            desk: Some(Desk {
                jobs,
                out,
                done,
                bell,
                files: 0,
                searches: 0,
                patience: Instant::now(),
            }),
            done: VecDeque::new(),
        })
    }

    /// Gives a job on files.
    pub(crate) fn give(&mut self, job: impl FnOnce() -> Then<T> + Send + 'static) {
        let Some(desk) = &mut self.desk else {
            self.done.push_back(job());
            return;
        };
        // One that hangs is not waited for again with every key.
        if desk.files == 0 {
            desk.patience = Instant::now() + GRACE;
        }
        match desk.jobs.send(Box::new(job)) {
            Ok(()) => desk.files += 1,
            Err(unsent) => self.done.push_back((unsent.0)()),
        }
    }

    /// Gives a search, which is not waited for when the program is left.
    pub(crate) fn search(&mut self, job: impl FnOnce() -> Then<T> + Send + 'static) {
        let Some(desk) = &mut self.desk else {
            self.done.push_back(job());
            return;
        };
        desk.patience = Instant::now() + GRACE;
        let tray = desk.out.clone();
        let job: Arc<Mutex<Option<Job<T>>>> = Arc::new(Mutex::new(Some(Box::new(job))));
        let given = Arc::clone(&job);
        let work = move || {
            if let Some(job) = taken(&given) {
                tray.serve(Apart::Search, job);
            }
        };
        if thread::Builder::new()
            .name("search".into())
            .spawn(work)
            .is_ok()
        {
            desk.searches += 1;
        } else if let Some(job) = taken(&job) {
            // The system creates no thread: it is done here.
            self.done.push_back(job());
        }
    }

    /// What follows from the next job that was done, waited for a moment.
    pub(crate) fn next(&mut self) -> Option<Then<T>> {
        if let Some(then) = self.done.pop_front() {
            return Some(then);
        }
        let desk = self.desk.as_mut();
        let desk = desk.filter(|desk| desk.files + desk.searches > 0)?;
        let patience = desk.patience.saturating_duration_since(Instant::now());
        desk.take(patience)
    }

    /// The bell was heard. What it told of is there before it rings.
    pub(crate) fn hush(&self) {
        if let Some(desk) = &self.desk {
            let _ = read(&desk.bell, &mut [0; 64]);
        }
    }

    /// Readable when a job is done.
    pub(crate) fn bell(&self) -> Option<BorrowedFd<'_>> {
        self.desk.as_ref().map(|desk| desk.bell.as_fd())
    }
}

impl<T> Desk<T> {
    fn take(&mut self, patience: Duration) -> Option<Then<T>> {
        let (apart, then) = self.done.recv_timeout(patience).ok()?;
        match apart {
            Apart::Files => self.files -= 1,
            Apart::Search => self.searches -= 1,
        }
        Some(then)
    }
}

impl<T> Drop for Clerk<T> {
    /// What was to be done to files before leaving is done, if that is not for ever.
    fn drop(&mut self) {
        let end = Instant::now() + FAREWELL;
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

impl<T> fmt::Debug for Clerk<T> {
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

/// What follows from a job that panicked: the rest goes on.
fn broken<T: Client>() -> Then<T> {
    Box::new(|client: &mut T, _| client.fail(&Error::other(words().broken_there())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    struct Nobody;

    impl Client for Nobody {
        fn fail(&mut self, error: &Error) {
            panic!("{error}");
        }
    }

    /// The bell takes some hundred rings before it is full; nobody hears it while a line is stalled.
    #[test]
    fn jobs_are_done_whether_or_not_somebody_hears_the_bell() {
        const JOBS: usize = 2000;
        let done = Arc::new(AtomicUsize::new(0));
        let mut clerk = Clerk::<Nobody>::apart().unwrap();
        for _ in 0..JOBS {
            let done = Arc::clone(&done);
            clerk.give(move || {
                done.fetch_add(1, Ordering::Relaxed);
                Box::new(|_, _| {})
            });
        }
        drop(clerk);
        assert_eq!(done.load(Ordering::Relaxed), JOBS);
    }

    /// A search used to stand in the same line as what is to be written: a file that was saved while a long one
    /// went on was lost on leaving.
    #[test]
    fn a_search_holds_up_no_file() {
        let mut clerk = Clerk::<Nobody>::apart().unwrap();
        let (end, until) = channel::<()>();
        clerk.search(move || {
            let _ = until.recv();
            Box::new(|_, _| {})
        });
        let is_written = Arc::new(AtomicUsize::new(0));
        let file = Arc::clone(&is_written);
        clerk.give(move || {
            file.store(1, Ordering::Relaxed);
            Box::new(|_, _| {})
        });
        drop(clerk);
        assert_eq!(is_written.load(Ordering::Relaxed), 1);
        drop(end);
    }
}
