//! Where the stroke of a slide ends.

use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{Ball, Constant, SlideId, StrokeEnd};

/// The motion is looked at so many times before each end that was seen is closed in on.
const LOOKS: usize = 720;
/// Halvings until a double has no more digits.
const HALVINGS: u32 = 60;

/// The least or greatest position of a slide in the whole motion, in the scene's unit.
///
/// There the position changes by the square of what the driver is off, so that it is as good as any
/// other.
pub(super) fn end(solver: &Solver, slide: SlideId, end: StrokeEnd) -> Constant {
    let (low, high) = solver.motion().range.ends();
    let mut look = Look {
        solver,
        state: solver.state(),
        enclosure: solver.enclosure(),
        slide,
        sign: match end {
            StrokeEnd::Least => 1.0,
            StrokeEnd::Greatest => -1.0,
        },
    };
    let step = (high - low) / LOOKS as f64;
    let seen: Vec<f64> = (0..=LOOKS)
        .map(|k| look.height(low + step * k as f64))
        .collect();
    let beside = |k: usize| seen.get(k).copied().unwrap_or(f64::INFINITY);
    let lows = (0..=LOOKS).filter(|&k| {
        seen[k] < f64::INFINITY && seen[k] <= beside(k + 1) && seen[k] <= beside(k.wrapping_sub(1))
    });
    let lowest = lows
        .map(|k| look.close_in(low + step * k as f64, step))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    lowest.map_or(Constant::default(), |(_, at)| look.position(at))
}

/// The slide at a coordinate.
struct Look<'a> {
    solver: &'a Solver,
    state: Workspace,
    enclosure: Workspace<Ball>,
    slide: SlideId,
    /// 1 where the least position is meant, else -1.
    sign: f64,
}

impl Look<'_> {
    fn solve(&mut self, at: f64, order: Order) -> Condition {
        self.solver.solve(at, order, &mut self.state)
    }

    /// The height above the end that is meant; infinite where there is none.
    fn height(&mut self, at: f64) -> f64 {
        match self.solve(at, Order::Position) {
            Condition::NoAssembly => f64::INFINITY,
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => {
                self.sign * self.state.travel(self.slide).position
            }
        }
    }

    /// Whether the height falls as the driver's coordinate grows; at a limit nobody can say.
    fn falls(&mut self, at: f64) -> Option<bool> {
        match self.solve(at, Order::Velocity) {
            Condition::Ok | Condition::ChangePoint => {
                Some(self.sign * self.state.travels[self.slide.index()].v < 0.0)
            }
            Condition::DeadPoint | Condition::NoAssembly => None,
        }
    }

    /// The lowest place within a step of one, with its height.
    fn close_in(&mut self, at: f64, step: f64) -> (f64, f64) {
        let mut best = (self.height(at), at);
        let (mut left, mut right) = (at - step, at + step);
        for _ in 0..HALVINGS {
            let middle = left + 0.5 * (right - left);
            match self.falls(middle) {
                Some(true) => left = middle,
                Some(false) => right = middle,
                // Beyond a limit, or on it: back inwards.
                None if middle < at => left = middle,
                None => right = middle,
            }
            let height = self.height(middle);
            if height < best.0 {
                best = (height, middle);
            }
        }
        best
    }

    /// The position at a coordinate, and how far the true one can be from it.
    fn position(&mut self, at: f64) -> Constant {
        self.solve(at, Order::Position);
        self.solver
            .enclose(&mut self.state, Order::Position, &mut self.enclosure);
        let position = self.state.travel(self.slide).position;
        let ball = self.enclosure.travel(self.slide).position;
        Constant {
            hi: position,
            lo: 0.0,
            radius: ball.bound(position).unwrap_or(f64::INFINITY),
        }
    }
}
