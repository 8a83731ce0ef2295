//! `krank sweep`: writes values row by row over the motion.

use crate::cli::columns::figures;
use crate::cli::external_values::measured;
use crate::cli::failure::{Failure, note};
use crate::cli::formats::{FigureArgs, OutputFormat};
use crate::cli::lead::{LeadArgs, check_bounds_not_asked, leader};
use crate::cli::output::{OutputArgs, write_to};
use crate::cli::place::{
    check_derivative_count, note_missing_derivatives, note_near_misses, note_unproved,
};
use crate::cli::rows::{RowEnds, clock, note_constant_speed, steps, times, write_rows};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene, check_output_differs_from_input, contents};
use crate::quantity::{Catalogue, Quantity};
use crate::report::{
    Columns, ExtraColumns, InputPath, LeadSweep, Missing, RowFormat, Sweep, SweepOutcome,
    WrittenDecimal, limits_text,
};
use crate::scene::{LeadingPoint, Scene};
use crate::solver::{Order, Range};
use crate::study::motor;
use crate::wording::words;
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub(in crate::cli) struct SweepArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[arg(help = words().first_row())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    from: Option<WrittenDecimal>,
    #[arg(help = words().last_row())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    to: Option<WrittenDecimal>,
    #[arg(help = words().row_to_row())]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    step: Option<WrittenDecimal>,
    #[arg(help = words().rows_over_time())]
    #[arg(long, conflicts_with_all = ["measured", "sensitivity"])]
    time: bool,
    #[arg(help = words().columns_or_all())]
    #[arg(long, value_name = "PATTERNS")]
    columns: Vec<String>,
    #[arg(help = words().measured_figures())]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["from", "to", "step", "bounds", "sensitivity"])]
    measured: Option<PathBuf>,
    #[arg(help = words().path_of_inputs())]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["from", "to", "step", "time", "by", "measured", "bounds", "sensitivity"])]
    path: Option<PathBuf>,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Csv)]
    format: OutputFormat,
    #[command(flatten)]
    figures: FigureArgs,
    #[command(flatten)]
    output: OutputArgs,
}

impl SweepArgs {
    /// Returns the limits and the step of the rows.
    fn ends(&self) -> RowEnds {
        RowEnds {
            from: self.from,
            to: self.to,
            step: self.step,
        }
    }
}

/// Default step of a turning driver, in degrees.
const STEP: f64 = 1.0;

pub(in crate::cli) fn sweep(args: &SweepArgs, screen: TextScreen) -> Result<(), Failure> {
    let digits = usize::from(args.figures.digits);
    let format = args.figures.csv.rows(args.format, digits)?;
    let opened = args.scene.open_for(&args.output)?;
    let opened = args.lead.applied_to(opened)?;
    if let Some(file) = &args.measured {
        return sweep_measured(file, args, format, &opened, screen);
    }
    if let Some(file) = &args.path {
        return sweep_path(file, args, format, &opened, screen);
    }
    if let Some(lead) = opened.scene.lead.clone() {
        return sweep_lead(&lead, args, format, &opened, screen);
    }
    let SolvableScene { scene, solver } = opened;
    let mut catalogue = Catalogue::new(&scene);
    let quantities = figures(&mut catalogue, &args.columns)?;
    let columns = Columns::new(catalogue.driver(), &quantities, !args.figures.no_units);
    let besides = ExtraColumns {
        bounds: args.figures.bounds,
        sensitivity: args.figures.sensitivity,
    };
    if besides.sensitivity {
        check_derivative_count(&scene, quantities.len())?;
    }
    let columns = columns.with(besides, scene.unit.symbol());
    let range = solver.motion().range;
    let clock = args.time.then(|| clock(&scene)).transpose()?;
    let (columns, steps) = match &clock {
        Some(clock) => (columns.over_time(), times(clock.span(range), args.ends())?),
        None => {
            note_constant_speed(&scene, screen);
            let range = default_range(&scene, range, &quantities);
            (columns, steps(&scene, range, args.ends(), STEP)?)
        }
    };
    let sweep = Sweep {
        scene: &scene,
        solver: &solver,
        columns: &columns,
        steps: &steps,
        clock: clock.as_ref(),
        format,
    };
    let path = args.output.output.as_deref();
    let outcome = write_rows(path, &steps, screen, |out, progress| {
        sweep.write(out, progress)
    })?;
    note_near_misses(&scene, &solver, screen);
    let driver = catalogue.driver();
    report_missing_values(&outcome, &limits_text(range, driver), screen)?;
    match &outcome.first_hidden {
        None => Ok(()),
        Some(first) => Err(Failure::Cannot(words().rows_withheld(
            outcome.hidden,
            outcome.rows,
            &first.text(&driver.unit),
        ))),
    }
}

/// Reports rows without values. A sweep without any values is an error.
fn report_missing_values(
    outcome: &SweepOutcome,
    range: &str,
    screen: TextScreen,
) -> Result<(), Failure> {
    let &SweepOutcome {
        rows,
        valued,
        missing,
        ..
    } = outcome;
    note_missing(missing, valued, screen);
    if valued == rows {
        return Ok(());
    }
    if valued == 0 {
        return Err(Failure::Cannot(words().no_row_in_motion(range)));
    }
    let outside = rows - valued;
    note(&words().rows_outside(outside, rows, range), screen);
    Ok(())
}

