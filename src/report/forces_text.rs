//! The forces as text, and for other programs.

use super::forces::{Existence, Forces, GuideRow, JointRow};
use super::number::significant;
use super::tables::{Entry, Plane};
use super::tables_data::number;
use super::tables_text::{BOUND, POINT_LABELS, VECTOR_LABELS, Writer};
use super::text::{Grid, WIDTH, wrapped};
use crate::quantity::Aspect;
use serde_json::{Map, Value};

/// Labels of the frame's table, which has one column more than others.
const FRAME_LABELS: usize = "on the frame".len() + 6;
/// Digits of what a check misses.
const MISSED: usize = 2;

/// What a check misses, as a reader sees it.
pub(crate) fn missed(entry: &Entry) -> String {
    let text = entry.value.map(|value| significant(value, MISSED));
    text.unwrap_or_else(|| "-".into())
}

impl Writer<'_> {
    /// The parts of the text: a table each of what exists, and what is to be said about the rest.
    pub(super) fn force_parts(&self, forces: &Forces) -> Vec<String> {
        let remarks = forces.remarks();
        let remarks = remarks.iter().flat_map(|text| wrapped(text, WIDTH));
        let mut parts = match forces.existence() {
            Existence::Nothing => Vec::new(),
            Existence::Withheld => vec![self.check_table(forces)],
            Existence::DriveAlone => vec![self.drive_table(forces)],
            Existence::Everything => vec![
                self.drive_table(forces),
                self.joint_table("force at joints", &forces.joints),
                self.guide_table("force of guides", &forces.guides),
                self.least_tables(forces),
                self.frame_table(forces),
                self.check_table(forces),
            ],
        };
        parts.push(remarks.map(|line| line + "\n").collect());
        parts
    }

    fn drive_table(&self, forces: &Forces) -> String {
        let drive = &forces.drive;
        let mut grid = Grid::new(VECTOR_LABELS, self.style.digits + 3);
        let heads = ["in all", "loads", "gravity", "inertia"];
        let title = format!("driver {}", drive.name);
        grid.row(std::iter::once(title).chain(heads.map(|head| format!("{head} "))));
        let entries = || std::iter::once(drive.total).chain(drive.parts);
        let label = self.label(drive.aspect.name(), drive.aspect);
        self.entries(&mut grid, label, entries(), drive.aspect, " ");
        let label = self.label("power", Aspect::Power);
        self.entries(&mut grid, label, [drive.power], Aspect::Power, " ");
        grid.render()
    }

    /// What is open, of least norm.
    fn least_tables(&self, forces: &Forces) -> String {
        let Some(least) = &forces.least else {
            return String::new();
        };
        let joints = self.joint_table("of least norm", &least.joints);
        let guides = self.guide_table("of least norm", &least.guides);
        [joints, guides]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join("\n")
    }

    fn joint_table(&self, title: &str, joints: &[JointRow]) -> String {
        let mut grid = Grid::new(POINT_LABELS, self.style.digits + 2);
        let heads = ["fx", "fy", "f"].map(|name| self.label(name, Aspect::Fx));
        let direction = self.label("direction", Aspect::Angle);
        grid.row(
            std::iter::once(title.to_owned())
                .chain(heads)
                .chain([direction]),
        );
        let rows = joints.iter().filter(|joint| !joint.repeats);
        let mut any = false;
        for joint in rows {
            let by = joint.by.as_ref().map(|by| format!(", by {by}"));
            let name = format!(
                "{} at {}{}",
                joint.link,
                joint.point,
                by.unwrap_or_default()
            );
            self.plane(&mut grid, name, joint.force, []);
            any = true;
        }
        if any { grid.render() } else { String::new() }
    }

    fn guide_table(&self, title: &str, guides: &[GuideRow]) -> String {
        if guides.is_empty() {
            return String::new();
        }
        let mut grid = Grid::new(POINT_LABELS, self.style.digits + 2);
        let heads = [
            ("normal", Aspect::Normal),
            ("at", Aspect::Length),
            ("moment", Aspect::Moment),
        ];
        let heads = heads.map(|(name, aspect)| self.label(name, aspect));
        grid.row(std::iter::once(title.to_owned()).chain(heads));
        for guide in guides {
            let name = format!("{} on {}", guide.name, guide.slider);
            let cells = [Some(guide.normal), guide.at, guide.moment];
            let texts = cells.map(|cell| cell.map(|entry| self.figure(entry, Aspect::Normal)));
            grid.row(std::iter::once(name).chain(texts.map(Option::unwrap_or_default)));
            if self.style.bounds {
                let bounds = cells.map(|cell| cell.map(|entry| self.bound(entry)));
                let bounds = bounds.map(Option::unwrap_or_default);
                grid.row(std::iter::once(BOUND.to_owned()).chain(bounds));
            }
        }
        grid.render()
    }

    fn frame_table(&self, forces: &Forces) -> String {
        let mut grid = Grid::new(FRAME_LABELS, self.style.digits + 2);
        let heads = ["fx", "fy", "f"].map(|name| self.label(name, Aspect::Fx));
        let others = [("direction", Aspect::Angle), ("moment", Aspect::Moment)];
        let others = others.map(|(name, aspect)| self.label(name, aspect));
        let title = "on the frame".to_owned();
        grid.row(std::iter::once(title).chain(heads).chain(others));
        let frame = &forces.frame;
        self.plane(&mut grid, "shaking".to_owned(), frame.force, [frame.moment]);
        grid.render()
    }

    fn check_table(&self, forces: &Forces) -> String {
        let mut grid = Grid::new(FRAME_LABELS, self.style.digits + 2);
        let drive = forces.drive.aspect;
        let heads = [
            (drive.name(), drive),
            ("fx", Aspect::Fx),
            ("fy", Aspect::Fy),
            ("moment", Aspect::Moment),
        ];
        let heads = heads.map(|(name, aspect)| self.label(name, aspect));
        grid.row(std::iter::once("checks miss by".to_owned()).chain(heads));
        let entries = std::iter::once(forces.checks.drive).chain(forces.checks.frame);
        let cells = entries.map(|entry| missed(&entry));
        grid.row(std::iter::once(String::new()).chain(cells));
        grid.render()
    }

    /// A row of figures, and their bounds below them where they are asked for.
    fn entries(
        &self,
        grid: &mut Grid,
        label: String,
        entries: impl IntoIterator<Item = Entry>,
        aspect: Aspect,
        behind: &str,
    ) {
        let entries: Vec<Entry> = entries.into_iter().collect();
        let cells = entries.iter().map(|&e| self.figure(e, aspect) + behind);
        grid.row(std::iter::once(label).chain(cells));
        if self.style.bounds {
            let bounds = entries.iter().map(|&entry| self.bound(entry) + behind);
            grid.row(std::iter::once(BOUND.to_owned()).chain(bounds));
        }
    }

    /// A row of a force by components, size and direction, and what stands behind them.
    fn plane<const N: usize>(
        &self,
        grid: &mut Grid,
        label: String,
        force: Option<Plane>,
        others: [Entry; N],
    ) {
        let entries = force.map_or([Entry::NONE; 4], |force| force.entries(false));
        let aspects = [Aspect::Fx, Aspect::Fy, Aspect::Fx, Aspect::Angle];
        let all = entries.into_iter().zip(aspects);
        let all = all.chain(others.map(|entry| (entry, Aspect::Moment)));
        let all: Vec<(Entry, Aspect)> = all.collect();
        let cells = all
            .iter()
            .map(|&(entry, aspect)| self.figure(entry, aspect));
        grid.row(std::iter::once(label).chain(cells));
        if self.style.bounds {
            let bounds = all.iter().map(|&(entry, _)| self.bound(entry));
            grid.row(std::iter::once(BOUND.to_owned()).chain(bounds));
        }
    }
}

impl Forces {
    /// One object: every figure by its name, and what is left open.
    pub(super) fn to_json(&self, bounds: bool) -> Value {
        let mut object = Map::new();
        for (name, _, entry) in self.figures() {
            object.insert(name.clone(), number(entry.value));
            if bounds {
                object.insert(format!("{name}.bound"), number(entry.proved()));
            }
        }
        if let Some(why) = &self.withheld {
            object.insert("withheld".into(), why.clone().into());
        }
        object.insert("indeterminate".into(), self.indeterminate.clone().into());
        if let Some(least) = &self.least {
            let figures = least.figures().into_iter();
            let figures = figures.map(|(name, value)| (name, number(value)));
            object.insert("least_norm".into(), Value::Object(figures.collect()));
        }
        Value::Object(object)
    }
}
