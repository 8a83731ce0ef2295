//! The working of the present state, while it is looked at.

use crate::Ball;
use crate::page::Page;
use crate::quantity::DriverStand;
use crate::report::Working;
use crate::scene::Scene;
use crate::solver::{Order, Workspace};
use crate::tui::Opened;

/// Significant digits, as in the tables.
pub(crate) const DIGITS: usize = 6;
/// Of more links than this a frame would be late.
const MOST_LINKS: usize = 64;

/// What the working is written from, and the present one.
#[derive(Debug)]
pub(crate) struct Explained {
    working: Working,
    state: Workspace,
    enclosure: Workspace<Ball>,
    page: Page,
}

impl Explained {
    /// Whether a scene has few enough links for it.
    pub(crate) fn is_possible(scene: &Scene) -> bool {
        scene.mechanism.links().len() <= MOST_LINKS
    }

    /// The working at a place; `None` where the scene has too many links for it.
    pub(crate) fn new(opened: &Opened, stand: &DriverStand) -> Option<Explained> {
        let Opened { scene, solver, .. } = opened;
        if !Explained::is_possible(scene) {
            return None;
        }
        let mut explained = Explained {
            working: Working::new(scene, solver),
            state: solver.state(),
            enclosure: solver.enclosure(),
            page: Page::default(),
        };
        explained.go(opened, stand);
        Some(explained)
    }

    /// The driver is somewhere else.
    pub(crate) fn go(&mut self, opened: &Opened, stand: &DriverStand) {
        let Opened { scene, solver, .. } = opened;
        let _ = stand.solve(solver, Order::Force, &mut self.state);
        stand.drive(solver, &mut self.enclosure);
        solver.enclose(&mut self.state, Order::Force, &mut self.enclosure);
        let worked = self.working.of(scene, solver, &self.state, DIGITS);
        self.page = worked.page;
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }
}
