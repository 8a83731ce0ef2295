//! The prompts of the status line.

use super::facts::mode;
use super::{MIN_WIDTH_WITH_GAPS, Writer};
use crate::scene::Value;
use crate::tui::app::{App, GoalRun, Mode};
use crate::tui::appearance::theme::ScreenPart;
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::player::open_scene::shown;
use crate::tui::views::candidates::fits_both;
use crate::tui::views::candidates::list::CandidatesPage;
use crate::tui::views::scene_picker::list::{Picker, PickerTarget};
use crate::tui::views::scene_picker::preview::Preview;
use crate::tui::views::{columns, cut};
use crate::wording::words;

/// Renders the prompt behind the mode. Returns `false` if the mode has no prompt in this line.
pub(super) fn render(app: &App, line: &mut Writer<'_>) -> bool {
    match app.mode() {
        Mode::GoTo(typed) => coordinate(app, typed, line),
        Mode::Guess(typed) => example(typed, words().guesses_are_typed(), app, line),
        Mode::Goal(typed) => example(typed, &goal_example(app), app, line),
        Mode::GoalRun(run) => design(app, run, line),
        Mode::FileName(prompt) => file_name(app, &prompt.name, line),
        Mode::Recovery(_) => offered(app, line),
        // The question itself is in the middle of the screen.
        Mode::Unsaved(_) | Mode::Confirm(_) => line.gap(1),
        Mode::AssemblyChoice(picker) => picking(app, picker, line),
        Mode::Candidates => candidate(app, line),
        Mode::Search(search) => render_search_prompt(app, &search.name, line),
        Mode::Value(_) => value(app, line),
        Mode::Copy => write_copy_hints(line),
        Mode::Palette(_) => {
            line.gap(1);
            keys(words().do_it(), words().back(), app, line);
        }
        Mode::Normal | Mode::Help(_) | Mode::Tour(_) | Mode::Assemblies(_) | Mode::PlotList(_) => {
            return false;
        }
    }
    true
}

/// Renders the prompt for a coordinate.
fn coordinate(app: &App, typed: &EditLine, line: &mut Writer<'_>) {
    let unit = app.open_scene().unit();
    let what = match app.open_scene().driver_range().turns() {
        _ if app.open_scene().led_motion().is_some() => words().time_in().to_owned(),
        true => words().angle_in(unit),
        false => words().position_in(unit),
    };
    line.gap(1);
    line.write_text(&what, ScreenPart::Text);
    line.typed(typed.text());
    end(words().go(), words().cancel(), app, line);
}

/// Returns an example of a goal, whose value is the selected one unless another is named.
fn goal_example(app: &App) -> String {
    let name = app.editor().value().map(Value::dotted);
    words().goals_are_typed(&name.unwrap_or_default())
}

/// Renders the progress of the search for designs, or the selected design with its keys.
fn design(app: &App, run: &GoalRun, line: &mut Writer<'_>) {
    line.gap(1);
    let key = |action| app.keymap().key_label(action);
    let back = (key(Action::Back), words().cancel());
    if let Some(percent) = run.percent() {
        line.write_text(&words().looking_for_designs(percent), ScreenPart::Text);
        line.gap(3);
        line.hint(&back.0, back.1);
        return;
    }
    let sides = [TablesAction::Left, TablesAction::Right].map(|side| key(Action::Tables(side)));
    let hints = [
        (Key::Enter.to_string(), words().take()),
        (sides.join(" "), words().next()),
        back,
    ];
    let needed = |(key, name): &(String, &str)| columns(key) + 1 + columns(name) + 2;
    let hinted: u16 = hints.iter().map(needed).sum();
    let longest = line.columns_left().saturating_sub(hinted + 1);
    let text = run.line().unwrap_or_default();
    let shown_line = shown(&text, app.glyphs());
    // A design must be completely visible before it is accepted.
    if columns(&shown_line) > longest {
        line.keep_message(&text);
    } else {
        line.write_text(&shown_line, ScreenPart::Text);
        line.gap(2);
    }
    for (key, name) in &hints {
        line.hint(key, name);
    }
}

/// Renders a prompt with an example in place of empty input.
fn example(typed: &EditLine, example: &str, app: &App, line: &mut Writer<'_>) {
    line.gap(1);
    if typed.text().is_empty() && app.message().is_none() {
        line.write_text(" ", ScreenPart::Caret);
        line.write_text(example, ScreenPart::Quiet);
    } else {
        line.typed(typed.text());
    }
    end(words().take(), words().cancel(), app, line);
}

/// Renders the prompt for a file name.
fn file_name(app: &App, typed: &EditLine, line: &mut Writer<'_>) {
    line.gap(1);
    line.write_text(words().write_to(), ScreenPart::Text);
    let text = shown(typed.text(), app.glyphs());
    match typed.is_proposal() {
        true => line.proposed(&text),
        false => line.typed(&text),
    }
    end(words().writing(), words().cancel(), app, line);
}

/// Renders the prompt for a search.
fn render_search_prompt(app: &App, typed: &EditLine, line: &mut Writer<'_>) {
    line.gap(1);
    line.write_text(words().name(), ScreenPart::Text);
    line.typed(typed.text());
    end(words().keep(), words().back(), app, line);
}

/// Renders the hints for typing a value; the text itself is in the value's row.
fn value(app: &App, line: &mut Writer<'_>) {
    line.gap(1);
    if line.shows_message(app) {
        return;
    }
    if let Some(value) = app.editor().value() {
        let units = value.units().join(", ");
        line.write_text(&words().value_in(&value.name, &units), ScreenPart::Text);
        line.gap(2);
    }
    line.hint(&Key::Enter.to_string(), words().take());
    line.hint(&Key::Escape.to_string(), words().cancel());
}

