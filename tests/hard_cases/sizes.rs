//! Sizes: links of very different lengths, everything tiny or huge, a ground far away.

use crate::bits::bits;
use crate::exact::{DoubleDouble, PI};
use crate::rig::{FourBar, LECTURE, Opened, U, assert_near, exact};
use krank::Vec2;
use krank::solver::{Range, State};

const ONE_RADIAN: f64 = 57.295_779_513_082_32;

/// The lecture's four-bar at 60 degrees: theta3, theta4, omega3, omega4 and C.
const THETA3: &str = "0.5127680962439173386614";
const THETA4: &str = "1.932996150262127931469";
const OMEGA3: &str = "-3.916412730164438530885";
const OMEGA4: &str = "3.091073219520966523067";
const C: [&str; 2] = ["311.416953239068390194", "233.7799046679389075852"];

#[test]
fn h08_tiny_crank_has_accurate_rates() {
    let rows = [
        (
            1e-6,
            ["0.5625006664309789275817", "0.8267980403687718943009"],
            "2.418857599737597979994",
            ["-9.962937709612298816777e-7", "2.145395227343129564641e-8"],
        ),
        (
            1e-9,
            ["0.5625000006664306486308", "0.8267972854633458856387"],
            "2.41885840497033887915",
            [
                "-9.962938118554356725116e-10",
                "2.145382766986793644759e-11",
            ],
        ),
        (
            1e-12,
            ["0.5625000000006664306483", "0.8267972847084402208581"],
            "2.418858405775571588536",
            [
                "-9.962938118963296299475e-13",
                "2.145382754526471326626e-14",
            ],
        ),
    ];
    for (crank, [x, y], theta4, [omega3, omega4]) in rows {
        let tiny = FourBar {
            crank,
            coupler: 1.0,
            rocker: 1.25,
            ground: 1.5,
            start: ONE_RADIAN,
            speed: 1.0,
            ..LECTURE
        };
        let opened = tiny.open();
        let state = opened.at(ONE_RADIAN);
        let c = state.position(opened.joint).unwrap();
        let slack = opened.position_slack(&state);
        assert_near("C.x", c.x, x, slack);
        assert_near("C.y", c.y, y, slack);
        let direction = state.direction(opened.rocker).unwrap().angle();
        assert_near("theta4", direction, theta4, slack / 1.25 + 2.0 * U);
        // 10 u / sin^2(mu) relative to the larger rate: omega4 is near its zero, where rounding the
        // crank's angle alone changes it by 38 u relative to itself.
        let slack = 10.0 * U / opened.sin_mu(&state).powi(2) * exact(omega3).hi.abs();
        for (link, omega) in [(opened.coupler, omega3), (opened.rocker, omega4)] {
            assert_near("omega", state.omega(link).unwrap(), omega, slack);
        }
    }
}

#[test]
fn h08_huge_crank_is_accurate_to_coordinate_rounding() {
    let huge = FourBar {
        crank: 1e6,
        coupler: 1.0,
        rocker: 1.0,
        ground: 1e6 + 1.0,
        start: 1e-7 * ONE_RADIAN,
        speed: 1.0,
        ..LECTURE
    };
    let opened = huge.open();
    let state = opened.at(huge.start);
    let c = state.position(opened.joint).unwrap();
    let slack = opened.position_slack(&state);
    assert_near("C.x", c.x, "1000000.586029004241798", slack);
    assert_near("C.y", c.y, "0.9102900717194285895416", slack);
    // B has a rounding error of 1e6 u, and so has the coupler, of length 1.
    for (link, omega) in [
        (opened.coupler, "-1047643.53899938738528"),
        (opened.rocker, "-932554.4512956721330874"),
    ] {
        assert_near("omega", state.omega(link).unwrap(), omega, 1e6 * U * 1e6);
    }
}

/// Compares the angles and rates of a scaled or translated copy with those of the lecture's
/// four-bar.
fn assert_turns_like_the_lecture_s(opened: &Opened, state: &State) {
    let angle_slack = opened.position_slack(state) / opened.of.rocker + 2.0 * U;
    let angle = |link| state.direction(link).unwrap().angle();
    assert_near("theta3", angle(opened.coupler), THETA3, angle_slack);
    assert_near("theta4", angle(opened.rocker), THETA4, angle_slack);
    for (link, omega) in [(opened.coupler, OMEGA3), (opened.rocker, OMEGA4)] {
        let slack = opened.omega_slack(state, exact(omega).hi);
        assert_near("omega", state.omega(link).unwrap(), omega, slack);
    }
}

