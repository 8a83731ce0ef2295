//! Tests the explanation of every fault of the solver, on presets.

use super::*;
use crate::scene::presets;

fn scene(preset: &str) -> Scene {
    Scene::parse(presets::find(preset).unwrap().text, preset).unwrap()
}

fn link(scene: &Scene, name: &str) -> LinkId {
    let mut ids = scene.mechanism.link_ids();
    ids.find(|&id| scene.link_name(id) == name).unwrap()
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut ids = scene.mechanism.point_ids();
    ids.find(|&id| scene.point_name(id) == Some(name)).unwrap()
}

#[track_caller]
fn assert_message(scene: &Scene, fault: &Fault, phrases: &[&str]) {
    let shown = scene.explain(fault).to_string();
    for phrase in phrases {
        assert!(shown.contains(phrase), "{phrase:?} is not in:\n{shown}");
    }
}

#[test]
fn mobility_fault_names_floating_and_redundant_parts() {
    let scene = scene("four-bar");
    let floating = vec![link(&scene, "r3"), link(&scene, "r4")];
    let fault = Fault::Mobility {
        mobility: 2,
        redundant: 1,
        repeating: Vec::new(),
        floating,
        is_unclear: false,
    };
    let phrases = [
        "the mobility is 2, not 1",
        "`r3` is not fully constrained",
        "`r4` is not fully constrained",
        "1 constraint is redundant",
        "1 constraint is missing",
    ];
    assert_message(&scene, &fault, &phrases);
    let fault = Fault::Mobility {
        mobility: 0,
        redundant: 2,
        repeating: vec![ElementId::Link(link(&scene, "r3"))],
        floating: Vec::new(),
        is_unclear: true,
    };
    let phrases = [
        "the mobility is 0, not 1: nothing can move",
        "2 constraints are redundant, among link `r3`",
        "this is not certain",
        "remove a link or a joint",
    ];
    assert_message(&scene, &fault, &phrases);
}

#[test]
fn open_loop_fault_reports_gap_and_links() {
    let scene = scene("four-bar");
    let fault = Fault::Open {
        point: point(&scene, "C"),
        links: vec![link(&scene, "r3"), link(&scene, "r4")],
        gap: 12.345_678,
    };
    let phrases = [
        "`C` is out of reach by 12.3457 mm",
        "`r3` must reach it",
        "`r4` must reach it",
        "the driver is at 60 deg",
    ];
    assert_message(&scene, &fault, &phrases);
}

#[test]
fn vague_start_lists_choices_as_toml_lines() {
    let mut text = presets::find("four-bar").unwrap().text.to_owned();
    text = text
        .replace("\"C\"", "\"C'\"")
        .replace("C = [310, 230]", "");
    let scene = Scene::parse(&text, "x").unwrap();
    let fault = Fault::Vague {
        point: point(&scene, "C'"),
        choices: vec![Vec2::new(311.416_95, 233.78), Vec2::new(-1e-7, 2.0 / 3.0)],
        behind: Vec::new(),
    };
    let phrases = [
        "`C'` can be at (311.417, 233.78) or (-1e-7, 0.666667) mm",
        "\"C'\" = [311.417, 233.78]   # or",
        "\"C'\" = [-1e-7, 0.666667]",
    ];
    assert_message(&scene, &fault, &phrases);
    // The shown lines can be copied to the file unchanged.
    let mended = text.replace("[start]\n", "[start]\n\"C'\" = [-1e-7, 0.666667]\n");
    assert!(Scene::parse(&mended, "x").is_ok());
}

#[test]
fn vague_start_quotes_the_given_position() {
    let scene = scene("four-bar");
    let fault = Fault::Vague {
        point: point(&scene, "C"),
        choices: vec![Vec2::ZERO, Vec2::X],
        behind: Vec::new(),
    };
    assert_message(&scene, &fault, &["[start] has `C` at (310, 230)"]);
}

#[test]
fn unassembled_group_asks_for_missing_start_positions() {
    let scene = scene("stephenson-six-bar");
    let given = scene.mechanism.start()[0].0;
    let other = scene
        .mechanism
        .point_ids()
        .find(|&p| {
            scene.mechanism.point(p).ground.is_none()
                && !scene.mechanism.start().iter().any(|&(s, _)| s == p)
        })
        .unwrap();
    let name = scene.point_name(other).unwrap();
    let fault = Fault::NotAssembled {
        points: vec![given, other],
        gap: 3.0,
    };
    let line = format!("{name} = [x, y]");
    assert_message(
        &scene,
        &fault,
        &["no assembly was found near the start", &line],
    );
    let fault = Fault::NotAssembled {
        points: vec![given],
        gap: 3.0,
    };
    assert_message(&scene, &fault, &["move the positions in [start] closer"]);
    let fault = Fault::NotAssembled {
        points: Vec::new(),
        gap: 3.0,
    };
    assert_message(&scene, &fault, &["at this position of the driver"]);
}

