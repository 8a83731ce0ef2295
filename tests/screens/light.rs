//! Tests highlights in the drawing for the value under the cursor, and ghosts of the position
//! before an edit.

use crate::scene::Values;
use crate::screen::{Session, four_bar, open, preset, text};
use krank::drawing::Glyphs;
use krank::tui::Origin;

/// Counts the highlighted cells of an ASCII drawing: bars and marks.
fn lit(screen: &str) -> usize {
    screen.matches('#').count()
}

/// Returns the names in brackets in the drawing, the right part of the scene view. Excludes the
/// active tab and the pins of blocks.
fn names(screen: &str) -> Vec<String> {
    let drawings = screen.lines().skip(1).filter_map(|line| line.get(45..));
    let pieces = drawings.flat_map(|line| line.split('[').skip(1));
    let names = pieces.filter_map(|piece| piece.split_once(']'));
    let names = names.map(|(name, _)| name.to_owned());
    names
        .filter(|name| !["o", "@", "#"].contains(&name.as_str()))
        .collect()
}

/// Returns the scene view with the cursor on a value.
fn on(scene: &str, value: &str) -> String {
    let opened = open(scene, Origin::Preset("test".into()));
    let mut session = Session::new(opened, Glyphs::Ascii, 100, 24);
    session.press("6").find(value).painted_text()
}

/// Every kind of value highlights and names its part in ASCII; values of the whole scene highlight
/// nothing.
#[test]
fn value_under_cursor_highlights_its_part() {
    let sprung = format!(
        "{}\n[[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 10.0\nlength = 200\n",
        text("four-bar-load")
    );
    for (scene, value, name, marked) in [
        (text("four-bar"), "A x", "[A]", 1..=1),
        (text("four-bar"), "C start y", "[C]", 1..=1),
        (text("four-bar"), "r3 length", "[r3]", 5..=60),
        (text("four-bar"), "r3 com x", "[r3]", 5..=60),
        // The driver highlights the link that it turns.
        (text("four-bar"), "driver speed", "[r2]", 2..=30),
        (text("slider-crank"), "r4 angle", "[r4]", 5..=60),
        (text("excavator-boom"), "driver speed", "[rod]", 5..=60),
        // A load highlights the point on which it acts.
        (text("four-bar-load"), "E force y", "[E]", 1..=1),
        (sprung.as_str(), "spring A-C stiffness", "", 5..=60),
    ] {
        let screen = on(scene, value);
        assert_eq!(
            names(&screen).concat(),
            name.replace(['[', ']'], ""),
            "{value}\n{screen}"
        );
        let count = lit(&screen);
        assert!(marked.contains(&count), "{value}: {count} cells\n{screen}");
    }
    let screen = on(text("four-bar-load"), "gravity y");
    assert_eq!((names(&screen).len(), lit(&screen)), (0, 0), "{screen}");
}

/// The highlighted part is named whichever names are shown, and is drawn on top in the default
/// foreground colour.
#[test]
fn highlighted_part_is_bold_and_named_when_names_are_off() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Braille, 100, 30);
    session.press("i i 6").find("r3 length");
    let screen = session.painted_text();
    assert!(
        screen.contains("[r3]") && !screen.lines().any(|line| line.ends_with(" C")),
        "{screen}"
    );
    let colours = |session: &Session| {
        let screen = session.terminal.screen();
        let cells = (0..30).flat_map(|row| (50..100).map(move |col| (row, col)));
        let cells = cells.filter_map(|(row, col)| screen.cell(row, col));
        let dotted = cells.filter(|cell| cell.contents().starts_with(|c| c > '\u{2800}'));
        let bold = dotted.filter(|cell| cell.bold());
        bold.map(|cell| format!("{:?}", cell.fgcolor()))
            .collect::<Vec<_>>()
    };
    let highlighted = colours(&session);
    assert!(highlighted.len() > 20, "{}\n{screen}", highlighted.len());
    assert!(
        highlighted.iter().all(|colour| colour == "Default"),
        "{highlighted:?}"
    );
}

/// The cursor of the tables highlights its row's part; the motion view highlights nothing.
#[test]
fn table_and_plot_rows_highlight_their_parts() {
    let mut session = four_bar(120, 40);
    let plain = lit(&session.painted_text());
    assert_eq!(plain, 0);
    session.press("2");
    let screen = session.painted_text();
    assert!(screen.contains("[r2]") && lit(&screen) > 3, "{screen}");
    // After r3 and r4 comes r1, which is not a link but the line between two ground pins.
    let screen = session.press("j j j").painted_text();
    assert!(screen.contains("[r1]") && lit(&screen) > 20, "{screen}");
    insta::assert_snapshot!("lit-vector-120x40", screen);
    assert_eq!(lit(&session.press("1").painted_text()), 0);
    // The list of plots highlights parts as well.
    let screen = session.press("3 x / r 3 . o m e g a Enter").painted_text();
    assert!(screen.contains("[r3]") && lit(&screen) > 5, "{screen}");
}

/// The previous position is shown until the next key: the position before the first of several
/// steps of one edit, not before the last step.
#[test]
fn edit_shows_previous_position_as_ghost_until_next_key() {
    let ghost = |screen: &str| {
        let lines = screen.lines().filter_map(|line| line.get(45..));
        lines
            .take(20)
            .map(|line| line.matches('.').count())
            .sum::<usize>()
    };
    let mut session = four_bar(80, 24);
    // A window that follows the linkage shows it larger.
    session.press("f 6").find("r2 length");
    assert_eq!(ghost(&session.painted_text()), 0);
    let first = ghost(&session.press("> > >").painted_text());
    let later = ghost(&session.press(&"> ".repeat(20)).painted_text());
    assert!(later > first && later > 5, "{first}, {later}");
    insta::assert_snapshot!("ghost-of-an-edit-80x24", session.painted_text());
    assert_eq!(ghost(&session.press("j").painted_text()), 0);
    // After another key, the same edit starts a new ghost.
    assert!(ghost(&session.press("k >").painted_text()) < later);
    // Undo leaves a ghost too; an edit that moves nothing leaves none.
    assert!(ghost(&session.press("u u").painted_text()) > 5);
    session.find("driver speed").press("> >");
    assert_eq!(ghost(&session.painted_text()), 0);
    // While the motion plays, the previous position would belong to another moment.
    session.find("r2 length").press(&"> ".repeat(20));
    assert!(ghost(&session.painted_text()) > 3);
    session.press("space").pass(0.1).press(">");
    assert_eq!(ghost(&session.painted_text()), 0);
}
