//! Evaluates the designs of a plan, one row each, on several cores and always in the plan's order.

use super::{DesignFigures, DesignPlan, NoDesign};
use crate::study::NoFigure;
use std::ops::Range;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

/// Designs per chunk, which take about a millisecond.
const CHUNK: u64 = 32;
/// Maximum number of chunks by which a thread may be ahead of the consumer.
const MAX_CHUNKS_AHEAD: usize = 64;

/// The validity of a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DesignState {
    /// The design assembles as the given scene does.
    Ok,
    /// The design does not assemble, or has other elements than the given scene.
    NoAssembly,
    /// The numbers do not give a valid scene.
    Unreadable,
}

/// The result of one design.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignRow {
    /// The numbers that vary.
    pub numbers: Vec<f64>,
    /// The validity.
    pub state: DesignState,
    /// The reason why the design is not valid; empty for a valid one.
    pub reason: String,
    /// The figures, each a value or the reason for its absence; empty without a design. Directions,
    /// and places in a cyclic motion, are counted from those of the given design. They may be
    /// negative, or a turn and more.
    pub figures: Vec<Result<f64, NoFigure>>,
}

/// A run over designs of a plan.
#[derive(Clone, Debug)]
pub struct DesignRun<'a> {
    /// The figures to compute.
    pub figures: &'a DesignFigures,
    /// The plan.
    pub plan: &'a DesignPlan,
    /// The numbers of the plan's designs to evaluate.
    pub designs: Range<u64>,
    /// The number of threads.
    pub threads: usize,
}

impl DesignState {
    /// Returns the word for tables and files.
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
    /// Computes the row of a design with these numbers.
    #[must_use]
    pub fn of(numbers: Vec<f64>, figures: &mut DesignFigures) -> DesignRow {
        let (state, reason, figures) = match figures.in_row(&numbers) {
            Ok(found) => (DesignState::Ok, String::new(), found),
            Err(none) => {
                let state = match &none {
                    NoDesign::Unread(_) => DesignState::Unreadable,
                    NoDesign::OtherElements | NoDesign::Unsolved(..) => DesignState::NoAssembly,
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

    /// Returns the figure with this index, if it exists.
    #[must_use]
    pub fn figure(&self, index: usize) -> Option<f64> {
        self.figures.get(index)?.ok()
    }
}

impl DesignRun<'_> {
    /// Passes the rows to `take` in order, some at a time; an error of `take` ends the run.
    ///
    /// # Errors
    /// Returns the error of `take`.
    pub fn each<E>(&self, take: &mut dyn FnMut(Vec<DesignRow>) -> Result<(), E>) -> Result<(), E> {
        let chunks = self
            .designs
            .end
            .saturating_sub(self.designs.start)
            .div_ceil(CHUNK);
        let threads = (self.threads.max(1) as u64).min(chunks);
        thread::scope(|scope| {
            // The chunks are distributed round-robin, so that they are complete in order.
            let lines: Vec<_> = (0..threads)
                .map(|first| {
                    let (to, from) = sync_channel(MAX_CHUNKS_AHEAD);
                    let own = (first..chunks).step_by(usize::try_from(threads).unwrap_or(1));
                    let work = move || self.work(own, &to);
                    let started = thread::Builder::new().spawn_scoped(scope, work);
                    started.is_ok().then_some(from)
                })
                .collect();
            let mut figures = None;
            for (chunk, line) in (0..chunks).zip(lines.iter().cycle()) {
                let rows = match line {
                    Some(line) => match line.recv() {
                        Ok(rows) => rows,
                        Err(_) => break,
                    },
                    // The system could not create a thread: its chunks are computed here.
                    None => self.rows(chunk, figures.get_or_insert_with(|| self.figures.clone())),
                };
                take(rows)?;
            }
            Ok(())
        })
    }

    /// Computes the rows of some chunks until the receiver is dropped.
    fn work(&self, chunks: impl Iterator<Item = u64>, to: &SyncSender<Vec<DesignRow>>) {
        let mut figures = self.figures.clone();
        for chunk in chunks {
            if to.send(self.rows(chunk, &mut figures)).is_err() {
                return;
            }
        }
    }

    /// Computes the rows of a chunk.
    fn rows(&self, chunk: u64, figures: &mut DesignFigures) -> Vec<DesignRow> {
        let first = self.designs.start + chunk * CHUNK;
        let last = first.saturating_add(CHUNK).min(self.designs.end);
        let numbers = (first..last).map(|k| self.plan.numbers(k));
        numbers
            .map(|numbers| DesignRow::of(numbers, figures))
            .collect()
    }
}
