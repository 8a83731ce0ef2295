//! Tests the motion view with its layers, zoomed and panned.

use crate::claims::{assert_dotted, assert_shown, cells, differences, drawing, pane, places};
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
fn arrows_are_shown_with_their_scale() {
    let arrows = |glyphs| {
        Session::new(preset("four-bar"), glyphs, 80, 24)
            .press("v A")
            .body()
    };
    let shown = arrows(Glyphs::Ascii);
    insta::assert_snapshot!("motion-arrows-ascii-80x24", shown);
    // In Braille, the arrows' heads lie in the same cells and the scale is the same.
    let dotted = arrows(Glyphs::Braille);
    let heads = |screen: &str, heads: [char; 4]| places(&cells(&drawing(screen)), &heads);
    let of_characters = heads(&shown, ['<', '>', '^', 'v']);
    let of_dots = heads(&dotted, ['\u{25c4}', '\u{25ba}', '\u{25b2}', '\u{25bc}']);
    // The last row is the legend, whose arrows start elsewhere.
    let above = |heads: &[(usize, usize)]| heads.iter().filter(|at| at.0 < 20).count();
    assert_eq!(
        of_characters[..above(&of_characters)],
        of_dots[..above(&of_dots)]
    );
    assert!(above(&of_characters) >= 5, "{shown}");
    for screen in [&shown, &dotted] {
        assert_shown(screen, &["v 1000 mm/s ="]);
        assert_shown(screen, &["a 20000 mm/s^2 ="]);
    }
    // On a small screen, arrows have a coarser scale and accelerations are not shown.
    let tiny = Session::new(preset("four-bar"), Glyphs::Ascii, 40, 13)
        .press("v A")
        .body();
    assert_shown(
        &tiny,
        &[
            "<_ __-<<",
            "@ B",
            "o A",
            "v 5000 mm/s = ------->",
            "r4 250.000 290.753*",
        ],
    );
    assert!(!tiny.contains("mm/s^2 ="), "{tiny}");
}

#[test]
fn coupler_curves_are_shown() {
    // The scene names its traced point.
    let traced = |glyphs| {
        let mut session = Session::new(preset("hoecken"), glyphs, 80, 24);
        let shown = session.body();
        [session.press("T").body(), shown]
    };
    let [plain, shown] = traced(Glyphs::Ascii);
    insta::assert_snapshot!("motion-trace-ascii-80x24", shown);
    let curve = differences(&plain, &shown).into_iter();
    let curve: Vec<_> = curve
        .filter(|c| ".:'".contains(c.3))
        .map(|c| (c.0, c.1))
        .collect();
    assert!(curve.len() >= 40, "{shown}");
    assert_dotted(&curve, &traced(Glyphs::Braille)[1]);
    // On a small screen, a leg shows the curve of its foot in the space available.
    let mut leg = Session::new(preset("jansen-leg"), Glyphs::Ascii, 40, 13);
    let shown = leg.press("f").body();
    let plain = leg.press("T").body();
    assert_shown(&shown, &["trace T", "m 15.0000 60.000"]);
    let points = differences(&plain, &shown)
        .into_iter()
        .filter(|c| ".:'".contains(c.3));
    assert!(points.count() >= 6, "{shown}");
}

#[test]
fn all_layers_are_shown_together() {
    let mut session = Session::new(preset("slider-crank"), Glyphs::Braille, 120, 40);
    let body = session.press("i v A T G c").body();
    insta::assert_snapshot!("motion-everything-braille-120x40", &body);
    let plain = session.press("i v A T G c d").body();
    // Only three joints and the lines between them remain: no arrows, traces, names or ground.
    let drawn = drawing(&plain);
    assert_eq!(places(&cells(&drawn), &['o', '@']).len(), 3, "{plain}");
    let all = drawn.chars().filter(|c| c.is_ascii_graphic());
    assert_eq!(all.collect::<String>(), "@o[o]", "{plain}");
    // The tables next to the drawing are the same.
    let tables = |body: &str| pane(body, true);
    assert!(tables(&plain).contains("r3.com"), "{plain}");
    assert_eq!(tables(&plain), tables(&body));
}

