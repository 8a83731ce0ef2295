//! Formats values in formulas.

use super::expression::Expression;
use crate::page::Formula;
use crate::report::tables::index;
use crate::report::text::number::{concise, direction, significant};
use crate::solver::Order;
use crate::study::UnknownKind;

/// Significant digits, and the scene's unit of length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Figures {
    pub digits: usize,
    pub unit: &'static str,
}

/// Relative magnitude of rounding errors: a few roundings of a sum's terms.
const NOUGHT: f64 = 64.0 * f64::EPSILON;

impl Figures {
    /// Formats a computed value.
    pub(super) fn number(&self, value: f64) -> String {
        if value.is_finite() {
            significant(value, self.digits)
        } else {
            "-".into()
        }
    }

    /// Formats a value as 0 if it is a rounding error of values of this magnitude.
    pub(super) fn format_or_zero(&self, value: f64, size: f64) -> String {
        if value.abs() <= NOUGHT * size {
            "0".into()
        } else {
            self.number(value)
        }
    }

    /// Formats a computed length.
    pub(super) fn length(&self, value: f64) -> Formula {
        Formula::measured(self.number(value), self.unit)
    }

    /// Formats a computed length, or 0 for a rounding error of lengths of this magnitude.
    pub(super) fn length_or_zero(&self, value: f64, size: f64) -> Formula {
        Formula::measured(self.format_or_zero(value, size), self.unit)
    }

    /// Formats a square of lengths, or 0 for a rounding error of values of this magnitude.
    pub(super) fn area_or_zero(&self, value: f64, size: f64) -> Formula {
        Formula::measured(
            self.format_or_zero(value, size),
            &format!("{}^2", self.unit),
        )
    }

    /// Formats a value given by the scene, with no more digits than it has.
    pub(super) fn given(&self, value: f64) -> String {
        if value.is_finite() {
            concise(value, self.digits)
        } else {
            "-".into()
        }
    }

    /// Formats a direction in degrees from 0 to below 360.
    pub(super) fn direction(&self, degrees: f64) -> String {
        if !degrees.is_finite() {
            return "-".into();
        }
        let text = direction(crate::angle::wrapped(degrees), self.digits);
        let plain = concise(crate::angle::wrapped(degrees), self.digits);
        // A right angle is written without decimals.
        if plain.len() < text.len() {
            plain
        } else {
            text
        }
    }

    /// Formats an angle in degrees with its sign.
    pub(super) fn angle(&self, degrees: f64) -> String {
        if degrees.is_finite() {
            concise(degrees, self.digits)
        } else {
            "-".into()
        }
    }

    /// Returns a computed value with its symbol.
    pub(super) fn computed(&self, symbol: impl Into<Formula>, value: f64) -> Expression {
        Expression::known(symbol, self.number(value), value)
    }

    /// Returns a computed value with its symbol, written as 0 if it is a rounding error.
    pub(super) fn rounded(&self, symbol: impl Into<Formula>, value: f64, size: f64) -> Expression {
        Expression::known(symbol, self.format_or_zero(value, size), value)
    }

    /// Returns a value given by the scene with its symbol.
    pub(super) fn as_given(&self, symbol: impl Into<Formula>, value: f64) -> Expression {
        Expression::known(symbol, self.given(value), value)
    }

    /// Returns a direction in degrees with its symbol.
    pub(super) fn directed(&self, symbol: impl Into<Formula>, degrees: f64) -> Expression {
        Expression::known(symbol, self.direction(degrees), degrees)
    }

    /// Writes the sum of values without those that are 0 or rounding errors.
    pub(super) fn sum(&self, values: impl IntoIterator<Item = f64>, size: f64) -> Expression {
        let figures = values
            .into_iter()
            .map(|value| self.format_or_zero(value, size));
        Expression::sum(figures.filter_map(|figure| Expression::term(figure, None)))
    }

    /// Returns the unit of an unknown.
    pub(super) fn unit_of(&self, kind: UnknownKind) -> &'static str {
        match kind {
            UnknownKind::Angle => "deg",
            UnknownKind::Length => self.unit,
        }
    }

    /// Returns the unit of an unknown, or of its rate of an order.
    pub(super) fn rate_unit(&self, kind: UnknownKind, order: Order) -> String {
        match (order, kind) {
            (Order::Position, _) => self.unit_of(kind).to_owned(),
            (_, UnknownKind::Angle) => ["rad/s", "rad/s^2"][index(order) - 1].to_owned(),
            (_, UnknownKind::Length) => self.length_unit(index(order)),
        }
    }

    /// Returns the unit of a length or of its rate: `mm`, `mm/s`, `mm/s^2`.
    pub(super) fn length_unit(&self, order: usize) -> String {
        match order {
            0 => self.unit.to_owned(),
            1 => format!("{}/s", self.unit),
            _ => format!("{}/s^2", self.unit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIX: Figures = Figures {
        digits: 6,
        unit: "mm",
    };

    #[test]
    fn values_have_the_digits_of_their_kind() {
        assert_eq!(SIX.given(300.0), "300");
        assert_eq!(SIX.number(300.0), "300.000");
        assert_eq!(SIX.direction(180.0), "180");
        assert_eq!(SIX.direction(-69.247_478_774), "290.753");
        assert_eq!(SIX.direction(359.999_999_9), "0");
        assert_eq!(SIX.number(f64::NAN), "-");
        assert_eq!(SIX.format_or_zero(1e-14, 100.0), "0");
    }
}
