//! Tests tolerances against published values and closed formulas, which are written out here.

use super::machines::of_derivatives;
use super::*;
use crate::Length;
use crate::quantity::Catalogue;
use crate::solver::Order;

/// A four-bar of Denavit's proportions: ground 3.5, crank 1, coupler 3, rocker 2.
const FOUR_BAR: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
D = [3.5, 0]
[driver]
link = "crank"
angle = 60
speed = "1 rad/s"
[links]
crank = { from = "A", to = "B", length = 1 }
coupler = { from = "B", to = "C", length = 3 }
rocker = { from = "D", to = "C", length = 2 }
[start]
C = [3, 2]
"#;

/// In line at 0 deg: C is at crank + rod.
const SLIDER_CRANK: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link = "crank"
angle = 40
speed = "1 rad/s"
[links]
crank = { from = "A", to = "B", length = 50 }
rod = { from = "B", to = "C", length = 150 }
[slides]
ram = { point = "C", on = "ground", through = "A", angle = 0 }
[start]
C = [190, 0]
"#;

fn opened(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "tolerance.toml").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn figures(scene: &Scene, names: &[&str]) -> Vec<Quantity> {
    let catalogue = Catalogue::new(scene);
    let named = names
        .iter()
        .map(|name| catalogue.find(name).unwrap().clone());
    named.collect()
}

fn links(scene: &Scene, by: f64) -> Tolerances {
    let lengths = scene
        .mechanism
        .link_ids()
        .map(|link| (Length::Link(link), by));
    Tolerances {
        lengths: lengths.collect(),
        clearances: Vec::new(),
    }
}

/// The mean shift of the pin between coupler and rocker per unit of length, with each length 1 %
/// longer, over the crank angles 0.1, 0.2 ... 6.3 rad. The published values are 0.742633, 1.105773
/// and 1.105910 for crank, coupler and rocker.
#[test]
fn four_bar_pin_shift_matches_published_values() {
    let (scene, solver) = opened(FOUR_BAR);
    let pin = scene
        .mechanism
        .point_ids()
        .find(|&p| scene.point_name(p) == Some("C"))
        .unwrap();
    let demand = crate::solver::Demand {
        points: vec![pin],
        ..Default::default()
    };
    let lengths: Vec<_> = scene.mechanism.link_ids().map(Length::Link).collect();
    let mut varied = solver.varied(&lengths, &demand).unwrap();
    let known = [0.742_633, 1.105_773, 1.105_910];
    for ((i, length), known) in [1.0, 3.0, 2.0].into_iter().enumerate().zip(known) {
        let mut sum = 0.0;
        for k in 1..=63 {
            let at = (0.1 * f64::from(k)).to_degrees();
            let mut place = |by: f64| {
                let mut all = vec![0.0; 3];
                all[i] = by;
                varied.change(&all);
                let _ = varied.solve(at, Order::Position);
                varied.state().position(pin).unwrap()
            };
            let by = 0.01 * length;
            sum += (place(by) - place(0.0)).norm() / by;
        }
        let mean = sum / 63.0;
        assert!((mean - known).abs() < 5e-7, "{i}: {mean} {known}");
    }
}

/// At an in-line dead centre, 0.1 on crank and rod is 0.2 at worst, and 0.1414 by the root of the
/// sum of squares.
#[test]
fn tolerances_add_up_at_dead_centre() {
    let (scene, solver) = opened(SLIDER_CRANK);
    let request = figures(&scene, &["ram.length"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.1), &request).unwrap();
    let found = study.at(0.0).remove(0).unwrap();
    assert_eq!(found.nominal, 200.0);
    assert_eq!(found.worst.kind, WorstKind::Corners);
    assert!((found.worst.high - 200.2).abs() < 1e-12, "{found:?}");
    assert!((found.worst.low - 199.8).abs() < 1e-12, "{found:?}");
    let square = found.root_sum_square.unwrap();
    assert!((square - 0.1 * 2.0_f64.sqrt()).abs() < 1e-12, "{square}");
    let shares: Vec<f64> = found.contributions.iter().map(|c| c.share).collect();
    assert!(
        shares.iter().all(|share| (share - 0.5).abs() < 1e-12),
        "{shares:?}"
    );
}

