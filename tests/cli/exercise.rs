//! Tests of `exercise` and `grade`: sheets are created, and answers are graded.

use super::{folder, krank, refused, rows, run_ok};
use std::fs;
use std::path::{Path, PathBuf};

fn fresh(name: &str) -> PathBuf {
    let here = folder(name);
    fs::remove_dir_all(&here).unwrap();
    fs::create_dir_all(&here).unwrap();
    here
}

fn shown(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// Returns the value of a column at a driver coordinate, with six digits.
fn exact(scene: &Path, at: &str, column: &str) -> String {
    let args = [
        "sweep",
        shown(scene),
        "--columns",
        column,
        "--from",
        at,
        "--to",
        at,
        "--step",
        "1",
    ];
    let csv = run_ok(&args);
    let value: f64 = rows(&csv)[0][1].parse().unwrap();
    format!("{value:.5e}")
}

/// Returns the initial driver angle of an exercise.
fn angle(scene: &str) -> &str {
    let mut lines = scene.lines();
    lines
        .find_map(|line| line.strip_prefix("angle = "))
        .unwrap()
}

#[test]
fn sheet_is_determined_by_its_seed() {
    let sheet = run_ok(&["exercise", "four-bar", "--seed", "7"]);
    assert_eq!(sheet, run_ok(&["exercise", "four-bar", "--seed", "7"]));
    assert_ne!(sheet, run_ok(&["exercise", "four-bar", "--seed", "8"]));
    for piece in [
        "Four-bar crank-rocker: exercise 7",
        "theta3 = ?",
        "four-bar-7.csv",
        "Number:",
    ] {
        assert!(sheet.contains(piece), "{piece}\n{sheet}");
    }
    assert!(run_ok(&["exercise", "press", "--format", "html"]).starts_with("<!DOCTYPE html>\n"));
    let turkish = run_ok(&["exercise", "slider-crank", "--language", "tr"]);
    assert!(
        turkish.contains("Verilenler") && turkish.is_ascii(),
        "{turkish}"
    );
    // Titles of presets are translated.
    assert!(turkish.contains("Krank-biyel, eksende: odev"), "{turkish}");
}

#[test]
fn exercise_writes_four_files_and_keeps_answers() {
    let here = fresh("exercise");
    let path = shown(&here);
    assert_eq!(
        run_ok(&[
            "exercise", "press", "--seed", "3", "--count", "2", "-o", path
        ]),
        ""
    );
    let mut names: Vec<String> = fs::read_dir(&here)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let expected = [3, 4].map(|n| {
        let endings = ["-solution.html", ".csv", ".html", ".toml"];
        endings.map(|end| format!("press-{n}{end}"))
    });
    assert_eq!(names, expected.concat());
    let scene = here.join("press-3.toml");
    assert!(run_ok(&["check", shown(&scene)]).contains("turns fully"));
    let blank = fs::read_to_string(here.join("press-3.csv")).unwrap();
    assert!(
        blank.starts_with("figure,unit,answer\nsheet,,press-3.toml\nstudent,,\nr3.angle,deg,\n"),
        "{blank}"
    );
    let solution = fs::read_to_string(here.join("press-3-solution.html")).unwrap();
    let sheet = fs::read_to_string(here.join("press-3.html")).unwrap();
    let text = fs::read_to_string(&scene).unwrap();
    let exact: f64 = exact(&scene, angle(&text), "r4.alpha").parse().unwrap();
    let exact = exact.abs().to_string();
    assert!(
        solution.contains(&exact) && !sheet.contains(&exact),
        "{exact}"
    );
    // Exercises can be created again while their answer files are empty.
    run_ok(&[
        "exercise",
        "press",
        "--seed",
        "3",
        "--decimal",
        "comma",
        "-o",
        path,
    ]);
    let blank = fs::read_to_string(here.join("press-3.csv")).unwrap();
    assert!(blank.starts_with("figure;unit;answer\n"), "{blank}");
    fs::write(
        here.join("press-3.csv"),
        blank.replacen("angle;deg;", "angle;deg;1,5", 1),
    )
    .unwrap();
    let message = refused(
        1,
        &[
            "exercise", "press", "--seed", "2", "--count", "2", "-o", path,
        ],
    );
    assert!(
        message.contains("press-3.csv") && !here.join("press-2.toml").exists(),
        "{message}"
    );
}

#[test]
fn invalid_exercise_arguments_are_rejected() {
    assert!(refused(2, &["exercise", "four-bar", "--count", "2"]).contains("-o DIR"));
    let last = u64::MAX.to_string();
    let here = folder("exercise-seeds");
    let args = [
        "exercise",
        "four-bar",
        "--count",
        "2",
        "--seed",
        &last,
        "-o",
        shown(&here),
    ];
    assert!(refused(2, &args).contains("largest seed"));
    assert!(refused(2, &["exercise", "no-such"]).contains("no-such"));
    assert!(refused(2, &["grade", "four-bar"]).contains("ANSWERS"));
}

/// The answers are the values of the lecture notes, which are rounded in some places.
#[test]
fn grading_detects_early_rounding_and_wrong_sign() {
    let here = fresh("grade-notes");
    let notes = here.join("week4.csv");
    let text = "figure;unit;answer\nr4.length;cm;28,0\nr3.angle;deg;345,5\nr3.omega;rad/s;-89,45\n\
        r4.rate;cm/s;1447,93\nr3.alpha;rad/s^2;8259\nx.y;;1\n";
    fs::write(&notes, text).unwrap();
    let output = run_ok(&["grade", "slider-crank", shown(&notes)]);
    for piece in [
        "week4\n",
        "rounded early: r3.angle as 345,5",
        "wrong sign",
        "4 points of 18: 2 values are right, 2 are right except for rounding",
        "The first difference is r3.omega: rounded early: r3.angle as 345,5.",
        "The first mistake is r4.rate: wrong sign.",
        "Rows that name no value of this scene: x.y [1] in line 7.",
    ] {
        let joined = output.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(joined.contains(piece.trim_end()), "{piece}\n{output}");
    }
    let turkish = run_ok(&["grade", "slider-crank", shown(&notes), "--language", "tr"]);
    assert!(
        turkish.contains("erken yuvarlama: r3.angle = 345,5"),
        "{turkish}"
    );
    let elsewhere = krank(&["grade", "slider-crank", shown(&notes), "--at", "40"]);
    assert_eq!(elsewhere.code, 0);
    assert!(
        !elsewhere.out.contains("rounded early: r3.angle"),
        "{}",
        elsewhere.out
    );
}

/// Values that are zero except for rounding errors are asked for, and 0 is the right answer.
#[test]
fn zero_values_are_asked_and_graded() {
    let here = fresh("exercise-rounding");
    let path = shown(&here);
    run_ok(&["exercise", "parallelogram", "--seed", "4", "-o", path]);
    let blank = fs::read_to_string(here.join("parallelogram-4.csv")).unwrap();
    assert!(
        blank.contains("r3.angle,") && blank.contains("r3.alpha,"),
        "{blank}"
    );
    let sheet = run_ok(&["exercise", "parallelogram", "--seed", "4"]);
    assert!(sheet.contains("alpha3 = ?"), "{sheet}");
    let answers = here.join("answers.csv");
    fs::write(&answers, "α3,,0\n").unwrap();
    let scene = here.join("parallelogram-4.toml");
    let output = run_ok(&["grade", shown(&scene), shown(&answers)]);
    assert!(output.contains("1 points of"), "{output}");
}

/// Spreadsheets write UTF-16 and leave out columns. A file without any answer to the scene is rejected.
#[test]
fn utf16_answers_are_read_and_unrelated_answers_rejected() {
    let here = fresh("grade-files");
    let file = here.join("ali.csv");
    let text = "\u{feff}figure\tanswer\r\nstudent\tAli\r\nr3.angle\t29,38\r\n";
    let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    fs::write(&file, bytes).unwrap();
    let output = run_ok(&["grade", "four-bar", shown(&file)]);
    assert!(
        output.starts_with("Ali\n") && output.contains("1 points of 22"),
        "{output}"
    );
    fs::write(&file, "figure,unit,answer\nx.y,mm,1\nz9.angle,deg,2\n").unwrap();
    let message = refused(2, &["grade", "four-bar", shown(&file)]);
    assert!(
        message.contains("ali.csv") && message.contains("four-bar"),
        "{message}"
    );
}

/// Every file of a class finds its sheet, and an invalid file does not stop the others.
#[test]
fn class_is_graded_into_a_table() {
    let here = fresh("grade-class");
    let class = here.join("class");
    run_ok(&[
        "exercise",
        "four-bar",
        "--seed",
        "1",
        "--count",
        "2",
        "-o",
        shown(&class),
    ]);
    let mut files = Vec::new();
    for (seed, student) in [("1", "Ayse"), ("2", "=Ali")] {
        let scene = class.join(format!("four-bar-{seed}.toml"));
        let text = fs::read_to_string(&scene).unwrap();
        let at = text
            .lines()
            .find_map(|line| line.strip_prefix("angle = "))
            .unwrap();
        let blank = fs::read_to_string(class.join(format!("four-bar-{seed}.csv"))).unwrap();
        let blank = blank.replace("student,,", &format!("student,,{student}"));
        let lines = blank.lines().map(|line| {
            let figure = line.split(',').next().unwrap();
            match figure.contains('.') && (seed == "1" || figure != "r4.angle") {
                true => line.to_owned() + &exact(&scene, at, figure) + "\n",
                false => line.to_owned() + "\n",
            }
        });
        let file = here.join(format!("{student}.csv"));
        fs::write(&file, lines.collect::<String>()).unwrap();
        files.push(file);
    }
    let one = krank(&["grade", shown(&class), shown(&files[0])]);
    assert_eq!((one.code, one.err.as_str()), (0, ""));
    assert!(
        one.out.contains("22 points of 22: 22 values are right"),
        "{}",
        one.out
    );
    let args = [
        "grade",
        shown(&class),
        shown(&files[0]),
        shown(&files[1]),
        "--format",
        "csv",
    ];
    let csv = run_ok(&args);
    let table = rows(&csv);
    let head = "student,sheet,figures,points,right,rounded,followed,sign,unit,assembly,wrong,empty,\
        first,verdict,mistake,why,answer,file,unknown_units,no_numbers,repeated,unknown_rows,\
        encoding,misread\n";
    assert!(csv.starts_with(head), "{csv}");
    assert_eq!(table[0][..5], ["Ayse", "four-bar-1.toml", "22", "22", "22"]);
    // A spreadsheet must not execute a student's name as a formula.
    assert_eq!(
        table[1][..5],
        ["'=Ali", "four-bar-2.toml", "22", "21", "21"]
    );
    assert_eq!(
        table[1][11..18],
        [
            "1",
            "r4.angle",
            "empty",
            "r4.angle",
            "empty",
            "",
            shown(&files[1])
        ]
    );

    let broken = here.join("broken.csv");
    fs::write(&broken, "no answers").unwrap();
    let outside = here.join("outside.csv");
    fs::write(
        &outside,
        "sheet,,../class/four-bar-1.toml\nr3.angle,deg,1\n",
    )
    .unwrap();
    let args = [
        "grade",
        shown(&class),
        shown(&broken),
        shown(&files[0]),
        shown(&outside),
    ];
    let output = krank(&args);
    assert_eq!(output.code, 2);
    for piece in [
        "broken.csv",
        "../class/four-bar-1.toml",
        "2 of 3 files were not graded",
    ] {
        assert!(output.err.contains(piece), "{}", output.err);
    }
    assert!(output.out.contains("Ayse"), "{}", output.out);
    refused(2, &["grade", shown(&class), shown(&broken)]);
    let other = krank(&["grade", "four-bar", shown(&files[0])]);
    assert!(
        other.code == 0 && other.err.contains("four-bar-1.toml"),
        "{}",
        other.err
    );
}

/// Input files are not overwritten, under any name or link.
#[test]
fn grade_does_not_overwrite_its_inputs() {
    let here = fresh("grade-over");
    let class = here.join("class");
    run_ok(&["exercise", "four-bar", "--seed", "1", "-o", shown(&class)]);
    let [sheet, answers] = ["toml", "csv"].map(|end| class.join(format!("four-bar-1.{end}")));
    let other = here.join("other.csv");
    fs::copy(&answers, &other).unwrap();
    let link = here.join("linked.txt");
    std::os::unix::fs::symlink(&other, &link).unwrap();
    let before = [&sheet, &answers, &other].map(|file| fs::read(file).unwrap());
    for (of, to) in [
        (&sheet, &answers),
        (&sheet, &sheet),
        (&sheet, &other),
        (&sheet, &link),
        (&class, &sheet),
        (&class, &other),
    ] {
        let args = [
            "grade",
            shown(of),
            shown(&answers),
            shown(&other),
            "-o",
            shown(to),
        ];
        let text = refused(2, &args);
        assert!(text.contains("would be lost"), "{text}");
        let after = [&sheet, &answers, &other].map(|file| fs::read(file).unwrap());
        assert_eq!(before, after, "{}", to.display());
    }
    let points = here.join("points.txt");
    run_ok(&["grade", shown(&class), shown(&other), "-o", shown(&points)]);
    assert!(fs::read_to_string(points).unwrap().contains("0 points"));
}

/// Answer files that are no longer empty stay unchanged, whatever they contain; so do all other edited files.
#[test]
fn exercise_does_not_overwrite_edited_files() {
    let here = fresh("exercise-lost");
    let make = ["exercise", "four-bar", "--seed", "7", "-o", shown(&here)];
    let again = ["--count", "2", "--seed", "6", "-o", shown(&here)];
    let again = [&["exercise", "four-bar"][..], &again[..]].concat();
    run_ok(&make);
    let file = |end: &str| here.join(format!("four-bar-7{end}"));
    let blank = fs::read_to_string(file(".csv")).unwrap();
    let long = blank.clone() + &"\n".repeat(20) + &"r3.angle,deg,1\n".repeat(10_001);
    let filled = blank.replacen("angle,deg,", "angle,deg,29.4", 1);
    let texts: [(&str, &[u8]); 11] = [
        (".csv", filled.as_bytes()),
        (".csv", long.as_bytes()),
        (".csv", b"r3.angle deg 29.4\nC.v mm/s 12\n"),
        (".csv", b"r3.angle|deg|29.4\n"),
        (".csv", b"\"r3.angle,deg,29.4\nC.v,mm/s,12\n"),
        (".csv", b"r3.angle,\"deg,29.4\nC.v,mm/s,12\n"),
        (".csv", b"Dear Sir. I could not find the crank.\n"),
        (".csv", b"PK\x03\x04\x14\0\x06\0\x08\0\xff\xfe"),
        (".csv", b"figure,unit,answer\nstudent,,Ayse\n"),
        (".toml", b"name = \"mine\"\n"),
        (".html", b"<p>My own sheet.</p>\n"),
    ];
    for (end, text) in texts {
        let before = fs::read(file(end)).unwrap();
        fs::write(file(end), text).unwrap();
        let message = refused(1, &again);
        let name = format!("four-bar-7{end}");
        assert!(
            message.contains(&name) && message.contains("lost"),
            "{message}"
        );
        assert_eq!(fs::read(file(end)).unwrap(), text, "{message}");
        assert!(!here.join("four-bar-6.toml").exists(), "{message}");
        fs::write(file(end), before).unwrap();
    }
    // Spreadsheets save an empty file with other separators, other line ends and additional cells.
    let saved = blank.replace(',', ";").replace('\n', ";;\r\n");
    fs::write(file(".csv"), format!("\u{feff}{saved}")).unwrap();
    run_ok(&again);
    assert_eq!(fs::read_to_string(file(".csv")).unwrap(), blank);
    // Another assembly gives another exercise.
    let other = [&make[..], &["--assembly", "C=-"][..]].concat();
    assert!(refused(1, &other).contains("four-bar-7.toml"));
}

/// The `source` of an exercise is the command that creates it again.
#[test]
fn exercise_records_the_command_that_created_it() {
    let here = fresh("exercise-again");
    let scene = here.join("my bar.toml");
    fs::write(&scene, run_ok(&["start", "four-bar"])).unwrap();
    let args = [
        "exercise",
        shown(&scene),
        "--assembly",
        "C=-",
        "--seed",
        "4",
        "-o",
        shown(&here),
    ];
    run_ok(&args);
    let made = fs::read_to_string(here.join("my bar-4.toml")).unwrap();
    let source = format!(
        "source = \"krank exercise '{}' --assembly C=- --seed 4\"",
        shown(&scene)
    );
    assert!(made.contains(&source), "{made}");
}

#[test]
fn exercise_rejects_scene_without_lengths() {
    let here = fresh("exercise-none");
    let scene = here.join("point.toml");
    let text = "[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 1\n\
        [links]\nr = { points = { A = [0, 0] } }\n";
    fs::write(&scene, text).unwrap();
    let message = refused(1, &["exercise", shown(&scene)]);
    assert!(message.contains("no lengths"), "{message}");
}

/// Each row names its file, a student with several files is reported, and no name contains control characters.
#[test]
fn class_table_names_files_and_duplicate_students() {
    let here = fresh("grade-class-faults");
    let mut files = Vec::new();
    for (file, student) in [
        ("a.csv", "Ayse"),
        ("b.csv", "Ayse"),
        ("c.csv", "\u{1b}[31mAli"),
    ] {
        let path = here.join(file);
        fs::write(&path, format!("student,,{student}\nr3.angle,deg,\u{7}2\n")).unwrap();
        files.push(path);
    }
    let paths: Vec<&str> = files.iter().map(|file| shown(file)).collect();
    let output = krank(&[&["grade", "four-bar", "--format", "csv"][..], &paths].concat());
    assert_eq!(output.code, 0);
    let table = rows(&output.out);
    for (row, path) in table.iter().zip(&paths) {
        assert_eq!(row[17], *path);
    }
    assert!(!output.out.contains(['\u{1b}', '\u{7}']), "{}", output.out);
    assert!(output.out.contains("[31mAli"), "{}", output.out);
    let twice = format!(
        "Ayse appears in more than one file: {}, {}",
        paths[0], paths[1]
    );
    assert!(output.err.contains(&twice), "{}", output.err);
    let text = krank(&[&["grade", "four-bar"][..], &paths[..1], &paths[2..]].concat());
    assert_eq!((text.code, text.err.as_str()), (0, ""));
    assert!(text.out.contains("c.csv"), "{}", text.out);
}

/// Answer files in the various notations of a class of students.
#[test]
fn ambiguous_answers_are_reported() {
    let answers = |name: &str| format!("tests/answers/{name}");
    let sheet = answers("four-bar-7.toml");
    let files = ["names.csv", "cp1254.csv", "rpm.csv", "no_normal.csv"].map(answers);
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let csv = run_ok(&[&["grade", &sheet, "--format", "csv"][..], &files].concat());
    let table = rows(&csv);
    let of = |row: usize, head: &str| {
        let heads = csv.lines().next().unwrap().split(',');
        let index = heads.into_iter().position(|own| own == head).unwrap();
        table[row][index].clone()
    };
    assert_eq!(of(0, "repeated"), "4 r4.angle: 277.17");
    assert_eq!(of(0, "unknown_rows"), "3 foo: 3");
    assert_eq!(of(1, "student"), "Şükrü İğneci");
    assert_eq!(of(1, "encoding"), "windows-1254");
    let points = [0, 1, 2, 3].map(|row| of(row, "points"));
    assert_eq!(points, ["3", "22", "21", "20"]);
    assert!(
        of(2, "misread").starts_with("driver speed = 1.2566"),
        "{csv}"
    );
    let text = run_ok(&[&["grade", &sheet][..], &files].concat());
    for piece in [
        "foo [3] in line 3",
        "windows-1254",
        "r4.angle [277.17] in line 4",
    ] {
        let joined = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(joined.contains(piece), "{piece}\n{text}");
    }
}

/// A pipe without a writer does not block; a pipe with a writer is read.
#[test]
fn pipe_without_writer_is_rejected() {
    let here = fresh("grade-pipe");
    let pipe = here.join("pipe.csv");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    let text = refused(2, &["grade", "four-bar", shown(&pipe)]);
    assert!(
        text.contains("pipe.csv") && text.contains("nobody writes"),
        "{text}"
    );
    let text = refused(2, &["report", "four-bar", "--against", shown(&pipe)]);
    assert!(text.contains("nobody writes"), "{text}");
    fs::rename(&pipe, here.join("four-bar-7.csv")).unwrap();
    let make = ["exercise", "four-bar", "--seed", "7", "-o", shown(&here)];
    assert!(refused(1, &make).contains("four-bar-7.csv"));
    let line = "cat tests/answers/derece.csv | $0 grade four-bar /dev/stdin";
    let output = std::process::Command::new("sh")
        .args(["-c", line, env!("CARGO_BIN_EXE_krank")])
        .output()
        .unwrap();
    let out = String::from_utf8(output.stdout).unwrap();
    assert!(out.contains("5 points of 22"), "{out}");
}

/// Scenes accept the same spellings of units as answers.
#[test]
fn scenes_accept_turkish_units() {
    let here = fresh("turkish-units");
    let scene = here.join("scene.toml");
    let plain = run_ok(&["start", "four-bar"]);
    let with = |angle: &str, speed: &str| {
        let text = plain.replacen("angle = 60", &format!("angle = {angle}"), 1);
        let text = text.replacen("\"15 rad/s\"", &format!("\"{speed}\""), 1);
        fs::write(&scene, text).unwrap();
        run_ok(&["table", shown(&scene)])
    };
    let expected = with("60", "60 rpm");
    for (angle, speed) in [
        ("\"60°\"", "60 d/dk"),
        ("\"60 derece\"", "60 dev/dk"),
        ("\"30 der + 30 deg\"", "360 derece/sn"),
    ] {
        assert_eq!(with(angle, speed), expected, "{angle} {speed}");
    }
    let expected = with("60", "15 rad/s");
    for speed in ["15 rd/s", "15 rad/sn", "15,0 radyan/saniye"] {
        assert_eq!(with("60", speed), expected, "{speed}");
    }
}
