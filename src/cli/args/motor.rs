//! Arguments of `krank motor`, which analyses the motor over a cycle.

use super::{CsvArgs, OutputArgs, OutputFormat, SceneArgs};
use crate::scene::with_point;
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct MotorArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().rated_effort())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) rated: Option<f64>,
    #[arg(help = words().peak_effort())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) peak: Option<f64>,
    #[arg(help = words().motor_speed())]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub(in crate::cli) speed: Option<String>,
    #[arg(help = words().flywheel_on_shaft())]
    #[arg(long, value_name = "INERTIA", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) flywheel: Option<f64>,
    #[arg(help = words().wished_fluctuation())]
    #[arg(long, value_name = "SHARE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) fluctuation: Option<f64>,
    #[arg(help = words().slide_of_ram())]
    #[arg(long, value_name = "NAME")]
    pub(in crate::cli) ram: Option<String>,
    #[arg(help = words().height_of_ram())]
    #[arg(long, value_name = "LENGTH", value_parser = not_negative, allow_negative_numbers = true)]
    pub(in crate::cli) height: Option<f64>,
    #[arg(help = words().effort_for_ram())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) torque: Option<f64>,
    #[arg(help = words().tolerance_of_rest())]
    #[arg(long, alias = "tolerance", value_name = "LENGTH", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) rest: Option<f64>,
    #[arg(help = words().there_and_back_from())]
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "to",
        value_parser = number,
        allow_negative_numbers = true
    )]
    pub(in crate::cli) from: Option<f64>,
    #[arg(help = words().there_and_back_to())]
    #[arg(
        long,
        value_name = "COORDINATE",
        requires = "from",
        value_parser = number,
        allow_negative_numbers = true
    )]
    pub(in crate::cli) to: Option<f64>,
    #[arg(help = words().how_to_write_motor())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let value = not_negative(text)?;
    let wrong = || words().must_be_positive().to_owned();
    (value > 0.0).then_some(value).ok_or_else(wrong)
}

fn not_negative(text: &str) -> Result<f64, String> {
    let value = number(text)?;
    let wrong = || words().must_not_be_negative().to_owned();
    (value.is_finite() && value >= 0.0)
        .then_some(value)
        .ok_or_else(wrong)
}

fn number(text: &str) -> Result<f64, String> {
    let unclear = || words().digits_without_groups().to_owned();
    let text = with_point(text).ok_or_else(unclear)?;
    text.parse()
        .map_err(|_| words().must_be_a_number().to_owned())
}