/// Elsewhere the worst case follows from the closed formula at the four corners:
/// x = r cos t + sqrt(l^2 - r^2 sin^2 t).
#[test]
fn worst_case_matches_closed_formula_at_corners() {
    let (scene, solver) = opened(SLIDER_CRANK);
    let request = figures(&scene, &["ram.length"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.5), &request).unwrap();
    for at in [10.0_f64, 70.0, 100.0, 179.0, 251.0] {
        let (sin, cos) = at.to_radians().sin_cos();
        let x = |r: f64, l: f64| r * cos + (l * l - r * r * sin * sin).sqrt();
        let corners = [-0.5, 0.5].map(|r| [-0.5, 0.5].map(|l| x(50.0 + r, 150.0 + l)));
        let all = corners.as_flattened();
        let [low, high] = [f64::min, f64::max].map(|f| all.iter().copied().reduce(f).unwrap());
        let found = study.at(at).remove(0).unwrap().worst;
        assert!(
            (found.low - low).abs() < 1e-12 && (found.high - high).abs() < 1e-12,
            "{at}"
        );
        assert!(!found.fails);
    }
}

/// Random crank and rod at the in-line dead centre: the sum of two uniform numbers has the variance
/// 2 t^2 / 3, that of two normal ones 2 t^2 / 9. Equal seeds give equal machines, different seeds
/// different ones.
#[test]
fn samples_have_expected_spread() {
    let (scene, solver) = opened(SLIDER_CRANK);
    let request = figures(&scene, &["ram.length"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.1), &request).unwrap();
    for (distribution, part) in [
        (Distribution::Even, 2.0 / 3.0),
        (Distribution::Normal, 2.0 / 9.0),
    ] {
        let order = |seed| SampleOrder {
            count: 50_000,
            seed,
            distribution,
        };
        let found = study.sampled(0.0, order(1));
        assert_eq!(found, study.sampled(0.0, order(1)));
        assert_ne!(found, study.sampled(0.0, order(2)));
        assert_eq!(found.open, 0.0);
        let known = 0.1 * f64::sqrt(part);
        let figure = found.figures[0].unwrap();
        assert!((figure.deviation / known - 1.0).abs() < 0.02, "{figure:?}");
        assert!((figure.median - 200.0).abs() < 0.002, "{figure:?}");
        assert!((figure.high - 200.0) < 0.2001 || distribution == Distribution::Normal);
    }
}

/// A pin of clearance c in the rod's end: at the in-line dead centre, the ram reaches c further.
/// The clearance counts as much as a length.
#[test]
fn pin_clearance_counts_like_a_length_at_dead_centre() {
    let (scene, solver) = opened(SLIDER_CRANK);
    let request = figures(&scene, &["ram.length"]);
    let rod = scene.mechanism.link_ids().nth(1).unwrap();
    let pin = scene
        .mechanism
        .point_ids()
        .find(|&p| scene.point_name(p) == Some("C"))
        .unwrap();
    let tolerances = Tolerances {
        lengths: Vec::new(),
        clearances: vec![(rod, pin, 0.03)],
    };
    let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &request).unwrap();
    let found = study.at(0.0).remove(0).unwrap();
    assert!(
        (found.root_sum_square.unwrap() - 0.03).abs() < 1e-12,
        "{found:?}"
    );
    assert!(found.worst.high >= 200.03 - 1e-12, "{found:?}");
    assert_eq!(found.contributions[0].of, ToleranceOf::Pin(rod, pin));
}

/// If the rod is too short at some corners, the result says so, and samples count such machines.
#[test]
fn machines_that_cannot_close_are_reported() {
    let (scene, solver) = opened(&SLIDER_CRANK.replace("150", "50.05"));
    let request = figures(&scene, &["ram.length"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.1), &request).unwrap();
    let found = study.at(90.0).remove(0).unwrap();
    assert!(found.worst.fails, "{found:?}");
    let order = SampleOrder {
        count: 10_000,
        seed: 1,
        distribution: Distribution::Even,
    };
    // rod - crank < 0 in r x r: with u, v even in [-0.1, 0.1], P(v - u > 0.05) = (0.15)^2 / 2 / 0.04.
    let open = study.sampled(90.0, order).open;
    assert!((open - 0.28125).abs() < 0.02, "{open}");
}

