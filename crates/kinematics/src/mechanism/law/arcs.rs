//! Evaluates the smooth arcs of a law of motion in double-double, with error bounds.
//!
//! A trapezoid has three arcs, a table one between each two knots. A derivative may jump where arcs
//! meet.

use super::{StepLaw, TimedStep};
use crate::arithmetic::Sharp;
use crate::{Constant, Number};

/// A part of a motion that is one smooth function of time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MotionArc {
    /// The time at which it begins, in s from the beginning of the period.
    pub(super) begin: Constant,
    shape: ArcShape,
}

/// The coordinate over the time d since an arc began.
#[derive(Clone, Debug, PartialEq)]
enum ArcShape {
    /// c0 + c1 d + c2 d^2 + c3 d^3.
    Cubic([Constant; 4]),
    /// from + way (1 - cos a) / 2.
    Harmonic(Wave),
    /// from + way (a - sin a) / (2 pi).
    Cycloidal(Wave),
    /// from + way (sin(phase + a) - sin phase).
    Sine(Wave, Constant),
}

/// The constants of a shape with an angle a that grows linearly with time.
#[derive(Clone, Debug, PartialEq)]
struct Wave {
    from: Constant,
    way: Constant,
    /// The rate of the angle, in degrees per s.
    rate: Constant,
    /// The rate of the angle, in radians per s.
    turn: Constant,
}

impl Wave {
    /// Creates a wave whose angle grows by this number of half turns in the given time.
    fn new([from, to]: [f64; 2], time: f64, half_turns: f64) -> Wave {
        let [from, to, time] = [from, to, time].map(Constant::given);
        let rate = Constant::exactly(180.0 * half_turns) / time;
        Wave {
            from,
            way: to - from,
            rate,
            turn: rate * Constant::RADIAN,
        }
    }
}

impl TimedStep {
    /// Appends the arcs of the step, which begins at coordinate `from` and time `begin`.
    pub(super) fn add_arcs(&self, from: f64, first: Constant, arcs: &mut Vec<MotionArc>) {
        let mut add = |after: Constant, shape: ArcShape| {
            arcs.push(MotionArc {
                begin: first + after,
                shape,
            });
        };
        let at_once = Constant::default();
        match self {
            TimedStep::Law { law, to, time } => match law {
                StepLaw::Constant => {
                    let [start, end, complete] = [from, *to, *time].map(Constant::given);
                    let speed = (end - start) / complete;
                    add(at_once, ArcShape::Cubic([start, speed, at_once, at_once]));
                }
                StepLaw::Harmonic => {
                    let wave = Wave::new([from, *to], *time, 1.0);
                    add(at_once, ArcShape::Harmonic(wave));
                }
                StepLaw::Cycloidal => {
                    let wave = Wave::new([from, *to], *time, 2.0);
                    add(at_once, ArcShape::Cycloidal(wave));
                }
                StepLaw::Trapezoid { ramp } => {
                    for (after, cubic) in trapezoid([from, *to], *time, *ramp) {
                        add(after, ArcShape::Cubic(cubic));
                    }
                }
            },
            TimedStep::Table(spline) => {
                for (after, cubic) in spline.cubics() {
                    add(after, ArcShape::Cubic(cubic));
                }
            }
            TimedStep::Sine(sine) => {
                let mut wave = Wave::new([sine.from, sine.from], sine.time, 2.0);
                wave.way = Constant::given(sine.amplitude);
                add(at_once, ArcShape::Sine(wave, Constant::given(sine.phase)));
            }
        }
    }
}

/// Returns the three arcs of a trapezoidal speed. The speed grows over the time r T to h / (T (1 -
/// r)), stays constant and falls symmetrically.
fn trapezoid([from, to]: [f64; 2], time: f64, ramp: f64) -> [(Constant, [Constant; 4]); 3] {
    let [from, to, time, ramp] = [from, to, time, ramp].map(Constant::given);
    let nothing = Constant::default();
    let maximum = (to - from) / (time * (Constant::exactly(1.0) - ramp));
    let up = ramp * time;
    let half_rate = (maximum / up).scaled(0.5);
    let half_way = (maximum * up).scaled(0.5);
    [
        (nothing, [from, nothing, half_rate, nothing]),
        (up, [from + half_way, maximum, nothing, nothing]),
        (time - up, [to - half_way, maximum, -half_rate, nothing]),
    ]
}

impl MotionArc {
    /// Returns the coordinate and its first and second time derivative, at the time `d` since the
    /// arc began.
    pub(super) fn at(&self, d: Sharp) -> [Sharp; 3] {
        match &self.shape {
            ArcShape::Cubic(terms) => {
                let [c0, c1, c2, c3] = terms.map(Sharp::of);
                let steep = c3 * d;
                [
                    c0 + d * (c1 + d * (c2 + steep)),
                    c1 + d * (c2.scaled(2.0) + Sharp::exactly(3.0) * steep),
                    c2.scaled(2.0) + Sharp::exactly(6.0) * steep,
                ]
            }
            ArcShape::Harmonic(wave) => {
                let [from, way, rate, turn] =
                    [wave.from, wave.way, wave.rate, wave.turn].map(Sharp::of);
                let unit = Sharp::unit(rate * d);
                let speed = (way * turn).scaled(0.5);
                [
                    from + way * (Sharp::exactly(1.0) - unit.x).scaled(0.5),
                    speed * unit.y,
                    speed * turn * unit.x,
                ]
            }
            ArcShape::Sine(wave, phase) => {
                let [from, way, rate, turn] =
                    [wave.from, wave.way, wave.rate, wave.turn].map(Sharp::of);
                let phase = Sharp::of(*phase);
                let [start, unit] = [Sharp::unit(phase), Sharp::unit(phase + rate * d)];
                let speed = way * turn;
                [
                    from + way * (unit.y - start.y),
                    speed * unit.x,
                    -(speed * turn * unit.y),
                ]
            }
            ArcShape::Cycloidal(wave) => {
                let [from, way, rate, turn] =
                    [wave.from, wave.way, wave.rate, wave.turn].map(Sharp::of);
                let unit = Sharp::unit(rate * d);
                // The angle grows by 360 degrees, or 2 pi, over the step.
                let turns = rate * d / Sharp::exactly(360.0);
                let share = rate / Sharp::exactly(360.0);
                let sine = unit.y * share / turn;
                [
                    from + way * (turns - sine),
                    way * share * (Sharp::exactly(1.0) - unit.x),
                    way * share * turn * unit.y,
                ]
            }
        }
    }
}
