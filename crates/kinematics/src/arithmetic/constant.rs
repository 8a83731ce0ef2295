//! Represents the constants of a mechanism with their precision.

use super::U;
use super::ball::half_ulp;
use super::decimal::Decimal;
use super::double::Double;
use super::number::Number;
use super::vec2::Vec2;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Mask of a double's last bits. If all are zero, the typed number may be exactly a double, such as
/// 250 or 0.625. One in a million of the numbers that are not doubles passes this test too.
const LAST_BITS: u64 = (1 << 20) - 1;
/// Conversion error of a rate given in rpm or degrees, in half ulps. Reading, two operations and
/// the constant pi round by less than 3.4 u in all, and u is at most two half ulps.
const CONVERSION: f64 = 7.0;
/// Assumed rounding errors of a coordinate that a program computed.
const COMPUTED_ROUNDINGS: f64 = 8.0;
/// Relative error of a double-double operation, with a margin.
pub(crate) const DOUBLE_DOUBLE_ERROR: f64 = 1e-31;
/// Maximum relative error of an operation in double-double (Joldes, Muller and Popescu: 3 u^2 for a
/// sum, 7 for a product, 15 for a quotient).
const LOST: f64 = 16.0 * U * U;
/// Maximum error of the Taylor series of a sine or cosine in double-double.
const LOST_IN_UNIT: f64 = 8.0 * LOST;

/// A constant of a mechanism: the stored value in double-double, and a bound on its distance from
/// the value meant.
///
/// A scene with the length 39.3 stores the nearest double, which is off by up to half an ulp. Both
/// numbers are within `radius` of `hi + lo`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Constant {
    /// The nearest double.
    pub hi: f64,
    /// The remainder of the stored value beyond `hi`.
    pub lo: f64,
    /// A bound on the distance of the meant value from the stored one.
    pub radius: f64,
    /// The derivative by the length under study, if any: see [`Dual`](crate::Dual).
    pub slope: f64,
}

/// Returns a bound on the distance between a typed number and the double it was read as.
#[must_use]
pub(crate) fn typed_radius(value: f64) -> f64 {
    if is_exact(value) {
        0.0
    } else {
        half_ulp(value)
    }
}

/// Returns `true` if the typed number is exactly the double it was read as.
fn is_exact(value: f64) -> bool {
    value.to_bits() & LAST_BITS == 0 && Decimal::of(value).is_double
}

impl Constant {
    /// One degree in radians.
    pub(crate) const RADIAN: Constant = Constant::new(Double::RADIAN, 0.0);
    /// One radian in degrees.
    pub(crate) const DEGREES: Constant = Constant::new(Double::DEGREES, 0.0);

    /// Creates a constant from a number given in a scene or by a program.
    #[must_use]
    pub fn given(value: f64) -> Constant {
        Constant {
            hi: value,
            lo: 0.0,
            radius: typed_radius(value),
            slope: 0.0,
        }
    }

    /// Creates a constant from a number given in another unit, by dividing it by a power of two. If
    /// half its ulp underflows, the radius is half an ulp of the quotient.
    pub(crate) fn given_in(value: f64, unit: f64) -> Constant {
        let hi = value / unit;
        let radius = if is_exact(value) { 0.0 } else { half_ulp(hi) };
        Constant::new(Double::exactly(hi), radius)
    }

    /// Widens the radius for a rate converted from another unit.
    pub fn converted(self) -> Constant {
        let radius = CONVERSION * half_ulp(self.hi);
        Constant {
            radius: if self.hi == 0.0 { 0.0 } else { radius },
            ..self
        }
    }

    /// Returns the constant with its radius widened by `more`.
    #[must_use]
    pub fn widened(self, more: f64) -> Constant {
        Constant {
            radius: self.radius + more,
            ..self
        }
    }

    /// Returns the constant with another derivative.
    #[must_use]
    pub(crate) const fn with_slope(self, slope: f64) -> Constant {
        Constant { slope, ..self }
    }

    /// Creates a position for comparing lengths, from the typed decimals or from the stored
    /// doubles. `radius` covers the rounding of both coordinates if one of them is a long number.
    pub(crate) fn compared(position: Vec2, is_decimal: bool) -> Vec2<Constant> {
        Constant::compared_with(position, is_decimal, |decimal| decimal.is_long)
    }

    /// Creates a position as [`Constant::compared`] does, in a mechanism with other long numbers. One
    /// number in ten of 15 digits ends in a zero, which a program does not print.
    pub(crate) fn compared_among_long(position: Vec2, is_decimal: bool) -> Vec2<Constant> {
        Constant::compared_with(position, is_decimal, |decimal| decimal.is_nearly_long)
    }

