//! Tests of imported files: every scene opens in the pose of its drawing, has one input, and moves
//! with rigid links.
//!
//! The files in `tests/import` are in the published layouts of other programs. The places and the
//! rigid links below are written from the files by hand.

use krank::import::{ImportFormat, Imported, import, recognize};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Solver};
use krank::{Input, Vec2};
use proptest::prelude::*;
use std::collections::HashMap;
use std::path::PathBuf;

fn file(name: &str) -> Vec<u8> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/import");
    std::fs::read(folder.join(name)).unwrap()
}

fn imported(name: &str) -> Imported {
    import(&file(name), name).unwrap_or_else(|why| panic!("{name}: {why}"))
}

type Place = (&'static str, [f64; 2]);

/// What a file says.
struct Said {
    file: &'static str,
    format: ImportFormat,
    /// The size of a unit of the file in the scene's unit.
    scale: f64,
    /// All points by their names in the scene.
    places: &'static [Place],
    /// The names of the points of each moving link.
    rigid: &'static [&'static [&'static str]],
    /// Points and the straight lines on which they move: a place and a direction.
    lines: &'static [(&'static str, [f64; 2], [f64; 2])],
    /// The driven element, and how its coordinate opens; `None` for a driven link.
    driver: (&'static str, Option<f64>),
}

const MM: f64 = 25.4 / 96.0;
const INCH: f64 = 1.0 / 96.0;

const FOUR_BAR: &[Place] = &[
    ("A", [0.0, 0.0]),
    ("B", [15.0, 40.0]),
    ("C", [95.0, 75.0]),
    ("D", [120.0, -10.0]),
    ("E", [60.0, 95.0]),
];

const SAID: &[Said] = &[
    Said {
        file: "four-bar.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: FOUR_BAR,
        rigid: &[&["A", "B"], &["B", "C", "E"], &["C", "D"]],
        lines: &[],
        driver: ("input", None),
    },
    Said {
        file: "address.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: FOUR_BAR.split_at(4).0,
        rigid: &[&["A", "B"], &["B", "C"], &["C", "D"]],
        lines: &[],
        driver: ("input", None),
    },
    Said {
        file: "slider-crank.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: &[("A", [0.0, 0.0]), ("B", [3.0, 4.0]), ("C", [15.0, 1.0])],
        rigid: &[&["A", "B"], &["B", "C"]],
        lines: &[(
            "C",
            [15.0, 1.0],
            [0.984_807_753_012_208_1, 0.173_648_177_666_930_33],
        )],
        driver: ("crank", None),
    },
    Said {
        file: "inverted-slider.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [30.0, 40.0]),
            ("C", [-50.0, -20.0]),
            ("D", [30.0, 40.0]),
            ("E", [100.0, 77.0]),
        ],
        rigid: &[&["A", "D"], &["C", "E"]],
        lines: &[],
        driver: ("R", None),
    },
    Said {
        file: "multi-pin.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [30.0, 40.0]),
            ("C", [-80.0, 30.0]),
            ("D", [110.0, 50.0]),
            ("E", [-60.0, -50.0]),
            ("F", [90.0, -60.0]),
        ],
        rigid: &[
            &["A", "B"],
            &["B", "C"],
            &["B", "D"],
            &["C", "E"],
            &["D", "F"],
        ],
        lines: &[],
        driver: ("crank", None),
    },
    Said {
        file: "two-slots.pmks.txt",
        format: ImportFormat::Pmks,
        scale: 1.0,
        places: &[
            ("A", [40.0, 0.0]),
            ("B", [0.0, 30.0]),
            ("C", [20.0, 15.0]),
            ("D", [30.0, -20.0]),
            ("E", [5.0, -5.0]),
        ],
        rigid: &[&["A", "B", "C"], &["C", "D"], &["D", "E"]],
        lines: &[
            ("A", [40.0, 0.0], [1.0, 0.0]),
            ("B", [0.0, 30.0], [0.0, 1.0]),
        ],
        driver: ("crank", None),
    },
    Said {
        file: "slider-crank.pmks-plus.txt",
        format: ImportFormat::PmksPlus,
        scale: 1.0,
        places: &[
            ("a", [-1.5, -2.0]),
            ("b", [0.5, 2.0]),
            ("c", [2.75, 0.25]),
            ("F1", [1.5, 1.5]),
        ],
        rigid: &[&["a", "b"], &["b", "c", "F1"]],
        lines: &[("c", [2.75, 0.25], [1.0, 0.0])],
        driver: ("ab", None),
    },
    Said {
        file: "four-bar.pmks-plus.txt",
        format: ImportFormat::PmksPlus,
        scale: 1.0,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [1.0, 2.0]),
            ("C", [5.0, 3.0]),
            ("D", [6.0, -1.0]),
            ("E", [3.0, 5.0]),
        ],
        rigid: &[&["A", "B"], &["B", "C", "E"], &["C", "D"]],
        lines: &[],
        driver: ("AB", None),
    },
    Said {
        file: "four-bar.pyslvs",
        format: ImportFormat::Pyslvs,
        scale: 1.0,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [14.5, 30.25]),
            ("C", [70.0, 65.5]),
            ("D", [30.0, 70.0]),
            ("E", [92.0, 0.0]),
        ],
        rigid: &[&["A", "B"], &["B", "C", "D"], &["C", "E"]],
        lines: &[],
        driver: ("link_0", None),
    },
    Said {
        file: "sliders.pyslvs",
        format: ImportFormat::Pyslvs,
        scale: 1.0,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [20.0, 15.0]),
            ("C", [80.0, 5.0]),
            ("D", [100.0, 60.0]),
            ("E", [140.0, 10.0]),
        ],
        rigid: &[&["A", "B"], &["B", "C"], &["C", "D"], &["D", "E"]],
        lines: &[("C", [80.0, 5.0], [1.0, 0.0])],
        driver: ("crank", None),
    },
    Said {
        file: "four-bar.pylinkage.json",
        format: ImportFormat::Pylinkage,
        scale: 1.0,
        places: &[
            ("O1", [0.0, 0.0]),
            ("O2", [4.0, 0.5]),
            ("Crank_pin", [0.0, 1.0]),
            ("B", [3.0, 3.0]),
            ("P", [1.0, 3.5]),
        ],
        rigid: &[&["O1", "Crank_pin"], &["Crank_pin", "B", "P"], &["B", "O2"]],
        lines: &[],
        driver: ("crank", None),
    },
    Said {
        file: "slider-crank.pylinkage.json",
        format: ImportFormat::Pylinkage,
        scale: 1.0,
        places: &[("O", [0.0, 0.0]), ("A", [3.0, 4.0]), ("S", [15.0, 1.0])],
        rigid: &[&["O", "A"], &["A", "S"]],
        lines: &[(
            "S",
            [15.0, 1.0],
            [0.970_142_500_145_332_1, 0.242_535_625_036_333],
        )],
        driver: ("crank", None),
    },
    Said {
        file: "four-bar.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [0.0, 94.488_189]),
            ("C", [283.464_567, 150.0]),
            ("D", [340.0, -40.0]),
            ("E", [150.0, 260.0]),
        ],
        rigid: &[&["A", "B"], &["B", "C", "E"], &["C", "D"]],
        lines: &[],
        driver: ("link-1", None),
    },
    Said {
        file: "sliders.linkage2",
        format: ImportFormat::Linkage,
        scale: INCH,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [30.0, 40.0]),
            ("C", [150.0, 20.0]),
            ("D", [100.0, 20.0]),
            ("E", [260.0, 20.0]),
            ("G", [-50.0, -53.333_333]),
            ("H", [70.0, 86.666_667]),
            ("I", [200.0, 160.0]),
        ],
        rigid: &[&["A", "B"], &["B", "C"], &["G", "H", "I"]],
        lines: &[("C", [150.0, 20.0], [1.0, 0.0])],
        driver: ("link-1", None),
    },
    Said {
        file: "actuator.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [120.0, 20.0]),
            ("C", [150.0, 90.0]),
            ("D", [-60.0, -20.0]),
            ("E", [300.0, 120.0]),
        ],
        rigid: &[&["A", "B", "C", "E"]],
        lines: &[],
        // The distance from D to C: 210 and 110.
        driver: ("link-2", Some(237.065_391_823_6)),
    },
    Said {
        file: "two-actuators.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [120.0, 20.0]),
            ("C", [150.0, 90.0]),
            ("D", [-60.0, -20.0]),
            ("E", [300.0, 120.0]),
            ("F", [330.0, -80.0]),
        ],
        rigid: &[&["A", "B", "C", "E"], &["E", "F"]],
        lines: &[],
        driver: ("link-2", Some(237.065_391_823_6)),
    },
    Said {
        file: "fastened.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [30.0, 40.0]),
            ("C", [180.0, 90.0]),
            ("D", [220.0, -30.0]),
            ("E", [250.0, 150.0]),
            ("F", [300.0, 100.0]),
            ("G", [350.0, -60.0]),
        ],
        rigid: &[
            &["A", "B"],
            &["B", "C"],
            &["C", "D", "E"],
            &["E", "F"],
            &["F", "G"],
        ],
        lines: &[],
        driver: ("link-1", None),
    },
    Said {
        file: "arc-slot.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [-60.0, 0.0]),
            ("B", [-40.0, 30.0]),
            ("C", [82.635_182, 38.480_775]),
            ("D", [13.397_460, -10.0]),
            ("E", [176.604_444, 4.278_761]),
        ],
        rigid: &[&["A", "B"], &["B", "C"]],
        lines: &[],
        driver: ("link-1", None),
    },
    Said {
        file: "two-inputs.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [20.0, 50.0]),
            ("C", [200.0, 0.0]),
            ("D", [230.0, 40.0]),
            ("E", [120.0, 150.0]),
        ],
        rigid: &[&["A", "B"], &["C", "D"], &["B", "E"], &["D", "E"]],
        lines: &[],
        driver: ("link-1", None),
    },
    Said {
        file: "mixed-inputs.linkage2",
        format: ImportFormat::Linkage,
        scale: MM,
        places: &[
            ("A", [0.0, 0.0]),
            ("B", [20.0, 50.0]),
            ("C", [200.0, 0.0]),
            ("D", [230.0, 40.0]),
            ("E", [120.0, 150.0]),
            ("F", [330.0, -20.0]),
        ],
        rigid: &[
            &["A", "B"],
            &["C", "D"],
            &["B", "E"],
            &["D", "E"],
            &["D", "F"],
        ],
        lines: &[],
        driver: ("link-1", None),
    },
];

