//! Computes a driver's coordinate, speed and acceleration over time from a law of motion.
//!
//! A law is a list of steps from one coordinate to the next. It restarts after the last one: a
//! driver that ends where it began repeats its period; one that ends whole turns further continues
//! from there.

mod arcs;
mod dwell_times;
mod peaks;

pub use peaks::MotionPeaks;

use super::spline::ClampedSpline;
use crate::angle::TURN;
use crate::arithmetic::Sharp;
use crate::{Ball, Constant, Number};
use arcs::MotionArc;

/// The shape of a step: the fraction h of its travel over the fraction s of its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepLaw {
    /// h = s: a constant speed.
    Constant,
    /// h = (1 - cos pi s) / 2.
    Harmonic,
    /// h = s - sin(2 pi s) / (2 pi): no acceleration at both ends.
    Cycloidal,
    /// A trapezoidal speed: it grows linearly over this fraction of the time, stays constant and
    /// falls symmetrically.
    Trapezoid {
        /// The fraction of the time, above 0 and at most a half.
        ramp: f64,
    },
}

/// A step of a motion, which begins where the previous one ended.
#[derive(Clone, Debug, PartialEq)]
pub enum TimedStep {
    /// A move to a coordinate in a given time.
    Law {
        /// The shape of the step. A step to its own start is a dwell.
        law: StepLaw,
        /// The end coordinate, in degrees or in the scene's length unit.
        to: f64,
        /// The duration in s, above 0.
        time: f64,
    },
    /// A curve through knots of time, from the beginning of the step, and coordinate. It is at rest
    /// at both ends.
    Table(ClampedSpline),
    /// One period of a sine about a middle position.
    Sine(SineStep),
}

/// One period of a sine: the coordinate is `from + amplitude (sin(phase + 360 t / time) - sin phase)`.
/// It ends where it began, with the same speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineStep {
    /// The coordinate at the beginning, in degrees or in the scene's length unit.
    pub from: f64,
    /// The largest distance from the middle position, above 0.
    pub amplitude: f64,
    /// The phase at the beginning, in degrees: 0 in the middle position, on the way up.
    pub phase: f64,
    /// The period in s, above 0.
    pub time: f64,
}

impl SineStep {
    /// Returns the times at which the sine reverses, from the beginning of the step.
    fn turns(&self) -> [f64; 2] {
        // The phases of the reversals are 90 and 270 degrees.
        let mut turns = [90.0, 270.0].map(|at: f64| {
            let turned = (at - self.phase).rem_euclid(TURN);
            self.time * (turned / TURN)
        });
        turns.sort_by(f64::total_cmp);
        turns
    }
}

/// A driver's coordinate over time.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionLaw {
    start: f64,
    steps: Vec<TimedStep>,
    /// The end time of each step, in s: the doubles nearest to the sums of their durations.
    joints: Vec<f64>,
    arcs: Vec<MotionArc>,
    period: Constant,
    /// The change of the coordinate per period: whole turns or zero.
    advance: f64,
}

/// Relative tolerance for a difference of two coordinates that is zero but for rounding errors.
const ROUNDING: f64 = 1e-12;
/// Tolerance within which a time counts as a joint's, in machine epsilons: both may be rounded
/// sums.
const NAMED: f64 = 2.0;

/// The driver's coordinate with its first and second time derivative, at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverMoment {
    /// The coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The first derivative of the coordinate, per s.
    pub speed: f64,
    /// The second derivative of the coordinate, per s^2.
    pub acceleration: f64,
    /// Error bounds of the three values against the motion as meant, beyond the rounding of a typed
    /// coordinate. They enter the error bounds of the results.
    pub off: [f64; 3],
}

impl TimedStep {
    /// Returns the coordinate at which the step ends.
    #[must_use]
    pub fn to(&self) -> f64 {
        match self {
            TimedStep::Law { to, .. } => *to,
            TimedStep::Table(spline) => spline.ends()[1][1],
            TimedStep::Sine(sine) => sine.from,
        }
    }

    /// Returns the duration of the step, in s.
    #[must_use]
    pub fn time(&self) -> f64 {
        match self {
            TimedStep::Law { time, .. } => *time,
            TimedStep::Table(spline) => spline.ends()[1][0],
            TimedStep::Sine(sine) => sine.time,
        }
    }

