//! Tests the working: it is complete, consistent line by line, and agrees with the solver.

use krank::page::{Content, Line, TextStyle};
use krank::report::{WorkedState, Working};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, Workspace};

const PLAIN: TextStyle = TextStyle {
    ascii: true,
    width: 80,
};

/// A scene with its solver, its working and a state.
struct Bench {
    scene: Scene,
    solver: Solver,
    working: Working,
    state: Workspace,
}

impl Bench {
    fn of(name: &str) -> Bench {
        let preset = presets::find(name).unwrap();
        Bench::parsed(preset.text, name)
    }

    fn parsed(text: &str, name: &str) -> Bench {
        let scene = Scene::parse(text, name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        Bench {
            working: Working::new(&scene, &solver),
            state: solver.state(),
            scene,
            solver,
        }
    }

    fn at(&mut self, at: f64, digits: usize) -> WorkedState {
        let _ = self.solver.solve(at, Order::Force, &mut self.state);
        self.working
            .of(&self.scene, &self.solver, &self.state, digits)
    }

    /// Returns coordinates over the whole motion, including its ends and positions beyond them.
    fn places(&self) -> Vec<f64> {
        let (low, high) = self.solver.motion().range.ends();
        let step = (high - low) / 24.0;
        let mut coordinates: Vec<f64> = (0..=24).map(|k| low + step * f64::from(k)).collect();
        let motion = self.solver.motion();
        coordinates.extend(motion.change_points.iter().chain(&motion.dead_points));
        coordinates.extend([low - step, high + step, self.scene.mechanism.driver().start]);
        coordinates
    }
}

fn text(computed: &WorkedState) -> String {
    computed.page.to_text(PLAIN)
}

// ---- values of the solver

/// The rounding error of the printed formulas: a few roundings of their terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Forms that no preset has: a guide with an offset from its pivot, a barrel with an offset, a
/// block locked to a moving link, a guide on a moving link, and a joint between two oblique guides.
pub(crate) const OTHERS: [(&str, &str); 5] = [
    (
        "offset lever",
        r#"
[ground]
A = [0, 0]
O = [0, -120]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
acceleration = "7 rad/s^2"
[links]
r2 = { from = "A", to = "B", length = 50 }
r4 = { from = "O", to = "T", length = 200 }
[slides]
r3 = { point = "B", on = "r4", through = [15, 12], angle = 10 }
[start]
T = [30, 78]
"#,
    ),
    (
        "offset barrel",
        r#"
unit = "m"
[ground]
O = [0.6, -0.35]
Q = [0, 0]
[driver]
slide = "rod"
position = 2.0
speed = "0.15 m/s"
acceleration = "0.02 m/s^2"
[links]
barrel = { points = { O = [0, 0], N = [1.5, 0] }, com = [0.5, 0], mass = 20, inertia = 2 }
boom = { points = { Q = [0, 0], P = [2.3, 0.45] } }
[slides]
rod = { point = "P", on = "barrel", through = [0.1, 0.2], angle = 5 }
[start]
P = [2, 1.1]
[[loads]]
point = "P"
force = [30, -200]
"#,
    ),
    (
        "block on a lever",
        r#"
[ground]
A = [0, 0]
O = [0, -120]
[driver]
link = "r2"
angle = 60
speed = "10 rad/s"
[links]
r2 = { from = "A", to = "B", length = 50 }
block = { points = { S = [0, 0], B = [4, 9] } }
r4 = { from = "O", to = "T", length = 200, com = [100, 0], mass = 1, inertia = 0.01 }
[slides]
r3 = { link = "block", on = "r4", through = "O", angle = 0, turn = 30 }
[start]
T = [30, 78]
S = [20, 35]
"#,
    ),
    (
        "slider on a coupler",
        r#"
[ground]
A = [0, 0]
D = [400, 0]
E = [150, 320]
[driver]
link = "r2"
angle = 60
speed = "15 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
r4 = { from = "C", to = "D", length = 250 }
r5 = { from = "E", to = "F", length = 170 }
[slides]
r6 = { point = "F", on = "r3", through = "B", angle = 15 }
[start]
C = [310, 230]
F = [190, 175]
[vectors]
r1 = ["D", "A"]
BF = ["E", "C"]
"#,
    ),
    (
        "two guides",
        r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 40
speed = "3 rad/s"
[links]
r2 = { from = "A", to = "B", length = 50 }
yoke = { points = { Y = [0, 0] } }
[slides]
r3 = { point = "B", on = "yoke", through = "Y", angle = 70 }
r4 = { link = "yoke", on = "ground", through = [10, 5], angle = 20, turn = 15 }
[start]
Y = [25, 0]
"#,
    ),
];

/// Returns all presets, and forms that no preset has.
fn benches() -> impl Iterator<Item = (&'static str, Bench)> {
    let presets = presets::all().iter();
    let presets = presets.map(|preset| (preset.name, Bench::of(preset.name)));
    presets.chain(OTHERS.map(|(name, text)| (name, Bench::parsed(text, name))))
}

#[test]
fn worked_values_agree_with_the_solver() {
    for (name, mut bench) in benches() {
        for at in bench.places() {
            let computed = bench.at(at, 6);
            for agreement in &computed.agreements {
                assert!(
                    agreement.part() <= ROUNDING,
                    "{} at {at} ({:?}): {agreement:?} off by {:e}",
                    name,
                    bench.state.condition(),
                    agreement.part()
                );
            }
            let rates = bench.state.condition() == Condition::Ok;
            assert!(
                !rates || !computed.agreements.is_empty(),
                "{} at {at}",
                name
            );
        }
    }
}

/// Where a link stops turning, its instant centre goes through infinity: near and at that position,
/// the working stays correct.
#[test]
fn instant_centres_stay_valid_through_infinity() {
    let mut met = 0;
    for (name, mut bench) in benches() {
        let links: Vec<_> = bench.scene.mechanism.link_ids().collect();
        let (low, high) = bench.solver.motion().range.ends();
        for link in links {
            let omega = |bench: &mut Bench, at: f64| {
                let condition = bench.solver.solve(at, Order::Force, &mut bench.state);
                (condition == Condition::Ok).then(|| bench.state.omega(link).unwrap())
            };
            let coordinates: Vec<f64> = (0..=60)
                .map(|k| low + (high - low) * f64::from(k) / 60.0 + 0.003)
                .collect();
            for pair in coordinates.windows(2) {
                let [mut from, mut to] = [pair[0], pair[1]];
                let ends = [omega(&mut bench, from), omega(&mut bench, to)];
                let [Some(start), Some(end)] = ends else {
                    continue;
                };
                if start * end >= 0.0 {
                    continue;
                }
                for _ in 0..60 {
                    let middle = (from + to) / 2.0;
                    match omega(&mut bench, middle) {
                        Some(w) if w * start > 0.0 => from = middle,
                        _ => to = middle,
                    }
                }
                // A link at rest has no instant centre, and only rounding is left to compare.
                let members = bench.scene.mechanism.link(link).members.iter();
                let speed = |point| bench.state.velocity(point).unwrap().norm();
                if members.map(|m| speed(m.point)).fold(0.0, f64::max) < 1e-6 {
                    continue;
                }
                for off in [0.0, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 0.1] {
                    let computed = bench.at(from - off, 6);
                    for agreement in &computed.agreements {
                        let part = agreement.part();
                        let at = from - off;
                        assert!(part <= ROUNDING, "{name} at {at}: {agreement:?}: {part:e}");
                    }
                    let text = text(&computed);
                    assert!(!text.contains("NaN") && !text.contains("inf "), "{text}");
                }
                met += 1;
            }
        }
    }
    assert!(met > 20, "{met}");
}

/// A student finds the centre as the intersection of the crank's line and the rocker's line, about
/// which the coupler turns.
#[test]
fn four_bar_instant_centres_match_snapshot() {
    let text = text(&Bench::of("four-bar").at(60.0, 6));
    insta::assert_snapshot!("working-centres", part(&text, "8 Instant", "9 Check"));
}

// ---- complete, finite, plain

#[test]
fn working_names_all_links_vectors_and_groups_in_ascii() {
    for (name, mut bench) in benches() {
        for at in bench.places() {
            let computed = bench.at(at, 6);
            let text = text(&computed);
            let context = format!("{} at {at}:\n{text}", name);
            assert!(text.is_ascii(), "{context}");
            let mut words = text.split(|c: char| !c.is_alphanumeric());
            assert!(
                !words.any(|word| matches!(word, "NaN" | "inf")),
                "{context}"
            );
            let rows: Vec<&str> = text.lines().map(str::trim_start).collect();
            let has_row = |name: &str| rows.iter().any(|row| row.split(' ').next() == Some(name));
            for vector in &bench.scene.vectors {
                assert!(has_row(&vector.name), "{}: {context}", vector.name);
            }
            for link in bench.scene.mechanism.link_ids() {
                let link = bench.scene.link_name(link);
                assert!(has_row(link), "{link}: {context}");
            }
            for number in 1..=bench.solver.plan().groups.len() {
                assert!(text.contains(&format!("Group {number}, ")), "{context}");
            }
            let markdown = computed.page.to_markdown(true);
            assert!(
                markdown.is_ascii() && markdown.starts_with("# "),
                "{markdown}"
            );
        }
    }
}

#[test]
fn lines_fit_their_width() {
    for preset in presets::all() {
        let mut bench = Bench::of(preset.name);
        let start = bench.scene.mechanism.driver().start;
        let computed = bench.at(start, 6);
        for width in [20, 38, 78, 118] {
            for ascii in [false, true] {
                let style = TextStyle { ascii, width };
                for line in computed.page.lines(style) {
                    let (role, line) = (line.role(), line.text());
                    let columns = line.chars().count();
                    let name = preset.name;
                    assert!(
                        columns <= width,
                        "{name}: {columns} of {width}: {role:?} {line}"
                    );
                    assert_eq!(line, line.trim_end(), "{name}");
                }
            }
        }
    }
}

/// Wrapping loses no part of a formula.
#[test]
fn wrapped_lines_keep_every_character() {
    let words = |lines: Vec<Line>| -> String {
        let all = lines.into_iter().map(|line| line.text());
        all.flat_map(|line| {
            line.chars()
                .filter(|c| !c.is_whitespace())
                .collect::<Vec<_>>()
        })
        .collect()
    };
    let mut bench = Bench::of("four-bar");
    let mut computed = bench.at(60.0, 9);
    // Tables repeat their first column.
    computed
        .page
        .blocks
        .retain(|block| !matches!(block.content, Content::Table(_)));
    let style = |width| TextStyle {
        ascii: false,
        width,
    };
    let text = words(computed.page.lines(style(10_000)));
    for width in [12, 20, 38, 60, 80] {
        assert_eq!(words(computed.page.lines(style(width))), text, "{width}");
    }
}

// ---- the loops

fn loops(name: &str) -> Vec<String> {
    let mut bench = Bench::of(name);
    let start = bench.scene.mechanism.driver().start;
    let text = text(&bench.at(start, 6));
    let part = text.split("2 Position table").next().unwrap();
    let lines = part.lines().filter(|line| line.ends_with(" = 0"));
    lines.map(|line| line.trim().to_owned()).collect()
}

#[test]
fn loops_equal_those_of_the_lectures() {
    assert_eq!(loops("four-bar"), ["r1 + r2 + r3 + r4 = 0"]);
    assert_eq!(loops("slider-crank"), ["r2 + r3 + r4 = 0"]);
    assert_eq!(loops("slotted-lever"), ["r2 + r3 - r1 = 0"]);
    // Two loops, the second from the ternary link to the ram, whose guide runs through Q.
    assert_eq!(
        loops("press-ram"),
        ["r1 + r2 + r3 - r4 = 0", "QD + r4e + r5 + r6 = 0"]
    );
    assert_eq!(loops("excavator-boom"), ["r2 + rod - r1 = 0"]);
    assert_eq!(loops("jansen-leg").len(), 3);
    assert_eq!(loops("stephenson-six-bar").len(), 2);
}

/// The number of independent loops is the number of joints minus that of moving links.
#[test]
fn loop_count_follows_structure() {
    for (name, count) in [
        ("watt-six-bar", 2),
        ("klann-leg", 2),
        // Two of the loops define additional vectors, OB and OP.
        ("peaucellier", 5),
        ("triple-parallelogram", 2),
        ("kite", 1),
    ] {
        assert_eq!(loops(name).len(), count, "{name}: {:?}", loops(name));
    }
}

// ---- the lectures, line by line

/// The exact values of the lectures' examples, to 25 digits.
const EXACT: &str = include_str!("../reference/lecture_values.json");

fn exact(path: &str) -> f64 {
    let values: serde_json::Value = serde_json::from_str(EXACT).unwrap();
    let value = path.split('.').fold(&values, |value, key| &value[key]);
    value.as_str().unwrap().parse().unwrap()
}

/// Returns the working of a preset to nine digits, with every formula on one line.
fn long_lines(name: &str, at: f64) -> String {
    let wide = TextStyle {
        ascii: true,
        width: 10_000,
    };
    Bench::of(name).at(at, 9).page.to_text(wide)
}

/// Returns the value at the end of a symbol's line, below a heading; with `at`, the direction after
/// it.
fn figure(text: &str, heading: &str, symbol: &str, at: bool) -> f64 {
    let below = &text[text
        .find(heading)
        .unwrap_or_else(|| panic!("{heading}:\n{text}"))..];
    let line = below
        .lines()
        .find(|line| line.trim_start().starts_with(&format!("{symbol} = ")));
    let line = line.unwrap_or_else(|| panic!("{symbol}:\n{text}"));
    let mut words = line.rsplit(" = ").next().unwrap().split(' ');
    let word = if at { words.nth(3) } else { words.next() };
    word.unwrap()
        .parse()
        .unwrap_or_else(|e| panic!("{line}: {e}"))
}

/// A value of the notes: its heading and symbol, whether it is a direction, the printed value, its
/// error, and the exact value.
struct Printed(&'static str, &'static str, bool, f64, f64, f64);

fn follow(text: &str, figures: &[Printed]) {
    for Printed(heading, symbol, at, printed, off, exact) in figures {
        let found = figure(text, heading, symbol, *at);
        let size = exact.abs().max(1.0);
        assert!(
            (found - exact).abs() <= 1e-8 * size,
            "{symbol}: {found}, not {exact}"
        );
        let miss = (found - printed).abs();
        assert!(
            miss <= *off,
            "{symbol}: {found} is {miss:e} away from the notes' {printed}"
        );
        // The stated error of the notes must not be far larger than the actual one.
        assert!(
            miss >= off / 12.0,
            "{symbol}: the notes are off by {miss:e} alone"
        );
    }
}

/// Weeks 3 and 7: the four-bar at 60 deg. The notes round intermediate results: alpha is off by
/// 4.6e-5 deg, and the accelerations of C, which follow from rates of four digits, by up to 4e-5
/// relative.
#[test]
fn four_bar_values_agree_with_lecture_notes() {
    let text = long_lines("four-bar", 60.0);
    let m = 350.0_f64.hypot(exact("B1.B.y"));
    let alpha = (exact("B1.B.y") / 350.0).atan().to_degrees();
    let theta3 = exact("B1.theta3_deg");
    let theta4 = 360.0 + exact("B1.theta4_deg");
    let (w4, a4) = (exact("B1.omega4"), exact("B1.alpha4"));
    let [tangential, normal] = [a4 * 250.0, w4 * w4 * 250.0];
    let to_turn = |degrees: f64| 360.0 + degrees;
    let (group, velocity, acceleration) = ("Group 2", "5 Velocities", "6 Accelerations");
    let (b, c, g3, g4) = ("B on r2", "C on r4", "r3.com on r3", "r4.com on r4");
    follow(
        &text,
        &[
            Printed(group, "m", false, 360.55512, 1e-5, m),
            Printed(group, "alpha", false, 13.897_841, 5e-5, alpha),
            Printed(group, "beta", false, 43.277_343, 1e-5, theta3 + alpha),
            Printed(
                group,
                "gamma",
                false,
                55.349_599,
                1e-5,
                360.0 - alpha - theta4,
            ),
            Printed(group, "theta3", false, 29.3795, 6e-5, theta3),
            Printed(velocity, "omega3", false, -3.916, 5e-4, exact("B1.omega3")),
            Printed(velocity, "omega4", false, 3.091, 1e-4, w4),
            Printed(
                acceleration,
                "alpha3",
                false,
                42.27,
                4e-3,
                exact("B1.alpha3"),
            ),
            Printed(acceleration, "alpha4", false, 95.5, 4e-3, a4),
            Printed(c, "aC", false, 23_994.18, 1.0, exact("B1.C.a")),
            Printed(
                c,
                "aC",
                true,
                206.47,
                5e-3,
                to_turn(exact("B1.C.a_dir_deg")),
            ),
            Printed(c, "aCt", false, 23_875.0, 1.0, tangential),
            Printed(c, "aCn", false, 2388.57, 0.2, normal),
            Printed(
                c,
                "beta",
                false,
                84.28,
                8e-3,
                (tangential / normal).atan().to_degrees(),
            ),
            Printed(g3, "a_r3.com", false, 22_260.0, 0.3, exact("B1.G3.a")),
            Printed(
                g3,
                "a_r3.com",
                true,
                222.68,
                5e-3,
                to_turn(exact("B1.G3.a_dir_deg")),
            ),
            Printed(g4, "a_r4.com", false, 11_997.09, 0.5, exact("B1.G4.a")),
            Printed(
                g4,
                "a_r4.com",
                true,
                206.47,
                5e-3,
                to_turn(exact("B1.G4.a_dir_deg")),
            ),
        ],
    );
    assert_eq!(figure(&text, b, "aB", false), 22_500.0);
    assert_eq!(figure(&text, b, "aB", true), 240.0);
    // The notes print 290.7520, but 290.75 in the drawing.
    let found = figure(&text, group, "theta4", false);
    assert!((found - theta4).abs() < 1e-6 && (found - 290.7520).abs() < 6e-4);
    assert!(text.contains("  theta3 = -alpha + beta = "), "{text}");
    assert!(text.contains("  theta4 = -alpha - gamma = "), "{text}");
}

/// Week 4: the slider-crank at 30 deg. The notes continue with four digits of theta3. Their second
/// root, -21.4, is twice the exact one, because the formula's division by two was forgotten there.
#[test]
fn slider_crank_values_agree_with_lecture_notes() {
    let text = long_lines("slider-crank", 30.0);
    let (group, velocity, acceleration) = ("Group 2", "5 Velocities", "6 Accelerations");
    follow(
        &text,
        &[
            Printed(velocity, "omega3", false, -89.45, 0.01, exact("B2.omega3")),
            Printed(velocity, "dr4/dt", false, -1447.93, 0.8, exact("B2.v4")),
            Printed(
                acceleration,
                "alpha3",
                false,
                8259.0,
                4.0,
                exact("B2.alpha3"),
            ),
            Printed(
                acceleration,
                "d2r4/dt2",
                false,
                -459_977.6,
                41.0,
                exact("B2.a4"),
            ),
        ],
    );
    let below = &text[text.find(group).unwrap()..];
    let roots = below
        .lines()
        .find(|line| line.contains("+- sqrt(p^2 - q)"))
        .unwrap();
    assert!(
        roots.ends_with(" = 28.0251708 or -10.7046627 cm"),
        "{roots}"
    );
    assert!((2.0_f64 * -10.7046627 + 21.4).abs() < 0.01);
    let theta = below
        .lines()
        .find(|line| line.trim_start().starts_with("theta3 = "))
        .unwrap();
    assert!(
        theta.ends_with(" = -14.4775122 deg = 345.522488 deg"),
        "{theta}"
    );
    assert!((exact("B2.theta3_deg") + 14.47).abs() < 0.01);
}

// ---- snapshots of small parts

/// Returns the text between two headings.
fn part<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let start = text.find(from).unwrap();
    let end = text[start..].find(to).map_or(text.len(), |end| start + end);
    &text[start..end]
}

