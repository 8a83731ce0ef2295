//! The equation of a dyad, and what is made of its solutions.
//!
//! Pose j puts the pin w of the body at `B_j = d_j + e_j w`, with e_j the unit vector of its angle, as complex numbers.
//! A link on the pivot a keeps `|B_j - a|`:
//!
//! ```text
//! 1/2 |d_j|^2 + Re(conj(d_j) e_j w) - Re(conj(d_j) a) - Re(conj(e_j w) a) = k,    the same k for all j
//! ```
//!
//! (McCarthy and Soh, Geometric Design of Linkages, 2nd ed. 2011, chapter 5; Sandor and Erdman, Advanced Mechanism
//! Design, 1984, chapter 3.) With homogeneous coordinates of the pin `(x, y, w)` and of the pivot `(X, Y, W)` every
//! difference of two of them is a bilinear [`Form`]: n poses give n - 1. A pivot at infinity is the normal of a slide, so
//! that slides are no case of their own.

use super::form::{self, Form};
use super::space::{self, Triple};
use crate::arithmetic::U;
use crate::synthesis::{OpenReason, Partner, Pose, PoseTask, PosedDyad};
use crate::{Double, Vec2, angle};
use std::ops::RangeInclusive;

/// What a pin may miss its circle or its line by, as a part of the size.
const MISS: f64 = 1e-9;
/// Pins, or pivots, that are nearer to each other than this part of the size are one: poses rounded to doubles
/// split a double root by the root of their rounding.
const ONE: f64 = 1e-7;
/// Pins further out than so many sizes are at infinity; and a pivot that is may be the slide that it looks like.
const FAR: f64 = 1e6;
/// A direction nearer to the x axis than these degrees is its own.
const LEVEL: f64 = 1e-14;
/// A part of the number of poses that keeps the quietest point of a body that turns by rounding alone from being far
/// away.
const RIDGE: f64 = 1e-20;
/// The share of what the equations say that is of turns, where turns and moves count alike: two of seven coordinates.
const BALANCED: f64 = 2.0 / 7.0;
/// What equations say of moves, where they are turns alone, is the square of their rounding.
const NO_MOVE: f64 = 1e-20;
/// Coordinates, and differences of them, from the least to the greatest that are computed with: squares of squares of them
/// are numbers.
const COORDINATES: RangeInclusive<f64> = 1e-70..=1e70;
/// Doublings of the unit: turns that are smaller are rounding.
const MOST_DOUBLINGS: u8 = 50;

/// A pin of the body and what can hold it in all poses.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PinHeld {
    /// The pivot or the slide.
    pub by: Partner,
    /// The pin in the body's frame.
    pub pin: Vec2,
    /// The pin at every pose.
    pub places: Vec<Vec2>,
}

impl PinHeld {
    /// The same as others see it.
    pub(super) fn dyad(&self) -> Option<PosedDyad> {
        let pin = *self.places.first()?;
        Some(PosedDyad { held: self.by, pin })
    }
}

/// Poses, and the equations of dyads through them in units of about their size, from the middle and for pins counted
/// from the point of the body that moves least.
pub(super) struct Guidance {
    poses: Vec<[Vec2<Double>; 2]>,
    /// A length: how far apart the poses are.
    pub size: f64,
    /// A power of two near the size.
    pub unit: f64,
    middle: Vec2,
    quietest: Vec2,
    /// The equations that say something, each of length one and orthogonal to the others; with five poses at most four.
    pub forms: Vec<Form>,
    /// What the rounding of the poses to doubles may make of them.
    pub error: f64,
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
            if form::turning(&in_unit.0) >= BALANCED * forms.len() as f64 {
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
        let turning = form::turning(&self.forms);
        let first = task.poses.first().map_or(0.0, |pose| pose.angle);
        let keeps = |pose: &Pose| angle::wrapped(pose.angle - first) == 0.0;
        if task.poses.iter().all(keeps) {
            OpenReason::Shift
        } else if self.forms.len() as f64 - turning <= NO_MOVE {
            OpenReason::Turn(self.plain(self.middle.exactly()))
        } else if is_complete {
            OpenReason::NoPair
        } else {
            OpenReason::Far
        }
    }