#[test]
fn over_constrained_fault_names_element_and_misfit() {
    let scene = scene("excavator-boom");
    let fault = Fault::OverConstrained {
        element: ElementId::Slide(scene.mechanism.slide_ids().next().unwrap()),
        others: vec![ElementId::Link(LinkId::new(0))],
        misfit: 1e-9,
        at: 1.25,
    };
    let unit = scene.unit.symbol();
    let size = format!("by 1e-9 {unit}");
    let place = format!("the driver at 1.25 {unit}");
    let others = format!("the others are link `{}`", scene.link_name(LinkId::new(0)));
    let accepted = "[redundant]\n           misfit = 1e-8";
    assert_message(
        &scene,
        &fault,
        &["over-constrained", &size, &place, &others, accepted],
    );
}

/// Regression: `by NaNe0 mm`, and the advice to accept `misfit = NaN`.
#[test]
fn misfit_without_number_is_an_unknown_amount() {
    let scene = scene("excavator-boom");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let element = ElementId::Slide(scene.mechanism.slide_ids().next().unwrap());
        let (others, at) = (Vec::new(), 1.25);
        let over_constrained = Fault::OverConstrained {
            element,
            others,
            misfit: value,
            at,
        };
        let (point, links) = (PointId::new(0), Vec::new());
        let open = Fault::Open {
            point,
            links,
            gap: value,
        };
        let points = vec![point];
        let not_assembled = Fault::NotAssembled { points, gap: value };
        for fault in [over_constrained, open, not_assembled] {
            let shown = scene.explain(&fault).to_string();
            assert!(shown.contains("an unknown amount"), "{shown}");
            for number in ["NaN", "inf", "misfit ="] {
                assert!(!shown.contains(number), "{shown}");
            }
        }
    }
}

/// The points of `lev` coincide, so that it has no direction that the slide could fix.
#[test]
fn link_without_length_between_ground_points_misses_by_their_distance() {
    let text = "unit = \"mm\"\n[ground]\nA = [0, -100]\nD = [200, 100]\nE = [100, 0]\n\
                [driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
                r2 = { from = \"A\", to = \"B\", length = 100 }\n\
                r3 = { from = \"B\", to = \"C\", length = 100 }\n\
                r4 = { from = \"D\", to = \"C\", length = 100 }\n\
                lev = { points = { A = [0, 0], D = [0, 0], E = [0, 0] } }\n[slides]\n\
                s = { link = \"lev\", on = \"r4\", through = \"D\", angle = 0 }\n\
                [start]\nC = [200, 200]\n";
    let scene = Scene::parse(text, "x").unwrap();
    let fault = crate::solver::Solver::new(&scene.mechanism).unwrap_err();
    let misfit = "does not fit between the ground points `A` and `D`, by 282.843 mm";
    assert_message(&scene, &fault, &["link `lev`", misfit]);
}

#[test]
fn hidden_point_is_named_by_its_link() {
    let text = "[ground]\nA = [0, 0]\n[driver]\nslide = \"s\"\nposition = 0\n\
                [links]\nram = { points = { P = [1, 0] } }\nr = { from = \"A\", to = \"P\", length = 1 }\n\
                [slides]\ns = { link = \"ram\", on = \"ground\", through = \"A\" }\n";
    let scene = Scene::parse(text, "x").unwrap();
    let hidden = scene.mechanism.slides()[0].slider.point();
    assert_eq!(scene.point_name(hidden), None);
    let fault = Fault::Open {
        point: hidden,
        links: vec![link(&scene, "ram")],
        gap: 1.0,
    };
    assert_message(
        &scene,
        &fault,
        &["the origin of `ram` is out of reach by 1 mm"],
    );
}

#[test]
fn singular_group_fault_names_its_elements() {
    let scene = scene("press-ram");
    let slide = scene.mechanism.slide_ids().next().unwrap();
    let point = scene.mechanism.slide(slide).slider.point();
    let fault = Fault::Singular {
        elements: vec![ElementId::Point(point), ElementId::Driver],
        is_here_only: false,
    };
    assert_message(
        &scene,
        &fault,
        &["do not determine a position", "the driver"],
    );
    let fault = Fault::Singular {
        elements: vec![ElementId::Point(point)],
        is_here_only: true,
    };
    assert_message(
        &scene,
        &fault,
        &[
            "the scene opens at a change point or a dead point",
            "open the scene at another",
        ],
    );
}

#[test]
fn figure_formats_six_significant_digits() {
    for (value, text) in [
        (0.0, "0"),
        (-250.0, "-250"),
        (123_456.7, "123457"),
        (1e9, "1e9"),
        (9.999_999_9, "10"),
        (1.0 / 3.0, "0.333333"),
        (-2.5e-5, "-2.5e-5"),
        (f64::MAX, "1.79769e308"),
    ] {
        assert_eq!(figure(value), text);
    }
}
