//! Tests the polygons view.

use crate::screen::{Session, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;

fn session(name: &str, cols: u16, rows: u16) -> Session {
    let mut session = Session::new(preset(name), Glyphs::Ascii, cols, rows);
    session.press("0");
    session
}

#[test]
fn polygons_of_loop_are_shown_with_their_scales() {
    let mut session = session("four-bar", 120, 40);
    let screen = session.painted_text();
    // The polygons are next to the drawing.
    let names = [
        "position  r ",
        "r4",
        "velocity  v ",
        "vB",
        "vC/B",
        "acceleration  a ",
        "aB n",
    ];
    for name in names {
        assert!(screen.contains(name), "{name}: {screen}");
    }
    // Alone, the view still has all three.
    let alone = session.press("O").painted_text();
    for name in ["r4", "vB", "vC/B", "aB n"] {
        assert!(alone.contains(name), "{name}: {alone}");
    }
}

#[test]
fn polygons_move_with_linkage_at_fixed_scale() {
    let mut session = session("four-bar", 120, 40);
    let titles = |screen: &str| {
        let titles = screen.lines().filter(|line| line.contains("velocity  v "));
        let title = |line: &str| line.rsplit('|').next().map(str::to_owned);
        titles.map(title).collect::<Vec<_>>()
    };
    let before = session.body();
    assert_eq!(titles(&before).len(), 1, "{before}");
    let after = session.press(". . . .").body();
    assert_ne!(before, after);
    assert_eq!(titles(&before), titles(&after));
}

#[test]
fn all_loops_can_be_reached_by_scrolling() {
    let mut session = session("jansen-leg", 80, 24);
    let mut seen = session.body();
    for _ in 0..40 {
        seen += &session.press("Down").body();
    }
    for number in 1..=3 {
        assert!(
            seen.contains(&format!("acceleration, loop {number}")),
            "{seen}"
        );
    }
}

/// At a dead point there are no rates, and a slide has Coriolis's acceleration.
#[test]
fn polygons_of_presets_are_drawn_at_every_size() {
    for preset in presets::all() {
        for (cols, rows) in [(40, 12), (80, 24), (200, 60)] {
            let mut session = session(preset.name, cols, rows);
            session.press(". . G space");
            session.pass(1.0);
            assert!(!session.body().trim().is_empty(), "{}", preset.name);
        }
    }
    let mut lever = session("slotted-lever", 120, 40);
    let screen = lever.press("O").painted_text();
    assert!(screen.contains(" c"), "{screen}");
}
