//! Tests inputs that follow a point over time: `[lead]` of a scene.

use krank::scene::{LeadingPoint, Scene, presets};
use krank::solver::{Condition, LeadSingularity, LedReach, Order, PointLeader, Solver, State};
use krank::{Input, Vec2};

/// A scene with a leading point, its solver, and the inputs where it opens.
struct Led {
    scene: Scene,
    solver: Solver,
    lead: LeadingPoint,
    leader: PointLeader,
}

fn parsed(text: &str) -> Led {
    let scene = Scene::parse(text, "led.toml").map_err(|faults| faults.to_string());
    let scene = scene.unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let lead = scene.lead.clone().unwrap();
    let leader = PointLeader::new(&solver, lead.lead()).unwrap();
    Led {
        scene,
        solver,
        lead,
        leader,
    }
}

/// Returns a preset with a section added.
fn with(preset: &str, section: &str) -> Led {
    let text = presets::find(preset).unwrap().text;
    parsed(&format!("{text}\n{section}\n"))
}

impl Led {
    fn input(&self, name: &str) -> Input {
        self.scene.input_named(name).unwrap()
    }

    fn reach(&self) -> LedReach {
        self.leader.clone().reach(&self.lead.path, 120)
    }

    fn group_name(&self, singularity: &LeadSingularity) -> String {
        let LeadSingularity::Parallel(group) = singularity else {
            panic!("{singularity:?}");
        };
        let group = self.solver.plan().group(*group).unwrap();
        self.scene.group_name(group).to_owned()
    }
}

#[track_caller]
fn near(found: f64, expected: f64, within: f64) {
    assert!(
        (found - expected).abs() <= within * expected.abs().max(1.0),
        "{found}, not {expected}"
    );
}

/// Angle (rad), speed and acceleration of a motor of the five-bar that holds P on its arms of 100 and
/// 140. The angle follows from the law of cosines, and the rates from the constant length of the rod:
/// with d = P - B, d . (P' - B') = 0 and d . (P'' - B'') + (P' - B')^2 = 0.
fn motor(base: f64, side: f64, [p, v, a]: [Vec2; 3]) -> [f64; 3] {
    let (dx, distance) = (p.x - base, (p.x - base).hypot(p.y));
    let cos = (100.0_f64.powi(2) + distance.powi(2) - 140.0_f64.powi(2)) / (200.0 * distance);
    let angle = p.y.atan2(dx) + side * cos.acos();
    let arm = Vec2::new(100.0 * angle.cos(), 100.0 * angle.sin());
    let across = Vec2::new(-arm.y, arm.x);
    let d = p - (Vec2::new(base, 0.0) + arm);
    let omega = d.dot(v) / d.dot(across);
    let relative = v - across * omega;
    let alpha = (relative.dot(relative) + d.dot(a + arm * (omega * omega))) / d.dot(across);
    [angle, omega, alpha]
}

/// The reference values of the five-bar at both ends, and between them the closed form of both motors
/// at the closed form of the path: two knots are 3 s^2 - 2 s^3.
#[test]
fn motors_of_five_bar_follow_a_line() {
    let mut led = with(
        "five-bar",
        "[lead]\nP = { over = [[0, 0, 173.205080756888], [2, 0, 226.491106406735]] }",
    );
    let length = 226.491_106_406_735 - 173.205_080_756_888;
    let (r2, r5) = (led.input("r2"), led.input("r5"));
    let Input::Turn(right) = r5 else { panic!() };
    for time in [0.0, 0.3, 1.0, 1.4, 2.0, 0.7] {
        let pose = led.leader.follow(&led.lead.path, time, Order::Acceleration);
        let pose = pose.unwrap();
        assert_eq!((pose.condition, &pose.singularity), (Condition::Ok, &None));
        let s = time / 2.0;
        let led_by = [
            Vec2::new(0.0, 173.205_080_756_888 + length * s * s * (3.0 - 2.0 * s)),
            Vec2::new(0.0, length * 3.0 * s * (1.0 - s)),
            Vec2::new(0.0, length * (1.5 - 3.0 * s)),
        ];
        let left = motor(-60.0, 1.0, led_by);
        let state = led.leader.state();
        near(state.at(), left[0].to_degrees(), 1e-11);
        near(state.driver_speed(), left[1], 1e-11);
        near(state.driver_acceleration(), left[2], 1e-11);
        let other = motor(60.0, -1.0, led_by);
        near(state.angle(right).unwrap(), other[0].to_degrees(), 1e-11);
        near(state.omega(right).unwrap(), other[1], 1e-11);
        near(state.alpha(right).unwrap(), other[2], 1e-11);
        // The moments are in degrees.
        near(pose.inputs[1].speed, other[1].to_degrees(), 1e-11);
        let point = led.lead.point;
        let values = [
            state.position(point),
            state.velocity(point),
            state.acceleration(point),
        ];
        for (found, expected) in values.into_iter().zip(led_by) {
            near((found.unwrap() - expected).norm(), 0.0, 1e-9);
        }
        if time == 0.0 {
            near(state.at(), 120.0, 1e-11);
        } else if time == 2.0 {
            near(state.at(), 90.0, 1e-11);
        }
    }
    assert_eq!(led.scene.input_name(r2), "r2");
}

