//! The keys that matter now.

use super::{ROOM_FOR_GAPS, Writer, is_listing};
use crate::tui::app::{App, Mode};
use crate::tui::commands::action::{Action, PlotsAction, SceneAction, entry_of};
use crate::tui::commands::key::Key;
use crate::tui::views::accuracy::study_run::Phase;
use crate::tui::views::most_scroll;
use crate::tui::views::motion::FIT;

/// What Enter does in the list of plots, where there is room to say all of it.
const PLOT: &str = "plot it or not";

/// The key that comes first, and what it does.
pub(super) fn first(app: &App) -> (String, &'static str) {
    hint_of(app, offered(app)[0]).unwrap_or_default()
}

/// Offers keys as far as there is room.
pub(super) fn render(app: &App, line: &mut Writer<'_>) {
    if let Mode::Help(help) = app.mode()
        && help.is_typing()
    {
        let (back, on) = match help.topic() {
            None => ("all keys", "keep"),
            Some(_) => ("back", "next"),
        };
        line.hint(&Key::Escape.to_string(), back);
        line.hint(&Key::Enter.to_string(), on);
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
        if (action == Action::LineDown && !can_scroll) || (action == FIT && app.viewport().fits()) {
            continue;
        }
        if let Some((key, name)) = hint_of(app, action) {
            line.hint(&key, name);
        }
        if action == Action::Help
            && let Some((mark, meaning)) = app.view().pane().legend()
        {
            line.hint(&mark.to_string(), meaning);
        }
    }
}

/// What to offer now, the most important first: the last ones are dropped where there is no room.
fn offered(app: &App) -> &'static [Action] {
    match app.mode() {
        Mode::Help(_) => &[
            Action::Back,
            Action::Search,
            Action::NextView,
            Action::LineDown,
            Action::Quit,
        ],
        Mode::Tour(_) => &[Action::Back, Action::StepForward, Action::StepBack],
        Mode::Assemblies(_) => &[Action::Back, Action::LineDown, Action::Save, Action::Help],
        Mode::Pick(_) => &[Action::Back],
        _ => app.view().pane().hints(app),
    }
}

/// The first key of an action, if it has one, and what it does now.
fn hint_of(app: &App, action: Action) -> Option<(String, &'static str)> {
    let key = app.keymap().key(action)?;
    let is_looked_at = action == Action::Look(app.view());
    let name = match action {
        Action::Play if app.playback().is_playing() => "pause",
        Action::Scene(SceneAction::NudgeDown) => "less",
        Action::Scene(SceneAction::NudgeUp) => "more",
        Action::Back if matches!(app.mode(), Mode::Tour(_)) => "end",
        Action::Back if app.is_working() && *app.mode() == Mode::Normal => "stop",
        Action::LineDown if matches!(app.mode(), Mode::Assemblies(_)) => "next",
        Action::NextView if let Mode::Help(help) = app.mode() => match help.topic() {
            None => "manual",
            Some(_) => "next topic",
        },
        Action::Plots(PlotsAction::Choose) => "choose",
        Action::Plots(PlotsAction::Abscissa) => "along x",
        Action::Look(_) if app.study_run().phase() == Phase::Stopped && is_looked_at => "go on",
        Action::Look(_) if app.study_run().phase() == Phase::Done && is_looked_at => "again",
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
