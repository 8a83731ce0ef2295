//! What one figure says by itself, beside the exact one.

use super::{AskedFigure, WrittenFigure};
use crate::angle::TURN;

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

/// Digits that are asked of a figure at the least, and looked at when it follows from others.
pub(super) const FEWEST: i32 = 3;
pub(super) const MOST: i32 = 6;
/// What is nearer than this part is taken for rounding: of the figure itself, of a direction in radians.
const NEAR: f64 = 1e-3;
/// What is smaller than this part of the largest of its kind is 0.
const NOUGHT: f64 = 1e-9;
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

    fn is_nought(&self) -> bool {
        !self.is_direction && self.exact.abs() <= NOUGHT * self.scale
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
            own.max(written.unit_of(0, i32::MAX).min(NEAR * self.size()))
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
        if (1..FEWEST).contains(&written.digits) && apart.abs() <= own {
            return Some(RoundedEarly::Coarse);
        }
        // Cut off, it is nearer to 0 than the exact figure.
        let is_smaller = apart * written.value < 0.0;
        (is_smaller && apart.abs() < self.last_of(written)).then_some(RoundedEarly::Cut)
    }

    /// What may have happened, where no earlier figure explains it.
    pub(super) fn mistaken(&self, written: WrittenFigure, unit: &str) -> Option<FigureVerdict> {
        let value = written.value;
        if self.is_near(value) {
            return Some(FigureVerdict::Rounded(RoundedEarly::Near));
        }
        // Nothing is to be told from 0 by its sign or its unit.
        if self.is_nought() || value == 0.0 {
            return None;
        }
        let fits = |value: f64, factor: f64| {
            let half = 0.5 * written.unit_of(FEWEST, i32::MAX) * factor.abs();
            self.is_near(value * factor) || self.apart(value * factor).abs() <= half
        };
        if fits(value, -1.0) {
            return Some(FigureVerdict::Sign);
        }
        if self.is_direction && self.is_near(value + TURN / 2.0) {
            return Some(FigureVerdict::Opposite);
        }
        let mut units = unit_factors(unit).into_iter();
        let other = units.find(|(_, factor)| fits(value, *factor));
        other.map(|(unit, _)| FigureVerdict::OtherUnit(unit))
    }
}

/// Units in which a figure may have been written instead of its own, and by how much it is to be multiplied then.
pub(super) fn unit_factors(unit: &str) -> Vec<(&'static str, f64)> {
    let degree = 1_f64.to_degrees();
    let turning = match unit {
        "deg" => vec![("rad", degree)],
        "rad/s" => vec![
            ("deg/s", 1.0 / degree),
            ("rpm", std::f64::consts::TAU / 60.0),
        ],
        "rad/s^2" => vec![("deg/s^2", 1.0 / degree)],
        _ => Vec::new(),
    };
    if !turning.is_empty() {
        return turning;
    }
    // Tenths of a millimetre.
    const LENGTHS: [(&str, [&str; 3], f64); 4] = [
        ("mm", ["mm", "mm/s", "mm/s^2"], 10.0),
        ("cm", ["cm", "cm/s", "cm/s^2"], 100.0),
        ("m", ["m", "m/s", "m/s^2"], 10_000.0),
        ("in", ["in", "in/s", "in/s^2"], 254.0),
    ];
    let own = LENGTHS.iter().find_map(|(_, names, size)| {
        let order = names.iter().position(|name| *name == unit)?;
        Some((order, *size))
    });
    let Some((order, size)) = own else {
        return Vec::new();
    };
    let others = LENGTHS.iter().filter(|(_, names, _)| names[order] != unit);
    others
        .map(|(_, names, other)| (names[order], other / size))
        .collect()
}
