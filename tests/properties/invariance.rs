//! Tests the invariance of states under scaling, translation, history and demand.

use crate::bits::bits;
use crate::four_bar::{FourBar, crank_rocker, pose, round_pose};
use crate::plant::*;
use crate::support::U;
use krank::solver::{Condition, Demand, Order, Range, Solver};
use krank::{Body, Mechanism, Vec2};
use proptest::prelude::*;

/// Generates coordinates at which two solvers or histories are compared.
pub(crate) fn places() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-720.0..720.0_f64, 1..6)
}

proptest! {
    #[test]
    fn scaling_by_powers_of_two_changes_no_bit(pose in round_pose(), power in -40..40_i32, coordinates in places()) {
        let factor = 2.0_f64.powi(power);
        let (near, far) = (pose.build(Vec2::ZERO, 1.0), pose.build(Vec2::ZERO, factor));
        let Some(one) = pose.open(&near.mechanism) else { return Ok(()) };
        let other = Solver::new(&far.mechanism).expect("the same mechanism in another size");
        prop_assert_eq!(one.motion().range, other.motion().range);
        let (mut a, mut b) = (one.state(), other.state());
        for at in coordinates {
            let condition = one.solve(at, Order::Acceleration, &mut a);
            prop_assert_eq!(condition, other.solve(at, Order::Acceleration, &mut b));
            if condition == Condition::Ok {
                prop_assert_eq!(bits(&near.mechanism, &a, 1.0), bits(&far.mechanism, &b, factor));
            }
        }
    }

    #[test]
    fn translation_far_from_origin_loses_no_digits(
        pose in round_pose(),
        shift in (-100_000_000..100_000_000_i32, -100_000_000..100_000_000_i32),
        coordinates in places(),
    ) {
        let shift = Vec2::new(f64::from(shift.0), f64::from(shift.1));
        let (here, there) = (pose.build(Vec2::ZERO, 1.0), pose.build(shift, 1.0));
        let scale = pose.scale();
        let Some(one) = pose.open(&here.mechanism) else { return Ok(()) };
        let other = Solver::new(&there.mechanism).expect("the same mechanism elsewhere");
        let (mut a, mut b) = (one.state(), other.state());
        for at in coordinates {
            let condition = one.solve(at, Order::Acceleration, &mut a);
            prop_assert_eq!(condition, other.solve(at, Order::Acceleration, &mut b));
            if condition != Condition::Ok {
                continue;
            }
            for id in here.mechanism.link_ids() {
                prop_assert_eq!(a.direction(id).unwrap(), b.direction(id).unwrap());
                prop_assert_eq!(a.omega(id).unwrap().to_bits(), b.omega(id).unwrap().to_bits());
                prop_assert_eq!(a.alpha(id).unwrap().to_bits(), b.alpha(id).unwrap().to_bits());
            }
            let moved = a.position(here.joint).unwrap() + shift;
            let off = b.position(there.joint).unwrap() - moved;
            let ulp = U * (shift.norm() + scale);
            prop_assert!(off.x.abs() <= 2.0 * ulp && off.y.abs() <= 2.0 * ulp, "{off:?}");
        }
    }

    #[test]
    fn state_does_not_depend_on_path(pose in pose(apex()), at in -720.0..720.0_f64, steps in 1..40_i32) {
        let FourBar { mechanism, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let mut jumped = solver.state();
        let condition = solver.solve(at, Order::Acceleration, &mut jumped);
        let mut stepped = solver.state();
        let start = mechanism.driver().start;
        for k in 0..steps {
            let way = start + (at - start) * f64::from(k) / f64::from(steps);
            let _ = solver.solve(way, Order::Acceleration, &mut stepped);
        }
        prop_assert_eq!(solver.solve(at, Order::Acceleration, &mut stepped), condition);
        if matches!(condition, Condition::Ok | Condition::ChangePoint) {
            prop_assert_eq!(bits(&mechanism, &jumped, 1.0), bits(&mechanism, &stepped, 1.0));
        }
    }

    #[test]
    fn state_repeats_bit_for_bit_after_full_turns(pose in crank_rocker(), at in -1024..1024_i32, turns in -1_000_000..1_000_000_i32) {
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
    fn reduced_demand_changes_no_bit(pose in crank_rocker(), at in angle()) {
        let FourBar { mechanism, joint, rocker, .. } = pose.build(Vec2::ZERO, 1.0);
        let Some(solver) = pose.open(&mechanism) else { return Ok(()) };
        let mut full = solver.state();
        let condition = solver.solve(at, Order::Acceleration, &mut full);
        prop_assert_eq!(condition, Condition::Ok);
        let mut positions = solver.state();
        prop_assert_eq!(solver.solve(at, Order::Position, &mut positions), condition);
        prop_assert_eq!(full.position(joint).unwrap(), positions.position(joint).unwrap());
        let demand = Demand { points: vec![joint], links: vec![rocker], ..Demand::default() };
        let pruned = solver.only(&demand);
        let mut wanted = pruned.state();
        prop_assert_eq!(pruned.solve(at, Order::Acceleration, &mut wanted), condition);
        prop_assert_eq!(full.position(joint).unwrap(), wanted.position(joint).unwrap());
        prop_assert_eq!(full.velocity(joint).unwrap(), wanted.velocity(joint).unwrap());
        prop_assert_eq!(full.acceleration(joint).unwrap(), wanted.acceleration(joint).unwrap());
        prop_assert_eq!(full.omega(rocker).unwrap().to_bits(), wanted.omega(rocker).unwrap().to_bits());
        prop_assert_eq!(full.alpha(rocker).unwrap().to_bits(), wanted.alpha(rocker).unwrap().to_bits());
    }

    /// Hard case H28: accelerations are linear in the driver's acceleration, at a standstill too.
    #[test]
    fn h28_accelerations_exist_at_standstill(pose in pose(open_apex()), acceleration in -100.0..100.0_f64) {
        let turning = pose.driven(Vec2::ZERO, 1.0, 1.0, 0.0);
        let starting = pose.driven(Vec2::ZERO, 1.0, 0.0, acceleration);
        let Some(one) = pose.open(&turning.mechanism) else { return Ok(()) };
        let other = Solver::new(&starting.mechanism).expect("the same mechanism");
        let a = at_start(&one, &turning.mechanism, Order::Acceleration);
        let b = at_start(&other, &starting.mechanism, Order::Acceleration);
        prop_assert_eq!(a.condition(), Condition::Ok);
        for link in [turning.coupler, turning.rocker] {
            prop_assert_eq!(b.omega(link).unwrap(), 0.0);
            // At a standstill, alpha is the first-order coefficient (here omega) times the
            // acceleration.
            let expected = a.omega(link).unwrap() * acceleration;
            let off = (b.alpha(link).unwrap() - expected).abs();
            prop_assert!(off <= 4.0 * U * expected.abs(), "{off:e}");
        }
    }
}

/// A demand may consist of a single slide.
#[test]
fn slide_alone_can_be_demanded() {
    let mut builder = Mechanism::builder();
    let crank = Crank {
        length: 1.0,
        angle: 30.0,
    };
    let pin = crank.build(&mut builder);
    let joint = builder.moving_point();
    builder.link(pin, joint, 2.0);
    let slide = builder.pin_in_slot(joint, Body::Ground, Vec2::ZERO, 0.0);
    builder.start(joint, Vec2::new(2.8, 0.0));
    let mechanism = builder.build().expect("a sound slider-crank");
    let solver = Solver::new(&mechanism).expect("it closes");
    let demand = Demand {
        slides: vec![slide],
        ..Demand::default()
    };
    let pruned = solver.only(&demand);
    let mut state = pruned.state();
    let _ = pruned.solve(30.0, Order::Position, &mut state);
    let expected = 0.75_f64.sqrt() + 3.75_f64.sqrt();
    assert!((state.travel(slide).unwrap().position - expected).abs() <= 20.0 * U);
}
