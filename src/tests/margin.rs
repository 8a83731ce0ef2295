//! Tests the distances of groups from their singularities.

use crate::scene::{Scene, presets};
use crate::solver::Solver;

#[test]
fn dyad_margin_is_squared_sine_of_transmission_angle() {
    let preset = presets::find("four-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut workspace = solver.state();
    let margins = solver.margins(60.0, &mut workspace).unwrap();
    // The sine of the lectures' transmission angle at 60 deg, from the reference values.
    let sine: f64 = 0.988_685_996_664_259_4;
    assert!((margins[1] - sine * sine).abs() < 1e-12, "{margins:?}");
    assert_eq!(margins[0], 1.0);
}

#[test]
fn coupled_group_margin_depends_on_position() {
    let preset = presets::find("stephenson-six-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut workspace = solver.state();
    let mut at = |degrees| solver.margins(degrees, &mut workspace).unwrap()[1];
    assert!(at(60.0) > 0.0 && at(60.0) != at(120.0));
    assert_eq!(at(60.0).to_bits(), at(60.0).to_bits());
}
