//! Tests the comparison with a second scene: its ghost in the drawing and the differences of
//! values.

use crate::claims::{
    assert_dotted, assert_only_a_ghost_is_added, assert_shown, cells, collapse_blanks, drawing,
    places,
};
use crate::screen::{SCREENS, Session, folder, masked, open, text};
use krank::drawing::Glyphs;
use krank::tui::Origin;
use std::fs;

/// Returns the four-bar with a crank of 101 mm.
fn longer() -> String {
    text("four-bar").replace("length = 100", "length = 101")
}

/// Returns the four-bar in inches, of the same size as in millimetres.
fn in_inches() -> String {
    let mut text = text("four-bar").replace("\"mm\"", "\"in\"");
    for length in ["400", "100", "300", "250", "150", "125", "310", "230"] {
        let inches = length.parse::<f64>().unwrap() / 25.4;
        for (before, after) in [("= ", " "), ("[", ","), (", ", "]"), ("= ", ",")] {
            let old = format!("{before}{length}{after}");
            text = text.replace(&old, &format!("{before}{inches}{after}"));
        }
    }
    text
}

/// Opens the four-bar in a folder with other scenes to compare it with.
pub(crate) fn open_with_scenes(test: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let folder = folder(test);
    let shorter = text("four-bar").replace("length = 300", "length = 220");
    let scenes = [
        ("longer", longer()),
        ("inches", in_inches()),
        ("shorter", shorter),
    ];
    for (name, text) in scenes {
        fs::write(folder.join(format!("{name}.toml")), text).unwrap();
    }
    let origin = Origin::File(folder.join("mine.toml"));
    Session::new(open(text("four-bar"), origin), glyphs, cols, rows)
}

/// Returns the words of the first line that begins with this name.
fn row(screen: &str, name: &str) -> Vec<String> {
    let lines = screen
        .lines()
        .map(|line| line.trim_start_matches([' ', '>', '+']));
    let mut rows = lines.filter(|line| line.split_whitespace().next() == Some(name));
    let row = rows
        .next()
        .unwrap_or_else(|| panic!("no row {name}:\n{screen}"));
    let figures = row.split_whitespace();
    figures
        .map(|word| word.trim_matches(['[', ']', '*']).to_owned())
        .collect()
}

/// Opens the four-bar, compared with a four-bar whose coupler is shorter.
fn compare_with_shorter(test: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let mut session = open_with_scenes(test, glyphs, cols, rows);
    session.press("D").type_in("shorter").press("Enter");
    session
}

#[test]
fn compared_scene_is_drawn_as_ghost() {
    let mut plain = String::new();
    for (name, glyphs, cols, rows) in SCREENS {
        let alone = drawing(&open_with_scenes(name, glyphs, cols, rows).body());
        let mut session = compare_with_shorter(name, glyphs, cols, rows);
        let screen = session.painted_text();
        if name == "ascii-80x24" {
            insta::assert_snapshot!("motion-ascii-80x24", masked(&screen));
        }
        let title = screen.lines().nth(1).unwrap();
        let has_title = cols > 40;
        assert_eq!(
            title.contains(" compared with short"),
            has_title,
            "{screen}"
        );
        assert_shown(&screen, &["this - shorter.toml", "r3 80.0000 0.211*"]);
        let drawn = drawing(&session.body());
        if glyphs == Glyphs::Ascii {
            plain.clone_from(&drawn);
        }
        // Each Braille screen shows the ghost of the ASCII screen of its size.
        let ghost = places(&cells(&plain), &['.']);
        let minimum = if cols == 40 { 2 } else { 4 };
        assert!(ghost.len() >= minimum, "{plain}");
        if glyphs == Glyphs::Braille {
            assert_dotted(&ghost, &drawn);
        }
        if (cols, rows) == (80, 24) {
            assert!(
                assert_only_a_ghost_is_added(&alone, &drawn) >= minimum,
                "{screen}"
            );
        } else {
            // The window fits both linkages, so that the drawing's scale changes slightly.
            for name in ['A', 'B', 'C', 'D'] {
                assert_eq!(places(&cells(&drawn), &[name]).len(), 1, "{screen}");
            }
        }
    }
}

