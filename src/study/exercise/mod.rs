//! Exercises: a scene with other dimensions, drawn by chance and the same for the same seed on every machine.
//!
//! What is drawn moves as the scene does from which it was made: the same groups, the same class, a crank that turns
//! fully where it did, the same assembly; and it stands well away from dead points and change points.

mod agreeable;
mod dimensions;
mod likeness;

use crate::Input;
use crate::numeric::SeededChance;
use crate::scene::{Measure, Scene, Value, ValueOwner};
use crate::solver::{Condition, Order, Solver};
use agreeable::agreeable;

use dimensions::{Dimensions, DrawnApart};
use likeness::{MotionKind, is_lively, margins, places};

/// How often dimensions are drawn, and how far apart: where lengths stand in relations that chance does not
/// keep, the whole grows or shrinks.
const TRIES: [(usize, DrawnApart); 3] = [
    (60, DrawnApart::Each(25)),
    (30, DrawnApart::Each(12)),
    (12, DrawnApart::Together),
];
/// At no place of the motion is a group nearer to a singularity than this: 18 degrees of a dyad, as the square of a sine.
const WORST: f64 = 0.1;
/// The same at the place of the exercise: 30 degrees.
const ASKED: f64 = 0.25;
/// Where the scene itself comes nearer, an exercise may come so much nearer still.
const LESS: f64 = 0.8;
/// How many places are tried of one mechanism.
const PLACES: usize = 6;
/// Speeds in percent of the scene's.
const SPEEDS: [u32; 2] = [50, 200];

/// A scene from which exercises are made.
#[derive(Debug)]
pub struct ExerciseMaker<'a> {
    scene: &'a Scene,
    solver: &'a Solver,
    dimensions: Dimensions,
    kind: MotionKind,
    /// What is asked of the smallest margin over the motion, and of the one at the place of the exercise.
    worst: f64,
    asked: f64,
}

/// What an exercise is called, where it comes from, and what is to be said of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExerciseTitles {
    /// The title.
    pub name: String,
    /// Where it comes from.
    pub source: String,
    /// What there is to know.
    pub note: String,
}

/// An exercise: a scene of its own.
#[derive(Debug)]
pub struct Exercise {
    /// The scene, which opens where the exercise stands.
    pub scene: Scene,
    /// Its solver.
    pub solver: Solver,
}

impl<'a> ExerciseMaker<'a> {
    /// Looks at a scene in the assembly that its solver follows.
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
            // Nobody asks more of an exercise than of what it is made from.
            worst: WORST.min(LESS * worst),
            asked: ASKED.min(LESS * best),
        }
    }

    /// Whether there are lengths that chance can change.
    #[must_use]
    pub fn has_dimensions(&self) -> bool {
        !self.dimensions.is_empty()
    }

    /// The exercise of a seed; `None` where no dimensions were found with which the scene still moves as it did.
    #[must_use]
    pub fn exercise(&self, seed: u64, titles: &ExerciseTitles) -> Option<Exercise> {
        if !self.has_dimensions() {
            return None;
        }
        let mut chance = SeededChance::new(seed);
        let told = self
            .scene
            .retold(&titles.name, &titles.source, &titles.note);
        // Values are put into the text in which they were found: first numbers, then titles.
        let template = self.scene.again(&told)?;
        let of_template = template.values();
        for (tries, spread) in TRIES {
            for _ in 0..tries {
                let Some(changes) = self.drawn(&mut chance, spread) else {
                    continue;
                };
                let in_template = changes.into_iter().filter_map(|(value, text)| {
                    let own = of_template.iter().find(|own| own.name == value.name)?;
                    Some((own.clone(), text))
                });
                let changes: Vec<_> = in_template.collect();
                if let Some(made) = self.tried(&template, &changes, &mut chance) {
                    return Some(made);
                }
            }
        }
        None
    }

    /// Dimensions, and how fast the driver is.
    fn drawn(&self, chance: &mut SeededChance, spread: DrawnApart) -> Option<Vec<(Value, String)>> {
        let mut changes = self.dimensions.changed(chance, spread)?;
        let [low, high] = SPEEDS;
        let factor = f64::from(chance.between(low, high)) / 100.0;
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

    /// The exercise with these numbers, if it moves as it should.
    fn tried(
        &self,
        template: &Scene,
        changes: &[(Value, String)],
        chance: &mut SeededChance,
    ) -> Option<Exercise> {
        let scene = template.again(&template.with_values(changes))?;
        let at = self.scene.mechanism.driver().start;
        let solver = self.solver.carried_over(at, &scene.mechanism).ok()?;
        if MotionKind::of(&solver) != self.kind {
            return None;
        }
        let mut work = solver.state();
        let places = places(&scene.mechanism, &solver);
        let margins = margins(&solver, &places, &mut work);
        if !margins.iter().all(|margin| *margin >= self.worst) {
            return None;
        }
        let far = places.iter().zip(&margins);
        let far: Vec<f64> = far
            .filter_map(|(at, margin)| (*margin >= self.asked).then_some(*at))
            .collect();
        let at = (0..PLACES).find_map(|_| {
            let at = *chance.one_of(&far)?;
            is_lively(&solver, at, &mut work).then_some(at)
        })?;
        opened(&scene, &solver, at)
    }
}

/// The scene as it opens at a place in the assembly of its solver.
fn opened(scene: &Scene, solver: &Solver, at: f64) -> Option<Exercise> {
    let key = match scene.mechanism.driver().input {
        Input::Turn(_) => Measure::Angle,
        Input::Push(_) => Measure::Coordinate,
    };
    let values = scene.values();
    let mut coordinate = values.iter();
    let coordinate =
        coordinate.find(|value| value.owner == ValueOwner::Driver && value.measure == key)?;
    let moved = scene.again(&scene.with_value(coordinate, &crate::scene::figure(at)))?;
    let scene = moved.again(&moved.with_start_of(solver, at)?)?;
    let solver = Solver::new(&scene.mechanism).ok()?;
    let start = scene.mechanism.driver().start;
    let mut state = solver.state();
    let is_sound =
        start == at && solver.solve(at, Order::Acceleration, &mut state) == Condition::Ok;
    is_sound.then_some(Exercise { scene, solver })
}

#[cfg(test)]
mod tests;