    /// Whether a solution of the equations is none of a linkage: the pin is at infinity, stands still, or is its pivot.
    pub(super) fn is_nothing(&self, pin: Triple, pivot: Triple) -> bool {
        let Some(places) = self.pin(pin).and_then(|pin| self.places(pin)) else {
            return true;
        };
        let pivot = Vec2::new(pivot[0] / pivot[2], pivot[1] / pivot[2]);
        let pivot = pivot.scaled(self.unit) + self.middle.exactly();
        let is_short = |at: &Vec2<Double>| (*at - pivot).norm().hi < ONE * self.size;
        places.first().is_some_and(is_short)
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

    /// The pin that a pivot of the ground can hold; the only one, where there are three poses or more that say different
    /// things.
    pub(super) fn on_pivot(&self, pivot: Vec2) -> Option<PinHeld> {
        let place = (pivot - self.middle).exactly().scaled(1.0 / self.unit);
        let rows: Vec<Triple> = self
            .forms
            .iter()
            .map(|f| form::of_pivot(f, space::point(place)))
            .collect();
        let pin = self.pin(space::kernel(&rows)?)?;
        let places = self.places(pin)?;
        let by = Partner::Rocker(pivot);
        let is_held = self.keeps_distance(&places, pivot);
        is_held.then(|| self.with(by, pin, &places))
    }

    /// What can hold a pin that is given in the body's frame.
    pub(super) fn on_pin(&self, pin: Vec2) -> Option<PinHeld> {
        let place = (pin - self.quietest).exactly().scaled(1.0 / self.unit);
        let rows: Vec<Triple> = self
            .forms
            .iter()
            .map(|f| form::of_pin(f, space::point(place)))
            .collect();
        self.held(pin, space::kernel(&rows)?)
    }

    /// The dyad of a solution of the equations; none where the pin or its link is at infinity, is nothing, or does not
    /// come through the poses.
    pub(super) fn dyad(&self, pin: Triple, pivot: Triple) -> Option<PinHeld> {
        self.held(self.pin(pin)?, pivot)
    }

    fn pin(&self, pin: Triple) -> Option<Vec2> {
        let place = Vec2::new(pin[0] / pin[2], pin[1] / pin[2]);
        let is_near = place.nearest().norm() <= FAR * self.size / self.unit;
        let pin = place.scaled(self.unit) + self.quietest.exactly();
        (is_near && pin.nearest().is_finite()).then(|| self.plain(pin))
    }

    /// In doubles, without what is left of a nought where coordinates of the size are rounded.
    fn plain(&self, place: Vec2<Double>) -> Vec2 {
        let least = f64::EPSILON * self.size;
        place
            .nearest()
            .map(|v| if v.abs() < least { 0.0 } else { v })
    }

    /// Where a pin is at every pose; none where it stands still, since then anything holds it.
    fn places(&self, pin: Vec2) -> Option<Vec<Vec2<Double>>> {
        let place = |[at, turn]: &[Vec2<Double>; 2]| *at + pin.exactly().turned(*turn);
        let places: Vec<Vec2<Double>> = self.poses.iter().map(place).collect();
        let first = *places.first()?;
        let moves = |at: &Vec2<Double>| (*at - first).nearest().norm() >= ONE * self.size;
        places.iter().any(moves).then_some(places)
    }

    fn held(&self, pin: Vec2, pivot: Triple) -> Option<PinHeld> {
        let places = self.places(pin)?;
        let by = self
            .slide(&places, pivot)
            .or_else(|| self.rocker(&places, pivot))?;
        Some(self.with(by, pin, &places))
    }

    fn with(&self, by: Partner, pin: Vec2, places: &[Vec2<Double>]) -> PinHeld {
        let places = places.iter().map(|at| at.nearest()).collect();
        PinHeld { by, pin, places }
    }

    /// A dyad that was found before; none where the pin stands still.
    pub(super) fn known(&self, dyad: &PosedDyad) -> Option<PinHeld> {
        let [at, turn] = *self.poses.first()?;
        let pin = (dyad.pin.exactly() - at).turned(turn.conj()).nearest();
        let places = self.places(pin)?;
        Some(self.with(dyad.held, pin, &places))
    }

    /// Whether two dyads differ by rounding alone.
    pub(super) fn is_same(&self, a: &PinHeld, b: &PinHeld) -> bool {
        let near = |a: Vec2, b: Vec2, size: f64| (a - b).norm() <= ONE * size;
        let is_held_alike = match (a.by, b.by) {
            (Partner::Rocker(p), Partner::Rocker(q)) => {
                let length = a.places.first().map_or(0.0, |at| (*at - p).norm());
                near(p, q, self.size.max(length))
            }
            // A pin has one line at most.
            (Partner::Slide(_), Partner::Slide(_)) => true,
            (Partner::Rocker(_), Partner::Slide(_)) | (Partner::Slide(_), Partner::Rocker(_)) => {
                false
            }
        };
        is_held_alike && near(a.pin, b.pin, self.size)
    }

    /// A slide, where the pivot is far and the places are on a line.
    fn slide(&self, places: &[Vec2<Double>], pivot: Triple) -> Option<Partner> {
        let [x, y, w] = pivot;
        let is_far = w.hi.abs() * FAR * (self.size / self.unit) <= x.hi.hypot(y.hi);
        // Seen from the first place: a pivot that is not at infinity sees its circle's tangent there.
        let first = (*places.first()? - self.middle.exactly()).scaled(1.0 / self.unit);
        let normal = Vec2::new(x, y) - first * w;
        let normal = normal / normal.norm();
        let off = |at: &Vec2<Double>| normal.dot(*at - *places.first().unwrap_or(at)).hi.abs();
        let is_line = places.iter().all(|at| off(at) <= MISS * self.size);
        let along = Double::degrees(-normal.perp()).hi;
        let along = if along.abs() < LEVEL {
            0.0
        } else {
            along.rem_euclid(180.0)
        };
        (is_far && is_line && along.is_finite()).then_some(Partner::Slide(along))
    }

    fn rocker(&self, places: &[Vec2<Double>], pivot: Triple) -> Option<Partner> {
        let place = Vec2::new(pivot[0] / pivot[2], pivot[1] / pivot[2]);
        let pivot = self.plain(place.scaled(self.unit) + self.middle.exactly());
        self.keeps_distance(places, pivot)
            .then_some(Partner::Rocker(pivot))
    }

    /// Whether all places are as far from a pivot, and not on it.
    fn keeps_distance(&self, places: &[Vec2<Double>], pivot: Vec2) -> bool {
        let distances = places.iter().map(|at| (*at - pivot.exactly()).norm());
        let distances: Vec<Double> = distances.collect();
        let Some(&first) = distances.first() else {
            return false;
        };
        let is_same = |d: &Double| (*d - first).hi.abs() <= MISS * self.size;
        pivot.is_finite() && first.hi >= ONE * self.size && distances.iter().all(is_same)
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
