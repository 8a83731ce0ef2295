//! `krank help` on a terminal: paged, as wide as there is room, and as plain as is wished.

use crate::session::Setup;

/// Everything that was sent, once the program has left.
fn sent(setup: Setup) -> String {
    let mut session = setup.start();
    assert!(session.ended_as_found().success());
    let seen = session.seen.lock().unwrap();
    String::from_utf8(seen.bytes.clone()).unwrap()
}

fn topic(name: &str) -> Setup {
    Setup::krank(&["help", name])
}

/// Ctrl-C is the pager's affair: nobody else ends by it, and leaves the pager to a terminal that another reads.
#[test]
fn the_pager_of_the_person_shows_it() {
    for pager in ["less", "more", "\"less\" -R", "FROM=krank less"] {
        let mut session = topic("scene").env("PAGER", pager).without("LESS").start();
        session.wait_for("The scene file");
        if pager != "more" {
            session.send("\x03");
            session.settle();
        }
        session.send(" ");
        session.wait_for("[slides]").send("q");
        assert!(session.ended_as_found().success(), "{pager}");
    }
}

/// It is a command for the shell, as for others that ask for it.
#[test]
fn the_pager_may_be_a_pipe() {
    let all = sent(topic("limits").env("PAGER", "less | sed 's/^/> /'"));
    assert!(all.contains("> - A scene file has"), "{all}");
    assert!(all.contains("10,000 links"), "{all}");
}

/// Options that a person has chosen used to show the escapes of what is bold.
#[test]
fn no_escape_is_read_whatever_less_is_told() {
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
fn a_pager_that_is_not_there_keeps_nobody_from_reading() {
    // Nothing is found on this path, so neither are the usual ones.
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
    // A terminal that cannot go back has no use for a pager.
    let dumb = sent(topic("limits").env("TERM", "dumb").env("PAGER", "false"));
    assert!(
        dumb.contains("10,000 links") && !dumb.contains('\x1b'),
        "{dumb}"
    );
}

#[test]
fn headings_are_bold_unless_that_is_not_wished() {
    let plain = |setup: Setup| sent(setup.env("PAGER", "cat"));
    assert!(plain(topic("keys")).contains("\x1b[1mThe motion\x1b[0m"));
    let plain = plain(topic("keys").env("NO_COLOR", "1"));
    assert!(
        plain.contains("The motion") && !plain.contains('\x1b'),
        "{plain}"
    );
}

#[test]
fn it_is_as_wide_as_the_terminal() {
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