/// An enclosure contains the worst case in the direction of the derivatives.
#[test]
fn enclosures_contain_worst_case_of_derivatives() {
    let preset = crate::scene::presets::find("press").unwrap();
    let (scene, solver) = opened(preset.text);
    let request: Vec<_> = Catalogue::new(&scene)
        .figures()
        .into_iter()
        .filter(|f| f.order() == Order::Position)
        .collect();
    let lengths: Vec<_> = scene
        .mechanism
        .lengths()
        .into_iter()
        .map(|l| (l, 0.05))
        .collect();
    let tolerances = Tolerances {
        lengths,
        clearances: Vec::new(),
    };
    let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &request).unwrap();
    let mut held = 0;
    for at in [13.0, 77.0, 200.0, 301.0] {
        let nominal = study.machines.go(at);
        let enclosed = study.enclosed(at, &nominal);
        let slopes = study.slopes_at(at).unwrap();
        let acting: Vec<usize> = (0..study.off.lengths).collect();
        for i in 0..request.len() {
            let Some(ball) = enclosed[i] else { continue };
            let slopes = slopes.of(i).unwrap();
            let machines = &mut study.machines;
            let worst = of_derivatives(machines, &study.off, &acting, i, &nominal, slopes).unwrap();
            assert!(
                ball.low <= worst.low && worst.high <= ball.high,
                "{} at {at}",
                request[i].name
            );
            held += 1;
        }
    }
    assert!(held > 40, "{held}");
}

/// The computed offsets of a band match the closed formula. Those between are interpolated
/// linearly.
#[test]
fn band_offsets_match_closed_formula() {
    let (scene, solver) = opened(SLIDER_CRANK);
    let request = figures(&scene, &["ram.length"]);
    let by = 0.5;
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, by), &request).unwrap();
    let coordinates: Vec<f64> = (0..=720).map(|k| f64::from(k) / 2.0).collect();
    let band = study.band(&coordinates, BandKind::RootSumSquare).remove(0);
    assert_eq!(band.len(), coordinates.len());
    for (k, (at, offsets)) in coordinates.iter().zip(band).enumerate() {
        let (sin, cos) = at.to_radians().sin_cos();
        let root = (150.0_f64.powi(2) - (50.0 * sin).powi(2)).sqrt();
        let slopes = [cos - 50.0 * sin * sin / root, 150.0 / root];
        let expected = by * slopes[0].hypot(slopes[1]);
        let allowed = if k % 10 == 0 { 1e-12 } else { 1e-3 };
        let [below, above] = offsets.unwrap();
        assert!(
            (above - expected).abs() < allowed,
            "{at}: {above} {expected}"
        );
        assert_eq!(below, -above);
    }
}

/// Pins of crank, rod and slide at the in-line dead centre: each moves the ram by at most its
/// clearance.
#[test]
fn pin_clearances_add_up_at_dead_centre() {
    let (scene, solver) = opened(&SLIDER_CRANK.replace("unit", "clearance = 0.05\nunit"));
    assert_eq!(scene.tolerances().clearances.len(), 3);
    let request = figures(&scene, &["ram.length"]);
    let mut study = ToleranceStudy::new(&scene, &solver, scene.tolerances(), &request).unwrap();
    let found = study.at(0.0).remove(0).unwrap();
    let [low, high] = found.worst.reached;
    assert!((low - 199.85).abs() < 1e-9 && (high - 200.15).abs() < 1e-9);
    assert!(found.worst.low <= low && found.worst.high >= high);
    let square = found.root_sum_square.unwrap();
    assert!((square - 0.05 * 3.0_f64.sqrt()).abs() < 1e-12, "{square}");
    let slopes: Vec<f64> = found.contributions.iter().map(|c| c.slope).collect();
    assert!(
        slopes.iter().all(|slope| (slope - 1.0).abs() < 1e-12),
        "{slopes:?}"
    );
}

