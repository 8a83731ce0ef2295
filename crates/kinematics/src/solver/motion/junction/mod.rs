//! Treats a coordinate at which groups are singular as a whole. All groups are expanded in series
//! about it, in the order of the plan, each from the results of those before it.
//!
//! The square of a group's height decides whether the group passes, and on which side it continues
//! (see [`crate::solver::elements::Height`]). The group passes if the order of the square is even,
//! 2p, and its sign changes if p is odd. All series are in double-double. They are proved by
//! solving the mechanism on both sides of the coordinate.

mod continuation;
mod coupled_pair;
mod curve;
mod pair;
mod proof;
mod series_steps;
mod singularity;

use super::change::Change;
use super::tracking::Walker;
use crate::arithmetic::{Series, TERMS};
use crate::solver::elements::{Dyad, POSITION, SingularShift, StepOutcome, root};
use crate::solver::workspace::Workspace;
use crate::{Double, Vec2};
use coupled_pair::CoupledPair;
use curve::Curve;
pub(super) use pair::PairFound;
use pair::{Paired, paired};
pub(super) use singularity::{CHANGE_POINT_TOLERANCE, DyadSingularity};
use std::ops::Range;

/// Number of terms of the first attempt.
pub(super) const FIRST: usize = 16;
/// Number of additional terms per attempt, if too few coefficients remain.
pub(super) const MORE: usize = 8;
/// Half widths of a step across two close change points, in radians or scaled lengths.
const WIDTHS: [f64; 4] = [0.03, 0.018, 6e-3, 2e-3];
/// Minimum number of known coefficients of every group.
const MIN_KNOWN_COEFFICIENTS: usize = 10;

/// Minimum number about two change points, so that the series reaches beyond both.
const WANTED_BY_PAIR: usize = 20;

/// All groups in series about a coordinate at which some are singular.
pub(super) struct Junction {
    pub(super) at: Double,
    /// The sign of the distances at which the motion exists, at an end of a table; otherwise 0.
    pub(super) side: f64,
    series: Workspace<Series>,
    /// The groups singular at the coordinate.
    folds: Vec<SingularGroup>,
    /// The groups whose assemblies miss each other there by more than the rounding of the lengths.
    pub(super) missed: Vec<Missed>,
    /// The signs of all groups below and above the coordinate.
    sides: [Vec<f64>; 2],
    /// The driver's coordinate, if it is not the parameter of the series.
    curve: Option<Curve>,
    /// The coupled group whose branch is known by its series alone.
    pair: Option<CoupledPair>,
}

/// A group singular at a junction.
struct SingularGroup {
    step: usize,
    group: usize,
    snap: SingularShift,
    /// The distances from the coordinate at which the group's sign changes.
    turns: Vec<Double>,
    /// The maximum distance of the places at which the group is singular.
    spread: f64,
    /// Whether the group is singular or almost singular at two close places.
    pair: bool,
    /// Whether the input reverses just before the group is singular.
    is_missed: bool,
}

/// A nearly singular group.
#[derive(Clone, Copy, Debug)]
pub(super) struct Missed {
    pub(super) group: usize,
    /// The sine of the group's transmission angle.
    pub(super) sine: f64,
}

impl SingularGroup {
    /// Creates a group singular at one place. The square of its height is of this order there.
    fn tolerances_at(
        (step, group): (usize, usize),
        snap: SingularShift,
        order: usize,
    ) -> SingularGroup {
        SingularGroup {
            step,
            group,
            snap,
            turns: if order % 4 == 2 {
                vec![Double::ZERO]
            } else {
                Vec::new()
            },
            spread: 0.0,
            pair: false,
            is_missed: false,
        }
    }

    /// Returns `true` if the group's sign on both sides differs.
    fn turns(&self) -> bool {
        self.turns.len() % 2 == 1
    }
}

/// The reason why there is no crossing.
enum Refusal {
    /// The motion ends, or its continuation cannot be determined.
    End,
    /// More terms may decide.
    Terms,
}

impl Junction {
    /// Creates a junction at which no group is known to be singular yet, and at which no table ends.
    fn about(at: Double, series: Workspace<Series>, signs: &[f64]) -> Junction {
        Junction {
            at,
            side: 0.0,
            series,
            folds: Vec::new(),
            missed: Vec::new(),
            sides: [signs.to_vec(), signs.to_vec()],
            curve: None,
            pair: None,
        }
    }

