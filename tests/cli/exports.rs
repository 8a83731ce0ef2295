//! Tests of exports: DXF, drawings to scale, scripts and comparison with measurements.

use super::{folder, krank, presets, refused, rows, run_ok};
use std::process::Command;

/// An entity of a DXF document: its kind and its pairs of code and value.
struct Entity {
    kind: String,
    pairs: Vec<(u16, String)>,
}

impl Entity {
    fn text(&self, code: u16) -> &str {
        let pair = self.pairs.iter().find(|(c, _)| *c == code);
        pair.map_or("", |(_, value)| value)
    }

    fn number(&self, code: u16) -> f64 {
        self.text(code).parse().unwrap()
    }
}

/// Parses DXF: pairs of lines, with a new entity at each code 0.
fn read_dxf(text: &str) -> Vec<Entity> {
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        lines.len().is_multiple_of(2),
        "codes and values come in pairs"
    );
    let mut entities: Vec<Entity> = Vec::new();
    for pair in lines.chunks(2) {
        let code: u16 = pair[0].trim().parse().unwrap();
        match code {
            0 => entities.push(Entity {
                kind: pair[1].to_owned(),
                pairs: Vec::new(),
            }),
            _ => entities
                .last_mut()
                .unwrap()
                .pairs
                .push((code, pair[1].to_owned())),
        }
    }
    assert_eq!(entities.last().unwrap().kind, "EOF");
    entities
}

fn table(scene: &str, at: &str, columns: &str) -> Vec<f64> {
    let text = run_ok(&[
        "sweep",
        scene,
        "--from",
        at,
        "--to",
        at,
        "--columns",
        columns,
    ]);
    let row = rows(&text).remove(0);
    row[1..row.len() - 1]
        .iter()
        .map(|cell| cell.parse().unwrap())
        .collect()
}

#[test]
fn dxf_has_a_layer_per_link_and_exact_coordinates() {
    let text = run_ok(&[
        "draw", "four-bar", "--at", "75", "--traces", "C", "--format", "dxf",
    ]);
    assert!(
        text.contains("AC1009") && text.contains("$INSUNITS\n 70\n4\n"),
        "{text}"
    );
    let all = read_dxf(&text);
    let of = |kind: &str, layer: &str| -> Vec<&Entity> {
        let wanted = |e: &&Entity| e.kind == kind && e.text(8) == layer;
        all.iter().filter(wanted).collect()
    };
    let layers: Vec<&str> = all
        .iter()
        .filter(|e| e.kind == "LAYER")
        .map(|e| e.text(2))
        .collect();
    assert_eq!(
        layers,
        ["r2", "r3", "r4", "ground", "joints", "paths", "names"]
    );
    let place = table("four-bar", "75", "B.x,B.y,C.x,C.y");
    let coupler = of("LINE", "r3");
    let mut ends = [10, 20, 11, 21].map(|code| coupler[0].number(code));
    if ends[0] != place[0] {
        ends.rotate_left(2);
    }
    assert_eq!(ends.to_vec(), place, "to the last bit");
    let pins: Vec<[f64; 2]> = of("CIRCLE", "joints")
        .iter()
        .map(|e| [10, 20].map(|c| e.number(c)))
        .collect();
    assert!(pins.contains(&[place[0], place[1]]) && pins.contains(&[place[2], place[3]]));
    assert_eq!(of("CIRCLE", "ground").len(), 2);
    assert!(of("VERTEX", "paths").len() > 700);
    for preset in presets() {
        let all = read_dxf(&run_ok(&["draw", &preset, "--format", "dxf"]));
        assert!(all.iter().any(|e| e.kind == "LINE"), "{preset}");
    }
}

