//! What the line tells, part by part.

use crate::report::upwards;
use crate::solver::Condition;
use crate::tui::Origin;
use crate::tui::ahead::ahead;
use crate::tui::app::{App, Mode, Unsaved, View};
use crate::tui::figures::coordinate;
use crate::tui::picker::Purpose;
use crate::tui::stage::{Stage, shown};
use crate::tui::survey::Phase;
use crate::tui::theme::Part;
use crate::tui::views::columns;
use crate::tui::writing::{Document, Prompt, Question};

/// More turns than this are told with an exponent.
const MANY_TURNS: f64 = 1e7;

pub(super) fn mode(app: &App) -> &'static str {
    match (app.mode(), app.view()) {
        (Mode::Help(_), _) => "help",
        (Mode::Tour(_), _) => "tour",
        (Mode::GoTo(_), _) => "go to",
        (Mode::Assemblies(_) | Mode::PlotList(_), _) => "choose",
        (Mode::FileName(Prompt { document, .. }), _)
        | (Mode::Confirm(Question { document, .. }), _) => match document {
            Document::Scene => "save",
            Document::Text(_) => "write",
        },
        (Mode::Pick(picker), _) => match picker.purpose() {
            Purpose::Open => "open",
            Purpose::Compare => "compare",
        },
        (Mode::Search(_), _) => "search",
        (Mode::Copy, _) => "copy",
        (Mode::Unsaved(asked), _) => match asked {
            Unsaved::Quit => "quit",
            Unsaved::Open => "open",
            Unsaved::Reload => "reload",
        },
        (Mode::Recovery(_), _) => "recover",
        (Mode::Value(_), _) => "edit",
        (Mode::Normal, View::Motion) => "motion",
        (Mode::Normal, View::Tables) => "tables",
        (Mode::Normal, View::Accuracy) => "accuracy",
        (Mode::Normal, View::Lengths) => "lengths",
        (Mode::Normal, View::Working) => "working",
        (Mode::Normal, View::Motor) => "motor",
        (Mode::Normal, View::Plots) => "plots",
        (Mode::Normal, View::Forces) => "forces",
        (Mode::Normal, View::Scene) => "scene",
    }
}

pub(super) fn scene(app: &App) -> String {
    let name = match app.stage().origin() {
        Origin::Preset(name) => name.clone(),
        Origin::File(path) => {
            let name = path.file_name().unwrap_or(path.as_os_str());
            name.to_string_lossy().into_owned()
        }
        Origin::Stdin => "stdin".into(),
    };
    let mark = if app.is_changed() { "*" } else { "" };
    shown(&name, app.glyphs()) + mark
}

/// The driver's coordinate: an angle within a turn, and the turns.
pub(super) fn driver(stage: &Stage) -> String {
    let (at, unit) = (stage.at(), stage.unit());
    let course = stage.course();
    if !course.turns() || course.shuttle().is_some() {
        let text = coordinate(at, course.decimals());
        return format!("{text:>7} {unit}");
    }
    let turns = (at / crate::angle::TURN).floor();
    // Subtracting whole turns from a decimal leaves digits that nobody asked for.
    let within = crate::tui::course::rounded(at - turns * crate::angle::TURN, 9);
    let text = coordinate(within, course.decimals());
    if turns == 0.0 {
        format!("{text:>6} {unit}")
    } else {
        let plural = if turns.abs() == 1.0 { "" } else { "s" };
        let turns = if turns.abs() < MANY_TURNS {
            format!("{turns:+}")
        } else {
            format!("{turns:+.3e}")
        };
        format!("{text:>6} {unit} {turns} turn{plural}")
    }
}

/// How far the study has come, in the view that shows it: there, the driver is of no interest.
pub(super) fn studied(app: &App) -> Option<String> {
    let survey = app.survey();
    let percent = (survey.progress() * 100.0).floor();
    match survey.phase() {
        _ if app.view() != View::Accuracy || *app.mode() != Mode::Normal => None,
        Phase::Idle => None,
        Phase::Running => Some(format!("measuring {percent:>2} %")),
        Phase::Stopped => Some(format!("stopped at {percent} %")),
        Phase::Done => Some("all measured".into()),
    }
}

