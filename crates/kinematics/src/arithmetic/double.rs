//! Implements double-double arithmetic: a value is the sum of two doubles.
//!
//! It is used for the rounding errors of constants, for residuals, and for whole runs of the solver
//! as a reference. It needs no fused operation, so that the bits are the same on every machine.

use crate::Vec2;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Veltkamp's constant 2^27 + 1, which splits a double into two halves.
pub(super) const SPLITTER: f64 = 134_217_729.0;

/// Returns a + b as the rounded sum and its rounding error (Knuth).
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let back = sum - a;
    (sum, (a - (sum - back)) + (b - back))
}

/// Returns a + b as the rounded sum and its rounding error, for |a| >= |b| (Dekker).
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

#[inline(always)]
pub(super) fn split(a: f64) -> (f64, f64) {
    let t = SPLITTER * a;
    let top = t - (t - a);
    (top, a - top)
}

/// Returns a b as the rounded product and its rounding error (Dekker); exact except for underflow.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

/// A number as `hi + lo`, where `hi` is the nearest double: 106 bits.
///
/// Sums and products are accurate to about 2^-104 of the larger operand (Joldes, Muller and
/// Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
/// 2017).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Double {
    /// The nearest double.
    pub hi: f64,
    /// The remainder beyond `hi`.
    pub lo: f64,
}

/// The inverses of the factorials of 0 to 27, each as two doubles. A table avoids the divisions, which
/// would take most of the time.
const INVERSE_FACTORIALS: [[f64; 2]; 28] = [
    [1.0, 0.0],
    [1.0, 0.0],
    [0.5, 0.0],
    [0.166_666_666_666_666_66, 9.251_858_538_542_97e-18],
    [0.041_666_666_666_666_664, 2.312_964_634_635_742_7e-18],
    [0.008_333_333_333_333_333, 1.156_482_317_317_871_4e-19],
    [0.001_388_888_888_888_889, -5.300_543_954_373_577e-20],
    [0.000_198_412_698_412_698_4, 1.720_955_829_342_070_5e-22],
    [2.480_158_730_158_73e-5, 2.151_194_786_677_588_2e-23],
    [2.755_731_922_398_589_3e-6, -1.858_393_274_046_472e-22],
    [2.755_731_922_398_589e-7, 2.376_771_462_225_029_7e-23],
    [2.505_210_838_544_172e-8, -1.448_814_070_935_912e-24],
    [2.087_675_698_786_81e-9, -1.207_345_059_113_26e-25],
    [1.605_904_383_682_161_3e-10, 1.258_529_458_875_209_8e-26],
    [1.147_074_559_772_972_5e-11, 2.065_551_275_283_074_5e-28],
    [7.647_163_731_819_816e-13, 7.038_728_777_334_53e-30],
    [4.779_477_332_387_385e-14, 4.399_205_485_834_081e-31],
    [2.811_457_254_345_520_6e-15, 1.650_884_273_086_143_3e-31],
    [1.561_920_696_858_622_5e-16, 1.191_067_966_027_375_4e-32],
    [8.220_635_246_624_33e-18, 2.214_189_411_960_426_5e-34],
    [4.110_317_623_312_165e-19, 1.441_297_337_865_952_7e-36],
    [1.957_294_106_339_126_3e-20, -1.364_350_383_008_790_8e-36],
    [8.896_791_392_450_574e-22, -7.911_402_614_872_376e-38],
    [3.868_170_170_630_684e-23, -8.843_177_655_482_344e-40],
    [1.611_737_571_096_118_4e-24, -3.684_657_356_450_976_6e-41],
    [6.446_950_284_384_474e-26, -1.933_040_423_370_346_5e-42],
    [2.479_596_263_224_797_6e-27, -1.295_373_096_476_522_9e-43],
    [9.183_689_863_795_546e-29, 1.430_315_039_678_732_2e-45],
];

impl Double {
    /// Zero.
    pub const ZERO: Double = Double { hi: 0.0, lo: 0.0 };
    /// One.
    pub const ONE: Double = Double { hi: 1.0, lo: 0.0 };
    /// pi / 180.
    pub const RADIAN: Double = Double {
        hi: 0.017_453_292_519_943_295,
        lo: 2.948_652_270_870_168_7e-19,
    };
    /// 180 / pi.
    pub const DEGREES: Double = Double {
        hi: 57.295_779_513_082_32,
        lo: -1.987_849_567_057_628_2e-15,
    };

    /// Creates a number from a double, exactly.
    #[inline]
    #[must_use]
    pub const fn exactly(value: f64) -> Double {
        Double { hi: value, lo: 0.0 }
    }

    /// Returns a + b of two doubles, exactly.
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Double {
        let (hi, lo) = two_sum(a, b);
        Double { hi, lo }
    }

    /// Multiplies by a power of two, exactly.
    #[inline]
    #[must_use]
    pub fn scaled(self, power_of_two: f64) -> Double {
        Double {
            hi: self.hi * power_of_two,
            lo: self.lo * power_of_two,
        }
    }

    /// Returns the square root; zero for zero.
    #[must_use]
    pub fn sqrt(self) -> Double {
        let root = self.hi.sqrt();
        if root == 0.0 {
            return Double::ZERO;
        }
        // Two Newton steps: each doubles the digits.
        let step = |x: Double| {
            let rest = self - x * x;
            x + Double::exactly(rest.hi / (2.0 * root))
        };
        step(step(Double::exactly(root)))
    }

