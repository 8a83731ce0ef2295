//! A method at work on the present state, while it is watched.

use super::explained::Explained;
use crate::page::Page;
use crate::report::{PositionMethod, Working};
use crate::solver::{Order, Workspace};
use crate::study::ErrorCurve;
use crate::tui::Opened;

/// Significant digits, as in the tables.
const DIGITS: usize = 6;

/// The iterations of a method, and what they are written from.
#[derive(Debug)]
pub(crate) struct WatchedMethod {
    method: PositionMethod,
    working: Working,
    state: Workspace,
    page: Page,
    curves: Vec<ErrorCurve>,
}

impl WatchedMethod {
    /// A method at a coordinate; `None` where the scene has too many links for it.
    pub(crate) fn new(method: PositionMethod, opened: &Opened, at: f64) -> Option<WatchedMethod> {
        let Opened { scene, solver, .. } = opened;
        if !Explained::is_possible(scene) {
            return None;
        }
        let mut watched = WatchedMethod {
            method,
            working: Working::new(scene, solver),
            state: solver.state(),
            page: Page::default(),
            curves: Vec::new(),
        };
        watched.go(opened, at);
        Some(watched)
    }

    /// The driver is somewhere else.
    pub(crate) fn go(&mut self, opened: &Opened, at: f64) {
        let Opened { scene, solver, .. } = opened;
        let _ = solver.solve(at, Order::Position, &mut self.state);
        let stand = (scene, solver, self.state.state());
        let worked = self.working.watched(self.method, stand, DIGITS);
        (self.page, self.curves) = (worked.page, worked.curves);
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
