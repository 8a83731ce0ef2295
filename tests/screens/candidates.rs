//! Tests the candidate linkages of a task, driven by keys: listing, moving and taking them.

use crate::claims::{assert_shown, collapse_blanks};
use crate::screen::{SCREENS, Session, folder, preset, text};
use krank::drawing::Glyphs;
use krank::task_file::{ExampleTask, TaskFile};
use krank::tui::{Colours, TaskOrder, Workbench};
use std::fs;

/// Four poses of a body: its possible pivots lie on curves.
const FOUR_POSES: &str = "\
kind  = \"poses\"
poses = [[0, 0, 0], [-5.5, 55.5, -20.1], [-75.3, 83.9, -27.1], [-165.9, 73.9, -28.2]]
";

fn order(text: &str, name: &str) -> TaskOrder {
    TaskOrder::new(TaskFile::parse(text, name).unwrap(), name.to_owned())
}

/// Opens the four-bar with the candidates of an example task above it.
fn search_linkages(example: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let text = ExampleTask::find(example).unwrap().text;
    coloured(&order(text, example), glyphs, Colours::Sixteen, cols, rows)
}

fn coloured(task: &TaskOrder, glyphs: Glyphs, colours: Colours, cols: u16, rows: u16) -> Session {
    let workbench = Workbench::new(preset("four-bar"), glyphs, colours, cols, rows);
    Session::on(workbench.synthesizing(task.clone()), cols, rows)
}

/// Masks numbers that are only rounding errors.
fn masked(screen: &str) -> String {
    let rounding = |word: &str| word.contains("e-1") && word.parse::<f64>().is_ok();
    let mask = |word: &str| match rounding(word) {
        true => "N.NNe-NN".to_owned(),
        false => word.to_owned(),
    };
    let line = |line: &str| line.split(' ').map(mask).collect::<Vec<_>>().join(" ") + "\n";
    screen.lines().map(line).collect()
}

/// Regression: a number of two digits and a miss of nine characters were one word.
#[test]
fn numbers_and_misses_are_separate_words() {
    let mut session = search_linkages("straight-line", Glyphs::Ascii, 100, 60);
    let screen = session.press("End").painted_text();
    let first = screen.lines().filter_map(|line| line.split('|').next());
    let words = first.map(|line| line.trim_start_matches('>').split_whitespace());
    let rows: Vec<Vec<&str>> = words.map(Iterator::collect).collect();
    let rows = rows.iter().filter(|row| row.len() == 4 && row[0] != "miss");
    let numbers: Vec<usize> = rows.map(|row| row[0].parse().unwrap()).collect();
    assert!(numbers.len() > 30, "{screen}");
    let follow = |pair: &[usize]| pair[0] + 1 == pair[1];
    assert!(numbers.windows(2).all(follow), "{numbers:?}");
}

