//! Facts on a driver's motion over time.

use super::check::unsigned_zero;
use super::number::concise;
use super::stop_facts::stop_name;
use crate::quantity::{Catalogue, MotionOutOfRange};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::wording::words;
use crate::{Input, LimitOf, MotionPeaks, StepLaw, TimedStep};
use serde::Serialize;

/// Significant digits of a time, a speed and an acceleration.
const DIGITS: usize = 4;
/// Significant digits of the place and time at which it leaves the range.
const PLACES: usize = 9;

/// A step of a motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StepFacts {
    /// The law as named in the scene file; `dwell` if the driver stays.
    pub law: &'static str,
    /// The final coordinate, in deg or the scene's unit.
    pub to: f64,
    /// The duration in s.
    pub time: f64,
    /// The fraction of a trapezoid's time during which the speed increases, and decreases again.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ramp: Option<f64>,
    /// The knots of a table: the time from the beginning of the step, in s, and the coordinate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub knots: Option<Vec<[f64; 2]>>,
}

/// The place at which a motion leaves the range of the mechanism.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeavingFacts {
    /// The time in s.
    pub time: f64,
    /// The driver's coordinate, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub at: f64,
    /// The name of the stop there; `None` if the mechanism itself cannot move on.
    pub stop: Option<String>,
    #[serde(skip)]
    text: String,
}

/// A motion over time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MotionFacts {
    /// Its steps, beginning where the scene opens.
    pub steps: Vec<StepFacts>,
    /// The period in s.
    pub period: f64,
    /// The total rest of the driver in a period, in s.
    pub rest: f64,
    /// The maximum absolute speed, in rad/s or the scene's unit per s.
    pub speed: f64,
    /// The maximum absolute acceleration, in rad/s^2 or the scene's unit per s^2, without jumps of
    /// the speed.
    pub acceleration: f64,
    /// The time of the first jump of the speed, in s; `None` if the speed is continuous.
    pub jump: Option<f64>,
    /// The first place at which it leaves the range; `None` if it stays inside.
    pub leaves: Option<LeavingFacts>,
    /// The unit of its coordinate in speeds.
    #[serde(skip)]
    unit: &'static str,
}

impl MotionFacts {
    /// Returns the facts of a scene's motion; `None` for a driver without a motion over time.
    #[must_use]
    pub fn of(scene: &Scene, solver: &Solver) -> Option<MotionFacts> {
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
                to: step.to() + 0.0,
                time: step.time(),
                ramp: match step {
                    TimedStep::Law {
                        law: StepLaw::Trapezoid { ramp },
                        ..
                    } => Some(*ramp),
                    TimedStep::Law { .. } | TimedStep::Table(_) => None,
                },
                knots: match step {
                    TimedStep::Table(spline) => Some(spline.knots().to_vec()),
                    TimedStep::Law { .. } => None,
                },
            }
        });
        Some(MotionFacts {
            steps: steps.collect(),
            period: law.period(),
            rest,
            speed: scale(speed),
            acceleration: scale(acceleration),
            jump,
            leaves: MotionOutOfRange::of(law, solver).map(|leaves| LeavingFacts {
                time: leaves.time,
                at: leaves.at,
                stop: leaves.stop.map(|stop| stop_name(scene, stop)),
                text: leaves_text(scene, &leaves),
            }),
            unit,
        })
    }

    /// Returns a sentence on the motion, and another one if it leaves the range.
    pub(super) fn texts(&self) -> impl Iterator<Item = String> {
        let leaves = self.leaves.as_ref().map(|leaves| leaves.text.clone());
        [self.text()].into_iter().chain(leaves)
    }

    fn text(&self) -> String {
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

    /// Returns two short forms, the shorter one last.
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

/// Describes where a motion leaves the range.
pub(super) fn leaves_text(scene: &Scene, leaves: &MotionOutOfRange) -> String {
    let catalogue = Catalogue::new(scene);
    let unit = &catalogue.driver().unit;
    let (time, at) = (concise(leaves.time, PLACES), concise(leaves.at, PLACES));
    match leaves.stop {
        None => words().motion_passes_end(&at, unit, &time),
        Some(stop) => match scene.mechanism.limit(stop).of {
            LimitOf::Table(_) => {
                words().motion_passes_table(&at, unit, &time, scene.limit_name(stop))
            }
            LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. } => {
                words().motion_passes_stop(&at, unit, &time, scene.limit_name(stop))
            }
        },
    }
}

const DWELL: &str = "dwell";

/// Returns the scene file's name of a step that starts at `from`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Check;

    /// The rod's limit of [100, 380] is reached at cos(theta) = (r2^2 + s^2 - r3^2) / (2 r2 s),
    /// 32.0734 deg.
    #[test]
    fn motion_beyond_stop_is_reported_with_stop_place_and_time() {
        let text = |limits: &str| {
            format!(
                "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\nmotion = [{{ law = \
                 \"constant\", to = 20, time = 2 }}, {{ law = \"table\", knots = [[0, 20], [0.5, 30], [1, 60]] }}, \
                 {{ law = \"trapezoid\", ramp = 0.2, to = 60, time = 1 }}]\n[links]\nr2 = {{ from = \"A\", to = \
                 \"B\", length = 100 }}\nr3 = {{ from = \"B\", to = \"C\", length = 300 }}\n[slides]\nrod = {{ \
                 point = \"C\", on = \"ground\", through = \"A\", angle = 0 }}\n[start]\nC = [350, 0]\n\
                 [limits]\n{limits}"
            )
        };
        let check = |limits: &str| {
            let scene = Scene::parse(&text(limits), "test").unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let check = Check::new(&scene, &solver);
            let told = check.to_text(true);
            let words: Vec<&str> = told.split_whitespace().collect();
            (words.join(" "), check.to_json())
        };
        let (told, json) = check("rod = [100, 380]\n");
        assert!(
            told.contains("passes the stop of rod: 32.0734124 deg, at 1.39632938 s"),
            "{told}"
        );
        let leaves = &json["motion"]["leaves"];
        assert_eq!(leaves["stop"], "rod");
        let time = (60.0 - 32.073_412_392_109) / 20.0;
        assert!(
            (leaves["time"].as_f64().unwrap() - time).abs() < 1e-12,
            "{leaves}"
        );
        let steps = &json["motion"]["steps"];
        assert_eq!(steps[1]["knots"][1], serde_json::json!([0.5, 30.0]));
        assert_eq!(steps[2]["ramp"], 0.2);
        assert!(steps[0].get("ramp").is_none() && steps[0].get("knots").is_none());
        let (told, json) = check("rod = [100, 500]\n");
        assert!(!told.contains("the motion over time passes"), "{told}");
        assert!(json["motion"]["leaves"].is_null());
        // Neither end of the range is ever reached.
        assert!(
            told.contains("never reached: rod from 100 to 500 mm"),
            "{told}"
        );
        assert_eq!(json["unmet"][0]["name"], "rod");
    }
}
