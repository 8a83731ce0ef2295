//! Tests of `report`: the working as a hand-in document, in four formats.

use super::{command, folder, krank, refused, run, run_ok};

#[test]
fn file_extension_selects_the_format() {
    let here = folder("report");
    for (name, starts) in [
        ("a.html", "<!DOCTYPE html>\n"),
        ("a.TEX", "\\documentclass[a4paper,11pt]{article}\n"),
        ("a.md", "# Four-bar crank-rocker\n"),
        ("a.txt", "Four-bar crank-rocker\n---"),
        ("a", "<!DOCTYPE html>\n"),
    ] {
        let file = here.join(name);
        assert_eq!(
            run_ok(&["report", "four-bar", "-o", file.to_str().unwrap()]),
            ""
        );
        let written = std::fs::read_to_string(&file).unwrap();
        assert!(written.starts_with(starts), "{name}: {written}");
    }
    let file = here.join("b.html");
    let path = file.to_str().unwrap();
    run_ok(&["report", "four-bar", "--format", "latex", "-o", path]);
    let written = std::fs::read_to_string(&file).unwrap();
    assert!(written.starts_with("\\documentclass"), "{written}");
    assert!(run_ok(&["report", "four-bar"]).starts_with("<!DOCTYPE html>\n"));
}

#[test]
fn text_report_is_ascii_within_80_columns() {
    let text = run_ok(&["report", "press-ram", "--format", "text"]);
    assert!(text.is_ascii(), "{text}");
    let long: Vec<&str> = text.lines().filter(|line| line.len() > 80).collect();
    assert!(long.is_empty(), "{long:#?}");
    for piece in [
        "theta3 = ?",
        "mu(theta) = cos(theta) i + sin(theta) j",
        "\n11 Over the",
    ] {
        assert!(text.contains(piece), "{piece}\n{text}");
    }
}

#[test]
fn options_set_digits_and_driver_angle() {
    let args = [
        "report", "four-bar", "--at", "90", "--digits", "10", "--format", "text",
    ];
    let text = run_ok(&args);
    assert!(text.contains("theta3 = 22.99126939"), "{text}");
    assert!(refused(2, &["report", "four-bar", "--digits", "0"]).contains("1..=17"));
    assert!(refused(2, &["report", "four-bar", "--format", "pdf"]).contains("latex"));
    assert!(refused(2, &["report", "no-such-scene"]).contains("no-such-scene"));
}

#[test]
fn position_outside_range_exits_with_1() {
    let output = krank(&["report", "double-rocker", "--at", "200", "--format", "text"]);
    assert_eq!(output.code, 1);
    assert!(output.out.contains("State: no-assembly."), "{}", output.out);
    let text = "cannot be assembled at 200 deg";
    assert!(output.err.contains(text), "{}", output.err);
}

#[test]
fn markdown_contains_text_pictures() {
    let mut utf8 = command(&["report", "four-bar", "--format", "markdown"]);
    utf8.env("LC_ALL", "en_US.UTF-8")
        .env("TERM", "xterm-256color");
    let output = run(&mut utf8);
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    assert_eq!(output.out.matches("```").count() % 2, 0);
    for piece in [
        "| θ \\[deg\\] | 180 | 60 | θ3 = ? | θ4 = ? |",
        "```text\n",
        "  /_\\",
    ] {
        assert!(output.out.contains(piece), "{piece}\n{}", output.out);
    }
}