/// A crank-rocker 0.1 from a change point, with three lengths uniformly off by at most 0.1. The sum
/// of three uniform numbers within 1 must not be below -1, which one in six is (Irwin and Hall).
#[test]
fn one_machine_in_six_changes_its_class() {
    let text = FOUR_BAR
        .replace("[3.5, 0]", "[449.9, 0]")
        .replace("length = 1 ", "length = 100 ")
        .replace("length = 3 ", "length = 300 ")
        .replace("length = 2 ", "length = 250 ")
        .replace("[3, 2]", "[300, 200]");
    let (scene, solver) = opened(&text);
    let request = figures(&scene, &["C.x"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.1), &request).unwrap();
    let order = SampleOrder {
        count: 100_000,
        seed: 5,
        distribution: Distribution::Even,
    };
    let changed = study.sampled(60.0, order).changed.unwrap();
    // Four standard deviations.
    assert!((changed - 1.0 / 6.0).abs() < 4.7e-3, "{changed}");
}

/// The stroke of an offset slider-crank is sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2). Checks
/// its worst case at the corners of r, l and e, its first order by the derivatives, and the spread
/// of samples.
#[test]
fn stroke_tolerances_match_closed_formula() {
    let text = SLIDER_CRANK.replace("through = \"A\"", "through = [0, 20]");
    let (scene, solver) = opened(&text);
    let stroke = |r: f64, l: f64, e: f64| {
        ((l + r).powi(2) - e * e).sqrt() - ((l - r).powi(2) - e * e).sqrt()
    };
    let catalogue = Catalogue::new(&scene);
    let figure = crate::study::CycleFigure::parse("ram.length.stroke", &catalogue).unwrap();
    let slide = scene.mechanism.slide_ids().next().unwrap();
    let through = Length::Through(slide, crate::CoordinateAxis::Y);
    let mut tolerances = links(&scene, 0.5);
    tolerances.lengths.push((through, 0.5));
    let mut study = MotionTolerance::new(&solver, &tolerances, vec![figure]).unwrap();
    let found = study.found().remove(0).unwrap();
    let off = [-0.5, 0.5];
    let corners = off.map(|r| off.map(|l| off.map(|e| stroke(50.0 + r, 150.0 + l, 20.0 + e))));
    let all = corners.as_flattened().as_flattened();
    let [low, high] = [f64::min, f64::max].map(|f| all.iter().copied().reduce(f).unwrap());
    assert!(
        (found.nominal - stroke(50.0, 150.0, 20.0)).abs() < 1e-9,
        "{found:?}"
    );
    assert_eq!(found.worst.kind, WorstKind::Corners);
    assert!((found.worst.low - low).abs() < 1e-9, "{found:?} {low}");
    assert!((found.worst.high - high).abs() < 1e-9, "{found:?} {high}");
    let (r, l, e) = (50.0_f64, 150.0_f64, 20.0_f64);
    let (long, short) = (
        ((l + r).powi(2) - e * e).sqrt(),
        ((l - r).powi(2) - e * e).sqrt(),
    );
    let slopes = [
        (l + r) / long + (l - r) / short,
        (l + r) / long - (l - r) / short,
        e / short - e / long,
    ];
    let square = slopes.iter().map(|d| (0.5 * d).powi(2)).sum::<f64>().sqrt();
    let first = found.root_sum_square.unwrap();
    assert!((first - square).abs() < 1e-6 * square, "{first} {square}");
    let order = SampleOrder {
        count: 3_000,
        seed: 1,
        distribution: Distribution::Normal,
    };
    let samples = study.sampled(order);
    let spread = samples.figures[0].unwrap();
    assert!(
        (spread.deviation / (square / 3.0) - 1.0).abs() < 0.06,
        "{spread:?}"
    );
    assert_eq!(samples.open, 0.0);
}

/// If the crank does not turn fully at some corners, each machine is opened with its own lengths.
#[test]
fn range_tolerance_sees_machines_that_turn_less() {
    // Grashof's condition is met by 0.02 alone: s + l = 4.5, p + q = 4.52.
    let text = FOUR_BAR.replace("length = 3 }", "length = 2.52 }");
    let (scene, solver) = opened(&text);
    let catalogue = Catalogue::new(&scene);
    let range = crate::study::CycleFigure::parse("range", &catalogue).unwrap();
    let tolerances = links(&scene, 0.05);
    let mut study = MotionTolerance::new(&solver, &tolerances, vec![range]).unwrap();
    let found = study.found().remove(0).unwrap();
    assert_eq!((found.nominal, found.worst.high), (360.0, 360.0));
    assert!(found.worst.low < 359.0, "{found:?}");
}

