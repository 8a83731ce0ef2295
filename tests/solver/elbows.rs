//! Links driven relative to other links, compared with the same machines driven by their cranks.
//! The crank-driven machine provides the angle between two links and its rates; driven by this
//! angle, the machine must have the same states.

use krank::scene::{Scene, presets};
use krank::solver::{Condition, Fault, GroupKind, Order, Range, Solver, State};
use krank::{Body, Input, LinkId, Vec2, angle};
use std::fmt::Write;

/// Returns a scene without these sections.
fn without(text: &str, sections: &[&str]) -> String {
    let mut keeps = true;
    let mut kept = String::new();
    for line in text.lines() {
        if let Some(head) = line.strip_prefix('[') {
            let name = head.trim_start_matches('[').split([']', '.']).next();
            keeps = !name.is_some_and(|name| sections.contains(&name));
        }
        if keeps {
            writeln!(kept, "{line}").unwrap();
        }
    }
    kept
}

/// Returns the angle from one link to another in degrees, its speed and its acceleration.
fn between(state: &State, link: LinkId, from: LinkId) -> [f64; 3] {
    let [there, here] = [link, from].map(|l| state.direction(l).unwrap());
    let distance = there.turned(here.conj());
    let omega = state.omega(link).unwrap() - state.omega(from).unwrap();
    let alpha = state.alpha(link).unwrap() - state.alpha(from).unwrap();
    [angle::degrees(distance), omega, alpha]
}

/// Returns a scene driven by the angle between two links, with the starts taken from a state.
fn driven_by_elbow(scene: &Scene, state: &State, [link, from]: [LinkId; 2]) -> String {
    let left_out = ["driver", "start", "motor", "limits", "figures", "exercise"];
    let mut text = without(scene.text(), &left_out);
    let [at, speed, acceleration] = between(state, link, from);
    let [link, from] = [link, from].map(|l| scene.link_name(l));
    write!(
        text,
        "\n[driver]\nlink = \"{link}\"\nfrom = \"{from}\"\nangle = {at:?}\nspeed = \"{speed:?} rad/s\"\n\
         acceleration = \"{acceleration:?} rad/s^2\"\n[start]\n"
    )
    .unwrap();
    let moving = scene.mechanism.point_ids().filter(|&p| {
        let point = scene.mechanism.point(p);
        point.ground.is_none() && scene.point_name(p).is_some_and(|name| !name.contains('.'))
    });
    for point in moving {
        let position = state.position(point).unwrap();
        let name = scene.point_name(point).unwrap();
        writeln!(text, "{name} = [{:?}, {:?}]", position.x, position.y).unwrap();
    }
    text
}

fn solved(solver: &Solver, at: f64) -> Option<State> {
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    (condition == Condition::Ok).then(|| state.into_state())
}

/// Returns the difference of two vectors relative to a size.
fn off(a: Vec2, b: Vec2, size: f64) -> f64 {
    (a - b).norm() / size
}

/// Counts of tested pairs of links and positions.
#[derive(Default)]
struct Tally {
    pairs: usize,
    places: usize,
    coupled: usize,
    forced: usize,
}

/// Drives a machine with a crank by the angles between pairs of its links.
fn check(scene: &Scene, tally: &mut Tally) {
    let mechanism = &scene.mechanism;
    let crank = Solver::new(mechanism).unwrap();
    let start = mechanism.driver().start;
    let opened = solved(&crank, start).unwrap();
    let reach = mechanism
        .point_ids()
        .filter_map(|p| Some(opened.position(p)?.norm()))
        .fold(1e-9, f64::max);
    for link in mechanism.link_ids() {
        for from in mechanism.link_ids().filter(|&from| from != link) {
            // Only some pairs of machines with many links.
            if mechanism.links().len() > 4 && (5 * link.index() + 3 * from.index()) % 7 > 1 {
                continue;
            }
            let [_, omega, _] = between(&opened, link, from);
            // The angle hardly changes: a dead point of this input.
            if omega.abs() < 0.1 * opened.driver_speed().abs() {
                continue;
            }
            let text = driven_by_elbow(scene, &opened, [link, from]);
            let name = format!("{} from {}", scene.link_name(link), scene.link_name(from));
            let elbow = Scene::parse(&text, &name).unwrap_or_else(|e| panic!("{e:?} in {text}"));
            let driven = Solver::new(&elbow.mechanism)
                .unwrap_or_else(|fault| panic!("{}, {name}: {fault:?}", scene.title()));
            let is_coupled = |g: &krank::solver::Group| matches!(g.kind, GroupKind::Coupled { .. });
            tally.coupled += usize::from(driven.plan().groups.iter().any(is_coupled));
            tally.pairs += 1;
            let places = places(&crank, start, [link, from]);
            // In another order than along the motion.
            let count = places.len();
            for k in 0..count {
                let at = places[(k * 7 + 3) % count];
                let (q, turned) = at;
                same(scene, (&crank, q), (&driven, turned), [link, from], reach);
                tally.places += 1;
            }
            // A load that depends on the driver's coordinate would differ here.
            if !scene.text().lines().any(|line| line.starts_with("over ")) {
                tally.forced += same_power(&opened, &driven, &scene.title());
            }
        }
    }
}

