//! Facts on the driver's range, change points and near misses.

use super::{CheckedScene, Fact, PLACES};
use crate::quantity::Catalogue;
use crate::report::text::number::{concise, fixed};
use crate::report::text::places::{DECIMALS, errors_text, limit_text, range_text};
use crate::scene::Scene;
use crate::solver::{Range, Solver};
use crate::wording::words;
use serde_json::{Value, json};

/// Significant digits of a sine in a sentence.
const DIGITS: usize = 3;

impl CheckedScene<'_> {
    pub(super) fn range(&self) -> Fact {
        let motion = self.solver.motion();
        let (range, period) = match motion.range {
            Range::Full { period } => ([0.0, period], Some(period)),
            Range::Limited { low, high } => ([low, high], None),
        };
        let errors = period.is_none();
        let errors = errors.then(|| errors_text(motion.range_bounds, &self.unit));
        let text = range_text(motion.range, Catalogue::new(self.scene).driver());
        Fact::new(words().fact_range())
            .lines([text].into_iter().chain(errors))
            .value("range", range)
            .value("range_bounds", motion.range_bounds)
            .value("period", period)
            .value("dead_points", &motion.dead_points)
    }

    /// Returns the change points through which the motion passes, and the tolerance that
    /// distinguishes them from near misses.
    pub(super) fn change_points(&self) -> Fact {
        let motion = self.solver.motion();
        let points = &motion.change_points;
        let lines = (!points.is_empty()).then(|| {
            let at = points.iter().map(|&at| fixed(at, DECIMALS));
            let at: Vec<String> = at.collect();
            let tolerance = match motion.tolerance {
                0.0 => words().equal_as_typed().into(),
                size => words().equal_within(&format!("{size:.1e}"), self.length),
            };
            [
                words().change_points_at(&at.join(", "), &self.unit),
                tolerance,
            ]
        });
        Fact::new(words().fact_change())
            .lines(lines.into_iter().flatten())
            .value("change_points", points)
            .value("tolerance", motion.tolerance)
    }

    /// Returns the ends of the range at which two assemblies meet, without proof that the motion
    /// can pass.
    pub(super) fn lined_up(&self) -> Fact {
        let items = self
            .solver
            .motion()
            .meeting_assemblies
            .iter()
            .filter_map(|end| {
                let group = self.group_name(self.solver.plan().group(end.group)?);
                let text = words().ends_lined_up(&limit_text(end.at), &self.unit, group);
                Some((json!({"group": group, "at": end.at + 0.0}), [text]))
            });
        Fact::each(words().fact_change(), "lined_up", items)
    }

    pub(super) fn near_misses(&self) -> Fact {
        Fact::each(
            words().fact_near_miss(),
            "near_misses",
            self.all_near_misses(),
        )
    }

    /// Returns the places where two assemblies almost meet, and the motion keeps its own.
    fn all_near_misses(&self) -> impl Iterator<Item = (Value, [String; 1])> {
        self.solver.motion().near_misses.iter().filter_map(|miss| {
            let group = self.group_name(self.solver.plan().group(miss.group)?);
            let [at, sine] = [(miss.at, PLACES), (miss.sine, DIGITS)].map(|(v, n)| concise(v, n));
            let text = words().near_miss(&at, &self.unit, &sine, group);
            let value = json!({"group": group, "sine": miss.sine, "at": miss.at + 0.0});
            Some((value, [text]))
        })
    }
}

/// Returns a sentence for each place where two assemblies almost meet during the motion.
#[must_use]
pub fn near_misses(scene: &Scene, solver: &Solver) -> Vec<String> {
    let of = CheckedScene::new(scene, solver);
    of.all_near_misses().flat_map(|(_, text)| text).collect()
}
