//! Reads states whose values are known to exist.

use super::state::{Sliding, State, Travel};
use crate::{LinkId, PointId, SlideId, Vec2};
use std::ops::Deref;

/// A state for readers that have checked which values exist. A missing value reads as NaN, which no
/// table shows and no comparison accepts.
#[derive(Clone, Copy, Debug)]
pub struct Known<'a>(&'a State);

const NOWHERE: Vec2 = Vec2::new(f64::NAN, f64::NAN);

impl State {
    /// Returns a view of the state whose readers return NaN instead of `None`.
    pub fn known(&self) -> Known<'_> {
        Known(self)
    }
}

impl Deref for Known<'_> {
    type Target = State;

    fn deref(&self) -> &State {
        self.0
    }
}

impl Known<'_> {
    /// Returns the position of a point.
    pub fn position(self, point: PointId) -> Vec2 {
        self.0.position(point).unwrap_or(NOWHERE)
    }

    /// Returns the velocity of a point.
    pub fn velocity(self, point: PointId) -> Vec2 {
        self.0.velocity(point).unwrap_or(NOWHERE)
    }

    /// Returns the acceleration of a point.
    pub fn acceleration(self, point: PointId) -> Vec2 {
        self.0.acceleration(point).unwrap_or(NOWHERE)
    }

    /// Returns the unit vector along the x axis of a link.
    pub fn direction(self, link: LinkId) -> Vec2 {
        self.0.direction(link).unwrap_or(NOWHERE)
    }

    /// Returns the angle of a link in degrees, from 0 to below 360.
    pub fn angle(self, link: LinkId) -> f64 {
        self.0.angle(link).unwrap_or(f64::NAN)
    }

    /// Returns the angular velocity of a link in rad/s.
    pub fn omega(self, link: LinkId) -> f64 {
        self.0.omega(link).unwrap_or(f64::NAN)
    }

    /// Returns the angular acceleration of a link in rad/s^2.
    pub fn alpha(self, link: LinkId) -> f64 {
        self.0.alpha(link).unwrap_or(f64::NAN)
    }

    /// Returns the motion of a slide along its guide.
    pub fn travel(self, slide: SlideId) -> Sliding {
        let travel = self.0.travel(slide);
        let figure = |figure: Option<f64>| figure.unwrap_or(f64::NAN);
        let rate = |of: fn(&Travel) -> Option<f64>| figure(travel.as_ref().and_then(of));
        Sliding {
            position: figure(travel.map(|t| t.position)),
            guide: travel.map_or(NOWHERE, |t| t.guide),
            rate: rate(|t| t.rate),
            accel: rate(|t| t.accel),
            omega: rate(|t| t.omega),
            alpha: rate(|t| t.alpha),
        }
    }
}
