//! What a figure of the cycle is to be: `F.stroke = 120`, `transmission >= 40`.

use crate::expression::converted;
use crate::quantity::Catalogue;
use crate::study::{CycleFigure, UnknownCycleFigure};
use crate::wording::words;
use thiserror::Error;

/// How a figure is held against a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GoalSense {
    /// It is to be that.
    Equal,
    /// It is not to be less.
    AtLeast,
    /// It is not to be more.
    AtMost,
}

impl GoalSense {
    /// As it is written.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            GoalSense::Equal => "=",
            GoalSense::AtLeast => ">=",
            GoalSense::AtMost => "<=",
        }
    }
}

/// A figure of the cycle, and what it is to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The figure.
    pub figure: CycleFigure,
    /// How it is held against the number.
    pub sense: GoalSense,
    /// The number, in the figure's unit.
    pub number: f64,
    /// By what a miss is measured: the size of the number, or of what the figure has to be changed by.
    size: f64,
}

/// What is no goal.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum MistypedGoal {
    /// It is not a figure, a sign and a number.
    #[error("{}", words().no_goal(.0))]
    Form(String),
    /// Its figure is none.
    #[error(transparent)]
    Figure(#[from] UnknownCycleFigure),
    /// The unit behind the number measures something else.
    #[error("{}", words().unit_of_goal(figure, unit, found))]
    Unit {
        /// The figure.
        figure: String,
        /// Its unit.
        unit: String,
        /// What was written.
        found: String,
    },
}

impl Goal {
    /// Reads a goal; the number may have a unit behind it, and is told in the figure's.
    ///
    /// # Errors
    /// What is no goal, and what would be one.
    pub fn parse(text: &str, catalogue: &Catalogue) -> Result<Goal, MistypedGoal> {
        let senses = [GoalSense::AtLeast, GoalSense::AtMost, GoalSense::Equal];
        let found = senses.into_iter().find_map(|sense| {
            let (figure, number) = text.split_once(sense.sign())?;
            Some((sense, figure.trim(), number.trim()))
        });
        let form = || MistypedGoal::Form(text.to_owned());
        let (sense, figure, typed) = found.ok_or_else(form)?;
        let figure = CycleFigure::parse(figure, catalogue)?;
        let split = typed.find(char::is_whitespace).unwrap_or(typed.len());
        let (plain, unit) = typed.split_at(split);
        let (plain, unit) = (plain.parse::<f64>().ok(), unit.trim());
        let is_own = unit.is_empty() || unit == figure.unit();
        let number = match plain.filter(|_| is_own) {
            Some(number) => number,
            None => {
                let number = converted(typed, figure.unit(), catalogue.length_scale());
                number.ok_or_else(|| match plain {
                    Some(_) => MistypedGoal::Unit {
                        figure: figure.name().to_owned(),
                        unit: figure.unit().to_owned(),
                        found: unit.to_owned(),
                    },
                    None => form(),
                })?
            }
        };
        if !number.is_finite() {
            return Err(form());
        }
        Ok(Goal {
            size: number.abs(),
            figure,
            sense,
            number,
        })
    }

    /// The same, where the figure has this value as it was given.
    #[must_use]
    pub fn from(self, given: Option<f64>) -> Goal {
        let way = given.map_or(0.0, |given| self.over(given).abs());
        let size = self.number.abs().max(way);
        Goal {
            size: if size > 0.0 { size } else { 1.0 },
            ..self
        }
    }

    /// By how much a value is more than the number: the short way to what a direction or a place in a turn is to be
    /// equal to. What it is to be more or less than it is compared with as both are told.
    fn over(&self, value: f64) -> f64 {
        match self.sense == GoalSense::Equal && self.figure.is_round() {
            true => crate::angle::beside(0.0, value - self.number),
            false => value - self.number,
        }
    }

    /// By how much a value misses it, in parts of its size.
    #[must_use]
    pub fn part(&self, value: f64) -> f64 {
        self.miss(value) / self.size
    }

    /// The derivative of [`Goal::part`] where the figure has this value and this derivative.
    pub(super) fn slope_of_part(&self, value: f64, slope: f64) -> f64 {
        match self.sense == GoalSense::Equal || self.miss(value) != 0.0 {
            true => slope / self.size,
            false => 0.0,
        }
    }

    /// The derivative of [`Goal::slack`] where the figure has this derivative.
    pub(super) fn slope_of_slack(&self, slope: f64) -> f64 {
        match self.sense {
            GoalSense::Equal | GoalSense::AtLeast => slope / self.size,
            GoalSense::AtMost => -slope / self.size,
        }
    }

    /// What a value leaves, in parts of the goal's size: of what it is not to be less or more than how far it is on the
    /// good side, below nought where it is missed; of what it is to be equal to how much it is more.
    pub(super) fn slack(&self, value: f64) -> f64 {
        let over = self.over(value) / self.size;
        match self.sense {
            GoalSense::Equal | GoalSense::AtLeast => over,
            GoalSense::AtMost => -over,
        }
    }

    /// By how much a value misses it, with its sign; 0 where it is met.
    #[must_use]
    pub fn miss(&self, value: f64) -> f64 {
        let over = self.over(value);
        match self.sense {
            GoalSense::Equal => over,
            GoalSense::AtLeast => over.min(0.0),
            GoalSense::AtMost => over.max(0.0),
        }
    }

    /// Whether a value meets it, as far as rounding tells.
    #[must_use]
    pub fn is_met(&self, value: f64) -> bool {
        self.miss(value).abs() <= MET * self.size
    }
}

/// What meets a goal may be off by this part of it.
const MET: f64 = 1e-9;
