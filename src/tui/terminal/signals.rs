//! Delivers signals through a file descriptor, for waiting together with the keyboard.

use rustix::process::{Signal, getpgrp, getsid, kill_current_process_group};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::iterator::backend::SignalDelivery;
use signal_hook::iterator::exfiltrator::SignalOnly;
use signal_hook::low_level::emulate_default_handler;
use std::io;
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;

/// All signals that would end or stop the program with the terminal in raw mode, and the two that
/// require a new frame.
const CAUGHT_SIGNALS: [i32; 7] = [SIGWINCH, SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGCONT, SIGTSTP];

/// The signal of a closed terminal.
pub(crate) const HANG_UP_SIGNAL: i32 = SIGHUP;

/// The meaning of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SignalEvent {
    /// The window has another size.
    Resized,
    /// The program continues after a suspension.
    Continued,
    /// The program should suspend itself.
    Suspend,
    /// The program should end by this signal.
    End(i32),
}

/// The caught signals.
#[derive(Debug)]
pub(crate) struct Signals(SignalDelivery<UnixStream, SignalOnly>);

impl Signals {
    /// Starts catching signals. Catches SIGHUP even if the parent ignores it (`nohup`), because a
    /// program without a terminal has nothing left to do.
    pub(crate) fn new() -> io::Result<Self> {
        let (read, write) = UnixStream::pair()?;
        SignalDelivery::with_pipe(read, write, SignalOnly, CAUGHT_SIGNALS).map(Signals)
    }

    /// Returns the notices since the last call.
    pub(crate) fn pending(&mut self) -> Vec<SignalEvent> {
        self.0.pending().filter_map(notice).collect()
    }
}

impl AsFd for Signals {
    /// Returns a descriptor that is readable when a signal has arrived.
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.0.get_read().as_fd()
    }
}

fn notice(signal: i32) -> Option<SignalEvent> {
    match signal {
        SIGWINCH => Some(SignalEvent::Resized),
        SIGCONT => Some(SignalEvent::Continued),
        SIGTSTP => Some(SignalEvent::Suspend),
        SIGTERM | SIGHUP | SIGINT | SIGQUIT => Some(SignalEvent::End(signal)),
        _ => None,
    }
}

/// Returns `true` if a shell can continue the program after a suspension.
///
/// Under `ssh -t host krank` there is no shell with job control: a suspended program would stay
/// suspended forever, together with the line. In this case the session leader is in the program's
/// own process group.
pub(super) fn can_suspend() -> bool {
    getsid(None).is_ok_and(|leader| leader != getpgrp())
}

/// Suspends the whole process group on Ctrl-Z, including a script around the program. The signal
/// comes back as [`SignalEvent::Suspend`].
pub(crate) fn suspend_process_group() -> io::Result<()> {
    if can_suspend() {
        kill_current_process_group(Signal::TSTP)?;
    }
    Ok(())
}

/// Stops the program until SIGCONT.
pub(super) fn stop() -> io::Result<()> {
    emulate_default_handler(SIGTSTP)
}

/// Ends the program by `signal`, so that the parent process sees the cause.
pub(crate) fn die_of(signal: i32) -> io::Result<()> {
    emulate_default_handler(signal)
}
