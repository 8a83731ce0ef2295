//! Random cases of the same kinds as the numbered ones.

use crate::bits::bits;
use crate::closed_form::{self, Exact};
use crate::exact::DoubleDouble;
use crate::rig::{FourBar, LECTURE, Opened, U};
use krank::solver::{Condition, Order, Range, State};
use krank::{Vec2, angle};
use proptest::prelude::*;

/// The sine of 3 degrees: nearer to a dead point, other tests construct poses instead of computing
/// them.
const OPEN_ENOUGH: f64 = 0.05;

/// Draws a length from two decades around 1, logarithmically uniform.
fn length() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

fn side() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// Draws an angle in degrees, often a round one.
fn degrees() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => 0.0..360.0_f64,
        1 => (0..24_i32).prop_map(|k| 15.0 * f64::from(k)),
    ]
}

/// Draws a share of a length range, between nearly folded and nearly stretched.
fn share() -> impl Strategy<Value = f64> {
    0.001..0.999_f64
}

/// Chooses a rocker length between those at which the dyad would be folded and stretched at the
/// start; returns the four-bar and its exact values there.
fn closing(of: FourBar, share: f64) -> Option<(FourBar, Exact)> {
    let b = angle::unit(of.start) * of.crank;
    let base = (Vec2::new(of.ground, 0.0) - b).norm();
    let rocker = (base - of.coupler).abs() + share * 2.0 * base.min(of.coupler);
    let of = FourBar { rocker, ..of };
    let exact = closed_form::solve(&of, of.start)?;
    (exact.sin_mu >= OPEN_ENOUGH).then_some((of, exact))
}

/// Draws a four-bar with this crank, and with a coupler and a ground from two decades.
fn drawn(crank: impl Strategy<Value = f64>) -> impl Strategy<Value = (FourBar, Exact)> {
    (crank, [length(), length()], degrees(), side(), share()).prop_filter_map(
        "all but stretched",
        |(crank, [coupler, ground], start, side, share)| {
            let of = FourBar {
                crank,
                coupler,
                ground,
                side,
                start,
                speed: 1.0,
                ..LECTURE
            };
            closing(of, share)
        },
    )
}

fn ordinary() -> impl Strategy<Value = (FourBar, Exact)> {
    drawn(length())
}

/// Draws a four-bar with a crank down to 1e-13 of the other lengths.
fn tiny_crank() -> impl Strategy<Value = (FourBar, Exact)> {
    drawn((-12.0..-1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent)))
}

/// Draws a four-bar with a crank and a ground up to 1e8 times as long as coupler and rocker, at a
/// small angle.
fn huge_crank() -> impl Strategy<Value = (FourBar, Exact)> {
    let crank = (1.0..7.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent));
    let distance = [-2.0..2.0_f64, -2.0..2.0_f64];
    (crank, length(), distance, side(), share()).prop_filter_map(
        "all but stretched",
        |(crank, coupler, [along, across], side, share)| {
            let of = FourBar {
                crank,
                coupler,
                ground: crank + along * coupler,
                side,
                start: (across * coupler / crank).to_degrees(),
                speed: 1.0,
                ..LECTURE
            };
            closing(of, share)
        },
    )
}

fn off(exact: DoubleDouble, by: f64, found: f64) -> f64 {
    (exact * DoubleDouble::from(by)).minus(found).abs()
}

/// Compares a state of the four-bar, scaled by `size`, with the exact values.
///
/// The allowed error of C is some u of the longest length L, divided by sin(mu). With a coupler or
/// rocker of length m, this is u L/m in its direction, and once more divided by sin(mu) in the
/// rates. The rates are of the size of the crank divided by m, or larger.
fn assert_agrees(opened: &Opened, state: &State, size: f64, exact: &Exact) {
    let of = opened.of;
    let (longest, shortest) = (of.longest(), of.coupler.min(of.rocker));
    let position = state.position(opened.joint).unwrap() - of.origin;
    let slack = 4.0 * U * longest / exact.sin_mu;
    for (found, exact) in [position.x, position.y].into_iter().zip(exact.joint) {
        let off = off(exact, size, found);
        assert!(off <= slack, "C: {} of the slack, {of:?}", off / slack);
    }
    let rate = exact.omega.iter().map(|w| w.hi.abs());
    let rate = rate.fold(of.crank / shortest, f64::max);
    let slack = 7.0 * U * rate * (longest / shortest) / exact.sin_mu.powi(2);
    let links = [opened.coupler, opened.rocker];
    for (link, exact) in links.into_iter().zip(exact.omega) {
        let off = off(exact, 1.0, state.omega(link).unwrap());
        assert!(off <= slack, "omega: {} of the slack, {of:?}", off / slack);
    }
}

