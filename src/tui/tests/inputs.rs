//! Tests stepping held inputs.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::tui::app::App;

use crate::tui::document::opening;
use crate::tui::{OpenedScene, Origin};
use crate::wording::Language;
use ratatui::layout::Size;
use std::time::Duration;

fn open(name: &str) -> App {
    Language::English.speak();
    app(opening::preset(presets::find(name).unwrap()).unwrap())
}

fn app(opened: OpenedScene) -> App {
    let capability = Capability {
        glyphs: Glyphs::Ascii,
        colours: Colours::None,
        modern: false,
    };
    App::new(opened, None, capability, Size::new(80, 24))
}

/// Presses keys, separated by blanks; `_` is the space bar.
fn press(app: &mut App, keys: &str) {
    for key in keys.split(' ') {
        let key = if key == "_" { " " } else { key };
        app.key(key.parse().unwrap(), Duration::ZERO);
    }
}

/// Returns the coordinates of the inputs, the driver first.
fn inputs(app: &App) -> Vec<f64> {
    let (scene, at) = (app.open_scene().scene(), app.open_scene().at());
    let inputs = scene.mechanism.inputs();
    let inputs = inputs.map(|input| scene.mechanism.input_coordinate(input, at).unwrap());
    inputs.collect()
}

#[track_caller]
fn assert_point(app: &App, name: &str, x: f64, y: f64) {
    let scene = app.open_scene().scene();
    let mut points = scene.mechanism.point_ids();
    let point = points.find(|&point| scene.point_name(point) == Some(name));
    let at = app.open_scene().state().position(point.unwrap()).unwrap();
    assert!((at.x - x).hypot(at.y - y) < 1e-9, "{at:?}");
}

/// The places of P are intersections of two circles of 140 about the elbows.
#[test]
fn step_keys_move_the_selected_input() {
    let mut app = open("five-bar");
    assert_eq!(app.selected_input(), None);
    press(&mut app, "U");
    assert_eq!(app.selected_input().as_deref(), Some("r5 60 deg"));
    press(&mut app, ".");
    assert_eq!(inputs(&app), [120.0, 65.0]);
    assert_point(&app, "P", -5.601_072_197_747_116, 179.880_961_643_707_56);
    press(&mut app, "[ ,");
    assert_eq!(inputs(&app), [120.0, 63.0]);
    // Steps are one edit each kind, and can be undone.
    press(&mut app, "u");
    assert_eq!(inputs(&app), [120.0, 60.0]);
    // After the last input, the keys move the driver again.
    press(&mut app, "U .");
    assert_eq!(app.selected_input(), None);
    assert_eq!(inputs(&app), [125.0, 60.0]);
}

#[test]
fn inputs_are_moved_by_name() {
    let mut app = open("five-bar");
    press(&mut app, "g r 5 _ 9 0 Enter");
    assert_eq!(inputs(&app), [120.0, 90.0]);
    assert!(app.mode().is_normal());
    press(&mut app, "g r 2 _ 9 0 Enter");
    assert_eq!(inputs(&app), [90.0, 90.0]);
    assert_point(&app, "P", 0.0, 226.491_106_406_735_18);
    press(&mut app, ": r 5 _ 6 0 Enter");
    assert_eq!(inputs(&app), [90.0, 60.0]);
    assert_point(&app, "P", 33.723_943_111_888, 203.999_146_571_304_04);
    // A name alone selects the input, and an unknown one is reported.
    press(&mut app, "g r 5 Enter");
    assert_eq!(app.selected_input().as_deref(), Some("r5 60 deg"));
    press(&mut app, "g r 3 _ 1 Enter");
    assert!(!app.mode().is_normal());
    assert_eq!(inputs(&app), [90.0, 60.0]);
}

/// The third cylinder is one of three; each step of a slide is about a hundredth of its length.
#[test]
fn cylinders_are_stepped_in_the_unit_of_the_scene() {
    let mut app = open("excavator");
    press(&mut app, "U U");
    assert_eq!(app.selected_input().as_deref(), Some("bucket-rod 2 m"));
    press(&mut app, ".");
    assert_eq!(inputs(&app), [1.9, 2.55, 2.01]);
}

#[test]
fn scenes_of_one_input_have_no_other() {
    let mut app = open("four-bar");
    press(&mut app, "U .");
    assert_eq!(app.selected_input(), None);
    assert_eq!(inputs(&app), [65.0]);
}

/// Opens a five-bar with this line for its second input.
fn five_bar(line: &str) -> App {
    Language::English.speak();
    let text = presets::find("five-bar").unwrap().text;
    let text = text.replace("r5 = { at = 60 }", line);
    let (name, _) = line.split_once(' ').unwrap();
    let text = text.replace("r5 = { from", &format!("{name} = {{ from"));
    app(opening::text(&text, Origin::Stdin).unwrap())
}

#[test]
fn input_held_by_a_ratio_of_zero_is_stepped_by_its_phase() {
    let mut app = five_bar("r5 = { ratio = 0, phase = 60 }");
    press(&mut app, "U .");
    assert_eq!(inputs(&app), [120.0, 65.0]);
}

/// Links may have digits as names; a number alone is a coordinate of the driver all the same.
#[test]
fn number_alone_moves_the_driver() {
    let mut app = five_bar("5 = { at = 60 }");
    press(&mut app, "g 9 0 Enter");
    assert_eq!(inputs(&app), [90.0, 60.0]);
    press(&mut app, "g 5 Enter");
    assert_eq!(app.selected_input(), None);
}
