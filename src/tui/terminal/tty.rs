//! Takes over the terminal, waits for its events, and restores its original state.

use super::file_watch::Watch;
use super::image_escapes::StillSequence;
use super::input_thread::{
    InputDescriptors, InputQueue, IntakeEvent, RESTORE_TIMEOUT, SharedIntake, TerminalRestore,
    is_gone,
};
use super::keyboard::{TerminalColour, TerminalInput};
use super::line::ConnectionKind;
use super::queue;
use super::rate_limit::{QUESTION, RateLimit};
use super::signals::{self, SignalEvent, Signals};
use crate::capability::{Capability, Colours};
use crate::tui::Error;
use crate::tui::commands::key::Key;
use crate::tui::commands::mouse::Mouse;
use crossterm::cursor::{Hide, MoveTo, Show};
use crossterm::style::ResetColor;
use crossterm::terminal::{
    Clear, ClearType, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen,
};
use ratatui::layout::Size;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, open};
use rustix::io::{Errno, write};
use rustix::termios::{OptionalActions, Termios, isatty, tcgetattr, tcgetwinsize, tcsetattr};
use std::io;
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Switches bracketed paste, which marks pasted text.
const PASTE_ON: &[u8] = b"\x1b[?2004h";
const PASTE_OFF: &[u8] = b"\x1b[?2004l";
/// Switches mouse reports of buttons and of motion while a button is pressed (1002), with
/// coordinates of any size (1006).
const MOUSE_ON: &[u8] = b"\x1b[?1002h\x1b[?1006h";
const MOUSE_OFF: &[u8] = b"\x1b[?1006l\x1b[?1002l";
/// Asks for the colours of plain text (OSC 10) and of the background (OSC 11). Many terminals do not
/// answer.
const COLOUR_QUESTION: &[u8] = b"\x1b]10;?\x1b\\\x1b]11;?\x1b\\";
/// Ends a frame that was cut short: CAN aborts an incomplete sequence, and the frame is shown as it
/// is.
const CUT: &[u8] = b"\x18";

/// Assumed size of a terminal that reports none, usually a serial console.
const DEFAULT_SIZE: Size = Size::new(80, 24);
/// Maximum size of a screen, which limits the memory if a terminal reports nonsense.
const MAX_SCREEN_SIZE: Size = Size::new(1000, 400);

/// The event that ended a wait.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Wake {
    /// A pressed key.
    Key(Key),
    /// Pasted text.
    Paste(String),
    /// A mouse event.
    Mouse(Mouse),
    /// A colour of the terminal.
    Colour(TerminalColour),
    /// A signal.
    SignalEvent(SignalEvent),
    /// The line has transmitted the last frame.
    Room,
    /// The watched file has changed.
    Written,
    /// A background job has finished.
    Done,
    /// The terminal is gone; further writes are forbidden.
    HungUp,
}

/// The terminal while krank controls it. Dropping it restores the terminal.
#[derive(Debug)]
pub(crate) struct Tty {
    ends: InputDescriptors,
    intake: Arc<SharedIntake>,
    screen: OwnedFd,
    /// The terminal's original modes.
    found: Termios,
    modern: bool,
    /// `true` if mouse reports are on.
    mouse: bool,
    /// The bytes that remove an image that may be shown.
    removal: &'static [u8],
    entered: bool,
    hung_up: bool,
    /// `true` if the last frame was not completely written.
    cut: bool,
    watch: Watch,
    rate_limit: RateLimit,
    /// `true` until the terminal was asked for its colours.
    asks_colours: bool,
    /// Events not yet fetched.
    wakes: Vec<Wake>,
}

