//! Editing the scene in the workbench, driven by key scripts, as a terminal shows it.

use crate::screen::{self, Session, folder, open, preset, text};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::{Colours, Opened, Origin, Workbench};
use proptest::prelude::*;
use std::time::Duration;

fn four_bar(cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows)
}

/// What is done and seen in the list of values.
trait Values {
    /// Goes to a value.
    fn find(&mut self, name: &str) -> &mut Self;
    /// The row under the cursor, without what is drawn beside it.
    fn row(&mut self) -> String;
}

impl Values for Session {
    fn find(&mut self, name: &str) -> &mut Self {
        self.press("/").type_in(name).press("Enter")
    }

    fn row(&mut self) -> String {
        let screen = self.look();
        let row = screen.lines().find(|line| line.starts_with(" >")).unwrap();
        let words = row.split(" | ").next().unwrap().split_whitespace();
        words.collect::<Vec<_>>().join(" ")
    }
}

#[test]
fn lists_every_value() {
    for (cols, rows) in [(80, 24), (120, 40), (40, 12)] {
        let screen = four_bar(cols, rows).press("6").look();
        insta::assert_snapshot!(format!("scene-{cols}x{rows}"), screen);
    }
}

#[test]
fn a_value_is_typed_with_a_unit_and_everything_follows() {
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = four_bar(cols, rows);
        session
            .press("6")
            .find("r2 len")
            .press("Enter")
            .type_in("4,5 in");
        insta::assert_snapshot!(format!("scene-typing-{cols}x{rows}"), session.look());
        session.press("Enter");
        insta::assert_snapshot!(format!("scene-changed-{cols}x{rows}"), session.look());
    }
}

