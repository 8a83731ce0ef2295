//! Laws of motion over time: where a driver is, how fast, and how its speed changes.
//!
//! A law is a list of steps from one coordinate to the next, one after another, and begins anew when all are
//! done: a driver that ends where it began repeats its period, one that ends whole turns on goes on from there.

mod peaks;
mod stays;

pub use peaks::MotionPeaks;

use super::spline::ClampedSpline;
use crate::angle::TURN;
use std::f64::consts::PI;

/// How a step goes from its beginning to its end; s is the part of its time, h the part of its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepLaw {
    /// h = s: a constant speed.
    Constant,
    /// h = (1 - cos pi s) / 2.
    Harmonic,
    /// h = s - sin(2 pi s) / (2 pi): no acceleration at both ends.
    Cycloidal,
    /// A speed that grows evenly over this part of the time, stays, and falls as it grew: a trapezoid.
    Trapezoid {
        /// Above 0 and at most a half.
        ramp: f64,
    },
}

/// A part of a motion, from where the one before it ended.
#[derive(Clone, Debug, PartialEq)]
pub enum TimedStep {
    /// To a coordinate, in a time.
    Law {
        /// How it goes there; what stays where it is dwells.
        law: StepLaw,
        /// In degrees or in the scene's length unit.
        to: f64,
        /// In s, above 0.
        time: f64,
    },
    /// Through knots of time, from its beginning on, and coordinate: at rest at both ends.
    Table(ClampedSpline),
}

/// A driver's coordinate over time.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionLaw {
    start: f64,
    steps: Vec<TimedStep>,
    period: f64,
    /// Whole turns, or nothing.
    advance: f64,
}

/// What rounding leaves of nothing, as a part of two coordinates.
const ROUNDING: f64 = 1e-12;

/// Where a driver is, and how it goes on: the coordinate, and its first and second derivative by time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverMoment {
    /// In degrees or in the scene's length unit.
    pub at: f64,
    /// The same per s.
    pub speed: f64,
    /// The same per s^2.
    pub acceleration: f64,
}

impl DriverMoment {
    /// So much farther on.
    fn turned(self, by: f64) -> DriverMoment {
        DriverMoment {
            at: self.at + by,
            ..self
        }
    }
}

impl StepLaw {
    /// The part of the way after a part of the time, and its first two derivatives by that.
    #[must_use]
    pub fn shape(self, s: f64) -> [f64; 3] {
        match self {
            StepLaw::Constant => [s, 1.0, 0.0],
            StepLaw::Harmonic => {
                let (sin, cos) = (PI * s).sin_cos();
                // Of a difference of equals near the beginning, the square of the half angle.
                let way = (0.5 * PI * s).sin().powi(2);
                [way, 0.5 * PI * sin, 0.5 * PI * PI * cos]
            }
            StepLaw::Cycloidal => {
                let (sin, _) = (2.0 * PI * s).sin_cos();
                let speed = 2.0 * (PI * s).sin().powi(2);
                [s - sin / (2.0 * PI), speed, 2.0 * PI * sin]
            }
            StepLaw::Trapezoid { ramp } => trapezoid(s, ramp),
        }
    }
}

impl TimedStep {
    /// Where it ends.
    #[must_use]
    pub fn to(&self) -> f64 {
        match self {
            TimedStep::Law { to, .. } => *to,
            TimedStep::Table(spline) => spline.ends()[1][1],
        }
    }

    /// How long it takes, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        match self {
            TimedStep::Law { time, .. } => *time,
            TimedStep::Table(spline) => spline.ends()[1][0],
        }
    }

    /// Whether it goes on from a coordinate, in a time.
    fn is_sound(&self, from: f64) -> bool {
        match self {
            TimedStep::Law { law, to, time } => {
                let has_ramps = match law {
                    StepLaw::Trapezoid { ramp } => *ramp > 0.0 && *ramp <= 0.5,
                    StepLaw::Constant | StepLaw::Harmonic | StepLaw::Cycloidal => true,
                };
                has_ramps && to.is_finite() && *time > 0.0
            }
            TimedStep::Table(spline) => spline.ends()[0] == [0.0, from],
        }
    }

    /// Where the driver is so long after it began at a coordinate.
    fn moment(&self, from: f64, after: f64) -> DriverMoment {
        match self {
            TimedStep::Law { law, to, time } => {
                let way = to - from;
                let [part, first, second] = law.shape((after / time).clamp(0.0, 1.0));
                DriverMoment {
                    at: from + way * part,
                    speed: way * first / time,
                    acceleration: way * second / (time * time),
                }
            }
            TimedStep::Table(spline) => {
                let [at, speed, acceleration] = spline.at(after);
                DriverMoment {
                    at,
                    speed,
                    acceleration,
                }
            }
        }
    }
}

