//! Tests of reading valid scenes.

mod refusals;

use super::*;
use crate::{Body, Input, Load, Profile, Slider, StrokeEnd, Vec2};

fn preset(name: &str) -> Scene {
    let preset = presets::find(name).unwrap();
    Scene::parse(preset.text, name).unwrap_or_else(|faults| panic!("{faults}"))
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut ids = scene.mechanism.point_ids();
    let found = ids.find(|&id| scene.point_name(id) == Some(name));
    found.unwrap_or_else(|| panic!("no point {name}"))
}

#[test]
fn parse_reads_four_bar_preset() {
    let scene = preset("four-bar");
    let m = &scene.mechanism;
    let names: Vec<_> = m
        .point_ids()
        .map(|id| scene.point_name(id).unwrap())
        .collect();
    assert_eq!(names, ["A", "D", "B", "C", "r2.com", "r3.com", "r4.com"]);
    assert_eq!(
        m.point(point(&scene, "D")).ground,
        Some(Vec2::new(400.0, 0.0))
    );
    let links: Vec<_> = m.link_ids().map(|id| scene.link_name(id)).collect();
    assert_eq!(links, ["r2", "r3", "r4"]);
    let rocker = &m.links()[2];
    assert_eq!(rocker.ends, Some((point(&scene, "C"), point(&scene, "D"))));
    assert_eq!(
        rocker.local(point(&scene, "D")),
        Some(Vec2::new(250.0, 0.0))
    );
    assert_eq!(rocker.com, Some(point(&scene, "r4.com")));
    assert_eq!(
        rocker.local(point(&scene, "r4.com")),
        Some(Vec2::new(125.0, 0.0))
    );
    let driver = m.driver();
    assert_eq!(driver.input, Input::Turn(m.link_ids().next().unwrap()));
    assert_eq!(
        (driver.start, driver.speed, driver.acceleration),
        (60.0, 15.0, 0.0)
    );
    assert_eq!(m.start(), [(point(&scene, "C"), Vec2::new(310.0, 230.0))]);
    let vectors: Vec<_> = scene.vectors.iter().map(|v| v.name.as_str()).collect();
    assert_eq!(vectors, ["r2", "r3", "r4", "r1"]);
    let frame = VectorKind::Between(point(&scene, "D"), point(&scene, "A"));
    assert_eq!(scene.vectors[3].kind, frame);
    assert_eq!(scene.unit, Unit::Millimetre);
}

#[test]
fn slider_crank_lists_its_slide_as_vector() {
    let scene = preset("slider-crank");
    let slide = &scene.mechanism.slides()[0];
    assert_eq!(slide.slider, Slider::Pin(point(&scene, "C")));
    assert_eq!(slide.on, Body::Ground);
    assert_eq!((slide.through, slide.direction()), (Vec2::ZERO, Vec2::X));
    assert!(matches!(scene.vectors[2].kind, VectorKind::Slide(_)));
    assert_eq!(scene.vectors[2].name, "r4");
    assert_eq!(scene.unit, Unit::Centimetre);
}

#[test]
fn every_preset_parses_with_source_and_note() {
    for preset in presets::all() {
        let scene =
            Scene::parse(preset.text, preset.name).unwrap_or_else(|faults| panic!("{faults}"));
        assert!(
            scene.source.is_some() && scene.note.is_some(),
            "{}",
            preset.name
        );
    }
}

/// A scene with every key of the format.
const EVERYTHING: &str = r#"
name = "Every  key"
source = "made up"
note = """two
lines"""
unit = "in"
gravity = [0, -9.81]

[ground]
O = [0, 0]
"Q'" = [0.4, 0.9]

[driver]
slide = "rod"
position = 1.0
speed = "25.4 mm/s"
acceleration = "0.0254 m/s^2"

[links]
barrel = { points = { O = [0, 0], "end-1" = [2, 0] } }
boom = { points = { "Q'" = [0, 0], P = [1.1, -0.2], T = [3.2, 0.35] }, com = [1.5, 0], mass = 12, inertia = 0.5 }
ram = { points = { R = [0.1, 0] }, com = [0.1, 0.1] }
arm = { from = "T", to = "R", length = 2 }

[slides]
rod = { point = "P", on = "barrel", through = [0, 0.05] }
guide = { link = "ram", on = "ground", through = "Q'", angle = 90, turn = 180 }
pin = { point = "R", on = "boom", through = "T", angle = 30 }

[start]
P = [1.05, 0.2]

[vectors]
lift = ["Q'", "T"]
balance = ["boom.com", "ram.com"]

