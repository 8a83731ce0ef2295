//! Tests discontinuous quantities: directions in them pass a full turn, or they grow without bound.

use super::NoFigure;
use super::tests::{close, excursion, figures, opened};
use crate::quantity::Catalogue;
use crate::scene::{Scene, presets};
use crate::solver::{Order, Solver};

/// Returns the crank-rocker with a fixed direction v. The rocker swings past the opposite
/// direction.
fn fixed_direction_scene(definitions: &str) -> (Scene, Solver) {
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace(
        "D = [400, 0]",
        "D = [400, 0]\nE = [-200, 346.41016151377545]",
    );
    let text = text.replace("r1 = [\"D\", \"A\"]", "v = [\"A\", \"E\"]");
    opened(&format!("{text}\n[figures]\n{definitions}"))
}

/// Relative to a fixed line, the rocker swings as it does relative to the x axis.
#[test]
fn direction_difference_has_no_jump_at_half_turn() {
    let scene = fixed_direction_scene(
        "rel = \"r4.angle - v.angle\"\nback = \"v.angle - r4.angle\"\ntwice = \"2 * r4.angle\"\n\
         more = \"r4.angle + r4.angle - v.angle\"\nhalf = \"r4.angle / 2\"\nfold = \"abs(r4.angle - v.angle)\"\n",
    );
    let own = figures(&scene, &["r4.angle.swing", "r4.angle.ratio"]);
    let [swing, ratio] = [own[0].unwrap(), own[1].unwrap()];
    assert!((swing - 47.643_195_1).abs() < 1e-7, "{swing}");
    let found = figures(&scene, &["rel.swing", "rel.ratio", "rel.turns"]);
    close(&found, &[swing, ratio, 2.0], 1e-12);
    let found = figures(&scene, &["back.swing", "back.ratio"]);
    close(&found, &[swing, ratio], 1e-12);
    let found = figures(&scene, &["twice.swing", "more.swing", "half.swing"]);
    close(&found, &[2.0 * swing, 2.0 * swing, 0.5 * swing], 1e-12);
    // At its maximum it has the value of a state, and the values in between jump once.
    let [minimum, maximum, at] = ["rel.least", "rel.greatest", "rel.greatest.at"]
        .map(|name| figures(&scene, &[name])[0].unwrap());
    let column = Catalogue::new(&scene.0).find("rel").unwrap();
    let mut state = scene.1.state();
    let _ = scene.1.solve(at, Order::Position, &mut state);
    close(&[Ok(maximum)], &[column.value(&state).unwrap()], 1e-12);
    assert!(minimum < -180.0 && maximum > -180.0, "{minimum} {maximum}");
    // The absolute value, folded at half a turn, does not jump.
    let folded = figures(&scene, &["fold.greatest", "fold.least"]);
    let minimum = (minimum + 360.0).min(-maximum);
    close(&folded, &[180.0, minimum], 1e-9);
}

#[test]
fn difference_to_rotating_link_turns_round() {
    let scene = fixed_direction_scene(
        "off = \"r2.angle - r4.angle\"\nsum = \"r2.angle + r4.angle\"\non = \"driver.angle - r4.angle\"\n\
         lift = \"B.y * sin(r2.angle - r4.angle)\"\n",
    );
    let found = figures(&scene, &["off.swing", "sum.swing", "on.swing"]);
    assert_eq!(found, [Err(NoFigure::TurnsRound); 3]);
    assert!(figures(&scene, &["lift.stroke"])[0].is_ok());
}

