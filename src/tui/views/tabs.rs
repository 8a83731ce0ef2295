//! The first line: the views with their keys. The current view is in brackets; views with nothing
//! to show of the scene are dim.
//!
//! ```text
//! [1 Motion] 2 Tables  3 Plots  4 Accuracy  5 Forces  ..        ? help  : commands    where there is room
//!  1 Motion [2 Tables] 3 Plots  4 Accu.  ..                                           80 columns
//!  1 [2 Tables] 3 4 5 6 7 8 9                                                         40 columns
//! ```

use super::{columns, print, print_right};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, entry_of};
use crate::tui::commands::key::Key;
use crate::wording::{Language, words};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Minimum columns between the tabs and the hints at the right.
const GAP: u16 = 3;

/// A tab: its view, its key, and its name, which may be shortened or empty.
struct Tab {
    view: View,
    key: String,
    name: String,
}

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let (tabs, gap) = fitted(app, area.width);
    let mut x = area.x;
    for tab in &tabs {
        x = render_tab(app, tab, (x, area.y), buffer) + gap;
    }
    if hints_start(app, area, x).is_some() {
        let style = theme::part(ScreenPart::Quiet);
        print_right(buffer, area.right() - 1, area.y, &hints(app), style);
    }
}

/// Returns the column where the hints begin, if they fit behind the tabs, which end at `end`.
fn hints_start(app: &App, area: Rect, end: u16) -> Option<u16> {
    let start = area.right().checked_sub(1 + columns(&hints(app)))?;
    (end + GAP <= start).then_some(start)
}

/// Returns the view whose tab is at a column.
pub(super) fn at(app: &App, area: Rect, x: u16) -> Option<View> {
    let (tabs, gap) = fitted(app, area.width);
    let mut start = area.x;
    for tab in &tabs {
        let end = start + needed(std::slice::from_ref(tab), 0) + 1;
        if (start..end).contains(&x) {
            return Some(tab.view);
        }
        start = end - 1 + gap;
    }
    None
}

/// Returns the key whose hint is at a column, right of the tabs.
pub(super) fn key_at(app: &App, area: Rect, x: u16) -> Option<Key> {
    let (tabs, gap) = fitted(app, area.width);
    let end = area.x + needed(&tabs, gap) + gap;
    let start = hints_start(app, area, end)?;
    let mut ends = HINTS.iter().scan(start, |at, action| {
        *at += hint(app, *action).map_or(0, |hint| columns(&hint)) + HINT_GAP;
        Some((*action, *at))
    });
    let (action, _) = ends.find(|(_, end)| (start..*end).contains(&x))?;
    app.keymap().key(action)
}

/// Renders a tab with a blank or bracket on both sides and returns its end. The second one is
/// shared with the next tab.
fn render_tab(app: &App, tab: &Tab, (x, y): (u16, u16), buffer: &mut Buffer) -> u16 {
    let is_looked_at = tab.view == app.view();
    let part = |usual| match is_looked_at {
        true => ScreenPart::Mode,
        false if tab.view.pane_in(app).nothing(app).is_some() => ScreenPart::Quiet,
        false => usual,
    };
    let blank = if tab.name.is_empty() { "" } else { " " };
    let text = format!("{}{blank}{}", tab.key, tab.name);
    let end = x + 1 + columns(&text);
    if is_looked_at {
        print(buffer, x, y, 1, "[", theme::part(ScreenPart::Title));
        print(buffer, end, y, 1, "]", theme::part(ScreenPart::Title));
    }
    let style = theme::part(part(ScreenPart::Text));
    print(buffer, x + 1, y, columns(&text), &text, style);
    let style = theme::part(part(ScreenPart::Key));
    print(buffer, x + 1, y, columns(&tab.key), &tab.key, style);
    end
}

/// Returns the longest form of the tabs that fits, and the additional blanks between them.
fn fitted(app: &App, width: u16) -> (Vec<Tab>, u16) {
    let all = || View::ALL.into_iter();
    let complete = || all().map(|view| tab(app, view, named(view)));
    let brief = || all().map(|view| tab(app, view, in_short(view)));
    // The last view gives way on 80 columns, unless it is the current one.
    let most = || {
        let stays = |view: &View| *view != View::Polygons || *view == app.view();
        let views = all().filter(stays);
        views.map(|view| tab(app, view, in_short(view)))
    };
    let own = |view: View| {
        if view == app.view() {
            named(view)
        } else {
            String::new()
        }
    };
    let keys = || all().map(|view| tab(app, view, own(view)));
    let candidates: [(Vec<Tab>, u16); 5] = [
        (complete().collect(), 1),
        (complete().collect(), 0),
        (brief().collect(), 0),
        (most().collect(), 0),
        (keys().collect(), 0),
    ];
    // The bracket behind the last tab must fit too, and blanks give way to the hints.
    let hints = GAP + columns(&hints(app)) + 2;
    let fits = |(tabs, gap): &(Vec<Tab>, u16)| needed(tabs, *gap) + hints * gap < width;
    let mut fitting = candidates.into_iter().skip_while(|tabs| !fits(tabs));
    fitting.next().unwrap_or_else(|| (keys().collect(), 0))
}

/// Returns the width of tabs, from the blank before the first one to the last letter.
fn needed(tabs: &[Tab], gap: u16) -> u16 {
    let width = |tab: &Tab| {
        let blank = u16::from(!tab.name.is_empty());
        1 + columns(&tab.key) + blank + columns(&tab.name) + gap
    };
    tabs.iter().map(width).sum::<u16>().saturating_sub(gap)
}

fn tab(app: &App, view: View, name: String) -> Tab {
    let key = app.keymap().key(Action::Look(view));
    Tab {
        view,
        key: key.map_or_else(|| "-".into(), |key| key.to_string()),
        name,
    }
}

/// Returns the name of a view, such as `Tables`.
fn named(view: View) -> String {
    capitalised((entry_of(Action::Look(view)).hint)(words()))
}

/// Returns the name of a view on a line of 80 columns.
fn in_short(view: View) -> String {
    match view {
        View::Accuracy => capitalised(words().short_accuracy()),
        _ => named(view),
    }
}

fn capitalised(name: &str) -> String {
    Language::current_language().capitalised(name)
}

/// The actions of the hints for help and commands, through which everything else is found.
const HINTS: [Action; 2] = [Action::Help, Action::Palette];
/// Blanks between them.
const HINT_GAP: u16 = 2;

/// Returns the hints.
fn hints(app: &App) -> String {
    let hints: Vec<String> = HINTS
        .into_iter()
        .filter_map(|action| hint(app, action))
        .collect();
    hints.join(&" ".repeat(HINT_GAP.into()))
}

/// Returns the hint of an action that has a key.
fn hint(app: &App, action: Action) -> Option<String> {
    let key = app.keymap().key(action)?;
    Some(format!("{key} {}", (entry_of(action).hint)(words())))
}
