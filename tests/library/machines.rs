//! The machines among the presets, each against formulas written out here that share no code with the solver.

use krank::quantity::Catalogue;
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, Workspace};

/// Places that are looked at.
const PLACES: u32 = 73;

/// A place or a vector: x + i y.
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

    /// The direction of it.
    fn unit(self) -> Plane {
        Plane(self.0 / self.size(), self.1 / self.size())
    }

    /// The turn from another vector to it.
    fn seen_from(self, other: Plane) -> Plane {
        self.times(Plane(other.0, -other.1)).unit()
    }
}

/// By the law of cosines: at `b` from P and at `c` from Q, on the left of P -> Q.
fn left(p: Plane, b: f64, q: Plane, c: f64) -> Plane {
    let d = q.minus(p).size();
    let cosine = (b * b + d * d - c * c) / (2.0 * b * d);
    let sine = (1.0 - cosine * cosine).sqrt();
    p.plus(q.minus(p).unit().times(Plane(b * cosine, b * sine)))
}

/// The same on the right.
fn right(p: Plane, b: f64, q: Plane, c: f64) -> Plane {
    left(q, c, p, b)
}

/// A preset, ready to be asked.
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
        let figure = Catalogue::new(&self.scene).find(name);
        figure.expect(name).value(&self.state).expect(name)
    }

    fn point(&self, name: &str) -> Plane {
        Plane(
            self.figure(&format!("{name}.x")),
            self.figure(&format!("{name}.y")),
        )
    }

    /// Whether points lie where the formulas say, at places all over the motion.
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

/// The lever of a shaper: its direction follows the pin, and the ram hangs on its tip.
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
fn the_shaper_cuts_over_four_fifths_of_its_lever_and_hurries_back() {
    let mut machine = Machine::of("shaper");
    machine.agrees(500.0, |q| vec![("T", shaper(q).0), ("F", shaper(q).1)]);
    // At its ends the lever is a tangent of the pin's circle: acos(100 / 250) to either side of -90 degrees.
    let half = (100.0_f64 / 250.0).acos().to_degrees();
    let ends = [-90.0 + half, -90.0 - half].map(|end| {
        machine.go(end);
        assert!(machine.figure("F.vx").abs() < 1e-9, "at {end}");
        machine.figure("F.x")
    });
    // 2 x 500 x 100 / 250, for the tip stands equally high at both.
    assert!((ends[0] - ends[1] - 400.0).abs() < 1e-9, "{ends:?}");
    let ratio = (360.0 - 2.0 * half) / (2.0 * half);
    assert!((ratio - 1.71).abs() < 0.005, "as the note says: {ratio}");
}

#[test]
fn the_knuckle_press_strikes_twice() {
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
fn the_drag_link_press_comes_down_slowly() {
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
fn the_counterweight_of_the_v_twin_takes_all_that_comes_once_a_turn() {
    let mut machine = Machine::of("v-twin");
    let piston = |q: f64, bore: f64| {
        let (sine, cosine) = (q - bore).to_radians().sin_cos();
        let rod = (150.0_f64.powi(2) - (40.0 * sine).powi(2)).sqrt();
        Plane::polar(40.0 * cosine + rod, bore)
    };
    machine.agrees(190.0, |q| {
        vec![("C", piston(q, 135.0)), ("D", piston(q, 45.0))]
    });
    // Fourier's sums of what shakes the frame: 360 places are enough for a figure of so few harmonics.
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
    // Unbalanced, each piston alone would give m r w^2.
    let alone = 0.04 * (3000.0 * std::f64::consts::PI / 30.0_f64).powi(2);
    assert!(largest > 0.2 * alone, "{largest}");
    for sum in sums.into_iter().flatten() {
        assert!(sum.abs() < 1e-9 * alone, "{sum} of {alone}");
    }
}

#[test]
fn the_rods_of_the_radial_engine_hang_on_the_master() {
    let mut machine = Machine::of("radial-engine");
    const NAMES: [&str; 4] = ["P2", "P3", "P4", "P5"];
    machine.agrees(320.0, |q| {
        let pin = Plane::polar(70.0, q);
        let top = Plane(0.0, pin.1 + (250.0_f64.powi(2) - pin.0 * pin.0).sqrt());
        let master = top.minus(pin).unit();
        let others = NAMES.iter().zip(1..).map(|(&name, k)| {
            let turn = 72.0 * f64::from(k);
            let knuckle = pin.plus(master.times(Plane::polar(50.0, turn)));
            // In the frame of the bore.
            let seen = knuckle.times(Plane::polar(1.0, -90.0 - turn));
            let reach = seen.0 + (200.0_f64.powi(2) - seen.1 * seen.1).sqrt();
            (name, Plane::polar(reach, 90.0 + turn))
        });
        std::iter::once(("P1", top)).chain(others).collect()
    });
}

#[test]
fn the_wiper_takes_as_long_there_as_back() {
    let mut machine = Machine::of("wiper");
    machine.agrees(500.0, |q| {
        let (pin, pivot) = (Plane::polar(50.0, q), Plane(282.5, 0.0));
        let end = left(pin, 280.0, pivot, 62.5);
        vec![("C", end), ("E", end.plus(Plane(500.0, 0.0)))]
    });
    // Crank and rod in line, stretched and folded: by the law of cosines at A.
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
fn the_wheel_on_its_wishbones_leans_as_it_rises() {
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
    // 264^2 + 23^2 = 265^2: as the car stands the upper ball joint is right above the lower one.
    assert!(lean[1].abs() < 1e-10, "upright: {lean:?}");
    assert!(lean[0] < lean[1] && lean[1] < lean[2], "inwards: {lean:?}");
}

#[test]
fn the_steering_is_right_straight_ahead_and_once_more() {
    let mut machine = Machine::of("ackermann");
    let arm = Plane(-70.0, -175.0);
    let outer = |q: f64| {
        let pin = Plane(-700.0, 0.0).plus(Plane(70.0, -175.0).times(Plane::polar(1.0, q)));
        let pivot = Plane(700.0, 0.0);
        let end = right(pin, 1260.0, pivot, arm.size());
        end.minus(pivot).seen_from(arm)
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
fn the_bucket_turns_further_than_its_rocker() {
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
        let turn = of(1.65).seen_from(of(1.0));
        turn.1.atan2(turn.0).to_degrees().abs()
    };
    let [own, others] = [
        turned(&|s| bucket(s).1.minus(hinge)),
        turned(&|s| bucket(s).0.minus(rocker)),
    ];
    assert!(own > 1.2 * others, "{own} and {others}");
}

#[test]
fn the_lift_table_rises_by_the_law_of_cosines_between_its_arms() {
    let mut machine = Machine::of("lift-table");
    assert!(matches!(
        machine.solver.motion().range,
        Range::Limited { .. }
    ));
    machine.agrees(1600.0, |s| {
        // From M the cylinder's ends are 500 and 300 away, twice the arms' angle apart.
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
