//! Builds the mechanism of a proposal.

use crate::{PinConstraint, Proposal, Task, TaskKind};
use kinematics::angle::degrees;
use kinematics::solver::Solver;
use kinematics::{Body, Driver, Input, LinkId, Mechanism, PointId};

/// A proposal as a mechanism, opened at the first point of its task, with the elements to be
/// measured.
#[derive(Debug)]
pub(crate) struct Machine {
    pub(crate) solver: Solver,
    pub(crate) c: PointId,
    /// The led point; `None` for a function.
    pub(crate) tracer: Option<PointId>,
    pub(crate) coupler: LinkId,
}

impl Machine {
    /// Builds the mechanism of a proposal and plans its solution. Returns `None` if the proposal
    /// has no places, if a length is not valid, or if it cannot be assembled.
    pub(crate) fn open(task: &Task, proposal: &Proposal) -> Option<Machine> {
        let [at_b, at_c] = *proposal.places.first()?;
        let (crank_length, coupler_length, rocker_length) = proposal.lengths()?;
        let mut builder = Mechanism::builder();
        // As in the scene file of the proposal, numbers are compared by their written decimals.
        builder.decimals();
        let a = builder.ground_point(proposal.pivot.x, proposal.pivot.y);
        let [b, c] = [builder.moving_point(), builder.moving_point()];
        let crank = builder.link(a, b, crank_length);
        let coupler = builder.link(b, c, coupler_length);
        let guided = match task.kind {
            TaskKind::Function(_) => None,
            TaskKind::Poses(_) | TaskKind::Path(_) => proposal.tracer,
        };
        let tracer = guided.map(|at| {
            let along = (at_c - at_b) * (1.0 / coupler_length);
            let tracer = builder.moving_point();
            builder.carry(coupler, tracer, (at - at_b).turned(along.conj()));
            tracer
        });
        match (proposal.partner, rocker_length) {
            (PinConstraint::Rocker(at), Some(length)) => {
                let d = builder.ground_point(at.x, at.y);
                builder.link(c, d, length);
            }
            (PinConstraint::Slide(angle), _) => {
                builder.pin_in_slot(c, Body::Ground, at_c, angle);
            }
            (PinConstraint::Rocker(_), None) => return None,
        }
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: degrees(at_b - proposal.pivot),
            speed: 1.0,
            acceleration: 0.0,
        });
        builder.start(c, at_c);
        let solver = Solver::new(&builder.build().ok()?).ok()?;
        Some(Machine {
            solver,
            c,
            tracer,
            coupler,
        })
    }
}
