//! The linkages for a task in the workbench, driven by keys: listed, drawn on their way, and one taken.

use crate::claims::{assert_told, said};
use crate::screen::{SCREENS, Session, folder, preset, text};
use krank::drawing::Glyphs;
use krank::task_file::{ExampleTask, TaskFile};
use krank::tui::{Colours, TaskOrder, Workbench};
use std::fs;

/// Four places of a body: its pivots lie on curves.
const FOUR_POSES: &str = "\
kind  = \"poses\"
poses = [[0, 0, 0], [-5.5, 55.5, -20.1], [-75.3, 83.9, -27.1], [-165.9, 73.9, -28.2]]
";

fn order(text: &str, name: &str) -> TaskOrder {
    TaskOrder::new(TaskFile::parse(text, name).unwrap(), name.to_owned())
}

/// The four-bar, and over it the linkages for an example.
fn looking_for(example: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let text = ExampleTask::find(example).unwrap().text;
    coloured(&order(text, example), glyphs, Colours::Sixteen, cols, rows)
}

fn coloured(task: &TaskOrder, glyphs: Glyphs, colours: Colours, cols: u16, rows: u16) -> Session {
    let workbench = Workbench::new(preset("four-bar"), glyphs, colours, cols, rows);
    Session::on(workbench.synthesizing(task.clone()), cols, rows)
}

/// The screen without the digits of what is mere rounding.
fn masked(screen: &str) -> String {
    let rounding = |word: &str| word.contains("e-1") && word.parse::<f64>().is_ok();
    let mask = |word: &str| match rounding(word) {
        true => "N.NNe-NN".to_owned(),
        false => word.to_owned(),
    };
    let line = |line: &str| line.split(' ').map(mask).collect::<Vec<_>>().join(" ") + "\n";
    screen.lines().map(line).collect()
}

#[test]
fn candidates_stand_beside_what_they_do() {
    for (name, glyphs, cols, rows) in SCREENS {
        let screen = masked(&looking_for("hatch", glyphs, cols, rows).look());
        assert_told(
            &screen,
            &[
                "4 found, 2 defective",
                "miss mm transm. crank",
                "> 1 N.NNe-NN 46.0 turns",
                "defective",
            ],
        );
        if ["ascii-80x24", "braille-120x40", "ascii-40x12"].contains(&name) {
            insta::assert_snapshot!(format!("candidates-{name}"), screen);
        }
    }
}

#[test]
fn a_candidate_is_moved_over_its_task() {
    let mut session = looking_for("hatch", Glyphs::Ascii, 80, 24);
    let first = session.look();
    assert!(said(&first).contains("point 1 of 5, crank at"), "{first}");
    let second = session.press("Right").look();
    assert!(said(&second).contains("point 2 of 5, crank at"), "{second}");
    assert_ne!(first, second);
    assert_eq!(session.press("Left").look(), first);
    // It goes to the last point and comes back; the list below it does not wait for the crank of the open scene.
    session.press("space").pass(3.2);
    let last = session.look();
    assert!(said(&last).contains("point 5 of 5, crank at"), "{last}");
    assert!(last.contains("space pause"), "{last}");
    session.pass(3.2);
    assert_eq!(session.press("space").look(), first);
    // The next candidate begins at its first point.
    let next = session.press("Right Down").look();
    assert!(said(&next).contains("point 1 of 5"), "{next}");
    assert_told(&next, &["> 2"]);
}

#[test]
fn a_defective_one_says_why_and_is_not_taken() {
    let why = "branch: a dead point lies between points 1 and 2";
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = looking_for("hatch", Glyphs::Ascii, cols, rows);
        let screen = session.press("End").look();
        assert!(!screen.contains("Enter take"), "{screen}");
        assert!(
            said(&screen).contains("branch: a dead point lies"),
            "{screen}"
        );
        let line = session.press("Enter").last_line();
        assert!(line.contains(&why[..20]), "{line}");
        assert!(session.press("Home").last_line().contains("Enter take"));
    }
}

#[test]
fn one_is_taken_as_a_new_scene_and_the_others_are_found_again() {
    let mut session = looking_for("hatch", Glyphs::Ascii, 80, 24);
    let screen = session.press("Down Enter").look();
    assert_told(&screen, &["hatch-2*"]);
    assert!(screen.contains("Hatch, candidate 2"), "{screen}");
    assert!(session.press("w").last_line().contains("hatch-2.toml"));
    let list = session.press("Esc o Home").look();
    assert_told(&list, &["> Linkages for hatch"]);
    let again = session.press("Enter").look();
    assert_told(&again, &["4 found, 2 defective", "> 2"]);
    // The scene below is the one that was taken.
    assert_told(&session.press("Esc").look(), &["hatch-2*"]);
}

