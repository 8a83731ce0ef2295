//! `krank solve`: finds values of a scene that meet goals, or optimal ones.

use super::study::named_axes;
use crate::cli::failure::{Failure, note};
use crate::cli::formats::TextOrJson;
use crate::cli::output::{self, OutputArgs, write_scene, write_text};
use crate::cli::progress::Progress;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SceneSource, SolvableScene, read};
use crate::parallel;
use crate::quantity::Catalogue;
use crate::report::{BestReport, GoalReport, no_best};
use crate::study::{
    BestDesign, CycleFigure, Design, DesignFigures, DesignSpace, Goal, GoalSearch, OptimiseOrder,
    PlanAxis,
};
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct SolveArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().values_to_vary())]
    #[arg(long, value_name = "NAME[=LOW..HIGH]", required = true)]
    vary: Vec<String>,
    #[arg(help = words().goal_to_meet())]
    #[arg(long, value_name = "GOAL")]
    goal: Vec<String>,
    #[arg(help = words().limit_to_keep())]
    #[arg(long, value_name = "GOAL")]
    keep: Vec<String>,
    #[arg(help = words().figure_to_minimize())]
    #[arg(long, value_name = "FIGURE", conflicts_with = "maximize")]
    minimize: Option<String>,
    #[arg(help = words().figure_to_maximize())]
    #[arg(long, value_name = "FIGURE")]
    maximize: Option<String>,
    #[arg(help = words().starts_of_search())]
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u32).range(0..=100_000))]
    starts: u32,
    #[arg(help = words().generations_of_search())]
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    generations: u32,
    #[arg(help = words().seed_of_search())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    #[arg(help = words().design_to_write())]
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pick: u32,
    #[arg(help = words().resume_search())]
    #[arg(long)]
    resume: bool,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
    #[command(flatten)]
    output: OutputArgs,
}

/// Decimals of the best value in the progress line.
const SHOWN_DECIMALS: usize = 4;

pub(in crate::cli) fn solve(args: &SolveArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open()?;
    let vary = named_axes(&args.vary)?;
    let space = DesignSpace::of_axes(&scene, &solver, &vary)
        .map_err(|why| Failure::Usage(words().of_option("--vary", &why)))?;
    let catalogue = Catalogue::new(&scene);
    let goals = |texts: &[String], option| goals(texts, option, &catalogue);
    let (requested, kept) = (goals(&args.goal, "--goal")?, goals(&args.keep, "--keep")?);
    let best = args.maximize.as_ref().or(args.minimize.as_ref());
    match best {
        None if requested.is_empty() => Err(Failure::Usage(words().no_goal_given().into())),
        None if args.resume => Err(Failure::Usage(words().resume_needs_best().into())),
        Some(_) if !requested.is_empty() => Err(Failure::Usage(words().goals_and_best().into())),
        None => meet(
            args,
            &space,
            &vary,
            requested.into_iter().chain(kept).collect(),
            screen,
        ),
        Some(name) => {
            let of = |why: &dyn std::fmt::Display| Failure::Usage(why.to_string());
            let figure = CycleFigure::parse(name, &catalogue).map_err(|why| of(&why))?;
            optimise(args, &space, &vary, (figure, &kept), screen)
        }
    }
}

fn goals(texts: &[String], option: &str, catalogue: &Catalogue) -> Result<Vec<Goal>, Failure> {
    let goal = |text: &String| Goal::parse(text, catalogue);
    let goals = texts.iter().map(goal).collect::<Result<_, _>>();
    goals.map_err(|why| Failure::Usage(words().of_option(option, &why)))
}

/// Finds values that meet the goals.
fn meet(
    args: &SolveArgs,
    space: &DesignSpace,
    vary: &[PlanAxis],
    goals: Vec<Goal>,
    screen: TextScreen,
) -> Result<(), Failure> {
    let figures = goals.iter().map(|goal| goal.figure.clone()).collect();
    let mut figures = DesignFigures::new(space, figures, None);
    let given = figures.of(&space.given()).ok();
    let search = GoalSearch::new(figures, goals.clone(), vary);
    let count = u64::from(args.starts) + 1;
    let progress = Progress::new(count, words().starts_counted(), screen, false);
    let mut progress = progress.stoppable();
    let outcome = search.run(args.starts, args.seed, parallel::cores(), &mut |part| {
        progress.report_progress((part * count as f64).round() as u64);
        !progress.is_stopped()
    });
    end(progress, screen);
    let report = GoalReport {
        space,
        goals: &goals,
        given,
        outcome: &outcome,
    };
    let number = usize::try_from(args.pick).unwrap_or(usize::MAX);
    // Saved before it is printed: the terminal may be closed.
    let saved = match outcome.solutions.get(number - 1) {
        _ if outcome.solutions.is_empty() => Err(Failure::Cannot(words().goals_not_met().into())),
        Some(found) => save(args, space, &found.design, screen),
        None => Err(Failure::Usage(
            words().no_such_design(number, outcome.solutions.len()),
        )),
    };
    write_output(args, &report.to_text(screen.ascii), || {
        format!("{:#}", report.to_json())
    })?;
    saved
}

