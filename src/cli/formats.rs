//! Options for CSV output: the decimal mark and the separator of cells.

use super::OutputFormat;
use crate::cli::failure::Failure;
use crate::report::{CellSeparator, CsvDialect, DecimalMark, RowFormat};
use crate::wording::words;
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};

/// How CSV is written.
#[derive(Clone, Copy, Debug, Args)]
pub(in crate::cli) struct CsvArgs {
    #[arg(help = words().decimal_of_csv())]
    #[arg(long, value_name = "MARK", value_enum)]
    decimal: Option<DecimalMark>,
    #[arg(help = words().separator_of_csv())]
    #[arg(long, value_name = "SEPARATOR", value_enum)]
    separator: Option<CellSeparator>,
}

impl CsvArgs {
    /// Returns the requested CSV dialect.
    ///
    /// # Errors
    /// Returns a usage error if an option is given although `format` is not CSV. Returns a usage error if the decimal
    /// mark and the separator are both a comma.
    pub(in crate::cli) fn dialect(self, format: OutputFormat) -> Result<CsvDialect, Failure> {
        let asked = [
            self.decimal.map(|_| "--decimal"),
            self.separator.map(|_| "--separator"),
        ];
        match asked.into_iter().flatten().next() {
            Some(option) if format != OutputFormat::Csv => {
                Err(Failure::Usage(words().for_csv_alone(option)))
            }
            _ => CsvDialect::of(self.decimal.unwrap_or_default(), self.separator)
                .ok_or_else(|| Failure::Usage(words().comma_for_both().into())),
        }
    }
}

impl CsvArgs {
    /// Returns the format of rows, with so many digits in text.
    pub(in crate::cli) fn rows(
        self,
        format: OutputFormat,
        digits: usize,
    ) -> Result<RowFormat, Failure> {
        let dialect = self.dialect(format)?;
        Ok(match format {
            OutputFormat::Csv => RowFormat::Csv(dialect),
            OutputFormat::Json => RowFormat::Json,
            OutputFormat::Text => RowFormat::Text { digits },
        })
    }
}

impl ValueEnum for DecimalMark {
    fn value_variants<'a>() -> &'a [DecimalMark] {
        &DecimalMark::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let about = match self {
            DecimalMark::Point => words().decimal_point(),
            DecimalMark::Comma => words().decimal_comma(),
        };
        Some(PossibleValue::new(self.name()).help(about))
    }
}

impl ValueEnum for CellSeparator {
    fn value_variants<'a>() -> &'a [CellSeparator] {
        &CellSeparator::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let about = match self {
            CellSeparator::Comma => words().separator_comma(),
            CellSeparator::Semicolon => words().separator_semicolon(),
            CellSeparator::Tab => words().separator_tab(),
        };
        Some(PossibleValue::new(self.name()).help(about))
    }
}
