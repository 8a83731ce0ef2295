//! Finds two change points of a dyad close to each other, between which its input reverses.
//!
//! The reach of the dyad has three extremes there: both change points, and the reversal between
//! them. In doubles they cannot be told apart, because the reach itself differs by the fourth power
//! of their distance only. In double-double, the zeros of its derivative are those of a cubic
//! polynomial, which divides the series of the derivative.

use super::SingularGroup;
use crate::Double;
use crate::Number;
use crate::arithmetic::Series;
use crate::solver::elements::{Dyad, Pair, SingularShift};
use crate::solver::motion::tracking::Walker;
use crate::solver::state::State;

/// Maximum distance of the three extremes of a dyad or a coupled group from the centre of a series about
/// all of them, in radians or scaled lengths. If they are further apart, each has a series of its own.
pub(super) const SPREAD: f64 = 2e-2;
/// Distance below which both change points count as one, at which the motion reverses: the input
/// exceeds the change point by less than the rounding of a double.
const MERGED: f64 = 1e-8;
/// Distance below which the extremes are one extreme of a higher order.
const SINGLE: f64 = 1e-12;
/// Maximum radius of a disc that contains three zeros of the derivative and no others.
const DISC: f64 = 0.08;
/// Number of discs tried, each half as wide as the last.
const DISCS: i32 = 16;
/// Maximum number of corrections of the cubic polynomial. Each reduces the error by the ratio of
/// the extremes' distance to the radius of convergence.
const CORRECTIONS: usize = 30;
/// Relative size of a correction in double-double that ends the iteration.
const MAX_LAST_CORRECTION: f64 = 1e-28;
/// Distance within which two change points of one dyad are the same.
const EQUALITY_TOLERANCE: f64 = 1e-12;
/// Number of terms with which a pair is searched.
const FEW_TERMS: usize = 14;
/// Maximum number of moves of the centre.
const MOVES: usize = 5;
/// Maximum squared sine of a dyad that is almost in line at the reversal and needs a series.
/// Further away, doubles have enough digits.
const FLAT: f64 = 1e-10;
/// Maximum squared sine, at the centre, of a dyad that may have a pair of change points.
const NEARLY_FLAT: f64 = 1e-4;
/// Relative rounding error of a square in double-double, with a margin.
const ROUNDING: f64 = 1e-27;

/// Two close places at which a dyad is in line, or at which it would be if its input did not
/// reverse just before.
#[derive(Clone, Debug)]
pub(in crate::solver::motion) struct Paired {
    pub(super) pair: Pair,
    pub(super) snap: SingularShift,
    /// The distances from the centre at which the sign changes, in increasing order: two or none.
    pub(super) turns: Vec<Double>,
    /// The distance of the reversal from the centre.
    pub(super) middle: Double,
    /// The maximum distance of the places from the centre.
    pub(super) spread: f64,
    /// The sine of the transmission angle at the centre if the input reverses before the dyad is in
    /// line.
    pub(super) missed: Option<f64>,
}

/// A pair found near a coordinate.
#[derive(Clone, Debug)]
pub(in crate::solver::motion) struct PairFound {
    pub(in crate::solver::motion) step: usize,
    pub(in crate::solver::motion) centre: Double,
    /// The first place on the way at which the assemblies meet or almost meet.
    pub(in crate::solver::motion) first: f64,
    /// The last such place on the way.
    pub(in crate::solver::motion) last: f64,
    /// The distance of the places from the centre.
    pub(in crate::solver::motion) spread: f64,
}

