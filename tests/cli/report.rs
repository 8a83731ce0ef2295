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
        "\n10 Over the",
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
