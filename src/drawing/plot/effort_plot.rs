//! Plots the driver's torque or force over a cycle, with its extremes marked.

use crate::Vec2;
use crate::drawing::plot::{Axis, CurveTurn, Panel, Plot, PlotCurve};
use crate::study::motor::Duty;

/// Number of points of the curve.
const POINTS: u32 = 720;
/// The fraction of the cycle left out next to a dead point, because the torque may grow without
/// bound there.
const DEAD_POINT_MARGIN: f64 = 0.02;

/// Returns the plot of a cycle. `coordinate` is the name and the unit of the driver's coordinate,
/// `effort` those of its torque or force.
#[must_use]
pub fn effort(duty: &Duty, coordinate: [&str; 2], effort: [&str; 2]) -> Plot {
    let [name, unit] = effort;
    let cycle = &duty.cycle;
    let mut pieces = duty.curve(POINTS);
    if cycle.course.ends_at_dead_point {
        let (low, high) = (cycle.course.low, cycle.course.high);
        let nearby = DEAD_POINT_MARGIN * (high - low);
        let is_far = |p: &[f64; 2]| low + nearby <= p[0] && p[0] <= high - nearby;
        pieces.iter_mut().for_each(|piece| piece.retain(is_far));
        pieces.retain(|piece| !piece.is_empty());
    }
    let peaks = [(cycle.all.largest, true), (cycle.all.least, false)];
    let turns = peaks.into_iter().filter_map(|(peak, is_peak)| {
        let peak = peak?;
        Some(CurveTurn {
            at: Vec2::new(peak.at, peak.value),
            is_peak,
            is_extreme: true,
        })
    });
    let turns: Vec<CurveTurn> = turns.collect();
    // The range always includes zero.
    let values = pieces.iter().flatten().map(|p| p[1]);
    let values = values.chain(turns.iter().map(|turn| turn.at.y));
    let (low, high) = values.fold((0.0, 0.0), |(low, high): (f64, f64), v| {
        (low.min(v), high.max(v))
    });
    let line = PlotCurve {
        name: name.to_owned(),
        figure: Some(0),
        pieces: pieces
            .into_iter()
            .map(|piece| piece.into_iter().map(|[x, y]| Vec2::new(x, y)).collect())
            .collect(),
        turns,
        ..PlotCurve::default()
    };
    let high = if high > low { high } else { low + 1.0 };
    Plot {
        x: Axis::new(
            coordinate[0],
            coordinate[1],
            (cycle.course.low, cycle.course.high),
        ),
        panels: vec![Panel {
            y: Axis::new("", unit, (low, high)),
            curves: vec![line],
        }],
        is_true: false,
    }
}
