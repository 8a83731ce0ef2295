//! A second scene beside the open one: its ghost in the drawing, and what the figures differ by.
#![cfg(feature = "tui")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "support/session.rs"]
mod session;

use krank::drawing::Glyphs;
use krank::tui::Origin;
use session::{Session, folder, open, text};
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
fn beside(test: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
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

#[test]
fn look() {
    for (glyphs, cols, rows) in [
        (Glyphs::Ascii, 80, 24),
        (Glyphs::Braille, 80, 24),
        (Glyphs::Ascii, 120, 40),
        (Glyphs::Braille, 120, 40),
        (Glyphs::Ascii, 40, 12),
    ] {
        for name in [
            "longer",
            "inches",
            "shorter",
            "slider-crank",
            "press-ram",
            "scissor-lift",
        ] {
            let mut session = beside("look-compare", glyphs, cols, rows);
            println!("{}", session.press("D").type_in(name).look());
            println!("{}", session.press("Enter").look());
            println!("{}", session.press("2").look());
        }
    }
}