#[test]
fn tables_show_differences_in_place_of_values() {
    for (name, glyphs, cols, rows) in SCREENS {
        let mut session = compare_with_shorter(&format!("tables-{name}"), glyphs, cols, rows);
        let screen = session
            .press(if cols > 100 { "2 O" } else { "2" })
            .painted_text();
        if name == "ascii-40x12" {
            insta::assert_snapshot!("tables-ascii-40x12", screen);
        }
        let mut lines = vec![
            "difference: this - shorter.toml",
            "> r2 [0.0000] 0.000",
            "r3 80.0000 0.211*",
            "r4 0.0000 -18.415*",
        ];
        if cols >= 80 {
            lines = vec![
                "difference: this - shorter.toml",
                "> r2 [0.0000] 0.000 0 0.00000 0 0.000",
                "r3 80.0000 0.211* 0 2.55432* 0 23.967*",
                "r4 0.0000 -18.415* 0 -0.03147* 0 -22.103*",
                "C 69.3147 39.9545 -117.403 219.225 -7.867 -18.415",
                "-224.9 9765.9 -5507.3 -17.441",
            ];
        }
        if cols >= 120 {
            lines.push("1706.7 5060.1 -4806.5 -5.434");
        }
        assert_shown(&screen, &lines);
    }
}

/// B lies at 101 (cos 60, sin 60) deg in the other scene and at 100 (cos 60, sin 60) deg in this
/// one, and moves at 15 rad/s.
#[test]
fn differences_equal_hand_computed_values() {
    let mut session = open_with_scenes("numbers", Glyphs::Ascii, 100, 40);
    let screen = session
        .press("2 D")
        .type_in("longer")
        .press("Enter")
        .painted_text();
    assert!(
        screen.contains("difference: this - longer.toml"),
        "{screen}"
    );
    assert_eq!(row(&screen, "r2")[1..3], ["-1.00000", "0.000"]);
    assert_eq!(row(&screen, "r3")[1..3], ["0.00000", "0.122"]);
    let b = row(&screen, "B");
    assert_eq!(
        b[1..6],
        ["-0.50000", "-0.86603", "12.9904", "-7.5000", "-15.0000"]
    );
    // Differences follow the driver: B is at 90 deg now.
    let screen = session.press("g 9 0 Enter").painted_text();
    assert_eq!(
        row(&screen, "B")[1..6],
        ["0.00000", "-1.00000", "15.0000", "0.0000", "-15.0000"]
    );
    // Comparing the other way round inverts the signs.
    let screen = session
        .press("D o")
        .type_in("longer")
        .press("Enter")
        .painted_text();
    assert!(!screen.contains("compared with"), "{screen}");
    let origin = Origin::File(folder("numbers-back").join("longer.toml"));
    let mut back = Session::new(open(&longer(), origin), Glyphs::Ascii, 100, 40);
    let screen = back
        .press("2 D")
        .type_in("four-bar")
        .press("Enter")
        .painted_text();
    assert_eq!(row(&screen, "r2")[1], "1.00000");
    assert_eq!(row(&screen, "r3")[2], "-0.122");
}

#[test]
fn differences_convert_units() {
    let mut session = open_with_scenes("units", Glyphs::Ascii, 100, 40);
    session.press("D").type_in("inches").press("Enter");
    let tables = session.press("2").painted_text();
    assert!(tables.contains("r [mm]"), "{tables}");
    for (name, figures) in [("r2", 1..7), ("r3", 1..7), ("B", 1..6), ("C", 1..6)] {
        for figure in &row(&tables, name)[figures] {
            assert_eq!(figure.parse::<f64>().unwrap(), 0.0, "{name}: {tables}");
        }
    }
}

#[test]
fn rows_without_counterpart_are_marked() {
    let mut session = open_with_scenes("partners", Glyphs::Ascii, 100, 40);
    let screen = session
        .press("2 D")
        .type_in("press")
        .press("Enter")
        .painted_text();
    assert_eq!(row(&screen, "r2.com")[1..], ["only", "here"]);
    assert!(screen.contains("only there: r5"), "{screen}");
    // Rates also differ through the drivers' speeds, which the screen names.
    let screen = session
        .press("D D")
        .type_in("slider-crank")
        .press("Down Up Enter")
        .painted_text();
    assert!(screen.contains("driven at 15.0 and 200 rad/s"), "{screen}");
    let mut narrow = open_with_scenes("speeds", Glyphs::Ascii, 40, 12);
    let screen = narrow
        .press("2 D")
        .type_in("slider-crank")
        .press("Down Up Enter");
    let screen = screen.painted_text();
    assert!(screen.contains(" 15.0 and 200 rad/s; this - "), "{screen}");
}

