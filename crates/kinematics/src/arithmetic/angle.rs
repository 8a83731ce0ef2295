//! Converts angles in degrees to unit vectors and back.
//!
//! An angle is reduced exactly before any trigonometry. Multiples of 90 degrees therefore give
//! exact zeros and ones, and an angle a billion turns further gives the same bits as in the first
//! turn.

use super::double::SPLITTER;
use super::{Halves, U};
use crate::{Double, Vec2};

/// Degrees in a full turn.
pub const TURN: f64 = 360.0;

/// 1.5 * 2^52: adding and subtracting it rounds to the nearest integer without a library call.
const INTEGER_SHIFT: f64 = 6_755_399_441_055_744.0;
/// Below this, 90 times the number of quadrants is exact. Larger angles are first reduced by a
/// remainder.
const EXACT_QUADRANTS: f64 = 4_503_599_627_370_496.0; // 2^52

/// pi / 180 as the sum `RADIAN + RADIAN_REST`, and `RADIAN` itself split into 26 + 27 bits.
const RADIAN: f64 = 0.017_453_292_519_943_295;
const RADIAN_REST: f64 = 2.948_652_270_870_168_7e-19;
const RADIAN_TOP: f64 = 0.017_453_292_384_743_69;
const RADIAN_TAIL: f64 = RADIAN - RADIAN_TOP;

/// Converts degrees to radians.
#[must_use]
pub fn radians(degrees: f64) -> f64 {
    degrees * RADIAN
}

/// Returns the unit vector at `degrees` from +x, counter-clockwise. Each component is within 1 ulp
/// (measured: 0.6 ulp), exact at multiples of 90 degrees. Not finite if the angle is not finite.
#[inline]
#[must_use]
pub fn unit(degrees: f64) -> Vec2 {
    // The remainder is always exact.
    let reduced = if is_reduced(degrees) {
        degrees
    } else {
        degrees % TURN
    };
    let (x, y) = components(reduced);
    Vec2::new(x, y)
}

/// Returns `true` if the angle is small enough for its quadrants to be counted exactly.
#[inline(always)]
pub(super) fn is_reduced(degrees: f64) -> bool {
    degrees.abs() < EXACT_QUADRANTS
}

/// Returns the components of the unit vector at a reduced angle. Free of branches, so that it
/// vectorizes.
#[inline(always)]
pub(super) fn components(degrees: f64) -> (f64, f64) {
    // The lowest bits of the counter are the quadrant modulo 4. The subtraction is exact by
    // Sterbenz's lemma.
    let counter = degrees * (1.0 / 90.0) + INTEGER_SHIFT;
    let (sin, cos) = sin_cos(degrees - 90.0 * (counter - INTEGER_SHIFT));
    let quadrant = counter.to_bits();
    let odd = quadrant & 1 == 1;
    let (x, y) = if odd { (sin, cos) } else { (cos, sin) };
    // x is negative in quadrants 1 and 2, y in quadrants 2 and 3.
    let negative = |v: f64, bit: u64| f64::from_bits(v.to_bits() ^ ((bit & 2) << 62));
    (negative(x, quadrant.wrapping_add(1)), negative(y, quadrant))
}

/// Returns the unit vector at `degrees` in double-double, and an error bound for each component.
/// The bound is below an eighth of the rounding error of [`unit`].
#[inline(always)]
pub(crate) fn unit_closely<const FUSED: bool>(degrees: f64) -> (Vec2<Double>, Vec2) {
    let reduced = if is_reduced(degrees) {
        degrees
    } else {
        degrees % TURN
    };
    let counter = reduced * (1.0 / 90.0) + INTEGER_SHIFT;
    let (sin, cos, square) = sin_cos_closely::<FUSED>(reduced - 90.0 * (counter - INTEGER_SHIFT));
    // The rounding errors of the two series, each proportional to z^2: see `sin_cos_closely`.
    let off = [U * 0.06, U * 0.3].map(|part| part * square);
    let minus = |v: Double| -v;
    match counter.to_bits() & 3 {
        0 => (Vec2::new(cos, sin), Vec2::new(off[1], off[0])),
        1 => (Vec2::new(minus(sin), cos), Vec2::new(off[0], off[1])),
        2 => (Vec2::new(minus(cos), minus(sin)), Vec2::new(off[1], off[0])),
        _ => (Vec2::new(sin, minus(cos)), Vec2::new(off[0], off[1])),
    }
}

