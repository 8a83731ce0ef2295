//! Implements arithmetic on several doubles at once, one for each of several states solved
//! together.
//!
//! It uses no vector types or intrinsics: compilers turn plain arrays into the vector instructions
//! of the target. For that reason everything is inlined, even where a call would do. The operations
//! are written without loops, because unrolling thousands of loops in one function took the
//! compiler as long as the rest of this crate.

use super::angle;
use crate::{Constant, Number, Vec2};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Number of states solved at once: two AVX2 registers, so that one computes while the other waits,
/// or four of SSE2 or Neon.
pub const LANES: usize = 8;

/// A double in each lane. Every operation acts on each lane separately and nothing is fused, so
/// that each state has the same bits as when solved alone. Operations that combine all lanes say
/// so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

impl Lanes {
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Lanes {
        let [a, b, c, d, e, g, h, i] = self.0;
        Lanes([f(a), f(b), f(c), f(d), f(e), f(g), f(h), f(i)])
    }

    #[inline(always)]
    fn with(self, other: Lanes, f: impl Fn(f64, f64) -> f64) -> Lanes {
        let (a, b) = (self.0, other.0);
        Lanes([
            f(a[0], b[0]),
            f(a[1], b[1]),
            f(a[2], b[2]),
            f(a[3], b[3]),
            f(a[4], b[4]),
            f(a[5], b[5]),
            f(a[6], b[6]),
            f(a[7], b[7]),
        ])
    }

    /// Returns `true` if a condition holds in every lane.
    #[inline(always)]
    pub(crate) fn all(self, holds: impl Fn(f64) -> bool) -> bool {
        let [a, b, c, d, e, g, h, i] = self.0;
        (holds(a) & holds(b) & holds(c) & holds(d)) & (holds(e) & holds(g) & holds(h) & holds(i))
    }
}

impl Add for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn add(self, o: Lanes) -> Lanes {
        self.with(o, |a, b| a + b)
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, o: Lanes) {
        *self = *self + o;
    }
}

impl Sub for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn sub(self, o: Lanes) -> Lanes {
        self.with(o, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, o: Lanes) -> Lanes {
        self.with(o, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn div(self, o: Lanes) -> Lanes {
        self.with(o, |a, b| a / b)
    }
}

impl Neg for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn neg(self) -> Lanes {
        self.each(|a| -a)
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn of(constant: Constant) -> Lanes {
        Lanes([constant.hi; LANES])
    }

    #[inline(always)]
    fn exactly(value: f64) -> Lanes {
        Lanes([value; LANES])
    }

    /// Returns the value of the first lane.
    #[inline(always)]
    fn nearest(self) -> f64 {
        self.0[0]
    }

    /// Returns `true` if every lane is finite.
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.all(f64::is_finite)
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> Lanes {
        self.each(|a| a * power_of_two)
    }

    #[inline(always)]
    fn sqrt(self) -> Lanes {
        self.each(f64::sqrt)
    }

    #[inline(always)]
    fn abs(self) -> Lanes {
        self.each(f64::abs)
    }

    #[inline(always)]
    fn min(self, other: Lanes) -> Lanes {
        self.with(other, f64::min)
    }

    /// Returns `true` if it holds in every lane.
    #[inline(always)]
    fn exceeds(self, other: Lanes) -> bool {
        let (a, b) = (self.0, other.0);
        let low = (a[0] > b[0]) & (a[1] > b[1]) & (a[2] > b[2]) & (a[3] > b[3]);
        let high = (a[4] > b[4]) & (a[5] > b[5]) & (a[6] > b[6]) & (a[7] > b[7]);
        low & high
    }

    #[inline(always)]
    fn unit(degrees: Lanes) -> Vec2<Lanes> {
        let mut unit: Vec2<Lanes> = Vec2::default();
        if degrees.all(angle::is_reduced) {
            for (i, &degrees) in degrees.0.iter().enumerate() {
                (unit.x.0[i], unit.y.0[i]) = angle::components(degrees);
            }
            unit
        } else {
            far_unit(degrees)
        }
    }

    fn norm(vector: Vec2<Lanes>) -> Lanes {
        vector.x.with(vector.y, f64::hypot)
    }

    fn degrees(direction: Vec2<Lanes>) -> Lanes {
        let degrees = |x, y| angle::degrees(Vec2::new(x, y));
        direction.x.with(direction.y, degrees)
    }

    fn wrapped(degrees: Lanes) -> Lanes {
        degrees.each(angle::wrapped)
    }
}

/// Computes the unit vector lane by lane, for angles too large for the vectorized reduction.
#[cold]
fn far_unit(degrees: Lanes) -> Vec2<Lanes> {
    let units = degrees.0.map(angle::unit);
    Vec2::new(Lanes(units.map(|u| u.x)), Lanes(units.map(|u| u.y)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same(lanes: Lanes, alone: [f64; LANES]) -> bool {
        let bits = |v: f64| if v.is_nan() { None } else { Some(v.to_bits()) };
        lanes.0.map(bits) == alone.map(bits)
    }

    proptest! {
        /// Tests arbitrary doubles, including infinite and subnormal ones and NaN.
        #[test]
        fn lanes_match_scalar_results_bit_for_bit(a: [u64; LANES], b: [u64; LANES], small: [i32; LANES]) {
            let [a, b] = [a, b].map(|bits| bits.map(f64::from_bits));
            let two = |f: fn(f64, f64) -> f64| -> [f64; LANES] {
                std::array::from_fn(|i| f(a[i], b[i]))
            };
            let (x, y) = (Lanes(a), Lanes(b));
            prop_assert!(same(x + y, two(|a, b| a + b)));
            prop_assert!(same(x - y, two(|a, b| a - b)));
            prop_assert!(same(x * y, two(|a, b| a * b)));
            prop_assert!(same(x / y, two(|a, b| a / b)));
            prop_assert!(same(-x, a.map(|a| -a)));
            prop_assert!(same(x.min(y), two(f64::min)));
            prop_assert!(same(x.sqrt(), a.map(f64::sqrt)));
            prop_assert!(same(x.abs(), a.map(f64::abs)));
            prop_assert!(same(x.scaled(0.5), a.map(|a| 0.5 * a)));
            prop_assert_eq!(x.exceeds(y), a.iter().zip(b).all(|(a, b)| *a > b));
            prop_assert_eq!(x.is_finite(), a.iter().all(|a| a.is_finite()));
            let vector = Vec2::new(x, y);
            prop_assert!(same(Lanes::norm(vector), two(f64::hypot)));
            prop_assert!(same(Lanes::degrees(vector), two(|x, y| angle::degrees(Vec2::new(x, y)))));
            prop_assert!(same(Lanes::wrapped(x), a.map(angle::wrapped)));
            // Small and large angles: large ones take another code path.
            for angles in [a, small.map(|s| f64::from(s) * 1e-3), small.map(f64::from)] {
                let unit = Lanes::unit(Lanes(angles));
                prop_assert!(same(unit.x, angles.map(|a| angle::unit(a).x)));
                prop_assert!(same(unit.y, angles.map(|a| angle::unit(a).y)));
            }
        }
    }

    #[test]
    fn comparisons_require_all_lanes() {
        let ones = Lanes([1.0; LANES]);
        for lane in 0..LANES {
            for value in [0.0, -1.0, f64::NAN] {
                let mut but_one = ones;
                but_one.0[lane] = value;
                assert!(!but_one.exceeds(Lanes::default()), "{value} in {lane}");
                assert_eq!(but_one.is_finite(), value.is_finite());
            }
        }
        assert!(ones.exceeds(Lanes::default()));
    }
}
