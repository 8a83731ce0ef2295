//! Signals, as something to wait for beside the keyboard.

use rustix::process::{Signal, getpgrp, getsid, kill_current_process_group};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::iterator::backend::SignalDelivery;
use signal_hook::iterator::exfiltrator::SignalOnly;
use signal_hook::low_level::emulate_default_handler;
use std::io;
use std::os::fd::{AsFd, BorrowedFd};
use std::os::unix::net::UnixStream;

/// Every signal that would end or stop the program with the terminal left raw, and the two that
/// call for a new frame.
const CAUGHT: [i32; 7] = [SIGWINCH, SIGTERM, SIGHUP, SIGINT, SIGQUIT, SIGCONT, SIGTSTP];

/// The signal of a terminal that has gone.
pub(crate) const HANG_UP: i32 = SIGHUP;

/// What a signal asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Notice {
    /// The window has another size.
    Resized,
    /// The program goes on after having been stopped.
    Continued,
    /// The program ought to stop.
    Suspend,
    /// The program ought to end, by this signal.
    End(i32),
}

/// The signals that have come.
#[derive(Debug)]
pub(crate) struct Signals(SignalDelivery<UnixStream, SignalOnly>);

impl Signals {
    /// Begins to catch signals; a SIGHUP that the parent ignores (`nohup`) is caught too, because a
    /// program on a dead terminal has nothing left to do.
    pub(crate) fn new() -> io::Result<Self> {
        let (read, write) = UnixStream::pair()?;
        SignalDelivery::with_pipe(read, write, SignalOnly, CAUGHT).map(Signals)
    }

    /// What has come since the last call.
    pub(crate) fn pending(&mut self) -> Vec<Notice> {
        self.0.pending().filter_map(notice).collect()
    }
}

impl AsFd for Signals {
    /// Readable when a signal has come.
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.0.get_read().as_fd()
    }
}

fn notice(signal: i32) -> Option<Notice> {
    match signal {
        SIGWINCH => Some(Notice::Resized),
        SIGCONT => Some(Notice::Continued),
        SIGTSTP => Some(Notice::Suspend),
        SIGTERM | SIGHUP | SIGINT | SIGQUIT => Some(Notice::End(signal)),
        _ => None,
    }
}

/// Whether somebody is there to continue the program once it has stopped.
///
/// Under `ssh -t host krank` there is no shell with job control: stopped there, it would stay so for
/// ever, and the line with it. Then the session's leader is in our own process group.
pub(super) fn can_suspend() -> bool {
    getsid(None).is_ok_and(|leader| leader != getpgrp())
}

/// What Ctrl-Z means: the whole process group is to stop, a script around the program included. The
/// signal comes back as [`Notice::Suspend`].
pub(crate) fn ask_to_suspend() -> io::Result<()> {
    if can_suspend() {
        kill_current_process_group(Signal::TSTP)?;
    }
    Ok(())
}

/// Stops the program until SIGCONT.
pub(super) fn stop() -> io::Result<()> {
    emulate_default_handler(SIGTSTP)
}

/// Ends the program as `signal` would have, so that whoever waits for it learns why.
pub(crate) fn die_of(signal: i32) -> io::Result<()> {
    emulate_default_handler(signal)
}
