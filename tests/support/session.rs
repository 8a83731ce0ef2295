//! A workbench, driven by keys, and the screen that it paints on.

use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, Opened, Origin, Workbench};
use std::fs;
use std::num::NonZeroU16;
use std::path::{Path, PathBuf};

/// A workbench and the screen that it paints on.
pub(crate) struct Session {
    pub(crate) workbench: Workbench,
    terminal: vt100::Parser,
}

impl Session {
    pub(crate) fn new(opened: Opened, glyphs: Glyphs, cols: u16, rows: u16) -> Self {
        let [height, width] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
        Session {
            workbench: Workbench::new(opened, glyphs, Colours::Sixteen, cols, rows),
            terminal: vt100::Parser::new(height, width, 0),
        }
    }

    pub(crate) fn press(&mut self, keys: &str) -> &mut Self {
        for key in keys.split_whitespace() {
            self.workbench.press(key);
            self.paint();
        }
        self
    }

    /// Types a word, letter by letter.
    pub(crate) fn type_in(&mut self, word: &str) -> &mut Self {
        for letter in word.chars() {
            self.press(&letter.to_string());
        }
        self
    }

    pub(crate) fn paint(&mut self) {
        let frame = self.workbench.paint();
        self.terminal.process(frame);
    }

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

pub(crate) fn open(text: &str, origin: Origin) -> Opened {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    Opened {
        scene,
        solver,
        origin,
    }
}

pub(crate) fn text(preset: &str) -> &'static str {
    presets::find(preset).unwrap().text
}

/// A folder of this name with nothing in it.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("picker")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}
