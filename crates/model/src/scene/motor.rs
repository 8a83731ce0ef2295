//! The motor that is to drive a scene.

use super::input::{self, DraftInput, PUSHED, TURNED};
use super::rate::{Degree, RateKind};
use super::reader::{ByteSpan, Reader};
use super::{Scene, Unit, keys, rate};
use crate::document::{Diagnostic, Lenient, WrittenKey};
use crate::wording::words;
use serde::Deserialize;

/// The capabilities of the motor at the driver's shaft, and the requirements on the drive. For a
/// driven slide it is a cylinder or a linear motor.
///
/// Nothing here changes the motion of the mechanism or the reactions in its joints.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motor {
    /// The continuous rating: torque in N m, or force in N for a driven slide.
    pub rated: Option<f64>,
    /// The peak for short times, in the same unit; not less than `rated`.
    pub peak: Option<f64>,
    /// The rated speed in rad/s, or in the scene's unit per s for a driven slide.
    pub speed: Option<f64>,
    /// Moment of inertia of a flywheel on the driver's shaft, in kg m^2.
    pub flywheel: Option<f64>,
    /// The required fluctuation of the speed: (maximum - minimum) / mean.
    pub fluctuation: Option<f64>,
    /// Maximum distance from the end of its stroke at which a ram counts as at rest, in the scene's
    /// unit.
    pub rest: Option<f64>,
}

impl Scene {
    /// Parses a speed of the driver or of its motor as a scene writes it: `1500 rpm`, `15 rad/s`,
    /// `0.2 m/s`.
    ///
    /// # Errors
    /// Returns a message with the supported units.
    pub fn speed(&self, text: &str) -> Result<f64, String> {
        let kind = match self.mechanism.driver().input {
            crate::Input::Turn(_) => RateKind::Turn,
            crate::Input::Push(_) => RateKind::Push(self.unit),
        };
        let rate = rate::parse(text, kind, Degree::Speed);
        rate.map(|rate| rate.value).map_err(|_| {
            let units = rate::units(kind, Degree::Speed).join(", ");
            words().no_speed_of_driver(text, &units)
        })
    }
}

const EXAMPLE: &str = r#"{ torque = 20, peak = 60, speed = "1500 rpm" }"#;

/// The section `[motor]` as written.
#[derive(Debug, Deserialize)]
pub(super) struct MotorTable {
    torque: Option<Lenient<f64>>,
    force: Option<Lenient<f64>>,
    peak: Option<Lenient<f64>>,
    speed: Option<Lenient<String>>,
    flywheel: Option<Lenient<f64>>,
    fluctuation: Option<Lenient<f64>>,
    rest: Option<Lenient<f64>>,
    /// The former name of `rest`.
    tolerance: Option<Lenient<f64>>,
}

/// Reads the section; its permitted keys depend on the kind of driver.
pub(super) fn read(
    reader: &mut Reader<'_>,
    unit: Unit,
    driven: Option<&DraftInput<'_>>,
    value: &Lenient<MotorTable>,
) -> Option<Motor> {
    let table = reader.table("[motor]", EXAMPLE, value)?;
    reader.only(words().the_motor(), value);
    // Without a driver, the keys of its motor cannot be checked.
    let pushes = matches!(driven?, DraftInput::Slide(_));
    misfits(reader, &value.keys, pushes);
    let (form, rated, size, kind) = if pushes {
        (PUSHED, &table.force, " (N)", RateKind::Push(unit))
    } else {
        (TURNED, &table.torque, " (N m)", RateKind::Turn)
    };
    let mut positive = |key: &str, unit: &str, value: &Option<Lenient<f64>>| {
        positive(reader, key, unit, value.as_ref()?)
    };
    let motor = Motor {
        rated: positive(form.effort, size, rated),
        peak: positive("peak", size, &table.peak),
        flywheel: positive("flywheel", " (kg m^2)", &table.flywheel),
        fluctuation: positive("fluctuation", "", &table.fluctuation),
        rest: match &table.rest {
            Some(_) => positive("rest", "", &table.rest),
            None => positive("tolerance", "", &table.tolerance),
        },
        speed: table.speed.as_ref().and_then(|speed| {
            let rate = input::rate(
                reader,
                words().the_motor(),
                "speed",
                kind,
                Degree::Speed,
                speed,
            );
            rate.map(|rate| rate.value)
        }),
    };
    check(reader, table, form.effort, &motor);
    Some(motor)
}

