//! Poses and the equations of dyads through them, in a unit that suits both.

use super::form::{self, Form};
use super::space;
use crate::{OpenReason, Pose, PoseTask};
use kinematics::arithmetic::U;
use kinematics::{Double, Vec2, angle};
use std::ops::RangeInclusive;

/// Part of the number of poses that keeps the least-moved point near if the body rotates only by
/// rounding.
const RIDGE: f64 = 1e-20;
/// Translation part of the equations at which rotations and translations have equal weight: five of
/// seven coordinates.
const BALANCED: f64 = 5.0 / 7.0;
/// Multiple of the poses' rounding error below which the translation part is insignificant: the
/// equations then describe rotations only.
const NO_MOVE: f64 = 8.0;
/// Range of supported coordinates and of their differences: squares of their squares stay finite
/// and nonzero.
const COORDINATES: RangeInclusive<f64> = 1e-70..=1e70;
/// Maximum number of doublings of the unit; smaller rotations are rounding errors.
const MAX_DOUBLINGS: u8 = 50;

/// Poses and the equations of dyads through them. Pivots are relative to `middle`, and pins to the
/// point of the body that moves least.
pub(super) struct Guidance {
    /// The origin and the unit vector of the x axis of each pose.
    pub(super) poses: Vec<[Vec2<Double>; 2]>,
    /// The distance between the poses, a length.
    pub(super) size: f64,
    /// The unit of length of the equations: a power of two, of about the size or larger.
    pub(super) unit: f64,
    /// The ground point to which pivots are relative.
    pub(super) middle: Vec2,
    /// The body point to which pins are relative, in the body's frame.
    pub(super) quietest_point: Vec2,
    /// The independent equations, each normalised and orthogonal to the others; at most four for
    /// five poses.
    pub(super) forms: Vec<Form>,
    /// The effect on the equations of rounding the poses to doubles.
    pub(super) error: f64,
}

impl Guidance {
    /// Sets up the equations. Returns `None` if a pose is not finite, or if the poses' size is
    /// outside the supported range.
    pub(super) fn new(task: &PoseTask) -> Option<Guidance> {
        let poses: Vec<[Vec2<Double>; 2]> = task
            .poses
            .iter()
            .map(|pose| [pose.at.exactly(), Double::unit(pose.angle)])
            .collect();
        let size = size(task);
        let far = task.poses.iter().map(|pose| pose.at.norm());
        let far = far.fold(size, f64::max);
        if !(COORDINATES.contains(&size) && COORDINATES.contains(&far)) {
            return None;
        }
        let unit = 2.0_f64.powi(space::exponent(size)?);
        let (middle, quietest) = least_moved_points(task)?;
        let mut guidance = Guidance {
            poses,
            size,
            unit,
            middle,
            quietest_point: quietest,
            forms: Vec::new(),
            error: 0.0,
        };
        guidance.balance(task)?;
        Some(guidance)
    }

    /// Sets up the equations in the unit in which rotations and translations have equal weight.
    ///
    /// If poses nearly repeat, the distance of the pins in sizes is inversely proportional to the
    /// rotations. If translations in that unit are rounding errors, the size remains the unit.
    fn balance(&mut self, task: &PoseTask) -> Option<()> {
        let first = self.unit;
        let (forms, error) = self.equations(task)?;
        let mut in_unit = (forms.clone(), error);
        for _ in 0..MAX_DOUBLINGS {
            if in_unit.0.len() < forms.len() {
                break;
            }
            if form::moving(&in_unit.0) <= BALANCED * forms.len() as f64 {
                (self.forms, self.error) = in_unit;
                return Some(());
            }
            self.unit *= 2.0;
            in_unit = self.equations(task)?;
        }
        (self.unit, self.forms, self.error) = (first, forms, error);
        Some(())
    }

    /// Returns the reason why no linkage passes through the poses, or why none was found.
    pub(super) fn reason_for_none(&self, task: &PoseTask, is_complete: bool) -> OpenReason {
        let rounding = self.forms.len() as f64 * (NO_MOVE * self.error).powi(2);
        let first = task.poses.first().map_or(0.0, |pose| pose.angle);
        let keeps = |pose: &Pose| angle::wrapped(pose.angle - first) == 0.0;
        if task.poses.iter().all(keeps) {
            OpenReason::Shift
        } else if form::moving(&self.forms) <= rounding {
            OpenReason::Turn(self.plain(self.middle.exactly()))
        } else if is_complete {
            OpenReason::NoPair
        } else {
            OpenReason::Far
        }
    }

