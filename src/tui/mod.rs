//! The workbench: a scene on the screen, moved by keys.
//!
//! Keys become actions, actions change the state, and views show it without changing it. Time and
//! the terminal are passed in, so that a test can drive everything as a [`Workbench`]. The timer
//! follows the wall clock. While paused, the program neither wakes up nor writes.
//!
//! # Where to find what
//!
//! | module | contents |
//! |---|---|
//! | `app` | the state of the workbench, and how each action changes it |
//! | `commands`, `config` | key bindings, the table of all commands, and the user's configuration |
//! | `document` | the scene as text: edits, its file, recovery and file operations |
//! | `player` | the open scene solved at its driver coordinate, its motion, and the compared scene |
//! | `figures` | tables: columns, digits, the cursor, searching, copying |
//! | `views` | drawing: a folder or file for each view and each list, with its state |
//! | `appearance` | the look of the screen's parts, and the terminal's colours |
//! | `workbench`, `picture`, `terminal` | the workbench without a terminal, its screen as text, and the real terminal |

mod app;
mod appearance;
mod commands;
mod config;
mod document;
mod figures;
mod picture;
mod player;
mod terminal;
#[cfg(test)]
mod tests;
mod views;
mod workbench;

pub use crate::capability::{Colours, PictureChoice, PictureProtocol};
pub use crate::wording::Language;
use appearance::palette::Ground;
pub use appearance::palette::Theme;
pub use commands::view::View;
pub use config::{Config, template};
pub use picture::picture;
pub use terminal::Terminal;
pub use views::help::keys::key_list;
pub(crate) use views::help::keys::{key_rows, key_rows_about};
pub use workbench::Workbench;

use crate::capability::TerminalProfile;
use crate::drawing::Glyphs;
use crate::files::directories;
use crate::scene::Scene;
use crate::solver::Solver;
use crate::synthesis::SynthesisSettings;
use crate::task_file::TaskFile;
use crate::wording::words;
use app::Effect;
use commands::mouse::{Mouse, MouseEventKind};
use std::backtrace::{Backtrace, BacktraceStatus};
use std::io;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use terminal::{Console, SignalEvent, Tty, Wake};
use thiserror::Error;

/// The origin of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A built-in preset with this name.
    Preset(String),
    /// A file.
    File(PathBuf),
    /// A new scene with this name, not yet saved to any file.
    New(String),
    /// Standard input; keys are then read from /dev/tty.
    Stdin,
}

/// A scene with its solver, ready to be shown.
#[derive(Debug)]
pub struct OpenedScene {
    /// The scene.
    pub scene: Scene,
    /// The scene's solver, with no quantity left out.
    pub solver: Solver,
    /// The scene's origin.
    pub origin: Origin,
}

/// A synthesis task to be solved.
#[derive(Clone, Debug, PartialEq)]
pub struct TaskOrder {
    /// The task file.
    pub file: TaskFile,
    /// The task's name, in lists and in the names of its scenes.
    pub name: String,
    /// The seed of the random numbers, for a search that starts at many points.
    pub seed: u64,
    /// The permitted deviation of each length of a scene; `None` if the user gave none.
    pub tolerance: Option<f64>,
    /// The task's folder, offered as the folder of saved solutions.
    pub folder: Option<PathBuf>,
}

impl TaskOrder {
    /// Creates an order with the default seed, without tolerance and folder.
    #[must_use]
    pub fn new(file: TaskFile, name: String) -> TaskOrder {
        TaskOrder {
            file,
            name,
            seed: SynthesisSettings::DEFAULT_SEED,
            tolerance: None,
            folder: None,
        }
    }
}

/// Options for opening the workbench. A `None` is replaced by a value from the scene or the
/// environment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The driver coordinate, in degrees or in the scene's length unit.
    pub at: Option<f64>,
    /// The characters to draw with; overrides the configuration.
    pub glyphs: Option<Glyphs>,
    /// The colours to draw with; overrides the configuration.
    pub colours: Option<Colours>,
    /// The initial view.
    pub view: Option<View>,
    /// The theme, which maps the palette's names to colours.
    pub theme: Theme,
    /// The protocol for pixel images.
    pub picture: PictureChoice,
    /// All other configuration.
    pub config: Config,
    /// A synthesis task to start at once.
    pub task: Option<TaskOrder>,
    /// `true` if the command line names nothing to show. The first start then begins with the tour.
    pub idle: bool,
}

/// Number and size of the frames with at least one changed cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Frames {
    /// The number of frames.
    pub count: u64,
    /// The total size of the frames, in bytes.
    pub bytes: u64,
}

