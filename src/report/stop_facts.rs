//! Facts on the stops at which a motion ends.

use super::number::concise;
use crate::scene::Scene;
use crate::solver::{EndStop, Solver};
use crate::wording::words;
use crate::{Input, LimitId, LimitOf, StrokeEnd};
use serde::Serialize;

/// A stop at an end of the range.
#[derive(Clone, Debug, Serialize)]
pub struct StopFacts {
    /// The limited element: a slide, a link, the driver, or the limit's own name.
    pub name: String,
    /// The driver's coordinate at the stop, in deg or the scene's unit.
    pub at: f64,
    /// The limit's value at the stop, in deg or the scene's unit.
    pub value: f64,
    /// The unit of `value`.
    #[serde(skip)]
    unit: &'static str,
    /// Whether it is the end of an input's table.
    #[serde(skip)]
    is_table: bool,
}

/// A limit whose ends the motion never reaches.
#[derive(Clone, Debug, Serialize)]
pub struct UnmetLimit {
    /// The limited element: a slide, a link, the driver, or the limit's own name.
    pub name: String,
    /// Its minimum and maximum, in deg or the scene's unit.
    pub ends: [f64; 2],
    #[serde(skip)]
    unit: &'static str,
}

/// Returns the limits whose ends the motion never reaches; the ends of a table do not count as
/// stops.
pub(super) fn unmet_limits(scene: &Scene, solver: &Solver) -> Vec<UnmetLimit> {
    let is_met = |id: &LimitId| solver.motion().stops.iter().any(|stop| stop.limit == *id);
    let limits = scene.mechanism.limit_ids().filter(|id| !is_met(id));
    let unmet = limits.filter_map(|id| {
        let limit = scene.mechanism.limit(id);
        match limit.of {
            LimitOf::Table(_) => None,
            LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Angle { .. } => Some(UnmetLimit {
                name: scene.limit_name(id).to_owned(),
                ends: [limit.low, limit.high],
                unit: unit_of(scene, limit.of),
            }),
        }
    });
    unmet.collect()
}

impl UnmetLimit {
    /// Formats the limit as a sentence.
    pub(super) fn text(&self) -> String {
        let [low, high] = self.ends.map(|end| concise(end, usize::MAX));
        words().never_met(&self.name, &low, &high, self.unit)
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

/// Returns the stops at which the motion ends, in order.
#[must_use]
pub fn stops(scene: &Scene, solver: &Solver) -> Vec<StopFacts> {
    let facts = |stop: &EndStop| {
        let limit = scene.mechanism.limit(stop.limit);
        StopFacts {
            name: scene.limit_name(stop.limit).to_owned(),
            at: stop.at,
            value: match stop.end {
                StrokeEnd::Least => limit.low,
                StrokeEnd::Greatest => limit.high,
            },
            is_table: matches!(limit.of, LimitOf::Table(_)),
            unit: unit_of(scene, limit.of),
        }
    };
    solver.motion().stops.iter().map(facts).collect()
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

impl StopFacts {
    /// Returns the name of the stop.
    #[must_use]
    pub fn called(&self) -> String {
        match self.is_table {
            true => words().table_named(&self.name),
            false => self.name.clone(),
        }
    }

    /// Explains that the stop ends the motion before a coordinate; `covered` is the driver's range.
    #[must_use]
    pub fn before(&self, at: f64, unit: &str, covered: &str) -> String {
        match self.is_table {
            true => words().table_ends_before(&at, unit, &self.name, covered),
            false => words().stopped_before(&at, unit, &self.name, covered),
        }
    }

    /// Formats the stop as a sentence; `at` is the driver's coordinate in `unit`.
    #[must_use]
    pub fn text(&self, at: &str, unit: &str) -> String {
        if self.is_table {
            return words().table_ends_at(at, unit, &self.name);
        }
        let value = format!("{} {}", concise(self.value, usize::MAX), self.unit);
        words().stop_at(at, unit, &self.name, &value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{Check, Verdict};

    const SLIDER_CRANK: &str = "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 100 }\nr3 = { from = \"B\", to = \"C\", length = 300 }\n[slides]\n\
        rod = { point = \"C\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nC = [350, 0]\n[limits]\n";

    fn told(limits: &str) -> (String, [String; 2], serde_json::Value) {
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
        let (text, verdict, json) = told("rod = [250, 380]\n");
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
        let (text, verdict, _) = told(
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
        let (text, verdict, json) = told("rod = [100, 500]\n");
        assert!(
            text.contains("stops      never reached: rod from 100 to 500 mm\n"),
            "{text}"
        );
        assert_eq!(verdict, ["turns fully", "turns fully"]);
        assert_eq!(json, serde_json::json!([]));
    }
}
