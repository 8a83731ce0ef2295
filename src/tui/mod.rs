//! The workbench: a scene on the screen, moved by keys.
//!
//! Keys become actions, actions change the state, views show it: a view changes nothing. Time and the
//! terminal come in from outside, so that the whole can be driven, as a [`Workbench`], by a
//! test. The timer follows the wall clock; while paused nothing wakes up and nothing is written.
//!
//! # Where to find what
//!
//! | room | what it holds |
//! |---|---|
//! | `app` | the state of the workbench, and what each action does to it |
//! | `commands`, `config` | keys, the one table of what they can ask for, and what a person has configured |
//! | `document` | the scene as a text: edits, its file, recovery; what is done to files |
//! | `player` | the open scene solved where its driver stands, how that moves, and what is compared with it |
//! | `figures` | tables: columns, digits, the cursor, finding, copying |
//! | `views` | what is drawn: a folder or file for each view and each list, with what it keeps |
//! | `appearance` | what the parts of the screen look like, and the colours of a terminal |
//! | `workbench`, `picture`, `terminal` | the whole without a terminal, its screen as text, and the real terminal |

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
pub use appearance::palette::Theme;
pub use commands::view::View;
pub use config::{Config, template};
pub use picture::picture;
pub use terminal::Terminal;
pub use views::help::keys::key_list;
pub(crate) use views::help::keys::{key_rows, key_rows_about};
pub use workbench::Workbench;

use crate::capability::Judgement;
use crate::drawing::Glyphs;
use crate::files::places;
use crate::scene::Scene;
use crate::solver::Solver;
use crate::synthesis::SynthesisOrder;
use crate::task_file::TaskFile;
use crate::wording::words;
use app::Effect;
use commands::mouse::{Mouse, MouseDeed};
use std::backtrace::{Backtrace, BacktraceStatus};
use std::io;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use terminal::{Console, Notice, Tty, Wake};
use thiserror::Error;

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Built in, under this name.
    Preset(String),
    /// A file.
    File(PathBuf),
    /// Made here, under this name: no file holds it yet.
    New(String),
    /// Standard input; keys are then read from /dev/tty.
    Stdin,
}

/// A scene that is ready to be shown.
#[derive(Debug)]
pub struct Opened {
    /// The scene.
    pub scene: Scene,
    /// Its solver, with nothing left out.
    pub solver: Solver,
    /// Where it comes from.
    pub origin: Origin,
}

/// A task whose linkages are to be looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct TaskOrder {
    /// What is wanted.
    pub file: TaskFile,
    /// What it is called in a list, and scenes after it.
    pub name: String,
    /// From which chance follows, where a search begins at many places.
    pub seed: u64,
    /// How far each length of a scene may be off; nothing where that is left open.
    pub tolerance: Option<f64>,
    /// The folder that it lies in: what is saved of it is offered a name there.
    pub folder: Option<PathBuf>,
}

impl TaskOrder {
    /// A task as it is looked at where nothing else is said.
    #[must_use]
    pub fn new(file: TaskFile, name: String) -> TaskOrder {
        TaskOrder {
            file,
            name,
            seed: SynthesisOrder::USUAL_SEED,
            tolerance: None,
            folder: None,
        }
    }
}

/// How to open the workbench; what is `None` follows from the scene and the environment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: Option<f64>,
    /// The characters to draw with, whatever is configured.
    pub glyphs: Option<Glyphs>,
    /// The colours to draw with, whatever is configured.
    pub colours: Option<Colours>,
    /// The view to open with.
    pub view: Option<View>,
    /// Which colours stand for the names of the palette.
    pub theme: Theme,
    /// How still pictures are sent.
    pub picture: PictureChoice,
    /// What is configured beside these.
    pub config: Config,
    /// A task whose linkages are looked for at once.
    pub task: Option<TaskOrder>,
    /// Whether nothing was named that somebody wants to see at once: then the first start begins with the
    /// tour.
    pub idle: bool,
}

/// Frames with at least one changed cell, and what they cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Frames {
    /// How many there were.
    pub count: u64,
    /// Their bytes.
    pub bytes: u64,
}