#[test]
fn dxf_is_always_in_millimetres() {
    let text = run_ok(&["draw", "excavator-boom", "--format", "dxf"]);
    let place = table("excavator-boom", "2", "P.x,P.y");
    let all = read_dxf(&text);
    let pin = |e: &&Entity| e.kind == "CIRCLE" && (e.number(10) - 1000.0 * place[0]).abs() < 1e-9;
    assert!(
        all.iter()
            .filter(pin)
            .any(|e| (e.number(20) - 1000.0 * place[1]).abs() < 1e-9)
    );
    let wrong = refused(2, &["draw", "four-bar", "--format", "dxf", "--forces"]);
    assert!(
        wrong.contains("`--forces` does not work with `--format dxf`"),
        "{wrong}"
    );
}

/// Returns the width of an SVG and the centres of its circles, in millimetres.
fn circles(svg: &str) -> (f64, Vec<[f64; 2]>) {
    let value = |text: &str, name: &str| -> f64 {
        let from = text.find(&format!("{name}=\"")).unwrap() + name.len() + 2;
        let end = from + text[from..].find(['"', 'm']).unwrap();
        text[from..end].parse().unwrap()
    };
    let units = svg.split("viewBox=\"0 0 ").nth(1).unwrap();
    let units: f64 = units.split(' ').next().unwrap().parse().unwrap();
    let width = value(svg, "width");
    let all = svg.lines().filter(|line| line.starts_with("<circle"));
    let place = |line: &str| ["cx", "cy"].map(|name| value(line, name) * width / units);
    (width, all.map(place).collect())
}

#[test]
fn svg_scale_sets_printed_size() {
    for (scale, factor) in [("1:2", 0.5), ("1:5", 0.2), ("2:1", 2.0)] {
        let svg = run_ok(&["draw", "four-bar", "--format", "svg", "--scale", scale]);
        let (width, circles) = circles(&svg);
        assert!(width > 0.0);
        // The ground pins are 400 mm apart, so one pair of circles must have that distance.
        let distance = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let fits = circles.iter().any(|a| {
            circles
                .iter()
                .any(|b| (distance(a, b) - 400.0 * factor).abs() < 0.02 * factor.max(1.0))
        });
        assert!(fits, "{scale}: {circles:?}");
    }
    let wrong = refused(
        2,
        &["draw", "four-bar", "--format", "svg", "--scale", "half"],
    );
    assert!(
        wrong.contains("expected a scale such as 1:2 or 5:1"),
        "{wrong}"
    );
    let wrong = refused(2, &["draw", "four-bar", "--scale", "1:2"]);
    assert!(
        wrong.contains("`--scale` does not work with `--format text`; use svg"),
        "{wrong}"
    );
}

/// Runs a Python script and returns its output, or `None` without Python.
fn python(file: &str, args: &[&str]) -> Option<String> {
    let output = Command::new("python3").arg(file).args(args).output().ok()?;
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{file}: {error}");
    Some(String::from_utf8(output.stdout).unwrap())
}

/// Runs a MATLAB script with Octave and returns its output, or `None` without Octave.
fn octave(file: &str) -> Option<String> {
    let requested = ["--no-gui", "--quiet", "--no-init-file", file];
    let output = Command::new("octave").args(requested).output().ok()?;
    Some(String::from_utf8(output.stdout).unwrap())
}

/// Returns start, end and step for the script of a preset. They avoid round values, where a change
/// point may lie: there a script loses half of its digits.
fn script_range(preset: &str) -> [&'static str; 3] {
    match preset {
        // These ranges lie between the stops.
        "double-wishbone" | "ackermann" => ["1.3", "13.3", "3"],
        "lift-table" => ["260.5", "610.5", "50"],
        "backhoe" => ["1", "1.6", "0.1"],
        "scissor-lift" => ["0.5", "1.9", "0.2"],
        "excavator" => ["1.75", "2.65", "0.1"],
        "excavator-boom" => ["1.7", "3", "0.1"],
        _ => ["37.3", "77.3", "10"],
    }
}