/// A scene, its solver and the ids of its points.
struct OpenedScene {
    scene: Scene,
    solver: Solver,
}

impl OpenedScene {
    fn new(name: &str, text: &str) -> OpenedScene {
        let scene =
            Scene::parse(text, name).unwrap_or_else(|why| panic!("{name}: {why:?}\n{text}"));
        let solver = Solver::new(&scene.mechanism);
        let solver = solver.unwrap_or_else(|why| panic!("{name}: {why:?}\n{text}"));
        OpenedScene { scene, solver }
    }

    /// Returns the places of all points at a coordinate of the driver.
    fn places(&self, at: f64) -> HashMap<String, Vec2> {
        let mut state = self.solver.state();
        let condition = self.solver.solve(at, Order::Position, &mut state);
        assert_ne!(condition, Condition::NoAssembly, "{at}");
        let points = self.scene.mechanism.point_ids();
        points
            .filter_map(|point| {
                let name = self.scene.point_name(point)?.to_owned();
                Some((name, state.position(point)?))
            })
            .collect()
    }
}

fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

/// The opening pose is the drawing, and 40 further positions have rigid links and straight slots.
#[test]
fn scenes_open_as_drawn_and_move() {
    for text in SAID {
        let name = text.file;
        assert_eq!(recognize(&file(name)), Some(text.format), "{name}");
        let imported = imported(name);
        assert_eq!(imported.format, text.format, "{name}");
        let opened = OpenedScene::new(name, &imported.text);
        let scaled = |at: [f64; 2]| at.map(|x| text.scale * x);
        let drawn: HashMap<&str, [f64; 2]> = text
            .places
            .iter()
            .map(|&(point, at)| (point, scaled(at)))
            .collect();
        let far = |one: &[f64; 2]| {
            drawn
                .values()
                .map(|other| distance(*one, *other))
                .fold(0.0, f64::max)
        };
        let size = drawn.values().map(far).fold(0.0, f64::max);

        let driver = opened.scene.mechanism.driver();
        assert_eq!(
            opened.scene.driven_name(driver.input),
            text.driver.0,
            "{name}"
        );
        if let Some(position) = text.driver.1 {
            assert!(matches!(driver.input, Input::Push(_)), "{name}");
            assert!(
                (driver.start - text.scale * position).abs() < 1e-9 * size,
                "{name} {driver:?}"
            );
        }
        let places = opened.places(driver.start);
        for (point, at) in &drawn {
            // Two joints at one place may be one point of the scene.
            let Some(found) = places.get(*point) else {
                assert!(
                    drawn
                        .iter()
                        .any(|(other, same)| other != point && same == at),
                    "{name} {point}"
                );
                continue;
            };
            let off = distance([found.x, found.y], *at);
            assert!(
                off <= 1e-9 * size,
                "{name}: {point} is {off:e} off\n{}",
                imported.text
            );
        }

        let (low, high) = opened.solver.motion().range.ends();
        assert!(high - low > 0.0, "{name}: [{low}, {high}]");
        let mut moved = 0.0_f64;
        for k in 1..=40_u32 {
            let at = low + (high - low) * (f64::from(k) - 0.5) / 40.0;
            let here = opened.places(at);
            for link in text.rigid {
                for pair in link.windows(2) {
                    let [one, other] =
                        [pair[0], pair[1]].map(|point| [here[point].x, here[point].y]);
                    let intended = distance(drawn[pair[0]], drawn[pair[1]]);
                    let off = (distance(one, other) - intended).abs();
                    // The actuator of `mixed-inputs` is held.
                    assert!(off <= 1e-9 * size, "{name} {at}: {pair:?} {off:e}");
                }
            }
            for (point, through, [cos, sin]) in text.lines {
                let [x, y] = scaled(*through);
                let off = (here[*point].x - x) * sin - (here[*point].y - y) * cos;
                assert!(off.abs() <= 1e-9 * size, "{name} {at}: {point} {off:e}");
            }
            for (point, from) in &drawn {
                if let Some(here) = here.get(*point) {
                    moved = moved.max(distance([here.x, here.y], *from));
                }
            }
        }
        assert!(moved > 1e-3 * size, "{name}: nothing moves");
    }
}