/// In one word, and with what follows from it where there is room.
pub(super) fn state(condition: Condition, narrow: bool) -> (&'static str, Part) {
    match condition {
        Condition::Ok => ("ok", Part::Text),
        Condition::ChangePoint => ("change point", Part::Warning),
        Condition::DeadPoint if narrow => ("dead point", Part::Warning),
        Condition::DeadPoint => ("dead point: no rates", Part::Warning),
        Condition::NoAssembly if narrow => ("no assembly", Part::Warning),
        Condition::NoAssembly => ("no assembly here", Part::Warning),
    }
}

/// Whether there is anything in the motion that the driver can come near to.
pub(super) fn can_come_near(app: &App) -> bool {
    let stage = app.stage();
    stage.course().shuttle().is_some() || !stage.solver().motion().change_points.is_empty()
}

/// What lies ahead of the driver, where figures exist and something is near.
pub(super) fn near(app: &App) -> Option<String> {
    let stage = app.stage();
    if app.condition() != Condition::Ok {
        return None;
    }
    let backwards = app.playback().is_backwards();
    let motion = stage.solver().motion();
    let ahead = ahead(stage.course(), motion, stage.at(), backwards)?;
    Some(ahead.text(stage.course(), stage.unit()))
}

/// What the last state cost, where that was measured and there is room for it, and how far a place in it
/// can be from the truth. Not beside what the lengths do: that is another kind of error.
pub(super) fn trust(app: &App, room: u16) -> Option<String> {
    let stage = app.stage();
    let shows_figures = match (app.mode(), app.view()) {
        (Mode::Normal, View::Motion | View::Tables | View::Forces) => true,
        (
            Mode::Normal,
            View::Plots
            | View::Accuracy
            | View::Scene
            | View::Lengths
            | View::Working
            | View::Motor,
        )
        | (
            Mode::Help(_)
            | Mode::Tour(_)
            | Mode::GoTo(_)
            | Mode::Assemblies(_)
            | Mode::PlotList(_)
            | Mode::FileName(_)
            | Mode::Value(_)
            | Mode::Confirm(_)
            | Mode::Unsaved(_)
            | Mode::Recovery(_)
            | Mode::Pick(_)
            | Mode::Search(_)
            | Mode::Copy,
            _,
        ) => false,
    };
    if !shows_figures || app.condition() != Condition::Ok {
        return None;
    }
    match app.view() {
        View::Tables => return of_cursor(app),
        View::Forces => return of_drive(app),
        View::Motion
        | View::Plots
        | View::Accuracy
        | View::Scene
        | View::Lengths
        | View::Working
        | View::Motor => {}
    }
    let bound = match stage.largest_bound() {
        Some(bound) => format!("+-{} {}", upwards(bound, 1), stage.scene().unit.symbol()),
        None => "no bound".into(),
    };
    let both = stage.cost().map(|cost| format!("{cost}, {bound}"));
    Some(both.filter(|both| columns(both) <= room).unwrap_or(bound))
}

/// How far what the driver must do can be from the truth.
fn of_drive(app: &App) -> Option<String> {
    let drive = &app.stage().balance()?.forces().drive;
    drive.total.value?;
    let unit = drive.aspect.unit(app.stage().scene().unit.symbol());
    Some(match drive.total.bound {
        Some(bound) => format!("{} +-{} {unit}", drive.aspect.name(), upwards(bound, 1)),
        None => format!("{}: no bound", drive.aspect.name()),
    })
}

/// How far the figure under the cursor can be from the truth.
fn of_cursor(app: &App) -> Option<String> {
    let (sheet, tables, cursor) = (app.sheet(), app.tables(), app.cursor());
    let entries = sheet.entries(tables, cursor.part, cursor.row);
    let entry = entries.get(cursor.column).copied().flatten()?;
    let unit = sheet.unit(cursor.part, cursor.column)?;
    entry.value?;
    Some(match entry.bound {
        _ if entry.given => "given".into(),
        Some(bound) => format!("+-{} {unit}", upwards(bound, 1)),
        None => "no bound".into(),
    })
}
