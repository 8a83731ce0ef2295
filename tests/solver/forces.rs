//! Compares forces with the textbooks' matrix methods, which share no code with the solver: a free
//! body for every link, three equations each, all solved together. The motion follows from closed
//! formulas of the loop.
//!
//! R. L. Norton, Design of Machinery, chapter 11 (dynamic force analysis).

use krank::quantity::Catalogue;
use krank::scene::{Scene, presets};
use krank::solver::{Condition, InputMoment, Order, Solver};

/// A plain two-component vector, so that no code of the program is used.
type V = [f64; 2];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1]]
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1]]
}

fn polar(length: f64, angle: f64) -> V {
    [length * angle.cos(), length * angle.sin()]
}

/// Returns the acceleration of the end of a turning vector of this length at this angle.
fn turning(length: f64, angle: f64, omega: f64, alpha: f64) -> V {
    let (sin, cos) = angle.sin_cos();
    [
        -length * (alpha * sin + omega * omega * cos),
        length * (alpha * cos - omega * omega * sin),
    ]
}

/// Solves a linear system by Gaussian elimination with pivoting.
fn solve<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()));
        let pivot = pivot.unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        let row = a[k];
        for i in k + 1..N {
            let factor = a[i][k] / row[k];
            for (v, above) in a[i].iter_mut().zip(row) {
                *v -= factor * above;
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let rest: f64 = (k + 1..N).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - rest) / a[k][k];
    }
    b
}

/// A link in the plane: position and acceleration of its centre of mass, and its angular
/// acceleration.
#[derive(Clone, Copy)]
struct Body {
    com: V,
    a: V,
    alpha: f64,
    mass: f64,
    inertia: f64,
}

const GRAVITY: V = [0.3, -9.81];

impl Body {
    /// Returns the right-hand sides: m (a - g), and I alpha.
    fn needs(&self) -> [f64; 3] {
        [
            self.mass * (self.a[0] - GRAVITY[0]),
            self.mass * (self.a[1] - GRAVITY[1]),
            self.inertia * self.alpha,
        ]
    }

    /// Returns the coefficients of the moment about the centre of mass for a force at a position.
    fn moment(&self, at: V) -> V {
        let r = sub(at, self.com);
        [-r[1], r[0]]
    }
}

/// The quantities of a scene by name.
struct Figures {
    catalogue: Catalogue,
    solver: Solver,
}

impl Figures {
    fn of(text: &str) -> Figures {
        let scene = Scene::parse(text, "test.toml").unwrap_or_else(|e| panic!("{e}"));
        Figures {
            solver: Solver::new(&scene.mechanism).unwrap(),
            catalogue: Catalogue::new(&scene),
        }
    }

    fn at<const N: usize>(&self, at: f64, names: [&str; N]) -> [f64; N] {
        let mut state = self.solver.state();
        let condition = self.solver.solve(at, Order::Force, &mut state);
        assert_eq!(condition, Condition::Ok, "{at}");
        names.map(|name| {
            let figure = self.catalogue.all().iter().find(|q| q.name == name);
            let figure = figure.unwrap_or_else(|| panic!("no figure {name}"));
            figure.value(&state).unwrap()
        })
    }
}

fn agree<const N: usize>(at: f64, names: [&str; N], got: [f64; N], want: [f64; N]) {
    let size = want.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    for i in 0..N {
        let miss = (got[i] - want[i]).abs();
        let name = names[i];
        assert!(
            miss < 1e-11 * size,
            "{name} at {at}: {} and not {}",
            got[i],
            want[i]
        );
    }
}

/// Returns the lectures' four-bar with masses, in a unit of which a millimetre has `mm`.
fn four_bar_in(unit: &str, mm: f64) -> String {
    let [d, r2, r3, r4] = [400.0, 100.0, 300.0, 250.0].map(|v| v * mm);
    let [g2, g3, g4] = [40.0, 150.0, 125.0].map(|v| v * mm);
    let [x, y] = [310.0, 230.0].map(|v| v * mm);
    format!(
        r#"
unit = "{unit}"
gravity = [0.3, -9.81]
[ground]
A = [0, 0]
D = [{d}, 0]
[driver]
link = "r2"
angle = 60
speed = "15 rad/s"
acceleration = "7 rad/s^2"
[links]
r2 = {{ from = "A", to = "B", length = {r2}, com = [{g2}, 0], mass = 1.5, inertia = 0.004 }}
r3 = {{ from = "B", to = "C", length = {r3}, com = [{g3}, 0], mass = 2.5, inertia = 0.02 }}
r4 = {{ from = "D", to = "C", length = {r4}, com = [{g4}, 0], mass = 2.0, inertia = 0.015 }}
[start]
C = [{x}, {y}]
[[loads]]
point = "r3.com"
force = [120, -500]
[[loads]]
link = "r4"
torque = -35
"#
    )
}

