//! Compares one answer with the exact value.

use super::{RequiredValue, WrittenFigure};
use crate::angle::TURN;
use crate::quantity::other_units;

/// The verdict on an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureVerdict {
    /// The exact value, rounded to the written digits.
    Right,
    /// Right except for early rounding.
    Rounded(RoundedEarly),
    /// Consequential: right if computed from the wrong answer with this index.
    Followed(usize),
    /// The opposite sign.
    Sign,
    /// The opposite direction.
    Opposite,
    /// The value in another unit than the required one.
    OtherUnit(&'static str),
    /// The value in another assembly.
    OtherAssembly,
    /// Wrong without a known cause.
    Wrong,
    /// An empty answer.
    Empty,
    /// Text that is not a number.
    Unreadable,
}

/// The cause of early rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoundedEarly {
    /// An earlier answer as it was written, by index.
    By(usize),
    /// Digits cut off instead of rounded.
    Cut,
    /// Too few digits in the answer itself.
    Coarse,
    /// The answer is close, and the cause is unknown.
    Near,
}

impl FigureVerdict {
    /// Returns `true` if the answer earns a point: right, rounded early, or consequential.
    #[must_use]
    pub fn earns_point(self) -> bool {
        matches!(
            self,
            FigureVerdict::Right | FigureVerdict::Rounded(_) | FigureVerdict::Followed(_)
        )
    }

    /// Returns the rank of a verdict. The interpretation with the lowest rank is chosen.
    pub(super) fn rank(self) -> u8 {
        match self {
            FigureVerdict::Right => 0,
            FigureVerdict::Rounded(_) => 1,
            FigureVerdict::Followed(_) => 2,
            FigureVerdict::Wrong | FigureVerdict::Empty | FigureVerdict::Unreadable => 4,
            _ => 3,
        }
    }
}

/// Minimum digits required of an answer, and maximum digits considered when it follows from others.
pub(super) const MIN_COUNT: i32 = 3;
pub(super) const MAX_COUNT: i32 = 6;
/// The relative difference that counts as rounding; for directions in radians.
const NEAR: f64 = 1e-3;
/// The fraction of the largest value of its kind below which a value counts as 0.
const NOUGHT: f64 = 1e-9;
/// The relative limit of half the last digit for answers with too few digits; the limit for
/// directions in degrees; and the largest direction accepted, in degrees.
const MAX_HALF_DIGIT: f64 = 0.05;
const DEGREE: f64 = 1.0;
const MAX_DISTANCE: f64 = 1e4;
/// Maximum relative effect of unwritten digits.
const CARRIED: f64 = 5e-3;
/// Relative allowance for converting a decimal to a double, and for comparisons.
const FUZZ: f64 = 1e-9;

/// The exact value of an answer.
#[derive(Clone, Copy)]
pub(super) struct Truth {
    exact: f64,
    bound: f64,
    scale: f64,
    is_direction: bool,
}

impl Truth {
    pub(super) fn of(figure: &RequiredValue) -> Truth {
        Truth {
            exact: figure.exact,
            bound: figure.bound.unwrap_or(0.0),
            scale: figure.scale,
            is_direction: figure.quantity.is_direction(),
        }
    }

    /// Returns another value of the same quantity.
    pub(super) fn with(self, exact: f64) -> Truth {
        Truth { exact, ..self }
    }

    /// Returns the difference of a value from the exact one; for directions within half a turn.
    pub(super) fn difference_from(&self, value: f64) -> f64 {
        let distance = value - self.exact;
        if self.is_direction {
            (distance + TURN / 2.0).rem_euclid(TURN) - TURN / 2.0
        } else {
            distance
        }
    }

    /// Returns the size that relative differences refer to.
    fn size(&self) -> f64 {
        match self.is_direction {
            true => 1_f64.to_degrees(),
            false if self.is_zero() => self.scale,
            false => self.exact.abs(),
        }
    }

    /// Returns the maximum effect of unwritten digits.
    pub(super) fn carried(&self) -> f64 {
        CARRIED * self.size()
    }

