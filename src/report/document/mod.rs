//! Writes a report: the worked solution of one state for submission, with the drawing, vector
//! polygons, tables before and after the solution, velocity and acceleration diagrams to scale, and
//! plots over the whole motion.
//!
//! The solution is that of [`Working`]; the additions are inserted between its parts.

mod diagrams;
mod drawings;
mod format;
mod loop_tables;
mod plots;

pub use format::ReportFormat;

use super::check::Check;
use super::external_comparison::ForeignFigures;
use super::working::{LoopVectors, WorkedState, Working, WorkingNotation, WorkingPart};
use crate::SlideId;
use crate::drawing::Extents;
use crate::page::{Artwork, Block, Content, Illustration, Page};
use crate::parallel;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State};
use crate::wording::words;
use std::sync::{Arc, Mutex, PoisonError};

/// A report on one state of a scene.
#[derive(Clone, Debug)]
pub struct Report {
    /// The page.
    pub page: Page,
}

/// The data from which a report is written.
pub(super) struct ReportedState<'a> {
    scene: &'a Scene,
    solver: &'a Solver,
    state: &'a State,
    working: Working,
    reach: Extents,
    loops: Vec<LoopVectors>,
    digits: usize,
    notation: WorkingNotation,
}

impl Report {
    /// Creates the report on a solved and enclosed state, with so many significant digits.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver, state: &State, digits: usize) -> Report {
        Report::in_notation(scene, solver, state, digits, WorkingNotation::Lecture)
    }

    /// Creates the report in a given notation.
    #[must_use]
    pub fn in_notation(
        scene: &Scene,
        solver: &Solver,
        state: &State,
        digits: usize,
        notation: WorkingNotation,
    ) -> Report {
        let solution = || {
            let reported = ReportedState::new(scene, solver, state, digits);
            ReportedState {
                notation,
                ..reported
            }
            .solution()
        };
        let plots = || plots::plots(scene, solver);
        let facts = || facts(scene, solver);
        // The parts are written beside each other.
        let parts: [&(dyn Fn() -> Page + Sync); 3] = [&solution, &plots, &facts];
        let write = |(): &mut (), i: usize| parts[i]();
        let cores = parallel::cores();
        let written = parallel::each(parts.len(), cores, || (), write, &mut |_| true);
        let mut written = written.into_iter();
        let mut page = written.next().unwrap_or_default();
        let headings = [words().plots_part(), words().facts_part()];
        for (heading, part) in headings.into_iter().zip(written) {
            page.part(heading);
            for block in part.blocks {
                page.add(block.content);
            }
        }
        Report { page }
    }

    /// Adds a comparison with values from lecture notes or another program: for the reported state,
    /// which must be solved with forces, or for a table over the driver.
    pub fn add_comparison(
        &mut self,
        figures: &ForeignFigures,
        driver_state: (&Scene, &Solver, &State),
        digits: usize,
    ) {
        figures.add_to(&mut self.page, driver_state, digits);
    }
}

impl<'a> ReportedState<'a> {
    /// Prepares the report on a solved state, with so many significant digits.
    pub(super) fn new(
        scene: &'a Scene,
        solver: &'a Solver,
        state: &'a State,
        digits: usize,
    ) -> ReportedState<'a> {
        let working = Working::new(scene, solver);
        ReportedState {
            loops: working.loop_vectors(scene, solver, state, digits),
            reach: Extents::of(scene, solver),
            working,
            scene,
            solver,
            state,
            digits,
            notation: WorkingNotation::Lecture,
        }
    }
}

