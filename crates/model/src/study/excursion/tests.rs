//! Tests excursions against closed formulas, which are written out here.

use super::sampler::{MotionSampler, SlopeSource};
use super::{CycleFigure, CycleFigures, Excursion, ExcursionOptions, LEVEL, NoFigure, changing};
use crate::quantity::Catalogue;
use crate::scene::{Scene, presets};
use crate::solver::{Order, Solver};

pub(super) fn opened(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

pub(super) fn preset(name: &str) -> (Scene, Solver) {
    opened(presets::find(name).unwrap().text)
}

pub(super) fn figures(
    (scene, solver): &(Scene, Solver),
    names: &[&str],
) -> Vec<Result<f64, NoFigure>> {
    let catalogue = Catalogue::new(scene);
    let parsed = names
        .iter()
        .map(|name| CycleFigure::parse(name, &catalogue).unwrap());
    CycleFigures::new(parsed.collect(), None).of(solver)
}

pub(super) fn excursion(
    (scene, solver): &(Scene, Solver),
    name: &str,
    tolerance: Option<f64>,
) -> Excursion {
    let quantity = Catalogue::new(scene).find(name).unwrap();
    let options = ExcursionOptions {
        rates: true,
        dwells: true,
        tolerance,
    };
    Excursion::of_all(solver, &[quantity], options)
        .remove(0)
        .unwrap()
}

pub(super) fn close(found: &[Result<f64, NoFigure>], wanted: &[f64], within: f64) {
    assert_eq!(found.len(), wanted.len());
    for (found, wanted) in found.iter().zip(wanted) {
        let found = found.unwrap();
        assert!(
            (found - wanted).abs() <= within * wanted.abs().max(1.0),
            "{found} {wanted}"
        );
    }
}

/// Returns a slider-crank whose guide is offset from the crank's pivot by `offset`.
pub(super) fn slider_crank(crank: f64, rod: f64, offset: f64) -> (Scene, Solver) {
    opened(&format!(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"crank\"\nangle = 60\nspeed = \"10 rad/s\"\n\
         [links]\ncrank = {{ from = \"A\", to = \"B\", length = {crank} }}\n\
         rod = {{ from = \"B\", to = \"C\", length = {rod} }}\n[slides]\n\
         s = {{ point = \"C\", on = \"ground\", through = [0, {}], angle = 0 }}\n[start]\nC = [{rod}, {}]\n\
         [figures]\nalong = \"C.x * cos(30 deg) + C.y * sin(30 deg)\"\nheight = \"abs(B.y)\"\nlevel = \"max(B.y, 10 mm)\"\n",
        -offset, -offset
    ))
}

/// The dead centres are where crank and rod are in line: (l +- r)^2 = x^2 + e^2, and the crank's angles there are
/// -asin(e / (l + r)) and 180 deg - asin(e / (l - r)).
#[test]
fn slider_crank_stroke_and_ratio_match_dead_centres() {
    for (r, l, e) in [
        (30.0_f64, 100.0_f64, 0.0_f64),
        (40.0, 120.0, 50.0),
        (10.0, 50.0, -20.0),
    ] {
        let scene = slider_crank(r, l, e);
        let far = ((l + r).powi(2) - e * e).sqrt();
        let near = ((l - r).powi(2) - e * e).sqrt();
        let outer = -(e / (l + r)).asin().to_degrees();
        let inner = 180.0 - (e / (l - r)).asin().to_degrees();
        let back = inner - outer;
        let ratio = (back / (360.0 - back)).max((360.0 - back) / back);
        let names = [
            "C.x.stroke",
            "C.x.least",
            "C.x.greatest",
            "C.x.least.at",
            "C.x.turns",
            "C.x.ratio",
        ];
        let wanted = [far - near, near, far, inner, 2.0, ratio];
        close(&figures(&scene, &names), &wanted, 1e-12);
        let at = figures(&scene, &["C.x.greatest.at"])[0].unwrap();
        assert!(
            (at - outer)
                .rem_euclid(360.0)
                .min((outer - at).rem_euclid(360.0))
                < 1e-11
        );
        // Along a direction: y is constant, x counts by its cosine.
        let along = (far - near) * 30_f64.to_radians().cos();
        close(&figures(&scene, &["along.stroke"]), &[along], 1e-12);
        close(&figures(&scene, &["along.ratio"]), &[ratio], 1e-11);
    }
}

/// x = r cos q: the maximum speed is r w, the maximum acceleration r w^2. The yoke stays within t
/// of an end while cos q > 1 - t / r, over twice the acos of that.
#[test]
fn scotch_yoke_is_harmonic() {
    let scene = preset("scotch-yoke");
    let names = [
        "Y.x.stroke",
        "Y.x.ratio",
        "Y.x.fastest",
        "Y.x.hardest",
        "Y.x@60",
    ];
    close(
        &figures(&scene, &names),
        &[100.0, 1.0, 500.0, 5000.0, 25.0],
        1e-12,
    );
    let yoke = excursion(&scene, "Y.x", Some(2.0));
    let (_, dwells) = yoke.dwells.unwrap();
    let wanted = 2.0 * (1.0 - 2.0 / 50.0_f64).acos().to_degrees();
    assert_eq!(dwells.len(), 2);
    for dwell in &dwells {
        assert!((dwell.travel - wanted).abs() < 1e-9, "{dwell:?} {wanted}");
        let seconds = wanted.to_radians() / 10.0;
        assert!((dwell.seconds.unwrap() - seconds).abs() < 1e-12);
    }
    // A tolerance larger than the stroke contains all of it.
    let all = excursion(&scene, "Y.x", Some(200.0)).dwells.unwrap().1;
    assert!(
        all.iter().all(|dwell| (dwell.travel - 360.0).abs() < 1e-9),
        "{all:?}"
    );
}

/// The rocker of a crank-rocker a, b, c, d has an angle at D, measured from the line to A. Its
/// cosine is (c^2 + d^2 - (b +- a)^2) / (2 c d) where crank and coupler are in line; the crank's
/// angles there give the ratio.
#[test]
fn crank_rocker_swing_matches_law_of_cosines() {
    let scene = preset("four-bar");
    let (a, b, c, d) = (100.0_f64, 300.0_f64, 250.0_f64, 400.0_f64);
    let angle = |side: f64, near: f64, far: f64| {
        ((near * near + far * far - side * side) / (2.0 * near * far))
            .acos()
            .to_degrees()
    };
    let swing = angle(a + b, c, d) - angle(b - a, c, d);
    // The crank is in line with the coupler: from A, C is at b + a or, on the other side, at b - a.
    let (outer, inner) = (angle(c, b + a, d), angle(c, b - a, d) + 180.0);
    let travel = inner - outer;
    let ratio = (travel / (360.0 - travel)).max((360.0 - travel) / travel);
    let found = figures(&scene, &["r4.angle.swing", "r4.angle.ratio"]);
    close(&found, &[swing, ratio], 1e-12);
    let none = figures(
        &scene,
        &["r2.angle.swing", "r2.angle.ratio", "r2.angle.least"],
    );
    assert_eq!(none, [Err(NoFigure::TurnsRound); 3]);
    // omega4 = (a / c) w sin(t2 - t3) / sin(t4 - t3) with t3, t4 from the diagonal, every 0.01 deg.
    let rate = |t2: f64| {
        let t2 = t2.to_radians();
        let f = (d - a * t2.cos()).hypot(a * t2.sin());
        let (x, y) = (a * t2.cos(), a * t2.sin());
        let to_d = (-y).atan2(d - x);
        let t3 = to_d + ((b * b + f * f - c * c) / (2.0 * b * f)).acos();
        let (cx, cy) = (x + b * t3.cos(), y + b * t3.sin());
        let t4 = cy.atan2(cx - d);
        (a / c) * 15.0 * ((t2 - t3).sin() / (t4 - t3).sin())
    };
    let maximum = (0..36_000)
        .map(|k| rate(f64::from(k) / 100.0).abs())
        .fold(0.0, f64::max);
    let found = figures(&scene, &["r4.angle.fastest"])[0].unwrap();
    assert!(
        found >= maximum - 1e-12 && found - maximum < 1e-6,
        "{found} {maximum}"
    );
}

/// The lever's pivot lies inside the crank's circle. At the dead centres, the lever lies along the
/// ram's guide. The quick part is 2 acos(distance / crank), the slow part 360 deg minus that.
#[test]
fn whitworth_quick_return_has_known_stroke_and_ratio() {
    let scene = preset("whitworth");
    let quick = 2.0 * (50.0_f64 / 100.0).acos().to_degrees();
    let ratio = (360.0 - quick) / quick;
    close(
        &figures(&scene, &["F.x.stroke", "F.x.ratio"]),
        &[120.0, ratio],
        1e-9,
    );
}

/// A crank of 60 about A moves the knee K of a toggle of 240 + 240 across the straight line twice a
/// turn, so that the ram has four turning points. It is lowest, 480 below O, where the toggle is
/// straight. The two equal minima count together.
#[test]
fn toggle_passing_straight_line_makes_four_turns() {
    let text = presets::find("toggle-press").unwrap().text;
    let straight = text.replace("length = 236", "length = 300");
    assert_ne!(straight, text);
    let scene = opened(&straight.replace("K = [95, -220]", "K = [36, -237]"));
    let found = figures(&scene, &["S.y.turns", "S.y.least", "S.y.ratio"]);
    assert_eq!(found[0], Ok(4.0));
    assert!((found[1].unwrap() + 480.0).abs() < 1e-9, "{found:?}");
    assert!(found[2].unwrap() >= 1.0);
    let turns = excursion(&scene, "S.y", None).turnings;
    let peaks: Vec<bool> = turns.iter().map(|turn| turn.is_peak).collect();
    assert!(peaks.windows(2).all(|pair| pair[0] != pair[1]), "{turns:?}");
    // In the straight toggle O, K and S are in line: K is 240 below O, and 300 from B.
    let lowest: Vec<f64> = turns
        .iter()
        .filter(|t| !t.is_peak)
        .map(|t| t.place.at)
        .collect();
    for at in lowest {
        let (x, y) = (
            300.0 + 60.0 * at.to_radians().cos(),
            -250.0 + 60.0 * at.to_radians().sin(),
        );
        let rod = x.hypot(y + 240.0);
        assert!((rod - 300.0).abs() < 1e-9, "{at} {rod}");
    }
}

/// A rod of 100 between two perpendicular guides: y = sqrt(100^2 - x^2), with extrema at both ends
/// and in the middle.
#[test]
fn limited_range_turns_at_its_ends_and_has_no_ratio() {
    let scene = opened(
        "unit = \"mm\"\n[driver]\nslide = \"push\"\nposition = 60\nspeed = \"10 mm/s\"\n[links]\n\
         rod = { from = \"P\", to = \"Q\", length = 100 }\n[slides]\n\
         push = { point = \"P\", on = \"ground\", through = [0, 0], angle = 0 }\n\
         s = { point = \"Q\", on = \"ground\", through = [0, 0], angle = 90 }\n[start]\nQ = [0, 80]\n",
    );
    let names = [
        "Q.y.stroke",
        "Q.y.turns",
        "Q.y.greatest.at",
        "range",
        "range.low",
    ];
    close(
        &figures(&scene, &names),
        &[100.0, 3.0, 0.0, 200.0, -100.0],
        1e-9,
    );
    let none = figures(
        &scene,
        &["Q.y.ratio", "Q.y.fastest", "Q.y@101", "condition"],
    );
    assert_eq!(none[0], Err(NoFigure::ThereAndBack));
    assert!(matches!(none[1], Err(NoFigure::Unbounded(_))), "{none:?}");
    assert_eq!(none[2], Err(NoFigure::OutOfReach(101.0)));
    assert_eq!(none[3], Err(NoFigure::NoCoupledGroup));
}

/// A kite's period is two turns, and the crank's pin moves alike in both.
#[test]
fn two_turn_period_counts_extrema_of_both_turns() {
    let scene = preset("kite");
    let found = figures(&scene, &["B.x.turns", "B.x.stroke", "B.x.ratio", "range"]);
    let crank = found[1].unwrap() / 2.0;
    close(&found, &[4.0, 2.0 * crank, 1.0, 720.0], 1e-12);
}

/// Compares a group solved by iteration with 7200 samples.
#[test]
fn coupled_group_stroke_matches_dense_samples() {
    let scene = preset("stephenson-six-bar");
    let (_, solver) = &scene;
    let catalogue = Catalogue::new(&scene.0);
    let mut state = solver.state();
    let column = catalogue
        .all()
        .iter()
        .rfind(|q| q.name.ends_with(".x"))
        .unwrap();
    let mut values = Vec::new();
    for k in 0..7200 {
        let _ = solver.solve(f64::from(k) / 20.0, column.order(), &mut state);
        values.push(column.value(&state).unwrap());
    }
    let maximum = values.iter().copied().fold(f64::MIN, f64::max);
    let minimum = values.iter().copied().fold(f64::MAX, f64::min);
    let found = excursion(&scene, &column.name, None);
    let stroke = found.stroke().unwrap();
    assert!(stroke >= maximum - minimum - 1e-9 && stroke - (maximum - minimum) < 1e-4 * stroke);
    let condition = figures(&scene, &["condition"])[0].unwrap();
    assert!(0.0 < condition && condition < 1.0);
}

/// Two extrema within a degree, between two sampled coordinates: x = r cos q of a yoke, and a
/// formula of it with a narrow wiggle.
#[test]
fn extrema_close_together_are_found() {
    let text = presets::find("scotch-yoke").unwrap().text;
    // The formula is u^3 - 3 h^2 u with u = x - 20 and h = 0.1. It has extrema at u = +-h.
    let wiggle = "\n[figures]\nwiggle = \"(Y.x - 20 mm)^3 - 0.03 mm^2 * (Y.x - 20 mm)\"\n";
    let scene = opened(&format!("{text}{wiggle}"));
    let turns = excursion(&scene, "wiggle", None).turnings;
    // u^2 = 0.01 at x = 20 +- 0.1, in both directions, and both ends of the stroke. The wiggle is 4e-3 in 3.7e5.
    let mut wanted = vec![0.0, 180.0];
    for x in [20.1_f64, 19.9] {
        let at = (x / 50.0).acos().to_degrees();
        wanted.extend([at, 360.0 - at]);
    }
    wanted.sort_by(f64::total_cmp);
    let found: Vec<f64> = turns.iter().map(|turn| turn.place.at).collect();
    assert_eq!(found.len(), wanted.len(), "{found:?} {wanted:?}");
    for (found, wanted) in found.iter().zip(&wanted) {
        let distance = (found - wanted).rem_euclid(360.0);
        assert!(distance.min(360.0 - distance) < 1e-6, "{found} {wanted}");
    }
}

/// A driver with speed and acceleration: from q0 it moves to q(t) = q0 + w t + a t^2 / 2.
#[test]
fn ratio_of_accelerated_driver_is_in_time() {
    let text = presets::find("scotch-yoke").unwrap().text;
    let scene = opened(&text.replace(
        "speed = \"10 rad/s\"",
        "speed = \"10 rad/s\"\nacceleration = \"4 rad/s^2\"",
    ));
    // From 60 deg: the minimum at 180, the maximum at 360, the minimum again at 540 deg.
    let time = |degrees: f64| {
        let far = (degrees - 60.0_f64).to_radians();
        ((100.0 + 8.0 * far).sqrt() - 10.0) / 4.0
    };
    let (up, down) = (time(360.0) - time(180.0), time(540.0) - time(360.0));
    close(&figures(&scene, &["Y.x.ratio"]), &[up / down], 1e-12);
    // f'' w^2 + f' a with f = 50 cos q.
    let maximum = (50.0_f64 * 100.0).hypot(50.0 * 4.0);
    close(&figures(&scene, &["Y.x.hardest"]), &[maximum], 1e-12);
}

#[test]
fn transmission_value_suggestions_and_units_are_correct() {
    let scene = preset("four-bar");
    // The angle between coupler and rocker is farthest from 90 deg where crank and frame are in line.
    let (b, c) = (300.0_f64, 250.0_f64);
    let mu = |f: f64| {
        ((b * b + c * c - f * f) / (2.0 * b * c))
            .acos()
            .to_degrees()
    };
    let off = (mu(300.0) - 90.0).abs().max((mu(500.0) - 90.0).abs());
    let found = figures(&scene, &["transmission", "transmission.C"]);
    close(&found, &[90.0 - off, 90.0 - off], 1e-9);
    let catalogue = Catalogue::new(&scene.0);
    for (name, text) in [
        ("C.x.strok", "`C.x.stroke`"),
        ("C.z.stroke", "`C.x.stroke`"),
        ("rnage", "`range`"),
        ("C.x", "stroke, swing"),
        ("transmission.Q", "transmission"),
    ] {
        let fault = CycleFigure::parse(name, &catalogue)
            .unwrap_err()
            .to_string();
        assert!(fault.contains(text), "{fault}");
    }
    let units = [
        "C.x.stroke",
        "r4.angle.fastest",
        "C.x.hardest",
        "C.x.ratio",
        "C.x.dwell",
    ];
    let unit = |name: &&str| {
        CycleFigure::parse(name, &catalogue)
            .unwrap()
            .unit()
            .to_owned()
    };
    let units: Vec<String> = units.iter().map(unit).collect();
    assert_eq!(units, ["mm", "rad/s", "mm/s^2", "", "deg"]);
}

/// The height of a crank's pin is r |sin q|. It has four extrema, two of them at the kinks of the
/// formula, where the rate is largest, r w. The other formula is constant over a part of the turn.
#[test]
fn absolute_value_has_extrema_at_its_kinks() {
    let bench = slider_crank(40.0, 150.0, 0.0);
    let height = excursion(&bench, "height", None);
    let turns: Vec<(bool, f64)> = height
        .turnings
        .iter()
        .map(|turn| (turn.is_peak, turn.place.at))
        .collect();
    assert_eq!(turns.len(), 4, "{turns:?}");
    for (k, &(is_peak, at)) in turns.iter().enumerate() {
        assert_eq!(is_peak, k % 2 == 1, "{turns:?}");
        assert!((at - 90.0 * k as f64).abs() < 1e-6, "{turns:?}");
    }
    assert!(height.least.value.abs() < 1e-6 && (height.greatest.value - 40.0).abs() < 1e-9);
    let fastest = height.fastest.unwrap();
    assert!((fastest.value - 400.0).abs() < 1e-3, "{fastest:?}");
    let level = excursion(&bench, "level", None);
    assert!((level.stroke().unwrap() - 30.0).abs() < 1e-9, "{level:?}");
    assert_eq!(level.least.value, 10.0);
}

/// Next to a near change point, an acceleration has a peak a thousandth of a degree wide. It is
/// found, as dense samples find it.
#[test]
fn peak_next_to_near_miss_is_found() {
    let bench = opened(
        "unit = \"mm\"\n[ground]\nA = [0, 0]\nD = [300, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n\
         speed = \"1 rad/s\"\n[links]\nr2 = { from = \"A\", to = \"B\", length = 100 }\n\
         r3 = { from = \"B\", to = \"C\", length = 250 }\n\
         r4 = { from = \"C\", to = \"D\", length = 150.00001 }\n[start]\nC = [290, 150]\n",
    );
    let hardest = excursion(&bench, "r4.angle", None).hardest.unwrap();
    let (_, solver) = &bench;
    let mut state = solver.state();
    let link = solver.mechanism().link_ids().nth(2).unwrap();
    let mut largest = 0.0_f64;
    for k in -200_000..200_000 {
        let at = 180.0 + f64::from(k) * 1e-5;
        let _ = solver.solve(at, Order::Acceleration, &mut state);
        largest = largest.max(state.alpha(link).map_or(0.0, f64::abs));
    }
    assert!(largest > 500.0, "{largest}");
    assert!(
        hardest.value >= largest * (1.0 - 1e-9),
        "{hardest:?} {largest}"
    );
    assert!(hardest.value < largest * 1.01, "{hardest:?} {largest}");
}

/// A change between a few places is one of the whole motion, too.
#[test]
fn changing_values_equal_those_of_whole_motion() {
    let mut seen = [0, 0];
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let catalogue = Catalogue::new(&scene);
        let all = [catalogue.figures(), catalogue.unlisted()].concat();
        let mut sampler = MotionSampler::new(&solver, SlopeSource::Nothing, all.iter(), 0);
        let complete = sampler.sample_motion();
        for ((column, values), changes) in complete.iter().enumerate().zip(changing(&solver, &all))
        {
            let expected = sampler.changes(column, values, LEVEL) != Some(false);
            assert_eq!(changes, expected, "{} {}", preset.name, all[column].name);
            seen[usize::from(changes)] += 1;
        }
    }
    assert!(seen[0] > 50 && seen[1] > 500, "{seen:?}");
}
