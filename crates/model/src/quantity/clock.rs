//! Computes the driver's motion over time.
//!
//! Time is 0 at the scene's start position. From there the driver follows the scene's motion law,
//! or moves with its speed w and acceleration a: q(t) = q0 + w t + a t^2 / 2, at the rate w + a t.
//!
//! Everywhere else in krank, a value belongs to a coordinate passed with the speed w. Curves over
//! time use the rates of the driver's actual speed, so that the slope of a position over time is
//! the velocity shown next to it.

use super::{Aspect, Quantity, QuantitySource, Subject, value};
use crate::arithmetic::Sharp;
use crate::scene::Scene;
use crate::solver::{Order, Range, State};
use crate::{Constant, Driver, DriverMoment, Input, MotionLaw, Number};

/// The driver's coordinate as a function of time, in seconds from the scene's start position.
#[derive(Clone, Debug, PartialEq)]
pub struct Clock {
    /// The start coordinate, in degrees or in the scene's length unit.
    start: f64,
    /// The rate of the coordinate, per second; not 0.
    speed: f64,
    /// The second derivative of the coordinate, per second squared.
    acceleration: f64,
    /// The driver's motion law, if it does not move by its speed.
    law: Option<MotionLaw>,
}

/// Relative tolerance for the ends of an interval of time, because of rounding.
const ROUNDING: f64 = 1e-12;
/// Tolerance for a coordinate computed from a time, as a fraction of the range.
const COORDINATE_TOLERANCE: f64 = 1e-12;

/// The driver's rates at a time, relative to the scene's speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MotionRates {
    /// The driver's speed, divided by the scene's speed.
    ratio: f64,
    /// The driver's acceleration, divided by the scene's speed, per second.
    drift: f64,
    /// The scene's acceleration, divided by the scene's speed, per second.
    own: f64,
}

impl Clock {
    /// Creates the clock of a driver that moves by its speed; `None` if the speed is 0, because
    /// time then determines nothing.
    #[must_use]
    pub fn new(driver: &Driver) -> Option<Clock> {
        let scale = |rate: f64| match driver.input {
            Input::Turn(_) => rate.to_degrees(),
            Input::Push(_) => rate,
        };
        let clock = Clock {
            start: driver.start,
            speed: scale(driver.speed),
            acceleration: scale(driver.acceleration),
            law: None,
        };
        let runs = clock.speed != 0.0 && (1.0 / clock.speed).is_finite();
        runs.then_some(clock)
    }

    /// Creates the clock of a scene, by its motion law if it has one.
    #[must_use]
    pub fn of(scene: &Scene) -> Option<Clock> {
        let law = scene.motion.clone();
        let clock = Clock::new(scene.mechanism.driver())?;
        Some(Clock { law, ..clock })
    }

    /// Returns the driver's moment at a time. Rounding moves the coordinate neither beyond a limit
    /// nor slightly inside it.
    #[must_use]
    pub fn moment(&self, time: f64, range: Range) -> DriverMoment {
        let moment = match &self.law {
            Some(law) => law.at(time),
            None => self.evenly(time),
        };
        let Range::Limited { low, high } = range else {
            return moment;
        };
        // Next to a dead point rates are unbounded; exactly there they do not exist.
        let at = moment.at;
        let limit = if at - low < high - at { low } else { high };
        let is_there = (at - limit).abs() <= COORDINATE_TOLERANCE * (high - low);
        let at = match (is_there, &self.law) {
            (true, _) => limit,
            (false, Some(_)) => at,
            // A driver without a law stops at its limits.
            (false, None) => at.max(low).min(high),
        };
        let mut off = moment.off;
        let moved = (at - moment.at).abs();
        // If the error reaches the limit, the limit is meant.
        off[0] = match at == limit && moved <= off[0] {
            true => 0.0,
            false => off[0] + moved,
        };
        DriverMoment { at, off, ..moment }
    }

