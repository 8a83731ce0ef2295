//! Properties: plant a pose, measure the lengths, solve, recover the pose.
//!
//! The poses lean towards toggles, equal links and neighbours within 32 ulp. What is recovered is
//! judged by the measure of the group, sin(mu): an error of one rounding in a length moves the inner
//! joint by L u / sin(mu), and by no more than about L sqrt(u) where sin(mu) vanishes.

mod support;

use krank::solver::{Condition, Demand, Fault, Order, Range, Solver, State};
use krank::{Body, Builder, Driver, Input, LinkId, Mechanism, PointId, SlideId, Vec2};
use proptest::prelude::*;
use std::ops::RangeInclusive;
use support::{U, closure_error, longest_link};

/// Roundings in planting and solving a pose, in u L: some five of each, and a factor for safety.
const ROUNDINGS: f64 = 32.0;

/// The unit vector at an angle, by the platform's functions.
fn unit(degrees: f64) -> Vec2 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec2::new(cos, sin)
}

/// A length over two decades, its logarithm evenly spread.
fn length() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

fn angle() -> impl Strategy<Value = f64> {
    0.0..360.0_f64
}

fn sign() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// A number that is often tiny: from 1 down to 1e-15.
fn tiny() -> impl Strategy<Value = f64> {
    (-15.0..0.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent))
}

/// The angle at which two guides cross in degrees, now and then so small that the rounding of sums of
/// angles begins to show.
fn crossing() -> impl Strategy<Value = f64> {
    let small = (-8.0..1.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent));
    prop_oneof![2 => 5.0..175.0_f64, 1 => small]
}

/// Neighbours of a length: mostly none, at most 32 ulp.
fn ulps() -> impl Strategy<Value = i64> {
    const FAR: RangeInclusive<i64> = -32..=32;
    prop_oneof![2 => Just(0), 1 => FAR]
}

fn nudged(length: f64, ulps: i64) -> f64 {
    f64::from_bits(length.to_bits().wrapping_add_signed(ulps))
}

/// Where the inner joint of a dyad lies, seen from its outer joints: along and across the line from
/// one to the other, in units of their distance.
#[derive(Clone, Copy, Debug)]
struct Apex {
    along: f64,
    across: f64,
}

impl Apex {
    fn place(self, from: Vec2, to: Vec2) -> Vec2 {
        let line = to - from;
        from + line * self.along + line.perp() * self.across
    }
}

/// Away from a toggle.
fn open_apex() -> impl Strategy<Value = Apex> {
    (-1.0..2.0_f64, 0.2..2.0_f64, sign()).prop_map(|(along, across, sign)| Apex {
        along,
        across: sign * across,
    })
}

/// Anywhere, with toggles and equal sides over-represented.
fn apex() -> impl Strategy<Value = Apex> {
    let near_toggle = prop_oneof![-1.5..-0.2_f64, 0.2..0.8_f64, 1.2..2.5_f64];
    prop_oneof![
        2 => open_apex(),
        2 => (near_toggle, tiny()).prop_map(|(along, across)| Apex { along, across }),
        1 => (0.1..2.0_f64, sign()).prop_map(|(across, sign)| Apex {
            along: 0.5,
            across: sign * across,
        }),
    ]
}

/// A crank AB about the origin, turned by `angle`.
#[derive(Clone, Copy, Debug)]
struct Crank {
    length: f64,
    angle: f64,
}

impl Crank {
    fn pin(self) -> Vec2 {
        unit(self.angle) * self.length
    }

    /// Builds it as the driver, at one radian per second.
    fn build(self, builder: &mut Builder) -> PointId {
        let pivot = builder.ground_point(0.0, 0.0);
        let pin = builder.moving_point();
        let link = builder.link(pivot, pin, self.length);
        builder.driver(Driver {
            input: Input::Turn(link),
            start: self.angle,
            speed: 1.0,
            acceleration: 0.0,
        });
        pin
    }
}

fn crank() -> impl Strategy<Value = Crank> {
    (length(), angle()).prop_map(|(length, angle)| Crank { length, angle })
}

/// The sine of the angle between two directions.
fn sine(a: Vec2, b: Vec2) -> f64 {
    a.cross(b).abs() / (a.norm() * b.norm())
}

/// How far a joint may be from where it was planted, in units of the longest length.
fn allowance(roundings: f64, sin_mu: f64) -> f64 {
    roundings * U / sin_mu.max(U.sqrt())
}

