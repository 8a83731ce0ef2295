//! Finds extrema of transmission angles between two neighbouring states.
//!
//! Solving a state of a long chain takes time in proportion to its length, and there are as many
//! extrema as dyads. Extrema between the same two neighbours are therefore sought together. A few
//! intermediate states serve all these dyads, and their number does not depend on the length of the
//! chain. Sums of Chebyshev polynomials approximate each dyad in between. If they do not converge,
//! as next to a limit, the extremum is sought with separate states.

use super::{DyadLines, ObservedJoint};
use crate::numeric::chebyshev::{Basis, ChebyshevSum, TERMS};
use crate::numeric::{few_decimals, root};
use crate::solver::{Order, Solver, Workspace};

/// Blur of an extremum in ulps. An extremum is flat: within this distance, its rate, a difference
/// of two angular velocities, is rounding error. The position with few decimals is reported: 0
/// rather than -6e-15 degrees.
const BLUR: f64 = 1024.0;
/// Maximum size of the terms after the first third, relative to the largest. The terms of a smooth
/// function fall geometrically, so that the last ones are about the cube of this, which is rounding
/// error. The terms themselves do not fall as far, because the states are rounded, too.
const MAX_TAIL_TERM: f64 = 1e-5;

/// Two neighbouring states between which mu has an extremum.
#[derive(Clone, Copy)]
pub(super) struct Bracket {
    pub(super) ends: [DyadLines; 2],
    pub(super) reading: ExtremeFunction,
    /// The expected cosine of the extremum.
    pub(super) cosine: f64,
}

/// The function that is zero at an extremum. For undirected lines mu is at most 90 degrees, reached
/// where the cosine changes its sign.
#[derive(Clone, Copy)]
pub(super) enum ExtremeFunction {
    Rate,
    Cosine,
}

/// A bracket and its joint.
struct BracketedJoint {
    joint: usize,
    bracket: Bracket,
}

/// The sine, cosine and rate of the cosine of a dyad between two coordinates, as sums.
struct Sums {
    ends: [f64; 2],
    sums: [ChebyshevSum; 3],
}

impl Solver {
    /// Finds the extrema of all joints between the observed states.
    pub(super) fn find_extrema_between(
        &self,
        seen: &mut [ObservedJoint<'_>],
        workspace: &mut Workspace,
    ) {
        let mut sought = Vec::new();
        for (joint, seen) in seen.iter_mut().enumerate() {
            let brackets = seen.take_likely();
            sought.extend(brackets.map(|bracket| BracketedJoint { joint, bracket }));
        }
        sought.sort_by(|a, b| a.bracket.start().total_cmp(&b.bracket.start()));
        let basis = Basis::new();
        for together in sought.chunk_by(|a, b| a.bracket.coordinates() == b.bracket.coordinates()) {
            let sums = self.sums(&basis, together, seen, workspace);
            for (BracketedJoint { joint, bracket }, sums) in together.iter().zip(sums) {
                let seen = &mut seen[*joint];
                let found = match sums {
                    Some(sums) => self.extreme(bracket, |at| Some(sums.lines_at(at))),
                    None => self.extreme(bracket, |at| {
                        let condition = self.solve(at, Order::Velocity, workspace);
                        seen.joint.lines_at(condition, workspace)
                    }),
                };
                if let Some(look) = found {
                    seen.consider(&look);
                }
            }
        }
    }

    /// Returns the sums of several dyads between the same coordinates; `None` for a dyad whose sums
    /// do not converge.
    fn sums(
        &self,
        basis: &Basis,
        together: &[BracketedJoint],
        seen: &[ObservedJoint<'_>],
        workspace: &mut Workspace,
    ) -> Vec<Option<Sums>> {
        let Some(first) = together.first() else {
            return Vec::new();
        };
        let ends = first.bracket.coordinates();
        let mut values = vec![Some([[0.0; TERMS]; 3]); together.len()];
        for (k, t) in basis.places.into_iter().enumerate() {
            let at = ends[0] + 0.5 * (1.0 + t) * (ends[1] - ends[0]);
            let condition = self.solve(at, Order::Velocity, workspace);
            for (values, sought) in values.iter_mut().zip(together) {
                let look = seen[sought.joint].joint.lines_at(condition, workspace);
                let read = look.and_then(|look| Some([look.sine, look.cosine, look.rate?]));
                match (values.as_mut(), read) {
                    (Some(values), Some(read)) => {
                        for (values, value) in values.iter_mut().zip(read) {
                            values[k] = value;
                        }
                    }
                    _ => *values = None,
                }
            }
        }
        let driver_state = |values: Option<[[f64; TERMS]; 3]>| {
            let sums = values?.map(|values| basis.through(&values));
            let is_smooth = |sum: &ChebyshevSum| sum.third() <= MAX_TAIL_TERM * sum.size();
            sums.iter().all(is_smooth).then_some(Sums { ends, sums })
        };
        values.into_iter().map(driver_state).collect()
    }

    /// Finds the extremum in a bracket by evaluating states between its ends.
    fn extreme(
        &self,
        bracket: &Bracket,
        mut look: impl FnMut(f64) -> Option<DyadLines>,
    ) -> Option<DyadLines> {
        let read = |look: &DyadLines| match bracket.reading {
            ExtremeFunction::Rate => look.rate,
            ExtremeFunction::Cosine => Some(look.cosine),
        };
        let [a, b] = &bracket.ends;
        let finest = self.engine.finest();
        let (from, to) = ((a.at, read(a)?), (b.at, read(b)?));
        let at = root(from, to, finest, |at| read(&look(at)?)).ok()?;
        let round = few_decimals(at);
        let is_blurred = (round - at).abs() <= BLUR * finest.max(f64::EPSILON * at.abs());
        look(if is_blurred { round } else { at })
    }
}

impl Bracket {
    fn start(&self) -> f64 {
        self.ends[0].at
    }

    fn coordinates(&self) -> [f64; 2] {
        self.ends.map(|look| look.at)
    }
}

impl Sums {
    fn lines_at(&self, at: f64) -> DyadLines {
        let [from, to] = self.ends;
        let t = 2.0 * (at - from) / (to - from) - 1.0;
        let [sine, cosine, rate] = self.sums.map(|sum| sum.at(t));
        DyadLines {
            at,
            sine,
            cosine,
            rate: Some(rate),
        }
    }
}

#[cfg(any(test, feature = "testing"))]
pub(in crate::solver) mod testing;
