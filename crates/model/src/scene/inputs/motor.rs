//! The motor that is to drive a scene.

use crate::document::{Diagnostic, WrittenValue};
use crate::scene::inputs::input::{self, DraftInput, PUSHED, TURNED};
use crate::scene::numbers::rate;
use crate::scene::numbers::rate::{Degree, RateKind};
use crate::scene::numbers::reader::{ByteSpan, Reader};
use crate::scene::table::KeyTable;
use crate::scene::{Scene, Unit, keys};
use crate::wording::words;

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

/// Reads the section; its permitted keys depend on the kind of driver.
pub(crate) fn read(
    reader: &mut Reader<'_>,
    unit: Unit,
    driven: Option<&DraftInput<'_>>,
    value: &WrittenValue<'_>,
) -> Option<Motor> {
    let names = ["[motor]", words().the_motor()];
    let mut table = reader.open(names, keys::MOTOR, EXAMPLE, value)?;
    reader.only_known(&table);
    // Without a driver, the keys of its motor cannot be checked.
    table.is_rotary = matches!(driven?, DraftInput::Link(_));
    misfits(reader, &table);
    let (form, kind) = match table.is_rotary {
        true => (TURNED, RateKind::Turn),
        false => (PUSHED, RateKind::Push(unit)),
    };
    let table = &table;
    let mut number = |key: &str| reader.number_of(table, key);
    let motor = Motor {
        rated: number(form.effort),
        peak: number("peak"),
        flywheel: number("flywheel"),
        fluctuation: number("fluctuation"),
        rest: number(match table.has("rest") {
            true => "rest",
            // The former name.
            false => "tolerance",
        }),
        speed: input::rate(reader, table, "speed", kind, Degree::Speed).map(|rate| rate.value),
    };
    check(reader, table, form.effort, &motor);
    Some(motor)
}

/// Reports keys of a motor of the other kind.
fn misfits(reader: &mut Reader<'_>, table: &KeyTable<'_>) {
    let form = if table.is_rotary { TURNED } else { PUSHED };
    for key in table.strays(form.driven) {
        let (message, help) = match key.text {
            "torque" => (
                words().motor_of_slide_has_no(key.text),
                words().slide_has_force(),
            ),
            "force" => (
                words().motor_of_link_has_no(key.text),
                words().link_has_torque(),
            ),
            _ => (
                words().motor_of_slide_has_no(key.text),
                words().slide_has_no_shaft(),
            ),
        };
        reader.report(
            Diagnostic::new(message)
                .at(key.span, words().does_not_fit_driver())
                .help(help),
        );
    }
}

/// Checks the relations between the numbers.
fn check(reader: &mut Reader<'_>, table: &KeyTable<'_>, rated: &str, motor: &Motor) {
    let place = |key: &str| table.get(key).map(WrittenValue::span).unwrap_or_default();
    let mut fault = |span: ByteSpan, message: String, label: &str, help: &str| {
        reader.report(Diagnostic::new(message).at(span, label).help(help));
    };
    if table.has("rest") && table.has("tolerance") {
        let message = words().rest_of_motor_given_twice().to_owned();
        let (label, help) = (
            words().is_old_name_of_rest(),
            words().leave_old_name_of_rest_out(),
        );
        fault(place("tolerance"), message, label, help);
    }
    if let (Some(continuous), Some(peak)) = (motor.rated, motor.peak)
        && peak < continuous
    {
        let message = words().peak_of_motor_too_small(rated);
        let help = words().peak_is_for_short();
        fault(place("peak"), message, words().is_too_small(), help);
    }
    if let Some(share) = motor.fluctuation
        && share > 1.0
    {
        // (w - 0) / (w / 2) = 2: the minimum speed is zero, and a larger value is impossible.
        let message = match share > 2.0 {
            true => words().fluctuation_of_motor_impossible().to_owned(),
            false => words().fluctuation_of_motor_too_large().to_owned(),
        };
        let help = words().what_fluctuation_is();
        fault(place("fluctuation"), message, words().is_too_large(), help);
    }
    if motor.speed.is_some_and(|speed| speed <= 0.0) {
        let message = words().speed_of_motor_not_positive().to_owned();
        let help = words().leave_unknown_out("speed");
        fault(place("speed"), message, words().is_not_positive(), &help);
    }
}
