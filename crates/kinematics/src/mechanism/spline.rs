//! Interpolates knots by cubic splines: piecewise cubics with continuous values, slopes and second
//! derivatives.
//!
//! With M the second derivatives at the knots, h the widths and d the slopes of the chords, the
//! slopes are continuous if h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (d1 - d0).

use crate::{Constant, Number};

/// A clamped cubic spline: its slope is zero at both ends.
#[derive(Clone, Debug, PartialEq)]
pub struct ClampedSpline {
    curve: Spline,
}

impl ClampedSpline {
    /// Creates a spline through the knots. Returns `None` for fewer than two, if their positions do
    /// not increase, or if a number is not finite.
    #[must_use]
    pub fn new(knots: Vec<[f64; 2]>) -> Option<ClampedSpline> {
        let curve = Spline::new(knots, SplineEnds::AtRest)?;
        Some(ClampedSpline { curve })
    }

    /// Returns the first and the last knot.
    #[must_use]
    pub fn ends(&self) -> [[f64; 2]; 2] {
        self.curve.ends()
    }

    /// Returns the knots, each a position and the value there.
    #[must_use]
    pub fn knots(&self) -> &[[f64; 2]] {
        self.curve.knots()
    }

    /// Returns the value and its first two derivatives at a position; beyond an end, those at that
    /// end.
    #[must_use]
    pub fn at(&self, place: f64) -> [f64; 3] {
        self.curve.at(place)
    }

    /// Returns the positions where the slope is 0, in order.
    pub fn turns(&self) -> Vec<f64> {
        self.curve.turns()
    }

    /// Returns the beginning and the coefficients of each cubic, computed from the knots as typed.
    pub(super) fn cubics(&self) -> Vec<(Constant, [Constant; 4])> {
        let knots = self.curve.knots.iter();
        let knots: Vec<[Constant; 2]> = knots.map(|knot| knot.map(Constant::given)).collect();
        let bends = bends(&knots, SplineEnds::AtRest);
        let pairs = knots.windows(2).zip(bends.windows(2));
        let mut cubics: Vec<_> = pairs
            .map(|(knots, bends)| {
                let cubic = cubic([knots[0], knots[1]], [bends[0], bends[1]]);
                (knots[0][0], cubic)
            })
            .collect();
        if let Some((_, first)) = cubics.first_mut() {
            first[1] = Constant::default();
        }
        cubics
    }

    /// Returns the maximum magnitudes of the slope and of the second derivative.
    pub(super) fn steepest(&self) -> [f64; 2] {
        self.curve.steepest()
    }
}

/// The end conditions of a spline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SplineEnds {
    /// Zero slope at both ends.
    AtRest,
    /// Periodic: slopes and second derivatives agree at both ends.
    Closed,
}

/// A cubic spline through knots.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Spline {
    /// The positions and the values there.
    knots: Vec<[f64; 2]>,
    /// The second derivatives at the knots.
    bends: Vec<f64>,
}

impl Spline {
    /// Creates a spline through the knots. Returns `None` for fewer than two, if their positions do
    /// not increase, or if a number is not finite.
    pub(crate) fn new(knots: Vec<[f64; 2]>, ends: SplineEnds) -> Option<Spline> {
        let grow = knots.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        let is_sound = knots.len() > 1 && grow && knots.iter().flatten().all(|x| x.is_finite());
        is_sound.then(|| Spline {
            bends: bends(&knots, ends),
            knots,
        })
    }

    /// Returns the knots, each a position and the value there: at least two.
    pub(crate) fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Returns the second derivatives at the knots.
    pub(crate) fn bends(&self) -> &[f64] {
        &self.bends
    }

    /// Returns the first and the last knot.
    pub(crate) fn ends(&self) -> [[f64; 2]; 2] {
        [self.knots[0], self.knots[self.knots.len() - 1]]
    }

    /// Returns the value and its first two derivatives at a position; beyond an end, those at that
    /// end.
    pub(crate) fn at(&self, place: f64) -> [f64; 3] {
        let last = self.knots.len() - 1;
        let place = place.clamp(self.knots[0][0], self.knots[last][0]);
        let k = self.knots.partition_point(|knot| knot[0] <= place);
        let k = k.clamp(1, last) - 1;
        let [[begin, low], [end, high]] = [self.knots[k], self.knots[k + 1]];
        let [first, second] = [self.bends[k], self.bends[k + 1]];
        let h = end - begin;
        let (b, a) = ((place - begin) / h, (end - place) / h);
        let cubic = |s: f64| s * (s * s - 1.0);
        let slope = |s: f64| 3.0 * s * s - 1.0;
        [
            a * low + b * high + (cubic(a) * first + cubic(b) * second) * h * h / 6.0,
            (high - low) / h + (slope(b) * second - slope(a) * first) * h / 6.0,
            a * first + b * second,
        ]
    }