/// Checks that the rows of a script agree with a sweep by krank.
fn agrees(preset: &str, found: &str) {
    let [from, to, step] = script_range(preset);
    let headers: Vec<&str> = found.lines().next().unwrap().split(',').collect();
    let names: Vec<&str> = headers
        .iter()
        .map(|h| h.split(' ').next().unwrap())
        .collect();
    let columns = names[1..].join(",");
    let window = ["--from", from, "--to", to, "--step", step];
    let named = ["sweep", preset, "--columns", &columns];
    // Scripts move the driver, also where a point leads.
    let by: &[&str] = match preset {
        "plotter" => &["--by", "r2"],
        _ => &[],
    };
    let expected = run_ok(&[&named[..], &window, by].concat());
    assert_eq!(
        expected.lines().next().unwrap(),
        format!("{},state", headers.join(",")),
        "{preset}"
    );
    let (found, expected) = (rows(found), rows(&expected));
    assert_eq!(found.len(), expected.len(), "{preset}");
    let number = |cell: &String| cell.parse::<f64>().unwrap();
    let size = found
        .iter()
        .flatten()
        .map(number)
        .fold(0.0_f64, |m, v| m.max(v.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        for (a, b) in found[1..].iter().zip(&expected[1..]) {
            let off = (number(a) - number(b)).abs();
            assert!(off < 1e-12 * size, "{preset} at {}: {off:e}", found[0]);
        }
    }
}

#[test]
fn python_scripts_of_all_presets_match_krank() {
    let folder = folder("exports");
    for preset in presets() {
        let file = folder.join(format!("{}.py", preset.replace('-', "_")));
        let file = file.to_str().unwrap();
        run_ok(&["export", &preset, "--format", "python", "-o", file]);
        let Some(found) = python(file, &script_range(&preset)) else {
            return;
        };
        agrees(&preset, &found);
    }
}

#[test]
fn matlab_scripts_of_all_presets_match_krank() {
    let folder = folder("exports-matlab");
    let mut all = format!("addpath('{}');\n", folder.display());
    for preset in presets() {
        let name = preset.replace('-', "_");
        let file = folder.join(format!("{name}.m"));
        let file = file.to_str().unwrap();
        run_ok(&["export", &preset, "--format", "matlab", "-o", file]);
        let [from, to, step] = script_range(&preset);
        all += &format!(
            "[r, h] = {name}({from}, {to}, {step});\nprintf('%s%s', strjoin(h, ','), char(10));\n\
             for k = 1:rows(r), printf('%.17g,', r(k, 1:end-1)); printf('%.17g%s', r(k, end), char(10)); end\n\
             printf('END %s%s', '{preset}', char(10));\n"
        );
    }
    let file = folder.join("krank_runs_all.m");
    std::fs::write(&file, all).unwrap();
    let Some(mut found) = octave(file.to_str().unwrap()) else {
        return;
    };
    for preset in presets() {
        let end = format!("END {preset}\n");
        let (one, rest) = found
            .split_once(&end)
            .unwrap_or_else(|| panic!("{preset}: {found}"));
        agrees(&preset, one);
        found = rest.to_owned();
    }
}

/// The second crank of a five-bar follows a closed table, and a telescope follows an open one.
#[test]
fn python_scripts_interpolate_input_tables() {
    let links = "[links]\nr2 = { from = \"A\", to = \"B\", length = 100 }\nr3 = { from = \"B\", to = \"C\", length = 260 }\n\
        r4 = { from = \"E\", to = \"C\", length = 240 }\nr5 = { from = \"D\", to = \"E\", length = 80 }\n[start]\nC = [150, 250]\n";
    let five_bar = format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [300, 0]\n[driver]\nlink = \"r2\"\nangle = 50\n[inputs]\n\
         r5 = {{ over = [[0.5, 80], [40, 65], [90.1, 10], [200, -20.5], [360.5, -280]] }}\n{links}"
    );
    let telescope = "unit = \"mm\"\n[ground]\nO = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 50\n[inputs]\n\
        rod = { over = [[0, 200], [40, 265], [90, 310], [150, 200]] }\n[links]\nr2 = { points = { O = [0, 0] } }\n\
        [slides]\nrod = { point = \"T\", on = \"r2\", through = \"O\", angle = 0 }\n";
    let folder = folder("exports-tables");
    for (name, text, [from, to]) in [
        ("five_bar", five_bar.as_str(), ["-400", "800"]),
        ("telescope", telescope, ["0", "150"]),
    ] {
        let [scene, script] = ["toml", "py"].map(|end| folder.join(format!("{name}.{end}")));
        std::fs::write(&scene, text).unwrap();
        let [scene, script] = [scene.to_str().unwrap(), script.to_str().unwrap()];
        run_ok(&["export", scene, "--format", "python", "-o", script]);
        let Some(found) = python(script, &[from, to, "7.5"]) else {
            return;
        };
        let headers: Vec<&str> = found.lines().next().unwrap().split(',').collect();
        let names: Vec<&str> = headers
            .iter()
            .map(|h| h.split(' ').next().unwrap())
            .collect();
        let columns = names[1..].join(",");
        let expected = run_ok(&[
            "sweep",
            scene,
            "--from",
            from,
            "--to",
            to,
            "--step",
            "7.5",
            "--columns",
            &columns,
        ]);
        let (found, expected) = (rows(&found), rows(&expected));
        assert_eq!(found.len(), expected.len(), "{name}");
        for (found, expected) in found.iter().zip(&expected) {
            for (a, b) in found[1..].iter().zip(&expected[1..]) {
                let off = (a.parse::<f64>().unwrap() - b.parse::<f64>().unwrap()).abs();
                assert!(off < 1e-9, "{name} at {}: {off:e}", found[0]);
            }
        }
    }
}

