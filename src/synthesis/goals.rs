//! Writes a candidate's task as goals on its scene, to be kept while parameters of the scene change.

use super::functions::FunctionRun;
use super::machine::has_figures;
use super::{Candidate, Output, PathTask, PinConstraint, Proposal, Task, TaskKind};
use crate::Vec2;
use crate::angle::{degrees, unit};

/// Minimum tolerance between the led point and a path point, relative to the task's size. It applies if the candidate
/// misses its points by less.
const NEAR: f64 = 2e-3;

/// A task as varied parameters and goals of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneGoals {
    /// The parameters that the task leaves free.
    pub vary: Vec<&'static str>,
    /// Goals over the whole motion, such as `P.x@60 = 120`, in degrees and in lengths of the task.
    pub keep: Vec<String>,
}

impl SceneGoals {
    /// Creates the goals for a candidate's scene.
    ///
    /// A body must have its poses, and an output its values, at the crank angles of this candidate. The led point of a
    /// path must pass each point within a tolerance slightly above the candidate's largest miss. If the task leaves the
    /// crank angles free, it may do so at any angle.
    ///
    /// Returns `None` if the task has too many points to name each one, if the candidate does not reach all of them, or
    /// if the output of a function cannot be computed.
    #[must_use]
    pub fn of(task: &Task, candidate: &Candidate) -> Option<SceneGoals> {
        let is_shown = candidate.at.len() == task.points() && has_figures(task);
        let keep = match &task.kind {
            _ if !is_shown => return None,
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

/// Rounds a miss up to two significant digits. The added 5 % outweigh a rounding to a smaller value.
fn near(miss: f64) -> f64 {
    let rounded = format!("{:.1e}", 1.05 * miss);
    rounded.parse().unwrap_or(miss)
}

/// Returns the scene's output at a point of the task: the direction from C to D, in degrees, or the displacement of C
/// along its guide from the first point. Returns `None` if the proposal does not have the point.
fn output_at(proposal: &Proposal, point: usize) -> Option<f64> {
    let [_, c] = *proposal.places.get(point)?;
    Some(match proposal.partner {
        PinConstraint::Rocker(d) => degrees(d - c),
        PinConstraint::Slide(angle) => {
            let [_, first] = *proposal.places.first()?;
            (c - first).dot(unit(angle))
        }
    })
}

/// Returns the parameters that the task leaves free. Given pivots are fixed. For a function, the pivots and the guide
/// are given, and only the lengths are free.
fn free(task: &Task, proposal: &Proposal) -> Vec<&'static str> {
    let mut free = vec!["crank", "coupler"];
    let is_rocker = matches!(proposal.partner, PinConstraint::Rocker(_));
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
        PinConstraint::Rocker(d) if pivots.contains(&d) => {}
        PinConstraint::Rocker(_) => free.extend(["dx", "dy"]),
        // Only a displacement normal to the guide changes the linkage.
        PinConstraint::Slide(angle) => {
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