/// The values printed in the lecture, with their units and decimal commas, are compared with the exact ones.
#[test]
fn printed_values_are_compared_with_computed_ones() {
    let here = folder("report-against");
    let file = here.join("notes.csv");
    let printed = "figure;unit;value\nr3.angle;deg;29,3795\nr3.omega;rd/s;-3,916\nr4.alpha;rad/s²;95,5\n\
        C.a;mm/s^2;23994,18\nC.a.t;m/s2;23,875\nB.a;mm/s;22500\nnothing;mm;3\n";
    std::fs::write(&file, printed).unwrap();
    let path = file.to_str().unwrap();
    let of = |language: &str| {
        run_ok(&[
            "report",
            "four-bar",
            "--at",
            "60",
            "--against",
            path,
            "--format",
            "text",
            "--language",
            language,
        ])
    };
    let text = of("en");
    let (_, nearby) = text.split_once(" Comparison with notes.csv\n").unwrap();
    let row = |name: &str| -> Vec<&str> {
        let line = nearby.lines().find(|line| line.starts_with(name)).unwrap();
        line.split_whitespace().collect()
    };
    assert_eq!(
        row("r3.angle")[2..],
        ["29.3794", "29,3795", "0.0000522", "-"]
    );
    assert_eq!(
        row("r3.omega")[2..],
        ["-3.91641", "-3,916", "rd/s", "agrees", "-"]
    );
    assert_eq!(
        row("C.a ")[2..],
        ["23995.1", "23994,18", "-0.913", "-3.8e-5"]
    );
    assert_eq!(
        row("C.a.t")[2..],
        ["23875.9", "23,875", "m/s2", "-0.902", "-3.8e-5"]
    );
    // A value with a wrong unit and an unknown name are listed.
    assert!(
        nearby
            .replace('\n', " ")
            .contains("not in this unit: B.a, nothing."),
        "{nearby}"
    );
    assert!(of("tr").contains("notes.csv ile"), "{}", of("tr"));
    std::fs::write(&file, "no figures\n").unwrap();
    let args = ["report", "four-bar", "--against", path];
    assert!(refused(2, &args).contains("has no values"));
}

/// For the output of another program over the motion, the report has the largest difference of each
/// column and its position.
#[test]
fn motion_file_is_compared_column_by_column() {
    let here = folder("report-course");
    let file = here.join("motion.csv");
    let path = file.to_str().unwrap();
    let columns = "C.x,r3.angle,r4.omega";
    run_ok(&[
        "sweep",
        "four-bar",
        "--step",
        "10",
        "--columns",
        columns,
        "-o",
        path,
    ]);
    let of = || {
        let args = ["report", "four-bar", "--against", path, "--format", "text"];
        let text = run_ok(&args);
        let (_, nearby) = text.split_once(" Comparison with motion.csv\n").unwrap();
        nearby.to_owned()
    };
    let row = |text: &str, name: &str| -> Vec<String> {
        let line = text.lines().find(|line| line.starts_with(name)).unwrap();
        line.split_whitespace().map(str::to_owned).collect()
    };
    assert_eq!(row(&of(), "C.x")[2..], ["37", "0", "0", "-", "-", "0"]);
    let given = std::fs::read_to_string(&file).unwrap();
    let changed: Vec<String> = given
        .lines()
        .map(|line| match line.strip_prefix("120,") {
            Some(rest) => {
                let cells: Vec<&str> = rest.split(',').collect();
                let off: f64 = cells[0].parse::<f64>().unwrap() + 0.5;
                let turned: f64 = cells[1].parse::<f64>().unwrap() - 360.0;
                format!("120,{off},{turned},{}", cells[2..].join(","))
            }
            None => line.to_owned(),
        })
        .collect();
    std::fs::write(&file, changed.join("\n")).unwrap();
    let text = of();
    let off = row(&text, "C.x");
    // One of 37 rows is off: the root mean square is 0.5 / sqrt(37).
    assert_eq!(off[2..6], ["37", "0.0822", "0.500", "120.000"], "{text}");
    assert_eq!(off[7], "1", "{text}");
    // Angles that differ by a whole turn are equal.
    assert_eq!(row(&text, "r3.angle")[7], "0", "{text}");
    // A column in turns is not taken for degrees.
    let turns = given.replacen("[deg]", "[turns]", 1);
    std::fs::write(&file, turns).unwrap();
    let text = of().replace('\n', " ");
    assert!(
        text.contains("over 0 rows") && text.contains("unit: driver.angle"),
        "{text}"
    );
}