/// Reports keys of a motor of the other kind.
fn misfits(reader: &mut Reader<'_>, given: &[WrittenKey], pushes: bool) {
    let driven = if pushes { PUSHED.driven } else { TURNED.driven };
    let fitting = keys::of(keys::MOTOR, driven);
    for key in given {
        let text = key.get_ref().as_str();
        if fitting.contains(&text) || keys::find(keys::MOTOR, text).is_none() {
            continue;
        }
        let (message, help) = match text {
            "torque" => (
                words().motor_of_slide_has_no(text),
                words().slide_has_force(),
            ),
            "force" => (
                words().motor_of_link_has_no(text),
                words().link_has_torque(),
            ),
            _ => (
                words().motor_of_slide_has_no(text),
                words().slide_has_no_shaft(),
            ),
        };
        reader.report(
            Diagnostic::new(message)
                .at(key.span(), words().does_not_fit_driver())
                .help(help),
        );
    }
}

fn positive(reader: &mut Reader<'_>, key: &str, unit: &str, value: &Lenient<f64>) -> Option<f64> {
    let what = words().key_of(key, words().the_motor()) + unit;
    let number = reader.number(&what, value)?;
    if number > 0.0 {
        return Some(number);
    }
    let literal = reader.literal(&value.span);
    reader.report(
        Diagnostic::new(words().must_be(&what, words().positive(), &literal))
            .at(value.span.clone(), words().is_not_positive())
            .help(words().leave_unknown_out(key)),
    );
    None
}

/// Checks the relations between the numbers.
fn check(reader: &mut Reader<'_>, table: &MotorTable, rated: &str, motor: &Motor) {
    let mut fault = |span: ByteSpan, message: String, label: &str, help: &str| {
        reader.report(Diagnostic::new(message).at(span, label).help(help));
    };
    if table.rest.is_some() && table.tolerance.is_some() {
        let message = words().rest_of_motor_given_twice().to_owned();
        let help = words().leave_old_name_of_rest_out();
        fault(
            place(&table.tolerance),
            message,
            words().is_old_name_of_rest(),
            help,
        );
    }
    if let (Some(continuous), Some(peak)) = (motor.rated, motor.peak)
        && peak < continuous
    {
        let message = words().peak_of_motor_too_small(rated);
        let help = words().peak_is_for_short();
        fault(place(&table.peak), message, words().is_too_small(), help);
    }
    if motor.fluctuation.is_some_and(|share| share > 1.0) {
        let message = match motor.fluctuation {
            // (w - 0) / (w / 2) = 2: the minimum speed is zero, and a larger value is impossible.
            Some(share) if share > 2.0 => words().fluctuation_of_motor_impossible().to_owned(),
            _ => words().fluctuation_of_motor_too_large().to_owned(),
        };
        let help = words().what_fluctuation_is();
        fault(
            place(&table.fluctuation),
            message,
            words().is_too_large(),
            help,
        );
    }
    if motor.speed.is_some_and(|speed| speed <= 0.0) {
        let message = words().speed_of_motor_not_positive().to_owned();
        let help = words().leave_unknown_out("speed");
        fault(
            place(&table.speed),
            message,
            words().is_not_positive(),
            &help,
        );
    }
}

fn place<T>(value: &Option<Lenient<T>>) -> ByteSpan {
    let span = value.as_ref().map(|value| value.span.clone());
    span.unwrap_or_default()
}
