//! Tests of `krank draw`: pictures in characters and as SVG.

use super::{PARALLEL_CRANKS, command, folder, json, krank, presets, refused, run, run_ok};

#[test]
fn picture_has_requested_size_and_is_ascii_in_c_locale() {
    let usual = run_ok(&["draw", "four-bar", "--at", "60"]);
    assert_eq!(usual.lines().count(), 24, "{usual}");
    assert!(usual.is_ascii(), "{usual}");
    assert!(usual.contains("/_\\") && usual.contains('C'), "{usual}");
    for (size, cols, rows) in [("120x40", 120, 40), ("40x12", 40, 12), ("1x1", 1, 1)] {
        let picture = run_ok(&["draw", "four-bar", "--size", size]);
        assert_eq!(picture.lines().count(), rows, "{picture}");
        assert!(picture.lines().all(|line| line.chars().count() <= cols));
    }
    let small = run_ok(&["draw", "four-bar", "--size", "60x20", "--velocities"]);
    assert_eq!(
        small.lines().count(),
        20,
        "the legend is a part of it\n{small}"
    );
}

/// Another program would not open characters in a file that is called a PDF.
#[test]
fn unknown_extension_of_a_picture_is_refused() {
    for (command, columns) in [("draw", &[][..]), ("plot", &["--columns", "C.x"][..])] {
        let file = folder("unknown-extension").join(format!("{command}.pdf"));
        let args = [
            &[command, "four-bar", "-o", file.to_str().unwrap()],
            columns,
        ]
        .concat();
        let _ = std::fs::remove_file(&file);
        let message = refused(2, &args);
        let expected = "extension .pdf; use .txt, .svg";
        assert!(message.contains(expected), "{message}");
        assert!(!file.exists());
        assert_eq!(run_ok(&[&args[..], &["--format", "text"]].concat()), "");
        assert!(file.exists());
    }
    let file = folder("unknown-extension").join("turn.cast");
    run_ok(&["draw", "four-bar", "-o", file.to_str().unwrap()]);
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .starts_with("{\"version\"")
    );
}

#[test]
fn locale_or_option_selects_glyphs() {
    let drawn = |glyphs: &str| run_ok(&["draw", "four-bar", "--glyphs", glyphs]);
    assert_eq!(drawn("auto"), drawn("ascii"));
    assert!(drawn("line").contains('\u{2502}'));
    let is_dots = |text: &str| text.chars().any(|c| ('\u{2801}'..='\u{28ff}').contains(&c));
    assert!(is_dots(&drawn("braille")) && !is_dots(&drawn("line")));
    let mut command = command(&["draw", "four-bar"]);
    let utf8 = run(command.env("LC_ALL", "C.UTF-8").env("TERM", "xterm")).out;
    assert!(is_dots(&utf8), "{utf8}");
}

#[test]
fn layer_options_change_picture_and_legend() {
    let picture = run_ok(&["draw", "four-bar", "--velocities", "--accelerations", "C"]);
    let legend = picture.lines().last().unwrap();
    assert!(legend.starts_with("v 500 mm/s = --"), "{legend}");
    assert!(legend.contains("   a 10000 mm/s^2 = "), "{legend}");
    // The scene names its traced point.
    let plain = run_ok(&["draw", "hoecken", "--traces", "none"]);
    let traced = run_ok(&["draw", "hoecken", "--traces"]);
    assert_eq!(traced, run_ok(&["draw", "hoecken", "--traces", "P"]));
    assert_eq!(traced, run_ok(&["draw", "hoecken"]));
    assert_ne!(traced, plain);
    assert!(traced.contains("......"), "{traced}");
    let all = run_ok(&["draw", "hoecken", "--traces", "all"]);
    assert_eq!(all, run_ok(&["draw", "hoecken", "--traces", "B,C,P"]));
    assert_ne!(all, traced);
    assert_ne!(run_ok(&["draw", "hoecken", "--ghosts", "5"]), traced);
    let named = |names: &str| run_ok(&["draw", "four-bar", "--names", names]);
    assert!(named("all").contains("r3") && !named("points").contains("r3"));
    assert!(!named("none").contains('C'));
    let free = run_ok(&["draw", "four-bar", "--no-guides"]);
    assert!(!free.contains("/_\\"), "{free}");
    assert!(run_ok(&["draw", "four-bar", "--centres"]).contains('x'));
    let loaded = run_ok(&["draw", "four-bar-load", "--forces", "--size", "100x34"]);
    assert!(
        loaded.contains("500 N") && loaded.contains("F 200 N = "),
        "{loaded}"
    );
}

#[test]
fn svg_is_printed_or_written_to_a_file() {
    let file = folder("draw").join("leg.svg");
    let path = file.to_str().unwrap();
    let args = ["draw", "jansen-leg", "--traces", "T", "--ghosts", "4"];
    let svg = run_ok(&[&args[..], &["--format", "svg"]].concat());
    assert!(
        svg.starts_with("<svg xmlns=") && svg.ends_with("</svg>\n"),
        "{svg}"
    );
    assert!(
        svg.contains("<title>Jansen's walking leg at 60 deg</title>"),
        "{svg}"
    );
    assert!(
        svg.contains("class=\"trace\"") && svg.contains(">T</text>"),
        "{svg}"
    );
    assert_eq!(
        run_ok(&[&args[..], &["--format", "svg", "-o", path]].concat()),
        ""
    );
    assert_eq!(std::fs::read_to_string(&file).unwrap(), svg);
    let sized = run_ok(&["draw", "four-bar", "--format", "svg", "--size", "50x20"]);
    assert!(sized.contains("width=\"400\" height=\"320\""), "{sized}");
}

