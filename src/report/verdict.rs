//! Summarizes a linkage during design: range of motion, class, and worst transmission angle.

use super::check::{TimedMotion, loop_name, stop_name};
use crate::quantity::Catalogue;
use crate::report::text::number::concise;
use crate::scene::Scene;
use crate::solver::{Range, Solver, Transmission};
use crate::wording::words;

/// Significant digits of an end of the range, and of the place of the worst transmission.
const PLACES: usize = 5;
/// Coordinates below this fraction of the range are shown as 0.
const NOUGHT: f64 = 1e-9;
/// Maximum number of groups for which transmission is evaluated after every edit.
const MAX_GROUPS: usize = 200;

/// A summary of a linkage over its whole motion.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    /// The parts, the most important first; a part that does not apply is `None`.
    pub parts: [Option<VerdictPart>; 5],
}

/// A part of a summary, as a long and a short text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VerdictPart {
    /// The full text.
    pub long: String,
    /// The short text.
    pub short: String,
}

impl VerdictPart {
    fn of(text: impl Into<String>) -> VerdictPart {
        let long = text.into();
        VerdictPart {
            short: long.clone(),
            long,
        }
    }
}

impl Verdict {
    /// Summarizes an assembled scene: the driver's range, the class of its first loop, change
    /// points, the transmission angle with the maximum deviation from 90 degrees, and the motion
    /// over time.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver) -> Verdict {
        let catalogue = Catalogue::new(scene);
        let unit = &catalogue.driver().unit;
        let range = range_part(scene, solver, unit);
        let class = solver.first_loop();
        let motion = TimedMotion::of(scene).map(|motion| {
            let [long, short] = motion.in_short();
            VerdictPart { long, short }
        });
        let passed = solver.motion().change_points.len();
        Verdict {
            parts: [
                Some(range),
                class.map(|class| VerdictPart::of(loop_name(&class))),
                (passed > 0).then(|| VerdictPart::of(words().some_change_points(passed))),
                transmission(scene, solver, unit),
                motion,
            ],
        }
    }
}

/// Describes the driver's range and its stops.
#[must_use]
pub fn motion_text(scene: &Scene, solver: &Solver) -> String {
    let catalogue = Catalogue::new(scene);
    range_part(scene, solver, &catalogue.driver().unit).long
}

/// Describes the driver's range and its stops.
fn range_part(scene: &Scene, solver: &Solver, unit: &str) -> VerdictPart {
    let Range::Limited { low, high } = solver.motion().range else {
        return VerdictPart::of(words().range_whole());
    };
    let size = low.abs().max(high.abs());
    let place = |at| concise(without_rounding(at, size), PLACES);
    let range = words().range_between(&place(low), &place(high), unit);
    let short = [range.clone()]
        .into_iter()
        .chain(stops_named(scene, solver));
    let placed = stop_placed(scene, solver, |at| place(at) + " " + unit);
    let long = [range].into_iter().chain(placed);
    let [long, short] = [long.collect::<Vec<_>>(), short.collect()];
    VerdictPart {
        long: long.join(", "),
        short: short.join(", "),
    }
}

/// Names the stops of the driver, if there are any.
fn stops_named(scene: &Scene, solver: &Solver) -> Option<String> {
    let met = solver.motion().stops.iter();
    let met = met.map(|stop| stop_name(scene, stop.limit));
    let mut names: Vec<String> = met.collect();
    match names.as_slice() {
        [] => None,
        [name] => Some(words().stop_of(name)),
        [..] => {
            names.dedup();
            Some(words().stops_of(&names))
        }
    }
}

/// Names the stops of the driver; a single stop with its place.
fn stop_placed(scene: &Scene, solver: &Solver, place: impl Fn(f64) -> String) -> Option<String> {
    match solver.motion().stops.as_slice() {
        [stop] => {
            let name = stop_name(scene, stop.limit);
            Some(words().stop_in_verdict(&name, &place(stop.at)))
        }
        _ => stops_named(scene, solver),
    }
}

/// Returns 0 for a coordinate that is a rounding error of 0 in a range of this size.
fn without_rounding(at: f64, size: f64) -> f64 {
    if at.abs() < NOUGHT * size { 0.0 } else { at }
}

/// Describes the transmission angle with the maximum deviation from 90 degrees; with the name of
/// its dyad if there are several.
fn transmission(scene: &Scene, solver: &Solver, unit: &str) -> Option<VerdictPart> {
    if solver.plan().groups.len() > MAX_GROUPS {
        return None;
    }
    let all = solver.transmission();
    let further = |a: &&Transmission, b: &&Transmission| a.deviation().total_cmp(&b.deviation());
    let worst = all.iter().max_by(further)?;
    let [minimum, maximum] = [worst.smallest, worst.largest];
    let at = match 90.0 - minimum.angle < maximum.angle - 90.0 {
        true => maximum.at,
        false => minimum.at,
    };
    let off = format!("{:.1}", worst.deviation());
    let group = (all.len() > 1)
        .then(|| solver.plan().group(worst.group))
        .flatten();
    let group = group.and_then(|group| scene.point_name(group.point?));
    let size = match solver.motion().range {
        Range::Full { period } => period,
        Range::Limited { low, high } => low.abs().max(high.abs()),
    };
    let at = concise(without_rounding(at, size), PLACES);
    Some(VerdictPart {
        long: words().transmission_worst(group, &off, &at, unit),
        short: words().transmission_off(&off),
    })
}
