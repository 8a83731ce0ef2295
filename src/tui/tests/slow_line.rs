//! Tests a line of 960 bytes per second with a simulated clock, so that the timing does not depend
//! on the machine.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::document::opening;
use crate::tui::terminal::SlowLine;
use crate::tui::{Session, Workbench};
use ratatui::layout::Size;
use std::num::NonZeroU16;
use std::time::{Duration, Instant};

/// The rate of a line of 9,600 baud, in bytes per second.
const SLOW_LINE_RATE: u32 = 960;
const SIZE: Size = Size::new(80, 24);
const HALF_A_SECOND: Duration = Duration::from_millis(500);

fn workbench(at: Option<f64>) -> Workbench {
    workbench_on(at, SIZE)
}

fn workbench_on(at: Option<f64>, size: Size) -> Workbench {
    workbench_of("four-bar", at, size)
}

fn workbench_of(preset: &str, at: Option<f64>, size: Size) -> Workbench {
    let capability = Capability {
        glyphs: Glyphs::Braille,
        colours: Colours::Indexed,
        modern: true,
    };
    let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
    Workbench::on(opened, at, capability, size)
}

fn emulator(size: Size) -> vt100::Parser {
    let [rows, cols] = [size.height, size.width].map(|n| NonZeroU16::new(n).unwrap());
    vt100::Parser::new(rows, cols, 0)
}

fn rows(terminal: &vt100::Parser) -> Vec<String> {
    let (_, width) = terminal.screen().size();
    terminal.screen().rows(0, width.get()).collect()
}

fn last_row(rows: &[String]) -> &str {
    rows.last().map_or("", String::as_str)
}

/// Returns the rows that a line of unlimited speed shows.
fn shown_at_once(at: Option<f64>, keys: &str) -> Vec<String> {
    let (mut workbench, mut terminal) = (workbench(at), emulator(SIZE));
    assert!(workbench.press(keys));
    terminal.process(workbench.paint());
    rows(&terminal)
}

/// A session on a slow line, and the terminal at the other end.
struct Slow {
    session: Session<SlowLine>,
    terminal: vt100::Parser,
    /// Number of bytes that the terminal has shown.
    shown: usize,
}

impl Slow {
    /// Opens the four-bar and waits until its first screen is complete.
    fn open(rate: u32) -> Slow {
        Slow::open_on(rate, SIZE)
    }

    fn open_on(rate: u32, size: Size) -> Slow {
        Slow::open_with(rate, workbench_on(None, size), size)
    }

    fn open_with(rate: u32, workbench: Workbench, size: Size) -> Slow {
        let line = SlowLine::new(rate, size);
        let mut slow = Slow {
            session: Session::new(line, workbench),
            terminal: emulator(size),
            shown: 0,
        };
        slow.settle();
        slow
    }

    fn line(&mut self) -> &mut SlowLine {
        &mut self.session.tty
    }

    fn now(&mut self) -> Instant {
        crate::tui::Console::now(self.line())
    }

    fn step(&mut self) {
        assert!(self.session.step().unwrap().is_none(), "it has ended");
    }

    /// Shows the bytes that have arrived, eight at a time, until `holds` returns `true`. Returns
    /// the time at which it did.
    fn show_until(&mut self, holds: &dyn Fn(&[String]) -> bool) -> Option<Instant> {
        for piece in self.session.tty.arrived()[self.shown..].chunks(8) {
            for &(_, byte) in piece {
                self.terminal.process(&[byte]);
            }
            self.shown += piece.len();
            if holds(&rows(&self.terminal)) {
                return piece.last().map(|&(at, _)| at);
            }
        }
        None
    }

    /// Shows all bytes that have arrived.
    fn show(&mut self) {
        for &(_, byte) in &self.session.tty.arrived()[self.shown..] {
            self.terminal.process(&[byte]);
        }
        self.shown = self.session.tty.arrived().len();
    }

    /// Waits until the line is idle.
    fn settle(&mut self) {
        while !self.line().idle {
            self.step();
        }
        self.show();
    }

    /// Lets time pass.
    fn pass(&mut self, time: Duration) {
        let end = self.now() + time;
        while self.now() < end {
            self.step();
        }
        self.show();
    }

    fn press(&mut self, key: &'static str) {
        self.line().press_after(key, Duration::ZERO);
    }

    /// Presses a key, and returns the time until `holds` returns `true`.
    fn until(&mut self, key: &'static str, holds: impl Fn(&[String]) -> bool) -> Duration {
        let pressed = self.now();
        self.press(key);
        loop {
            if let Some(seen) = self.show_until(&holds) {
                return seen - pressed;
            }
            self.step();
            assert!(!self.line().idle, "never: {:#?}", rows(&self.terminal));
        }
    }
}

