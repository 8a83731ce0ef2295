//! Tests scenes and their files: saving, reloading after changes by other programs, and recovery
//! after a crash.

use crate::claims::{assert_shown, collapse_blanks};
use crate::scene::Values;
use crate::screen::{Session, folder, four_bar, open, preset, text};
use krank::drawing::Glyphs;
use krank::tui::{Colours, OpenedScene, Origin, Workbench};
use std::time::Duration;

fn file(folder: &std::path::Path, text: &str) -> (std::path::PathBuf, OpenedScene) {
    let file = folder.join("mine.toml");
    std::fs::write(&file, text).unwrap();
    let opened = open(text, Origin::File(file.clone()));
    (file, opened)
}

/// Comments, CRLF line endings and the byte order mark stay unchanged.
#[test]
fn saving_changes_only_edited_values() {
    let text = format!("\u{feff}# mine\n{}", text("four-bar")).replace('\n', "\r\n");
    let (file, opened) = file(&folder("scene-saved"), &text);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let line = session.press("w").last_line();
    assert!(line.contains("no changes to save"), "{line}");
    session
        .press("6")
        .find("r2 len")
        .press("Enter")
        .type_in("101.5")
        .press("Enter");
    assert!(session.last_line().contains("mine.toml*"));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text, "not unasked");
    let line = session.press("w").last_line();
    assert!(line.contains("written to "), "{line}");
    let expected = text.replace("length = 100,", "length = 101.5,");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), expected);
    let screen = session.press("1").painted_text();
    assert!(
        !screen.contains("mine.toml*") && !screen.contains("rocker *"),
        "{screen}"
    );
    // A saved edit can be undone, which is an unsaved edit again.
    session.press("u w");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
}