/// At the in-line dead centre, an offset of the guide is worst in the middle of its tolerance: with
/// both lengths long and the guide through the pivot. That is no corner, and is not reported as
/// one.
#[test]
fn worst_case_inside_box_is_marked_as_searched() {
    let text = SLIDER_CRANK.replace("through = \"A\"", "through = [0, 0]");
    let (scene, solver) = opened(&text);
    let slide = scene.mechanism.slide_ids().next().unwrap();
    let mut tolerances = links(&scene, 0.1);
    tolerances
        .lengths
        .push((Length::Through(slide, crate::CoordinateAxis::Y), 2.0));
    let request = figures(&scene, &["C.x"]);
    let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &request).unwrap();
    let found = study.at(0.0).remove(0).unwrap();
    assert!((found.worst.high - 200.2).abs() < 1e-12, "{found:?}");
    assert_eq!(found.worst.kind, WorstKind::Searched);
    // The lengths alone are worst at corners.
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 0.1), &request).unwrap();
    assert_eq!(
        study.at(0.0).remove(0).unwrap().worst.kind,
        WorstKind::Corners
    );
}

/// At 90 deg, C is at sqrt(l^2 - r^2). If the rod can be shorter than the crank, the minimum is 0,
/// which no corner has.
#[test]
fn worst_case_is_at_edge_when_corner_cannot_close() {
    let (scene, solver) = opened(&SLIDER_CRANK.replace("150", "50.5"));
    let request = figures(&scene, &["C.x"]);
    let (low, high) = (0.0, (51.5_f64.powi(2) - 49.0_f64.powi(2)).sqrt());
    let mut study = ToleranceStudy::new(&scene, &solver, &links(&scene, 1.0), &request).unwrap();
    let worst = study.at(90.0).remove(0).unwrap().worst;
    assert_eq!((worst.kind, worst.fails), (WorstKind::AtEdge, true));
    assert!((worst.low - low).abs() < 1e-4, "{worst:?}");
    assert!((worst.high - high).abs() < 1e-9, "{worst:?}");
    // With a loose pin, too, the worst case follows the derivatives as far as the machine closes.
    let mut tolerances = links(&scene, 1.0);
    let rod = scene.mechanism.link_ids().nth(1).unwrap();
    let pin = scene.mechanism.link(rod).members[1].point;
    tolerances.clearances.push((rod, pin, 1e-3));
    let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &request).unwrap();
    let worst = study.at(90.0).remove(0).unwrap().worst;
    assert_eq!((worst.kind, worst.fails), (WorstKind::Derivatives, true));
    assert!((worst.low - low).abs() < 1e-2, "{worst:?}");
    assert!(worst.high >= high, "{worst:?}");
}

/// The distance of a pin from its position in another machine within the tolerances. It is 0 with
/// that machine's lengths, which are no point of the grid. Checks few lengths and many.
#[test]
fn minimum_inside_box_is_found_by_search() {
    let jansen = crate::scene::presets::find("jansen-leg").unwrap().text;
    for (text, pin, by) in [(FOUR_BAR, "C", 0.05), (jansen, "T", 0.2)] {
        let (scene, solver) = opened(text);
        let lengths = scene.mechanism.lengths();
        let part = |i: usize| 0.6 * (i as f64 + 1.0).sin();
        let changed = lengths
            .iter()
            .enumerate()
            .fold(scene.mechanism.clone(), |made, (i, &length)| {
                made.changed(length, by * part(i))
            });
        let mut state = solver.state();
        let id = scene
            .mechanism
            .point_ids()
            .find(|&p| scene.point_name(p) == Some(pin));
        let other = Solver::new(&changed).unwrap();
        let _ = other.solve(60.0, Order::Position, &mut state);
        let position = state.position(id.unwrap()).unwrap();
        let unit = scene.unit.symbol();
        let text = format!(
            "{text}\n[figures]\ngap = \"hypot({pin}.x - {} {unit}, {pin}.y - {} {unit})\"\n",
            position.x, position.y
        );
        let (scene, solver) = opened(&text);
        let tolerances = Tolerances {
            lengths: lengths.into_iter().map(|length| (length, by)).collect(),
            clearances: Vec::new(),
        };
        let request = figures(&scene, &["gap"]);
        let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &request).unwrap();
        let found = study.at(60.0).remove(0).unwrap();
        assert!(found.nominal > 0.1 * by, "{found:?}");
        assert!(found.worst.low < 1e-3 * by, "{found:?}");
        assert_eq!(found.worst.kind, WorstKind::Searched);
    }
}