#[test]
fn four_bar_group_matches_snapshot() {
    let text = text(&Bench::of("four-bar").at(60.0, 6));
    insta::assert_snapshot!("working-four-bar", part(&text, "1 Vector", "5 Velocities"));
}

#[test]
fn coupled_group_matches_snapshot() {
    let text = text(&Bench::of("stephenson-six-bar").at(60.0, 6));
    insta::assert_snapshot!("working-coupled", part(&text, "4.2 Group", "5 Velocities"));
}

#[test]
fn free_body_of_a_loaded_link_matches_snapshot() {
    let text = text(&Bench::of("four-bar-load").at(60.0, 6));
    insta::assert_snapshot!("working-forces", part(&text, "9 Forces", "9.2 Link"));
}

// ---- special states

#[test]
fn dead_point_has_positions_but_no_rates() {
    let mut bench = Bench::of("double-rocker");
    let at = bench.solver.motion().dead_points[0];
    let text = text(&bench.at(at, 6));
    assert_eq!(bench.state.condition(), Condition::DeadPoint);
    assert!(
        text.contains("State: dead-point.") && text.contains("A dead point:"),
        "{text}"
    );
    assert!(text.contains("do not exist at a dead point"), "{text}");
    assert!(!text.contains("rad/s\n"), "{text}");
}

