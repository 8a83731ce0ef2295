//! Equality of lengths decides between a change point, a near miss and a dead point. It is
//! determined from the typed decimals, for any position and orientation of the linkage.

use krank::solver::{Range, Solver};
use krank::{Builder, Double, Driver, Input, Vec2};

/// Opens a four-bar with its frame of length `d` at `position`, rotated, with decimals of at most 15
/// digits.
fn four_bar(lengths: [&str; 4], position: Vec2, turn: f64, start: f64) -> Solver {
    let [a, b, c, d] = lengths.map(|length| length.parse().unwrap());
    let far = position.exactly() + Double::unit(turn) * Double::exactly(d);
    let mut m = Builder::default();
    m.decimals();
    let pivot = m.ground_point(typed(position.x), typed(position.y));
    let other = m.ground_point(typed(far.x.hi), typed(far.y.hi));
    let (pin, joint) = (m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, a);
    m.link(pin, joint, b);
    m.link(joint, other, c);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: start + turn,
        speed: 1.0,
        acceleration: 0.0,
    });
    // The corner of a parallelogram, or close to it.
    m.start(joint, far.nearest() + krank::angle::unit(start + turn) * a);
    Solver::new(&m.build().unwrap()).unwrap()
}

/// Rounds to 15 digits, as read off a drawing.
fn typed(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap()
}

#[test]
fn rotated_parallelogram_of_typed_decimals_is_recognised() {
    for sizes in [
        ["1", "3"],
        ["30", "40"],
        ["25", "30"],
        ["100", "150"],
        ["0.7", "0.3"],
    ] {
        let [a, g] = sizes;
        for turn in [0.0, 23.0, 71.0, 90.0, 137.7] {
            for position in [Vec2::ZERO, Vec2::new(12.5, -8.25), Vec2::new(1e3, -2e3)] {
                let solver = four_bar([a, g, a, g], position, turn, 60.0);
                let motion = solver.motion();
                assert_eq!(
                    motion.range,
                    Range::Full { period: 360.0 },
                    "{sizes:?} {turn} {position:?}"
                );
                assert_eq!(
                    motion.change_points.len(),
                    2,
                    "{sizes:?} {turn} {position:?}"
                );
                assert!(
                    motion.near_misses.is_empty(),
                    "{sizes:?} {turn} {position:?}"
                );
            }
        }
    }
}

#[test]
fn length_that_differs_in_last_digit_is_not_equal() {
    for position in [Vec2::ZERO, Vec2::new(1e6, 0.0), Vec2::new(-3.0, 1e6)] {
        for turn in [0.0, 90.0, 180.0] {
            for longer in ["1.000000001", "1.000000000001", "1.00000000000001"] {
                let solver = four_bar(["1", "3", longer, "3"], position, turn, 60.0);
                let motion = solver.motion();
                assert_eq!(motion.tolerance, 0.0);
                assert_eq!(
                    motion.range,
                    Range::Full { period: 360.0 },
                    "{longer} {position:?} {turn}"
                );
                assert!(
                    motion.change_points.is_empty(),
                    "{longer} {position:?} {turn}"
                );
                assert_eq!(motion.near_misses.len(), 2, "{longer} {position:?} {turn}");
            }
            for shorter in ["0.999999999", "0.999999999999", "0.99999999999999"] {
                let solver = four_bar(["1", "3", shorter, "3"], position, turn, 60.0);
                let motion = solver.motion();
                assert_eq!(motion.dead_points.len(), 2, "{shorter} {position:?} {turn}");
                // The motion ends where the pivots are 2 + e apart, 10 - 6 cos = (2 + e)^2, and
                // where they are 4 - e apart.
                let e = 1.0 - shorter.parse::<f64>().unwrap();
                let from = |share: f64| 2.0 * share.sqrt().asin().to_degrees();
                let [near, far] = [4.0 * e + e * e, 8.0 * e - e * e].map(|v| from(v / 12.0));
                for (found, expected) in motion.dead_points.iter().zip([near, 180.0 - far]) {
                    let off = found - turn - expected;
                    assert!(
                        off.abs() < 1e-2 * near,
                        "{off:e} {near:e}: {shorter} {position:?} {turn}"
                    );
                }
                assert!(
                    motion.change_points.is_empty(),
                    "{shorter} {position:?} {turn}"
                );
                assert!(
                    motion.near_misses.is_empty(),
                    "{shorter} {position:?} {turn}: {:?}",
                    motion.near_misses
                );
            }
        }
    }
}

/// 0.1 + 0.4 = 0.2 + 0.3 holds for the decimals, but not for their nearest doubles.
#[test]
fn equal_sums_of_typed_decimals_give_change_points() {
    let solver = four_bar(["0.1", "0.2", "0.3", "0.4"], Vec2::ZERO, 0.0, 60.0);
    let motion = solver.motion();
    // The assemblies change where all links are collinear, once per turn.
    assert_eq!(motion.range, Range::Full { period: 720.0 });
    assert_eq!(motion.change_points, [180.0, 540.0]);
    assert!(motion.near_misses.is_empty());
}
