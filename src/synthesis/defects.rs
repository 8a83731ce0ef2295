//! What keeps a linkage from doing its task, decided by the signs of its assembly and the range of its crank.

use super::way::{self, Way};
use super::{Partner, Proposal, Wishes};
use crate::angle::{degrees, unit};
use crate::solver::Range;

/// A pin within this part of a right angle from where both assemblies meet lies in both.
const MEETS: f64 = 1e-7;

/// Why a linkage does not do its task; points are counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TaskDefect {
    /// Its numbers are none, or it cannot be opened at the first point, as where it stands in a dead point there.
    Unopened,
    /// Between these points coupler and rocker would have to pass a dead point of the crank.
    Branch {
        /// The last point in one assembly.
        from: usize,
        /// The first in the other.
        to: usize,
    },
    /// Between these points it would have to be taken apart.
    Circuit {
        /// The last point on one circuit.
        from: usize,
        /// The first on the other.
        to: usize,
    },
    /// From the first of these points to the second the crank has to turn back.
    Order {
        /// Where it turns back.
        from: usize,
        /// Where it goes then.
        to: usize,
    },
    /// It does not come to this point, by the solver's figure: a proposal that was none.
    Missed {
        /// The point.
        point: usize,
    },
}

/// On which side of its dead points a linkage stands: 0 where it stands in one.
pub(super) fn side(proposal: &Proposal, point: usize) -> f64 {
    let Some([b, c]) = proposal.places.get(point).copied() else {
        return 0.0;
    };
    let rod = c - b;
    let sine = match proposal.partner {
        Partner::Rocker(d) => rod.cross(d - c) / (rod.norm() * (d - c).norm()),
        Partner::Slide(angle) => rod.dot(unit(angle)) / rod.norm(),
    };
    match sine.abs() <= MEETS {
        true => 0.0,
        false => sine.signum(),
    }
}

/// The crank's angle at every point in the order of the task, and what is wrong with it.
pub(super) fn crank_way(
    proposal: &Proposal,
    range: Range,
    wishes: &Wishes,
) -> (Vec<f64>, Vec<TaskDefect>) {
    let angles: Vec<f64> = proposal
        .places
        .iter()
        .map(|[b, _]| degrees(*b - proposal.pivot))
        .collect();
    let (at, is_here, turns_back) = match range {
        Range::Full { .. } => {
            let Way { at, turns_back } = way::turning(&angles, wishes.sense);
            let all = vec![true; at.len()];
            (at, all, turns_back)
        }
        Range::Limited { low, high } => {
            let found = way::swinging(&angles, (low, high));
            let is_here = found.iter().map(Option::is_some).collect();
            let at: Vec<f64> = found
                .iter()
                .zip(&angles)
                .map(|(at, angle)| at.unwrap_or(*angle))
                .collect();
            let reached: Vec<f64> = found.iter().map_while(|at| *at).collect();
            (at, is_here, way::turns_back(&reached))
        }
    };
    let mut defects = passages(proposal, range, &is_here);
    if let Some(to) = turns_back.filter(|_| wishes.ordered) {
        defects.push(TaskDefect::Order { from: to - 1, to });
    }
    (at, defects)
}

/// Between which neighbouring points the assembly changes; of a closed path the last comes before the first.
fn passages(proposal: &Proposal, range: Range, is_here: &[bool]) -> Vec<TaskDefect> {
    let mut found = Vec::new();
    // A point in a dead point belongs to both sides: it has the one that was there before.
    let mut before = (
        0,
        is_here.first().copied().unwrap_or(true),
        side(proposal, 0),
    );
    for (point, &here) in is_here.iter().enumerate().skip(1) {
        let own = side(proposal, point);
        let now = if own == 0.0 { before.2 } else { own };
        let ends = (before.0, point);
        if here != before.1 {
            found.push(TaskDefect::Circuit {
                from: ends.0,
                to: ends.1,
            });
        } else if now * before.2 < 0.0 {
            found.push(match range {
                Range::Full { .. } => TaskDefect::Circuit {
                    from: ends.0,
                    to: ends.1,
                },
                Range::Limited { .. } => TaskDefect::Branch {
                    from: ends.0,
                    to: ends.1,
                },
            });
        }
        before = (point, here, now);
    }
    found
}
