//! The commands that need only a few lines each.

use super::args::{CheckArgs, CheckFormat, Cli, OutputFormat, PlaceArgs, StartArgs, TableArgs};
use super::failure::{Failure, note};
use super::output::{write_scene, write_text, write_to};
use super::screen::TextScreen;
use super::source::SolvableScene;
use super::sweep::{clock, figures, tell_of_motion};
use crate::Input;
use crate::quantity::{Catalogue, Hidden, MAX_DERIVATIVES, Quantity, Sensitivity};
use crate::report::{
    Answers, Check, FigureList, Forces, TableStyle, Tables, limits_text, near_misses, stop_before,
};
use crate::scene::{Scene, presets, sanitized};
use crate::solver::{Condition, Order, Solver, State};
use crate::wording::words;
use clap::{Command, CommandFactory};

/// Runs `krank list`: prints a line per preset.
pub(super) fn list(screen: TextScreen) -> Result<(), Failure> {
    let presets = presets::all();
    let width = presets.iter().map(|p| p.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for preset in presets {
        let scene = Scene::parse(preset.text, preset.name).map_err(Failure::Scene)?;
        let title = sanitized(&scene.title(), screen.ascii);
        text.push_str(&format!("{:width$}  {title}\n", preset.name));
    }
    write_text(None, &text)
}

/// Runs `krank check`: prints the interpretation of a scene.
pub(super) fn check(args: &CheckArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let check = Check::new(&scene, &solver);
    let text = match args.format {
        CheckFormat::Text => check.to_text(screen.ascii),
        CheckFormat::Json => format!("{:#}\n", check.to_json()),
    };
    write_text(args.output.output.as_deref(), &text)
}

/// Runs `krank table`: prints positions, velocities, accelerations and loads at one driver
/// coordinate.
pub(super) fn table(args: &TableArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.figures.csv.dialect(args.format)?;
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let at = match args.time {
        Some(time) => {
            let moment = clock(&scene)?.moment(time.value(), solver.motion().range);
            solver.drive(&mut state, &moment);
            solver.drive(&mut enclosure, &moment);
            moment.at
        }
        None => {
            tell_of_motion(&scene, screen);
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
        let asked = named.clone().unwrap_or_else(|| catalogue.figures());
        check_derivative_count(&scene, asked.len())?;
        let mut sensitivity = Sensitivity::new(&scene, &solver, &asked);
        let answers = Answers::at(&mut sensitivity, tables.unit, at);
        if answers.list.is_none() {
            note(words().no_derivatives_by_lengths(), screen);
        }
        note_lacking(answers.lacking as u64, answers.asked() as u64, screen);
        tables.answers = Some(answers);
    }
    let list = named.map(|named| FigureList::new(&tables, &named, &state, &enclosure));
    if args.figures.bounds {
        let unproved = list.as_ref().map(FigureList::unproved);
        let (figures, unproved) = unproved.unwrap_or_else(|| tables.unproved());
        note_unproved(unproved, figures, screen);
    }
    let style = TableStyle {
        digits: usize::from(args.figures.digits),
        units: !args.figures.no_units,
        bounds: args.figures.bounds,
        ascii: screen.ascii,
    };
    write_to(args.output.output.as_deref(), |out| {
        match (args.format, &list) {
            (OutputFormat::Text, None) => out.write_all(tables.to_text(style).as_bytes()),
            (OutputFormat::Text, Some(list)) => out.write_all(list.to_text(style).as_bytes()),
            (OutputFormat::Csv, None) => tables.write_csv(style, dialect, out),
            (OutputFormat::Csv, Some(list)) => list.write_csv(style, dialect, out),
            (OutputFormat::Json, None) => writeln!(out, "{:#}", tables.to_json(style)),
            (OutputFormat::Json, Some(list)) => writeln!(out, "{:#}", list.to_json(style)),
        }
    })?;
    match &list {
        None => nothing_hidden(&scene, &state),
        Some(list) => none_hidden(list.quantities(), &catalogue, &state),
    }
}

/// Returns an error if any existing value of a state is not shown. Runs after all other output is
/// written.
pub(super) fn nothing_hidden(scene: &Scene, state: &State) -> Result<(), Failure> {
    let catalogue = Catalogue::new(scene);
    none_hidden(catalogue.all(), &catalogue, state)
}

fn none_hidden<'q>(
    figures: impl IntoIterator<Item = &'q Quantity>,
    catalogue: &Catalogue,
    state: &State,
) -> Result<(), Failure> {
    match Hidden::of(figures, state) {
        None => Ok(()),
        Some(hidden) => Err(Failure::Cannot(hidden.text(&catalogue.driver().unit))),
    }
}

/// Returns the driver coordinate: the scene's initial one, or the typed one. A typed coordinate may
/// differ by full turns, or by rounding, from the only one in the driver's range.
pub(super) fn place(args: &PlaceArgs, scene: &Scene, solver: &Solver, screen: TextScreen) -> f64 {
    let typed = args.typed().unwrap_or(scene.mechanism.driver().start);
    normalize_coordinate(typed, scene, solver, screen)
}

/// Returns the coordinate in the driver's range meant by a typed one, with a note if they differ.
pub(super) fn normalize_coordinate(
    typed: f64,
    scene: &Scene,
    solver: &Solver,
    screen: TextScreen,
) -> f64 {
    let driver = scene.mechanism.driver();
    let range = solver.motion().range;
    let turns = matches!(driver.input, Input::Turn(_));
    let Some(at) = range.meant(typed, turns) else {
        return typed;
    };
    let catalogue = Catalogue::new(scene);
    let unit = &catalogue.driver().unit;
    let limits = limits_text(range, catalogue.driver());
    note(&words().taken_within(&typed, &at, unit, &limits), screen);
    at
}

/// Returns the error for a coordinate without an assembly.
pub(super) fn out_of_reach(scene: &Scene, solver: &Solver, at: f64) -> Failure {
    let catalogue = Catalogue::new(scene);
    let driver = catalogue.driver();
    let covered = limits_text(solver.motion().range, driver);
    let (low, high) = solver.motion().range.ends();
    let end = if at < low { low } else { high };
    let mut stops = solver.motion().stops.iter();
    Failure::Cannot(match stops.find(|stop| stop.at == end) {
        Some(stop) => stop_before(scene, stop.limit, (at, &driver.unit), &covered),
        None => words().cannot_be_assembled(&at, &driver.unit, &covered),
    })
}

/// Returns an error if the derivatives by lengths would need too much memory and time.
pub(super) fn check_derivative_count(scene: &Scene, figures: usize) -> Result<(), Failure> {
    let lengths = scene.mechanism.lengths().len();
    if lengths.saturating_mul(figures) <= MAX_DERIVATIVES {
        return Ok(());
    }
    Err(Failure::Usage(
        words().too_many_sensitivities(figures, lengths),
    ))
}

/// Reports the number of values without an error bound.
pub(super) fn note_unproved(unproved: u64, figures: u64, screen: TextScreen) {
    if unproved > 0 {
        note(&words().unproved(&unproved, &figures), screen);
    }
}

pub(super) fn note_lacking(lacking: u64, figures: u64, screen: TextScreen) {
    if lacking > 0 {
        note(&words().figures_without_answer(lacking, figures), screen);
    }
}

/// Warns about nearby change points, where the last digits of the lengths determine how the motion
/// continues.
pub(super) fn note_near_misses(scene: &Scene, solver: &Solver, screen: TextScreen) {
    for text in near_misses(scene, solver) {
        note(&text, screen);
    }
}

/// Runs `krank start`: prints the scene with the start positions of an assembly.
pub(super) fn start(args: &StartArgs) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open()?;
    let start = scene.mechanism.driver().start;
    match scene.with_start_of(&solver, start) {
        Some(text) => write_scene(args.output.output.as_deref(), &text),
        None => Err(Failure::Cannot(words().no_start_tells_assembly().into())),
    }
}

/// Runs `krank man`: prints the manual page of krank or of one of its commands.
pub(super) fn man(command: Option<&str>, screen: TextScreen) -> Result<(), Failure> {
    let mut krank = Cli::command();
    krank.build();
    let page = match command {
        None => krank,
        Some(name) => page_of(&krank, name)?,
    };
    let mut roff = Vec::new();
    let rendered = clap_mangen::Man::new(page).render(&mut roff);
    rendered.map_err(|e| Failure::Output(None, e))?;
    write_text(None, &screen.shown(&String::from_utf8_lossy(&roff)))
}

fn page_of(krank: &Command, name: &str) -> Result<Command, Failure> {
    match krank.find_subcommand(name) {
        Some(command) => Ok(command.clone()),
        None => Err(Failure::Usage(words().krank_has_no_command(name))),
    }
}