/// Checks that the script of a chain of four-bars with these names agrees with krank. Returns
/// `false` if Python is missing.
fn agrees_with_names(folder: &std::path::Path, names: &[&str]) -> bool {
    let [a, b, crank, dyads @ ..] = names else {
        panic!("{NAMES} names");
    };
    let mut ground = format!("\"{a}\" = [0, 0]\n");
    let mut links = format!("\"{crank}\" = {{ from = \"{a}\", to = \"{b}\", length = 100 }}\n");
    let mut start = String::new();
    let mut joints = vec![*b];
    for (k, dyad) in (1..).zip(dyads.chunks_exact(4)) {
        let [c, d, coupler, rocker] = dyad else {
            panic!("four names");
        };
        let (before, length) = (joints[k - 1], if k == 1 { 300 } else { 400 });
        ground += &format!("\"{d}\" = [{}, 0]\n", 400 * k);
        links += &format!(
            "\"{coupler}\" = {{ from = \"{before}\", to = \"{c}\", length = {length} }}\n\
             \"{rocker}\" = {{ from = \"{c}\", to = \"{d}\", length = 250 }}\n"
        );
        start += &format!("\"{c}\" = [{}, 234]\n", 400 * k - 89);
        joints.push(c);
    }
    let text = format!(
        "[ground]\n{ground}[driver]\nlink = \"{crank}\"\nangle = 60\n[links]\n{links}[start]\n{start}"
    );
    let [scene, script] = ["toml", "py"].map(|end| folder.join(format!("names.{end}")));
    std::fs::write(&scene, text).unwrap();
    let [scene, script] = [scene.to_str().unwrap(), script.to_str().unwrap()];
    run_ok(&["export", scene, "--format", "python", "-o", script]);
    let Some(found) = python(script, &["60", "60", "1"]) else {
        return false;
    };
    let columns: Vec<String> = joints.iter().map(|c| format!("{c}.x,{c}.y")).collect();
    let expected = table(scene, "60", &columns.join(","));
    let found: Vec<f64> = rows(&found)[0][1..]
        .iter()
        .map(|cell| cell.parse().unwrap())
        .collect();
    for (found, expected) in found.iter().zip(&expected) {
        assert!(
            (found - expected).abs() < 1e-10,
            "{names:?}: {found} {expected}"
        );
    }
    true
}

