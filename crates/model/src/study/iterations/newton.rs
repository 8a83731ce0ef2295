//! The Newton-Raphson method with full steps.

use super::{LoopSystem, UnknownKind};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The step below which the method has converged: in rad, and relative to the longest length.
const STEP_TOLERANCE: f64 = 1e-12;
/// The maximum error of values that count as the right ones.
const EQUALITY_TOLERANCE: f64 = 1e-6;
/// Maximum number of steps; four or five are usual.
const MAX_STEPS: usize = 30;
/// The ratio of the smallest to the largest singular value below which a matrix is singular: three
/// digits are left.
const SINGULAR: f64 = 1e-13;
/// The change of an angle from its guess, in turns, at which the method diverges.
const FAR_TURNS: f64 = 100.0;
/// The length relative to the longest one, at which the method diverges.
const FAR_LENGTHS: f64 = 1000.0;

/// One iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonIteration {
    /// The unknowns in order.
    pub values: Vec<f64>,
    /// The residuals of the equations.
    pub residuals: Vec<f64>,
    /// The derivatives, row by row.
    pub jacobian: Vec<f64>,
    /// The determinant of the derivatives.
    pub determinant: f64,
    /// The step to the next values; `None` at the end of the method.
    pub step: Option<Vec<f64>>,
    /// The error of the values, if the right ones are known.
    pub error: Option<f64>,
}

/// The outcome for a guess.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NewtonOutcome {
    /// The right values.
    Found,
    /// Values that close the loops, but are not the right ones.
    OtherAssembly,
    /// Values far from the guess.
    Diverged,
    /// The matrix of this iteration is singular.
    Singular(usize),
    /// The steps do not become small.
    MinimumError,
}

/// All iterations, beginning with the guess.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonTrace {
    /// The iterations.
    pub iterations: Vec<NewtonIteration>,
    /// The outcome.
    pub outcome: NewtonOutcome,
}

impl LoopSystem {
    /// Runs the Newton-Raphson method from a guess; `right` are the expected values, if known. A
    /// system that is not square ends at once as singular.
    #[must_use]
    pub fn newton(&self, guess: &[f64], right: Option<&[f64]>) -> NewtonTrace {
        let mut values = guess.to_vec();
        let mut iterations = Vec::new();
        let outcome = loop {
            let mut here = self.iteration(&values, right);
            let next = if self.has_diverged(guess, &values) {
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
            let is_last = self.largest(&step) <= STEP_TOLERANCE;
            if is_last {
                let outcome = match here.error {
                    Some(error) if error <= EQUALITY_TOLERANCE => NewtonOutcome::Found,
                    _ => NewtonOutcome::OtherAssembly,
                };
                iterations.push(here);
                break outcome;
            }
            if iterations.len() == MAX_STEPS {
                iterations.push(here);
                break NewtonOutcome::MinimumError;
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

    /// Solves J d = -f; `None` if J is singular.
    fn step(&self, here: &NewtonIteration) -> Option<Vec<f64>> {
        let matrix = self.matrix(&here.jacobian);
        if !self.is_square() || here.jacobian.iter().any(|v| !v.is_finite()) {
            return None;
        }
        // The columns of angles have the dimension of a length, those of lengths have none; scaling
        // makes them comparable.
        let mut scaled = matrix.clone();
        for (index, kind) in self.kinds.iter().enumerate() {
            if *kind == UnknownKind::Angle {
                scaled.column_mut(index).scale_mut(self.longest.recip());
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

    fn has_diverged(&self, guess: &[f64], values: &[f64]) -> bool {
        let mut all = self.kinds.iter().zip(guess.iter().zip(values));
        all.any(|(kind, (guess, value))| match kind {
            UnknownKind::Angle => !((value - guess).abs() <= FAR_TURNS * TAU),
            UnknownKind::Length => !(value.abs() <= guess.abs().max(FAR_LENGTHS * self.longest)),
        })
    }
}