[[loads]]
point = "T"
force = [0, -500]

[[loads]]
link = "boom"
torque = 12.5

[[loads]]
point = "boom.com"
force = [1, 2]
frame = "arm"
over = [[1.0, 0], [1.2, 1.5], [2, -0.5]]

[[loads]]
link = "ram"
torque = -3
over = [[0, 1], [1, 0]]

[[loads]]
slide = "guide"
press = [[0.5, 0], [0.2, 200e3], [0, 350e3]]

[[loads]]
slide = "guide"
press = [[0, 10], [0.1, 0]]
end = "greatest"

[[springs]]
from = "O"
to = "T"
stiffness = 1200
length = 3.5
damping = 5

[[springs]]
from = "ram.com"
to = "T"
damping = 2

[[springs]]
from = "O"
to = "T"
stiffness = 3
preload = -4

[[springs]]
from = "T"
to = "O"
force = [[5, 60], [4, 70], [4, 80], [3, 90]]
damping = 1.5

[[springs]]
link = "arm"
to = "ram"
stiffness = 12
angle = -35
preload = 2
damping = 0.5

[[springs]]
link = "ram"
to = "ground"
stiffness = 6

[motor]
force = 2000
peak = 6e3
speed = "0.0508 m/s"
tolerance = 0.1
"#;

#[test]
fn every_key_is_read() {
    let scene = Scene::parse(EVERYTHING, "folder/made-up.toml").unwrap();
    assert_eq!(scene.name, "Every key");
    assert_eq!(scene.note.as_deref(), Some("two lines"));
    assert_eq!(scene.unit, Unit::Inch);
    let m = &scene.mechanism;
    let driver = m.driver();
    assert!(matches!(driver.input, Input::Push(_)));
    assert_eq!((driver.start, driver.speed), (1.0, 1.0));
    assert_eq!(driver.acceleration, 1.0);
    let names: Vec<_> = m.point_ids().map(|id| scene.point_name(id)).collect();
    let named = ["O", "Q'", "end-1", "P", "T", "R", "boom.com", "ram.com"];
    assert_eq!(names[..8], named.map(Some));
    assert_eq!(names[8..], [None], "the hidden origin of the ram");
    let boom = &m.links()[1];
    assert_eq!((boom.mass, boom.inertia, boom.ends), (12.0, 0.5, None));
    let vectors: Vec<_> = scene.vectors.iter().map(|v| v.name.as_str()).collect();
    assert_eq!(vectors, ["arm", "rod", "guide", "pin", "lift", "balance"]);
    let between = VectorKind::Between(point(&scene, "boom.com"), point(&scene, "ram.com"));
    assert_eq!(scene.vectors[5].kind, between);
    assert_eq!(m.gravity(), Vec2::new(0.0, -9.81));
    let t = point(&scene, "T");
    let force = Vec2::new(0.0, -500.0);
    assert_eq!(m.loads()[0], Load::force(t, force));
    assert!(matches!(m.loads()[1], Load::Torque { torque: 12.5, .. }));
    assert_eq!(m.metres(), 0.0254);
    assert!(m.has_forces());
}

fn over(knots: &[[f64; 2]]) -> Profile {
    Profile::new(knots.to_vec()).unwrap()
}

