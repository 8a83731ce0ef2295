//! The solved state for the questions of a sheet.

use crate::Ball;
use crate::report::exercise::requested_values::answer_key;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State, Workspace};
use crate::study::{AnswerKey, SheetScene};

/// The solved state for the questions of a sheet, with its error bounds.
#[derive(Debug)]
pub struct QuestionState {
    state: Workspace,
    enclosure: Workspace<Ball>,
}

impl QuestionState {
    /// Solves a scene at a coordinate, in degrees or in the scene's length unit.
    ///
    /// # Errors
    /// Returns the condition if there are no accelerations, because then there are no questions.
    pub fn new(solver: &Solver, at: f64) -> Result<QuestionState, Condition> {
        let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
        let condition = solver.solve(at, Order::Force, &mut state);
        if condition == Condition::NoAssembly || !state.has(Order::Acceleration) {
            return Err(condition);
        }
        solver.enclose(&mut state, Order::Force, &mut enclosure);
        Ok(QuestionState { state, enclosure })
    }

    /// Returns the scene at this coordinate, for finding answers that misread its given values.
    #[must_use]
    pub fn opened<'a>(&self, scene: &'a Scene, solver: &'a Solver) -> SheetScene<'a> {
        SheetScene {
            scene,
            solver,
            at: self.state().at(),
        }
    }

    /// Returns the state.
    #[must_use]
    pub fn state(&self) -> &State {
        self.state.state()
    }

    /// Returns the answers to all questions and to the quantities in `more`.
    #[must_use]
    pub fn key(&self, scene: &Scene, solver: &Solver, more: &[String]) -> AnswerKey {
        answer_key(scene, solver, self.state(), self.enclosure.state(), more)
    }
}
