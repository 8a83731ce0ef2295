//! Facts on the point that inputs follow.

use super::{CheckedScene, Fact, PLACES};
use crate::Input;
use crate::report::sweep::lead::singularity_text;
use crate::report::text::number::concise;
use crate::scene::LeadingPoint;
use crate::solver::{LeadSingularity, LedReach, PointLeader};
use crate::wording::words;
use serde_json::{Value, json};

/// Number of pieces in which the path is followed.
const PIECES: u16 = 360;

/// Says up to which time and place, in the scene's length unit, the inputs can follow a leading
/// point.
#[must_use]
pub fn followed_until(lead: &LeadingPoint, time: f64, unit: &str) -> String {
    let [at, ..] = lead.path.at(time);
    let [time, x, y] = [time, at.x, at.y].map(|number| concise(number, PLACES));
    words().lead_is_followed_until(&time, &format!("[{x}, {y}] {unit}"))
}

/// Says why the inputs cannot reach the first position of a leading point.
#[must_use]
pub fn unreached(is_independent: bool) -> &'static str {
    match is_independent {
        true => words().lead_is_not_reached(),
        false => words().lead_is_dependent(),
    }
}

impl CheckedScene<'_> {
    /// Returns the fact on the leading point; empty for a scene without one.
    pub(super) fn lead(&self) -> Fact {
        let fact = Fact::new(words().fact_lead());
        let Some(lead) = &self.scene.lead else {
            return fact;
        };
        let Some(leader) = PointLeader::new(self.solver, lead.lead()) else {
            return fact;
        };
        let is_independent = leader.is_independent();
        let reach = leader.reach(&lead.path, PIECES);
        let [first, last] = lead.path.span();
        let point = self.point_name(lead.point);
        let all: Vec<Input> = self.scene.mechanism.inputs().collect();
        let inputs = lead
            .inputs
            .iter()
            .filter_map(|&index| all.get(index).copied());
        let inputs: Vec<Input> = inputs.collect();
        let names: Vec<&str> = inputs.iter().map(|&i| self.scene.input_name(i)).collect();
        let mut lines = vec![words().point_leads(
            point,
            &concise(first, PLACES),
            &concise(last, PLACES),
            &names.join(", "),
        )];
        if reach.is_complete {
            lines.push(words().lead_is_followed().to_owned());
        } else if reach.until == first {
            lines.push(unreached(is_independent).to_owned());
        } else {
            lines.push(followed_until(lead, reach.until, self.length));
        }
        for (&input, range) in inputs.iter().zip(&reach.ranges) {
            if range[0] <= range[1] {
                let [low, high] = range.map(|end| concise(end, PLACES));
                let unit = self.scene.input_unit(input);
                let name = self.scene.driven_name(input);
                lines.push(words().following_input_covers(&name, &low, &high, unit));
            }
        }
        for (time, singularity) in &reach.singular {
            let text = singularity_text(self.scene, self.solver, singularity);
            lines.push(words().lead_is_singular(&concise(*time, PLACES), &text));
        }
        let value = json!({
            "point": point,
            "time": [first, last],
            "until": reach.until,
            "complete": reach.is_complete,
            "inputs": self.following_json(&names, &reach),
            "singular": self.singular_json(&reach),
        });
        fact.lines(lines).value("lead", value)
    }

    fn following_json(&self, names: &[&str], reach: &LedReach) -> Vec<Value> {
        let inputs = names.iter().zip(&reach.ranges);
        let json = inputs.map(|(name, range)| {
            let range = (range[0] <= range[1]).then_some(range);
            json!({"name": name, "range": range})
        });
        json.collect()
    }

    fn singular_json(&self, reach: &LedReach) -> Vec<Value> {
        let all: Vec<&str> = (self.scene.mechanism.inputs())
            .map(|input| self.scene.input_name(input))
            .collect();
        let json = reach
            .singular
            .iter()
            .map(|(time, singularity)| match singularity {
                LeadSingularity::Serial(inputs) => {
                    let names = inputs.iter().filter_map(|&index| all.get(index));
                    json!({"time": time, "kind": "serial", "inputs": names.collect::<Vec<_>>()})
                }
                LeadSingularity::Parallel(group) => {
                    let group = self.solver.plan().group(*group);
                    let name = group.map(|group| self.group_name(group));
                    json!({"time": time, "kind": "parallel", "group": name})
                }
            });
        json.collect()
    }
}
