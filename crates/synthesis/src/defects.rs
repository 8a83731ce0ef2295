//! What keeps a linkage from doing its task, decided by the signs of its assembly and the range of its crank.

use super::way::{self, Way};
use super::{Partner, Proposal, Wishes};
use kinematics::angle::{degrees, unit};
use kinematics::solver::Range;

/// A pin within this part of a right angle from where both assemblies meet lies in both.
const MEETS: f64 = 1e-7;

/// Why a linkage does not do its task; points are counted from 0.
#[derive(Clone, Debug, PartialEq)]
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
    /// It comes to every pair, but does not close over the whole range of its function.
    Short,
    /// It closes over the whole range of its function, but misses it by more than a tenth of the output's swing, in the root
    /// of the mean square: it comes to the pairs, if at all, on other ways than the function's.
    StructuralError,
    /// It does not come to this point, by the solver's figure: a proposal that was none.
    Missed {
        /// The point.
        point: usize,
    },
    /// The led point of a path passes this point at a distance that is no small part of the path's size.
    Far {
        /// The point that is missed most, as far as it counts.
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

/// What a task says of the crank's way, beside its wishes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct GivenWay {
    /// The crank's angle at every point, where the task gives it: in degrees, counted on.
    pub(super) turned: Option<Vec<f64>>,
    /// Whether it comes back to the first point.
    pub(super) closed: bool,
}

/// The crank's angle at every point in the order of the task, and what is wrong with it.
pub(super) fn crank_way(
    proposal: &Proposal,
    range: Range,
    wishes: &Wishes,
    way: &GivenWay,
) -> (Vec<f64>, Vec<TaskDefect>) {
    let places = proposal.places.iter();
    let angles: Vec<f64> = places.map(|[b, _]| degrees(*b - proposal.pivot)).collect();
    let limits = match range {
        Range::Full { .. } => None,
        Range::Limited { low, high } => Some((low, high)),
    };
    let (found, mut turns_back) = match (&way.turned, limits) {
        (Some(turned), limits) => (way::given(turned, limits), None),
        (None, Some(limits)) => {
            let found = way::swinging(&angles, limits);
            let reached: Vec<f64> = found.iter().map_while(|at| *at).collect();
            (found, way::turns_back(&reached))
        }
        (None, None) if !wishes.ordered => {
            let at = way::anyhow(&angles);
            (at.into_iter().map(Some).collect(), None)
        }
        (None, None) => {
            let Way { at, turns_back } = way::turning(&angles, wishes.sense);
            (at.into_iter().map(Some).collect(), turns_back)
        }
    };
    let is_here: Vec<bool> = found.iter().map(Option::is_some).collect();
    let told = found.iter().zip(&angles);
    let at = told.map(|(at, angle)| at.unwrap_or(*angle)).collect();
    let mut defects = passages(proposal, range, &is_here, way.closed);
    // Who swings comes back the way on which it went.
    if way.closed && limits.is_some() {
        turns_back = turns_back.or(Some(0));
    }
    if let Some(to) = turns_back.filter(|_| wishes.ordered) {
        let from = to.checked_sub(1).unwrap_or(angles.len().saturating_sub(1));
        defects.push(TaskDefect::Order { from, to });
    }
    (at, defects)
}

/// Between which neighbouring points the assembly changes; of a closed path the last comes before the first.
fn passages(proposal: &Proposal, range: Range, is_here: &[bool], closed: bool) -> Vec<TaskDefect> {
    let mut found = Vec::new();
    let points = is_here.len();
    // A point in a dead point belongs to both sides: it has the one that was there before.
    let mut before = (
        0,
        is_here.first().copied().unwrap_or(true),
        side(proposal, 0),
    );
    for place in 1..points + usize::from(closed) {
        let to = place % points;
        let own = side(proposal, to);
        let now = if own == 0.0 { before.2 } else { own };
        let from = before.0;
        if is_here[to] != before.1 {
            found.push(TaskDefect::Circuit { from, to });
        } else if now * before.2 < 0.0 {
            found.push(match range {
                Range::Full { .. } => TaskDefect::Circuit { from, to },
                Range::Limited { .. } => TaskDefect::Branch { from, to },
            });
        }
        before = (to, is_here[to], now);
    }
    found
}
