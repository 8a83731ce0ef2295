//! Bounds are never smaller than the true error; the tests also measure how much larger they are.
//!
//! The true values are those of the same state in double-double.
#![allow(clippy::print_stdout, reason = "the overestimates are to be read")]

use crate::typed::short;
use krank::quantity::{self, Aspect, Catalogue, Subject};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, Workspace};
use krank::{Ball, Body, Builder, Double, Driver, Input, LinkId, Mechanism, PointId, Vec2};

/// A solver with everything that its values are compared with.
struct Trial {
    solver: Solver,
    figures: Vec<(Subject, Aspect)>,
    state: Workspace,
    enclosure: Workspace<Ball>,
    twice: Workspace<Double>,
}

/// Results over many values, by the order of their derivative.
#[derive(Default)]
struct Tally {
    states: usize,
    unproved: [usize; 3],
    /// The ratio of bound to error, if there is an error.
    over: [Vec<f64>; 3],
}

impl Tally {
    fn medians(&mut self) -> [f64; 3] {
        self.over.each_mut().map(|over| {
            over.sort_by(f64::total_cmp);
            over.get(over.len() / 2).copied().unwrap_or(f64::NAN)
        })
    }

    fn report(&mut self, name: &str) -> [f64; 3] {
        let medians = self.medians();
        let [x, v, a] = medians;
        let count: usize = self.over.iter().map(Vec::len).sum();
        println!(
            "{name:24} {:7} states, {count:8} figures, unproved {:?}; bound over error, median: {x:.1} {v:.1} {a:.1}",
            self.states, self.unproved
        );
        medians
    }
}

const POINT: [Aspect; 6] = [
    Aspect::X,
    Aspect::Y,
    Aspect::Vx,
    Aspect::Vy,
    Aspect::Ax,
    Aspect::Ay,
];
const LINK: [Aspect; 3] = [Aspect::Angle, Aspect::Omega, Aspect::Alpha];

impl Trial {
    fn of_scene(scene: &Scene) -> Trial {
        let catalogue = Catalogue::new(scene);
        let quantities = catalogue
            .all()
            .iter()
            .filter_map(|q| Some((q.subject()?, q.aspect()?)));
        let solver = Solver::new(&scene.mechanism).unwrap();
        Trial::new(solver, quantities.collect())
    }

    fn of_mechanism(mechanism: &Mechanism) -> Option<Trial> {
        let solver = Solver::new(mechanism).ok()?;
        let points = mechanism.point_ids().map(Subject::Point);
        let links = mechanism.link_ids().map(Subject::Link);
        let figures = points
            .flat_map(|p| POINT.map(|a| (p, a)))
            .chain(links.flat_map(|l| LINK.map(|a| (l, a))));
        Some(Trial::new(solver, figures.collect()))
    }

    fn new(solver: Solver, figures: Vec<(Subject, Aspect)>) -> Trial {
        Trial {
            state: solver.state(),
            enclosure: solver.enclosure(),
            twice: solver.twice(),
            figures,
            solver,
        }
    }

    fn ends(&self) -> (f64, f64) {
        match self.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        }
    }

    /// Compares every bound at one coordinate with the true error.
    fn check(&mut self, at: f64, tally: &mut Tally) {
        let order = Order::Acceleration;
        if self.solver.solve(at, order, &mut self.state) != Condition::Ok
            || !self.solver.solve_twice(&self.state, order, &mut self.twice)
        {
            return;
        }
        self.solver
            .enclose(&mut self.state, order, &mut self.enclosure);
        tally.states += 1;
        for &(subject, aspect) in &self.figures {
            let value = quantity::value(subject, aspect, &self.state);
            let truth = quantity::value(subject, aspect, &self.twice);
            let (Some(value), Some(truth)) = (value, truth) else {
                continue;
            };
            let order = aspect.order() as usize;
            let bound = quantity::bound(subject, aspect, &self.state, &self.enclosure);
            let Some(bound) = bound else {
                tally.unproved[order] += 1;
                continue;
            };
            let off = (truth - Double::exactly(value)).abs();
            let is_turn = aspect == Aspect::Angle && off.hi > 180.0;
            let turn = Double::exactly(if is_turn { 360.0 } else { 0.0 });
            let error = (off - turn).hi.abs();
            assert!(
                error <= bound,
                "{subject:?} {aspect:?} at {at:?}: {value:?} is {truth:?}, bound {bound:e}"
            );
            if error > 0.0 {
                tally.over[order].push(bound / error);
            }
        }
    }
}