/// Opens a planted mechanism, or gives `None` where rounding has pulled a toggle apart or left it
/// exactly stretched, where both assemblies are one and no start can choose. `roundings` count in
/// units of the dyad's shortest length.
fn open(mechanism: &Mechanism, scale: f64, sin_mu: f64, roundings: f64) -> Option<Solver> {
    let allowed = allowance(roundings, sin_mu) * scale;
    // A misfit of the lengths by g parts a stretched dyad by the square root of 2 g or so.
    let stretched = sin_mu < (8.0 * roundings * U).sqrt();
    match Solver::new(mechanism) {
        Ok(solver) => Some(solver),
        Err(Fault::Open { gap, .. }) if stretched && gap <= 8.0 * roundings * U * scale => None,
        Err(Fault::Vague { choices, .. })
            if stretched && (choices[0] - choices[1]).norm() <= allowed =>
        {
            None
        }
        Err(fault) => panic!("{fault}: {fault:?}"),
    }
}

/// Solves at the angle of the planted pose; there must be a position.
fn at_start(solver: &Solver, mechanism: &Mechanism, order: Order) -> State {
    let mut state = solver.state();
    let condition = solver.solve(mechanism.driver().start, order, &mut state);
    assert_ne!(condition, Condition::NoAssembly, "the planted pose exists");
    state
}

/// Checks that all that can be solved closes, once around.
fn closes(solver: &Solver, mechanism: &Mechanism, scale: f64) {
    let mut state = solver.state();
    for k in 0..12 {
        let at = mechanism.driver().start + 30.0 * f64::from(k);
        match solver.solve(at, Order::Position, &mut state) {
            Condition::Ok | Condition::ChangePoint => {
                let error = closure_error(mechanism, &state);
                assert!(error <= 50.0 * U * scale, "{} u at {at}", error / U / scale);
            }
            Condition::DeadPoint | Condition::NoAssembly => {}
        }
    }
}

/// The ids of a four-bar.
struct FourBar {
    mechanism: Mechanism,
    joint: PointId,
    coupler: LinkId,
    rocker: LinkId,
}

/// A four-bar by its pose.
#[derive(Clone, Copy, Debug)]
struct Pose {
    crank: Crank,
    pivot: Vec2,
    joint: Vec2,
    ulps: (i64, i64),
}

impl Pose {
    fn lengths(self) -> (f64, f64) {
        let (b, c) = (self.joint - self.crank.pin(), self.joint - self.pivot);
        (nudged(b.norm(), self.ulps.0), nudged(c.norm(), self.ulps.1))
    }

    fn build(self, shift: Vec2, scale: f64) -> FourBar {
        self.driven(shift, scale, 1.0, 0.0)
    }

    fn driven(self, shift: Vec2, scale: f64, speed: f64, acceleration: f64) -> FourBar {
        let mut builder = Mechanism::builder();
        let (b, c) = self.lengths();
        let start = (self.joint + shift) * scale;
        let at = |p: Vec2| (p + shift) * scale;
        let (a_at, d_at) = (at(Vec2::ZERO), at(self.pivot));
        let a = builder.ground_point(a_at.x, a_at.y);
        let d = builder.ground_point(d_at.x, d_at.y);
        let (pin, joint) = (builder.moving_point(), builder.moving_point());
        let crank = builder.link(a, pin, self.crank.length * scale);
        let coupler = builder.link(pin, joint, b * scale);
        let rocker = builder.link(joint, d, c * scale);
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: self.crank.angle,
            speed,
            acceleration,
        });
        builder.start(joint, start);
        FourBar {
            mechanism: builder.build().expect("a sound four-bar"),
            joint,
            coupler,
            rocker,
        }
    }

    fn scale(self) -> f64 {
        let (b, c) = self.lengths();
        b.max(c).max(self.crank.length).max(self.pivot.norm())
    }

    fn sin_mu(self) -> f64 {
        sine(self.joint - self.crank.pin(), self.joint - self.pivot)
    }

    fn open(self, mechanism: &Mechanism) -> Option<Solver> {
        let (b, c) = self.lengths();
        let lever = self.scale() / b.min(c);
        open(
            mechanism,
            self.scale(),
            self.sin_mu(),
            self.roundings() * lever,
        )
    }

    fn roundings(self) -> f64 {
        ROUNDINGS + 2.0 * (self.ulps.0.unsigned_abs() + self.ulps.1.unsigned_abs()) as f64
    }
}

