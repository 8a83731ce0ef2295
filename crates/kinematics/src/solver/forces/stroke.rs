//! Finds the end of a slide's stroke.

use crate::solver::{DeadCentre, Order, Solver};
use crate::{Constant, SlideId, StrokeEnd};

/// The end of a slide's stroke.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stroke {
    /// The position of the end along the guide, in the scene's unit.
    pub(super) bottom: Constant,
    /// The driver's coordinate there.
    pub(super) at: f64,
}

/// Returns the minimum or maximum position of a slide in the whole motion, in the scene's unit,
/// with its error bound.
///
/// An error of the driver's coordinate changes this position only by its square, so the position is
/// as accurate as any other.
pub(super) fn end(solver: &Solver, slide: SlideId, end: StrokeEnd) -> Stroke {
    let centres = solver.dead_centres(slide).into_iter();
    let by_position = |a: &DeadCentre, b: &DeadCentre| a.position.total_cmp(&b.position);
    let last = match end {
        StrokeEnd::Minimum => centres.min_by(by_position),
        StrokeEnd::Maximum => centres.max_by(by_position),
    };
    // A slide that never reverses is at rest, and at its end everywhere.
    let at = last.map_or(solver.opening, |centre| centre.at);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let _ = solver.solve(at, Order::Position, &mut state);
    solver.enclose(&mut state, Order::Position, &mut enclosure);
    let position = state.sliding(slide).position;
    let ball = enclosure.sliding(slide).position;
    let bottom = Constant {
        hi: position,
        radius: ball.bound(position).unwrap_or(f64::INFINITY),
        ..Constant::default()
    };
    Stroke { bottom, at }
}
