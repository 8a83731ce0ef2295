//! Writes a proposal as a scene file.

use super::{PinConstraint, Pose, Proposal, Task, TaskKind};
use crate::Vec2;
use crate::angle::{degrees, unit};
use crate::scene::toml_string;
use std::fmt::{Arguments, Write as _};

/// Maximum number of task points for which the scene defines figures.
const MAX_FIGURES: usize = 24;

/// The header of a scene: comments, titles, unit and tolerance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneTitles {
    /// The title; not written if empty.
    pub name: String,
    /// The source of the linkage; not written if empty.
    pub source: String,
    /// Lines about the numbers in the file. They are written as TOML comments, so that no program applies them to
    /// changed numbers.
    pub comments: Vec<String>,
    /// The unit of lengths, in the notation of scene files; not written if empty.
    pub unit: String,
    /// The tolerance of each length, in the unit of lengths; `None` if unspecified.
    pub tolerance: Option<f64>,
}

/// Returns the scene file of a proposal, opened at the first point of its task.
///
/// The crank `r2` joins A and B, and the coupler `r3` joins B and C. `r4` is a rocker from C to D or a slide at C. The
/// lengths, pivots and led point are parameters.
///
/// P is the led point. The task's points are the marks T1, T2 ... on the ground. The figures `miss1`, `miss2` ... are
/// the distances of P from them. For poses, X is a second point on the body's x axis, half the coupler's length from P.
/// Its wanted positions are the marks X1, X2 ..., and the figure `body` is the direction of the axis. A task with more
/// than 24 points has no figures.
///
/// Returns `None` if the proposal has no positions.
#[must_use]
pub fn scene_text(proposal: &Proposal, task: &Task, titles: &SceneTitles) -> Option<String> {
    let [b, c] = *proposal.places.first()?;
    let (crank, coupler, rocker) = proposal.lengths()?;
    let marks = TaskMarks::of(task, 0.5 * coupler);
    let mut text = heading(titles);
    let mut line = |parts: Arguments<'_>| {
        // Writing to a string never fails.
        let _ = writeln!(text, "{parts}");
    };
    line(format_args!("[parameters]"));
    let mut parameter = |name: &str, value: f64| line(format_args!("{name:<7} = {value:?}"));
    parameter("crank", crank);
    parameter("coupler", coupler);
    if let Some(rocker) = rocker {
        parameter("rocker", rocker);
    }
    let mut place = |[x, y]: [&str; 2], at: Vec2| {
        parameter(x, at.x);
        parameter(y, at.y);
    };
    place(["ax", "ay"], proposal.pivot);
    match proposal.partner {
        PinConstraint::Rocker(d) => place(["dx", "dy"], d),
        PinConstraint::Slide(_) => place(["gx", "gy"], c),
    }
    let along = (c - b) * (1.0 / coupler);
    let guided = proposal.tracer.filter(|_| !marks.on_ground.is_empty());
    if let Some(p) = guided {
        place(["px", "py"], (p - b).turned(along.conj()));
    }
    if let PinConstraint::Slide(angle) = proposal.partner {
        parameter("guide", angle);
    }
    if let Some(axis) = marks.axis {
        parameter("lean", degrees(axis.turned(along.conj())));
    }
    line(format_args!("\n[ground]\nA = [\"ax\", \"ay\"]"));
    if let PinConstraint::Rocker(_) = proposal.partner {
        line(format_args!("D = [\"dx\", \"dy\"]"));
    }
    if !marks.on_ground.is_empty() {
        line(format_args!("\n[marks]"));
    }
    for (name, at) in &marks.on_ground {
        line(format_args!("{name} = {}", pair(*at)));
    }
    let start = degrees(b - proposal.pivot);
    line(format_args!(
        "\n[driver]\nlink  = \"r2\"\nangle = {start:?}"
    ));
    line(format_args!(
        "\n[links]\nr2 = {{ from = \"A\", to = \"B\", length = \"crank\" }}"
    ));
    let mut points = String::new();
    if guided.is_some() {
        points += ", points = { P = [\"px\", \"py\"]";
        if let Some(axis) = marks.axis {
            let arm = axis.norm();
            points +=
                &format!(", X = [\"px + {arm:?} * cos(lean)\", \"py + {arm:?} * sin(lean)\"]");
        }
        points += " }";
    }
    line(format_args!(
        "r3 = {{ from = \"B\", to = \"C\", length = \"coupler\"{points} }}"
    ));
    match proposal.partner {
        PinConstraint::Rocker(_) => line(format_args!(
            "r4 = {{ from = \"C\", to = \"D\", length = \"rocker\" }}"
        )),
        PinConstraint::Slide(_) => line(format_args!(
            "\n[slides]\nr4 = {{ point = \"C\", on = \"ground\", through = [\"gx\", \"gy\"], angle = \"guide\" }}",
        )),
    }
    let missed = (1..=task.points()).take_while(|_| guided.is_some() && has_figures(task));
    for k in missed {
        if k == 1 {
            line(format_args!("\n[figures]"));
            if marks.axis.is_some() {
                line(format_args!("body  = \"r3.angle + lean * 1 deg\""));
            }
        }
        line(format_args!(
            "miss{k} = \"hypot(P.x - T{k}.x, P.y - T{k}.y)\""
        ));
    }
    line(format_args!("\n[start]\nC = {}", pair(c)));
    Some(text)
}