#[test]
fn a_pin_follows_its_arc() {
    let imported = imported("arc-slot.linkage2");
    let opened = OpenedScene::new("arc", &imported.text);
    let (low, high) = opened.solver.motion().range.ends();
    for k in 0..=20_u32 {
        let here = opened.places(low + (high - low) * f64::from(k) / 20.0);
        let off = distance([here["C"].x, here["C"].y], [100.0, -60.0].map(|x| x * MM)) - 100.0 * MM;
        assert!(off.abs() < 1e-6, "{off:e}");
    }
}

/// Returns a file of Linkage with a slider-crank, whose pin `C` slides between `D` and `E`.
fn slot_file(pin: [f64; 2], ends: [[f64; 2]; 2], attributes: &str) -> String {
    let [[dx, dy], [ex, ey]] = ends;
    let [x, y] = pin;
    format!(
        "<linkage2>\n\
         <connector id=\"0\" x=\"3.1\" y=\"-7.7\" anchor=\"true\" input=\"true\" rpm=\"15\"/>\n\
         <connector id=\"1\" x=\"-22.33\" y=\"31.713\"/>\n\
         <connector id=\"2\" x=\"{x:.6}\" y=\"{y:.6}\" slider=\"true\" {attributes}>\
         <slidelimit id=\"3\"/><slidelimit id=\"4\"/></connector>\n\
         <connector id=\"3\" x=\"{dx:.6}\" y=\"{dy:.6}\" anchor=\"true\"/>\n\
         <connector id=\"4\" x=\"{ex:.6}\" y=\"{ey:.6}\" anchor=\"true\"/>\n\
         <Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>\n\
         <Link id=\"1\"><connector id=\"1\"/><connector id=\"2\"/></Link>\n</linkage2>\n"
    )
}

/// The motion ends with the pin at the end of its slot.
#[test]
fn slots_end_the_motion() {
    let (d, e) = ([80.0, 10.0], [130.0, 30.0]);
    let pin = [0.5 * (d[0] + e[0]), 0.5 * (d[1] + e[1])];
    let imported = import(slot_file(pin, [d, e], "").as_bytes(), "slot").unwrap();
    assert_eq!(imported.remarks, [""; 0]);
    let opened = OpenedScene::new("slot", &imported.text);
    let (low, high) = opened.solver.motion().range.ends();
    for at in [low, high] {
        let here = opened.places(at);
        let at_end = |end: [f64; 2]| {
            distance([here["C"].x, here["C"].y], end.map(|x| MM * x)) < 1e-9 * distance(d, e)
        };
        // Both ends of the slot are farther apart than the crank can push the pin.
        assert!(at_end(d) || at_end(e), "{at}: {here:?}\n{}", imported.text);
    }
    // The same for the middle of an arc of radius 40.
    let half = 0.5 * distance(d, e);
    let across = [-(e[1] - d[1]), e[0] - d[0]].map(|x| 0.5 * x / half);
    let height = (40.0_f64 * 40.0 - half * half).sqrt();
    let on_arc = [0, 1].map(|i| pin[i] + (40.0 - height) * across[i]);
    let text = slot_file(on_arc, [d, e], "slideradius=\"40\"");
    let imported = import(text.as_bytes(), "arc").unwrap();
    assert_eq!(imported.remarks, [""; 0]);
    let opened = OpenedScene::new("arc", &imported.text);
    let (low, high) = opened.solver.motion().range.ends();
    for at in [low, high] {
        let here = opened.places(at);
        let off = |end: [f64; 2]| distance([here["C"].x, here["C"].y], end.map(|x| MM * x));
        // The pin of the file has six decimals.
        let off = off(d).min(off(e));
        assert!(off < 1e-6 * half, "{at}: {off:e}\n{}", imported.text);
    }
}

