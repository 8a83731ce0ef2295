//! Coordinates or times of rows over the motion.

use super::failure::{Failure, note};
use super::output::{write_to, writes_to_terminal};
use super::progress::Progress;
use super::screen::TextScreen;
use crate::Input;
use crate::quantity::{Clock, TimeError};
use crate::report::{Steps, WrittenDecimal};
use crate::scene::Scene;
use crate::solver::Range;
use crate::wording::words;
use std::io::{self, Write};
use std::path::Path;

/// Minimum number of steps of a slide over the sweep. The default step is the largest of 1, 2 or 5
/// times a power of ten that gives as many.
const STEPS_OF_A_SLIDE: f64 = 100.0;

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

/// Writes the rows of `steps` to a file or to standard output, with their progress. `write` gets the
/// output and the routine that takes the number of rows written so far.
pub(super) fn write_rows<T>(
    path: Option<&Path>,
    steps: &Steps,
    screen: TextScreen,
    mut write: impl FnMut(&mut dyn Write, &mut dyn FnMut(u64)) -> io::Result<T>,
) -> Result<T, Failure> {
    let is_shown = writes_to_terminal(path);
    let mut progress = Progress::new(steps.count(), words().rows(), screen, is_shown);
    let outcome = write_to(path, |out| {
        write(out, &mut |rows| progress.report_progress(rows))
    });
    progress.end();
    outcome
}

/// Returns the clock that maps time to the driver coordinate.
pub(super) fn clock(scene: &Scene) -> Result<Clock, Failure> {
    let driver_states = || Failure::Cannot(words().of_option("--time", &TimeError::StandsStill));
    Clock::of(scene).ok_or_else(driver_states)
}

/// Notes that rows by coordinate use the scene's constant speed, if the scene has a motion over
/// time.
pub(super) fn note_constant_speed(scene: &Scene, screen: TextScreen) {
    let unit = format!(
        "{}/s",
        scene.input_rate_unit(scene.mechanism.driver().input)
    );
    if scene.motion.is_some() {
        note(&words().rates_by_coordinate(&unit), screen);
    }
}

/// Returns the times of the rows. A missing limit is that of the motion and gets a row of its own.
pub(super) fn times((start, end): (f64, f64), ends: RowEnds) -> Result<Steps, Failure> {
    let given = |given: Option<WrittenDecimal>, other| given.map_or_else(|| decimal(other), Ok);
    let (from, to) = (given(ends.from, start)?, given(ends.to, end)?);
    let step = given(ends.step, slide_step(from.value(), to.value()))?;
    let steps = Steps::new(from, to, step).map_err(|e| Failure::Usage(e.to_string()))?;
    Ok(match ends.to {
        Some(_) => steps,
        None => steps.ending_on(to.value()),
    })
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
    let maximum = ((to - from) / STEPS_OF_A_SLIDE).abs();
    // A single row, or limits without a representable distance: any step will do.
    if !maximum.is_normal() {
        return 1.0;
    }
    let ten = maximum.log10().floor();
    let size = [5.0, 2.0, 1.0]
        .map(|n| format!("{n}e{ten}").parse().unwrap_or(maximum))
        .into_iter()
        .find(|step: &f64| *step <= maximum)
        .unwrap_or(maximum);
    if to < from { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

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