    /// Returns the cubics in order.
    fn parts(&self) -> impl Iterator<Item = SplinePart> {
        let bends = self.bends.windows(2);
        self.knots.windows(2).zip(bends).map(|(knots, bends)| {
            let ([begin, low], [end, high]) = (knots[0], knots[1]);
            let h = end - begin;
            SplinePart {
                begin,
                length: h,
                bends: [bends[0], bends[1]],
                // Coefficients of the slope as a quadratic in the fraction b of the width.
                slope: [
                    (high - low) / h - (2.0 * bends[0] + bends[1]) * h / 6.0,
                    bends[0] * h,
                    0.5 * (bends[1] - bends[0]) * h,
                ],
            }
        })
    }

    /// Returns the positions where the slope is 0, in order.
    fn turns(&self) -> Vec<f64> {
        self.parts().flat_map(|part| part.turns()).collect()
    }

    /// Returns the maximum magnitudes of the slope and of the second derivative.
    fn steepest(&self) -> [f64; 2] {
        let sizes = self.parts().flat_map(|part| {
            // The slope is largest at an end or where the second derivative is zero.
            let [first, second] = part.bends;
            let level = first / (first - second);
            let inside = Some(level).filter(|b| (0.0..1.0).contains(b));
            let places = [Some(0.0), Some(1.0), inside].into_iter().flatten();
            places.map(move |b| part.slope_at(b).abs())
        });
        let bends = self.bends.iter().map(|bend| bend.abs());
        [sizes.fold(0.0, f64::max), bends.fold(0.0, f64::max)]
    }
}

/// One cubic of a spline.
struct SplinePart {
    begin: f64,
    length: f64,
    /// The second derivatives at its ends.
    bends: [f64; 2],
    slope: [f64; 3],
}

impl SplinePart {
    /// Returns the slope at the fraction `b` of the width.
    fn slope_at(&self, b: f64) -> f64 {
        let [c, d, e] = self.slope;
        c + b * (d + b * e)
    }

    /// Returns the positions where the slope is 0.
    fn turns(&self) -> impl Iterator<Item = f64> + use<> {
        let ([c, d, e], begin, length) = (self.slope, self.begin, self.length);
        // Avoids cancellation in the quadratic formula.
        let q = -0.5 * (d + (d * d - 4.0 * e * c).sqrt().copysign(d));
        let mut roots = [q / e, c / q];
        roots.sort_by(f64::total_cmp);
        let inside = roots.into_iter().filter(|b| (0.0..=1.0).contains(b));
        inside.map(move |b| begin + b * length)
    }
}

/// Returns the coefficients c0 + c1 d + c2 d^2 + c3 d^3 of the cubic between two knots, with d
/// measured from the first knot. `first` and `second` are the second derivatives at the knots.
pub(crate) fn cubic<T: Number>(
    [[begin, low], [end, high]]: [[T; 2]; 2],
    [first, second]: [T; 2],
) -> [T; 4] {
    let width = end - begin;
    let six = T::exactly(6.0);
    let slope = (high - low) / width - width * (first.scaled(2.0) + second) / six;
    let third = (second - first) / (width * six);
    [low, slope, first.scaled(0.5), third]
}

/// Returns the second derivatives at the knots, of which there must be at least two.
pub(crate) fn bends<T: Number>(knots: &[[T; 2]], ends: SplineEnds) -> Vec<T> {
    let pairs = || knots.windows(2);
    let widths: Vec<T> = pairs().map(|pair| pair[1][0] - pair[0][0]).collect();
    let rises: Vec<T> = pairs()
        .zip(&widths)
        .map(|(pair, &width)| (pair[1][1] - pair[0][1]) / width)
        .collect();
    match ends {
        SplineEnds::AtRest => bends_at_rest(&widths, &rises),
        SplineEnds::Closed => bends_around(&widths, &rises),
    }
}

/// Solves for the second derivatives with zero slope at both ends: beyond them, the chord has slope
/// and width zero.
fn bends_at_rest<T: Number>(widths: &[T], rises: &[T]) -> Vec<T> {
    let last = widths.len();
    let before = |of: &[T], k: usize| if k > 0 { of[k - 1] } else { T::default() };
    let after = |of: &[T], k: usize| if k < last { of[k] } else { T::default() };
    let rows = (0..=last).map(|k| BendRow {
        pivot: T::exactly(2.0) * (before(widths, k) + after(widths, k)),
        next: after(widths, k),
        side: T::exactly(6.0) * (after(rises, k) - before(rises, k)),
    });
    solved(rows.collect())
}