/// What cannot be is said at once, and the last good state stays: in the row, in the drawing, in all views.
#[test]
fn what_cannot_be_leaves_the_last_good_state() {
    let mut session = four_bar(80, 24);
    session.press("6").find("r3 len");
    let before = session.look();
    for (typed, said) in [
        ("0", "must be positive, not `0`"),
        ("-5", "must be positive, not `-5`"),
        ("1000", "r3 length 1000: C out of reach by"),
        ("5 kg", "kg does not fit here: mm, cm, m, in"),
        (
            "much",
            "no number: much; type one, alone or in mm, cm, m, in",
        ),
    ] {
        let line = session
            .press("Enter")
            .type_in(typed)
            .press("Enter")
            .last_line();
        assert!(line.contains(said), "{line}");
        assert_eq!(session.press("Esc").look(), before, "{typed}");
    }
    // Nudged until the linkage would open no more: there it stops.
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
fn nudges_follow_the_step_and_are_taken_back_as_one() {
    let mut session = four_bar(80, 24);
    session.press("6").find("r2 len").press("> > >");
    assert_eq!(session.row(), ">*r2 length 103 mm 100");
    session.press("{ >");
    assert_eq!(session.row(), ">*r2 length 103.5 mm 100");
    assert!(session.look().contains("nudge by 0.5 mm"));
    let line = session.press("u").last_line();
    assert!(line.contains("r2 length taken back"), "{line}");
    assert_eq!(session.row(), "> r2 length 100 mm");
    session.press("Ctrl-R");
    assert_eq!(session.row(), ">*r2 length 103.5 mm 100");
    let line = session.press("Ctrl-R").last_line();
    assert!(line.contains("no edit to make again"), "{line}");
    // Other views show the linkage with its new crank.
    let tables = session.press("2").look();
    assert!(tables.contains("103.5"), "{tables}");
}

/// The angle that is looked at may be out of reach after an edit: the end is shown, and said so.
#[test]
fn the_driver_stays_where_it_is_as_far_as_it_can() {
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
    // The driver's own angle takes the linkage along.
    session.press("u").find("driver angle").press("Enter");
    let line = session
        .type_in("1.5707963267948966 rad")
        .press("Enter")
        .last_line();
    assert!(line.contains("90.00 deg"), "{line}");
}

/// An edit never changes to the other assembly: where the text would, its [start] follows.
#[test]
fn an_edit_keeps_the_assembly() {
    let mut session = four_bar(80, 24);
    // With D so high, C = [310, 230] would be nearer to the other assembly: by hand, the circles about B
    // and D meet at (158.9, 366.1) and (348.4, 55.4), which are 203 mm and 179 mm away.
    session.press("6").find("D y").press("Enter");
    let line = session.type_in("300").press("Enter").last_line();
    assert!(line.contains("[start] follows"), "{line}");
    let screen = session.look();
    assert!(screen.contains("*C start x     158.9"), "{screen}");
    assert!(screen.contains("*C start y     366.1"), "{screen}");
    // One step takes both back.
    let screen = session.press("u").look();
    assert!(screen.contains(" C start x     310 "), "{screen}");
    assert!(!screen.contains("four-bar*"), "{screen}");
    // A start that is moved on purpose means the other assembly.
    let mut session = four_bar(80, 24);
    let before = session.look();
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
    let crossed = session.press("1").look();
    assert!(crossed.contains("302.825"), "{crossed}");
    let again = session.press("u u").look();
    assert!(again.contains("29.379"), "{again}");
}

#[test]
fn an_assembly_that_was_switched_is_an_edit_like_others() {
    let mut session = four_bar(80, 24);
    session.press("a Enter");
    assert!(session.look().contains("302.825"));
    let screen = session.press("6").look();
    assert!(screen.contains("*C start x     212.622"), "{screen}");
    session.find("r2 len").press(">");
    assert!(session.press("1").look().contains("C"));
    session.press("u");
    assert!(session.look().contains("302.825"), "{}", session.look());
    session.press("u");
    assert!(session.look().contains("29.379"), "{}", session.look());
}

fn file(folder: &std::path::Path, text: &str) -> (std::path::PathBuf, Opened) {
    let file = folder.join("mine.toml");
    std::fs::write(&file, text).unwrap();
    let opened = open(text, Origin::File(file.clone()));
    (file, opened)
}

/// Comments, line breaks of another system and the mark at the beginning stay.
#[test]
fn a_file_is_saved_with_nothing_else_changed() {
    let text = format!("\u{feff}# mine\n{}", text("four-bar")).replace('\n', "\r\n");
    let (file, opened) = file(&folder("scene-saved"), &text);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let line = session.press("w").last_line();
    assert!(line.contains("nothing has changed"), "{line}");
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
    let screen = session.press("1").look();
    assert!(
        !screen.contains("mine.toml*") && !screen.contains("rocker *"),
        "{screen}"
    );
    // What is saved can be taken back, and is then unsaved.
    session.press("u w");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
}

#[test]
fn a_file_that_cannot_be_written_keeps_the_edits() {
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

/// The steps of a link that turns used to stay where a slide had taken its place.
#[test]
fn a_file_that_is_read_again_may_be_driven_otherwise() {
    let (file, opened) = file(&folder("scene-driver"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    assert!(session.look().contains("step 5 deg"));
    std::fs::write(&file, text("scissor-lift")).unwrap();
    session.workbench.pass(Duration::from_secs(2));
    let screen = session.press("z").look();
    let step = screen.lines().next().unwrap();
    assert!(step.contains("step ") && !step.contains("deg"), "{screen}");
}

#[test]
fn a_file_that_somebody_else_writes_is_read_again() {
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
    assert!(line.contains("mine.toml was read again"), "{line}");
    assert_eq!(session.row(), "> r2 length 120.25 mm");
    // Broken meanwhile: the last good state stays until it is mended.
    std::fs::write(&file, "[ground]\nA = [0").unwrap();
    wait(&mut session);
    let line = session.press("[").last_line();
    assert!(line.contains("mine.toml is broken, not shown: "), "{line}");
    assert_eq!(session.row(), "> r2 length 120.25 mm");
    std::fs::write(
        &file,
        text("four-bar").replace("length = 100", "length = 90"),
    )
    .unwrap();
    wait(&mut session);
    session.press("[");
    assert_eq!(session.row(), "> r2 length 90 mm");
    // Never over unsaved edits.
    session.press(">");
    let edited = session.row();
    std::fs::write(
        &file,
        text("four-bar").replace("length = 100", "length = 95.125"),
    )
    .unwrap();
    wait(&mut session);
    let line = session.press("[").last_line();
    assert!(line.contains("has changed on disk: R reads it"), "{line}");
    assert_eq!(session.row(), edited);
    let line = session.press("w").last_line();
    let asked = " save  mine.toml has changed on disk: write over it?  Enter write  Esc cancel";
    assert_eq!(line, asked);
    let line = session.press("Esc R").last_line();
    assert!(line.contains("read it over unsaved edits?"), "{line}");
    session.press("Esc");
    assert_eq!(session.row(), edited);
    session.press("R Enter");
    assert_eq!(session.row(), "> r2 length 95.125 mm");
    // Even then they are not lost.
    session.press("u");
    assert!(
        session.row().starts_with(">*r2 length 90.5")
            || session.row().starts_with(">*r2 length 91")
    );
}

#[test]
fn unsaved_edits_are_asked_about() {
    let (file, opened) = file(&folder("scene-asked"), text("four-bar"));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("6").find("r2 len").press(">");
    let line = session.press("q").last_line();
    assert!(
        line.contains("unsaved edits  w save  q drop, quit  Esc stay"),
        "{line}"
    );
    session.press("Esc");
    assert_eq!(session.row(), ">*r2 length 101 mm 100");
    let line = session.press("n").last_line();
    assert!(
        line.contains("unsaved edits  w save  d drop, open  Esc stay"),
        "{line}"
    );
    session.press("Esc n w");
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .contains("length = 101")
    );
    assert!(
        !session.look().contains("r2 length     101"),
        "the other scene is shown"
    );
    let mut other = four_bar(40, 12);
    other.press("6").find("r2 len").press(">");
    let line = other.press("q").last_line();
    assert!(line.contains("w save  q drop, quit"), "{line}");
    assert!(!other.workbench.press("q"), "left");
    let mut quick = four_bar(40, 12);
    quick.press("6 >");
    assert!(!quick.workbench.press("Ctrl-C"), "always");
}

#[test]
fn edits_of_an_earlier_session_are_offered() {
    let folder = folder("scene-recovery");
    let begin = || {
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
    let mut session = begin();
    session.press("6").find("r2 len").press("> >");
    assert_eq!(kept(), 1);
    drop(session);
    let mut session = begin();
    // What was typed before it could be read is no answer.
    session.press("t d d Enter Esc");
    let screen = session.look();
    for part in ["Unsaved edits of this scene", "> 20", "c compare  t take"] {
        assert!(screen.contains(part), "{screen}");
    }
    assert_eq!(kept(), 1);
    session.pass(1.0);
    let screen = session.press("c").look();
    assert!(screen.contains("length = 102"), "{screen}");
    let screen = session.press("Enter Esc Enter").look();
    assert!(screen.contains("The edited text"), "{screen}");
    session.press("t 6").find("r2 len");
    assert_eq!(session.row(), ">*r2 length 102 mm 100");
    // Taken back to what is saved, what was left is where it was.
    session.press("u");
    assert_eq!(session.row(), "> r2 length 100 mm");
    assert_eq!(kept(), 1);
    drop(session);
    let mut session = begin();
    session.paint();
    session.pass(1.0).press("t q q");
    assert_eq!(kept(), 0, "dropped");
    let mut session = begin();
    session.press("6 >");
    drop(session);
    let mut session = begin();
    session.paint();
    let screen = session.pass(1.0).press("d").look();
    assert!(screen.contains("d again drops them"), "{screen}");
    assert_eq!(kept(), 1, "not at once");
    session.press("d");
    assert_eq!(kept(), 0, "deleted");
    assert!(session.last_line().contains("these edits are deleted"));
}

/// Every crash leaves a generation, and who leaves them for later loses none.
#[test]
fn three_generations_are_offered_and_fit_any_screen() {
    let folder = folder("scene-generations");
    let begin = |cols: u16, rows: u16| {
        let workbench =
            Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, cols, rows);
        let mut session = Session::on(workbench.recovering_in(&folder), cols, rows);
        session.paint();
        session.pass(1.0);
        session
    };
    for n in 1..=3 {
        let mut session = begin(80, 24);
        session.press("Esc 6").find("r2 len");
        session.press(&"> ".repeat(n));
    }
    for (cols, rows) in [(80, 24), (40, 12), (200, 60)] {
        let mut session = begin(cols, rows);
        let screen = session.look();
        assert_eq!(screen.matches("UTC").count(), 3, "{screen}");
        for part in ["Enter look", "c compare", "t take", "d drop", "Esc later"] {
            assert!(screen.contains(part), "{screen}");
        }
        let screen = session.press("Down c").look();
        assert!(screen.contains("+ r2 = {"), "{screen}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
}

/// Edits that were made on an older text are not written over a newer one unasked.
#[test]
fn old_edits_are_written_over_a_newer_file_only_where_that_is_meant() {
    let folder = folder("scene-older");
    let begin = || {
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
    let mut session = begin();
    session.press("6").find("r2 len").press(">");
    drop(session);
    let newer = text("four-bar").replace("length = 250", "length = 251");
    std::fs::write(&file, &newer).unwrap();
    let mut session = begin();
    let screen = session.look();
    assert!(screen.contains("made on another text"), "{screen}");
    let line = session.press("t w").last_line();
    assert!(
        line.contains("mine.toml is newer than these edits: write over it?"),
        "{line}"
    );
    session.press("Esc");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), newer);
    // What was typed before the question could be read is no answer to it.
    session.press("w Enter Enter");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), newer);
    session.pass(1.0).press("Enter");
    let saved = std::fs::read_to_string(&file).unwrap();
    assert!(saved.contains("length = 101") && saved.contains("length = 250"));
    drop(session);
    assert_eq!(std::fs::read_dir(folder.join("kept")).unwrap().count(), 0);
}

#[test]
fn a_read_only_file_is_asked_about() {
    use std::os::unix::fs::PermissionsExt;
    let (file, opened) = file(&folder("scene-read-only"), text("four-bar"));
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o444)).unwrap();
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let line = session.press("6").find("r2 len").press("> w").last_line();
    assert!(line.contains("mine.toml is read-only: write it?"), "{line}");
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

#[derive(Clone, Debug)]
enum Deed {
    Press(&'static str),
    Type(String),
}

fn deeds() -> impl Strategy<Value = Vec<Deed>> {
    let keys = [
        "Up", "Down", "PgDn", "PgUp", "<", ">", "{", "}", "}", "u", "Ctrl-R", "Enter", "Esc", ".",
        "a", "1", "6", "6", "R",
    ];
    let text = prop_oneof![
        Just(String::new()),
        "[-0-9.,e]{1,6}( (mm|in|deg|rad|rpm|kg))?",
        (1_u32..2000).prop_map(|n| (f64::from(n) / 10.0).to_string()),
    ];
    let deed = prop_oneof![
        6 => prop::sample::select(keys.to_vec()).prop_map(Deed::Press),
        2 => text.prop_map(Deed::Type),
    ];
    prop::collection::vec(deed, 1..40)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Whatever is typed and nudged, the scene stays one that opens; all of it taken back, the file is as
    /// it was.
    #[test]
    fn edits_never_leave_the_last_good_state(deeds in deeds(), preset in 0_usize..100) {
        let preset = &presets::all()[preset % presets::all().len()];
        let mut session = Session::new(screen::preset(preset.name), Glyphs::Ascii, 80, 24);
        session.press("6");
        for deed in deeds {
            match deed {
                Deed::Press(key) => {
                    session.press(key);
                }
                Deed::Type(text) => {
                    session.press("Enter").type_in(&text).press("Enter Esc 6");
                }
            }
        }
        session.press("Esc Esc 6");
        for _ in 0..60 {
            session.press("u");
        }
        let line = session.last_line();
        prop_assert!(line.contains("no edit to take back"), "{}", line);
        let changed = format!("{}*", preset.name);
        let screen = session.press("1").look();
        prop_assert!(!screen.contains(&changed), "{}", screen);
    }
}
