//! The equation of a dyad, and the conversion of its solutions.
//!
//! Pose j puts the pin w of the body at `B_j = d_j + e_j w`, with e_j the unit vector of its angle,
//! as complex numbers. A link on the pivot a keeps `|B_j - a|` constant:
//!
//! ```text
//! 1/2 |d_j|^2 + Re(conj(d_j) e_j w) - Re(conj(d_j) a) - Re(conj(e_j w) a) = k,    the same k for all j
//! ```
//!
//! (McCarthy and Soh, Geometric Design of Linkages, 2nd ed. 2011, chapter 5; Sandor and Erdman,
//! Advanced Mechanism Design, 1984, chapter 3.) With homogeneous coordinates of the pin `(x, y, w)`
//! and of the pivot `(X, Y, W)`, every difference of two of them is a bilinear
//! [`Form`](form::Form): n poses give n - 1. A pivot at infinity is the normal of a slide, so that
//! slides need no separate equations.

use super::dyad_equations::Guidance;
use super::form;
use super::space::{self, Triple};
use crate::{PinConstraint, PosedDyad};
use kinematics::{Double, Vec2};

/// Maximum distance of a pin from its circle or its line, relative to the size.
const MISS: f64 = 1e-9;
/// Pins or pivots closer to each other than this fraction of the size coincide. Poses rounded to
/// doubles split a double root by the square root of their rounding error.
const ONE: f64 = 1e-7;
/// Distance in sizes beyond which a pin is at infinity, and beyond which a pivot may be a slide.
const INFINITE_DISTANCE: f64 = 1e6;
/// Angle to the x axis, in degrees, below which a direction is parallel to it.
const LEVEL: f64 = 1e-14;
/// A pin of the body with its partner, which holds it in all poses.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FullDyad {
    /// The pivot or the slide.
    pub by: PinConstraint,
    /// The pin in the body's frame.
    pub pin: Vec2,
    /// The pin at every pose.
    pub places: Vec<Vec2>,
}

impl FullDyad {
    /// Converts to the public type.
    pub(super) fn dyad(&self) -> Option<PosedDyad> {
        let pin = *self.places.first()?;
        Some(PosedDyad { held: self.by, pin })
    }
}

impl Guidance {
    /// Returns `true` if a solution of the equations does not give a link: the pin is at infinity,
    /// does not move, or coincides with its pivot.
    pub(super) fn is_nothing(&self, pin: Triple, pivot: Triple) -> bool {
        let Some(positions) = self.pin(pin).and_then(|pin| self.places(pin)) else {
            return true;
        };
        let pivot = Vec2::new(pivot[0] / pivot[2], pivot[1] / pivot[2]);
        let pivot = pivot.scaled(self.unit) + self.middle.exactly();
        let is_short = |at: &Vec2<Double>| (*at - pivot).norm().hi < ONE * self.size;
        positions.first().is_some_and(is_short)
    }

    /// Returns the dyad of a ground pivot. It is unique if at least two equations are independent.
    /// Returns `None` if no pin keeps its distance from the pivot.
    pub(super) fn on_pivot(&self, pivot: Vec2) -> Option<FullDyad> {
        let position = (pivot - self.middle).exactly().scaled(1.0 / self.unit);
        let rows: Vec<Triple> = self
            .forms
            .iter()
            .map(|f| form::of_pivot(f, space::point(position)))
            .collect();
        let pin = self.pin(space::kernel(&rows)?)?;
        let positions = self.places(pin)?;
        let by = PinConstraint::Rocker(pivot);
        let is_held = self.keeps_distance(&positions, pivot);
        is_held.then(|| self.with(by, pin, &positions))
    }

    /// Returns the dyad of a pin given in the body's frame; `None` if no pivot or slide holds it.
    pub(super) fn on_pin(&self, pin: Vec2) -> Option<FullDyad> {
        let position = (pin - self.quietest_point)
            .exactly()
            .scaled(1.0 / self.unit);
        let rows: Vec<Triple> = self
            .forms
            .iter()
            .map(|f| form::of_pin(f, space::point(position)))
            .collect();
        self.held(pin, space::kernel(&rows)?)
    }

    /// Returns the dyad of a solution of the equations. Returns `None` if the pin is at infinity,
    /// if pin or link degenerates, or if the dyad does not pass through the poses.
    pub(super) fn dyad(&self, pin: Triple, pivot: Triple) -> Option<FullDyad> {
        self.held(self.pin(pin)?, pivot)
    }

    fn pin(&self, pin: Triple) -> Option<Vec2> {
        let position = Vec2::new(pin[0] / pin[2], pin[1] / pin[2]);
        let is_near = position.nearest().norm() <= INFINITE_DISTANCE * self.size / self.unit;
        let pin = position.scaled(self.unit) + self.quietest_point.exactly();
        (is_near && pin.nearest().is_finite()).then(|| self.plain(pin))
    }