    /// Returns the absolute value.
    #[must_use]
    pub fn abs(self) -> Double {
        if self.hi < 0.0 { -self } else { self }
    }

    /// Returns the unit vector at `degrees` from +x, counter-clockwise; exact at multiples of 90
    /// degrees.
    #[must_use]
    pub fn unit(degrees: f64) -> Vec2<Double> {
        let turn = degrees % 360.0;
        let quadrant = (turn / 90.0).round();
        // Exact by Sterbenz's lemma: 90 q is within 45 of the angle.
        let (sin, cos) = Double::exactly(turn - 90.0 * quadrant).sin_cos();
        let (x, y) = match quadrant.rem_euclid(4.0) as u8 {
            0 => (cos, sin),
            1 => (-sin, cos),
            2 => (-cos, -sin),
            _ => (sin, -cos),
        };
        Vec2::new(x, y)
    }

    /// Returns the sine and cosine of at most about 45 degrees by Taylor series: after 28 terms,
    /// they are below 2^-110.
    fn sin_cos(self) -> (Double, Double) {
        let x = self * Double::RADIAN;
        let square = -(x * x);
        // Horner's scheme by pairs of terms; the first of each pair belongs to the cosine.
        let (mut sin, mut cos) = (Double::ZERO, Double::ZERO);
        for pair in INVERSE_FACTORIALS.chunks_exact(2).rev() {
            let [of_cos, of_sin] = [pair[0], pair[1]].map(|[hi, lo]| Double { hi, lo });
            cos = cos * square + of_cos;
            sin = sin * square + of_sin;
        }
        (sin * x, cos)
    }

    /// Returns the direction of a vector in degrees, from -180 to 180.
    #[must_use]
    pub fn degrees(direction: Vec2<Double>) -> Double {
        let near = direction.y.hi.atan2(direction.x.hi).to_degrees();
        // The remainder is the small angle from the approximate direction to the true one,
        // approximated by its sine.
        let unit = Double::unit(near);
        let length = direction.norm2().sqrt();
        let rest = unit.cross(direction) / length;
        Double::exactly(near) + rest * Double::DEGREES
    }
}

impl Add for Double {
    type Output = Double;
    #[inline]
    fn add(self, o: Double) -> Double {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Double { hi, lo }
    }
}

impl AddAssign for Double {
    #[inline]
    fn add_assign(&mut self, o: Double) {
        *self = *self + o;
    }
}

impl Sub for Double {
    type Output = Double;
    #[inline]
    fn sub(self, o: Double) -> Double {
        self + -o
    }
}

impl Neg for Double {
    type Output = Double;
    #[inline]
    fn neg(self) -> Double {
        Double {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Mul for Double {
    type Output = Double;
    #[inline]
    fn mul(self, o: Double) -> Double {
        let (p, e) = two_product(self.hi, o.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * o.lo + self.lo * o.hi));
        Double { hi, lo }
    }
}

impl Div for Double {
    type Output = Double;
    #[inline]
    fn div(self, o: Double) -> Double {
        let first = self.hi / o.hi;
        let rest = self - o * Double::exactly(first);
        let second = rest.hi / o.hi;
        let rest = rest - o * Double::exactly(second);
        let third = rest.hi / o.hi;
        let (hi, lo) = quick_two_sum(first, second);
        Double { hi, lo } + Double::exactly(third)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(value: Double, hi: f64, lo: f64) {
        let off = value - Double { hi, lo };
        assert!(off.hi.abs() < 1e-31 * hi.abs().max(1.0), "{value:?}");
    }

    #[test]
    fn quotients_and_square_roots_have_double_double_precision() {
        let third = Double::ONE / Double::exactly(3.0);
        assert!((third * Double::exactly(3.0) - Double::ONE).hi.abs() < 1e-31);
        let root = Double::exactly(2.0).sqrt();
        assert_near(root, std::f64::consts::SQRT_2, -9.667_293_313_452_914e-17);
        assert_eq!(Double::exactly(9.0).sqrt(), Double::exactly(3.0));
        assert_eq!(Double::ZERO.sqrt(), Double::ZERO);
    }

    #[test]
    fn square_roots_of_squares_are_exact() {
        for x in [0.1, 250.0 / 256.0, 1.000_000_001, 3.7e-5] {
            let x = Double::exactly(x);
            assert_eq!((x * x).sqrt(), x);
        }
    }

    #[test]
    fn unit_vectors_have_exact_length_and_angle() {
        assert_eq!(Double::unit(450.0), Vec2::new(Double::ZERO, Double::ONE));
        let half = Double::unit(-30.0).y + Double::exactly(0.5);
        assert!(half.hi.abs() < 1e-31, "{half:?}");
        for k in 0..720_u16 {
            let angle = f64::from(k) * 0.517 - 180.0;
            let unit = Double::unit(angle);
            assert!((unit.norm2() - Double::ONE).hi.abs() < 1e-30);
            let back = Double::degrees(unit) - Double::exactly(angle);
            let off = back.hi.abs().min((back.hi.abs() - 360.0).abs());
            assert!(off < 1e-28, "{angle}: {off:e}");
        }
    }
}
