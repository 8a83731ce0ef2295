//! Reads pose and path tasks.

use super::{ByteSpan, Reader, numbers, points, report_missing_key, rows, same_twice};
use crate::Vec2;
use crate::angle::TURN;
use crate::document::{Diagnostic, items};
use crate::scene::{KeyTable, Measure};
use crate::synthesis::{PathTask, Pose, PoseTask};
use crate::wording::words;

const POSES: &str = "poses = [[0, 0, 0], [120, 40, 35], [180, 130, 80]]";
const POINTS: &str = "points = [[20, 20], [20, 25], [20, 30]]";
/// Minimum and maximum number of poses that the methods accept.
const MIN_COUNT: usize = 3;
const MAX_COUNT: usize = 5;
/// Maximum number of points of a path.
const MAX_POINTS: usize = 1000;

pub(super) fn poses(reader: &mut Reader<'_>, file: &KeyTable<'_>) -> Option<PoseTask> {
    let Some(written) = file.get("poses") else {
        return report_missing_key(reader, "poses", "poses", POSES);
    };
    let form = ("[x, y, angle]", "[120, 40, 35]");
    let measures = [Measure::Coordinate, Measure::Coordinate, Measure::Angle];
    let read = rows(reader, file, "poses", form, measures.map(Some));
    let pivots = given(reader, file, "pivots");
    let pins = given(reader, file, "pins");
    let (read, pivots, pins) = (read?, pivots?, pins?);
    if !(MIN_COUNT..=MAX_COUNT).contains(&read.len()) {
        reader.report(
            Diagnostic::new(words().count_of_poses(read.len()))
                .at(written.span(), "")
                .help(words().poses_that_methods_take()),
        );
        return None;
    }
    let mut are_apart = true;
    for (again, (row, span)) in read.iter().enumerate() {
        let first = read[..again]
            .iter()
            .position(|(before, _)| same_pose(before, row));
        if let Some(first) = first {
            same_twice(
                reader,
                (first, &read[first].1),
                (again, span),
                words().take_out_one_pose(),
            );
            are_apart = false;
        }
    }
    let given: Vec<&(Vec2, ByteSpan)> = pivots.iter().chain(&pins).collect();
    let maximum = if read.len() == MIN_COUNT { 2 } else { 0 };
    if let Some((_, span)) = given.get(maximum) {
        reader.report(
            Diagnostic::new(words().too_much_given(read.len(), given.len()))
                .at(span.clone(), words().one_too_many())
                .help(words().what_poses_leave_free()),
        );
        return None;
    }
    let plain = |all: Vec<(Vec2, ByteSpan)>| all.into_iter().map(|(at, _)| at).collect();
    are_apart.then(|| PoseTask {
        poses: read
            .iter()
            .map(|([x, y, angle], _)| Pose {
                at: Vec2::new(*x, *y),
                angle: *angle,
            })
            .collect(),
        pivots: plain(pivots),
        pins: plain(pins),
    })
}

/// Returns `true` if two poses agree up to full turns.
fn same_pose(one: &[f64; 3], other: &[f64; 3]) -> bool {
    let turned = crate::angle::wrapped(one[2]) == crate::angle::wrapped(other[2]);
    one[..2] == other[..2] && turned
}

