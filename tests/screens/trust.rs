//! Tests missing and unproved values: dead points, dim digits, and the largest error bound.

use crate::claims::{assert_shown, collapse_blanks};
use crate::screen::{SWINGING, Session, emulator, open, preset};
use krank::drawing::Glyphs;
use krank::tui::{Colours, Origin, Workbench};

fn four_bar(glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), glyphs, cols, rows)
}

#[test]
fn dead_point_shows_missing_rates_as_dashes() {
    let opened = open(SWINGING, Origin::File("bench/swinging.toml".into()));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("] ] ] ] ] .");
    let screen = session.painted_text();
    // Positions are shown, but only the driver has rates.
    let lines = [
        "| r3 50.0000 327.236*",
        "| r4 60.0000 327.236*",
        "| vector r' omega",
        "| r2 0 1.00000",
        "| r3 0 -",
        "| r4 0 -",
        "| vector r'' alpha",
        "| r2 0 0.00000",
        "| r3 0 -",
        "| r4 0 -",
        "motion 82.81924422 deg dead point: no rates the motion ends here",
    ];
    assert_shown(&screen, &lines);
    let line = session.press(".").last_line();
    assert!(line.contains("the motion ends here"), "{line}");
    assert!(line.contains("dead point: no rates"), "{line}");
    session.workbench.resize(40, 12);
    session.terminal = emulator(40, 12);
    let screen = session.press(".").painted_text();
    assert!(
        collapse_blanks(&screen).contains("the motion ends here"),
        "{screen}"
    );
    let line = session.last_line();
    assert!(line.contains("82.81924422 deg dead point"), "{line}");
}

/// Within 5e-13 deg of the dead point of [`SWINGING`], where rates have at most four proved digits.
const NEAR_DEAD_POINT: &str = "g 8 2 . 8 1 9 2 4 4 2 1 8 5 4 1 Enter";

/// Unproved digits are dim, or dots without colours.
#[test]
fn unproved_digits_are_dim_or_dotted() {
    let plain = |cols, rows| {
        let opened = open(SWINGING, Origin::Stdin);
        let workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, cols, rows);
        Session::on(workbench, cols, rows)
            .press(NEAR_DEAD_POINT)
            .painted_text()
    };
    let lines = [
        "| r3 50.0000 327.236*",
        "| r2 0 1.00000",
        "| r3 0 -4.8...e6*",
        "| r4 0 4.0....e6*",
        "| r2 0 0.00000",
        "| r3 0 -1.9..e20*",
        "| r4 0 1.6...e20*",
        "82.81924422 deg dead point within 0.1 deg ? help",
    ];
    assert_shown(&plain(80, 24), &lines);
    // Positions keep their digits, and a short line shows the position in full in preference to
    // what lies ahead.
    let lines = ["r3 50.0000 327.236*", "motion 82.81924422 deg ok ? help"];
    assert_shown(&plain(40, 12), &lines);
    let mut session = Session::new(open(SWINGING, Origin::Stdin), Glyphs::Ascii, 80, 24);
    let screen = session.press(NEAR_DEAD_POINT).painted_text();
    // Marks the dim characters of a rate of r4.
    let row = screen
        .lines()
        .position(|line| collapse_blanks(line).contains("| r4 0 4."))
        .unwrap();
    let line = screen.lines().nth(row).unwrap();
    let from = line.find("  4.").unwrap() + 2;
    let dim: String = (from..line.len())
        .map(|col| {
            let at = |n: usize| u16::try_from(n).unwrap();
            let cell = session.terminal.screen().cell(at(row), at(col)).unwrap();
            if cell.dim() { '~' } else { ' ' }
        })
        .collect();
    assert_eq!(&dim[..1], " ", "{line}\n{dim}");
    assert!(dim.contains("~~~"), "{line}\n{dim}");
    assert!(
        dim.trim_start().trim_end().len() < line[from..].len(),
        "{line}\n{dim}"
    );
    // Away from the dead point, the last line shows a bound.
    let line = session.press("Home").last_line();
    assert!(line.contains("ok  +-"), "{line}");
}

/// The last line shows the largest bound of a position, but not in views without values.
#[test]
fn last_line_shows_largest_error_bound() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let line = session.last_line();
    let bound = line
        .split("ok  +-")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap();
    assert!(
        (1e-14..1e-12).contains(&bound.parse::<f64>().unwrap()),
        "{line}"
    );
    assert!(line.contains(" mm  ? help"), "{line}");
    assert!(!session.press("e").last_line().contains("+-"));
    assert!(!session.press("1 ?").last_line().contains("+-"));
    // On a short line, the help key takes precedence.
    let mut narrow = four_bar(Glyphs::Ascii, 40, 12);
    let line = narrow.last_line();
    assert!(line.contains("? help") && !line.contains("+-"), "{line}");
}