/// Regression test: a pin at the end of its slot was beyond it by a rounding error.
#[test]
fn pins_at_the_ends_of_slots_open() {
    let turned = |angle: f64, length: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        [61.234_567 + length * cos, 12.345_678 + length * sin]
    };
    for k in 0..72_u32 {
        let angle = 5.0 * f64::from(k) + 1.3;
        let ends = [turned(angle, 0.0), turned(angle, 47.11)];
        for pin in ends {
            let text = slot_file(pin, ends, "");
            let imported = import(text.as_bytes(), "slot").unwrap();
            assert_eq!(imported.remarks, [""; 0], "{angle}\n{}", imported.text);
            assert!(imported.text.contains("\n[limits]"), "{}", imported.text);
            let opened = OpenedScene::new("slot", &imported.text);
            let here = opened.places(opened.scene.mechanism.driver().start);
            let off = distance([here["C"].x, here["C"].y], pin.map(|x| MM * x));
            // Six decimals of the file.
            assert!(off < 1e-6, "{angle}: {off:e}\n{}", imported.text);
        }
    }
}

/// A pin that is drawn beyond its slot has no limits, and krank says so.
#[test]
fn pins_beyond_their_slots_are_reported() {
    let read = |pin, attributes| {
        let ends = [[80.0, 0.0], [120.0, 0.0]];
        import(slot_file(pin, ends, attributes).as_bytes(), "slot").unwrap()
    };
    let beyond = read([70.0, 0.0], "");
    assert!(
        beyond.remarks
            == [
                "line 4, connector 2: the pin is drawn beyond the ends of its slot; the scene has no limits for it"
            ],
        "{:?}",
        beyond.remarks
    );
    assert!(!beyond.text.contains("[limits]"), "{}", beyond.text);
    OpenedScene::new("beyond", &beyond.text);
    // An arc slot with its centre at (100, -21): the pin is beside its upper arc.
    let beyond = read([71.0, -21.0], "slideradius=\"29\"");
    assert!(
        beyond
            .remarks
            .iter()
            .any(|remark| remark.contains("beyond the ends")),
        "{:?}",
        beyond.remarks
    );
}

/// The stroke of every actuator is that of the file, also where it is held.
#[test]
fn strokes_of_further_actuators_are_limits() {
    let text = imported("two-actuators.linkage2").text;
    let scene = Scene::parse(&text, "t").unwrap();
    let limits: Vec<f64> = scene
        .mechanism
        .limit_ids()
        .map(|id| scene.mechanism.limit(id))
        .map(|limit| limit.high - limit.low)
        .collect();
    let [_, further] = limits[..] else {
        panic!("{limits:?}\n{text}");
    };
    assert!((further - 20.0 * MM).abs() < 1e-9, "{limits:?}");
}

#[test]
fn slots_turn_with_their_links() {
    // The pin of the crank is on the line from C through the rocker's direction.
    let opened = OpenedScene::new("slot", &imported("inverted-slider.pmks.txt").text);
    for at in [-170.0, -60.0, 10.0, 95.0] {
        let here = opened.places(at);
        let (c, d, e) = (here["C"], here["D"], here["E"]);
        // In the drawing, E is off the slot by the angle from C to E.
        let angle = |p: Vec2| p.y.atan2(p.x);
        let turned =
            angle(Vec2::new(e.x - c.x, e.y - c.y)) - angle(Vec2::new(d.x - c.x, d.y - c.y));
        let drawn = 97_f64.atan2(150.0) - 60_f64.atan2(80.0);
        let off = (turned - drawn).rem_euclid(std::f64::consts::PI);
        assert!(off.min(std::f64::consts::PI - off) < 1e-9, "{at}: {off:e}");
    }
}