/// Renders a short description of the selected entry of the scene picker, with its keys.
fn picking(app: &App, picker: &Picker, line: &mut Writer<'_>) {
    line.gap(1);
    let enter = match picker.chosen().map(|item| &item.place) {
        None => None,
        Some(PickerTarget::Folder(_) | PickerTarget::Candidates) => Some(words().look_inside()),
        Some(PickerTarget::Original | PickerTarget::File(_) | PickerTarget::Preset(_)) => {
            Some(mode(app))
        }
    };
    let keys = [(Key::Enter, enter), (Key::Escape, Some(words().back()))];
    let keys = keys.map(|(key, name)| Some((key.to_string(), name?)));
    let needed = |(key, name): &(String, &str)| columns(key) + 1 + columns(name) + 2;
    // Without room for a preview the title is the only description.
    let hints: u16 = match app.size().width < MIN_WIDTH_WITH_GAPS {
        true => 0,
        false => keys.iter().flatten().map(needed).sum(),
    };
    let longest = line.columns_left().saturating_sub(hints + 1);
    let fits = |message: &&str| columns(&shown(message, app.glyphs())) <= longest;
    let text = app.message().filter(fits);
    if let (None, Some(message)) = (text, app.message()) {
        line.keep_message(message);
    }
    let title = match app.preview() {
        Some(Preview::Scene(sample)) => sample.scene.title(),
        _ => String::new(),
    };
    let (words, part) = match app.preview() {
        _ if let Some(message) = text => (message, ScreenPart::Warning),
        Some(Preview::Scene(_)) => (title.as_str(), ScreenPart::Text),
        Some(Preview::Fault(fault)) => (fault.what.as_str(), ScreenPart::Warning),
        Some(Preview::Unseen(why)) => (why.as_str(), ScreenPart::Quiet),
        Some(Preview::Folder(names)) if names.is_empty() => {
            (words().no_scene_in_it(), ScreenPart::Quiet)
        }
        Some(Preview::Folder(_)) => (words().a_folder(), ScreenPart::Quiet),
        None => ("", ScreenPart::Quiet),
    };
    let words = cut(&shown(words, app.glyphs()), longest.into());
    line.write_text(&words, part);
    line.gap(2);
    for (key, name) in keys.iter().flatten() {
        line.hint(key, name);
    }
}

/// Renders the keys for the selected candidate; on a small screen, after its defects or unmet
/// preferences.
fn candidate(app: &App, line: &mut Writer<'_>) {
    line.gap(1);
    let Some(list) = app.candidates() else {
        return;
    };
    if line.shows_message(app) {
        return;
    }
    let key = |action| app.keymap().key_label(action);
    let back = (key(Action::Back), words().back());
    let sides = [TablesAction::Left, TablesAction::Right].map(|side| key(Action::Tables(side)));
    if let CandidatesPage::Curves(walk) = list.page() {
        let does = match walk.picked() {
            Some(_) => words().put_into_list(),
            None => words().pick(),
        };
        line.hint(&Key::Enter.to_string(), does);
        line.hint(&sides.join(" "), words().walk());
        line.hint(&key(Action::PageDown), words().next_curve());
        line.hint(&back.0, back.1);
        return;
    }
    let Some((candidate, row)) = list.chosen() else {
        line.hint(&back.0, back.1);
        return;
    };
    if app.size().width < MIN_WIDTH_WITH_GAPS {
        let words = match row.reasons.is_empty() {
            true => &row.unmet,
            false => &row.reasons,
        };
        let words = cut(&shown(words, app.glyphs()), line.columns_left().into());
        line.write_text(&words, ScreenPart::Warning);
        line.gap(if words.is_empty() { 0 } else { 2 });
    }
    if candidate.meets_task() {
        line.hint(&Key::Enter.to_string(), words().take());
    }
    let play = match list.is_playing() {
        true => words().pause(),
        false => words().play(),
    };
    line.hint(&back.0, back.1);
    // The page that Tab shows next.
    let is_listed = matches!(list.page(), CandidatesPage::List);
    let next = match (is_listed && !fits_both(app.size()), list.has_curves()) {
        (true, _) => Some(words().linkage_alone()),
        (false, true) => Some(words().curves_of_dyads()),
        (false, false) if !is_listed => Some(words().all_linkages()),
        (false, false) => None,
    };
    if let Some(next) = next {
        line.hint(&key(Action::NextView), next);
    }
    line.hint(&key(Action::Play), play);
    line.hint(&sides.join(" "), words().point_by_point());
    line.hint(&key(Action::Help), words().help());
}

/// Renders the keys that choose how much of the tables is copied.
fn write_copy_hints(line: &mut Writer<'_>) {
    line.gap(1);
    for (key, name) in [
        ("v", words().value()),
        ("r", words().row()),
        ("t", words().table()),
    ] {
        line.hint(key, name);
    }
    line.hint(&Key::Escape.to_string(), words().back());
}

/// Renders the message about the offer in the middle of the screen.
fn offered(app: &App, line: &mut Writer<'_>) {
    line.gap(1);
    if !line.shows_message(app) {
        line.write_text(words().edits_by_others(), ScreenPart::Quiet);
    }
}

/// Renders the fault of the typed line behind it, or the effects of its keys.
fn end(enter: &str, escape: &str, app: &App, line: &mut Writer<'_>) {
    line.gap(3);
    keys(enter, escape, app, line);
}

/// Renders the message, or else the effects of the keys.
fn keys(enter: &str, escape: &str, app: &App, line: &mut Writer<'_>) {
    if line.shows_message(app) {
        return;
    }
    line.hint(&Key::Enter.to_string(), enter);
    line.hint(&Key::Escape.to_string(), escape);
}
