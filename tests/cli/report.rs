//! `report`: the working as it is handed in, in four formats.

use super::{command, done, folder, krank, refused, run};

#[test]
fn the_ending_of_the_file_chooses_the_format() {
    let here = folder("report");
    for (name, begins) in [
        ("a.html", "<!DOCTYPE html>\n"),
        ("a.TEX", "\\documentclass[a4paper,11pt]{article}\n"),
        ("a.md", "# Four-bar crank-rocker\n"),
        ("a.txt", "Four-bar crank-rocker\n---"),
        ("a", "<!DOCTYPE html>\n"),
    ] {
        let file = here.join(name);
        assert_eq!(
            done(&["report", "four-bar", "-o", file.to_str().unwrap()]),
            ""
        );
        let written = std::fs::read_to_string(&file).unwrap();
        assert!(written.starts_with(begins), "{name}: {written}");
    }
    let file = here.join("b.html");
    let path = file.to_str().unwrap();
    done(&["report", "four-bar", "--format", "latex", "-o", path]);
    let written = std::fs::read_to_string(&file).unwrap();
    assert!(written.starts_with("\\documentclass"), "{written}");
    assert!(done(&["report", "four-bar"]).starts_with("<!DOCTYPE html>\n"));
}

#[test]
fn as_text_it_is_what_a_plain_terminal_shows() {
    let text = done(&["report", "press-ram", "--format", "text"]);
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
fn digits_and_places_are_as_asked() {
    let args = [
        "report", "four-bar", "--at", "90", "--digits", "10", "--format", "text",
    ];
    let text = done(&args);
    assert!(text.contains("theta3 = 22.99126939"), "{text}");
    assert!(refused(2, &["report", "four-bar", "--digits", "0"]).contains("1..=17"));
    assert!(refused(2, &["report", "four-bar", "--format", "pdf"]).contains("latex"));
    assert!(refused(2, &["report", "no-such-scene"]).contains("no-such-scene"));
}

#[test]
fn outside_the_range_the_code_is_1_as_that_of_the_working() {
    let heard = krank(&["report", "double-rocker", "--at", "200", "--format", "text"]);
    assert_eq!(heard.code, 1);
    assert!(heard.out.contains("State: no-assembly."), "{}", heard.out);
    let said = "cannot be assembled at 200 deg";
    assert!(heard.err.contains(said), "{}", heard.err);
}

#[test]
fn markdown_has_its_pictures_in_characters() {
    let mut utf8 = command(&["report", "four-bar", "--format", "markdown"]);
    utf8.env("LC_ALL", "en_US.UTF-8")
        .env("TERM", "xterm-256color");
    let heard = run(&mut utf8);
    assert_eq!((heard.code, heard.err.as_str()), (0, ""));
    assert_eq!(heard.out.matches("```").count() % 2, 0);
    for piece in [
        "| θ \\[deg\\] | 180 | 60 | θ3 = ? | θ4 = ? |",
        "```text\n",
        "  /_\\",
    ] {
        assert!(heard.out.contains(piece), "{piece}\n{}", heard.out);
    }
}

/// One document has one way to write unit vectors, and defines it.
#[test]
fn the_notation_is_as_asked() {
    let of = |command: &str, notation: &str| {
        let format = ["--format", "text"];
        done(&[&[command, "four-bar", "--notation", notation], &format[..]].concat())
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
    assert_eq!(done(&["explain", "four-bar"]), of("explain", "krank"));
    assert_eq!(
        done(&["report", "four-bar", "--format", "text"]),
        of("report", "lecture")
    );
    assert!(of("report", "krank").contains("dn/dt = -omega u(theta)"));
    // Mu is the unit vector alone.
    assert!(!of("report", "lecture").contains("sin mu"));
    assert!(refused(2, &["explain", "four-bar", "--notation", "greek"]).contains("lecture"));
}

/// What the notes print stands in the report of either language, to its nine digits.
#[test]
fn the_figures_of_the_notes_stand_in_both_languages() {
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
            let text = done(&[
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
