//! Nearly folded triangles, away from the ends of the motion.

use crate::bounds::SplitMix;
use krank::quantity::{self, Aspect, Subject};
use krank::solver::{Condition, Order, Solver};
use krank::{Double, Driver, Input, Mechanism, PointId, Vec2};

const U: f64 = f64::EPSILON / 2.0;

/// Creates a triangle of two links on fixed pivots 5 apart, with an independent turning crank, and
/// returns the point where the links meet.
fn folded(coupler: f64, rocker: f64) -> (Mechanism, PointId) {
    let mut builder = Mechanism::builder();
    let (p, q) = (
        builder.ground_point(0.0, 3.0),
        builder.ground_point(4.0, 0.0),
    );
    let a = builder.ground_point(8.0, 0.0);
    let (c, x) = (builder.moving_point(), builder.moving_point());
    builder.link(p, c, coupler);
    builder.link(q, c, rocker);
    builder.start(c, Vec2::new(2.0, 2.5));
    let crank = builder.link(a, x, 1.0);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 30.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    (builder.build().unwrap(), c)
}

/// Returns the point where the links meet, on the left of the vector from pivot to pivot.
fn apex(coupler: f64, rocker: f64) -> Vec2<Double> {
    let [b, c, d] = [coupler, rocker, 5.0].map(Double::exactly);
    let square = Double::exactly(25.0);
    let factors = [b + c + d, b + c - d, d + c - b, d + b - c];
    let product = factors.into_iter().fold(Double::ONE, |p, f| p * f);
    let height = product.sqrt().scaled(0.5);
    let along = (square + b * b - c * c).scaled(0.5);
    let u = Vec2::new(4.0, -3.0).map(Double::exactly);
    let e = u * (along / square) + u.perp() * (height / square);
    Vec2::new(e.x, e.y + Double::exactly(3.0))
}

/// Links longer than the distance of their pivots by some ulps: plain doubles would give only half
/// of the height's digits.
#[test]
fn folded_triangles_are_accurate_to_16_u() {
    let mut rng = SplitMix::new(31);
    for power in 11..26 {
        for _ in 0..8 {
            let ulps = 10_f64.powf(0.3 * f64::from(power)).round();
            let coupler = (rng.within(1.0, 2.0) * 1024.0).round() / 1024.0;
            // The last bit of the rocker is one ulp of 5.
            let rocker = (5.0 - coupler) + ulps * 8.0 * U;
            let (mechanism, joint) = folded(coupler, rocker);
            let solver = Solver::new(&mechanism).unwrap();
            let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
            let condition = solver.solve(77.0, Order::Velocity, &mut state);
            assert_eq!(condition, Condition::Ok, "{coupler} {ulps}");
            solver.enclose(&mut state, Order::Velocity, &mut enclosure);
            let truth = apex(coupler, rocker);
            for (aspect, truth) in [(Aspect::X, truth.x), (Aspect::Y, truth.y)] {
                let subject = Subject::Point(joint);
                let value = quantity::value(subject, aspect, &state).unwrap();
                let off = (truth - Double::exactly(value)).hi.abs();
                assert!(
                    off <= 16.0 * U * 5.0,
                    "{coupler} {ulps} ulps: off by {off:e}"
                );
                let bound = quantity::bound(subject, aspect, &state, &enclosure);
                assert!(bound.is_none_or(|bound| off <= bound), "{off:e} {bound:?}");
            }
        }
    }
}