#[test]
fn failed_save_keeps_unsaved_edits() {
    let (file, opened) = file(&folder("scene-full"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("6").find("r2 len").press(">");
    session.press("W Ctrl-U").type_in("/dev/full");
    let line = session.press("Enter").last_line();
    assert!(line.contains("not written, it is a device"), "{line}");
    session.press("Esc");
    assert_eq!(session.row(), ">*r2 length 101 mm 100");
    assert_eq!(std::fs::read_to_string(file).unwrap(), text("four-bar"));
}

/// Regression test: the angular step stayed after a slide had replaced the turning driver.
#[test]
fn reload_adopts_step_of_another_kind_of_driver() {
    let (file, opened) = file(&folder("scene-driver"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    assert!(session.painted_text().contains("step 5 deg"));
    std::fs::write(&file, text("scissor-lift")).unwrap();
    session.workbench.pass(Duration::from_secs(2));
    let screen = session.press("z").painted_text();
    let step = screen.lines().nth(1).unwrap();
    assert!(step.contains("step ") && !step.contains("deg"), "{screen}");
}

#[test]
fn external_changes_are_reloaded_but_never_over_edits() {
    let (file, opened) = file(&folder("scene-reload"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let wait = |session: &mut Session| session.workbench.pass(Duration::from_secs(2));
    session.press("6").find("r2 len");
    std::fs::write(
        &file,
        text("four-bar").replace("length = 100", "length = 120.25"),
    )
    .unwrap();
    wait(&mut session);
    let line = session.press("[").last_line();
    assert!(line.contains("mine.toml reloaded"), "{line}");
    assert_eq!(session.row(), "> r2 length 120.25 mm");
    // While the file is invalid, the last valid state stays.
    std::fs::write(&file, "[ground]\nA = [0").unwrap();
    wait(&mut session);
    let screen = collapse_blanks(&session.press("[").painted_text());
    let output = "mine.toml invalid, not shown: ";
    assert!(screen.contains(output), "{screen}");
    assert_eq!(session.row(), "> r2 length 120.25 mm");
    // The name is marked until the file is valid, also when the message is gone.
    session.workbench.pass(Duration::from_secs(60));
    let line = session.press("] Esc").last_line();
    assert!(line.contains("mine.toml! "), "{line}");
    std::fs::write(
        &file,
        text("four-bar").replace("length = 100", "length = 90"),
    )
    .unwrap();
    wait(&mut session);
    session.press("[");
    assert_eq!(session.row(), "> r2 length 90 mm");
    let line = session.press("Esc").last_line();
    assert!(line.contains("mine.toml ") && !line.contains('!'), "{line}");
    // A reload never overwrites unsaved edits.
    session.press(">");
    let edited = session.row();
    std::fs::write(
        &file,
        text("four-bar").replace("length = 100", "length = 95.125"),
    )
    .unwrap();
    wait(&mut session);
    let line = session.press("[").last_line();
    assert!(line.contains("has changed on disk: R reloads"), "{line}");
    assert_eq!(session.row(), edited);
    let requested = [
        "mine.toml has changed on disk: overwrite it?",
        "Enter write Esc cancel",
    ];
    assert_shown(&session.press("w").painted_text(), &requested);
    let requested = ["reload over unsaved edits?", "Enter load Esc keep"];
    assert_shown(&session.press("Esc R").painted_text(), &requested);
    session.press("Esc");
    assert_eq!(session.row(), edited);
    session.press("R Enter");
    assert_eq!(session.row(), "> r2 length 95.125 mm");
    // Even after a confirmed reload, undo restores them.
    session.press("u");
    assert!(
        session.row().starts_with(">*r2 length 90.5")
            || session.row().starts_with(">*r2 length 91")
    );
}

#[test]
fn leaving_with_unsaved_edits_asks_first() {
    let (file, opened) = file(&folder("scene-asked"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("6").find("r2 len").press(">");
    let requested = ["unsaved edits", "w save q drop, quit Esc stay"];
    assert_shown(&session.press("q").painted_text(), &requested);
    session.press("Esc");
    assert_eq!(session.row(), ">*r2 length 101 mm 100");
    let requested = ["unsaved edits", "w save d drop, open Esc stay"];
    assert_shown(&session.press("Esc n").painted_text(), &requested);
    session.press("Esc n w");
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .contains("length = 101")
    );
    assert!(
        !session.painted_text().contains("r2 length     101"),
        "the other scene is shown"
    );
    let mut other = four_bar(40, 12);
    other.press("6").find("r2 len").press(">");
    let requested = ["w save q drop, quit Esc stay"];
    assert_shown(&other.press("q").painted_text(), &requested);
    assert!(!other.workbench.press("q"), "left");
    let mut quick = four_bar(40, 12);
    quick.press("6 >");
    assert!(!quick.workbench.press("Ctrl-C"), "always");
}

#[test]
fn unsaved_edits_of_earlier_session_are_offered() {
    let folder = folder("scene-recovery");
    let start = || {
        let opened = preset("four-bar");
        let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
        session.workbench = std::mem::replace(
            &mut session.workbench,
            Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::Sixteen, 80, 24),
        )
        .recovering_in(&folder);
        session
    };
    let kept = || std::fs::read_dir(&folder).unwrap().count();
    let mut session = start();
    session.press("6").find("r2 len").press("> >");
    assert_eq!(kept(), 1);
    drop(session);
    let mut session = start();
    // Keys typed before the offer was readable are ignored.
    session.press("t d d Enter Esc");
    let screen = session.painted_text();
    for part in ["Unsaved edits of this scene", "> 20", "c compare  t take"] {
        assert!(screen.contains(part), "{screen}");
    }
    assert_eq!(kept(), 1);
    session.pass(1.0);
    let screen = session.press("c").painted_text();
    assert!(screen.contains("length = 102"), "{screen}");
    let screen = session.press("Enter Esc Enter").painted_text();
    assert!(screen.contains("The edited text"), "{screen}");
    session.press("t 6").find("r2 len");
    assert_eq!(session.row(), ">*r2 length 102 mm 100");
    // After undo to the saved state, the recovered edits are kept as before.
    session.press("u");
    assert_eq!(session.row(), "> r2 length 100 mm");
    assert_eq!(kept(), 1);
    drop(session);
    let mut session = start();
    session.paint();
    session.pass(1.0).press("t q q");
    assert_eq!(kept(), 0, "dropped");
    let mut session = start();
    session.press("6 >");
    drop(session);
    let mut session = start();
    session.paint();
    let screen = session.pass(1.0).press("d").painted_text();
    assert!(screen.contains("d again deletes for good"), "{screen}");
    assert_eq!(kept(), 1, "not at once");
    session.press("d");
    assert_eq!(kept(), 0, "deleted");
    assert!(session.last_line().contains("edits deleted"));
}

/// Edits that were staged when the program ended are staged again.
#[test]
fn staged_edits_of_earlier_session_are_offered() {
    let folder = folder("scene-waiting");
    let start = || {
        let workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, 80, 24);
        let mut session = Session::on(workbench.recovering_in(&folder), 80, 24);
        session.paint();
        session.pass(1.0);
        session
    };
    let kept = || std::fs::read_dir(&folder).unwrap().count();
    let mut session = start();
    session.press("6").find("r3 len").press("b Enter");
    session.type_in("1000").press("Enter");
    assert_eq!(kept(), 1);
    session.find("D x").press(">");
    assert!(!session.workbench.press("Ctrl-C"), "ended");
    drop(session);
    let mut session = start();
    let screen = session.press("c").painted_text();
    for part in ["staged: r3 length = 1000", "staged: D x = 402"] {
        assert!(screen.contains(part), "{screen}");
    }
    let line = session.press("t").last_line();
    assert!(line.contains("staged edits: b applies them"), "{line}");
    let row = |session: &mut Session, name| {
        let row = session.find(name).row();
        row.trim_end_matches(" |").to_owned()
    };
    assert_eq!(row(&mut session, "r3 len"), ">+r3 length 1000 mm");
    assert_eq!(row(&mut session, "D x"), ">+D x 402 mm");
    // Discarded edits remain in the earlier session's file; restored ones also belong to this
    // session.
    session.press("Esc");
    assert_eq!(kept(), 1);
    session.press("u");
    assert_eq!(kept(), 2);
    drop(session);
    assert_eq!(kept(), 2);
    let mut session = start();
    session.press("t").find("r3 len").press("Enter");
    session.type_in("302").press("Enter b");
    assert!(session.last_line().contains("2 edits applied"));
    drop(session);
    let screen = start().press("c").painted_text();
    assert!(
        screen.contains("length = 302") && !screen.contains("waits:"),
        "{screen}"
    );
}

/// Every crash leaves one generation, and postponing the choice loses none.
#[test]
fn three_recovered_generations_fit_every_screen() {
    let folder = folder("scene-generations");
    let start = |cols: u16, rows: u16| {
        let workbench =
            Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, cols, rows);
        let mut session = Session::on(workbench.recovering_in(&folder), cols, rows);
        session.paint();
        session.pass(1.0);
        session
    };
    for n in 1..=3 {
        let mut session = start(80, 24);
        session.press("Esc 6").find("r2 len");
        session.press(&"> ".repeat(n));
    }
    for (cols, rows) in [(80, 24), (40, 12), (200, 60)] {
        let mut session = start(cols, rows);
        let screen = session.painted_text();
        assert_eq!(screen.matches("UTC").count(), 3, "{screen}");
        for part in ["Enter look", "c compare", "t take", "d drop", "Esc later"] {
            assert!(screen.contains(part), "{screen}");
        }
        let screen = session.press("Down c").painted_text();
        assert!(screen.contains("+ r2 = {"), "{screen}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
}

/// Edits of an older text overwrite a newer file only after confirmation.
#[test]
fn recovered_edits_overwrite_newer_file_only_after_confirmation() {
    let folder = folder("scene-older");
    let start = || {
        let (_, opened) = {
            let file = folder.join("mine.toml");
            let text = std::fs::read_to_string(&file).unwrap();
            (file.clone(), open(&text, Origin::File(file)))
        };
        let workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, 80, 24);
        let mut session = Session::on(workbench.recovering_in(&folder.join("kept")), 80, 24);
        session.paint();
        session.pass(1.0);
        session
    };
    let file = folder.join("mine.toml");
    std::fs::write(&file, text("four-bar")).unwrap();
    let mut session = start();
    session.press("6").find("r2 len").press(">");
    drop(session);
    let newer = text("four-bar").replace("length = 250", "length = 251");
    std::fs::write(&file, &newer).unwrap();
    let mut session = start();
    let screen = session.painted_text();
    assert!(screen.contains("file has changed"), "{screen}");
    let requested = ["mine.toml is newer than these edits: overwrite", "it?"];
    assert_shown(&session.press("t w").painted_text(), &requested);
    session.press("Esc");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), newer);
    // Keys typed before the question was readable do not answer it.
    session.press("w Enter Enter");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), newer);
    session.pass(1.0).press("Enter");
    let saved = std::fs::read_to_string(&file).unwrap();
    assert!(saved.contains("length = 101") && saved.contains("length = 250"));
    drop(session);
    assert_eq!(std::fs::read_dir(folder.join("kept")).unwrap().count(), 0);
}

#[test]
fn read_only_file_is_overwritten_after_confirmation() {
    use std::os::unix::fs::PermissionsExt;
    let (file, opened) = file(&folder("scene-read-only"), text("four-bar"));
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o444)).unwrap();
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let screen = session
        .press("6")
        .find("r2 len")
        .press("> w")
        .painted_text();
    assert_shown(&screen, &["mine.toml is read-only: overwrite?"]);
    session.press("Esc");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text("four-bar"));
    session.press("w").pass(1.0).press("Enter");
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .contains("length = 101")
    );
    let mode = std::fs::metadata(&file).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o444);
}

/// Regression test: removing a followed point from the file crashed the program.
#[test]
fn removed_point_is_no_longer_followed() {
    let named = text("hoecken");
    let (file, opened) = file(&folder("scene-point-gone"), named);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let line = session.press("s").last_line();
    assert!(line.contains("the view follows P"), "{line}");
    let without: String = named
        .lines()
        .filter(|line| !line.starts_with("traces"))
        .map(|line| line.replace(", points = { P = [200, 0] }", "") + "\n")
        .collect();
    assert_ne!(without, named);
    std::fs::write(&file, &without).unwrap();
    let line = session.press("R").last_line();
    assert!(line.contains("reloaded"), "{line}");
    // Undoing the reload restores the point without following it again.
    session.press("u");
    let line = session.press("s").last_line();
    assert!(line.contains("the view follows P"), "{line}");
    session.press("Ctrl-R u u");
    session.painted_text();
}
