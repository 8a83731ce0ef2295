//! The facts of the status line.

use crate::Input;
use crate::angle;
use crate::report::fixed;
use crate::report::{singularity_text, stop_name};
use crate::solver::Condition;
use crate::tui::Origin;
use crate::tui::app::{App, Mode, Unsaved};
use crate::tui::appearance::theme::ScreenPart;
use crate::tui::commands::action::{Action, entry_of};
use crate::tui::document::writing::{Prompt, Question, SavedContent};
use crate::tui::figures::format::{coordinate, rounded};
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::next_singularity::ahead;
use crate::tui::player::open_scene::{OpenScene, shown};
use crate::tui::views::scene_picker::list::Purpose;
use crate::wording::words;

/// Minimum width of a screen whose status line shows the inputs that follow a point.
const MIN_WIDTH_OF_INPUTS: u16 = 80;

/// Numbers of turns from here on are shown with an exponent.
const MANY_TURNS: f64 = 1e7;

pub(in crate::tui::views) fn mode(app: &App) -> &'static str {
    match app.mode() {
        Mode::Help(_) => words().help(),
        Mode::Tour(_) => words().tour(),
        Mode::GoTo(_) => words().go_to(),
        Mode::Guess(_) => words().guess(),
        Mode::Goal(_) | Mode::GoalRun(_) => words().goal(),
        Mode::Palette(_) => words().commands(),
        Mode::Assemblies(_) | Mode::PlotList(_) => words().choosing(),
        Mode::FileName(Prompt { content, .. }) | Mode::Confirm(Question { content, .. }) => {
            match content {
                SavedContent::Scene => words().save(),
                SavedContent::Text(_) => words().writing(),
            }
        }
        Mode::AssemblyChoice(picker) => match picker.purpose() {
            Purpose::Open => words().open(),
            Purpose::Compare => words().compare(),
        },
        Mode::Candidates => words().linkages(),
        Mode::Search(_) => words().search(),
        Mode::Copy => words().copy(),
        Mode::Unsaved(requested) => match requested {
            Unsaved::Quit => words().quit(),
            Unsaved::Open => words().open(),
            Unsaved::Reload => words().reload(),
        },
        Mode::Recovery(_) => words().recovering(),
        Mode::Value(_) => words().edit(),
        Mode::Normal => (entry_of(Action::Look(app.view())).hint)(words()),
    }
}

/// Returns the name of the scene, with `*` for unsaved edits and `!` for a file with other contents.
pub(super) fn scene(app: &App) -> String {
    let name = match app.open_scene().origin() {
        Origin::Preset(name) | Origin::New(name) => name.clone(),
        Origin::File(path) => {
            let name = path.file_name().unwrap_or(path.as_os_str());
            name.to_string_lossy().into_owned()
        }
        Origin::Stdin => "stdin".into(),
    };
    let edited = if app.is_unsaved() { "*" } else { "" };
    let other = if app.editor().is_file_other { "!" } else { "" };
    format!("{}{edited}{other}", shown(&name, app.glyphs()))
}

/// Returns the driver coordinate: an angle within one turn, and the number of whole turns.
pub(super) fn driver(open_scene: &OpenScene) -> String {
    let (at, unit) = (open_scene.at(), open_scene.unit());
    let driver_range = open_scene.driver_range();
    let decimals = driver_range.decimals();
    let shortest = |at: f64| match open_scene.time() {
        // A coordinate computed from a time may have any number of digits.
        Some(_) => coordinate(rounded(at, decimals), decimals),
        None => coordinate(at, decimals),
    };
    if !driver_range.turns() || driver_range.shuttle().is_some() {
        let text = shortest(at);
        return format!("{text:>7} {unit}");
    }
    // The remainder is exact, but that of a decimal number has rounding noise in its last digits.
    let within = angle::wrapped(at);
    let turns = ((at - within) / angle::TURN).round();
    let within = rounded(within, 9);
    let text = shortest(within);
    if turns == 0.0 {
        format!("{text:>6} {unit}")
    } else {
        let is_one = turns.abs() == 1.0;
        let turns = if turns.abs() < MANY_TURNS {
            format!("{turns:+}")
        } else {
            format!("{turns:+.3e}")
        };
        format!("{text:>6} {unit} {}", words().whole_turns(&turns, is_one))
    }
}

