//! Tests the motor view.

use crate::claims::{assert_shown, collapse_blanks, figures};
use crate::screen::{Session, folder, open, preset, text};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::Origin;

const SIZES: [(u16, u16); 3] = [(40, 12), (80, 24), (120, 40)];

#[test]
fn curve_and_values_fit_large_and_small_screens() {
    let shown = |glyphs, cols, rows| {
        let mut session = Session::new(preset("four-bar-load"), glyphs, cols, rows);
        session.press(if cols > 100 { "8 O" } else { "8" }).body()
    };
    insta::assert_snapshot!("motor-braille-120x40", shown(Glyphs::Braille, 120, 40));
    insta::assert_snapshot!("motor-ascii-40x12", shown(Glyphs::Ascii, 40, 12));
}

/// Returns everything that scrolling through the view shows.
fn scrolled(name: &str, cols: u16, rows: u16) -> String {
    let mut session = Session::new(preset(name), Glyphs::Ascii, cols, rows);
    let mut seen = session.press(if cols > 100 { "8 O" } else { "8" }).body();
    for _ in 0..120 {
        seen += &session.press("Down").body();
    }
    seen
}

/// Values that do not fit next to the curve are reached by scrolling.
#[test]
fn scrolling_reaches_every_value_on_every_screen() {
    for name in ["four-bar-load", "press-ram"] {
        // The labels of the curve and its axes depend on the space available.
        let large = scrolled(name, 200, 60);
        let report = large.lines().filter(|line| !line.contains("driver.torque"));
        let all = figures(&report.collect::<Vec<_>>().join("\n"));
        for (cols, rows) in [(80, 24), (120, 40)] {
            let seen = figures(&scrolled(name, cols, rows));
            let missing = all.iter().find(|n| n.contains('.') && !seen.contains(*n));
            assert_eq!(missing, None, "{name} at {cols} x {rows}");
        }
    }
    // Forty columns only fit the sum of the parts.
    let lines = [
        "over a turn at 15 rad/s (143.239",
        "torque [N m] all",
        "largest 28.7188",
        "smallest -32.0570",
        "RMS 20.1499",
        "power [W]",
        "largest 430.783",
        "supplied 55.3391",
        "motor: enough, but the flywheel is",
        "flywheel",
        "on the frame, loads included",
    ];
    assert_shown(&scrolled("four-bar-load", 40, 12), &lines);
}

#[test]
fn press_shows_stroke_values_of_its_ram() {
    let mut session = Session::new(preset("press-ram"), Glyphs::Ascii, 120, 40);
    let lines = [
        "N m * driver.torque 44.1 over driver.angle over a turn at 10 rad/s (95.493 rpm), r2 needs 1133.76 N m at",
        "1133.8 at 353.04",
        "largest 1133.76 1188.18 35.4129 21.3254",
        "rated for RMS 500 N m for 359.555: 140.445 N m left (1.39",
        "flywheel of 20 kg m^2 leaves a fluctuation of 0.3544, a",
        "-36.3 at 337.08",
        "force 58374.8 N at 36.420 deg (192.3, 5.837e4);",
    ];
    assert_shown(&session.press("8 O").body(), &lines);
    let mut small = Session::new(preset("press-ram"), Glyphs::Ascii, 80, 24);
    small.press("8");
    assert!(!small.painted_text().contains("time ratio"));
    // Scrolling stops at the end.
    for _ in 0..20 {
        small.press("PgDn");
    }
    let end = small.body();
    assert!(
        end.contains("time ratio") && end.contains("dwells"),
        "{end}"
    );
    assert_eq!(small.press("Down").body(), end);
    insta::assert_snapshot!("motor-press-ascii-80x24-end", end);
}

