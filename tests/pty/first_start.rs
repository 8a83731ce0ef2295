//! Tests of the configuration and of the first start.

use crate::session::{Session, Setup};
use std::path::Path;

/// The first start without a scene shows the tour. Later starts and starts with a scene do not.
#[test]
fn first_start_shows_the_tour_once() {
    let home = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pty-first-start");
    let _ = std::fs::remove_dir_all(&home);
    let start = |args: &[&str], config: &str| {
        let folder = home.join("config").join("krank");
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("config.toml"), config).unwrap();
        Setup::krank(args)
            .env("XDG_CONFIG_HOME", home.join("config").to_str().unwrap())
            .env("XDG_STATE_HOME", home.join("state").to_str().unwrap())
            .start()
    };
    let quit = |mut session: Session, key: &str| {
        session.send(key);
        assert!(session.ended_as_found().success());
    };
    let quiet = |args: &[&str], config: &str| {
        let session = start(args, config);
        session.wait_for("? help");
        assert!(!session.screen().contains("Tour"), "{args:?} {config}");
        quit(session, "q");
    };
    quiet(&["four-bar"], "");
    quiet(&["--at", "30"], "");
    quiet(&[], "tour = false");
    let first = start(&[], "");
    first.wait_for("Tour 1/5").send("\r");
    first.wait_for("Tour 2/5").send(".");
    first.wait_for("65.00 deg").send("\x1b");
    first.wait_for("? help");
    quit(first, "q");
    quiet(&[], "");
    // Keys of the configuration replace the default ones.
    let other = start(&["four-bar"], "[keys]\nquit = 'Q'");
    other.wait_for("Q quit").send("q.");
    other.wait_for("65.00 deg");
    quit(other, "Q");
}
