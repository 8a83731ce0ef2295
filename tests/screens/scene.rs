//! Tests editing in the scene view, driven by key scripts.

use crate::claims::{assert_shown, pane};
use crate::screen::{self, Session, four_bar};
use krank::drawing::Glyphs;
use krank::scene::presets;
use proptest::prelude::*;

/// Actions on the list of values.
pub(crate) trait Values {
    /// Moves the cursor to a value.
    fn find(&mut self, name: &str) -> &mut Self;
    /// Returns the row under the cursor, without the drawing next to it.
    fn row(&mut self) -> String;
}

impl Values for Session {
    fn find(&mut self, name: &str) -> &mut Self {
        self.press("/").type_in(name).press("Enter")
    }

    fn row(&mut self) -> String {
        let screen = self.painted_text();
        let row = screen.lines().find(|line| line.starts_with(" >")).unwrap();
        let words = row.split(" | ").next().unwrap().split_whitespace();
        words.collect::<Vec<_>>().join(" ")
    }
}

#[test]
fn scene_view_lists_every_value() {
    insta::assert_snapshot!("scene-120x40", four_bar(120, 40).press("6").painted_text());
    // On the smallest screen, the list fills the screen and can be scrolled.
    let lines = [
        "nudge by 2 mm",
        "> A x 0 mm",
        "D x 400 mm",
        "driver angle 60 deg",
        "driver speed 15 rad/s",
        "r2 length 100 mm",
        "r2 com y 0 mm v",
        "scene four-bar 60.00 deg ok ? help",
    ];
    let mut tiny = four_bar(40, 13);
    assert_shown(&tiny.press("6").painted_text(), &lines);
    assert_eq!(tiny.press("PgDn PgDn PgDn").row(), "> C start y 230 mm");
}

#[test]
fn typed_value_with_unit_updates_list_and_drawing() {
    for (cols, rows) in [(80, 24), (40, 13)] {
        let mut session = four_bar(cols, rows);
        session
            .press("6")
            .find("r2 len")
            .press("Enter")
            .type_in("4,5 in");
        let typing = session.painted_text();
        if cols == 80 {
            insta::assert_snapshot!("scene-typing-80x24", typing);
        }
        let lines = [
            "D y 0 mm",
            "> r2 length 4,5 in",
            "r2 com x 0 mm",
            "edit r2 length [mm, cm, m, in]",
        ];
        assert_shown(&typing, &lines);
        let drawn_before = pane(&session.body(), true);
        // The value is accepted and marked as changed, in its row with the previous value and in
        // the last line.
        let changed = session.press("Enter").painted_text();
        let lines = if cols == 80 {
            [
                "in the file",
                ">*r2 length 114.3 mm 100 |",
                "scene four-bar* 60.00 deg",
            ]
        } else {
            [
                "file: 100",
                ">*r2 length 114.3 mm",
                "scene four-bar* 60.00 deg",
            ]
        };
        assert_shown(&changed, &lines);
        // The other values are unchanged, and the drawing next to them shows the new crank.
        let values = |screen: &str| -> Vec<String> {
            let rows = screen.lines().skip(2).filter(|row| row.starts_with("   "));
            rows.map(|row| row.chars().take(43).collect()).collect()
        };
        assert_eq!(values(&typing), values(&changed));
        assert!(values(&changed).len() >= 8, "{changed}");
        let drawn_after = pane(&session.body(), true);
        assert_eq!(drawn_before == drawn_after, cols == 40);
    }
}

/// An invalid value is reported immediately, and the last valid state stays in the row, in the
/// drawing and in all views.
#[test]
fn invalid_edit_keeps_last_valid_state() {
    let mut session = four_bar(80, 24);
    session.press("6").find("r3 len");
    let before = session.painted_text();
    for (typed, text) in [
        ("0", "must be positive, not `0`"),
        ("-5", "must be positive, not `-5`"),
        ("1000", "r3 length 1000: C out of reach by"),
        ("5 kg", "kg does not fit here: mm, cm, m, in"),
        (
            "much",
            "not a number: much; type one, plain or in mm, cm, m, in",
        ),
    ] {
        let line = session
            .press("Enter")
            .type_in(typed)
            .press("Enter")
            .last_line();
        assert!(line.contains(text), "{line}");
        assert_eq!(session.press("Esc").painted_text(), before, "{typed}");
    }
    // Nudging stops where the linkage would no longer open.
    session.find("r2 len");
    for _ in 0..12 {
        session.press("}");
    }
    let line = session.press("> > > >").last_line();
    assert!(line.contains("r2 length"), "{line}");
    let stopped = session.row();
    assert_eq!(session.press(">").row(), stopped);
}

#[test]
fn nudges_use_increment_and_are_undone_together() {
    let mut session = four_bar(80, 24);
    session.press("6").find("r2 len").press("> > >");
    assert_eq!(session.row(), ">*r2 length 103 mm 100");
    session.press("{ >");
    assert_eq!(session.row(), ">*r2 length 103.5 mm 100");
    assert!(session.painted_text().contains("nudge by 0.5 mm"));
    let line = session.press("u").last_line();
    assert!(line.contains("r2 length undone"), "{line}");
    assert_eq!(session.row(), "> r2 length 100 mm");
    session.press("Ctrl-R");
    assert_eq!(session.row(), ">*r2 length 103.5 mm 100");
    let line = session.press("Ctrl-R").last_line();
    assert!(line.contains("nothing to redo"), "{line}");
    // Other views show the linkage with its new crank.
    let tables = session.press("2").painted_text();
    assert!(tables.contains("103.5"), "{tables}");
}