impl Walker<'_> {
    /// Returns the first dyad, up to `step`, that has two change points close to each other and to
    /// a coordinate.
    pub(in crate::solver::motion) fn pair_near(
        &mut self,
        step: usize,
        at: f64,
    ) -> Option<PairFound> {
        let engine = self.engine;
        let is_close = |end: &f64| engine.difference(*end, at).abs() <= SPREAD;
        let end = engine.table_ends().find(is_close);
        let is_knot = end.is_some();
        let mut centre = Double::exactly(end.unwrap_or(at));
        for _ in 0..MOVES {
            let (step, paired) = self.pair_about(step, centre)?;
            if self.is_single(centre.hi) {
                return None;
            }
            // Beyond an end of a table the series does not hold: it starts there.
            if is_knot || paired.middle.abs().hi <= 1e-3 * paired.spread.max(MERGED) {
                let side = self.engine.inwards(centre.hi);
                let turns = paired.turns.iter().map(|by| by.hi);
                let turns: Vec<f64> = turns.filter(|by| by * side >= 0.0).collect();
                let place = |by: Option<&f64>| {
                    let by = Double::exactly(by.copied().unwrap_or(0.0));
                    self.moved_exactly(centre, by).hi
                };
                let [low, high] = [turns.first(), turns.last()].map(place);
                let [first, last] = if self.sense < 0.0 {
                    [high, low]
                } else {
                    [low, high]
                };
                return Some(PairFound {
                    step,
                    centre,
                    first,
                    last,
                    spread: paired.spread,
                });
            }
            centre = self.moved_exactly(centre, paired.middle);
        }
        None
    }

    /// Returns `true` if change points close to a coordinate are passed one by one.
    pub(super) fn is_single(&self, at: f64) -> bool {
        let last = self.singly;
        last.is_some_and(|last| self.sense * self.engine.difference(last, at) < EQUALITY_TOLERANCE)
    }

    /// Returns `true` if the walk has already passed a pair of change points.
    pub(in crate::solver::motion) fn is_passed(&self, pair: &PairFound) -> bool {
        let engine = self.engine;
        let group = engine.group_of(pair.step);
        group.is_some_and(|group| {
            self.crossings
                .has(engine, (group, pair.first), EQUALITY_TOLERANCE)
        })
    }

    /// Returns the first dyad, up to `step`, that has two change points close to a coordinate.
    fn pair_about(&mut self, step: usize, centre: Double) -> Option<(usize, Paired)> {
        let engine = &self.exact?.engine;
        let is_end = self.engine.inwards(centre.hi) != 0.0;
        let (q, direction) = self.coordinate_of(centre, FEW_TERMS);
        let mut series = engine.state::<Series>(self.state.travels.len());
        for i in 0..=step {
            let paired = engine.program.steps[i]
                .dyad()
                .and_then(|dyad| paired(dyad, q, (self.slack(), is_end), &series));
            if let Some(paired) = paired {
                return Some((i, paired));
            }
            if i < step {
                self.place_in_series(i..i + 1, centre.hi, q, direction, &mut series)?;
            }
        }
        None
    }
}

impl Paired {
    /// Creates the singular group of a step. `side` is the sign of the distances at which the
    /// motion exists, or 0.
    pub(super) fn group(&self, (step, group): (usize, usize), side: f64) -> SingularGroup {
        let turns = self.turns.iter().copied();
        SingularGroup {
            step,
            group,
            snap: self.snap,
            turns: turns.filter(|by| by.hi * side >= 0.0).collect(),
            spread: self.spread,
            pair: true,
            is_missed: self.missed.is_some(),
        }
    }
}

