//! A workbench with an emulated terminal.

use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, Opened, Origin, Workbench};
use std::num::NonZeroU16;

/// Opens a scene from its text.
pub(crate) fn open(text: &str, origin: Origin) -> Opened {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    Opened {
        scene,
        solver,
        origin,
    }
}

/// Opens a preset.
pub(crate) fn preset(name: &str) -> Opened {
    let text = presets::find(name).unwrap().text;
    open(text, Origin::Preset(name.into()))
}

/// A workbench and the screen that it paints on.
pub(crate) struct Session {
    pub(crate) workbench: Workbench,
    pub(crate) terminal: vt100::Parser,
}

impl Session {
    pub(crate) fn new(opened: Opened, glyphs: Glyphs, cols: u16, rows: u16) -> Self {
        Session::on(
            Workbench::new(opened, glyphs, Colours::Sixteen, cols, rows),
            cols,
            rows,
        )
    }

    pub(crate) fn on(workbench: Workbench, cols: u16, rows: u16) -> Self {
        let [rows, cols] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
        Session {
            workbench,
            terminal: vt100::Parser::new(rows, cols, 0),
        }
    }

    /// Presses keys by their names, and paints after each.
    pub(crate) fn press(&mut self, keys: &str) -> &mut Self {
        for key in keys.split_whitespace() {
            self.workbench.press(key);
            self.paint();
        }
        self
    }

    /// Types text, character by character.
    pub(crate) fn type_in(&mut self, text: &str) -> &mut Self {
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

    pub(crate) fn paint(&mut self) {
        let frame = self.workbench.paint();
        self.terminal.process(frame);
    }

    /// The screen as text.
    pub(crate) fn look(&mut self) -> String {
        self.paint();
        let width = self.terminal.screen().size().1.get();
        let rows = self.terminal.screen().rows(0, width);
        rows.map(|row| row.trim_end().to_owned() + "\n").collect()
    }

    pub(crate) fn last_line(&mut self) -> String {
        self.look().lines().last().unwrap().to_owned()
    }
}
