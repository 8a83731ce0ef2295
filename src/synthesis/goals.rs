//! The task of a candidate as goals on its scene: what has to be kept where its numbers change.

use super::functions::FunctionRun;
use super::machine::has_figures;
use super::{Candidate, Output, Partner, PathTask, Proposal, Task, TaskKind};
use crate::Vec2;
use crate::angle::{degrees, unit};

/// What the led point of a path may come to lie beside a point, as a part of the task's size, where it misses by less.
const NEAR: f64 = 2e-3;

/// A task in the words of its scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneGoals {
    /// The parameters that nothing in the task gives.
    pub vary: Vec<&'static str>,
    /// Goals of figures of the whole motion, as `P.x@60 = 120`, in degrees and in lengths of the task.
    pub keep: Vec<String>,
}

impl SceneGoals {
    /// Of a candidate's scene. A body comes to its poses, and an output to its pairs, at the crank's angles at which this
    /// linkage does; the led point of a path to within a little of each point, at any angle where that is free. `None` where
    /// the points are too many to be named one by one, or not all are come to.
    #[must_use]
    pub fn of(task: &Task, candidate: &Candidate) -> Option<SceneGoals> {
        let is_told = candidate.at.len() == task.points() && has_figures(task);
        let keep = match &task.kind {
            _ if !is_told => return None,
            TaskKind::Poses(poses) => {
                let poses = poses.poses.iter().zip(&candidate.at);
                let goals = poses.flat_map(|(pose, at)| {
                    [("P.x", pose.at.x), ("P.y", pose.at.y), ("body", pose.angle)]
                        .map(|(figure, value)| format!("{figure}@{at:?} = {value:?}"))
                });
                goals.collect()
            }
            TaskKind::Path(path) => {
                let near = near(candidate.figures.miss.max(NEAR * task.size()));
                let angles = (1..).zip(&candidate.at);
                let goals = angles.map(|(k, at)| match path.turns {
                    Some(_) => format!("miss{k}@{at:?} <= {near:?}"),
                    None => format!("miss{k}.least <= {near:?}"),
                });
                goals.collect()
            }
            TaskKind::Function(function) => {
                let run = FunctionRun::of(function, &candidate.proposal)?;
                let output = match function.output {
                    Output::Angle => "r4.angle",
                    Output::Slide => "r4.length",
                };
                let pairs = function.pairs.iter().zip(&candidate.at).enumerate();
                let goals = pairs.map(|(k, ([x, y], at))| {
                    let value = output_at(&candidate.proposal, k)? - run.error(*x, *y)?;
                    Some(format!("{output}@{at:?} = {value:?}"))
                });
                goals.collect::<Option<_>>()?
            }
        };
        Some(SceneGoals {
            vary: free(task, &candidate.proposal),
            keep,
        })
    }
}

/// Rounded up to two digits.
fn near(miss: f64) -> f64 {
    let rounded = format!("{:.1e}", 1.05 * miss);
    rounded.parse().unwrap_or(miss)
}

/// What the scene tells of its output at a point: the direction from C to D, or how far C has come along its guide.
fn output_at(proposal: &Proposal, point: usize) -> Option<f64> {
    let [_, c] = *proposal.places.get(point)?;
    Some(match proposal.partner {
        Partner::Rocker(d) => degrees(d - c),
        Partner::Slide(angle) => {
            let [_, first] = *proposal.places.first()?;
            (c - first).dot(unit(angle))
        }
    })
}

/// The parameters that the task leaves free: no pivot that is given, and of a function, whose place is given, the lengths.
fn free(task: &Task, proposal: &Proposal) -> Vec<&'static str> {
    let mut free = vec!["crank", "coupler"];
    let is_rocker = matches!(proposal.partner, Partner::Rocker(_));
    if is_rocker {
        free.push("rocker");
    }
    let pivots: &[Vec2] = match &task.kind {
        TaskKind::Function(_) => return free,
        TaskKind::Poses(poses) => &poses.pivots,
        TaskKind::Path(PathTask { pivots, .. }) => pivots,
    };
    if !pivots.contains(&proposal.pivot) {
        free.extend(["ax", "ay"]);
    }
    match proposal.partner {
        Partner::Rocker(d) if pivots.contains(&d) => {}
        Partner::Rocker(_) => free.extend(["dx", "dy"]),
        // A guide is moved across itself; along it nothing changes.
        Partner::Slide(angle) => {
            let across = unit(angle).perp();
            let by = if across.x.abs() > across.y.abs() {
                "gx"
            } else {
                "gy"
            };
            free.extend([by, "guide"]);
        }
    }
    free.extend(["px", "py"]);
    if let TaskKind::Poses(_) = task.kind {
        free.push("lean");
    }
    free
}
