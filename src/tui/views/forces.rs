//! Forces view: the efforts of the driver and of further inputs, the reactions of joints and guides,
//! the load on the frame, and the residuals of the checks.
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

use super::page;
use super::pane::{Copied, Pane};
use crate::page::{Cell, Head, Line, Page, Row, Setting, Table, Units};
use crate::quantity::Aspect;
use crate::report::{
    Entry, Existence, Forces, GuideRow, LeastNormReactions, PlaneVector, effort_word, missed,
    perpendicular_up,
};
use crate::solver::Order;
use crate::tui::app::{App, View};
use crate::tui::figures::copying;
use crate::tui::figures::force_figures::{ForceFigures, Formats};
use crate::tui::figures::format::Format;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::open_scene::OpenScene;
use crate::wording::words;
use crate::{Mechanism, Vec2};
use ratatui::layout::Rect;

/// The forces view: the driver's effort and the reactions of joints and guides.
pub(super) struct ForcesView;

impl Pane for ForcesView {
    fn view(&self) -> View {
        View::Forces
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let acts = app.open_scene().solver().has_forces();
        (!acts).then(|| words().nothing_acts_in_short())
    }

    fn lines(&self, app: &App, area: Rect) -> Vec<Line> {
        let mut page = Page::aligned();
        match app.views.forces.get() {
            Some(force_figures) => {
                for table in tables(force_figures) {
                    page.table(table);
                }
                for remark in force_figures.forces().remarks() {
                    page.text(remark);
                }
            }
            None => {
                for words in nothing_acts(&app.open_scene().scene().mechanism) {
                    page.text(words);
                }
            }
        }
        page::lines(app, &page, area)
    }

    /// Returns the error bound of the driver's effort.
    fn trust(&self, app: &App, _room: u16) -> Option<String> {
        let drive = &app.views.forces.get()?.forces().drive;
        drive.total.value?;
        let unit = drive.aspect.unit(app.open_scene().scene().unit.symbol());
        Some(match drive.total.bound {
            Some(bound) => format!(
                "{} +-{} {unit}",
                effort_word(drive.aspect),
                perpendicular_up(bound, 1)
            ),
            None => words().effort_without_bound(effort_word(drive.aspect)),
        })
    }

    fn copy(&self, app: &App) -> Copied {
        let force_figures = app.views.forces.get();
        force_figures.map_or(Copied::Nothing, |force_figures| {
            Copied::Text(copying::balanced(force_figures.forces()))
        })
    }
}

/// Computes the forces at the driver's position, with formats that fit the whole motion; `None` if
/// no loads act.
pub(super) fn balance(open_scene: &OpenScene) -> Option<ForceFigures> {
    let (scene, solver) = (open_scene.scene(), open_scene.solver());
    let forces = current(open_scene)?;
    let mut state = solver.state();
    let samples = open_scene.places().into_iter().filter_map(|driver_state| {
        let _ = driver_state.solve(solver, Order::Force, &mut state);
        Forces::new(scene, solver, &state, None)
    });
    let led = open_scene.led_motion().into_iter();
    let led = led.flat_map(LedMotion::states);
    let led = led.filter_map(|state| Forces::new(scene, solver, state, None));
    let samples: Vec<Forces> = samples.chain(led).collect();
    Some(ForceFigures::new(forces, &samples))
}

/// Updates the forces for another driver state.
pub(super) fn follow(force_figures: &mut ForceFigures, open_scene: &OpenScene) {
    force_figures.follow(current(open_scene));
}

fn current(open_scene: &OpenScene) -> Option<Forces> {
    let (scene, solver) = (open_scene.scene(), open_scene.solver());
    let enclosure = open_scene.enclosure();
    Forces::new(scene, solver, open_scene.state(), enclosure)
}

/// Returns the reason why there are no forces, and how to add some.
fn nothing_acts(mechanism: &Mechanism) -> [&'static str; 2] {
    let why = if mechanism.gravity() == Vec2::ZERO {
        words().nothing_acts_at_all()
    } else {
        words().gravity_without_mass()
    };
    [why, words().how_forces_come()]
}

/// Returns the tables that exist, all with the same column width.
fn tables(force_figures: &ForceFigures) -> Vec<Table> {
    let (forces, formats) = (force_figures.forces(), force_figures.formats());
    let mut tables = match forces.existence() {
        Existence::Nothing => Vec::new(),
        Existence::WithheldReason => vec![checks(forces)],
        Existence::DriveAlone => vec![driver(forces, formats)],
        Existence::Everything => {
            let mut tables = vec![driver(forces, formats), reactions(forces, formats)];
            if !forces.guides.is_empty() {
                tables.push(guides(
                    words().table_of_guides(),
                    &forces.guides,
                    forces.unit,
                    formats,
                ));
            }
            if let Some(minimum) = &forces.least {
                let joints = open_joints(minimum, formats);
                let guides = guides(words().least_norm(), &minimum.guides, forces.unit, formats);
                let minimum = [joints, guides].into_iter();
                tables.extend(minimum.filter(|table| !table.rows.is_empty()));
            }
            tables.push(checks(forces));
            tables
        }
    };
    let headers = tables.iter().flat_map(|table| &table.heads);
    let headers = headers.flat_map(|head| [&head.name, &head.unit]);
    let widest = headers.map(|text| text.chars().count()).max();
    let column = widest.unwrap_or(0).max(widest_figure(formats));
    for table in &mut tables {
        table.setting = Setting {
            least: vec![column],
            gap: 1,
            spread: 3,
            units: Units::Below,
            ..Setting::default()
        };
    }
    tables
}

