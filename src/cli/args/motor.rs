//! The motor over a cycle.

use super::{Format, OutputArgs, SceneArgs};
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct MotorArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    /// The torque in N m, or force in N, that the motor can keep up
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) rated: Option<f64>,
    /// The most that it can do for an instant
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) peak: Option<f64>,
    /// Its speed with a unit: '1500 rpm', '0.2 m/s'
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub(in crate::cli) speed: Option<String>,
    /// A flywheel on the driver's shaft, in kg m^2
    #[arg(long, value_name = "INERTIA", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) flywheel: Option<f64>,
    /// The wished fluctuation of the speed: greatest less least, by the mean
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) fluctuation: Option<f64>,
    /// The slide that is the ram [default: the one a press works at, or the only one]
    #[arg(long, value_name = "NAME")]
    pub(in crate::cli) ram: Option<String>,
    /// A height above the bottom of the ram, in the scene's unit
    #[arg(long, value_name = "LENGTH", value_parser = not_negative, allow_negative_numbers = true)]
    pub(in crate::cli) height: Option<f64>,
    /// The torque in N m, or force in N, for the force of the ram [default: the rated one]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) torque: Option<f64>,
    /// How far from its bottom a ram counts as at rest, in the scene's unit
    #[arg(long, value_name = "LENGTH", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) tolerance: Option<f64>,
    /// Go there and back from this coordinate of the driver [default: the whole motion]
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "to",
        allow_negative_numbers = true
    )]
    pub(in crate::cli) from: Option<f64>,
    /// To this one; where a driver turns, a lower one lies a turn further
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "from",
        allow_negative_numbers = true
    )]
    pub(in crate::cli) to: Option<f64>,
    /// How to write it; CSV has the cycle step by step
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(in crate::cli) format: Format,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

fn positive(text: &str) -> Result<f64, String> {
    let value = not_negative(text)?;
    let wrong = || words().must_be_positive().to_owned();
    (value > 0.0).then_some(value).ok_or_else(wrong)
}

fn not_negative(text: &str) -> Result<f64, String> {
    let value: f64 = text
        .parse()
        .map_err(|_| words().must_be_a_number().to_owned())?;
    let wrong = || words().must_not_be_negative().to_owned();
    (value.is_finite() && value >= 0.0)
        .then_some(value)
        .ok_or_else(wrong)
}