/// No file holds what was taken: whoever leaves it is asked, be it for another scene, or for good.
#[test]
fn one_that_was_taken_is_not_lost_unasked() {
    let file = folder("candidates-taken").join("hatch.toml");
    let mut session = looking_for("hatch", Glyphs::Ascii, 80, 24);
    session.press("Enter");
    assert!(session.last_line().contains("hatch-1*"));
    let told = "this linkage is not saved yet";
    for (key, keys) in [("q", "q drop, quit"), ("n", "d drop, open")] {
        let asked = session.press(key).look();
        assert!(asked.contains(told) && asked.contains(keys), "{asked}");
        session.press("Esc");
        assert!(session.last_line().contains("hatch-1*"));
    }
    // Another of the same list loses none; one that was edited is asked about.
    session.press("o Home Enter Down Enter");
    assert!(session.last_line().contains("hatch-2*"));
    session.press("6 >").press("o Home Enter Home Enter");
    assert!(session.look().contains("unsaved edits"));
    session.press("Esc q w Ctrl-U");
    session.type_in(file.to_str().unwrap());
    assert!(!session.workbench.press("Enter"), "written, and left");
    let written = fs::read_to_string(&file).unwrap();
    assert!(written.contains("Hatch, candidate 2"), "{written}");
}

/// What is edited is asked about before a candidate takes its place.
#[test]
fn edits_of_the_open_scene_are_not_lost() {
    let folder = folder("candidates-edited");
    fs::write(
        folder.join("hatch.toml"),
        ExampleTask::find("hatch").unwrap().text,
    )
    .unwrap();
    fs::write(folder.join("mine.toml"), text("four-bar")).unwrap();
    let mut session = opened_in(&folder, Glyphs::Ascii);
    session.press("6 > o").type_in("hatch").press("Enter");
    assert_told(&session.look(), &["4 found, 2 defective"]);
    let asked = session.press("Enter").look();
    assert!(
        said(&asked).contains("w save") || said(&asked).contains("mine.toml"),
        "{asked}"
    );
    session.press("Esc");
    assert!(
        session.last_line().contains("mine.toml*"),
        "{}",
        session.last_line()
    );
}

fn opened_in(folder: &std::path::Path, glyphs: Glyphs) -> Session {
    let origin = krank::tui::Origin::File(folder.join("mine.toml"));
    Session::new(
        crate::screen::open(text("four-bar"), origin),
        glyphs,
        80,
        24,
    )
}

#[test]
fn a_task_among_the_files_is_opened_as_one() {
    let folder = folder("candidates-files");
    fs::write(folder.join("mine.toml"), text("four-bar")).unwrap();
    fs::write(folder.join("places.toml"), FOUR_POSES).unwrap();
    fs::write(folder.join("other.toml"), text("slider-crank")).unwrap();
    let wrong = FOUR_POSES.replace("-75.3, 83.9, -27.1", "0, 0, 0");
    fs::write(folder.join("twice.toml"), wrong).unwrap();
    let mut session = opened_in(&folder, Glyphs::Ascii);
    let screen = session.press("o").type_in("places").look();
    let told = "a task: a body in 4 poses; Enter searches for linkages";
    assert!(
        said(&screen.replace('|', " ")).contains("a task: a body in 4 poses"),
        "{told}\n{screen}"
    );
    assert_told(&session.press("Enter").look(), &["Linkages for places"]);
    // One with a fault says it as a scene does.
    session.press("Esc o").type_in("twice");
    assert_told(&session.look(), &["cannot be opened"]);
    // It is nothing to be held against a scene, and is not offered for that.
    let screen = session.press("Esc D").type_in("places").look();
    assert!(!screen.contains("places.toml"), "{screen}");
    let screen = session.press("Ctrl-U").type_in("other").look();
    assert!(screen.contains("other.toml"), "{screen}");
}

/// What is taken of a task in a file is offered a name beside that.
#[test]
fn one_that_was_taken_is_saved_beside_its_task() {
    let folder = folder("candidates-beside");
    let task = ExampleTask::find("hatch").unwrap().text;
    fs::write(folder.join("hatch.toml"), task).unwrap();
    fs::write(folder.join("mine.toml"), text("four-bar")).unwrap();
    let mut session = opened_in(&folder, Glyphs::Ascii);
    session.press("o").type_in("hatch").press("Enter Enter");
    let line = session.press("w").last_line();
    assert!(line.contains("candidates-beside/hatch-1.toml"), "{line}");
    session.press("Enter");
    assert!(folder.join("hatch-1.toml").exists());
}

/// Where pivots may stand is drawn: dots from one side of the drawing to the other.
#[test]
fn four_poses_leave_curves() {
    let dots = |text: &str| {
        let task = order(text, "places");
        let screen = coloured(&task, Glyphs::Ascii, Colours::None, 120, 40).look();
        screen.matches(['.', '\'', ':']).count()
    };
    let five = ExampleTask::find("hatch").unwrap().text;
    assert!(
        dots(FOUR_POSES) > dots(five) + 60,
        "{} {}",
        dots(FOUR_POSES),
        dots(five)
    );
}

#[test]
fn without_colours_the_same_is_told() {
    let task = order(ExampleTask::find("logarithm").unwrap().text, "logarithm");
    let mut plain = coloured(&task, Glyphs::Ascii, Colours::None, 80, 24);
    let english = plain.look();
    let mut painted = coloured(&task, Glyphs::Ascii, Colours::True, 80, 24);
    assert_eq!(painted.look(), english);
    assert!(english.contains("> 1"), "{english}");
}
