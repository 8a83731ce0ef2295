//! Tests how the panes share the screen, over all presets.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::tui::document::opening;
use crate::tui::views;
use ratatui::layout::Size;
use std::time::Duration;

fn app(preset: &str, glyphs: Glyphs, size: Size) -> App {
    let capability = Capability {
        glyphs,
        colours: Colours::None,
        modern: true,
    };
    let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
    App::new(opened, None, capability, size)
}

#[test]
fn tables_of_four_bar_fit_middle_screen() {
    for glyphs in [Glyphs::Ascii, Glyphs::Braille] {
        let app = app("four-bar", glyphs, Size::new(120, 40));
        let panes = views::extents(&app);
        let (_, lines, visible, _) = panes[1];
        assert_eq!(panes[1].0, View::Tables);
        assert!(lines <= visible, "{glyphs:?}: {lines} of {visible}");
    }
}

/// At most this part of a pane may be empty while another pane scrolls. Lower panes are excluded.
const MAX_EMPTY: usize = 3;
const MIN_HEIGHT: usize = 10;

#[test]
fn no_pane_is_empty_while_another_one_scrolls() {
    let mut wasted = Vec::new();
    for preset in presets::all() {
        let (middle, large) = (Size::new(120, 40), Size::new(200, 60));
        for (size, views) in [
            (middle, &[View::Motion, View::Working, View::Polygons][..]),
            (large, &View::ALL),
        ] {
            let mut app = app(preset.name, Glyphs::Braille, size);
            for view in views {
                app.update(Action::Look(*view), Duration::ZERO);
                let panes = views::extents(&app);
                let scrolls = panes.iter().any(|(_, lines, visible, _)| lines > visible);
                // Drawings and plots have no lines, and fill their panes.
                let mut filled = panes.iter().filter(|(_, lines, ..)| *lines > 0);
                let is_empty = |(_, lines, visible, height): &(View, usize, usize, usize)| {
                    *height > MIN_HEIGHT && visible.saturating_sub(*lines) > height / MAX_EMPTY
                };
                if scrolls && filled.any(is_empty) {
                    wasted.push(format!("{} {size} {view:?}: {panes:?}", preset.name));
                }
            }
        }
    }
    assert!(wasted.is_empty(), "{wasted:#?}");
}

#[test]
fn maximized_drawing_has_no_tables() {
    for (size, count) in [(Size::new(120, 40), 3), (Size::new(80, 24), 1)] {
        let mut app = app("four-bar", Glyphs::Ascii, size);
        let before = views::extents(&app);
        assert_eq!(before.len(), count);
        app.update(Action::Alone, Duration::ZERO);
        let alone: Vec<View> = views::extents(&app).iter().map(|pane| pane.0).collect();
        assert_eq!(alone, [View::Motion]);
        app.update(Action::Alone, Duration::ZERO);
        assert_eq!(views::extents(&app), before);
    }
}