/// Returns coordinates of the crank near its start with the angle between the links, as far as this
/// angle is monotonic.
fn places(crank: &Solver, start: f64, [link, from]: [LinkId; 2]) -> Vec<(f64, f64)> {
    let mut places = Vec::new();
    let opened = solved(crank, start).unwrap();
    let [first, forth, _] = between(&opened, link, from);
    for way in [1.0, -1.0] {
        let mut last = first;
        for k in 1..=12 {
            let q = start + way * 4.5 * f64::from(k);
            let Some(state) = solved(crank, q) else { break };
            let [at, omega, _] = between(&state, link, from);
            if omega / forth < 0.05 {
                break;
            }
            let turned = at + 360.0 * ((last - at) / 360.0).round();
            places.push((q, turned));
            last = turned;
        }
    }
    // Makes the number of positions coprime to the stride.
    while places.len() > 1 && places.len().is_multiple_of(7) {
        places.pop();
    }
    places
}

fn same(
    scene: &Scene,
    (crank, q): (&Solver, f64),
    (driven, turned): (&Solver, f64),
    [link, from]: [LinkId; 2],
    reach: f64,
) {
    let mechanism = &scene.mechanism;
    let what = || {
        let names = [link, from].map(|l| scene.link_name(l));
        format!("{}: {names:?} at {q} and {turned}", scene.title())
    };
    let by_crank = solved(crank, q).unwrap();
    let mut by_elbow = driven.state();
    let condition = driven.solve(turned, Order::Force, &mut by_elbow);
    assert_eq!(condition, Condition::Ok, "{}", what());
    let mut enclosure = driven.enclosure();
    driven.enclose(&mut by_elbow, Order::Force, &mut enclosure);
    let [_, omega, alpha] = between(&by_crank, link, from);
    let (speed, acceleration) = (by_elbow.driver_speed(), by_elbow.driver_acceleration());
    for point in mechanism.point_ids() {
        let place = by_crank.position(point).unwrap();
        // X' and X'' with respect to the angle between the links.
        let first = by_crank.velocity(point).unwrap() / omega;
        let second = (by_crank.acceleration(point).unwrap() - first * alpha) / (omega * omega);
        let found = by_elbow.position(point).unwrap();
        let slack = 1e-12 * (reach + first.norm());
        let distance = (found - place).norm();
        assert!(distance < 1e3 * slack, "{}: {distance:e}", what());
        let bound = enclosure.position(point).unwrap();
        let bounds = [(bound.x, found.x, place.x), (bound.y, found.y, place.y)];
        for (ball, found, place) in bounds {
            let radius = ball.bound(found).expect("a bound");
            assert!(radius < 1e-7 * reach, "{}: {radius:e}", what());
            assert!((found - place).abs() <= radius + slack, "{}", what());
        }
        let velocity = first * speed;
        let expected = second * (speed * speed) + first * acceleration;
        let sizes = [
            reach * speed.abs() + velocity.norm(),
            reach * (speed * speed + acceleration.abs()) + expected.norm(),
        ];
        let misses = [
            off(by_elbow.velocity(point).unwrap(), velocity, sizes[0]),
            off(by_elbow.acceleration(point).unwrap(), expected, sizes[1]),
        ];
        assert!(
            misses[0] < 1e-9 && misses[1] < 1e-7,
            "{}: {misses:?}",
            what()
        );
    }
    if let Some(parts) = by_elbow.drive_parts() {
        // The motor's reaction from the joints equals the effort from the virtual work of all
        // loads.
        let size: f64 = parts.iter().map(|part| part.abs()).sum();
        let miss = by_elbow.residual().unwrap();
        assert!(by_elbow.drive().is_some(), "{}: {miss:?}", what());
        assert!(
            miss.drive.abs() < 1e-9 * (1.0 + size),
            "{}: {miss:?} {size}",
            what()
        );
        assert!(
            miss.moment.abs() < 1e-9 * (1.0 + size),
            "{}: {miss:?} {size}",
            what()
        );
    }
}

