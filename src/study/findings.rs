//! What a study has found: figures, no text.

use super::spread::Spread;
use crate::solver::{Method, Unfit};

/// The largest errors over all positions at which a method found the mechanism.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MethodErrors {
    /// Of the positions of points, over the longest length.
    pub position: f64,
    /// Of their velocities, over the largest velocity of the cycle.
    pub velocity: f64,
    /// Of their accelerations, over the largest acceleration of the cycle.
    pub acceleration: f64,
}

/// How many steps or halvings a position takes, of all groups together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IterationCounts {
    /// At half of the positions at the most so many.
    pub median: u32,
    /// Nowhere more.
    pub most: u32,
}

/// What was measured of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodFigures {
    /// Seconds for one position with velocities and accelerations; of an integration, for a step.
    pub time: Option<Spread>,
    /// `None` where it was right nowhere.
    pub errors: Option<MethodErrors>,
    /// Positions at which it was tried.
    pub tried: u64,
    /// Of these, positions at which it found nothing, or another assembly.
    pub failures: u64,
    /// Of a method that counts them, where it found the mechanism.
    pub iterations: Option<IterationCounts>,
}

/// What there is to say about a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MethodVerdict {
    /// It was measured.
    Measured(MethodFigures),
    /// It cannot be used for this mechanism.
    Unfit(Unfit),
    /// The study has not come to it.
    Pending,
}

/// A method and what was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// The letter by which tables and charts name it: the same for every mechanism.
    pub key: char,
    /// The method.
    pub method: Method,
    /// What there is to say about it.
    pub verdict: MethodVerdict,
    /// Whether it never fails and no other such method is both faster and nearer.
    pub best: bool,
}

/// All methods.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// In the order of their letters.
    pub methods: Vec<Finding>,
    /// The longest length, which errors of positions are parts of, in the scene's unit.
    pub longest: f64,
    /// Positions at which the methods were compared.
    pub positions: usize,
    /// Whether everything was measured.
    pub finished: bool,
}

impl Finding {
    /// Its figures, if it was measured.
    #[must_use]
    pub fn figures(&self) -> Option<&MethodFigures> {
        match &self.verdict {
            MethodVerdict::Measured(figures) => Some(figures),
            MethodVerdict::Unfit(_) | MethodVerdict::Pending => None,
        }
    }
}

/// Marks the best front of time and error of position.
pub(super) fn mark_best(methods: &mut [Finding]) {
    let cost = |finding: &Finding| {
        let figures = finding.figures().filter(|f| f.failures == 0)?;
        Some([figures.time?.median, figures.errors?.position])
    };
    let costs: Vec<_> = methods.iter().map(cost).collect();
    for (finding, best) in methods.iter_mut().zip(super::front::front(&costs)) {
        finding.best = best;
    }
}
