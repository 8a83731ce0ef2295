//! A workbench driven by keys, and the emulated terminal on which it paints.

use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, OpenedScene, Origin, Workbench};
use std::cell::Cell;
use std::fs;
use std::num::NonZeroU16;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// Screens of every kind, by the names of their snapshots.
pub(crate) const SCREENS: [(&str, Glyphs, u16, u16); 6] = [
    ("ascii-80x24", Glyphs::Ascii, 80, 24),
    ("braille-80x24", Glyphs::Braille, 80, 24),
    ("ascii-120x40", Glyphs::Ascii, 120, 40),
    ("braille-120x40", Glyphs::Braille, 120, 40),
    ("ascii-40x12", Glyphs::Ascii, 40, 12),
    ("braille-40x12", Glyphs::Braille, 40, 12),
];

/// Six scenes of different kinds.
pub(crate) const SIX: [&str; 6] = [
    "four-bar",
    "slider-crank",
    "jansen-leg",
    "press-ram",
    "scissor-lift",
    "excavator-boom",
];

/// A crank that cannot turn fully: its limits are dead points, where there are no rates.
pub(crate) const SWINGING: &str = r#"
name = "Swinging crank"
unit = "mm"
[ground]
A = [0, 0]
D = [100, 0]
[driver]
link = "r2"
angle = 60
speed = "1 rad/s"
[links]
r2 = { from = "A", to = "B", length = 60 }
r3 = { from = "B", to = "C", length = 50 }
r4 = { from = "C", to = "D", length = 60 }
[start]
C = [75, 55]
"#;

/// Masks the digits of every bound as `+-Ne-NN`, so that a sharper bound does not change a
/// snapshot.
pub(crate) fn masked(text: &str) -> String {
    let mut pieces = text.split("+-");
    let first = pieces.next().unwrap().to_owned();
    pieces.fold(first, |mut all, piece| {
        let digits = |c: char| if c.is_ascii_digit() { 'N' } else { c };
        let end = piece.find(' ').unwrap_or(piece.len());
        all.push_str("+-");
        all.extend(piece[..end].chars().map(digits));
        all.push_str(&piece[end..]);
        all
    })
}

/// Returns the time of a simulated clock that advances by 5 ms per call. A study then does a few
/// pieces of work per frame and finds the same times on every machine.
pub(crate) fn made_up() -> Duration {
    // Tests in other threads do not advance it.
    thread_local!(static NOW: Cell<Duration> = const { Cell::new(Duration::ZERO) });
    NOW.set(NOW.get() + Duration::from_millis(5));
    NOW.get()
}

/// Opens a scene from its text.
pub(crate) fn open(text: &str, origin: Origin) -> OpenedScene {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    OpenedScene {
        scene,
        solver,
        origin,
    }
}

/// Returns the text of a preset.
pub(crate) fn text(preset: &str) -> &'static str {
    presets::find(preset).unwrap().text
}

/// Opens a preset.
pub(crate) fn preset(name: &str) -> OpenedScene {
    open(text(name), Origin::Preset(name.into()))
}

/// Creates an empty folder for the files of one test.
pub(crate) fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    // Tests of other programs may have the same name, and run at the same time.
    let folder = folder.join(env!("CARGO_CRATE_NAME")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Creates a blank terminal of this size.
pub(crate) fn emulator(cols: u16, rows: u16) -> vt100::Parser {
    let [rows, cols] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
    vt100::Parser::new(rows, cols, 0)
}

/// Opens the lecture's four-bar in ASCII.
pub(crate) fn four_bar(cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows)
}

/// Runs the program and returns its output and exit code.
pub(crate) fn krank(args: &[&str]) -> (String, Option<i32>) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_krank"));
    command.env_clear().env("LC_ALL", "C").args(args);
    let output = command.stdin(Stdio::null()).output().unwrap();
    (
        String::from_utf8(output.stdout).unwrap(),
        output.status.code(),
    )
}

/// Opens a session whose studies use the simulated clock.
pub(crate) fn timed(opened: OpenedScene, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let workbench = Workbench::new(opened, glyphs, Colours::Sixteen, cols, rows);
    Session::on(workbench.timed_by(made_up), cols, rows)
}

/// A workbench and the screen on which it paints.
pub(crate) struct Session {
    pub(crate) workbench: Workbench,
    pub(crate) terminal: vt100::Parser,
}

impl Session {
    pub(crate) fn new(opened: OpenedScene, glyphs: Glyphs, cols: u16, rows: u16) -> Self {
        Session::on(
            Workbench::new(opened, glyphs, Colours::Sixteen, cols, rows),
            cols,
            rows,
        )
    }

    pub(crate) fn on(workbench: Workbench, cols: u16, rows: u16) -> Self {
        Session {
            workbench,
            terminal: emulator(cols, rows),
        }
    }

    /// Presses the named keys, and paints after each.
    pub(crate) fn press(&mut self, keys: &str) -> &mut Self {
        for key in keys.split_whitespace() {
            self.workbench.press(key);
            self.paint();
        }
        self
    }

    /// Gives the terminal another size.
    pub(crate) fn resize(&mut self, cols: u16, rows: u16) -> &mut Self {
        self.terminal = emulator(cols, rows);
        self.workbench.resize(cols, rows);
        self.paint();
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

    /// Lets time pass.
    pub(crate) fn pass(&mut self, seconds: f64) -> &mut Self {
        self.workbench.pass(Duration::from_secs_f64(seconds));
        self
    }

    pub(crate) fn paint(&mut self) {
        let frame = self.workbench.paint();
        self.terminal.process(frame);
    }

    /// Paints, and returns the screen as text.
    pub(crate) fn painted_text(&mut self) -> String {
        self.paint();
        let width = self.terminal.screen().size().1.get();
        let rows = self.terminal.screen().rows(0, width);
        rows.map(|row| row.trim_end().to_owned() + "\n").collect()
    }

    /// Returns the screen without the title, the verdict and the last line.
    pub(crate) fn body(&mut self) -> String {
        let text = self.painted_text();
        let inner = text.lines().count().saturating_sub(3);
        let lines = text.lines().skip(1).take(inner);
        lines.map(|line| line.to_owned() + "\n").collect()
    }

    pub(crate) fn last_line(&mut self) -> String {
        self.painted_text().lines().last().unwrap().to_owned()
    }
}
