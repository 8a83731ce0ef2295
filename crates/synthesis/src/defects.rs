//! Finds the reasons why a linkage does not do its task, from the signs of its assembly and the
//! range of its crank.

use super::crank_motion::{self, Way};
use super::{PinConstraint, Preferences, Proposal};
use kinematics::angle::{degrees, unit};
use kinematics::solver::Range;

/// Sine of the transmission angle up to which a linkage is at a dead point, where both assemblies
/// meet.
const MEETS: f64 = 1e-7;

/// Why a linkage does not do its task; points are counted from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum TaskDefect {
    /// A number is not finite, or the linkage cannot be opened at the first point, for example
    /// because it is at a dead point there.
    Unopened,
    /// Between these points, coupler and rocker would have to pass a dead point of the crank.
    Branch {
        /// The last point in one assembly.
        from: usize,
        /// The first point in the other assembly.
        to: usize,
    },
    /// Between these points, the linkage would have to be taken apart.
    Circuit {
        /// The last point on one circuit.
        from: usize,
        /// The first point on the other circuit.
        to: usize,
    },
    /// Between these points, the crank has to turn back.
    Order {
        /// The point at which it turns back.
        from: usize,
        /// The next point after turning back.
        to: usize,
    },
    /// The linkage reaches every pair, but does not close over the whole range of its function.
    Short,
    /// The linkage closes over the whole range of its function, but its root mean square error
    /// exceeds a tenth of the output's swing. It may reach the pairs, but follows another curve
    /// between them.
    StructuralError,
    /// The linkage does not reach this point according to the solver: the proposal was wrong.
    Missed {
        /// The point.
        point: usize,
    },
    /// The led point of a path misses this point by more than a small part of the path's size.
    Far {
        /// The point with the largest weighted miss.
        point: usize,
    },
}

/// Returns the side of its dead points on which a linkage is, as a sign: 0 at a dead point.
pub(super) fn side(proposal: &Proposal, point: usize) -> f64 {
    let Some([b, c]) = proposal.places.get(point).copied() else {
        return 0.0;
    };
    let rod = c - b;
    let sine = match proposal.partner {
        PinConstraint::Rocker(d) => rod.cross(d - c) / (rod.norm() * (d - c).norm()),
        PinConstraint::Slide(angle) => rod.dot(unit(angle)) / rod.norm(),
    };
    match sine.abs() <= MEETS {
        true => 0.0,
        false => sine.signum(),
    }
}

/// Facts about the crank's motion that the task gives, apart from its preferences.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct GivenMotion {
    /// The crank's angle at every point if the task gives it, in degrees, counted continuously.
    pub(super) turned: Option<Vec<f64>>,
    /// Whether the path returns to the first point.
    pub(super) closed: bool,
}

/// Returns the crank's angle at every point in the order of the task, in degrees, and the defects
/// of this motion.
pub(super) fn crank_motion(
    proposal: &Proposal,
    range: Range,
    preferences: &Preferences,
    way: &GivenMotion,
) -> (Vec<f64>, Vec<TaskDefect>) {
    let places = proposal.places.iter();
    let angles: Vec<f64> = places.map(|[b, _]| degrees(*b - proposal.pivot)).collect();
    let limits = match range {
        Range::Full { .. } => None,
        Range::Limited { low, high } => Some((low, high)),
    };
    let (found, mut turns_back) = match (&way.turned, limits) {
        (Some(turned), limits) => (crank_motion::given(turned, limits), None),
        (None, Some(limits)) => {
            let found = crank_motion::swinging(&angles, limits);
            let reached: Vec<f64> = found.iter().map_while(|at| *at).collect();
            (found, crank_motion::turns_back(&reached))
        }
        (None, None) if !preferences.ordered => {
            let at = crank_motion::anyhow(&angles);
            (at.into_iter().map(Some).collect(), None)
        }
        (None, None) => {
            let Way { at, turns_back } = crank_motion::turning(&angles, preferences.sense);
            (at.into_iter().map(Some).collect(), turns_back)
        }
    };
    let is_here: Vec<bool> = found.iter().map(Option::is_some).collect();
    let text = found.iter().zip(&angles);
    let at = text.map(|(at, angle)| at.unwrap_or(*angle)).collect();
    let mut defects = passages(proposal, range, &is_here, way.closed);
    // A crank that only swings returns on the path on which it came.
    if way.closed && limits.is_some() {
        turns_back = turns_back.or(Some(0));
    }
    if let Some(to) = turns_back.filter(|_| preferences.ordered) {
        let from = to.checked_sub(1).unwrap_or(angles.len().saturating_sub(1));
        defects.push(TaskDefect::Order { from, to });
    }
    (at, defects)
}

/// Returns the defects between neighbouring points where the assembly changes. In a closed path,
/// the last point also precedes the first.
fn passages(proposal: &Proposal, range: Range, is_here: &[bool], closed: bool) -> Vec<TaskDefect> {
    let mut found = Vec::new();
    let points = is_here.len();
    // A point at a dead point belongs to both sides: it takes the side of the point before it.
    let mut before = (
        0,
        is_here.first().copied().unwrap_or(true),
        side(proposal, 0),
    );
    for index in 1..points + usize::from(closed) {
        let to = index % points;
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