/// Why the workbench could not be opened, or had to be left.
#[derive(Debug, Error)]
pub enum Error {
    /// Standard output goes elsewhere.
    #[error("{}", words().output_is_no_terminal())]
    NoScreen,
    /// Neither standard input nor /dev/tty is a terminal.
    #[error("{}", words().no_keys_to_read())]
    NoKeyboard,
    /// The terminal cannot place its cursor.
    #[error("{}", words().terminal_is_dumb())]
    Dumb,
    /// What the system says.
    #[error("{}", words().terminal_failed(.0))]
    Terminal(#[from] io::Error),
    /// A panic: what, and where in the source.
    #[error("{}", words().krank_is_broken(.0))]
    Broken(String),
}

impl Error {
    /// Whether the workbench was asked for where there can be none: a wrong command line.
    #[must_use]
    pub fn is_usage(&self) -> bool {
        match self {
            Error::NoScreen | Error::NoKeyboard | Error::Dumb => true,
            Error::Terminal(_) | Error::Broken(_) => false,
        }
    }
}

/// Opens the workbench on the terminal and returns when it is left.
///
/// The terminal is put back as it was found, whatever happens. A signal that ends the program, or a
/// terminal that vanishes, ends the process by that signal once the terminal is put back.
///
/// # Errors
/// Where there is no terminal that can show it, and what the system says about it. A panic inside is
/// an error too.
pub fn run(opened: Opened, options: &Options) -> Result<(), Error> {
    let judgement = Judgement::of(|name| std::env::var(name).ok());
    let plain = (options.theme == Theme::Plain).then_some(Colours::None);
    let capability = judgement.capability(options.glyphs, options.colours.or(plain));
    let capability = capability.ok_or(Error::Dumb)?;
    let end = catching(|| {
        let tty = Tty::open(capability)?;
        let (size, aspect) = (tty.size(), tty.aspect());
        let workbench = Workbench::on(opened, options.at, capability, size).themed(options.theme);
        let mut workbench = workbench
            .configured(&options.config)
            .looking_at(options.view.unwrap_or_default());
        workbench.app().resize(size, aspect);
        workbench.app().work_apart();
        let pictures = judgement.pictures(options.picture);
        workbench.app().send_pictures(pictures);
        if options.idle && options.config.tour && views::has_room(size) {
            workbench.app().tour_on_first_start();
        }
        let state = places::folder_of("XDG_STATE_HOME", ".local/state", places::environment);
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

/// Runs something that holds the terminal: a panic is caught on the way out, and told only after the
/// terminal was put back.
fn catching<T>(run: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    let told = Arc::new(Mutex::new(String::new()));
    let teller = Arc::clone(&told);
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        let mut text = teller.lock().unwrap_or_else(PoisonError::into_inner);
        *text = told_of(info);
    }));
    let outcome = panic::catch_unwind(AssertUnwindSafe(run));
    panic::set_hook(before);
    outcome.unwrap_or_else(|_| {
        let text = told.lock().unwrap_or_else(PoisonError::into_inner);
        Err(Error::Broken(text.clone()))
    })
}

/// What panicked and where; with RUST_BACKTRACE also how it came there.
fn told_of(info: &PanicHookInfo<'_>) -> String {
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
    /// From when on its time counts.
    begun: Instant,
    /// Whether something has happened that no frame has shown yet,
    owed: bool,
    /// and whether that is worth another picture before the last one was sent to its end.
    anew: bool,
}

/// By what signal the process is to end, if not by itself.
type EndSignal = Option<i32>;

impl<T: Console> Session<T> {
    fn new(tty: T, workbench: Workbench) -> Self {
        Session {
            begun: tty.now(),
            tty,
            workbench,
            owed: true,
            anew: true,
        }
    }

    fn run(mut self) -> Result<EndSignal, Error> {
        loop {
            if let Some(end) = self.step()? {
                return Ok(end);
            }
        }
    }

    /// Shows what is owed, waits once, and takes in what has happened; the end, if that was it.
    fn step(&mut self) -> Result<Option<EndSignal>, Error> {
        if self.owed && self.is_ready() {
            self.paint()?;
            self.owed = self.workbench.is_cut();
            self.anew = !self.owed;
            #[cfg(debug_assertions)]
            fault_on_demand();
        }
        let wanted = self.workbench.app().has_mouse();
        self.tty.take_mouse(wanted)?;
        let deadline = self.deadline();
        if self.tty.follow(self.workbench.app().watched()) {
            // It may have been written between the first look and now.
            let now = self.elapsed();
            self.workbench.app().look_at_file(now, true);
        }
        let bell = self.workbench.app().bell();
        let wakes = self.tty.wait(deadline, bell)?;
        if let Some(drawn) = self.tty.drawn_at().filter(|_| !self.owed) {
            let seen = drawn.saturating_duration_since(self.begun);
            self.workbench.app().be_seen(seen);
        }
        if !self.owed && is_room_alone(&wakes) {
            return Ok(None);
        }
        self.owed = true;
        // What moves on by itself waits for a slow line: half of one picture and half of the next
        // would be none.
        self.anew |= wakes.iter().any(|wake| *wake != Wake::Room);
        // Everything that has come is taken in before one frame shows it.
        self.take_all(wakes)
    }

    /// Returns the time since the session began.
    fn elapsed(&self) -> Duration {
        self.tty.now().saturating_duration_since(self.begun)
    }

