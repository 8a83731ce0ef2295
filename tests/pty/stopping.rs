//! Tests of stop and continue by the job control of a shell.

use crate::session::{Session, Setup};
use rustix::process::Signal;

/// Starts an interactive shell with job control.
fn shell() -> Session {
    let session = Setup::program("/bin/sh", &["-i"])
        .env("PS1", "ready> ")
        .start();
    session.wait_for("ready>");
    session
}

/// Waits for the prompt: the shell discards keys typed before it.
fn wait_for_the_prompt(session: &Session) {
    session.wait_until("prompt", |seen| {
        let screen = seen.terminal.screen();
        !screen.alternate_screen() && screen.contents().trim_end().ends_with("ready>")
    });
}

#[test]
fn ctrl_z_returns_the_terminal_to_the_shell() {
    let session = shell();
    let krank = env!("CARGO_BIN_EXE_krank");
    session.send(&format!("{krank} four-bar\r"));
    session.wait_for("60.00 deg").send(" ");
    session.wait_for("pause").send("\x1a");
    wait_for_the_prompt(&session);
    session.send("echo back$((1 + 1))\r");
    session.wait_for("back2");
    assert!(!session.seen.lock().unwrap().terminal.screen().hide_cursor());
    session.send("fg\r");
    session.wait_for("pause").send(" ");
    session.wait_for("play").send("q");
    wait_for_the_prompt(&session);
    session.send("echo gone$((2 + 2)); exit\r");
    session.wait_for("gone4");
}

/// A signal from another process has the same effect as the key.
#[test]
fn sigtstp_returns_the_terminal_to_the_shell() {
    let session = shell();
    let krank = env!("CARGO_BIN_EXE_krank");
    // The shell is krank's parent; the signal is sent to the job.
    session.send(&format!("{krank} four-bar\r"));
    session.wait_for("60.00 deg");
    let parent = session.pid().as_raw_nonzero();
    let children = std::fs::read_to_string(format!("/proc/{parent}/task/{parent}/children"));
    let child: i32 = children.unwrap().trim().parse().unwrap();
    let job = rustix::process::Pid::from_raw(child).unwrap();
    for _ in 0..3 {
        rustix::process::kill_process_group(job, Signal::TSTP).unwrap();
        wait_for_the_prompt(&session);
        session.send("fg\r");
        session.wait_until("alternate screen", |seen| {
            seen.terminal.screen().alternate_screen()
        });
        session.wait_for("60.00 deg").wait_for("-3.9164");
    }
    session.send("q");
    wait_for_the_prompt(&session);
    session.send("exit\r");
}

#[test]
fn sigcont_after_sigstop_repaints_the_screen() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg");
    session.settle();
    session.signal(Signal::STOP);
    session.wipe();
    session.signal(Signal::CONT);
    session.wait_for("60.00 deg").wait_for("-3.9164").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn ctrl_z_without_a_shell_does_not_hang() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send("\x1a.");
    session.wait_for("65.00 deg").send("q");
    assert!(session.ended_as_found().success());
}