/// A circle at constant speed, in both directions; the assembly is kept over a whole turn.
#[test]
fn motors_of_five_bar_follow_a_circle() {
    for speed in [1.5_f64, -1.5] {
        let mut led = with(
            "five-bar",
            &format!(
                "[lead]\nP = {{ centre = [10, 180], radius = 25, angle = 30, speed = \"{speed} rad/s\" }}"
            ),
        );
        let [_, period] = led.lead.path.span();
        near(period, 4.0 * std::f64::consts::PI / 3.0, 1e-15);
        for k in 0..=12 {
            let time = period * f64::from(k) / 12.0;
            let turned = 30_f64.to_radians() + speed * time;
            let arm = Vec2::new(25.0 * turned.cos(), 25.0 * turned.sin());
            let v = Vec2::new(-arm.y, arm.x) * speed;
            let led_by = [Vec2::new(10.0, 180.0) + arm, v, -arm * (speed * speed)];
            let pose = led.leader.follow(&led.lead.path, time, Order::Velocity);
            assert_eq!(pose.unwrap().condition, Condition::Ok);
            let state = led.leader.state();
            let left = motor(-60.0, 1.0, led_by);
            near(state.at(), left[0].to_degrees(), 1e-10);
            near(state.driver_speed(), left[1], 1e-10);
            // Accelerations were not requested.
            assert_eq!(state.acceleration(led.lead.point), None);
        }
        let reach = led.reach();
        assert!(reach.is_complete && reach.singular.is_empty(), "{reach:?}");
    }
}

/// The torques of the robot arm by the equations of motion of two links in the textbook form, with
/// the elbow's angle relative to the upper arm.
#[test]
fn torques_of_robot_arm_move_its_masses() {
    let mut led = with(
        "robot-arm",
        "[lead]\nW = { over = [[0, 480, 250], [0.4, 420, 350], [1, 250, 450]] }",
    );
    let (l1, c1, m1, i1) = (0.4_f64, 0.18, 4.0, 0.06);
    let (l2, c2, m2, i2) = (0.3_f64, 0.12, 2.0, 0.02);
    let (g, load) = (9.81, -50.0);
    let [upper, fore] = ["upper", "fore"].map(|name| led.input(name));
    for time in [0.1, 0.4, 0.75] {
        let pose = led.leader.follow(&led.lead.path, time, Order::Force);
        let pose = pose.unwrap();
        assert_eq!(pose.condition, Condition::Ok);
        let [a, b] = [0, 1].map(|k| pose.inputs[k].at.to_radians());
        let [v, w] = [0, 1].map(|k| pose.inputs[k].speed.to_radians());
        let [p, q] = [0, 1].map(|k| pose.inputs[k].acceleration.to_radians());
        let both = a + b;
        let coupled = m2 * l1 * c2 * b.cos();
        let own = m2 * c2 * c2 + i2;
        let first = m1 * c1 * c1 + i1 + m2 * l1 * l1 + own + 2.0 * coupled;
        let coriolis = m2 * l1 * c2 * b.sin();
        let fore_weight = m2 * g * c2 * both.cos() - load * l2 * both.cos();
        let upper_weight = (m1 * c1 + m2 * l1) * g * a.cos() - load * l1 * a.cos();
        let shoulder = first * p + (own + coupled) * q - coriolis * (2.0 * v * w + w * w)
            + upper_weight
            + fore_weight;
        let elbow = (own + coupled) * p + own * q + coriolis * v * v + fore_weight;
        let state = led.leader.state();
        near(state.effort(upper).unwrap(), shoulder, 1e-10);
        near(state.effort(fore).unwrap(), elbow, 1e-10);
        near(state.drive().unwrap(), shoulder, 1e-10);
        near(state.power().unwrap(), shoulder * v + elbow * w, 1e-10);
        assert_eq!(state.drive_parts(), None);
        let residual = state.residual().unwrap();
        near(residual.drive, 0.0, 1e-9);
        near(residual.force.norm(), 0.0, 1e-9);
    }
}

