//! A place at which groups are singular, treated as a whole: all groups in series about it, in the order
//! of the plan, each on what those before it do there.
//!
//! Whether a group passes, and on which side it goes on, is read off the square of its height (see
//! [`crate::solver::elements::Height`]): of even order 2p it passes, its sign changing with odd p. Everything
//! is carried in twice the precision, and proved by solving the mechanism on both sides of the place.

mod lay;
mod proof;
mod standing;

use super::change::Change;
use super::walk::Walker;
use crate::arithmetic::{Series, TERMS};
use crate::solver::elements::{Dyad, POSITION, Snap, StepOutcome, root};
use crate::solver::workspace::Workspace;
use crate::{Double, Vec2};
pub(super) use standing::Standing;

/// Terms that are begun with, and how many more are tried where too few are left.
pub(super) const FIRST: usize = 16;
const MORE: usize = 8;
/// Terms that are to be left of every group.
const WANTED: usize = 10;

/// All groups about a place.
pub(super) struct Junction {
    pub(super) at: Double,
    series: Workspace<Series>,
    /// The groups that are singular there.
    folds: Vec<SingularGroup>,
    /// The groups whose assemblies miss each other there, by more than lengths have been rounded.
    pub(super) missed: Vec<Missed>,
    /// The signs of all groups below the place and above it.
    sides: [Vec<f64>; 2],
}

/// A singular group.
struct SingularGroup {
    step: usize,
    group: usize,
    snap: Snap,
    /// The order of the square of its height.
    order: usize,
}

/// A group that is all but singular.
#[derive(Clone, Copy, Debug)]
pub(super) struct Missed {
    pub(super) group: usize,
    /// The sine of its transmission angle.
    pub(super) sine: f64,
}

impl SingularGroup {
    fn turns(&self) -> bool {
        self.order % 4 == 2
    }
}

/// Why there is no passage.
enum Refusal {
    /// The motion ends, or cannot be told.
    End,
    /// More terms would tell.
    Terms,
}

impl Junction {
    /// Whether the groups are only near to being singular.
    pub(super) fn is_miss(&self) -> bool {
        self.folds.is_empty()
    }

    /// The groups that are singular.
    pub(super) fn groups(&self) -> impl Iterator<Item = usize> + '_ {
        self.folds.iter().map(|f| f.group)
    }

    /// The steps whose group goes on with the other sign.
    pub(super) fn turning(&self) -> impl Iterator<Item = usize> + '_ {
        self.folds.iter().filter(|f| f.turns()).map(|f| f.step)
    }
}

impl Walker<'_> {
    /// The mechanism in series about a place, with the signs that it comes with; `None` where the motion
    /// ends there, or where it cannot be told how it goes on.
    pub(super) fn junction(&mut self, at: Double, crossing: Option<&Change>) -> Option<Junction> {
        for terms in (self.terms..=TERMS).step_by(MORE) {
            match self.junction_of(at, crossing, terms) {
                Ok(junction) => {
                    // At the next place as many will do.
                    self.terms = terms;
                    return Some(junction);
                }
                Err(Refusal::End) => return None,
                Err(Refusal::Terms) => {}
            }
        }
        None
    }

    fn junction_of(
        &mut self,
        at: Double,
        crossing: Option<&Change>,
        terms: usize,
    ) -> Result<Junction, Refusal> {
        let engine = &self.exact.ok_or(Refusal::End)?.engine;
        let signs = &self.state.signs;
        let mut junction = Junction {
            at,
            series: engine.state(self.state.travels.len()),
            folds: Vec::new(),
            missed: Vec::new(),
            sides: [signs.clone(), signs.clone()],
        };
        let (q, direction) = self.coordinate_of(at, terms);
        for (i, step) in engine.program.steps.iter().enumerate() {
            if let Some(dyad) = step.dyad() {
                self.lead(i, dyad, q, &mut junction)?;
                continue;
            }
            let done = if let Some(index) = step.coupled() {
                let crossing = crossing.filter(|c| c.step == i);
                if crossing.is_some() {
                    let group = engine.program.coupled[index].group;
                    junction.fold((i, group), (Snap::default(), 2), self.sense);
                }
                self.follow(i, at.hi, q, crossing, &mut junction.series)
            } else {
                let series = &mut junction.series.state;
                step.run::<Series, POSITION>(q, direction, series) == StepOutcome::Done
            };
            if !done {
                return Err(Refusal::End);
            }
        }
        if junction.known() < WANTED && terms + MORE <= TERMS {
            return Err(Refusal::Terms);
        }
        Ok(junction)
    }

    /// Places a dyad in series, through its change point if it has one there.
    fn lead(
        &mut self,
        step: usize,
        dyad: Dyad<'_>,
        q: Series,
        junction: &mut Junction,
    ) -> Result<(), Refusal> {
        let group = dyad.group();
        let slack = self.slack();
        let (snap, order) = match self.standing(dyad, q, slack, &junction.series)? {
            Standing::Regular => (Snap::default(), 0),
            Standing::Missing { sine } => {
                junction.missed.push(Missed { group, sine });
                (Snap::default(), 0)
            }
            Standing::Singular { snap, order } => {
                // As long as the pivots of one have met it swings freely, and takes along those of the
                // next: there are more ways on than can be told apart.
                let has_met = |f: &SingularGroup| f.snap.equal_arms;
                let swings = snap.equal_arms && junction.folds.iter().any(has_met);
                if swings && dyad.is_afloat(&junction.series) {
                    return Err(Refusal::End);
                }
                junction.fold((step, group), (snap, order), self.sense);
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
}

impl Junction {
    /// Keeps a singular group, and its sign on the side to which the motion goes.
    fn fold(&mut self, (step, group): (usize, usize), (snap, order): (Snap, usize), sense: f64) {
        let fold = SingularGroup {
            step,
            group,
            snap,
            order,
        };
        if fold.turns() {
            let sign = &mut self.sides[usize::from(sense > 0.0)][group];
            *sign = -*sign;
        }
        self.folds.push(fold);
    }

    /// How many coefficients are known of every group that is singular.
    fn known(&self) -> usize {
        let of = |v: Vec2<Series>| v.x.known.min(v.y.known);
        let points = self.series.points.iter().map(|p| of(p.p));
        let links = self.series.links.iter().map(|l| of(l.d));
        points.chain(links).fold(TERMS, usize::min)
    }
}