/// Solves nine equations: three links, for the forces at A, B, C, D and the torque.
fn four_bar(degrees: f64) -> [f64; 9] {
    let (r1, r2, r3, r4) = (0.4_f64, 0.1_f64, 0.3_f64, 0.25_f64);
    let (w2, a2) = (15.0, 7.0);
    let t2 = degrees.to_radians();
    // The diagonal B-D and the law of cosines.
    let b = polar(r2, t2);
    let d: V = [r1, 0.0];
    let bd = sub(d, b);
    let m = bd[0].hypot(bd[1]);
    let at_b = ((m * m + r3 * r3 - r4 * r4) / (2.0 * m * r3)).acos();
    let t3 = bd[1].atan2(bd[0]) + at_b;
    let c = add(b, polar(r3, t3));
    let dc = sub(c, d);
    let t4 = dc[1].atan2(dc[0]);
    let w3 = r2 * w2 * (t4 - t2).sin() / (r3 * (t3 - t4).sin());
    let w4 = r2 * w2 * (t2 - t3).sin() / (r4 * (t4 - t3).sin());
    // The loop's accelerations, projected onto r4 and r3: each projection eliminates one unknown.
    let known = sub(
        sub(turning(r4, t4, w4, 0.0), turning(r3, t3, w3, 0.0)),
        turning(r2, t2, w2, a2),
    );
    let along = |t: f64| known[0] * t.cos() + known[1] * t.sin();
    let a3 = along(t4) / (r3 * (t4 - t3).sin());
    let a4 = along(t3) / (r4 * (t4 - t3).sin());
    let ab = turning(r2, t2, w2, a2);
    let bodies = [
        Body {
            com: polar(0.04, t2),
            a: turning(0.04, t2, w2, a2),
            alpha: a2,
            mass: 1.5,
            inertia: 0.004,
        },
        Body {
            com: add(b, polar(0.15, t3)),
            a: add(ab, turning(0.15, t3, w3, a3)),
            alpha: a3,
            mass: 2.5,
            inertia: 0.02,
        },
        Body {
            com: add(d, polar(0.125, t4)),
            a: turning(0.125, t4, w4, a4),
            alpha: a4,
            mass: 2.0,
            inertia: 0.015,
        },
    ];
    // Unknowns: A on r2, B on r3 (so -B on r2), C on r4 (so -C on r3), D on r4, torque on r2.
    let mut matrix = [[0.0; 9]; 9];
    let mut right = [0.0; 9];
    let acts: [(usize, usize, V, f64); 6] = [
        (0, 0, [0.0, 0.0], 1.0),
        (0, 2, b, -1.0),
        (1, 2, b, 1.0),
        (1, 4, c, -1.0),
        (2, 4, c, 1.0),
        (2, 6, d, 1.0),
    ];
    for (body, unknown, at, sign) in acts {
        let moment = bodies[body].moment(at);
        for axis in 0..2 {
            matrix[3 * body + axis][unknown + axis] += sign;
            matrix[3 * body + 2][unknown + axis] += sign * moment[axis];
        }
    }
    matrix[2][8] = 1.0;
    for (i, body) in bodies.iter().enumerate() {
        right[3 * i..3 * i + 3].copy_from_slice(&body.needs());
    }
    // The load at the coupler's centre of mass, and the torque on the rocker.
    right[3] -= 120.0;
    right[4] += 500.0;
    right[8] += 35.0;
    solve(matrix, right)
}

#[test]
fn four_bar_forces_match_matrix_method() {
    const NAMES: [&str; 9] = [
        "r2.A.fx",
        "r2.A.fy",
        "r3.B.fx",
        "r3.B.fy",
        "r4.C.fx",
        "r4.C.fy",
        "r4.D.fx",
        "r4.D.fy",
        "driver.torque",
    ];
    let figures = Figures::of(&four_bar_in("mm", 1.0));
    for degrees in (0..360).step_by(5).map(f64::from) {
        agree(
            degrees,
            NAMES,
            figures.at(degrees, NAMES),
            four_bar(degrees),
        );
    }
}

