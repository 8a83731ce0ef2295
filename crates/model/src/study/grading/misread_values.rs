//! Finds a given value that a student misread, so that the wrong answers follow from it.

use super::comparison::{FigureVerdict, MAX_COUNT, MIN_COUNT, Truth};
use super::{AnswerKey, GivenAnswer, WrittenFigure};
use crate::scene::{Measure, Scene, Value, ValueOwner};
use crate::solver::{Condition, Order, Solver};

/// The scene of an exercise sheet at the position of the questions; its given values can be
/// changed.
#[derive(Clone, Copy, Debug)]
pub struct SheetScene<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The scene's solver.
    pub solver: &'a Solver,
    /// The driver's coordinate.
    pub at: f64,
}

/// A given value that was read as another number.
#[derive(Clone, Debug, PartialEq)]
pub struct MisreadValue {
    /// The value.
    pub value: Value,
    /// The number it was read as.
    pub number: f64,
    /// The index of the first answer that shows the mistake.
    pub figure: usize,
}

/// Minimum number of other answers to explain, or all wrong ones if there are fewer; an explanation
/// of fewer may be a coincidence.
const MIN_EXPLAINED: usize = 2;
/// Maximum number of secant steps.
const STEPS: usize = 30;
/// Maximum number of halvings of a step.
const HALVINGS: i32 = 8;
/// The step below which the iteration ends, relative to the value.
const STEP_TOLERANCE: f64 = 1e-12;
/// The relative change for the first slope.
const FIRST_STEP: f64 = 1e-4;

impl AnswerKey {
    /// Explains wrong answers by one misread given value. The first of them keeps its verdict; the
    /// others count as consequential.
    #[must_use]
    pub fn misread(
        &self,
        answers: &[GivenAnswer],
        verdicts: &mut [FigureVerdict],
        sheet: SheetScene<'_>,
    ) -> Option<MisreadValue> {
        let lost: Vec<(usize, WrittenFigure)> = (0..self.required.min(verdicts.len()))
            .filter(|&number| is_lost(verdicts[number]))
            .filter_map(|number| Some((number, answers.get(number)?.figure()?)))
            .filter(|(number, written)| {
                !Truth::of(&self.figures[*number]).is_out_of_reach(*written)
            })
            .collect();
        if lost.len() < 2 {
            return None;
        }
        // Candidates: the first answer of the positions, of the velocities and of the
        // accelerations; with two wrong answers both.
        let mut orders: Vec<Order> = Vec::new();
        let firsts = lost.iter().filter(|(number, _)| {
            let order = self.figures[*number].quantity.order();
            let is_first = !orders.contains(&order);
            orders.push(order);
            is_first || lost.len() == 2
        });
        // Choose the value that explains most of the others, and the first one of equals.
        let maximum = lost.len() - 1;
        let fewest = MIN_EXPLAINED.min(maximum);
        let mut best: Option<(MisreadValue, Vec<usize>)> = None;
        let pairs = firsts.flat_map(|&first| sheet.given().into_iter().map(move |v| (first, v)));
        for ((first, written), value) in pairs {
            let Some((number, by)) = self.reading((first, written), &lost, &value, sheet) else {
                continue;
            };
            let minimum = best.as_ref().map_or(fewest, |(_, by)| by.len() + 1);
            if by.len() >= minimum {
                let index = first;
                best = Some((
                    MisreadValue {
                        value,
                        number,
                        figure: index,
                    },
                    by,
                ));
            }
            if best.as_ref().is_some_and(|(_, by)| by.len() == maximum) {
                break;
            }
        }
        let (misread, by) = best?;
        for explained in by {
            verdicts[explained] = FigureVerdict::Followed(misread.figure);
        }
        Some(misread)
    }

    /// Finds the number for a given value at which a quantity equals the written one.
    fn read_as(
        &self,
        (index, written): (usize, WrittenFigure),
        value: &Value,
        sheet: SheetScene<'_>,
    ) -> Option<f64> {
        let requested = self.figures.get(index)?;
        let off = |number: f64| {
            let found = sheet.with(value, number, |state| requested.quantity.value(state))??;
            Some(
                -Truth::of(requested)
                    .with(found)
                    .difference_from(written.value),
            )
        };
        let mut last = (value.number, off(value.number)?);
        let next = value.number * (1.0 + FIRST_STEP);
        let mut here = (next, off(next)?);
        for _ in 0..STEPS {
            let slope = (here.1 - last.1) / (here.0 - last.0);
            let next = here.0 - here.1 / slope;
            if !next.is_finite() {
                return None;
            }
            if (next - here.0).abs() <= STEP_TOLERANCE * value.number.abs() {
                return Some(next);
            }
            // A long step may end where the loops do not close.
            let mut halved = (0..HALVINGS).map(|k| here.0 + (next - here.0) / f64::from(1 << k));
            let (next, miss) = halved.find_map(|next| Some((next, off(next)?)))?;
            (last, here) = (here, (next, miss));
        }
        None
    }

