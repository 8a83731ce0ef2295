//! The commands that need only a few lines each.

use crate::cli::columns::figures;
use crate::cli::failure::{Failure, note};
use crate::cli::formats::{FigureArgs, OutputFormat};
use crate::cli::lead::{LeadArgs, check_bounds_not_asked, leader};
use crate::cli::output::{OutputArgs, write_to};
use crate::cli::place::{
    PlaceArgs, check_derivative_count, check_nothing_hidden, none_hidden, note_missing_derivatives,
    note_near_misses, note_unproved, out_of_reach, place,
};
use crate::cli::rows::{clock, note_constant_speed};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::quantity::{Catalogue, Sensitivity};
use crate::report::{
    Answers, CsvDialect, FigureList, Forces, TableStyle, Tables, WrittenDecimal, singularity_text,
};
use crate::scene::{LeadingPoint, Scene};
use crate::solver::{Condition, Order, State};
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct TableArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[command(flatten)]
    place: PlaceArgs,
    #[arg(help = words().moment_of_motion())]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, conflicts_with_all = ["at", "sensitivity"])]
    time: Option<WrittenDecimal>,
    #[arg(help = words().columns_of_table())]
    #[arg(long, value_name = "PATTERNS")]
    columns: Vec<String>,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    #[command(flatten)]
    figures: FigureArgs,
    #[command(flatten)]
    output: OutputArgs,
}

/// Runs `krank table`: prints positions, velocities, accelerations and loads at one driver
/// coordinate.
pub(in crate::cli) fn table(args: &TableArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.figures.csv.dialect(args.format)?;
    let opened = args.scene.open_for(&args.output)?;
    let opened = args.lead.applied_to(opened)?;
    if let Some(lead) = &opened.scene.lead
        && args.place.typed().is_none()
    {
        return table_of_lead(lead, args, dialect, &opened, screen);
    }
    let SolvableScene { scene, solver } = opened;
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let at = match args.time {
        Some(time) => {
            let moment = clock(&scene)?.moment(time.value(), solver.motion().range);
            solver.drive(&mut state, &moment);
            solver.drive(&mut enclosure, &moment);
            moment.at
        }
        None => {
            note_constant_speed(&scene, screen);
            place(&args.place, &scene, &solver, screen)
        }
    };
    if solver.solve(at, Order::Force, &mut state) == Condition::NoAssembly {
        return Err(out_of_reach(&scene, &solver, at));
    }
    note_near_misses(&scene, &solver, screen);
    solver.enclose(&mut state, Order::Force, &mut enclosure);
    let mut tables = Tables::bounded(&scene, &state, &enclosure);
    tables.forces = Forces::new(&scene, &solver, &state, Some(&enclosure));
    let mut catalogue = Catalogue::new(&scene);
    let named = match args.columns.is_empty() {
        true => None,
        false => Some(figures(&mut catalogue, &args.columns)?),
    };
    if args.figures.sensitivity {
        let requested = named.clone().unwrap_or_else(|| catalogue.figures());
        check_derivative_count(&scene, requested.len())?;
        let mut sensitivity = Sensitivity::new(&scene, &solver, &requested);
        let answers = Answers::at(&mut sensitivity, tables.unit, at);
        if answers.list.is_none() {
            note(words().no_derivatives_by_lengths(), screen);
        }
        note_missing_derivatives(
            answers.missing_derivatives as u64,
            answers.requested_count() as u64,
            screen,
        );
        tables.answers = Some(answers);
    }
    let list = named.map(|named| FigureList::new(&tables, &named, &state, Some(&enclosure)));
    if args.figures.bounds {
        let unproved = list.as_ref().map(FigureList::unproved);
        let (count, unproved) = unproved.unwrap_or_else(|| tables.unproved());
        note_unproved(unproved, count, screen);
    }
    write_tables(args, dialect, (&tables, list.as_ref()), screen)?;
    check_shown(list.as_ref(), &scene, &state)
}

/// Writes the tables, or the list of the named values.
fn write_tables(
    args: &TableArgs,
    dialect: CsvDialect,
    (tables, list): (&Tables, Option<&FigureList>),
    screen: TextScreen,
) -> Result<(), Failure> {
    let style = TableStyle {
        digits: usize::from(args.figures.digits),
        units: !args.figures.no_units,
        bounds: args.figures.bounds,
        ascii: screen.ascii,
    };
    write_to(args.output.output.as_deref(), |out| {
        match (args.format, list) {
            (OutputFormat::Text, None) => out.write_all(tables.to_text(style).as_bytes()),
            (OutputFormat::Text, Some(list)) => out.write_all(list.to_text(style).as_bytes()),
            (OutputFormat::Csv, None) => tables.write_csv(style, dialect, out),
            (OutputFormat::Csv, Some(list)) => list.write_csv(style, dialect, out),
            (OutputFormat::Json, None) => writeln!(out, "{:#}", tables.to_json(style)),
            (OutputFormat::Json, Some(list)) => writeln!(out, "{:#}", list.to_json(style)),
        }
    })
}

/// Returns an error if a value of the tables, or of the list, exists but is not shown.
fn check_shown(list: Option<&FigureList>, scene: &Scene, state: &State) -> Result<(), Failure> {
    match list {
        None => check_nothing_hidden(scene, state),
        Some(list) => none_hidden(list.quantities(), &Catalogue::new(scene), state),
    }
}

/// Prints the tables of a scene with a leading point, at a time of its motion.
fn table_of_lead(
    lead: &LeadingPoint,
    args: &TableArgs,
    dialect: CsvDialect,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = opened;
    check_bounds_not_asked(&args.figures)?;
    let [first, _] = lead.path.span();
    let time = args.time.map_or(first, WrittenDecimal::value);
    let mut leader = leader(scene, solver, lead)?;
    let Some(pose) = leader.follow(&lead.path, time, Order::Force) else {
        return Err(Failure::Cannot(words().lead_out_of_reach(&time)));
    };
    if let Some(singularity) = &pose.singularity {
        note(&singularity_text(scene, solver, singularity), screen);
    }
    let state = leader.state();
    let mut tables = Tables::new(scene, state);
    tables.forces = Forces::new(scene, solver, state, None);
    let mut catalogue = Catalogue::new(scene);
    let named = match args.columns.is_empty() {
        true => None,
        false => Some(figures(&mut catalogue, &args.columns)?),
    };
    let list = named.map(|named| FigureList::new(&tables, &named, state, None));
    write_tables(args, dialect, (&tables, list.as_ref()), screen)?;
    check_shown(list.as_ref(), scene, state)
}
