//! Facts on transmission angles, the condition of coupled groups, and strokes.

use super::{CheckedScene, Fact};
use crate::report::cycle::{CycleReport, conditions};
use crate::report::text::places::place;
use crate::solver::Extreme;
use crate::wording::words;
use serde_json::json;

/// Decimals of a transmission angle.
const DECIMALS: usize = 4;
/// Maximum number of groups for which the values of a cycle are computed.
const MAX_GROUPS: usize = 200;

impl CheckedScene<'_> {
    /// Returns the minimum and maximum transmission angle of every dyad.
    pub(super) fn transmission(&self) -> Fact {
        let items = self.solver.transmission().into_iter().filter_map(|found| {
            let group = self.group_name(self.solver.plan().group(found.group)?);
            let extreme = |end: Extreme| json!({"angle": end.angle, "at": end.at + 0.0});
            let ends = [found.smallest, found.largest];
            let [minimum, maximum] = ends.map(|end| format!("{:.DECIMALS$}", end.angle));
            let [at_least, at_most] = ends.map(|end| place(end.at));
            let text = match minimum == maximum {
                true => words().transmission_throughout(group, &minimum),
                false => {
                    let ends = [&*minimum, &at_least, &maximum, &at_most];
                    words().transmission_between(group, ends, &self.unit)
                }
            };
            let value = json!({
                "group": group,
                "smallest": extreme(found.smallest),
                "largest": extreme(found.largest),
                "deviation": found.deviation(),
            });
            Some((value, [text]))
        });
        Fact::each(words().fact_transmission(), "transmission", items)
    }

    /// Returns the worst condition of every coupled group.
    pub(super) fn condition(&self) -> Fact {
        let items = conditions(self.scene, self.solver).into_iter();
        let items = items.map(|one| (one.to_json(), [one.condition_text(&self.unit)]));
        Fact::each(words().fact_condition(), "condition", items)
    }

    /// Returns the default values of `krank cycle`: stroke or swing, turning places and time ratio.
    /// Empty for mechanisms with very many groups.
    pub(super) fn strokes(&self) -> Fact {
        let is_small = self.solver.plan().groups.len() <= MAX_GROUPS;
        let found = is_small.then(|| CycleReport::strokes(self.scene, self.solver));
        let lines = found.iter().flat_map(CycleReport::lines);
        let values = found.iter().flat_map(CycleReport::strokes_json);
        Fact::new(words().fact_figures())
            .lines(lines)
            .value("figures", values.collect::<Vec<_>>())
    }
}