/// A ramp up over r of the time, and the same down at the end: the greatest speed is 1 / (1 - r).
fn trapezoid(s: f64, r: f64) -> [f64; 3] {
    let most = 1.0 / (1.0 - r);
    let up = |s: f64| 0.5 * most * s * s / r;
    if s < r {
        [up(s), most * s / r, most / r]
    } else if s <= 1.0 - r {
        [most * (s - 0.5 * r), most, 0.0]
    } else {
        let left = 1.0 - s;
        [1.0 - up(left), most * left / r, -most / r]
    }
}

impl MotionLaw {
    /// From a coordinate through these steps; `None` without one that takes time, or where a number is none.
    /// `turns` tells that a link is turned: it may end whole turns from where it began.
    #[must_use]
    pub fn new(start: f64, steps: Vec<TimedStep>, turns: bool) -> Option<MotionLaw> {
        let period: f64 = steps.iter().map(TimedStep::time).sum();
        let end = steps.last()?.to();
        let advance = match turns {
            true => ((end - start) / TURN).round() * TURN,
            false => 0.0,
        };
        let closes = (end - start - advance).abs() <= ROUNDING * (start.abs() + end.abs());
        let is_whole = closes && start.is_finite() && period.is_finite();
        let mut from = start;
        let is_sound = steps.iter().all(|step| {
            let begins = std::mem::replace(&mut from, step.to());
            step.is_sound(begins)
        });
        (is_whole && is_sound).then_some(MotionLaw {
            start,
            steps,
            period,
            advance,
        })
    }

    /// The time after which it begins anew, in s.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// How far it has gone by then: 0, or whole turns.
    #[must_use]
    pub fn advance(&self) -> f64 {
        self.advance
    }

    /// Where the driver is at a time. Where two steps meet, what begins.
    #[must_use]
    pub fn at(&self, time: f64) -> DriverMoment {
        let periods = (time / self.period).floor();
        let turned = periods * self.advance();
        let mut left = time - periods * self.period;
        let (mut from, last) = (self.start, self.steps.len() - 1);
        for step in &self.steps[..last] {
            if left < step.time() {
                return step.moment(from, left).turned(turned);
            }
            left -= step.time();
            from = step.to();
        }
        self.steps[last].moment(from, left).turned(turned)
    }

