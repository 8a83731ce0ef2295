//! What the driver must do, what joints and guides bear, what the frame feels, and how far the checks
//! miss.
//!
//! ```text
//! driver               torque      loads    gravity    inertia      power
//!                         N m        N m        N m        N m          W
//! r2                 -6.44714   -7.30178    0.05773    0.79691   -96.7071
//!
//! force on                 fx         fy          f      dir f     moment
//!                           N          N          N        deg        N m
//! r2 at A by ground   110.758    87.4215    141.103     38.284
//! ```

use super::pane::{Copied, Need, Pane};
use super::table::{columns_of, doubt};
use super::{Sketch, columns, cut, first_seen, inset, print, print_right};
use crate::quantity::Aspect;
use crate::report::{Entry, Existence, Forces, GuideRow, Least, Plane, missed, upwards, wrapped};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, Part};
use crate::tui::figures::copying;
use crate::tui::figures::flow_table::{Block, Columns, Line, Row};
use crate::tui::figures::force_figures::{ForceFigures, Formats};
use crate::tui::figures::format::{Format, Written};
use crate::tui::figures::sheet::Shown;
use crate::tui::player::open_scene::shown;
use crate::{Mechanism, Vec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// What the driver must do, and what joints and guides bear.
pub(super) struct ForcesView;

impl Pane for ForcesView {
    fn name(&self) -> &'static str {
        "forces"
    }

    fn about(&self) -> &'static str {
        "What the driver must do, and what joints and guides bear"
    }

    fn help_title(&self) -> &'static str {
        "In the forces view"
    }

    fn needs(&self) -> Need {
        Need::Forces
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let area = inset(body);
        let (placed, lines) = lines(app, area);
        let first = first_seen(app, lines.len(), area, buffer);
        for (y, line) in (area.top()..area.bottom()).zip(lines.iter().skip(first)) {
            let height = 1;
            render_line(app, &placed, line, Rect { y, height, ..area }, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let area = inset(body);
        (lines(app, area).1.len(), area.height.into())
    }

    /// How far what the driver must do can be from the truth.
    fn trust(&self, app: &App, _room: u16) -> Option<String> {
        let drive = &app.open_scene().force_figures()?.forces().drive;
        drive.total.value?;
        let unit = drive.aspect.unit(app.open_scene().scene().unit.symbol());
        Some(match drive.total.bound {
            Some(bound) => format!("{} +-{} {unit}", drive.aspect.name(), upwards(bound, 1)),
            None => format!("{}: no bound", drive.aspect.name()),
        })
    }

    fn copy(&self, app: &App) -> Copied {
        let force_figures = app.open_scene().force_figures();
        force_figures.map_or(Copied::Nothing, |force_figures| {
            Copied::Text(copying::balanced(force_figures.forces()))
        })
    }
}

fn lines(app: &App, area: Rect) -> (Columns, Vec<Line>) {
    let width = area.width.into();
    let Some(force_figures) = app.open_scene().force_figures() else {
        let words = nothing_acts(&app.open_scene().scene().mechanism);
        let words = words.iter().flat_map(|text| sentence(text, width));
        return (Columns::fitting(&[], 0, width), words.collect());
    };
    let blocks = blocks(force_figures);
    let placed = Columns::fitting(&blocks, widest(force_figures.formats()), width);
    let mut lines = placed.lines(&blocks);
    for remark in force_figures.forces().remarks() {
        if !lines.is_empty() {
            lines.push(Line::Blank);
        }
        lines.extend(sentence(&remark, width));
    }
    (placed, lines)
}

/// A sentence over as many lines as it needs.
fn sentence(text: &str, width: usize) -> Vec<Line> {
    if text.is_empty() {
        return vec![Line::Blank];
    }
    wrapped(text, width).into_iter().map(Line::Words).collect()
}

/// Why there is nothing to show, and what would change that.
fn nothing_acts(mechanism: &Mechanism) -> [&'static str; 3] {
    let why = if mechanism.gravity() == Vec2::ZERO {
        "Nothing acts on this linkage: the scene has no loads, no springs and no masses."
    } else {
        "Nothing acts on this linkage: the scene has gravity, but no link has a mass."
    };
    let mend = "Give a link its mass and com, or add [[loads]] or [[springs]] to the file: then this \
                view shows what the driver must do and what every joint bears.";
    [why, "", mend]
}

/// What exists, block by block.
fn blocks(force_figures: &ForceFigures) -> Vec<Block> {
    let (forces, formats) = (force_figures.forces(), force_figures.formats());
    match forces.existence() {
        Existence::Nothing => Vec::new(),
        Existence::Withheld => vec![checks(forces)],
        Existence::DriveAlone => vec![driver(forces, formats)],
        Existence::Everything => {
            let mut blocks = vec![driver(forces, formats), reactions(forces, formats)];
            if !forces.guides.is_empty() {
                blocks.push(guides("guide", &forces.guides, forces.unit, formats));
            }
            if let Some(least) = &forces.least {
                let joints = open_joints(least, formats);
                let guides = guides("least norm", &least.guides, forces.unit, formats);
                blocks.extend(
                    [joints, guides]
                        .into_iter()
                        .filter(|block| !block.rows.is_empty()),
                );
            }
            blocks.push(checks(forces));
            blocks
        }
    }
}

/// The widest of all figures.
fn widest(formats: &Formats) -> usize {
    let Formats {
        effort,
        power,
        force,
        moment,
        arm,
    } = formats;
    let all = [effort, power, force, moment, arm, &Format::ANGLE];
    all.into_iter()
        .map(|format| format.width())
        .max()
        .unwrap_or(0)
}

/// Names of columns with their units.
fn heads<const N: usize>(heads: [(&'static str, &str); N]) -> Vec<(&'static str, String)> {
    heads.map(|(name, unit)| (name, unit.to_owned())).into()
}

fn row(name: String, more: Option<String>, cells: Vec<Option<Written>>) -> Row {
    Row {
        more: more.unwrap_or_else(|| name.clone()),
        name,
        cells,
    }
}

fn driver(forces: &Forces, formats: &Formats) -> Block {
    let drive = &forces.drive;
    let unit = drive.aspect.unit(forces.unit);
    let entries = std::iter::once(drive.total).chain(drive.parts);
    let cells = entries.map(|entry| Some(formats.effort.write(&entry)));
    let power = formats.power.write(&drive.power);
    Block {
        title: "driver",
        heads: heads([
            (drive.aspect.name(), &unit),
            ("loads", &unit),
            ("gravity", &unit),
            ("inertia", &unit),
            ("power", "W"),
        ]),
        rows: vec![row(
            drive.name.clone(),
            None,
            cells.chain([Some(power)]).collect(),
        )],
    }
}

/// What links bear at joints, and below them what the frame feels.
fn reactions(forces: &Forces, formats: &Formats) -> Block {
    let joints = forces.joints.iter().filter(|joint| !joint.repeats);
    let joints = joints.map(|joint| {
        let name = format!("{} at {}", joint.link, joint.point);
        let more = joint.by.as_ref().map(|by| format!("{name} by {by}"));
        row(name, more, plane(joint.force, formats.force, None))
    });
    let frame = &forces.frame;
    let moment = Some(formats.moment.write(&frame.moment));
    let frame = plane(frame.force, formats.force, moment);
    let ground = row("ground".into(), Some("ground by all".into()), frame);
    Block {
        title: "force on",
        heads: heads([
            ("fx", "N"),
            ("fy", "N"),
            ("f", "N"),
            ("dir f", "deg"),
            ("moment", "N m"),
        ]),
        rows: joints.chain([ground]).collect(),
    }
}

fn plane(force: Option<Plane>, format: Format, moment: Option<Written>) -> Vec<Option<Written>> {
    let entries = force.map_or([Entry::NONE; 4], |force| force.entries(false));
    let [x, y, size, direction] = entries;
    let figures = [x, y, size].map(|entry| Some(format.write(&entry)));
    let direction = Some(Format::ANGLE.write_angle(&direction));
    figures.into_iter().chain([direction, moment]).collect()
}

/// What joints would bear that the equilibrium leaves open.
fn open_joints(least: &Least, formats: &Formats) -> Block {
    let joints = least.joints.iter().filter(|joint| !joint.repeats);
    let joints = joints.map(|joint| {
        let name = format!("{} at {}", joint.link, joint.point);
        row(name, None, plane(joint.force, formats.force, None))
    });
    Block {
        title: "least norm",
        heads: heads([("fx", "N"), ("fy", "N"), ("f", "N"), ("dir f", "deg")]),
        rows: joints.collect(),
    }
}

fn guides(
    title: &'static str,
    guides: &[GuideRow],
    unit: &'static str,
    formats: &Formats,
) -> Block {
    let rows = guides.iter().map(|guide| {
        let more = format!("{} on {}", guide.name, guide.slider);
        let cells = vec![
            Some(formats.force.write(&guide.normal)),
            guide.at.map(|at| formats.arm.write(&at)),
            guide.moment.map(|moment| formats.moment.write(&moment)),
        ];
        row(guide.name.clone(), Some(more), cells)
    });
    Block {
        title,
        heads: heads([("normal", "N"), ("at", unit), ("moment", "N m")]),
        rows: rows.collect(),
    }
}

fn checks(forces: &Forces) -> Block {
    let drive = forces.drive.aspect;
    let checks = &forces.checks;
    let entries = std::iter::once(checks.drive).chain(checks.frame);
    let cells = entries.map(|entry| Some(Written::sure(missed(&entry))));
    Block {
        title: "check",
        heads: heads([
            (drive.name(), &drive.unit(forces.unit)),
            ("fx", &Aspect::Fx.unit(forces.unit)),
            ("fy", &Aspect::Fy.unit(forces.unit)),
            ("moment", &Aspect::Moment.unit(forces.unit)),
        ]),
        rows: vec![row("off by".into(), None, cells.collect())],
    }
}

fn render_line(app: &App, placed: &Columns, line: &Line, area: Rect, buffer: &mut Buffer) {
    let (name, cells, of_name, of_cells) = match line {
        Line::Blank => return,
        Line::Words(text) => {
            let style = theme::part(Part::Text);
            print(buffer, area.x, area.y, area.width, text, style);
            return;
        }
        Line::Head(name, cells) => (name, cells, Part::Quiet, Part::Quiet),
        Line::Row(name, cells) => (name, cells, Part::Name, Part::Text),
    };
    let name = cut(&shown(name, app.glyphs()), placed.names);
    print(
        buffer,
        area.x,
        area.y,
        area.width,
        &name,
        theme::part(of_name),
    );
    let mut right = area.x.saturating_add(columns_of(placed.names));
    for cell in cells {
        right = right.saturating_add(columns_of(placed.figure));
        if right > area.right() {
            break;
        }
        print_right(buffer, right, area.y, &cell.text, theme::part(of_cells));
        let left = right.saturating_sub(columns(&cell.text));
        let cell = Shown {
            text: cell.text.clone(),
            width: placed.figure,
            unsure: cell.unsure.clone(),
        };
        doubt(app.colours(), &cell, left, area.y, buffer);
    }
}
