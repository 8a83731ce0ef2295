//! Tests of `krank import`, and of other programs' files as scenes.

use super::{command, folder, json, krank, refused, run, run_ok};
use std::fs;

fn file(name: &str) -> String {
    format!("{}/tests/import/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// The scene is the same on standard output and in a file, and is a scene for every command.
#[test]
fn import_writes_a_scene_that_opens() {
    let source = file("four-bar.pmks.txt");
    let text = run_ok(&["import", &source]);
    assert!(
        text.starts_with("# Imported from a file of PMKS."),
        "{text}"
    );
    let scene = folder("import").join("four-bar.toml");
    let scene = scene.to_str().unwrap();
    let output = krank(&["import", &source, "-o", scene]);
    assert_eq!((output.code, output.out.as_str()), (0, ""));
    assert_eq!(fs::read_to_string(scene).unwrap(), text);
    let check = json(&run_ok(&["check", scene, "--format", "json"]));
    assert_eq!(
        check,
        json(&run_ok(&["check", &source, "--format", "json"]))
    );
}

/// A file of another program is a scene for every command, by its contents.
#[test]
fn commands_read_files_of_other_programs() {
    let copy = folder("import").join("unnamed");
    fs::copy(file("slider-crank.pmks.txt"), &copy).unwrap();
    let copy = format!("./{}", copy.file_name().unwrap().to_str().unwrap());
    let output = run(command(&["table", &copy, "--at", "60"]).current_dir(folder("import")));
    assert_eq!(output.code, 0, "{}", output.err);
    // The file marks no input, and names none.
    assert!(
        output.err.contains("note: line 3: the file marks no input"),
        "{}",
        output.err
    );
    let piped = run(command(&["check", "-"])
        .pipe_stdin(file("four-bar.pyslvs"))
        .unwrap());
    assert_eq!(piped.code, 0, "{}", piped.err);
    assert!(piped.out.contains("link_0"), "{}", piped.out);
}

#[test]
fn addresses_are_files() {
    let address = fs::read_to_string(file("four-bar.pmks-plus.txt")).unwrap();
    let address = address.trim();
    let text = run_ok(&["import", address]);
    assert!(text.contains("CBE = { from = \"B\""), "{text}");
    assert!(run_ok(&["check", address]).contains("CBE"));
    let packed = refused(2, &["check", "https://app.pmksplus.com/?0.2.2.6.1.R.Y.Y.N"]);
    assert!(packed.contains("packed of version 0"), "{packed}");
    let bare = address.split_once("://").unwrap().1;
    assert_eq!(run_ok(&["import", bare]), text);
    assert!(run_ok(&["check", bare]).contains("CBE"));
    for empty in [
        "https://app.pmksplus.com/",
        "app.pmksplus.com/?j=x",
        "?mech=",
    ] {
        for command in ["import", "check"] {
            let output = refused(2, &[command, empty]);
            assert!(output.contains("this address has no mechanism"), "{output}");
        }
    }
    let other = refused(2, &["check", "https://example.org/linkage"]);
    assert!(other.contains("internet address"), "{other}");
}

/// JSON without a joint of pylinkage is no file of another program. `krank import` says what it
/// lacks.
#[test]
fn other_json_is_named_as_json() {
    let no_lists = "it has no lists `joints` and `links`";
    let no_joint = "the file has no joint with coordinates";
    let no_file = "this is not a file of PMKS";
    for (text, lack) in [
        (r#"{"joints": [], "links": []}"#, no_joint),
        (r#"{"joints": [], "links": [{"id": "r2"}]}"#, no_joint),
        (
            r#"{"joints": [{"name": "A", "x": 0, "y": 0}], "links": []}"#,
            no_joint,
        ),
        (r#"{"joints": {}, "links": []}"#, no_lists),
        (r#"{"mechanism": {"joints": [], "links": []}}"#, no_lists),
        (r#"{"a": 1}"#, no_lists),
        ("{}", no_lists),
        ("{", "the JSON is invalid"),
        ("[]", no_file),
        ("[[]]", no_file),
        ("[ ]\n", no_file),
        ("[\n  [0, 0],\n  [100, 0]\n]\n", no_file),
        ("[{\"a\": 1}]", no_file),
        (r#"["A", "B"]"#, no_file),
    ] {
        let path = folder("import").join("other.json");
        fs::write(&path, text).unwrap();
        let path = path.to_str().unwrap();
        let checked = refused(2, &["check", path]);
        assert!(
            checked.starts_with("error: this is JSON, not TOML\n"),
            "{text}: {checked}"
        );
        let imported = refused(2, &["import", path]);
        assert!(imported.contains(lack), "{text}: {imported}");
    }
    // The headers of tables of a scene.
    for text in ["[ground]\nA = [0, 0]\n", "[\"ab\"] # 1, 2\n"] {
        let path = folder("import").join("header.toml");
        fs::write(&path, text).unwrap();
        let checked = refused(2, &["check", path.to_str().unwrap()]);
        assert!(!checked.contains("JSON"), "{checked}");
    }
}

/// The scene of a file with gears is written, and its fault ends the command with 2.
#[test]
fn a_scene_that_needs_more_is_written_and_explained() {
    let scene = folder("import").join("gears.toml");
    let output = krank(&[
        "import",
        &file("gears.linkage2"),
        "-o",
        scene.to_str().unwrap(),
    ]);
    assert_eq!(output.code, 2, "{}", output.err);
    assert!(
        output.err.contains("krank does not model gears"),
        "{}",
        output.err
    );
    assert!(output.err.contains("error:"), "{}", output.err);
    let text = fs::read_to_string(&scene).unwrap();
    assert!(
        text.contains("krank does not model gears; left out\n"),
        "{text}"
    );
    // A line of the scene is not called one of the file.
    let foreign = refused(2, &["check", &file("gears.linkage2")]);
    assert!(foreign.contains("scene made from "), "{foreign}");
    let printed = krank(&["import", &file("gears.linkage2")]);
    assert!(printed.err.contains("scene made from "), "{}", printed.err);
    // Later commands say the same.
    let later = refused(2, &["check", scene.to_str().unwrap()]);
    assert!(output.err.ends_with(&later), "{later}\n{}", output.err);
}

#[test]
fn import_refuses_what_it_cannot_read() {
    let press = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/press.toml");
    let output = refused(2, &["import", press]);
    assert!(output.contains("not a file of PMKS"), "{output}");
    let output = refused(2, &["import", "missing.linkage2"]);
    assert!(output.contains("missing.linkage2"), "{output}");
    // The file is not replaced by its scene.
    let copy = folder("import").join("same.linkage2");
    fs::copy(file("four-bar.linkage2"), &copy).unwrap();
    let copy = copy.to_str().unwrap();
    refused(2, &["import", copy, "-o", copy]);
    assert_eq!(
        fs::read(copy).unwrap(),
        fs::read(file("four-bar.linkage2")).unwrap()
    );
    let large = folder("import").join("large.linkage2");
    fs::write(&large, format!("<linkage2>{}", " ".repeat(1 << 20))).unwrap();
    let output = refused(2, &["import", large.to_str().unwrap()]);
    assert!(output.contains("too large"), "{output}");
}

/// The workbench never saves over the file of another program: the scene is a new one.
#[cfg(feature = "tui")]
#[test]
fn workbench_opens_a_file_as_a_new_scene() {
    let screen = run_ok(&[&file("four-bar.pmks.txt"), "--print", "--size", "100x30"]);
    assert!(screen.contains("four-bar.pmks"), "{screen}");
    assert!(!screen.contains("four-bar.pmks.txt"), "{screen}");
}

#[test]
fn turkish_remarks_are_turkish() {
    let output = krank(&["--language", "tr", "import", &file("gears.pmks.txt")]);
    assert!(
        output.err.contains("dislileri modellemez"),
        "{}",
        output.err
    );
    assert!(
        output.out.contains("PMKS programının bir dosyasından"),
        "{}",
        output.out
    );
}