    /// Returns `true` if the step begins at coordinate `from` and its numbers are valid.
    fn is_valid(&self, from: f64) -> bool {
        match self {
            TimedStep::Law { law, to, time } => {
                let has_ramps = match law {
                    StepLaw::Trapezoid { ramp } => *ramp > 0.0 && *ramp <= 0.5,
                    StepLaw::Constant | StepLaw::Harmonic | StepLaw::Cycloidal => true,
                };
                has_ramps && to.is_finite() && *time > 0.0
            }
            TimedStep::Table(spline) => spline.ends()[0] == [0.0, from],
            TimedStep::Sine(sine) => {
                let is_finite = sine.amplitude.is_finite() && sine.phase.is_finite();
                sine.from == from && is_finite && sine.amplitude > 0.0 && sine.time > 0.0
            }
        }
    }
}

impl MotionLaw {
    /// Creates a law from a start coordinate and steps. With `turns`, a link is turned, and the law
    /// may end whole turns from where it began.
    ///
    /// Returns `None` without steps, if a step is invalid, if a number is not finite, or if the end
    /// does not match the start.
    #[must_use]
    pub fn new(start: f64, steps: Vec<TimedStep>, is_rotary: bool) -> Option<MotionLaw> {
        let end = steps.last()?.to();
        let advance = match is_rotary {
            true => ((end - start) / TURN).round() * TURN,
            false => 0.0,
        };
        let closes = (end - start - advance).abs() <= ROUNDING * (start.abs() + end.abs());
        let mut from = start;
        let is_sound = steps.iter().all(|step| {
            let starts = std::mem::replace(&mut from, step.to());
            step.is_valid(starts)
        });
        if !(closes && start.is_finite() && is_sound) {
            return None;
        }
        let (mut from, mut period) = (start, Constant::default());
        let (mut joints, mut arcs) = (Vec::with_capacity(steps.len()), Vec::new());
        for step in &steps {
            step.add_arcs(from, period, &mut arcs);
            (from, period) = (step.to(), period + Constant::given(step.time()));
            joints.push(period.hi);
        }
        period.hi.is_finite().then_some(MotionLaw {
            start,
            steps,
            joints,
            arcs,
            period,
            advance,
        })
    }

    /// Returns the period, in s, after which the law repeats.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period.hi
    }

    /// Returns the change of the coordinate per period: 0 or whole turns.
    #[must_use]
    pub fn advance(&self) -> f64 {
        self.advance
    }

    /// Returns the driver's moment at a time, with error bounds. Where two steps meet, the one that
    /// begins counts, also at a time that differs from the joint by rounding errors only.
    #[must_use]
    pub fn at(&self, time: f64) -> DriverMoment {
        let place = self.place(time);
        let arc = &self.arcs[place.arc];
        let mut found = arc.at(place.after);
        if place.is_named {
            let near = found;
            found = arc.at(Sharp::default());
            for (here, near) in found.iter_mut().zip(near) {
                *here = here.either(near);
            }
            // The time may also lie before the joint by as much: the coordinate is as near there,
            // but its rates may differ.
            found[0] = found[0].either(self.before(&place));
        }
        found[0] += Sharp::exactly(place.periods * self.advance);
        let [at, speed, acceleration] = found.map(Ball::from);
        // Adding 0.0 turns -0.0 into 0.0.
        DriverMoment {
            at: at.mid + 0.0,
            speed: speed.mid + 0.0,
            acceleration: acceleration.mid + 0.0,
            off: [at.radius, speed.radius, acceleration.radius],
        }
    }

    /// Returns the coordinate on the arc before the given place.
    fn before(&self, place: &MotionPlace) -> Sharp {
        let start = Sharp::of(self.arcs[place.arc].begin);
        let (arc, end, advance) = match place.arc.checked_sub(1) {
            Some(arc) => (&self.arcs[arc], start, 0.0),
            None => {
                let last = &self.arcs[self.arcs.len() - 1];
                (last, Sharp::of(self.period), self.advance)
            }
        };
        let [at, ..] = arc.at(end - Sharp::of(arc.begin) + place.after);
        at - Sharp::exactly(advance)
    }

    /// Finds the arc on which a time lies.
    fn place(&self, time: f64) -> MotionPlace {
        let (requested, period) = (Sharp::of(Constant::given(time)), Sharp::of(self.period));
        let slack = NAMED * f64::EPSILON * time.abs().max(self.period.hi);
        let since = |periods: f64| requested - Sharp::exactly(periods) * period;
        let reaches = |left: Sharp, start: Constant| {
            let after = left - Sharp::of(start);
            after.mid.hi >= -(after.radius + slack)
        };
        // The rounded quotient can be off by one.
        let mut periods = (time / self.period.hi).floor();
        let mut left = since(periods);
        if reaches(left, self.period) {
            periods += 1.0;
            left = since(periods);
        } else if !reaches(left, Constant::default()) {
            periods -= 1.0;
            left = since(periods);
        }
        let started = self.arcs.partition_point(|arc| reaches(left, arc.begin));
        let arc = started.max(1) - 1;
        let after = left - Sharp::of(self.arcs[arc].begin);
        MotionPlace {
            arc,
            after,
            is_named: after.mid.hi.abs() <= after.radius + slack,
            periods,
        }
    }

    /// Returns the end times of the steps in one period, where rates may jump.
    pub fn joints(&self) -> impl Iterator<Item = f64> {
        self.joints.iter().copied()
    }

    /// Returns the times in one period at which a derivative may jump or the driver may reverse.
    /// These are joints, the ends of ramps, the knots of tables and the points where tables
    /// reverse.
    pub fn seams(&self) -> impl Iterator<Item = f64> {
        let arcs = self.arcs.iter().skip(1).map(|arc| arc.begin.hi);
        arcs.chain(self.stretches().map(|[_, end]| end))
    }
}