/// Reports missing error bounds and derivatives.
fn note_missing(missing: Missing, valued: u64, screen: TextScreen) {
    note_unproved(missing.unproved, missing.figures, screen);
    if missing.rows_without_derivatives > 0 {
        let rows = missing.rows_without_derivatives;
        note(
            &words().rows_without_answer(rows, valued, words().no_derivatives_by_lengths()),
            screen,
        );
    }
    note_missing_derivatives(missing.missing_derivatives, missing.requested, screen);
}

/// Returns the default range of a sweep: the motion, repeated for as many periods as the loads need
/// to repeat if forces are included.
fn default_range(scene: &Scene, range: Range, quantities: &[Quantity]) -> Range {
    let has_forces = quantities.iter().any(|q| q.order() == Order::Force);
    let repeats = motor::repeats(&scene.mechanism, range).filter(|_| has_forces);
    match (range, repeats) {
        (Range::Full { period }, Some(times)) => Range::Full {
            period: period * f64::from(times),
        },
        _ => range,
    }
}

/// Runs `krank sweep` for a scene with a leading point: writes rows over time, in which the inputs
/// follow it.
fn sweep_lead(
    lead: &LeadingPoint,
    args: &SweepArgs,
    format: RowFormat,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = opened;
    check_bounds_not_asked(&args.figures)?;
    let mut catalogue = Catalogue::new(scene);
    let quantities = figures(&mut catalogue, &args.columns)?;
    let columns = Columns::new(catalogue.driver(), &quantities, !args.figures.no_units);
    let columns = columns.over_time();
    let [first, last] = lead.path.span();
    let steps = times((first, last), args.ends())?;
    let leader = leader(scene, solver, lead)?;
    let sweep = LeadSweep {
        scene,
        leader: &leader,
        lead,
        columns: &columns,
        steps: &steps,
        format,
    };
    let path = args.output.output.as_deref();
    let outcome = write_rows(path, &steps, screen, |out, progress| {
        sweep.write(out, progress)
    })?;
    report_unreached(&outcome, opened, screen)
}

/// Runs `krank sweep --path`: writes a row for each row of the file, which has the coordinates of
/// all inputs.
fn sweep_path(
    file: &Path,
    args: &SweepArgs,
    format: RowFormat,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = opened;
    let output = args.output.output.as_deref();
    check_output_differs_from_input(file, output)?;
    let shown = file.display().to_string();
    let path = InputPath::read(scene, &contents(file)?);
    let path = path.map_err(|why| Failure::Usage(words().import_failed(&shown, &why)))?;
    let mut catalogue = Catalogue::new(scene);
    let mut quantities = figures(&mut catalogue, &args.columns)?;
    // Positions only: a path has no times.
    if let Some(rate) = quantities.iter().find(|q| q.order() != Order::Position)
        && !args.columns.is_empty()
    {
        return Err(Failure::Usage(words().path_has_no_rates(&rate.name)));
    }
    quantities.retain(|quantity| quantity.order() == Order::Position);
    let columns = Columns::new(catalogue.driver(), &quantities, !args.figures.no_units);
    let outcome = write_to(output, |out| {
        path.write((scene, solver), &columns, format, out)
    })?;
    report_unreached(&outcome, opened, screen)
}

/// Reports singular rows, and rows that the inputs cannot reach. A sweep without any values is an
/// error.
fn report_unreached(
    outcome: &SweepOutcome,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    if let Some(text) = outcome.singular_text(&opened.scene, &opened.solver) {
        note(&text, screen);
    }
    let &SweepOutcome { rows, valued, .. } = outcome;
    if valued == rows {
        return Ok(());
    }
    let message = words().poses_out_of_reach(rows - valued, rows);
    match valued {
        0 => Err(Failure::Cannot(message)),
        _ => {
            note(&message, screen);
            Ok(())
        }
    }
}

/// Runs `krank sweep --measured`: writes a row for each row of the file.
fn sweep_measured(
    file: &Path,
    args: &SweepArgs,
    format: RowFormat,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = opened;
    let output = args.output.output.as_deref();
    let mut catalogue = Catalogue::new(scene);
    let of = match args.columns.is_empty() {
        true => None,
        false => Some(figures(&mut catalogue, &args.columns)?),
    };
    let found = measured(file, output, &catalogue, of.as_deref(), screen)?;
    let is_shown = matches!(format, RowFormat::Text { .. });
    if !(is_shown || found.strangers().is_empty()) {
        note(&words().not_compared(&found.strangers().join(", ")), screen);
    }
    if let Some(left_out) = found.left_out().filter(|_| !is_shown) {
        note(&left_out, screen);
    }
    let written = (format, !args.figures.no_units);
    let outcome = write_to(output, |out| {
        found.write((scene, solver), written, screen.ascii, out)
    })?;
    match outcome.valued {
        0 => Err(Failure::Cannot(words().no_row_in_motion(
            &crate::report::limits_text(solver.motion().range, catalogue.driver()),
        ))),
        _ => Ok(()),
    }
}