    /// Returns the moment of a driver that moves by its speed, with its deviation from the
    /// double-double result.
    fn evenly(&self, time: f64) -> DriverMoment {
        // Converted when read, and once more to the driver's unit.
        let given = |rate: f64| {
            let rate = Constant::given(rate).converted();
            Sharp::of(rate.widened(rate.radius))
        };
        let [speed, acceleration] = [self.speed, self.acceleration].map(given);
        let [start, requested] = [self.start, time].map(|v| Sharp::of(Constant::given(v)));
        let exact = [
            start + requested * (speed + requested * acceleration.scaled(0.5)),
            speed + acceleration * requested,
            acceleration,
        ];
        let found = [
            self.coordinate(time),
            self.speed + self.acceleration * time,
            self.acceleration,
        ];
        let off = |k: usize| exact[k].radius + exact[k].way_from(found[k]).abs();
        let [at, speed, acceleration] = found;
        DriverMoment {
            at,
            speed,
            acceleration,
            off: [off(0), off(1), off(2)],
        }
    }

    /// Returns the moment at a coordinate passed with the scene's own speed, regardless of its
    /// motion law.
    #[must_use]
    pub fn passing(&self, at: f64) -> DriverMoment {
        let moment = self.evenly(0.0);
        let [_, speed, acceleration] = moment.off;
        DriverMoment {
            at,
            // The coordinate is exactly the requested one.
            off: [0.0, speed, acceleration],
            ..moment
        }
    }

    /// Returns the driver's coordinate at a time, in degrees or in the scene's length unit.
    #[must_use]
    pub fn coordinate(&self, time: f64) -> f64 {
        match &self.law {
            Some(law) => law.at(time).at,
            None => self.start + time * (self.speed + 0.5 * self.acceleration * time),
        }
    }

    /// Returns the driver's motion law, if it does not move by its speed.
    #[must_use]
    pub fn law(&self) -> Option<&MotionLaw> {
        self.law.as_ref()
    }

    /// Returns the time at which the driver reaches a coordinate in its initial direction, or
    /// `None` if it reverses before. With a motion law, returns the first such time in a period.
    #[must_use]
    pub fn time(&self, coordinate: f64) -> Option<f64> {
        match &self.law {
            Some(law) => law.first(coordinate, [0.0, law.period()]),
            None => self.times(coordinate - self.start)[0],
        }
    }

    /// Returns the first time between `low` and `high` at which the driver is at a coordinate. A
    /// driver that reverses can pass it twice.
    pub(super) fn time_between(&self, coordinate: f64, low: f64, high: f64) -> Option<f64> {
        if let Some(law) = &self.law {
            return law.first(coordinate, [low, high]);
        }
        let times = self.times(coordinate - self.start).into_iter().flatten();
        // The ends themselves were rounded.
        let slack = ROUNDING * (high - low);
        let within = times.filter(|t| (low - slack..=high + slack).contains(t));
        within.min_by(f64::total_cmp).map(|t| t.max(low).min(high))
    }

    /// Returns `true` if the driver moves at constant speed.
    pub(super) fn is_even(&self) -> bool {
        self.acceleration == 0.0 && self.law.is_none()
    }

    /// Returns the period of the whole motion in seconds, if it repeats, for a linkage with this
    /// range.
    pub(super) fn period(&self, range: Range) -> Option<f64> {
        let way = match range {
            Range::Full { period } => Some(period),
            Range::Limited { .. } => None,
        };
        match &self.law {
            None => way
                .filter(|_| self.is_even())
                .map(|way| (way / self.speed).abs()),
            Some(law) => {
                let stays = law.advance() == 0.0;
                let repeats = stays || way.is_some_and(|way| law.advance() % way == 0.0);
                repeats.then(|| law.period())
            }
        }
    }

