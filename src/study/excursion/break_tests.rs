//! What directions make of a figure where they pass a full turn.

use super::NoFigure;
use super::tests::{close, figures, opened};
use crate::quantity::Catalogue;
use crate::scene::{Scene, presets};
use crate::solver::{Order, Solver};

/// The crank-rocker, and a fixed direction v beside which the rocker passes half a turn.
fn beside_a_line(definitions: &str) -> (Scene, Solver) {
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace(
        "D = [400, 0]",
        "D = [400, 0]\nE = [-200, 346.41016151377545]",
    );
    let text = text.replace("r1 = [\"D\", \"A\"]", "v = [\"A\", \"E\"]");
    opened(&format!("{text}\n[figures]\n{definitions}"))
}

/// The rocker beside a line that stands still swings as it does beside the x axis.
#[test]
fn a_difference_of_directions_has_no_jump_at_half_a_turn() {
    let scene = beside_a_line(
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
    // At its greatest it has the value that a state has, and there is one jump of the values in between.
    let [least, greatest, at] = ["rel.least", "rel.greatest", "rel.greatest.at"]
        .map(|name| figures(&scene, &[name])[0].unwrap());
    let column = Catalogue::new(&scene.0).find("rel").unwrap();
    let mut state = scene.1.state();
    let _ = scene.1.solve(at, Order::Position, &mut state);
    close(&[Ok(greatest)], &[column.value(&state).unwrap()], 1e-12);
    assert!(least < -180.0 && greatest > -180.0, "{least} {greatest}");
    // Folded at half a turn it does not jump.
    let folded = figures(&scene, &["fold.greatest", "fold.least"]);
    let least = (least + 360.0).min(-greatest);
    close(&folded, &[180.0, least], 1e-9);
}

#[test]
fn a_difference_to_what_turns_turns_round() {
    let scene = beside_a_line(
        "off = \"r2.angle - r4.angle\"\nsum = \"r2.angle + r4.angle\"\non = \"driver.angle - r4.angle\"\n\
         lift = \"B.y * sin(r2.angle - r4.angle)\"\n",
    );
    let found = figures(&scene, &["off.swing", "sum.swing", "on.swing"]);
    assert_eq!(found, [Err(NoFigure::TurnsRound); 3]);
    assert!(figures(&scene, &["lift.stroke"])[0].is_ok());
}

/// Half of a jump by a full turn is none that can be left out.
#[test]
fn what_jumps_by_less_than_a_turn_has_no_stroke() {
    let scene = beside_a_line(
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