/// Returns the two change points of a dyad that are close to the centre of the series, which may be
/// an end of a table.
pub(super) fn paired(
    dyad: Dyad<'_>,
    q: Series,
    (slack, is_end): (f64, bool),
    state: &State<Series>,
) -> Option<Paired> {
    // At a simple end of the motion there is no cubic polynomial, which takes least to find out.
    let [reach, _] = dyad.reach(state);
    let cubic = cubic(reach.derivative())?;
    let spread = spread(cubic);
    let minimum = if is_end { 0.0 } else { SINGLE };
    if !(minimum..=SPREAD).contains(&spread) {
        return None;
    }
    let right = dyad.right_angle(q, state);
    let plain = dyad.height(q, SingularShift::default(), state);
    if !(plain.square.nearest().abs() <= NEARLY_FLAT * right) {
        return None;
    }
    let within = spread.max(MERGED);
    let (pair, middle) = divided(cubic, spread);
    let is_small = |v: Series| bound(&v.divided(pair.lower).1, within) <= 4.0 * slack;
    let meets = dyad.meeting(q, slack, state).is_some()
        && dyad
            .pivots(state)
            .is_some_and(|u| is_small(u.x) && is_small(u.y));
    let snap = SingularShift {
        equal_arms: meets,
        pair: meets.then_some(pair),
        ..SingularShift::default()
    };
    let height = dyad.height(q, snap, state);
    let (rest, remainder) = height.square.divided(pair.squared());
    let slope: f64 = height.slopes.iter().map(|s| s.nearest().abs()).sum();
    let allowed = 4.0 * slack * slope
        + (4.0 * slack).powi(2) * right.sqrt()
        + ROUNDING * (height.size.nearest() + right * within * within);
    if !(bound(&remainder, within) <= allowed && rest.nearest() > 0.0) {
        return None;
    }
    let zeros = pair.zeros().filter(|_| spread >= MERGED);
    let square = plain.square.nearest() / right;
    let is_missed = zeros.is_none() && spread >= MERGED;
    if is_missed && square > FLAT {
        return None;
    }
    Some(Paired {
        pair,
        snap,
        turns: zeros.into_iter().flatten().collect(),
        middle,
        spread,
        missed: is_missed.then(|| square.max(0.0).sqrt()),
    })
}

/// Two close places at which two solutions of a coupled group cross, or at which they would if the
/// group's input did not reverse just before.
pub(super) struct PairedOpening {
    pub(super) pair: Pair,
    /// The distances of both places from the centre, in increasing order; none if the solutions miss
    /// each other.
    pub(super) turns: Vec<Double>,
    /// The distance of the reversal from the centre.
    pub(super) middle: Double,
    /// The maximum distance of the places from the centre.
    pub(super) spread: f64,
}

/// Returns the two places close to the centre of a series at which a group's opening has a double
/// zero. An opening up to `slack` counts as zero.
pub(super) fn paired_opening(opening: Series, slack: f64) -> Option<PairedOpening> {
    let cubic = cubic(opening.derivative())?;
    let spread = spread(cubic);
    if !(MERGED..=SPREAD).contains(&spread) {
        return None;
    }
    let (pair, middle) = divided(cubic, spread);
    let (_, remainder) = opening.divided(pair.squared());
    let turns = pair.zeros().into_iter().flatten().collect();
    (bound(&remainder, spread) <= slack).then_some(PairedOpening {
        pair,
        turns,
        middle,
        spread,
    })
}

/// Returns a bound of a polynomial at all distances up to `spread`.
pub(super) fn bound(coefficients: &[Double], spread: f64) -> f64 {
    let sizes = coefficients.iter().rev().map(|c| c.abs().hi);
    sizes.fold(0.0, |sum, size| sum * spread + size)
}

/// Returns the coefficients, lowest first, of the polynomial t^3 + ... that divides a series and
/// contains its three zeros in a disc. Returns `None` if no disc provably contains exactly three.
fn cubic(rate: Series) -> Option<[Double; 3]> {
    let size = |n: usize| rate.c[n].abs().hi;
    // By Pellet's theorem.
    let has_three = |k: i32| {
        let radius = DISC * 0.5_f64.powi(k);
        let others = (0..rate.known).filter(|&n| n != 3);
        let others: f64 = others.map(|n| size(n) * radius.powi(n as i32)).sum();
        others < 0.8 * size(3) * radius.powi(3)
    };
    if rate.known < 8 || !(0..DISCS).any(has_three) {
        return None;
    }
    let mut lower = [Double::ZERO; 3];
    for _ in 0..CORRECTIONS {
        let (quotient, rest) = rate.divided(lower);
        let [a, b, c] = [quotient.c[0], quotient.c[1], quotient.c[2]];
        let first = rest[0] / a;
        let second = (rest[1] - b * first) / a;
        let third = (rest[2] - b * second - c * first) / a;
        let by = [first, second, third];
        for (of, by) in lower.iter_mut().zip(by) {
            *of += by;
        }
        let spread = spread(lower);
        let mut sizes = by.iter().zip([3, 2, 1]);
        if sizes.all(|(by, power)| by.abs().hi <= MAX_LAST_CORRECTION * spread.powi(power)) {
            break;
        }
    }
    Some(lower)
}