    fn compared_with(
        position: Vec2,
        is_decimal: bool,
        is_long: impl Fn(&Decimal) -> bool,
    ) -> Vec2<Constant> {
        let read = |v: f64| {
            if is_decimal {
                let decimal = Decimal::of(v);
                // A long number was computed by a program, and its last digit was then rounded.
                let radius = decimal.rounding + COMPUTED_ROUNDINGS * typed_radius(v);
                return (Constant::new(decimal.value, radius), is_long(&decimal));
            }
            let radius = COMPUTED_ROUNDINGS * typed_radius(v);
            (Constant::new(Double::exactly(v), radius), radius > 0.0)
        };
        let Vec2 { x, y } = position.map(read);
        let is_rounded = x.1 || y.1;
        Vec2::new(x.0, y.0).map(|v| Constant {
            radius: if is_rounded { v.radius } else { 0.0 },
            ..v
        })
    }

    /// Creates a position as meant: the typed decimals or the stored doubles. The radius covers
    /// double-double rounding only, but a decimal of 15 digits or more counts as already rounded
    /// when it was typed, to half an ulp.
    pub(crate) fn intended_position(position: Vec2, is_decimal: bool) -> Vec2<Constant> {
        position.map(|v| {
            if !is_decimal {
                return Constant::new(Double::exactly(v), 0.0);
            }
            let Decimal {
                value,
                roundings,
                is_long,
                ..
            } = Decimal::of(v);
            let typed = if is_long {
                typed_radius(v) + value.lo.abs()
            } else {
                0.0
            };
            Constant::new(value, typed + f64::from(roundings) * LOST * v.abs())
        })
    }

    /// Returns the unit vector at an angle in degrees, with the angle as meant (see
    /// [`Constant::intended_position`]).
    pub(crate) fn intended_unit_vector(degrees: f64, is_decimal: bool) -> Vec2<Constant> {
        let Vec2 { x: angle, .. } =
            Constant::intended_position(Vec2::new(degrees, 0.0), is_decimal);
        <Double as Number>::unit(angle.value()).map(|v| {
            let is_exact = v == Double::ZERO || v.abs() == Double::ONE;
            let off = angle.radius.to_radians() + LOST_IN_UNIT;
            Constant::new(v, if is_exact { 0.0 } else { off })
        })
    }

    /// Returns the unit vector at an angle given in degrees.
    #[must_use]
    pub fn given_unit(degrees: f64) -> Vec2<Constant> {
        let off = typed_radius(degrees).to_radians();
        let unit = Double::unit(degrees);
        let across = unit.map(|v| v.hi.abs() + off);
        let with = |value: Double, across: f64| Constant::new(value, across * off);
        Vec2::new(with(unit.x, across.y), with(unit.y, across.x))
    }

    /// Returns the displacement for a given length and a given angle in degrees.
    pub(crate) fn given_arm(length: f64, degrees: f64) -> Vec2<Constant> {
        Constant::given_unit(degrees).map(|v| Constant::given(length) * v.lost_in_unit())
    }

    /// Returns the displacement for a length and an angle in degrees, both as meant (see
    /// [`Constant::intended_position`]).
    pub(crate) fn intended_arm(length: f64, degrees: f64, is_decimal: bool) -> Vec2<Constant> {
        let Vec2 { x: length, .. } =
            Constant::intended_position(Vec2::new(length, 0.0), is_decimal);
        Constant::intended_unit_vector(degrees, is_decimal).map(|v| length * v)
    }

    /// Widens a sine or cosine by the error of its series.
    fn lost_in_unit(self) -> Constant {
        let is_exact = self.is_double() && (self.hi == 0.0 || self.hi.abs() == 1.0);
        let lost = if is_exact { 0.0 } else { LOST_IN_UNIT };
        Constant {
            radius: self.radius + lost,
            ..self
        }
    }

    /// Creates the result of an operation from its value and the propagated radius; adds a rounding
    /// error unless the operation is exact.
    fn rounded(value: Double, carried: f64, is_exact: bool) -> Constant {
        let lost = if is_exact { 0.0 } else { LOST };
        Constant::new(value, carried + lost * value.hi.abs())
    }

    /// Returns `true` if the stored value is a double. Sums and products of two such values are
    /// exact in double-double.
    fn is_double(self) -> bool {
        self.lo == 0.0
    }

    /// Creates a constant whose derivative is zero.
    const fn new(value: Double, radius: f64) -> Constant {
        let Double { hi, lo } = value;
        Constant {
            hi,
            lo,
            radius,
            slope: 0.0,
        }
    }

    /// Creates a constant known to double-double precision, such as a mathematical one, without
    /// typing error.
    pub(crate) fn known(value: Double) -> Constant {
        Constant::new(value, DOUBLE_DOUBLE_ERROR * value.hi.abs())
    }

    /// Creates a constant known to double-double precision up to a few roundings, and stored as the
    /// double `hi` near it.
    pub(crate) fn stored(hi: f64, value: Double) -> Constant {
        Constant::new(value, 4.0 * LOST * value.hi.abs()).relative_to(hi)
    }

    /// Re-expresses the same value relative to a double near it.
    #[must_use]
    pub(crate) fn relative_to(self, hi: f64) -> Constant {
        let rest = self.value() - Double::exactly(hi);
        Constant {
            hi,
            lo: rest.hi,
            radius: self.radius + rest.lo.abs(),
            ..self
        }
    }

