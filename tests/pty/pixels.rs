//! Tests of the drawing in pixels: the sequences sent, when they are sent, and how they are removed.

use crate::session::Setup;

/// A terminal that may not support pictures receives none: it would show them as letters.
#[cfg(feature = "pictures")]
#[test]
fn unknown_terminal_is_sent_no_pixels() {
    let mut session = Setup::krank(&["four-bar"]).without("TERM_PROGRAM").start();
    session.wait_for("60.00 deg").send("V");
    session
        .wait_for("--picture kitty, iterm or sixel")
        .send("q");
    assert!(session.ended_as_found().success());
}

#[cfg(not(feature = "pictures"))]
#[test]
fn missing_pixels_feature_is_explained_in_the_workbench() {
    for wish in ["kitty", "auto"] {
        let mut session = Setup::krank(&["four-bar", "--picture", wish]).start();
        session.wait_for("60.00 deg").send("V");
        session.wait_for("built without the feature").send("q");
        assert!(session.ended_as_found().success());
    }
}

#[cfg(feature = "pictures")]
mod sent {
    use crate::session::{Setup, TerminalBehaviour};

    /// Start and end of a protocol's sequence, and the sequence that removes its picture in
    /// addition to clearing the screen.
    struct Sequence {
        protocol: &'static str,
        begins: &'static [u8],
        ends: &'static [u8],
        removal: &'static [u8],
    }

    const KITTY: Sequence = Sequence {
        protocol: "kitty",
        begins: b"\x1b_Ga=T,f=100,i=1,q=2,C=1,",
        ends: b"\x1b\\",
        removal: b"\x1b_Ga=d,d=I,i=1,q=2\x1b\\",
    };
    const ITERM: Sequence = Sequence {
        protocol: "iterm",
        begins: b"\x1b]1337;File=inline=1;",
        ends: b"\x07",
        removal: b"",
    };
    const SIXEL: Sequence = Sequence {
        protocol: "sixel",
        begins: b"\x1bP",
        ends: b"\x1b\\",
        removal: b"",
    };
    const CLEARED: &[u8] = b"\x1b[2J";

    fn has(bytes: &[u8], part: &[u8]) -> bool {
        bytes.windows(part.len()).any(|window| window == part)
    }

    #[test]
    fn pixels_are_sent_complete_and_removed_by_the_next_key() {
        for sequence in [KITTY, ITERM, SIXEL] {
            let Sequence {
                protocol,
                begins: starts,
                ends,
                removal,
            } = sequence;
            let mut session = Setup::krank(&["four-bar", "--picture", protocol]).start();
            session.wait_for("60.00 deg").send(" ");
            // The playback pauses for the picture.
            session.wait_until("playing", |seen| {
                !seen.rows().join("").contains("60.00 deg")
            });
            session.send("V");
            session.wait_for("any key closes it");
            session.wait_until("the picture", |seen| {
                has(&seen.bytes, starts) && seen.bytes.ends_with(ends)
            });
            let sent = session.seen.lock().unwrap().bytes.len();
            session.send(".");
            session.wait_until("cells again", |seen| {
                let after = &seen.bytes[sent..];
                has(after, CLEARED) && (removal.is_empty() || has(after, removal))
            });
            assert!(
                !has(&session.seen.lock().unwrap().bytes[sent..], starts),
                "{protocol}"
            );
            session.send("q");
            assert!(session.ended_as_found().success());
        }
    }

    /// kitty keeps pictures unless they are removed, so an exit by signal must remove them too.
    #[test]
    fn pixels_are_removed_on_exit_by_signal() {
        let Sequence {
            begins: starts,
            removal,
            ..
        } = KITTY;
        let mut session = Setup::krank(&["four-bar", "--picture", "kitty"]).start();
        session.wait_for("60.00 deg").send("V");
        session.wait_until("the picture", |seen| has(&seen.bytes, starts));
        session.signal(rustix::process::Signal::TERM);
        session.wait_until("it is taken away", |seen| has(&seen.bytes, removal));
        session.ended_as_found();
    }

    #[test]
    fn pixels_on_a_slow_line_are_sent_only_after_confirmation() {
        let starts = SIXEL.begins;
        let arguments = ["four-bar", "--picture", "sixel"];
        let mut session = Setup::krank(&arguments)
            .manner(TerminalBehaviour::Slow)
            .start();
        session.wait_for("-3.9164").send("V");
        session.wait_for("on this line; press V again");
        session.send(".");
        session.wait_for("65.00 deg");
        assert!(!has(&session.seen.lock().unwrap().bytes, starts));
        session.send("V");
        session.wait_for("on this line; press V again").send("V");
        session.wait_until("the picture begins", |seen| has(&seen.bytes, starts));
        session.read_without_delay();
        session.send("q");
        assert!(session.ended_as_found().success());
    }
}
