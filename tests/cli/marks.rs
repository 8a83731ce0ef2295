//! Tests of `[marks]`: points that appear in drawings, but in no table and no count.

use super::{folder, refused, run_ok};
use std::fs;

const MARKED: &str = r#"
name = "Marked"
unit = "mm"
[ground]
A = [0, 0]
D = [40, 0]
[marks]
T1 = [10, 30]
T2 = ["10 + 5", 35]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 15 }
r3 = { from = "B", to = "C", length = 35 }
r4 = { from = "C", to = "D", length = 30 }
[start]
C = [38, 30]
"#;

fn scene(name: &str, text: &str) -> String {
    let path = folder("marks").join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn marks_are_drawn_but_not_listed_in_tables() {
    let marked = scene("marked.toml", MARKED);
    let plain = MARKED.replace("[marks]\nT1 = [10, 30]\nT2 = [\"10 + 5\", 35]\n", "");
    let plain = scene("bare.toml", &plain);
    let drawn = run_ok(&["draw", &marked]);
    assert!(drawn.contains("T1") && drawn.contains("T2"), "{drawn}");
    // All results are the same without the marks.
    for args in [
        &["check"][..],
        &["table", "--at", "60"],
        &["table", "--at", "60", "--format", "json"],
        &["sweep", "--step", "30"],
    ] {
        let of = |scene: &str| {
            let mut args = args.to_vec();
            args.insert(1, scene);
            run_ok(&args).replace("marked", "bare")
        };
        let output = of(&marked);
        assert!(!output.contains("T1"), "{args:?}\n{output}");
        assert_eq!(output, of(&plain), "{args:?}");
    }
    // A mark can be named as a column.
    let column = run_ok(&["sweep", &marked, "--step", "180", "--columns", "T2.x"]);
    assert!(column.lines().nth(1).unwrap().contains(",15,"), "{column}");
}

#[test]
fn invalid_marks_are_rejected() {
    let twice = scene("twice.toml", &MARKED.replace("T2 =", "A ="));
    let message = refused(2, &["check", &twice]);
    assert!(message.contains("`A`"), "{message}");
    let nan = scene("nan.toml", &MARKED.replace("[10, 30]", "[10, nan]"));
    let message = refused(2, &["check", &nan]);
    assert!(message.contains("finite"), "{message}");
    let no_table = MARKED.replace("[marks]\nT1 = [10, 30]\nT2 = [\"10 + 5\", 35]\n", "");
    let no_table = scene("no-table.toml", &format!("marks = 3\n{no_table}"));
    let message = refused(2, &["check", &no_table]);
    assert!(message.contains("[marks]"), "{message}");
}
