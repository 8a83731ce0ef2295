//! The motor that a scene is to be driven by.

use super::draft::Input;
use super::input::{self, PUSHED, TURNED};
use super::rate::{Degree, Kind};
use super::reader::{Reader, Value};
use super::{Scene, Unit, rate};
use crate::document::Diagnostic;
use toml::de::DeTable;

/// What the motor at the driver's shaft can do, and what is wished of the whole; for a driven slide the
/// cylinder or the linear motor.
///
/// Nothing of it changes how a mechanism moves or what its joints bear.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motor {
    /// What it gives without end: its rated torque in N m, for a driven slide its force in N.
    pub rated: Option<f64>,
    /// What it gives for a short while, in the same unit; not less than `rated`.
    pub peak: Option<f64>,
    /// The speed for which that holds: in rad/s, for a driven slide in the scene's unit per s.
    pub speed: Option<f64>,
    /// Moment of inertia of a flywheel on the driver's shaft, in kg m^2.
    pub flywheel: Option<f64>,
    /// The fluctuation of the speed that is wished: (greatest - least) / mean.
    pub fluctuation: Option<f64>,
    /// How far from the end of its stroke a ram still counts as at rest, in the scene's unit.
    pub tolerance: Option<f64>,
}

impl Scene {
    /// Reads a speed of the driver or of its motor from a text, as a scene writes it: `1500 rpm`,
    /// `15 rad/s`, `0.2 m/s`.
    ///
    /// # Errors
    /// What would be read.
    pub fn speed(&self, text: &str) -> Result<f64, String> {
        let kind = match self.mechanism.driver().input {
            crate::Input::Turn(_) => Kind::Turn,
            crate::Input::Push(_) => Kind::Push(self.unit),
        };
        rate::parse(text, kind, Degree::Speed).map_err(|_| {
            let units = rate::units(kind, Degree::Speed).join(", ");
            format!("`{text}` is no speed of this driver: a number with one of {units}")
        })
    }
}

const EXAMPLE: &str = r#"{ torque = 20, peak = 60, speed = "1500 rpm" }"#;
const KEYS: [&str; 7] = [
    "torque",
    "force",
    "peak",
    "speed",
    "flywheel",
    "fluctuation",
    "tolerance",
];
/// The keys that only a motor with a shaft has.
const OF_A_SHAFT: [&str; 3] = ["torque", "flywheel", "fluctuation"];

/// The section `[motor]`; what it may hold depends on what is driven.
pub(super) fn read<'v>(
    reader: &mut Reader<'_>,
    unit: Unit,
    driven: Option<&Input<'_>>,
    value: &'v Value<'v>,
) -> Option<Motor> {
    let table = reader.table("[motor]", EXAMPLE, value)?;
    reader.only("the motor", table, &KEYS);
    // Without a driver nothing can be said about its motor.
    let pushes = matches!(driven?, Input::Slide(_));
    misfits(reader, table, pushes);
    let (rated, size, kind) = if pushes {
        (PUSHED.effort, " (N)", Kind::Push(unit))
    } else {
        (TURNED.effort, " (N m)", Kind::Turn)
    };
    let mut positive = |key: &str, unit: &str| positive(reader, table, key, unit);
    let motor = Motor {
        rated: positive(rated, size),
        peak: positive("peak", size),
        flywheel: positive("flywheel", " (kg m^2)"),
        fluctuation: positive("fluctuation", ""),
        tolerance: positive("tolerance", ""),
        speed: input::rate(reader, "the motor", table, "speed", kind, Degree::Speed),
    };
    check(reader, table, rated, &motor);
    Some(motor)
}

/// Reports keys of a motor of the other kind.
fn misfits(reader: &mut Reader<'_>, table: &DeTable<'_>, pushes: bool) {
    for (key, _) in table {
        let text = key.get_ref().as_ref();
        let (what, help) = if pushes && text == "torque" {
            ("a slide is driven", "by a force: force = 2000 (N)")
        } else if pushes && OF_A_SHAFT.contains(&text) {
            ("a slide is driven", "without a shaft: leave it out")
        } else if !pushes && text == "force" {
            ("a link is driven", "by a torque: torque = 20 (N m)")
        } else {
            continue;
        };
        reader.report(
            Diagnostic::new(format!("the motor has no `{text}` where {what}"))
                .at(key.span(), "does not fit the driver")
                .help(format!("{what} {help}")),
        );
    }
}

fn positive(reader: &mut Reader<'_>, table: &DeTable<'_>, key: &str, unit: &str) -> Option<f64> {
    let value = table.get(key)?;
    let what = format!("`{key}` of the motor{unit}");
    let number = reader.number(&what, value)?;
    if number > 0.0 {
        return Some(number);
    }
    let literal = reader.literal(&value.span());
    reader.report(
        Diagnostic::new(format!("{what} must be positive, not {literal}"))
            .at(value.span(), "not positive")
            .help(format!(
                "leave `{key}` out where it is not known; what the motor gives has no sign"
            )),
    );
    None
}

/// What the numbers must be to each other.
fn check(reader: &mut Reader<'_>, table: &DeTable<'_>, rated: &str, motor: &Motor) {
    let mut fault = |key: &str, message: String, label: &str, help: &str| {
        let span = table.get(key).map(|value| value.span()).unwrap_or_default();
        reader.report(Diagnostic::new(message).at(span, label).help(help));
    };
    if let (Some(continuous), Some(peak)) = (motor.rated, motor.peak)
        && peak < continuous
    {
        let message = format!("`peak` of the motor is less than its `{rated}`");
        let help = "the peak is what it gives for a short while, at least as much as without end";
        fault("peak", message, "too small", help);
    }
    if motor.fluctuation.is_some_and(|share| share > 1.0) {
        let message = "`fluctuation` of the motor must be at most 1".to_owned();
        let help = "it is (greatest - least) / mean of the speed: 0.02 is 2 %";
        fault("fluctuation", message, "too large", help);
    }
    if motor.speed.is_some_and(|speed| speed <= 0.0) {
        let message = "`speed` of the motor must be positive".to_owned();
        let help = "leave `speed` out where it is not known; what the motor gives has no sign";
        fault("speed", message, "not positive", help);
    }
}
