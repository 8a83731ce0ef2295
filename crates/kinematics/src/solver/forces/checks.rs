//! Implements the checks rule: forces that do not satisfy the balance of the whole are not shown.
//!
//! Each check is a sum that is zero except for rounding errors:
//!
//! ```text
//! drive    effort on the driver  - sum (F.v + M w)     over all loads
//! force    force on the frame    - sum F
//! moment   moment on the frame   - sum (p x F + M)
//! ```
//!
//! The checks add up the equilibrium of every link and pin, so their terms are the forces at all
//! joints and guides, and the loads. If bounds are known, they limit the rounding error of the sum.
//! If not, the limit is a fraction of the terms, not of the result, so that cancelling terms hide
//! no error.

use super::applied::LoadReceiver;
use super::storage::Slot;
use super::{Balance, Extent, ForceState, Residual, TorquePart};
use crate::solver::state::{PointState, State};
use crate::{Ball, LinkId, Number, PointId, Vec2};

/// Maximum rounding error of a sum relative to its terms, if there is no bound: 1e7 roundings. A
/// state so near a singularity that it exceeds this has few digits. An error of a millionth is
/// detected.
const ROUNDING: f64 = 1e-9;

/// A check of the forces of a state: see [`Residual`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceCheck {
    /// The driver against the virtual work of all loads.
    Drive,
    /// The force on the frame along x against the sum of all loads.
    ForceX,
    /// The force on the frame along y against the sum of all loads.
    ForceY,
    /// The moment on the frame against that of all loads.
    Moment,
}

/// The reason why computed forces of a state are not shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WithheldReason {
    /// A check misses by more than rounding explains.
    Unbalanced {
        /// The check that fails. Its residual is part of [`State::residual`].
        check: ForceCheck,
        /// The maximum explained by rounding, in N m or N: the bound of the residual if known, or
        /// else a fraction of the terms.
        most: f64,
    },
    /// A force, or a torque, is too large for a double.
    Overflow,
}

impl ForceCheck {
    /// All checks.
    pub const ALL: [ForceCheck; 4] = [
        ForceCheck::Drive,
        ForceCheck::ForceX,
        ForceCheck::ForceY,
        ForceCheck::Moment,
    ];
}

impl<T: Number> Residual<T> {
    /// Returns the residual of a check.
    #[must_use]
    pub fn of(&self, check: ForceCheck) -> T {
        match check {
            ForceCheck::Drive => self.drive,
            ForceCheck::ForceX => self.force.x,
            ForceCheck::ForceY => self.force.y,
            ForceCheck::Moment => self.moment,
        }
    }
}

/// The sums of the absolute terms of each check.
#[derive(Clone, Copy, Debug, Default)]
struct Terms<T> {
    drive: T,
    force: T,
    moment: T,
}

impl<T: Number> Terms<T> {
    fn force(&mut self, at: &PointState<T>, force: Vec2<T>) {
        let size = extent(force);
        self.force += size;
        self.moment += extent(at.p) * size;
        self.drive += extent(at.v) * size;
    }

    fn couple(&mut self, turning: T, couple: T) {
        self.moment += couple.abs();
        self.drive += (turning * couple).abs();
    }
}

/// Returns a cheap upper bound of the length of a vector.
fn extent<T: Number>(vector: Vec2<T>) -> T {
    vector.x.abs() + vector.y.abs()
}

impl<T: Number> LoadReceiver<T> for Terms<T> {
    fn push(&mut self, _: TorquePart, point: PointId, force: Vec2<T>, state: &State<T>) {
        self.force(&state.points[point.index()], force);
    }

    fn twist(&mut self, _: TorquePart, link: LinkId, couple: T, state: &State<T>) {
        self.couple(state.links[link.index()].w, couple);
    }

    fn twist_ground(&mut self, couple: T) {
        self.couple(T::default(), couple);
    }

    fn add_off_pin_force(&mut self, _: Slot, _: Vec2<T>) {}
}

/// Returns `true` if a sum is within the rounding error of its terms, in every lane. NaN gives
/// `false`.
#[inline(always)]
fn is_rounding<T: Number>(miss: T, terms: T) -> bool {
    // An empty sum must be zero.
    (terms * T::exactly(ROUNDING) + T::exactly(f64::MIN_POSITIVE)).exceeds(miss.abs())
}

impl<T: Number> ForceState<T> {
    /// Returns the residual of each check, in the solver's lengths about its origin.
    #[inline(always)]
    pub(super) fn misses(&self) -> Residual<T> {
        Residual {
            drive: self.drive - self.virtual_work(),
            force: self.frame - self.sum,
            moment: self.frame_moment - self.sum_moment,
        }
    }