    /// Returns the driver's rates at a time; `None` if they are constantly the scene's.
    pub(super) fn pace(&self, time: f64) -> Option<MotionRates> {
        let own = self.acceleration / self.speed;
        if let Some(law) = &self.law {
            let moment = law.at(time);
            return Some(MotionRates {
                ratio: moment.speed / self.speed,
                drift: moment.acceleration / self.speed,
                own,
            });
        }
        (!self.is_even()).then_some(MotionRates {
            ratio: 1.0 + own * time,
            drift: own,
            own,
        })
    }

    /// Returns the start and end time of the motion: from 0 s over one period, or from the limit
    /// where the driver came from to the limit where it ends.
    #[must_use]
    pub fn span(&self, range: Range) -> (f64, f64) {
        if let Some(law) = &self.law {
            return (0.0, law.period());
        }
        match range {
            Range::Full { period } => (0.0, self.exit(-period, period)),
            Range::Limited { low, high } => {
                let (low, high) = (low - self.start, high - self.start);
                let back = Clock {
                    speed: -self.speed,
                    ..self.clone()
                };
                (-back.exit(low, high), self.exit(low, high))
            }
        }
    }

    /// Returns the first time at which the driver leaves the interval from `low` to `high`, both
    /// relative to its start.
    fn exit(&self, low: f64, high: f64) -> f64 {
        let outwards = [(low, -1.0), (high, 1.0)];
        let leaves = outwards.into_iter().flat_map(|(far, sense)| {
            let times = self.times(far).into_iter().flatten();
            let rate = move |t: f64| (self.speed + self.acceleration * t) * sense;
            times.filter(move |&t| t >= 0.0 && rate(t) > 0.0)
        });
        leaves.min_by(f64::total_cmp).unwrap_or(0.0)
    }

    /// Returns the times at which the driver is at the distance `far` from its start, first the one
    /// in its initial direction. They are the roots of a t^2 / 2 + w t - far, computed without
    /// cancellation.
    fn times(&self, far: f64) -> [Option<f64>; 2] {
        let (w, a) = (self.speed, self.acceleration);
        let root = (w * w + 2.0 * a * far).sqrt().copysign(w);
        let near = 2.0 * far / (w + root);
        let other = -(w + root) / a;
        [near, other].map(|t| Some(t).filter(|t| t.is_finite()))
    }
}

/// Returns the value of a quantity when the driver runs at another pace than the scene's. Rates are
/// K q' and K q'' + K' q'^2, and the state has those for the scene's own q' and q''.
pub(super) fn paced(quantity: &Quantity, state: &State, pace: Option<MotionRates>) -> Option<f64> {
    let Some(pace) = pace else {
        return quantity.value(state);
    };
    let paced = match &quantity.source {
        QuantitySource::Solved(subject, aspect) => solved(*subject, *aspect, state, pace),
        QuantitySource::Derived(derived) => {
            derived.run(|subject, aspect| solved(subject, aspect, state, pace))
        }
    };
    paced.filter(|value| value.is_finite())
}

