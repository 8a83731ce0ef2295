//! The hints of the keys that are useful now.

use super::{Writer, is_listing};
use crate::tui::app::{App, BackTarget, Mode};
use crate::tui::commands::action::{Action, PlotsAction, SceneAction, entry_of};
use crate::tui::commands::key::Key;
use crate::tui::views::accuracy::study_run::Phase;
use crate::tui::views::max_scroll;
use crate::tui::views::motion::FIT;
use crate::wording::words;

/// Minimum width for longer hints on the keys of a list.
const MIN_WIDTH_WITH_LONG_HINTS: u16 = 100;

/// Returns the first key and its effect.
pub(super) fn first(app: &App) -> (String, &'static str) {
    hint_of(app, offered(app)[0]).unwrap_or_default()
}

/// Prints as many key hints as fit.
pub(super) fn render(app: &App, line: &mut Writer<'_>) {
    if let Mode::Help(help) = app.mode()
        && help.is_typing()
    {
        let (back, on) = match help.topic() {
            None => (words().all_keys(), words().keep()),
            Some(_) => (words().back(), words().next()),
        };
        line.hint(&Key::Escape.to_string(), back);
        line.hint(&Key::Enter.to_string(), on);
        return;
    }
    if let Mode::PlotList(list) = app.mode() {
        let narrow = app.size().width < MIN_WIDTH_WITH_LONG_HINTS;
        let hints = match list.read() {
            Some(_) => vec![(Key::Escape, words().back()), (Key::Down, words().scroll())],
            None => list_hints(list.typing, narrow),
        };
        for (key, name) in hints {
            line.hint(&key.to_string(), name);
        }
        return;
    }
    let listing = is_listing(app);
    let can_scroll = listing || max_scroll(app) > 0;
    if listing {
        line.hint(&Key::Enter.to_string(), words().take());
    }
    for &action in offered(app) {
        if (action == Action::LineDown && !can_scroll)
            || (action == FIT && app.views.viewport.lens.fits())
        {
            continue;
        }
        if let Some((key, name)) = hint_of(app, action) {
            line.hint(&key, name);
        }
        if action == Action::Help
            && let Some((mark, meaning)) = app.view().pane_in(app).legend()
        {
            line.hint(&mark.to_string(), meaning);
        }
        if action == Action::Help {
            for (key, name) in pane_actions(app) {
                line.hint(&key, name);
            }
        }
    }
    if app.mode().is_normal() && app.views.searched == Some(app.view()) {
        line.hint("n N", words().next());
    }
}

/// Returns the keys that switch between panes, if there are several.
fn pane_actions(app: &App) -> Vec<(String, &'static str)> {
    if !app.mode().is_normal() || app.visible_views().len() < 2 {
        return Vec::new();
    }
    let actions = [Action::NextPane, Action::Alone];
    let hints = actions
        .into_iter()
        .filter_map(|action| hint_of(app, action));
    hints.collect()
}

/// Returns the actions to offer, the most important first; the last ones are dropped if they do not
/// fit.
fn offered(app: &App) -> &'static [Action] {
    match app.mode() {
        Mode::Help(_) => &[
            Action::Back,
            Action::Search,
            Action::NextView,
            Action::LineDown,
        ],
        Mode::Tour(_) => &[Action::Back, Action::StepForward, Action::StepBack],
        Mode::Assemblies(_) => &[Action::Back, Action::LineDown, Action::Save, Action::Help],
        Mode::AssemblyChoice(_) | Mode::Candidates => &[Action::Back],
        _ => app.view().pane_in(app).hints(app),
    }
}

/// Returns the first key of an action, if it has one, and its current effect.
fn hint_of(app: &App, action: Action) -> Option<(String, &'static str)> {
    let key = app.keymap().key(action)?;
    let is_looked_at = action == Action::Look(app.view());
    let name = match action {
        Action::Play if app.playback().is_playing() => words().pause(),
        Action::Scene(SceneAction::NudgeDown) => words().less(),
        Action::Scene(SceneAction::NudgeUp) => words().more(),
        Action::Scene(SceneAction::Gather) if app.editor().staged.is_some() => {
            words().make_gathered()
        }
        Action::Back if matches!(app.mode(), Mode::Tour(_)) => words().end(),
        Action::Back if app.mode().is_normal() => match app.back_target() {
            BackTarget::StagedEdits => words().drop_staged(),
            BackTarget::Study => words().stop(),
            BackTarget::Tolerance
            | BackTarget::Method
            | BackTarget::Pane
            | BackTarget::Comparison
            | BackTarget::Search => words().back(),
        },
        Action::LineDown if matches!(app.mode(), Mode::Assemblies(_)) => words().next(),
        Action::NextView if let Mode::Help(help) = app.mode() => match help.topic() {
            None => words().manual(),
            Some(_) => words().next_topic(),
        },
        Action::Plots(PlotsAction::Choose) => words().choose(),
        Action::Plots(PlotsAction::Abscissa) => words().along_x(),
        Action::Look(_) if app.views.study_run.phase() == Phase::Stopped && is_looked_at => {
            words().go_on()
        }
        Action::Look(_) if app.views.study_run.phase() == Phase::Done && is_looked_at => {
            words().again()
        }
        _ => (entry_of(action).hint)(words()),
    };
    Some((key.to_string(), name))
}

/// Returns the keys of the list of quantities to plot.
fn list_hints(typing: bool, narrow: bool) -> Vec<(Key, &'static str)> {
    if typing {
        return vec![(Key::Enter, words().keep()), (Key::Escape, words().all())];
    }
    let plot = match narrow {
        true => words().plot(),
        false => words().plot_it_or_not(),
    };
    vec![
        (Key::Enter, plot),
        (Key::Escape, words().done()),
        (Key::Char('o'), words().the_whole_cycle()),
        (Key::Char('/'), words().search()),
        (Key::Char('c'), words().none()),
    ]
}