    fn is_zero(&self) -> bool {
        !self.is_direction && self.exact.abs() <= (NOUGHT * self.scale).max(self.bound)
    }

    /// Returns `true` for a direction of so many turns that its digits are lost.
    pub(super) fn is_out_of_reach(&self, written: WrittenFigure) -> bool {
        self.is_direction && written.value.abs() > MAX_DISTANCE
    }

    /// Returns `true` if the answer is the exact value rounded to its own digits, at least three,
    /// or within the bound.
    pub(super) fn is_right(&self, written: WrittenFigure) -> bool {
        let distance = self.difference_from(written.value).abs();
        if self.is_zero() && written.value == 0.0 {
            return true;
        }
        let is_bare = written.digits == 0 && !self.is_direction;
        let half = if is_bare {
            0.0
        } else {
            0.5 * self.last_of(written)
        };
        distance <= (half + FUZZ * half).max(self.bound)
    }

    /// Returns one unit of the last significant digit. A small direction is not more accurate than
    /// a large one.
    fn last_of(&self, written: WrittenFigure) -> f64 {
        let own = written.unit_of(MIN_COUNT, i32::MAX);
        // 0.5 deg has a digit, which is as accurate as the last one of 120.5 deg.
        if self.is_direction {
            let small = written.unit_of(0, i32::MAX).min(NEAR * self.size());
            own.max(small).min(DEGREE)
        } else {
            own
        }
    }

    pub(super) fn is_near(&self, value: f64) -> bool {
        self.difference_from(value).abs() <= NEAR * self.size()
    }

    /// Returns the cause of early rounding visible in the answer itself: digits cut off, or too few
    /// digits.
    pub(super) fn rounded(&self, written: WrittenFigure) -> Option<RoundedEarly> {
        let distance = self.difference_from(written.value);
        let own = 0.5 * written.unit_of(0, i32::MAX) * (1.0 + FUZZ);
        let coarsest = match self.is_direction {
            true => 0.5 * DEGREE,
            false => MAX_HALF_DIGIT * self.size(),
        };
        let is_coarse = (1..MIN_COUNT).contains(&written.digits) && own <= coarsest * (1.0 + FUZZ);
        if is_coarse && distance.abs() <= own {
            return Some(RoundedEarly::Coarse);
        }
        // Truncation moves a value towards 0.
        let is_smaller = distance * written.value < 0.0;
        (is_smaller && distance.abs() < self.last_of(written)).then_some(RoundedEarly::Cut)
    }

    /// Returns the probable mistake if no earlier answer explains the value.
    pub(super) fn mistaken(&self, written: WrittenFigure, unit: &str) -> Option<FigureVerdict> {
        let value = written.value;
        let half = 0.5 * written.unit_of(MIN_COUNT, i32::MAX) * (1.0 + FUZZ);
        let maximum = match self.is_direction {
            true => 0.5 * DEGREE,
            false => f64::INFINITY,
        };
        // Sign and unit of a zero are meaningless.
        let is_telling = !self.is_zero() && value != 0.0;
        let is_exact = |factor: f64| {
            is_telling
                && self.difference_from(value * factor).abs() <= (half * factor.abs()).min(maximum)
        };
        let units = other_units(unit);
        let exact_unit = units.iter().find(|(_, factor)| is_exact(*factor));
        // A small direction is close to its opposite, and to its value in another unit.
        if self.is_near(value) {
            return Some(match exact_unit {
                _ if is_exact(-1.0) => FigureVerdict::Sign,
                Some((unit, _)) => FigureVerdict::OtherUnit(unit),
                None => FigureVerdict::Rounded(RoundedEarly::Near),
            });
        }
        if !is_telling {
            return None;
        }
        let fits = |factor: f64| self.is_near(value * factor) || is_exact(factor);
        if fits(-1.0) {
            return Some(FigureVerdict::Sign);
        }
        if self.is_direction && self.is_near(value + TURN / 2.0) {
            return Some(FigureVerdict::Opposite);
        }
        let other = units.iter().find(|(_, factor)| fits(*factor));
        other.map(|(unit, _)| FigureVerdict::OtherUnit(unit))
    }
}