/// Returns the value of a solver quantity at another pace.
fn solved(subject: Subject, aspect: Aspect, state: &State, pace: MotionRates) -> Option<f64> {
    let plain = value(subject, aspect, state)?;
    if subject == Subject::Driver {
        // The driver's own rates are given by the pace.
        return Some(match aspect.order() {
            Order::Velocity => plain * pace.ratio,
            Order::Acceleration => plain + (pace.drift - pace.own) * state.driver_speed(),
            Order::Position | Order::Force => plain,
        });
    }
    let first = |aspect| value(subject, aspect, state);
    let second =
        |rate: f64| rate * pace.drift + (plain - rate * pace.own) * pace.ratio * pace.ratio;
    let paced = match aspect {
        Aspect::X | Aspect::Y | Aspect::Angle | Aspect::Length => plain,
        Aspect::Vx | Aspect::Vy | Aspect::Omega | Aspect::Rate => plain * pace.ratio,
        Aspect::Ax => second(first(Aspect::Vx)?),
        Aspect::Ay => second(first(Aspect::Vy)?),
        Aspect::Alpha => second(first(Aspect::Omega)?),
        Aspect::Accel => second(first(Aspect::Rate)?),
        // Loads, dampers and inertia forces cannot be derived from those at another pace.
        Aspect::Torque
        | Aspect::Force
        | Aspect::Power
        | Aspect::Fx
        | Aspect::Fy
        | Aspect::Normal
        | Aspect::Moment => return None,
    };
    Some(paced)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clock(start: f64, speed: f64, acceleration: f64) -> Clock {
        Clock {
            start,
            speed,
            acceleration,
            law: None,
        }
    }

    const LIMITED: Range = Range::Limited {
        low: -30.0,
        high: 90.0,
    };

    #[test]
    fn time_is_zero_at_start_and_inverts_coordinate() {
        for clock in [
            clock(60.0, 100.0, 0.0),
            clock(60.0, -100.0, 7.0),
            clock(-5.0, 3.0, 2.0),
        ] {
            assert_eq!(clock.coordinate(0.0), clock.start);
            for time in [-0.3, 0.0, 0.1, 1.0] {
                let back = clock.time(clock.coordinate(time)).unwrap();
                assert!((back - time).abs() < 1e-12, "{clock:?} {time} {back}");
            }
        }
    }

    #[test]
    fn span_covers_limits_or_one_period() {
        assert_eq!(clock(60.0, 100.0, 0.0).span(LIMITED), (-0.9, 0.3));
        assert_eq!(clock(60.0, -100.0, 0.0).span(LIMITED), (-0.3, 0.9));
        let full = Range::Full { period: 720.0 };
        assert_eq!(clock(60.0, -100.0, 0.0).span(full), (0.0, 7.2));
        // The start is at the limit.
        assert_eq!(clock(90.0, 10.0, 0.0).span(LIMITED), (-12.0, 0.0));
    }

    /// Forwards by a cycloid, a dwell at 120, and back at a constant speed.
    #[test]
    fn timed_motion_maps_time_and_coordinate_both_ways() {
        use crate::{StepLaw, TimedStep};
        let step = |law, to, time| TimedStep::Law { law, to, time };
        let steps = vec![
            step(StepLaw::Cycloidal, 120.0, 0.5),
            step(StepLaw::Constant, 120.0, 0.25),
            step(StepLaw::Constant, 0.0, 0.25),
        ];
        let clock = Clock {
            law: MotionLaw::new(0.0, steps, true),
            ..clock(0.0, 57.3, 0.0)
        };
        let range = Range::Full { period: 360.0 };
        assert_eq!(
            (clock.span(range), clock.period(range)),
            ((0.0, 1.0), Some(1.0))
        );
        let joints = clock.law().unwrap().joints();
        assert_eq!(joints.collect::<Vec<_>>(), [0.5, 0.75, 1.0]);
        let moment = clock.moment(0.25, range);
        assert!((moment.at - 60.0).abs() < 1e-12 && (moment.speed - 480.0).abs() < 1e-9);
        let time = clock.time(60.0).unwrap();
        assert!((time - 0.25).abs() < 1e-12, "{time}");
        let back = clock.time_between(30.0, 0.6, 1.0).unwrap();
        assert!((back - 0.9375).abs() < 1e-12, "{back}");
        assert_eq!(clock.time(121.0), None);
        // Coordinates beyond a stop are not clamped: the mechanism cannot follow.
        assert_eq!(clock.moment(0.6, LIMITED).at, 120.0);
    }

    #[test]
    fn reversing_driver_leaves_at_entry_limit() {
        // From 60 up to 70 in 2 s, and back: at -30 after 2 + sqrt(20 * 100 / 50) s.
        let clock = clock(60.0, 10.0, -5.0);
        let (from, to) = clock.span(LIMITED);
        let way = 40.0_f64.sqrt();
        assert!(
            (to - 2.0 - way).abs() < 1e-12 && (from - 2.0 + way).abs() < 1e-12,
            "{from} {to}"
        );
        assert_eq!(clock.time(71.0), None);
    }
}
