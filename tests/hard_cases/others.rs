//! Other cases of the same kinds as the numbered ones, drawn at random.

use crate::bits::bits;
use crate::closed_form::{self, Exact};
use crate::exact::DoubleDouble;
use crate::rig::{FourBar, LECTURE, Opened, U};
use krank::solver::{Condition, Order, Range, State};
use krank::{Vec2, angle};
use proptest::prelude::*;

/// The sine of 3 degrees: nearer to a dead point poses are planted, not computed.
const OPEN_ENOUGH: f64 = 0.05;

/// Two decades around 1, evenly.
fn length() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

fn side() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// Degrees that are often round.
fn degrees() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => 0.0..360.0_f64,
        1 => (0..24_i32).prop_map(|k| 15.0 * f64::from(k)),
    ]
}

/// Of a length: between all but folded and all but stretched.
fn share() -> impl Strategy<Value = f64> {
    0.001..0.999_f64
}

/// A four-bar whose rocker is between the lengths at which the dyad would be folded and stretched at
/// the start, and its exact values there.
fn closing(of: FourBar, share: f64) -> Option<(FourBar, Exact)> {
    let b = angle::unit(of.start) * of.crank;
    let base = (Vec2::new(of.ground, 0.0) - b).norm();
    let rocker = (base - of.coupler).abs() + share * 2.0 * base.min(of.coupler);
    let of = FourBar { rocker, ..of };
    let exact = closed_form::solve(&of, of.start)?;
    (exact.sin_mu >= OPEN_ENOUGH).then_some((of, exact))
}

/// A four-bar with this crank, a coupler and a ground over two decades.
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

/// A crank down to 1e-13 of the other lengths.
fn tiny_crank() -> impl Strategy<Value = (FourBar, Exact)> {
    drawn((-12.0..-1.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent)))
}

/// A crank and a ground up to 1e8 times as long as coupler and rocker, at a small angle.
fn huge_crank() -> impl Strategy<Value = (FourBar, Exact)> {
    let crank = (1.0..7.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent));
    let apart = [-2.0..2.0_f64, -2.0..2.0_f64];
    (crank, length(), apart, side(), share()).prop_filter_map(
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

/// Holds a state of the four-bar, scaled by `size`, against the exact values.
///
/// C may be off by some u of the longest length L over sin(mu). With a coupler or rocker of length m
/// that is u L/m of its direction, and of the rates over sin(mu) once more; these are of the size of
/// the crank over m, or larger.
fn assert_agrees(opened: &Opened, state: &State, size: f64, exact: &Exact) {
    let of = opened.of;
    let (longest, shortest) = (of.longest(), of.coupler.min(of.rocker));
    let place = state.position(opened.joint).unwrap() - of.origin;
    let slack = 4.0 * U * longest / exact.sin_mu;
    for (found, exact) in [place.x, place.y].into_iter().zip(exact.joint) {
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
    /// As H08.
    #[test]
    fn tiny_cranks_have_accurate_rates((of, exact) in tiny_crank()) {
        let opened = of.open();
        assert_agrees(&opened, &opened.at(of.start), 1.0, &exact);
    }

    /// As H08.
    #[test]
    fn huge_cranks_keep_what_their_coordinates_leave((of, exact) in huge_crank()) {
        let opened = of.open();
        assert_agrees(&opened, &opened.at(of.start), 1.0, &exact);
    }

    /// As H09.
    #[test]
    fn a_power_of_ten_costs_the_rounding_of_the_lengths((of, exact) in ordinary(), power in -290..290_i32) {
        let size = 10.0_f64.powi(power);
        let opened = of.scaled(size).open();
        assert_agrees(&opened, &opened.at(of.start), size, &exact);
    }

    /// As H09.
    #[test]
    fn a_power_of_two_costs_nothing((of, _) in ordinary(), power in -950..950_i32) {
        let size = 2.0_f64.powi(power);
        let (plain, scaled) = (of.open(), of.scaled(size).open());
        prop_assert_eq!(plain.solver.motion().range, scaled.solver.motion().range);
        let one = bits(&plain.mechanism, &plain.at(of.start), 1.0);
        prop_assert_eq!(one, bits(&scaled.mechanism, &scaled.at(of.start), size));
    }

    /// As H10: the ground's own coordinates are rounded, the motion on it is not.
    #[test]
    fn a_far_ground_costs_what_it_is_rounded_by(
        (of, _) in ordinary(),
        place in (-1e12..1e12_f64, -1e12..1e12_f64),
        fine in 0..40_i32,
    ) {
        let origin = Vec2::new(place.0, place.1) / 2.0_f64.powi(fine);
        // The distance that is left of the ground after rounding, on both.
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

    /// As H29.
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
            // Where there are no values, none are compared.
            if condition == Condition::Ok {
                prop_assert_eq!(figures(&state), fresh(at), "at {}", at);
            } else {
                prop_assert_eq!(condition, fresh(at).0, "at {}", at);
            }
        }
    }

    /// As H27.
    #[test]
    fn a_turn_later_the_bits_are_the_same((of, _) in ordinary(), turns in -1_000_000_000..1_000_000_000_i64) {
        let opened = of.open();
        // A start of eighths of a degree and whole turns add up exactly.
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
