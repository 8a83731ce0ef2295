//! Columns for a step of a motor's cycle, common to sweeps over the driver's coordinate and over
//! time.

use crate::quantity::state_word;
use crate::report::forces::PARTS;
use crate::report::text::csv_dialect::cell;
use crate::study::motor::Step;

/// The columns after the torque and its parts.
const REST: [&str; 6] = [
    "driver.power [W]",
    "driver.work [J]",
    "ground.fx [N]",
    "ground.fy [N]",
    "ground.moment [N m]",
    "state",
];

/// Returns the headers; `effort` is `driver.torque` or `driver.force`.
pub(in crate::report) fn step_heads(effort: &str, unit: &str) -> Vec<String> {
    let mut headers = vec![format!("{effort} [{unit}]")];
    headers.extend(PARTS.map(|part| format!("{effort}.{part} [{unit}]")));
    headers.extend(REST.map(str::to_owned));
    headers
}

/// Returns the cells of a step, with the work in joules since the beginning. A missing value is
/// empty.
pub(in crate::report) fn step_cells(step: &Step, work: Option<f64>) -> Vec<String> {
    let mut cells = vec![cell(step.torque)];
    cells.extend((0..PARTS.len()).map(|i| cell(step.parts.map(|parts| parts[i]))));
    cells.extend([
        cell(step.power),
        cell(work),
        cell(step.ground.map(|(force, _)| force.x)),
        cell(step.ground.map(|(force, _)| force.y)),
        cell(step.ground.map(|(_, moment)| moment)),
        state_word(step.condition).to_owned(),
    ]);
    cells
}
