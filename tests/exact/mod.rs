//! Just enough double-double arithmetic to read a reference of 25 digits without rounding it to a
//! double first: at 20 units of rounding, half a unit of our own would count.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two doubles, some 32 digits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleDouble {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

/// pi to 32 digits.
pub(crate) const PI: DoubleDouble = DoubleDouble {
    hi: std::f64::consts::PI,
    lo: 1.224_646_799_147_353_2e-16,
};

/// The exact sum of two doubles (Knuth's two-sum).
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let b_part = hi - a;
    let lo = (a - (hi - b_part)) + (b - b_part);
    DoubleDouble { hi, lo }
}

/// The exact product of two doubles.
fn two_prod(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    let lo = a.mul_add(b, -hi);
    DoubleDouble { hi, lo }
}

impl DoubleDouble {
    /// Reads a decimal such as `-273.0996813837050523441056` or `8.883079e+00`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (sign, digits) = match mantissa.strip_prefix('-') {
            Some(rest) => (-1.0, rest),
            None => (1.0, mantissa),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let integer: u128 = format!("{whole}{fraction}").parse().ok()?;
        let places = i32::try_from(fraction.len()).ok()?;
        let power = exponent.parse::<i32>().ok()? - places;
        let hi = integer as f64;
        let lo = if integer >= hi as u128 {
            (integer - hi as u128) as f64
        } else {
            -((hi as u128 - integer) as f64)
        };
        let magnitude = two_sum(hi, lo).times_power_of_ten(power);
        Some(magnitude * Self::from(sign))
    }

    fn times_power_of_ten(self, power: i32) -> Self {
        let ten = Self::from(10.0);
        (0..power.abs()).fold(self, |v, _| if power < 0 { v / ten } else { v * ten })
    }

    /// This value minus a double, as a double: without cancellation where they are close.
    pub(crate) fn minus(self, value: f64) -> f64 {
        let difference = self - Self::from(value);
        difference.hi + difference.lo
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        DoubleDouble { hi, lo: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        let sum = two_sum(self.hi, o.hi);
        two_sum(sum.hi, sum.lo + (self.lo + o.lo))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let product = two_prod(self.hi, o.hi);
        two_sum(product.hi, product.lo + (self.hi * o.lo + self.lo * o.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let first = self.hi / o.hi;
        let rest = self - o * Self::from(first);
        two_sum(first, rest.hi / o.hi)
    }
}