#[test]
fn speeds_ratios_and_sine_are_taken_over() {
    let text = imported("two-inputs.linkage2").text;
    assert!(text.contains("speed = \"-15 rpm\""), "{text}");
    let scene = Scene::parse(&text, "t").unwrap();
    let [timed] = scene.mechanism.timed() else {
        panic!("{text}");
    };
    // 30 rpm the other way round. The cranks open at atan2(50, 20) and atan2(40, 30).
    let [first, second] = [50_f64.atan2(20.0), 40_f64.atan2(30.0)].map(f64::to_degrees);
    assert!((timed.coordinate(first) - second).abs() < 1e-9);
    assert!((timed.coordinate(first + 1.0) - (second - 2.0)).abs() < 1e-9);

    let text = imported("actuator.linkage2").text;
    let scene = Scene::parse(&text, "t").unwrap();
    let law = scene.motion.expect("a sine");
    let start = scene.mechanism.driver().start;
    assert!((law.period() - 4.0).abs() < 1e-12);
    // The throw is 50 from the drawing outwards: a sine about the middle.
    let stroke = 50.0 * MM;
    for (time, share) in [
        (0.0, 0.0),
        (1.0, 0.5),
        (2.0, 1.0),
        (3.0, 0.5),
        (4.0, 0.0),
        (1.0 / 3.0, 0.066_987_298),
    ] {
        let at = law.at(time).at - start;
        assert!((at - share * stroke).abs() < 1e-7 * stroke, "{time}: {at}");
    }
    let fastest = std::f64::consts::PI / 4.0 * stroke;
    assert!((law.at(1.0).speed - fastest).abs() < 1e-11 * fastest);

    let text = imported("slider-crank.pmks-plus.txt").text;
    for part in [
        "unit   = \"cm\"",
        "speed = \"-10 rpm\"",
        "gravity = [0, -9.81]",
        "mass = 2",
        "force = [3, 0]",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let text = imported("slider-crank.pylinkage.json").text;
    assert!(
        text.contains("speed = \"0.1 rad/s\"") && text.contains("range = "),
        "{text}"
    );
}

/// What krank does not model is reported with its place; the rest is kept.
#[test]
fn parts_that_krank_does_not_model_are_reported() {
    let remarks = |name: &str| imported(name).remarks.join("\n");
    let output = remarks("gears.pmks.txt");
    assert!(
        output.contains("line 5: krank does not model gears"),
        "{output}"
    );
    assert!(output.contains("line 8: not a joint"), "{output}");
    let output = remarks("gears.linkage2");
    assert!(
        output.contains("Link 3: krank does not model gears"),
        "{output}"
    );
    assert!(
        output.contains("Link 4: krank does not model gears"),
        "{output}"
    );
    assert!(
        output.contains("ratio: krank does not model gears"),
        "{output}"
    );
    let text = imported("gears.linkage2").text;
    assert!(
        text.contains("link-2 = ") && text.contains("# - line"),
        "{text}"
    );
    let scene = Scene::parse(&text, "gears").unwrap();
    // The second gear turns freely, and the message of the scene says so.
    let fault = Solver::new(&scene.mechanism).unwrap_err();
    let message = scene.explain(&fault).to_string();
    assert!(message.contains('2'), "{message}");
    let output = remarks("mixed-inputs.linkage2");
    assert!(
        output.contains("it is held as drawn, with `at`"),
        "{output}"
    );
    let output = remarks("four-bar.pylinkage.json");
    assert!(
        output.contains("`Crank pin` is called `Crank_pin`"),
        "{output}"
    );
    let output = remarks("four-bar.pyslvs");
    assert!(
        output.contains("line 3, joint 1: the file marks no input"),
        "{output}"
    );
}

/// Every element and attribute of a file is taken over, is for the display only, or is reported.
#[test]
fn every_odd_part_of_a_linkage_file_is_reported() {
    let text = "<linkage2>
<program units=\"Feet\" scalefactor=\"2.5\" zoom=\"1\" bkcolor=\"3\"/>
<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"abc\" color=\"7\"/>
<connector id=\"1\" x=\"30\" y=\"40\" anchor=\"yes\" draw=\"true\" glow=\"1\"/>
<connector id=\"2\" x=\"180\" y=\"90\" glow=\"2\"><spring id=\"1\"/><slidelimit id=\"0\"/></connector>
<connector id=\"3\" x=\"220\" y=\"-30\" anchor=\"true\"/>
<connector id=\"4\" x=\"250\" y=\"150\"/>
<connector id=\"5\" x=\"300\" y=\"100\"/>
<connector id=\"6\" x=\"350\" y=\"-60\" anchor=\"true\"/>
<connector id=\"7\" x=\"1\" y=\"2\"/>
<connector id=\"8\" x=\"5\" y=\"6\" layer=\"1\" hidden=\"1\"/>
<connector id=\"9\" x=\"7\" y=\"8\" fastenconnector=\"1\"><fastenlink id=\"1\"/></connector>
<Link id=\"0\" locked=\"true\"><connector id=\"0\"/><connector id=\"1\"/></Link>
<Link id=\"1\"><connector id=\"1\"/><connector id=\"2\"/><fastenconnector id=\"8\"/></Link>
<Link id=\"2\"><connector id=\"2\"/><connector id=\"3\"/><fastenconnector id=\"77\"/></Link>
<Link id=\"3\"><connector id=\"2\"/><connector id=\"4\"/><fastenlink id=\"2\"/></Link>
<Link id=\"4\"><connector id=\"4\"/><connector id=\"5\"/></Link>
<Link id=\"5\"><connector id=\"5\"/><connector id=\"6\"/></Link>
<Link id=\"6\"/>
<cam id=\"1\"/>
<background/>
</linkage2>
";
    let imported = import(text.as_bytes(), "odd").unwrap();
    let remarks = imported.remarks;
    let expected = [
        "line 3, connector 0: `rpm` is not a number: `abc`; left out",
        "line 4, connector 1: `anchor` is neither true nor false: `yes`; read as false",
        "line 5, spring 1: unknown element; left out",
        "line 20, cam 1: unknown element; left out",
        "line 4, connector 1: the attribute `glow` of 2 elements is unknown; left out",
        "line 2, program: the attribute `bkcolor` is unknown; left out",
        "line 2, program: unknown unit `Feet`; lengths are read in millimetres",
        "line 2, program: the scale factor 2.5 of the display is not applied: lengths are those of the file",
        "line 19, Link 6: the link has no connector; left out",
        "line 15, fastenconnector 77: there is no connector with this id; left out",
        "line 12, connector 9: fastened to a connector that is no input; left out",
        "line 5, slidelimit 0: the connector is no slider; its ends are left out",
        "line 10, connector 7: no link has this connector; left out",
    ];
    assert_eq!(remarks, expected);
    // Link 3 moves with link 2, and connector 9 with link 1.
    let opened = OpenedScene::new("odd", &imported.text);
    let near = |at: f64| {
        let here = opened.places(at);
        let pair = |one: &str, other: &str| {
            distance([here[one].x, here[one].y], [here[other].x, here[other].y])
        };
        [pair("E", "D"), pair("J", "C")]
    };
    let start = opened.scene.mechanism.driver().start;
    let (_, high) = opened.solver.motion().range.ends();
    let later = start + 0.3 * (high - start);
    for (one, other) in near(start).into_iter().zip(near(later)) {
        assert!((one - other).abs() < 1e-9, "{one} {other}");
    }
}

/// Regression test: the remark on a held input said a ratio that the scene does not have.
#[test]
fn remarks_on_held_inputs_name_the_key_of_the_scene() {
    let imported = imported("mixed-inputs.linkage2");
    assert!(
        imported.remarks[0].ends_with("held as drawn, with `at`"),
        "{:?}",
        imported.remarks
    );
    assert!(
        imported.text.contains("link-5 = { at = "),
        "{}",
        imported.text
    );
}

/// Regression test: decimals with a comma were read as two numbers without a remark.
#[test]
fn decimal_commas_are_never_misread() {
    let read = |line: &str| {
        let text = format!(
            "ground,input,R,0,0,tfft\n{line}\ncoupler,output,R,95,75\noutput,ground,R,120,-10\n"
        );
        import(text.as_bytes(), "x").unwrap()
    };
    for (line, typed) in [
        ("input coupler R 0,5 1,5", "0,5 1,5"),
        ("input coupler R 0,5 10", "0,5 10"),
        ("input coupler R 10 0,5 tfff", "10 0,5"),
        ("input,coupler,R,0,5,1,5", "0,5,1,5"),
        ("input;coupler;R;0,5;1", "0,5;1"),
        // Messages have no control characters.
        ("input\tcoupler\tR\t0,5\t1,0", "0,5 1,0"),
        ("input,coupler,P,1,5,2,5,30", "1,5,2,5,30"),
    ] {
        let imported = read(line);
        let expected = format!(
            "line 2: `{typed}` can be read in several ways: write decimals with a point; left out"
        );
        assert!(
            imported.remarks.contains(&expected),
            "{line}: {:?}",
            imported.remarks
        );
    }
    // Three numbers of a pin may be a decimal and a number.
    let imported = read("input,coupler,R,0,5,10");
    assert_eq!(
        imported.remarks,
        ["line 2: read as x 0, y 5 and angle 10, which a pin does not use; decimals need a point"]
    );
    for line in [
        "input,coupler,R,15,40",
        "input coupler R 15 40 0 tfff",
        "input, coupler, R, 15, 40, 0, tfff",
        "input;coupler;R;15;40",
        "input coupler R 15,40 t f f f",
    ] {
        assert_eq!(read(line).remarks, [""; 0], "{line}");
    }
    assert!(read("input,coupler,R,15,40,0,tff").remarks[0].contains("the flags `tff` are unknown"));
    // A file without any other line says why it cannot be read.
    let refused = import(b"ground a R 0,5 1,5\na b R 2,5 3,5\n", "x")
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("line 1: `0,5 1,5` can be read"),
        "{refused}"
    );
    // Pyslvs has exactly two coordinates.
    let text =
        "M[J[R, P[0,5, 1,0], L[ground, a]], J[R, P[2, 3], L[a, b]], J[R, P[7, 3], L[b, ground]]]";
    let imported = import(text.as_bytes(), "x").unwrap();
    assert!(
        imported.remarks[0].starts_with("line 1, joint 1: not a joint"),
        "{:?}",
        imported.remarks
    );
}

