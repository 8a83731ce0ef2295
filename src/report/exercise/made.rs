//! Makes the exercise of a seed, with its sheet, solution and answers.

use crate::report::document::Report;
use crate::report::exercise::question_state::QuestionState;
use crate::scene::Scene;
use crate::study::{AnswerKey, Exercise, ExerciseMaker, ExerciseTitles};
use crate::wording::words;

/// Significant digits of the solution.
const DIGITS: usize = 6;

/// An exercise with its solved state and its answers.
#[derive(Debug)]
pub struct MadeExercise {
    exercise: Exercise,
    state: QuestionState,
    key: AnswerKey,
}

impl MadeExercise {
    /// Makes the exercise of a seed from a scene. `typed` is the scene on the command line that makes
    /// the same exercise. The error is a message.
    pub fn new(
        maker: &ExerciseMaker<'_>,
        scene: &Scene,
        typed: &str,
        seed: u64,
    ) -> Result<MadeExercise, String> {
        if !maker.has_dimensions() {
            return Err(words().no_dimensions().into());
        }
        let titles = ExerciseTitles {
            name: words().exercise_called(&scene.title(), seed),
            source: words().exercise_made_by(typed, seed),
            note: words().made_by_chance().into(),
        };
        let exercise = maker.exercise(seed, &titles);
        let exercise = exercise.ok_or_else(|| words().no_exercise(seed))?;
        let Exercise { scene, solver } = &exercise;
        let at = scene.mechanism.driver().start;
        let state = QuestionState::new(solver, at);
        let state = state.map_err(|_| words().no_figures_at(&at.to_string()))?;
        let key = state.key(scene, solver, &[]);
        Ok(MadeExercise {
            exercise,
            state,
            key,
        })
    }

    /// Returns the scene of the exercise.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.exercise.scene
    }

    /// Returns the answers.
    #[must_use]
    pub fn key(&self) -> &AnswerKey {
        &self.key
    }

    /// Returns the sheet. Its text names the file for the answers of an exercise of this name.
    #[must_use]
    pub fn sheet(&self, name: &str) -> Report {
        let Exercise { scene, solver } = &self.exercise;
        let answers = format!("{name}.csv");
        Report::sheet(scene, solver, self.state.state(), &self.key, &answers)
    }

    /// Returns the solution.
    #[must_use]
    pub fn solution(&self) -> Report {
        let Exercise { scene, solver } = &self.exercise;
        Report::new(scene, solver, self.state.state(), DIGITS)
    }
}
