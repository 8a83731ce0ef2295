//! Facts on a driver's motion over time.

use super::{CheckedScene, Fact, PLACES, stop_name};
use crate::quantity::{Catalogue, MotionOutOfRange};
use crate::report::text::number::concise;
use crate::scene::Scene;
use crate::wording::words;
use crate::{Input, LimitOf, MotionLaw, MotionPeaks, StepLaw, TimedStep};
use serde_json::{Value, json};

/// Significant digits of a time, a speed and an acceleration.
const DIGITS: usize = 4;

/// A motion over time with its maxima.
pub(in crate::report) struct TimedMotion<'a> {
    law: &'a MotionLaw,
    /// The maxima, in rad/s or the scene's unit per s.
    peaks: MotionPeaks,
    /// The names of the steps.
    names: Vec<&'static str>,
    /// The unit of its coordinate in speeds.
    unit: &'static str,
}

impl CheckedScene<'_> {
    /// Returns the fact on the motion over time; empty for a driver without one.
    pub(super) fn motion(&self) -> Fact {
        let fact = Fact::new(words().fact_motion());
        let Some(motion) = TimedMotion::of(self.scene) else {
            return fact;
        };
        let leaves = MotionOutOfRange::of(motion.law, self.solver);
        let text = leaves
            .as_ref()
            .map(|out| describe_out_of_range(self.scene, out));
        let leaves = leaves.map(|out| {
            let stop = out.stop.map(|stop| stop_name(self.scene, stop));
            json!({"time": out.time, "at": out.at + 0.0, "stop": stop})
        });
        let value = json!({
            "steps": motion.steps_json(),
            "period": motion.law.period(),
            "rest": motion.peaks.rest,
            "speed": motion.peaks.speed,
            "acceleration": motion.peaks.acceleration,
            "jump": motion.peaks.jump,
            "leaves": leaves,
        });
        let lines = [motion.text()].into_iter().chain(text);
        fact.lines(lines).value("motion", value)
    }
}

impl<'a> TimedMotion<'a> {
    /// Returns the motion of a scene; `None` for a driver without a motion over time.
    pub(in crate::report) fn of(scene: &'a Scene) -> Option<Self> {
        let law = scene.motion.as_ref()?;
        let driver = scene.mechanism.driver();
        let mut peaks = law.peaks();
        let unit = match driver.input {
            Input::Turn(_) => {
                peaks.speed = peaks.speed.to_radians();
                peaks.acceleration = peaks.acceleration.to_radians();
                "rad"
            }
            Input::Push(_) => scene.unit.symbol(),
        };
        let mut from = driver.start;
        let steps = law.steps().iter();
        let names = steps.map(|step| name(step, std::mem::replace(&mut from, step.to())));
        Some(TimedMotion {
            names: names.collect(),
            law,
            peaks,
            unit,
        })
    }

    fn steps_json(&self) -> Vec<Value> {
        let steps = self.law.steps().iter().zip(&self.names);
        let json = steps.map(|(step, name)| {
            let mut value = json!({"law": name, "to": step.to() + 0.0, "time": step.time()});
            match step {
                TimedStep::Law {
                    law: StepLaw::Trapezoid { ramp },
                    ..
                } => value["ramp"] = json!(ramp),
                TimedStep::Law { .. } => {}
                TimedStep::Sine(sine) => {
                    value["amplitude"] = json!(sine.amplitude);
                    value["phase"] = json!(sine.phase);
                }
                TimedStep::Table(spline) => value["knots"] = json!(spline.knots()),
            }
            value
        });
        json.collect()
    }

    fn text(&self) -> String {
        let mut laws: Vec<&str> = Vec::new();
        for &name in &self.names {
            if name != DWELL && !laws.contains(&name) {
                laws.push(name);
            }
        }
        let mut text = words().motion_in_time(&laws.join(", "), &figure(self.law.period()));
        if self.peaks.rest > 0.0 {
            text += &words().motion_rests(&figure(self.peaks.rest));
        }
        let [speed, acceleration] = self.rates();
        text + &words().motion_at_most(&speed, &acceleration) + &self.jump()
    }

    /// Returns two short forms, the shorter one last.
    pub(in crate::report) fn in_short(&self) -> [String; 2] {
        let period = figure(self.law.period());
        let [speed, acceleration] = self.rates();
        [
            words().motion_verdict(&period, &speed, &acceleration) + &self.jump(),
            words().motion_in_short(&period, &speed),
        ]
    }

    /// Describes the first jump of the speed; empty if it is continuous.
    fn jump(&self) -> String {
        let jump = self.peaks.jump;
        jump.map_or_else(String::new, |jump| words().motion_jumps(&figure(jump)))
    }

    fn rates(&self) -> [String; 2] {
        let unit = self.unit;
        [
            format!("{} {unit}/s", figure(self.peaks.speed)),
            format!("{} {unit}/s^2", figure(self.peaks.acceleration)),
        ]
    }
}

/// Describes where a motion leaves the range.
pub(in crate::report) fn describe_out_of_range(scene: &Scene, leaves: &MotionOutOfRange) -> String {
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
        TimedStep::Sine(_) => "sine",
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
    use crate::solver::Solver;

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
            let shown_text = check.to_text(true);
            let words: Vec<&str> = shown_text.split_whitespace().collect();
            (words.join(" "), check.to_json())
        };
        let (shown_text, json) = check("rod = [100, 380]\n");
        assert!(
            shown_text.contains("passes the stop of rod: 32.0734124 deg, at 1.39632938 s"),
            "{shown_text}"
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
        let (shown_text, json) = check("rod = [100, 500]\n");
        assert!(
            !shown_text.contains("the motion over time passes"),
            "{shown_text}"
        );
        assert!(json["motion"]["leaves"].is_null());
        // Neither end of the range is ever reached.
        assert!(
            shown_text.contains("never reached: rod from 100 to 500 mm"),
            "{shown_text}"
        );
        assert_eq!(json["unmet"][0]["name"], "rod");
    }
}