/// Both arms of the five-bar are straight 240 from each motor: the edge of the workspace.
#[test]
fn edge_of_workspace_ends_the_reach() {
    let led = with(
        "five-bar",
        "[lead]\nP = { over = [[0, 0, 173], [1, 0, 260]] }",
    );
    let reach = led.reach();
    assert!(!reach.is_complete);
    let height = (240.0_f64.powi(2) - 60.0_f64.powi(2)).sqrt();
    let [at, ..] = led.lead.path.at(reach.until);
    near(at.y, height, 1e-12);
    let (time, singularity) = reach.singular.last().unwrap();
    near(*time, reach.until, 1e-9);
    assert_eq!(singularity, &LeadSingularity::Serial(vec![0, 1]));
    // Beyond the edge there is no position, and before it there still is.
    let mut leader = led.leader.clone();
    assert_eq!(leader.follow(&led.lead.path, 1.0, Order::Position), None);
    assert!(
        leader
            .follow(&led.lead.path, 0.2, Order::Position)
            .is_some()
    );
}

/// Only the left arm is straight at (60, 207.8): 240 from the left motor, and less from the right one.
#[test]
fn edge_of_one_arm_names_its_input() {
    let height = 240.0 * 60_f64.to_radians().sin();
    let led = with(
        "five-bar",
        &format!("[lead]\nP = {{ over = [[0, 40, 180], [1, 60, {height:?}], [2, 40, 180]] }}"),
    );
    let reach = led.reach();
    let (_, singularity) = reach.singular.first().unwrap();
    assert_eq!(singularity, &LeadSingularity::Serial(vec![0]));
}

/// Close to the inner edge, both elbows of the robot arm are within a step of Newton's method.
#[test]
fn elbow_is_kept_close_to_the_edge_of_the_workspace() {
    for radius in [100.001, 100.01, 100.1, 101.0] {
        for step in [0.04, 0.05, 0.5] {
            let circle = format!(
                "W = {{ centre = [0, 0], radius = {radius}, angle = 28.7566, speed = \"90 deg/s\" }}"
            );
            let mut led = with("robot-arm", &format!("[lead]\n{circle}"));
            // The law of cosines with arms of 400 and 300: the elbow opens at -75 deg.
            let cos = (radius * radius - 400.0 * 400.0 - 300.0 * 300.0) / 240_000.0_f64;
            for k in 0..=(4.0 / step) as u32 {
                let time = step * f64::from(k);
                let pose = led.leader.follow(&led.lead.path, time, Order::Position);
                let elbow = pose.unwrap().inputs[1].at;
                near(elbow, -cos.acos().to_degrees(), 1e-6);
            }
        }
    }
}

/// Returns a path of 100 s at rest, except for a motion that begins at 50.4 s and takes less than 1 s.
fn shortly_moved(point: &str, motion: &[[f64; 2]]) -> String {
    let (first, last) = (motion[0], motion[motion.len() - 1]);
    let mut rows: Vec<[f64; 3]> = [0.0, 40.0, 49.0].map(|t| [t, first[0], first[1]]).to_vec();
    let rest = |[x, y]: [f64; 2]| std::iter::repeat_n([x, y], 20);
    let moved = rest(first).chain(motion.iter().copied()).chain(rest(last));
    rows.extend(
        (0..)
            .zip(moved)
            .map(|(k, [x, y])| [50.0 + 0.02 * f64::from(k), x, y]),
    );
    rows.extend([60.0, 70.0, 100.0].map(|t| [t, last[0], last[1]]));
    format!("[lead]\n{point} = {{ over = {rows:?} }}")
}

