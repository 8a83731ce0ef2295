//! Computes the maximum speed and acceleration of a law of motion.

use super::{MotionLaw, StepLaw, TimedStep};
use std::f64::consts::PI;

/// The peak demands of a law of motion: magnitudes, in units of the coordinate per s and s^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionPeaks {
    /// The maximum speed.
    pub speed: f64,
    /// The maximum acceleration, apart from jumps of the speed.
    pub acceleration: f64,
    /// The total dwell time in a period, in s.
    pub rest: f64,
    /// The time of the first jump of the speed, in s. The acceleration is unbounded there.
    pub jump: Option<f64>,
}

/// Relative tolerance: speeds that differ by less than this fraction of the maximum do not count as
/// a jump.
const EQUALITY_TOLERANCE: f64 = 1e-9;

impl StepLaw {
    /// Returns the maxima of the first two derivatives of the shape, in units of travel and time.
    fn peaks(self) -> [f64; 2] {
        match self {
            StepLaw::Constant => [1.0, 0.0],
            StepLaw::Harmonic => [0.5 * PI, 0.5 * PI * PI],
            StepLaw::Cycloidal => [2.0, 2.0 * PI],
            StepLaw::Trapezoid { ramp } => {
                let speed = 1.0 / (1.0 - ramp);
                [speed, speed / ramp]
            }
        }
    }
}

impl TimedStep {
    /// Returns the maximum speed and acceleration of the step from a coordinate.
    fn peaks(&self, from: f64) -> [f64; 2] {
        match self {
            TimedStep::Law { law, to, time } => {
                let [speed, acceleration] = law.peaks();
                let way = (to - from).abs();
                [speed * way / time, acceleration * way / (time * time)]
            }
            TimedStep::Table(spline) => spline.steepest(),
            TimedStep::Sine(sine) => {
                let rate = 2.0 * PI / sine.time;
                [1, 2].map(|degree| sine.amplitude * rate.powi(degree))
            }
        }
    }

    /// Returns the speeds at the step's beginning and end.
    fn end_speeds(&self, from: f64) -> [f64; 2] {
        match self {
            TimedStep::Law {
                law: StepLaw::Constant,
                to,
                time,
            } => [(to - from) / time; 2],
            TimedStep::Sine(sine) => {
                let speed = sine.amplitude * 2.0 * PI / sine.time;
                [speed * sine.phase.to_radians().cos(); 2]
            }
            TimedStep::Law { .. } | TimedStep::Table(_) => [0.0; 2],
        }
    }
}

impl MotionLaw {
    /// Returns the maximum speed and acceleration, the dwell time and the first jump.
    #[must_use]
    pub fn peaks(&self) -> MotionPeaks {
        let froms = std::iter::once(self.start).chain(self.steps.iter().map(TimedStep::to));
        let steps = || self.steps.iter().zip(froms.clone());
        let peaks = steps().map(|(step, from)| step.peaks(from));
        let [speed, acceleration] = peaks.fold([0.0_f64; 2], |[v, a], [speed, acceleration]| {
            [v.max(speed), a.max(acceleration)]
        });
        let rests = steps().filter(|(step, from)| step.peaks(*from)[0] == 0.0);
        let ends: Vec<[f64; 2]> = steps().map(|(step, from)| step.end_speeds(from)).collect();
        // Before the first step, the driver is at rest or arrives from the last step.
        let mut before = ends.last().map_or(0.0, |end| end[1]);
        let starts = std::iter::once(0.0).chain(self.joints());
        let jump = ends.iter().zip(starts).find_map(|(&[first, last], time)| {
            let arrives = std::mem::replace(&mut before, last);
            ((first - arrives).abs() > EQUALITY_TOLERANCE * speed).then_some(time)
        });
        MotionPeaks {
            speed,
            acceleration,
            rest: rests.map(|(step, _)| step.time()).sum(),
            jump,
        }
    }

    /// Returns the steps in order.
    #[must_use]
    pub fn steps(&self) -> &[TimedStep] {
        &self.steps
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{near, step};
    use super::*;
    use crate::ClampedSpline;

    #[test]
    fn peaks_match_maxima_of_dense_sampling() {
        let knots = vec![[0.0, 0.0], [0.2, 40.0], [0.3, 35.0], [0.5, 120.0]];
        let steps = vec![
            TimedStep::Table(ClampedSpline::new(knots).unwrap()),
            step(StepLaw::Constant, 120.0, 0.25),
            step(StepLaw::Trapezoid { ramp: 0.25 }, 0.0, 0.4),
        ];
        let law = MotionLaw::new(0.0, steps, true).unwrap();
        let peaks = law.peaks();
        let moments: Vec<_> = (0..=200_000)
            .map(|k| law.at(f64::from(k) * law.period() / 200_000.0))
            .collect();
        let maximum = |of: fn(&crate::DriverMoment) -> f64| {
            moments.iter().map(|m| of(m).abs()).fold(0.0, f64::max)
        };
        let (speed, acceleration) = (maximum(|m| m.speed), maximum(|m| m.acceleration));
        assert!(
            speed <= peaks.speed && speed > (1.0 - 1e-6) * peaks.speed,
            "{speed} {peaks:?}"
        );
        assert!(
            acceleration <= peaks.acceleration && acceleration > (1.0 - 1e-4) * peaks.acceleration,
            "{acceleration} {peaks:?}"
        );
        near(peaks.rest, 0.25);
        assert_eq!(peaks.jump, None);
    }

    #[test]
    fn constant_speed_jumps_unless_it_continues() {
        let forth = vec![
            step(StepLaw::Harmonic, 90.0, 0.5),
            step(StepLaw::Constant, 0.0, 0.5),
        ];
        let peaks = MotionLaw::new(0.0, forth, true).unwrap().peaks();
        assert_eq!(peaks.jump, Some(0.0));
        let index = vec![
            step(StepLaw::Harmonic, 90.0, 0.5),
            step(StepLaw::Constant, 90.0, 0.5),
            step(StepLaw::Constant, 360.0, 0.5),
            step(StepLaw::Constant, 360.0, 0.5),
        ];
        let peaks = MotionLaw::new(0.0, index, true).unwrap().peaks();
        assert_eq!(
            (peaks.speed, peaks.rest, peaks.jump),
            (540.0, 1.0, Some(1.0))
        );
        let round = vec![step(StepLaw::Constant, 360.0, 2.0)];
        let peaks = MotionLaw::new(0.0, round, true).unwrap().peaks();
        assert_eq!(
            (peaks.speed, peaks.acceleration, peaks.jump),
            (180.0, 0.0, None)
        );
    }
}
