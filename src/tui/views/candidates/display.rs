//! Draws a candidate and moves it over its task.

use crate::Vec2;
use crate::drawing::{self, Extents, Figure, Layers};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::tui::Origin;
use crate::tui::document::opening;
use std::sync::Arc;

/// Number of steps along the led point's path.
const SAMPLES: u16 = 180;

/// A candidate as a movable scene.
#[derive(Debug)]
pub(crate) struct ShownCandidate {
    scene: Scene,
    solver: Solver,
    reach: Extents,
    state: Workspace,
    /// The crank's angle of `state`, in degrees; `None` before the first solve.
    at: Option<f64>,
    /// The led point's path from the first point of the task to the last, with NaN where the
    /// linkage cannot be assembled.
    way: Arc<[Vec2]>,
}

impl ShownCandidate {
    /// Opens the scene of a candidate; `at` are its crank angles at the task's points.
    pub(super) fn of(text: &str, at: &[f64]) -> Option<ShownCandidate> {
        let opened = opening::text(text, Origin::Stdin).ok()?;
        let (scene, solver) = (opened.scene, opened.solver);
        let mut state = solver.state();
        let way = way(&scene, &solver, &mut state, at);
        Some(ShownCandidate {
            reach: Extents::of(&scene, &solver),
            state,
            at: None,
            way,
            scene,
            solver,
        })
    }

    pub(super) fn extents(&self) -> &Extents {
        &self.reach
    }

    /// Returns the linkage at its present position.
    pub(super) fn figure(&self) -> Figure {
        drawing::linkage(&self.scene, &self.reach, &self.state, Layers::default())
    }

    pub(super) fn way(&self) -> &Arc<[Vec2]> {
        &self.way
    }

    /// Turns the crank to an angle, in degrees.
    pub(super) fn turn_to(&mut self, at: f64) {
        if self.at != Some(at) {
            let _ = self.solver.solve(at, Order::Position, &mut self.state);
            self.at = Some(at);
        }
    }
}

/// Computes the path of point P; empty for a function task, which leads no point.
fn way(scene: &Scene, solver: &Solver, state: &mut Workspace, at: &[f64]) -> Arc<[Vec2]> {
    let mut points = scene.mechanism.point_ids();
    let guided = points.find(|id| scene.point_name(*id) == Some("P"));
    let (Some(guided), Some(first), Some(last)) = (guided, at.first(), at.last()) else {
        return Arc::default();
    };
    let nowhere = Vec2::new(f64::NAN, f64::NAN);
    let samples = (0..=SAMPLES).map(|k| {
        let at = first + (last - first) * f64::from(k) / f64::from(SAMPLES);
        match solver.solve(at, Order::Position, state) {
            Condition::NoAssembly => nowhere,
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => {
                state.position(guided).unwrap_or(nowhere)
            }
        }
    });
    samples.collect()
}
