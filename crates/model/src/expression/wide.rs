//! Implements ball arithmetic with big numbers for formulas: many digits and any exponent.
//!
//! A formula of plain numbers is evaluated once, when a scene is read, and its result is rounded
//! once. No intermediate value overflows or underflows, and cancellation leaves enough digits:
//! `1e308 + 1e-308 - 1e308` is 1e-308.

use crate::Double;
use num_bigint::{BigInt, BigUint, Sign};

/// Bits of a sum, product, quotient or root. Two doubles of any size are added exactly in 2,100.
const PRECISION: u64 = 4096;
/// Bits of a bound.
const RADIUS_BITS: u64 = 32;
/// Bits by which the value must exceed its bound: more than a double has.
const KNOWN_BITS: u64 = 64;
/// The maximum power of ten of a literal, and the maximum power of two of a value.
const MAX_DECIMAL_POWER: i64 = 10_000;
const MAX_POWER: i64 = 1 << 21;

/// All numbers within `radius` of `mid`, both times 2^`exponent`.
#[derive(Clone, Debug, PartialEq)]
pub struct Wide {
    mid: BigInt,
    radius: BigUint,
    exponent: i64,
}

impl Wide {
    pub(super) const ZERO: Wide = Wide {
        mid: BigInt::ZERO,
        radius: BigUint::ZERO,
        exponent: 0,
    };

    pub(super) fn integer(value: impl Into<BigInt>) -> Wide {
        Wide {
            mid: value.into(),
            ..Wide::ZERO
        }
    }

    /// Creates the numbers within `radius` of `mid`, both times 2^`exponent`.
    pub(super) fn ball(mid: BigInt, radius: BigUint, exponent: i64) -> Wide {
        Wide {
            mid,
            radius,
            exponent,
        }
    }

