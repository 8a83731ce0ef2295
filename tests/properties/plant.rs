//! Generates known poses, and the tolerances for a solver that recovers them.

use crate::support::{U, closure_error};
use krank::solver::{Condition, Fault, Order, Range, Solver, State};
use krank::{Builder, Driver, Input, Mechanism, PointId, Vec2};
use proptest::prelude::*;
use std::ops::RangeInclusive;

/// Rounding errors of measuring and solving a pose, in u L: about five of each, with a safety
/// factor.
pub(crate) const ROUNDINGS: f64 = 32.0;

/// Returns the unit vector at an angle, by the platform's functions.
pub(crate) fn unit(degrees: f64) -> Vec2 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec2::new(cos, sin)
}

/// Generates lengths over two decades, with uniform logarithms.
pub(crate) fn length() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

pub(crate) fn angle() -> impl Strategy<Value = f64> {
    0.0..360.0_f64
}

pub(crate) fn sign() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// Generates numbers with magnitudes from 1 down to 1e-15.
pub(crate) fn tiny() -> impl Strategy<Value = f64> {
    (-15.0..0.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent))
}

/// Generates angles between two guides in degrees, sometimes so small that the rounding of sums of
/// angles becomes visible.
pub(crate) fn crossing() -> impl Strategy<Value = f64> {
    let small = (-8.0..1.0_f64, sign()).prop_map(|(exponent, sign)| sign * 10.0_f64.powf(exponent));
    prop_oneof![2 => 5.0..175.0_f64, 1 => small]
}

/// Generates offsets of lengths: mostly none, at most 32 ulp.
pub(crate) fn ulps() -> impl Strategy<Value = i64> {
    const FAR: RangeInclusive<i64> = -32..=32;
    prop_oneof![2 => Just(0), 1 => FAR]
}

pub(crate) fn nudged(length: f64, ulps: i64) -> f64 {
    f64::from_bits(length.to_bits().wrapping_add_signed(ulps))
}

/// The position of a dyad's inner joint relative to its outer joints: along and across their line,
/// in units of their distance.
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

/// Generates inner joints away from a toggle.
pub(crate) fn open_apex() -> impl Strategy<Value = Apex> {
    (-1.0..2.0_f64, 0.2..2.0_f64, sign()).prop_map(|(along, across, sign)| Apex {
        along,
        across: sign * across,
    })
}

/// Generates inner joints anywhere, with toggles and equal sides over-represented.
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

/// A crank AB about the origin, at `angle`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crank {
    pub(crate) length: f64,
    pub(crate) angle: f64,
}

impl Crank {
    pub(crate) fn pin(self) -> Vec2 {
        unit(self.angle) * self.length
    }

    /// Builds the crank as the driver, at one radian per second.
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

/// Returns the sine of the angle between two directions.
pub(crate) fn sine(a: Vec2, b: Vec2) -> f64 {
    a.cross(b).abs() / (a.norm() * b.norm())
}

/// Returns the maximum distance of a joint from its known position, in units of the longest length.
///
/// A length error of g changes the square of the joint's height by 2 g. The height itself then changes by
/// g / sin mu in first order, and by up to twice as much if it is lost completely.
pub(crate) fn allowance(roundings: f64, sin_mu: f64) -> f64 {
    let error = 2.0 * roundings * U;
    let left = (sin_mu * sin_mu - error).max(0.0).sqrt();
    error / (sin_mu.max(error.sqrt()) + left)
}

/// Opens a mechanism with a known pose. Returns `None` where rounding has pulled a toggle apart or
/// left it exactly extended, where both assemblies coincide and no start can choose. `roundings` is
/// in units of the dyad's shortest length.
pub(crate) fn open(
    mechanism: &Mechanism,
    scale: f64,
    sin_mu: f64,
    roundings: f64,
) -> Option<Solver> {
    // Each assembly is at most half as far from the position in which the arms are in line.
    let apart = 2.0 * (sin_mu + allowance(roundings, sin_mu)) * scale;
    // A length error of g separates an extended dyad by about the square root of 2 g.
    let stretched = sin_mu < (8.0 * roundings * U).sqrt();
    match Solver::new(mechanism) {
        Ok(solver) if stretched && ends_at_start(&solver) => None,
        Ok(solver) => Some(solver),
        Err(Fault::Open { gap, .. }) if stretched && gap <= 8.0 * roundings * U * scale => None,
        Err(Fault::Vague { choices, .. })
            if stretched && (choices[0] - choices[1]).norm() <= apart =>
        {
            None
        }
        Err(Fault::ChangePoint { .. }) if stretched => None,
        Err(fault) => panic!("{fault}: {fault:?}"),
    }
}

/// Returns `true` if the motion ends next to the start, which lies beyond: in the rounded numbers,
/// the arms of a toggle miss each other by less than a rounding error, and krank decides by those
/// numbers.
fn ends_at_start(solver: &Solver) -> bool {
    let start = solver.mechanism().driver().start;
    let Range::Limited { low, high } = solver.motion().range else {
        return false;
    };
    let end = (low - start).abs().min((high - start).abs());
    end < 1e-9 && solver.solve(start, Order::Position, &mut solver.state()) == Condition::NoAssembly
}

/// Solves at the angle of the known pose, where a position must exist.
pub(crate) fn at_start(solver: &Solver, mechanism: &Mechanism, order: Order) -> State {
    let mut state = solver.state();
    let condition = solver.solve(mechanism.driver().start, order, &mut state);
    assert_ne!(condition, Condition::NoAssembly, "the planted pose exists");
    state.into_state()
}

/// Checks that all solvable positions of a full turn close.
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
