//! Tests of `--assembly` and `krank start`: showing and saving another assembly.

use super::{command, folder, json, refused, rows, run, run_ok};
use std::fs;

const CROSSED: &[&str] = &["four-bar", "--assembly", "C=-"];

fn with<'a>(command: &'a str, args: &[&'a str]) -> Vec<&'a str> {
    [&[command], CROSSED, args].concat()
}

/// The mirrored coordinates of hard case H29, by `table` and `sweep`.
#[test]
fn h29_other_assembly_has_its_known_coordinates() {
    let table = json(&run_ok(&with(
        "table",
        &["--at", "240", "--format", "json"],
    )));
    let c = &table["points"]["C"];
    assert!(table.to_string().contains("233.03106360959"), "{c}");
    let csv = run_ok(&with(
        "sweep",
        &["--from", "240", "--to", "240", "--columns", "C.x,C.y"],
    ));
    let row = &rows(&csv)[0];
    let place: Vec<f64> = row[1..3].iter().map(|cell| cell.parse().unwrap()).collect();
    assert!(
        (place[0] - 233.031_063_609_591_44).abs() < 1e-12 * 300.0,
        "{place:?}"
    );
    assert!(
        (place[1] + 186.068_197_929_296_08).abs() < 1e-12 * 300.0,
        "{place:?}"
    );
}

#[test]
fn check_lists_choices_and_whole_assemblies() {
    let text = run_ok(&["check", "press-ram", "--assembly", "C=-,F=+"]);
    for line in [
        "choices    C: + at (311.417, 233.780), - at (212.622, -165.497) now\n",
        "\n           F: + at (560, ",
        "assemblies 4: C=+,F=+; C=+,F=-; C=-,F=+ now; C=-,F=-\n",
    ] {
        assert!(text.contains(line), "{line}{text}");
    }
    let facts = json(&run_ok(&["check", "press-ram", "--format", "json"]));
    assert_eq!(facts["choices"][1]["group"], "F");
    assert_eq!(facts["choices"][1]["list"][1]["choice"], "-");
    assert_eq!(facts["choices"][1]["list"][1]["current"], true);
    assert_eq!(facts["choices"][1]["list"][1]["at"][0], 560.0);
    let complete = &facts["assemblies"];
    assert_eq!(
        (&complete["complete"], &complete["current"]),
        (&true.into(), &1.into())
    );
    assert_eq!(complete["list"].as_array().unwrap().len(), 4);
    assert_eq!(complete["list"][1]["F"], "-");
    let arm = json(&run_ok(&["check", "slotted-lever", "--format", "json"]));
    assert!(arm["choices"][0]["list"][0]["angle"].is_f64());
}

#[test]
fn invalid_assembly_choices_are_rejected() {
    for (code, wish, phrase) in [
        (
            2,
            "X=-",
            "--assembly: no group `X` has a choice of assemblies; there are `C`, `F`",
        ),
        (2, "c=-", "did you mean `C`?"),
        (2, "C=1", "`C` needs a sign"),
        (2, "C=+,C=-", "`C` is given twice"),
        (2, "C:-", "write NAME=+ or NAME=-"),
        // The scene is valid, but cannot be assembled with this request.
        (
            1,
            "C=-",
            "--assembly C=-: the mechanism cannot be assembled at the start: `F` is out of reach by",
        ),
    ] {
        let message = refused(code, &["table", "press", "--assembly", wish]);
        assert!(message.contains(phrase), "{wish}: {message}");
    }
}

#[test]
fn coupled_group_reports_its_assembly_numbers() {
    let args = ["check", "stephenson-six-bar", "--assembly", "E=3"];
    let message = refused(1, &args);
    assert!(
        message.contains("`E` has 2 assemblies here: choose a number from 1 to 2"),
        "{message}"
    );
}

#[test]
fn start_at_change_point_suggests_assembly_option() {
    let flat = run_ok(&["start", "parallelogram"]).replace("angle = 60", "angle = 180");
    let here = folder("change-point");
    fs::write(here.join("flat.toml"), flat).unwrap();
    let output = run(command(&["check", "flat.toml"]).current_dir(&here));
    assert_eq!(output.code, 2);
    for phrase in [
        "the scene opens at a change point",
        "`--assembly C=+` or `--assembly C=-`",
        "another `angle` of the driver",
    ] {
        assert!(output.err.contains(phrase), "{}", output.err);
    }
    for (choice, kind) in [
        ("C=+", "C: + at (200, 0) now"),
        ("C=-", "- at (200, 0) now"),
    ] {
        let mut check = command(&["check", "flat.toml", "--assembly", choice]);
        let output = run(check.current_dir(&here));
        assert_eq!((output.code, output.err.as_str()), (0, ""));
        assert!(output.out.contains(kind), "{}", output.out);
    }
}

#[test]
fn start_prints_the_scene_with_another_start() {
    let same = run_ok(&["start", "four-bar"]);
    let crossed = run_ok(&with("start", &[]));
    let changed = crossed.lines().zip(same.lines()).filter(|(a, b)| a != b);
    let changed: Vec<_> = changed.map(|(line, _)| line).collect();
    assert_eq!(changed, ["C = [212.622, -165.497]"]);
    let mut check = command(&["check", "-"]);
    let output = run(check.write_stdin(crossed));
    assert!(
        output.out.contains("- at (212.622, -165.497) now"),
        "{}",
        output.out
    );
}

#[test]
fn start_overwrites_its_input_scene() {
    let here = folder("start");
    let file = here.join("mine.toml");
    let mine = run_ok(&["start", "four-bar"]).replace("[start]", "# up or down\n[start] # here");
    fs::write(&file, &mine).unwrap();
    let mut start = command(&["start", "mine.toml", "--assembly", "C=-", "-o", "mine.toml"]);
    let output = run(start.current_dir(&here));
    assert_eq!(
        (output.code, output.out.as_str(), output.err.as_str()),
        (0, "", "")
    );
    let saved = fs::read_to_string(&file).unwrap();
    assert!(
        saved.contains("# up or down\n[start] # here\nC = [212.622, -165.497]"),
        "{saved}"
    );
    assert_eq!(saved.lines().count(), mine.lines().count());
    // A failed command leaves the file unchanged.
    let mut start = command(&["start", "mine.toml", "--assembly", "X=-", "-o", "mine.toml"]);
    assert_eq!(run(start.current_dir(&here)).code, 2);
    assert_eq!(fs::read_to_string(&file).unwrap(), saved);
}

/// Three dyads in series without start positions.
const OPEN: &str = r#"
[ground]
A = [0, 0]
D = [400, 0]
G = [800, 0]
H = [800, 400]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
r4 = { from = "C", to = "D", length = 250 }
r5 = { from = "C", to = "E", length = 400 }
r6 = { from = "E", to = "G", length = 500 }
r7 = { from = "E", to = "F", length = 300 }
r8 = { from = "F", to = "H", length = 400 }
"#;

/// The message lists all ambiguous points at once, and the scene opens with its lines copied.
#[test]
fn all_ambiguous_start_positions_are_listed_at_once() {
    let file = folder("all-open").join("scene.toml");
    std::fs::write(&file, OPEN).unwrap();
    let name = file.to_str().unwrap();
    let output = refused(2, &["check", name]);
    assert!(output.contains("`C` can be at "), "{output}");
    assert!(output.contains("; open as well: `E`, `F`"), "{output}");
    for point in ["C", "E", "F"] {
        assert!(output.contains(&format!("where is `{point}`?")), "{output}");
    }
    assert_eq!(refused(2, &["start", name]), output);
    let lines = output.split_once("[start]\n").unwrap().1;
    let lines: Vec<&str> = lines.lines().map(str::trim).take(3).collect();
    for (line, point) in lines.iter().zip(["C", "E", "F"]) {
        assert!(line.starts_with(&format!("{point} = [")), "{output}");
        assert!(line.contains("]   # or "), "{output}");
    }
    std::fs::write(&file, format!("{OPEN}[start]\n{}\n", lines.join("\n"))).unwrap();
    let first = run_ok(&["check", name]);
    // Each point is at the first of its proposed positions.
    for line in &lines {
        let (point, places) = line.split_once(" = [").unwrap();
        let (x, _) = places.split_once(',').unwrap();
        let row = first
            .lines()
            .find(|l| l.contains(&format!("{point}: ")) && l.contains("now"));
        let (now, _) = row
            .unwrap_or_else(|| panic!("{point} in {first}"))
            .split_once(" now")
            .unwrap();
        let here: f64 = now
            .rsplit_once('(')
            .unwrap()
            .1
            .split(',')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        assert!(
            (here - x.parse::<f64>().unwrap()).abs() < 0.01,
            "{line}: {first}"
        );
    }
    // A point with a start position is not listed any more.
    std::fs::write(&file, format!("{OPEN}[start]\n{}\n", lines[0])).unwrap();
    let output = refused(2, &["check", name]);
    assert!(
        output.contains("`E` can be at ") && output.contains("; open as well: `F`"),
        "{output}"
    );
}

/// C and Q are ambiguous. T has a start position, but reaches E from only one of the two positions of C. This position
/// is listed first, in any order of the links, and the printed lines open the scene.
#[test]
fn suggested_start_positions_can_be_assembled() {
    let of_c = [
        "r3 = { from = \"B\", to = \"C\", length = 300 }",
        "r4 = { from = \"C\", to = \"D\", length = 250 }",
    ];
    let of_q = [
        "q1 = { from = \"B\", to = \"Q\", length = 320 }",
        "q2 = { from = \"Q\", to = \"D\", length = 240 }",
    ];
    let of_t = "r5 = { from = \"C\", to = \"T\", length = 50 }\nr6 = { from = \"T\", to = \"E\", length = 50 }";
    let file = folder("open-closes").join("scene.toml");
    for (end, start) in [("[330, 260]", "[282, 274]"), ("[230, -140]", "[182, -126]")] {
        for [one, other] in [[of_c, of_q], [of_q, of_c]] {
            let [one, other] = [one, other].map(|links| links.join("\n"));
            let scene = format!(
                "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [400, 0]\nE = {end}\n[driver]\nlink = \"r2\"\nangle = 60\n\
                 [links]\nr2 = {{ from = \"A\", to = \"B\", length = 100 }}\n{one}\n{other}\n{of_t}\n\
                 [start]\nT = {start}\n"
            );
            std::fs::write(&file, &scene).unwrap();
            let name = file.to_str().unwrap();
            let output = refused(2, &["check", name]);
            let lines = output
                .split_once("[start]\n")
                .unwrap()
                .1
                .lines()
                .map(str::trim);
            let lines: Vec<&str> = lines.take_while(|l| l.contains(" = [")).collect();
            assert_eq!(lines.len(), 2, "{output}");
            std::fs::write(&file, scene + &lines.join("\n") + "\n").unwrap();
            run_ok(&["check", name]);
        }
    }
}