#[test]
fn change_point_gives_limits_along_the_motion() {
    let mut bench = Bench::of("parallelogram");
    let text = text(&bench.at(0.0, 6));
    assert_eq!(bench.state.condition(), Condition::ChangePoint);
    assert!(text.contains("A change point:"), "{text}");
    assert!(text.contains("the limit along the motion is"), "{text}");
}

#[test]
fn triangle_explains_missing_assembly() {
    let mut bench = Bench::of("double-rocker");
    let range = bench.solver.motion().range;
    let Range::Limited { high, .. } = range else {
        panic!("{range:?}")
    };
    let text = text(&bench.at(high + 20.0, 6));
    assert!(text.contains("State: no-assembly."), "{text}");
    assert!(
        text.contains(
            "  r1 + r2 + r3 - r4 = 0
"
        ),
        "{text}"
    );
    let unbroken: Vec<&str> = text.split_whitespace().collect();
    let unbroken = unbroken.join(" ");
    assert!(
        unbroken.contains("do not reach each other") || unbroken.contains("cannot close"),
        "{text}"
    );
    assert!(text.contains('?'), "{text}");
}

/// The arm is too short for its guide.
#[test]
fn quadratic_explains_missing_assembly() {
    let text = "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 10\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 100 }\nr3 = { from = \"B\", to = \"C\", length = 50 }\n[slides]\n\
        r4 = { point = \"C\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nC = [140, 0]\n";
    let mut bench = Bench::parsed(text, "short");
    let text = self::text(&bench.at(80.0, 6));
    assert!(text.contains("r3 does not reach the guide"), "{text}");
}
