//! Poses and the equations of dyads through them, in the unit that suits both.

use super::form::{self, Form};
use super::space;
use crate::{OpenReason, Pose, PoseTask};
use kinematics::arithmetic::U;
use kinematics::{Double, Vec2, angle};
use std::ops::RangeInclusive;

/// A part of the number of poses that keeps the quietest point of a body that turns by rounding alone from being far
/// away.
const RIDGE: f64 = 1e-20;
/// The share of what the equations say that is of moves, where turns and moves count alike: five of seven coordinates.
const BALANCED: f64 = 5.0 / 7.0;
/// Equations that say no more of moves than so many times what the rounding of the poses may say, are of turns alone.
const NO_MOVE: f64 = 8.0;
/// Coordinates, and differences of them, from the least to the greatest that are computed with: squares of squares of them
/// are numbers.
const COORDINATES: RangeInclusive<f64> = 1e-70..=1e70;
/// Doublings of the unit: turns that are smaller are rounding.
const MOST_DOUBLINGS: u8 = 50;

/// Poses, and the equations of dyads through them: pivots from the middle, and pins counted from the point of the body that
/// moves least.
pub(super) struct Guidance {
    /// The origin and the unit vector of the x axis of each.
    pub(super) poses: Vec<[Vec2<Double>; 2]>,
    /// A length: how far apart the poses are.
    pub(super) size: f64,
    /// The length that the equations count in: a power of two from about the size on.
    pub(super) unit: f64,
    /// A point of the ground that pivots are counted from.
    pub(super) middle: Vec2,
    /// A point of the body, in its frame.
    pub(super) quietest: Vec2,
    /// The equations that say something, each of length one and orthogonal to the others; with five poses at most four.
    pub(super) forms: Vec<Form>,
    /// What the rounding of the poses to doubles may make of them.
    pub(super) error: f64,
}

impl Guidance {
    /// None where a pose is no number, or the poses have no size that can be computed in.
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
        let (middle, quietest) = least_moved(task)?;
        let mut guidance = Guidance {
            poses,
            size,
            unit,
            middle,
            quietest,
            forms: Vec::new(),
            error: 0.0,
        };
        guidance.balance(task)?;
        Some(guidance)
    }

    /// Sets up the equations in the unit in which turns and moves count alike: of poses that nearly repeat, the pins are
    /// as many sizes away as the turns are small. Where moves in that unit are rounding, it stays the size.
    fn balance(&mut self, task: &PoseTask) -> Option<()> {
        let first = self.unit;
        let (forms, error) = self.equations(task)?;
        let mut in_unit = (forms.clone(), error);
        for _ in 0..MOST_DOUBLINGS {
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

    /// Why no linkage leads through the poses, or none that was found.
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

    /// The body's origin at the first pose.
    pub(super) fn origin(&self) -> Vec2 {
        self.poses
            .first()
            .map_or(Vec2::ZERO, |[at, _]| at.nearest())
    }

    /// The way from the body's origin to where pins are counted from, and from the middle of the poses to where pivots
    /// are, in units of the equations.
    pub(super) fn offsets(&self) -> [Vec2<Double>; 2] {
        let count = Double::exactly(self.poses.len() as f64);
        let origins = self.poses.iter().map(|[at, _]| *at / count);
        let middle = origins.fold(Vec2::ZERO.exactly(), |sum, at| sum + at);
        [self.quietest.exactly(), self.middle.exactly() - middle]
            .map(|offset: Vec2<Double>| offset.scaled(1.0 / self.unit))
    }

    /// With what the rounding of the poses may make of each.
    fn equations(&self, task: &PoseTask) -> Option<(Vec<Form>, f64)> {
        let forms: Vec<Form> = self
            .poses
            .iter()
            .map(|[at, turn]| {
                let moved = *at + self.quietest.exactly().turned(*turn) - self.middle.exactly();
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

    /// What the rounding of the poses to doubles may make of the difference of two equations, before they are made
    /// independent.
    fn rounding(&self, task: &PoseTask) -> f64 {
        let (mut turn, mut place) = (0.0_f64, 0.0_f64);
        for pose in &task.poses {
            turn = turn.max(pose.angle.to_radians().abs());
            place = place.max(pose.at.norm());
        }
        // The pin's places hang on both.
        let place = (place + turn * self.quietest.norm()) / self.unit;
        4.0 * U * (turn + place)
    }
}

/// How far apart the origins are; where they all are one, how far away what is given is.
fn size(task: &PoseTask) -> f64 {
    let poses = &task.poses;
    let apart =
        |from: Vec2, to: &[Vec2]| to.iter().map(|at| (*at - from).norm()).fold(0.0, f64::max);
    let origins: Vec<Vec2> = poses.iter().map(|pose| pose.at).collect();
    let spread = origins
        .iter()
        .map(|at| apart(*at, &origins))
        .fold(0.0, f64::max);
    if spread > 0.0 {
        return spread;
    }
    let first = origins.first().copied().unwrap_or_default();
    let given = apart(first, &task.pivots).max(apart(Vec2::ZERO, &task.pins));
    if given > 0.0 { given } else { 1.0 }
}

/// A point c of the ground and a point w of the body with the least sum of `|d_j + e_j w - c|^2`; with it the equations
/// depend neither on where the ground's origin is nor on where the body's is.
fn least_moved(task: &PoseTask) -> Option<(Vec2, Vec2)> {
    let count = task.poses.len() as f64;
    let turns = || task.poses.iter().map(|pose| angle::unit(pose.angle));
    let places = || task.poses.iter().map(|pose| pose.at);
    // Each part by itself: the sum of coordinates may be no number.
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
