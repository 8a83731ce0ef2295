//! Formats values in formulas.

use crate::report::text::number::{concise, direction, significant};

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

    /// Returns the unit of a length or of its rate: `mm`, `mm/s`, `mm/s^2`.
    pub(super) fn length_unit(&self, order: usize) -> String {
        match order {
            0 => self.unit.to_owned(),
            1 => format!("{}/s", self.unit),
            _ => format!("{}/s^2", self.unit),
        }
    }
}

/// A sum in written form, each term with its sign.
#[derive(Clone, Debug, Default)]
pub(super) struct WrittenSum(String);

impl WrittenSum {
    pub(super) fn push(&mut self, negative: bool, term: &str) {
        self.0 += match (self.0.is_empty(), negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        self.0 += term;
    }

    /// Adds a formatted value with its own sign.
    pub(super) fn push_figure(&mut self, text: &str) {
        match text.strip_prefix('-') {
            Some(size) if !size.is_empty() => self.push(true, size),
            _ => self.push(false, text),
        }
    }

    /// Returns the sum; 0 if it has no terms.
    pub(super) fn text(self) -> String {
        if self.0.is_empty() {
            "0".into()
        } else {
            self.0
        }
    }
}

/// Returns a formatted value as a factor, in brackets if it is negative.
pub(super) fn factor(text: &str) -> String {
    if text.starts_with('-') && text.len() > 1 {
        format!("({text})")
    } else {
        text.to_owned()
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
    fn sum_has_signs_between_terms() {
        let mut sum = WrittenSum::default();
        sum.push(true, "r1");
        sum.push(false, "r2");
        sum.push_figure("-3.5");
        sum.push_figure("2");
        assert_eq!(sum.text(), "-r1 + r2 - 3.5 + 2");
        assert_eq!(WrittenSum::default().text(), "0");
        assert_eq!(factor("-2"), "(-2)");
    }

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
