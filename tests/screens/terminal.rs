//! Tests the bytes sent to the terminal for every kind of glyphs and colours, and the last line.

use crate::screen::{Session, preset};
use krank::drawing::Glyphs;
use krank::tui::{Colours, Theme, Workbench};
use std::time::Duration;

fn opened(name: &str, glyphs: Glyphs, colours: Colours) -> Session {
    let workbench = Workbench::new(preset(name), glyphs, colours, 80, 24);
    Session::on(workbench, 80, 24)
}

/// Returns the median number of bytes of a frame, over a turn of 120 frames.
fn median(glyphs: Glyphs, colours: Colours, theme: Theme) -> usize {
    let workbench = Workbench::new(preset("four-bar"), glyphs, colours, 80, 24);
    let mut workbench = workbench.themed(theme);
    workbench.paint();
    assert!(workbench.paint().is_empty(), "nothing has changed");
    workbench.press("space");
    let mut costs: Vec<_> = (0..120)
        .map(|_| {
            workbench.pass(Duration::from_secs_f64(4.0 / 120.0));
            workbench.paint().len()
        })
        .collect();
    costs.sort_unstable();
    let median = costs[60];
    workbench.press("space");
    workbench.paint();
    workbench.pass(Duration::from_secs(1));
    assert!(workbench.paint().is_empty(), "paused is paused");
    median
}

/// `cargo test --test screens terminal -- --nocapture` prints the sizes.
#[test]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn median_frame_size_stays_small_in_every_glyph_and_colour() {
    for (colours, maximum) in [
        (Colours::None, 700),
        (Colours::Sixteen, 900),
        (Colours::Indexed, 900),
        (Colours::True, 900),
    ] {
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
                let bytes = median(glyphs, colours, theme);
                println!(
                    "{glyphs:?}, {}, {}: {bytes} bytes",
                    colours.name(),
                    theme.name()
                );
                assert!(bytes <= maximum, "{glyphs:?} {colours:?}: {bytes}");
            }
        }
    }
}

/// The screen after a switch equals that of a session started with those colours.
#[test]
fn colour_key_switches_at_once() {
    let four_bar = |colours| opened("four-bar", Glyphs::Braille, colours);
    let mut session = four_bar(Colours::Sixteen);
    let mut seen = Vec::new();
    for colours in ["256", "24-bit colours", "no colours", "16 colours"] {
        let line = session.press("C").last_line();
        assert!(line.contains(colours), "{line}");
        session.press("Home Ctrl-L");
        seen.push(session.terminal.screen().state_formatted());
    }
    for (colours, seen) in [
        Colours::Indexed,
        Colours::True,
        Colours::None,
        Colours::Sixteen,
    ]
    .into_iter()
    .zip(seen)
    {
        let mut anew = four_bar(colours);
        anew.paint();
        assert_eq!(anew.terminal.screen().state_formatted(), seen);
    }
}

#[test]
fn last_line_announces_dead_and_change_points_ahead() {
    let mut session = opened("peaucellier", Glyphs::Ascii, Colours::Sixteen);
    let line = session.press("g 7 9 . 6 2 Enter").last_line();
    assert!(
        line.starts_with(" motion  peaucellier    79.62 deg  dead point in 3.2 deg  "),
        "{line}"
    );
    let line = session.press("r").last_line();
    assert!(line.contains("  79.62 deg  ok"), "it moves away: {line}");
    let line = session.press("r g 5 0 Enter").last_line();
    assert!(line.contains("  50.00 deg  ok"), "{line}");
    let mut kite = opened("parallelogram", Glyphs::Ascii, Colours::Sixteen);
    let line = kite.press("g 1 7 0 Enter").last_line();
    assert!(line.contains("change point in 10.0 deg"), "{line}");
}

#[test]
fn last_line_hints_stay_in_place_while_playing() {
    for (name, from) in [("peaucellier", "g 6 0 Enter"), ("four-bar", "g 3 Enter")] {
        let mut session = opened(name, Glyphs::Ascii, Colours::Sixteen);
        session.press(from).press("space");
        let mut places = Vec::new();
        for _ in 0..20 {
            session.workbench.pass(Duration::from_millis(33));
            places.push(session.last_line().find("? help"));
        }
        places.dedup();
        assert_eq!(places.len(), 1, "{name}: {places:?}");
    }
}