#[test]
fn h09_scaled_four_bar_is_equally_accurate() {
    let plain = LECTURE.open();
    let lecture = plain.at(60.0);
    for size in [1e-9, 1e-12, 1e9, 1e150, 1e-150, 1.0] {
        let opened = LECTURE.scaled(size).open();
        assert_eq!(opened.solver.motion().range, Range::Full { period: 360.0 });
        let state = opened.at(60.0);
        assert_turns_like_the_lecture_s(&opened, &state);
        for link in [plain.coupler, plain.rocker] {
            let alpha = lecture.alpha(link).unwrap();
            let off = (state.alpha(link).unwrap() - alpha).abs();
            assert!(
                off <= plain.alpha_slack(&lecture, alpha),
                "alpha at {size:e}: {off:e}"
            );
        }
        let c = state.position(opened.joint).unwrap();
        for (found, decimal) in [(c.x, C[0]), (c.y, C[1])] {
            let expected = exact(decimal) * DoubleDouble::from(size);
            let off = expected.minus(found).abs();
            assert!(
                off <= opened.position_slack(&state),
                "C at {size:e}: {off:e}"
            );
        }
    }
}

#[test]
fn h09_scaling_by_power_of_two_is_exact() {
    let plain = LECTURE.open();
    for power in [-900, -500, -40, -1, 1, 30, 500, 900] {
        let size = 2.0_f64.powi(power);
        let scaled = LECTURE.scaled(size).open();
        for degrees in [60.0, 0.0, 123.456, 359.0] {
            let one = bits(&plain.mechanism, &plain.at(degrees), 1.0);
            let other = bits(&scaled.mechanism, &scaled.at(degrees), size);
            assert_eq!(one, other, "2^{power} at {degrees}");
        }
    }
}

/// Subnormal lengths, as H19 requires: they are scaled first.
#[test]
fn h09_subnormal_lengths_move_like_normal_ones() {
    const MIN_SIZE: f64 = 5e-324;
    let (plain, tiny) = (LECTURE.open(), LECTURE.scaled(MIN_SIZE).open());
    assert_eq!(plain.solver.motion().range, tiny.solver.motion().range);
    let (one, other) = (plain.at(60.0), tiny.at(60.0));
    for link in [plain.coupler, plain.rocker] {
        assert_eq!(one.direction(link).unwrap(), other.direction(link).unwrap());
        assert_eq!(one.omega(link).unwrap(), other.omega(link).unwrap());
        assert_eq!(one.alpha(link).unwrap(), other.alpha(link).unwrap());
    }
    let c = Vec2::new(311.0, 234.0) * MIN_SIZE;
    assert_eq!(other.position(tiny.joint).unwrap(), c);
}

#[test]
fn h10_distant_ground_loses_no_accuracy() {
    let origin = Vec2::new(1e8, -3e8);
    let far = FourBar { origin, ..LECTURE }.open();
    let plain = LECTURE.open();
    let (there, here) = (far.at(60.0), plain.at(60.0));
    assert_turns_like_the_lecture_s(&far, &there);
    for link in [far.coupler, far.rocker] {
        assert_eq!(
            there.direction(link).unwrap(),
            here.direction(link).unwrap()
        );
        assert_eq!(there.omega(link).unwrap(), here.omega(link).unwrap());
        assert_eq!(there.alpha(link).unwrap(), here.alpha(link).unwrap());
    }
    assert_eq!(
        there.velocity(far.joint).unwrap(),
        here.velocity(plain.joint).unwrap()
    );
    assert_eq!(
        there.acceleration(far.joint).unwrap(),
        here.acceleration(plain.joint).unwrap()
    );
    let c = there.position(far.joint).unwrap();
    // Half an ulp of the coordinate, plus the allowed error of C itself.
    let own = plain.position_slack(&here);
    for (found, decimal, shift, half_ulp) in [
        (c.x, C[0], origin.x, 2.0_f64.powi(-27)),
        (c.y, C[1], origin.y, 2.0_f64.powi(-25)),
    ] {
        let expected = exact(decimal) + DoubleDouble::from(shift);
        let off = expected.minus(found).abs();
        assert!(off <= half_ulp + own, "{found}: {off:e}");
    }
}

#[test]
fn one_radian_is_the_nearest_double() {
    let degrees = DoubleDouble::from(180.0) / PI;
    assert_eq!(degrees.hi, ONE_RADIAN);
}