/// Half of a jump by a full turn cannot be ignored.
#[test]
fn value_jumping_by_part_of_a_turn_has_no_stroke() {
    let scene = fixed_direction_scene(
        "half = \"(r4.angle - v.angle) / 2\"\nturn = \"r2.angle / 2\"\ncount = \"driver.angle / 2\"\n\
         arc = \"driver.angle * C.x\"\n",
    );
    let found = figures(
        &scene,
        &["half.swing", "turn.swing", "count.swing", "arc.stroke"],
    );
    let Err(NoFigure::Jumps(at)) = found[0] else {
        panic!("{found:?}");
    };
    let column = Catalogue::new(&scene.0).find("half").unwrap();
    let mut state = scene.1.state();
    let mut half = |at: f64| {
        let _ = scene.1.solve(at, Order::Position, &mut state);
        column.value(&state).unwrap()
    };
    let sides = [half(at - 1e-9), half(at + 1e-9)];
    assert!((sides[0] - sides[1]).abs() > 179.0, "{at} {sides:?}");
    assert_eq!(found[1..], [Err(NoFigure::Jumps(0.0)); 3]);
}

/// 1 / (x - a) and similar formulas have no maximum. If the denominator never reaches 0, they have
/// one.
#[test]
fn pole_is_not_a_maximum() {
    let scene = fixed_direction_scene(
        "gain = \"r2.omega / r4.omega\"\nodd = \"1 / (C.x - 300 mm)\"\neven = \"1 / (C.x - 300 mm)^2\"\n\
         size = \"abs(1 / (C.x - 300 mm))\"\nroot = \"1 / sqrt(abs(C.x / (300 mm) - 1))\"\n\
         slope = \"tan(r2.angle)\"\nnear = \"1 / ((C.x - 300 mm)^2 + 0.0001 mm^2)\"\n\
         none = \"C.x - 300 mm\"\npush = \"C.ax / (C.x - 300 mm)\"\n\
         pull = \"C.ax / (C.x - 300 mm)^2\"\n",
    );
    let pole = |name: &str| match figures(&scene, &[name])[0] {
        Err(NoFigure::Unbounded(at)) => at,
        other => panic!("{name}: {other:?}"),
    };
    let value = |name: &str, at: f64| figures(&scene, &[&format!("{name}@{at}")])[0].unwrap();
    // The rocker turns back where its speed is zero.
    let back = figures(&scene, &["r4.angle.least.at"])[0].unwrap();
    assert!((pole("gain.greatest") - back).abs() < 1e-8, "{back}");
    for name in ["odd", "even", "size", "root", "push", "pull"] {
        let at = pole(&format!("{name}.stroke"));
        assert!((value("C.x", at) - 300.0).abs() < 1e-6, "{name} {at}");
    }
    assert!((pole("slope.least") - 90.0).abs() < 1e-8);
    close(&figures(&scene, &["near.greatest"]), &[1e4], 1e-9);
    assert!(figures(&scene, &["none.stroke"])[0].is_ok());
}

/// Returns the crank-rocker with a torque of -40 N m on the rocker, times a factor over the crank's
/// angle.
fn loaded(over: &str) -> (Scene, Solver) {
    let text = presets::find("four-bar").unwrap().text;
    opened(&format!(
        "{text}\n[[loads]]\nlink = \"r4\"\ntorque = -40\nover = {over}\n"
    ))
}

/// The crank's torque is 40 N m times the ratio of both speeds, at the peak of a load a fifth of a
/// degree wide.
#[test]
fn narrow_load_peak_is_found() {
    let scene = loaded("[[0, 0], [80.1, 0], [80.2, 1], [80.3, 0], [360, 0]]");
    let names = [
        "driver.torque.greatest",
        "driver.torque.greatest.at",
        "driver.torque.least",
        "r4.omega@80.2",
    ];
    let found: Vec<f64> = figures(&scene, &names)
        .into_iter()
        .map(Result::unwrap)
        .collect();
    assert!((found[0] - 13.1799).abs() < 1e-4, "{found:?}");
    assert!(
        (found[0] - 40.0 * found[3] / 15.0).abs() < 1e-9,
        "{found:?}"
    );
    assert!(
        (found[1] - 80.2).abs() < 1e-9 && found[2].abs() < 1e-12,
        "{found:?}"
    );
}

