//! Reads keys and signals, even while the main thread computes.
//!
//! The main thread announces when it waits for the terminal. While it computes, a second thread
//! reads ahead and stores the input for it. If the input ends the program and the main thread does
//! not respond, the second thread restores the terminal and ends the process. While the main thread
//! waits, the second one sleeps.

use super::keyboard::{Keyboard, TerminalInput};
use super::signals::{HANG_UP_SIGNAL, SignalEvent, Signals, die_of};
use crate::tui::commands::key::Key;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::{Errno, read, write};
use rustix::termios::{OptionalActions, Termios, tcsetattr};
use std::io;
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Maximum number of bytes read before a frame; a terminal's queue holds no more.
const MAX_BATCH: usize = 4096;
/// Computing time after which the second thread starts reading, and its interval between reads.
const WATCHED: Duration = Duration::from_millis(100);
/// Maximum time for the main thread to respond to input that ends the program.
const EXIT_TIMEOUT: Duration = Duration::from_millis(500);
/// Maximum time for restoring the terminal on a stalled line.
pub(super) const RESTORE_TIMEOUT: Duration = Duration::from_millis(500);
const NO_WAIT: Timespec = Timespec {
    tv_sec: 0,
    tv_nsec: 0,
};

/// Input from the terminal or the system.
#[derive(Debug)]
pub(super) enum IntakeEvent {
    /// Input from the terminal, with its time.
    Input(TerminalInput, Instant),
    /// A signal.
    SignalEvent(SignalEvent),
}

/// The cause that ends the program.
#[derive(Clone, Copy, Debug)]
enum ExitCause {
    /// Ctrl-C.
    Key,
    Signal(i32),
    HungUp,
}

/// Everything needed to restore the terminal.
#[derive(Debug)]
pub(super) struct TerminalRestore {
    pub(super) screen: OwnedFd,
    pub(super) modes: Termios,
    pub(super) bytes: Vec<u8>,
}

/// Keys and signals on their way to the main thread.
#[derive(Debug)]
pub(super) struct InputQueue {
    keys: OwnedFd,
    signals: Signals,
    pub(super) keyboard: Keyboard,
    arrivals: Vec<IntakeEvent>,
    /// The cause among the arrivals that ends the program, and the time of its arrival.
    ending: Option<(ExitCause, Instant)>,
    pub(super) hung_up: bool,
    /// The time since which the main thread computes; `None` while it waits for the terminal.
    busy: Option<Instant>,
    /// `true` if the second thread must be woken when the main thread starts computing.
    is_asleep: bool,
    has_left: bool,
    /// `None` while the terminal is in its original state.
    pub(super) restore: Option<TerminalRestore>,
}

/// An intake shared by both threads.
#[derive(Debug)]
pub(super) struct SharedIntake {
    intake: Mutex<InputQueue>,
    turned: Condvar,
}

impl InputQueue {
    pub(super) fn new(keys: OwnedFd, signals: Signals) -> InputQueue {
        InputQueue {
            keys,
            signals,
            keyboard: Keyboard::default(),
            arrivals: Vec::new(),
            ending: None,
            hung_up: false,
            busy: Some(Instant::now()),
            is_asleep: false,
            has_left: false,
            restore: None,
        }
    }

    /// Reads pending signals and keys without waiting.
    pub(super) fn collect(&mut self) -> io::Result<()> {
        let mut inputs = Vec::new();
        self.read_keys(&mut inputs)?;
        let now = Instant::now();
        let is_over = |deadline| deadline <= now;
        if self.keyboard.deadline().is_some_and(is_over) {
            self.keyboard.give_up(&mut inputs);
        }
        let notices = self
            .signals
            .pending()
            .into_iter()
            .map(IntakeEvent::SignalEvent);
        let inputs = inputs
            .into_iter()
            .map(|input| IntakeEvent::Input(input, now));
        for arrival in notices.chain(inputs) {
            self.ending = self.ending.or(arrival.ending().map(|ending| (ending, now)));
            self.arrivals.push(arrival);
        }
        if self.hung_up {
            self.ending.get_or_insert((ExitCause::HungUp, now));
        }
        Ok(())
    }

    /// Returns the arrivals since the last call.
    pub(super) fn take(&mut self) -> Vec<IntakeEvent> {
        self.ending = None;
        std::mem::take(&mut self.arrivals)
    }