/// A band must not slow down editing: with all lengths of many bars it is only of first order.
#[test]
fn quick_band_kind_depends_on_number_of_machines() {
    let kind = |text: &str, point: &str, by: &dyn Fn(&Scene) -> Tolerances, places: usize| {
        let (scene, solver) = opened(text);
        let request = figures(&scene, &[&format!("{point}.x")]);
        let study = ToleranceStudy::new(&scene, &solver, &by(&scene), &request).unwrap();
        study.quick_kind(places)
    };
    let jansen = crate::scene::presets::find("jansen-leg").unwrap().text;
    let of_links = |scene: &Scene| links(scene, 0.1);
    let of_all = |scene: &Scene| Tolerances {
        lengths: scene
            .mechanism
            .lengths()
            .into_iter()
            .map(|l| (l, 0.1))
            .collect(),
        clearances: Vec::new(),
    };
    assert_eq!(kind(FOUR_BAR, "C", &of_links, 721), BandKind::Worst);
    assert_eq!(kind(FOUR_BAR, "C", &of_all, 721), BandKind::Worst);
    assert_eq!(kind(jansen, "T", &of_links, 721), BandKind::Worst);
    assert_eq!(kind(jansen, "T", &of_all, 721), BandKind::RootSumSquare);
    // For one coordinate, all corners are affordable.
    assert_eq!(kind(jansen, "T", &of_all, 1), BandKind::Worst);
}

/// Returns the four-bar rotated in the plane by this angle in degrees, including its driver.
fn turned(by: f64) -> String {
    let turn = |x: f64, y: f64| {
        let (sin, cos) = by.to_radians().sin_cos();
        format!("[{}, {}]", x * cos - y * sin, x * sin + y * cos)
    };
    FOUR_BAR
        .replace("[3.5, 0]", &turn(3.5, 0.0))
        .replace("[3, 2]", &turn(3.0, 2.0))
        .replace("angle = 60", &format!("angle = {}", 60.0 + by))
}

/// A machine rotated in the plane has the same tolerances. They used to jump by 360 deg where a
/// direction or a coordinate of the nominal machine is close to a full turn. The nominal values are
/// 0.001 deg to either side of it.
#[test]
fn direction_tolerances_do_not_jump_at_full_turn() {
    let study = |by: f64, name: &str| {
        let (scene, solver) = opened(&turned(by));
        let figure = crate::study::CycleFigure::parse(name, &Catalogue::new(&scene)).unwrap();
        let mut study = MotionTolerance::new(&solver, &links(&scene, 0.02), vec![figure]).unwrap();
        let order = SampleOrder {
            count: 50,
            seed: 3,
            distribution: Distribution::Even,
        };
        let found = study.found().remove(0).unwrap();
        (found, study.sampled(order).figures[0].unwrap())
    };
    for name in [
        "rocker.angle.greatest",
        "rocker.angle.least.at",
        "coupler.angle@0",
    ] {
        let (still, spread) = study(0.0, name);
        for nearby in [-1e-3, 1e-3] {
            let by = nearby - still.nominal;
            let name = name.replace("@0", &format!("@{by}"));
            let (found, samples) = study(by, &name);
            let off = crate::angle::unwrap_near(0.0, found.nominal - nearby);
            assert!(off.abs() < 1e-6, "{name}: {found:?}");
            for (one, other) in [
                (
                    found.worst.low - found.nominal,
                    still.worst.low - still.nominal,
                ),
                (
                    found.worst.high - found.nominal,
                    still.worst.high - still.nominal,
                ),
                (samples.deviation, spread.deviation),
                (
                    found.root_sum_square.unwrap(),
                    still.root_sum_square.unwrap(),
                ),
            ] {
                assert!((one - other).abs() < 1e-4, "{name}: {one} {other}");
                assert!(one.abs() > 0.01, "{name}: {one}");
            }
        }
    }
}