impl Tty {
    /// Takes over the terminal.
    ///
    /// Keys are read from standard input, or from /dev/tty if that is no terminal, because the
    /// scene may come through standard input.
    ///
    /// # Errors
    /// Returns an error if no terminal is available for drawing or for keys, or if a system call
    /// fails.
    pub(crate) fn open(capability: Capability) -> Result<Self, Error> {
        let screen = terminal_of(io::stdout().as_fd()).ok_or(Error::NoScreen)?;
        let keys = terminal_of(io::stdin().as_fd()).or_else(controlling_terminal);
        let keys = keys.ok_or(Error::NoKeyboard)?;
        let signals = Signals::new()?;
        let mut tty = Tty {
            found: tcgetattr(&keys).map_err(io::Error::from)?,
            ends: InputDescriptors::of(keys.as_fd(), &signals)?,
            intake: SharedIntake::watched(InputQueue::new(keys, signals)),
            screen,
            modern: capability.modern,
            mouse: false,
            removal: &[],
            entered: false,
            hung_up: false,
            cut: false,
            watch: Watch::new(),
            rate_limit: RateLimit::new(None),
            asks_colours: capability.modern && capability.colours != Colours::None,
            wakes: Vec::new(),
        };
        tty.enter()?;
        Ok(tty)
    }

    /// Enters raw mode and the alternate screen. The screen's contents are unknown afterwards.
    pub(crate) fn enter(&mut self) -> io::Result<()> {
        self.entered = true;
        self.rate_limit =
            RateLimit::new(ConnectionKind::of(&self.screen).and_then(ConnectionKind::rate));
        let mut raw = self.found.clone();
        raw.make_raw();
        self.prepare_parting();
        tcsetattr(&self.ends.keys, OptionalActions::Now, &raw)?;
        // The painter clears the screen.
        let mut bytes = Vec::new();
        queue(&mut bytes, EnterAlternateScreen);
        queue(&mut bytes, Hide);
        if self.modern {
            bytes.extend_from_slice(PASTE_ON);
        }
        if self.mouse {
            bytes.extend_from_slice(MOUSE_ON);
        }
        self.write_all(&bytes)
    }

    /// Restores the terminal's original state as far as possible. Errors are ignored, because they
    /// could not be shown.
    pub(crate) fn restore(&mut self) {
        if !std::mem::take(&mut self.entered) || self.hung_up {
            return;
        }
        self.await_answer();
        let bytes = self.parting();
        let _ = self.write_until(&bytes, Some(Instant::now() + RESTORE_TIMEOUT));
        let _ = tcsetattr(&self.ends.keys, OptionalActions::Now, &self.found);
        self.prepare_parting();
    }

    /// Returns the bytes that restore the screen.
    fn parting(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        if self.cut {
            bytes.extend_from_slice(CUT);
        }
        if self.cut && self.modern {
            queue(&mut bytes, EndSynchronizedUpdate);
        }
        if self.mouse {
            bytes.extend_from_slice(MOUSE_OFF);
        }
        if self.modern {
            bytes.extend_from_slice(PASTE_OFF);
        }
        bytes.extend_from_slice(self.removal);
        // The screen is cleared for terminals without an alternate one.
        queue(&mut bytes, ResetColor);
        queue(&mut bytes, Clear(ClearType::All));
        queue(&mut bytes, MoveTo(0, 0));
        queue(&mut bytes, Show);
        queue(&mut bytes, LeaveAlternateScreen);
        bytes
    }

    /// Enables the second thread to restore the terminal while the main thread computes.
    fn prepare_parting(&self) {
        let screen = self.screen.try_clone().ok().filter(|_| self.entered);
        self.intake.lock().restore = screen.map(|screen| TerminalRestore {
            screen,
            modes: self.found.clone(),
            bytes: self.parting(),
        });
    }

    /// Suspends the program until it is continued. Does nothing if no shell could continue it. The
    /// screen's contents are unknown afterwards.
    pub(crate) fn suspend(&mut self) -> io::Result<()> {
        if !signals::can_suspend() {
            return Ok(());
        }
        self.restore();
        signals::stop()?;
        let woken_by = |n: &SignalEvent| matches!(n, SignalEvent::Continued | SignalEvent::Suspend);
        let mut intake = self.intake.lock();
        intake.collect()?;
        let others = intake
            .take()
            .into_iter()
            .filter_map(|arrival| match arrival {
                IntakeEvent::SignalEvent(notice) if !woken_by(&notice) => {
                    Some(Wake::SignalEvent(notice))
                }
                IntakeEvent::SignalEvent(_) | IntakeEvent::Input(..) => None,
            });
        self.wakes.extend(others);
        drop(intake);
        self.enter()
    }