/// Returns the size of the zeros of a cubic polynomial: none is more than twice as large.
fn spread([c, b, a]: [Double; 3]) -> f64 {
    let [c, b, a] = [c, b, a].map(|v| v.hi.abs());
    c.cbrt().max(b.sqrt()).max(a)
}

/// Divides a cubic polynomial by its real zero, the middle one if there are three. Returns the
/// other two zeros, and this one.
fn divided(cubic: [Double; 3], spread: f64) -> (Pair, Double) {
    let [c, b, a] = cubic;
    if spread < MERGED {
        let middle = -a / Double::exactly(3.0);
        let lower = [middle * middle, -middle.scaled(2.0)];
        return (Pair { lower }, middle);
    }
    let middle = middle_zero([c.hi / spread.powi(3), b.hi / spread.powi(2), a.hi / spread]);
    let mut middle = Double::exactly(middle * spread);
    for _ in 0..4 {
        let value = ((middle + a) * middle + b) * middle + c;
        let slope = (middle * Double::exactly(3.0) + a.scaled(2.0)) * middle + b;
        middle += -(value / slope);
    }
    let p = a + middle;
    let lower = [b + middle * p, p];
    (Pair { lower }, middle)
}

/// Returns the real zero of x^3 + a x^2 + b x + c, the middle one if there are three.
fn middle_zero([c, b, a]: [f64; 3]) -> f64 {
    let third = a / 3.0;
    let p = b - a * third;
    let q = third * (2.0 * third * third - b) + c;
    let discriminant = 0.25 * q * q + (p / 3.0).powi(3);
    if discriminant < 0.0 {
        let radius = (-p / 3.0).sqrt();
        let angle = (-0.5 * q / radius.powi(3)).clamp(-1.0, 1.0).acos() / 3.0;
        return 2.0 * radius * (angle - std::f64::consts::TAU / 3.0).cos() - third;
    }
    let root = discriminant.sqrt();
    let larger = (-0.5 * q - root.copysign(q)).cbrt();
    let smaller = if larger == 0.0 {
        0.0
    } else {
        -p / (3.0 * larger)
    };
    larger + smaller - third
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (t - 1e-6) (t - 3e-6) (t + 2e-6) (1 + 5 t)
    #[test]
    fn cubic_and_its_zeros_are_found_in_double_double() {
        let zeros = [-2e-6, 1e-6, 3e-6].map(Double::exactly);
        let steep = Series::line(Double::ONE, Double::exactly(5.0)).cut(9);
        let product = zeros.iter().fold(steep, |p, &zero| p.multiplied([-zero]));
        let cubic = cubic(product).unwrap();
        let (pair, middle) = divided(cubic, spread(cubic));
        let [low, high] = pair.zeros().unwrap();
        for (found, expected) in [low, middle, high].into_iter().zip(zeros) {
            assert!(
                (found - expected).abs().hi < 1e-30,
                "{found:?} {expected:?}"
            );
        }
    }

    #[test]
    fn middle_zero_is_the_only_real_one() {
        // (x - 0.5) (x^2 + 1)
        assert!((middle_zero([-0.5, 1.0, -0.5]) - 0.5).abs() < 1e-15);
        assert!((middle_zero([0.0, -1.0, 0.0])).abs() < 1e-15);
    }
}