proptest! {
    /// Like case H08.
    #[test]
    fn tiny_cranks_have_accurate_rates((of, exact) in tiny_crank()) {
        let opened = of.open();
        assert_agrees(&opened, &opened.at(of.start), 1.0, &exact);
    }

    /// Like case H08.
    #[test]
    fn huge_cranks_are_accurate_to_coordinate_rounding((of, exact) in huge_crank()) {
        let opened = of.open();
        assert_agrees(&opened, &opened.at(of.start), 1.0, &exact);
    }

    /// Like case H09.
    #[test]
    fn scaling_by_power_of_ten_stays_accurate((of, exact) in ordinary(), power in -290..290_i32) {
        let size = 10.0_f64.powi(power);
        let opened = of.scaled(size).open();
        assert_agrees(&opened, &opened.at(of.start), size, &exact);
    }

    /// Like case H09.
    #[test]
    fn scaling_by_power_of_two_is_exact((of, _) in ordinary(), power in -950..950_i32) {
        let size = 2.0_f64.powi(power);
        let (plain, scaled) = (of.open(), of.scaled(size).open());
        prop_assert_eq!(plain.solver.motion().range, scaled.solver.motion().range);
        let one = bits(&plain.mechanism, &plain.at(of.start), 1.0);
        prop_assert_eq!(one, bits(&scaled.mechanism, &scaled.at(of.start), size));
    }

    /// Like case H10: the ground's own coordinates are rounded, the motion relative to it is not.
    #[test]
    fn distant_ground_changes_only_its_own_rounding(
        (of, _) in ordinary(),
        place in (-1e12..1e12_f64, -1e12..1e12_f64),
        fine in 0..40_i32,
    ) {
        let origin = Vec2::new(place.0, place.1) / 2.0_f64.powi(fine);
        // The ground's length after rounding, used for both.
        let ground = (origin.x + of.ground) - origin.x;
        let rounded = FourBar { ground, ..of };
        let Some(exact) = closed_form::solve(&rounded, of.start) else { return Ok(()) };
        prop_assume!(ground > 0.0 && exact.sin_mu >= OPEN_ENOUGH);
        let here = rounded.open();
        let there = FourBar { origin, ..rounded }.open();
        let (a, b) = (here.at(of.start), there.at(of.start));
        assert_agrees(&here, &a, 1.0, &exact);
        for link in [here.coupler, here.rocker] {
            prop_assert_eq!(a.direction(link).unwrap(), b.direction(link).unwrap());
            prop_assert_eq!(a.omega(link).unwrap(), b.omega(link).unwrap());
            prop_assert_eq!(a.alpha(link).unwrap(), b.alpha(link).unwrap());
        }
        for point in [here.pin, here.joint] {
            prop_assert_eq!(a.velocity(point).unwrap(), b.velocity(point).unwrap());
            prop_assert_eq!(a.position(point).unwrap() + origin, b.position(point).unwrap());
        }
    }

    /// Like case H29.
    #[test]
    fn jumps_and_reversed_sweeps_give_the_same_bits(
        (of, _) in ordinary(),
        jumps in prop::collection::vec(-720.0..720.0_f64, 1..8),
        step in 0.5..90.0_f64,
    ) {
        let opened = of.open();
        let figures = |state: &State| (state.condition(), bits(&opened.mechanism, state, 1.0));
        let fresh = |at: f64| {
            let mut state = opened.solver.state();
            let _ = opened.solver.solve(at, Order::Acceleration, &mut state);
            figures(&state)
        };
        let up: Vec<f64> = (0..8).map(|k| of.start + step * f64::from(k)).collect();
        let down = up.iter().rev();
        let mut state = opened.solver.state();
        for &at in up.iter().chain(down).chain(&jumps) {
            let condition = opened.solver.solve(at, Order::Acceleration, &mut state);
            // Values are compared only if there are any.
            if condition == Condition::Ok {
                prop_assert_eq!(figures(&state), fresh(at), "at {}", at);
            } else {
                prop_assert_eq!(condition, fresh(at).0, "at {}", at);
            }
        }
    }

    /// Like case H27.
    #[test]
    fn a_turn_later_the_bits_are_the_same((of, _) in ordinary(), turns in -1_000_000_000..1_000_000_000_i64) {
        let opened = of.open();
        // A start in eighths of a degree and whole turns add up exactly.
        let at = (of.start * 8.0).round() / 8.0;
        if let Range::Full { period } = opened.solver.motion().range {
            let later = opened.at(at + period * turns as f64);
            prop_assert_eq!(
                bits(&opened.mechanism, &opened.at(at), 1.0),
                bits(&opened.mechanism, &later, 1.0)
            );
        }
    }
}
