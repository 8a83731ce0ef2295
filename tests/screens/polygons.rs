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
        "position",
        "mm = ",
        "r4",
        "velocity",
        "mm/s = ",
        "vB",
        "vC/B",
        "acceleration",
        "mm/s^2 = ",
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

/// Returns the scales of the visible polygons, such as `v 1000 mm/s = ---->`.
fn scales(screen: &str) -> Vec<&str> {
    let starts = ["r ", "v ", "a "];
    let lines = screen.lines().filter(|line| line.contains(" = -"));
    let pieces = lines.flat_map(|line| line.split("  ").map(str::trim));
    let scales = pieces.map(|piece| piece.rsplit(['|', '+']).next().unwrap_or(piece).trim());
    scales
        .filter(|piece| {
            piece.contains(" = -") && starts.iter().any(|start| piece.starts_with(start))
        })
        .collect()
}

#[test]
fn every_polygon_has_a_scale_with_its_unit() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40), (200, 60)] {
        let screen = session("press", cols, rows).body();
        let scales = scales(&screen);
        let titles = ["position, loop", "velocity, loop", "acceleration, loop"];
        let panels = titles.map(|title| screen.matches(title).count());
        assert_eq!(scales.len(), panels.iter().sum::<usize>(), "{screen}");
        assert!(panels[0] > 0, "{screen}");
    }
}

/// The coordinates lie between the samples that determine the scale, and around the peaks of all rates.
#[test]
fn polygons_move_with_linkage_at_fixed_scale() {
    let mut session = session("four-bar", 120, 40);
    let before = session.body();
    let kept: Vec<String> = scales(&before).into_iter().map(str::to_owned).collect();
    assert_eq!(kept.len(), 3, "{before}");
    for k in 0..52 {
        session
            .press("g")
            .type_in(&format!("{}", 1.3 + 7.0 * f64::from(k)));
        let after = session.press("Enter").body();
        assert_ne!(before, after);
        assert_eq!(scales(&after), kept, "{after}");
    }
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

#[test]
fn polygons_of_presets_are_drawn_at_every_size() {
    for preset in presets::all() {
        for (cols, rows) in [(40, 12), (80, 24), (200, 60)] {
            let mut session = session(preset.name, cols, rows);
            // Polygons belong to the motion of the driver: a leading point gives way to it.
            session.press(match preset.name {
                "plotter" => "U . .",
                _ => ". . space",
            });
            session.pass(1.0);
            // Only the robot arm has no loop.
            let shown = if preset.name == "robot-arm" {
                "loop"
            } else {
                "position"
            };
            assert!(session.body().contains(shown), "{}", preset.name);
        }
    }
}

#[test]
fn relative_acceleration_of_a_slide_includes_coriolis() {
    let screen = session("slotted-lever", 200, 60).press("O").body();
    assert!(screen.contains("aB c"), "{screen}");
}

/// At a dead point there is a position, and a reason in place of each polygon of rates.
#[test]
fn panels_without_rates_show_the_reason() {
    let mut session = session("double-rocker", 120, 40);
    session.press("g").type_in("101.53695903281549");
    let screen = session.press("Enter O").body();
    assert_eq!(screen.matches("dead point").count(), 2, "{screen}");
    assert_eq!(scales(&screen).len(), 1, "{screen}");
}
