//! Newton and Raphson's method, in full steps.

use super::{LoopSystem, SoughtKind};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// It has arrived where a step is no larger: in rad, and in parts of the longest length.
const ARRIVED: f64 = 1e-12;
/// And nearer than this to the right values.
const SAME: f64 = 1e-6;
/// It does not settle in so many steps: four or five are usual.
const MOST_STEPS: usize = 30;
/// A matrix is singular where its smallest singular value is less than this part of the largest: of digits,
/// three are left.
const SINGULAR: f64 = 1e-13;
/// It has run away where an angle is so many turns from its guess,
const FAR_TURNS: f64 = 100.0;
/// or a length so many times the longest.
const FAR_LENGTHS: f64 = 1000.0;

/// Values, and what the method makes of them.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonIteration {
    /// What is sought, in its order.
    pub values: Vec<f64>,
    /// What is left of each equation.
    pub residuals: Vec<f64>,
    /// The derivatives, row by row.
    pub jacobian: Vec<f64>,
    /// Their determinant.
    pub determinant: f64,
    /// What is added to the values; `None` where the method ends.
    pub step: Option<Vec<f64>>,
    /// How far the values are from the right ones, where these are known.
    pub error: Option<f64>,
}

/// What becomes of a guess.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NewtonOutcome {
    /// The values that are right.
    Found,
    /// Values that close the loops, and not the right ones.
    OtherAssembly,
    /// Values far away from all that is meant.
    Diverged,
    /// The matrix of this iteration has no inverse.
    Singular(usize),
    /// The steps do not become small.
    Unsettled,
}

/// All iterations from a guess, the guess first.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonTrace {
    /// The iterations.
    pub iterations: Vec<NewtonIteration>,
    /// How it ends.
    pub outcome: NewtonOutcome,
}

impl LoopSystem {
    /// Newton and Raphson's method from a guess; `right` are the values that are sought, if there are any. A
    /// system that is not square ends at once as a singular one.
    #[must_use]
    pub fn newton(&self, guess: &[f64], right: Option<&[f64]>) -> NewtonTrace {
        let mut values = guess.to_vec();
        let mut iterations = Vec::new();
        let outcome = loop {
            let mut here = self.iteration(&values, right);
            let next = if self.has_run_away(guess, &values) {
                Err(NewtonOutcome::Diverged)
            } else {
                self.step(&here)
                    .ok_or(NewtonOutcome::Singular(iterations.len()))
            };
            let step = match next {
                Ok(step) => step,
                Err(outcome) => {
                    iterations.push(here);
                    break outcome;
                }
            };
            let is_last = self.largest(&step) <= ARRIVED;
            if is_last {
                let outcome = match here.error {
                    Some(error) if error <= SAME => NewtonOutcome::Found,
                    _ => NewtonOutcome::OtherAssembly,
                };
                iterations.push(here);
                break outcome;
            }
            if iterations.len() == MOST_STEPS {
                iterations.push(here);
                break NewtonOutcome::Unsettled;
            }
            values.iter_mut().zip(&step).for_each(|(v, d)| *v += d);
            here.step = Some(step);
            iterations.push(here);
        };
        NewtonTrace {
            iterations,
            outcome,
        }
    }

    fn iteration(&self, values: &[f64], right: Option<&[f64]>) -> NewtonIteration {
        let jacobian = self.jacobian(values);
        let matrix = self.matrix(&jacobian);
        NewtonIteration {
            values: values.to_vec(),
            residuals: self.residuals(values),
            determinant: match matrix.is_square() {
                true => matrix.determinant(),
                false => f64::NAN,
            },
            jacobian,
            step: None,
            error: right.map(|right| self.error(values, right)),
        }
    }

    fn matrix(&self, jacobian: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(2 * self.loops.len(), self.kinds.len(), jacobian)
    }

    /// J d = -f; `None` where J has no inverse.
    fn step(&self, here: &NewtonIteration) -> Option<Vec<f64>> {
        let matrix = self.matrix(&here.jacobian);
        if !self.is_square() || here.jacobian.iter().any(|v| !v.is_finite()) {
            return None;
        }
        // A column of an angle is longer by a length: beside one of a length that says nothing.
        let mut scaled = matrix.clone();
        for (place, kind) in self.kinds.iter().enumerate() {
            if *kind == SoughtKind::Angle {
                scaled.column_mut(place).scale_mut(self.longest.recip());
            }
        }
        let sizes = scaled.singular_values();
        if !(sizes.min() > SINGULAR * sizes.max()) {
            return None;
        }
        let right = DVector::from_iterator(here.residuals.len(), here.residuals.iter().map(|f| -f));
        let step = matrix.lu().solve(&right)?;
        let step: Vec<f64> = step.iter().copied().collect();
        step.iter().all(|d| d.is_finite()).then_some(step)
    }

    fn has_run_away(&self, guess: &[f64], values: &[f64]) -> bool {
        let mut all = self.kinds.iter().zip(guess.iter().zip(values));
        all.any(|(kind, (guess, value))| match kind {
            SoughtKind::Angle => !((value - guess).abs() <= FAR_TURNS * TAU),
            SoughtKind::Length => !(value.abs() <= guess.abs().max(FAR_LENGTHS * self.longest)),
        })
    }
}
