//! Editing the scene in the workbench, driven by key scripts, as a terminal shows it.
#![cfg(feature = "tui")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, Opened, Origin, Workbench};
use proptest::prelude::*;
use std::num::NonZeroU16;
use std::time::Duration;

fn open(text: &str, origin: Origin) -> Opened {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    Opened {
        scene,
        solver,
        origin,
    }
}

fn text(preset: &str) -> &'static str {
    presets::find(preset).unwrap().text
}

/// A workbench and the screen that it paints on.
struct Session {
    workbench: Workbench,
    terminal: vt100::Parser,
}

impl Session {
    fn of(opened: Opened, cols: u16, rows: u16) -> Session {
        let size = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
        Session {
            workbench: Workbench::new(opened, Glyphs::Ascii, Colours::Sixteen, cols, rows),
            terminal: vt100::Parser::new(size[0], size[1], 0),
        }
    }

    fn preset(name: &str, cols: u16, rows: u16) -> Session {
        Session::of(open(text(name), Origin::Preset(name.into())), cols, rows)
    }

    fn press(&mut self, keys: &str) -> &mut Self {
        for key in keys.split_whitespace() {
            self.workbench.press(key);
            self.paint();
        }
        self
    }

    /// Types a text, letter by letter.
    fn type_in(&mut self, text: &str) -> &mut Self {
        for c in text.chars() {
            let key = if c == ' ' {
                "space".into()
            } else {
                c.to_string()
            };
            self.press(&key);
        }
        self
    }

    /// Goes to a value of the list.
    fn find(&mut self, name: &str) -> &mut Self {
        self.press("/").type_in(name).press("Enter")
    }

    fn paint(&mut self) {
        let frame = self.workbench.paint();
        self.terminal.process(frame);
    }

    fn look(&mut self) -> String {
        self.paint();
        let width = self.terminal.screen().size().1.get();
        let rows = self.terminal.screen().rows(0, width);
        rows.map(|row| row.trim_end().to_owned() + "\n").collect()
    }

    fn last_line(&mut self) -> String {
        self.look().lines().last().unwrap().to_owned()
    }

    /// The row under the cursor, without what is drawn beside it.
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
        let screen = Session::preset("four-bar", cols, rows).press("6").look();
        insta::assert_snapshot!(format!("scene-{cols}x{rows}"), screen);
    }
}

#[test]
fn a_value_is_typed_with_a_unit_and_everything_follows() {
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = Session::preset("four-bar", cols, rows);
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
