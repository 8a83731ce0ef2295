//! A proposal as a scene: what is judged is what is handed over.

use super::{Partner, Pose, Proposal, Task, TaskKind};
use crate::Vec2;
use crate::angle::{degrees, unit};
use crate::scene::toml_string;
use std::fmt::{Arguments, Write as _};

/// What is said of a scene beside its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneTitles {
    /// The title.
    pub name: String,
    /// Where it comes from.
    pub source: String,
    /// What there is to know.
    pub note: String,
    /// The unit of lengths, as scenes write it.
    pub unit: String,
    /// How far each length may be off; nothing where that is left open.
    pub tolerance: Option<f64>,
}

/// The text of the scene: crank `r2` from A to B, coupler `r3` from B to C, and rocker `r4` from C to D or slide `r4`; lengths
/// are parameters. P is the point that is led, and comes to the task's points T1, T2 ... on the ground; of poses X lies on
/// the body's x axis beside P, and comes to X1, X2 .... It opens at the first point.
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
    line(format_args!(
        "[parameters]\ncrank   = {crank:?}\ncoupler = {coupler:?}"
    ));
    if let Some(rocker) = rocker {
        line(format_args!("rocker  = {rocker:?}"));
    }
    line(format_args!("\n[ground]\nA = {}", pair(proposal.pivot)));
    if let Partner::Rocker(d) = proposal.partner {
        line(format_args!("D = {}", pair(d)));
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
    let along = (c - b) * (1.0 / coupler);
    let led = proposal.tracer.map_or(String::new(), |p| {
        let place = |(name, offset): (&str, Vec2)| {
            let seen = (p + offset - b).turned(along.conj());
            format!("{name} = {}", pair(seen))
        };
        let places: Vec<String> = marks.on_body().map(place).collect();
        format!(", points = {{ {} }}", places.join(", "))
    });
    line(format_args!(
        "r3 = {{ from = \"B\", to = \"C\", length = \"coupler\"{led} }}"
    ));
    match proposal.partner {
        Partner::Rocker(_) => line(format_args!(
            "r4 = {{ from = \"C\", to = \"D\", length = \"rocker\" }}"
        )),
        Partner::Slide(angle) => line(format_args!(
            "\n[slides]\nr4 = {{ point = \"C\", on = \"ground\", through = {}, angle = {angle:?} }}",
            pair(c)
        )),
    }
    line(format_args!("\n[start]\nC = {}", pair(c)));
    Some(text)
}

fn heading(titles: &SceneTitles) -> String {
    let mut text = String::new();
    for (key, value) in [
        ("name", &titles.name),
        ("source", &titles.source),
        ("note", &titles.note),
        ("unit", &titles.unit),
    ] {
        if !value.is_empty() {
            text += &format!("{key:<6} = {}\n", toml_string(value));
        }
    }
    if let Some(tolerance) = titles.tolerance {
        text += &format!("tolerance = {tolerance:?}\n");
    }
    if !text.is_empty() {
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

    /// The points of the body that come to them, from the led one.
    fn on_body(&self) -> impl Iterator<Item = (&'static str, Vec2)> {
        let led = (!self.on_ground.is_empty()).then_some(("P", Vec2::ZERO));
        led.into_iter().chain(self.axis.map(|axis| ("X", axis)))
    }
}

fn pair(v: Vec2) -> String {
    format!("[{:?}, {:?}]", v.x, v.y)
}
