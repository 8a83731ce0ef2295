//! What one figure says by itself, beside the exact one.

use super::{AskedFigure, WrittenFigure};
use crate::angle::TURN;
use crate::quantity::other_units;

/// What is to be said of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureVerdict {
    /// The exact figure, rounded to the digits that were written.
    Right,
    /// Right but for rounding on the way.
    Rounded(RoundedEarly),
    /// Right by this earlier figure, which is wrong: its number.
    Followed(usize),
    /// The opposite sign.
    Sign,
    /// A direction the other way round.
    Opposite,
    /// In another unit than it was asked for.
    OtherUnit(&'static str),
    /// Of another assembly.
    OtherAssembly,
    /// None of these.
    Wrong,
    /// Not answered.
    Empty,
    /// No figure.
    Unreadable,
}

/// What explains a figure that was rounded on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoundedEarly {
    /// An earlier figure, by its number, as it was written.
    By(usize),
    /// Digits that were cut off instead of rounded.
    Cut,
    /// It has too few digits itself.
    Coarse,
    /// Nothing that was written: it is near.
    Near,
}

impl FigureVerdict {
    /// Whether it is worth a point: right, but for rounding and for what was wrong before.
    #[must_use]
    pub fn is_worth_a_point(self) -> bool {
        matches!(
            self,
            FigureVerdict::Right | FigureVerdict::Rounded(_) | FigureVerdict::Followed(_)
        )
    }

    /// Where an answer may be read in several ways, the least of these is meant.
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

/// Digits that are asked of a figure at the least, and looked at when it follows from others.
pub(super) const FEWEST: i32 = 3;
pub(super) const MOST: i32 = 6;
/// What is nearer than this part is taken for rounding: of the figure itself, of a direction in radians.
const NEAR: f64 = 1e-3;
/// What is smaller than this part of the largest of its kind is 0.
const NOUGHT: f64 = 1e-9;
/// Too few digits are good enough where half of the last one is no more than this part; directions are told to a
/// degree at the least, and nobody turns so often.
const COARSEST: f64 = 0.05;
const DEGREE: f64 = 1.0;
const FARTHEST: f64 = 1e4;
/// More than this part is not done by digits that were carried on and not written.
const CARRIED: f64 = 5e-3;
/// The rounding of a decimal into a double, and of a comparison.
const FUZZ: f64 = 1e-9;

/// A figure as it should be.
#[derive(Clone, Copy)]
pub(super) struct Truth {
    exact: f64,
    bound: f64,
    scale: f64,
    is_direction: bool,
}

impl Truth {
    pub(super) fn of(figure: &AskedFigure) -> Truth {
        Truth {
            exact: figure.exact,
            bound: figure.bound.unwrap_or(0.0),
            scale: figure.scale,
            is_direction: figure.quantity.is_direction(),
        }
    }

    /// Another value of the same figure.
    pub(super) fn with(self, exact: f64) -> Truth {
        Truth { exact, ..self }
    }

    /// How far a value is from it, directions by less than half a turn.
    pub(super) fn apart(&self, value: f64) -> f64 {
        let apart = value - self.exact;
        if self.is_direction {
            (apart + TURN / 2.0).rem_euclid(TURN) - TURN / 2.0
        } else {
            apart
        }
    }

    /// The size by which nearness is measured.
    fn size(&self) -> f64 {
        match self.is_direction {
            true => 1_f64.to_degrees(),
            false if self.is_nought() => self.scale,
            false => self.exact.abs(),
        }
    }

    /// What digits that were carried on and not written may do to it at the most.
    pub(super) fn carried(&self) -> f64 {
        CARRIED * self.size()
    }

    fn is_nought(&self) -> bool {
        !self.is_direction && self.exact.abs() <= (NOUGHT * self.scale).max(self.bound)
    }

    /// Directions are the same after a turn, but of so many turns nothing is left of the digits.
    pub(super) fn is_out_of_reach(&self, written: WrittenFigure) -> bool {
        self.is_direction && written.value.abs() > FARTHEST
    }

    /// Whether it is the exact figure rounded to its own digits, three at the least, or within the bound.
    pub(super) fn is_right(&self, written: WrittenFigure) -> bool {
        let apart = self.apart(written.value).abs();
        if self.is_nought() && written.value == 0.0 {
            return true;
        }
        let is_bare = written.digits == 0 && !self.is_direction;
        let half = if is_bare {
            0.0
        } else {
            0.5 * self.last_of(written)
        };
        apart <= (half + FUZZ * half).max(self.bound)
    }

    /// One unit of the last digit that counts; a direction may be written small, and is not the more exact.
    fn last_of(&self, written: WrittenFigure) -> f64 {
        let own = written.unit_of(FEWEST, i32::MAX);
        // 0.5 deg has a digit; its last is no more exact than that of 120.5 deg would be.
        if self.is_direction {
            let small = written.unit_of(0, i32::MAX).min(NEAR * self.size());
            own.max(small).min(DEGREE)
        } else {
            own
        }
    }

    pub(super) fn is_near(&self, value: f64) -> bool {
        self.apart(value).abs() <= NEAR * self.size()
    }

    /// Rounding that the figure tells by itself: digits cut off, or too few of them.
    pub(super) fn rounded(&self, written: WrittenFigure) -> Option<RoundedEarly> {
        let apart = self.apart(written.value);
        let own = 0.5 * written.unit_of(0, i32::MAX) * (1.0 + FUZZ);
        let coarsest = match self.is_direction {
            true => 0.5 * DEGREE,
            false => COARSEST * self.size(),
        };
        let is_coarse = (1..FEWEST).contains(&written.digits) && own <= coarsest * (1.0 + FUZZ);
        if is_coarse && apart.abs() <= own {
            return Some(RoundedEarly::Coarse);
        }
        // Cut off, it is nearer to 0 than the exact figure.
        let is_smaller = apart * written.value < 0.0;
        (is_smaller && apart.abs() < self.last_of(written)).then_some(RoundedEarly::Cut)
    }

    /// What may have happened, where no earlier figure explains it.
    pub(super) fn mistaken(&self, written: WrittenFigure, unit: &str) -> Option<FigureVerdict> {
        let value = written.value;
        let half = 0.5 * written.unit_of(FEWEST, i32::MAX) * (1.0 + FUZZ);
        let most = match self.is_direction {
            true => 0.5 * DEGREE,
            false => f64::INFINITY,
        };
        // Nothing is to be told from 0 by its sign or its unit.
        let is_telling = !self.is_nought() && value != 0.0;
        let is_exact = |factor: f64| {
            is_telling && self.apart(value * factor).abs() <= (half * factor.abs()).min(most)
        };
        let units = other_units(unit);
        let exact_unit = units.iter().find(|(_, factor)| is_exact(*factor));
        // A small direction is near to what it is with the other sign, or in another unit.
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
