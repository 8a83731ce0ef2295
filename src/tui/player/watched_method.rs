//! A method at work on the present state, while it is watched.

use super::explained::Explained;
use crate::page::Page;
use crate::report::{Guess, PositionMethod, WorkedMethod, Working};
use crate::solver::{Order, Workspace};
use crate::study::ErrorCurve;
use crate::tui::Opened;

/// Significant digits, as in the tables.
const DIGITS: usize = 6;

/// The iterations of a method, and what they are written from.
#[derive(Debug)]
pub(crate) struct WatchedMethod {
    method: PositionMethod,
    guesses: Vec<Guess>,
    working: Working,
    state: Workspace,
    page: Page,
    curves: Vec<ErrorCurve>,
}

impl WatchedMethod {
    /// A method at a coordinate, from a guess as it is typed if that is one for the scene; `None` where the scene has
    /// too many links for it.
    pub(crate) fn new(
        (method, guess): (PositionMethod, &str),
        opened: &Opened,
        at: f64,
    ) -> Option<WatchedMethod> {
        let Opened { scene, solver, .. } = opened;
        if !Explained::is_possible(scene) {
            return None;
        }
        let mut watched = WatchedMethod {
            method,
            guesses: Vec::new(),
            working: Working::new(scene, solver),
            state: solver.state(),
            page: Page::default(),
            curves: Vec::new(),
        };
        watched.go(opened, at);
        let _ = watched.begin_at(guess, opened);
        Some(watched)
    }

    /// Begins at another guess, as it is typed; at the sketch of where the scene opens if nothing is.
    ///
    /// # Errors
    /// In words, where that is no guess for the scene; then nothing has changed.
    pub(crate) fn begin_at(&mut self, guess: &str, opened: &Opened) -> Result<(), String> {
        let guesses = Guess::listed(guess).map_err(|error| error.to_string())?;
        let worked = self.work(&guesses, opened)?;
        (self.page, self.curves) = (worked.page, worked.curves);
        self.guesses = guesses;
        Ok(())
    }

    fn work(&self, guesses: &[Guess], opened: &Opened) -> Result<WorkedMethod, String> {
        let stand = (&opened.scene, &opened.solver, self.state.state());
        self.working.watched(self.method, stand, guesses, DIGITS)
    }

    /// The driver is somewhere else.
    pub(crate) fn go(&mut self, opened: &Opened, at: f64) {
        let _ = opened.solver.solve(at, Order::Position, &mut self.state);
        // What was a guess for the scene is one at every place of it.
        if let Ok(worked) = self.work(&self.guesses, opened) {
            (self.page, self.curves) = (worked.page, worked.curves);
        }
    }

    pub(crate) fn method(&self) -> PositionMethod {
        self.method
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }

    pub(crate) fn curves(&self) -> &[ErrorCurve] {
        &self.curves
    }
}