/// Cells of PMKS+ that cannot be read are reported, and shifted ones are not taken over.
#[test]
fn unreadable_cells_of_addresses_are_reported() {
    let address = "https://app.pmksplus.com/?j=A,0,0,AB,R,t,0,t%0AB,1,2,AB|CBE,R,no,x,maybe%0A\
        C,5,3,CBE|CD,R,f,0,f%0AD,6,-1,CD,R,t,0,f%0A&l=AB,R,2,5,0,5,1,5,A|B%0ACBE,R,2,1,Null,Null,B|C%0A\
        &f=F1,CBE,1,5,1,2,5,1,t,true,3%0A&s=10,5,true,furlong&v=3";
    let imported = import(address.as_bytes(), "x").unwrap();
    assert_eq!(
        imported.remarks,
        [
            "`v`: krank does not use this parameter of the address",
            "joint 2 of `j`: the value of ground cannot be read: `no`; left out",
            "joint 2 of `j`: the value of angle cannot be read: `x`; left out",
            "joint 2 of `j`: the value of input cannot be read: `maybe`; left out",
            "link 1 of `l`: there is no joint `1`; left out",
            "link 1 of `l`: the mass, moment of inertia or centre of mass cannot be read; left out",
            "link 2 of `l`: the mass, moment of inertia or centre of mass cannot be read; left out",
            "force 1 of `f`: not a force on a link; left out",
            "`s`: the value of clockwise cannot be read: `5`; left out",
            "`s`: unknown unit `furlong`; lengths are read in millimetres",
        ]
    );
    assert!(!imported.text.contains("mass ="), "{}", imported.text);
    OpenedScene::new("cells", &imported.text);
}

/// Addresses without their scheme, with `#`, in quotes, or from `?` on are the same mechanism.
#[test]
fn parts_of_addresses_are_read() {
    for (name, parameter) in [
        ("four-bar.pmks-plus.txt", "j="),
        ("address.pmks.txt", "mech="),
    ] {
        let address = String::from_utf8(file(name)).unwrap();
        let address = address.trim();
        let whole = import(address.as_bytes(), "https://x").unwrap().text;
        let joints = &address[address.find(parameter).unwrap()..];
        let (_, host) = address.split_once("://").unwrap();
        for part in [
            host.to_owned(),
            format!("?{joints}"),
            format!("#{joints}"),
            format!("HTTPS://x.org/#/?{joints}"),
            format!("\"{address}\"\n"),
            format!("<{address}>"),
        ] {
            assert!(krank::import::is_address(&part), "{part}");
            let read = import(part.as_bytes(), "https://x").unwrap();
            assert_eq!(read.text, whole, "{part}");
        }
    }
    let plus = String::from_utf8(file("four-bar.pmks-plus.txt")).unwrap();
    let joints = &plus[plus.find("j=").unwrap()..];
    assert_eq!(recognize(joints.as_bytes()), Some(ImportFormat::PmksPlus));
    for other in [
        "name = \"x?j=1\"\n",
        "# ?mech=a\n[links]\n",
        "a?b=c",
        "j = 3\n",
    ] {
        assert_eq!(recognize(other.as_bytes()), None, "{other}");
    }
    // The settings of an address are read or reported.
    let address = String::from_utf8(file("address.pmks.txt")).unwrap();
    let address = format!("{}&name=Crank&s=3", address.trim());
    let imported = import(address.as_bytes(), "x").unwrap();
    assert!(
        imported.text.contains("name   = \"Crank\""),
        "{}",
        imported.text
    );
    assert_eq!(
        imported.remarks,
        ["`s`: krank does not use the setting `s=3`"]
    );
}

#[test]
fn odd_parts_of_pylinkage_files_are_reported() {
    let text = r#"{"name": "odd", "joints": [
        {"id": "O", "type": "revolute", "position": [0, 0]},
        {"id": "A", "type": "revolute", "position": [3, 4]},
        {"id": "S", "type": "prismatic", "position": [15, 1], "line_point": [0, 3], "axis": [1, 0]},
        {"id": "T", "type": "tracker", "position": [1, 1], "ref_joint1_id": "A", "ref_joint2_id": "none"},
        {"id": "U", "type": "revolute", "position": [9, 9]},
        {"id": "V", "type": "prismatic", "position": [8, 8]}
      ], "links": [
        {"id": "crank", "type": "driver", "joints": ["O", "A"], "motor_joint": "O", "angular_velocity": "fast"},
        {"id": "rod", "type": "spring", "joints": ["A", "S"]},
        {"id": "lost"}
      ]}"#;
    let imported = import(text.as_bytes(), "odd").unwrap();
    assert_eq!(
        imported.remarks,
        [
            "joints[2]: the joint is drawn 2.000 away from its line; the scene keeps the drawn position",
            "joints[5]: the slider has no axis; it slides along x",
            "links[0]: the value of angular_velocity cannot be read: `\"fast\"`; left out",
            "links[1]: unknown type `spring`; read as a rigid link",
            "links[2]: not a link with an id and joints; left out",
            "joints[3]: the joint has no link; left out",
            "joints[4]: the joint has no link; left out",
            "joints[5]: the joint has no link; left out",
        ]
    );
    // The joint of the motor is fixed.
    OpenedScene::new("odd", &imported.text);
}

