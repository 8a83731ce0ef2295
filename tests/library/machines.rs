//! Tests the machines among the presets against formulas that share no code with the solver.

use krank::quantity::Catalogue;
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, Workspace};

/// Number of coordinates checked.
const PLACES: u32 = 73;

/// A point or a vector: x + i y.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane(f64, f64);

impl Plane {
    fn polar(size: f64, degrees: f64) -> Plane {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Plane(size * cosine, size * sine)
    }

    fn plus(self, other: Plane) -> Plane {
        Plane(self.0 + other.0, self.1 + other.1)
    }

    fn minus(self, other: Plane) -> Plane {
        Plane(self.0 - other.0, self.1 - other.1)
    }

    fn times(self, other: Plane) -> Plane {
        Plane(
            self.0 * other.0 - self.1 * other.1,
            self.0 * other.1 + self.1 * other.0,
        )
    }

    fn size(self) -> f64 {
        self.0.hypot(self.1)
    }

    /// Returns the unit vector of this direction.
    fn unit(self) -> Plane {
        Plane(self.0 / self.size(), self.1 / self.size())
    }

    /// Returns the rotation from another vector to this one, as a unit vector.
    fn rotation_from(self, other: Plane) -> Plane {
        self.times(Plane(other.0, -other.1)).unit()
    }
}

/// Returns the point at distance `b` from P and `c` from Q, on the left of P -> Q, by the law of
/// cosines.
fn left(p: Plane, b: f64, q: Plane, c: f64) -> Plane {
    let d = q.minus(p).size();
    let cosine = (b * b + d * d - c * c) / (2.0 * b * d);
    let sine = (1.0 - cosine * cosine).sqrt();
    p.plus(q.minus(p).unit().times(Plane(b * cosine, b * sine)))
}

/// Returns the point at distance `b` from P and `c` from Q, on the right of P -> Q.
fn right(p: Plane, b: f64, q: Plane, c: f64) -> Plane {
    left(q, c, p, b)
}

/// A preset with its solver and state.
struct Machine {
    scene: Scene,
    solver: Solver,
    state: Workspace,
}