    /// Returns the stored value.
    #[inline]
    #[must_use]
    pub const fn value(self) -> Double {
        Double {
            hi: self.hi,
            lo: self.lo,
        }
    }

    /// Returns a bound on the distance of the nearest double from the value meant.
    #[inline]
    #[must_use]
    pub fn off(self) -> f64 {
        self.radius + (self.lo.abs() + DOUBLE_DOUBLE_ERROR * self.hi.abs())
    }
}

impl Add for Constant {
    type Output = Constant;
    fn add(self, o: Constant) -> Constant {
        let is_exact = self.is_double() && o.is_double();
        let sum = Constant::rounded(self.value() + o.value(), self.radius + o.radius, is_exact);
        sum.with_slope(self.slope + o.slope)
    }
}

impl AddAssign for Constant {
    fn add_assign(&mut self, o: Constant) {
        *self = *self + o;
    }
}

impl Sub for Constant {
    type Output = Constant;
    fn sub(self, o: Constant) -> Constant {
        self + -o
    }
}

impl Neg for Constant {
    type Output = Constant;
    fn neg(self) -> Constant {
        Constant::new(-self.value(), self.radius).with_slope(-self.slope)
    }
}

impl Mul for Constant {
    type Output = Constant;
    fn mul(self, o: Constant) -> Constant {
        let radius = self.hi.abs() * o.radius + self.radius * (o.hi.abs() + o.radius);
        let is_exact = self.is_double() && o.is_double();
        let value = self.value() * o.value();
        let product = Constant::rounded(value, radius * (1.0 + 4.0 * U), is_exact);
        product.with_slope(self.hi * o.slope + self.slope * o.hi)
    }
}

impl Div for Constant {
    type Output = Constant;
    fn div(self, o: Constant) -> Constant {
        let value = self.value() / o.value();
        let minimum = o.hi.abs() * (1.0 - 4.0 * U) - o.radius;
        let radius = (self.radius + value.hi.abs() * o.radius) / minimum;
        let quotient = Constant::rounded(value, radius * (1.0 + 8.0 * U), false);
        quotient.with_slope((self.slope - value.hi * o.slope) / o.hi)
    }
}

impl Number for Constant {
    fn of(constant: Constant) -> Constant {
        constant
    }

    fn exactly(value: f64) -> Constant {
        Constant::new(Double::exactly(value), 0.0)
    }

    fn nearest(self) -> f64 {
        self.hi
    }

    fn scaled(self, power_of_two: f64) -> Constant {
        Constant::new(
            self.value().scaled(power_of_two),
            self.radius * power_of_two,
        )
        .with_slope(self.slope * power_of_two)
    }

    fn sqrt(self) -> Constant {
        let root = self.value().sqrt();
        let radius = if self.radius == 0.0 {
            0.0
        } else {
            self.radius / root.hi * (1.0 + 4.0 * U)
        };
        let is_exact = root.lo == 0.0 && root * root == self.value();
        let slope = if self.slope == 0.0 {
            0.0
        } else {
            self.slope / (2.0 * root.hi)
        };
        Constant::rounded(root, radius, is_exact).with_slope(slope)
    }

    fn abs(self) -> Constant {
        let slope = if self.hi < 0.0 {
            -self.slope
        } else {
            self.slope
        };
        Constant::new(self.value().abs(), self.radius).with_slope(slope)
    }

    fn min(self, other: Constant) -> Constant {
        if other.exceeds(self) { self } else { other }
    }

    fn exceeds(self, other: Constant) -> bool {
        (self.value() - other.value()).hi > 0.0
    }

    fn unit(degrees: Constant) -> Vec2<Constant> {
        Constant::given_unit(degrees.hi)
    }

    fn degrees(direction: Vec2<Constant>) -> Constant {
        let degrees = Double::degrees(direction.map(Constant::value));
        let off = direction.x.radius + direction.y.radius;
        Constant::new(degrees, (off / direction.norm().hi).to_degrees())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exactly_representable_values_have_no_error() {
        for exact in [0.0, 250.0, -0.625, 400.0, 1e6 + 1.0] {
            assert!(
                Constant::given(exact).off() <= DOUBLE_DOUBLE_ERROR * 1e7,
                "{exact}"
            );
        }
        // The double nearest to the last one ends with twenty zero bits.
        for rounded in [0.1, 39.3, 1.000_000_001, 9.47615610808134] {
            let off = Constant::given(rounded).off();
            assert!(
                off > 0.4 * U * rounded && off < 1.1 * U * rounded,
                "{off:e}"
            );
        }
    }

    #[test]
    fn lengths_keep_error_of_their_coordinates() {
        let local = Vec2::new(Constant::given(0.3), Constant::given(0.4));
        let length = local.norm();
        assert!(
            length.off() > 0.1 * U && length.off() < U,
            "{:e}",
            length.off()
        );
        let along = Vec2::new(Constant::given(250.0), Constant::given(0.0));
        assert_eq!(along.norm(), Constant::given(250.0));
    }
}
