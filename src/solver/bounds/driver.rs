//! What the driver's own coordinate can be off by, and the direction that it gives a crank.

use super::errors::LinkError;
use crate::arithmetic::{U, two_product, typed_radius};
use crate::{Ball, Double, Vec2, angle};

/// Decimals of 15 digits are whole numbers from the one to below the other, in some unit;
const LEAST_DIGITS: f64 = 1e14;
const MOST_DIGITS: f64 = 1e15;
/// and this is the largest power of ten whose inverse such a unit can be: it is the last that a double holds.
const LARGEST_UNIT: f64 = 1e22;
/// What a direction in twice the digits rounds, and the way to it.
const UNIT: f64 = 64.0 * U * U;
/// pi / 180, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

/// How far the driver's coordinate that was meant can be from the double that it was read as: one of more
/// than 15 digits is that double, one of fewer is the decimal that it reads back as.
pub(super) fn asked_radius(at: f64) -> f64 {
    // A whole number is itself.
    if at.abs() < MOST_DIGITS && at == at.trunc() {
        return 0.0;
    }
    let mut unit = 1.0;
    while (at * unit).abs() < LEAST_DIGITS {
        unit *= 10.0;
        if unit > LARGEST_UNIT {
            return typed_radius(at);
        }
    }
    // Both are whole and below 2^53: their quotient is what the decimal is read as.
    let (product, lost) = two_product(at, unit);
    let whole = product.round();
    if whole.abs() < MOST_DIGITS && whole / unit == at {
        ((whole - product) - lost).abs() / unit * (1.0 + 4.0 * U)
    } else {
        0.0
    }
}

/// The error of a crank's computed direction at an angle in degrees. A long chain makes much of little: there the
/// direction is found to twice the digits.
pub(super) fn crank_error(d: Vec2, at: Ball, is_long: bool) -> LinkError {
    let (close, off) = if is_long {
        (Double::unit(at.mid), Vec2::ZERO)
    } else {
        angle::unit_closely(at.mid)
    };
    let off = off.x + off.y + UNIT + at.radius * RADIAN;
    LinkError {
        direction: Vec2::new(
            (close.x.hi - d.x) + close.x.lo,
            (close.y.hi - d.y) + close.y.lo,
        ),
        rest: [off, 0.0, 0.0],
        along: off,
        ..LinkError::none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_is_meant_as_it_was_typed() {
        for exact in [
            0.0,
            30.0,
            1e9 + 1.0,
            9_007_199_254_740_991.0,
            0.625,
            1.0 / 3.0,
        ] {
            let most = if exact == 0.0 { 1e-300 } else { 0.0 };
            assert!(asked_radius(exact) <= most, "{exact}");
        }
        // Off by 2.8421709430404007e-15 / 10, by hand.
        let off = asked_radius(39.3);
        assert!(off > 2.84e-15 && off < 2.85e-15, "{off:e}");
        assert_eq!(asked_radius(-39.3), off);
        assert_eq!(asked_radius(1e-12), typed_radius(1e-12));
    }
}