/// Number of names in a chain of four-bars: three of the crank and four of each of eight dyads.
const NAMES: usize = 3 + 4 * 8;

/// Names scene elements like everything that a script defines, imports or calls, like keywords, and
/// like Python's builtins.
#[test]
fn scene_names_do_not_shadow_script_names() {
    let folder = folder("exports-names");
    let frames = ["python", "matlab"].map(|language| {
        let file = format!(
            "{}/src/script_export/{language}.txt",
            env!("CARGO_MANIFEST_DIR")
        );
        std::fs::read_to_string(file).unwrap()
    });
    let is_of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut names: Vec<String> = frames
        .iter()
        .flat_map(|frame| frame.split(|c| !is_of_name(c)))
        .map(str::to_owned)
        .collect();
    let listed = Command::new("python3")
        .args([
            "-c",
            "import builtins, keyword\nprint(*dir(builtins), *keyword.kwlist)",
        ])
        .output();
    let listed = listed.map_or_else(
        |_| String::new(),
        |output| String::from_utf8_lossy(&output.stdout).into_owned(),
    );
    names.extend(listed.split_whitespace().map(str::to_owned));
    let reserved = ["driver", "ground", "com", "state"];
    names.retain(|name| {
        name.starts_with(|c: char| c.is_ascii_alphabetic()) && !reserved.contains(&name.as_str())
    });
    names.sort();
    names.dedup();
    assert!(names.len() > 100, "{}", names.len());
    let spare = ["A1", "B1", "C1", "D1", "s2", "s3", "s4"].map(str::to_owned);
    names.extend(spare);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    for some in names.chunks_exact(NAMES) {
        if !agrees_with_names(&folder, some) {
            return;
        }
    }
    let last = &names[names.len() - NAMES..];
    agrees_with_names(&folder, last);
    // A point on a link is named after link and point, unless that name is taken.
    let text = "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 100 }\n\
        r3 = { from = \"B\", to = \"C\", length = 300, points = { P = [150, 40] } }\n\
        r3_P = { from = \"C\", to = \"D\", length = 250 }\n[start]\nC = [310, 230]\n";
    let [scene, script] = ["toml", "py"].map(|end| folder.join(format!("parts.{end}")));
    std::fs::write(&scene, text).unwrap();
    let [scene, script] = [scene.to_str().unwrap(), script.to_str().unwrap()];
    run_ok(&["export", scene, "--format", "python", "-o", script]);
    let Some(found) = python(script, &["60", "60", "1"]) else {
        return;
    };
    let headers: Vec<&str> = found.lines().next().unwrap().split(',').collect();
    let columns: Vec<&str> = headers[1..]
        .iter()
        .map(|h| h.split(' ').next().unwrap())
        .collect();
    let expected = table(scene, "60", &columns.join(","));
    for (found, expected) in rows(&found)[0][1..].iter().zip(&expected) {
        let found: f64 = found.parse().unwrap();
        assert!((found - expected).abs() < 1e-10, "{found} {expected}");
    }
}

/// Layer names have 31 characters. Regression test: more links with the same first 31 characters
/// caused an endless loop.
#[test]
fn long_link_names_give_distinct_dxf_layers() {
    let long = "a_link_with_a_very_long_name_of_many_words";
    let text = format!(
        "[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"{long}_1\"\nangle = 60\n[links]\n\
         {long}_1 = {{ from = \"A\", to = \"B\", length = 100 }}\n\
         {long}_2 = {{ from = \"B\", to = \"C\", length = 300 }}\n\
         {long}_3 = {{ from = \"C\", to = \"D\", length = 250 }}\n[start]\nC = [310, 230]\n"
    );
    let scene = folder("exports-layers").join("long.toml");
    std::fs::write(&scene, text).unwrap();
    let drawn = run_ok(&["draw", scene.to_str().unwrap(), "--format", "dxf"]);
    let all = read_dxf(&drawn);
    let layers: std::collections::BTreeSet<&str> = all
        .iter()
        .filter(|e| e.kind == "LAYER")
        .map(|e| e.text(2))
        .collect();
    assert_eq!(layers.len(), 7, "{layers:?}");
    assert!(layers.iter().all(|layer| layer.len() <= 31), "{layers:?}");
}