    /// Returns `true` if the groups are only nearly singular.
    pub(super) fn is_miss(&self) -> bool {
        self.folds.is_empty()
    }

    /// Returns the singular groups.
    pub(super) fn groups(&self) -> impl Iterator<Item = usize> + '_ {
        self.folds.iter().map(|f| f.group)
    }

    /// Returns the half widths of a step across two close change points that are wider than those
    /// across a single one. The assemblies differ by the square of the distance only.
    pub(super) fn widths(&self) -> impl Iterator<Item = f64> {
        let is_wide = self.folds.iter().any(|f| f.pair);
        let widths = if is_wide { &WIDTHS[..] } else { &[] };
        widths.iter().copied()
    }

    /// Returns the maximum distance of the places at which a group is singular.
    pub(super) fn spread(&self) -> f64 {
        self.folds.iter().map(|f| f.spread).fold(0.0, f64::max)
    }

    /// Returns the coupled group whose branch is known by its series alone.
    pub(super) fn coupled_pair(&self) -> Option<&CoupledPair> {
        self.pair.as_ref()
    }

    /// Returns the steps whose group changes its sign.
    pub(super) fn turning(&self) -> impl Iterator<Item = usize> + '_ {
        self.folds.iter().filter(|f| f.turns()).map(|f| f.step)
    }
}

