//! Finds the coordinates at which nonlinear springs have kinks or jumps. Gas springs have kinks at
//! the lengths of their knots, and torsion springs jump opposite their free angle, where the angle
//! wraps around.

use crate::angle::{TURN, unit};
use crate::numeric::roots;
use crate::solver::{Condition, Demand, Order, Solver, Workspace};
use crate::{Body, LinkId, Load, PointId, Profile};

/// Number of places of the motion; two kinks of a spring between neighbours may be missed.
const PLACES: u32 = 720;

/// Finds the driver's coordinates at which springs have kinks or jumps.
pub(super) struct SpringBends<'a> {
    solver: &'a Solver,
    coordinates: Vec<f64>,
}

impl SpringBends<'_> {
    pub(super) fn over(solver: &Solver) -> SpringBends<'_> {
        let (low, high) = solver.motion().range.ends();
        let share = |k: u32| f64::from(k) / f64::from(PLACES);
        let place = |k: u32| match k {
            PLACES => high,
            _ => low + (high - low) * share(k),
        };
        SpringBends {
            solver,
            coordinates: (0..=PLACES).map(place).collect(),
        }
    }

    /// Adds the coordinates of a load.
    pub(super) fn of(&self, load: &Load, to: &mut Vec<f64>) {
        match *load {
            Load::GasSpring {
                from,
                to: end,
                ref force,
                ..
            } => self.lengths([from, end], force, to),
            Load::TorsionSpring {
                link,
                to: fixed,
                angle,
                ..
            } => self.turns((link, fixed), angle, to),
            Load::Force { .. } | Load::Torque { .. } | Load::Press { .. } | Load::Spring { .. } => {
            }
        }
    }

    /// Adds the coordinates at which the distance of two points equals a knot's length.
    fn lengths(&self, ends: [PointId; 2], force: &Profile, to: &mut Vec<f64>) {
        let demand = Demand {
            points: ends.to_vec(),
            ..Demand::default()
        };
        let mut knots: Vec<f64> = force.knots().iter().map(|knot| knot[0]).collect();
        knots.dedup();
        for length in knots {
            let found = self.zeros(&demand, |state| {
                let [a, b] = ends.map(|point| state.position(point));
                Some((b? - a?).norm() - length)
            });
            to.extend(found);
        }
    }

    /// Adds the coordinates at which two bodies are half a turn from the free angle.
    fn turns(&self, (link, fixed): (LinkId, Body), free: f64, to: &mut Vec<f64>) {
        let links = match fixed {
            Body::Ground => vec![link],
            Body::Link(other) => vec![link, other],
        };
        let demand = Demand {
            links: links.clone(),
            ..Demand::default()
        };
        let turn = |state: &Workspace| {
            let angles: Option<Vec<f64>> = links.iter().map(|&link| state.angle(link)).collect();
            let angles = angles?;
            let other = angles.get(1).copied().unwrap_or(0.0);
            Some(unit(angles.first()? - other - free - 0.5 * TURN))
        };
        let found = self.zeros(&demand, |state| {
            // Only sign changes near half a turn count.
            let turn = turn(state)?;
            (turn.x > 0.0).then_some(turn.y)
        });
        to.extend(found);
    }

    fn zeros(&self, demand: &Demand, f: impl Fn(&Workspace) -> Option<f64>) -> Vec<f64> {
        let solver = self.solver.only(demand);
        let mut state = solver.state();
        roots(self.coordinates.iter().copied(), f64::EPSILON, |at| {
            let condition = solver.solve(at, Order::Position, &mut state);
            (condition != Condition::NoAssembly).then(|| f(&state))?
        })
    }
}

#[cfg(test)]
mod tests;