#[test]
fn scripts_use_the_names_and_values_of_the_scene() {
    let script = run_ok(&["export", "four-bar", "--format", "python"]);
    for line in [
        "r3 = 300.0",
        "    u_r2 = turn(q)",
        "    B = A + u_r2 * r2",
        "    C = circles(B, abs(r3), D, abs(r4), 1)",
    ] {
        assert!(script.lines().any(|l| l == line), "{line}\n{script}");
    }
    let matlab = run_ok(&["export", "four-bar", "--format", "octave"]);
    assert!(
        matlab.starts_with("function [rows, heads] = four_bar(low, high, step)\n"),
        "{matlab}"
    );
    assert!(
        matlab.contains("    C = circles(B, abs(r3), D, abs(r4), 1);\n"),
        "{matlab}"
    );
    let coupled = run_ok(&["export", "stephenson-six-bar", "--format", "python"]);
    assert!(coupled.contains("newton(lambda z: ["), "{coupled}");
    for text in [&script, &matlab, &coupled] {
        assert!(text.is_ascii() && !text.contains("<<"), "{text}");
    }
}

/// Regression test: such cells were dropped silently.
#[test]
fn non_numeric_measurements_are_reported_with_line_and_column() {
    let file = folder("measured-badly").join("run.csv");
    let text = "driver.angle [deg],C.x [mm],C.y [mm]\n10,1,2\n\nx,3,4\n20,\"1,2,3\",5\n30,,6\n";
    std::fs::write(&file, text).unwrap();
    let path = file.to_str().unwrap();
    let output = |columns: &str, format: &str| {
        let requested = [
            "sweep",
            "four-bar",
            "--measured",
            path,
            "--columns",
            columns,
        ];
        let done = krank(&[&requested[..], &["--format", format]].concat());
        assert_eq!(done.code, 0);
        // Text pages wrap their lines.
        (done.out + &done.err)
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    };
    let both = "since they are not numbers: line 4, driver.angle: `x`; line 5, C.x: `1,2,3`.";
    for format in ["csv", "text", "json"] {
        let output = output("C.x,C.y", format);
        assert!(output.contains(both), "{output}");
    }
    // A bad cell in an unselected column is not reported.
    assert!(output("C.y", "csv").contains("line 4, driver.angle: `x`."));
}

/// The measurements are krank's own values, two of them shifted by known amounts.
#[test]
fn measured_columns_follow_computed_columns() {
    let folder = folder("measured");
    let file = folder.join("run.csv");
    let place = |at: &str| table("four-bar", at, "C.x,C.y");
    let (a, b) = (place("10"), place("20"));
    // In cm, 1 mm more at 10 deg and 3 mm less at 20 deg: the root mean square is sqrt((1 + 9) /
    // 2).
    let text = format!(
        "driver.angle [deg],C.x [cm],C.y [mm]\n10,{},{}\n20,{},{}\n",
        (a[0] + 1.0) / 10.0,
        a[1],
        (b[0] - 3.0) / 10.0,
        b[1]
    );
    std::fs::write(&file, text).unwrap();
    let path = file.to_str().unwrap();
    let text = run_ok(&["sweep", "four-bar", "--measured", path, "--columns", "C.x"]);
    assert!(
        text.starts_with(
            "driver.angle [deg],C.x [mm],C.x.measured [mm],C.x.difference [mm],state\n"
        ),
        "{text}"
    );
    let rows = rows(&text);
    let cell = |row: usize, k: usize| rows[row][k].parse::<f64>().unwrap();
    assert!(
        (cell(0, 3) - 1.0).abs() < 1e-10 && (cell(1, 3) + 3.0).abs() < 1e-10,
        "{text}"
    );
    assert_eq!((cell(0, 1), rows[0][4].as_str()), (a[0], "ok"));
    let text = run_ok(&["sweep", "four-bar", "--measured", path, "--format", "text"]);
    let line = text
        .lines()
        .find(|line| line.contains("C.x [mm]") && line.contains("2.24"));
    assert!(
        line.is_some_and(|line| line.contains("-3.00") && line.contains("20")),
        "{text}"
    );
    let plot = run_ok(&["plot", "four-bar", "--columns", "C.x", "--measured", path]);
    assert!(plot.contains("C.x measured"), "{plot}");
    let svg = run_ok(&[
        "plot",
        "four-bar",
        "--columns",
        "C.x",
        "--measured",
        path,
        "--format",
        "svg",
    ]);
    assert!(svg.contains("C.x measured"), "{svg}");
    let wrong = refused(
        2,
        &["sweep", "four-bar", "--measured", path, "--columns", "B.x"],
    );
    assert!(
        wrong.contains("has no measurements of these columns"),
        "{wrong}"
    );
    let wrong = refused(
        2,
        &[
            "plot",
            "four-bar",
            "--columns",
            "C.x",
            "--against",
            "C.y",
            "--measured",
            path,
        ],
    );
    assert!(wrong.contains("remove `--against`"), "{wrong}");
}