    /// Converts a finite double, exactly.
    pub fn exactly(value: f64) -> Wide {
        let bits = value.abs().to_bits();
        let (power, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
        let (digits, power) = match power {
            0 => (fraction, 1),
            power => (fraction | 1 << 52, power),
        };
        let size = Wide {
            mid: digits.into(),
            exponent: i64::try_from(power).unwrap_or(0) - 1075,
            ..Wide::ZERO
        };
        if value < 0.0 { size.negative() } else { size }
    }

    /// Parses a decimal number, such as `-1.5e-32`; exact if its power of ten is not negative.
    pub(crate) fn decimal(text: &str) -> Option<Wide> {
        let (digits, power) = match text.split_once(['e', 'E']) {
            None => (text, 0),
            Some((digits, power)) => (digits, power.parse::<i64>().ok()?),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let power = power.checked_sub(i64::try_from(fraction.len()).ok()?)?;
        if power.abs() > MAX_DECIMAL_POWER {
            return None;
        }
        let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
        let ten = BigInt::from(10).pow(u32::try_from(power.abs()).ok()?);
        let (digits, ten) = (Wide::integer(digits), Wide::integer(ten));
        Some(match power < 0 {
            true => digits.over(&ten),
            false => digits.times(&ten),
        })
    }

    /// Rounds to this number of bits.
    pub(super) fn rounded(self, bits: u64) -> Wide {
        let excess = self.mid.bits().saturating_sub(bits);
        let excess = excess.max(self.radius.bits().saturating_sub(RADIUS_BITS));
        if excess == 0 {
            return self;
        }
        let zeros = self.mid.trailing_zeros().unwrap_or(0);
        let is_exact = self.is_exact() && zeros >= excess;
        Wide {
            mid: self.mid >> excess,
            // Both shifts round down by less than 1.
            radius: if is_exact {
                BigUint::ZERO
            } else {
                (self.radius >> excess) + 2_u8
            },
            exponent: self.exponent + excess.cast_signed(),
        }
    }

    fn is_exact(&self) -> bool {
        self.radius == BigUint::ZERO
    }

    /// Returns `true` if the value is exactly zero.
    pub(super) fn is_zero(&self) -> bool {
        self.mid == BigInt::ZERO && self.is_exact()
    }

    pub(super) fn is_negative(&self) -> bool {
        self.mid.sign() == Sign::Minus
    }

    /// Returns the exponent of a power of two that exceeds the magnitude of the midpoint.
    pub(super) fn top(&self) -> i64 {
        self.exponent + self.mid.bits().cast_signed()
    }

    /// Returns the exponent of a power of two that exceeds every magnitude in the ball.
    pub(super) fn largest_top(&self) -> i64 {
        let bits = self.mid.bits().max(self.radius.bits());
        self.exponent + bits.cast_signed() + 1
    }

    /// Returns zero if the bound does not separate the value from zero. A formula loses that many
    /// digits only if its value is 0.
    pub(super) fn settled(self) -> Wide {
        match *self.mid.magnitude() <= self.radius {
            true => Wide::ZERO,
            false => self,
        }
    }

    /// Returns `true` if the exponent is in the supported range, which practical formulas never
    /// leave.
    pub(super) fn is_in_range(&self) -> bool {
        self.is_zero() || self.top().abs() < MAX_POWER
    }

    /// Returns `true` if the bound is less than the rounding error of a double.
    pub(super) fn is_known(&self) -> bool {
        self.is_exact() || self.mid.bits() >= self.radius.bits() + KNOWN_BITS
    }

    /// Returns the midpoint without its radius.
    pub(super) fn middle(self) -> Wide {
        Wide {
            radius: BigUint::ZERO,
            ..self
        }
    }

    /// Adds 2^`power` to the error bound.
    pub(super) fn widened(self, power: i64) -> Wide {
        let more = Wide {
            mid: BigInt::ZERO,
            radius: 1_u8.into(),
            exponent: power,
        };
        self.plus(&more)
    }

    /// Multiplies by 2^`power`, exactly.
    pub(super) fn scaled(self, power: i64) -> Wide {
        Wide {
            exponent: self.exponent + power,
            ..self
        }
    }

    /// Returns midpoint and radius in units of 2^`exponent`.
    pub(super) fn aligned(&self, exponent: i64) -> (BigInt, BigUint) {
        let shift = self.exponent - exponent;
        let by = shift.unsigned_abs();
        match shift < 0 {
            false => (&self.mid << by, &self.radius << by),
            true => (&self.mid >> by, (&self.radius >> by) + 2_u8),
        }
    }

    pub(super) fn negative(&self) -> Wide {
        Wide {
            mid: -&self.mid,
            ..self.clone()
        }
    }

    pub(super) fn size(self) -> Wide {
        match self.is_negative() {
            true => self.negative(),
            false => self,
        }
    }

    pub(super) fn plus(&self, other: &Wide) -> Wide {
        if self.is_zero() || other.is_zero() {
            let sum = if self.is_zero() { other } else { self };
            return sum.clone();
        }
        let top = self.largest_top().max(other.largest_top());
        let minimum = self.exponent.min(other.exponent);
        let exponent = minimum.max(top - PRECISION.cast_signed() - 64);
        let (a, b) = (self.aligned(exponent), other.aligned(exponent));
        let sum = Wide {
            mid: a.0 + b.0,
            radius: a.1 + b.1,
            exponent,
        };
        sum.rounded(PRECISION)
    }

    pub(super) fn minus(&self, other: &Wide) -> Wide {
        self.plus(&other.negative())
    }

    pub(super) fn times(&self, other: &Wide) -> Wide {
        let (a, b) = (self.mid.magnitude(), other.mid.magnitude());
        let (ra, rb) = (&self.radius, &other.radius);
        let product = Wide {
            mid: &self.mid * &other.mid,
            radius: a * rb + b * ra + ra * rb,
            exponent: self.exponent + other.exponent,
        };
        product.rounded(PRECISION)
    }

    /// Returns the quotient; zero if the divisor may be zero, which callers exclude.
    pub(super) fn over(&self, by: &Wide) -> Wide {
        self.over_to(by, PRECISION)
    }

    /// Returns the quotient to this number of bits.
    pub(super) fn over_to(&self, by: &Wide, bits: u64) -> Wide {
        let size = by.mid.magnitude();
        if *size <= by.radius {
            return Wide::ZERO;
        }
        let shift = (bits + size.bits()).saturating_sub(self.mid.bits());
        let dividend = &self.mid << shift;
        let mid = &dividend / &by.mid;
        let is_exact = self.is_exact() && by.is_exact() && &mid * &by.mid == dividend;
        // (A + a) / (B + b) - A / B = (a - (A / B) b) / (B + b), and both quotients round down.
        let carried = (&self.radius << shift) + (mid.magnitude() + 1_u8) * &by.radius;
        let radius = match is_exact {
            true => BigUint::ZERO,
            false => carried / (size - &by.radius) + 2_u8,
        };
        let quotient = Wide {
            mid,
            radius,
            exponent: self.exponent - shift.cast_signed() - by.exponent,
        };
        quotient.rounded(bits)
    }

    /// Returns the square root of a number that must not be negative.
    pub(super) fn root(&self) -> Wide {
        if *self.mid.magnitude() <= self.radius || self.is_negative() {
            return Wide::ZERO;
        }
        let shift = (2 * PRECISION).saturating_sub(self.mid.bits());
        let odd = (self.exponent - shift.cast_signed()).rem_euclid(2);
        let shift = shift + odd.unsigned_abs();
        let square = self.mid.magnitude() << shift;
        let root = square.sqrt();
        let is_exact = self.is_exact() && &root * &root == square;
        // |sqrt(v + d) - sqrt(v)| <= |d| / sqrt(v), and both quotients round down.
        let radius = match is_exact {
            true => BigUint::ZERO,
            false => (&self.radius << shift) / &root + 2_u8,
        };
        let root = Wide {
            mid: root.into(),
            radius,
            exponent: (self.exponent - shift.cast_signed()) / 2,
        };
        root.rounded(PRECISION)
    }

    /// Returns the nearest whole number.
    pub(super) fn nearest_integer(&self) -> BigInt {
        let by = self.exponent.unsigned_abs();
        match self.exponent < 0 {
            false => &self.mid << by,
            true => (&self.mid + (BigInt::from(1) << (by - 1))) >> by,
        }
    }

    /// The value in double-double.
    pub(crate) fn twice(&self) -> Double {
        let hi = self.nearest();
        if !hi.is_finite() {
            return Double::exactly(hi);
        }
        let lo = self.minus(&Wide::exactly(hi)).nearest();
        Double { hi, lo }
    }

    /// Returns the nearest double; infinite beyond the range of doubles.
    pub(crate) fn nearest(&self) -> f64 {
        let size = self.mid.magnitude();
        let top = self.top();
        if top > 1024 {
            return if self.is_negative() {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
        }
        // Below 2^-1022, doubles have fewer bits.
        let kept = (top + 1074).min(53);
        if size.bits() == 0 || kept < 0 {
            return 0.0;
        }
        let dropped = size.bits().saturating_sub(kept.unsigned_abs());
        let mut digits = size >> dropped;
        if dropped > 0 {
            let rest = size - (&digits << dropped);
            let half = BigUint::from(1_u8) << (dropped - 1);
            if rest > half || rest == half && digits.bit(0) {
                digits += 1_u8;
            }
        }
        let exponent = self.exponent + dropped.cast_signed();
        let digits = u64::try_from(digits).unwrap_or(0) as f64;
        let half = i32::try_from(exponent / 2).unwrap_or(0);
        let rest = i32::try_from(exponent - exponent / 2).unwrap_or(0);
        // Scaled in two steps, because 2^-1074 times a whole number is a double, but 2^1074 is not.
        let value = digits * 2.0_f64.powi(half) * 2.0_f64.powi(rest);
        if self.is_negative() { -value } else { value }
    }
}