    /// Returns the body's origin at the first pose.
    pub(super) fn origin(&self) -> Vec2 {
        self.poses
            .first()
            .map_or(Vec2::ZERO, |[at, _]| at.nearest())
    }

    /// Returns the vector from the body's origin to the origin of pins, and from the middle of the
    /// poses to the origin of pivots, in units of the equations.
    pub(super) fn offsets(&self) -> [Vec2<Double>; 2] {
        let count = Double::exactly(self.poses.len() as f64);
        let origins = self.poses.iter().map(|[at, _]| *at / count);
        let middle = origins.fold(Vec2::ZERO.exactly(), |sum, at| sum + at);
        [
            self.quietest_point.exactly(),
            self.middle.exactly() - middle,
        ]
        .map(|offset: Vec2<Double>| offset.scaled(1.0 / self.unit))
    }

    /// Returns the independent equations and the effect of the poses' rounding on them; `None` if a
    /// coefficient is not finite.
    fn equations(&self, task: &PoseTask) -> Option<(Vec<Form>, f64)> {
        let forms: Vec<Form> = self
            .poses
            .iter()
            .map(|[at, turn]| {
                let moved =
                    *at + self.quietest_point.exactly().turned(*turn) - self.middle.exactly();
                form::of_pose(moved.scaled(1.0 / self.unit), *turn)
            })
            .collect();
        let first = forms.first()?;
        let difference = |other: &Form| form::minus(other, first, Double::ONE);
        let differences: Vec<Form> = forms[1..].iter().map(difference).collect();
        let is_finite = |form: &Form| form.iter().flatten().all(|c| c.hi.is_finite());
        differences
            .iter()
            .all(is_finite)
            .then(|| form::independent(differences, self.rounding(task)))
    }

    /// Returns the effect of rounding the poses to doubles on the difference of two equations,
    /// before they are made independent.
    fn rounding(&self, task: &PoseTask) -> f64 {
        let (mut turn, mut place) = (0.0_f64, 0.0_f64);
        for pose in &task.poses {
            turn = turn.max(pose.angle.to_radians().abs());
            place = place.max(pose.at.norm());
        }
        // The pin's positions depend on both.
        let place = (place + turn * self.quietest_point.norm()) / self.unit;
        4.0 * U * (turn + place)
    }
}

/// Returns the maximum distance between the origins. If they all coincide, returns the maximum
/// distance of a given pivot or pin, or 1.
fn size(task: &PoseTask) -> f64 {
    let poses = &task.poses;
    let distance =
        |from: Vec2, to: &[Vec2]| to.iter().map(|at| (*at - from).norm()).fold(0.0, f64::max);
    let origins: Vec<Vec2> = poses.iter().map(|pose| pose.at).collect();
    let spread = origins
        .iter()
        .map(|at| distance(*at, &origins))
        .fold(0.0, f64::max);
    if spread > 0.0 {
        return spread;
    }
    let first = origins.first().copied().unwrap_or_default();
    let given = distance(first, &task.pivots).max(distance(Vec2::ZERO, &task.pins));
    if given > 0.0 { given } else { 1.0 }
}

/// Returns a ground point c and a body point w that minimise the sum of `|d_j + e_j w - c|^2`.
/// Relative to them, the equations depend neither on the ground's origin nor on the body's.
fn least_moved_points(task: &PoseTask) -> Option<(Vec2, Vec2)> {
    let count = task.poses.len() as f64;
    let turns = || task.poses.iter().map(|pose| angle::unit(pose.angle));
    let places = || task.poses.iter().map(|pose| pose.at);
    // Each part is divided first, since the sum of coordinates may overflow.
    let mean_turn = turns().fold(Vec2::ZERO, |sum, e| sum + e / count);
    let mean = places().fold(Vec2::ZERO, |sum, d| sum + d / count);
    let (mut moved, mut spread) = (Vec2::ZERO, RIDGE * count);
    for (d, e) in places().zip(turns()) {
        moved += (d - mean).turned((e - mean_turn).conj());
        spread += (e - mean_turn).norm2();
    }
    let quietest = -moved / spread;
    let middle = mean + quietest.turned(mean_turn);
    (middle.is_finite() && quietest.is_finite()).then_some((middle, quietest))
}