#[test]
fn extension_of_output_file_selects_format() {
    let folder = folder("extensions");
    let written = |command: &str, name: &str| {
        let path = folder.join(name);
        let words = command.split(' ').chain(["-o", path.to_str().unwrap()]);
        run_ok(&words.collect::<Vec<_>>());
        std::fs::read_to_string(&path).unwrap()
    };
    for (command, name, start) in [
        ("draw four-bar", "a.svg", "<svg"),
        ("draw four-bar", "A.SVG", "<svg"),
        ("draw four-bar --traces", "a.dxf", "0\nSECTION"),
        ("plot four-bar --columns C.vx", "p.svg", "<svg"),
        ("sweep four-bar --step 90", "s.json", "{"),
        ("table four-bar", "t.csv", "name,value"),
        ("explain four-bar", "e.md", "# "),
        ("export four-bar", "e.py", "#!"),
    ] {
        let text = written(command, name);
        assert!(
            text.trim_start().starts_with(start),
            "{command} {name}: {text:.80}"
        );
    }
    // An option precedes the extension, and other extensions have no effect.
    let text = run_ok(&["draw", "four-bar", "--glyphs", "ascii"]);
    assert_eq!(
        written("draw four-bar --glyphs ascii --format text", "b.svg"),
        text
    );
    assert_eq!(written("draw four-bar --glyphs ascii", "b.txt"), text);
    // `solve` writes a scene.
    let solve = "solve slider-crank --vary r2.length --goal r4.length.stroke=13";
    assert!(written(solve, "found.json").contains("[links]"));
}

/// The title of a scene is untrusted text.
#[test]
fn svg_escapes_markup_in_scene_title() {
    let hostile = PARALLEL_CRANKS.replace(
        "Three parallel cranks",
        "</title><script>1</script>\\u001B[2J&",
    );
    let mut command = command(&["draw", "-", "--format", "svg"]);
    let output = run(command.write_stdin(hostile));
    assert_eq!(output.code, 0, "{}", output.err);
    let title =
        "<title>&lt;/title&gt;&lt;script&gt;1&lt;/script&gt;\u{fffd}[2J&amp; at 60 deg</title>";
    assert!(output.out.contains(title), "{}", output.out);
    assert!(!output.out.contains("<script>") && !output.out.contains('\u{1b}'));
}

#[test]
fn every_preset_draws_as_text_and_svg() {
    for preset in presets() {
        let everything = [
            "draw",
            &preset,
            "--traces",
            "--velocities",
            "--accelerations",
            "--ghosts",
            "4",
            "--names",
            "all",
            "--centres",
        ];
        let picture = run_ok(&everything);
        assert!(picture.is_ascii() && picture.contains('o'), "{picture}");
        let svg = run_ok(&[&everything[..], &["--format", "svg"]].concat());
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{preset}");
    }
}

#[test]
fn position_without_assembly_fails_as_in_table() {
    let args = |command| [command, "double-rocker", "--at", "5"];
    assert_eq!(refused(1, &args("draw")), refused(1, &args("table")));
    // At a limit, the picture has no arrows, and a note gives the reason.
    let facts = json(&run_ok(&["check", "double-rocker", "--format", "json"]));
    let limit = facts["range"][0].to_string();
    let output = krank(&["draw", "double-rocker", "--at", &limit, "--velocities"]);
    assert_eq!(output.code, 0);
    assert_eq!(
        output.err,
        "note: no arrows: velocities and accelerations do not exist at a dead point\n"
    );
    assert!(output.out.contains("/_\\"), "{}", output.out);
}

#[test]
fn assembly_option_changes_the_picture() {
    let open = run_ok(&["draw", "four-bar"]);
    assert_ne!(open, run_ok(&["draw", "four-bar", "--assembly", "C=-"]));
}

#[test]
fn invalid_draw_arguments_are_rejected() {
    for (args, phrase) in [
        (&["draw"][..], "<SCENE>"),
        (&["draw", "four-bar", "--size", "80"], "columns x rows"),
        (&["draw", "four-bar", "--size", "0x9"], "columns x rows"),
        (&["draw", "four-bar", "--size", "9x99999"], "columns x rows"),
        (&["draw", "four-bar", "--ghosts", "400"], "--ghosts"),
        (&["draw", "four-bar", "--glyphs", "crayon"], "--glyphs"),
        (&["draw", "four-bar", "--format", "csv"], "--format"),
        (
            &["draw", "four-bar", "--traces", "E"],
            "--traces: the scene has no point `E`",
        ),
        (
            &["draw", "press", "--velocities", "b"],
            "--velocities: the scene has no point `b`; ",
        ),
    ] {
        let message = refused(2, args);
        assert!(message.contains(phrase), "{args:?}: {message}");
    }
}

#[test]
fn unwritable_output_file_exits_with_1() {
    let message = refused(1, &["draw", "four-bar", "-o", "/no/such/folder/x.svg"]);
    assert!(
        message.contains("cannot write `/no/such/folder/x.svg`"),
        "{message}"
    );
}