#[test]
fn every_preset_value_is_within_its_bound() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let mut trial = Trial::of_scene(&scene);
        let (low, high) = trial.ends();
        let mut tally = Tally::default();
        for k in 0..=500 {
            trial.check(low + (high - low) * f64::from(k) / 500.0, &mut tally);
        }
        tally.report(preset.name);
        assert_eq!(tally.unproved, [0; 3], "{}", preset.name);
    }
}

/// Points given by lengths and angles that no double represents, over a whole turn. Their bounds
/// are about as wide as those of the same points by coordinates that no double represents.
#[test]
fn polar_points_are_within_their_bounds() {
    let sighted = crate::polar::SIGHTED;
    let plain = sighted
        .replace(
            "{ from = \"E\", length = 30.7, angle = -40.1 }",
            "[378.241, 151.801]",
        )
        .replace(
            "{ from = \"C\", length = 180.1, angle = 72.3 }",
            "[354.757, 171.573]",
        )
        .replace(
            "{ from = \"E\", length = 12.3, angle = 33 }",
            "[365.073, 178.273]",
        );
    let [sighted, plain] = [sighted, &plain].map(|text| {
        let scene = Scene::parse(text, "by length and angle").unwrap();
        let mut trial = Trial::of_scene(&scene);
        let mut tally = Tally::default();
        for k in 0..720 {
            trial.check(f64::from(k) * 0.5 + 0.1, &mut tally);
        }
        assert_eq!((tally.states, tally.unproved), (720, [0; 3]));
        tally.report(&scene.name)
    });
    for (sighted, plain) in sighted.into_iter().zip(plain) {
        assert!(sighted < 2.0 * plain, "{sighted} {plain}");
    }
}

fn four_bar_of(change: [&str; 2]) -> Scene {
    let preset = presets::find("four-bar").unwrap();
    let text = preset.text.replacen(change[0], change[1], 1);
    Scene::parse(&text, preset.name).unwrap()
}

/// An angle that rounds to a full turn is shown as 0.
#[test]
fn angle_just_below_turn_is_within_its_bound_of_zero() {
    let scene = four_bar_of(["", ""]);
    let solver = Solver::new(&scene.mechanism).unwrap();
    let (mut state, mut balls) = (solver.state(), solver.enclosure());
    let figure = (
        Subject::Link(scene.mechanism.link_ids().next().unwrap()),
        Aspect::Angle,
    );
    for below in [1e-300, 1e-20, 1e-14, 2.8e-14] {
        let _ = solver.solve(-below, Order::Position, &mut state);
        solver.enclose(&mut state, Order::Position, &mut balls);
        let value = quantity::value(figure.0, figure.1, &state).unwrap();
        let bound = quantity::bound(figure.0, figure.1, &state, &balls).unwrap();
        let off = if value == 0.0 { below } else { 0.0 };
        assert!(off <= bound, "-{below}: {value} +- {bound}");
    }
}

