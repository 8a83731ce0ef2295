//! Tests the plots of a comparison: curves of the second scene.

use crate::claims::{assert_shown, cells, differences, places};
use crate::compare::open_with_scenes;
use krank::drawing::Glyphs;

/// Asserts that the second scene's curve is dotted. Its crank is 1 % longer, so that its points lie
/// on the curve and next to it.
#[track_caller]
fn assert_curve_is_dotted(alone: &str, compared: &str) {
    let changed = differences(alone, compared);
    let dotted = |was: char| changed.iter().filter(|c| c.2 == was && c.3 == '.').count();
    assert!(dotted('*') >= 10, "{compared}");
    assert!(dotted('*') > dotted(' '), "{compared}");
    // The marks of driver, extrema and axes stay in place.
    let chart = |screen: &str| {
        let is_text =
            |line: &str| line.contains("crank") || line.contains("r4.") || line.contains("plots");
        let lines = screen
            .lines()
            .map(|line| if is_text(line) { "" } else { line }.to_owned() + "\n");
        places(
            &cells(&lines.collect::<String>()),
            &['O', '^', 'v', '+', ':'],
        )
    };
    let after = chart(compared);
    let lost = chart(alone)
        .into_iter()
        .find(|place| !after.contains(place));
    assert_eq!(lost, None, "{alone}{compared}");
}

/// The second scene's curves are dotted, converted to the unit of the open scene, and end with the
/// comparison.
#[test]
fn plots_show_compared_scene_as_dotted_curve() {
    let screens = [
        ("ascii-80x24", Glyphs::Ascii, 80, 24),
        ("braille-120x40", Glyphs::Braille, 120, 40),
        ("ascii-40x12", Glyphs::Ascii, 40, 12),
    ];
    for (name, glyphs, cols, rows) in screens {
        let mut session = open_with_scenes(&format!("plots-{name}"), glyphs, cols, rows);
        let alone = session
            .press(if cols > 100 { "3 O" } else { "3" })
            .painted_text();
        session.press("D").type_in("longer").press("Enter");
        // The opening message has expired.
        let screen = session.pass(9.0).painted_text();
        let (own, other) = if cols == 40 {
            ("r4.omega 3.0911 +1", "plots mine.toml 60.00 deg ok ? help")
        } else {
            ("r4.alpha 95.50", "r4.omega longer.toml")
        };
        assert_shown(&screen, &[other]);
        assert_shown(&screen, &[own]);
        match glyphs {
            Glyphs::Braille => insta::assert_snapshot!(format!("plots-{name}"), screen),
            _ => assert_curve_is_dotted(&alone, &screen),
        }
        // Switching views keeps the dotted curves; ending the comparison removes them.
        assert_eq!(session.press("m m").pass(9.0).painted_text(), screen);
        assert_eq!(session.press("1 3").painted_text(), screen);
        assert_eq!(session.press("D , .").painted_text(), alone);
    }
    // The same scene in inches has the same axis and ticks.
    let mut session = open_with_scenes("plots-units", Glyphs::Ascii, 80, 24);
    session.press("3 x c / B . x Enter space Esc");
    let alone = session.press("Esc").painted_text();
    assert!(alone.contains("B.x"), "{alone}");
    let screen = session
        .press("D")
        .type_in("inches")
        .press("Enter")
        .painted_text();
    assert!(screen.contains("B.x inches.toml"), "{screen}");
    let ticks = |screen: &str| -> Vec<String> {
        let labels = screen
            .lines()
            .skip(2)
            .filter_map(|line| line.split_once('|'));
        labels.map(|(label, _)| label.trim().to_owned()).collect()
    };
    assert_eq!(ticks(&screen), ticks(&alone), "{screen}\n{alone}");
}