const ENGINE: &str = r#"
unit = "mm"
gravity = [0.3, -9.81]
[ground]
O = [0, 0]
[driver]
link = "crank"
angle = 30
speed = "3000 rpm"
[links]
crank = { from = "O", to = "A", length = 40, com = [-5, 0], mass = 2.0, inertia = 0.003 }
rod = { from = "A", to = "B", length = 140, com = [45, 0], mass = 0.6, inertia = 0.0018 }
piston = { points = { B = [0, 0] }, com = [10, 15], mass = 0.5 }
[slides]
bore = { link = "piston", on = "ground", through = [0, 10], angle = 0, turn = 0 }
[start]
B = [178, 10]
[[loads]]
point = "B"
force = [-9000, 0]
"#;

/// Solves eight equations, and one for the moment that keeps the piston from turning.
fn slider_crank(degrees: f64) -> [f64; 9] {
    let (r, l, e) = (0.04_f64, 0.14_f64, 0.01_f64);
    let w = 3000.0 / 60.0 * std::f64::consts::TAU;
    let t2 = degrees.to_radians();
    // The rod's angle from r sin t2 + l sin t3 = e, and its rates.
    let a = polar(r, t2);
    let t3 = ((e - a[1]) / l).asin();
    let w3 = -r * w * t2.cos() / (l * t3.cos());
    let a3 = (r * w * w * t2.sin() + l * w3 * w3 * t3.sin()) / (l * t3.cos());
    let b = add(a, polar(l, t3));
    let aa = turning(r, t2, w, 0.0);
    let ab = add(aa, turning(l, t3, w3, a3));
    let crank = Body {
        com: polar(-0.005, t2),
        a: turning(-0.005, t2, w, 0.0),
        alpha: 0.0,
        mass: 2.0,
        inertia: 0.003,
    };
    let rod = Body {
        com: add(a, polar(0.045, t3)),
        a: add(aa, turning(0.045, t3, w3, a3)),
        alpha: a3,
        mass: 0.6,
        inertia: 0.0018,
    };
    let piston = Body {
        com: add(b, [0.01, 0.015]),
        a: [ab[0], 0.0],
        alpha: 0.0,
        mass: 0.5,
        inertia: 0.0,
    };
    assert!(
        ab[1].abs() < 1e-9 * ab[0].abs().max(1.0),
        "the piston stays in its bore"
    );
    let bodies = [crank, rod, piston];
    // Unknowns: O on the crank, A on the rod, B on the piston, the bore's force and moment, the
    // torque.
    let mut matrix = [[0.0; 9]; 9];
    let mut right = [0.0; 9];
    let acts: [(usize, usize, V, f64); 5] = [
        (0, 0, [0.0, 0.0], 1.0),
        (0, 2, a, -1.0),
        (1, 2, a, 1.0),
        (1, 4, b, -1.0),
        (2, 4, b, 1.0),
    ];
    for (body, unknown, at, sign) in acts {
        let moment = bodies[body].moment(at);
        for axis in 0..2 {
            matrix[3 * body + axis][unknown + axis] += sign;
            matrix[3 * body + 2][unknown + axis] += sign * moment[axis];
        }
    }
    matrix[7][6] = 1.0;
    matrix[8][6] = piston.moment(b)[1];
    matrix[8][7] = 1.0;
    matrix[2][8] = 1.0;
    for (i, body) in bodies.iter().enumerate() {
        right[3 * i..3 * i + 3].copy_from_slice(&body.needs());
    }
    // The gas force acts on the pin, here applied to the piston.
    right[6] += 9000.0;
    right[8] -= piston.moment(b)[0] * -9000.0;
    solve(matrix, right)
}

#[test]
fn slider_crank_forces_match_matrix_method() {
    const NAMES: [&str; 9] = [
        "crank.O.fx",
        "crank.O.fy",
        "rod.A.fx",
        "rod.A.fy",
        "rod.B.fx",
        "rod.B.fy",
        "bore.normal",
        "bore.moment",
        "driver.torque",
    ];
    let figures = Figures::of(ENGINE);
    for degrees in (0..360).step_by(5).map(f64::from) {
        let mut want = slider_crank(degrees);
        // The force of the piston on the rod.
        (want[4], want[5]) = (-want[4], -want[5]);
        agree(degrees, NAMES, figures.at(degrees, NAMES), want);
    }
}