#[test]
fn every_kind_of_load_is_read() {
    let scene = Scene::parse(EVERYTHING, "made-up").unwrap();
    let m = &scene.mechanism;
    let [_, _, ram, arm] = m.link_ids().collect::<Vec<_>>()[..] else {
        panic!("four links")
    };
    let [_, guide, _] = m.slide_ids().collect::<Vec<_>>()[..] else {
        panic!("three slides")
    };
    let named = |name| point(&scene, name);
    let spring = |from, to, stiffness, length, damping| Load::Spring {
        from: named(from),
        to: named(to),
        stiffness,
        length,
        preload: 0.0,
        damping,
    };
    let press = |end, knots: &[[f64; 2]]| Load::Press {
        slide: guide,
        end,
        curve: over(knots),
    };
    assert_eq!(
        m.loads()[2..],
        [
            Load::Force {
                point: named("boom.com"),
                force: Vec2::new(1.0, 2.0),
                frame: Body::Link(arm),
                over: over(&[[1.0, 0.0], [1.2, 1.5], [2.0, -0.5]]),
            },
            Load::Torque {
                link: ram,
                torque: -3.0,
                over: over(&[[0.0, 1.0], [1.0, 0.0]]),
            },
            // The guide points up: its lower end has the minimum position.
            press(
                StrokeEnd::Minimum,
                &[[0.0, 350e3], [0.2, 200e3], [0.5, 0.0]]
            ),
            press(StrokeEnd::Maximum, &[[0.0, 10.0], [0.1, 0.0]]),
            spring("O", "T", 1200.0, 3.5, 5.0),
            spring("ram.com", "T", 0.0, 0.0, 2.0),
            Load::Spring {
                from: named("O"),
                to: named("T"),
                stiffness: 3.0,
                length: 0.0,
                preload: -4.0,
                damping: 0.0,
            },
            // Descending knots are sorted, including the jump.
            Load::GasSpring {
                from: named("T"),
                to: named("O"),
                force: over(&[[3.0, 90.0], [4.0, 80.0], [4.0, 70.0], [5.0, 60.0]]),
                damping: 1.5,
            },
            Load::TorsionSpring {
                link: arm,
                to: Body::Link(ram),
                stiffness: 12.0,
                angle: -35.0,
                preload: 2.0,
                damping: 0.5,
            },
            Load::TorsionSpring {
                link: ram,
                to: Body::Ground,
                stiffness: 6.0,
                angle: 0.0,
                preload: 0.0,
                damping: 0.0,
            },
        ]
    );
    assert_eq!(
        scene.motor,
        Some(Motor {
            rated: Some(2000.0),
            peak: Some(6000.0),
            speed: Some(2.0),
            rest: Some(0.1),
            ..Motor::default()
        })
    );
}

#[test]
fn press_without_end_acts_at_lower_end_of_guide() {
    let text = presets::find("press-ram").unwrap().text;
    let end = |angle: &str| {
        let text = text.replace("angle = 90", &format!("angle = {angle}"));
        let load = "[[loads]]\nslide = \"r6\"\npress = [[9, 0], [0, 5]]\n";
        let scene = Scene::parse(&format!("{text}{load}"), "x").ok()?;
        let Load::Press { end, .. } = scene.mechanism.loads()[0] else {
            panic!("a press")
        };
        Some(end)
    };
    assert_eq!(end("90"), Some(StrokeEnd::Minimum));
    assert_eq!(end("0.001"), Some(StrokeEnd::Minimum));
    assert_eq!(end("-90"), Some(StrokeEnd::Maximum));
    assert_eq!(end("180.001"), Some(StrokeEnd::Maximum));
    assert_eq!((end("0"), end("-180"), end("360")), (None, None, None));
}

#[test]
fn motor_table_is_read_for_driven_link() {
    let text = presets::find("four-bar").unwrap().text;
    let motor = |keys: &str| {
        Scene::parse(&format!("{text}\n[motor]\n{keys}"), "x")
            .unwrap()
            .motor
    };
    let all = "torque = 20\npeak = 20.0\nspeed = \"60 rpm\"\nflywheel = 0.5\nfluctuation = 0.02\n";
    assert_eq!(
        motor(all),
        Some(Motor {
            rated: Some(20.0),
            peak: Some(20.0),
            speed: Some(2.0 * std::f64::consts::PI),
            flywheel: Some(0.5),
            fluctuation: Some(0.02),
            rest: None,
        })
    );
    assert_eq!(motor(""), Some(Motor::default()));
    assert_eq!(Scene::parse(text, "x").unwrap().motor, None);
}

#[test]
fn slides_are_placed_in_frame_of_their_carrier() {
    let scene = Scene::parse(EVERYTHING, "made-up").unwrap();
    let m = &scene.mechanism;
    let [rod, guide, pin] = m.slides() else {
        panic!("three slides")
    };
    let [barrel, boom, ram, _] = m.link_ids().collect::<Vec<_>>()[..] else {
        panic!("four links")
    };
    assert_eq!(rod.on, Body::Link(barrel));
    assert_eq!(
        (rod.through, rod.direction()),
        (Vec2::new(0.0, 0.05), Vec2::X)
    );
    assert_eq!(guide.on, Body::Ground);
    assert_eq!(guide.through, Vec2::new(0.4, 0.9));
    assert_eq!(guide.direction(), Vec2::new(0.0, 1.0));
    let Slider::Link { link, turn, origin } = guide.slider else {
        panic!("a sliding link")
    };
    assert_eq!((link, turn), (ram, 180.0));
    assert_eq!(m.link(ram).local(origin), Some(Vec2::ZERO));
    assert_eq!(pin.on, Body::Link(boom));
    assert_eq!(
        pin.through,
        Vec2::new(3.2, 0.35),
        "T in the frame of the boom"
    );
}