/// Each key switches its layer on and off again with a message, and the view returns to its first
/// state.
#[test]
fn layer_keys_toggle_and_restore_the_view() {
    let mut session = Session::new(preset("press"), Glyphs::Ascii, 80, 24);
    let before = session.body();
    for (key, name) in [
        ("v", "velocity arrows on"),
        ("A", "acceleration arrows on"),
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
fn zoom_and_pan_persist_while_linkage_moves() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 25);
    let fitted = session.body();
    let near = session.press("z z L K").body();
    // B and C are twice as far apart as before, within the rounding of a cell, and D is outside the
    // window. The last row is the legend.
    let joints = |body: &str| {
        let mut all = places(&cells(&drawing(body)), &['o', '@']);
        all.retain(|(row, _)| *row < 21);
        all
    };
    let (far, close) = (joints(&fitted), joints(&near));
    let distance = |joints: &[(usize, usize)], down: usize| {
        let (c, b) = (joints[0], joints[down]);
        (b.0 - c.0, c.1 - b.1)
    };
    assert_eq!((far.len(), close.len()), (4, 2), "{near}");
    let (rows, cols) = distance(&far, 1);
    let (more_rows, more_cols) = distance(&close, 1);
    assert!(more_rows.abs_diff(2 * rows) <= 2, "{near}");
    assert!(more_cols.abs_diff(2 * cols) <= 2, "{near}");
    assert!(!drawing(&near).contains('D'), "{near}");
    assert!(near.contains("zoom 2x"), "{near}");
    // The ground stays in place while the driver steps forward and back. The first step plans the
    // names, which then keep their sides.
    let planned = session.press(". . . , , ,").body();
    assert_eq!(joints(&planned), close);
    assert_eq!(session.press(". . . , , ,").body(), planned);
    // Arrows keep their length on the screen, and the legend shows their new scale.
    let arrows = session.press("v").body();
    assert!(
        arrows.contains(" mm/s = --") && arrows.contains("zoom 2x"),
        "{arrows}"
    );
    session.press("v");
    // Another scene is fitted again, and f fits this one.
    assert!(!session.press("n").body().contains("zoom"));
    assert_eq!(session.press("p").body(), fitted);
    assert_eq!(session.press("z H J f").body(), fitted);
}

#[test]
fn zoom_and_pan_limits_are_reported() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    let line = session.press(&"z ".repeat(30)).last_line();
    assert!(line.contains("zoom limit reached"), "{line}");
    assert!(session.body().contains("zoom 64x"));
    let line = session.press("f").press(&"L ".repeat(30)).last_line();
    assert!(line.contains("the motion ends here"), "{line}");
    let line = session.press("f").press(&"Z ".repeat(30)).last_line();
    assert!(line.contains("zoom limit reached"), "{line}");
    assert!(session.body().contains("zoom 0.25x"));
}

/// The legend appears only where it fits, and the drawing stays within its columns.
#[test]
fn smallest_screen_still_shows_the_drawing() {
    for preset in presets::all() {
        let mut session = Session::new(screen::preset(preset.name), Glyphs::Ascii, 40, 12);
        let body = session.press("v A T G c i").body();
        assert!(body.contains('o'), "{}\n{body}", preset.name);
        assert!(body.is_ascii(), "{}\n{body}", preset.name);
    }
}

/// Limits the median size of a frame of the four-bar with traces.
#[test]
fn median_frame_with_traces_costs_few_bytes() {
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
        let maximum = if colours == Colours::None { 700 } else { 900 };
        assert!(
            costs[60] <= maximum,
            "{colours:?}: median {} bytes",
            costs[60]
        );
    }
}

/// Measures the time of a frame: `cargo test --release --test screens motion -- --ignored
/// --nocapture`.
#[test]
#[ignore = "a measurement"]
#[allow(clippy::print_stdout, reason = "whoever measures wants to see it")]
fn measure_frame_with_every_layer() {
    for preset in presets::all() {
        let mut workbench = workbench(preset.name, Glyphs::Braille, Colours::Sixteen, 200, 60);
        let started = Instant::now();
        workbench.press("v A T G c i");
        let found = started.elapsed();
        workbench.paint();
        workbench.press("space");
        let mut times: Vec<Duration> = (0..240)
            .map(|_| {
                let started = Instant::now();
                workbench.pass(Duration::from_millis(34));
                workbench.paint();
                started.elapsed()
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

    /// For any keys, scene and size, nothing panics, and incremental frames add up to a full
    /// repaint.
    #[test]
    fn frames_with_layers_equal_full_repaint(
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