/// The place of a time in a motion.
struct MotionPlace {
    /// The index of the arc.
    arc: usize,
    /// The time since the arc began.
    after: Sharp,
    /// Whether the time differs from the arc's beginning by rounding errors only.
    is_named: bool,
    /// The number of complete periods before.
    periods: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

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
        let maximum = 1e-12 * exact.abs().max(1.0);
        assert!((value - exact).abs() < maximum, "{value} for {exact}");
    }

    /// Returns the moments of a step of 1 in 1 s, followed by a step back.
    fn shape(law: StepLaw) -> impl Fn(f64) -> [f64; 3] {
        let steps = vec![step(law, 1.0, 1.0), step(law, 0.0, 1.0)];
        let law = MotionLaw::new(0.0, steps, false).unwrap();
        move |s| {
            let moment = law.at(s);
            [moment.at, moment.speed, moment.acceleration]
        }
    }

    /// The handbooks' maximum speeds and accelerations: h/T times 1, pi/2, 2, 1/(1-r); h/T^2 times
    /// 0, pi^2/2, 2 pi, 1/(r (1-r)).
    #[test]
    fn every_law_has_handbook_peaks() {
        let speeds = [1.0, PI / 2.0, 2.0, 4.0 / 3.0, 2.0];
        let accelerations = [0.0, PI * PI / 2.0, 2.0 * PI, 16.0 / 3.0, 4.0];
        for ((law, speed), acceleration) in LAWS.into_iter().zip(speeds).zip(accelerations) {
            let shape = shape(law);
            let moments: Vec<[f64; 3]> = (0..=1000).map(|k| shape(f64::from(k) / 1000.0)).collect();
            let maximum = |i: usize| moments.iter().map(|m| m[i].abs()).fold(0.0, f64::max);
            near(maximum(1), speed);
            near(maximum(2), acceleration);
            near(moments[0][0], 0.0);
            near(moments[500][0], 0.5);
            near(moments[1000][0], 1.0);
        }
    }

    /// Compares each derivative with the slope of the preceding quantity.
    #[test]
    fn speed_and_acceleration_match_difference_quotients() {
        for law in LAWS {
            let shape = shape(law);
            for k in 1..50 {
                let s = f64::from(k) / 50.0 + 0.003;
                let distance = 1e-5;
                if s + distance >= 1.0 {
                    continue;
                }
                let (low, here, high) = (shape(s - distance), shape(s), shape(s + distance));
                for i in 0..2 {
                    let slope = (high[i] - low[i]) / (2.0 * distance);
                    assert!(
                        (slope - here[i + 1]).abs() < 1e-6,
                        "{law:?} {s} {i}: {slope}"
                    );
                }
            }
        }
    }

    #[test]
    fn steps_follow_each_other_and_repeat() {
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

    /// In doubles, 0.1 + 0.2 is not 0.3, and ten times 0.1 is not the period. Still, at a joint the
    /// next step has begun and the one before has ended, for any computation of the time.
    #[test]
    fn rounding_does_not_change_step_at_joint() {
        let steps = vec![
            step(StepLaw::Constant, 30.0, 0.1),
            step(StepLaw::Constant, 30.0, 0.2),
            step(StepLaw::Constant, 90.0, 0.3),
            step(StepLaw::Trapezoid { ramp: 0.1 }, 0.0, 0.7),
        ];
        let law = MotionLaw::new(0.0, steps, false).unwrap();
        let joints: Vec<f64> = law.joints().collect();
        for period in [0.0, 1.0, 7.0, 1e6, -3.0] {
            let started = period * 1.3;
            for (time, at, speed) in [
                (started, 0.0, 300.0),
                (started + 0.1, 30.0, 0.0),
                (started + 0.3, 30.0, 200.0),
                (started + (0.1 + 0.2), 30.0, 200.0),
                (started + joints[1], 30.0, 200.0),
                (started + 0.6, 90.0, 0.0),
                (started + joints[3], 0.0, 300.0),
            ] {
                let moment = law.at(time);
                let off = 4.0 * f64::EPSILON * time.abs() * 300.0;
                assert!((moment.at - at).abs() <= off, "{time}: {moment:?}");
                near(moment.speed, speed);
            }
        }
        // Within a step, too: the ramp of 0.07 s ends at 0.67 s, and the acceleration there is
        // zero.
        assert_eq!(law.at(0.67).acceleration, 0.0);
        assert!(law.at(0.6).acceleration < -1.0);
    }

    /// Coordinate, speed and acceleration are within their bounds, compared with the handbooks'
    /// formulas in double-double for the typed decimals. The bounds are at most some rounding
    /// errors wide.
    #[test]
    fn moment_error_covers_rounding() {
        use crate::Double;
        let tenths = |n: u32| Double::exactly(f64::from(n)) / Double::exactly(1000.0);
        let pi = Double::exactly(180.0) * Double::RADIAN;
        let mut largest = [0.0_f64; 3];
        for (number, law) in LAWS.into_iter().enumerate() {
            for k in 1..700_u32 {
                // From 12.3 to 131.7 in 0.7 s, at a time of k thousandths.
                let steps = vec![step(law, 131.7, 0.7), step(StepLaw::Harmonic, 12.3, 0.6)];
                let motion = MotionLaw::new(12.3, steps, false).unwrap();
                let time = f64::from(k) / 1000.0;
                let found = motion.at(time);
                let [from, way, complete] = [tenths(12_300), tenths(119_400), tenths(700)];
                let s = tenths(k) / complete;
                let turned = |half_turns: f64| {
                    let angle = s * Double::exactly(180.0 * half_turns);
                    <Double as Number>::unit(angle)
                };
                let (one, half) = (Double::ONE, Double::exactly(0.5));
                let exact = match number {
                    0 => [s, one, Double::ZERO],
                    1 => {
                        let unit = turned(1.0);
                        [
                            half * (one - unit.x),
                            half * pi * unit.y,
                            half * pi * pi * unit.x,
                        ]
                    }
                    2 => {
                        let unit = turned(2.0);
                        let two_pi = pi.scaled(2.0);
                        [s - unit.y / two_pi, one - unit.x, two_pi * unit.y]
                    }
                    _ => {
                        let r = Double::exactly(if number == 3 { 0.25 } else { 0.5 });
                        let maximum = one / (one - r);
                        let left = one - s;
                        if (s - r).hi < -1e-25 {
                            [half * maximum * s * s / r, maximum * s / r, maximum / r]
                        } else if (left - r).hi > 1e-25 {
                            [maximum * (s - half * r), maximum, Double::ZERO]
                        } else {
                            [
                                one - half * maximum * left * left / r,
                                maximum * left / r,
                                -maximum / r,
                            ]
                        }
                    }
                };
                let exact = [
                    from + way * exact[0],
                    way * exact[1] / complete,
                    way * exact[2] / (complete * complete),
                ];
                let values = [found.at, found.speed, found.acceleration];
                for i in 0..3 {
                    let miss = (exact[i] - Double::exactly(values[i])).hi.abs();
                    assert!(
                        miss <= found.off[i],
                        "{law:?} {time} {i}: {miss:e} {found:?}"
                    );
                    largest[i] = largest[i].max(found.off[i]);
                }
            }
        }
        assert!(
            largest[0] < 2e-13 && largest[1] < 4e-12 && largest[2] < 4e-11,
            "{largest:?}"
        );
    }

    /// The first step of 0.5 s ends where the table of the second begins.
    #[test]
    fn table_starts_where_previous_step_ended() {
        let table = |from| {
            let knots = vec![[0.0, from], [0.5, 30.0], [1.0, 0.0]];
            TimedStep::Table(ClampedSpline::new(knots).unwrap())
        };
        let steps = |from| vec![step(StepLaw::Harmonic, 60.0, 0.5), table(from)];
        let law = MotionLaw::new(0.0, steps(60.0), false).unwrap();
        near(law.period(), 1.5);
        near(law.at(1.0).at, 30.0);
        // s^2 (3 - 2 s) falls from 60 to 0 in 1 s: 1.5 times the mean speed in the middle.
        near(law.at(4.0).speed, -90.0);
        near(law.at(0.5).acceleration, -6.0 * 60.0);
        assert_eq!(MotionLaw::new(0.0, steps(50.0), false), None);
    }

    /// A cylinder of 20 mm stroke that begins retracted, and a lever that begins at any phase.
    #[test]
    fn sine_swings_about_its_middle_position() {
        let sine = |from, amplitude, phase, time| {
            TimedStep::Sine(SineStep {
                from,
                amplitude,
                phase,
                time,
            })
        };
        let law = MotionLaw::new(100.0, vec![sine(100.0, 10.0, -90.0, 4.0)], false).unwrap();
        for (time, at, speed) in [
            (0.0, 100.0, 0.0),
            (1.0, 110.0, 5.0 * PI),
            (2.0, 120.0, 0.0),
            (3.0, 110.0, -5.0 * PI),
            (4.0, 100.0, 0.0),
            // A twelfth of the period: the sine of -60 degrees.
            (9.0 - 2.0 / 3.0, 110.0 - 5.0 * 3.0_f64.sqrt(), 2.5 * PI),
        ] {
            let moment = law.at(time);
            near(moment.at, at);
            near(moment.speed, speed);
            // The acceleration points to the middle.
            near(
                moment.acceleration,
                (110.0 - moment.at) * (PI / 2.0).powi(2),
            );
        }
        assert_eq!(law.reach(), [100.0, 120.0]);
        assert_eq!((law.period(), law.advance()), (4.0, 0.0));
        // Elsewhere the reversals lie within the period.
        let law = MotionLaw::new(35.0, vec![sine(35.0, 10.0, 30.0, 3.0)], true).unwrap();
        let [low, high] = law.reach();
        near(low, 20.0);
        near(high, 40.0);
        let meets: Vec<f64> = law.meets(30.0).collect();
        assert_eq!(meets.len(), 4, "{meets:?}");
        near(meets[0], 1.25);
        near(meets[2], 2.75);
        let peaks = law.peaks();
        near(peaks.speed, 20.0 * PI / 3.0);
        near(peaks.acceleration, 10.0 * (2.0 * PI / 3.0).powi(2));
        assert_eq!((peaks.rest, peaks.jump), (0.0, None));
        // A dwell before it makes the speed jump.
        let steps = vec![step(StepLaw::Constant, 0.0, 1.0), sine(0.0, 1.0, 0.0, 1.0)];
        assert_eq!(
            MotionLaw::new(0.0, steps, false).unwrap().peaks().jump,
            Some(0.0)
        );
        for bad in [
            sine(1.0, 1.0, 0.0, 1.0),
            sine(0.0, 0.0, 0.0, 1.0),
            sine(0.0, 1.0, 0.0, 0.0),
        ] {
            assert_eq!(MotionLaw::new(0.0, vec![bad], false), None);
        }
        assert_eq!(
            MotionLaw::new(0.0, vec![sine(0.0, 1.0, f64::NAN, 1.0)], false),
            None
        );
    }

    /// The bounds cover the difference from the formula in double-double.
    #[test]
    fn sine_error_covers_rounding() {
        use crate::Double;
        let (amplitude, phase, time) = (13.7, 12.3, 0.7);
        let sine = TimedStep::Sine(SineStep {
            from: 41.1,
            amplitude,
            phase,
            time,
        });
        let law = MotionLaw::new(41.1, vec![sine], false).unwrap();
        let tenths = |n: u32| Double::exactly(f64::from(n)) / Double::exactly(1000.0);
        let unit = |angle: Double| <Double as Number>::unit(angle);
        for k in 1..700_u32 {
            let found = law.at(f64::from(k) / 1000.0);
            let rate = Double::exactly(360.0) / tenths(700);
            let (start, here) = (
                unit(tenths(12_300)),
                unit(tenths(12_300) + rate * tenths(k)),
            );
            let (way, turn) = (tenths(13_700), rate * Double::RADIAN);
            let exact = [
                tenths(41_100) + way * (here.y - start.y),
                way * turn * here.x,
                -(way * turn * turn * here.y),
            ];
            let values = [found.at, found.speed, found.acceleration];
            for i in 0..3 {
                let miss = (exact[i] - Double::exactly(values[i])).hi.abs();
                assert!(miss <= found.off[i], "{k} {i}: {miss:e} {found:?}");
                assert!(found.off[i] < 1e-10, "{found:?}");
            }
        }
    }

    #[test]
    fn whole_turns_accumulate_and_other_ends_are_rejected() {
        let index = |to| vec![step(StepLaw::Cycloidal, to, 1.0)];
        let law = MotionLaw::new(30.0, index(390.0), true).unwrap();
        near(law.at(2.5).at, 30.0 + 720.0 + 180.0);
        // 360.3 - 0.3 has a rounding error.
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