/// The worst of half a million: 37.459... rpm has an error of 4.8 half ulps after the conversion.
/// The others become doubles with twenty or more trailing zeros, as if they had been typed.
#[test]
fn converted_speed_is_within_its_bound() {
    let speeds = [
        ("37.45989650588049", 3_745_989_650_588_049.0, 1e14),
        ("6002.41", 600_241.0, 1e2),
        ("1800.723", 1_800_723.0, 1e3),
        ("25039.7", 250_397.0, 10.0),
        // These become whole numbers: 5, 50 and 15 rad/s.
        ("47.7464829275686", 477_464_829_275_686.0, 1e13),
        ("477.464829275686", 477_464_829_275_686.0, 1e12),
        ("143.2394487827058", 1_432_394_487_827_058.0, 1e13),
    ];
    for (text, digits, unit) in speeds {
        let scene = four_bar_of(["15 rad/s", &format!("{text} rpm")]);
        let solver = Solver::new(&scene.mechanism).unwrap();
        let (mut state, mut balls) = (solver.state(), solver.enclosure());
        let _ = solver.solve(60.0, Order::Velocity, &mut state);
        solver.enclose(&mut state, Order::Velocity, &mut balls);
        let speed = quantity::value(Subject::Driver, Aspect::Omega, &state).unwrap();
        let bound = quantity::bound(Subject::Driver, Aspect::Omega, &state, &balls).unwrap();
        let pi = Double {
            hi: std::f64::consts::PI,
            lo: 1.224_646_799_147_353_2e-16,
        };
        let typed = Double::exactly(digits) / Double::exactly(unit);
        let off = (typed * pi / Double::exactly(30.0) - Double::exactly(speed))
            .hi
            .abs();
        assert!(off <= bound, "{text}: {off:e} {bound:e}");
    }
}

/// Beyond a limit there is no assembly, not even for the decimals of the limit as printed. Such a
/// value means the limit, where positions have their bounds.
#[test]
fn value_just_beyond_limit_means_limit() {
    let preset = presets::find("double-rocker").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let (mut state, mut balls) = (solver.state(), solver.enclosure());
    let Range::Limited { low, high } = solver.motion().range else {
        panic!("a double rocker");
    };
    for (limit, outwards) in [(low, -5e-13), (high, 5e-13)] {
        let beyond = solver.solve(limit + outwards, Order::Position, &mut state);
        assert_eq!(beyond, Condition::NoAssembly, "{limit}");
        let intended = solver
            .motion()
            .range
            .equivalent_in_range(limit + outwards, true);
        assert_eq!(intended, Some(limit));
        let condition = solver.solve(limit, Order::Position, &mut state);
        assert_eq!(condition, Condition::DeadPoint, "{limit}");
        solver.enclose(&mut state, Order::Position, &mut balls);
        for point in scene.mechanism.point_ids() {
            let subject = Subject::Point(point);
            let bound = quantity::bound(subject, Aspect::Y, &state, &balls).unwrap();
            assert!(bound < 1e-5, "{limit}: {bound:e}");
        }
    }
}

/// Pseudo-random numbers, equal in every run (splitmix64).
pub(crate) struct SplitMix(u64);

impl SplitMix {
    pub(crate) fn new(seed: u64) -> SplitMix {
        SplitMix(seed)
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Returns a random position around another.
    fn around(&mut self, of: Vec2, reach: f64) -> Vec2 {
        of + Vec2::new(self.within(-reach, reach), self.within(-reach, reach))
    }
}

/// A mechanism built from positions: lengths are the distances between them, so that it closes.
struct Maker {
    builder: Builder,
    places: Vec<(PointId, Vec2)>,
}

impl Maker {
    fn new() -> Maker {
        Maker {
            builder: Mechanism::builder(),
            places: Vec::new(),
        }
    }

    fn ground(&mut self, at: Vec2) -> PointId {
        let at = at.map(short);
        let point = self.builder.ground_point(at.x, at.y);
        self.places.push((point, at));
        point
    }

    fn joint(&mut self, at: Vec2) -> PointId {
        let point = self.builder.moving_point();
        self.builder.start(point, at);
        self.places.push((point, at));
        point
    }

    fn place(&self, of: PointId) -> Vec2 {
        self.places.iter().find(|(p, _)| *p == of).unwrap().1
    }

    fn link(&mut self, from: PointId, to: PointId) -> LinkId {
        let length = short((self.place(to) - self.place(from)).norm());
        self.builder.link(from, to, length)
    }

    /// Adds a further point to a link at its position.
    fn carry(&mut self, link: LinkId, [from, to]: [PointId; 2], point: PointId) {
        let along = self.place(to) - self.place(from);
        let seen = self.place(point) - self.place(from);
        let local = (seen.turned(along.conj()) / along.norm()).map(short);
        self.builder.carry(link, point, local);
    }

