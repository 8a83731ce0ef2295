//! The results of a study as numbers, without text.

use super::spread::Spread;
use crate::solver::{Method, Unsuitable};

/// The largest errors of a method over all positions that it solved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MethodErrors {
    /// The error of points' positions, relative to the longest length.
    pub position: f64,
    /// The error of their velocities, relative to the cycle's largest velocity.
    pub velocity: f64,
    /// The error of their accelerations, relative to the cycle's largest acceleration.
    pub acceleration: f64,
}

/// The number of iterations or bisection steps per position, summed over all groups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IterationCounts {
    /// The median.
    pub median: u32,
    /// The maximum.
    pub most: u32,
}

/// The measurements of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodFigures {
    /// Seconds per position with velocities and accelerations; for an integration, per step.
    pub time: Option<Spread>,
    /// `None` if the method failed at every position.
    pub errors: Option<MethodErrors>,
    /// The number of positions at which the method was tried.
    pub tried: u64,
    /// The number of positions at which it found no state, or another assembly.
    pub failures: u64,
    /// Iterations of the successful positions, for a method that counts them.
    pub iterations: Option<IterationCounts>,
}

/// The state of a method in a study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MethodVerdict {
    /// The method was measured.
    Measured(MethodFigures),
    /// The method cannot be used for this mechanism.
    Unsuitable(Unsuitable),
    /// The method is not measured yet.
    Pending,
}

/// A method and its results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// The letter of the method in tables and charts, independent of the mechanism.
    pub key: char,
    /// The method.
    pub method: Method,
    /// The results.
    pub verdict: MethodVerdict,
    /// `true` if the method never fails and no other such method is both faster and more accurate.
    pub best: bool,
}

/// The results of all methods.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// The methods in the order of their letters.
    pub methods: Vec<Finding>,
    /// The longest length, in the scene's unit; errors of positions are relative to it.
    pub longest: f64,
    /// The number of positions at which the methods were compared.
    pub positions: usize,
    /// `true` if everything was measured.
    pub finished: bool,
}

impl Finding {
    /// Returns the measurements; `None` if the method was not measured.
    #[must_use]
    pub fn figures(&self) -> Option<&MethodFigures> {
        match &self.verdict {
            MethodVerdict::Measured(figures) => Some(figures),
            MethodVerdict::Unsuitable(_) | MethodVerdict::Pending => None,
        }
    }
}

/// Marks the best front of time and position error.
pub(super) fn mark_best(methods: &mut [Finding]) {
    let cost = |finding: &Finding| {
        let figures = finding.figures().filter(|f| f.failures == 0)?;
        Some([figures.time?.median, figures.errors?.position])
    };
    let costs: Vec<_> = methods.iter().map(cost).collect();
    for (finding, best) in methods.iter_mut().zip(super::pareto_front::front(&costs)) {
        finding.best = best;
    }
}
