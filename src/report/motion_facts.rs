//! A driver's motion over time, as a whole.

use super::number::concise;
use crate::scene::Scene;
use crate::wording::words;
use crate::{Input, MotionPeaks, StepLaw, TimedStep};
use serde::Serialize;

/// Significant digits of a time, a speed and an acceleration.
const DIGITS: usize = 4;

/// A step of a motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StepFacts {
    /// As the scene file names its law; `dwell` where the driver stays.
    pub law: &'static str,
    /// Where it ends, in deg or the scene's unit.
    pub to: f64,
    /// How long it takes, in s.
    pub time: f64,
}

/// A motion over time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MotionFacts {
    /// Its steps, from where the scene opens.
    pub steps: Vec<StepFacts>,
    /// The time after which it begins anew, in s.
    pub period: f64,
    /// How much of that the driver rests, in s.
    pub rest: f64,
    /// Its greatest speed without a sign, in rad/s or the scene's unit per s.
    pub speed: f64,
    /// Its greatest acceleration without a sign, in rad/s^2 or the scene's unit per s^2, where the speed does not jump.
    pub acceleration: f64,
    /// When its speed first jumps, in s; `None` for one that goes on smoothly.
    pub jump: Option<f64>,
    /// What its speeds are in, but for the second.
    #[serde(skip)]
    unit: &'static str,
}

impl MotionFacts {
    /// Of a scene's driver; `None` for one that runs by its speed.
    #[must_use]
    pub fn of(scene: &Scene) -> Option<MotionFacts> {
        let law = scene.motion.as_ref()?;
        let driver = scene.mechanism.driver();
        let (scale, unit): (fn(f64) -> f64, _) = match driver.input {
            Input::Turn(_) => (f64::to_radians, "rad"),
            Input::Push(_) => (|rate| rate, scene.unit.symbol()),
        };
        let MotionPeaks {
            speed,
            acceleration,
            rest,
            jump,
        } = law.peaks();
        let mut from = driver.start;
        let steps = law.steps().iter().map(|step| {
            let begins = std::mem::replace(&mut from, step.to());
            StepFacts {
                law: name(step, begins),
                to: step.to(),
                time: step.time(),
            }
        });
        Some(MotionFacts {
            steps: steps.collect(),
            period: law.period(),
            rest,
            speed: scale(speed),
            acceleration: scale(acceleration),
            jump,
            unit,
        })
    }

    /// All of it in a sentence.
    pub(super) fn text(&self) -> String {
        let mut laws: Vec<&str> = Vec::new();
        for step in &self.steps {
            if step.law != DWELL && !laws.contains(&step.law) {
                laws.push(step.law);
            }
        }
        let mut told = words().motion_in_time(&laws.join(", "), &figure(self.period));
        if self.rest > 0.0 {
            told += &words().motion_rests(&figure(self.rest));
        }
        let [speed, acceleration] = self.rates();
        told += &words().motion_at_most(&speed, &acceleration);
        if let Some(jump) = self.jump {
            told += &words().motion_jumps(&figure(jump));
        }
        told
    }

    /// The same for a line that has little room, and for one that has less.
    pub(super) fn in_short(&self) -> [String; 2] {
        let period = figure(self.period);
        let [speed, acceleration] = self.rates();
        let jump = self.jump.map(|jump| words().motion_jumps(&figure(jump)));
        [
            words().motion_verdict(&period, &speed, &acceleration) + &jump.unwrap_or_default(),
            words().motion_in_short(&period, &speed),
        ]
    }

    fn rates(&self) -> [String; 2] {
        let unit = self.unit;
        [
            format!("{} {unit}/s", figure(self.speed)),
            format!("{} {unit}/s^2", figure(self.acceleration)),
        ]
    }
}

const DWELL: &str = "dwell";

/// What the scene file calls a step from a coordinate.
fn name(step: &TimedStep, from: f64) -> &'static str {
    match step {
        TimedStep::Table(_) => "table",
        TimedStep::Law { to, .. } if *to == from => DWELL,
        TimedStep::Law { law, .. } => match law {
            StepLaw::Constant => "constant",
            StepLaw::Harmonic => "harmonic",
            StepLaw::Cycloidal => "cycloidal",
            StepLaw::Trapezoid { .. } => "trapezoid",
        },
    }
}

fn figure(value: f64) -> String {
    concise(value, DIGITS)
}