#[test]
fn forces_do_not_depend_on_length_unit() {
    const NAMES: [&str; 4] = ["r3.B.fx", "r4.C.fy", "driver.torque", "ground.moment"];
    let mm = Figures::of(&four_bar_in("mm", 1.0));
    for (unit, per_mm) in [("cm", 0.1), ("m", 0.001)] {
        let other = Figures::of(&four_bar_in(unit, per_mm));
        for degrees in (0..360).step_by(7).map(f64::from) {
            let (want, got) = (mm.at(degrees, NAMES), other.at(degrees, NAMES));
            for i in 0..NAMES.len() {
                let miss = (got[i] - want[i]).abs();
                let size = want.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
                assert!(
                    miss < 1e-13 * size,
                    "{unit} {degrees} {}: {miss:e}",
                    NAMES[i]
                );
            }
        }
    }
}

#[test]
fn scene_without_loads_has_no_forces() {
    let preset = presets::find("four-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    assert!(!solver.has_forces());
    let names = Catalogue::new(&scene);
    assert!(names.all().iter().all(|q| q.order() < Order::Force));
    let mut state = solver.state();
    let _ = solver.solve(60.0, Order::Force, &mut state);
    assert_eq!(state.drive(), None);
}

/// Opens a scene with its solver.
fn opened(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test.toml").unwrap_or_else(|e| panic!("{e}"));
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

/// Returns the text of a preset with additional loads.
fn with(preset: &str, replace: &[(&str, &str)], acts: &str) -> String {
    let mut text = presets::find(preset).unwrap().text.to_owned();
    for (from, to) in replace {
        assert!(text.contains(from), "{preset} has no {from}");
        text = text.replace(from, to);
    }
    text + acts
}

/// The stored energy, kinetic and potential, in J, and the power of a force at a point, in W.
struct Energy {
    stored: f64,
    given: f64,
}

/// Computes the energy of a mechanism with masses under its gravity, with one force at a point.
fn energy(scene: &Scene, solver: &Solver, at: f64, point: &str, force: V) -> Energy {
    let mechanism = &scene.mechanism;
    let mut state = solver.state();
    let _ = solver.solve(at, Order::Velocity, &mut state);
    let metres = mechanism.metres();
    let mut stored = 0.0;
    for id in mechanism.link_ids() {
        let link = mechanism.link(id);
        let Some(com) = link.com else { continue };
        let (p, v) = (state.position(com).unwrap(), state.velocity(com).unwrap());
        let omega = state.omega(id).unwrap();
        stored += 0.5 * link.mass * (v.x * v.x + v.y * v.y) * metres * metres;
        stored += 0.5 * link.inertia * omega * omega;
        let g = mechanism.gravity();
        stored -= link.mass * (g.x * p.x + g.y * p.y) * metres;
    }
    let named = |id: &krank::PointId| scene.point_name(*id) == Some(point);
    let loaded = mechanism.point_ids().find(named).unwrap();
    let v = state.velocity(loaded).unwrap();
    Energy {
        stored,
        given: (force[0] * v.x + force[1] * v.y) * metres,
    }
}

/// The motor's power equals the energy's rate less the load's power, from differences of energies,
/// which need only positions and velocities. Tested with six-bars of dyads and one whose four links
/// form one group.
#[test]
fn motor_power_matches_energy_balance() {
    let masses = |link: &str, length: f64| {
        let [half, mass, inertia] = [0.4 * length, 0.01 * length, 1e-6 * length * length];
        format!("length = {length}, com = [{half}, 7], mass = {mass}, inertia = {inertia}{link}")
    };
    let mut tried = 0;
    for name in ["stephenson-six-bar", "watt-six-bar", "klann-leg"] {
        let preset = presets::find(name).unwrap().text;
        let mut text = String::from("gravity = [0, -9.81]\n");
        let mut last_point = String::new();
        for line in preset.lines() {
            let is_plain = line.contains("length = ") && !line.contains("com =");
            match line.split_once("length = ").filter(|_| is_plain) {
                Some((head, tail)) => {
                    let digits = tail.split([',', ' ', '}']).next().unwrap();
                    let length: f64 = digits.parse().unwrap();
                    let rest = &tail[digits.len()..];
                    text += &format!("{head}{}\n", masses(rest, length));
                    let to = line.split_once("to = \"").unwrap().1;
                    last_point = to.split('"').next().unwrap().to_owned();
                }
                None => text += &format!("{line}\n"),
            }
        }
        text += &format!("[[loads]]\npoint = \"{last_point}\"\nforce = [30, -40]\n");
        let (scene, solver) = opened(&text);
        let mut state = solver.state();
        let speed = scene.mechanism.driver().speed;
        for at in (0..360).step_by(15).map(f64::from) {
            if solver.solve(at, Order::Force, &mut state) != Condition::Ok {
                continue;
            }
            // A step in degrees and its duration in seconds.
            let step = 0.05_f64;
            let seconds = step.to_radians() / speed;
            let of = |k: f64| energy(&scene, &solver, at + k * step, &last_point, [30.0, -40.0]);
            let slope = |k: f64| (of(k).stored - of(-k).stored) / (2.0 * k * seconds);
            // Richardson's extrapolation, of fourth order.
            let grown = (4.0 * slope(1.0) - slope(2.0)) / 3.0;
            let want = grown - of(0.0).given;
            let got = state.power().unwrap();
            let size = want.abs().max(of(0.0).given.abs()).max(0.1);
            assert!(
                (got - want).abs() < 1e-6 * size,
                "{name} at {at}: {got} W and not {want}"
            );
            tried += 1;
        }
    }
    assert!(tried > 60, "only {tried} places");
}

#[test]
fn drive_diverges_towards_dead_point_and_is_none_there() {
    // Driven at its rocker, the four-bar reaches a limit where crank and coupler are collinear.
    let text = with(
        "double-rocker",
        &[],
        "[[loads]]\npoint = \"C\"\nforce = [0, -100]\n",
    );
    let (_, solver) = opened(&text);
    let krank::solver::Range::Limited { high, .. } = solver.motion().range else {
        panic!("a double rocker has limits");
    };
    let mut state = solver.state();
    let drive = |at: f64, state: &mut krank::solver::Workspace| {
        let condition = solver.solve(at, Order::Force, state);
        (condition, state.drive())
    };
    assert_eq!(drive(high, &mut state), (Condition::DeadPoint, None));
    let (_, near) = drive(high - 1e-3, &mut state);
    let (_, nearer) = drive(high - 1e-5, &mut state);
    // The mechanical advantage decreases with the root of the distance.
    let ratio = nearer.unwrap() / near.unwrap();
    assert!((ratio.abs() - 10.0).abs() < 0.1, "{ratio}");
}

/// At a change point, the reactions depend on the assembly and are undefined. The driver's torque
/// follows from virtual work and agrees from both sides.
#[test]
fn change_point_has_torque_but_no_reactions() {
    let text = with(
        "parallelogram",
        &[],
        "[[loads]]\npoint = \"C\"\nforce = [20, -100]\n",
    );
    let (scene, solver) = opened(&text);
    let at = solver.motion().change_points[0];
    let mut state = solver.state();
    assert_eq!(
        solver.solve(at, Order::Force, &mut state),
        Condition::ChangePoint
    );
    let there = state.drive().unwrap();
    let link = scene.mechanism.link_ids().next().unwrap();
    let pin = scene.mechanism.pins(link).next().unwrap();
    assert_eq!(state.joint_force(link, pin), None);
    assert_eq!(state.frame_force(), None);
    for nearby in [at - 1.0, at + 1.0] {
        let _ = solver.solve(nearby, Order::Force, &mut state);
        let nearby = state.drive().unwrap();
        assert!(
            (nearby - there).abs() < 0.2 * there.abs().max(1.0),
            "{nearby} {there}"
        );
    }
}

/// A parallelogram in a turned frame, with a load on its coupler.
const TURNED_PARALLELOGRAM: &str = r#"unit = "mm"
[ground]
A = [0, 0]
D = [180, 240]
[driver]
link = "r2"
angle = 60
speed = "1 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300, points.P = [100, 40] }
r4 = { from = "D", to = "C", length = 100 }
[start]
C = [230, 326]
[[loads]]
point = "P"
force = [20, -100]
"#;

/// Beside a change point the reactions are millions of times the load, and cancel in the torque and
/// in the force on the frame. P moves as B does, so that the torque has a closed form.
#[test]
fn torque_beside_change_point_has_all_digits() {
    let (_, solver) = opened(TURNED_PARALLELOGRAM);
    let at = solver.motion().change_points[0];
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    for distance in [1.0, 1e-3, 1e-6, 1e-8] {
        let degrees = at + distance;
        let condition = solver.solve(degrees, Order::Force, &mut state);
        assert_eq!(condition, Condition::Ok);
        solver.enclose(&mut state, Order::Force, &mut enclosure);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let torque = 0.1 * (20.0 * sin + 100.0 * cos);
        let error = state.drive().unwrap() - torque;
        assert!(error.abs() < 1e-12, "{distance}: {error}");
        let frame = state.frame_force().unwrap();
        let error = (frame.x - 20.0).hypot(frame.y + 100.0);
        assert!(error < 1e-12, "{distance}: {error}");
        // Closer, the rates have no bound.
        if distance >= 1e-3 {
            let bound = enclosure.drive().unwrap().bound(torque).unwrap();
            assert!(bound < 1e-6, "{distance}: {bound}");
        }
    }
}

/// An input that moves by itself, at any speed, needs the torque that it needs as the driver.
#[test]
fn single_free_input_has_the_torque_of_the_driver() {
    let (scene, solver) = opened(presets::find("four-bar-load").unwrap().text);
    let driver = *scene.mechanism.driver();
    let mut state = solver.state();
    let mut free = solver.free_inputs().unwrap();
    for at in [20.0, 75.0, 200.0] {
        let moment = InputMoment {
            at,
            // The coordinate is in degrees.
            speed: driver.speed.to_degrees(),
            acceleration: driver.acceleration.to_degrees(),
        };
        assert_eq!(free.solve(&[moment], Order::Force), Condition::Ok);
        assert_eq!(solver.solve(at, Order::Force, &mut state), Condition::Ok);
        let expected = state.drive().unwrap();
        for found in [free.state().drive(), free.state().effort(driver.input)] {
            let error = found.unwrap() - expected;
            assert!(error.abs() < 1e-12 * expected.abs(), "{at}: {error}");
        }
        let [own, led] = [state.frame_force(), free.state().frame_force()];
        let error = (own.unwrap() - led.unwrap()).norm();
        assert!(error < 1e-9, "{at}: {error}");
    }
}

/// A load in a link's frame equals a load in the ground frame rotated with it. A load scaled by a
/// table vanishes where the table is zero.
#[test]
fn loads_turn_with_their_frame_and_follow_their_table() {
    let fixed = |acts: &str| Figures::of(&with("four-bar", &[], acts));
    let turned = fixed("[[loads]]\npoint = \"C\"\nforce = [100, 0]\nframe = \"r2\"\n");
    for degrees in [0.0_f64, 30.0, 75.0, 200.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let [x, y] = [100.0 * cos, 100.0 * sin];
        let fixed = fixed(&format!("[[loads]]\npoint = \"C\"\nforce = [{x}, {y}]\n"));
        let names = ["driver.torque", "r3.B.fx", "r4.D.fy"];
        agree(
            degrees,
            names,
            turned.at(degrees, names),
            fixed.at(degrees, names),
        );
    }
    let over = fixed(
        "[[loads]]\nlink = \"r4\"\ntorque = 10\nover = [[0, 0], [90, 1], [180, 0], [360, 0]]\n",
    );
    let all = fixed("[[loads]]\nlink = \"r4\"\ntorque = 10\n");
    for (degrees, part) in [(45.0, 0.5), (90.0, 1.0), (360.0 + 45.0, 0.5), (250.0, 0.0)] {
        let [got] = over.at(degrees, ["driver.torque"]);
        let [complete] = all.at(degrees, ["driver.torque"]);
        assert!(
            (got - part * complete).abs() < 1e-12,
            "{degrees}: {got} {complete}"
        );
    }
}

/// A spring between a ground point and the slider: the crank supplies its energy.
#[test]
fn spring_and_damper_give_exact_driver_power() {
    let acts =
        "[[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 500\nlength = 15\ndamping = 40\n";
    let figures = Figures::of(&with("slider-crank", &[], acts));
    for degrees in [10.0, 100.0, 170.0, 300.0] {
        let names = ["driver.power", "C.x", "C.vx"];
        let [power, x, v] = figures.at(degrees, names);
        // In cm; the slider moves along the line to A.
        let pull = 500.0 * (x - 15.0) / 100.0 + 40.0 * v / 100.0;
        let want = pull * v / 100.0;
        assert!(
            (power - want).abs() < 1e-10 * want.abs(),
            "{degrees}: {power} {want}"
        );
    }
}
