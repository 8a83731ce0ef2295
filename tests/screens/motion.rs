//! The motion view with its layers, zoomed and panned, as a terminal shows it.

use crate::screen::{self, Session, emulator, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::{Colours, Workbench};
use proptest::prelude::*;
use std::time::{Duration, Instant};

fn workbench(preset: &str, glyphs: Glyphs, colours: Colours, cols: u16, rows: u16) -> Workbench {
    Workbench::new(screen::preset(preset), glyphs, colours, cols, rows)
}

#[test]
fn shows_arrows_with_their_scale() {
    for (name, glyphs) in [
        ("ascii", Glyphs::Ascii),
        ("line", Glyphs::Line),
        ("braille", Glyphs::Braille),
    ] {
        let body = Session::new(preset("four-bar"), glyphs, 80, 24)
            .press("v A")
            .body();
        insta::assert_snapshot!(format!("motion-arrows-{name}-80x24"), body);
    }
    let mut tiny = Session::new(preset("four-bar"), Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!("motion-arrows-ascii-40x12", tiny.press("v A").body());
}

#[test]
fn shows_coupler_curves() {
    for (name, glyphs) in [("ascii", Glyphs::Ascii), ("braille", Glyphs::Braille)] {
        let body = Session::new(preset("hoecken"), glyphs, 80, 24)
            .press("T")
            .body();
        insta::assert_snapshot!(format!("motion-trace-{name}-80x24"), body);
    }
    let mut tiny = Session::new(preset("jansen-leg"), Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!("motion-trace-ascii-40x12", tiny.press("T").body());
}

#[test]
fn shows_everything_at_once() {
    let mut session = Session::new(preset("slider-crank"), Glyphs::Braille, 120, 40);
    let body = session.press("i v A T G c").body();
    insta::assert_snapshot!("motion-everything-braille-120x40", body);
    let bare = session.press("i v A T G c d").body();
    assert!(!bare.contains("mm/s ="), "{bare}");
    insta::assert_snapshot!("motion-bare-braille-120x40", bare);
}

/// Each key switches its layer on, says so, and switches it off again: then all is as it was.
#[test]
fn every_layer_goes_as_it_came() {
    let mut session = Session::new(preset("press"), Glyphs::Ascii, 80, 24);
    let before = session.body();
    for (key, name) in [
        ("v", "arrows of velocity on"),
        ("A", "arrows of acceleration on"),
        ("T", "traces on"),
        ("G", "other positions on"),
        ("c", "centres of mass on"),
        ("d", "guides and supports off"),
    ] {
        let line = session.press(key).last_line();
        assert!(line.contains(name), "{line}");
        assert_ne!(session.body(), before, "{name}");
        assert_eq!(session.press(key).body(), before, "{name}");
    }
    let line = session.press("i").last_line();
    assert!(line.contains("names of points and links"), "{line}");
    assert!(session.body().contains("r3"));
    assert!(session.press("i").last_line().contains("no names"));
    assert_eq!(session.press("i").body(), before);
}

#[test]
fn zooms_and_pans_and_stays_there() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    let fitted = session.body();
    let near = session.press("z z L K").body();
    insta::assert_snapshot!("motion-zoomed-ascii-80x24", near);
    assert!(near.contains("zoom 2x"), "{near}");
    // The ground does not move while the linkage does, nor when a step is taken back.
    session.press(". . . , , ,");
    assert_eq!(session.body(), near);
    // Arrows keep their size, and what they mean is told anew.
    let arrows = session.press("v").body();
    assert!(
        arrows.contains(" mm/s = --") && arrows.contains("zoom 2x"),
        "{arrows}"
    );
    session.press("v");
    // Another scene is fitted again, and this one when it is asked for.
    assert!(!session.press("n").body().contains("zoom"));
    assert_eq!(session.press("p").body(), fitted);
    assert_eq!(session.press("z H J f").body(), fitted);
}

#[test]
fn the_ends_of_zooming_and_panning_are_told() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    let line = session.press(&"z ".repeat(30)).last_line();
    assert!(line.contains("there is no more to zoom"), "{line}");
    assert!(session.body().contains("zoom 64x"));
    let line = session.press("f").press(&"L ".repeat(30)).last_line();
    assert!(line.contains("the motion ends here"), "{line}");
    let line = session.press("f").press(&"Z ".repeat(30)).last_line();
    assert!(line.contains("there is no more to zoom"), "{line}");
    assert!(session.body().contains("zoom 0.25x"));
}

/// The legend is there where there is room for the drawing, and never leaves the drawing's columns.
#[test]
fn the_smallest_screen_keeps_the_drawing() {
    for preset in presets::all() {
        let mut session = Session::new(screen::preset(preset.name), Glyphs::Ascii, 40, 12);
        let body = session.press("v A T G c i").body();
        assert!(body.contains('o'), "{}\n{body}", preset.name);
        assert!(body.is_ascii(), "{}\n{body}", preset.name);
    }
}

/// What a frame costs with every layer on: at most so many bytes for the four-bar, arrows and all.
#[test]
fn layers_cost_few_bytes() {
    for colours in [Colours::Sixteen, Colours::None] {
        let mut workbench = workbench("four-bar", Glyphs::Braille, colours, 80, 24);
        workbench.press("T");
        workbench.paint();
        workbench.press("space");
        let mut costs = Vec::new();
        for _ in 0..120 {
            workbench.pass(Duration::from_secs_f64(4.0 / 120.0));
            costs.push(workbench.paint().len());
        }
        costs.sort_unstable();
        let most = if colours == Colours::None { 700 } else { 900 };
        assert!(costs[60] <= most, "{colours:?}: median {} bytes", costs[60]);
    }
}

/// Not a test but a measurement: `cargo test --release --test screens motion -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
#[allow(clippy::print_stdout, reason = "whoever measures wants to see it")]
fn measure_a_frame_with_every_layer() {
    for preset in presets::all() {
        let mut workbench = workbench(preset.name, Glyphs::Braille, Colours::Sixteen, 200, 60);
        let begun = Instant::now();
        workbench.press("v A T G c i");
        let found = begun.elapsed();
        workbench.paint();
        workbench.press("space");
        let mut times: Vec<Duration> = (0..240)
            .map(|_| {
                let begun = Instant::now();
                workbench.pass(Duration::from_millis(34));
                workbench.paint();
                begun.elapsed()
            })
            .collect();
        times.sort_unstable();
        let name = preset.name;
        println!(
            "{name:22} layers {found:>9.1?}  frame {:>9.1?}  worst {:>9.1?}",
            times[120], times[239]
        );
    }
}

fn keys() -> impl Strategy<Value = Vec<&'static str>> {
    let keys = [
        "i", "v", "A", "T", "G", "c", "d", "z", "Z", "f", "H", "J", "K", "L", "z", "z", ".", ",",
        "a", "Esc", "n", "t", "space",
    ];
    prop::collection::vec(prop::sample::select(keys.to_vec()), 1..40)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Any scene, any size, any zoom: nothing panics, nothing is written outside, and ASCII stays ASCII.
    #[test]
    fn layers_and_windows_of_any_kind_are_drawn(
        keys in keys(),
        preset in 0_usize..40,
        (cols, rows) in (1_u16..220, 1_u16..70),
    ) {
        let all = presets::all();
        let name = all[preset % all.len()].name;
        let mut session = Session::new(screen::preset(name), Glyphs::Ascii, cols, rows);
        for key in keys {
            session.press(key);
            session.workbench.pass(Duration::from_millis(170));
        }
        let shown = session.body();
        session.workbench.forget();
        session.terminal = emulator(cols, rows);
        prop_assert_eq!(shown, session.body());
    }
}
