//! A second scene beside the open one: its ghost in the drawing, and what the figures differ by.

use crate::claims::{
    assert_dotted, assert_only_a_ghost_is_added, assert_told, cells, drawing, places, said,
};
use crate::screen::{SCREENS, Session, folder, masked, open, text};
use krank::drawing::Glyphs;
use krank::tui::Origin;
use std::fs;

/// The four-bar with a crank of 101 mm.
fn longer() -> String {
    text("four-bar").replace("length = 100", "length = 101")
}

/// The four-bar in inches, as large as it is in millimetres.
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

/// The four-bar, with scenes to compare it with in its folder.
pub(crate) fn beside(test: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
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

/// The words of the first line that begins with this one.
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

/// The four-bar beside one whose coupler is shorter.
fn beside_shorter(test: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let mut session = beside(test, glyphs, cols, rows);
    session.press("D").type_in("shorter").press("Enter");
    session
}

#[test]
fn a_ghost_stands_beside_the_linkage() {
    let mut plain = String::new();
    for (name, glyphs, cols, rows) in SCREENS {
        let alone = drawing(&beside(name, glyphs, cols, rows).body());
        let mut session = beside_shorter(name, glyphs, cols, rows);
        let screen = session.look();
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
        assert_told(&screen, &["this - shorter.toml", "r3 80.0000 0.211*"]);
        let drawn = drawing(&session.body());
        if glyphs == Glyphs::Ascii {
            plain.clone_from(&drawn);
        }
        // Every screen of dots follows that of characters of its size.
        let ghost = places(&cells(&plain), &['.']);
        let least = if cols == 40 { 2 } else { 4 };
        assert!(ghost.len() >= least, "{plain}");
        if glyphs == Glyphs::Braille {
            assert_dotted(&ghost, &drawn);
        }
        if (cols, rows) == (80, 24) {
            assert!(
                assert_only_a_ghost_is_added(&alone, &drawn) >= least,
                "{screen}"
            );
        } else {
            // The window makes room for what the other needs: the figure is a little smaller or larger.
            for name in ['A', 'B', 'C', 'D'] {
                assert_eq!(places(&cells(&drawn), &[name]).len(), 1, "{screen}");
            }
        }
    }
}

#[test]
fn differences_stand_where_figures_stood() {
    for (name, glyphs, cols, rows) in SCREENS {
        let mut session = beside_shorter(&format!("tables-{name}"), glyphs, cols, rows);
        let screen = session.press(if cols > 100 { "2 O" } else { "2" }).look();
        if name == "ascii-40x12" {
            insta::assert_snapshot!("tables-ascii-40x12", screen);
        }
        let mut told = vec![
            "difference: this - shorter.toml",
            "> r2 [0.0000] 0.000",
            "r3 80.0000 0.211*",
            "r4 0.0000 -18.415*",
        ];
        if cols >= 80 {
            told = vec![
                "difference: this - shorter.toml",
                "> r2 [0.0000] 0.000 0 0.00000 0 0.000",
                "r3 80.0000 0.211* 0 2.55432* 0 23.967*",
                "r4 0.0000 -18.415* 0 -0.03147* 0 -22.103*",
                "C 69.3147 39.9545 -117.403 219.225 -7.867 -18.415",
                "-224.9 9765.9 -5507.3 -17.441",
            ];
        }
        if cols >= 120 {
            told.push("1706.7 5060.1 -4806.5 -5.434");
        }
        assert_told(&screen, &told);
    }
}

/// B lies at 101 (cos 60, sin 60) deg there, and at 100 here; it moves at 15 rad/s.
#[test]
fn differences_are_those_of_the_figures() {
    let mut session = beside("numbers", Glyphs::Ascii, 100, 40);
    let screen = session.press("2 D").type_in("longer").press("Enter").look();
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
    // It goes where the driver goes: B is at 90 deg now.
    let screen = session.press("g 9 0 Enter").look();
    assert_eq!(
        row(&screen, "B")[1..6],
        ["0.00000", "-1.00000", "15.0000", "0.0000", "-15.0000"]
    );
    // And the other way round, with the other sign.
    let screen = session.press("D o").type_in("longer").press("Enter").look();
    assert!(!screen.contains("compared with"), "{screen}");
    let origin = Origin::File(folder("numbers-back").join("longer.toml"));
    let mut back = Session::new(open(&longer(), origin), Glyphs::Ascii, 100, 40);
    let screen = back.press("2 D").type_in("four-bar").press("Enter").look();
    assert_eq!(row(&screen, "r2")[1], "1.00000");
    assert_eq!(row(&screen, "r3")[2], "-0.122");
}

#[test]
fn another_unit_is_converted() {
    let mut session = beside("units", Glyphs::Ascii, 100, 40);
    session.press("D").type_in("inches").press("Enter");
    let tables = session.press("2").look();
    assert!(tables.contains("r [mm]"), "{tables}");
    for (name, figures) in [("r2", 1..7), ("r3", 1..7), ("B", 1..6), ("C", 1..6)] {
        for figure in &row(&tables, name)[figures] {
            assert_eq!(figure.parse::<f64>().unwrap(), 0.0, "{name}: {tables}");
        }
    }
}

#[test]
fn rows_without_partner_say_so() {
    let mut session = beside("partners", Glyphs::Ascii, 100, 40);
    let screen = session.press("2 D").type_in("press").press("Enter").look();
    assert_eq!(row(&screen, "r2.com")[1..], ["only", "here"]);
    assert!(screen.contains("only there: r5"), "{screen}");
    // Rates differ by the speeds of the drivers too, which is said.
    let screen = session
        .press("D D")
        .type_in("slider-crank")
        .press("Down Up Enter")
        .look();
    assert!(screen.contains("driven at 15.0 and 200 rad/s"), "{screen}");
}

#[test]
fn where_the_other_has_no_assembly_it_says_so() {
    let mut session = beside("nowhere", Glyphs::Ascii, 80, 24);
    session.press("g 1 8 0 Enter");
    let screen = session.press("D").type_in("shorter").press("Enter").look();
    let title = "\n Four-bar crank-rocker compared with shorte.. ";
    assert!(screen.contains(title), "{screen}");
    assert!(
        screen.contains("| shorter.toml has no assembly.."),
        "{screen}"
    );
    assert_told(&screen, &["| r3 80.0000 -"]);
    // It comes back where it can be.
    let screen = session.press("Home").look();
    assert!(!screen.contains("no assembly"), "{screen}");
}

#[test]
fn a_slide_and_a_link_have_no_coordinate_in_common() {
    let mut session = beside("refused", Glyphs::Ascii, 120, 40);
    let before = session.look();
    let screen = session.press("D").type_in("scissor").press("Enter").look();
    let told = "scissor-lift is driven by a slide, this scene by a link that turns";
    assert!(said(&screen).contains(told), "{screen}");
    // The list stays for another choice.
    let line = session.last_line();
    assert!(line.starts_with(" compare "), "{line}");
    assert_eq!(session.press("Esc").look(), before);
}

#[test]
fn it_ends_by_its_key_and_with_the_scene() {
    let mut session = beside("ends", Glyphs::Ascii, 80, 24);
    let before = session.look();
    session.press("D").type_in("longer").press("Enter");
    assert!(session.look().contains("compared with longer"));
    assert!(session.press("D").last_line().contains("comparison ended"));
    // The message goes with the next key.
    assert_eq!(session.press("Esc").look(), before);
    // What was compared last is under the cursor: to and fro takes two keys.
    let again = session.press("D").look();
    assert!(again.contains("> longer.toml"), "{again}");
    assert!(
        session
            .press("Enter")
            .look()
            .contains("compared with longer")
    );
    assert!(!session.press("n").look().contains("compared with"));
}

/// Whatever is compared with whatever, at whatever size: nothing breaks.
#[test]
fn every_preset_stands_beside_every_other() {
    let presets = krank::scene::presets::all();
    let mut compared = 0;
    for this in presets.iter().step_by(3) {
        let origin = Origin::Preset(this.name.into());
        let mut session = Session::new(open(this.text, origin), Glyphs::Braille, 80, 24);
        for other in presets {
            session.press("D").type_in(other.name);
            if other.name == this.name {
                // Nothing is compared with itself.
                let screen = session.look();
                assert!(!screen.contains(&format!("> {} ", other.name)), "{screen}");
                session.press("Esc");
                continue;
            }
            session.press("Enter");
            let screen = session.look();
            let title = screen.lines().nth(1).unwrap();
            // The end of a long title is cut.
            if title.contains(" compared") {
                compared += 1;
                // Either key ends it.
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
    assert!(compared > 100, "{compared}");
}

/// After an edit, what was opened is the first that is offered, and follows every further edit.
#[test]
fn an_edited_scene_stands_beside_what_was_opened() {
    let mut session = beside("edited", Glyphs::Ascii, 100, 40);
    assert!(!session.press("D").look().contains("as opened"));
    session.press("Esc 6 / r 2 space l e n Enter Enter 1 0 1 Enter");
    let list = session.press("2 D").look();
    assert!(
        list.contains("> as opened") && list.contains("| Four-bar"),
        "{list}"
    );
    let screen = session.press("Enter").look();
    assert!(screen.contains("this - as opened"), "{screen}");
    assert_eq!(row(&screen, "r2")[1..3], ["1.00000", "0.000"]);
    assert_eq!(row(&screen, "B")[1], "0.50000");
    // A further edit: the difference is to what was opened, not to the step before.
    let screen = session.press("6 Enter 1 0 2 Enter 2").look();
    assert_eq!(row(&screen, "r2")[1], "2.00000");
    // Taken back, nothing differs, and the comparison goes on.
    let screen = session.press("u u").look();
    assert_eq!(row(&screen, "r2")[1].parse::<f64>().unwrap(), 0.0);
    assert!(screen.contains("this - as opened"), "{screen}");
}