/// The reason why the workbench could not open or had to close.
#[derive(Debug, Error)]
pub enum Error {
    /// Standard output is no terminal.
    #[error("{}", words().output_is_no_terminal())]
    NoScreen,
    /// Neither standard input nor /dev/tty is a terminal.
    #[error("{}", words().no_keys_to_read())]
    NoKeyboard,
    /// The terminal cannot place its cursor.
    #[error("{}", words().terminal_is_dumb())]
    Dumb,
    /// An I/O error of the terminal.
    #[error("{}", words().terminal_failed(.0))]
    Terminal(#[from] io::Error),
    /// A panic: its message and source location.
    #[error("{}", words().krank_is_broken(.0))]
    Broken(String),
}

impl Error {
    /// Returns `true` if the command line asks for a workbench where none is possible: a usage
    /// error.
    #[must_use]
    pub fn is_usage(&self) -> bool {
        match self {
            Error::NoScreen | Error::NoKeyboard | Error::Dumb => true,
            Error::Terminal(_) | Error::Broken(_) => false,
        }
    }
}

/// Opens the workbench on the terminal and returns when the user quits.
///
/// The terminal's state is always restored. If a signal ends the program, or the terminal
/// disappears, the process ends by that signal after the terminal is restored.
///
/// # Errors
/// Returns an error if no suitable terminal exists, if an I/O operation on it fails, or if the
/// workbench panics.
pub fn run(opened: OpenedScene, options: &Options) -> Result<(), Error> {
    let judgement = TerminalProfile::of(|name| std::env::var(name).ok());
    let plain = (options.theme == Theme::Plain).then_some(Colours::None);
    let capability = judgement.capability(options.glyphs, options.colours.or(plain));
    let capability = capability.ok_or(Error::Dumb)?;
    let end = catch_panic(|| {
        let tty = Tty::open(capability)?;
        let (size, aspect) = (tty.size(), tty.aspect());
        let workbench = Workbench::on(opened, options.at, capability, size).themed(options.theme);
        let mut workbench = workbench
            .configured(&options.config)
            .with_view(options.view.unwrap_or_default());
        workbench.app().resize(size, aspect);
        workbench.app().use_background_threads();
        let pictures = judgement.pictures(options.picture);
        workbench.app().send_pictures(pictures);
        if let Some(ground) = judgement.has_light_ground() {
            workbench.app().set_ground(match ground {
                true => Ground::Light,
                false => Ground::Dark,
            });
        }
        if options.idle && options.config.tour && views::fits_views(size) {
            workbench.app().tour_on_first_start();
        }
        let state =
            directories::folder_of("XDG_STATE_HOME", ".local/state", directories::environment);
        match state {
            Some(state) => workbench.app().recover_in(&state.join("recovery")),
            None => workbench.app().recover_nowhere(),
        }
        if let Some(warnings) = &options.config.warnings {
            workbench.app().warn_of_config(warnings);
        }
        if let Some(task) = &options.task {
            workbench.app().synthesize(task.clone());
        }
        Session::new(tty, workbench).run()
    })?;
    if let Some(signal) = end {
        terminal::die_of(signal)?;
    }
    Ok(())
}

/// Runs a function that holds the terminal. Catches a panic and reports it only after the terminal
/// is restored.
fn catch_panic<T>(run: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    let shown_text = Arc::new(Mutex::new(String::new()));
    let thread_text = Arc::clone(&shown_text);
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        let mut text = thread_text.lock().unwrap_or_else(PoisonError::into_inner);
        *text = panic_text(info);
    }));
    let outcome = panic::catch_unwind(AssertUnwindSafe(run));
    panic::set_hook(before);
    outcome.unwrap_or_else(|_| {
        let text = shown_text.lock().unwrap_or_else(PoisonError::into_inner);
        Err(Error::Broken(text.clone()))
    })
}

/// Formats a panic's message and location; with `RUST_BACKTRACE` also its backtrace.
fn panic_text(info: &PanicHookInfo<'_>) -> String {
    let payload = info.payload();
    let what = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let place = info.location().map(ToString::to_string);
    let (what, place) = (what.unwrap_or("a panic"), place.unwrap_or_default());
    let backtrace = Backtrace::capture();
    match backtrace.status() {
        BacktraceStatus::Captured => format!("{what} ({place})\n{backtrace}"),
        _ => format!("{what} ({place})"),
    }
}