/// The last row follows the frame in flight, and is complete after one more frame.
#[test]
fn last_row_answers_key_within_half_a_second() {
    let mut slow = Slow::open(SLOW_LINE_RATE);
    let took = slow.until(".", |rows| last_row(rows).contains("65.00 deg"));
    assert!(took <= HALF_A_SECOND, "{took:?}");
    slow.press("space");
    slow.pass(Duration::from_millis(2600));
    let modes = [
        ("?", " help "),
        ("Esc", " motion "),
        ("2", " tables "),
        ("1", " motion "),
    ];
    for (key, mode) in modes {
        let took = slow.until(key, |rows| last_row(rows).starts_with(mode));
        assert!(took <= HALF_A_SECOND, "{mode}: {took:?}");
        slow.pass(Duration::from_millis(300));
    }
}

#[test]
fn whole_help_overlay_shows_within_two_seconds() {
    let inner = |row: &String| {
        let (from, to) = (row.find('\u{2502}')?, row.rfind('\u{2502}')?);
        (from < to).then(|| row[from..to].to_owned())
    };
    let help: Vec<String> = shown_at_once(None, "?").iter().filter_map(inner).collect();
    assert!(help.len() > 10, "{help:?}");
    // At several points of the frame in flight, with the drawing at several driver angles.
    for k in 0..12 {
        let mut slow = Slow::open(SLOW_LINE_RATE);
        slow.press("space");
        slow.pass(Duration::from_millis(2000 + 171 * k));
        let took = slow.until("?", |rows| {
            // A box is drawn with ASCII lines at first.
            let rows: Vec<_> = rows
                .iter()
                .map(|row| row.replace('|', "\u{2502}"))
                .collect();
            help.iter()
                .all(|line| rows.iter().any(|row| row.contains(line)))
        });
        assert!(took <= Duration::from_secs(2), "{took:?}, case {k}");
    }
}

#[test]
fn queue_holds_at_most_half_a_second() {
    let maximum = SLOW_LINE_RATE as usize / 2;
    let mut slow = Slow::open(SLOW_LINE_RATE);
    assert!(
        slow.line().longest <= maximum,
        "at the start: {}",
        slow.line().longest
    );
    slow.press("space");
    for key in [
        "?", "Esc", "2", "1", "+", "Ctrl-L", "2", "Ctrl-L", "1", "Ctrl-L",
    ] {
        slow.pass(Duration::from_millis(700));
        slow.press(key);
    }
    slow.pass(Duration::from_secs(2));
    assert!(slow.line().longest <= maximum, "{}", slow.line().longest);
}

fn angle(rows: &[String]) -> Option<f64> {
    let words: Vec<_> = last_row(rows).split_whitespace().collect();
    let deg = words.iter().position(|word| *word == "deg")?;
    let within: f64 = words.get(deg.checked_sub(1)?)?.parse().ok()?;
    let turns = match words.get(deg + 2) {
        Some(word) if word.starts_with("turn") => words[deg + 1].parse().ok()?,
        _ => 0.0,
    };
    Some(within + 360.0 * turns)
}

/// Frames are dropped but the motion keeps its speed of a turn in 4 s, as on any line.
#[test]
fn playback_keeps_pace_with_clock() {
    let mut slow = Slow::open(SLOW_LINE_RATE);
    slow.press("space");
    let started = slow.now();
    let mut last = 60.0;
    for _ in 0..160 {
        slow.pass(Duration::from_millis(50));
        let rows = rows(&slow.terminal);
        last = angle(&rows).unwrap_or(last);
        let played = slow.now() - started;
        let wanted = 60.0 + 90.0 * played.as_secs_f64();
        // At most a second late.
        assert!(
            last <= wanted && wanted - last <= 90.0,
            "{last} of {wanted} deg"
        );
    }
    assert!(last > 600.0, "{last}");
}

/// Returns the drawings per second that the line transmits completely while a preset plays.
fn drawings_per_second(preset: &str, size: Size) -> f64 {
    let mut slow = Slow::open_with(SLOW_LINE_RATE, workbench_of(preset, None, size), size);
    slow.press("space");
    // The key itself is answered by a frame of the whole screen.
    slow.pass(Duration::from_secs(4));
    // A turn of the slowest preset.
    let seconds = 12;
    let end = slow.now() + Duration::from_secs(seconds);
    let (mut count, mut drawings) = (slow.session.workbench.frames().count, 0);
    while slow.now() < end {
        slow.step();
        let now = slow.session.workbench.frames().count;
        let is_whole = now != count && !slow.session.workbench.is_cut();
        drawings += u32::from(is_whole);
        count = now;
    }
    f64::from(drawings) / seconds as f64
}

