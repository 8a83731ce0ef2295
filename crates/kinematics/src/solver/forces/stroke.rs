//! Where the stroke of a slide ends.

use crate::solver::{DeadCentre, Order, Solver};
use crate::{Constant, SlideId, StrokeEnd};

/// The end of a slide's stroke.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stroke {
    /// Its position, in the scene's unit along the guide.
    pub(super) bottom: Constant,
    /// The driver's coordinate there.
    pub(super) at: f64,
}

/// The least or greatest position of a slide in the whole motion, in the scene's unit, and how far the
/// true one can be from it.
///
/// There the position changes by the square of what the driver is off, so that it is as good as any
/// other.
pub(super) fn end(solver: &Solver, slide: SlideId, end: StrokeEnd) -> Stroke {
    let centres = solver.dead_centres(slide).into_iter();
    let by_position = |a: &DeadCentre, b: &DeadCentre| a.position.total_cmp(&b.position);
    let last = match end {
        StrokeEnd::Least => centres.min_by(by_position),
        StrokeEnd::Greatest => centres.max_by(by_position),
    };
    // One that never turns stands still, and is everywhere at its end.
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