fn pose(apex: impl Strategy<Value = Apex>) -> impl Strategy<Value = Pose> {
    let pivot = (length(), angle()).prop_map(|(d, at)| unit(at) * d);
    (crank(), pivot, apex, (ulps(), ulps()))
        .prop_filter(
            "the anchors of the dyad must lie apart",
            |(crank, d, ..)| (*d - crank.pin()).norm() > 0.02,
        )
        .prop_map(|(crank, pivot, apex, ulps)| Pose {
            crank,
            pivot,
            joint: apex.place(crank.pin(), pivot),
            ulps,
        })
}

/// A pose on a grid of 1/1024, so that moving and scaling it is exact.
fn round_pose() -> impl Strategy<Value = Pose> {
    let grid = |v: f64| (v * 1024.0).round() / 1024.0;
    pose(open_apex()).prop_map(move |mut pose| {
        pose.crank.length = grid(pose.crank.length).max(0.125);
        pose.crank.angle = grid(pose.crank.angle);
        pose.pivot = Vec2::new(grid(pose.pivot.x), grid(pose.pivot.y));
        pose.joint = Vec2::new(grid(pose.joint.x), grid(pose.joint.y));
        pose
    })
}

/// A four-bar whose crank turns fully: it is the shortest link by far.
fn crank_rocker() -> impl Strategy<Value = Pose> {
    round_pose().prop_map(|mut pose| {
        let distance = pose.pivot.norm();
        pose.crank.length = (distance * 128.0).ceil() / 1024.0;
        pose.joint = Apex {
            along: 0.5,
            across: 0.75,
        }
        .place(Vec2::ZERO, pose.pivot);
        pose
    })
}

/// omega and alpha of coupler and rocker for a crank at one radian per second: the two vector
/// equations, each multiplied by the direction that removes one unknown.
fn textbook_rates(pose: Pose) -> [f64; 4] {
    let pin = pose.crank.pin();
    let (e, f) = (pose.joint - pin, pose.joint - pose.pivot);
    let det = e.cross(f);
    // w3 k x e + pin' = w4 k x f, times f and times e.
    let speed = pin.perp();
    let (w3, w4) = (-speed.dot(f) / det, -speed.dot(e) / det);
    // alpha3 k x e - w3^2 e - pin = alpha4 k x f - w4^2 f, times f and times e.
    let known = f * (w4 * w4) - e * (w3 * w3) - pin;
    let (alpha3, alpha4) = (-known.dot(f) / det, -known.dot(e) / det);
    [w3, w4, alpha3, alpha4]
}

/// The range of the crank by the cosine theorem in the triangle ABD, whose side BD must lie between
/// |b - c| and b + c, with the error in degrees that its rounding allows. `None` where a change point is
/// near.
fn textbook_range(pose: Pose) -> Option<(Range, f64)> {
    let (b, c) = pose.lengths();
    let (a, d) = (pose.crank.length, pose.pivot.norm());
    let cosine = |side: f64| (a * a + d * d - side * side) / (2.0 * a * d);
    let (at_folded, at_stretched) = (cosine((b - c).abs()), cosine(b + c));
    // The crank's angle from AD lies between these, to one side or the other.
    let inner = (at_folded < 1.0).then(|| at_folded.acos().to_degrees());
    let outer = (at_stretched > -1.0).then(|| at_stretched.acos().to_degrees());
    let near_change = [at_folded - 1.0, at_stretched + 1.0].map(|v| v.abs() < 1e-3);
    if near_change.contains(&true) {
        return None;
    }
    let frame = pose.pivot.angle().to_degrees();
    let start = pose.crank.angle;
    let from_frame = (start - frame + 540.0).rem_euclid(360.0) - 180.0;
    let (low, high) = match (inner, outer) {
        (None, None) => return Some((Range::Full { period: 360.0 }, 0.0)),
        (Some(inner), Some(outer)) if from_frame >= 0.0 => (inner, outer),
        (Some(inner), Some(outer)) => (-outer, -inner),
        (None, Some(outer)) => (-outer, outer),
        (Some(inner), None) if from_frame >= 0.0 => (inner, 360.0 - inner),
        (Some(inner), None) => (inner - 360.0, -inner),
    };
    let shift = start - from_frame;
    let longest = pose.scale();
    let slack = 128.0 * U * (longest * longest / (a * d) / 0.04 + 10.0);
    let limited = Range::Limited {
        low: low + shift,
        high: high + shift,
    };
    Some((limited, slack.to_degrees()))
}

