//! Parses speeds and accelerations with units, as used for the driver.

use crate::expression::plain_unit;
use crate::scene::Unit;
use crate::scene::numbers::numeral::{self, are_thousands, number_length};
use crate::{Double, angle};
use std::borrow::Cow;
use std::f64::consts::PI;

/// The quantity whose rate is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RateKind {
    /// An angle: the result is in rad/s or rad/s^2.
    Turn,
    /// A length: the result is in the scene's unit per s or s^2.
    Push(Unit),
}

/// The order of the derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Degree {
    /// First derivative, per second.
    Speed,
    /// Second derivative, per second squared.
    Acceleration,
}

/// A rate in the units of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rate {
    pub(crate) value: f64,
    /// `true` if the value was converted from another unit, which rounds it.
    pub(crate) is_converted: bool,
    /// The typed value as a double-double, if known.
    pub(crate) typed: Option<Double>,
}

/// The reason why a text is not a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RateError<'t> {
    /// The text does not begin with a number.
    NoNumber,
    /// The number has no unit.
    NoUnit,
    /// The number has both a point and a comma, or one of them twice, so the decimal mark is
    /// ambiguous.
    TwoMarks,
    /// The unit is not one of [`units`].
    Unit(&'t str),
    /// The number, or its value in the scene's unit, is not finite.
    NotFinite,
}

/// Returns the supported units.
pub(crate) fn units(kind: RateKind, degree: Degree) -> &'static [&'static str] {
    match (kind, degree) {
        (RateKind::Turn, Degree::Speed) => &["rad/s", "deg/s", "rpm"],
        (RateKind::Turn, Degree::Acceleration) => &["rad/s^2", "deg/s^2"],
        (RateKind::Push(_), Degree::Speed) => &["mm/s", "cm/s", "m/s", "in/s"],
        (RateKind::Push(_), Degree::Acceleration) => &["mm/s^2", "cm/s^2", "m/s^2", "in/s^2"],
    }
}

/// Returns the unit that a text denotes, `rad/s` for `rd/sn` and `rpm` for `d/dk`; `None` for an
/// unknown unit.
pub(crate) fn known(kind: RateKind, degree: Degree, text: &str) -> Option<&'static str> {
    let plain = plain_unit(text);
    let units = units(kind, degree).iter();
    units.copied().find(|unit| *unit == plain)
}

/// Parses a number with a unit: `15 rad/s`, `143.2 rpm`, `0.05 m/s`, `15,5 rad/s`.
pub(crate) fn parse(text: &str, kind: RateKind, degree: Degree) -> Result<Rate, RateError<'_>> {
    let WrittenRate {
        number: written,
        unit,
    } = WrittenRate::of(text);
    let number: f64 = written.parse().map_err(|_| RateError::NoNumber)?;
    if unit.starts_with(['.', ',']) {
        return Err(RateError::TwoMarks);
    }
    if unit.is_empty() {
        return Err(RateError::NoUnit);
    }
    let unit = known(kind, degree, unit).ok_or(RateError::Unit(unit))?;
    let rate = match numeral::typed(&written) {
        Some(typed) => of(typed, unit, kind),
        None => Rate {
            typed: None,
            ..of(Double::exactly(number), unit, kind)
        },
    };
    let is_finite = rate.value.is_finite();
    is_finite.then_some(rate).ok_or(RateError::NotFinite)
}

/// Converts a double-double from one of its units.
pub(crate) fn of(number: Double, unit: &str, kind: RateKind) -> Rate {
    let converted = converted(number.hi, unit, kind);
    Rate {
        value: converted.unwrap_or(number.hi),
        is_converted: converted.is_some(),
        typed: Some(closely(number, unit, kind)),
    }
}

/// Splits a text into a formula and a trailing unit that applies to all of it: `2 * n rpm`. Returns
/// `None` if the text begins with a plain number.
pub(crate) fn formula(text: &str, kind: RateKind, degree: Degree) -> Option<(&str, &'static str)> {
    let text = text.trim();
    let ends = text.match_indices([' ', '\t', ')']);
    let headers = ends.filter_map(|(at, mark)| {
        let (head, unit) = text.split_at(at + mark.len());
        Some((head.trim(), known(kind, degree, unit)?))
    });
    let is_formula = |(head, _): &(&str, _)| {
        let plain = head.replace(',', ".");
        let is_number = head
            .chars()
            .all(|c| c.is_ascii_digit() || c == '.' || c == ',');
        // `nan` and `inf` are not names.
        !is_number && number_length(&plain) < plain.len() && plain.parse::<f64>().is_err()
    };
    headers.into_iter().find(is_formula)
}

/// A number and a unit as written in the file.
pub(crate) struct WrittenRate<'t> {
    /// The number with a decimal point, whether written with a point or a comma.
    pub(crate) number: Cow<'t, str>,
    pub(crate) unit: &'t str,
}

impl WrittenRate<'_> {
    /// Splits a text into the number at its beginning and the rest.
    pub(crate) fn of(text: &str) -> WrittenRate<'_> {
        let text = text.trim();
        // Replacing keeps the number of bytes, so the length applies to both texts.
        let length = number_length(&text.replace(',', "."));
        let (number, unit) = text.split_at(length);
        // `1,500` is ambiguous: fifteen hundred or one and a half. Reject it.
        let (number, unit) = match number.find(',').filter(|_| are_thousands(number)) {
            Some(comma) => text.split_at(comma),
            None => (number, unit),
        };
        let number = match number.contains(',') {
            true => number.replace(',', ".").into(),
            false => number.into(),
        };
        WrittenRate {
            number,
            unit: unit.trim(),
        }
    }
}