    /// The times at which one step goes over into the next, in one period: there rates may jump.
    pub fn joints(&self) -> impl Iterator<Item = f64> {
        self.steps.iter().scan(0.0, |time, step| {
            *time += step.time();
            Some(*time)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [StepLaw; 5] = [
        StepLaw::Constant,
        StepLaw::Harmonic,
        StepLaw::Cycloidal,
        StepLaw::Trapezoid { ramp: 0.25 },
        StepLaw::Trapezoid { ramp: 0.5 },
    ];

    pub(super) fn step(law: StepLaw, to: f64, time: f64) -> TimedStep {
        TimedStep::Law { law, to, time }
    }

    pub(super) fn near(value: f64, exact: f64) {
        let most = 1e-12 * exact.abs().max(1.0);
        assert!((value - exact).abs() < most, "{value} for {exact}");
    }

    /// Largest speeds and accelerations of the handbooks: h/T times 1, pi/2, 2, 1/(1-r); h/T^2 times 0, pi^2/2,
    /// 2 pi, 1/(r (1-r)).
    #[test]
    fn every_law_has_the_peaks_of_the_handbooks() {
        let speeds = [1.0, PI / 2.0, 2.0, 4.0 / 3.0, 2.0];
        let accelerations = [0.0, PI * PI / 2.0, 2.0 * PI, 16.0 / 3.0, 4.0];
        for ((law, speed), acceleration) in LAWS.into_iter().zip(speeds).zip(accelerations) {
            let moments: Vec<[f64; 3]> = (0..=1000)
                .map(|k| law.shape(f64::from(k) / 1000.0))
                .collect();
            let most = |i: usize| moments.iter().map(|m| m[i].abs()).fold(0.0, f64::max);
            near(most(1), speed);
            near(most(2), acceleration);
            near(moments[0][0], 0.0);
            near(moments[500][0], 0.5);
            near(moments[1000][0], 1.0);
        }
    }

    /// Each derivative is the slope of what stands before it.
    #[test]
    fn speed_is_the_slope_of_the_way_and_acceleration_that_of_the_speed() {
        for law in LAWS {
            for k in 1..50 {
                let s = f64::from(k) / 50.0 + 0.003;
                let apart = 1e-5;
                if s + apart >= 1.0 {
                    continue;
                }
                let (low, here, high) = (law.shape(s - apart), law.shape(s), law.shape(s + apart));
                for i in 0..2 {
                    let slope = (high[i] - low[i]) / (2.0 * apart);
                    assert!(
                        (slope - here[i + 1]).abs() < 1e-6,
                        "{law:?} {s} {i}: {slope}"
                    );
                }
            }
        }
    }

    #[test]
    fn steps_follow_each_other_and_begin_anew() {
        let steps = vec![
            step(StepLaw::Cycloidal, 120.0, 0.5),
            step(StepLaw::Constant, 120.0, 0.25),
            step(StepLaw::Harmonic, 0.0, 0.25),
        ];
        let law = MotionLaw::new(0.0, steps, true).unwrap();
        assert_eq!((law.period(), law.advance()), (1.0, 0.0));
        for turn in [-2.0, 0.0, 3.0] {
            near(law.at(turn + 0.25).at, 60.0);
            near(law.at(turn + 0.25).speed, 2.0 * 120.0 / 0.5);
            near(law.at(turn + 0.6).at, 120.0);
            assert_eq!(law.at(turn + 0.6).speed, 0.0);
            near(law.at(turn + 0.875).at, 60.0);
            near(law.at(turn + 0.875).speed, -PI / 2.0 * 120.0 / 0.25);
        }
        assert_eq!(law.joints().collect::<Vec<_>>(), [0.5, 0.75, 1.0]);
    }

    /// The first step of 0.5 s ends where the table of the second begins.
    #[test]
    fn a_table_goes_on_where_the_step_before_it_ended() {
        let table = |from| {
            let knots = vec![[0.0, from], [0.5, 30.0], [1.0, 0.0]];
            TimedStep::Table(ClampedSpline::new(knots).unwrap())
        };
        let steps = |from| vec![step(StepLaw::Harmonic, 60.0, 0.5), table(from)];
        let law = MotionLaw::new(0.0, steps(60.0), false).unwrap();
        near(law.period(), 1.5);
        near(law.at(1.0).at, 30.0);
        // As s^2 (3 - 2 s) falls from 60 to 0 in 1 s: 1.5 times the mean speed in the middle.
        near(law.at(4.0).speed, -90.0);
        near(law.at(0.5).acceleration, -6.0 * 60.0);
        assert_eq!(MotionLaw::new(0.0, steps(50.0), false), None);
    }

    #[test]
    fn whole_turns_go_on_and_other_ends_are_refused() {
        let index = |to| vec![step(StepLaw::Cycloidal, to, 1.0)];
        let law = MotionLaw::new(30.0, index(390.0), true).unwrap();
        near(law.at(2.5).at, 30.0 + 720.0 + 180.0);
        // Of 360.3 - 0.3 rounding leaves something.
        assert_eq!(
            MotionLaw::new(0.3, index(360.3), true).unwrap().advance(),
            360.0
        );
        assert_eq!(MotionLaw::new(30.0, index(390.0), false), None);
        assert_eq!(MotionLaw::new(30.0, index(389.0), true), None);
        assert_eq!(MotionLaw::new(30.0, Vec::new(), true), None);
        assert_eq!(
            MotionLaw::new(0.0, vec![step(StepLaw::Harmonic, 0.0, 0.0)], true),
            None
        );
    }
}