/// Each document uses one notation of unit vectors and defines it.
#[test]
fn notation_option_sets_unit_vectors() {
    let of = |command: &str, notation: &str| {
        let format = ["--format", "text"];
        run_ok(&[&[command, "four-bar", "--notation", notation], &format[..]].concat())
    };
    for command in ["explain", "report"] {
        let [lecture, own] = ["lecture", "krank"].map(|notation| of(command, notation));
        for (text, has, has_not) in [
            (
                &lecture,
                ["mu(theta4)", "nu(theta3)"],
                [" u(theta", " n(theta"],
            ),
            (&own, ["u(theta4)", "n(theta3)"], [" mu(theta", " nu(theta"]),
        ] {
            for piece in has {
                assert!(
                    text.contains(&format!(" {piece}")),
                    "{command}: {piece}\n{text}"
                );
            }
            for piece in has_not {
                assert!(!text.contains(piece), "{command}: {piece}\n{text}");
            }
        }
    }
    assert_eq!(run_ok(&["explain", "four-bar"]), of("explain", "krank"));
    assert_eq!(
        run_ok(&["report", "four-bar", "--format", "text"]),
        of("report", "lecture")
    );
    assert!(of("report", "krank").contains("dn/dt = -omega u(theta)"));
    // Mu denotes only the unit vector.
    assert!(!of("report", "lecture").contains("sin mu"));
    assert!(refused(2, &["explain", "four-bar", "--notation", "greek"]).contains("lecture"));
}

/// The report contains the values of the notes in both languages, to nine digits.
#[test]
fn report_has_the_values_of_the_notes_in_both_languages() {
    let figures = [
        (
            "four-bar",
            &[
                "360.555128",
                "13.8978862",
                "43.2773340",
                "55.3495925",
                "29.3794478",
                "290.752521",
                "-3.91641273",
                "3.09107322",
                "42.2670183",
                "95.5036084",
                "23875.9021",
                "2388.68341",
                "23995.0934",
                "206.465712",
                "84.2868095",
                "22260.2239",
                "222.677773",
                "11997.5467",
            ][..],
        ),
        (
            "slider-crank",
            &[
                "28.0251708",
                "-14.4775122",
                "345.522488",
                "-89.4427191",
                "-1447.21360",
                "8262.36447",
                "-460017.673",
            ],
        ),
    ];
    for (scene, figures) in figures {
        for language in ["en", "tr"] {
            let text = run_ok(&[
                "report",
                scene,
                "--format",
                "text",
                "--digits",
                "9",
                "--language",
                language,
            ]);
            for figure in figures {
                assert!(
                    text.contains(figure),
                    "{scene} in {language}: {figure}\n{text}"
                );
            }
            for piece in ["  A = ", "  B = ", " = 0\n", "I_r3"] {
                assert!(text.contains(piece), "{scene} in {language}: {piece}");
            }
        }
    }
}

/// An unknown extension would not match the content of the file.
#[test]
fn unknown_file_extension_is_rejected() {
    let here = folder("report-ending");
    let file = here.join("four-bar.pdf");
    let _ = std::fs::remove_file(&file);
    let path = file.to_str().unwrap();
    let text = refused(2, &["report", "four-bar", "-o", path]);
    assert!(text.contains(".pdf") && text.contains(".tex"), "{text}");
    assert!(!file.exists());
    run_ok(&["report", "four-bar", "--format", "text", "-o", path]);
    assert!(file.exists());
}

#[test]
fn extensions_of_other_formats_are_rejected() {
    let here = folder("foreign-ending");
    for (command, ending, format) in [
        ("table", "xlsx", "csv"),
        ("sweep", "svg", "json"),
        ("cycle", "docx", "text"),
        ("check", "PDF", "json"),
        ("explain", "html", "markdown"),
    ] {
        let file = here.join(format!("{command}.{ending}"));
        let _ = std::fs::remove_file(&file);
        let path = file.to_str().unwrap();
        let text = refused(2, &[command, "four-bar", "-o", path]);
        assert!(text.contains(&ending.to_lowercase()), "{text}");
        assert!(!file.exists());
        run_ok(&[command, "four-bar", "--format", format, "-o", path]);
        assert!(file.exists());
    }
}

#[test]
fn output_does_not_overwrite_the_compared_file() {
    let here = folder("report-over");
    let file = here.join("notes.csv");
    let figures = "figure;unit;value\nr3.angle;deg;29,3795\n";
    std::fs::write(&file, figures).unwrap();
    let path = file.to_str().unwrap();
    let args = [
        "report",
        "four-bar",
        "--against",
        path,
        "--format",
        "html",
        "-o",
        path,
    ];
    assert!(refused(2, &args).contains("would be lost"));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), figures);
}