/// Regression test: the rounding of lengths decided whether a drawing at a dead point opens.
#[test]
fn drawings_at_dead_points_open() {
    for k in 0..40_u32 {
        let turned = |angle: f64, length: f64| {
            let (sin, cos) = angle.to_radians().sin_cos();
            [length * cos + 0.37, length * sin - 1.9]
        };
        let k = f64::from(k);
        let (b, d) = (turned(37.3 * k, 41.7), [150.0 + k, -7.7 * k]);
        // Coupler and rocker are in line, stretched or folded.
        let share = [0.3, 0.5, 0.77, 1.4][k as usize % 4];
        let c = [0, 1].map(|i| b[i] + share * (d[i] - b[i]));
        let text = format!(
            "ground,k,R,0.37,-1.9,0,tfft\nk,m,R,{},{}\nm,n,R,{},{}\nn,ground,R,{},{}\n",
            b[0], b[1], c[0], c[1], d[0], d[1]
        );
        let imported = import(text.as_bytes(), "dead").unwrap();
        let opened = OpenedScene::new("dead", &imported.text);
        let here = opened.places(opened.scene.mechanism.driver().start);
        let off = distance([here["C"].x, here["C"].y], c);
        assert!(
            off < 1e-6 * distance(b, d),
            "{k}: {off:e}\n{}",
            imported.text
        );
        // The drawing is not exactly the opening pose, and the scene says so.
        let is_exact = off <= 1e-9 * 150.0;
        assert!(
            is_exact
                || imported.remarks
                    == [
                        "the drawing is a dead point: the scene opens next to it, on one of its two sides"
                    ]
        );
    }
}

/// Joints at one place, which leave links without a length or a direction.
#[test]
fn joints_at_one_place_are_one_joint() {
    let text =
        "ground,k,R,0,0,0,tfft\nk,m,R,11.3,7.9\nm,n,R,11.3,7.9\nn,p,R,44.1,20\np,ground,R,50,-3\n";
    let imported = import(text.as_bytes(), "zero").unwrap();
    assert_eq!(
        imported.remarks,
        ["the joints of the link `m` are at one place; they are one joint here"]
    );
    let opened = OpenedScene::new("zero", &imported.text);
    assert_eq!(
        opened.scene.mechanism.link_ids().count(),
        3,
        "{}",
        imported.text
    );
    let here = opened.places(opened.scene.mechanism.driver().start + 10.0);
    let length = distance([here["B"].x, here["B"].y], [here["D"].x, here["D"].y]);
    assert!(
        (length - distance([11.3, 7.9], [44.1, 20.0])).abs() < 1e-12,
        "{length}"
    );
    // A turned link of length 0 is reported.
    let imported = import(text.replace("11.3,7.9", "0,0").as_bytes(), "zero").unwrap();
    assert_eq!(
        imported.remarks[0],
        "the joints of the link `k` are at one place: its length is 0"
    );
    for text in [
        "M[J[R, P[-10., 0.], L[ground, i]], J[R, P[-10., 0.], L[ground, j]]]",
        "M[J[R, P[-10., 0.], L[ground, i]], J[R, P[-10., 0.], L[ground, j]], J[R, P[5, 20], L[i, j]]]",
        "M[J[R, P[1, 1], L[ground, i]], J[R, P[1, 1], L[i, j]], J[P, A[0], P[1, 1], L[j, ground]]]",
        "M[J[RP, A[0], P[1, 1], L[ground, i]], J[RP, A[90], P[1, 1], L[ground, i]], J[R, P[1, 1], L[i, ground]]]",
    ] {
        let imported = import(text.as_bytes(), "x").unwrap();
        let scene = Scene::parse(&imported.text, "x").unwrap();
        let fault = Solver::new(&scene.mechanism).err();
        let message = fault.map_or(String::new(), |fault| scene.explain(&fault).to_string());
        for said in [&imported.text, &message] {
            assert!(
                !said.contains("NaN") && !said.contains("inf"),
                "{text}\n{said}"
            );
        }
    }
}

/// Regression test: a joint that the file has twice gave a misfit of NaN.
#[test]
fn joints_that_are_there_twice_are_one() {
    let four_bar = String::from_utf8(file("four-bar.pmks.txt")).unwrap();
    let text = four_bar + "coupler,input,R,15,40\noutput,ground,R,120,-10\n";
    let imported = import(text.as_bytes(), "x").unwrap();
    assert_eq!(
        imported.remarks,
        [
            "the file joins the same links twice at (15, 40); that is one joint here",
            "the file joins the same links twice at (120, -10); that is one joint here",
        ]
    );
    let opened = OpenedScene::new("twice", &imported.text);
    assert_eq!(
        opened.scene.mechanism.point_ids().count(),
        5,
        "{}",
        imported.text
    );
}

/// Files of other systems, and files with single lines that krank cannot read.
#[test]
fn encodings_and_unreadable_lines_are_read() {
    let name = "four-bar.pmks.txt";
    let text = String::from_utf8(file(name)).unwrap();
    let whole = imported(name).text;
    let read = |bytes: &[u8]| import(bytes, name).unwrap();
    assert_eq!(read(text.replace('\n', "\r\n").as_bytes()).text, whole);
    assert_eq!(read(text.replace('\n', "\r").as_bytes()).text, whole);
    assert_eq!(read(format!("\u{feff}{text}").as_bytes()).text, whole);
    let units = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
        let marked = format!("\u{feff}{text}");
        marked.encode_utf16().flat_map(order).collect()
    };
    assert_eq!(read(&units(u16::to_le_bytes)).text, whole);
    assert_eq!(read(&units(u16::to_be_bytes)).text, whole);
    for number in ["nan", "inf", "1e400", "0x0f", "1.5.2"] {
        let text = text.replace("15,40", &format!("{number},40"));
        let remarks = read(text.as_bytes()).remarks;
        assert!(
            remarks[0].starts_with("line 2: not a joint"),
            "{number}: {remarks:?}"
        );
    }
    for other in [
        "",
        " \n\n",
        "\0\u{1}\u{2}",
        "a text\nwith lines\nground,a,R,1,2\n",
    ] {
        assert_eq!(recognize(other.as_bytes()), None, "{other:?}");
    }
    let loose = read(b"frame,a,R,0,0\na,b,R,3,4\nb,frame,R,9,1\n");
    assert!(
        loose
            .remarks
            .contains(&"nothing is fixed: no joint has the frame".to_owned())
    );
    let tail = import(b"M[J[R, P[0, 0], L[ground, a]]] tail", "x").unwrap_err();
    assert!(tail.to_string().contains("brackets"), "{tail}");
}