/// Returns `true` if the scene has figures for the points of a task. Nobody reads the figures of many points one by
/// one.
pub(super) fn has_figures(task: &Task) -> bool {
    task.points() <= MAX_FIGURES
}

/// Formats the comments and keys before the first table of a scene.
fn heading(titles: &SceneTitles) -> String {
    let mut text = String::new();
    for comment in &titles.comments {
        text += &format!("# {comment}\n");
    }
    if !text.is_empty() {
        text.push('\n');
    }
    let before = text.len();
    for (key, value) in [
        ("name", &titles.name),
        ("source", &titles.source),
        ("unit", &titles.unit),
    ] {
        if !value.is_empty() {
            text += &format!("{key:<6} = {}\n", toml_string(value));
        }
    }
    if let Some(tolerance) = titles.tolerance {
        text += &format!("tolerance = {tolerance:?}\n");
    }
    if text.len() > before {
        text.push('\n');
    }
    text
}

/// The visible marks of a task: the wanted positions of the led point and, for poses, of a point on the body's x axis.
struct TaskMarks {
    /// The name and position of each mark; empty for a function.
    on_ground: Vec<(String, Vec2)>,
    /// The vector from the led point to the point on the x axis, in the first pose; `None` except for poses.
    axis: Option<Vec2>,
}

impl TaskMarks {
    /// Creates the marks of a task. `arm` is the distance of the point on the x axis from the led point.
    fn of(task: &Task, arm: f64) -> TaskMarks {
        let named = |letter: char, places: &mut dyn Iterator<Item = Vec2>| -> Vec<(String, Vec2)> {
            let numbered = (1..).zip(places);
            numbered
                .map(|(k, at)| (format!("{letter}{k}"), at))
                .collect()
        };
        match &task.kind {
            TaskKind::Poses(task) => {
                let mut on_ground = named('T', &mut task.poses.iter().map(|pose| pose.at));
                let end = |pose: &Pose| pose.at + unit(pose.angle) * arm;
                on_ground.extend(named('X', &mut task.poses.iter().map(end)));
                let axis = task.poses.first().map(|pose| unit(pose.angle) * arm);
                TaskMarks { on_ground, axis }
            }
            TaskKind::Path(task) => TaskMarks {
                on_ground: named('T', &mut task.points.iter().copied()),
                axis: None,
            },
            TaskKind::Function(_) => TaskMarks {
                on_ground: Vec::new(),
                axis: None,
            },
        }
    }
}

/// Formats a vector as a TOML array with the shortest decimals that parse to the same values.
fn pair(v: Vec2) -> String {
    format!("[{:?}, {:?}]", v.x, v.y)
}