/// Returns the angle in radians as an unevaluated sum of two doubles.
#[inline(always)]
fn in_radians<const FUSED: bool>(degrees: f64) -> (f64, f64) {
    let x = degrees * RADIAN;
    if FUSED {
        let lost = degrees.mul_add(RADIAN, -x);
        return (x, lost + degrees * RADIAN_REST);
    }
    // Dekker's product: the rounding error of the multiplication above.
    let t = SPLITTER * degrees;
    let top = t - (t - degrees);
    let tail = degrees - top;
    let lost =
        ((top * RADIAN_TOP - x) + top * RADIAN_TAIL + tail * RADIAN_TOP) + tail * RADIAN_TAIL;
    (x, lost + degrees * RADIAN_REST)
}

/// Returns the sine and cosine of an angle of at most about 45 degrees in double-double, and the
/// fourth power of the angle in radians.
///
/// Uses Taylor series with z = x^2: x - x z / 6 + x z^2 (...) and 1 - z / 2 + z^2 (...). The terms
/// before the brackets are computed in double-double. The brackets are rounded: x z^2 / 120 six
/// times by u, z^2 / 24 five times. The omitted terms are below 2e-19 and 6e-18 z^2.
#[inline(always)]
fn sin_cos_closely<const FUSED: bool>(degrees: f64) -> (Double, Double, f64) {
    const SIXTH: f64 = 1.0 / 6.0;
    const SIXTH_REST: f64 = 9.251_858_538_542_97e-18;
    let (x, rest) = in_radians::<FUSED>(degrees);
    let halves = Halves::<FUSED>::of(x);
    let z = halves.square();
    let cube = halves.times(Halves::of(z.hi));
    let sixth = Halves::<FUSED>::of(cube.hi).times(Halves::of(SIXTH));
    let low = SIXTH * (cube.lo + x * z.lo) + cube.hi * SIXTH_REST;
    let z1 = z.hi;
    let z2 = z1 * z1;
    let z4 = z2 * z2;
    let s = ((1.0 / 120.0 - z1 * (1.0 / 5_040.0))
        + z2 * (1.0 / 362_880.0 - z1 * (1.0 / 39_916_800.0)))
        + z4 * ((1.0 / 6_227_020_800.0 - z1 * (1.0 / 1_307_674_368_000.0))
            + z2 * (1.0 / 355_687_428_096_000.0));
    let c = ((1.0 / 24.0 - z1 * (1.0 / 720.0)) + z2 * (1.0 / 40_320.0 - z1 * (1.0 / 3_628_800.0)))
        + z4 * ((1.0 / 479_001_600.0 - z1 * (1.0 / 87_178_291_200.0))
            + z2 * (1.0 / 20_922_789_888_000.0));
    let near_one = Double::sum(1.0, -0.5 * z.hi);
    let cos = Double::sum(near_one.hi, z2 * c);
    let cos_rest = cos.lo + near_one.lo - 0.5 * z.lo - rest * (x - sixth.hi);
    let sin = Double::sum(x, -sixth.hi);
    let sin_rest = sin.lo - sixth.lo - low + x * z2 * s + rest * cos.hi;
    (
        Double::sum(sin.hi, sin_rest),
        Double::sum(cos.hi, cos_rest),
        z2,
    )
}

/// Returns the sine and cosine of an angle of at most about 45 degrees.
///
/// The angle in radians is kept as `x + rest`, because its rounding alone would contribute as much
/// error as everything else. The polynomials are our own Chebyshev fits on |x| < 0.794, accurate to
/// 2e-17 relative in the sine and 2e-18 absolute in the cosine.
#[inline(always)]
fn sin_cos(degrees: f64) -> (f64, f64) {
    let (x, rest) = in_radians::<false>(degrees);
    let z = x * x;
    let z2 = z * z;
    let s = (-0.166_666_666_666_666_66 + z * 0.008_333_333_333_330_7)
        + z2 * ((-0.000_198_412_698_363_854_35 + z * 2.755_731_591_093_9e-6)
            + z2 * (-2.505_109_230_843_131_8e-8 + z * 1.591_530_918_305_795_2e-10));
    let c = (0.041_666_666_666_666_664 + z * -0.001_388_888_888_888_724_1)
        + z2 * ((2.480_158_729_853_226e-5 + z * -2.755_731_715_185_888_6e-7)
            + z2 * (2.087_612_153_460_845_4e-9 + z * -1.138_086_817_144_991_4e-11));

    let half = 0.5 * z;
    let near_one = 1.0 - half;
    let cos = near_one + (((1.0 - near_one) - half) + (z2 * c - x * rest));
    let sin = x + (x * z * s + rest * near_one);
    (sin, cos)
}