    /// Rounds to doubles; coordinates below the rounding error of the size become zero.
    pub(super) fn plain(&self, position: Vec2<Double>) -> Vec2 {
        let minimum = f64::EPSILON * self.size;
        position
            .nearest()
            .map(|v| if v.abs() < minimum { 0.0 } else { v })
    }

    /// Returns the pin's position at every pose; `None` if it does not move, since anything holds
    /// it then.
    fn places(&self, pin: Vec2) -> Option<Vec<Vec2<Double>>> {
        let place = |[at, turn]: &[Vec2<Double>; 2]| *at + pin.exactly().turned(*turn);
        let positions: Vec<Vec2<Double>> = self.poses.iter().map(place).collect();
        let first = *positions.first()?;
        let moves = |at: &Vec2<Double>| (*at - first).nearest().norm() >= ONE * self.size;
        positions.iter().any(moves).then_some(positions)
    }

    fn held(&self, pin: Vec2, pivot: Triple) -> Option<FullDyad> {
        let positions = self.places(pin)?;
        let by = self
            .slide(&positions, pivot)
            .or_else(|| self.rocker(&positions, pivot))?;
        Some(self.with(by, pin, &positions))
    }

    fn with(&self, by: PinConstraint, pin: Vec2, positions: &[Vec2<Double>]) -> FullDyad {
        let positions = positions.iter().map(|at| at.nearest()).collect();
        FullDyad {
            by,
            pin,
            places: positions,
        }
    }

    /// Returns the full dyad of a posed one; `None` if the pin does not move.
    pub(super) fn known(&self, dyad: &PosedDyad) -> Option<FullDyad> {
        let [at, turn] = *self.poses.first()?;
        let pin = (dyad.pin.exactly() - at).turned(turn.conj()).nearest();
        let positions = self.places(pin)?;
        Some(self.with(dyad.held, pin, &positions))
    }

    /// Returns `true` if two dyads differ only by rounding.
    pub(super) fn is_same(&self, a: &FullDyad, b: &FullDyad) -> bool {
        let near = |a: Vec2, b: Vec2, size: f64| (a - b).norm() <= ONE * size;
        let is_held_alike = match (a.by, b.by) {
            (PinConstraint::Rocker(p), PinConstraint::Rocker(q)) => {
                let length = a.places.first().map_or(0.0, |at| (*at - p).norm());
                near(p, q, self.size.max(length))
            }
            // A pin has at most one line.
            (PinConstraint::Slide(_), PinConstraint::Slide(_)) => true,
            (PinConstraint::Rocker(_), PinConstraint::Slide(_))
            | (PinConstraint::Slide(_), PinConstraint::Rocker(_)) => false,
        };
        is_held_alike && near(a.pin, b.pin, self.size)
    }

    /// Returns a slide if the pivot is far away and the pin's positions are on a line.
    fn slide(&self, positions: &[Vec2<Double>], pivot: Triple) -> Option<PinConstraint> {
        let [x, y, w] = pivot;
        let is_far = w.hi.abs() * INFINITE_DISTANCE * (self.size / self.unit) <= x.hi.hypot(y.hi);
        // Relative to the first position: for a finite pivot this gives its circle's tangent there.
        let first = (*positions.first()? - self.middle.exactly()).scaled(1.0 / self.unit);
        let normal = Vec2::new(x, y) - first * w;
        let normal = normal / normal.norm();
        let off = |at: &Vec2<Double>| normal.dot(*at - *positions.first().unwrap_or(at)).hi.abs();
        let is_line = positions.iter().all(|at| off(at) <= MISS * self.size);
        let along = Double::degrees(-normal.perp()).hi;
        let along = if along.abs() < LEVEL {
            0.0
        } else {
            along.rem_euclid(180.0)
        };
        (is_far && is_line && along.is_finite()).then_some(PinConstraint::Slide(along))
    }

    fn rocker(&self, positions: &[Vec2<Double>], pivot: Triple) -> Option<PinConstraint> {
        let position = Vec2::new(pivot[0] / pivot[2], pivot[1] / pivot[2]);
        let pivot = self.plain(position.scaled(self.unit) + self.middle.exactly());
        self.keeps_distance(positions, pivot)
            .then_some(PinConstraint::Rocker(pivot))
    }

    /// Returns `true` if all positions have the same nonzero distance from a pivot.
    fn keeps_distance(&self, positions: &[Vec2<Double>], pivot: Vec2) -> bool {
        let distances = positions.iter().map(|at| (*at - pivot.exactly()).norm());
        let distances: Vec<Double> = distances.collect();
        let Some(&first) = distances.first() else {
            return false;
        };
        let is_same = |d: &Double| (*d - first).hi.abs() <= MISS * self.size;
        pivot.is_finite() && first.hi >= ONE * self.size && distances.iter().all(is_same)
    }
}
