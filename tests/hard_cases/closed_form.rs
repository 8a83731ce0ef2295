//! Solves a four-bar by the law of cosines in double-double arithmetic: any f64 solver should agree
//! with it within its own rounding, for any lengths.

use crate::exact::{DoubleDouble, PI};
use crate::rig::FourBar;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

type Pair = [DoubleDouble; 2];

/// The compared values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    /// The position of C relative to A.
    pub(crate) joint: Pair,
    /// omega3 and omega4 at one radian per second.
    pub(crate) omega: Pair,
    pub(crate) sin_mu: f64,
}

fn dd(v: f64) -> DoubleDouble {
    DoubleDouble::from(v)
}

fn dot(a: Pair, b: Pair) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Pair, b: Pair) -> DoubleDouble {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Pair, b: Pair) -> Pair {
    [a[0] - b[0], a[1] - b[1]]
}

fn perp(a: Pair) -> Pair {
    [-a[1], a[0]]
}

/// Computes a square root by one Newton step from the root of the leading double.
fn sqrt(v: DoubleDouble) -> DoubleDouble {
    let root = dd(v.hi.sqrt());
    root + (v - root * root) / (root * dd(2.0))
}

/// Returns (cos, sin) of an angle in degrees, by Taylor's series within a quarter of a right angle.
fn unit(degrees: f64) -> Pair {
    let eighths = (degrees / 45.0).round();
    let x = dd(degrees - 45.0 * eighths) * PI / dd(180.0);
    assert!(x.hi.abs() < FRAC_PI_2 / 2.0);
    let (mut cos, mut sin) = (dd(0.0), dd(0.0));
    let mut term = dd(1.0);
    for k in 0..24 {
        let (sum, sign) = (
            if k % 2 == 0 { &mut cos } else { &mut sin },
            [1.0, 1.0, -1.0, -1.0],
        );
        *sum = *sum + term * dd(sign[k % 4]);
        term = term * x / dd((k + 1) as f64);
    }
    let half_root = sqrt(dd(2.0)) / dd(2.0);
    assert!((half_root.hi * 2.0 - SQRT_2).abs() < 1e-15);
    (0..eighths.rem_euclid(8.0) as usize).fold([cos, sin], |[c, s], _| {
        [(c - s) * half_root, (c + s) * half_root]
    })
}

/// Solves the four-bar at a crank angle in degrees; `None` if it does not close.
pub(crate) fn solve(of: &FourBar, degrees: f64) -> Option<Exact> {
    let [cos, sin] = unit(degrees);
    let (a, b, c) = (dd(of.crank), dd(of.coupler), dd(of.rocker));
    let pin = [cos * a, sin * a];
    let u = minus([dd(of.ground), dd(0.0)], pin);
    let d2 = dot(u, u);
    let x = (d2 + (b - c) * (b + c)) / dd(2.0);
    let h2 = b * b * d2 - x * x;
    if !(h2.hi > 0.0) {
        return None;
    }
    let h = sqrt(h2) * dd(of.side);
    let k = perp(u);
    let e = [(u[0] * x + k[0] * h) / d2, (u[1] * x + k[1] * h) / d2];
    let f = minus(e, u);
    // w3 k x e + k x pin = w4 k x f, times f and times e.
    let speed = perp(pin);
    let det = cross(e, f);
    let omega = [-dot(speed, f) / det, -dot(speed, e) / det];
    Some(Exact {
        joint: [pin[0] + e[0], pin[1] + e[1]],
        omega,
        sin_mu: (det / (b * c)).hi.abs(),
    })
}

#[test]
fn closed_form_matches_exact_values_of_lecture_four_bar() {
    use crate::rig::{LECTURE, exact};
    let found = solve(&LECTURE, 60.0).expect("it closes");
    let values = [
        (found.joint[0], "311.416953239068390194"),
        (found.joint[1], "233.7799046679389075852"),
        (found.omega[0] * dd(15.0), "-3.916412730164438530885"),
        (found.omega[1] * dd(15.0), "3.091073219520966523067"),
    ];
    for (value, decimal) in values {
        let off = (value - exact(decimal)).minus(0.0).abs();
        assert!(off < 1e-21 * value.hi.abs(), "{decimal}: {off:e}");
    }
}