/// At equal speeds, both have equal power.
fn same_power(opened: &State, driven: &Solver, title: &str) -> usize {
    let state = solved(driven, driven.mechanism().driver().start).unwrap();
    let (Some(by_crank), Some(by_elbow)) = (opened.power(), state.power()) else {
        return 0;
    };
    let size = by_crank.abs()
        + state
            .drive_parts()
            .unwrap()
            .iter()
            .map(|p| p.abs())
            .sum::<f64>();
    let distance = (by_crank - by_elbow).abs();
    assert!(
        distance < 1e-8 * (1.0 + size),
        "{title}: {by_crank} {by_elbow}"
    );
    1
}

#[test]
fn elbow_driven_machines_match_crank_driven_ones() {
    let mut tally = Tally::default();
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let is_one_crank = matches!(scene.mechanism.driver().input, Input::Turn(_))
            && scene.mechanism.timed().is_empty()
            && scene.mechanism.links().len() < 9;
        let solver = Solver::new(&scene.mechanism).unwrap();
        if is_one_crank && solver.plan().redundant.is_empty() {
            check(&scene, &mut tally);
        }
    }
    let Tally {
        pairs,
        places,
        coupled,
        forced,
    } = tally;
    assert!(
        pairs > 150 && places > 3000 && coupled > 100 && forced > 30,
        "{pairs} {places} {coupled} {forced}"
    );
}

/// The driver's base link is known, and the ground is the base of a crank.
#[test]
fn turned_from_returns_base_of_motor() {
    let scene = Scene::parse(ARM, "arm").unwrap();
    let m = &scene.mechanism;
    let [upper, fore] = [0, 1].map(|i| m.link_ids().nth(i).unwrap());
    assert_eq!(m.turned_from(fore), Body::Link(upper));
    assert_eq!(m.turned_from(upper), Body::Ground);
    assert!(m.is_directed(upper) && !m.is_directed(fore));
    assert!(m.is_crank(upper));
}

/// An arm of two links, whose elbow turns three times as fast as its shoulder.
const ARM: &str = r#"
unit = "m"
gravity = [0, -9.81]
[ground]
O = [0, 0]
[driver]
link = "upper"
angle = 30
speed = "2 rad/s"
acceleration = "1 rad/s^2"
[inputs]
fore = { ratio = 3, phase = -20, from = "upper" }
[links]
upper = { from = "O", to = "E", length = 2, com = [1, 0], mass = 3 }
fore = { from = "E", to = "T", length = 1.5, com = [1.5, 0], mass = 2 }
"#;