/// Returns the width of the widest value format.
fn widest_figure(formats: &Formats) -> usize {
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

/// Creates a table without rows, with a title and the columns' names and units.
fn table<const N: usize>(title: &str, headers: [(&str, &str); N]) -> Table {
    let head = |(name, unit): (&str, &str)| Head {
        name: name.to_owned(),
        unit: unit.to_owned(),
    };
    Table {
        title: title.to_owned(),
        heads: headers.map(head).into(),
        ..Table::default()
    }
}

fn row(name: String, more: Option<String>, cells: Vec<Option<Cell>>) -> Row {
    Row::Figures {
        mark: String::new(),
        name,
        more,
        cells,
    }
}

fn driver(forces: &Forces, formats: &Formats) -> Table {
    let drive = &forces.drive;
    let unit = drive.aspect.unit(forces.unit);
    let entries = std::iter::once(drive.total).chain(drive.parts);
    let cells = entries.map(|entry| Some(formats.effort.write(&entry)));
    let power = formats.power.write(&drive.power);
    let mut table = table(
        words().driver(),
        [
            (effort_word(drive.aspect), &unit),
            (words().loads(), &unit),
            (words().gravity(), &unit),
            (words().inertia(), &unit),
            (words().power(), "W"),
        ],
    );
    table.rows = vec![row(
        drive.name.clone(),
        None,
        cells.chain([Some(power)]).collect(),
    )];
    // The effort of every input, with its unit where it differs from the driver's. With all others
    // held, the driver's own effort is the total.
    for (name, aspect, effort) in &drive.own {
        if *name == drive.name && effort.value == drive.total.value {
            continue;
        }
        let own = aspect.unit(forces.unit);
        let name = match own == unit {
            true => name.clone(),
            false => format!("{name} {own}"),
        };
        let effort = formats.effort.write(effort);
        table.rows.push(row(name, None, vec![Some(effort)]));
    }
    table
}

/// Returns the table of joint reactions, with the load on the frame in its last row.
fn reactions(forces: &Forces, formats: &Formats) -> Table {
    let joints = forces.joints.iter().filter(|joint| !joint.repeats);
    let joints = joints.map(|joint| {
        let name = words().link_at_point(&joint.link, &joint.point);
        let by = joint.by.as_ref();
        let more = by.map(|by| words().pin_by(&joint.link, &joint.point, &words().body_called(by)));
        row(name, more, plane(joint.force, formats.force, None))
    });
    let frame = &forces.frame;
    let moment = Some(formats.moment.write(&frame.moment));
    let frame = plane(frame.force, formats.force, moment);
    let ground = row(
        words().ground().into(),
        Some(words().ground_by_all().into()),
        frame,
    );
    let mut table = table(
        words().force_on(),
        [
            ("fx", "N"),
            ("fy", "N"),
            ("f", "N"),
            (words().direction_of_force(), "deg"),
            (words().moment(), "N m"),
        ],
    );
    table.rows = joints.chain([ground]).collect();
    table
}

fn plane(force: Option<PlaneVector>, format: Format, moment: Option<Cell>) -> Vec<Option<Cell>> {
    let entries = force.map_or([Entry::NONE; 4], |force| force.entries(false));
    let [x, y, size, direction] = entries;
    let figures = [x, y, size].map(|entry| Some(format.write(&entry)));
    let direction = Some(Format::ANGLE.write_angle(&direction));
    figures.into_iter().chain([direction, moment]).collect()
}

/// Returns the joint reactions that the equilibrium does not determine, in their least-norm
/// solution.
fn open_joints(minimum: &LeastNormReactions, formats: &Formats) -> Table {
    let joints = minimum.joints.iter().filter(|joint| !joint.repeats);
    let joints = joints.map(|joint| {
        let name = words().link_at_point(&joint.link, &joint.point);
        row(name, None, plane(joint.force, formats.force, None))
    });
    let mut table = table(
        words().least_norm(),
        [
            ("fx", "N"),
            ("fy", "N"),
            ("f", "N"),
            (words().direction_of_force(), "deg"),
        ],
    );
    table.rows = joints.collect();
    table
}

fn guides(title: &str, guides: &[GuideRow], unit: &'static str, formats: &Formats) -> Table {
    let rows = guides.iter().map(|guide| {
        let more = words().guide_on(&guide.name, &guide.slider);
        let cells = vec![
            Some(formats.force.write(&guide.normal)),
            guide.at.map(|at| formats.arm.write(&at)),
            guide.moment.map(|moment| formats.moment.write(&moment)),
        ];
        row(guide.name.clone(), Some(more), cells)
    });
    let mut table = table(
        title,
        [
            (words().normal(), "N"),
            (words().at(), unit),
            (words().moment(), "N m"),
        ],
    );
    table.rows = rows.collect();
    table
}

fn checks(forces: &Forces) -> Table {
    let drive = forces.drive.aspect;
    let checks = &forces.checks;
    let entries = std::iter::once(checks.drive).chain(checks.frame);
    let cells = entries.map(|entry| Some(Cell::proved(missed(&entry))));
    let mut table = table(
        words().table_of_checks(),
        [
            (effort_word(drive), &drive.unit(forces.unit)),
            ("fx", &Aspect::Fx.unit(forces.unit)),
            ("fy", &Aspect::Fy.unit(forces.unit)),
            (words().moment(), &Aspect::Moment.unit(forces.unit)),
        ],
    );
    table.rows = vec![row(words().off_by().into(), None, cells.collect())];
    table
}