/// If the current angle is out of reach after an edit, the nearest end of the range is shown with a
/// message.
#[test]
fn edit_keeps_driver_angle_unless_out_of_reach() {
    let mut session = four_bar(80, 24);
    session.press("g 1 8 0 Enter 6").find("r2 len");
    let line = session
        .press("Enter")
        .type_in("110")
        .press("Enter")
        .last_line();
    assert!(line.contains("180.00 deg"), "{line}");
    let line = session
        .press("Enter")
        .type_in("180")
        .press("Enter")
        .last_line();
    assert!(line.contains("180.00 deg is out of reach now"), "{line}");
    // Undo brings the driver back, unless it was moved since.
    let line = session.press("u").last_line();
    assert!(line.contains("180.00 deg"), "{line}");
    // Regression: the limit that was left was called out of reach.
    assert!(!line.contains("out of reach"), "{line}");
    let line = session.press("Ctrl-R , u").last_line();
    assert!(!line.contains("180.00 deg"), "{line}");
    // Editing the driver's own angle moves the linkage.
    session.find("driver angle").press("Enter");
    let line = session
        .type_in("1.5707963267948966 rad")
        .press("Enter")
        .last_line();
    assert!(line.contains("90.00 deg"), "{line}");
}

/// An edit never switches to the other assembly: where the edited text would, `[start]` is changed.
#[test]
fn edit_keeps_assembly_unless_start_is_moved() {
    let mut session = four_bar(80, 24);
    // With D this high, C = [310, 230] would be nearer to the other assembly: by hand, the circles
    // about B and D meet at (158.9, 366.1) and (348.4, 55.4), which are 203 mm and 179 mm away.
    session.press("6").find("D y").press("Enter");
    let line = session.type_in("300").press("Enter").last_line();
    assert!(line.contains("[start] changed"), "{line}");
    let screen = session.painted_text();
    assert!(screen.contains("*C start x     158.9"), "{screen}");
    assert!(screen.contains("*C start y     366.1"), "{screen}");
    // One undo reverts both.
    let screen = session.press("u").painted_text();
    assert!(screen.contains(" C start x     310 "), "{screen}");
    assert!(!screen.contains("four-bar*"), "{screen}");
    // A start that is moved on purpose selects the other assembly.
    let mut session = four_bar(80, 24);
    let before = session.painted_text();
    assert!(before.contains("29.379"), "{before}");
    session
        .press("6")
        .find("C start y")
        .press("Enter")
        .type_in("-165")
        .press("Enter");
    session
        .find("C start x")
        .press("Enter")
        .type_in("212")
        .press("Enter");
    let crossed = session.press("1").painted_text();
    assert!(crossed.contains("302.825"), "{crossed}");
    let again = session.press("u u").painted_text();
    assert!(again.contains("29.379"), "{again}");
}

#[test]
fn switching_assembly_is_an_undoable_edit() {
    let mut session = four_bar(80, 24);
    session.press("a Enter");
    assert!(session.painted_text().contains("302.825"));
    let screen = session.press("6").painted_text();
    assert!(screen.contains("*C start x     212.622"), "{screen}");
    session.find("r2 len").press(">");
    assert!(session.press("1").painted_text().contains("C"));
    session.press("u");
    assert!(
        session.painted_text().contains("302.825"),
        "{}",
        session.painted_text()
    );
    session.press("u");
    assert!(
        session.painted_text().contains("29.379"),
        "{}",
        session.painted_text()
    );
}

#[derive(Clone, Debug)]
enum TestAction {
    Press(&'static str),
    Type(String),
}

fn actions() -> impl Strategy<Value = Vec<TestAction>> {
    let keys = [
        "Up", "Down", "PgDn", "PgUp", "<", ">", "{", "}", "}", "u", "Ctrl-R", "Enter", "Esc", ".",
        "a", "1", "6", "6", "R",
    ];
    let text = prop_oneof![
        Just(String::new()),
        "[-0-9.,e]{1,6}( (mm|in|deg|rad|rpm|kg))?",
        (1_u32..2000).prop_map(|n| (f64::from(n) / 10.0).to_string()),
    ];
    let action = prop_oneof![
        6 => prop::sample::select(keys.to_vec()).prop_map(TestAction::Press),
        2 => text.prop_map(TestAction::Type),
    ];
    prop::collection::vec(action, 1..40)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// After any typing and nudging, undoing everything leaves the scene unchanged.
    #[test]
    fn random_edits_can_all_be_undone(actions in actions(), preset in 0_usize..100) {
        let preset = &presets::all()[preset % presets::all().len()];
        let mut session = Session::new(screen::preset(preset.name), Glyphs::Ascii, 80, 24);
        session.press("6");
        for action in actions {
            match action {
                TestAction::Press(key) => {
                    session.press(key);
                }
                TestAction::Type(text) => {
                    session.press("Enter").type_in(&text).press("Enter Esc 6");
                }
            }
        }
        session.press("Esc Esc 6");
        for _ in 0..60 {
            session.press("u");
        }
        let line = session.last_line();
        prop_assert!(line.contains("nothing to undo"), "{}", line);
        let changed = format!("{}*", preset.name);
        let screen = session.press("1").painted_text();
        prop_assert!(!screen.contains(&changed), "{}", screen);
    }
}
