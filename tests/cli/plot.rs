//! Tests of `plot`: output, x axis and rejected arguments.

use super::{Run, folder, krank, refused, run_ok};

fn plot(args: &[&str]) -> String {
    run_ok(&[&["plot"], args].concat())
}

#[test]
fn plot_has_requested_size_and_is_ascii_in_c_locale() {
    let text = plot(&["four-bar", "--columns", "C.vx,r4.omega"]);
    assert_eq!(text.lines().count(), 24);
    assert!(
        text.lines().all(|line| line.len() <= 80) && text.is_ascii(),
        "{text}"
    );
    for part in [
        "mm/s",
        "rad/s",
        "* C.vx",
        "* r4.omega",
        "over driver.angle",
        "deg  360",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let small = plot(&["four-bar", "--columns", "C.vx", "--size", "40x12"]);
    assert_eq!(small.lines().count(), 12);
    assert!(small.lines().all(|line| line.len() <= 40));
}

#[test]
fn extrema_show_solved_values_unless_disabled() {
    // The slider-crank is in line: dead centres at 0 and 180 deg, 30 and 10 cm from the pivot.
    let args = [
        "slider-crank",
        "--columns",
        "C.x",
        "--from",
        "-90",
        "--to",
        "270",
    ];
    let text = plot(&args);
    assert!(
        text.contains("30.000 at 0.00") && text.contains("10.000 at 180.00"),
        "{text}"
    );
    let plain = plot(&[&args[..], &["--no-extrema"]].concat());
    assert!(!plain.contains(" at "), "{plain}");
}

#[test]
fn x_axis_can_be_time_or_another_column() {
    let text = plot(&["four-bar", "--columns", "r4.omega", "--against", "time"]);
    assert!(
        text.contains("over time") && text.contains(" s\n"),
        "{text}"
    );
    let phase = plot(&["slider-crank", "--columns", "C.vx", "--against", "C.x"]);
    assert!(
        phase.contains("over C.x") && phase.contains("* C.vx"),
        "{phase}"
    );
}

#[test]
fn glyphs_option_selects_characters() {
    let with = |glyphs| plot(&["four-bar", "--columns", "C.vx", "--glyphs", glyphs]);
    assert!(with("ascii").is_ascii() && with("auto").is_ascii());
    assert!(with("line").contains('\u{2510}'));
    let braille = |c: char| ('\u{2800}'..='\u{28ff}').contains(&c);
    assert!(with("braille").chars().any(braille));
}

#[test]
fn svg_is_written_to_a_file() {
    let file = folder("plot").join("plot.svg");
    let path = file.to_str().unwrap();
    let out = plot(&[
        "hoecken",
        "--columns",
        "P.y",
        "--against",
        "P.x",
        "--format",
        "svg",
        "-o",
        path,
    ]);
    assert_eq!(out, "");
    let text = std::fs::read_to_string(file).unwrap();
    assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
    assert!(
        text.contains(">P.y<") && text.contains("P.x [mm]"),
        "{text}"
    );
}

#[test]
fn invalid_plot_arguments_are_rejected_with_a_fix() {
    let columns = |columns| refused(2, &["plot", "four-bar", "--columns", columns]);
    assert!(columns("C.z").contains("`C.x`") || columns("C.z").contains("C.y"));
    assert!(columns("state").contains("--columns"));
    let base = ["plot", "four-bar", "--columns", "C.x"];
    let with = |more: &[&str]| refused(2, &[&base[..], more].concat());
    assert!(with(&["--against", "C.*"]).contains("names 6 quantities"));
    assert!(with(&["--against", "C.q"]).contains("--against"));
    assert!(with(&["--from", "5", "--to", "5"]).contains("both 5"));
    assert!(with(&["--size", "10x3"]).contains("too small"));
    assert!(with(&["--size", "80"]).contains("80x24"));
    assert!(refused(2, &["plot", "four-bar"]).contains("--columns"));
}

#[test]
fn range_outside_motion_gives_a_note_or_exits_with_1() {
    let args = ["plot", "double-rocker", "--columns", "C.x", "--from"];
    let outside = |from, to| krank(&[&args[..], &[from, "--to", to]].concat());
    let Run { code, out, err } = outside("0", "360");
    assert_eq!(code, 0, "{err}");
    assert!(
        err.contains("part of the plot is outside the motion"),
        "{err}"
    );
    assert!(out.contains("C.x"));
    let Run { code, out, err } = outside("100000", "100001");
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("the driver covers"), "{err}");
}
