//! Tests of the configuration: its template, its location and its errors.

use super::{command, folder, refused, run, run_ok};

/// The workbench fails without a terminal; this message shows that the configuration was read before.
const NO_TERMINAL: &str = "standard output is not a terminal";

#[test]
fn template_is_a_valid_configuration() {
    let text = run_ok(&["config"]);
    assert!(text.contains("\n#play = \"space\" "), "{text}");
    assert!(text.contains("\n[keys]\n"), "{text}");
    let file = folder("config-template").join("config.toml");
    std::fs::write(&file, &text).unwrap();
    let message = refused(2, &["--config", file.to_str().unwrap()]);
    assert!(message.contains(NO_TERMINAL), "{message}");
}

#[test]
fn config_error_is_reported_before_scene_errors() {
    let home = folder("config-faulty");
    std::fs::create_dir_all(home.join("krank")).unwrap();
    let file = home.join("krank").join("config.toml");
    std::fs::write(&file, "glyphs = \"asci\"\n").unwrap();
    let output = run(command(&["no-such-scene"]).env("XDG_CONFIG_HOME", &home));
    assert_eq!((output.code, output.out.as_str()), (2, ""));
    let place = format!(" --> {}:1:10\n", file.display());
    let lines = [
        "error: `glyphs` cannot be `asci`\n",
        &place,
        "did you mean `ascii`?",
    ];
    for part in lines.iter().chain(&["\"braille\""]) {
        assert!(output.err.contains(part), "{part}: {}", output.err);
    }
    // Commands that do not use the configuration do not read it.
    let listed = run(command(&["list"]).env("XDG_CONFIG_HOME", &home));
    assert_eq!(listed.code, 0, "{}", listed.err);
}

#[test]
fn explicit_config_must_exist_but_default_may_be_missing() {
    let message = refused(2, &["--config", "nowhere.toml"]);
    assert!(
        message.starts_with("error: cannot read `nowhere.toml`: "),
        "{message}"
    );
    for (name, value) in [
        ("XDG_CONFIG_HOME", "/nowhere"),
        ("HOME", "/nowhere"),
        ("HOME", ""),
    ] {
        let output = run(command(&[]).env(name, value));
        assert!(output.err.contains(NO_TERMINAL), "{}", output.err);
    }
    let bytes = folder("config-bytes").join("config.toml");
    std::fs::write(&bytes, b"tour = \xff").unwrap();
    let message = refused(2, &["--config", bytes.to_str().unwrap()]);
    assert!(message.contains("the file is not UTF-8"), "{message}");
}

/// All unknown entries are reported at once, and the valid ones apply.
#[test]
fn unknown_entries_give_warnings() {
    let file = folder("config-unknown").join("config.toml");
    let text = "glyfs = 1\nglyphs = \"ascii\"\nblink = true\n[keys]\nplya = \"F5\"\nstep = [\"F99\", \"F7\"]\n[mouse-keys]\nx = 1\n";
    std::fs::write(&file, text).unwrap();
    let file = file.to_str().unwrap();
    let output = run(command(&["four-bar", "--print", "--config", file]).env("LC_ALL", "C.UTF-8"));
    assert_eq!(output.code, 0, "{}", output.err);
    assert!(output.out.is_ascii() && output.out.contains("four-bar"));
    for unknown in ["`glyfs`", "`blink`", "`mouse-keys`", "`plya`", "`F99`"] {
        let warned = output
            .err
            .lines()
            .any(|line| line.starts_with("warning: ") && line.ends_with(unknown));
        assert!(warned, "{unknown}: {}", output.err);
    }
    assert!(!output.err.contains("error"), "{}", output.err);
}
