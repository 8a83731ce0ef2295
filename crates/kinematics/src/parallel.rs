//! Several pieces of work on several cores, their results in their order.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::thread;

/// Threads that this machine works with at once.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Does pieces of work in any order, each in the room of its thread, and gives what came of them in theirs: the same
/// whatever the number of threads. `watch` is told the part that is done, and by answering false lets no piece begin
/// any more; what was done until then comes out. A panic of any of them goes on here.
pub fn each<R, T: Send>(
    count: usize,
    threads: usize,
    room: impl Fn() -> R + Sync,
    work: impl Fn(&mut R, usize) -> T + Sync,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Vec<T> {
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let mut found: Vec<(usize, T)> = thread::scope(|scope| {
        let (to, from) = channel();
        for _ in 0..threads.clamp(1, count.max(1)) {
            let to = to.clone();
            let (next, stopped, room, work) = (&next, &stopped, &room, &work);
            scope.spawn(move || {
                let mut room = room();
                while !stopped.load(Ordering::Relaxed) {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    if i >= count || to.send((i, work(&mut room, i))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(to);
        let mut found = Vec::new();
        while let Ok(one) = from.recv() {
            found.push(one);
            if !watch(found.len() as f64 / count as f64) {
                stopped.store(true, Ordering::Relaxed);
            }
        }
        found
    });
    found.sort_by_key(|(i, _)| *i);
    found.into_iter().map(|(_, one)| one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_their_order() {
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
    fn what_was_done_until_the_stop_comes_out() {
        let found = each(1000, 1, || (), |(), i| i, &mut |part| part < 0.01);
        assert!(!found.is_empty() && found.iter().copied().eq(0..found.len()));
    }

    /// A thread that panicked used to leave its share out, as if nothing had been found there.
    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn a_panic_is_not_swallowed() {
        let broken = |(): &mut (), i: usize| assert_ne!(i, 7, "broken");
        each(10, 2, || (), broken, &mut |_| true);
    }
}