#[test]
fn candidates_are_listed_with_their_results() {
    for (name, glyphs, cols, rows) in SCREENS {
        let screen = masked(&search_linkages("hatch", glyphs, cols, rows).painted_text());
        assert_shown(
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
fn candidate_steps_and_plays_through_task_points() {
    let mut session = search_linkages("hatch", Glyphs::Ascii, 80, 24);
    let first = session.painted_text();
    assert!(
        collapse_blanks(&first).contains("point 1 of 5, crank at"),
        "{first}"
    );
    let second = session.press("Right").painted_text();
    assert!(
        collapse_blanks(&second).contains("point 2 of 5, crank at"),
        "{second}"
    );
    assert_ne!(first, second);
    assert_eq!(session.press("Left").painted_text(), first);
    // Playing runs to the last point and back, independent of the open scene's crank.
    session.press("space").pass(3.2);
    let last = session.painted_text();
    assert!(
        collapse_blanks(&last).contains("point 5 of 5, crank at"),
        "{last}"
    );
    assert!(last.contains("space pause"), "{last}");
    session.pass(3.2);
    assert_eq!(session.press("space").painted_text(), first);
    // The next candidate starts at its first point.
    let next = session.press("Right Down").painted_text();
    assert!(collapse_blanks(&next).contains("point 1 of 5"), "{next}");
    assert_shown(&next, &["> 2"]);
}

#[test]
fn defective_candidate_explains_its_defect_and_is_rejected() {
    let why = "branch: a dead point lies between points 1 and 2";
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = search_linkages("hatch", Glyphs::Ascii, cols, rows);
        let screen = session.press("End").painted_text();
        assert!(!screen.contains("Enter take"), "{screen}");
        assert!(
            collapse_blanks(&screen).contains("branch: a dead point lies"),
            "{screen}"
        );
        let line = session.press("Enter").last_line();
        assert!(line.contains(&why[..20]), "{line}");
        assert!(session.press("Home").last_line().contains("Enter take"));
    }
}

#[test]
fn taken_candidate_becomes_scene_and_list_stays_reachable() {
    let mut session = search_linkages("hatch", Glyphs::Ascii, 80, 24);
    let screen = session.press("Down Enter").painted_text();
    assert_shown(&screen, &["hatch-2*"]);
    assert!(screen.contains("Hatch, candidate 2"), "{screen}");
    assert!(session.press("w").last_line().contains("hatch-2.toml"));
    let list = session.press("Esc o Home").painted_text();
    assert_shown(&list, &["> Linkages for hatch"]);
    let again = session.press("Enter").painted_text();
    assert_shown(&again, &["4 found, 2 defective", "> 2"]);
    // The scene below the list is the one taken.
    assert_shown(&session.press("Esc").painted_text(), &["hatch-2*"]);
}

/// A taken candidate is in no file yet, so both quitting and opening another scene ask.
#[test]
fn leaving_unsaved_candidate_asks_first() {
    let file = folder("candidates-taken").join("hatch.toml");
    let mut session = search_linkages("hatch", Glyphs::Ascii, 80, 24);
    session.press("Enter");
    assert!(session.last_line().contains("hatch-1*"));
    let output = "this linkage is not saved yet";
    for (key, keys) in [("q", "q drop, quit"), ("n", "d drop, open")] {
        let requested = session.press(key).painted_text();
        assert!(
            requested.contains(output) && requested.contains(keys),
            "{requested}"
        );
        session.press("Esc");
        assert!(session.last_line().contains("hatch-1*"));
    }
    // Taking another candidate of the same list does not ask; an edited candidate does.
    session.press("o Home Enter Down Enter");
    assert!(session.last_line().contains("hatch-2*"));
    session.press("6 >").press("o Home Enter Home Enter");
    assert!(session.painted_text().contains("unsaved edits"));
    session.press("Esc q w Ctrl-U");
    session.type_in(file.to_str().unwrap());
    assert!(!session.workbench.press("Enter"), "written, and left");
    let written = fs::read_to_string(&file).unwrap();
    assert!(written.contains("Hatch, candidate 2"), "{written}");
}

#[test]
fn taking_candidate_asks_about_unsaved_edits() {
    let folder = folder("candidates-edited");
    fs::write(
        folder.join("hatch.toml"),
        ExampleTask::find("hatch").unwrap().text,
    )
    .unwrap();
    fs::write(folder.join("mine.toml"), text("four-bar")).unwrap();
    let mut session = opened_in(&folder, Glyphs::Ascii);
    session.press("6 > o").type_in("hatch").press("Enter");
    assert_shown(&session.painted_text(), &["4 found, 2 defective"]);
    let requested = session.press("Enter").painted_text();
    assert!(
        collapse_blanks(&requested).contains("w save")
            || collapse_blanks(&requested).contains("mine.toml"),
        "{requested}"
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
fn picker_opens_task_files_as_tasks() {
    let folder = folder("candidates-files");
    fs::write(folder.join("mine.toml"), text("four-bar")).unwrap();
    fs::write(folder.join("places.toml"), FOUR_POSES).unwrap();
    fs::write(folder.join("other.toml"), text("slider-crank")).unwrap();
    let wrong = FOUR_POSES.replace("-75.3, 83.9, -27.1", "0, 0, 0");
    fs::write(folder.join("twice.toml"), wrong).unwrap();
    let mut session = opened_in(&folder, Glyphs::Ascii);
    let screen = session.press("o").type_in("places").painted_text();
    let output = "a task: a body in 4 poses; Enter searches for linkages";
    assert!(
        collapse_blanks(&screen.replace('|', " ")).contains("a task: a body in 4 poses"),
        "{output}\n{screen}"
    );
    assert_shown(
        &session.press("Enter").painted_text(),
        &["Linkages for places"],
    );
    // A faulty task reports its error as a scene does.
    session.press("Esc o").type_in("twice");
    assert_shown(&session.painted_text(), &["cannot be opened"]);
    // A task cannot be compared with a scene, so the comparison list omits it.
    let screen = session.press("Esc D").type_in("places").painted_text();
    assert!(!screen.contains("places.toml"), "{screen}");
    let screen = session.press("Ctrl-U").type_in("other").painted_text();
    assert!(screen.contains("other.toml"), "{screen}");
}

/// The proposed name lies in the folder of the task file.
#[test]
fn candidate_is_saved_next_to_its_task_file() {
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

/// Possible pivots are drawn as dots across the whole drawing.
#[test]
fn four_poses_draw_curves_of_possible_pivots() {
    let dots = |text: &str| {
        let task = order(text, "places");
        let screen = coloured(&task, Glyphs::Ascii, Colours::None, 120, 40).painted_text();
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
fn candidates_show_same_text_without_colours() {
    let task = order(ExampleTask::find("logarithm").unwrap().text, "logarithm");
    let mut plain = coloured(&task, Glyphs::Ascii, Colours::None, 80, 24);
    let english = plain.painted_text();
    let mut painted = coloured(&task, Glyphs::Ascii, Colours::True, 80, 24);
    assert_eq!(painted.painted_text(), english);
    assert!(english.contains("> 1"), "{english}");
}