#[test]
fn elements_map_to_their_place_in_text() {
    let scene = Scene::parse(EVERYTHING, "made-up").unwrap();
    let m = &scene.mechanism;
    let shown = |element| &scene.text()[scene.place(element)];
    assert_eq!(shown(ElementId::Driver), "driver");
    let links: Vec<_> = m.link_ids().map(|id| shown(ElementId::Link(id))).collect();
    assert_eq!(links, ["barrel", "boom", "ram", "arm"]);
    let slides: Vec<_> = m
        .slide_ids()
        .map(|id| shown(ElementId::Slide(id)))
        .collect();
    assert_eq!(slides, ["rod", "guide", "pin"]);
    let points: Vec<_> = m
        .point_ids()
        .map(|id| shown(ElementId::Point(id)))
        .collect();
    let expected = [
        "O",
        "\"Q'\"",
        "\"end-1\"",
        "P",
        "T",
        "R",
        "com",
        "com",
        "guide",
    ];
    assert_eq!(points, expected);
}

/// Returns the visible parts of a scene, for comparing two texts of one scene.
fn visible_parts(text: &str) -> String {
    let scene = Scene::parse(text, "gist").unwrap_or_else(|faults| panic!("{faults}"));
    let names: Vec<_> = scene
        .mechanism
        .point_ids()
        .map(|id| scene.point_name(id))
        .collect();
    format!(
        "{names:?} {:?} {:?} {:?}",
        scene.link_names, scene.vectors, scene.mechanism
    )
}

#[test]
fn line_endings_bom_tabs_and_comments_are_ignored() {
    let text = presets::find("four-bar").unwrap().text;
    let expected = visible_parts(text);
    assert_eq!(visible_parts(&text.replace('\n', "\r\n")), expected);
    assert_eq!(visible_parts(&format!("\u{feff}{text}")), expected);
    assert_eq!(visible_parts(&text.replace(" = ", "\t=\t")), expected);
    assert_eq!(
        visible_parts(&text.replace('\n', "   # \u{f6}\u{202e} remark\n")),
        expected
    );
    let bytes = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    assert!(Scene::read(&bytes, "bytes").is_ok());
}

#[test]
fn links_are_read_from_dotted_keys_and_tables() {
    let text = presets::find("four-bar").unwrap().text;
    let inline = "r2 = { from = \"A\", to = \"B\", length = 100, com = [0, 0] }";
    let dotted = "r2.from = \"A\"\nr2.to = \"B\"\nr2.length = 1e2\nr2.com = [0.0, -0.0]";
    assert!(text.contains(inline));
    let other = text.replace(inline, dotted);
    let names = |text| Scene::parse(text, "x").unwrap().link_names;
    assert_eq!(names(&other), names(text));
    let table = "[links.r2]\nfrom = \"A\"\nto = \"B\"\nlength = 0x64\n[links]\n";
    let other = text.replace("[links]\n", table).replace(inline, "");
    assert_eq!(names(&other), names(text));
}

/// `from` may name a point defined later. Without it, length and angle start at the link's origin.
#[test]
fn polar_points_are_placed_relative_to_from_point() {
    let points = "points = { F = { from = \"E\", length = 5, angle = -90 }, P = [1, 2], \
                  E = { from = \"C\", length = 180, angle = 90 }, G = { length = 50, angle = 60 } }, \
                  com = { from = \"F\", length = 3, angle = 180 }";
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("com = [150, 0]", points);
    let scene = Scene::parse(&text, "seen").unwrap();
    let mut links = scene.mechanism.link_ids();
    let r3 = links.find(|&id| scene.link_name(id) == "r3").unwrap();
    let r3 = scene.mechanism.link(r3);
    for (name, position) in [
        ("P", Vec2::new(1.0, 2.0)),
        ("E", Vec2::new(300.0, 180.0)),
        ("F", Vec2::new(300.0, 175.0)),
        ("G", Vec2::new(25.0, 50.0 * 0.75_f64.sqrt())),
        ("r3.com", Vec2::new(297.0, 175.0)),
    ] {
        assert_eq!(r3.local(point(&scene, name)), Some(position), "{name}");
    }
    // In file order, as in tables.
    let names = scene.mechanism.point_ids();
    let names: Vec<_> = names.filter_map(|id| scene.point_name(id)).collect();
    let further = ["A", "D", "B", "C", "F", "P", "E", "G"];
    assert_eq!(names[..8], further);
}