#[test]
fn missing_assembly_of_compared_scene_is_reported() {
    let mut session = open_with_scenes("nowhere", Glyphs::Ascii, 80, 24);
    session.press("g 1 8 0 Enter");
    let screen = session
        .press("D")
        .type_in("shorter")
        .press("Enter")
        .painted_text();
    let title = "\n Four-bar crank-rocker compared with shorte.. ";
    assert!(screen.contains(title), "{screen}");
    assert!(
        screen.contains("| shorter.toml has no assembly.."),
        "{screen}"
    );
    assert_shown(&screen, &["| r3 80.0000 -"]);
    // The ghost returns where the other scene has an assembly.
    let screen = session.press("Home").painted_text();
    assert!(!screen.contains("no assembly"), "{screen}");
}

#[test]
fn comparison_rejects_different_kinds_of_driver() {
    let mut session = open_with_scenes("refused", Glyphs::Ascii, 120, 40);
    let before = session.painted_text();
    let screen = session
        .press("D")
        .type_in("scissor")
        .press("Enter")
        .painted_text();
    let output = "scissor-lift is driven by a slide, this scene by a link that turns";
    assert!(collapse_blanks(&screen).contains(output), "{screen}");
    // The list stays open for another choice.
    let line = session.last_line();
    assert!(line.starts_with(" compare "), "{line}");
    assert_eq!(session.press("Esc").painted_text(), before);
}

#[test]
fn comparison_ends_by_key_and_on_scene_change() {
    let mut session = open_with_scenes("ends", Glyphs::Ascii, 80, 24);
    let before = session.painted_text();
    session.press("D").type_in("longer").press("Enter");
    assert!(session.painted_text().contains("compared with longer"));
    assert!(session.press("D").last_line().contains("comparison ended"));
    // The next key clears the message.
    assert_eq!(session.press("Esc").painted_text(), before);
    // The cursor is on the scene compared last, so that toggling takes two keys.
    let again = session.press("D").painted_text();
    assert!(again.contains("> longer.toml"), "{again}");
    assert!(
        session
            .press("Enter")
            .painted_text()
            .contains("compared with longer")
    );
    assert!(!session.press("n").painted_text().contains("compared with"));
}

/// Comparing presets with each other never breaks the workbench.
#[test]
fn every_preset_compares_with_others() {
    let presets = krank::scene::presets::all();
    let mut compared = 0;
    for (index, this) in presets.iter().enumerate() {
        let origin = Origin::Preset(this.name.into());
        let mut session = Session::new(open(this.text, origin), Glyphs::Braille, 80, 24);
        // Itself and a few others: every preset is compared with some, and some with it.
        for other in [0, 1, 5, 17].map(|apart| &presets[(index + apart) % presets.len()]) {
            session.press("D").type_in(other.name);
            if other.name == this.name {
                // The list omits the open scene itself.
                let screen = session.painted_text();
                assert!(!screen.contains(&format!("> {} ", other.name)), "{screen}");
                session.press("Esc");
                continue;
            }
            session.press("Enter");
            let screen = session.painted_text();
            let title = screen.lines().nth(1).unwrap();
            // Long titles are truncated.
            if title.contains(" compared") {
                compared += 1;
                // D and Esc both end the comparison.
                session.press(if compared % 2 == 0 {
                    ". 2 PgDn Tab 1 , D"
                } else {
                    "Esc"
                });
            } else {
                assert!(screen.contains("is driven by"), "{screen}");
                session.press("Esc");
            }
        }
    }
    assert!(compared > 70, "{compared}");
}

/// After an edit, the list offers the opened state first, and the comparison follows every further
/// edit.
#[test]
fn edited_scene_compares_with_its_opened_state() {
    let mut session = open_with_scenes("edited", Glyphs::Ascii, 100, 40);
    assert!(!session.press("D").painted_text().contains("as opened"));
    session.press("Esc 6 / r 2 space l e n Enter Enter 1 0 1 Enter");
    let list = session.press("2 D").painted_text();
    assert!(
        list.contains("> as opened") && list.contains("| Four-bar"),
        "{list}"
    );
    let screen = session.press("Enter").painted_text();
    assert!(screen.contains("this - as opened"), "{screen}");
    assert_eq!(row(&screen, "r2")[1..3], ["1.00000", "0.000"]);
    assert_eq!(row(&screen, "B")[1], "0.50000");
    // After a further edit, the difference still refers to the opened state, not to the step
    // before.
    let screen = session.press("6 Enter 1 0 2 Enter 2").painted_text();
    assert_eq!(row(&screen, "r2")[1], "2.00000");
    // After undo, all differences are zero and the comparison stays active.
    let screen = session.press("u u").painted_text();
    assert_eq!(row(&screen, "r2")[1].parse::<f64>().unwrap(), 0.0);
    assert!(screen.contains("this - as opened"), "{screen}");
}