proptest! {
    #[test]
    fn a_planted_four_bar_is_recovered(pose in pose(apex())) {
        let FourBar { mechanism, joint, .. } = pose.build(Vec2::ZERO, 1.0);
        let (scale, sin_mu) = (pose.scale(), pose.sin_mu());
        if let Some(solver) = pose.open(&mechanism) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let off = (state.position(joint) - pose.joint).norm();
            let allowed = allowance(pose.roundings(), sin_mu) * scale;
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn the_rates_of_a_four_bar_are_the_textbook_s(pose in pose(open_apex())) {
        let FourBar { mechanism, coupler, rocker, .. } = pose.build(Vec2::ZERO, 1.0);
        let (scale, sin_mu) = (pose.scale(), pose.sin_mu());
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let state = at_start(&solver, &mechanism, Order::Acceleration);
        prop_assert_eq!(state.condition(), Condition::Ok);
        let [w3, w4, alpha3, alpha4] = textbook_rates(pose);
        let (b, c) = pose.lengths();
        let lever = scale / b.min(c);
        // The rules of the numerics, with the roundings of planting: err(omega) <= 7 u max(1, omega)
        // (L / min(b, c)) / sin^2, err(alpha) <= 40 u max(1, alpha) (L / min(b, c))^2 / sin^2.
        let omega = |w: f64| 2.0 * pose.roundings() * U * w.abs().max(1.0) * lever / (sin_mu * sin_mu);
        let alpha = |a: f64| {
            let size = a.abs().max(w3 * w3).max(w4 * w4).max(1.0);
            10.0 * pose.roundings() * U * size * lever * lever / (sin_mu * sin_mu)
        };
        prop_assert!((state.omega(coupler) - w3).abs() <= omega(w3), "omega3");
        prop_assert!((state.omega(rocker) - w4).abs() <= omega(w4), "omega4");
        prop_assert!((state.alpha(coupler) - alpha3).abs() <= alpha(alpha3), "alpha3");
        prop_assert!((state.alpha(rocker) - alpha4).abs() <= alpha(alpha4), "alpha4");
    }

    #[test]
    fn the_range_of_a_four_bar_is_that_of_its_triangle(pose in pose(open_apex())) {
        let FourBar { mechanism, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let Some((expected, slack)) = textbook_range(pose) else { return Ok(()) };
        match (expected, solver.motion().range) {
            (Range::Full { .. }, found) => prop_assert_eq!(found, expected),
            (Range::Limited { low, high }, Range::Limited { low: l, high: h }) => {
                let off = (low - l).abs().max((high - h).abs());
                prop_assert!(off <= slack, "{l}..{h}, expected {low}..{high} within {slack:e}");
            }
            (_, found) => prop_assert!(false, "{found:?}, expected {expected:?}"),
        }
    }

    #[test]
    fn a_planted_slider_crank_is_recovered(
        crank in crank(),
        rod in (length(), angle()),
        guide in (prop_oneof![2 => angle(), 1 => Just(0.0), 1 => Just(90.0)], -2.0..2.0_f64),
        lean in prop_oneof![1 => Just(None), 1 => tiny().prop_map(Some)],
    ) {
        let along = unit(guide.0);
        // Near its toggle the rod stands nearly across the guide.
        let rod_direction = match lean {
            None => unit(rod.1),
            Some(lean) => along.perp() + along * lean,
        };
        let joint_at = crank.pin() + rod_direction * rod.0;
        let through = joint_at - along * guide.1;
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let joint = builder.moving_point();
        let length = (joint_at - crank.pin()).norm();
        builder.link(pin, joint, length);
        let slide = builder.pin_in_slot(joint, Body::Ground, through, guide.0);
        builder.start(joint, joint_at);
        let mechanism = builder.build().expect("a sound slider-crank");
        let scale = length.max(crank.length).max(through.norm()).max(guide.1.abs());
        let sin_mu = sine(joint_at - crank.pin(), along.perp());
        if let Some(solver) = open(&mechanism, scale, sin_mu, ROUNDINGS * scale / length) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let allowed = allowance(ROUNDINGS, sin_mu) * scale;
            let off = (state.position(joint) - joint_at).norm();
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
            let off = (state.travel(slide).position - guide.1).abs();
            prop_assert!(off <= 2.0 * allowed, "travel {off:e} > {allowed:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn a_planted_inverted_slider_crank_is_recovered(
        crank in crank(),
        lever in angle(),
        along in prop_oneof![1 => length(), 1 => tiny().prop_map(f64::abs)],
        forward in sign(),
        offset in (prop_oneof![2 => Just(0.0), 1 => length()], sign()),
    ) {
        // The slot lies `offset` to the left of the lever's x axis; the pin is at `reach` along it.
        let reach = along * forward;
        // Pin and pivot must not coincide: a short reach stands on an offset.
        let offset = offset.1 * if along < 0.1 { offset.0.max(0.1) } else { offset.0 };
        let direction = unit(lever);
        let pivot_at = crank.pin() - Vec2::new(reach, offset).turned(direction);
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let pivot = builder.ground_point(pivot_at.x, pivot_at.y);
        let tip = builder.moving_point();
        let link = builder.link(pivot, tip, 1.0);
        let slide = builder.pin_in_slot(pin, Body::Link(link), Vec2::new(0.0, offset), 0.0);
        builder.start(tip, pivot_at + direction);
        let mechanism = builder.build().expect("a sound inverted slider-crank");
        let scale = crank.length.max(pivot_at.norm()).max(reach.abs()).max(offset.abs()).max(1.0);
        // The reach is found from distance and offset: its square root is the measure.
        let distance = (pivot_at - crank.pin()).norm();
        let sin_mu = (reach / distance).abs();
        if let Some(solver) = open(&mechanism, scale, sin_mu, ROUNDINGS * scale / distance) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let allowed = allowance(ROUNDINGS, sin_mu) * scale / distance;
            let off = (state.direction(link) - direction).norm();
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, s / D {sin_mu:e}");
            let off = (state.travel(slide).position - reach).abs();
            prop_assert!(off <= allowed * distance, "travel {off:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn a_planted_pin_in_two_slots_is_recovered(
        angle_of_crank in angle(),
        first in (angle(), -2.0..2.0_f64),
        crossing in crossing(),
        second in -2.0..2.0_f64,
        joint_at in (-2.0..2.0_f64, -2.0..2.0_f64),
    ) {
        // A slot in the crank and one in the ground: the dyad of two guides, PRP.
        let joint_at = Vec2::new(joint_at.0, joint_at.1);
        let turned = unit(angle_of_crank);
        let slot = unit(first.0).turned(turned);
        let guide_angle = angle_of_crank + first.0 + crossing;
        let guide = unit(guide_angle);
        let through = (joint_at - slot * first.1).turned(turned.conj());
        let through_ground = joint_at - guide * second;
        let mut builder = Mechanism::builder();
        let crank = builder.free_link();
        let pivot = builder.ground_point(0.0, 0.0);
        builder.carry(crank, pivot, Vec2::ZERO);
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: angle_of_crank,
            speed: 1.0,
            acceleration: 0.0,
        });
        let joint = builder.moving_point();
        builder.pin_in_slot(joint, Body::Link(crank), through, first.0);
        builder.pin_in_slot(joint, Body::Ground, through_ground, guide_angle);
        builder.start(joint, joint_at);
        let mechanism = builder.build().expect("a sound tangent mechanism");
        let solver = Solver::new(&mechanism).expect("crossing slots");
        let state = at_start(&solver, &mechanism, Order::Position);
        let scale = 8.0;
        // Two lines: without a square root the error stays proportional to 1 / sin(mu). The angles of
        // the slots are sums of degrees up to 900, with 2^-44 deg of rounding each.
        let sin_mu = sine(slot, guide);
        let allowed = 4.0 * ROUNDINGS * U * scale / sin_mu;
        let off = (state.position(joint) - joint_at).norm();
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
    }

    #[test]
    fn a_planted_yoke_is_recovered(
        crank in crank(),
        guide in (angle(), -2.0..2.0_f64),
        turn in prop_oneof![2 => Just(0.0), 1 => angle()],
        slot in (crossing(), -2.0..2.0_f64),
        travel in -2.0..2.0_f64,
    ) {
        // A yoke that does not turn against its guide, with a slot for the crank's pin: RPP.
        let along = unit(guide.0);
        let yoke_axis = unit(turn).turned(along);
        let slot_in_yoke = slot.0 - turn;
        let slot_axis = unit(slot_in_yoke).turned(yoke_axis);
        // The slot passes through the pin, the yoke's origin anywhere.
        let origin_at = crank.pin() - slot_axis * slot.1;
        let through = origin_at - along * travel;
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let yoke = builder.free_link();
        let origin = builder.moving_point();
        builder.carry(yoke, origin, Vec2::ZERO);
        let guide_slide = builder.sliding_link(yoke, turn, Body::Ground, through, guide.0);
        let slot_slide = builder.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, slot_in_yoke);
        builder.start(origin, origin_at);
        let mechanism = builder.build().expect("a sound yoke");
        let solver = Solver::new(&mechanism).expect("crossing guides");
        let state = at_start(&solver, &mechanism, Order::Acceleration);
        let scale = crank.length.max(through.norm()).max(4.0);
        let sin_mu = sine(along, slot_axis);
        let allowed = 4.0 * ROUNDINGS * U * scale / sin_mu;
        let off = (state.position(origin) - origin_at).norm();
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
        let off = (state.travel(guide_slide).position - travel).abs();
        prop_assert!(off <= allowed, "travel {off:e} > {allowed:e}");
        let off = (state.travel(slot_slide).position - slot.1).abs();
        prop_assert!(off <= 2.0 * allowed, "slot {off:e} > {allowed:e}");
        prop_assert_eq!(state.omega(yoke), 0.0);
        prop_assert_eq!(state.alpha(yoke), 0.0);
    }

    #[test]
    fn a_planted_six_bar_is_recovered(
        pose in pose(open_apex()),
        bodies in prop_oneof![Just((0, 1)), Just((0, 2)), Just((1, 2)), Just((2, 0))],
        locals in [(-1.5..1.5_f64, -1.5..1.5_f64), (-1.5..1.5_f64, -1.5..1.5_f64)],
        apex in apex(),
    ) {
        // The second dyad hangs on two different bodies of: coupler, rocker, ground.
        let (first, second) = ((bodies.0, locals[0]), (bodies.1, locals[1]));
        let pin = pose.crank.pin();
        let (b, c) = pose.lengths();
        let (u, v) = ((pose.joint - pin) / b, (pose.pivot - pose.joint) / c);
        let anchor = |(body, local): (usize, (f64, f64))| {
            let local = Vec2::new(local.0, local.1);
            match body {
                0 => pin + local.turned(u),
                1 => pose.joint + local.turned(v),
                _ => local,
            }
        };
        let (e_at, f_at) = (anchor(first), anchor(second));
        if (f_at - e_at).norm() < 0.05 {
            return Ok(());
        }
        let apex_at = apex.place(e_at, f_at);
        let mut builder = Mechanism::builder();
        let b_pin = pose.crank.build(&mut builder);
        let d = builder.ground_point(pose.pivot.x, pose.pivot.y);
        let joint = builder.moving_point();
        let coupler = builder.link(b_pin, joint, b);
        let rocker = builder.link(joint, d, c);
        let mut carry = |(body, local): (usize, (f64, f64))| {
            let local = Vec2::new(local.0, local.1);
            match body {
                0 | 1 => {
                    let point = builder.moving_point();
                    builder.carry(if body == 0 { coupler } else { rocker }, point, local);
                    point
                }
                _ => builder.ground_point(local.x, local.y),
            }
        };
        let (e, f) = (carry(first), carry(second));
        let apex_point = builder.moving_point();
        builder.link(e, apex_point, (apex_at - e_at).norm());
        builder.link(apex_point, f, (apex_at - f_at).norm());
        builder.start(joint, pose.joint);
        builder.start(apex_point, apex_at);
        let mechanism = builder.build().expect("a sound six-bar");
        let scale = pose.scale().max((apex_at - e_at).norm()).max((apex_at - f_at).norm()).max(3.0);
        // The first dyad's error, by the lever of its links, enters the second.
        let lever = 1.0 + 3.0 / b.min(c);
        let before = allowance(pose.roundings(), pose.sin_mu()) * lever;
        let sin_mu = sine(apex_at - e_at, apex_at - f_at);
        let roundings = before / U + ROUNDINGS;
        let shortest = (apex_at - e_at).norm().min((apex_at - f_at).norm());
        let Some(solver) = open(&mechanism, scale, sin_mu, roundings * scale / shortest) else { return Ok(()) };
        let state = at_start(&solver, &mechanism, Order::Position);
        let off = (state.position(apex_point) - apex_at).norm();
        let allowed = roundings * U * scale / sin_mu.max((roundings * U).sqrt());
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
        closes(&solver, &mechanism, scale);
    }
}

/// Every figure of a state, in the order of the mechanism, as bits.
fn bits(mechanism: &Mechanism, state: &State, length: f64) -> Vec<u64> {
    let mut figures = Vec::new();
    for id in mechanism.point_ids() {
        let vectors = [
            state.position(id),
            state.velocity(id),
            state.acceleration(id),
        ];
        figures.extend(vectors.iter().flat_map(|v| [v.x / length, v.y / length]));
    }
    for id in mechanism.link_ids() {
        let direction = state.direction(id);
        figures.extend([direction.x, direction.y, state.omega(id), state.alpha(id)]);
    }
    figures.iter().map(|v| v.to_bits()).collect()
}

/// The places at which two solvers or histories are compared.
fn places() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-720.0..720.0_f64, 1..6)
}

