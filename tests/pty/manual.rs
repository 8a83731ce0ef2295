//! Tests of `krank help` on a terminal: pager, width and plain output.

use crate::session::Setup;

/// Returns all bytes sent until the program ends.
fn sent(setup: Setup) -> String {
    let mut session = setup.start();
    assert!(session.ended_as_found().success());
    let seen = session.seen.lock().unwrap();
    String::from_utf8(seen.bytes.clone()).unwrap()
}

fn topic(name: &str) -> Setup {
    Setup::krank(&["help", name])
}

/// Only the pager handles Ctrl-C: if krank ended, the pager would compete with the shell for the terminal.
#[test]
fn topic_is_shown_in_the_users_pager() {
    for pager in ["less", "more", "\"less\" -R", "FROM=krank less"] {
        let mut session = topic("scene").env("PAGER", pager).without("LESS").start();
        session.wait_for("The scene file");
        if pager == "more" {
            session.send_until("/slides]\r", "[slides]", |seen| {
                seen.terminal.screen().contents().contains("[slides]")
            });
        } else {
            session.send("\x03");
            session.settle();
            // A pager that is still handling Ctrl-C drops keys. The rest of a longer command would be
            // another one.
            session.send_until("G", "end of the topic", |seen| {
                let screen = seen.terminal.screen().contents();
                screen.contains("did you mean `length`?")
            });
        }
        session.send("q");
        assert!(session.ended_as_found().success(), "{pager}");
    }
}

/// `PAGER` is a shell command, as in other programs.
#[test]
fn pager_can_be_a_shell_pipeline() {
    let all = sent(topic("limits").env("PAGER", "less | sed 's/^/> /'"));
    assert!(all.contains("> - A scene file has"), "{all}");
    assert!(all.contains("10,000 links"), "{all}");
}

/// Regression test: with options in `LESS`, the escapes of bold text were visible.
#[test]
fn less_never_shows_raw_escapes_with_user_options() {
    for options in ["-i", "i", "", "-Pso far"] {
        let mut session = topic("scene")
            .env("PAGER", "less")
            .env("LESS", options)
            .start();
        session.wait_for("The scene file").wait_for("[ground]");
        assert!(!session.screen().contains("ESC"), "{}", session.screen());
        session.send("q");
        assert!(session.ended_as_found().success(), "{options}");
    }
}

#[test]
fn missing_pager_falls_back_to_plain_output() {
    // The path is empty, so the default pagers are not found either.
    let all = sent(
        topic("limits")
            .env("PAGER", "/nowhere/pager")
            .env("PATH", "/nowhere"),
    );
    assert!(all.contains("10,000 links"), "{all}");
    let all = sent(topic("limits").env("PAGER", ""));
    assert!(all.contains("10,000 links"), "{all}");
    let without = Setup::krank(&["help", "limits", "--no-pager"]).env("PAGER", "false");
    assert!(sent(without).contains("10,000 links"));
    // A terminal without cursor movement gets no pager.
    let dumb = sent(topic("limits").env("TERM", "dumb").env("PAGER", "false"));
    assert!(
        dumb.contains("10,000 links") && !dumb.contains('\x1b'),
        "{dumb}"
    );
}

#[test]
fn headings_are_bold_unless_no_color_is_set() {
    let plain = |setup: Setup| sent(setup.env("PAGER", "cat"));
    assert!(plain(topic("keys")).contains("\x1b[1mThe motion\x1b[0m"));
    let plain = plain(topic("keys").env("NO_COLOR", "1"));
    assert!(
        plain.contains("The motion") && !plain.contains('\x1b'),
        "{plain}"
    );
}

#[test]
fn text_follows_terminal_width_up_to_100_columns() {
    for (cols, widest) in [(40, 40), (80, 80), (300, 100)] {
        let text = sent(
            topic("limits")
                .env("PAGER", "cat")
                .env("NO_COLOR", "1")
                .size(cols, 24),
        );
        let longest = text
            .lines()
            .map(|line| line.trim_end().len())
            .max()
            .unwrap();
        assert!(
            longest <= widest && longest > widest - 12,
            "{cols}: {longest}\n{text}"
        );
    }
}
