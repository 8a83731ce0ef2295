//! Keeps the written solution of the current state while its view is visible.

use crate::Ball;
use crate::page::Page;
use crate::report::Working;
use crate::scene::Scene;
use crate::solver::{Order, Workspace};
use crate::tui::player::open_scene::OpenScene;

/// Significant digits, as in the tables.
pub(crate) const DIGITS: usize = 6;
/// Maximum number of links. A larger linkage would delay the frame.
const MAX_LINKS: usize = 64;

/// The current working, with the data to update it.
#[derive(Debug)]
pub(crate) struct Explained {
    working: Working,
    state: Workspace,
    enclosure: Workspace<Ball>,
    page: Page,
}

impl Explained {
    /// Returns `true` if the scene has few enough links for a working.
    pub(crate) fn is_possible(scene: &Scene) -> bool {
        scene.mechanism.links().len() <= MAX_LINKS
    }

    /// Creates the working at the driver's position; `None` if the scene has too many links.
    pub(crate) fn new(open_scene: &OpenScene) -> Option<Explained> {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        if !Explained::is_possible(scene) {
            return None;
        }
        let mut explained = Explained {
            working: Working::new(scene, solver),
            state: solver.state(),
            enclosure: solver.enclosure(),
            page: Page::default(),
        };
        explained.go(open_scene);
        Some(explained)
    }

    /// Updates the working for another driver state.
    pub(crate) fn go(&mut self, open_scene: &OpenScene) {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        let driver_state = open_scene.driver_state();
        let _ = driver_state.solve(solver, Order::Force, &mut self.state);
        driver_state.drive(solver, &mut self.enclosure);
        solver.enclose(&mut self.state, Order::Force, &mut self.enclosure);
        let computed = self.working.of(scene, solver, &self.state, DIGITS);
        self.page = computed.page;
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }
}
