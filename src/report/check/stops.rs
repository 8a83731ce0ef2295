//! Facts on the stops at which a motion ends.

use super::{CheckedScene, Fact};
use crate::report::text::number::concise;
use crate::report::text::places::limit_text;
use crate::scene::Scene;
use crate::solver::{EndStop, Solver};
use crate::wording::words;
use crate::{Input, LimitId, LimitOf, StrokeEnd};
use serde_json::{Value, json};

impl CheckedScene<'_> {
    /// Returns the fact on the stops at which the motion ends, and on limits never reached.
    pub(super) fn stops(&self) -> Fact {
        let stops = self.solver.motion().stops.iter();
        let unmet = self.unmet();
        let unmet = Fact::each(words().fact_stops(), "unmet", unmet);
        let lines = stops.map(|stop| self.stop_text(stop)).chain(unmet.lines);
        Fact::new(words().fact_stops())
            .lines(lines)
            .value("stops", stops_json(self.scene, self.solver))
            .values(unmet.values)
    }

    fn stop_text(&self, stop: &EndStop) -> String {
        let (at, name) = (limit_text(stop.at), self.scene.limit_name(stop.limit));
        match self.scene.mechanism.limit(stop.limit).of {
            LimitOf::Table(_) => words().table_ends_at(&at, &self.unit, name),
            of @ (LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. }) => {
                let value = concise(value(self.scene, stop), usize::MAX);
                let value = format!("{value} {}", unit_of(self.scene, of));
                words().stop_at(&at, &self.unit, name, &value)
            }
        }
    }

    /// Returns the limits whose ends the motion never reaches; the ends of a table do not count as
    /// stops.
    fn unmet(&self) -> impl Iterator<Item = (Value, [String; 1])> {
        let scene = self.scene;
        let is_met =
            |id: &LimitId| (self.solver.motion().stops.iter()).any(|stop| stop.limit == *id);
        let limits = scene.mechanism.limit_ids().filter(move |id| !is_met(id));
        limits.filter_map(move |id| {
            let limit = scene.mechanism.limit(id);
            match limit.of {
                LimitOf::Table(_) => None,
                LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. } => {
                    let name = scene.limit_name(id);
                    let [low, high] = [limit.low, limit.high].map(|end| concise(end, usize::MAX));
                    let text = words().never_met(name, &low, &high, unit_of(scene, limit.of));
                    Some((
                        json!({"name": name, "ends": [limit.low, limit.high]}),
                        [text],
                    ))
                }
            }
        })
    }
}

/// Returns the stops at which the motion ends, in order: the name of the limit, the driver's
/// coordinate, and the limit's value there.
pub(in crate::report) fn stops_json(scene: &Scene, solver: &Solver) -> Vec<Value> {
    let stop = |stop: &EndStop| {
        let name = scene.limit_name(stop.limit);
        json!({"name": name, "at": stop.at, "value": value(scene, stop)})
    };
    solver.motion().stops.iter().map(stop).collect()
}

fn value(scene: &Scene, stop: &EndStop) -> f64 {
    let limit = scene.mechanism.limit(stop.limit);
    match stop.end {
        StrokeEnd::Minimum => limit.low,
        StrokeEnd::Maximum => limit.high,
    }
}

/// Returns the unit of the ends of a limit.
fn unit_of(scene: &Scene, of: LimitOf) -> &'static str {
    let is_angle = match of {
        LimitOf::Driver | LimitOf::Table(_) => {
            matches!(scene.mechanism.driver().input, Input::Turn(_))
        }
        LimitOf::Slide(_) => false,
        LimitOf::Angle { .. } => true,
    };
    if is_angle { "deg" } else { scene.unit.symbol() }
}

/// Returns the name of a stop: the limited element, or the table that ends.
#[must_use]
pub fn stop_name(scene: &Scene, limit: LimitId) -> String {
    let name = scene.limit_name(limit);
    match scene.mechanism.limit(limit).of {
        LimitOf::Table(_) => words().table_named(name),
        LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. } => name.to_owned(),
    }
}

/// Explains that a stop ends the motion before a coordinate; `covered` is the driver's range.
#[must_use]
pub fn stop_before(
    scene: &Scene,
    limit: LimitId,
    (at, unit): (f64, &str),
    covered: &str,
) -> String {
    let name = scene.limit_name(limit);
    match scene.mechanism.limit(limit).of {
        LimitOf::Table(_) => words().table_ends_before(&at, unit, name, covered),
        LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. } => {
            words().stopped_before(&at, unit, name, covered)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{Check, Verdict};

    const SLIDER_CRANK: &str = "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 100 }\nr3 = { from = \"B\", to = \"C\", length = 300 }\n[slides]\n\
        rod = { point = \"C\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nC = [350, 0]\n[limits]\n";

    fn report_limits(limits: &str) -> (String, [String; 2], serde_json::Value) {
        let scene = Scene::parse(&format!("{SLIDER_CRANK}{limits}"), "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let check = Check::new(&scene, &solver);
        let [range, ..] = Verdict::new(&scene, &solver).parts;
        let range = range.unwrap();
        let mut json = check.to_json();
        (
            check.to_text(true),
            [range.long, range.short],
            json["stops"].take(),
        )
    }

    /// The positions by the law of cosines: cos(theta) = (r2^2 + s^2 - r3^2) / (2 r2 s).
    #[test]
    fn stops_are_reported_with_their_positions() {
        let (text, verdict, json) = report_limits("rod = [250, 380]\n");
        assert!(
            text.contains(
                "stops      32.073412392109 deg: rod at 380 mm\n           110.487315114723 deg: rod at 250 mm\n"
            ),
            "{text}"
        );
        assert_eq!(verdict[0], "32.073..110.49 deg, stops of rod");
        assert_eq!(verdict[1], verdict[0]);
        assert_eq!(json[0]["name"], "rod");
        assert_eq!(json[0]["value"], 380.0);
        assert_eq!(json[1]["at"], 110.48731511472266);
        assert_eq!(json.as_array().map(Vec::len), Some(2));
    }

    #[test]
    fn limits_are_reported_by_name() {
        let (text, verdict, _) = report_limits(
            "rod = [200, 380]\nknee = { link = \"r3\", from = \"r2\", angle = [-123, -30] }\n",
        );
        assert!(text.contains(" deg: knee at -123 deg\n"), "{text}");
        assert!(
            verdict[0].ends_with(", stops of rod and knee"),
            "{verdict:?}"
        );
    }

    #[test]
    fn fully_rotating_crank_reaches_no_stops() {
        let (text, verdict, json) = report_limits("rod = [100, 500]\n");
        assert!(
            text.contains("stops      never reached: rod from 100 to 500 mm\n"),
            "{text}"
        );
        assert_eq!(verdict, ["turns fully", "turns fully"]);
        assert_eq!(json, serde_json::json!([]));
    }
}
