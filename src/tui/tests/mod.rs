//! Tests the whole workbench, with access to its internals.

mod candidates;
mod inputs;
mod monkey;
mod mouse;
mod slow_line;
mod space;
mod stage;
mod tolerances;

use super::app::{App, View};
use super::is_only_line_ready;
use super::terminal::Wake;
use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::Workbench;
use crate::tui::commands::action::Action;
use crate::tui::document::opening;
use crate::wording::Language;
use ratatui::layout::Size;
use std::time::Duration;

/// Opens a scene with loads.
fn loaded(size: Size) -> App {
    let capability = Capability {
        glyphs: Glyphs::Ascii,
        colours: Colours::None,
        modern: false,
    };
    let opened = opening::preset(presets::find("four-bar-load").unwrap()).unwrap();
    App::new(opened, None, capability, size)
}

/// Returns whether the effects of lengths, the forces and the working have been computed.
fn found(app: &App) -> [bool; 3] {
    let views = &app.views;
    let [lengths, forces] = [views.lengths.get().is_some(), views.forces.get().is_some()];
    [lengths, forces, views.working.get().is_some()]
}

/// The terminal's answer means that the last frame is drawn. It changes nothing in the picture, and
/// during playback it arrives as often as frames.
#[test]
fn answer_alone_does_not_trigger_a_frame() {
    assert!(is_only_line_ready(&[Wake::Room, Wake::Room]));
    for events in [&[][..], &[Wake::Written], &[Wake::Room, Wake::Done]] {
        assert!(!is_only_line_ready(events), "{events:?}");
    }
}

/// The data of visible panes is computed, whichever pane has the focus; other data is not.
#[test]
fn only_data_of_visible_panes_is_computed() {
    let press = |app: &mut App, action| app.update(action, Duration::ZERO);
    let mut app = loaded(Size::new(120, 40));
    assert!(
        app.views.plots.plot().is_ok(),
        "a plot stands from the start"
    );
    assert_eq!(found(&app), [false; 3]);
    press(&mut app, Action::Look(View::Forces));
    for _ in 0..3 {
        press(&mut app, Action::NextPane);
        assert_eq!(found(&app), [false, true, false], "{:?}", app.view());
    }
    press(&mut app, Action::Look(View::Plots));
    press(&mut app, Action::Alone);
    assert_eq!(found(&app), [false; 3], "a plot alone");
    press(&mut app, Action::Alone);
    press(&mut app, Action::Look(View::Working));
    assert_eq!(found(&app), [false, false, true]);
    // A screen too small for panes shows only the focused view.
    app.resize(Size::new(80, 24), None);
    press(&mut app, Action::Look(View::Motion));
    assert_eq!(found(&app), [false; 3]);
}

/// The working of a walking leg has about a thousand lines. Leaving its view avoids waiting for
/// them.
#[test]
fn data_of_a_view_is_dropped_when_it_closes() {
    let mut app = loaded(Size::new(80, 24));
    for (view, expected) in [
        (View::Working, [false, false, true]),
        (View::Forces, [false, true, false]),
        (View::Lengths, [true, false, false]),
    ] {
        app.update(Action::Look(view), Duration::ZERO);
        assert_eq!(found(&app), expected, "{view:?}");
        // The list of assemblies is part of the motion view.
        app.update(Action::Assemblies, Duration::ZERO);
        assert_eq!(app.view(), View::Motion);
        assert_eq!(found(&app), [false; 3], "after {view:?}");
        app.update(Action::Assemblies, Duration::ZERO);
    }
}

#[test]
fn keys_jump_between_parts_of_the_scene() {
    let capability = Capability {
        glyphs: Glyphs::Ascii,
        colours: Colours::None,
        modern: false,
    };
    let opened = opening::preset(presets::find("four-bar").unwrap()).unwrap();
    let mut app = App::new(opened, None, capability, Size::new(80, 24));
    let mut press = |keys: &str| {
        for key in keys.split(' ') {
            app.key(key.parse().unwrap(), Duration::ZERO);
        }
        app.editor().value().unwrap().name.clone()
    };
    let parts = [
        "A x",
        "D x",
        "driver angle",
        "r2 length",
        "r3 length",
        "r4 length",
        "C start x",
    ];
    assert_eq!(press("6"), parts[0]);
    for part in &parts[1..] {
        assert_eq!(press("J"), *part);
    }
    assert_eq!(press("J"), "C start x", "the last");
    assert_eq!(press("j K"), "C start x", "its own beginning");
    assert_eq!(press("K K"), "r3 length");
}

/// Texts shown before the change are translated: the screen equals one opened in that language.
#[test]
fn changing_language_retranslates_every_view() {
    let open = |keys: &str| {
        let opened = opening::preset(presets::find("four-bar-load").unwrap()).unwrap();
        let mut workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, 100, 36);
        workbench.press(keys);
        workbench.text()
    };
    for view in ["1", "2", "3", "5", "6", "7", "8", "9"] {
        let twice = format!("{view} {view}");
        Language::English.speak();
        let english = open(&twice);
        let changed = open(&format!("{view} B {view}"));
        assert_eq!(Language::current_language(), Language::Turkish);
        assert_eq!(changed, open(&twice), "{view}");
        assert_ne!(changed, english, "{view}");
        assert_eq!(open(&format!("{view} B {view}")), english, "{view}");
    }
}