impl ReportedState<'_> {
    /// Returns `true` if there are tables with a column per vector.
    pub(super) fn has_loops(&self) -> bool {
        !self.loops.is_empty()
    }

    /// Returns the name in the loops of the point from which a slide's position is measured.
    pub(super) fn guide_point(&self, slide: SlideId) -> Option<&str> {
        self.working.guide_point(slide)
    }

    fn has_positions(&self) -> bool {
        self.state.condition() != Condition::NoAssembly
    }

    fn has_rates(&self) -> bool {
        self.state.known().has(Order::Acceleration)
    }

    /// Writes the solution with its additions.
    fn solution(&self) -> Page {
        let WorkedState {
            mut page, parts, ..
        } = self.working.written(
            self.scene,
            self.solver,
            self.state,
            self.digits,
            self.notation,
        );
        let mut written = std::mem::take(&mut page.blocks).into_iter();
        let starts = parts.iter().map(|(_, start)| *start);
        let ends = starts.skip(1).chain([usize::MAX]);
        let mut found: Vec<(WorkingPart, Vec<Block>)> = Vec::new();
        for ((part, start), end) in parts.iter().zip(ends) {
            let blocks = written.by_ref().take(end - start).collect();
            found.push((*part, blocks));
        }
        // A report defines the unit vectors at its beginning.
        found.sort_by_key(|(part, _)| match part {
            WorkingPart::Opening => 0,
            WorkingPart::UnitVectors => 1,
            _ => 2,
        });
        let found: Vec<_> = found
            .into_iter()
            .map(|(part, blocks)| (part, Mutex::new(blocks)))
            .collect();
        // A job takes the blocks of its part: a copy of large ones would take as long as writing them.
        let write = |(): &mut (), i: usize| {
            let (part, blocks) = &found[i];
            let blocks =
                std::mem::take(&mut *blocks.lock().unwrap_or_else(PoisonError::into_inner));
            let mut page = Page::default();
            self.part(*part, blocks, &mut page);
            page.blocks
        };
        let all = parallel::each(found.len(), parallel::cores(), || (), write, &mut |_| true);
        page.blocks.extend(all.into_iter().flatten());
        page
    }

    /// Adds a part of the solution with its additions.
    fn part(&self, part: WorkingPart, blocks: Vec<Block>, page: &mut Page) {
        let mut blocks = blocks.into_iter();
        match part {
            WorkingPart::Opening => {
                page.blocks.extend(blocks);
                self.drawing(page);
            }
            WorkingPart::UnitVectors => page.blocks.extend(blocks),
            WorkingPart::Polygons => {
                page.blocks.extend(blocks);
                self.polygons(page);
            }
            // The vectors of loops have tables of their own, which must not reveal results.
            WorkingPart::PositionTable if !self.loops.is_empty() => {
                page.blocks.extend(blocks.next());
                self.tables_with_unknowns(Order::Position, page);
                // Keep the blocks after the table.
                page.blocks.extend(blocks.skip(1));
            }
            WorkingPart::PositionTable | WorkingPart::Equations | WorkingPart::Check => {
                page.blocks.extend(blocks)
            }
            WorkingPart::Positions => {
                page.blocks.extend(blocks);
                self.completed_tables(Order::Position, page);
            }
            WorkingPart::Velocities => self.rates(Order::Velocity, blocks, page),
            WorkingPart::Accelerations => self.rates(Order::Acceleration, blocks, page),
            WorkingPart::Points => {
                page.blocks.extend(blocks);
                self.diagrams(page);
            }
            WorkingPart::Centres => {
                page.blocks.extend(blocks);
                self.centres(page);
            }
            WorkingPart::Forces => self.forces(blocks, page),
        }
    }

    /// Adds velocities or accelerations: the empty table, the solution, and the completed table.
    fn rates(&self, order: Order, mut blocks: impl Iterator<Item = Block>, page: &mut Page) {
        page.blocks.extend(blocks.next());
        if !self.loops.is_empty() {
            self.tables_with_unknowns(order, page);
        }
        // The following block keeps the spacing that it would have had after the heading.
        let first = blocks.next().map(|block| Block {
            is_apart: true,
            ..block
        });
        page.blocks.extend(first.into_iter().chain(blocks));
        self.completed_tables(order, page);
    }
}

/// Returns the facts of a scene for its whole motion.
fn facts(scene: &Scene, solver: &Solver) -> Page {
    let mut page = Check::new(scene, solver).page();
    page.blocks
        .retain(|block| !matches!(block.content, Content::Title(_)));
    page
}

/// Adds a picture to a page.
fn picture(page: &mut Page, artwork: Artwork, caption: String, characters: Vec<String>) {
    page.add(Content::Picture(Illustration {
        artwork: Arc::new(artwork),
        caption,
        character_caption: None,
        characters,
    }));
}