/// The target for a screen of 120x40 lies between those of the two other sizes.
#[test]
fn playback_shows_three_drawings_per_second_and_one_on_large_screen() {
    let sizes = [
        (SIZE, 3.0),
        (Size::new(120, 40), 1.5),
        (Size::new(200, 60), 1.0),
    ];
    let mut slow = Vec::new();
    for preset in presets::all() {
        for (size, minimum) in sizes {
            let shown = drawings_per_second(preset.name, size);
            if shown < minimum {
                slow.push(format!("{} {size}: {shown}", preset.name));
            }
        }
    }
    assert!(slow.is_empty(), "{slow:#?}");
}

/// Regression test: late answers counted as lost ones, so that frames piled up and a key was
/// answered after 4 to 7 s.
#[test]
fn line_that_becomes_slow_is_noticed() {
    for size in [SIZE, Size::new(200, 60)] {
        for k in 0..6 {
            let mut slow = Slow::open_on(1_000_000, size);
            slow.press("space");
            slow.pass(Duration::from_millis(2000 + 37 * k));
            slow.line().set_rate(SLOW_LINE_RATE);
            // The frames sent until the line is known to be slow.
            slow.pass(Duration::from_secs(6));
            let queued = slow.line().longest;
            assert!(
                queued <= 4 * SLOW_LINE_RATE as usize,
                "{size}: {queued} bytes"
            );
            let took = slow.until("?", |rows| last_row(rows).starts_with(" help "));
            assert!(took <= Duration::from_secs(1), "{size}: {took:?}, case {k}");
            slow.press("Esc");
            slow.pass(Duration::from_secs(3));
            slow.line().set_rate(1_000_000);
            slow.pass(Duration::from_secs(6));
            let before = slow.session.workbench.frames().count;
            slow.pass(Duration::from_secs(1));
            let shown = slow.session.workbench.frames().count - before;
            assert!(
                shown >= 25,
                "{size}: {shown} frames a second on the fast line"
            );
        }
    }
}

/// The tables pause during playback and are complete after it.
#[test]
fn pausing_playback_completes_screen() {
    let mut slow = Slow::open(SLOW_LINE_RATE);
    slow.press("space");
    slow.pass(Duration::from_secs(3));
    slow.press("space");
    slow.settle();
    let expected = slow.session.workbench.text();
    let shown: Vec<String> = rows(&slow.terminal);
    let shown: Vec<&str> = shown.iter().map(|row| row.trim_end()).collect();
    assert_eq!(shown, expected.lines().collect::<Vec<_>>());
}

/// The terminal has answered so far, and then stops.
#[test]
fn silent_terminal_still_gets_frames() {
    for rate in [SLOW_LINE_RATE, 1_000_000] {
        let mut slow = Slow::open(rate);
        slow.line().silent = true;
        for k in 1..=8 {
            let to = format!("{}.00 deg", 60 + 5 * k);
            let took = slow.until(".", |rows| last_row(rows).contains(&to));
            assert!(took < Duration::from_secs(3), "{took:?} to {to}, {rate}");
        }
    }
}

/// Regression test: a message stayed until the next key, because no answer told when it was visible.
#[test]
fn message_expires_on_silent_terminal() {
    let mut slow = Slow::open(1_000_000);
    slow.line().silent = true;
    let shows = |rows: &[String]| rows.iter().any(|row| row.contains("velocity arrows"));
    slow.until("v", shows);
    slow.settle();
    assert!(!shows(&rows(&slow.terminal)), "{:#?}", rows(&slow.terminal));
}

#[test]
fn screen_is_complete_after_key_repeat() {
    let mut slow = Slow::open(SLOW_LINE_RATE);
    for k in 0..40 {
        slow.line().press_after(".", Duration::from_millis(30 * k));
    }
    slow.settle();
    // Labels keep their places as long as possible, so the fast line must show every step, too.
    let mut fast = Slow::open(1_000_000);
    for _ in 0..40 {
        fast.press(".");
        fast.settle();
    }
    let (slow, fast) = (rows(&slow.terminal), rows(&fast.terminal));
    // The footer is excluded because it shows the measured computing time.
    let above = SIZE.height as usize - 1;
    assert!(last_row(&slow).contains(" 260.00 deg "), "{slow:?}");
    assert_eq!(slow[..above], fast[..above]);
}