/// A workbench on a terminal.
struct Session<T> {
    tty: T,
    workbench: Workbench,
    /// The time at which the session began.
    started: Instant,
    /// `true` if something has happened that no frame shows yet.
    frame_is_due: bool,
    /// `true` if that justifies a new frame before the last one is completely sent.
    anew: bool,
    /// `true` if more than the clock has caused the next frame.
    is_requested: bool,
}

/// The frame limit in bytes below which playback sends only the drawing: that of 19,200 baud.
const MOTION_ONLY_LIMIT: usize = 500;

/// The signal by which the process is to end; `None` for a normal exit.
type EndSignal = Option<i32>;

impl<T: Console> Session<T> {
    fn new(tty: T, workbench: Workbench) -> Self {
        Session {
            started: tty.now(),
            tty,
            workbench,
            frame_is_due: true,
            anew: true,
            is_requested: true,
        }
    }

    fn run(mut self) -> Result<EndSignal, Error> {
        loop {
            if let Some(end) = self.step()? {
                return Ok(end);
            }
        }
    }

    /// Paints a pending frame, waits once, and handles the events. Returns `Some` if the session
    /// ends.
    fn step(&mut self) -> Result<Option<EndSignal>, Error> {
        if self.frame_is_due && self.is_ready() {
            self.paint()?;
            self.frame_is_due = self.workbench.is_cut();
            self.anew = !self.frame_is_due;
            #[cfg(debug_assertions)]
            fault_on_demand();
        }
        let wanted = self.workbench.app().has_mouse();
        self.tty.handle_mouse(wanted)?;
        let deadline = self.deadline();
        if self.tty.follow(self.workbench.app().watched()) {
            // The file may have been written between the first check and now.
            let now = self.elapsed();
            self.workbench.app().check_file(now, true);
        }
        let bell = self.workbench.app().bell();
        let events = self.tty.wait(deadline, bell)?;
        if let Some(drawn) = self.tty.drawn_at().filter(|_| !self.frame_is_due) {
            let seen = drawn.saturating_duration_since(self.started);
            self.workbench.app().note_frame_shown(seen);
        }
        if !self.frame_is_due && is_only_line_ready(&events) {
            return Ok(None);
        }
        self.frame_is_due = true;
        // An animation waits for a slow line: halves of two different frames would show neither.
        let is_requested = events.iter().any(|wake| *wake != Wake::Room);
        self.anew |= is_requested;
        self.is_requested |= is_requested;
        // All pending events are handled before one frame shows the result.
        self.take_all(events)
    }

    /// Returns the time since the session began.
    fn elapsed(&self) -> Duration {
        self.tty.now().saturating_duration_since(self.started)
    }

    /// Returns `true` if the line takes another frame.
    fn is_ready(&self) -> bool {
        let ready = self.tty.ready_at();
        ready.is_none_or(|ready| ready <= self.tty.now())
    }

    /// Sends the current screen, or the unsent rest of the last one.
    fn paint(&mut self) -> Result<(), Error> {
        let space = self.tty.max_frame_len();
        let frame = if self.anew {
            self.workbench.app().measure_cost();
            let is_requested = std::mem::take(&mut self.is_requested);
            if is_requested || space >= MOTION_ONLY_LIMIT {
                self.workbench.paint_within(space)
            } else {
                self.workbench.paint_motion(space)
            }
        } else {
            self.workbench.paint_rest(space)
        };
        self.tty.send(frame)?;
        // Nothing is sent, so no answer will tell when it is visible.
        let is_shown = frame.is_empty() && self.tty.drawn_at().is_some();
        if is_shown {
            let now = self.elapsed();
            self.workbench.app().note_frame_shown(now);
        }
        while let Some(still) = self.workbench.take_still() {
            self.tty.write_image(&still)?;
        }
        Ok(())
    }

    /// Returns the time until which to wait for an event; `None` waits without a limit.
    fn deadline(&mut self) -> Option<Instant> {
        let ready = self.tty.ready_at();
        // A background computation continues, whether or not a slow line takes the next frame.
        if self.workbench.app().is_working() {
            return Some(self.tty.now());
        }
        if self.frame_is_due {
            return ready;
        }
        let app = self.workbench.app();
        let Some(next) = app.next_frame() else {
            // A terminal that answers nothing does not tell when a message is visible.
            return ready.filter(|_| app.message_awaits_frame());
        };
        let next = self.started + next;
        Some(ready.map_or(next, |ready| ready.max(next)))
    }

