//! The dead centres of a slide: where it turns back.
//!
//! Its position s over the driver's coordinate q is smooth but at dead points, and s' comes with every
//! state: a dead centre is a root of s', as good as the coordinate itself.

use super::{Condition, Demand, Order, Range, Solver};
use crate::SlideId;
use crate::numeric::roots;

/// Places over the motion between which s' changes its sign once at the most.
const LOOKS: u32 = 720;
/// A dead point has no rates; it is looked at from this far inside, as a part of the range.
const INSIDE: f64 = 1e-9;

/// A place at which a slide turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadCentre {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The position along the guide, in the scene's length unit.
    pub position: f64,
}

impl Solver {
    /// The dead centres of a slide over the motion, by coordinate: over one period, which may begin a
    /// little behind 0, or over the range with both of its ends, where the driver turns. None for a slide
    /// that stands still, or goes one way, round and round.
    #[must_use]
    pub fn dead_centres(&self, slide: SlideId) -> Vec<DeadCentre> {
        let solver = self.only(&Demand {
            slides: vec![slide],
            ..Demand::default()
        });
        let mut state = solver.state();
        let (low, high) = self.motion.range.ends();
        // Beside round coordinates, where symmetry puts dead centres.
        let place = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(LOOKS);
        let finest = self.engine.finest();
        let slope = |at| match solver.solve(at, Order::Velocity, &mut state) {
            Condition::Ok | Condition::ChangePoint => Some(state.travels[slide.index()].v),
            Condition::DeadPoint | Condition::NoAssembly => None,
        };
        let turns = match self.motion.range {
            // Round the end of the period to the first place again.
            Range::Full { .. } => roots((0..=LOOKS).map(place), finest, slope),
            Range::Limited { .. } => {
                let inside = INSIDE * (high - low);
                let first = [low + inside].into_iter();
                let places = first.chain((0..LOOKS).map(place)).chain([high - inside]);
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
