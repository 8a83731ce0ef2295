//! Measures the condition of the coupled groups' equations over the whole motion.
//!
//! The group's matrix J has lengths in units of the longest link and angles in radians. Each row is
//! relative to the length that it would have if all joints moved in the direction that its equation
//! measures. The ratio of its smallest singular value to its largest shows how near it is to
//! being singular: 0 at a dead point or a change point, 1 at best. It corresponds to the sine of
//! the transmission angle of a dyad: an error of a length is magnified by up to its reciprocal.

use super::coupled::{Coupled, Scratch};
use super::plan::GroupId;
use super::{Condition, Order, Solver, State, Workspace};
use crate::numeric::{MinimumError, lowest};
use nalgebra::DMatrix;

/// Number of places over a turn or a range at which the groups are evaluated.
const SAMPLES_PER_TURN: u32 = 360;
/// Maximum number of sweeps of a decomposition.
const MAX_SWEEPS: usize = 1000;

/// The worst condition of a coupled group over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditioning {
    /// The group.
    pub group: GroupId,
    /// The minimum over the motion of the ratio of the smallest singular value to the largest.
    pub least: f64,
    /// The driver's coordinate of the minimum.
    pub at: f64,
}

impl Solver {
    /// Returns the worst condition of every coupled group over the motion, in plan order. The
    /// search evaluates every degree, or 360 places of a range, and refines the smallest of these
    /// to the last digits.
    #[must_use]
    pub fn conditioning(&self) -> Vec<Conditioning> {
        let groups = self.engine.program.coupled.iter();
        let mut workspace = self.state();
        let worst = groups.filter_map(|group| self.worst(group, &mut workspace));
        worst.collect()
    }

    fn worst(&self, group: &Coupled, workspace: &mut Workspace) -> Option<Conditioning> {
        let (low, high) = self.motion.range.ends();
        let step = (high - low) / f64::from(SAMPLES_PER_TURN);
        // The ends are left out: at a limit a group may fold.
        let places = (0..SAMPLES_PER_TURN).map(|k| low + step * (f64::from(k) + 0.5));
        let seen = places.filter_map(|at| Some((at, self.condition_of(group, at, workspace)?)));
        let first = seen.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let around = [(first.0 - step).max(low), (first.0 + step).min(high)];
        let look = |at| self.condition_of(group, at, workspace);
        let (at, minimum) = lowest(look, around, first).unwrap_or_else(MinimumError::best);
        Some(Conditioning {
            group: GroupId::new(group.group),
            least: minimum,
            at,
        })
    }

    /// Returns the condition of a group in one state; `None` if the state is not an ordinary one.
    fn condition_of(&self, group: &Coupled, at: f64, workspace: &mut Workspace) -> Option<f64> {
        match self.solve(at, Order::Position, workspace) {
            Condition::Ok => {}
            Condition::ChangePoint => return Some(0.0),
            Condition::DeadPoint | Condition::NoAssembly => return None,
        }
        let (q, _) = self.engine.coordinate(at);
        let Workspace { state, scratch, .. } = workspace;
        group.read(state, group.open(scratch).z);
        condition(group, q, state, scratch)
    }
}

/// Returns the condition of a coupled group at the z in the scratch.
pub(super) fn condition(
    group: &Coupled,
    q: f64,
    state: &State,
    scratch: &mut Scratch,
) -> Option<f64> {
    let n = group.unknowns();
    let matrix = DMatrix::from_row_slice(n, n, group.normalised(q, state, scratch));
    let decomposed = nalgebra::SVD::try_new(matrix, false, false, f64::EPSILON, MAX_SWEEPS)?;
    let values = decomposed.singular_values;
    Some(values.min() / values.max()).filter(|condition| condition.is_finite())
}

#[cfg(any(test, feature = "testing"))]
pub(super) mod testing;