impl Walker<'_> {
    /// Expands the mechanism in series about a coordinate, with the signs of the arriving motion.
    /// Returns `None` if the motion ends there or its continuation cannot be determined.
    pub(super) fn junction(&mut self, at: Double, changes: &[Change]) -> Option<Junction> {
        for terms in (self.terms..=TERMS).step_by(MORE) {
            match self.junction_of(at, changes, terms) {
                Ok(junction) => {
                    // The next junction starts with the number of terms that was needed here.
                    self.terms = terms;
                    return Some(junction);
                }
                Err(Refusal::End) => return None,
                Err(Refusal::Terms) => {}
            }
        }
        None
    }

    /// Expands the mechanism in series with a given number of terms.
    fn junction_of(
        &mut self,
        at: Double,
        changes: &[Change],
        terms: usize,
    ) -> Result<Junction, Refusal> {
        let steps = self.engine.program.steps.len();
        let junction = self.junction_before(steps, at, changes, terms)?;
        junction.with_enough_terms(terms)
    }

    /// Expands the first `steps` steps in series with a given number of terms.
    fn junction_before(
        &mut self,
        steps: usize,
        at: Double,
        changes: &[Change],
        terms: usize,
    ) -> Result<Junction, Refusal> {
        let engine = &self.exact.ok_or(Refusal::End)?.engine;
        let series = engine.state(self.state.travels.len());
        let mut junction = Junction {
            side: self.engine.inwards(at.hi),
            ..Junction::about(at, series, &self.state.signs)
        };
        let coordinate = self.coordinate_of(at, terms);
        self.expand(0..steps, coordinate, changes, &mut junction)?;
        Ok(junction)
    }

    /// Returns the first `steps` steps in series about a coordinate at which some are singular.
    pub(super) fn series_before(
        &mut self,
        steps: usize,
        at: Double,
        changes: &[Change],
    ) -> Option<Workspace<Series>> {
        let junction = self.junction_before(steps, at, changes, self.terms);
        Some(junction.ok()?.series)
    }

    /// Places steps in series, with all groups that are singular at the junction.
    fn expand(
        &mut self,
        steps: Range<usize>,
        (q, direction): (Series, Vec2<Series>),
        changes: &[Change],
        junction: &mut Junction,
    ) -> Result<(), Refusal> {
        let engine = &self.exact.ok_or(Refusal::End)?.engine;
        let at = junction.at;
        for i in steps {
            let step = &engine.program.steps[i];
            if let Some(dyad) = step.dyad() {
                self.lead(i, dyad, q, junction)?;
                continue;
            }
            let done = if let Some(index) = step.coupled() {
                let crossing = changes.iter().find(|c| c.step == i);
                if crossing.is_some() {
                    let group = engine.program.coupled[index].group;
                    let fold =
                        SingularGroup::tolerances_at((i, group), SingularShift::default(), 2);
                    junction.fold(fold, self.sense);
                }
                // If its solutions cross here, too, another junction passes all groups.
                self.follow(i, at.hi, q, crossing, &mut junction.series)
                    && (crossing.is_some() || !self.is_singular_at(junction, i))
            } else {
                let series = &mut junction.series.state;
                step.run::<Series, POSITION>(q, direction, series) == StepOutcome::Done
            };
            if !done {
                return Err(Refusal::End);
            }
        }
        Ok(())
    }

    /// Places a dyad in series, through its change point if it has one at this coordinate.
    fn lead(
        &mut self,
        step: usize,
        dyad: Dyad<'_>,
        q: Series,
        junction: &mut Junction,
    ) -> Result<(), Refusal> {
        let group = dyad.group();
        let slack = self.slack();
        let is_end = junction.side != 0.0;
        let paired = paired(dyad, q, (slack, is_end), &junction.series);
        if let Some(paired) = paired.filter(|_| !self.is_single(junction.at.hi)) {
            return self.lead_twice((step, dyad), &paired, q, junction);
        }
        let (snap, order) = match self.singularity(dyad, q, slack, &junction.series)? {
            DyadSingularity::Regular => (SingularShift::default(), 0),
            DyadSingularity::Missing { sine } => {
                junction.missed.push(Missed { group, sine });
                (SingularShift::default(), 0)
            }
            DyadSingularity::Singular { snap, order } => {
                // While the pivots of one dyad coincide, it swings freely and carries those of the
                // next along. Then there are more continuations than can be distinguished.
                let has_met = |f: &SingularGroup| f.snap.equal_arms;
                let swings = snap.equal_arms && junction.folds.iter().any(has_met);
                if swings && dyad.has_moving_pivots(&junction.series) {
                    return Err(Refusal::End);
                }
                let fold = SingularGroup::tolerances_at((step, group), snap, order);
                junction.fold(fold, self.sense);
                (snap, order)
            }
        };
        let series = &mut junction.series.state;
        let square = dyad.square(q, snap, series);
        let height = root(square, order, junction.sides[1][group]);
        dyad.run_through(q, snap, height, series);
        if order > 0 {
            dyad.translate(series);
        }
        Ok(())
    }

    /// Places a dyad in series through two change points close to this coordinate.
    fn lead_twice(
        &self,
        (step, dyad): (usize, Dyad<'_>),
        paired: &Paired,
        q: Series,
        junction: &mut Junction,
    ) -> Result<(), Refusal> {
        let group = dyad.group();
        let has_met = |f: &SingularGroup| f.snap.equal_arms;
        let swings = paired.snap.equal_arms && junction.folds.iter().any(has_met);
        if swings && dyad.has_moving_pivots(&junction.series) {
            return Err(Refusal::End);
        }
        if let Some(sine) = paired.missed {
            junction.missed.push(Missed { group, sine });
        }
        junction.fold(paired.group((step, group), junction.side), self.sense);
        let series = &mut junction.series.state;
        let square = dyad.square(q, paired.snap, series);
        // The motion arrives from outside both places.
        let height = paired.pair.root(square, self.state.signs[group]);
        dyad.run_through(q, paired.snap, height, series);
        dyad.translate(series);
        Ok(())
    }
}

impl Junction {
    /// Stores a singular group, and its sign on the side towards which the motion goes.
    fn fold(&mut self, fold: SingularGroup, sense: f64) {
        if fold.turns() {
            let sign = &mut self.sides[usize::from(sense > 0.0)][fold.group];
            *sign = -*sign;
        }
        self.folds.push(fold);
    }

    /// Returns the junction if enough of the coefficients are known, or if more terms are not
    /// possible.
    fn with_enough_terms(self, terms: usize) -> Result<Junction, Refusal> {
        let is_pair = self.folds.iter().any(|f| f.pair);
        let wanted = if is_pair {
            WANTED_BY_PAIR
        } else {
            MIN_KNOWN_COEFFICIENTS
        };
        if self.known() < wanted && terms + MORE <= TERMS {
            return Err(Refusal::Terms);
        }
        Ok(self)
    }

    /// Returns the minimum number of known coefficients of all points and links.
    fn known(&self) -> usize {
        let of = |v: Vec2<Series>| v.x.known.min(v.y.known);
        let points = self.series.points.iter().map(|p| of(p.p));
        let links = self.series.links.iter().map(|l| of(l.d));
        points.chain(links).fold(TERMS, usize::min)
    }
}
