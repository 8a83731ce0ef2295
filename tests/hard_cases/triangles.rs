//! Triangles of two links and the line between their feet: needles, and triangles with integer
//! sides.

use crate::exact::DoubleDouble;
use crate::rig::{Triangle, U, condition, exact, solved};
use krank::Vec2;
use krank::solver::{Condition, Fault, Order};

/// The needles of Kahan's paper with their exact areas, and a last, equally thin one. Doubles
/// cannot decide whether the last two are triangles at all.
const NEEDLES: [([f64; 3], &str); 6] = [
    (
        [100_000.0, 99_999.999_79, 0.000_29],
        "10.0000000770210383233",
    ),
    ([100_000.0, 100_000.0, 1.000_05], "50002.49999937491152109"),
    (
        [99_999.999_96, 99_999.999_94, 3e-5],
        "1.118033685395200594927",
    ),
    (
        [10_000.0, 5_000.000_001, 15_000.0],
        "612.3725393762839798798",
    ),
    ([1.0, 1.0, f64::EPSILON], "1.110223024625156540424e-16"),
    (
        [1.0, 1.0 - f64::EPSILON, 2.0 * f64::EPSILON],
        "1.922962686383563714311e-16",
    ),
];

/// Returns the approximate position of the apex, sufficient to distinguish the sides.
fn apex(base: f64, left: f64, right: f64, height: f64) -> Vec2 {
    let along = 0.5 * (base + (left - right) * (left + right) / base);
    Vec2::new(along, height)
}

#[test]
fn h07_needle_triangles_have_exact_height() {
    for ([p, q, r], area) in NEEDLES {
        for [base, left, right] in [
            [p, q, r],
            [p, r, q],
            [q, p, r],
            [q, r, p],
            [r, p, q],
            [r, q, p],
        ] {
            let height = exact(area) * DoubleDouble::from(2.0) / DoubleDouble::from(base);
            for side in [1.0, -1.0] {
                let near = apex(base, left, right, side * height.hi);
                let triangle = Triangle::open(base, left, right, near).expect("a triangle");
                let found = side
                    * solved(&triangle.solver, base)
                        .position(triangle.apex)
                        .unwrap()
                        .y;
                // 4 ulp of the area; 1 ulp is at most 2 u.
                let off = height.minus(found).abs() / (2.0 * U * height.hi);
                assert!(off <= 4.0, "{base} {left} {right}: {found:e}, {off} ulp");
            }
        }
    }
}

#[test]
fn h07_triangle_without_area_is_dead_point() {
    // The case's own sides, 1 and 1 - u, are equal by the rule of 4 u: their feet may meet, and the
    // motion continues there like a kite's. Sides that are not equal by any rule form a line.
    let (left, right, base) = (1.0, 0.75, 0.25);
    let near = apex(0.5, left, right, 1.0);
    let triangle = Triangle::open(0.5, left, right, near).expect("a triangle");
    assert_eq!(condition(&triangle.solver, base), Condition::DeadPoint);
    let mut state = triangle.solver.state();
    let _ = triangle.solver.solve(base, Order::Position, &mut state);
    assert_eq!(state.position(triangle.apex).unwrap(), Vec2::new(1.0, 0.0));
}

/// The case's own values: 1 = 0.9999999999999999 + 1.1102230246251565e-16 exactly. Its two
/// assemblies coincide at height 0, and no start distinguishes them.
#[test]
fn h07_needle_without_area_is_vague() {
    let (long, less, sliver) = (1.0, 1.0 - U, U);
    for [base, left, right] in [
        [long, less, sliver],
        [long, sliver, less],
        [less, long, sliver],
        [less, sliver, long],
    ] {
        match Triangle::open(base, left, right, apex(base, left, right, 1.0)).err() {
            Some(Fault::Vague { choices, .. }) => {
                assert!(choices.iter().all(|c| c.y == 0.0), "{choices:?}");
            }
            other => panic!("{base} {left} {right}: {other:?}"),
        }
    }
}

#[test]
fn h07_triangle_on_tiny_base_keeps_its_sides() {
    let triangle = Triangle::open(1.0, 1.0, 1.0, Vec2::new(0.5, 0.8)).expect("a triangle");
    let mut state = triangle.solver.state();
    for base in [f64::EPSILON, 1e-17, 1e-100, 1e-160, 1e-300] {
        let condition = triangle.solver.solve(base, Order::Position, &mut state);
        assert_ne!(condition, Condition::NoAssembly, "{base:e}");
        let c = state.position(triangle.apex).unwrap();
        let sides = [c.norm(), (c - Vec2::new(base, 0.0)).norm()];
        let off = sides.map(|side| (side - 1.0).abs());
        assert!(off[0].max(off[1]) <= 4.0 * U, "{base:e}: {sides:?}");
    }
}

#[test]
fn h25_integer_triangles_are_exact() {
    for (base, side, apex) in [(8.0, 5.0, (4.0, 3.0)), (10.0, 13.0, (5.0, 12.0))] {
        for sign in [1.0, -1.0] {
            let expected = Vec2::new(apex.0, sign * apex.1);
            let near = Vec2::new(1.0, sign);
            let triangle = Triangle::open(base, side, side, near).expect("a triangle");
            let found = solved(&triangle.solver, base)
                .position(triangle.apex)
                .unwrap();
            assert_eq!(found, expected);
        }
    }
}

/// A base that is one double too long leaves the sides open, by less than any rounding error, and
/// the fault reports the gap.
#[test]
fn base_one_ulp_too_long_is_open() {
    let open = |base: f64| Triangle::open(base, 80.0, 120.0, apex(base, 80.0, 120.0, 1e-6));
    let ulp = 200.0_f64.next_up() - 200.0;
    match open(200.0 + ulp).err() {
        Some(Fault::Open { gap, .. }) => assert_eq!(gap, ulp),
        other => panic!("{other:?}"),
    }
    let high = open(200.0 - ulp).expect("a triangle").solver.motion().range;
    assert_eq!(high.ends().1, 200.0);
}
