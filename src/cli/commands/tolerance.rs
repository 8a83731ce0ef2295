//! `krank tolerance`: computes the effect of tolerances and joint clearances on values.

use crate::Tolerances;
use crate::cli::choice::{OptionValue, one_of};
use crate::cli::columns::{entries, figures};
use crate::cli::failure::{Failure, note};
use crate::cli::formats::{CsvArgs, OutputFormat};
use crate::cli::output::{OutputArgs, write_text, write_to};
use crate::cli::place::{
    check_derivative_count, normalize_coordinate, note_near_misses, out_of_reach,
};
use crate::cli::rows::{RowEnds, steps, write_rows};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::quantity::{Catalogue, Quantity, demand, length_name};
use crate::report::{
    ToleranceOutcome, ToleranceReport, ToleranceRows, WrittenDecimal, limits_text,
};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};
use crate::study::{
    CycleFigure, Distribution, MotionTolerance, SampleOrder, ToleranceError, ToleranceStudy,
};
use crate::wording::words;
use clap::Args;

/// Returns how lengths are spread among the samples.
fn distributions() -> [OptionValue<Distribution>; 2] {
    [
        (
            "normal",
            words().spread_choice_normal(),
            Distribution::Normal,
        ),
        ("even", words().spread_choice_even(), Distribution::Even),
    ]
}

/// Maximum number of samples; more take memory and add no information.
const MAX_SAMPLES: i64 = 10_000_000;

#[derive(Debug, Args)]
pub(in crate::cli) struct ToleranceArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().columns_of_tolerances())]
    #[arg(long, value_name = "PATTERNS")]
    columns: Vec<String>,
    #[arg(help = words().place_of_tolerances())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    at: Option<WrittenDecimal>,
    #[arg(help = words().first_row())]
    #[arg(
        long,
        value_name = "COORDINATE",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    from: Option<WrittenDecimal>,
    #[arg(help = words().last_row())]
    #[arg(
        long,
        value_name = "COORDINATE",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    to: Option<WrittenDecimal>,
    #[arg(help = words().row_to_row_of_tolerances())]
    #[arg(
        long,
        value_name = "STEP",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    step: Option<WrittenDecimal>,
    #[arg(help = words().tolerance_of_all())]
    #[arg(long, value_name = "TOLERANCE", allow_negative_numbers = true)]
    tolerance: Option<String>,
    #[arg(help = words().machines_by_chance())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MAX_SAMPLES))]
    samples: Option<u32>,
    #[arg(help = words().seed_of_samples())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    #[arg(help = words().spread_of_lengths())]
    #[arg(long, value_parser = one_of(distributions()), default_value = "normal")]
    distribution: Distribution,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    csv: CsvArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// Default step, in degrees: 72 rows per turn.
const STEP: f64 = 5.0;
/// Significant digits of rows in text.
const DIGITS: usize = 6;
/// Default number of random machines at one coordinate.
const DEFAULT_SAMPLES: u32 = 100_000;
/// Default number of random machines for values of the whole motion, because each must be tracked.
const DEFAULT_MOTION_SAMPLES: u32 = 2_000;

pub(in crate::cli) fn tolerance(args: &ToleranceArgs, screen: TextScreen) -> Result<(), Failure> {
    let format = args.csv.rows(args.format, DIGITS)?;
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let mut catalogue = Catalogue::new(&scene);
    let tolerances = tolerances(args, &scene)?;
    if let Some(figures) = motion_values(&mut catalogue, &args.columns, args.at)? {
        if args.from.is_some() || args.to.is_some() || args.step.is_some() {
            return Err(Failure::Usage(words().whole_has_no_place().into()));
        }
        let study = MotionTolerance::new(&solver, &tolerances, figures);
        let mut study = study.map_err(refused)?;
        let samples = order(args, args.samples.unwrap_or(DEFAULT_MOTION_SAMPLES));
        let report = ToleranceReport::for_motion(&scene, &mut study, samples);
        return write_output(args, &report, screen.ascii);
    }
    let mut figures = requested_quantities(&mut catalogue, &args.columns)?;
    let study = |figures: &[Quantity]| {
        check_derivative_count(&scene, figures.len())?;
        let study = ToleranceStudy::new(&scene, &solver, &tolerances, figures);
        study.map_err(refused)
    };
    if args.columns.is_empty() {
        let at = scene.mechanism.driver().start;
        figures = study(&figures)?.moved(at);
    }
    let mut study = study(&figures)?;
    note_near_misses(&scene, &solver, screen);
    if let Some(at) = args.at {
        let at = normalize_coordinate(at.value(), &scene, &solver, screen);
        return tolerances_at(args, at, &scene, &solver, &mut study, screen.ascii);
    }
    let range = solver.motion().range;
    let ends = RowEnds {
        from: args.from,
        to: args.to,
        step: args.step,
    };
    let steps = steps(&scene, range, ends, STEP)?;
    let rows = ToleranceRows {
        scene: &scene,
        solver: &solver,
        steps: &steps,
        samples: args.samples.map(|count| order(args, count)),
        format,
    };
    let path = args.output.output.as_deref();
    let outcome = write_rows(path, &steps, screen, |out, progress| {
        rows.write(&mut study, out, progress)
    })?;
    report_unproved(outcome, &limits_text(range, catalogue.driver()), screen)
}