/// Returns the direction of a vector in degrees, in [0, 360); 0 for the null vector.
#[must_use]
pub fn degrees(direction: Vec2) -> f64 {
    let degrees = direction.y.atan2(direction.x).to_degrees();
    wrapped(degrees)
}

/// Shifts a direction by whole turns to within half a turn of `other`, in degrees.
pub fn unwrap_near(other: f64, direction: f64) -> f64 {
    unwrap_within(TURN, other, direction)
}

/// Shifts a value by whole periods to within half a period of `other`.
pub fn unwrap_within(period: f64, other: f64, value: f64) -> f64 {
    value - period * ((value - other) / period).round()
}

/// Returns the equivalent angle in [0, 360); one that rounds to 360 becomes 0.
#[must_use]
pub fn wrapped(degrees: f64) -> f64 {
    let rest = degrees % TURN;
    let positive = if rest < 0.0 { rest + TURN } else { rest };
    // Adding 0.0 also clears the sign of a negative zero.
    if positive >= TURN {
        0.0
    } else {
        positive + 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_of_90_degrees_are_exact() {
        let exact = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for k in -8..9_i32 {
            let expected = exact[k.rem_euclid(4) as usize];
            let u = unit(90.0 * f64::from(k));
            assert_eq!((u.x, u.y), expected, "at {} deg", 90 * k);
        }
    }

    #[test]
    fn whole_turns_do_not_change_any_bit() {
        for k in 0..3600_i32 {
            let angle = f64::from(k) * 0.125 + 0.0625;
            let later = 360.0e9 + angle;
            assert_eq!(
                later - 360.0e9,
                angle,
                "the test's own angles must be exact"
            );
            assert_eq!(unit(later), unit(angle));
            assert_eq!(unit(angle - 360.0), unit(angle));
        }
        let far = 360.0 * 2.0_f64.powi(60);
        assert_eq!(unit(far + 0.0), Vec2::X);
    }

    #[test]
    fn close_unit_is_within_its_bound() {
        for k in -40_000..40_000_i32 {
            let angle = f64::from(k) * 0.017_1;
            let (close, off) = unit_closely::<false>(angle);
            let miss = (close - Double::unit(angle)).map(|v| v.hi.abs());
            let maximum = off.map(|v| v + 1e-19);
            assert!(
                miss.x <= maximum.x && miss.y <= maximum.y,
                "{angle}: {miss:?} {off:?}"
            );
            assert!(off.x < 0.12 * U && off.y < 0.12 * U, "{angle}");
            let near = close.map(|v| v.hi) - unit(angle);
            assert!(near.x.abs() <= U && near.y.abs() <= U, "{angle}");
        }
    }

    #[test]
    fn unit_agrees_with_platform_within_rounding() {
        // The platform's functions take radians, whose rounding alone is half an ulp of the angle.
        for k in -40_000..40_000_i32 {
            let angle = f64::from(k) * 0.0071;
            let u = unit(angle);
            let rad = angle.to_radians();
            let slack = 2.0 * f64::EPSILON * (1.0 + rad.abs());
            assert!(
                (u.x - rad.cos()).abs() < slack && (u.y - rad.sin()).abs() < slack,
                "{angle}"
            );
        }
    }

    #[test]
    fn directions_are_in_half_open_turn() {
        assert_eq!(degrees(Vec2::new(1.0, -1e-30)), 0.0);
        assert_eq!(degrees(Vec2::new(0.0, -1.0)), 270.0);
        assert!(wrapped(-0.0).is_sign_positive());
        assert_eq!(wrapped(-450.0), 270.0);
    }
}
