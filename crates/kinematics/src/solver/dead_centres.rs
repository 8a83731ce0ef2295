//! Finds the dead centres of a slide: the positions at which it reverses.
//!
//! Its position s as a function of the driver's coordinate q is smooth except at dead points, and
//! s' is part of every state. A dead centre is a root of s', as accurate as the coordinate itself.

use super::{Condition, Demand, Order, Range, Solver};
use crate::SlideId;
use crate::numeric::roots;

/// Number of intervals over the motion. In each of them s' changes its sign at most once.
const MOTION_INTERVALS: u32 = 720;
/// Distance inside the range at which a dead point, which has no rates, is replaced, relative to
/// the range.
const INSIDE: f64 = 1e-9;

/// A position at which a slide reverses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadCentre {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The position along the guide, in the scene's length unit.
    pub position: f64,
}

impl Solver {
    /// Returns the dead centres of a slide over the motion, ordered by coordinate. They cover one
    /// period, which may begin slightly after 0, or the range including both of its ends, where the
    /// driver reverses. Empty for a slide that does not move, or always moves in the same sense.
    #[must_use]
    pub fn dead_centres(&self, slide: SlideId) -> Vec<DeadCentre> {
        let solver = self.only(&Demand {
            slides: vec![slide],
            ..Demand::default()
        });
        let mut state = solver.state();
        let (low, high) = self.motion.range.ends();
        // Offset from round coordinates, where symmetry puts dead centres.
        let place =
            |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(MOTION_INTERVALS);
        let finest = self.engine.finest();
        let slope = |at| match solver.solve(at, Order::Velocity, &mut state) {
            Condition::Ok | Condition::ChangePoint => Some(state.travels[slide.index()].v),
            Condition::DeadPoint | Condition::NoAssembly => None,
        };
        let turns = match self.motion.range {
            // Past the end of the period to the first place again.
            Range::Full { .. } => roots((0..=MOTION_INTERVALS).map(place), finest, slope),
            Range::Limited { .. } => {
                let inside = INSIDE * (high - low);
                let first = [low + inside].into_iter();
                let places = first
                    .chain((0..MOTION_INTERVALS).map(place))
                    .chain([high - inside]);
                let mut turns = roots(places, finest, slope);
                turns.insert(0, low);
                turns.push(high);
                turns
            }
        };
        let centre = |at| {
            let exists = solver.solve(at, Order::Position, &mut state) != Condition::NoAssembly;
            let position = state.sliding(slide).position;
            exists.then_some(DeadCentre { at, position })
        };
        turns.into_iter().filter_map(centre).collect()
    }
}
