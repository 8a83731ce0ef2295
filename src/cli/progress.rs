//! Shows a long command's progress on a line of standard error.
//!
//! The line appears only after a delay, changes a few times per second, and disappears at the end,
//! even if a signal ends the program. It is not shown where it would disturb results or other
//! programs: without a terminal, if the results go to a terminal, on a terminal that cannot move
//! its cursor back, and in the background.

use crate::cli::failure::print_text;
use crate::cli::screen::TextScreen;
use crate::wording::words;
use rustix::process::getpgrp;
use rustix::termios::{tcgetpgrp, tcgetwinsize};
use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::flag;
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::{fs, io, thread};

/// Minimum duration of a command before the line appears.
const DELAY: Duration = Duration::from_millis(500);
/// Time between two updates of the line.
const PAUSE: Duration = Duration::from_millis(100);
/// Width in columns if the terminal reports none.
const WIDTH: usize = 80;
/// Maximum length of the bar; more would add no information.
const MAX_BAR_LEN: usize = 40;
/// Free columns at the end of the line: two for `^C`, which the terminal echoes there, and the last
/// column, after which the line would wrap.
const FREE: usize = 3;
/// The signals that ask a program to end. A stoppable command then reports its results first.
const STOP_SIGNALS: [i32; 3] = [SIGINT, SIGTERM, SIGHUP];
/// Returns to the first column and clears the line.
const CLEAR: &str = "\r\x1b[K";

/// The progress of a command.
pub(super) struct Progress {
    total: u64,
    /// The name of the counted items, such as `rows`.
    unit: &'static str,
    screen: TextScreen,
    /// `None` if the line is not shown.
    line: Option<Arc<Mutex<ProgressLine>>>,
    begin: Instant,
    /// The time of the next update.
    next: Duration,
    /// The best result so far, as text; empty if there is none.
    best: String,
    /// `None` if signals end the command.
    stop: Option<StopFlags>,
}

/// How signals stop a command that then reports its results.
#[derive(Clone, Default)]
struct StopFlags {
    /// Set by the first Ctrl-C, SIGTERM or SIGHUP.
    is_stopped: Arc<AtomicBool>,
    /// Set at the end of the work.
    is_over: Arc<AtomicBool>,
}

/// The text on the terminal; empty before the first update and after clearing.
#[derive(Default)]
struct ProgressLine(String);

impl Progress {
    /// Creates the progress of a command with `total` items, counted in `unit`. The last argument
    /// is `true` if the results go to the terminal; then the line is not shown.
    pub(super) fn new(
        total: u64,
        unit: &'static str,
        screen: TextScreen,
        nearby: bool,
    ) -> Progress {
        let seen = screen.redraws && !nearby;
        Progress {
            total,
            unit,
            screen,
            line: seen.then(Arc::default),
            begin: Instant::now(),
            next: DELAY,
            best: String::new(),
            stop: None,
        }
    }

    /// Makes the first Ctrl-C, SIGTERM or SIGHUP stop the search, so that the command can report
    /// its results; a second Ctrl-C ends the program.
    pub(super) fn stoppable(self) -> Progress {
        Progress {
            stop: StopFlags::registered().ok().flatten(),
            ..self
        }
    }

    /// Shows the best result so far after the progress.
    pub(super) fn show_best(&mut self, best: String) {
        self.best = best;
    }

    /// Returns `true` if the search should stop.
    pub(super) fn is_stopped(&self) -> bool {
        self.stop
            .as_ref()
            .is_some_and(|stop| stop.is_stopped.load(Ordering::Relaxed))
    }

    /// Reports the number of completed items, and updates the line if an update is due. Most calls
    /// are very cheap.
    pub(super) fn report_progress(&mut self, done: u64) {
        let Some(line) = &self.line else { return };
        let elapsed = self.begin.elapsed();
        if elapsed < self.next {
            return;
        }
        let first = self.next == DELAY;
        self.next = elapsed + PAUSE;
        if self.is_stopped() {
            return;
        }
        if first && watch_for_signals(Arc::clone(line), self.stop.is_some()).is_err() {
            // A line that stays after a signal is worse than no line.
            self.line = None;
            return;
        }
        let counted = Counted {
            done,
            total: self.total,
            unit: self.unit,
            elapsed,
            best: &self.best,
        };
        let text = counted.line(width(), self.screen.ascii);
        hold(line).show(self.screen.shown(&text));
    }

    /// Clears the line at the end of the work. From then on Ctrl-C and SIGTERM end the program
    /// again.
    pub(super) fn end(self) {
        self.clear();
        if let Some(stop) = &self.stop {
            stop.is_stopped.store(true, Ordering::Relaxed);
            stop.is_over.store(true, Ordering::Relaxed);
        }
    }

    /// Clears the line until the next update.
    pub(super) fn clear(&self) {
        if let Some(line) = &self.line {
            hold(line).clear();
        }
    }
}