    /// Returns the size of the screen in cells, which is never empty.
    #[must_use]
    pub(crate) fn size(&self) -> Size {
        let text = tcgetwinsize(&self.screen).map_or((0, 0), |w| (w.ws_col, w.ws_row));
        match text {
            (0, _) | (_, 0) => DEFAULT_SIZE,
            (cols, rows) => Size::new(
                cols.min(MAX_SCREEN_SIZE.width),
                rows.min(MAX_SCREEN_SIZE.height),
            ),
        }
    }

    /// Returns the height of a cell divided by its width, if the terminal reports a plausible size
    /// in pixels.
    #[must_use]
    pub(crate) fn aspect(&self) -> Option<f64> {
        let w = tcgetwinsize(&self.screen).ok()?;
        let cell = |pixels: u16, cells: u16| f64::from(pixels) / f64::from(cells);
        let aspect = cell(w.ws_ypixel, w.ws_row) / cell(w.ws_xpixel, w.ws_col);
        // Some terminals report impossible pixels; a cell is between square and very slim.
        (1.0..=4.0).contains(&aspect).then_some(aspect)
    }

    /// Returns the width and height of a cell in pixels, if the terminal reports them.
    #[must_use]
    pub(crate) fn cell(&self) -> Option<(u16, u16)> {
        let w = tcgetwinsize(&self.screen).ok()?;
        let cell = |pixels: u16, cells: u16| pixels.checked_div(cells).filter(|&n| n > 0);
        // If the shape of a cell is implausible, so is its size.
        self.aspect()?;
        cell(w.ws_xpixel, w.ws_col).zip(cell(w.ws_ypixel, w.ws_row))
    }

    /// Watches this file and no other. Returns `true` if a new watch was started.
    pub(crate) fn follow(&mut self, file: Option<&Path>) -> bool {
        self.watch.follow(file)
    }

    /// Returns the time since which the last frame is visible; `None` if it is still in flight.
    pub(crate) fn drawn_at(&self) -> Option<Instant> {
        self.rate_limit.drawn_at(Instant::now())
    }

    /// Returns the earliest time of the next frame if [`Wake::Room`] does not arrive before; `None`
    /// if it may be sent at once.
    pub(crate) fn ready_at(&self) -> Option<Instant> {
        self.rate_limit.ready_at()
    }

    /// Returns the maximum length of the next frame in bytes.
    pub(crate) fn max_frame_len(&self) -> usize {
        self.rate_limit.max_frame_len()
    }

    /// Writes a frame; an empty one is ignored. On a stalled line, an event that ends the program
    /// also ends the write. The next [`Tty::wait`] reports it.
    pub(crate) fn send(&mut self, frame: &[u8]) -> io::Result<()> {
        if frame.is_empty() {
            return Ok(());
        }
        // Behind the first frame, and before a query that the terminal is known to answer: so the
        // answer about the colours never arrives after krank has left.
        let question = match self.asks_colours && self.rate_limit.is_answered() {
            true => COLOUR_QUESTION,
            false => &[],
        };
        let bytes = frame.len() + question.len();
        if !self.rate_limit.send(bytes, Instant::now()) {
            return self.write_all(frame);
        }
        self.asks_colours &= question.is_empty();
        self.write_all(&[frame, question, QUESTION].concat())
    }

    /// Switches mouse reports on or off. They are switched off whenever the terminal is restored.
    pub(crate) fn handle_mouse(&mut self, wanted: bool) -> io::Result<()> {
        if self.mouse == wanted {
            return Ok(());
        }
        self.mouse = wanted;
        self.prepare_parting();
        self.write_outside_frames(if wanted { MOUSE_ON } else { MOUSE_OFF })
    }

    /// Writes bytes that belong to no frame and are never dropped: completely, once, and after
    /// everything sent before. They must not change the screen.
    pub(crate) fn write_outside_frames(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.rate_limit.record_sent(bytes.len());
        self.write_all(bytes)
    }

    /// Writes an image. The bytes that remove it are sent whenever the terminal is restored.
    pub(crate) fn write_image(&mut self, still: &StillSequence) -> io::Result<()> {
        self.removal = still.removal;
        self.prepare_parting();
        self.write_outside_frames(&still.bytes)
    }

