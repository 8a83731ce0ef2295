//! Tests the display of tolerances: the band around a curve, and the page of a value.

use crate::capability::Colours;
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::document::opening;
use crate::tui::{Origin, Workbench};

/// Opens a four-bar with length tolerances of 0.5 mm, on a screen with room for names.
fn workbench() -> Workbench {
    let preset = presets::find("four-bar").unwrap();
    let text = format!("tolerance = 0.5\n{}", preset.text);
    let opened = opening::text(&text, Origin::New("four-bar".into())).unwrap();
    Workbench::new(opened, Glyphs::Ascii, Colours::None, 120, 40)
}

#[test]
fn enter_opens_tolerance_page_of_a_value() {
    let mut workbench = workbench();
    workbench.press("9");
    let all = workbench.text();
    assert!(
        all.contains("within tolerances") && !all.contains("worst case"),
        "{all}"
    );
    workbench.press("Enter");
    let first = workbench.text();
    assert!(
        first.contains("r3.angle [deg]") && first.contains("worst case"),
        "{first}"
    );
    workbench.press("Enter");
    assert_eq!(workbench.text(), all);
    workbench.press("/ C . y Enter Enter");
    let found = workbench.text();
    assert!(
        found.contains("C.y [mm]") && found.contains("99.73 % of samples"),
        "{found}"
    );
    assert!(!found.contains("r3.angle [deg]"), "{found}");
    workbench.press("Esc");
    assert!(!workbench.text().contains("worst case"));
}

#[test]
fn tolerance_band_is_listed_at_cursor_and_toggled_by_key() {
    let preset = presets::find("four-bar").unwrap();
    let loose = preset
        .text
        .replace("length = 250", "length = 250, tolerance = 0.5");
    let opened = opening::text(&loose, Origin::New("four-bar".into())).unwrap();
    let mut workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, 120, 40);
    workbench.press("3 O");
    let with = workbench.text();
    let at = with.find("r4.omega worst -").expect(&with);
    let shown_text = with[at..].lines().next().unwrap();
    assert!(shown_text.contains(" +0.0"), "{shown_text}");
    workbench.press("b");
    let without = workbench.text();
    assert!(!without.contains("worst -"), "{without}");
    workbench.press("b");
    assert!(workbench.text().contains("r4.omega worst -"));
    // Clearance in pins is treated to first order, which is symmetric.
    let loose = format!("clearance = 0.5\n{}", preset.text);
    let opened = opening::text(&loose, Origin::New("four-bar".into())).unwrap();
    let mut workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, 120, 40);
    workbench.press("3 O");
    let text = workbench.text();
    assert!(text.contains("r4.omega rss +-0.0"), "{text}");
}