impl Machine {
    fn of(name: &str) -> Machine {
        let preset = presets::find(name).expect("it is built in");
        let scene = Scene::parse(preset.text, name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let state = solver.state();
        Machine {
            scene,
            solver,
            state,
        }
    }

    fn places(&self) -> Vec<f64> {
        let (low, high) = self.solver.motion().range.ends();
        let place = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(PLACES);
        (0..PLACES).map(place).collect()
    }

    fn go(&mut self, at: f64) {
        let found = self.solver.solve(at, Order::Force, &mut self.state);
        assert_eq!(found, Condition::Ok, "at {at}");
    }

    fn figure(&self, name: &str) -> f64 {
        let quantity = Catalogue::new(&self.scene).find(name);
        quantity.expect(name).value(&self.state).expect(name)
    }

    fn point(&self, name: &str) -> Plane {
        Plane(
            self.figure(&format!("{name}.x")),
            self.figure(&format!("{name}.y")),
        )
    }

    /// Asserts that points agree with the formulas over the whole motion.
    fn agrees(&mut self, size: f64, expected: impl Fn(f64) -> Vec<(&'static str, Plane)>) {
        for at in self.places() {
            self.go(at);
            for (name, place) in expected(at) {
                let off = self.point(name).minus(place).size();
                assert!(off < 1e-12 * size, "{name} at {at}: {off:e} off {place:?}");
            }
        }
    }
}

/// Returns the tip and the ram of a shaper: the lever's direction follows the pin, and the ram is
/// coupled to its tip.
fn shaper(q: f64) -> (Plane, Plane) {
    let pivot = Plane(0.0, -250.0);
    let lever = Plane::polar(100.0, q).minus(pivot).unit();
    let tip = pivot.plus(lever.times(Plane(500.0, 0.0)));
    let rise = 230.0 - tip.1;
    (
        tip,
        Plane(tip.0 - (150.0_f64.powi(2) - rise * rise).sqrt(), 230.0),
    )
}

#[test]
fn shaper_has_expected_stroke_and_time_ratio() {
    let mut machine = Machine::of("shaper");
    machine.agrees(500.0, |q| vec![("T", shaper(q).0), ("F", shaper(q).1)]);
    // At its ends the lever is tangent to the pin's circle: acos(100 / 250) to either side of -90
    // degrees.
    let half = (100.0_f64 / 250.0).acos().to_degrees();
    let ends = [-90.0 + half, -90.0 - half].map(|end| {
        machine.go(end);
        assert!(machine.figure("F.vx").abs() < 1e-9, "at {end}");
        machine.figure("F.x")
    });
    // 2 x 500 x 100 / 250, because the tip has the same height at both ends.
    assert!((ends[0] - ends[1] - 400.0).abs() < 1e-9, "{ends:?}");
    let ratio = (360.0 - 2.0 * half) / (2.0 * half);
    assert!((ratio - 1.71).abs() < 0.005, "as the note says: {ratio}");
}

#[test]
fn knuckle_press_strikes_twice_per_turn() {
    let mut machine = Machine::of("knuckle-press");
    let knuckle = |q: f64| {
        let pin = Plane(420.0, -200.0).plus(Plane::polar(60.0, q));
        right(Plane(0.0, 0.0), 200.0, pin, 420.0)
    };
    let ram = |q: f64| {
        let k = knuckle(q);
        Plane(0.0, k.1 - (200.0_f64.powi(2) - k.0 * k.0).sqrt())
    };
    machine.agrees(600.0, |q| vec![("K", knuckle(q)), ("S", ram(q))]);
    let heights: Vec<f64> = (0..720).map(|k| ram(f64::from(k) / 2.0 + 0.1).1).collect();
    let turns = (0..720).filter(|&k| {
        let [a, b, c] = [0, 1, 2].map(|n| heights[(k + n) % 720]);
        (b - a) * (c - b) < 0.0
    });
    assert_eq!(turns.count(), 4);
}

#[test]
fn drag_link_press_falls_over_225_degrees() {
    let mut machine = Machine::of("drag-link-press");
    let ram = |q: f64| {
        let (pin, pivot) = (Plane::polar(200.0, q), Plane(80.0, 0.0));
        let end = left(pin, 180.0, pivot, 190.0);
        let arm = end.minus(pivot).unit().times(Plane(180.0, 0.0)).plus(pivot);
        let aside = arm.0 - 80.0;
        (
            end,
            Plane(80.0, arm.1 - (900.0_f64.powi(2) - aside * aside).sqrt()),
        )
    };
    machine.agrees(900.0, |q| vec![("C", ram(q).0), ("F", ram(q).1)]);
    let falls = (0..3600).filter(|&k| {
        let q = f64::from(k) / 10.0;
        ram(q + 0.1).1.1 < ram(q).1.1
    });
    let falls = falls.count();
    assert!(
        (2245..=2262).contains(&falls),
        "225 degrees of 360: {falls}"
    );
}

#[test]
fn v_twin_counterweight_cancels_first_order_frame_force() {
    let mut machine = Machine::of("v-twin");
    let piston = |q: f64, bore: f64| {
        let (sine, cosine) = (q - bore).to_radians().sin_cos();
        let rod = (150.0_f64.powi(2) - (40.0 * sine).powi(2)).sqrt();
        Plane::polar(40.0 * cosine + rod, bore)
    };
    machine.agrees(190.0, |q| {
        vec![("C", piston(q, 135.0)), ("D", piston(q, 45.0))]
    });
    // Fourier sums of the force on the frame: 360 positions are enough for a force with so few
    // harmonics.
    let mut sums = [[0.0; 2]; 2];
    let mut largest = 0.0_f64;
    for at in 0..360 {
        machine.go(f64::from(at));
        let (sine, cosine) = f64::from(at).to_radians().sin_cos();
        for (sum, name) in sums.iter_mut().zip(["ground.fx", "ground.fy"]) {
            let force = machine.figure(name);
            largest = largest.max(force.abs());
            sum[0] += force * cosine / 180.0;
            sum[1] += force * sine / 180.0;
        }
    }
    // Unbalanced, a single piston would give m r w^2.
    let alone = 0.04 * (3000.0 * std::f64::consts::PI / 30.0_f64).powi(2);
    assert!(largest > 0.2 * alone, "{largest}");
    for sum in sums.into_iter().flatten() {
        assert!(sum.abs() < 1e-9 * alone, "{sum} of {alone}");
    }
}

#[test]
fn radial_engine_pistons_match_master_rod_formulas() {
    let mut machine = Machine::of("radial-engine");
    const NAMES: [&str; 4] = ["P2", "P3", "P4", "P5"];
    machine.agrees(320.0, |q| {
        let pin = Plane::polar(70.0, q);
        let top = Plane(0.0, pin.1 + (250.0_f64.powi(2) - pin.0 * pin.0).sqrt());
        let master = top.minus(pin).unit();
        let others = NAMES.iter().zip(1..).map(|(&name, k)| {
            let turn = 72.0 * f64::from(k);
            let knuckle = pin.plus(master.times(Plane::polar(50.0, turn)));
            // Coordinates in the frame of the bore.
            let seen = knuckle.times(Plane::polar(1.0, -90.0 - turn));
            let reach = seen.0 + (200.0_f64.powi(2) - seen.1 * seen.1).sqrt();
            (name, Plane::polar(reach, 90.0 + turn))
        });
        std::iter::once(("P1", top)).chain(others).collect()
    });
}

#[test]
fn wiper_is_centric_and_swings_by_its_formula() {
    let mut machine = Machine::of("wiper");
    machine.agrees(500.0, |q| {
        let (pin, pivot) = (Plane::polar(50.0, q), Plane(282.5, 0.0));
        let end = left(pin, 280.0, pivot, 62.5);
        vec![("C", end), ("E", end.plus(Plane(500.0, 0.0)))]
    });
    // Crank and rod in line, extended and folded: by the law of cosines at A.
    let end = |reach: f64| {
        let cosine = (reach * reach + 282.5 * 282.5 - 62.5 * 62.5) / (2.0 * reach * 282.5);
        cosine.acos().to_degrees()
    };
    let (stretched, folded) = (end(330.0), end(230.0) + 180.0);
    assert!((folded - stretched - 180.0).abs() < 1e-12, "centric");
    let angles = [stretched, folded].map(|at| {
        machine.go(at);
        assert!(machine.figure("r4.omega").abs() < 1e-12, "at {at}");
        machine.figure("r4.angle")
    });
    let swing = 2.0 * 0.8_f64.asin().to_degrees();
    assert!((angles[1] - angles[0] - swing).abs() < 1e-11, "{angles:?}");
}

#[test]
fn double_wishbone_camber_increases_with_wheel_travel() {
    let mut machine = Machine::of("double-wishbone");
    let contact = |q: f64| {
        let (pin, pivot) = (Plane::polar(360.0, q), Plane(96.0, 217.0));
        let upper = right(pin, 240.0, pivot, 265.0);
        let upright = upper.minus(pin).unit();
        (upper, pin.plus(upright.times(Plane(-200.0, -110.0))))
    };
    for at in (-15..=15).map(f64::from) {
        machine.go(at);
        for (name, place) in [("C", contact(at).0), ("P", contact(at).1)] {
            let off = machine.point(name).minus(place).size();
            assert!(off < 1e-9, "{name} at {at}: {off:e}");
        }
    }
    let lean = [-5.0, 0.0, 5.0].map(|at| {
        machine.go(at);
        machine.figure("camber")
    });
    // 264^2 + 23^2 = 265^2: at rest the upper ball joint is exactly above the lower one.
    assert!(lean[1].abs() < 1e-10, "upright: {lean:?}");
    assert!(lean[0] < lean[1] && lean[1] < lean[2], "inwards: {lean:?}");
}

#[test]
fn ackermann_error_vanishes_at_0_and_near_29_degrees() {
    let mut machine = Machine::of("ackermann");
    let arm = Plane(-70.0, -175.0);
    let outer = |q: f64| {
        let pin = Plane(-700.0, 0.0).plus(Plane(70.0, -175.0).times(Plane::polar(1.0, q)));
        let pivot = Plane(700.0, 0.0);
        let end = right(pin, 1260.0, pivot, arm.size());
        end.minus(pivot).rotation_from(arm)
    };
    let error = |q: f64| {
        let (sine, cosine) = q.to_radians().sin_cos();
        let ideal = (2550.0 * sine).atan2(2550.0 * cosine + 1400.0 * sine);
        let turned = outer(q);
        (turned.1.atan2(turned.0) - ideal).to_degrees()
    };
    for at in (0..=32).map(f64::from) {
        machine.go(at);
        let off = machine.figure("error") - error(at);
        assert!(off.abs() < 1e-11, "at {at}: {off:e}");
    }
    assert!(error(0.0).abs() < 1e-12 && error(29.6) > 0.0 && error(29.7) < 0.0);
    assert!((0..29).all(|at| error(f64::from(at)) < 0.3));
}

#[test]
fn backhoe_bucket_turns_further_than_its_rocker() {
    let mut machine = Machine::of("backhoe");
    let [foot, rocker, hinge] = [Plane(0.0, 0.22), Plane(1.35, 0.06), Plane(1.6, 0.0)];
    let bucket = |s: f64| {
        let eye = left(foot, s, rocker, 0.4);
        let pin = left(eye, 0.36, hinge, 0.3);
        let along = pin.minus(hinge).unit();
        (
            eye,
            pin,
            hinge.plus(along.times(Plane::polar(0.85, -140.0))),
        )
    };
    machine.agrees(2.0, |s| {
        let (eye, pin, tip) = bucket(s);
        vec![("P", eye), ("K", pin), ("T", tip)]
    });
    let turned = |of: &dyn Fn(f64) -> Plane| {
        let turn = of(1.65).rotation_from(of(1.0));
        turn.1.atan2(turn.0).to_degrees().abs()
    };
    let [own, others] = [
        turned(&|s| bucket(s).1.minus(hinge)),
        turned(&|s| bucket(s).0.minus(rocker)),
    ];
    assert!(own > 1.2 * others, "{own} and {others}");
}

#[test]
fn lift_table_follows_law_of_cosines() {
    let mut machine = Machine::of("lift-table");
    assert!(matches!(
        machine.solver.motion().range,
        Range::Limited { .. }
    ));
    machine.agrees(1600.0, |s| {
        // The cylinder's ends are 500 and 300 away from M, twice the arms' angle apart.
        let cosine = (500.0_f64.powi(2) + 300.0_f64.powi(2) - s * s) / (2.0 * 500.0 * 300.0);
        let angle = cosine.acos().to_degrees() / 2.0;
        let top = Plane::polar(1600.0, angle);
        vec![
            ("M", Plane::polar(800.0, angle)),
            ("U", top),
            ("V", Plane(0.0, top.1)),
            ("R", Plane(top.0, 0.0)),
        ]
    });
}