impl ProgressLine {
    fn show(&mut self, text: String) {
        if self.0 != text && in_the_foreground() {
            print_text(&format!("{CLEAR}{text}"));
            self.0 = text;
        }
    }

    fn clear(&mut self) {
        if !std::mem::take(&mut self.0).is_empty() && in_the_foreground() {
            print_text(CLEAR);
        }
    }
}

/// Locks the line. Its state is valid even if a panic poisoned the lock.
fn hold(line: &Mutex<ProgressLine>) -> MutexGuard<'_, ProgressLine> {
    line.lock().unwrap_or_else(PoisonError::into_inner)
}

impl StopFlags {
    /// Registers the signals. `None` if Ctrl-C, SIGTERM and SIGHUP are all ignored; an ignored one,
    /// as Ctrl-C in a script's background job, stays ignored.
    fn registered() -> io::Result<Option<StopFlags>> {
        let caught: Vec<i32> = caught(&STOP_SIGNALS).collect();
        if caught.is_empty() {
            return Ok(None);
        }
        let stop = StopFlags::default();
        // Without it, a signal between the two registrations below would have no effect.
        let early = Arc::<AtomicBool>::default();
        for signal in caught {
            flag::register(signal, Arc::clone(&early))?;
            // `timeout` sends SIGTERM twice, and a closed terminal SIGHUP: once by its shell and
            // once by the system. Only a person who repeats Ctrl-C wants to end at once.
            let ends = match signal {
                SIGINT => Some(&stop.is_stopped),
                SIGTERM => Some(&stop.is_over),
                _ => None,
            };
            // Registered before `is_stopped`, so that the signal that sets it does not end the program.
            if let Some(ends) = ends {
                flag::register_conditional_default(signal, Arc::clone(ends))?;
            }
            flag::register(signal, Arc::clone(&stop.is_stopped))?;
        }
        if early.load(Ordering::Relaxed) {
            stop.is_stopped.store(true, Ordering::Relaxed);
        }
        Ok(Some(stop))
    }
}

/// Returns those signals that the parent process did not make the program ignore.
fn caught(signals: &[i32]) -> impl Iterator<Item = i32> + '_ {
    signals
        .iter()
        .copied()
        .filter(|&signal| !is_ignored(signal))
}

/// Returns `true` if the parent process made the program ignore a signal; `false` if unknown.
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// Starts clearing the line before a signal ends the program, even while the program waits for a
/// reader of its results. A stoppable command continues after the first signal that stops it.
fn watch_for_signals(line: Arc<Mutex<ProgressLine>>, is_stoppable: bool) -> io::Result<()> {
    let caught: Vec<i32> = caught(&[SIGINT, SIGTERM, SIGHUP, SIGQUIT]).collect();
    // Registered within the thread: if the thread cannot be created, signals keep their effect.
    let (ready, is_ready) = channel();
    let wait = move || {
        let mut signals = Signals::new(caught).ok();
        let _ = ready.send(signals.is_some());
        for signal in signals.iter_mut().flat_map(|signals| signals.forever()) {
            // Locked to the end, so that no update intervenes.
            let mut line = hold(&line);
            line.clear();
            if !STOP_SIGNALS.contains(&signal) || !is_stoppable {
                // Without the default handler the program continues; the error cannot be reported.
                let _ = emulate_default_handler(signal);
            }
        }
    };
    thread::Builder::new().spawn(wait)?;
    match is_ready.recv() {
        Ok(true) => Ok(()),
        Ok(false) | Err(_) => Err(io::ErrorKind::Other.into()),
    }
}

/// Returns `true` if the program is in the terminal's foreground.
fn in_the_foreground() -> bool {
    tcgetpgrp(io::stderr()).is_ok_and(|group| group == getpgrp())
}

/// Returns the terminal's width in columns, or [`WIDTH`] if the terminal reports none.
fn width() -> usize {
    let count = tcgetwinsize(io::stderr()).map_or(0, |size| usize::from(size.ws_col));
    if count == 0 { WIDTH } else { count }
}

/// The contents of the line.
struct Counted<'a> {
    done: u64,
    total: u64,
    unit: &'static str,
    elapsed: Duration,
    best: &'a str,
}

