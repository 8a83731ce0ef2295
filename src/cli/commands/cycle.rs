//! `krank cycle`: reports values over the whole motion.

use crate::cli::columns::{entries, figures};
use crate::cli::failure::Failure;
use crate::cli::formats::{CsvArgs, OutputFormat, positive};
use crate::cli::lead::LeadArgs;
use crate::cli::output::{OutputArgs, write_text, write_to};
use crate::cli::place::note_near_misses;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::quantity::{Catalogue, Quantity};
use crate::report::{CycleReport, usual_columns};
use crate::scene::Scene;
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct CycleArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[arg(help = words().columns_of_cycle())]
    #[arg(long, value_name = "PATTERNS")]
    columns: Vec<String>,
    #[arg(help = words().dwell_of_cycle())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    dwell: Option<f64>,
    #[arg(help = words().bounds_of_cycle())]
    #[arg(long)]
    bounds: bool,
    #[arg(help = words().how_to_write_cycle())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[command(flatten)]
    output: OutputArgs,
}

pub(in crate::cli) fn cycle(args: &CycleArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let opened = args.scene.open_for(&args.output)?;
    let SolvableScene { scene, solver } = args.lead.applied_to(opened)?;
    let columns = match args.columns.is_empty() {
        true => usual_columns(&scene),
        false => named_columns(&scene, &args.columns)?,
    };
    note_near_misses(&scene, &solver, screen);
    let report = CycleReport::new(&scene, &solver, &columns, args.dwell);
    let report = match args.bounds {
        true => report.with_bounds(&solver),
        false => report,
    };
    let output = args.output.output.as_deref();
    match args.format {
        OutputFormat::Text => write_text(output, &report.to_text(screen.ascii)),
        OutputFormat::Json => write_text(output, &format!("{:#}\n", report.to_json())),
        OutputFormat::Csv => write_to(output, |out| report.write_csv(dialect, out)),
    }
}

/// Returns the columns that the patterns name. Includes the driver's coordinate if named, although
/// tables contain it anyway.
fn named_columns(scene: &Scene, patterns: &[String]) -> Result<Vec<Quantity>, Failure> {
    let mut catalogue = Catalogue::new(scene);
    let found = figures(&mut catalogue, patterns)?;
    let driver = catalogue.driver();
    let mut all = patterns.iter().flat_map(|list| entries(list));
    let driver = all
        .any(|pattern| pattern.trim() == driver.name)
        .then(|| driver.clone());
    let columns: Vec<Quantity> = driver.into_iter().chain(found).collect();
    match columns.is_empty() {
        true => {
            let why = words().of_option("--columns", &words().state_has_no_cycle());
            Err(Failure::Usage(why))
        }
        false => Ok(columns),
    }
}
