//! Computes the structural error of a proposed linkage at every x.

use super::fit::{fitted, in_order};
use super::linkage::FunctionLinkage;
use super::task::{FunctionLaw, TargetFunction, wrapped};
use crate::{FunctionTask, Output, PinConstraint, Proposal};
use kinematics::Vec2;
use kinematics::numeric::lowest;
use std::f64::consts::{PI, TAU};

/// Number of samples over a range before the maximum error is refined.
const RANGE_SAMPLES: usize = 361;

/// A proposal for a function, over its whole range, on the side of its first pair.
#[derive(Clone, Debug)]
pub struct FunctionRun {
    linkage: FunctionLinkage,
    law: FunctionLaw,
    side: f64,
    size: f64,
}

/// The point of maximum error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxError {
    /// The x of the point.
    pub x: f64,
    /// The error at x, signed, in degrees or in lengths of the task.
    pub error: f64,
}

impl FunctionRun {
    /// Creates the run of a proposal for a task.
    ///
    /// Free datums and scales are fitted to the pins. The crank's are exact if neighbouring pairs
    /// are less than half a turn apart. Returns `None` if the proposal is not for a function of
    /// this kind.
    #[must_use]
    pub fn of(task: &FunctionTask, proposal: &Proposal) -> Option<FunctionRun> {
        let target = TargetFunction::of(task)?;
        let (crank, coupler, rocker) = proposal.lengths()?;
        let place = |at: Vec2| Vec2::new(at.x / task.size, at.y / task.size);
        let pins: Vec<[Vec2; 2]> = proposal
            .places
            .iter()
            .map(|[b, c]| [place(*b - proposal.pivot), place(*c - proposal.pivot)])
            .collect();
        let [_, first] = *pins.first()?;
        let third = match (proposal.partner, target.output) {
            (PinConstraint::Rocker(_), Output::Angle) => rocker? / task.size,
            (PinConstraint::Slide(_), Output::Slide) => first.y,
            _ => return None,
        };
        let linkage = FunctionLinkage {
            output: target.output,
            crank: crank / task.size,
            coupler: coupler / task.size,
            third,
        };
        let outputs = |[_, c]: &[Vec2; 2]| match target.output {
            Output::Angle => (*c - Vec2::new(1.0, 0.0)).angle(),
            Output::Slide => c.x,
        };
        let cranks: Vec<f64> = pins.iter().map(|[b, _]| b.angle()).collect();
        let outputs: Vec<f64> = pins.iter().map(outputs).collect();
        let xs: Vec<f64> = target.pairs.iter().map(|pair| pair[0]).collect();
        let ys: Vec<f64> = target.pairs.iter().map(|pair| pair[1]).collect();
        // The crank of a slider-crank is never opposite to its angle.
        let [crank_period, output_period] = match target.output {
            Output::Angle => [Some(PI), Some(PI)],
            Output::Slide => [Some(TAU), None],
        };
        let order = in_order(&xs);
        let law = FunctionLaw {
            crank: fitted(
                &order,
                &xs,
                &cranks,
                [target.given[0], target.given[1]],
                crank_period,
            )?,
            output: fitted(
                &order,
                &ys,
                &outputs,
                [target.given[2], target.given[3]],
                output_period,
            )?,
        };
        Some(FunctionRun {
            side: linkage.side(*cranks.first()?, *outputs.first()?),
            linkage,
            law,
            size: task.size,
        })
    }

    /// Returns the crank's angle at x, in degrees.
    #[must_use]
    pub fn crank(&self, x: f64) -> f64 {
        (self.law.crank[0] + self.law.crank[1] * x).to_degrees()
    }

    /// Returns the output at x, in radians or in parts of the size; `None` if the linkage does not
    /// close.
    fn made(&self, x: f64) -> Option<f64> {
        let angle = self.law.crank[0] + self.law.crank[1] * x;
        self.linkage.output(angle, self.side)
    }

    /// Returns the structural error: the output at x less the wanted output for y, in degrees or in
    /// lengths of the task. Returns `None` if the linkage does not close.
    #[must_use]
    pub fn error(&self, x: f64, y: f64) -> Option<f64> {
        let [datum, scale] = self.law.output;
        let error = self.made(x)? - datum - scale * y;
        Some(match self.linkage.output {
            Output::Angle => wrapped(error).to_degrees(),
            Output::Slide => error * self.size,
        })
    }

    /// Returns the range of the wanted output over pairs, maximum less minimum, in the unit of the
    /// errors.
    #[must_use]
    pub fn swing<'p>(&self, pairs: impl IntoIterator<Item = &'p [f64; 2]>) -> f64 {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let ys = pairs.into_iter().map(|[_, y]| *y);
        let (low, high) = ys.fold(ends, |(low, high), y| (low.min(y), high.max(y)));
        let swing = self.law.output[1].abs() * (high - low);
        match self.linkage.output {
            Output::Angle => swing.to_degrees(),
            Output::Slide => swing * self.size,
        }
    }

    /// Returns the point of maximum absolute error against a function between two ends. Returns
    /// `None` if the linkage does not close everywhere, or if the function has no value.
    #[must_use]
    pub fn max_error(
        &self,
        f: impl Fn(f64) -> Option<f64>,
        [from, to]: [f64; 2],
    ) -> Option<MaxError> {
        let error = |x: f64| self.error(x, f(x)?).filter(|error| error.is_finite());
        let place = |k: usize| from + (to - from) * k as f64 / (RANGE_SAMPLES - 1) as f64;
        let looks: Option<Vec<f64>> = (0..RANGE_SAMPLES).map(|k| error(place(k))).collect();
        let looks = looks?;
        let maximum =
            (0..RANGE_SAMPLES).max_by(|&a, &b| looks[a].abs().total_cmp(&looks[b].abs()))?;
        let (x, size) = (place(maximum), looks[maximum].abs());
        let ends = [
            place(maximum.saturating_sub(1)),
            place((maximum + 1).min(RANGE_SAMPLES - 1)),
        ];
        let closer = lowest(|x| Some(-error(x)?.abs()), ends, (x, -size));
        let (x, _) = closer.unwrap_or_else(|unsettled| unsettled.best());
        Some(MaxError {
            x,
            error: error(x)?,
        })
    }
}