    fn take_all(&mut self, events: Vec<Wake>) -> Result<Option<EndSignal>, Error> {
        // Playback does not advance while the process is suspended.
        let mut stopped = events.contains(&Wake::SignalEvent(SignalEvent::Continued));
        if !stopped {
            let now = self.elapsed();
            self.workbench.move_to(now);
        }
        let mut events = events.into_iter().peekable();
        while let Some(wake) = events.next() {
            if is_overtaken(&wake, events.peek()) {
                continue;
            }
            stopped |= wake == Wake::SignalEvent(SignalEvent::Suspend);
            if let Some(end) = self.take(wake)? {
                return Ok(Some(end));
            }
        }
        if stopped {
            let now = self.elapsed();
            self.workbench.skip_to(now);
        }
        Ok(None)
    }

    /// Handles an event. Returns `Some` if the session ends.
    fn take(&mut self, wake: Wake) -> Result<Option<EndSignal>, Error> {
        match wake {
            Wake::HungUp => return Ok(Some(Some(terminal::HANG_UP_SIGNAL))),
            Wake::SignalEvent(SignalEvent::End(signal)) => return Ok(Some(Some(signal))),
            Wake::SignalEvent(SignalEvent::Suspend) => {
                self.tty.suspend()?;
                self.start_over();
            }
            Wake::SignalEvent(SignalEvent::Continued) => {
                self.tty.enter()?;
                self.start_over();
            }
            Wake::SignalEvent(SignalEvent::Resized) => self.start_over(),
            Wake::Room => {}
            Wake::Written => {
                let now = self.elapsed();
                self.workbench.app().check_file(now, true);
                return Ok(self.attend(now));
            }
            Wake::Done => {
                self.workbench.app().clear_signal();
                let now = self.elapsed();
                return Ok(self.attend(now));
            }
            Wake::Colour(colour) => self.workbench.app().set_colour(colour),
            Wake::Paste(text) => self.workbench.paste(&text),
            Wake::Mouse(mouse) => {
                let effect = self.workbench.point(mouse);
                return self.follow(effect);
            }
            Wake::Key(key) => {
                let effect = self.workbench.key(key);
                return self.follow(effect);
            }
        }
        Ok(None)
    }

    /// Applies an effect to the terminal. Returns `Some` if the session ends.
    fn follow(&mut self, effect: Effect) -> Result<Option<EndSignal>, Error> {
        match effect {
            Effect::Show | Effect::Picture => {}
            Effect::Still => {
                let (cell, rate) = (self.tty.cell(), self.tty.rate());
                self.workbench.show_still(cell, rate);
            }
            Effect::Send(bytes) => self.tty.write_outside_frames(&bytes)?,
            Effect::Redraw => self.start_over(),
            Effect::Suspend => terminal::suspend_process_group()?,
            Effect::Quit => return Ok(Some(None)),
        }
        Ok(None)
    }

    /// Handles finished file operations. Returns `Some` if the program was waiting for them to
    /// quit.
    fn attend(&mut self, now: Duration) -> Option<EndSignal> {
        (self.workbench.app().attend(now) == Effect::Quit).then_some(None)
    }

    /// Adopts the terminal's current size and repaints everything. The screen's contents are
    /// unknown, even if the terminal shrank and grew back to the same size.
    fn start_over(&mut self) {
        let (size, aspect) = (self.tty.size(), self.tty.aspect());
        self.workbench.app().resize(size, aspect);
        self.workbench.forget();
    }
}

/// Returns `true` if the only event is that the line took the last frame, which needs no new frame.
/// An empty list means that the deadline has come, so it returns `false`.
fn is_only_line_ready(events: &[Wake]) -> bool {
    !events.is_empty() && events.iter().all(|wake| *wake == Wake::Room)
}

/// Returns `true` if `wake` is a mouse drag directly followed by another. Only the last position
/// before a frame counts.
fn is_overtaken(wake: &Wake, next: Option<&Wake>) -> bool {
    let is_drag = |wake: &Wake| {
        matches!(
            wake,
            Wake::Mouse(Mouse {
                kind: MouseEventKind::Drag,
                ..
            })
        )
    };
    is_drag(wake) && next.is_some_and(is_drag)
}

/// Injects a fault: `KRANK_FAULT=panic` panics after the first frame, for the test that restores
/// the terminal; `KRANK_FAULT=busy` loops forever. Release builds ignore both.
#[cfg(debug_assertions)]
fn fault_on_demand() {
    let fault = std::env::var_os("KRANK_FAULT").unwrap_or_default();
    assert!(fault != "panic", "KRANK_FAULT=panic asks for this");
    if fault == "busy" {
        loop {
            std::hint::spin_loop();
        }
    }
}