/// A guide runs through the named point, also after that point moves.
#[test]
fn guide_through_polar_point_follows_the_point() {
    let preset = presets::find("whitworth").unwrap().text;
    let scene = Scene::parse(preset, "whitworth").unwrap();
    let on_link = |s: &crate::Slide| matches!(s.on, Body::Link(_));
    assert!(scene.mechanism.slides().iter().any(on_link));
    let text = "[ground]\nA = [0, 0]\nD = [0, -40]\n[driver]\nlink = \"r2\"\nangle = 20\n[links]\n\
                r2 = { from = \"A\", to = \"B\", length = 10 }\n\
                r4 = { from = \"D\", to = \"C\", length = 90, points = { Q = { length = 7.1, angle = 33.3 } } }\n\
                [slides]\ns = { point = \"B\", on = \"r4\", through = \"Q\", angle = 10 }\n[start]\nC = [20, 40]\n";
    let scene = Scene::parse(text, "guide").unwrap();
    let slide = &scene.mechanism.slides()[0];
    let q = scene.mechanism.links()[1].local(point(&scene, "Q"));
    assert_eq!(Some(slide.through), q);
    assert_eq!(slide.named, Some(point(&scene, "Q")));
    let way = scene.mechanism.lengths();
    let arm = way.iter().find(|l| matches!(l, crate::Length::Arm(..)));
    let moved = scene.mechanism.changed(*arm.unwrap(), 1.0);
    let q = moved.links()[1].local(point(&scene, "Q"));
    assert!((moved.slides()[0].through - q.unwrap()).norm() < 1e-14);
}

#[test]
fn missing_keys_have_defaults() {
    let text = "[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 0\n\
                [links]\nr = { from = \"A\", to = \"B\", length = 1 }\n";
    let scene = Scene::parse(text, "some/where/Crank 1.toml").unwrap();
    assert_eq!(scene.name, "Crank 1");
    assert_eq!(scene.unit, Unit::Millimetre);
    assert_eq!((scene.source, scene.note), (None, None));
    let driver = scene.mechanism.driver();
    assert_eq!((driver.speed, driver.acceleration), (1.0, 0.0));
    assert_eq!(scene.mechanism.gravity(), Vec2::ZERO);
}

#[test]
fn harmful_characters_in_names_are_replaced() {
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("Four-bar crank-rocker", "Four\\u001b[2J\\u202e bar");
    let scene = Scene::parse(&text, "x").unwrap();
    assert_eq!(scene.name, "Four\u{fffd}[2J\u{fffd} bar");
    let unnamed = Scene::parse(presets::all()[0].text, "a\u{1b}c.toml").unwrap();
    assert!(!unnamed.name.contains(is_harmful));
}

/// Lecture notes count the frame as a link. A frame written as a link becomes the vector of that
/// name.
#[test]
fn frame_written_as_link_becomes_a_vector() {
    let given = crate::scene::presets::find("four-bar").unwrap().text;
    let (plain, _) = given.split_once("\n[vectors]").unwrap();
    let with = |length: &str, more: &str| {
        let frame =
            format!("[links]\nr1 = {{ from = \"D\", to = \"A\", length = {length}{more} }}");
        plain.replace("[links]", &frame)
    };
    let scene = Scene::parse(&with("400", ""), "frame").unwrap();
    let as_vector = Scene::parse(given, "frame").unwrap();
    let mut names: Vec<&str> = scene.vectors.iter().map(|v| v.name.as_str()).collect();
    assert_eq!(names, ["r1", "r2", "r3", "r4"], "in the order of the file");
    names.rotate_left(1);
    assert!(as_vector.vectors.iter().map(|v| v.name.as_str()).eq(names));
    assert_eq!(scene.mechanism.links().len(), 3);
    assert!(matches!(scene.vectors[0].kind, VectorKind::Between(..)));
    // With a mass, a load or another length it stays a link, and a wrong length is an error.
    let heavy = Scene::parse(&with("400", ", com = [200, 0], mass = 1"), "frame").unwrap();
    assert_eq!(heavy.mechanism.links().len(), 4);
    let turned = with("400", "") + "\n[[loads]]\nlink = \"r1\"\ntorque = 5\n";
    assert_eq!(
        Scene::parse(&turned, "frame")
            .unwrap()
            .mechanism
            .links()
            .len(),
        4
    );
    let long = Scene::parse(&with("410", ""), "frame");
    let fits = long.is_ok_and(|scene| crate::solver::Solver::new(&scene.mechanism).is_ok());
    assert!(!fits, "D and A are 400 mm apart");
}