/// Solves for the second derivatives of a periodic spline, whose last knot is the first. With s the
/// second derivative there, those of the other knots are u + s v; s follows from equal slopes at
/// the seam.
fn bends_around<T: Number>(widths: &[T], rises: &[T]) -> Vec<T> {
    let count = widths.len();
    let row = |k: usize, side: T| BendRow {
        pivot: T::exactly(2.0) * (widths[k - 1] + widths[k]),
        next: widths[k],
        side,
    };
    let turned = |before: usize, after: usize| T::exactly(6.0) * (rises[after] - rises[before]);
    let around = |inner: Vec<T>, end: T| {
        let ends = [end];
        let all = ends.iter().chain(&inner).chain(&ends);
        all.copied().collect::<Vec<T>>()
    };
    let inner = 1..count;
    let u = solved(inner.clone().map(|k| row(k, turned(k - 1, k))).collect());
    let ends_beside = |k: usize| {
        let first = if k == 1 { widths[0] } else { T::default() };
        let last = if k == count - 1 {
            widths[k]
        } else {
            T::default()
        };
        T::default() - (first + last)
    };
    let v = solved(inner.map(|k| row(k, ends_beside(k))).collect());
    let (u, v) = (around(u, T::default()), around(v, T::exactly(1.0)));
    let [first, last] = [widths[0], widths[count - 1]];
    let nearby = |of: &[T]| first * of[1] + last * of[count - 1];
    let pivot = T::exactly(2.0) * (first + last) + nearby(&v);
    let s = (turned(count - 1, 0) - nearby(&u)) / pivot;
    u.iter().zip(&v).map(|(&u, &v)| u + s * v).collect()
}

/// A row of a symmetric tridiagonal system.
struct BendRow<T> {
    pivot: T,
    /// The coefficient of the next unknown in this row, and of this unknown in the next row.
    next: T,
    side: T,
}

/// Solves a symmetric tridiagonal system by elimination from top to bottom and back substitution.
fn solved<T: Number>(mut rows: Vec<BendRow<T>>) -> Vec<T> {
    for k in 1..rows.len() {
        let BendRow { pivot, next, side } = rows[k - 1];
        let part = next / pivot;
        let row = &mut rows[k];
        row.pivot = row.pivot - part * next;
        row.side = row.side - part * side;
    }
    let mut found = vec![T::default(); rows.len()];
    let mut below = T::default();
    for (row, found) in rows.iter().zip(&mut found).rev() {
        below = (row.side - row.next * below) / row.pivot;
        *found = below;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// s^2 (3 - 2 s) is a cubic at rest at both ends, and the only such spline through its own
    /// knots.
    #[test]
    fn cubic_at_rest_at_both_ends_is_reproduced() {
        let cubic = |s: f64| s * s * (3.0 - 2.0 * s);
        for coordinates in [&[0.0, 1.0][..], &[0.0, 0.1, 0.25, 0.7, 1.0]] {
            let knots = coordinates.iter().map(|&s| [s, cubic(s)]).collect();
            let spline = ClampedSpline::new(knots).unwrap();
            for k in 0..=40 {
                let s = f64::from(k) / 40.0;
                let exact = [cubic(s), 6.0 * s * (1.0 - s), 6.0 - 12.0 * s];
                for (found, exact) in spline.at(s).into_iter().zip(exact) {
                    assert!((found - exact).abs() < 1e-13, "{s}: {found} for {exact}");
                }
            }
        }
    }

    /// Three knots leave one free slope m at (0.2, 40). The second derivatives of the Hermite
    /// cubics agree there if 2 m / h0 + 2 m / h1 = 3 d0 / h0 + 3 d1 / h1: m = 3 (200/0.2 + 80/0.3 *
    /// 1/0.3) / (2 (1/0.2 + 1/0.3)).
    #[test]
    fn slope_at_middle_of_three_knots_matches_formula() {
        let spline = ClampedSpline::new(vec![[0.0, 0.0], [0.2, 40.0], [0.5, 120.0]]).unwrap();
        let (rise, other) = (200.0 / 0.2, 80.0 / 0.3 / 0.3);
        let slope = 3.0 * (rise + other) / (2.0 * (5.0 + 1.0 / 0.3));
        let [value, found, _] = spline.at(0.2);
        assert!(
            (value - 40.0).abs() < 1e-12 && (found - slope).abs() < 1e-10,
            "{found} {slope}"
        );
        let distance = 1e-9;
        let [before, after] = [spline.at(0.2 - distance)[2], spline.at(0.2 + distance)[2]];
        assert!((before - after).abs() < 1e-3, "{before} {after}");
        assert_eq!([spline.at(-1.0)[1], spline.at(9.0)[0]], [0.0, 120.0]);
    }

    #[test]
    fn invalid_knots_are_rejected() {
        assert_eq!(ClampedSpline::new(vec![[0.0, 1.0]]), None);
        assert_eq!(ClampedSpline::new(vec![[0.0, 1.0], [0.0, 2.0]]), None);
        assert_eq!(ClampedSpline::new(vec![[0.0, 1.0], [1.0, f64::NAN]]), None);
    }
}
