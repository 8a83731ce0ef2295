//! Computes sines, directions, exponentials and logarithms of formulas, with error bounds.

use super::wide::Wide;
use num_bigint::BigInt;
use std::sync::LazyLock;

/// Bits of a result; `1 + exp(-700)` leaves a margin of 300.
const BITS: u64 = 1280;
/// Additional bits for the digits that squaring loses.
const GUARD: u64 = 64;
/// Number of times that the argument of a series is halved, and its result squared.
const HALVINGS: i64 = 16;
/// Maximum exponent of e is 2^19: larger ones do not occur in formulas.
const MAX_EXPONENT_TOP: i64 = 20;
/// Bits of the steps that refine a direction: each triples the digits.
const DIRECTION_STEPS: [u64; 3] = [160, 448, BITS];
/// Bits of the steps that refine a logarithm: the initial value of a large one has fewer digits.
const LOGARITHM_STEPS: [u64; 4] = [160, 320, 896, BITS];

/// pi, by Machin's formula.
pub(super) static PI: LazyLock<Wide> = LazyLock::new(|| {
    let far = arctangent_of_inverse(5).times(&Wide::integer(16));
    far.minus(&arctangent_of_inverse(239).times(&Wide::integer(4)))
});

/// The number of degrees in a radian.
pub(super) static DEGREES: LazyLock<Wide> =
    LazyLock::new(|| Wide::integer(180).over_to(&PI, BITS + GUARD));

static LN_10: LazyLock<Wide> =
    LazyLock::new(|| logarithm(&Wide::integer(10)).unwrap_or(Wide::ZERO));

/// Computes arctan(1 / n) = 1 / n - 1 / (3 n^3) + ..., whose remainder is less than its last term.
fn arctangent_of_inverse(n: i32) -> Wide {
    let (bits, square) = (BITS + GUARD, Wide::integer(n * n));
    let mut power = Wide::integer(1).over_to(&Wide::integer(n), bits);
    let mut sum = power.clone();
    let mut k = 1;
    while power.largest_top() > -bits.cast_signed() {
        power = power.over_to(&square, bits).negative();
        k += 2;
        sum = sum.plus(&power.over_to(&Wide::integer(k), bits));
    }
    sum.widened(power.largest_top())
}

/// Sums x^n / n! for |x| < 1/2 into two series, over even and odd n. `turn` is -1 for cosine and
/// sine, 1 for the exponential.
///
/// The terms are integers in units of the last bit: they become shorter as they become smaller.
fn series(x: &Wide, turn: i32, bits: u64) -> [Wide; 2] {
    // The last bit of the terms: a small x keeps all its digits.
    let last = x.top().min(0) - bits.cast_signed();
    let places = last.unsigned_abs();
    let (x, off) = x.aligned(last);
    let mut term = BigInt::from(1) << places;
    let mut sums = [term.clone(), BigInt::ZERO];
    let mut n = 0_u32;
    while term != BigInt::ZERO {
        n += 1;
        // Two roundings of less than 1, and at most half of the error of the term before: less than 4.
        term = ((term * &x) >> places) / n;
        if n.is_multiple_of(2) {
            term *= turn;
        }
        sums[usize::from(n % 2 == 1)] += &term;
    }
    // The remainder is less than the last term, which is less than 5. The derivative is less than 2.
    let radius = off * 2_u8 + (4 * n + 8);
    sums.map(|sum| Wide::ball(sum, radius.clone(), last).rounded(bits))
}

/// Returns the cosine and sine of an angle in degrees; `None` if the angle is too large or its
/// bound too wide.
pub(super) fn unit(degrees: &Wide) -> Option<[Wide; 2]> {
    unit_to(degrees, BITS)
}

fn unit_to(degrees: &Wide, bits: u64) -> Option<[Wide; 2]> {
    const MAX_TOP: i64 = 2048;
    if degrees.largest_top() > MAX_TOP {
        return None;
    }
    let right = Wide::integer(90);
    let quarters = degrees.over(&right).nearest_integer();
    let rest = degrees.minus(&right.times(&Wide::integer(quarters.clone())));
    // 45 degrees, plus the bound.
    if rest.largest_top() > 8 {
        return None;
    }
    let [cosine, sine] = match rest.is_zero() {
        true => [Wide::integer(1), Wide::ZERO],
        false => unit_of_rest(&rest, bits + GUARD),
    };
    Some(match u8::try_from(quarters & BigInt::from(3)) {
        Ok(0) => [cosine, sine],
        Ok(1) => [sine.negative(), cosine],
        Ok(2) => [cosine.negative(), sine.negative()],
        _ => [sine, cosine.negative()],
    })
}