/// The tip of the arm is at 2 (q) + 1.5 (q + 3 q - 20). The elbow carries the moment of the mass at
/// the tip; the shoulder additionally carries the weight of the whole arm.
#[test]
fn two_motor_arm_matches_closed_form() {
    let scene = Scene::parse(ARM, "arm").unwrap();
    let m = &scene.mechanism;
    let solver = Solver::new(m).unwrap();
    let tip = m
        .point_ids()
        .find(|&p| scene.point_name(p) == Some("T"))
        .unwrap();
    let [upper, fore] = [0, 1].map(|i| m.link_ids().nth(i).unwrap());
    for q in [30.0, -75.5, 190.25, 12.0] {
        let state = solved(&solver, q).unwrap();
        let (one, two) = (q.to_radians(), (4.0 * q - 20.0).to_radians());
        let unit = |angle: f64| Vec2::new(angle.cos(), angle.sin());
        let elbow = unit(one) * 2.0;
        let position = elbow + unit(two) * 1.5;
        assert!((state.position(tip).unwrap() - position).norm() < 1e-13);
        let rates = [(one, 2.0, 2.0, 1.0), (two, 1.5, 8.0, 4.0)];
        let mut acceleration = [Vec2::ZERO; 2];
        for (number, (angle, length, omega, alpha)) in rates.into_iter().enumerate() {
            let d = unit(angle) * length;
            acceleration[number] = d.perp() * alpha - d * (omega * omega);
        }
        let of_tip = acceleration[0] + acceleration[1];
        assert!((state.acceleration(tip).unwrap() - of_tip).norm() < 1e-11);
        // Euler's equations about the elbow and about the shoulder.
        let weight = Vec2::new(0.0, 9.81);
        let at_tip = (of_tip + weight) * 2.0;
        let at_middle = (acceleration[0] * 0.5 + weight) * 3.0;
        let bent = (position - elbow).cross(at_tip);
        let shoulder = position.cross(at_tip) + (elbow * 0.5).cross(at_middle);
        let efforts = [
            state.effort(Input::Turn(upper)),
            state.effort(Input::Turn(fore)),
        ];
        let [lifted, bends] = efforts.map(Option::unwrap);
        assert!((bends - bent).abs() < 1e-10, "{bends} {bent}");
        assert!((lifted - shoulder).abs() < 1e-10, "{lifted} {shoulder}");
        let drive = state.drive().unwrap();
        assert!((drive - (shoulder + 3.0 * bent)).abs() < 1e-9, "{drive}");
    }
}

/// Creates a crank-rocker of 100, 300, 250 and 400, with a driver.
fn four_bar(driver: &str) -> Scene {
    let text = format!(
        "[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\n{driver}\n[links]\n\
         r2 = {{ from = \"A\", to = \"B\", length = 100 }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = 300 }}\n\
         r4 = {{ from = \"C\", to = \"D\", length = 250 }}\n\
         [start]\nB = [50, 87]\nC = [310, 230]\n"
    );
    Scene::parse(&text, "four-bar").unwrap()
}

/// The crank turns fully about the coupler as well. The angle at C is the transmission angle. Its
/// extrema are where the crank lies along the frame: 300^2 + 250^2 - 2 300 250 cos = (400 -+
/// 100)^2.
#[test]
fn elbow_at_crank_turns_fully_and_wrist_is_limited() {
    let round = four_bar("link = \"r3\"\nfrom = \"r2\"\nangle = -45");
    let solver = Solver::new(&round.mechanism).unwrap();
    assert_eq!(solver.motion().range, Range::Full { period: 360.0 });
    let mut states = [-45.0, 315.0, 675.0].map(|q| solved(&solver, q).unwrap());
    states.sort_by(|a, b| a.at().total_cmp(&b.at()));
    let points: Vec<_> = round.mechanism.point_ids().collect();
    for point in points {
        let positions = states.each_ref().map(|s| s.position(point).unwrap());
        assert!(positions[1] == positions[0] && positions[2] == positions[0]);
    }

    let wrist = four_bar("link = \"r4\"\nfrom = \"r3\"\nangle = 270");
    let solver = Solver::new(&wrist.mechanism).unwrap();
    let Range::Limited { low, high } = solver.motion().range else {
        panic!("{:?}", solver.motion().range);
    };
    let angle = |away: f64| {
        let cosine = (300.0_f64 * 300.0 + 250.0 * 250.0 - away * away) / (2.0 * 300.0 * 250.0);
        180.0 + cosine.acos().to_degrees()
    };
    let ends = [angle(300.0), angle(500.0)];
    assert!((low - ends[0]).abs() < 1e-11, "{low} {ends:?}");
    assert!((high - ends[1]).abs() < 1e-11, "{high} {ends:?}");
    assert_eq!(solver.motion().dead_points.len(), 2);
    let mut state = solver.state();
    assert_eq!(
        solver.solve(low - 1e-6, Order::Position, &mut state),
        Condition::NoAssembly
    );
    assert_eq!(
        solver.solve(low, Order::Acceleration, &mut state),
        Condition::DeadPoint
    );
    let seen = state
        .angle(wrist.mechanism.link_ids().next().unwrap())
        .unwrap();
    assert!(
        (seen - 360.0 * (seen / 360.0).round()).abs() < 1e-5,
        "{seen}"
    );
}

