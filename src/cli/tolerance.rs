//! `krank tolerance`: what lengths that are off and loose pins do to figures.

use super::args::{OutputFormat, ToleranceArgs};
use super::commands::{few_enough, out_of_reach, place_meant, tell_of_near_misses};
use super::failure::{Failure, note};
use super::output::{goes_to_terminal, write_text, write_to};
use super::progress::Progress;
use super::screen::TextScreen;
use super::source::SolvableScene;
use super::sweep::{RowEnds, entries, figures, steps};
use crate::Tolerances;
use crate::quantity::{Catalogue, Quantity, demand};
use crate::report::{
    ToleranceFormat, ToleranceOutcome, ToleranceReport, ToleranceRows, limits_text,
};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};
use crate::study::{CycleFigure, NoTolerance, SampleOrder, ToleranceStudy, WholeTolerance};
use crate::wording::words;

/// Degrees from row to row: 72 rows of a turn.
const STEP: f64 = 5.0;
/// So many machines are made where nobody says how many.
const USUAL_SAMPLES: u32 = 100_000;
/// The same of figures of the whole motion, for which each has to be followed.
const WHOLE_SAMPLES: u32 = 2_000;

pub(super) fn tolerance(args: &ToleranceArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let mut catalogue = Catalogue::new(&scene);
    let tolerances = tolerances(args, &scene);
    if let Some(figures) = of_whole(&catalogue, &args.columns)? {
        if args.at.is_some() || args.from.is_some() || args.to.is_some() || args.step.is_some() {
            return Err(Failure::Usage(words().whole_has_no_place().into()));
        }
        let study = WholeTolerance::new(&solver, &tolerances, figures);
        let mut study = study.map_err(refused)?;
        let samples = order(args, args.samples.unwrap_or(WHOLE_SAMPLES));
        let report = ToleranceReport::of_whole(&scene, &mut study, samples);
        return tell(args, &report, screen.ascii);
    }
    let mut figures = asked(&mut catalogue, &args.columns)?;
    let study = |figures: &[Quantity]| {
        few_enough(&scene, figures.len())?;
        let study = ToleranceStudy::new(&scene, &solver, &tolerances, figures);
        study.map_err(refused)
    };
    if args.columns.is_empty() {
        let at = scene.mechanism.driver().start;
        figures = study(&figures)?.moved(at);
    }
    let mut study = study(&figures)?;
    tell_of_near_misses(&scene, &solver, screen);
    if let Some(at) = args.at {
        let at = place_meant(at.value(), &scene, &solver, screen);
        return at_one_place(args, at, &scene, &solver, &mut study, screen.ascii);
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
        format: match args.format {
            OutputFormat::Text => ToleranceFormat::Text,
            OutputFormat::Csv => ToleranceFormat::Csv(dialect),
            OutputFormat::Json => ToleranceFormat::Json,
        },
    };
    let path = args.output.output.as_deref();
    let mut progress = Progress::new(
        steps.count(),
        words().rows(),
        screen,
        goes_to_terminal(path),
    );
    let outcome = write_to(path, |out| {
        rows.write(&mut study, out, &mut |done| progress.tell(done))
    });
    progress.end();
    judge(outcome?, &limits_text(range, catalogue.driver()), screen)
}

/// Figures of the whole motion, if such are asked for: `F.stroke`, `transmission`. They do not stand beside columns.
fn of_whole(
    catalogue: &Catalogue,
    columns: &[String],
) -> Result<Option<Vec<CycleFigure>>, Failure> {
    let names = columns.iter().flat_map(|list| entries(list)).map(str::trim);
    let all: Vec<_> = names
        .map(|name| CycleFigure::parse(name, catalogue))
        .collect();
    if all.iter().all(Result::is_err) {
        return Ok(None);
    }
    let wrong = |why| Failure::Usage(words().of_option("--columns", &why));
    all.into_iter()
        .collect::<Result<_, _>>()
        .map(Some)
        .map_err(wrong)
}

/// Why nothing can be told, and what would help here.
fn refused(why: NoTolerance) -> Failure {
    Failure::Cannot(match why {
        NoTolerance::Exact => format!("{why}; {}", words().or_say_tolerance()),
        _ => why.to_string(),
    })
}

/// The figures that were named; the places and directions of all that moves where none was.
fn asked(catalogue: &mut Catalogue, columns: &[String]) -> Result<Vec<Quantity>, Failure> {
    if columns.is_empty() {
        let mut all = catalogue.figures();
        all.retain(|figure| {
            let (demand, order) = demand([figure]);
            order == Order::Position && !demand.forces
        });
        return Ok(all);
    }
    let mut all = figures(catalogue, columns)?;
    all.retain(|figure| !figure.is_driver());
    Ok(all)
}

/// What may be off: what the scene says, or every length by as much.
fn tolerances(args: &ToleranceArgs, scene: &Scene) -> Tolerances {
    let mut tolerances = scene.tolerances().clone();
    if let Some(by) = args.tolerance {
        let lengths = scene.mechanism.lengths().into_iter();
        tolerances.lengths = lengths.map(|length| (length, by)).collect();
    }
    tolerances
}

fn order(args: &ToleranceArgs, count: u32) -> SampleOrder {
    SampleOrder {
        count,
        seed: args.seed,
        distribution: args.distribution.distribution(),
    }
}

fn at_one_place(
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
    let samples = order(args, args.samples.unwrap_or(USUAL_SAMPLES));
    let report = ToleranceReport::at(scene, study, at, condition, Some(samples));
    tell(args, &report, ascii)
}

fn tell(args: &ToleranceArgs, report: &ToleranceReport, ascii: bool) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let output = args.output.output.as_deref();
    match args.format {
        OutputFormat::Text => write_text(output, &report.to_text(ascii)),
        OutputFormat::Json => write_text(output, &format!("{:#}\n", report.to_json())),
        OutputFormat::Csv => write_to(output, |out| report.write_csv(dialect, out)),
    }
}

/// Says what is not proved, and which rows have no values; where none has, it has failed.
fn judge(outcome: ToleranceOutcome, range: &str, screen: TextScreen) -> Result<(), Failure> {
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
