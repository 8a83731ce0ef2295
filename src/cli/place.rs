//! Reads the driver coordinate of a command, and notes on the results there.

use super::failure::{Failure, note};
use super::screen::TextScreen;
use crate::Input;
use crate::quantity::{Catalogue, Hidden, MAX_DERIVATIVES, Quantity};
use crate::report::{WrittenDecimal, limits_text, near_misses, stop_before};
use crate::scene::Scene;
use crate::solver::{Solver, State};
use crate::wording::words;
use clap::Args;

/// The options that name a driver coordinate.
#[derive(Debug, Args)]
pub(super) struct PlaceArgs {
    #[arg(help = words().place_of_driver())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    at: Option<WrittenDecimal>,
}

impl PlaceArgs {
    /// Returns the typed driver coordinate; `None` if there is none.
    pub(super) fn typed(&self) -> Option<f64> {
        self.at.map(|at| at.value())
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
    let is_rotary = matches!(driver.input, Input::Turn(_));
    let Some(at) = range.equivalent_in_range(typed, is_rotary) else {
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

/// Returns an error if any existing value of a state is not shown. Runs after all other output is
/// written.
pub(super) fn check_nothing_hidden(scene: &Scene, state: &State) -> Result<(), Failure> {
    let catalogue = Catalogue::new(scene);
    none_hidden(catalogue.all(), &catalogue, state)
}

pub(super) fn none_hidden<'q>(
    quantities: impl IntoIterator<Item = &'q Quantity>,
    catalogue: &Catalogue,
    state: &State,
) -> Result<(), Failure> {
    match Hidden::of(quantities, state) {
        None => Ok(()),
        Some(hidden) => Err(Failure::Cannot(hidden.text(&catalogue.driver().unit))),
    }
}

/// Returns an error if the derivatives by lengths would need too much memory and time.
pub(super) fn check_derivative_count(scene: &Scene, count: usize) -> Result<(), Failure> {
    let lengths = scene.mechanism.lengths().len();
    if lengths.saturating_mul(count) <= MAX_DERIVATIVES {
        return Ok(());
    }
    Err(Failure::Usage(
        words().too_many_sensitivities(count, lengths),
    ))
}

/// Reports the number of values without an error bound.
pub(super) fn note_unproved(unproved: u64, count: u64, screen: TextScreen) {
    if unproved > 0 {
        note(&words().unproved(&unproved, &count), screen);
    }
}

pub(super) fn note_missing_derivatives(missing: u64, count: u64, screen: TextScreen) {
    if missing > 0 {
        note(&words().figures_without_answer(missing, count), screen);
    }
}

/// Warns about nearby change points, where the last digits of the lengths determine how the motion
/// continues.
pub(super) fn note_near_misses(scene: &Scene, solver: &Solver, screen: TextScreen) {
    for text in near_misses(scene, solver) {
        note(&text, screen);
    }
}