/// Returns the coordinate of the selected input: that of a held input, or the driver's with the
/// time of a motion over time; if the view's rates ignore that motion, with the driver's speed
/// instead.
pub(super) fn driver_in_time(app: &App) -> String {
    let open_scene = app.open_scene();
    if let Some(input) = app.selected_input() {
        return shown(&input, app.glyphs()).into_owned();
    }
    if let Some(led) = open_scene.led() {
        return led_in_time(app, led);
    }
    let driver = driver(open_scene);
    let Some(timetable) = open_scene.timetable() else {
        return driver;
    };
    let time = open_scene
        .time()
        .filter(|_| app.view().pane_in(app).is_timed(app));
    let when = match time {
        Some(time) => words().time_of_motion(&timetable.text(time)),
        None => words().at_driver_speed(match open_scene.driver_range().turns() {
            true => "rad",
            false => open_scene.unit(),
        }),
    };
    format!("{driver}  {when}")
}

/// Returns the time of a leading point, and the inputs that follow if the screen is wide enough.
fn led_in_time(app: &App, led: &LedMotion) -> String {
    let time = words().time_of_motion(&led.text(led.time()));
    if app.size().width < MIN_WIDTH_OF_INPUTS {
        return time;
    }
    let scene = app.open_scene().scene();
    let inputs = scene.mechanism.inputs().zip(led.inputs()).enumerate();
    let inputs = inputs.filter(|(index, _)| led.lead().inputs.contains(index));
    let inputs = inputs.map(|(_, (input, at))| {
        let (decimals, unit) = match input {
            Input::Turn(_) => (2, "deg"),
            Input::Push(_) => (4, scene.unit.symbol()),
        };
        let name = shown(scene.input_name(input), app.glyphs());
        format!("  {name} {} {unit}", fixed(rounded(at, decimals), decimals))
    });
    inputs.fold(time, |all, one| all + &one)
}

/// Returns the progress of the view's work, which then replaces the driver.
pub(super) fn progress(app: &App) -> Option<String> {
    let is_normal = app.mode().is_normal();
    is_normal
        .then(|| app.view().pane_in(app).progress(app))
        .flatten()
}

/// Returns the state in one word, or with its consequences if the line is not `narrow`.
pub(in crate::tui::views) fn state(
    condition: Condition,
    narrow: bool,
) -> (&'static str, ScreenPart) {
    match condition {
        Condition::Ok => (words().ok(), ScreenPart::Text),
        Condition::ChangePoint => (words().change_point(), ScreenPart::Warning),
        Condition::DeadPoint if narrow => (words().dead_point(), ScreenPart::Warning),
        Condition::DeadPoint => (words().dead_point_without_rates(), ScreenPart::Warning),
        Condition::NoAssembly if narrow => (words().no_assembly(), ScreenPart::Warning),
        Condition::NoAssembly => (words().no_assembly_here(), ScreenPart::Warning),
    }
}

/// Returns `true` if the motion has a limit or a change point that the driver can approach.
pub(super) fn can_come_near(app: &App) -> bool {
    let open_scene = app.open_scene();
    if open_scene.led().is_some() {
        return false;
    }
    open_scene.driver_range().shuttle().is_some()
        || !open_scene.solver().motion().change_points.is_empty()
}

/// Returns a description of the next limit or change point, if the state is regular and one is
/// near.
pub(super) fn near(app: &App) -> Option<String> {
    let open_scene = app.open_scene();
    if let Some(led) = open_scene.led() {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        let singularity = led.singularity()?;
        return Some(singularity_text(scene, solver, singularity));
    }
    if app.condition() != Condition::Ok {
        return None;
    }
    let driver_state = open_scene.driver_state().pace;
    let goes_back = driver_state.is_some_and(|moment| moment.speed < 0.0);
    let backwards = app.playback().is_backwards() != goes_back;
    let (scene, motion) = (open_scene.scene(), open_scene.solver().motion());
    let mut stops = motion.stops.iter();
    if let Some(stop) = stops.find(|stop| stop.at == open_scene.at()) {
        return Some(words().stop_of(&stop_name(scene, stop.limit)));
    }
    let ahead = ahead(
        open_scene.driver_range(),
        motion,
        open_scene.at(),
        backwards,
    )?;
    Some(ahead.text(scene, open_scene.driver_range(), open_scene.unit()))
}

/// Returns the error bound of the shown values in at most `room` columns.
pub(super) fn trust(app: &App, space: u16) -> Option<String> {
    let shows_figures = app.mode().is_normal() && app.condition() == Condition::Ok;
    shows_figures
        .then(|| app.view().pane_in(app).trust(app, space))
        .flatten()
}