    /// Returns `true` if the line takes another frame.
    fn is_ready(&self) -> bool {
        let ready = self.tty.ready_at();
        ready.is_none_or(|ready| ready <= self.tty.now())
    }

    /// Sends the screen as it is now, or what was left of it before.
    fn paint(&mut self) -> Result<(), Error> {
        let room = self.tty.room();
        let frame = if self.anew {
            self.workbench.app().weigh();
            self.workbench.paint_within(room)
        } else {
            self.workbench.paint_rest(room)
        };
        self.tty.send(frame)?;
        while let Some(still) = self.workbench.take_still() {
            self.tty.say_still(&still)?;
        }
        Ok(())
    }

    /// Until when to wait, if nothing happens before.
    fn deadline(&mut self) -> Option<Instant> {
        let ready = self.tty.ready_at();
        // There is work to do, whether or not a slow line takes the next frame.
        if self.workbench.app().is_working() {
            return Some(self.tty.now());
        }
        if self.owed {
            return ready;
        }
        let next = self.begun + self.workbench.app().next_frame()?;
        Some(ready.map_or(next, |ready| ready.max(next)))
    }

    fn take_all(&mut self, wakes: Vec<Wake>) -> Result<Option<EndSignal>, Error> {
        // Time in which the program was stopped has not passed for what is played.
        let mut stopped = wakes.contains(&Wake::Notice(Notice::Continued));
        if !stopped {
            let now = self.elapsed();
            self.workbench.move_to(now);
        }
        let mut wakes = wakes.into_iter().peekable();
        while let Some(wake) = wakes.next() {
            if is_overtaken(&wake, wakes.peek()) {
                continue;
            }
            stopped |= wake == Wake::Notice(Notice::Suspend);
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

    /// Takes in what has happened; the end, if that was it.
    fn take(&mut self, wake: Wake) -> Result<Option<EndSignal>, Error> {
        match wake {
            Wake::HungUp => return Ok(Some(Some(terminal::HANG_UP))),
            Wake::Notice(Notice::End(signal)) => return Ok(Some(Some(signal))),
            Wake::Notice(Notice::Suspend) => {
                self.tty.suspend()?;
                self.start_over();
            }
            Wake::Notice(Notice::Continued) => {
                self.tty.enter()?;
                self.start_over();
            }
            Wake::Notice(Notice::Resized) => self.start_over(),
            Wake::Room => {}
            Wake::Written => {
                let now = self.elapsed();
                self.workbench.app().look_at_file(now, true);
                return Ok(self.attend(now));
            }
            Wake::Done => {
                self.workbench.app().hush();
                let now = self.elapsed();
                return Ok(self.attend(now));
            }
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

    /// Does what the workbench asks of its terminal; the end, if that is it.
    fn follow(&mut self, effect: Effect) -> Result<Option<EndSignal>, Error> {
        match effect {
            Effect::Show | Effect::Picture => {}
            Effect::Still => {
                let (cell, rate) = (self.tty.cell(), self.tty.rate());
                self.workbench.show_still(cell, rate);
            }
            Effect::Send(bytes) => self.tty.say(&bytes)?,
            Effect::Redraw => self.start_over(),
            Effect::Suspend => terminal::ask_to_suspend()?,
            Effect::Quit => return Ok(Some(None)),
        }
        Ok(None)
    }

    /// Takes in what was done to files; the end, if the program was to be left after it.
    fn attend(&mut self, now: Duration) -> Option<EndSignal> {
        (self.workbench.app().attend(now) == Effect::Quit).then_some(None)
    }

    /// What the terminal shows, and how large it is, is no longer what it was: where it became smaller and
    /// larger again, only the first.
    fn start_over(&mut self) {
        let (size, aspect) = (self.tty.size(), self.tty.aspect());
        self.workbench.app().resize(size, aspect);
        self.workbench.forget();
    }
}

/// Whether nothing has happened but that the line has taken the last frame, which is no reason for another. No wake
/// at all is one: the time has come.
fn is_room_alone(wakes: &[Wake]) -> bool {
    !wakes.is_empty() && wakes.iter().all(|wake| *wake == Wake::Room)
}

/// Of a mouse that is dragged only the last place counts before a frame shows it.
fn is_overtaken(wake: &Wake, next: Option<&Wake>) -> bool {
    let is_drag = |wake: &Wake| {
        matches!(
            wake,
            Wake::Mouse(Mouse {
                deed: MouseDeed::Drag,
                ..
            })
        )
    };
    is_drag(wake) && next.is_some_and(is_drag)
}

/// `KRANK_FAULT=panic` makes the workbench panic after its first frame, for the test that the
/// terminal survives it; `KRANK_FAULT=busy` makes it compute for ever. A release build knows no such switch.
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
