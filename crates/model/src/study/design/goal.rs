//! Goals for cycle figures: `F.stroke = 120`, `transmission >= 40`.

use crate::expression::converted;
use crate::quantity::Catalogue;
use crate::scene::with_point;
use crate::study::{CycleFigure, UnknownCycleFigure};
use crate::wording::words;
use thiserror::Error;

/// The comparison of a figure with a goal's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GoalSense {
    /// The figure must equal the number.
    Equal,
    /// The figure must be at least the number.
    AtLeast,
    /// The figure must be at most the number.
    AtMost,
}

impl GoalSense {
    /// Returns the sign as it is written.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            GoalSense::Equal => "=",
            GoalSense::AtLeast => ">=",
            GoalSense::AtMost => "<=",
        }
    }
}

/// A goal: a cycle figure, a comparison and a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The cycle figure of the goal.
    pub figure: CycleFigure,
    /// The comparison.
    pub sense: GoalSense,
    /// The number, in the figure's unit.
    pub number: f64,
    /// The scale of misses: the larger of the number and the required change of the figure.
    size: f64,
}

/// An error in the text of a goal.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MistypedGoal {
    /// The text is not a figure, a sign and a number.
    #[error("{}", words().no_goal(.0))]
    Form(String),
    /// The decimal mark of the number is ambiguous.
    #[error("{}", words().typed_two_marks(.0))]
    TwoMarks(String),
    /// The figure does not exist.
    #[error(transparent)]
    Figure(#[from] UnknownCycleFigure),
    /// The unit after the number measures another quantity.
    #[error("{}", words().unit_of_goal(figure, unit, found))]
    Unit {
        /// The name of the figure.
        figure: String,
        /// The figure's unit.
        unit: String,
        /// The unit in the text.
        found: String,
    },
}

impl Goal {
    /// Parses a goal. The number may have a unit and is converted to the figure's unit.
    ///
    /// # Errors
    /// Returns an error if the text is not a goal.
    pub fn parse(text: &str, catalogue: &Catalogue) -> Result<Goal, MistypedGoal> {
        let senses = [GoalSense::AtLeast, GoalSense::AtMost, GoalSense::Equal];
        let found = senses.into_iter().find_map(|sense| {
            let (figure, number) = text.split_once(sense.sign())?;
            Some((sense, figure.trim(), number.trim()))
        });
        let form = || MistypedGoal::Form(text.to_owned());
        let (sense, figure, typed) = found.ok_or_else(form)?;
        let figure = CycleFigure::parse(figure, catalogue)?;
        let unclear = || MistypedGoal::TwoMarks(typed.to_owned());
        let typed = with_point(typed).ok_or_else(unclear)?;
        let typed = typed.as_ref();
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

    /// Returns the goal with misses scaled for a figure that has the value `given` in the given
    /// design.
    #[must_use]
    pub fn from(self, given: Option<f64>) -> Goal {
        let travel = given.map_or(0.0, |given| self.over(given).abs());
        let size = self.number.abs().max(travel);
        Goal {
            size: if size > 0.0 { size } else { 1.0 },
            ..self
        }
    }

    /// Returns the excess of a value over the number. For equality with a direction or a place in a
    /// turn it is the shorter difference. Inequalities compare the values as they are shown.
    fn over(&self, value: f64) -> f64 {
        match self.sense == GoalSense::Equal && self.figure.is_round() {
            true => crate::angle::unwrap_near(0.0, value - self.number),
            false => value - self.number,
        }
    }

    /// Returns the miss of a value, relative to the goal's size.
    #[must_use]
    pub fn part(&self, value: f64) -> f64 {
        self.miss(value) / self.size
    }

    /// Returns the derivative of [`Goal::part`] for a figure with this value and derivative.
    pub(super) fn slope_of_part(&self, value: f64, slope: f64) -> f64 {
        match self.sense == GoalSense::Equal || self.miss(value) != 0.0 {
            true => slope / self.size,
            false => 0.0,
        }
    }

    /// Returns the derivative of [`Goal::slack`] for a figure with this derivative.
    pub(super) fn slope_of_slack(&self, slope: f64) -> f64 {
        match self.sense {
            GoalSense::Equal | GoalSense::AtLeast => slope / self.size,
            GoalSense::AtMost => -slope / self.size,
        }
    }

    /// Returns the slack of a value, relative to the goal's size. For an inequality it is positive
    /// if the goal is met and negative if it is missed; for an equality it is the excess.
    pub(super) fn slack(&self, value: f64) -> f64 {
        let over = self.over(value) / self.size;
        match self.sense {
            GoalSense::Equal | GoalSense::AtLeast => over,
            GoalSense::AtMost => -over,
        }
    }

    /// Returns the signed miss of a value; 0 if it meets the goal.
    #[must_use]
    pub fn miss(&self, value: f64) -> f64 {
        let over = self.over(value);
        match self.sense {
            GoalSense::Equal => over,
            GoalSense::AtLeast => over.min(0.0),
            GoalSense::AtMost => over.max(0.0),
        }
    }

    /// Returns `true` if a value meets the goal up to rounding error.
    #[must_use]
    pub fn is_met(&self, value: f64) -> bool {
        self.miss(value).abs() <= MET * self.size
    }
}

/// Tolerance for meeting a goal, relative to its size.
pub(super) const MET: f64 = 1e-9;