/// The rocker's speed grows up to 100 deg, so the crank's torque is largest just before the load
/// ends.
#[test]
fn both_sides_of_a_jump_are_checked() {
    let scene = loaded("[[0, 0], [80, 0], [80, 1], [100, 1], [100, 0], [360, 0]]");
    let names = [
        "driver.torque.greatest",
        "driver.torque.greatest.at",
        "r4.omega@100",
    ];
    let found: Vec<f64> = figures(&scene, &names)
        .into_iter()
        .map(Result::unwrap)
        .collect();
    assert!(
        (found[0] - 40.0 * found[2] / 15.0).abs() < 1e-8,
        "{found:?}"
    );
    assert!((found[1] - 100.0).abs() < 1e-8, "{found:?}");
    // A load over two turns is followed over both.
    let scene = loaded("[[0, 0], [440, 0], [440, 1], [460, 1], [460, 0], [720, 0]]");
    let later = figures(
        &scene,
        &["driver.torque.greatest", "driver.torque.greatest.at"],
    );
    close(&later, &[found[0], 460.0], 1e-8);
}

/// max(x, a) stays at a while x is below it: the time of its minimum is not unique.
#[test]
fn value_resting_at_extremum_has_no_time_ratio() {
    let scene = fixed_direction_scene("level = \"max(B.y, 50 mm)\"\nlow = \"min(B.y, 150 mm)\"\n");
    assert_eq!(figures(&scene, &["level.ratio"]), [Err(NoFigure::Rests)]);
    assert!(figures(&scene, &["low.ratio"])[0].is_ok());
    let found = excursion(&scene, "level", None);
    let rests = found
        .turnings
        .iter()
        .find(|turning| !turning.is_peak)
        .unwrap();
    // B.y = 100 sin q is 50 at 30 and at 150 deg.
    assert!((rests.place.at - 150.0).abs() < 1e-9, "{rests:?}");
    assert!((rests.until.unwrap() - 30.0).abs() < 1e-9, "{rests:?}");
    close(&figures(&scene, &["level.least.at"]), &[150.0], 1e-9);
    let peak = found
        .turnings
        .iter()
        .find(|turning| turning.is_peak)
        .unwrap();
    assert_eq!(peak.until, None);
}

/// A ripple within the tolerance of a dwell does not split it.
#[test]
fn dwell_with_ripple_is_listed_once() {
    let scene =
        fixed_direction_scene("ripple = \"max(B.y, 50 mm) + 0.1 mm * cos(5 * r2.angle)\"\n");
    let (_, dwells) = excursion(&scene, "ripple", Some(0.5)).dwells.unwrap();
    let low = dwells.iter().filter(|dwell| dwell.about.place.value < 60.0);
    assert_eq!(low.count(), 1, "{dwells:?}");
}

/// Rounding errors change sign at every coordinate, but are no pole. A press force that jumps from
/// end to end has no ratio.
#[test]
fn rounding_errors_have_no_pole_and_jumps_no_ratio() {
    let scene = opened(presets::find("parallelogram").unwrap().text);
    let catalogue = Catalogue::new(&scene.0);
    let speeds = catalogue
        .all()
        .iter()
        .filter(|q| q.name.ends_with(".omega"));
    let names: Vec<String> = speeds.map(|q| format!("{}.stroke", q.name)).collect();
    for name in names {
        assert!(figures(&scene, &[&name])[0].is_ok(), "{name}");
    }
    let scene = loaded("[[0, 1], [100, 1], [100, -1], [360, 1]]");
    let found = figures(
        &scene,
        &["driver.torque.load.stroke", "driver.torque.load.ratio"],
    );
    assert!(found[0].is_ok(), "{found:?}");
    let scene = opened(presets::find("press-ram").unwrap().text);
    assert_eq!(figures(&scene, &["r2.A.fx.ratio"]), [Err(NoFigure::Leaps)]);
}