    /// Returns `true` if all checks hold against the readily available part of their terms.
    #[inline(always)]
    fn is_plainly_balanced(&self) -> bool {
        let Residual {
            drive,
            force,
            moment,
        } = self.misses();
        let [load, gravity, inertia] = self.work;
        let work = load.abs() + gravity.abs() + inertia.abs();
        let forces = extent(self.frame);
        is_rounding(drive, work)
            && is_rounding(force.x, forces)
            && is_rounding(force.y, forces)
            && is_rounding(moment, self.frame_moment.abs())
    }
}

impl Balance {
    /// Withholds forces whose checks miss by more than a fraction of their terms.
    #[inline(always)]
    pub(super) fn check<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        if forces.extent == Extent::All && !forces.is_plainly_balanced() {
            self.check_closely(state, forces);
        }
    }

    /// Withholds forces whose checks miss by more than a fraction of all their terms.
    #[cold]
    #[inline(never)]
    fn check_closely<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let terms = self.terms(state, forces);
        let (misses, scale) = (forces.misses(), &forces.scale);
        let checks = [
            (ForceCheck::Drive, misses.drive, terms.drive, scale.drive),
            (
                ForceCheck::ForceX,
                misses.force.x,
                terms.force,
                T::exactly(1.0),
            ),
            (
                ForceCheck::ForceY,
                misses.force.y,
                terms.force,
                T::exactly(1.0),
            ),
            (
                ForceCheck::Moment,
                misses.moment,
                terms.moment,
                scale.couple,
            ),
        ];
        let fails = |&(_, miss, terms, _): &(ForceCheck, T, T, T)| !is_rounding(miss, terms);
        if let Some((check, _, terms, unit)) = checks.into_iter().find(fails) {
            let maximum = (terms * unit).nearest() * ROUNDING;
            forces.extent = Extent::WithheldReason(if maximum.is_finite() {
                WithheldReason::Unbalanced {
                    check,
                    most: maximum,
                }
            } else {
                WithheldReason::Overflow
            });
        }
    }

    /// Returns the terms of all loads, and of all forces at joints and guides.
    fn terms<T: Number>(&self, state: &State<T>, forces: &ForceState<T>) -> Terms<T> {
        let mut terms = Terms::default();
        self.acting.apply_loads(state, &mut terms);
        let joints = self.slots.members.iter().zip(&forces.joints);
        for (point, &force) in joints {
            terms.force(&state.points[point.index()], force);
        }
        for (slide, &(point, link)) in self.sliders.iter().enumerate() {
            let along = Vec2::new(forces.normals[slide], T::default());
            terms.force(&state.points[point.index()], along);
            if let Some(link) = link {
                terms.couple(state.links[link.index()].w, forces.moments[slide]);
            }
        }
        terms.drive += forces.drive.abs();
        terms
    }
}

impl<T: Number> State<T> {
    /// Returns `true` if computed forces are not shown.
    pub(in crate::solver) fn withholds(&self) -> bool {
        let forces = self.forces.as_deref();
        forces.is_some_and(|forces| matches!(forces.extent, Extent::WithheldReason(_)))
    }
}

impl State {
    /// Returns the reason why the forces of this state are not shown; `None` if they are shown or
    /// do not exist.
    #[must_use]
    pub fn withheld(&self) -> Option<WithheldReason> {
        match self.forces.as_deref()?.extent {
            Extent::WithheldReason(why) => Some(why),
            Extent::Nothing | Extent::Drive | Extent::All => None,
        }
    }

    /// Decides by the bounds of the residuals, if they exist, whether rounding explains them.
    pub(in crate::solver) fn check_by_bounds(&mut self, enclosure: &State<Ball>) {
        let Some((found, proved)) = self.residual().zip(enclosure.residual()) else {
            return;
        };
        let bound = |check| Some((check, proved.of(check).bound(found.of(check))?));
        let bounds = ForceCheck::ALL.map(bound);
        let missed = bounds.into_iter().flatten();
        let missed = missed.filter(|&(check, bound)| found.of(check).abs() > bound);
        let missed = missed.map(|(check, maximum)| WithheldReason::Unbalanced {
            check,
            most: maximum,
        });
        let Some(forces) = &mut self.forces else {
            return;
        };
        let is_proved = bounds.iter().all(Option::is_some);
        match (missed.into_iter().next(), forces.extent) {
            (Some(why), _) => forces.extent = Extent::WithheldReason(why),
            (None, Extent::WithheldReason(WithheldReason::Unbalanced { .. })) if is_proved => {
                forces.extent = Extent::All;
            }
            (None, _) => {}
        }
    }
}