pub(super) fn path(reader: &mut Reader<'_>, file: &KeyTable<'_>) -> Option<PathTask> {
    let Some(written) = file.get("points") else {
        return report_missing_key(reader, "path", "points", POINTS);
    };
    let read = points(reader, file, "points");
    let pivots = given(reader, file, "pivots");
    let closed = file.get("closed");
    let closed = closed.and_then(|closed| reader.boolean("`closed`", closed));
    let (read, pivots) = (read?, pivots?);
    if read.len() < 2 || read.len() > MAX_POINTS {
        reader.report(
            Diagnostic::new(words().count_of_points(read.len(), MAX_POINTS))
                .at(written.span(), "")
                .help(words().for_example(POINTS)),
        );
        return None;
    }
    // Points may repeat, as where a curve crosses itself, but not consecutively.
    for (k, pair) in read.windows(2).enumerate() {
        if pair[0].0 == pair[1].0 {
            let help = words().take_out_one_point();
            same_twice(reader, (k, &pair[0].1), (k + 1, &pair[1].1), help);
        }
    }
    if let ([first, .., last], Some(true)) = (&read[..], closed)
        && first.0 == last.0
    {
        let again = (read.len() - 1, &last.1);
        let help = words().take_out_last_point();
        same_twice(reader, (0, &first.1), again, help);
    }
    if let Some((_, span)) = pivots.get(2) {
        reader.report(
            Diagnostic::new(words().more_than_two_pivots())
                .at(span.clone(), words().one_too_many()),
        );
    }
    let turns = match file.has("turns") {
        false => None,
        true => Some(read_per_point(reader, file, "turns", read.len())?),
    };
    if let (Some(turns), Some(written)) = (&turns, file.get("turns")) {
        turns_fit(reader, turns, &written.span(), closed == Some(true));
    }
    let weights = match file.get("weights") {
        None => vec![1.0; read.len()],
        Some(written) => {
            let weights = read_per_point(reader, file, "weights", read.len())?;
            if !weights.iter().all(|weight| *weight > 0.0) {
                let fault = Diagnostic::new(words().weights_are_positive());
                reader.report(fault.at(written.span(), ""));
            }
            weights
        }
    };
    reader.found.is_empty().then(|| PathTask {
        points: read.iter().map(|(at, _)| *at).collect(),
        closed: closed.unwrap_or(false),
        turns,
        pivots: pivots.into_iter().map(|(at, _)| at).collect(),
        weights,
    })
}

/// Reads as many numbers as there are points.
fn read_per_point(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    key: &str,
    count: usize,
) -> Option<Vec<f64>> {
    let (read, written) = (numbers(reader, file, key)?, file.get(key)?);
    if read.len() == count {
        return Some(read);
    }
    reader.report(
        Diagnostic::new(words().one_for_each_point(key, count, read.len())).at(written.span(), ""),
    );
    None
}

/// Reports a second pivot if `linkages` contains slider-cranks only.
pub(super) fn slider_cranks_have_one_pivot(
    reader: &mut Reader<'_>,
    file: &KeyTable<'_>,
    linkages: &ByteSpan,
) {
    // An invalid list of points is reported where it is read.
    let pivots = file.get("pivots").and_then(items);
    if let Some(second) = pivots.and_then(|pivots| pivots.get(1)) {
        reader.report(
            Diagnostic::new(words().slider_crank_has_one_pivot())
                .at(second.span(), words().one_too_many())
                .and(linkages.clone(), words().slider_cranks_alone())
                .help(words().take_out_one_pivot()),
        );
    }
}

/// Reads given pivots or pins, and reports repeated ones.
fn given(reader: &mut Reader<'_>, file: &KeyTable<'_>, key: &str) -> Option<Vec<(Vec2, ByteSpan)>> {
    let read = points(reader, file, key)?;
    for (again, (at, span)) in read.iter().enumerate() {
        let first = read[..again].iter().position(|(before, _)| before == at);
        if let Some(first) = first {
            let help = words().links_have_their_own_ends();
            same_twice(reader, (first, &read[first].1), (again, span), help);
        }
    }
    Some(read)
}

/// Checks that the crank's turns start at the first point with 0 and are monotonic; for a closed
/// path they must stay below a full turn.
fn turns_fit(reader: &mut Reader<'_>, turns: &[f64], written: &ByteSpan, closed: bool) {
    let steps: Vec<f64> = turns.windows(2).map(|two| two[1] - two[0]).collect();
    let one_way = steps.iter().all(|step| *step > 0.0) || steps.iter().all(|step| *step < 0.0);
    let fault = if turns.first() != Some(&0.0) {
        words().turns_begin_at_nought()
    } else if !one_way {
        words().turns_go_one_way()
    } else if closed && turns.iter().any(|turn| turn.abs() >= TURN) {
        words().turns_end_within_one()
    } else {
        return;
    };
    reader.report(
        Diagnostic::new(fault)
            .at(written.clone(), "")
            .help(words().for_example("turns = [0, 30, 60]")),
    );
}