proptest! {
    #[test]
    fn a_power_of_two_changes_no_bit(pose in round_pose(), power in -40..40_i32, places in places()) {
        let factor = 2.0_f64.powi(power);
        let (near, far) = (pose.build(Vec2::ZERO, 1.0), pose.build(Vec2::ZERO, factor));
        let scale = pose.scale();
        let Some(one) = pose.open(&near.mechanism) else { return Ok(()) };
        let other = Solver::new(&far.mechanism).expect("the same mechanism in another size");
        prop_assert_eq!(one.motion().range, other.motion().range);
        let (mut a, mut b) = (one.state(), other.state());
        for at in places {
            let condition = one.solve(at, Order::Acceleration, &mut a);
            prop_assert_eq!(condition, other.solve(at, Order::Acceleration, &mut b));
            if condition == Condition::Ok {
                prop_assert_eq!(bits(&near.mechanism, &a, 1.0), bits(&far.mechanism, &b, factor));
            }
        }
    }

    #[test]
    fn a_far_ground_costs_no_digit_of_the_motion(
        pose in round_pose(),
        shift in (-100_000_000..100_000_000_i32, -100_000_000..100_000_000_i32),
        places in places(),
    ) {
        let shift = Vec2::new(f64::from(shift.0), f64::from(shift.1));
        let (here, there) = (pose.build(Vec2::ZERO, 1.0), pose.build(shift, 1.0));
        let scale = pose.scale();
        let Some(one) = pose.open(&here.mechanism) else { return Ok(()) };
        let other = Solver::new(&there.mechanism).expect("the same mechanism elsewhere");
        let (mut a, mut b) = (one.state(), other.state());
        for at in places {
            let condition = one.solve(at, Order::Acceleration, &mut a);
            prop_assert_eq!(condition, other.solve(at, Order::Acceleration, &mut b));
            if condition != Condition::Ok {
                continue;
            }
            for id in here.mechanism.link_ids() {
                prop_assert_eq!(a.direction(id), b.direction(id));
                prop_assert_eq!(a.omega(id).to_bits(), b.omega(id).to_bits());
                prop_assert_eq!(a.alpha(id).to_bits(), b.alpha(id).to_bits());
            }
            let moved = a.position(here.joint) + shift;
            let off = b.position(there.joint) - moved;
            let ulp = U * (shift.norm() + scale);
            prop_assert!(off.x.abs() <= 2.0 * ulp && off.y.abs() <= 2.0 * ulp, "{off:?}");
        }
    }

    #[test]
    fn a_state_does_not_depend_on_how_one_got_there(pose in pose(apex()), at in -720.0..720.0_f64, steps in 1..40_i32) {
        let FourBar { mechanism, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let mut jumped = solver.state();
        let condition = solver.solve(at, Order::Acceleration, &mut jumped);
        let mut stepped = solver.state();
        let start = mechanism.driver().start;
        for k in 0..steps {
            let way = start + (at - start) * f64::from(k) / f64::from(steps);
            solver.solve(way, Order::Acceleration, &mut stepped);
        }
        prop_assert_eq!(solver.solve(at, Order::Acceleration, &mut stepped), condition);
        if matches!(condition, Condition::Ok | Condition::ChangePoint) {
            prop_assert_eq!(bits(&mechanism, &jumped, 1.0), bits(&mechanism, &stepped, 1.0));
        }
    }

    #[test]
    fn a_turn_later_the_bits_are_the_same(pose in crank_rocker(), at in -1024..1024_i32, turns in -1_000_000..1_000_000_i32) {
        // Sums of eighths of a degree and whole turns are exact.
        let FourBar { mechanism, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        prop_assert_eq!(solver.motion().range, Range::Full { period: 360.0 });
        let at = f64::from(at) * 0.125;
        let (mut now, mut later) = (solver.state(), solver.state());
        let condition = solver.solve(at, Order::Acceleration, &mut now);
        let again = solver.solve(at + 360.0 * f64::from(turns), Order::Acceleration, &mut later);
        prop_assert_eq!(condition, again);
        prop_assert_eq!(bits(&mechanism, &now, 1.0), bits(&mechanism, &later, 1.0));
    }

    #[test]
    fn asking_for_less_changes_no_bit(pose in crank_rocker(), at in angle()) {
        let FourBar { mechanism, joint, rocker, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let mut full = solver.state();
        let condition = solver.solve(at, Order::Acceleration, &mut full);
        prop_assert_eq!(condition, Condition::Ok);
        let mut positions = solver.state();
        prop_assert_eq!(solver.solve(at, Order::Position, &mut positions), condition);
        prop_assert_eq!(full.position(joint), positions.position(joint));
        let demand = Demand { points: vec![joint], links: vec![rocker], slides: Vec::new() };
        let pruned = solver.only(&demand);
        let mut wanted = pruned.state();
        prop_assert_eq!(pruned.solve(at, Order::Acceleration, &mut wanted), condition);
        prop_assert_eq!(full.position(joint), wanted.position(joint));
        prop_assert_eq!(full.velocity(joint), wanted.velocity(joint));
        prop_assert_eq!(full.acceleration(joint), wanted.acceleration(joint));
        prop_assert_eq!(full.omega(rocker).to_bits(), wanted.omega(rocker).to_bits());
        prop_assert_eq!(full.alpha(rocker).to_bits(), wanted.alpha(rocker).to_bits());
    }

    /// Hard case H28: accelerations are linear in the driver's acceleration, at a standstill too.
    #[test]
    fn h28_a_standstill_has_accelerations(pose in pose(open_apex()), acceleration in -100.0..100.0_f64) {
        let turning = pose.driven(Vec2::ZERO, 1.0, 1.0, 0.0);
        let starting = pose.driven(Vec2::ZERO, 1.0, 0.0, acceleration);
        let Some(one) = pose.open(&turning.mechanism) else { return Ok(()) };
        let other = Solver::new(&starting.mechanism).expect("the same mechanism");
        let a = at_start(&one, &turning.mechanism, Order::Acceleration);
        let b = at_start(&other, &starting.mechanism, Order::Acceleration);
        prop_assert_eq!(a.condition(), Condition::Ok);
        for link in [turning.coupler, turning.rocker] {
            prop_assert_eq!(b.omega(link), 0.0);
            // At a standstill alpha is the coefficient of first order, here omega, times the acceleration.
            let expected = a.omega(link) * acceleration;
            let off = (b.alpha(link) - expected).abs();
            prop_assert!(off <= 4.0 * U * expected.abs(), "{off:e}");
        }
    }
}

/// A slide is a function of its id alone: reading it must not need the other slides.
#[test]
fn slides_are_read_one_by_one() {
    let mut builder = Mechanism::builder();
    let crank = Crank {
        length: 1.0,
        angle: 30.0,
    };
    let pin = crank.build(&mut builder);
    let joint = builder.moving_point();
    builder.link(pin, joint, 2.0);
    let slide: SlideId = builder.pin_in_slot(joint, Body::Ground, Vec2::ZERO, 0.0);
    builder.start(joint, Vec2::new(2.8, 0.0));
    let mechanism = builder.build().expect("a sound slider-crank");
    let solver = Solver::new(&mechanism).expect("it closes");
    let demand = Demand {
        slides: vec![slide],
        ..Demand::default()
    };
    let pruned = solver.only(&demand);
    let mut state = pruned.state();
    pruned.solve(30.0, Order::Position, &mut state);
    let expected = 0.75_f64.sqrt() + 3.75_f64.sqrt();
    assert!((state.travel(slide).position - expected).abs() < 1e-15 * 8.0);
    assert!(longest_link(&mechanism) == 2.0);
}
