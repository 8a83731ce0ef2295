//! Formats the forces as text and for other programs.

use crate::page::{Page, Setting, Table};
use crate::quantity::Aspect;
use crate::report::forces::{Existence, Forces, GuideRow, JointRow, effort_word};
use crate::report::tables::data::{insert, number};
use crate::report::tables::entry::{Entry, PlaneVector};
use crate::report::tables::page::{
    BOUND, TablesWriter, VECTOR_LABELS, point_labels, set, shown_bound,
};
use crate::report::text::number::significant;
use crate::wording::words;
use serde_json::{Map, Value};

/// Width of the labels of the frame's table besides its title: it has one column more than other
/// tables.
const FRAME_LABELS: usize = 6;
/// Significant digits of a residual.
const MISSED: usize = 2;

/// Formats the residual of a check.
pub(crate) fn missed(entry: &Entry) -> String {
    let text = entry.value.map(|value| significant(value, MISSED));
    text.unwrap_or_else(|| "-".into())
}

impl TablesWriter<'_> {
    /// Adds a table for each available part, and remarks on the rest.
    pub(in crate::report) fn add_forces(&self, forces: &Forces, page: &mut Page) {
        let mut tables = Vec::new();
        match forces.existence() {
            Existence::Nothing => {}
            Existence::WithheldReason => tables.push(self.check_table(forces)),
            Existence::DriveAlone => tables.push(self.drive_table(forces)),
            Existence::Everything => {
                tables.push(self.drive_table(forces));
                tables.extend(self.joint_table(words().force_at_joints(), &forces.joints));
                tables.extend(self.guide_table(words().force_of_guides(), &forces.guides));
                if let Some(minimum) = &forces.least {
                    tables.extend(self.joint_table(words().of_least_norm(), &minimum.joints));
                    tables.extend(self.guide_table(words().of_least_norm(), &minimum.guides));
                }
                tables.push(self.frame_table(forces));
                tables.push(self.check_table(forces));
            }
        }
        tables.into_iter().for_each(|table| page.table(table));
        let mut remarks = forces.remarks().into_iter();
        if let Some(first) = remarks.next() {
            page.text(first);
        }
        remarks.for_each(|remark| page.text_below(remark));
    }

    fn drive_table(&self, forces: &Forces) -> Table {
        let drive = &forces.drive;
        let headers = [
            words().in_all(),
            words().loads(),
            words().gravity(),
            words().inertia(),
        ];
        let title = words().driver_named(&drive.name);
        let setting = set(VECTOR_LABELS, self.style.digits + 3);
        let mut table = Table::new(title, headers.map(|head| format!("{head} "))).set(setting);
        let entries = || std::iter::once(drive.total).chain(drive.parts);
        let label = self.label(effort_word(drive.aspect), drive.aspect);
        self.entries(&mut table, label, entries(), drive.aspect, " ");
        for (name, aspect, entry) in &drive.own {
            let label = self.label(name, *aspect);
            self.entries(&mut table, label, [*entry], *aspect, " ");
        }
        let label = self.label(words().power(), Aspect::Power);
        self.entries(&mut table, label, [drive.power], Aspect::Power, " ");
        table
    }

    /// Returns the table of joints; `None` if there is no joint to list.
    fn joint_table(&self, title: &str, joints: &[JointRow]) -> Option<Table> {
        let headers = ["fx", "fy", "f"].map(|name| self.label(name, Aspect::Fx));
        let headers = headers.into_iter().chain([self.direction()]);
        let mut table = Table::new(title, headers).set(set(point_labels(), self.style.digits + 2));
        for joint in joints.iter().filter(|joint| !joint.repeats) {
            let name = match &joint.by {
                Some(by) => {
                    let by = words().body_called(by);
                    words().link_at_point_by(&joint.link, &joint.point, &by)
                }
                None => words().link_at_point(&joint.link, &joint.point),
            };
            self.plane(&mut table, name, joint.force, []);
        }
        (!table.rows.is_empty()).then_some(table)
    }

    /// Returns the table of guides; `None` if there is no guide.
    fn guide_table(&self, title: &str, guides: &[GuideRow]) -> Option<Table> {
        let headers = [
            (words().normal(), Aspect::Normal),
            (words().at(), Aspect::Length),
            (words().moment(), Aspect::Moment),
        ];
        let headers = headers.map(|(name, aspect)| self.label(name, aspect));
        let mut table = Table::new(title, headers).set(set(point_labels(), self.style.digits + 2));
        for guide in guides {
            let name = words().guide_on(&guide.name, &guide.slider);
            let cells = [Some(guide.normal), guide.at, guide.moment];
            let texts = cells.map(|cell| cell.map(|entry| self.figure(entry, Aspect::Normal)));
            table.row(name, texts.map(Option::unwrap_or_default));
            if self.style.bounds {
                let bounds = cells.map(|cell| cell.map(shown_bound));
                table.row(BOUND, bounds.map(Option::unwrap_or_default));
            }
        }
        (!table.rows.is_empty()).then_some(table)
    }

    fn frame_table(&self, forces: &Forces) -> Table {
        let headers = ["fx", "fy", "f"].map(|name| self.label(name, Aspect::Fx));
        let others = [
            self.direction(),
            self.label(words().moment(), Aspect::Moment),
        ];
        let headers = headers.into_iter().chain(others);
        let mut table = Table::new(words().on_the_frame(), headers).set(self.of_frame());
        let frame = &forces.frame;
        let moment = [frame.moment];
        self.plane(
            &mut table,
            words().shaking().to_owned(),
            frame.force,
            moment,
        );
        table
    }

    fn check_table(&self, forces: &Forces) -> Table {
        let drive = forces.drive.aspect;
        let headers = [
            (effort_word(drive), drive),
            ("fx", Aspect::Fx),
            ("fy", Aspect::Fy),
            (words().moment(), Aspect::Moment),
        ];
        let headers = headers.map(|(name, aspect)| self.label(name, aspect));
        let mut table = Table::new(words().checks_miss_by(), headers).set(self.of_frame());
        let entries = std::iter::once(forces.checks.drive).chain(forces.checks.frame);
        table.row("", entries.map(|entry| missed(&entry)));
        table
    }

    /// Returns the layout of the frame's tables.
    fn of_frame(&self) -> Setting {
        let labels = words().on_the_frame().chars().count() + FRAME_LABELS;
        set(labels, self.style.digits + 2)
    }

    /// Adds a row of values, followed by a row of bounds if requested.
    fn entries(
        &self,
        table: &mut Table,
        label: String,
        entries: impl IntoIterator<Item = Entry>,
        aspect: Aspect,
        after: &str,
    ) {
        let entries: Vec<Entry> = entries.into_iter().collect();
        let cells = entries.iter().map(|&e| self.figure(e, aspect) + after);
        table.row(label, cells);
        if self.style.bounds {
            let bounds = entries.iter().map(|&entry| shown_bound(entry) + after);
            table.row(BOUND, bounds);
        }
    }

    /// Adds a row of a force by components, magnitude and direction, followed by other values.
    fn plane<const N: usize>(
        &self,
        table: &mut Table,
        label: String,
        force: Option<PlaneVector>,
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
        table.row(label, cells);
        if self.style.bounds {
            let bounds = all.iter().map(|&(entry, _)| shown_bound(entry));
            table.row(BOUND, bounds);
        }
    }
}

impl Forces {
    /// Returns one object: every value by its name, and the indeterminate reactions.
    pub(in crate::report) fn to_json(&self, bounds: bool) -> Value {
        let mut object = Map::new();
        for (name, _, entry) in self.figures() {
            insert(&mut object, &name, &entry, bounds);
        }
        if let Some(why) = &self.withheld {
            object.insert("withheld".into(), why.clone().into());
        }
        object.insert("indeterminate".into(), self.indeterminate.clone().into());
        if let Some(minimum) = &self.least {
            let figures = minimum.figures().into_iter();
            let figures = figures.map(|(name, value)| (name, number(value)));
            object.insert("least_norm".into(), Value::Object(figures.collect()));
        }
        Value::Object(object)
    }
}