/// Finds the values that maximize or minimize a quantity.
fn optimise(
    args: &SolveArgs,
    space: &DesignSpace,
    vary: &[PlanAxis],
    (figure, kept): (CycleFigure, &[Goal]),
    screen: TextScreen,
) -> Result<(), Failure> {
    if let Some(axis) = vary.iter().find(|axis| axis.ends.is_none()) {
        return Err(Failure::Usage(words().free_without_ends(&axis.name)));
    }
    let known = known_designs(args, space)?;
    let all = std::iter::once(figure.clone());
    let all = all
        .chain(kept.iter().map(|goal| goal.figure.clone()))
        .collect();
    let mut figures = DesignFigures::new(space, all, None);
    let order = OptimiseOrder {
        greatest: args.maximize.is_some(),
        generations: args.generations,
        seed: args.seed,
        threads: parallel::cores(),
    };
    let generations = u64::from(args.generations);
    let progress = Progress::new(generations, words().generations_counted(), screen, false);
    let mut progress = progress.stoppable();
    let best = BestDesign::find_from(&known, &figures, kept, vary, order, &mut |state| {
        if let Some(best) = state.best {
            let best = format!("{best:.SHOWN_DECIMALS$} {}", figure.unit());
            let best = best.trim_end();
            progress.show_best(match state.missed > 0.0 {
                true => words().value_misses_limits(best),
                false => best.to_owned(),
            });
        }
        progress.report_progress(u64::from(state.generations));
        !progress.is_stopped()
    });
    end(progress, screen);
    let given = figures.of(&space.given()).ok();
    let best =
        best.ok_or_else(|| Failure::Cannot(no_best(space, figures.figures(), given.as_deref())))?;
    let design = space
        .open(&best.numbers)
        .map_err(|why| Failure::Cannot(why.reason()))?;
    let report = BestReport {
        space,
        figure: &figure,
        greatest: order.greatest,
        constraints: kept,
        given,
        figures: figures.of(&best.numbers).unwrap_or_default(),
        best: &best,
        design: &design,
    };
    // Saved before it is printed: the terminal may be closed.
    let saved = match best.missed > 0.0 {
        true => Err(Failure::Cannot(words().keeps_nothing().into())),
        false => save(args, space, &design, screen),
    };
    write_output(args, &report.to_text(screen.ascii), || {
        format!("{:#}", report.to_json())
    })?;
    saved
}

/// Returns the design in the output file if the search is resumed and the file exists.
fn known_designs(args: &SolveArgs, space: &DesignSpace) -> Result<Vec<Vec<f64>>, Failure> {
    if !args.resume {
        return Ok(Vec::new());
    }
    let Some(path) = output::file(args.output.output.as_deref()) else {
        return Err(Failure::Usage(words().resume_needs_scene().into()));
    };
    if !path.exists() {
        return Ok(Vec::new());
    }
    let scene = read(&SceneSource::File(path.to_owned()))?;
    let numbers = space.numbers_in(&scene).map_err(|name| {
        let shown = path.display().to_string();
        Failure::Usage(words().scene_of_other_search(&shown, &name))
    })?;
    Ok(vec![numbers])
}

/// Ends the progress line and notes whether the search was stopped.
fn end(progress: Progress, screen: TextScreen) {
    let is_stopped = progress.is_stopped();
    progress.end();
    if is_stopped {
        note(words().search_was_stopped(), screen);
    }
}

fn write_output(
    args: &SolveArgs,
    text: &str,
    json: impl FnOnce() -> String,
) -> Result<(), Failure> {
    match args.format {
        TextOrJson::Text => write_text(None, text),
        TextOrJson::Json => write_text(None, &(json() + "\n")),
    }
}

/// Writes the scene with these values, if a file is named.
fn save(
    args: &SolveArgs,
    space: &DesignSpace,
    design: &Design,
    screen: TextScreen,
) -> Result<(), Failure> {
    let Some(path) = args.output.output.as_deref() else {
        return Ok(());
    };
    if design.is_held {
        note(words().start_was_written(), screen);
    }
    if !design.moves_like(space.solver()) {
        note(words().moves_otherwise(), screen);
    }
    write_scene(Some(path), &text(design))
}

/// Returns the text of a design, which opens in its assembly.
fn text(design: &Design) -> String {
    let at = design.scene.mechanism.driver().start;
    let started = design
        .is_held
        .then(|| design.scene.with_start_of(&design.solver, at));
    let started = started.flatten();
    started.unwrap_or_else(|| design.scene.text().to_owned())
}