#[test]
fn scene_without_loads_is_reported_and_still_shows_stroke() {
    let mut plain = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    let nothing = "the scene has no load and no mass, so the driver does no work";
    assert_eq!(collapse_blanks(&plain.press("8").body()), nothing);
    let mut slider = Session::new(preset("offset-slider-crank"), Glyphs::Ascii, 80, 24);
    let shown = slider.press("8").body();
    assert!(
        shown.contains("no load and no mass") && shown.contains("stroke"),
        "{shown}"
    );
    // Y reports that there is nothing to write.
    let before = collapse_blanks(&plain.press("[").painted_text());
    let after = collapse_blanks(&plain.press("Y").painted_text());
    let count = |text: &str| text.matches("no load and no mass").count();
    assert_eq!(count(&after), count(&before) + 1, "{after}");
}

#[test]
fn cursor_follows_driver_and_wraps_after_load_cycle() {
    let mut session = Session::new(preset("engine"), Glyphs::Ascii, 100, 30);
    let at = |session: &mut Session, place: &str| {
        session.press("8 g").type_in(place).press("Enter").body()
    };
    let (first, second) = (at(&mut session, "30"), at(&mut session, "390"));
    assert_ne!(first, second, "the second turn is another one");
    assert_eq!(at(&mut session, "750"), first);
    assert!(first.contains("driver.torque"), "{first}");
}

#[test]
fn view_depends_on_loads_and_returns_with_scene() {
    let mut session = Session::new(preset("four-bar-load"), Glyphs::Ascii, 80, 24);
    let before = session.press("8").body();
    let heavier = text("four-bar-load").replace("[0, -500]", "[0, -600]");
    let origin = Origin::Preset("four-bar-load".into());
    let mut other = Session::new(open(&heavier, origin), Glyphs::Ascii, 80, 24);
    assert_ne!(other.press("8").body(), before);
    // Returning from another scene shows the same view again.
    session.press("n");
    assert_ne!(session.body(), before);
    session.press("p");
    assert_eq!(session.body(), before);
}

#[test]
fn cycle_is_written_and_copied() {
    let folder = folder("take");
    let mut session = Session::new(preset("four-bar-load"), Glyphs::Ascii, 80, 24);
    let mut take = |key: &str, ending: &str| {
        let line = session.press("8").press(key).last_line();
        let proposal = format!("write to: four-bar-load-motor.{ending}");
        assert!(line.contains(&proposal), "{line}");
        let file = folder.join("taken");
        session.press("Ctrl-U").type_in(file.to_str().unwrap());
        session.press("Enter");
        let text = std::fs::read_to_string(&file).unwrap();
        std::fs::remove_file(file).unwrap();
        text
    };
    let csv = take("Y", "csv");
    assert!(
        csv.starts_with("driver.angle [deg],driver.torque [N m],"),
        "{csv}"
    );
    assert_eq!(csv.lines().count(), 362);
    let svg = take("S", "svg");
    assert!(svg.contains("driver.torque"), "{svg}");
    session.press("y");
    assert!(
        session.last_line().contains("clipboard"),
        "{}",
        session.last_line()
    );
}

#[test]
fn every_preset_shows_text_without_nan_or_infinity() {
    for found in presets::all() {
        for (cols, rows) in SIZES {
            let mut session = Session::new(preset(found.name), Glyphs::Ascii, cols, rows);
            let shown = session.press("8").body();
            assert!(shown.is_ascii(), "{shown}");
            assert!(shown.trim().len() > 20, "{}: {shown}", found.name);
            for bad in ["NaN", "inf", "nan"] {
                assert!(!shown.contains(bad), "{}: {shown}", found.name);
            }
        }
    }
}

#[test]
fn manual_screen_of_motor_matches_program() {
    let views = include_str!("../../src/manual/english/views.md");
    let mut session = Session::new(preset("press-ram"), Glyphs::Ascii, 80, 18);
    let screen = session.press("8").painted_text();
    let block = format!("```txt\n{}\n```", screen.trim_end());
    assert!(views.contains(&block), "the manual should show\n{screen}");
}