/// Returns the requested values of the whole motion, such as `F.stroke` or `transmission`. Other
/// values next to them are taken at the coordinate `at`. `None` if there are no values of the whole
/// motion.
fn motion_values(
    catalogue: &mut Catalogue,
    columns: &[String],
    at: Option<WrittenDecimal>,
) -> Result<Option<Vec<CycleFigure>>, Failure> {
    let names = columns.iter().flat_map(|list| entries(list)).map(str::trim);
    let names: Vec<&str> = names.collect();
    let is_whole = |name: &&str| CycleFigure::parse(name, catalogue).is_ok();
    let integer = names.iter().filter(|name| is_whole(name)).count();
    if integer == 0 {
        return Ok(None);
    }
    if integer == names.len() && at.is_some() {
        return Err(Failure::Usage(words().whole_has_no_place().into()));
    }
    let mut all = Vec::new();
    for name in names {
        let wrong = |why: String| Failure::Usage(words().of_option("--columns", &why));
        if let Ok(figure) = CycleFigure::parse(name, catalogue) {
            all.push(figure);
            continue;
        }
        for figure in requested_quantities(catalogue, &[name.to_owned()])? {
            let Some(at) = at else {
                return Err(wrong(words().beside_whole_say_where(&figure.name)));
            };
            let name = format!("{}@{}", figure.name, at.value());
            all.push(CycleFigure::parse(&name, catalogue).map_err(|why| wrong(why.to_string()))?);
        }
    }
    Ok(Some(all))
}

/// Converts an error of the tolerance study, with advice.
fn refused(why: ToleranceError) -> Failure {
    Failure::Cannot(match why {
        ToleranceError::Exact => format!("{why}; {}", words().or_say_tolerance()),
        ToleranceError::Redundant | ToleranceError::Forces => why.to_string(),
    })
}

/// Returns the requested quantities, or all positions and directions if none are named.
fn requested_quantities(
    catalogue: &mut Catalogue,
    columns: &[String],
) -> Result<Vec<Quantity>, Failure> {
    if columns.is_empty() {
        let mut all = catalogue.figures();
        all.retain(|quantity| {
            let (demand, order) = demand([quantity]);
            order == Order::Position && !demand.forces
        });
        return Ok(all);
    }
    let mut all = figures(catalogue, columns)?;
    all.retain(|quantity| !quantity.is_driver());
    Ok(all)
}

/// Returns the scene's tolerances, with the typed tolerance for every length and coordinate if given.
fn tolerances(args: &ToleranceArgs, scene: &Scene) -> Result<Tolerances, Failure> {
    let Some(typed) = &args.tolerance else {
        return Ok(scene.tolerances().clone());
    };
    let found = scene.typed_tolerances(typed, |length| length_name(scene, length));
    found.map_err(|why| Failure::Usage(words().of_option("--tolerance", &why)))
}

fn order(args: &ToleranceArgs, count: u32) -> SampleOrder {
    SampleOrder {
        count,
        seed: args.seed,
        distribution: args.distribution,
    }
}

fn tolerances_at(
    args: &ToleranceArgs,
    at: f64,
    scene: &Scene,
    solver: &Solver,
    study: &mut ToleranceStudy,
    ascii: bool,
) -> Result<(), Failure> {
    let condition = solver.solve(at, Order::Position, &mut solver.state());
    if condition == Condition::NoAssembly {
        return Err(out_of_reach(scene, solver, at));
    }
    let samples = order(args, args.samples.unwrap_or(DEFAULT_SAMPLES));
    let report = ToleranceReport::at(scene, study, at, condition, Some(samples));
    write_output(args, &report, ascii)
}

fn write_output(
    args: &ToleranceArgs,
    report: &ToleranceReport,
    ascii: bool,
) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let output = args.output.output.as_deref();
    match args.format {
        OutputFormat::Text => write_text(output, &report.to_text(ascii)),
        OutputFormat::Json => write_text(output, &format!("{:#}\n", report.to_json())),
        OutputFormat::Csv => write_to(output, |out| report.write_csv(dialect, out)),
    }
}

/// Reports unproved rows and rows without values. No values at all is an error.
fn report_unproved(
    outcome: ToleranceOutcome,
    range: &str,
    screen: TextScreen,
) -> Result<(), Failure> {
    let ToleranceOutcome {
        rows,
        valued,
        estimated,
        fails,
    } = outcome;
    if valued == 0 {
        return Err(Failure::Cannot(words().no_row_in_motion(range)));
    }
    if valued < rows {
        note(&words().rows_outside(rows - valued, rows, range), screen);
    }
    if estimated > 0 {
        note(&words().rows_estimated(estimated, rows), screen);
    }
    if fails > 0 {
        note(&words().rows_that_may_not_close(fails, rows), screen);
    }
    Ok(())
}