    /// Reads keys once, without waiting. End of file or a device error means that the terminal is
    /// gone.
    fn read_keys(&mut self, inputs: &mut Vec<TerminalInput>) -> io::Result<()> {
        let mut fds = [PollFd::new(&self.keys, PollFlags::IN)];
        match poll(&mut fds, Some(&NO_WAIT)) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(error) => return Err(error.into()),
        }
        let ready = fds[0].revents();
        if ready.is_empty() {
            return Ok(());
        }
        let mut buffer = [0; MAX_BATCH];
        match read(&self.keys, &mut buffer) {
            Ok(0) | Err(Errno::IO | Errno::NXIO) => self.hung_up = true,
            Ok(n) => self.keyboard.feed(&buffer[..n], Instant::now(), inputs),
            // `poll` returned although there is nothing to read. Without this check the loop would
            // spin.
            Err(Errno::AGAIN) => self.hung_up |= is_gone(ready),
            Err(Errno::INTR) => {}
            Err(error) => return Err(error.into()),
        }
        Ok(())
    }

    /// Restores the terminal and ends the process, because the main thread does not respond.
    fn end(&self, ending: ExitCause) {
        if let Some(parting) = self.restore.as_ref().filter(|_| !self.hung_up) {
            parting.write(Instant::now() + RESTORE_TIMEOUT);
            let _ = tcsetattr(&self.keys, OptionalActions::Now, &parting.modes);
        }
        match ending {
            ExitCause::Key => {}
            ExitCause::Signal(signal) => drop(die_of(signal)),
            ExitCause::HungUp => drop(die_of(HANG_UP_SIGNAL)),
        }
        std::process::exit(0);
    }
}

impl IntakeEvent {
    fn ending(&self) -> Option<ExitCause> {
        match self {
            IntakeEvent::Input(TerminalInput::Key(Key::Ctrl('c')), _) => Some(ExitCause::Key),
            IntakeEvent::SignalEvent(SignalEvent::End(signal)) => Some(ExitCause::Signal(*signal)),
            IntakeEvent::Input(..) | IntakeEvent::SignalEvent(_) => None,
        }
    }
}

impl TerminalRestore {
    /// Writes the bytes that restore the screen, retrying on a stalled line until the deadline.
    fn write(&self, deadline: Instant) {
        let mut bytes = &self.bytes[..];
        while !bytes.is_empty() && Instant::now() < deadline {
            match write(&self.screen, bytes) {
                Ok(n) => bytes = &bytes[n..],
                Err(Errno::INTR) => {}
                Err(Errno::AGAIN) => thread::sleep(RESTORE_TIMEOUT / 50),
                Err(_) => return,
            }
        }
    }
}

impl SharedIntake {
    /// Starts the second thread. If the system creates none, only the main thread can end the
    /// program.
    pub(super) fn watched(intake: InputQueue) -> Arc<SharedIntake> {
        let shared = Arc::new(SharedIntake {
            intake: Mutex::new(intake),
            turned: Condvar::new(),
        });
        let own = Arc::clone(&shared);
        let watch = move || own.watch();
        let _ = thread::Builder::new().name("intake".into()).spawn(watch);
        shared
    }

    pub(super) fn lock(&self) -> MutexGuard<'_, InputQueue> {
        self.intake.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes that the main thread waits for the terminal. Returns `true` if arrivals are already
    /// pending.
    pub(super) fn rest(&self) -> bool {
        let mut intake = self.lock();
        intake.busy = None;
        !intake.arrivals.is_empty()
    }

    /// Notes that the main thread computes.
    pub(super) fn work(&self) {
        let mut intake = self.lock();
        intake.busy = Some(Instant::now());
        if intake.is_asleep {
            self.turned.notify_one();
        }
    }

    /// Ends the second thread after the terminal was finally restored.
    pub(super) fn stop(&self) {
        self.lock().has_left = true;
        self.turned.notify_one();
    }

    /// Reads ahead while the main thread computes.
    fn watch(&self) {
        let mut intake = self.lock();
        while !intake.has_left {
            let Some(since) = intake.busy else {
                intake.is_asleep = true;
                intake = match self.turned.wait(intake) {
                    Ok(intake) => intake,
                    Err(poisoned) => poisoned.into_inner(),
                };
                intake.is_asleep = false;
                continue;
            };
            intake = match self.turned.wait_timeout(intake, WATCHED) {
                Ok((intake, _)) => intake,
                Err(poisoned) => poisoned.into_inner().0,
            };
            if intake.has_left || intake.busy != Some(since) || since.elapsed() < WATCHED {
                continue;
            }
            // The main thread will meet the same error.
            let _ = intake.collect();
            if let Some((ending, waits)) = intake.ending
                && waits.elapsed() >= EXIT_TIMEOUT
            {
                intake.end(ending);
            }
        }
    }
}

/// Returns `true` if the events of `poll` mean that the terminal is gone.
pub(super) fn is_gone(events: PollFlags) -> bool {
    events.intersects(PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL)
}

/// The descriptors of an intake, for waiting without its lock.
#[derive(Debug)]
pub(super) struct InputDescriptors {
    pub(super) keys: OwnedFd,
    pub(super) signals: OwnedFd,
}

impl InputDescriptors {
    pub(super) fn of(keys: BorrowedFd<'_>, signals: &Signals) -> io::Result<InputDescriptors> {
        Ok(InputDescriptors {
            keys: keys.try_clone_to_owned()?,
            signals: signals.as_fd().try_clone_to_owned()?,
        })
    }
}
