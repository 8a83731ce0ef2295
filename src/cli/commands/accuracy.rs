//! `krank accuracy`: runs the accuracy study and writes its findings.

use crate::cli::failure::Failure;
use crate::cli::formats::{CsvArgs, OutputFormat};
use crate::cli::output::{OutputArgs, write_to};
use crate::cli::progress::Progress;
use crate::cli::screen::TextScreen;
use crate::cli::source::{AssemblyArgs, SolvableScene, open_for};
use crate::drawing::{Glyphs, trade_off};
use crate::report::{Accuracy, accuracy_notes};
use crate::study::{DEFAULT_POSITIONS, Findings, Study};
use crate::wording::words;
use clap::Args;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Maximum number of positions; more take minutes and find no larger error.
const MAX_POSITIONS: i64 = 1_000_000;

#[derive(Debug, Args)]
pub(in crate::cli) struct AccuracyArgs {
    #[arg(help = words().name_of_scene())]
    #[arg(default_value = "four-bar")]
    scene: PathBuf,
    #[arg(help = words().positions_to_compare())]
    #[arg(long, value_name = "N", default_value_t = DEFAULT_POSITIONS, value_parser = clap::value_parser!(u32).range(1..=MAX_POSITIONS))]
    positions: u32,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[command(flatten)]
    assembly: AssemblyArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// Time between two progress reports.
const SLICE: Duration = Duration::from_millis(50);
/// Resolution of the progress.
const PARTS: u64 = 1000;
/// Size of the chart below the table, in columns and rows.
const CHART: (u16, u16) = (80, 20);

pub(in crate::cli) fn accuracy(args: &AccuracyArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let SolvableScene { scene, solver } =
        open_for(&args.scene, &args.assembly.wishes, &args.output)?;
    let study = Study::new(&solver, args.positions);
    let findings = measured(study, screen);
    let accuracy = Accuracy {
        scene: &scene,
        findings: &findings,
    };
    write_to(args.output.output.as_deref(), |out| match args.format {
        OutputFormat::Text => {
            let table = accuracy.to_text(screen.ascii);
            let notes = screen.shown(&accuracy_notes());
            write!(out, "{table}\n{}\n{notes}", chart(&findings))
        }
        OutputFormat::Csv => accuracy.write_csv(dialect, out),
        OutputFormat::Json => writeln!(out, "{:#}", accuracy.to_json()),
    })
}

fn measured(mut study: Study, screen: TextScreen) -> Findings {
    let started = Instant::now();
    // Results are written only at the end, so the progress line disturbs no output.
    let mut progress = Progress::new(PARTS, words().parts(), screen, false);
    while study.advance(&mut || started.elapsed(), SLICE) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 1 times a thousand"
        )]
        progress.report_progress((study.progress() * PARTS as f64) as u64);
    }
    progress.end();
    study.findings()
}

fn chart(findings: &Findings) -> String {
    let (cols, rows) = CHART;
    trade_off(findings).render(cols, rows, Glyphs::Ascii).text()
}
