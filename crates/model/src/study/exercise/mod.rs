//! Exercises: a scene with random dimensions, equal for equal seeds on every machine.
//!
//! The exercise moves like the original scene. It has the same groups and class, a crank that turns
//! fully if the original did, and the same assembly. Its position is well away from dead points and
//! change points.

mod dimensions;
mod motion_kind;
mod round_numbers;

use crate::Input;
use crate::numeric::SeededRng;
use crate::scene::{Measure, Scene, Value, ValueOwner};
use crate::solver::{Condition, Order, Solver};
use round_numbers::agreeable;

use dimensions::{DimensionSpread, Dimensions};
use motion_kind::{MotionKind, is_lively, margins, places};

/// The number of attempts and the variation of dimensions. If lengths have relations that random
/// changes break, the whole scene is scaled.
const TRIES: [(usize, DimensionSpread); 3] = [
    (60, DimensionSpread::Each(25)),
    (30, DimensionSpread::Each(12)),
    (12, DimensionSpread::Together),
];
/// Minimum margin of all groups from singularities over the motion: 18 degrees of a dyad, as the
/// square of a sine.
const MIN_MOTION_MARGIN: f64 = 0.1;
/// Minimum margin at the position of the exercise: 30 degrees.
const MIN_POSITION_MARGIN: f64 = 0.25;
/// The factor on the original's own margins if they are smaller.
const MARGIN_FACTOR: f64 = 0.8;
/// Number of positions to try for one mechanism.
const PLACES: usize = 6;
/// The range of speeds, in percent of the scene's speed.
const SPEEDS: [u32; 2] = [50, 200];

/// A generator of exercises from a scene.
#[derive(Debug)]
pub struct ExerciseMaker<'a> {
    scene: &'a Scene,
    solver: &'a Solver,
    dimensions: Dimensions,
    kind: MotionKind,
    /// The required smallest margins over the motion and at the position of the exercise.
    worst: f64,
    required: f64,
}

/// The texts of an exercise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExerciseTitles {
    /// The title.
    pub name: String,
    /// The source.
    pub source: String,
    /// The note.
    pub note: String,
}

/// An exercise: a separate scene.
#[derive(Debug)]
pub struct Exercise {
    /// The scene, which opens at the position of the exercise.
    pub scene: Scene,
    /// The scene's solver.
    pub solver: Solver,
}

impl<'a> ExerciseMaker<'a> {
    /// Analyses a scene in the assembly that its solver follows.
    #[must_use]
    pub fn new(scene: &'a Scene, solver: &'a Solver) -> ExerciseMaker<'a> {
        let own = margins(
            solver,
            &places(&scene.mechanism, solver),
            &mut solver.state(),
        );
        let worst = own.iter().copied().fold(1.0, f64::min);
        let best = own.iter().copied().fold(0.0, f64::max);
        ExerciseMaker {
            scene,
            solver,
            dimensions: Dimensions::of(scene),
            kind: MotionKind::of(solver),
            // The requirements are no stricter than the original allows.
            worst: MIN_MOTION_MARGIN.min(MARGIN_FACTOR * worst),
            required: MIN_POSITION_MARGIN.min(MARGIN_FACTOR * best),
        }
    }

    /// Returns `true` if the scene has dimensions to change.
    #[must_use]
    pub fn has_dimensions(&self) -> bool {
        !self.dimensions.is_empty()
    }

    /// Creates the exercise of a seed; `None` if no dimensions were found that keep the kind of
    /// motion.
    #[must_use]
    pub fn exercise(&self, seed: u64, titles: &ExerciseTitles) -> Option<Exercise> {
        if !self.has_dimensions() {
            return None;
        }
        let mut rng = SeededRng::new(seed);
        let shown_text = self
            .scene
            .with_header(&titles.name, &titles.source, &titles.note);
        // Values are replaced in the text in which they were found: first the numbers, then the
        // titles.
        let template = self.scene.reparse(&shown_text)?;
        let of_template = template.values();
        for (tries, spread) in TRIES {
            for _ in 0..tries {
                let Some(changes) = self.drawn(&mut rng, spread) else {
                    continue;
                };
                let in_template = changes.into_iter().filter_map(|(value, text)| {
                    let own = of_template.iter().find(|own| own.name == value.name)?;
                    Some((own.clone(), text))
                });
                let changes: Vec<_> = in_template.collect();
                if let Some(made) = self.tried(&template, &changes, &mut rng) {
                    return Some(made);
                }
            }
        }
        None
    }

    /// Draws dimensions and the driver's speed.
    fn drawn(&self, rng: &mut SeededRng, spread: DimensionSpread) -> Option<Vec<(Value, String)>> {
        let mut changes = self.dimensions.changed(rng, spread)?;
        let [low, high] = SPEEDS;
        let factor = f64::from(rng.between(low, high)) / 100.0;
        for value in self.scene.values() {
            let power = match value.measure {
                Measure::TurnSpeed | Measure::PushSpeed => 1,
                Measure::TurnAcceleration | Measure::PushAcceleration => 2,
                _ => continue,
            };
            if value.owner == ValueOwner::Driver && value.formula.is_none() {
                let number =
                    agreeable(value.number * if power == 1 { factor } else { factor * factor })?;
                let text = format!("{number} {}", value.unit);
                changes.push((value, text));
            }
        }
        Some(changes)
    }

    /// Creates the exercise with these numbers, if it meets the requirements.
    fn tried(
        &self,
        template: &Scene,
        changes: &[(Value, String)],
        rng: &mut SeededRng,
    ) -> Option<Exercise> {
        let scene = template.reparse(&template.with_values(changes))?;
        // Other elements would be another exercise.
        if !scene.has_elements_of(template) {
            return None;
        }
        let at = self.scene.mechanism.driver().start;
        let solver = self
            .solver
            .with_dimensions_in_assembly(at, &scene.mechanism)
            .ok()?;
        if MotionKind::of(&solver) != self.kind {
            return None;
        }
        let mut workspace = solver.state();
        let coordinates = places(&scene.mechanism, &solver);
        let margins = margins(&solver, &coordinates, &mut workspace);
        if !margins.iter().all(|margin| *margin >= self.worst) {
            return None;
        }
        let far = coordinates.iter().zip(&margins);
        let far: Vec<f64> = far
            .filter_map(|(at, margin)| (*margin >= self.required).then_some(*at))
            .collect();
        let at = (0..PLACES).find_map(|_| {
            let at = *rng.one_of(&far)?;
            is_lively(&solver, at, &mut workspace).then_some(at)
        })?;
        opened(&scene, &solver, at)
    }
}

/// Returns the scene opened at a position in the assembly of its solver.
fn opened(scene: &Scene, solver: &Solver, at: f64) -> Option<Exercise> {
    let key = match scene.mechanism.driver().input {
        Input::Turn(_) => Measure::Angle,
        Input::Push(_) => Measure::Coordinate,
    };
    let values = scene.values();
    let mut coordinate = values.iter();
    let coordinate =
        coordinate.find(|value| value.owner == ValueOwner::Driver && value.measure == key)?;
    let moved = scene.reparse(&scene.with_value(coordinate, &crate::scene::figure(at)))?;
    let scene = moved.reparse(&moved.with_start_of(solver, at)?)?;
    let solver = Solver::new(&scene.mechanism).ok()?;
    let start = scene.mechanism.driver().start;
    let mut state = solver.state();
    let is_sound =
        start == at && solver.solve(at, Order::Acceleration, &mut state) == Condition::Ok;
    is_sound.then_some(Exercise { scene, solver })
}

#[cfg(test)]
mod tests;