/// A part out of reach, and a turn about the shoulder, are shorter than a 64th of their paths.
#[test]
fn short_parts_of_a_long_path_are_followed() {
    let heights = [
        210.0, 215.0, 230.0, 250.0, 270.0, 250.0, 230.0, 215.0, 210.0,
    ];
    let mut led = with("five-bar", &shortly_moved("P", &heights.map(|y| [0.0, y])));
    let reach = led.reach();
    assert!(!reach.is_complete && (50.4..50.5).contains(&reach.until));
    // The arms of 240 are in line there, 60 to the side.
    let [at, ..] = led.lead.path.at(reach.until);
    near(at.y, (240.0_f64.powi(2) - 60.0_f64.powi(2)).sqrt(), 1e-3);
    let mut follow = |time| led.leader.follow(&led.lead.path, time, Order::Position);
    assert!(follow(50.0).is_some() && follow(52.0).is_none());

    let around: Vec<[f64; 2]> = (0..=24)
        .map(|k| f64::from(15 * k).to_radians())
        .map(|angle| [450.0 * angle.cos(), 450.0 * angle.sin()])
        .collect();
    let mut led = with("robot-arm", &shortly_moved("W", &around));
    let mut upper = |time| {
        let pose = led.leader.follow(&led.lead.path, time, Order::Position);
        pose.unwrap().inputs[0].at
    };
    let first = upper(0.0);
    near(upper(100.0) - first, 360.0, 1e-9);
}

/// The rods of the five-bar are in line at (0, 60): there P can move while both motors rest.
#[test]
fn rods_in_line_are_a_parallel_singularity_of_their_group() {
    let led = with(
        "five-bar",
        "[lead]\nP = { over = [[0, 0, 173], [1, 0, 40]] }",
    );
    let reach = led.reach();
    assert!(!reach.is_complete);
    let [at, ..] = led.lead.path.at(reach.until);
    near(at.y, 60.0, 1e-4);
    let (_, singularity) = reach.singular.last().unwrap();
    assert_eq!(led.group_name(singularity), "P");
}

/// With three inputs, two of them follow, and the third one is held.
#[test]
fn named_inputs_follow_and_others_are_held() {
    let text = presets::find("excavator").unwrap().text;
    let plain = Scene::parse(text, "excavator.toml").unwrap();
    let solver = Solver::new(&plain.mechanism).unwrap();
    let mut state = solver.state();
    let start = plain.mechanism.driver().start;
    assert_eq!(
        solver.solve(start, Order::Position, &mut state),
        Condition::Ok
    );
    let inputs: Vec<Input> = plain.mechanism.inputs().collect();
    let names: Vec<&str> = inputs.iter().map(|&i| plain.input_name(i)).collect();
    let tip = plain.traces[0];
    let name = plain.point_name(tip).unwrap();
    let at = state.position(tip).unwrap();
    let (to, by) = (
        at + Vec2::new(-0.01 * at.x.abs(), 0.01 * at.x.abs()),
        names[..2].join("\", \""),
    );
    let mut led = parsed(&format!(
        "{text}\n[lead]\n{name} = {{ over = [[0, {:?}, {:?}], [1, {:?}, {:?}]], inputs = [\"{by}\"] }}\n",
        at.x, at.y, to.x, to.y
    ));
    let held = plain.mechanism.input_coordinate(inputs[2], start).unwrap();
    let pose = led
        .leader
        .follow(&led.lead.path, 1.0, Order::Position)
        .unwrap();
    assert_eq!(pose.inputs[2].at, held);
    let moved: &State = led.leader.state();
    near(
        (moved.position(tip).unwrap() - to).norm(),
        0.0,
        1e-9 * at.norm(),
    );
    assert!((pose.inputs[0].at - start).abs() > 1e-6);
}
