//! Tests the other assemblies of a scene: listing, choosing and saving them.

use crate::claims::{assert_only_a_ghost_is_added, assert_shown, drawing};
use crate::screen::{Session, open, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::Origin;

fn four_bar(glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), glyphs, cols, rows)
}

/// The list replaces the tables, and the ghosts consist of dots.
#[test]
fn other_assemblies_are_listed_and_drawn_as_ghosts() {
    let screen = four_bar(Glyphs::Ascii, 80, 24).press("a").painted_text();
    insta::assert_snapshot!("assemblies-ascii-80x24", screen);
    let mut coupled = Session::new(preset("stephenson-six-bar"), Glyphs::Ascii, 80, 24);
    let lines = [
        "| > E 1 (118.9, 254.7) now",
        "E 2 (152.1, 200.8)",
        "choose stephenson-six-bar",
    ];
    assert_shown(&coupled.press("a Up").painted_text(), &lines);
    let lines = [
        "C + (311.4, 233.8) now",
        "> C - (212.6, -165.5)",
        "choose 60.00 deg Enter take",
    ];
    let mut tiny = four_bar(Glyphs::Ascii, 40, 13);
    assert_shown(&tiny.press("a").painted_text(), &lines);
    let points = drawing(&tiny.body()).matches('.').count();
    assert!(points >= 4, "{}", tiny.body());
}

/// A ghost is drawn below everything: no part of the linkage moves or is painted over.
#[test]
fn ghost_adds_only_dots_to_drawing() {
    for (name, keys) in [("four-bar", "a"), ("stephenson-six-bar", "a Up")] {
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            let mut session = Session::new(preset(name), glyphs, 80, 24);
            let before = drawing(&session.body());
            let after = drawing(&session.press(keys).body());
            assert!(
                assert_only_a_ghost_is_added(&before, &after) >= 4,
                "{after}"
            );
        }
    }
}

#[test]
fn chosen_assembly_persists_over_a_full_turn() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let before = session.painted_text();
    let closed = session.press("a Esc").painted_text();
    assert_eq!(closed, before, "a look changes nothing");
    let line = session.press("a Enter").last_line();
    assert!(line.contains("C=- now; w saves it"), "{line}");
    let crossed = session.painted_text();
    // The coupler's direction at 60 deg, now and a full turn later.
    assert!(crossed.contains("302.825"), "{crossed}");
    session.press("space").pass(4.0).press("space g 6 0 Enter");
    let later = session.painted_text();
    assert!(later.contains("302.825"), "{later}");
    // The cursor is now on the other assembly, so that Enter switches back.
    let again = session.press("a Enter").painted_text();
    assert!(again.contains("29.379"), "{again}");
}

#[test]
fn open_assembly_is_rejected() {
    let mut session = Session::new(preset("press"), Glyphs::Ascii, 80, 24);
    let screen = session.press("a Up Up Up").painted_text();
    let row = screen.lines().find(|l| l.contains(" C - ")).unwrap();
    assert!(row.trim_end().ends_with("open"), "{row}");
    let line = session.press("Down Enter").last_line();
    assert!(line.contains("no assembly with C=-"), "{line}");
    let mut yoke = Session::new(preset("scotch-yoke"), Glyphs::Ascii, 80, 24);
    let line = yoke.press("a").last_line();
    assert!(line.contains("there is no other assembly here"), "{line}");
}

#[test]
fn assembly_change_is_saved_to_file() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("saving");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mine.toml");
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("[start]", "# rough\n[start]");
    std::fs::write(&file, &text).unwrap();
    let opened = open(&text, Origin::File(file.clone()));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("a Enter");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text, "not unasked");
    let line = session.press("w").last_line();
    assert!(line.contains("written to "), "{line}");
    let saved = std::fs::read_to_string(&file).unwrap();
    assert!(
        saved.contains("# rough\n[start]\nC = [212.622, -165.497]"),
        "{saved}"
    );
    // A second save uses the file's present text, but never overwrites another program's changes.
    let line = session.press("a Enter w").last_line();
    assert!(line.contains("written to "), "{line}");
    std::fs::write(&file, text.replace("15 rad/s", "16 rad/s")).unwrap();
    let screen = session.press("a Enter w").painted_text();
    assert!(screen.contains("has changed on disk"), "{screen}");
    assert!(std::fs::read_to_string(&file).unwrap().contains("16 rad/s"));
}

#[test]
fn preset_is_saved_under_typed_name() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let line = session.press("w").last_line();
    assert!(line.contains("write to: four-bar.toml"), "{line}");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("saving-as");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("new.toml");
    let keys: Vec<String> = file.to_str().unwrap().chars().map(String::from).collect();
    session.press("Ctrl-U").press(&keys.join(" "));
    let line = session.press("Enter").last_line();
    assert!(line.contains("written to "), "{line}");
    assert!(std::fs::read_to_string(&file).unwrap().contains("[start]"));
    // The new file now belongs to the scene.
    let line = session.press("w").last_line();
    assert!(line.contains("no changes to save"), "{line}");
    // Another scene asks before it overwrites this file.
    let mut other = Session::new(preset("press"), Glyphs::Ascii, 40, 12);
    other.press("w Ctrl-U").press(&keys.join(" "));
    let screen = other.press("Enter").painted_text();
    assert!(screen.contains("overwrite new.toml?"), "{screen}");
    other.press("Esc");
    assert!(
        !std::fs::read_to_string(&file)
            .unwrap()
            .contains("[links]\nr5")
    );
}
