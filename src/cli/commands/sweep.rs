//! `krank sweep`: writes values row by row over the motion.

use super::args::SweepArgs;
use super::commands::{check_derivative_count, note_lacking, note_near_misses, note_unproved};
use super::failure::{Failure, note};
use super::measured::beside;
use super::output::{goes_to_terminal, write_to};
use super::progress::Progress;
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::Input;
use crate::quantity::{Catalogue, Clock, Quantity, TimeError, UnknownColumn};
use crate::report::{
    Columns, ExtraColumns, Missing, Steps, Sweep, SweepOutcome, WrittenDecimal, limits_text,
};
use crate::scene::Scene;
use crate::solver::{Order, Range};
use crate::study::motor;
use crate::wording::words;

/// Default step of a turning driver, in degrees.
const STEP: f64 = 1.0;
/// Minimum number of steps of a slide over the sweep. The default step is the largest of 1, 2 or 5
/// times a power of ten that gives as many.
const STEPS_OF_A_SLIDE: f64 = 100.0;

pub(super) fn sweep(args: &SweepArgs, screen: TextScreen) -> Result<(), Failure> {
    let digits = usize::from(args.figures.digits);
    let format = args.figures.csv.rows(args.format, digits)?;
    let opened = args.scene.open_for(&args.output)?;
    if let Some(file) = &args.measured {
        return beside(file, args, format, &opened, screen);
    }
    let SolvableScene { scene, solver } = opened;
    let mut catalogue = Catalogue::new(&scene);
    let figures = figures(&mut catalogue, &args.columns)?;
    let columns = Columns::new(catalogue.driver(), &figures, !args.figures.no_units);
    let besides = ExtraColumns {
        bounds: args.figures.bounds,
        sensitivity: args.figures.sensitivity,
    };
    if besides.sensitivity {
        check_derivative_count(&scene, figures.len())?;
    }
    let columns = columns.with(besides, scene.unit.symbol());
    let range = solver.motion().range;
    let ends = RowEnds {
        from: args.from,
        to: args.to,
        step: args.step,
    };
    let clock = args.time.then(|| clock(&scene)).transpose()?;
    let (columns, steps) = match &clock {
        Some(clock) => (columns.over_time(), times(clock.span(range), ends)?),
        None => {
            tell_of_motion(&scene, screen);
            let range = whole(&scene, range, &figures);
            (columns, steps(&scene, range, ends, STEP)?)
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
    let mut progress = Progress::new(
        steps.count(),
        words().rows(),
        screen,
        goes_to_terminal(path),
    );
    let outcome = write_to(path, |out| {
        sweep.write(out, &mut |rows| progress.tell(rows))
    });
    progress.end();
    let outcome = outcome?;
    note_near_misses(&scene, &solver, screen);
    let driver = catalogue.driver();
    judge(&outcome, &limits_text(range, driver), screen)?;
    match &outcome.first_hidden {
        None => Ok(()),
        Some(first) => Err(Failure::Cannot(words().rows_withheld(
            outcome.hidden,
            outcome.rows,
            &first.text(&driver.unit),
        ))),
    }
}

/// Returns the quantities that the patterns name or define. Without patterns, returns all of them
/// except those of marks. The driver and the state may be named, although they have columns anyway.
pub(super) fn figures(
    catalogue: &mut Catalogue,
    patterns: &[String],
) -> Result<Vec<Quantity>, Failure> {
    if patterns.is_empty() {
        return Ok(catalogue.usual());
    }
    let mut figures = Vec::new();
    let patterns = patterns.iter().flat_map(|list| entries(list));
    let patterns: Vec<&str> = patterns.map(str::trim).collect();
    for (number, pattern) in patterns.iter().enumerate() {
        if *pattern == "state" {
            continue;
        }
        let found = named(catalogue, "--columns", pattern);
        let around = patterns.get(number.saturating_sub(1)..).unwrap_or_default();
        let mend = || around.windows(2).take(2).find_map(cut_number);
        for figure in found.map_err(|fault| mend().unwrap_or(fault))? {
            if !figures.contains(&figure) {
                figures.push(figure);
            }
        }
    }
    Ok(figures)
}

/// Returns the error for a formula that a decimal comma cut into two entries.
fn cut_number(pair: &[&str]) -> Option<Failure> {
    let &[before, pattern] = pair else {
        return None;
    };
    let is_digit = |c: char| c.is_ascii_digit();
    let is_cut =
        before.contains('=') && before.ends_with(is_digit) && pattern.starts_with(is_digit);
    let head = before.rsplit(|c| !is_digit(c)).next()?;
    let tail = pattern.split(|c| !is_digit(c)).next()?;
    is_cut.then(|| {
        Failure::Usage(words().of_option("--columns", &words().number_with_comma(head, tail)))
    })
}

/// Returns the quantities of a pattern. `name = formula` defines a new quantity.
pub(super) fn named(
    catalogue: &mut Catalogue,
    option: &str,
    pattern: &str,
) -> Result<Vec<Quantity>, Failure> {
    if pattern.contains('=') {
        let defined = catalogue.define(pattern);
        let wrong = |why: String| Failure::Usage(words().of_option(option, &why));
        return Ok(vec![defined.map_err(wrong)?]);
    }
    let unknown = |e: UnknownColumn| Failure::Usage(words().of_option(option, &e));
    catalogue.select(&[pattern]).map_err(unknown)
}

/// Splits a list at commas, except within the parentheses of a formula.
pub(super) fn entries(list: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    list.split(move |c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    })
}

/// Reports rows without values. A sweep without any values is an error.
fn judge(outcome: &SweepOutcome, range: &str, screen: TextScreen) -> Result<(), Failure> {
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
    if missing.unanswered > 0 {
        let rows = missing.unanswered;
        note(
            &words().rows_without_answer(rows, valued, words().no_derivatives_by_lengths()),
            screen,
        );
    }
    note_lacking(missing.lacking, missing.asked, screen);
}

/// The limits and step of the rows, as far as given.
#[derive(Clone, Copy)]
pub(super) struct RowEnds {
    pub(super) from: Option<WrittenDecimal>,
    pub(super) to: Option<WrittenDecimal>,
    pub(super) step: Option<WrittenDecimal>,
}

/// Returns the steps of the rows. A missing limit is that of the motion and gets a row of its own.
/// `turn` is the default step of a turning driver, in degrees.
pub(super) fn steps(
    scene: &Scene,
    range: Range,
    ends: RowEnds,
    turn: f64,
) -> Result<Steps, Failure> {
    let down = ends.step.is_some_and(|step| step.value() < 0.0);
    let from = match ends.from {
        Some(from) => from,
        None => decimal(first(range, down))?,
    };
    let to = match ends.to {
        Some(to) => to,
        None => decimal(last(range, down, from.value()))?,
    };
    let step = match (ends.step, scene.mechanism.driver().input) {
        (Some(step), _) => step,
        (None, Input::Turn(_)) => decimal(turn)?,
        (None, Input::Push(_)) => decimal(slide_step(from.value(), to.value()))?,
    };
    let steps = Steps::new(from, to, step).map_err(|e| Failure::Usage(e.to_string()))?;
    Ok(match ends.to {
        Some(_) => steps,
        None => steps.ending_on(to.value()),
    })
}

/// Returns the clock that maps time to the driver coordinate.
pub(super) fn clock(scene: &Scene) -> Result<Clock, Failure> {
    let stands = || Failure::Cannot(words().of_option("--time", &TimeError::StandsStill));
    Clock::of(scene).ok_or_else(stands)
}

/// Notes that rows by coordinate use the scene's constant speed, if the scene has a motion over
/// time.
pub(super) fn tell_of_motion(scene: &Scene, screen: TextScreen) {
    let unit = match scene.mechanism.driver().input {
        Input::Turn(_) => "rad/s".to_owned(),
        Input::Push(_) => format!("{}/s", scene.unit.symbol()),
    };
    if scene.motion.is_some() {
        note(&words().rates_by_coordinate(&unit), screen);
    }
}

/// Returns the times of the rows. A missing limit is that of the motion and gets a row of its own.
fn times((begin, end): (f64, f64), ends: RowEnds) -> Result<Steps, Failure> {
    let given = |given: Option<WrittenDecimal>, other| given.map_or_else(|| decimal(other), Ok);
    let (from, to) = (given(ends.from, begin)?, given(ends.to, end)?);
    let step = given(ends.step, slide_step(from.value(), to.value()))?;
    let steps = Steps::new(from, to, step).map_err(|e| Failure::Usage(e.to_string()))?;
    Ok(match ends.to {
        Some(_) => steps,
        None => steps.ending_on(to.value()),
    })
}

/// Returns the default range of a sweep: the motion, repeated for as many periods as the loads need
/// to repeat if forces are included.
fn whole(scene: &Scene, range: Range, figures: &[Quantity]) -> Range {
    let has_forces = figures.iter().any(|q| q.order() == Order::Force);
    let repeats = motor::repeats(&scene.mechanism, range).filter(|_| has_forces);
    match (range, repeats) {
        (Range::Full { period }, Some(times)) => Range::Full {
            period: period * f64::from(times),
        },
        _ => range,
    }
}

/// Converts a limit to a decimal; limits are finite.
fn decimal(value: f64) -> Result<WrittenDecimal, Failure> {
    WrittenDecimal::of(value).ok_or_else(|| Failure::Cannot(words().no_finite_limits().into()))
}

/// Returns the default start of a sweep.
pub(super) fn first(range: Range, down: bool) -> f64 {
    match (range, down) {
        (Range::Full { .. }, false) => 0.0,
        (Range::Full { period }, true) => period,
        (Range::Limited { low, .. }, false) => low,
        (Range::Limited { high, .. }, true) => high,
    }
}

/// Returns the default end of a sweep: one period on, or the limit.
pub(super) fn last(range: Range, down: bool, from: f64) -> f64 {
    match (range, down) {
        (Range::Full { period }, false) => from + period,
        (Range::Full { period }, true) => from - period,
        (Range::Limited { high, .. }, false) => high,
        (Range::Limited { low, .. }, true) => low,
    }
}

/// Returns the default step of a slide: 1, 2 or 5 times a power of ten, in the direction of the
/// sweep.
fn slide_step(from: f64, to: f64) -> f64 {
    let most = ((to - from) / STEPS_OF_A_SLIDE).abs();
    // A single row, or limits without a representable distance: any step will do.
    if !most.is_normal() {
        return 1.0;
    }
    let ten = most.log10().floor();
    let size = [5.0, 2.0, 1.0]
        .map(|n| format!("{n}e{ten}").parse().unwrap_or(most))
        .into_iter()
        .find(|step: &f64| *step <= most)
        .unwrap_or(most);
    if to < from { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_in_brackets_belong_to_a_formula() {
        let found: Vec<&str> = entries("C.x,d = hypot(C.x, min(C.y, D.y)),,*").collect();
        assert_eq!(found, ["C.x", "d = hypot(C.x, min(C.y, D.y))", "", "*"]);
        assert_eq!(entries("),a").collect::<Vec<_>>(), [")", "a"]);
    }

    #[test]
    fn a_slide_takes_round_steps() {
        assert_eq!(slide_step(0.0, 1.0), 0.01);
        assert_eq!(slide_step(0.0, 0.7), 0.005);
        assert_eq!(slide_step(300.0, 50.0), -2.0);
        assert_eq!(slide_step(5.0, 5.0), 1.0);
    }

    #[test]
    fn ends_that_are_left_out_are_those_of_the_motion() {
        let ends = |range, down| (first(range, down), last(range, down, first(range, down)));
        let full = Range::Full { period: 720.0 };
        assert_eq!(ends(full, false), (0.0, 720.0));
        assert_eq!(ends(full, true), (720.0, 0.0));
        assert_eq!(last(full, false, 30.0), 750.0);
        let limited = Range::Limited {
            low: -3.0,
            high: 9.5,
        };
        assert_eq!(ends(limited, false), (-3.0, 9.5));
        assert_eq!(ends(limited, true), (9.5, -3.0));
    }
}
