use super::extrema::MIN_TURN;
use super::span::ends;
use super::*;
use crate::angle::TURN;
use crate::numeric::turns as turning;
use crate::scene::presets;
use crate::solver::Order;

fn opened(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn preset(name: &str) -> (Scene, Solver) {
    opened(presets::find(name).unwrap().text)
}

fn sampled((scene, solver): &(Scene, Solver), columns: &[&str], abscissa: Abscissa) -> Curves {
    let quantities = Catalogue::new(scene).select(columns).unwrap();
    Curves::new(scene, solver, &quantities, abscissa, None).unwrap()
}

fn turns(curve: &Curve) -> Vec<(f64, f64)> {
    let mut all: Vec<_> = curve.extrema.iter().map(|e| (e.at, e.value)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// Checks values and their coordinates to rounding errors.
fn close(found: &[(f64, f64)], wanted: &[(f64, f64)]) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (f, w) in found.iter().zip(wanted) {
        let distance = (f.0 - w.0).rem_euclid(TURN);
        assert!(distance.min(TURN - distance) < 1e-11, "{f:?} {w:?}");
        assert!((f.1 - w.1).abs() <= 1e-13 * w.1.abs(), "{f:?} {w:?}");
    }
}

/// At the dead centres crank r and rod l are in line: x^2 + e^2 = (l +- r)^2. The crank points
/// along the rod or against it.
#[test]
fn slider_crank_extrema_lie_at_dead_centres() {
    let curves = sampled(&preset("slider-crank"), &["C.x"], Abscissa::Driver);
    close(&turns(&curves.curves[0]), &[(0.0, 30.0), (180.0, 10.0)]);
    let text = presets::find("slider-crank").unwrap().text;
    let offset = text.replace("through = \"A\", angle = 0", "through = [0, -4], angle = 0");
    assert_ne!(offset, text);
    let offset = offset.replace("C = [28, 0]", "C = [28, -4]");
    let curves = sampled(&opened(&offset), &["C.x"], Abscissa::Driver);
    let (far, near) = ((900.0_f64 - 16.0).sqrt(), (100.0_f64 - 16.0).sqrt());
    let angle = |x: f64| (-4.0_f64).atan2(x).to_degrees();
    let wanted = [(angle(near) + 180.0, near), (angle(far) + 360.0, far)];
    close(&turns(&curves.curves[0]), &wanted);
}

/// A cutting stroke has breaks at its ends, which lie between samples, and no slope there.
#[test]
fn load_jump_breaks_the_curve() {
    let text = presets::find("four-bar").unwrap().text.to_owned()
        + "[[loads]]\nlink = \"r2\"\ntorque = -5\n\
           over = [[0, 0], [80.2, 0], [80.2, 1], [120.3, 1], [120.3, 0], [360, 0]]\n";
    let curves = sampled(&opened(&text), &["driver.torque"], Abscissa::Driver);
    let pieces = curves.pieces(0);
    let spans: Vec<_> = pieces.iter().map(|p| (p[0], p[p.len() - 1])).collect();
    assert_eq!(spans.len(), 3, "{spans:?}");
    for (piece, torque) in pieces.iter().zip([0.0, 5.0, 0.0]) {
        assert!(piece.iter().all(|[_, y]| (y - torque).abs() < 1e-12));
    }
    assert_eq!((spans[1].0[0], spans[1].1[0]), (80.5, 120.0));
}

/// A jump that is small compared with the rest of the curve is also a break, in later turns, too.
#[test]
fn small_load_jump_breaks_the_curve_in_any_turn() {
    let text = presets::find("four-bar").unwrap().text.to_owned()
        + "[[loads]]\nlink = \"r2\"\ntorque = -100\n\
           over = [[0, 0], [80.2, 0.5], [80.2, 0.55], [180, 1], [360, 0]]\n";
    let opened = opened(&text);
    let quantities = Catalogue::new(&opened.0)
        .select(&["driver.torque"])
        .unwrap();
    for first in [0.0, 720.0] {
        let window = Some((first, first + 360.0));
        let curves =
            Curves::new(&opened.0, &opened.1, &quantities, Abscissa::Driver, window).unwrap();
        let pieces = curves.pieces(0);
        assert_eq!(pieces.len(), 2, "{first}");
        assert_eq!((pieces[0].len(), pieces[1][0][0]), (161, first + 80.5));
    }
}

/// The rocker of a crank-rocker turns back where crank and coupler are in line. The expected values
/// are from the law of cosines.
#[test]
fn rocker_extrema_match_law_of_cosines() {
    let curves = sampled(&preset("four-bar"), &["r4.angle"], Abscissa::Driver);
    let rocker = |reach: f64| {
        let cosine =
            (400.0_f64.powi(2) + 250.0_f64.powi(2) - reach * reach) / (2.0 * 400.0 * 250.0);
        360.0 - cosine.acos().to_degrees()
    };
    let values: Vec<f64> = curves.curves[0].extrema.iter().map(|e| e.value).collect();
    assert_eq!(values.len(), 2);
    for wanted in [rocker(400.0), rocker(200.0)] {
        assert!(
            values.iter().any(|v| (v - wanted).abs() < 1e-11),
            "{values:?} {wanted}"
        );
    }
}

/// Checks all quantities of scenes with dwells, stops, loads and a period of two turns. Samples
/// eight times as dense show no further extremum, and no value beyond one. Where an extremum has a
/// slope, it is 0; over time, too, where the driver's speed depends on its coordinate.
#[test]
fn denser_samples_find_no_further_extrema() {
    const DENSER: usize = 8;
    for (name, abscissa) in [
        ("four-bar-load", Abscissa::Driver),
        ("toggle-press", Abscissa::Driver),
        ("kite", Abscissa::Driver),
        ("excavator-boom", Abscissa::Driver),
        ("jansen-leg", Abscissa::Driver),
        ("whitworth", Abscissa::Time),
        ("four-bar", Abscissa::Time),
    ] {
        let text = presets::find(name).unwrap().text;
        let text = text.replace(
            "15 rad/s\"\n",
            "15 rad/s\"\nacceleration = \"40 rad/s^2\"\n",
        );
        let (scene, solver) = opened(&text);
        let quantities = Catalogue::new(&scene).figures();
        let curves = Curves::new(&scene, &solver, &quantities, abscissa.clone(), None).unwrap();
        let clock = curves.clock.clone();
        let mut probe = Probe::new(&solver, &quantities, solver.motion().range, clock);
        let (first, last) = (curves.places(0), curves.places(usize::MAX));
        let count = DENSER * (curves.at.len() - 1);
        let step = (last - first) / count as f64;
        let coordinates: Vec<f64> = (0..=count).map(|k| first + step * k as f64).collect();
        let (dense, _) = probe.sample(&coordinates);
        let mut seen = 0;
        for (i, curve) in curves.curves.iter().enumerate() {
            let dense: Vec<f64> = dense[i].iter().copied().flatten().collect();
            let is_whole = dense.len() == coordinates.len() && !curve.breaks.contains(&true);
            if curve.is_level() || !is_whole {
                continue;
            }
            let size = curve.range().map_or(0.0, |(low, high)| high - low);
            let denser = turning(&dense, MIN_TURN * size, curves.period.is_some());
            let denser: Vec<_> = denser.into_iter().filter(|turn| !turn.is_end).collect();
            let of = |e: &&Extremum| first < e.along && e.along < last;
            let found: Vec<&Extremum> = curve.extrema.iter().filter(of).collect();
            let about = format!("{name} {} {found:?} {denser:?}", curve.quantity.name);
            for turn in &denser {
                let (at, value) = (coordinates[turn.sample], dense[turn.sample]);
                let near = |e: &&Extremum| {
                    let distance = (e.along - at).abs();
                    distance.min((last - first).abs() - distance) <= 2.0 * step.abs()
                };
                let Some(extremum) = curve.extrema.iter().find(near) else {
                    panic!("nothing at {at}: {about}");
                };
                let beyond = if turn.is_peak {
                    value - extremum.value
                } else {
                    extremum.value - value
                };
                assert!(
                    beyond <= 1e-12 * size,
                    "{beyond:e} beyond {extremum:?}: {about}"
                );
                let slopes = [-1.0, 0.0, 1.0].map(|k| probe.slope(i, at + k * step).unwrap_or(0.0));
                let slope = probe.slope(i, extremum.along).unwrap_or(0.0);
                let maximum = slopes
                    .iter()
                    .fold(0.0_f64, |maximum, slope| maximum.max(slope.abs()));
                assert!(
                    slope.abs() <= 1e-6 * maximum,
                    "{slope:e} of {maximum:e}: {about}"
                );
                seen += 1;
            }
            assert!(found.len() <= denser.len(), "{about}");
        }
        assert!(seen >= 10, "{name}: {seen}");
    }
}

#[test]
fn samples_equal_solved_states_bitwise() {
    for name in ["four-bar", "stephenson-six-bar", "double-rocker", "kite"] {
        let (scene, solver) = preset(name);
        let quantities = Catalogue::new(&scene).figures();
        let curves = Curves::new(&scene, &solver, &quantities, Abscissa::Driver, None).unwrap();
        let mut state = solver.state();
        for (k, &at) in curves.at.iter().enumerate().step_by(7) {
            let condition = solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, curves.conditions[k], "{name} {at}");
            let here = curves.here(&state);
            for (curve, value) in curves.curves.iter().zip(here.values) {
                let bits = |v: Option<f64>| v.map(f64::to_bits);
                assert_eq!(
                    bits(curve.values[k]),
                    bits(value),
                    "{name} {} {at}",
                    curve.quantity.name
                );
            }
            let along = here.along.unwrap();
            assert!((along - at).rem_euclid(curves.period.unwrap_or(f64::MAX)) < 1e-9);
        }
    }
}

#[test]
fn span_covers_two_turn_period_and_limited_range() {
    let curves = sampled(&preset("kite"), &["C.x"], Abscissa::Driver);
    assert_eq!(curves.span(), Some((0.0, 720.0)));
    let (scene, solver) = preset("double-rocker");
    let curves = sampled(&(scene, solver.clone()), &["C.x", "C.vx"], Abscissa::Driver);
    let Range::Limited { low, high } = solver.motion().range else {
        panic!("it is limited");
    };
    assert_eq!(curves.span(), Some((low, high)));
    // At the limits, positions exist but rates do not; rates grow without bound towards them.
    let [place, rate] = &curves.curves[..] else {
        panic!()
    };
    assert!(place.values[0].is_some() && rate.values[0].is_none());
    let (low, high) = ends(&rate.values).unwrap();
    let shown = rate.range().unwrap();
    assert!(
        shown.1 - shown.0 < 0.6 * (high - low),
        "{shown:?} of {low} to {high}"
    );
    assert_eq!(curves.pieces(1).len(), 1);
}

#[test]
fn only_directions_break_at_360_degrees() {
    let (scene, solver) = preset("drag-link");
    let quantities = Catalogue::new(&scene).figures();
    let curves = Curves::new(&scene, &solver, &quantities, Abscissa::Driver, None).unwrap();
    for (i, curve) in curves.curves.iter().enumerate() {
        for piece in curves.pieces(i) {
            let steps = piece.windows(2).map(|p| (p[1][1] - p[0][1]).abs());
            let maximum = steps.fold(0.0, f64::max);
            if curve.quantity.is_direction() {
                assert!(maximum < 180.0, "{} {maximum}", curve.quantity.name);
            }
        }
        if !curve.quantity.is_direction() {
            assert_eq!(curves.pieces(i).len(), 1, "{}", curve.quantity.name);
        }
    }
}

#[test]
fn jumps_detects_jump_but_not_steep_slope() {
    let (scene, solver) = preset("four-bar");
    let quantities = Catalogue::new(&scene).select(&["C.x"]).unwrap();
    let mut probe = Probe::new(&solver, &quantities, solver.motion().range, None);
    // C.x itself, from one end of its stroke to the other: steep, but no jump.
    let values = [0.0, 180.0].map(|at| probe.value(0, at).unwrap());
    assert!(!probe.jumps(0, [0.0, 180.0], values));
    // A first value off the curve acts like a jump behind the first sample.
    assert!(probe.jumps(0, [0.0, 180.0], [1e6, values[1]]));
}

/// The slope of a position over time is the velocity, and the slope of a velocity the acceleration,
/// also with an accelerated driver.
#[test]
fn rates_over_time_equal_slopes_of_values() {
    let text = presets::find("four-bar").unwrap().text;
    for speed in [
        "speed = \"15 rad/s\"",
        "speed = \"15 rad/s\"\nacceleration = \"40 rad/s^2\"",
        "speed = \"-3 rad/s\"\nacceleration = \"2 rad/s^2\"",
    ] {
        let scene = opened(&text.replace("speed = \"15 rad/s\"", speed));
        for names in [
            ["C.x", "C.vx", "C.ax"],
            ["r4.angle", "r4.omega", "r4.alpha"],
        ] {
            let curves = sampled(&scene, &names, Abscissa::Time);
            let unit = if names[0] == "C.x" {
                1.0
            } else {
                1.0_f64.to_radians()
            };
            for (of, slope, scale) in [(0, 1, unit), (1, 2, 1.0)] {
                let size = curves.curves[slope].range().unwrap();
                let size = size.0.abs().max(size.1.abs());
                for k in (1..curves.at.len() - 1).step_by(11) {
                    let t = |k: usize| curves.along[k].unwrap();
                    let v = |k: usize| curves.curves[of].values[k].unwrap() * scale;
                    let found = (v(k + 1) - v(k - 1)) / (t(k + 1) - t(k - 1));
                    let wanted = curves.curves[slope].values[k].unwrap();
                    assert!(
                        (found - wanted).abs() < 2e-3 * size,
                        "{speed} {names:?} {found} {wanted}"
                    );
                }
            }
        }
    }
}

#[test]
fn time_abscissa_needs_nonzero_speed() {
    let text = presets::find("four-bar")
        .unwrap()
        .text
        .replace("15 rad/s", "0 rad/s");
    let (scene, solver) = opened(&text);
    let quantities = Catalogue::new(&scene).select(&["C.x"]).unwrap();
    let none = Curves::new(&scene, &solver, &quantities, Abscissa::Time, None);
    assert!(matches!(none, Err(TimeError::StandsStill)));
}

/// A Peaucellier linkage's straight line and its rates deviate only by rounding errors, larger ones
/// at the dead points. A level coupler points to 0 deg, or to 360 deg minus a rounding error.
#[test]
fn constant_curve_with_rounding_errors_is_level() {
    for (name, column, at) in [
        ("peaucellier", "P.x", 105.0),
        ("peaucellier", "P.vx", 0.0),
        ("parallelogram", "r3.angle", 0.0),
        ("triple-parallelogram", "r3.angle", 0.0),
    ] {
        let (scene, solver) = preset(name);
        let curves = sampled(&(scene, solver.clone()), &[column], Abscissa::Driver);
        let curve = &curves.curves[0];
        assert!(curve.is_level(), "{name} {column}");
        assert!(curve.extrema.is_empty(), "{name} {column}");
        let (low, high) = curve.range().unwrap();
        assert_eq!(low.to_bits(), high.to_bits(), "{name} {column}");
        assert!((low - at).abs() < 1e-9, "{name} {column} {low}");
        let pieces = curves.pieces(0);
        assert_eq!(pieces.len(), 1, "{name} {column}");
        assert!(pieces[0].iter().all(|p| p[1].to_bits() == low.to_bits()));
        let mut state = solver.state();
        for at in [1.0, 33.3, 60.0] {
            let _ = solver.solve(at, Order::Acceleration, &mut state);
            let here = curves.here(&state).values[0].unwrap();
            assert!((here - low).abs() < 1e-9, "{name} {column} {here}");
        }
    }
}

/// Near a change point, bounds are as wide as the linkage. A curve whose largest sample lies there
/// must not count as level. The kite is rotated so that its change point is close to a sample.
#[test]
fn moving_curve_near_change_point_is_not_level() {
    let kite = presets::find("kite").unwrap().text;
    for nearby in [1e-9_f64, 1e-7, 1e-6, 1e-5, 1e-4] {
        let direction = (30.0 + nearby).to_radians();
        let (x, y) = (100.0 * direction.cos(), 100.0 * direction.sin());
        let text = kite
            .replace("D = [100, 0]", &format!("D = [{x:?}, {y:?}]"))
            .replace("angle = 90", "angle = 120")
            .replace("C = [182, 182]", "C = [66.6, 248.6]")
            .replace("[vectors]", "[vectors]\nAC = [\"A\", \"C\"]");
        assert_ne!(text, kite);
        let scene = opened(&text);
        let curves = sampled(
            &scene,
            &["AC.length", "AC.accel", "r4.omega"],
            Abscissa::Driver,
        );
        for curve in &curves.curves {
            assert!(!curve.is_level(), "{} {nearby}", curve.quantity.name);
        }
    }
}

/// Times are rounded, and so are the coordinates computed from them. The ends are the exact limits
/// nevertheless.
#[test]
fn curve_over_time_ends_exactly_at_limits() {
    let text = presets::find("scissor-lift").unwrap().text;
    let speed = "speed    = \"-50 mm/s\"";
    assert!(text.contains(speed));
    for (speed_of, rate) in [(-0.02, -0.001), (-0.02, 0.01), (-3.0, -0.7), (-50.0, 0.0)] {
        let slow = format!("speed = \"{speed_of:?} mm/s\"\nacceleration = \"{rate:?} mm/s^2\"");
        let scene = opened(&text.replace(speed, &slow));
        let Range::Limited { low, high } = scene.1.motion().range else {
            panic!("it is limited");
        };
        let curves = sampled(&scene, &["M1.vx"], Abscissa::Time);
        for end in [curves.at[0], *curves.at.last().unwrap()] {
            let ends = [low, high].map(f64::to_bits);
            assert!(ends.contains(&end.to_bits()), "{speed_of} {rate}: {end:e}");
        }
    }
}

/// Every coordinate of the driver has a time within the drawn span: on another turn, or after the
/// driver has turned back.
#[test]
fn cursor_lies_on_curve_over_time_for_uneven_driver() {
    let text = presets::find("four-bar").unwrap().text;
    for speed in [
        "speed = \"15 rad/s\"\nacceleration = \"40 rad/s^2\"",
        "speed = \"3 rad/s\"\nacceleration = \"-9 rad/s^2\"",
        "speed = \"-3 rad/s\"\nacceleration = \"2 rad/s^2\"",
    ] {
        let (scene, solver) = opened(&text.replace("speed = \"15 rad/s\"", speed));
        let of = (scene, solver.clone());
        let curves = sampled(&of, &["C.x", "C.vx"], Abscissa::Time);
        let mut state = solver.state();
        let clock = Clock::new(of.0.mechanism.driver()).unwrap();
        for at in [
            -700.0, -30.0, 0.0, 30.0, 59.0, 60.0, 61.0, 180.0, 419.0, 421.0, 7000.0,
        ] {
            let _ = solver.solve(at, Order::Acceleration, &mut state);
            let here = curves.here(&state);
            let time = here.along.unwrap_or_else(|| panic!("{speed} {at}"));
            let distance = (clock.coordinate(time) - at).rem_euclid(TURN);
            assert!(distance.min(TURN - distance) < 1e-6, "{speed} {at} {time}");
            // Between the adjacent samples.
            let next = curves
                .along
                .iter()
                .position(|t| t.unwrap() >= time)
                .unwrap();
            let around = curves.curves[1].values[next.saturating_sub(1)..=next].iter();
            let size = curves.curves[1]
                .range()
                .map_or(0.0, |(low, high)| high - low);
            for value in around.flatten() {
                let distance = (here.values[1].unwrap() - value).abs();
                assert!(distance < 0.05 * size, "{speed} {at} {distance} {size}");
            }
        }
    }
}

#[test]
fn is_level_detects_constant_columns() {
    let curves = sampled(
        &preset("slider-crank"),
        &["C.y", "C.vy", "C.x", "r2.omega"],
        Abscissa::Driver,
    );
    let level: Vec<bool> = curves.curves.iter().map(Curve::is_level).collect();
    assert_eq!(level, [true, true, false, true]);
}
