//! Tests of `krank synthesize`: reports, written scenes, and an independent loop closure that
//! checks whether the scenes fulfil their task.

use super::language::spoken;
use super::{Run, command, folder, json, krank, refused, rows, run, run_ok};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// Returns the path of a folder that does not exist yet.
fn new_folder(name: &str) -> PathBuf {
    let path = folder("synthesize").join(name);
    if path.exists() {
        fs::remove_dir_all(&path).unwrap();
    }
    path
}

/// Writes a task to a file and returns its path.
fn task(name: &str, text: &str) -> String {
    let path = folder("synthesize").join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn pair(value: &Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

fn away([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    (ax - bx).hypot(ay - by)
}

/// The dimensions of a written scene.
struct WrittenFourBar {
    a: [f64; 2],
    d: [f64; 2],
    crank: f64,
    coupler: f64,
    rocker: f64,
    /// P and, for poses, X on the coupler: coordinates from B along B-C and across.
    coupler_points: Vec<[f64; 2]>,
    /// The initial position of C.
    c: [f64; 2],
    angle: f64,
    /// The marks T1, T2 ... and X1, X2 ....
    marks: [Vec<[f64; 2]>; 2],
}

impl WrittenFourBar {
    fn read(path: &Path) -> WrittenFourBar {
        let text = fs::read_to_string(path).unwrap();
        let scene: toml::Table = text.parse().unwrap();
        let scene = serde_json::to_value(scene).unwrap();
        let parameter = |name: &str| number(&scene["parameters"][name]);
        let place = |x: &str, y: &str| [parameter(x), parameter(y)];
        let marks = |letter: &str| {
            let at = |k: usize| scene["marks"].get(format!("{letter}{k}"));
            (1..).map_while(at).map(pair).collect()
        };
        let guided = &scene["links"]["r3"]["points"];
        let p = guided.get("P").map(|_| place("px", "py"));
        // "px + 20.0 * cos(lean)": X lies at this distance from P, in the direction `lean`.
        let x = guided.get("X").map(|x| {
            let mut formula = x[0].as_str().unwrap().split(' ');
            let arm: f64 = formula.nth(2).unwrap().parse().unwrap();
            let (sine, cosine) = parameter("lean").to_radians().sin_cos();
            let [px, py] = p.unwrap();
            [px + arm * cosine, py + arm * sine]
        });
        WrittenFourBar {
            a: place("ax", "ay"),
            d: place("dx", "dy"),
            crank: parameter("crank"),
            coupler: parameter("coupler"),
            rocker: parameter("rocker"),
            coupler_points: p.into_iter().chain(x).collect(),
            c: pair(&scene["start"]["C"]),
            angle: number(&scene["driver"]["angle"]),
            marks: [marks("T"), marks("X")],
        }
    }

    /// Returns B and C at a crank angle in degrees, on one side of B-D.
    fn pins(&self, angle: f64, side: f64) -> Option<[[f64; 2]; 2]> {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let b = [
            self.a[0] + self.crank * cosine,
            self.a[1] + self.crank * sine,
        ];
        let (gx, gy) = (self.d[0] - b[0], self.d[1] - b[1]);
        let l = gx.hypot(gy);
        let x = (l * l + self.coupler * self.coupler - self.rocker * self.rocker) / (2.0 * l);
        let y = side * (self.coupler * self.coupler - x * x).sqrt();
        let c = [b[0] + (x * gx - y * gy) / l, b[1] + (x * gy + y * gx) / l];
        c[0].is_finite().then_some([b, c])
    }

    /// Returns the side of B-D on which the initial position lies.
    fn side(&self) -> f64 {
        let by = |side: f64| {
            let [_, c] = self.pins(self.angle, side).unwrap();
            away(c, self.c)
        };
        if by(1.0) < by(-1.0) { 1.0 } else { -1.0 }
    }

    /// Returns P and X at a crank angle in degrees.
    fn coupler_points_at(&self, angle: f64) -> Vec<[f64; 2]> {
        let [b, c] = self.pins(angle, self.side()).unwrap();
        let (ux, uy) = ((c[0] - b[0]) / self.coupler, (c[1] - b[1]) / self.coupler);
        let place = |[x, y]: &[f64; 2]| [b[0] + x * ux - y * uy, b[1] + x * uy + y * ux];
        self.coupler_points.iter().map(place).collect()
    }
}

/// Checks that each written scene reaches the points of the task, within the reported errors and at
/// the crank angles of the JSON.
fn scenes_do_their_task(example: &str, slack: f64) {
    let out = new_folder(example);
    let at = out.to_str().unwrap();
    let output =
        run(command(&["synthesize", example, "--format", "json"]).args(["--top", "3", "-o", at]));
    assert_eq!(output.code, 0, "{}", output.err);
    let output = json(&output.out);
    let candidates = output["candidates"].as_array().unwrap();
    assert!(!candidates.is_empty());
    for (number_of, candidate) in (1..).zip(candidates) {
        let path = out.join(format!("candidate-{number_of}.toml"));
        let checked = krank(&["check", path.to_str().unwrap()]);
        assert_eq!(checked.code, 0, "{}{}", checked.out, checked.err);
        let scene = WrittenFourBar::read(&path);
        // Scene and JSON contain the same doubles.
        assert_eq!(scene.a, pair(&candidate["A"]));
        assert_eq!(scene.d, pair(&candidate["partner"]["D"]));
        let lengths = [scene.crank, scene.coupler, scene.rocker];
        assert_eq!(lengths, ["r2", "r3", "r4"].map(|r| number(&candidate[r])));
        let angles = candidate["driver"].as_array().unwrap();
        assert_eq!(angles.len(), scene.marks[0].len());
        let (mut worst, mut squares) = (0.0_f64, 0.0);
        for (point, angle) in angles.iter().enumerate() {
            let guided = scene.coupler_points_at(number(angle));
            let miss = away(guided[0], scene.marks[0][point]);
            worst = worst.max(miss);
            squares += miss * miss;
            if let Some(x) = guided.get(1) {
                assert!(away(*x, scene.marks[1][point]) < slack, "{point}");
            }
        }
        let rms = (squares / angles.len() as f64).sqrt();
        assert!(
            (worst - number(&candidate["miss"])).abs() < slack,
            "{worst} {candidate}"
        );
        assert!(
            (rms - number(&candidate["rms"])).abs() < slack,
            "{rms} {candidate}"
        );
    }
}

#[test]
fn pose_scenes_reach_their_poses() {
    scenes_do_their_task("wiper", 1e-9);
    scenes_do_their_task("hatch", 1e-6);
}

#[test]
fn path_scenes_reach_their_points() {
    scenes_do_their_task("straight-line", 1e-9);
    scenes_do_their_task("stirrer", 1e-7);
}

/// Computes y = log10 x over 60 and 60 degrees by the law of cosines at 1000 points, and compares
/// with the reported structural error.
#[test]
fn function_scenes_have_the_reported_structural_error() {
    let out = new_folder("logarithm");
    let printed = run(command(&["synthesize", "logarithm", "--format", "json", "-o"]).arg(&out));
    let printed = json(&printed.out);
    let candidates = printed["candidates"].as_array().unwrap();
    assert!(!candidates.is_empty());
    let misses: Vec<f64> = candidates.iter().map(|c| number(&c["miss"])).collect();
    assert!(misses.is_sorted(), "the smallest first: {misses:?}");
    for (k, candidate) in (1..).zip(candidates) {
        let scene = WrittenFourBar::read(&out.join(format!("candidate-{k}.toml")));
        let side = scene.side();
        let angles: Vec<f64> = candidate["driver"]
            .as_array()
            .unwrap()
            .iter()
            .map(number)
            .collect();
        // Inset of the first of five Chebyshev points; the crank turns 60 degrees over the range.
        let inset = 0.5 - 0.5 * (std::f64::consts::PI / 10.0).cos();
        let scale = 60.0 * (angles[4] - angles[0]).signum();
        assert!((angles[4] - angles[0] - scale * (1.0 - 2.0 * inset)).abs() < 1e-9);
        let output = |x: f64| {
            let [_, c] = scene
                .pins(angles[0] + scale * (x - 1.0 - inset), side)
                .unwrap();
            (c[1] - scene.d[1]).atan2(c[0] - scene.d[0]).to_degrees()
        };
        let wanted = |x: f64| 60.0 * x.log10() / 2.0_f64.log10();
        let start = 1.0 + inset;
        let error = |x: f64| {
            let off = output(x) - output(start) - wanted(x) + wanted(start);
            (off + 180.0).rem_euclid(360.0) - 180.0
        };
        let worst = (0..=1000).map(|k| error(1.0 + f64::from(k) / 1000.0).abs());
        let worst = worst.fold(0.0, f64::max);
        let miss = number(&candidate["miss"]);
        assert!((worst - miss).abs() < 0.01 * miss + 1e-9, "{worst} {miss}");
        let printed = candidate["structural_error"].as_array().unwrap();
        assert!(printed.len() > 100 && pair(&printed[0])[0] == 1.0);
        for one in printed {
            let [x, printed] = pair(one);
            assert!((error(x) - printed).abs() < 1e-6, "{x} {printed}");
        }
    }
}

/// Replaces numbers that are only rounding errors, since these differ between machines.
fn without_rounding(text: &str) -> String {
    let tiny = |word: &str| word.contains("e-1") && word.parse::<f64>().is_ok_and(|x| x < 1e-9);
    let words = text
        .split_inclusive(' ')
        .map(|word| match tiny(word.trim_end()) {
            true => word.replace(|c: char| c != ' ', "~"),
            false => word.to_owned(),
        });
    words.collect()
}

#[test]
fn example_reports_match_snapshots() {
    for example in ["wiper", "hatch", "logarithm"] {
        let output = run_ok(&["synthesize", example, "--top", "3"]);
        insta::assert_snapshot!(format!("synthesize_{example}"), without_rounding(&output));
    }
}

/// Returns the commands of a chapter, with continuation lines joined.
fn commands(text: &str) -> Vec<String> {
    let text = text.replace("\\\n      ", "");
    let lines = text
        .lines()
        .filter_map(|line| line.strip_prefix("    krank "));
    lines.map(str::to_owned).collect()
}

/// Splits a line into arguments as a shell does.
pub(super) fn arguments(line: &str) -> Vec<&str> {
    let parts = line.split('\'').enumerate();
    let parts = parts.flat_map(|(k, part)| match k % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    parts.collect()
}

/// After the manual's edits of a candidate, the body still reaches its poses. Checked by loop closure.
#[test]
fn manual_design_still_reaches_its_poses() {
    let here = new_folder("manual");
    fs::create_dir_all(&here).unwrap();
    let manual = include_str!("../../src/manual/english/synthesis.md");
    let mut kept = Vec::new();
    for line in commands(manual) {
        let args = arguments(&line);
        // The workbench needs a terminal.
        if args.contains(&"--view") {
            continue;
        }
        let output = run(command(&args).current_dir(&here));
        assert_eq!(output.code, 0, "{line}: {}", output.err);
        let places = args.iter().filter_map(|arg| arg.strip_prefix("P.x@"));
        kept.extend(places.map(|at| at.split(' ').next().unwrap().parse::<f64>().unwrap()));
    }
    let [given, better] = ["wiper/candidate-1.toml", "better.toml"].map(|name| here.join(name));
    let scene = WrittenFourBar::read(&better);
    assert_ne!(scene.rocker, WrittenFourBar::read(&given).rocker);
    assert_eq!(kept.len(), 3);
    for (point, angle) in kept.iter().enumerate() {
        for (guided, marks) in scene.coupler_points_at(*angle).iter().zip(&scene.marks) {
            assert!(away(*guided, marks[point]) < 1e-5, "{point} {guided:?}");
        }
    }
    // The scene's comment names the same goals as the manual.
    let written = fs::read_to_string(&given).unwrap();
    for angle in kept {
        assert!(written.contains(&format!("'P.x@{angle:?} = ")), "{angle}");
    }
    // Remarks on the numbers are comments next to them: the edited scene would keep a `note`.
    assert!(!written.contains("\nnote"), "{written}");
    let printed = run_ok(&["check", better.to_str().unwrap()]);
    assert!(!printed.contains("driven through its task"), "{printed}");
}

#[test]
fn csv_and_json_contain_the_same_doubles() {
    let of = |format: &str| run_ok(&["synthesize", "hatch", "--format", format]);
    let told = json(&of("json"));
    let csv = of("csv");
    let table = rows(&csv);
    let headers: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    let column = |name: &str| {
        let of_name = |head: &&str| head.split(" [").next() == Some(name);
        headers
            .iter()
            .position(of_name)
            .unwrap_or_else(|| panic!("{name} of {headers:?}"))
    };
    let good = told["candidates"].as_array().unwrap();
    let defective = told["defective"].as_array().unwrap();
    assert_eq!(table.len(), good.len() + defective.len());
    for (row, candidate) in table.iter().zip(good.iter().chain(defective)) {
        for (name, value) in [
            ("A.x", &candidate["A"][0]),
            ("D.y", &candidate["partner"]["D"][1]),
            ("B.x", &candidate["B"][0]),
            ("C.y", &candidate["C"][1]),
            ("P.x", &candidate["P"][0]),
            ("r2", &candidate["r2"]),
            ("r4", &candidate["r4"]),
            ("r1", &candidate["r1"]),
            ("from", &candidate["defects"][0]["from"]),
            ("to", &candidate["defects"][0]["to"]),
            ("transmission", &candidate["transmission"]),
            ("ratio", &candidate["ratio"]),
            ("miss", &candidate["miss"]),
            ("rms", &candidate["rms"]),
            ("angle_miss", &candidate["angle_miss"]),
        ] {
            let cell = &row[column(name)];
            assert_eq!(cell.parse::<f64>().ok(), value.as_f64(), "{name}");
        }
    }
    assert_eq!(table[0][0], "1");
    assert_eq!(table[0][column("state")], "ok");
    assert_eq!(table[0][column("family")], "four-bar");
    assert_eq!(table[good.len()][0], "", "what is defective has no number");
    assert_eq!(table[good.len()][column("state")], "circuit");
    assert_eq!(table[good.len() + 1][column("state")], "branch");
    // CSV and JSON do not depend on the language.
    for format in ["csv", "json"] {
        let args = ["synthesize", "hatch", "--format", format];
        assert_eq!(spoken("tr", &folder("synthesize"), &args).out, of(format));
    }
}

/// No four-bar draws a square: the nearest ones are reported as too far off, and none as a solution.
#[test]
fn far_solutions_count_as_failures() {
    let points = "[[0, 0], [50, 0], [100, 0], [100, 50], [100, 100], [50, 100], [0, 100], [0, 50]]";
    let text = format!("kind = \"path\"\nclosed = true\npoints = {points}\n");
    let ended = krank(&[
        "synthesize",
        &task("square.toml", &text),
        "--format",
        "json",
    ]);
    assert_eq!(ended.code, 1, "{}", ended.err);
    let told = json(&ended.out);
    assert_eq!(told["candidates"].as_array().unwrap().len(), 0);
    let first = &told["defective"][0];
    assert_eq!(first["defects"][0]["state"], "far");
    assert!(
        number(&first["miss"]) > 0.05 * 100.0 * 2.0_f64.sqrt(),
        "{first}"
    );
}

#[test]
fn existing_scenes_are_not_overwritten() {
    let out = new_folder("kept");
    let args = [
        "synthesize",
        "hatch",
        "--top",
        "1",
        "-o",
        out.to_str().unwrap(),
    ];
    let first = krank(&args);
    assert_eq!(first.code, 0, "{}", first.err);
    assert!(first.err.contains("1 scene in "), "{}", first.err);
    // Writing the same scenes again loses nothing.
    assert_eq!(krank(&args).code, 0);
    let path = out.join("candidate-1.toml");
    fs::write(&path, "mine").unwrap();
    let again = krank(&args);
    assert_eq!(again.code, 1);
    assert!(again.err.contains("candidate-1.toml"), "{}", again.err);
    assert!(!again.err.contains("exercise"), "{}", again.err);
    assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
    // A file is not accepted as the folder.
    let args = [&args[..5], &[path.to_str().unwrap()]].concat();
    let none = krank(&args);
    assert_eq!(none.code, 1, "{}", none.err);
    assert!(
        !none.err.contains("candidate-1.toml/candidate-1"),
        "{}",
        none.err
    );
}

#[test]
fn task_without_solution_exits_with_1_and_writes_nothing() {
    // Any four-bar on these pivots has the three positions on two circuits.
    let text = "kind = \"poses\"\nposes = [[0, 0, 0], [10, 0, 170], [0, 12, 20]]\n\
                pivots = [[-40, -5], [300, 260]]\n";
    let path = task("nothing.toml", text);
    let out = new_folder("nothing");
    let ended = krank(&["synthesize", &path, "-o", out.to_str().unwrap()]);
    assert_eq!(ended.code, 1, "{}{}", ended.out, ended.err);
    assert!(ended.out.contains("defective"), "{}", ended.out);
    assert!(ended.err.contains("no linkage was found"), "{}", ended.err);
    assert!(!out.exists(), "nothing is written of nothing");
}

#[test]
fn unreadable_task_exits_with_2() {
    let message = refused(2, &["synthesize", "wipper"]);
    assert!(message.contains("available: wiper"), "{message}");
    let message = refused(2, &["synthesize", "zzzzzzzzzzz"]);
    assert!(message.contains("wiper, hatch, logarithm"), "{message}");
    refused(2, &["synthesize", "not-there.toml"]);
    refused(2, &["synthesize", "hatch", "--tolerance", "-1"]);
    let path = task("broken.toml", "kind = \"poses\"\nposes = [[0, 0, 0]]\n");
    let message = refused(2, &["synthesize", &path]);
    assert!(message.contains("broken.toml:2:9"), "{message}");
}

#[test]
fn task_can_come_from_standard_input() {
    let text = "kind = \"poses\"\nposes = [[0, 0, 0], [120, 40, 35], [180, 130, 80]]\n\
                pivots = [[0, -100], [200, -100]]\n";
    let mut piped = command(&["synthesize", "-", "--format", "json"]);
    let Run { out, err, .. } = run(piped.write_stdin(text));
    assert_eq!(json(&out)["task"], "stdin", "{err}");
    let file = run_ok(&["synthesize", &task("piped.toml", text), "--format", "json"]);
    assert_eq!(json(&out)["candidates"], json(&file)["candidates"]);
}

#[test]
fn tolerance_option_is_written_to_the_scene() {
    let out = new_folder("tolerance");
    let args = ["synthesize", "hatch", "--top", "1", "--tolerance", "0.1"];
    let ended = run(command(&args).arg("-o").arg(&out));
    assert_eq!(ended.code, 0, "{}", ended.err);
    let path = out.join("candidate-1.toml");
    let path = path.to_str().unwrap();
    let output = run_ok(&[
        "tolerance",
        path,
        "--columns",
        "P.x",
        "--at",
        "0",
        "--format",
        "json",
    ]);
    let worst = &json(&output)["figures"]["P.x"]["worst"];
    assert!(number(&worst["high"]) > number(&worst["low"]), "{worst}");
}

#[test]
fn tasks_and_scenes_are_not_interchangeable() {
    let text = "kind = \"poses\"\nposes = [[0, 0, 0], [1, 1, 10], [2, 0, 20]]\n";
    let path = task("own.toml", text);
    for args in [&["check", path.as_str()][..], &[path.as_str()]] {
        let message = refused(2, args);
        assert!(message.contains("this is a task, not a scene"), "{message}");
        assert!(message.contains("krank synthesize"), "{message}");
    }
    let message = refused(2, &["check", "hatch"]);
    assert!(message.contains("krank synthesize hatch"), "{message}");
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("presets/four-bar.toml");
    let scene = scene.to_str().unwrap().to_owned();
    let message = refused(2, &["synthesize", &scene]);
    assert!(message.contains("this is a scene, not a task"), "{message}");
    let message = refused(2, &["synthesize", "four-bar"]);
    assert!(message.contains("is a preset, not a task"), "{message}");
}

#[test]
fn turkish_report_contains_no_english() {
    let here = folder("synthesize");
    let Run { code, out, err } = spoken("tr", &here, &["synthesize", "hatch"]);
    assert_eq!(code, 0, "{err}");
    for word in ["linkage", "crank", "wanted", "defective", "circuit", "miss"] {
        assert!(!out.contains(word), "{word}\n{out}");
    }
    let Run { code, err, .. } = spoken("tr", &here, &["synthesize", "wipper"]);
    assert_eq!(code, 2);
    assert!(err.contains("wiper"), "{err}");
}
