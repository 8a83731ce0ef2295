//! Facts on loads, and on reactions that are not determined.

use super::{CheckedScene, Fact};
use crate::report::forces::indeterminate;
use crate::report::text::places::place_text;
use crate::solver::Range;
use crate::study::motor;
use crate::wording::words;
use crate::{Link, Load, Vec2};
use serde_json::{Value, json};

impl CheckedScene<'_> {
    /// Returns the number of loads of each kind, springs and masses, whether there is gravity, and
    /// knots of loads that the motion never reaches.
    pub(super) fn loads(&self) -> Fact {
        let mechanism = &self.scene.mechanism;
        let [mut forces, mut torques, mut presses, mut springs] = [0; 4];
        for load in mechanism.loads() {
            match load {
                Load::Force { .. } => forces += 1,
                Load::Torque { .. } => torques += 1,
                Load::Press { .. } => presses += 1,
                Load::Spring { .. } | Load::GasSpring { .. } | Load::TorsionSpring { .. } => {
                    springs += 1;
                }
            }
        }
        let has_mass = |link: &&Link| link.mass > 0.0 || link.inertia > 0.0;
        let masses = mechanism.links().iter().filter(has_mass).count();
        let gravity = mechanism.gravity() != Vec2::ZERO;
        let range = self.solver.motion().range;
        // The common period of loads and motion, if it is longer than that of the motion.
        let period = match (range, motor::repeats(mechanism, range)) {
            (Range::Full { period }, Some(times @ 2..)) => Some(period * f64::from(times)),
            _ => None,
        };
        let kinds = [
            (forces, words().count_of_forces(forces)),
            (torques, words().count_of_torques(torques)),
            (presses, words().count_of_presses(presses)),
            (springs, words().count_of_springs(springs)),
            (masses, words().count_of_masses(masses)),
        ];
        let kinds = kinds.into_iter().filter(|(count, _)| *count > 0);
        let weight = (gravity && masses > 0).then(|| words().gravity().into());
        let kinds: Vec<String> = kinds.map(|(_, text)| text).chain(weight).collect();
        let kinds = (!kinds.is_empty()).then(|| kinds.join(", "));
        let text = kinds.map(|kinds| match period {
            Some(period) => words().repeated_after(&kinds, &period),
            None => kinds,
        });
        let acting = json!({
            "forces": forces,
            "torques": torques,
            "presses": presses,
            "springs": springs,
            "masses": masses,
            "gravity": gravity,
            "period": period,
        });
        let dead = Fact::each(words().fact_forces(), "dead_knots", self.dead_knots());
        let fact = Fact::new(words().fact_forces())
            .lines(text)
            .lines(dead.lines);
        fact.value("acting", acting).values(dead.values)
    }

    /// Returns the knots of every load whose intervals lie outside the motion.
    fn dead_knots(&self) -> impl Iterator<Item = (Value, [String; 1])> {
        let mechanism = &self.scene.mechanism;
        let of_load = |load: &Load| {
            let Range::Limited { low, high } = self.solver.motion().range else {
                return None;
            };
            let (on, over) = match load {
                Load::Force { point, over, .. } => (self.scene.point_name(*point)?, over),
                Load::Torque { link, over, .. } => (self.scene.link_name(*link), over),
                _ => return None,
            };
            let at = over.unused_between(low, high, mechanism.driver().turns());
            let places: Vec<String> = at.iter().map(|&at| place_text(at, &self.unit)).collect();
            let text = words().knots_outside(on, &places.join(", "));
            (!at.is_empty()).then(|| (json!({"on": on, "at": at}), [text]))
        };
        mechanism.loads().iter().filter_map(of_load)
    }

    /// Returns the reactions not determined because of redundant constraints.
    pub(super) fn indeterminate(&self) -> Fact {
        let open = indeterminate(self.scene, self.solver);
        let text = (!open.is_empty()).then(|| words().not_settled(&open.join(", ")));
        let fact = Fact::new(words().fact_open()).lines(text);
        fact.value("indeterminate", open)
    }
}
