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
        let (_, lines, visible) = panes[1];
        assert_eq!(panes[1].0, View::Tables);
        assert!(lines <= visible, "{glyphs:?}: {lines} of {visible}");
    }
}

#[test]
fn no_pane_is_empty_while_another_one_scrolls() {
    for preset in presets::all() {
        for size in [Size::new(120, 40), Size::new(200, 60)] {
            let mut app = app(preset.name, Glyphs::Braille, size);
            for view in [View::Motion, View::Forces, View::Working, View::Polygons] {
                app.update(Action::Look(view), Duration::ZERO);
                check_space(preset.name, size, &views::extents(&app));
            }
        }
    }
}

fn check_space(preset: &str, size: Size, panes: &[(View, usize, usize)]) {
    let scrolls: Vec<_> = panes.iter().filter(|pane| pane.1 > pane.2).collect();
    let is_list = |view| matches!(view, View::Tables | View::Scene);
    let empty = panes.iter().filter(|pane| is_list(pane.0));
    let mut empty = empty.filter(|(_, lines, visible)| visible - lines.min(visible) > visible / 3);
    let is_wrong = !scrolls.is_empty() && empty.next().is_some();
    assert!(!is_wrong, "{preset} {size}: {panes:?}");
}

#[test]
fn maximized_drawing_has_no_tables() {
    for (size, count) in [(Size::new(120, 40), 3), (Size::new(80, 24), 1)] {
        let mut app = app("four-bar", Glyphs::Ascii, size);
        let before = views::extents(&app);
        assert_eq!(before.len(), count);
        app.update(Action::Alone, Duration::ZERO);
        assert_eq!(views::extents(&app), [(View::Motion, 0, 0)]);
        app.update(Action::Alone, Duration::ZERO);
        assert_eq!(views::extents(&app), before);
    }
}
