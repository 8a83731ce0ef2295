//! Runs jobs on several cores and returns their results in order.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread::{self, Scope};

/// Returns the number of threads that this machine runs at once.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Runs `count` jobs in any order and returns their results by index; the result does not depend on
/// the number of threads.
///
/// `buffers` creates the scratch space of each thread. With one thread, or if none can be created,
/// the calling thread does the work. `watch` receives the completed fraction; once it returns
/// `false`, no further job starts, and the results so far are returned. A panic in a job is
/// propagated.
pub fn each<R, T: Send>(
    count: usize,
    threads: usize,
    buffers: impl Fn() -> R + Sync,
    work: impl Fn(&mut R, usize) -> T + Sync,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Vec<T> {
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let do_pieces = |take: &mut dyn FnMut((usize, T)) -> bool| {
        let mut buffers = buffers();
        while !stopped.load(Ordering::Relaxed) {
            let i = next.fetch_add(1, Ordering::Relaxed);
            if i >= count || !take((i, work(&mut buffers, i))) {
                return;
            }
        }
    };
    let mut found: Vec<(usize, T)> = Vec::new();
    let mut keep = |one| {
        found.push(one);
        if !watch(found.len() as f64 / count as f64) {
            stopped.store(true, Ordering::Relaxed);
        }
        true
    };
    let send_all = |to: Sender<(usize, T)>| do_pieces(&mut |one| to.send(one).is_ok());
    thread::scope(|scope| {
        let (to, from) = channel();
        let threads = threads.min(count);
        let started = (0..if threads > 1 { threads } else { 0 })
            .take_while(|_| spawn(scope, &send_all, to.clone()))
            .count();
        drop(to);
        if started == 0 {
            do_pieces(&mut keep);
        }
        while let Ok(one) = from.recv() {
            keep(one);
        }
    });
    found.sort_by_key(|(i, _)| *i);
    found.into_iter().map(|(_, one)| one).collect()
}

/// Starts a thread. Returns `false` if the system cannot create one.
fn spawn<'scope, T: Send + 'scope>(
    scope: &'scope Scope<'scope, '_>,
    send_all: &'scope (impl Fn(Sender<T>) + Sync),
    to: Sender<T>,
) -> bool {
    let work = move || send_all(to);
    thread::Builder::new().spawn_scoped(scope, work).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order() {
        let mut parts = Vec::new();
        let squares = each(100, 3, || (), |(), i| i * i, &mut |part| {
            parts.push(part);
            true
        });
        assert_eq!(squares, (0..100).map(|i| i * i).collect::<Vec<_>>());
        assert_eq!((parts.len(), parts[99]), (100, 1.0));
        assert!(each(0, 3, || (), |(), i| i, &mut |_| true).is_empty());
    }

    #[test]
    fn results_before_stop_are_returned() {
        let found = each(1000, 1, || (), |(), i| i, &mut |part| part < 0.01);
        assert!(!found.is_empty() && found.iter().copied().eq(0..found.len()));
    }

    /// The results of a thread that panicked used to be missing, as if it had found nothing.
    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn panic_is_propagated() {
        let broken = |(): &mut (), i: usize| assert_ne!(i, 7, "broken");
        each(10, 2, || (), broken, &mut |_| true);
    }
}