    /// Returns the rate of the line in bytes per second, if known.
    pub(crate) fn rate(&self) -> Option<f64> {
        self.rate_limit.rate()
    }

    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        let was_cut = self.cut;
        self.cut = true;
        self.cut = !self.write_until(bytes, None)?;
        if self.cut != was_cut {
            self.prepare_parting();
        }
        Ok(())
    }

    /// Waits for a pending answer, which the shell would take for typed text. Keys typed meanwhile
    /// were meant for krank and are dropped with it.
    fn await_answer(&mut self) {
        let Some(until) = self.rate_limit.farewell(Instant::now()) else {
            return;
        };
        while !self.hung_up && Instant::now() < until {
            if self.poll(Some(until), PollFlags::empty(), None).is_err() {
                return;
            }
            // Other signals and the scene's file no longer matter at exit.
            let mut intake = self.intake.lock();
            let read = intake.collect();
            let is_answer =
                |arrival| matches!(arrival, IntakeEvent::Input(TerminalInput::Answer, _));
            if read.is_err() || intake.take().into_iter().any(is_answer) {
                return;
            }
            self.hung_up |= intake.hung_up;
            drop(intake);
            self.watch.has_changes();
        }
    }

    /// Writes bytes until the deadline. Returns `true` if all were written.
    fn write_until(&mut self, mut bytes: &[u8], deadline: Option<Instant>) -> io::Result<bool> {
        // Waits while the second thread restores the terminal.
        drop(self.intake.lock());
        while !bytes.is_empty() && !self.hung_up {
            match write(&self.screen, bytes) {
                Ok(n) => bytes = &bytes[n..],
                Err(Errno::INTR) => {}
                Err(Errno::AGAIN) => {
                    if !self.wait_until_writable(deadline)? {
                        return Ok(false);
                    }
                }
                Err(Errno::IO | Errno::PIPE | Errno::NXIO) => self.hung_up = true,
                Err(error) => return Err(error.into()),
            }
        }
        Ok(bytes.is_empty())
    }

    /// Waits until the line takes more bytes. Returns `false` if the rest should be dropped.
    fn wait_until_writable(&mut self, deadline: Option<Instant>) -> io::Result<bool> {
        let text = self.poll(deadline, PollFlags::OUT, None)?;
        if deadline.is_some_and(|deadline| deadline <= Instant::now()) {
            return Ok(false);
        }
        self.collect(text)?;
        let leaving = deadline.is_some();
        Ok(leaving || !self.wakes.iter().any(ends))
    }

    /// Waits for an event until `deadline`, or without limit. Takes all pending events at once, so
    /// that many keys cost one frame. Pending keys are read even after the deadline.
    pub(crate) fn wait(
        &mut self,
        deadline: Option<Instant>,
        bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Vec<Wake>> {
        loop {
            let at_once = (!self.wakes.is_empty()).then(Instant::now);
            let unfinished = self.intake.lock().keyboard.deadline();
            let until = [deadline, unfinished, at_once];
            let until = until.into_iter().flatten().min();
            let text = self.poll(until, PollFlags::empty(), bell)?;
            self.collect(text)?;
            if !text.bell.is_empty() {
                self.wakes.push(Wake::Done);
            }
            if self.hung_up {
                self.wakes.push(Wake::HungUp);
            }
            if !self.wakes.is_empty() || deadline.is_some_and(|d| d <= Instant::now()) {
                return Ok(std::mem::take(&mut self.wakes));
            }
        }
    }

    /// Reads pending signals and keys.
    fn collect(&mut self, shown_text: Readiness) -> io::Result<()> {
        self.hung_up |= is_gone(shown_text.screen);
        if self.watch.has_changes() {
            self.wakes.push(Wake::Written);
        }
        let mut intake = self.intake.lock();
        intake.collect()?;
        self.hung_up |= intake.hung_up;
        let arrivals = intake.take();
        drop(intake);
        for arrival in arrivals {
            self.wakes.push(match arrival {
                IntakeEvent::SignalEvent(notice) => Wake::SignalEvent(notice),
                IntakeEvent::Input(TerminalInput::Key(key), _) => Wake::Key(key),
                IntakeEvent::Input(TerminalInput::Paste(text), _) => Wake::Paste(text),
                IntakeEvent::Input(TerminalInput::Mouse(mouse), _) => Wake::Mouse(mouse),
                IntakeEvent::Input(TerminalInput::Colour(colour), _) => Wake::Colour(colour),
                IntakeEvent::Input(TerminalInput::Answer, at) => {
                    self.rate_limit.answered(at);
                    Wake::Room
                }
            });
        }
        Ok(())
    }

    /// Waits for keys, signals, the bell, and the given events of the screen.
    fn poll(
        &self,
        until: Option<Instant>,
        screen: PollFlags,
        bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Readiness> {
        let has_come = self.intake.rest();
        let until = if has_come {
            Some(Instant::now())
        } else {
            until
        };
        let text = self.poll_ends(until, screen, bell);
        self.intake.work();
        text
    }

    fn poll_ends(
        &self,
        until: Option<Instant>,
        screen: PollFlags,
        bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Readiness> {
        let timeout = until.map(|d| timespec(d.saturating_duration_since(Instant::now())));
        let keys = PollFd::new(&self.ends.keys, PollFlags::IN);
        let signals = PollFd::new(&self.ends.signals, PollFlags::IN);
        let screen = PollFd::new(&self.screen, screen);
        // An unused slot is filled with a descriptor that is polled anyway.
        let or_signals = |fd: Option<_>| match fd {
            Some(fd) => PollFd::from_borrowed_fd(fd, PollFlags::IN),
            None => signals.clone(),
        };
        let (watched, rings) = (or_signals(self.watch.descriptor()), or_signals(bell));
        let mut fds = [keys, signals, screen, watched, rings];
        match poll(&mut fds, timeout.as_ref()) {
            Ok(_) => Ok(Readiness {
                screen: fds[2].revents(),
                bell: match bell {
                    Some(_) => fds[4].revents(),
                    None => PollFlags::empty(),
                },
            }),
            Err(Errno::INTR) => Ok(Readiness::default()),
            Err(error) => Err(error.into()),
        }
    }
}

impl Drop for Tty {
    fn drop(&mut self) {
        self.restore();
        self.intake.stop();
    }
}

/// The results of `poll` for the screen and the bell.
#[derive(Clone, Copy, Debug)]
struct Readiness {
    screen: PollFlags,
    bell: PollFlags,
}

impl Default for Readiness {
    fn default() -> Self {
        Readiness {
            screen: PollFlags::empty(),
            bell: PollFlags::empty(),
        }
    }
}

/// Returns `true` for events that end the program even on a stalled line.
fn ends(wake: &Wake) -> bool {
    matches!(
        wake,
        Wake::HungUp | Wake::SignalEvent(SignalEvent::End(_)) | Wake::Key(Key::Ctrl('c'))
    )
}

/// Returns a private non-blocking descriptor for the terminal behind `fd`; `None` if `fd` is no
/// terminal.
///
/// The terminal is opened again, because O_NONBLOCK on the given descriptor would affect every
/// program that shares it. If this is not permitted (after `su`), the given descriptor is used, and
/// a stalled line can block.
fn terminal_of(fd: BorrowedFd<'_>) -> Option<OwnedFd> {
    if !isatty(fd) {
        return None;
    }
    let path = format!("/proc/self/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&fd));
    let anew = open(path, terminal_flags(), Mode::empty()).ok();
    anew.filter(|fd| isatty(fd))
        .or_else(|| fd.try_clone_to_owned().ok())
}

fn controlling_terminal() -> Option<OwnedFd> {
    open("/dev/tty", terminal_flags(), Mode::empty()).ok()
}

fn terminal_flags() -> OFlags {
    OFlags::RDWR | OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::CLOEXEC
}

fn timespec(duration: Duration) -> Timespec {
    // No wait exceeds `i64::MAX` seconds.
    Timespec::try_from(duration).unwrap_or(Timespec {
        tv_sec: i64::MAX,
        tv_nsec: 0,
    })
}