/// Regression test: a drawing at 1e300 times the linkage's size was accepted.
#[test]
fn scale_out_of_range_is_rejected() {
    for scale in [
        "0:1", "1:0", "-1:2", "nan:1", "inf:1", "1e300:1", "1:1e300", "10001:1", "2",
    ] {
        let option = format!("--scale={scale}");
        let text = refused(2, &["draw", "four-bar", "--format", "svg", &option]);
        assert!(
            text.contains("between 1:10000 and 10000:1"),
            "{scale}: {text}"
        );
    }
    for scale in ["1:10000", "10000:1", "2.5:1"] {
        run_ok(&["draw", "four-bar", "--format", "svg", "--scale", scale]);
    }
}

/// The squares of these differences overflow a double.
#[test]
fn root_mean_square_of_huge_differences_does_not_overflow() {
    let file = folder("against-far").join("far.csv");
    std::fs::write(
        &file,
        "driver.angle [deg],C.vy [mm/s]\n0,0\n30,1e308\n60,0\n90,0\n",
    )
    .unwrap();
    let report = run_ok(&[
        "report",
        "four-bar",
        "--at",
        "60",
        "--against",
        file.to_str().unwrap(),
    ]);
    assert!(report.contains("5.00e307"), "{report}");
    assert!(
        !report.contains("inf<") && !report.contains(" inf"),
        "{report}"
    );
}

/// Outside the range of motion a cell is empty, as in a sweep. Arguments may have a decimal comma.
#[test]
fn python_scripts_leave_missing_positions_empty() {
    let script = folder("exports-range").join("boom.py");
    let script = script.to_str().unwrap();
    run_ok(&[
        "export",
        "excavator-boom",
        "--format",
        "python",
        "-o",
        script,
    ]);
    let Some(found) = python(script, &["99,5", "99,5", "1"]) else {
        return;
    };
    let [head, row] = found.lines().collect::<Vec<_>>()[..] else {
        panic!("{found}");
    };
    let cells: Vec<&str> = row.split(',').collect();
    assert_eq!(cells.len(), head.split(',').count(), "{found}");
    assert_eq!(cells[0], "99.5");
    assert!(cells[1..].iter().any(|cell| cell.is_empty()), "{found}");
    assert!(!found.contains("nan"), "{found}");
}

/// A cylinder between the coupler and the rocker of a four-bar, near its shortest length.
const STEEP_END: &str = r#"unit = "mm"

[ground]
G1 = [2646.772, -9285.811]
G2 = [2588.738, -9375.456]

[driver]
slide = "s11"
position = 83.09
speed = "1241 mm/s"
acceleration = "-1200 mm/s^2"

