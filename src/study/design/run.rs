//! Designs of a plan, one row each: on several cores, and always in the order of the plan.

use super::{DesignFigures, DesignPlan, NoDesign};
use crate::study::NoFigure;
use std::ops::Range;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

/// Designs that are handed on together: as many as take about a millisecond.
const CHUNK: u64 = 32;
/// Chunks that a thread may be ahead of who takes them.
const AHEAD: usize = 64;

/// Whether a design is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DesignState {
    /// It assembles as the scene does.
    Ok,
    /// It does not.
    NoAssembly,
    /// Its numbers make no scene.
    Unreadable,
}

/// What came of one design.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignRow {
    /// The numbers that vary.
    pub numbers: Vec<f64>,
    /// Whether it is one at all.
    pub state: DesignState,
    /// Why it is none, in words; empty where it is one.
    pub reason: String,
    /// The figures, each or why there is none; empty where it is no design. Directions are counted from those of the
    /// given design, and so are places in a motion that comes round: they may be negative, or a turn and more.
    pub figures: Vec<Result<f64, NoFigure>>,
}

/// Which designs of a plan are looked at, and by how many threads.
#[derive(Clone, Debug)]
pub struct DesignRun<'a> {
    /// Their figures.
    pub figures: &'a DesignFigures,
    /// The plan.
    pub plan: &'a DesignPlan,
    /// Which of its designs.
    pub designs: Range<u64>,
    /// Threads.
    pub threads: usize,
}

impl DesignState {
    /// As tables and files have it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            DesignState::Ok => "ok",
            DesignState::NoAssembly => "no-assembly",
            DesignState::Unreadable => "unreadable",
        }
    }
}

impl DesignRow {
    /// The row of a design with these numbers.
    #[must_use]
    pub fn of(numbers: Vec<f64>, figures: &mut DesignFigures) -> DesignRow {
        let (state, reason, figures) = match figures.in_row(&numbers) {
            Ok(found) => (DesignState::Ok, String::new(), found),
            Err(none) => {
                let state = match &none {
                    NoDesign::Unread(_) => DesignState::Unreadable,
                    NoDesign::Unsolved(..) => DesignState::NoAssembly,
                };
                (state, none.reason(), Vec::new())
            }
        };
        DesignRow {
            numbers,
            state,
            reason,
            figures,
        }
    }

    /// The figure of this number, if it exists.
    #[must_use]
    pub fn figure(&self, figure: usize) -> Option<f64> {
        self.figures.get(figure)?.ok()
    }
}

impl DesignRun<'_> {
    /// Hands the rows on in their order, some at a time; an error of who takes them ends it.
    ///
    /// # Errors
    /// What `take` says.
    pub fn each<E>(&self, take: &mut dyn FnMut(Vec<DesignRow>) -> Result<(), E>) -> Result<(), E> {
        let chunks = self
            .designs
            .end
            .saturating_sub(self.designs.start)
            .div_ceil(CHUNK);
        let threads = (self.threads.max(1) as u64).min(chunks);
        thread::scope(|scope| {
            // Each thread has every so many-th chunk, so that they come in turn.
            let lines: Vec<_> = (0..threads)
                .map(|first| {
                    let (to, from) = sync_channel(AHEAD);
                    let own = (first..chunks).step_by(usize::try_from(threads).unwrap_or(1));
                    let work = move || self.work(own, &to);
                    let begun = thread::Builder::new().spawn_scoped(scope, work);
                    begun.is_ok().then_some(from)
                })
                .collect();
            let mut figures = None;
            for (chunk, line) in (0..chunks).zip(lines.iter().cycle()) {
                let rows = match line {
                    Some(line) => match line.recv() {
                        Ok(rows) => rows,
                        Err(_) => break,
                    },
                    // The system creates no thread for it: its chunks are done here.
                    None => self.rows(chunk, figures.get_or_insert_with(|| self.figures.clone())),
                };
                take(rows)?;
            }
            Ok(())
        })
    }

    /// The rows of some chunks, as long as somebody takes them.
    fn work(&self, chunks: impl Iterator<Item = u64>, to: &SyncSender<Vec<DesignRow>>) {
        let mut figures = self.figures.clone();
        for chunk in chunks {
            if to.send(self.rows(chunk, &mut figures)).is_err() {
                return;
            }
        }
    }

    /// The rows of a chunk.
    fn rows(&self, chunk: u64, figures: &mut DesignFigures) -> Vec<DesignRow> {
        let first = self.designs.start + chunk * CHUNK;
        let last = first.saturating_add(CHUNK).min(self.designs.end);
        let numbers = (first..last).map(|k| self.plan.numbers(k));
        numbers
            .map(|numbers| DesignRow::of(numbers, figures))
            .collect()
    }
}
