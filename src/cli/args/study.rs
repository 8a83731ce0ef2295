//! Arguments of `krank study`, which compares many designs.

use super::motor::positive;
use super::{CsvArgs, GlyphChoice, OutputArgs, SceneArgs, Size};
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::ops::Range;
use std::str::FromStr;

/// How designs are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum StudyFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
    #[value(help = words().format_json())]
    Json,
    #[value(help = words().format_chart())]
    Chart,
    #[value(help = words().format_svg())]
    Svg,
}

/// A part of a study, such as `1/4`; parts are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) struct StudyPart {
    number: u64,
    of: u64,
}

impl StudyPart {
    /// Returns the range of the part's designs. Each of the `count` designs belongs to exactly one part.
    pub(in crate::cli) fn of(self, count: u64) -> Range<u64> {
        let end = |part: u64| {
            let end = u128::from(count) * u128::from(part) / u128::from(self.of);
            u64::try_from(end).unwrap_or(count)
        };
        end(self.number - 1)..end(self.number)
    }
}

impl FromStr for StudyPart {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<u64>().ok().filter(|&n| n > 0);
        let part = text.split_once('/').and_then(|(part, of)| {
            let (number, of) = (number(part)?, number(of)?);
            (number <= of).then_some(StudyPart { number, of })
        });
        part.ok_or_else(|| words().no_part(text))
    }
}

/// Maximum number of threads, more than any machine has.
const MAX_THREADS: i64 = 1024;

#[derive(Debug, Args)]
pub(in crate::cli) struct StudyArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().values_of_study())]
    #[arg(long, value_name = "AXES", required = true, value_delimiter = ',')]
    pub(in crate::cli) vary: Vec<String>,
    #[arg(help = words().columns_of_study())]
    #[arg(long, value_name = "FIGURES", required = true, value_delimiter = ',')]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().designs_of_hypercube())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(in crate::cli) latin: Option<u32>,
    #[arg(help = words().seed_of_hypercube())]
    #[arg(long, value_name = "N", default_value_t = 1, requires = "latin")]
    pub(in crate::cli) seed: u64,
    #[arg(help = words().dwell_of_cycle())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) dwell: Option<f64>,
    #[arg(help = words().part_of_study())]
    #[arg(long, value_name = "K/N")]
    pub(in crate::cli) part: Option<StudyPart>,
    #[arg(help = words().resume_study())]
    #[arg(long, requires = "output")]
    pub(in crate::cli) resume: bool,
    #[arg(help = words().threads_of_study())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MAX_THREADS))]
    pub(in crate::cli) threads: Option<u16>,
    #[arg(help = words().how_to_write_study())]
    #[arg(long, value_enum, default_value_t = StudyFormat::Csv)]
    pub(in crate::cli) format: StudyFormat,
    #[arg(help = words().digits_of_tables())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[arg(help = words().leave_units_out())]
    #[arg(long)]
    pub(in crate::cli) no_units: bool,
    #[arg(help = words().size_of_chart())]
    #[arg(long, value_name = "COLSxROWS")]
    pub(in crate::cli) size: Option<Size>,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: GlyphChoice,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

impl StudyArgs {
    /// Returns `true` if the output is a picture.
    pub(in crate::cli) fn is_drawn(&self) -> bool {
        matches!(self.format, StudyFormat::Chart | StudyFormat::Svg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_every_design_once() {
        for (count, of) in [(1_000_000, 64_u64), (5, 7), (63, 3), (0, 2)] {
            let mut next = 0;
            for k in 1..=of {
                let part: StudyPart = format!("{k}/{of}").parse().unwrap();
                let designs = part.of(count);
                assert_eq!(designs.start, next);
                next = designs.end;
            }
            assert_eq!(next, count);
        }
        for text in ["0/3", "4/3", "1", "1/0", "a/b", "-1/3"] {
            assert!(text.parse::<StudyPart>().is_err(), "{text}");
        }
    }
}
