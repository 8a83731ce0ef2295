//! Output formats of values, and the dialect of CSV.

use crate::cli::choice::{OptionValue, one_of, option_values};
use crate::cli::failure::Failure;
use crate::report::{CellSeparator, CsvDialect, DecimalMark, RowFormat};
use crate::scene::with_point;
use crate::wording::words;
use clap::{Args, ValueEnum};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum OutputFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
    #[value(help = words().format_json())]
    Json,
}

/// A page, or JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum TextOrJson {
    #[value(help = words().format_for_person())]
    Text,
    #[value(help = words().format_json())]
    Json,
}

#[derive(Debug, Args)]
pub(super) struct FigureArgs {
    #[arg(help = words().digits_of_tables())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(super) digits: u8,
    #[command(flatten)]
    pub(super) csv: CsvArgs,
    #[arg(help = words().leave_units_out())]
    #[arg(long)]
    pub(super) no_units: bool,
    #[arg(help = words().add_bounds())]
    #[arg(long)]
    pub(super) bounds: bool,
    #[arg(help = words().add_sensitivity())]
    #[arg(long)]
    pub(super) sensitivity: bool,
}

fn marks() -> Vec<OptionValue<DecimalMark>> {
    let about = [words().decimal_point(), words().decimal_comma()];
    option_values(DecimalMark::ALL, DecimalMark::name, about)
}

fn separators() -> Vec<OptionValue<CellSeparator>> {
    let about = [
        words().separator_comma(),
        words().separator_semicolon(),
        words().separator_tab(),
    ];
    option_values(CellSeparator::ALL, CellSeparator::name, about)
}

/// How CSV is written.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct CsvArgs {
    #[arg(help = words().decimal_of_csv())]
    #[arg(long, value_name = "MARK", value_parser = one_of(marks()))]
    decimal: Option<DecimalMark>,
    #[arg(help = words().separator_of_csv())]
    #[arg(long, value_name = "SEPARATOR", value_parser = one_of(separators()))]
    separator: Option<CellSeparator>,
}

impl CsvArgs {
    /// Returns the requested CSV dialect.
    ///
    /// # Errors
    /// Returns a usage error if an option is given although `format` is not CSV. Returns a usage error if the decimal
    /// mark and the separator are both a comma.
    pub(super) fn dialect(self, format: OutputFormat) -> Result<CsvDialect, Failure> {
        let requested = [
            self.decimal.map(|_| "--decimal"),
            self.separator.map(|_| "--separator"),
        ];
        match requested.into_iter().flatten().next() {
            Some(option) if format != OutputFormat::Csv => {
                Err(Failure::Usage(words().for_csv_alone(option)))
            }
            _ => CsvDialect::of(self.decimal.unwrap_or_default(), self.separator)
                .ok_or_else(|| Failure::Usage(words().comma_for_both().into())),
        }
    }

    /// Returns the format of rows, with so many digits in text.
    pub(super) fn rows(self, format: OutputFormat, digits: usize) -> Result<RowFormat, Failure> {
        let dialect = self.dialect(format)?;
        Ok(match format {
            OutputFormat::Csv => RowFormat::Csv(dialect),
            OutputFormat::Json => RowFormat::Json,
            OutputFormat::Text => RowFormat::Text { digits },
        })
    }
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let value = not_negative(text)?;
    let wrong = || words().must_be_positive().to_owned();
    (value > 0.0).then_some(value).ok_or_else(wrong)
}

pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    let value = number(text)?;
    let wrong = || words().must_not_be_negative().to_owned();
    (value.is_finite() && value >= 0.0)
        .then_some(value)
        .ok_or_else(wrong)
}

pub(super) fn number(text: &str) -> Result<f64, String> {
    let unclear = || words().digits_without_groups().to_owned();
    let text = with_point(text).ok_or_else(unclear)?;
    text.parse()
        .map_err(|_| words().must_be_a_number().to_owned())
}