impl Counted<'_> {
    /// Formats the line for a width in columns. Parts that do not fit are omitted, the least
    /// important first.
    fn line(&self, width: usize, ascii: bool) -> String {
        let percent = self.done.saturating_mul(100) / self.total.max(1);
        let percent = format!("{percent:3} %");
        let left = format!("  {}", self.left());
        let (done, total) = (in_groups(self.done), in_groups(self.total));
        let count = format!("  {}", words().done_of(&done, &total, self.unit));
        let space = width.saturating_sub(FREE);
        let mut tails = Vec::new();
        if !self.best.is_empty() {
            let best = format!("  {}", words().best_so_far(self.best));
            tails.push(format!("{percent}{count}{left}{best}"));
            tails.extend([format!("{percent}{left}{best}"), percent.clone() + &best]);
        }
        tails.push(format!("{percent}{count}{left}"));
        tails.extend([percent.clone() + &left, percent.clone()]);
        // A bar needs at least eleven columns, and a blank after it.
        let length = |tail: &String| tail.chars().count();
        let fits = |tail: &&String| length(tail) + 12 <= space;
        match tails.iter().find(fits) {
            Some(tail) => self.bar(space - length(tail) - 1, ascii) + " " + tail,
            None => percent.chars().take(space).collect(),
        }
    }

    /// Draws a bar of at most `space` columns.
    fn bar(&self, space: usize, ascii: bool) -> String {
        let (full, open, ends) = if ascii {
            ("#", ".", ["[", "]"])
        } else {
            ("\u{2501}", "\u{2500}", ["", ""])
        };
        let length = space.min(MAX_BAR_LEN) - ends.concat().len();
        let share = self.done as f64 / self.total.max(1) as f64;
        let filled = ((share * length as f64) as usize).min(length);
        let (full, open) = (full.repeat(filled), open.repeat(length - filled));
        format!("{}{full}{open}{}", ends[0], ends[1])
    }

    /// Returns the estimated remaining time, in its largest unit and the next.
    fn left(&self) -> String {
        let rest = self.total.saturating_sub(self.done) as f64;
        let seconds = (self.elapsed.as_secs_f64() * rest / self.done.max(1) as f64).ceil();
        let (minutes, hours) = ((seconds / 60.0).floor(), (seconds / 3600.0).floor());
        if minutes < 1.0 {
            words().seconds_left(seconds)
        } else if hours < 1.0 {
            words().minutes_left(minutes, seconds % 60.0)
        } else {
            words().hours_left(hours, minutes % 60.0)
        }
    }
}

/// Formats a number with commas between groups of three digits: `1,000,000`.
fn in_groups(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() * 4 / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(done: u64, seconds: f64) -> Counted<'static> {
        Counted {
            done,
            total: 1_000_000,
            unit: "rows",
            elapsed: Duration::from_secs_f64(seconds),
            best: "",
        }
    }

    #[test]
    fn best_result_is_kept_longer_than_the_count() {
        let half = Counted {
            best: "12.5 mm",
            ..counted(500_000, 3.0)
        };
        let tail = |width| half.line(width, true).split("] ").nth(1).map(str::to_owned);
        let text = " 50 %  500,000 of 1,000,000 rows  3 s left  best 12.5 mm";
        assert_eq!(tail(80).as_deref(), Some(text));
        assert_eq!(tail(60).as_deref(), Some(" 50 %  3 s left  best 12.5 mm"));
        assert_eq!(tail(36).as_deref(), Some(" 50 %  best 12.5 mm"));
        assert_eq!(tail(24).as_deref(), Some(" 50 %"));
    }

    #[test]
    fn what_does_not_fit_is_left_out() {
        let half = counted(500_000, 3.0);
        let lines = [80, 60, 40, 24, 12, 4, 1, 0].map(|width| half.line(width, true));
        let expected = [
            "[###################...................]  50 %  500,000 of 1,000,000 rows  3 s left",
            "[######......]  50 %  500,000 of 1,000,000 rows  3 s left",
            "[#########..........]  50 %  3 s left",
            "[######.......]  50 %",
            " 50 %",
            " ",
            "",
            "",
        ];
        assert_eq!(lines[1..], expected[1..]);
        for (line, width) in lines.iter().zip([80, 60, 40, 24, 12, 4, 1, 0_usize]) {
            assert!(
                line.len() <= width.saturating_sub(FREE),
                "`{line}` in {width}"
            );
        }
        assert_eq!(half.line(200, true), expected[0]);
    }

    #[test]
    fn a_bar_fills_from_end_to_end() {
        let bars = [0, 1_000, 999_999, 1_000_000].map(|done| counted(done, 1.0).bar(12, true));
        assert_eq!(
            bars,
            [
                "[..........]",
                "[..........]",
                "[#########.]",
                "[##########]"
            ]
        );
        let drawn = counted(250_000, 1.0).bar(8, false);
        assert_eq!(
            drawn,
            "\u{2501}\u{2501}\u{2500}\u{2500}\u{2500}\u{2500}\u{2500}\u{2500}"
        );
        assert!(counted(5, 1.0).line(80, true).is_ascii());
    }

    #[test]
    fn the_time_left_takes_the_unit_that_it_needs() {
        let left = |done, seconds| counted(done, seconds).left();
        assert_eq!(left(500_000, 0.6), "1 s left");
        assert_eq!(left(1_000_000, 9.0), "0 s left");
        assert_eq!(left(10_000, 0.75), "1 min 15 s left");
        assert_eq!(left(1_000, 10.0), "2 h 46 min left");
        // Before the first row there is nothing to go by.
        assert!(left(0, 0.5).ends_with("left"));
    }

    #[test]
    fn counts_are_read_in_groups() {
        assert_eq!(
            [0, 999, 1_000, 12_345_678].map(in_groups),
            ["0", "999", "1,000", "12,345,678"]
        );
    }
}
