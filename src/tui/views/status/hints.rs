//! The keys that matter now.

use super::{ROOM_FOR_GAPS, Writer, is_listing};
use crate::tui::action::{Action, MotionAction, PlotsAction, SceneAction, TablesAction, entry_of};
use crate::tui::app::{App, Mode, View};
use crate::tui::key::Key;
use crate::tui::sheet::FOUND;
use crate::tui::survey::Phase;
use crate::tui::views::most_scroll;

/// What Enter does in the list of plots, where there is room to say all of it.
const PLOT: &str = "plot it or not";

/// Offered where only a part of the motion is seen.
const FIT: Action = Action::Motion(MotionAction::Fit);

/// The key that comes first, and what it does.
pub(super) fn first(app: &App) -> (String, &'static str) {
    hint_of(app, offered(app)[0]).unwrap_or_default()
}

/// Offers keys as far as there is room.
pub(super) fn render(app: &App, line: &mut Writer<'_>) {
    if matches!(app.mode(), Mode::Help(help) if help.is_typing()) {
        line.hint(&Key::Escape.to_string(), "all keys");
        line.hint(&Key::Enter.to_string(), "keep");
        return;
    }
    if let Mode::PlotList(list) = app.mode() {
        for (key, name) in list_hints(list.is_typing()) {
            let name = match *name {
                PLOT if app.size().width < ROOM_FOR_GAPS => "plot",
                name => name,
            };
            line.hint(&key.to_string(), name);
        }
        return;
    }
    let listing = is_listing(app);
    let can_scroll = listing || most_scroll(app) > 0;
    if listing {
        line.hint(&Key::Enter.to_string(), "take");
    }
    for &action in offered(app) {
        if (action == Action::LineDown && !can_scroll) || (action == FIT && app.lens().fits()) {
            continue;
        }
        if let Some((key, name)) = hint_of(app, action) {
            line.hint(&key, name);
        }
        if action == Action::Help && app.view() == View::Tables {
            line.hint(&FOUND.to_string(), "found");
        }
    }
}

/// What to offer now, the most important first: the last ones are dropped where there is no room.
fn offered(app: &App) -> &'static [Action] {
    match (app.mode(), app.view()) {
        (Mode::Help(_), _) => &[Action::Back, Action::Search, Action::LineDown, Action::Quit],
        (Mode::Tour(_), _) => &[Action::Back, Action::StepForward, Action::StepBack],
        (Mode::Assemblies(_), _) => &[Action::Back, Action::LineDown, Action::Save, Action::Help],
        (Mode::Pick(_), _) => &[Action::Back],
        (_, View::Motion) => &[
            Action::Help,
            FIT,
            Action::Play,
            Action::Quit,
            Action::StepForward,
            Action::GoTo,
            Action::NextPreset,
        ],
        (_, View::Accuracy) => match app.survey().phase() {
            Phase::Running => &[
                Action::Help,
                Action::Back,
                Action::LineDown,
                Action::MotionView,
                Action::Quit,
            ],
            Phase::Idle | Phase::Stopped | Phase::Done => &[
                Action::Help,
                Action::AccuracyView,
                Action::LineDown,
                Action::MotionView,
                Action::Quit,
            ],
        },
        (_, View::Tables) => &[
            Action::Help,
            Action::Search,
            Action::Copy,
            Action::MotionView,
            Action::Tables(TablesAction::Choose),
            Action::Csv,
            Action::Quit,
        ],
        (_, View::Scene) => &[
            Action::Help,
            Action::Scene(SceneAction::Edit),
            Action::Scene(SceneAction::NudgeDown),
            Action::Scene(SceneAction::NudgeUp),
            Action::Save,
            Action::Undo,
            Action::MotionView,
            Action::Quit,
        ],
        (_, View::Plots) => &[
            Action::Help,
            Action::Plots(PlotsAction::Choose),
            Action::LineDown,
            Action::Plots(PlotsAction::Abscissa),
            Action::MotionView,
            Action::Play,
            Action::StepForward,
            Action::Quit,
        ],
        (_, View::Forces | View::Lengths | View::Working | View::Motor) => &[
            Action::Help,
            Action::MotionView,
            Action::LineDown,
            Action::Quit,
            Action::Play,
            Action::StepForward,
        ],
    }
}

/// The first key of an action, if it has one, and what it does now.
fn hint_of(app: &App, action: Action) -> Option<(String, &'static str)> {
    let key = app.keymap().key(action)?;
    let name = match action {
        Action::Play if app.playback().is_playing() => "pause",
        Action::Scene(SceneAction::NudgeDown) => "less",
        Action::Scene(SceneAction::NudgeUp) => "more",
        Action::Back if matches!(app.mode(), Mode::Tour(_)) => "end",
        Action::Back if app.is_working() && *app.mode() == Mode::Normal => "stop",
        Action::LineDown if matches!(app.mode(), Mode::Assemblies(_)) => "next",
        Action::Plots(PlotsAction::Choose) => "choose",
        Action::Plots(PlotsAction::Abscissa) => "along x",
        Action::AccuracyView if app.survey().phase() == Phase::Stopped => "go on",
        Action::AccuracyView if app.survey().phase() == Phase::Done => "again",
        _ => entry_of(action).name,
    };
    Some((key.to_string(), name))
}

/// The keys of the list in which is chosen what is plotted.
fn list_hints(typing: bool) -> &'static [(Key, &'static str)] {
    if typing {
        &[(Key::Enter, "keep"), (Key::Escape, "all")]
    } else {
        &[
            (Key::Enter, PLOT),
            (Key::Escape, "done"),
            (Key::Char('/'), "search"),
            (Key::Char('c'), "none"),
        ]
    }
}