[links]
L5 = { from = "B3", to = "G1", length = 151.45 }
L6 = { from = "C4", to = "B3", length = 210.56, points = { Q8 = [-51.186, -71.949] } }
L7 = { from = "C4", to = "G2", length = 80.143, points = { Q9 = [-5.2026, 0.28739] } }
bar10 = { points = { Q8 = [0, 0] } }
ram12 = { points = { O13 = [0, 0] } }

[slides]
s11 = { point = "Q9", on = "bar10", through = "Q8", angle = 0 }
s14 = { link = "ram12", on = "ground", through = [2598.1113, -9409.453], angle = 312.16, turn = -41.681 }
s15 = { point = "C4", on = "ram12", through = "O13", angle = 158.091 }

[start]
B3 = [2514.164321, -9212.6455]
C4 = [2666.869076, -9357.613333]
Q8 = [2753.52781, -9340.674335]
Q9 = [2672.005082, -9356.73522]
O13 = [2631.882884, -9446.75016]
"#;

/// The slide of `STEEP_END` opens near the end of its range, where small changes of its length move
/// the links far. Regression test: the script printed places that Newton's method did not reach.
#[test]
fn python_scripts_follow_coupled_groups_near_their_ends() {
    let folder = folder("exports-end");
    let [scene, script] = ["toml", "py"].map(|end| folder.join(format!("steep_end.{end}")));
    std::fs::write(&scene, STEEP_END).unwrap();
    let [scene, script] = [scene.to_str().unwrap(), script.to_str().unwrap()];
    run_ok(&["export", scene, "--format", "python", "-o", script]);
    // The first rows have no assembly; those after them must be correct again.
    let Some(found) = python(script, &["82.9", "83.9", "0.1"]) else {
        return;
    };
    let columns = "B3.x,B3.y,C4.x,C4.y,Q8.x,Q8.y,Q9.x,Q9.y,O13.x,O13.y";
    let expected = krank(&[
        "sweep",
        scene,
        "--from",
        "82.9",
        "--to",
        "83.9",
        "--step",
        "0.1",
        "--columns",
        columns,
    ])
    .out;
    let (found, expected) = (rows(&found), rows(&expected));
    assert_eq!(found.len(), expected.len());
    let mut empty = 0;
    for (found, expected) in found.iter().zip(&expected) {
        for (a, b) in found[1..].iter().zip(&expected[1..]) {
            assert_eq!(a.is_empty(), b.is_empty(), "{found:?} {expected:?}");
            if a.is_empty() {
                empty += 1;
                continue;
            }
            let off = (a.parse::<f64>().unwrap() - b.parse::<f64>().unwrap()).abs();
            assert!(off < 1e-8, "{found:?} {expected:?}");
        }
    }
    assert_eq!(empty, 20, "{found:?}");
}

/// Regression test: the script did not end for a coordinate that is not finite.
#[test]
fn python_scripts_have_no_place_for_coordinates_that_are_not_finite() {
    let folder = folder("exports-not-finite");
    let [scene, script] = ["toml", "py"].map(|end| folder.join(format!("steep_end.{end}")));
    std::fs::write(&scene, STEEP_END).unwrap();
    run_ok(&[
        "export",
        scene.to_str().unwrap(),
        "--format",
        "python",
        "-o",
        script.to_str().unwrap(),
    ]);
    let ask = folder.join("ask.py");
    let text = "from steep_end import positions\n\
                for q in ['nan', 'inf', '-inf']:\n    \
                    found = positions(float(q))\n    \
                    print(len(found), sum(z != z for z in found))\n";
    std::fs::write(&ask, text).unwrap();
    let Some(found) = python(ask.to_str().unwrap(), &[]) else {
        return;
    };
    let (points, missing): (Vec<&str>, Vec<&str>) = found
        .lines()
        .filter_map(|line| line.split_once(' '))
        .unzip();
    assert_eq!(points.len(), 3, "{found}");
    assert_eq!(points, missing, "{found}");
}
