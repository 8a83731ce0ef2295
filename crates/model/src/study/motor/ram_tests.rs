//! Tests rams against closed formulas, which are written out here.

use super::*;
use crate::scene::{Scene, presets};

fn opened(name: &str) -> (Scene, Solver) {
    let preset = presets::find(name).unwrap();
    of(preset.text)
}

fn of(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn ram(scene: &Scene, solver: &Solver) -> Ram {
    let slide = rams(&scene.mechanism).last().unwrap();
    let end = RamEnd::of(&scene.mechanism, slide);
    Ram::new(&scene.mechanism, solver, slide, end).unwrap()
}

fn near(value: f64, exact: f64, maximum: f64) {
    let error = (value - exact).abs();
    assert!(error <= maximum, "{value} for {exact}: {error:e}");
}

/// Crank r, rod l, the guide e below the pivot, at 120 rpm.
const R: f64 = 40.0;
const L: f64 = 120.0;
const E: f64 = 50.0;
const OMEGA: f64 = 4.0 * std::f64::consts::PI;

#[test]
fn offset_slider_crank_ram_matches_textbook_formulas() {
    let (scene, solver) = opened("offset-slider-crank");
    let mut ram = ram(&scene, &solver);
    assert!(!ram.end.is_known, "a horizontal guide has no lower end");
    let far = ((L + R).powi(2) - E * E).sqrt();
    let close = ((L - R).powi(2) - E * E).sqrt();
    near(ram.stroke, far - close, 1e-12);
    near(ram.bottom.position, far, 1e-12);
    near(ram.top.position, close, 1e-12);
    // Crank and rod in one line, stretched and folded.
    let stretched = 360.0 - (E / (L + R)).asin().to_degrees();
    let folded = 180.0 - (E / (L - R)).asin().to_degrees();
    near(ram.bottom.at, stretched, 1e-12);
    near(ram.top.at, folded, 1e-12);
    let closing = stretched - folded;
    near(ram.travels[0], closing, 1e-12);
    near(ram.time_ratio(), closing / (360.0 - closing), 1e-13);
    near(ram.strokes_per_minute().unwrap(), 120.0, 1e-12);
    assert_eq!((ram.strokes, ram.others.len()), (1, 0));

    let [closing, opening] = ram.at_height(10.0).unwrap();
    for (passing, sense) in [(closing, 1.0), (opening, -1.0)] {
        let x = far - 10.0;
        near(passing.position, x, 1e-11);
        // (x - r cos)^2 + (e + r sin)^2 = l^2, and its two rates.
        let (s, c) = passing.at.to_radians().sin_cos();
        let (a, b) = (x - R * c, E + R * s);
        near(a * a + b * b, L * L, 1e-9);
        let v = -(a * R * s + b * R * c) / a;
        let (da, db) = (v + R * s, R * c);
        let acc = -(da * da + db * db + a * R * c - b * R * s) / a;
        near(passing.velocity, v * OMEGA, 1e-9);
        near(passing.acceleration, acc * OMEGA * OMEGA, 1e-7);
        near(passing.leverage, 1000.0 / v.abs(), 1e-8);
        assert!(passing.velocity * sense > 0.0);
    }
    let dwell = ram.dwell(10.0).unwrap();
    near(dwell.from, closing.at, 1e-10);
    near(dwell.to, opening.at, 1e-10);
    near(
        dwell.travel,
        (opening.at - closing.at).rem_euclid(360.0),
        1e-10,
    );
    near(
        dwell.seconds.unwrap(),
        dwell.travel.to_radians() / OMEGA,
        1e-14,
    );
    assert_eq!(ram.at_height(ram.stroke + 1.0), None);
    assert_eq!(ram.at_height(0.0).unwrap()[0].at, ram.bottom.at);
}

#[test]
fn backward_driver_swaps_closing_and_opening() {
    let (scene, solver) = opened("offset-slider-crank");
    let text = presets::find("offset-slider-crank").unwrap().text;
    let (back_scene, back_solver) = of(&text.replace("120 rpm", "-120 rpm"));
    let mut there = ram(&scene, &solver);
    let mut back = ram(&back_scene, &back_solver);
    assert_eq!((there.bottom, there.top), (back.bottom, back.top));
    assert_eq!(
        (there.travels[0], there.travels[1]),
        (back.travels[1], back.travels[0])
    );
    let (a, b) = (there.at_height(6.0).unwrap(), back.at_height(6.0).unwrap());
    assert_eq!((a[0].at, a[1].at), (b[1].at, b[0].at));
    assert!(b[0].velocity > 0.0 && b[1].velocity < 0.0);
    assert_eq!(a[1].velocity, -b[0].velocity);
    let (a, b) = (there.dwell(1.0).unwrap(), back.dwell(1.0).unwrap());
    assert_eq!((a.from, a.to, a.travel), (b.to, b.from, b.travel));
}

/// Returns the angle of the rocker of the presets' four-bar, by the law of cosines twice.
fn rocker(theta: f64, crank: f64, rod: f64, arm: f64, ground: [f64; 2], sign: f64) -> [f64; 2] {
    let b = [crank * theta.cos(), crank * theta.sin()];
    let d = [ground[0] - b[0], ground[1] - b[1]];
    let far = d[0].hypot(d[1]);
    let along = (rod * rod - arm * arm + far * far) / (2.0 * far);
    let across = sign * (rod * rod - along * along).sqrt();
    [
        b[0] + (along * d[0] - across * d[1]) / far,
        b[1] + (along * d[1] + across * d[0]) / far,
    ]
}

/// The ram of `press-ram` at a crank angle in radians.
fn press_ram(theta: f64) -> f64 {
    let c = rocker(theta, 100.0, 300.0, 250.0, [400.0, 0.0], 1.0);
    let (dx, dy) = ((c[0] - 400.0) / 250.0, c[1] / 250.0);
    let e = [400.0 + 40.0 * dx + 180.0 * dy, 40.0 * dy - 180.0 * dx];
    e[1] - (350.0_f64.powi(2) - (560.0 - e[0]).powi(2)).sqrt()
}

#[test]
fn press_ram_follows_closed_formula() {
    let (scene, solver) = opened("press-ram");
    let mut ram = ram(&scene, &solver);
    assert!(ram.end.is_known && ram.end.end == StrokeEnd::Minimum);
    for centre in [ram.bottom, ram.top] {
        let theta = centre.at.to_radians();
        near(press_ram(theta), centre.position, 1e-11);
        // Stationary: a step to either side changes the position by the step's square.
        let [before, after] = [-1e-4, 1e-4].map(|h| press_ram(theta + h) - centre.position);
        near(before, after, 1e-9);
        assert!(before * after > 0.0);
    }
    let samples = (0..3600).map(|k| press_ram(f64::from(k).to_radians() / 10.0));
    let (low, high) = samples.fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(s), h.max(s)));
    assert!(ram.bottom.position <= low && low - ram.bottom.position < 1e-3);
    assert!(ram.top.position >= high && ram.top.position - high < 1e-3);
    let [closing, _] = ram.at_height(6.0).unwrap();
    near(
        press_ram(closing.at.to_radians()),
        ram.bottom.position + 6.0,
        1e-11,
    );
    assert!(closing.velocity < 0.0);
    // Virtual work: the ram's force times its displacement is the work of the torque.
    let slope = (press_ram(closing.at.to_radians() + 1e-6)
        - press_ram(closing.at.to_radians() - 1e-6))
        / 2e-6;
    near(closing.leverage, 1000.0 / slope.abs(), 1e-3);
}

