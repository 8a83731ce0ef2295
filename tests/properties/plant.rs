//! Poses to plant, and what may be asked of a solver that is to recover them.

use crate::support::{U, closure_error};
use krank::solver::{Condition, Fault, Order, Range, Solver, State};
use krank::{Builder, Driver, Input, Mechanism, PointId, Vec2};
use proptest::prelude::*;
use std::ops::RangeInclusive;

/// Roundings in planting and solving a pose, in u L: some five of each, and a factor for safety.
pub(crate) const ROUNDINGS: f64 = 32.0;

/// The unit vector at an angle, by the platform's functions.
pub(crate) fn unit(degrees: f64) -> Vec2 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec2::new(cos, sin)
}

/// A length over two decades, its logarithm evenly spread.
pub(crate) fn length() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

pub(crate) fn angle() -> impl Strategy<Value = f64> {
    0.0..360.0_f64
}

pub(crate) fn sign() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// A number that is often tiny: from 1 down to 1e-15.
pub(crate) fn tiny() -> impl Strategy<Value = f64> {
    (-15.0..0.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent))
}

/// The angle at which two guides cross in degrees, now and then so small that the rounding of sums of
/// angles begins to show.
pub(crate) fn crossing() -> impl Strategy<Value = f64> {
    let small = (-8.0..1.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent));
    prop_oneof![2 => 5.0..175.0_f64, 1 => small]
}

/// Neighbours of a length: mostly none, at most 32 ulp.
pub(crate) fn ulps() -> impl Strategy<Value = i64> {
    const FAR: RangeInclusive<i64> = -32..=32;
    prop_oneof![2 => Just(0), 1 => FAR]
}

pub(crate) fn nudged(length: f64, ulps: i64) -> f64 {
    f64::from_bits(length.to_bits().wrapping_add_signed(ulps))
}

/// Where the inner joint of a dyad lies, seen from its outer joints: along and across the line from
/// one to the other, in units of their distance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Apex {
    pub(crate) along: f64,
    pub(crate) across: f64,
}

impl Apex {
    pub(crate) fn place(self, from: Vec2, to: Vec2) -> Vec2 {
        let line = to - from;
        from + line * self.along + line.perp() * self.across
    }
}

/// Away from a toggle.
pub(crate) fn open_apex() -> impl Strategy<Value = Apex> {
    (-1.0..2.0_f64, 0.2..2.0_f64, sign()).prop_map(|(along, across, sign)| Apex {
        along,
        across: sign * across,
    })
}

/// Anywhere, with toggles and equal sides over-represented.
pub(crate) fn apex() -> impl Strategy<Value = Apex> {
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
pub(crate) struct Crank {
    pub(crate) length: f64,
    pub(crate) angle: f64,
}

impl Crank {
    pub(crate) fn pin(self) -> Vec2 {
        unit(self.angle) * self.length
    }

    /// Builds it as the driver, at one radian per second.
    pub(crate) fn build(self, builder: &mut Builder) -> PointId {
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

pub(crate) fn crank() -> impl Strategy<Value = Crank> {
    (length(), angle()).prop_map(|(length, angle)| Crank { length, angle })
}

/// The sine of the angle between two directions.
pub(crate) fn sine(a: Vec2, b: Vec2) -> f64 {
    a.cross(b).abs() / (a.norm() * b.norm())
}

/// How far a joint may be from where it was planted, in units of the longest length.
pub(crate) fn allowance(roundings: f64, sin_mu: f64) -> f64 {
    roundings * U / sin_mu.max(U.sqrt())
}

/// Opens a planted mechanism, or gives `None` where rounding has pulled a toggle apart or left it
/// exactly stretched, where both assemblies are one and no start can choose. `roundings` count in
/// units of the dyad's shortest length.
pub(crate) fn open(
    mechanism: &Mechanism,
    scale: f64,
    sin_mu: f64,
    roundings: f64,
) -> Option<Solver> {
    let allowed = allowance(roundings, sin_mu) * scale;
    // A misfit of the lengths by g parts a stretched dyad by the square root of 2 g or so.
    let stretched = sin_mu < (8.0 * roundings * U).sqrt();
    match Solver::new(mechanism) {
        Ok(solver) if stretched && begins_apart(&solver) => None,
        Ok(solver) => Some(solver),
        Err(Fault::Open { gap, .. }) if stretched && gap <= 8.0 * roundings * U * scale => None,
        Err(Fault::Vague { choices, .. })
            if stretched && (choices[0] - choices[1]).norm() <= allowed =>
        {
            None
        }
        Err(Fault::ChangePoint { .. }) if stretched => None,
        Err(fault) => panic!("{fault}: {fault:?}"),
    }
}

/// Whether the motion ends at the start, which lies beyond: in the numbers as they are typed the arms of a toggle are
/// apart by less than any of them rounds, and krank decides by those numbers.
fn begins_apart(solver: &Solver) -> bool {
    let start = solver.mechanism().driver().start;
    let Range::Limited { low, high } = solver.motion().range else {
        return false;
    };
    let end = (low - start).abs().min((high - start).abs());
    end < 1e-9 && solver.solve(start, Order::Position, &mut solver.state()) == Condition::NoAssembly
}

/// Solves at the angle of the planted pose; there must be a position.
pub(crate) fn at_start(solver: &Solver, mechanism: &Mechanism, order: Order) -> State {
    let mut state = solver.state();
    let condition = solver.solve(mechanism.driver().start, order, &mut state);
    assert_ne!(condition, Condition::NoAssembly, "the planted pose exists");
    state.into_state()
}

/// Checks that all that can be solved closes, once around.
pub(crate) fn closes(solver: &Solver, mechanism: &Mechanism, scale: f64) {
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
