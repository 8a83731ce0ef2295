//! Converts between the units in which quantities are written.

use crate::expression::plain_unit;
use crate::scene::Unit;

/// The units in which a quantity may be written instead of its own.
const NAMES: [&str; 19] = [
    "rad", "deg", "rad/s", "deg/s", "rpm", "rad/s^2", "deg/s^2", "mm", "cm", "m", "in", "mm/s",
    "cm/s", "m/s", "in/s", "mm/s^2", "cm/s^2", "m/s^2", "in/s^2",
];

/// The dimension of a unit, apart from the powers of time in its denominator.
#[derive(Clone, Copy, PartialEq)]
enum UnitMeasure {
    Turning,
    Length,
}

/// Returns the factor that converts from one unit to another; `None` if their dimensions differ or
/// one is unknown. An empty `from` counts as the other unit.
#[must_use]
pub fn unit_factor(from: &str, to: &str) -> Option<f64> {
    let plain = plain_unit(from);
    if plain.is_empty() || plain == to {
        return Some(1.0);
    }
    let (from, from_rate) = parted(&plain);
    let (to, to_rate) = parted(to);
    if from_rate != to_rate {
        return None;
    }
    if from == to {
        return Some(1.0);
    }
    let ((measure, size), (other, complete)) = (size(from)?, size(to)?);
    (measure == other).then_some(size / complete)
}

/// Returns the units in which a quantity may be written instead of its own, with the factors that
/// convert them.
#[must_use]
pub fn other_units(unit: &str) -> Vec<(&'static str, f64)> {
    let others = NAMES.into_iter().filter(|name| *name != unit);
    others
        .filter_map(|name| Some((name, unit_factor(name, unit)?)))
        .collect()
}

/// Returns the unit of the time derivative; that of degrees is rad/s, as everywhere in krank.
#[must_use]
pub fn rate_unit(unit: &str) -> String {
    match unit.strip_suffix("/s") {
        Some(head) => format!("{head}/s^2"),
        None if unit.is_empty() => "1/s".into(),
        None if unit == "deg" => "rad/s".into(),
        None => format!("{unit}/s"),
    }
}

/// Returns the unit with this spelling, if it is a convertible one.
#[must_use]
pub fn known_unit(unit: &str) -> Option<&'static str> {
    let plain = plain_unit(unit);
    NAMES.into_iter().find(|name| *name == plain)
}

/// Splits a unit into its numerator and the powers of time in its denominator.
fn parted(unit: &str) -> (&str, &str) {
    match unit {
        "rpm" => ("rpm", "s"),
        unit => unit.split_once('/').unwrap_or((unit, "")),
    }
}

/// Returns the dimension and size of a unit, in degrees or in tenths of a millimetre. For rpm, the
/// size is degrees per second.
fn size(head: &str) -> Option<(UnitMeasure, f64)> {
    match head {
        "deg" => Some((UnitMeasure::Turning, 1.0)),
        "rad" => Some((UnitMeasure::Turning, 1_f64.to_degrees())),
        "rpm" => Some((UnitMeasure::Turning, crate::angle::TURN / 60.0)),
        head => {
            let unit = Unit::ALL.into_iter().find(|unit| unit.symbol() == head)?;
            Some((UnitMeasure::Length, unit.tenths_of_mm()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_factor_converts_only_within_one_measure() {
        for (from, to, factor) in [
            ("", "mm", 1.0),
            ("cm/s2", "mm/s^2", 10.0),
            ("m/s²", "mm/s^2", 1000.0),
            ("in", "mm", 25.4),
            ("rd/s", "rad/s", 1.0),
            ("rad/sn", "rad/s", 1.0),
            ("mm/sn^2", "mm/s^2", 1.0),
            ("rad", "deg", 1_f64.to_degrees()),
            ("°", "deg", 1.0),
            ("rpm", "deg/s", 6.0),
            ("d/dk", "deg/s", 6.0),
            ("dev/dk", "rpm", 1.0),
            ("derece", "deg", 1.0),
            ("der", "deg", 1.0),
            ("radyan", "rad", 1.0),
            ("mm/sn", "cm/s", 0.1),
            ("N", "N", 1.0),
        ] {
            assert_eq!(unit_factor(from, to), Some(factor), "{from} {to}");
        }
        let rpm = unit_factor("rpm", "rad/s").unwrap();
        assert!((rpm - std::f64::consts::TAU / 60.0).abs() < 1e-16);
        for (from, to) in [
            ("mm", "mm/s"),
            ("deg", "mm"),
            ("rpm", "deg"),
            ("furlong", "mm"),
            ("kg", "N"),
        ] {
            assert_eq!(unit_factor(from, to), None, "{from} {to}");
        }
    }

    #[test]
    fn other_units_lists_units_of_equal_measure() {
        let names = |unit| -> Vec<&str> { other_units(unit).into_iter().map(|(n, _)| n).collect() };
        assert_eq!(names("deg"), ["rad"]);
        assert_eq!(names("rad/s"), ["deg/s", "rpm"]);
        assert_eq!(names("mm/s"), ["cm/s", "m/s", "in/s"]);
        assert_eq!(names("N"), [""; 0]);
        assert_eq!(known_unit("mm/s"), Some("mm/s"));
        assert_eq!(known_unit("N"), None);
    }
}