/// A lever whose slot goes through its own pivot, and a crank as long as the distance of both pivots: the
/// lever's angle is that of the input with the opposite sign. A lever turned by 180 degrees holds the
/// slot's equation, and Newton's step of the angle is zero there. It was taken for a solution.
#[test]
fn opposite_direction_of_a_link_is_no_solution() {
    let links = [
        "L6 = { from = \"G4\", to = \"X5\", length = 140.73 }",
        "L3 = { from = \"B2\", to = \"G1\", length = 93.81944 }",
    ];
    for (first, second) in [(0, 1), (1, 0)] {
        for (shift, start) in [(0.0, -30.0), (6e5, -30.0), (6e5, -120.75), (0.0, 45.0)] {
            let [crank, lever] = [shift - 93.81944, shift];
            let (sin, cos) = f64::to_radians(-start).sin_cos();
            let slide = -2.0 * 93.81944 * cos;
            let pin = [shift + slide * cos, shift + slide * sin];
            let text = format!(
                "[ground]\nG1 = [{crank:?}, {lever:?}]\nG4 = [{lever:?}, {lever:?}]\n\
                 [driver]\nlink = \"L6\"\nfrom = \"L3\"\nangle = {start:?}\n[links]\n{}\n{}\n\
                 [slides]\ns7 = {{ point = \"B2\", on = \"L6\", through = \"G4\", angle = 0 }}\n\
                 [start]\nB2 = [{:.6}, {:.6}]\n",
                links[first], links[second], pin[0], pin[1]
            );
            let scene = Scene::parse(&text, "lever").unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap_or_else(|f| panic!("{f:?} {text}"));
            assert_eq!(
                solver.motion().range,
                Range::Full { period: 360.0 },
                "{text}"
            );
            let mut ids = scene.mechanism.link_ids();
            let lever = ids.find(|&l| scene.link_name(l) == "L6").unwrap();
            for at in [start, start + 7.3, 10.0, 100.0, 200.0] {
                let state = solved(&solver, at).unwrap();
                let found = angle::degrees(state.direction(lever).unwrap());
                let off = (found + at).rem_euclid(360.0);
                assert!(off.min(360.0 - off) < 1e-6, "{found} at {at} in {text}");
            }
        }
    }
}

/// The cranks of a parallelogram keep their angle, so that it determines no position. Regression test:
/// with rounded coordinates, the scene opened with a range of one coordinate or not, depending on names and
/// the order of lines.
#[test]
fn cranks_of_parallelogram_cannot_drive_each_other() {
    let places = [
        (1000.0, 5.0, 75.5, 120.0, [-73.176112, 18.587808]),
        (0.0, 5.0, 100.0, 100.0, [88.539_999, 46.484_242]),
        (1000.0, 0.0, 60.0, 140.0, [-41.073_663, 43.738_118]),
    ];
    let orders = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    for (x, y, crank, frame, [dx, dy]) in places {
        for (names, order) in orders
            .iter()
            .flat_map(|names| orders.map(|order| (names, order)))
        {
            let [near, coupler, far] = names.map(|name| ["a", "m", "z"][name]);
            let links = [
                format!("{near} = {{ from = \"A\", to = \"B\", length = {crank:?} }}\n"),
                format!("{coupler} = {{ from = \"B\", to = \"C\", length = {frame:?} }}\n"),
                format!("{far} = {{ from = \"C\", to = \"D\", length = {crank:?} }}\n"),
            ];
            let text = format!(
                "[ground]\nA = [{x:?}, {y:?}]\nD = [{:?}, {y:?}]\n\
                 [driver]\nlink = \"{far}\"\nfrom = \"{near}\"\nangle = 180\n[links]\n{}\
                 [start]\nB = [{:?}, {:?}]\nC = [{:?}, {:?}]\n",
                x + frame,
                order.map(|line| links[line].as_str()).concat(),
                x + dx,
                y + dy,
                x + frame + dx,
                y + dy,
            );
            let scene = Scene::parse(&text, "parallelogram").unwrap();
            let fault = Solver::new(&scene.mechanism).unwrap_err();
            assert!(matches!(fault, Fault::Singular { .. }), "{fault:?} {text}");
        }
    }
}
