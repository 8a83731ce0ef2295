//! Writes a proposal as a scene file.

use super::{Partner, Pose, Proposal, Task, TaskKind};
use crate::Vec2;
use crate::angle::{degrees, unit};
use crate::scene::toml_string;
use std::fmt::{Arguments, Write as _};

/// Points of a task that are figures of its scene.
const MAX_FIGURES: usize = 24;

/// What is said of a scene beside its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneTitles {
    /// The title.
    pub name: String,
    /// Where it comes from.
    pub source: String,
    /// What is told of these very numbers, line by line: it stands in comments, so that nothing reads it as being of others.
    pub comments: Vec<String>,
    /// The unit of lengths, as scenes write it.
    pub unit: String,
    /// How far each length may be off; nothing where that is left open.
    pub tolerance: Option<f64>,
}

/// The text of the scene: crank `r2` from A to B, coupler `r3` from B to C, and rocker `r4` from C to D or slide `r4`; its
/// lengths, pivots and led point are parameters. P is the point that is led, and comes to the task's points T1, T2 ... on
/// the ground, from which it is the figure `miss1`, `miss2` ... away; of poses X lies on the body's x axis beside P, and
/// comes to X1, X2 ..., and the figure `body` is the direction of that axis. It opens at the first point.
///
/// `None` where the proposal has no place at all.
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
        Partner::Rocker(d) => place(["dx", "dy"], d),
        Partner::Slide(_) => place(["gx", "gy"], c),
    }
    let along = (c - b) * (1.0 / coupler);
    let led = proposal.tracer.filter(|_| !marks.on_ground.is_empty());
    if let Some(p) = led {
        place(["px", "py"], (p - b).turned(along.conj()));
    }
    if let Partner::Slide(angle) = proposal.partner {
        parameter("guide", angle);
    }
    if let Some(axis) = marks.axis {
        parameter("lean", degrees(axis.turned(along.conj())));
    }
    line(format_args!("\n[ground]\nA = [\"ax\", \"ay\"]"));
    if let Partner::Rocker(_) = proposal.partner {
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
    if led.is_some() {
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
        Partner::Rocker(_) => line(format_args!(
            "r4 = {{ from = \"C\", to = \"D\", length = \"rocker\" }}"
        )),
        Partner::Slide(_) => line(format_args!(
            "\n[slides]\nr4 = {{ point = \"C\", on = \"ground\", through = [\"gx\", \"gy\"], angle = \"guide\" }}",
        )),
    }
    let missed = (1..=task.points()).take_while(|_| led.is_some() && has_figures(task));
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

/// Whether each point of a task is a figure of its scene: of many points nobody reads them one by one.
pub(super) fn has_figures(task: &Task) -> bool {
    task.points() <= MAX_FIGURES
}

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

/// What of a task can be seen: where the led point is to come, and of poses where a point on the body's x axis.
struct TaskMarks {
    on_ground: Vec<(String, Vec2)>,
    /// From the led point to the one on the x axis, in the first pose.
    axis: Option<Vec2>,
}

impl TaskMarks {
    /// `arm` is how far the point on the x axis lies from the led one.
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

fn pair(v: Vec2) -> String {
    format!("[{:?}, {:?}]", v.x, v.y)
}
