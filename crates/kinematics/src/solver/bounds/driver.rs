//! Bounds the error of the driver's coordinate, and of the direction that it gives a crank.

use super::errors::LinkError;
use crate::arithmetic::{Decimal, Halves, Product, U, half_ulp, typed_radius};
use crate::{Double, Vec2, angle};

/// Minimum of a 15-digit decimal as a whole number, in a suitable unit. `MAX_DIGITS` is the upper
/// limit.
const MIN_DIGITS: f64 = 1e14;
const MAX_DIGITS: f64 = 1e15;
/// The inverses of these units. A double holds no larger power of ten exactly.
const UNITS: [f64; 23] = [
    1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];
/// Rounding error of a double-double direction, and of the vector to it.
const UNIT: f64 = 64.0 * U * U;
/// pi / 180, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

/// The intended driver coordinate, relative to the double as which it was read. A coordinate of
/// more than 15 digits is that double. One of fewer digits is the decimal as which it is printed.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::solver) struct IntendedCoordinate {
    /// The difference of the intended coordinate from the double.
    pub(in crate::solver) rest: f64,
    /// The maximum error of that difference.
    pub(in crate::solver) radius: f64,
}

impl IntendedCoordinate {
    /// Returns the intended coordinate of a double.
    #[inline(always)]
    pub(in crate::solver) fn of<const FUSED: bool>(at: f64) -> IntendedCoordinate {
        // A whole number is exact.
        if at.abs() < MAX_DIGITS && at == at.trunc() {
            return IntendedCoordinate::default();
        }
        if at.abs() >= MAX_DIGITS {
            return IntendedCoordinate::within(typed_radius_of_many(at));
        }
        let Some(unit) = unit_of(at.abs()) else {
            return IntendedCoordinate::within(typed_radius(at));
        };
        // Both are whole and below 2^53: their quotient is the double as which the decimal is read.
        let Product { hi, lo } = Halves::<FUSED>::of(at).times(Halves::of(unit));
        let integer = hi.round_ties_even();
        if integer.abs() < MAX_DIGITS && integer / unit == at {
            let rest = ((integer - hi) - lo) * (1.0 / unit);
            let requested = IntendedCoordinate {
                rest,
                radius: rest.abs() * (4.0 * U),
            };
            // A number given with 15 digits may have been rounded: the double counts as well.
            let is_short = (integer * 0.1).round_ties_even() * 10.0 == integer;
            if is_short {
                requested
            } else {
                IntendedCoordinate::within(requested.max_distance())
            }
        } else {
            IntendedCoordinate::default()
        }
    }

    /// Returns a coordinate within `radius` of the double.
    #[inline(always)]
    pub(super) fn within(radius: f64) -> IntendedCoordinate {
        IntendedCoordinate { rest: 0.0, radius }
    }

    /// Returns the maximum distance from the double.
    #[inline(always)]
    pub(super) fn max_distance(self) -> f64 {
        self.rest.abs() + self.radius
    }

    /// Returns the double-double coordinate whose high part is the double.
    pub(in crate::solver) fn close(self, at: f64) -> Double {
        Double {
            hi: at,
            lo: self.rest,
        }
    }
}

/// Returns the radius of a coordinate so large that a decimal of 15 digits need not be a double,
/// although it is whole.
#[cold]
fn typed_radius_of_many(at: f64) -> f64 {
    if Decimal::of(at).is_double {
        0.0
    } else {
        half_ulp(at)
    }
}

/// Returns the smallest power of ten that gives a size 15 digits before the decimal point.
#[inline(always)]
fn unit_of(size: f64) -> Option<f64> {
    // 2^e <= size: its decimal exponent is at least that of 2^e, and at most one more.
    let e = (size.to_bits() >> 52) as i32 - 1023;
    let maximum = (14 - ((e * 1233) >> 12)).max(0) as usize;
    let less = maximum.saturating_sub(1);
    let is_enough = size * UNITS.get(less)? >= MIN_DIGITS;
    UNITS.get(if is_enough { less } else { maximum }).copied()
}

/// A crank's direction in double-double, as two vectors, and its maximum error.
pub(super) struct CrankDirection {
    pub d: Vec2,
    pub low: Vec2,
    pub off: f64,
}

impl CrankDirection {
    /// The direction for a driver that pushes.
    pub(super) const NONE: CrankDirection = CrankDirection {
        d: Vec2::X,
        low: Vec2::ZERO,
        off: 0.0,
    };

    /// Computes the direction at an angle in degrees. Long chains amplify small errors, so they get
    /// all digits.
    #[inline(always)]
    pub(super) fn at<const FUSED: bool>(
        at: f64,
        requested: IntendedCoordinate,
        is_long: bool,
    ) -> CrankDirection {
        let (close, off) = if is_long {
            (Double::unit(at), Vec2::ZERO)
        } else {
            angle::unit_closely::<FUSED>(at)
        };
        let d = close.map(|v| v.hi);
        let turn = requested.rest * RADIAN;
        let rounding = turn.abs() * (turn.abs() + 8.0 * U);
        CrankDirection {
            d,
            low: close.map(|v| v.lo) + d.perp() * turn,
            off: off.x + off.y + UNIT + rounding + requested.radius * RADIAN,
        }
    }

    /// Returns the error of a computed direction.
    #[inline(always)]
    pub(super) fn error_of(&self, d: Vec2) -> LinkError {
        LinkError::of_way(d, self.low + (self.d - d), self.off)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn intended_radius<const FUSED: bool>(at: f64) -> f64 {
        IntendedCoordinate::of::<FUSED>(at).max_distance()
    }

    #[test]
    fn coordinate_error_is_relative_to_typed_decimal() {
        for exact in [
            0.0,
            30.0,
            1e9 + 1.0,
            9_007_199_254_740_991.0,
            0.625,
            1.0 / 3.0,
        ] {
            let maximum = if exact == 0.0 { 1e-300 } else { 0.0 };
            assert!(intended_radius::<false>(exact) <= maximum, "{exact}");
        }
        // The error is 2.8421709430404007e-15 / 10, computed by hand.
        let off = intended_radius::<false>(39.3);
        assert!(off > 2.84e-15 && off < 2.85e-15, "{off:e}");
        assert_eq!(intended_radius::<false>(-39.3), off);
        // The double is below 39.3.
        let requested = IntendedCoordinate::of::<false>(39.3);
        assert!(
            requested.rest > 2.84e-15 && requested.radius < 1e-29,
            "{requested:?}"
        );
        assert_eq!(intended_radius::<false>(1e-12), typed_radius(1e-12));
        // 1e23 is not representable as a double, and neither is the next value; 1e22 is.
        assert!(intended_radius::<false>(1e23) > 8e6);
        assert!(intended_radius::<false>(-1.234_567_890_123_45e17) >= 5.0);
        assert_eq!(intended_radius::<false>(1e22), 0.0);
    }
}
