//! The configuration: its template, where it is looked for, and what is wrong with one.

use super::{command, done, folder, refused, run};

/// Without a terminal the workbench is refused: that it comes so far tells that the configuration was read.
const NO_TERMINAL: &str = "standard output is no terminal";

#[test]
fn the_template_is_a_configuration() {
    let text = done(&["config"]);
    assert!(text.contains("\n#play = \"space\" "), "{text}");
    assert!(text.contains("\n[keys]\n"), "{text}");
    let file = folder("config-template").join("config.toml");
    std::fs::write(&file, &text).unwrap();
    let message = refused(2, &["--config", file.to_str().unwrap()]);
    assert!(message.contains(NO_TERMINAL), "{message}");
}

#[test]
fn a_fault_is_told_as_one_of_a_scene_before_anything_else() {
    let home = folder("config-faulty");
    std::fs::create_dir_all(home.join("krank")).unwrap();
    let file = home.join("krank").join("config.toml");
    std::fs::write(&file, "glyphs = \"ascii\"\n[keys]\nplya = \"F5\"\n").unwrap();
    let heard = run(command(&["no-such-scene"]).env("XDG_CONFIG_HOME", &home));
    assert_eq!((heard.code, heard.out.as_str()), (2, ""));
    let shown = file.display();
    assert_eq!(
        heard.err,
        format!(
            "error: [keys]: unknown action `plya`\n --> {shown}:3:1\n  |\n3 | plya = \"F5\"\n  | ^^^^ unknown action\n  |\n  = help: did you mean `play`?\n"
        )
    );
    // Commands that show nothing by it do not read it.
    let listed = run(command(&["list"]).env("XDG_CONFIG_HOME", &home));
    assert_eq!(listed.code, 0, "{}", listed.err);
}

#[test]
fn a_file_that_is_named_must_be_there_and_the_usual_one_need_not() {
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
        let heard = run(command(&[]).env(name, value));
        assert!(heard.err.contains(NO_TERMINAL), "{}", heard.err);
    }
    let bytes = folder("config-bytes").join("config.toml");
    std::fs::write(&bytes, b"tour = \xff").unwrap();
    let message = refused(2, &["--config", bytes.to_str().unwrap()]);
    assert!(message.contains("the file is not UTF-8"), "{message}");
}