/// The first comment of a scene that does not open as drawn does not say that it does.
#[test]
fn comments_say_how_the_scene_opens() {
    let head = |text: &str| {
        let imported = import(text.as_bytes(), "x").unwrap();
        imported.text.lines().next().unwrap().to_owned()
    };
    let four_bar = String::from_utf8(file("four-bar.pmks.txt")).unwrap();
    assert!(head(&four_bar).ends_with("opens in the pose of its drawing."));
    // A loose link, and a slot through the pivot of its own link.
    for text in [
        "ground,k,R,0,0\nk,m,R,10,10\nm,n,R,30,20\n",
        "ground,k,R,9.2,8.6\nground,n,R,6.6,-6.6\nn,k,RP,6.6,-6.6,0\nn,R,-9.9,-10\n",
    ] {
        assert_eq!(head(text), "# Imported from a file of PMKS.", "{text}");
    }
}

/// Regression test: a comma at the end of each joint hid its mark, and another link was driven.
#[test]
fn commas_at_the_ends_of_joints_change_nothing() {
    let address = String::from_utf8(file("four-bar.pmks-plus.txt")).unwrap();
    let with_commas = address.replace("t%0A", "t,%0A").replace("f%0A", "f,%0A");
    assert_ne!(address, with_commas);
    let read = |text: &str| import(text.as_bytes(), "x").unwrap();
    let (one, other) = (read(&address), read(&with_commas));
    assert_eq!(one.text, other.text);
}

#[test]
fn files_without_a_mechanism_are_refused() {
    let refused = |text: &str| import(text.as_bytes(), "x").unwrap_err().to_string();
    let packed = refused("https://app.pmksplus.com/?2P.Fe.K,0.101.AB,,BC");
    assert!(packed.contains("packed of version 2P"), "{packed}");
    assert!(refused("[links]\nr2 = 1\n").contains("not a file of PMKS"));
    assert!(refused("").contains("not a file of PMKS"));
    assert!(
        refused("<linkage2><connector id=\"0\" x=\"1\" y=\"nan\"/></linkage2>")
            .contains("no joint")
    );
    let broken = refused("<linkage2>\n<connector id=\"0\" x=></linkage2>");
    assert!(broken.contains("XML") && broken.contains("2:"), "{broken}");
    let bomb = "<!DOCTYPE x [<!ENTITY a \"b\">]>\n<linkage2>&a;</linkage2>";
    assert!(refused(bomb).contains("XML"));
    assert!(refused("M[J[R, P[1, 2], L[a]").contains("brackets"));
    assert!(refused("{\"joints\": [], \"links\": []").contains("JSON"));
    assert!(refused("{\"joints\": [{\"type\": \"Crank\"}], \"links\": []}").contains("older"));
    let many = "ground,a,R,1,2\n".repeat(2_100);
    assert!(refused(&many).contains("too large"));
    let deep = format!("<linkage2>{}</linkage2>", "<a>".repeat(100_000));
    assert!(refused(&deep).contains("XML"));
}

/// Names that a scene cannot have are replaced and stay distinct.
#[test]
fn names_are_valid_and_unique() {
    let text = "ground,driver,R,0,0,tfft\ndriver,com,R,15,40\ncom,öl\u{7},R,95,75\nöl\u{7},ground,R,120,-10\n";
    let imported = import(text.as_bytes(), "names").unwrap();
    let opened = OpenedScene::new("names", &imported.text);
    let links: Vec<&str> = opened
        .scene
        .mechanism
        .link_ids()
        .map(|link| opened.scene.link_name(link))
        .collect();
    assert_eq!(links, ["driver-2", "com-2", "l"]);
    assert_eq!(imported.remarks.len(), 3, "{:?}", imported.remarks);
    assert!(!imported.text.contains('\u{7}'), "{}", imported.text);
}

fn all_files() -> Vec<Vec<u8>> {
    SAID.iter()
        .map(|text| file(text.file))
        .chain([file("gears.pmks.txt"), file("gears.linkage2")])
        .collect()
}

/// Reads a damaged file; the text of any scene must be a scene or have an explained fault.
fn survives(bytes: &[u8]) {
    if let Ok(imported) = import(bytes, "damaged")
        && let Err(faults) = Scene::parse(&imported.text, "damaged")
    {
        assert!(!faults.items.is_empty(), "{}", imported.text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn damaged_files_never_panic(
        which in 0..100_usize,
        cut in 0.0..1.0_f64,
        edits in prop::collection::vec((0.0..1.0_f64, any::<u8>()), 0..6),
        moved in prop::option::of((0.0..1.0_f64, 0.0..1.0_f64)),
    ) {
        let files = all_files();
        let mut bytes = files[which % files.len()].clone();
        let place = |share: f64, len: usize| ((share * len as f64) as usize).min(len.saturating_sub(1));
        if let Some((from, to)) = moved {
            // Repeats a line at another place.
            let mut lines: Vec<Vec<u8>> = bytes.split(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
            let line = lines[place(from, lines.len())].clone();
            lines.insert(place(to, lines.len()), line);
            bytes = lines.join(&b'\n');
        }
        for (at, byte) in edits {
            let at = place(at, bytes.len());
            bytes[at] = byte;
        }
        if cut < 0.5 {
            bytes.truncate(place(2.0 * cut, bytes.len()));
        }
        survives(&bytes);
    }

    #[test]
    fn extreme_numbers_never_panic(
        numbers in prop::collection::vec(prop_oneof![
            Just("0".to_owned()), Just("-0".to_owned()), Just("1e150".to_owned()), Just("1e300".to_owned()),
            Just("NaN".to_owned()), Just("inf".to_owned()), Just("1e-320".to_owned()), Just("7".to_owned()),
        ], 11),
    ) {
        let n = &numbers;
        survives(format!(
            "ground,input,R,{},{}\ninput,b,R,{},{}\nb,c,P,{},{},{}\nc,ground,RP,{},{},{}\nb,R,{},1\n",
            n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10]
        ).as_bytes());
    }
}