    /// Returns the number that a value was read as, and the other answers that it explains.
    fn reading(
        &self,
        (first, written): (usize, WrittenFigure),
        lost: &[(usize, WrittenFigure)],
        value: &Value,
        sheet: SheetScene<'_>,
    ) -> Option<(f64, Vec<usize>)> {
        let found = self.read_as((first, written), value, sheet)?;
        let figures = |number| {
            sheet.with(value, number, |state| {
                let values = self
                    .figures
                    .iter()
                    .map(|requested| requested.quantity.value(state));
                values.collect::<Vec<_>>()
            })
        };
        let nearby = (figures(found)?, figures(found * (1.0 + FIRST_STEP))?);
        let moved = |index: usize| {
            let there = Truth::of(&self.figures[index]).with(nearby.0[index]?);
            Some(there.difference_from(nearby.1[index]?).abs())
        };
        // The change of the value by the digits that the first answer lacks, because they may have
        // been cut off.
        let last = written.unit_of(MIN_COUNT, i32::MAX);
        let parts = last / moved(first).filter(|by| *by > 0.0)?;
        let is_explained = |there: &[Option<f64>], index: usize, own: WrittenFigure| {
            let truth = Truth::of(&self.figures[index]);
            let followed = truth.with(there[index]?);
            let distance = followed.difference_from(own.value).abs();
            let carried = (parts * moved(index)?).min(followed.carried());
            let is_nearer = distance <= 0.5 * truth.difference_from(own.value).abs();
            // A number that is written everywhere is not a consequence of earlier answers.
            let is_copied = own.value == written.value;
            Some(is_nearer && !is_copied && distance <= own.unit_of(MIN_COUNT, MAX_COUNT) + carried)
        };
        let explained = |number: f64, there: &[Option<f64>]| {
            let others = lost.iter().filter(|(number, _)| *number != first);
            let explained =
                others.filter(|(number, own)| is_explained(there, *number, *own) == Some(true));
            (
                number,
                explained.map(|(number, _)| *number).collect::<Vec<_>>(),
            )
        };
        // A round number is preferred, unless the exact one explains more.
        let round = roundest(found, (parts * FIRST_STEP * found).abs());
        let exact = explained(found, &nearby.0);
        let round = match round == found {
            true => None,
            false => figures(round).map(|there| explained(round, &there)),
        };
        let is_better = |round: &(f64, Vec<usize>)| round.1.len() >= exact.1.len();
        Some(round.filter(is_better).unwrap_or(exact))
    }
}

/// Returns the number with the fewest digits, up to four, within a distance; without one, the
/// number itself.
fn roundest(number: f64, within: f64) -> f64 {
    let rounded = (0..4).filter_map(|digits| format!("{number:.digits$e}").parse::<f64>().ok());
    let mut near = rounded.filter(|rounded| (rounded - number).abs() <= within);
    near.next().unwrap_or(number)
}

impl SheetScene<'_> {
    /// Returns the given values that can be misread: numbers other than 0.
    fn given(&self) -> Vec<Value> {
        let mut values = self.scene.values();
        values.retain(|value| {
            let is_given = match value.measure {
                Measure::Length
                | Measure::Coordinate
                | Measure::Angle
                | Measure::TurnSpeed
                | Measure::TurnAcceleration
                | Measure::PushSpeed
                | Measure::PushAcceleration
                | Measure::Parameter => true,
                Measure::Start
                | Measure::Deviation
                | Measure::Mass
                | Measure::Inertia
                | Measure::Force
                | Measure::Torque
                | Measure::Gravity
                | Measure::Stiffness
                | Measure::Damping
                | Measure::TurnStiffness
                | Measure::TurnDamping
                | Measure::Time
                | Measure::Factor => false,
            };
            is_given && value.formula.is_none() && value.number != 0.0
        });
        // The driver's values are misread more often than lengths.
        values.sort_by_key(|value| value.owner != ValueOwner::Driver);
        values
    }

    /// Solves the scene with another number for a value, in the same assembly.
    fn with<T>(
        &self,
        value: &Value,
        number: f64,
        read: impl FnOnce(&crate::solver::State) -> T,
    ) -> Option<T> {
        let is_coordinate = value.owner == ValueOwner::Driver && !value.measure.is_rate();
        if is_coordinate {
            return solved(self.solver, number, read);
        }
        if number == value.number {
            return solved(self.solver, self.at, read);
        }
        let changed = self.scene.with_value(value, &value.with_number(number));
        let scene = self.scene.reparse(&changed)?;
        // `read` has ids of the given scene.
        if !scene.has_elements_of(self.scene) {
            return None;
        }
        let solver = self
            .solver
            .with_dimensions_in_assembly(self.at, &scene.mechanism)
            .ok()?;
        solved(&solver, self.at, read)
    }
}

fn solved<T>(solver: &Solver, at: f64, read: impl FnOnce(&crate::solver::State) -> T) -> Option<T> {
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Acceleration, &mut state);
    (condition == Condition::Ok).then(|| read(&state))
}

/// Returns `true` if an answer earns nothing and may follow from a misread value.
fn is_lost(verdict: FigureVerdict) -> bool {
    match verdict {
        FigureVerdict::Wrong
        | FigureVerdict::Sign
        | FigureVerdict::Opposite
        | FigureVerdict::OtherUnit(_) => true,
        FigureVerdict::Right
        | FigureVerdict::Rounded(_)
        | FigureVerdict::Followed(_)
        | FigureVerdict::OtherAssembly
        | FigureVerdict::Empty
        | FigureVerdict::Unreadable => false,
    }
}