#[test]
fn toggle_press_dwells_at_bottom() {
    let (scene, solver) = opened("toggle-press");
    let mut ram = ram(&scene, &solver);
    let press = |theta: f64| {
        let shift = [-300.0, 250.0];
        let k = rocker(theta, 60.0, 236.0, 240.0, shift, 1.0);
        let k = [k[0] + 300.0, k[1] - 250.0];
        k[1] - (240.0_f64.powi(2) - k[0] * k[0]).sqrt()
    };
    near(
        press(ram.bottom.at.to_radians()),
        ram.bottom.position,
        1e-10,
    );
    near(press(ram.top.at.to_radians()), ram.top.position, 1e-10);
    let dwell = ram.dwell(0.5).unwrap();
    for at in [dwell.from, dwell.to] {
        near(press(at.to_radians()), ram.bottom.position + 0.5, 1e-10);
    }
    near(dwell.seconds.unwrap(), dwell.travel / 180.0, 1e-12);
    assert!(dwell.travel > 20.0, "{dwell:?}");
    near(
        ram.strokes_per_minute().unwrap(),
        30.0 * f64::from(ram.strokes),
        1e-12,
    );
    // A tolerance larger than the stroke contains all of it.
    near(ram.dwell(2.0 * ram.stroke).unwrap().travel, 360.0, 1e-12);
}

#[test]
fn ram_of_limited_driver_moves_there_and_back() {
    // A rod of 100 pushed up by a slide along x: y = sqrt(100^2 - x^2), at 50 mm/s.
    let text = "unit = \"mm\"
[driver]
slide = \"push\"
position = 60
speed = \"50 mm/s\"
[links]
rod = { from = \"P\", to = \"Q\", length = 100 }
[slides]
push = { point = \"P\", on = \"ground\", through = [0, 0], angle = 0 }
ram = { point = \"Q\", on = \"ground\", through = [0, 0], angle = 90 }
[start]
Q = [0, 80]
";
    let (scene, solver) = of(text);
    let mut ram = ram(&scene, &solver);
    near(ram.top.position, 100.0, 1e-9);
    near(ram.top.at, 0.0, 1e-9);
    let [closing, opening] = ram.at_height(80.0 - ram.bottom.position).unwrap();
    near(closing.at.abs(), 60.0, 1e-9);
    near(closing.velocity, -37.5, 1e-9);
    near(opening.velocity, 37.5, 1e-9);
    near(closing.leverage, 80.0 / 60.0, 1e-12);
    near(ram.time_ratio(), 1.0, 1e-12);
}

#[test]
fn slide_on_moving_link_is_no_ram() {
    let (scene, solver) = opened("slotted-lever");
    let slide = scene.mechanism.slide_ids().next().unwrap();
    let end = RamEnd::of(&scene.mechanism, slide);
    let refused = Ram::new(&scene.mechanism, &solver, slide, end);
    assert_eq!(refused.unwrap_err(), NoRam::Moves);
    assert_eq!(rams(&opened("four-bar").0.mechanism).count(), 0);
}
