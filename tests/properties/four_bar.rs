//! Tests four-bars with known solutions, and against the closed forms of textbooks.

use crate::plant::*;
use crate::support::U;
use krank::solver::{Condition, Order, Range, Solver};
use krank::{Driver, Input, LinkId, Mechanism, PointId, Vec2};
use proptest::prelude::*;

/// A four-bar with the ids of its parts.
pub(crate) struct FourBar {
    pub(crate) mechanism: Mechanism,
    pub(crate) joint: PointId,
    pub(crate) coupler: LinkId,
    pub(crate) rocker: LinkId,
}

/// A four-bar defined by its pose.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) crank: Crank,
    pub(crate) pivot: Vec2,
    pub(crate) joint: Vec2,
    ulps: (i64, i64),
}

impl Pose {
    pub(crate) fn lengths(self) -> (f64, f64) {
        let (b, c) = (self.joint - self.crank.pin(), self.joint - self.pivot);
        (nudged(b.norm(), self.ulps.0), nudged(c.norm(), self.ulps.1))
    }

    pub(crate) fn build(self, shift: Vec2, scale: f64) -> FourBar {
        self.driven(shift, scale, 1.0, 0.0)
    }

    pub(crate) fn driven(self, shift: Vec2, scale: f64, speed: f64, acceleration: f64) -> FourBar {
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

    pub(crate) fn scale(self) -> f64 {
        let (b, c) = self.lengths();
        b.max(c).max(self.crank.length).max(self.pivot.norm())
    }

    pub(crate) fn sin_mu(self) -> f64 {
        sine(self.joint - self.crank.pin(), self.joint - self.pivot)
    }

    pub(crate) fn open(self, mechanism: &Mechanism) -> Option<Solver> {
        let (b, c) = self.lengths();
        let lever = self.scale() / b.min(c);
        open(
            mechanism,
            self.scale(),
            self.sin_mu(),
            self.roundings() * lever,
        )
    }

    pub(crate) fn roundings(self) -> f64 {
        ROUNDINGS + 2.0 * (self.ulps.0.unsigned_abs() + self.ulps.1.unsigned_abs()) as f64
    }
}

pub(crate) fn pose(apex: impl Strategy<Value = Apex>) -> impl Strategy<Value = Pose> {
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

/// Generates poses on a grid of 1/1024, so that translation and scaling are exact.
pub(crate) fn round_pose() -> impl Strategy<Value = Pose> {
    let grid = |v: f64| (v * 1024.0).round() / 1024.0;
    pose(open_apex()).prop_map(move |mut pose| {
        pose.crank.length = grid(pose.crank.length).max(0.125);
        pose.crank.angle = grid(pose.crank.angle);
        pose.pivot = Vec2::new(grid(pose.pivot.x), grid(pose.pivot.y));
        pose.joint = Vec2::new(grid(pose.joint.x), grid(pose.joint.y));
        pose
    })
}

/// Generates four-bars whose crank, by far the shortest link, turns fully.
pub(crate) fn crank_rocker() -> impl Strategy<Value = Pose> {
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

/// Returns omega and alpha of coupler and rocker for a crank at one radian per second, from the two
/// vector equations, each multiplied by the direction that eliminates one unknown.
pub(crate) fn textbook_rates(pose: Pose) -> [f64; 4] {
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

/// Returns the range of the crank by the law of cosines in the triangle ABD, whose side BD must lie
/// between |b - c| and b + c, with its rounding error in degrees. `None` near a change point.
pub(crate) fn textbook_range(pose: Pose) -> Option<(Range, f64)> {
    let (b, c) = pose.lengths();
    let (a, d) = (pose.crank.length, pose.pivot.norm());
    let cosine = |side: f64| (a * a + d * d - side * side) / (2.0 * a * d);
    let (at_folded, at_stretched) = (cosine((b - c).abs()), cosine(b + c));
    // The crank's angle from AD lies between these, on one side or the other.
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
    fn planted_four_bar_is_recovered(pose in pose(apex())) {
        let FourBar { mechanism, joint, .. } = pose.build(Vec2::ZERO, 1.0);
        let (scale, sin_mu) = (pose.scale(), pose.sin_mu());
        if let Some(solver) = pose.open(&mechanism) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let off = (state.position(joint).unwrap() - pose.joint).norm();
            let allowed = allowance(pose.roundings(), sin_mu) * scale;
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn four_bar_rates_agree_with_closed_forms(pose in pose(open_apex())) {
        let FourBar { mechanism, coupler, rocker, .. } = pose.build(Vec2::ZERO, 1.0);
        let (scale, sin_mu) = (pose.scale(), pose.sin_mu());
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let state = at_start(&solver, &mechanism, Order::Acceleration);
        prop_assert_eq!(state.condition(), Condition::Ok);
        let [w3, w4, alpha3, alpha4] = textbook_rates(pose);
        let (b, c) = pose.lengths();
        let lever = scale / b.min(c);
        // The error model, with the rounding of the known pose: err(omega) <= 7 u max(1, omega) (L
        // / min(b, c)) / sin^2, err(alpha) <= 40 u max(1, alpha) (L / min(b, c))^2 / sin^2.
        let omega = |w: f64| 2.0 * pose.roundings() * U * w.abs().max(1.0) * lever / (sin_mu * sin_mu);
        let alpha = |a: f64| {
            let size = a.abs().max(w3 * w3).max(w4 * w4).max(1.0);
            10.0 * pose.roundings() * U * size * lever * lever / (sin_mu * sin_mu)
        };
        prop_assert!((state.omega(coupler).unwrap() - w3).abs() <= omega(w3), "omega3");
        prop_assert!((state.omega(rocker).unwrap() - w4).abs() <= omega(w4), "omega4");
        prop_assert!((state.alpha(coupler).unwrap() - alpha3).abs() <= alpha(alpha3), "alpha3");
        prop_assert!((state.alpha(rocker).unwrap() - alpha4).abs() <= alpha(alpha4), "alpha4");
    }

    #[test]
    fn four_bar_range_agrees_with_law_of_cosines(pose in pose(open_apex())) {
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
}