/// Returns the cosine and sine of a small angle, by squaring those of a much smaller one.
fn unit_of_rest(degrees: &Wide, bits: u64) -> [Wide; 2] {
    let radians = degrees.over_to(&DEGREES, bits);
    let [mut cosine, mut sine] = series(&radians.scaled(-HALVINGS), -1, bits);
    for _ in 0..HALVINGS {
        let product = cosine.times(&sine).scaled(1);
        cosine = cosine
            .times(&cosine)
            .minus(&sine.times(&sine))
            .rounded(bits);
        sine = product.rounded(bits);
    }
    [cosine, sine]
}

/// Returns the direction in degrees, from -180 to 180, of a nonzero vector; `None` if the vector
/// may be zero.
pub(super) fn direction(x: &Wide, y: &Wide) -> Option<Wide> {
    if y.is_zero() {
        return Some(Wide::integer(if x.is_negative() { 180 } else { 0 }));
    }
    if x.is_zero() {
        return Some(Wide::integer(if y.is_negative() { -90 } else { 90 }));
    }
    let top = x.top().max(y.top());
    let [x, y] = [x, y].map(|part| part.clone().scaled(-top));
    let square = x.times(&x).plus(&y.times(&y)).rounded(BITS + GUARD);
    let length = square.root();
    let near = y.nearest().atan2(x.nearest()).to_degrees();
    let mut angle = Wide::exactly(near);
    for bits in DIRECTION_STEPS {
        let [cosine, sine] = unit_to(&angle, bits)?;
        let across = cosine.times(&y).minus(&sine.times(&x));
        let off = across.over_to(&length, bits + GUARD);
        if off.largest_top() > -2 {
            return None;
        }
        // An angle exceeds its sine by less than the cube of the sine; a radian is less than 2^6
        // degrees.
        let beyond = 3 * off.largest_top() + 6;
        let degrees = off.times(&DEGREES).rounded(bits + GUARD);
        let refined = angle.plus(&degrees).widened(beyond);
        if bits == BITS {
            return Some(refined);
        }
        angle = refined.middle();
    }
    None
}

/// Returns e to this power; `None` if the power is too large.
pub(super) fn exponential(power: &Wide) -> Option<Wide> {
    exponential_to(power, BITS)
}

fn exponential_to(power: &Wide, bits: u64) -> Option<Wide> {
    if power.is_zero() {
        return Some(Wide::integer(1));
    }
    if power.largest_top() > MAX_EXPONENT_TOP {
        return None;
    }
    let bits = bits + GUARD;
    let halvings = HALVINGS + power.largest_top().max(0);
    let small = power.clone().rounded(bits).scaled(-halvings);
    let [even, odd] = series(&small, 1, bits);
    let squared = |value: Wide, _| value.times(&value).rounded(bits);
    Some((0..halvings).fold(even.plus(&odd), squared))
}

/// Returns the natural logarithm of a positive number; `None` if no digit of it is known.
pub(super) fn logarithm(of: &Wide) -> Option<Wide> {
    let top = of.top();
    let part = of.clone().scaled(-top).nearest();
    let near = part.ln() + top as f64 * std::f64::consts::LN_2;
    let mut found = Wide::exactly(near);
    let one = Wide::integer(1);
    for bits in LOGARITHM_STEPS {
        let over = of.times(&exponential_to(&found.negative(), bits)?);
        let off = over.minus(&one);
        if off.largest_top() > -2 {
            return None;
        }
        // ln(1 + e) differs from 2 e / (2 + e) by less than the cube of e.
        let beyond = 3 * off.largest_top();
        let more = off.scaled(1).over_to(&over.plus(&one), bits + GUARD);
        let refined = match more.is_zero() {
            true => found,
            false => found.plus(&more).rounded(bits + GUARD).widened(beyond),
        };
        if bits == BITS {
            return Some(refined);
        }
        found = refined.middle();
    }
    None
}

/// Returns the logarithm to base 10.
pub(super) fn decimal_logarithm(of: &Wide) -> Option<Wide> {
    let logarithm = logarithm(of)?;
    Some(logarithm.over_to(&LN_10, BITS + GUARD))
}