    fn driven(mut self, link: LinkId, [from, to]: [PointId; 2]) -> Option<Mechanism> {
        let start = (self.place(to) - self.place(from)).angle().to_degrees();
        self.builder.driver(Driver {
            input: Input::Turn(link),
            start,
            speed: 1.5,
            acceleration: 0.7,
        });
        self.builder.build().ok()
    }
}

fn four_bar(rng: &mut SplitMix) -> Option<Mechanism> {
    let mut maker = Maker::new();
    let size = 10_f64.powf(rng.within(-1.0, 1.0));
    let a = maker.ground(Vec2::ZERO);
    let d = maker.ground(Vec2::new(size, 0.0));
    let (at_b, at_c) = (
        rng.around(Vec2::ZERO, 1.0),
        rng.around(Vec2::new(size, 0.0), 1.5),
    );
    let (b, c) = (maker.joint(at_b), maker.joint(at_c));
    let crank = maker.link(a, b);
    let coupler = maker.link(b, c);
    maker.link(d, c);
    let e = maker.joint(rng.around(Vec2::ZERO, 1.0));
    maker.carry(coupler, [b, c], e);
    maker.driven(crank, [a, b])
}

/// The frame is chosen such that the arms come within 10^-1 to 10^-13 of being collinear.
fn near_change_point(rng: &mut SplitMix) -> Option<Mechanism> {
    let mut builder = Mechanism::builder();
    let [crank, coupler, rocker] = [0; 3].map(|_| short(rng.within(0.5, 2.0)));
    let off = 10_f64.powf(rng.within(-13.0, -1.0));
    let frame = coupler + rocker - crank + if rng.unit() < 0.5 { off } else { -off };
    let a = builder.ground_point(0.0, 0.0);
    let d = builder.ground_point(frame, 0.0);
    let (b, c) = (builder.moving_point(), builder.moving_point());
    let link = builder.link(a, b, crank);
    builder.link(b, c, coupler);
    builder.link(d, c, rocker);
    builder.start(c, Vec2::new(rng.within(0.0, frame), rng.within(-1.0, 1.0)));
    builder.driver(Driver {
        input: Input::Turn(link),
        start: 7.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    builder.build().ok()
}

fn slider_crank(rng: &mut SplitMix) -> Option<Mechanism> {
    let mut maker = Maker::new();
    let a = maker.ground(Vec2::ZERO);
    let at_b = rng.around(Vec2::ZERO, 1.0);
    let at_c = rng.around(Vec2::new(2.0, 0.0), 1.5);
    let (b, c) = (maker.joint(at_b), maker.joint(at_c));
    let crank = maker.link(a, b);
    maker.link(b, c);
    let angle = short(rng.within(-180.0, 180.0));
    let through = at_c.map(short);
    maker.builder.pin_in_slot(c, Body::Ground, through, angle);
    maker.driven(crank, [a, b])
}

/// A four-bar and a dyad on its coupler.
fn watt(rng: &mut SplitMix) -> Option<Mechanism> {
    let mut maker = Maker::new();
    let [a, d, g] = [(0.0, 0.0), (2.0, 0.0), (1.0, 2.0)]
        .map(|(x, y)| rng.around(Vec2::new(x, y), 0.5))
        .map(|at| maker.ground(at));
    let [b, c, e, f] = [(0.3, 0.5), (1.8, 1.2), (1.0, 1.2), (1.6, 2.0)]
        .map(|(x, y)| rng.around(Vec2::new(x, y), 0.4))
        .map(|at| maker.joint(at));
    let crank = maker.link(a, b);
    let coupler = maker.link(b, c);
    maker.carry(coupler, [b, c], e);
    maker.link(d, c);
    maker.link(e, f);
    maker.link(g, f);
    maker.driven(crank, [a, b])
}

/// Watt's six-bar driven from the other side, so that the loops are coupled.
fn stephenson(rng: &mut SplitMix) -> Option<Mechanism> {
    let mut maker = Maker::new();
    let [a, d, g] = [(0.0, 0.0), (2.0, 0.0), (1.0, 2.0)]
        .map(|(x, y)| rng.around(Vec2::new(x, y), 0.5))
        .map(|at| maker.ground(at));
    let [b, c, e, f] = [(0.3, 0.9), (1.8, 1.2), (1.0, 1.2), (1.3, 1.7)]
        .map(|(x, y)| rng.around(Vec2::new(x, y), 0.3))
        .map(|at| maker.joint(at));
    maker.link(a, b);
    let coupler = maker.link(b, c);
    maker.carry(coupler, [b, c], e);
    maker.link(d, c);
    maker.link(e, f);
    let crank = maker.link(g, f);
    maker.driven(crank, [g, f])
}

/// Checks states of one mechanism: half of them at random, half close to an end of the motion or,
/// for full turns, close to the first state of a turn.
fn visit(trial: &mut Trial, states: usize, rng: &mut SplitMix, tally: &mut Tally) {
    let (low, high) = trial.ends();
    for k in 0..states {
        let close = (high - low) * 10_f64.powf(rng.within(-14.0, -1.0));
        let at = match k % 4 {
            0 => low + close,
            1 => high - close,
            _ => rng.within(low, high),
        };
        trial.check(at, tally);
    }
}

fn visit_many(
    name: &str,
    make: fn(&mut SplitMix) -> Option<Mechanism>,
    states: usize,
    maximum: [f64; 3],
) -> usize {
    const REPEATS: usize = 500;
    let (mut rng, mut tally) = (SplitMix(name.len() as u64), Tally::default());
    while tally.states < states {
        let Some(mechanism) = make(&mut rng) else {
            continue;
        };
        if let Some(mut trial) = Trial::of_mechanism(&mechanism) {
            visit(&mut trial, REPEATS, &mut rng, &mut tally);
        }
    }
    let medians = tally.report(name);
    let is_near = medians
        .iter()
        .zip(maximum)
        .all(|(median, maximum)| *median <= maximum);
    assert!(is_near, "{name}: {medians:?}");
    // Bounds may be missing only within about 1e-13 of a dead point.
    let count: usize = tally.over.iter().map(Vec::len).sum();
    let unproved: usize = tally.unproved.iter().sum();
    assert!(unproved * 50 < count, "{name}: {unproved} of {count}");
    tally.states
}

/// Maximum median ratio of bound to error, for positions, velocities and accelerations.
const MEDIANS: [f64; 3] = [4.0, 6.0, 8.0];

#[test]
fn four_bars_stay_within_their_bounds() {
    visit_many("four-bars", four_bar, 250_000, MEDIANS);
}

#[test]
fn four_bars_near_change_points_stay_within_their_bounds() {
    visit_many("near change points", near_change_point, 250_000, MEDIANS);
}

#[test]
fn slider_cranks_stay_within_their_bounds() {
    visit_many("slider-cranks", slider_crank, 250_000, MEDIANS);
}

#[test]
fn six_bars_of_dyads_stay_within_their_bounds() {
    visit_many("six-bars of dyads", watt, 150_000, MEDIANS);
}

#[test]
fn coupled_six_bars_stay_within_their_bounds() {
    visit_many("coupled six-bars", stephenson, 100_000, MEDIANS);
}

/// Creates four-bars in series, each driven by the rocker of the one before.
fn chain(dyads: usize, length: f64) -> Mechanism {
    chain_of(dyads, length, |_, _, _| {})
}

/// Creates such a chain with additional elements on the rocker and the joint of each four-bar.
fn chain_of(
    dyads: usize,
    length: f64,
    mut driver_state: impl FnMut(&mut Builder, LinkId, PointId),
) -> Mechanism {
    let mut builder = Mechanism::builder();
    let pivot = builder.ground_point(-length, length);
    let mut pin = builder.moving_point();
    let crank = builder.link(pivot, pin, 0.2 * length);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 90.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    for k in 0..dyads {
        let x = k as f64 * length;
        let foot = builder.ground_point(x, 0.0);
        let joint = builder.moving_point();
        builder.link(pin, joint, length);
        let rocker = builder.link(foot, joint, length);
        builder.start(joint, Vec2::new(x, length));
        driver_state(&mut builder, rocker, joint);
        pin = joint;
    }
    builder.build().unwrap()
}

/// Computed group by group, balls used to widen until they were useless behind about eighty dyads.
#[test]
fn bounds_of_long_chains_stay_tight() {
    for dyads in [5, 20, 84, 160, 300] {
        let mut trial = Trial::of_mechanism(&chain(dyads, 1.25)).unwrap();
        let mut tally = Tally::default();
        for k in 0..40 {
            trial.check(f64::from(k) * 8.7, &mut tally);
        }
        let medians = tally.report(&format!("{dyads} dyads"));
        assert_eq!(tally.unproved, [0; 3], "{dyads}");
        assert!(medians.iter().all(|&m| m <= 30.0), "{dyads}: {medians:?}");
    }
}

/// Rounding errors of untyped digits do not widen from dyad to dyad either.
#[test]
fn bounds_of_long_chains_with_rounded_lengths_stay_useful() {
    let mut trial = Trial::of_mechanism(&chain(84, 39.3)).unwrap();
    trial.check(123.4, &mut Tally::default());
    let (subject, aspect) = *trial
        .figures
        .iter()
        .rfind(|f| f.1 == Aspect::Omega)
        .unwrap();
    let bound = quantity::bound(subject, aspect, &trial.state, &trial.enclosure).unwrap();
    println!("84 dyads of 39.3: {bound:e}");
    assert!(bound < 1e-9, "{bound:e}");
}

/// A link between two known points turns with the vector between them; its length differs from
/// their distance by the rounding of its digits. Its rates have bounds even behind many dyads.
#[test]
fn ties_in_long_chains_are_within_their_bounds() {
    let mechanism = chain_of(12, 1.25, |builder, rocker, joint| {
        let end = builder.moving_point();
        builder.carry(rocker, end, Vec2::new(0.75, 0.0));
        let tie = builder.free_link();
        // 0.5 apart in decimals, but not in doubles.
        builder.carry(tie, joint, Vec2::ZERO);
        builder.carry(tie, end, Vec2::new(0.3, 0.4));
        builder.decimals();
    });
    let mut trial = Trial::of_mechanism(&mechanism).unwrap();
    let mut tally = Tally::default();
    for k in 0..40 {
        trial.check(f64::from(k) * 8.7, &mut tally);
    }
    tally.report("12 dyads with ties");
    assert_eq!(tally.unproved, [0; 3]);
}

/// Bounds are local: the position of a scene does not affect its motion.
#[test]
fn bounds_do_not_depend_on_distance_from_origin() {
    const FAR: f64 = 1e7;
    let draw = |far: f64| {
        let mut builder = Mechanism::builder();
        let at = |x: f64, y: f64| Vec2::new(x + far, y - far);
        let (a, d) = (at(0.25, 0.5), at(400.125, -20.5));
        let (a, d) = (
            builder.ground_point(a.x, a.y),
            builder.ground_point(d.x, d.y),
        );
        let (b, c, e) = (
            builder.moving_point(),
            builder.moving_point(),
            builder.moving_point(),
        );
        let crank = builder.link(a, b, 120.0);
        let coupler = builder.link(b, c, 350.0);
        builder.link(d, c, 260.5);
        builder.carry(coupler, e, Vec2::new(100.0, 60.25));
        builder.start(c, at(300.0, 200.0));
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: 30.0,
            speed: 1.5,
            acceleration: 0.25,
        });
        Trial::of_mechanism(&builder.build().unwrap()).unwrap()
    };
    let (mut here, mut there) = (draw(0.0), draw(FAR));
    for k in 0..100 {
        let at = f64::from(k) * 3.7;
        here.check(at, &mut Tally::default());
        there.check(at, &mut Tally::default());
        for &(subject, aspect) in &here.figures {
            let bound = |t: &Trial| quantity::bound(subject, aspect, &t.state, &t.enclosure);
            let [near, far] = [bound(&here), bound(&there)].map(Option::unwrap);
            let half_ulp = match aspect {
                Aspect::X | Aspect::Y => 2.0 * FAR * f64::EPSILON,
                _ => 0.0,
            };
            assert!(
                far <= near + half_ulp,
                "{subject:?} {aspect:?} at {at}: {near:e} {far:e}"
            );
        }
    }
}
