//! Keeps the iterations of a watched method at the current state.

use super::solution_cache::Explained;
use crate::page::Page;
use crate::report::{Guess, PositionMethod, WorkedMethod, Working};
use crate::solver::{Order, Workspace};
use crate::study::ErrorCurve;
use crate::tui::player::open_scene::OpenScene;

/// Significant digits, as in the tables.
const DIGITS: usize = 6;

/// The iterations of a method, with the data to update them.
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
    /// Runs a method at a coordinate, from the typed guess if it is valid for the scene. Returns
    /// `None` if the scene has too many links.
    pub(crate) fn new(
        (method, guess): (PositionMethod, &str),
        open_scene: &OpenScene,
    ) -> Option<WatchedMethod> {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
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
        watched.go(open_scene);
        let _ = watched.set_guess(guess, open_scene);
        Some(watched)
    }

    /// Sets the typed initial guess. An empty guess means the sketch at the scene's initial
    /// coordinate.
    ///
    /// # Errors
    /// Returns a message if the guess is invalid for the scene; the previous one then stays.
    pub(crate) fn set_guess(&mut self, guess: &str, open_scene: &OpenScene) -> Result<(), String> {
        let guesses = Guess::listed(guess).map_err(|error| error.to_string())?;
        let computed = self.work(&guesses, open_scene)?;
        (self.page, self.curves) = (computed.page, computed.curves);
        self.guesses = guesses;
        Ok(())
    }

    fn work(&self, guesses: &[Guess], open_scene: &OpenScene) -> Result<WorkedMethod, String> {
        let driver_state = (open_scene.scene(), open_scene.solver(), self.state.state());
        self.working
            .watched(self.method, driver_state, guesses, DIGITS)
    }

    /// Updates the iterations for another driver coordinate.
    pub(crate) fn go(&mut self, open_scene: &OpenScene) {
        let (at, solver) = (open_scene.at(), open_scene.solver());
        let _ = solver.solve(at, Order::Position, &mut self.state);
        // A guess that is valid for the scene is valid at every coordinate.
        if let Ok(computed) = self.work(&self.guesses, open_scene) {
            (self.page, self.curves) = (computed.page, computed.curves);
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
