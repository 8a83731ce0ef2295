//! Three poses: every pivot has a pin and every pin a pivot, each from two linear equations (the
//! bisectors of its positions). In every direction there is one slide, and the pins of the slides
//! are on a circle.
//!
//! Free values come from grids: the result is a selection.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use super::form;
use super::space;
use crate::PoseTask;
use kinematics::{Double, Vec2};

/// Number of pivots along each side of their box, and number of pins along each side of theirs.
const PIVOTS: u8 = 9;
const PINS: u8 = 7;
/// Half a side of these boxes, in sizes, if no box is given.
const HALF_SIDE: f64 = 1.25;
/// Number of slide directions in half a turn.
const DIRECTIONS: u8 = 24;

/// Returns dyads on a grid of pivots, on a grid of pins, and with slides in all directions.
/// `inside` are two opposite corners of a box preferred for pivots; without it the grids are
/// `times` as wide as usual.
pub(super) fn dyads(
    guidance: &Guidance,
    task: &PoseTask,
    inside: Option<[Vec2; 2]>,
    times: f64,
) -> Vec<FullDyad> {
    let reach = Vec2::new(1.0, 1.0) * (HALF_SIDE * times * guidance.size);
    let count = task.poses.len() as f64;
    let middle = task
        .poses
        .iter()
        .fold(Vec2::ZERO, |sum, pose| sum + pose.at / count);
    let corners = inside.unwrap_or([middle - reach, middle + reach]);
    let pivots = grid(corners, PIVOTS).filter_map(|at| guidance.on_pivot(at));
    let pins = grid([-reach, reach], PINS).filter_map(|at| guidance.on_pin(at));
    pivots.chain(pins).chain(slides(guidance)).collect()
}

/// Returns the centres of the cells of a box.
fn grid([low, high]: [Vec2; 2], side: u8) -> impl Iterator<Item = Vec2> {
    let part = move |k: u8| (f64::from(k) + 0.5) / f64::from(side);
    let size = high - low;
    let places = (0..side).flat_map(move |i| (0..side).map(move |k| (part(i), part(k))));
    places.map(move |(x, y)| low + Vec2::new(x * size.x, y * size.y))
}

/// Returns the slides of the circle of pins with collinear positions, direction by direction.
fn slides(guidance: &Guidance) -> impl Iterator<Item = FullDyad> {
    (0..DIRECTIONS).filter_map(|k| {
        let normal = Double::unit(180.0 * f64::from(k) / f64::from(DIRECTIONS));
        let normal = [normal.x, normal.y, Double::ZERO];
        let rows = guidance.forms.iter().map(|f| form::of_pivot(f, normal));
        let rows: Vec<space::Triple> = rows.collect();
        guidance.dyad(space::kernel(&rows)?, normal)
    })
}