/// Converts to radians or the scene's unit; returns `None` if the number already has that unit.
fn converted(number: f64, unit: &str, kind: RateKind) -> Option<f64> {
    let base = unit.split('/').next().unwrap_or(unit);
    match kind {
        RateKind::Turn => match base {
            "deg" => Some(angle::radians(number)),
            "rpm" => Some(number / 30.0 * PI),
            _ => None,
        },
        RateKind::Push(scene) => {
            let from = Unit::ALL.into_iter().find(|u| u.symbol() == base);
            let from = from.filter(|from| *from != scene)?;
            Some(number * from.tenths_of_mm() / scene.tenths_of_mm())
        }
    }
}

/// Converts to radians or the scene's unit in double-double.
fn closely(number: Double, unit: &str, kind: RateKind) -> Double {
    let base = unit.split('/').next().unwrap_or(unit);
    match kind {
        RateKind::Turn => match base {
            "deg" => number * Double::RADIAN,
            "rpm" => number * Double::exactly(6.0) * Double::RADIAN,
            _ => number,
        },
        RateKind::Push(scene) => {
            let from = Unit::ALL.into_iter().find(|u| u.symbol() == base);
            let [from, to] =
                [from.unwrap_or(scene), scene].map(|u| Double::exactly(u.tenths_of_mm()));
            number * from / to
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PUSH: RateKind = RateKind::Push(Unit::Millimetre);

    #[test]
    fn parse_accepts_every_listed_unit() {
        for kind in [RateKind::Turn, PUSH] {
            for degree in [Degree::Speed, Degree::Acceleration] {
                for unit in units(kind, degree) {
                    let value = parse(&format!("2 {unit}"), kind, degree).unwrap().value;
                    assert!(value > 0.0, "{unit}");
                }
            }
        }
    }

    #[test]
    fn parse_converts_spellings_and_units() {
        let turn = |text| parse(text, RateKind::Turn, Degree::Speed).unwrap().value;
        assert_eq!(turn("15 rad/s"), 15.0);
        assert_eq!(turn("-1.5e1rad/s"), -15.0);
        assert_eq!(turn(" 60  rpm "), 2.0 * PI);
        assert_eq!(turn("180 deg/s"), PI);
        assert_eq!(turn("180 derece/sn"), PI);
        assert_eq!(turn("180°/s"), PI);
        assert_eq!(turn("60 d/dk"), 2.0 * PI);
        assert_eq!(turn("60 dev/dk"), 2.0 * PI);
        assert_eq!(turn("15 rd/s"), 15.0);
        assert_eq!(turn("15,5 radyan / saniye"), 15.5);
        assert_eq!(turn("15,5 rad/s"), 15.5);
        assert_eq!(turn("-,5e1 rad/s"), -5.0);
        let push = |text| parse(text, PUSH, Degree::Speed).unwrap().value;
        assert_eq!(push("0.05 m/s"), 50.0);
        assert_eq!(push("0,05 m/sn"), 50.0);
        assert_eq!(push("2 in/s"), 50.8);
        assert_eq!(push("5 cm/s"), 50.0);
        assert_eq!(push(".5 mm/s"), 0.5);
        assert_eq!(push("0 m/s"), 0.0);
        let metres = RateKind::Push(Unit::Metre);
        let rate = parse("50 mm/s^2", metres, Degree::Acceleration).unwrap();
        assert_eq!((rate.value, rate.is_converted), (0.05, true));
        let rate = parse("50 m/s^2", metres, Degree::Acceleration).unwrap();
        assert_eq!((rate.value, rate.is_converted), (50.0, false));
    }

    #[test]
    fn formula_splits_off_trailing_unit() {
        let turn = |text| formula(text, RateKind::Turn, Degree::Speed);
        assert_eq!(turn(" 2 * n rpm "), Some(("2 * n", "rpm")));
        assert_eq!(turn("(n + 1)rad/s"), Some(("(n + 1)", "rad/s")));
        assert_eq!(turn("2 * n dev / dk"), Some(("2 * n", "rpm")));
        assert_eq!(turn("(n)rd/sn"), Some(("(n)", "rad/s")));
        for plain in [
            "15 rad/s",
            "15,5 rpm",
            "1e3 deg/s",
            "n",
            "nrpm",
            "nan rpm",
            "rpm",
            "n mm/s",
        ] {
            assert_eq!(turn(plain), None, "{plain}");
        }
        let push = formula("v mm/s", PUSH, Degree::Speed);
        assert_eq!(push, Some(("v", "mm/s")));
    }

    #[test]
    fn parse_reports_why_a_rate_is_invalid() {
        let turn = |text| parse(text, RateKind::Turn, Degree::Speed);
        assert_eq!(turn("15"), Err(RateError::NoUnit));
        assert_eq!(turn(""), Err(RateError::NoNumber));
        assert_eq!(turn("fast"), Err(RateError::NoNumber));
        assert_eq!(turn("nan rad/s"), Err(RateError::NoNumber));
        assert_eq!(turn("inf rad/s"), Err(RateError::NoNumber));
        assert_eq!(turn("1e400 rad/s"), Err(RateError::NotFinite));
        for two in [
            "1,500", "-12,345", "1,234.5", "1.234,5", "1,234,5", "1.2.3", "1,,5",
        ] {
            let two = format!("{two} rad/s");
            let read = parse(&two, RateKind::Turn, Degree::Speed);
            assert_eq!(read, Err(RateError::TwoMarks), "{two}");
        }
        assert_eq!(turn("15 mm/s"), Err(RateError::Unit("mm/s")));
        assert_eq!(turn("1e rad/s"), Err(RateError::Unit("e rad/s")));
        assert_eq!(turn("15 rad/s^2"), Err(RateError::Unit("rad/s^2")));
        assert_eq!(turn("\u{bd} rpm"), Err(RateError::NoNumber));
    }
}
