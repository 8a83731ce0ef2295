//! Which of many linkages are different ones, and which of them come first.

use super::descent::Fit;
use super::shape::LinkageForm;
use super::wanted::{HeldPivots, WantedPath};
use kinematics::Vec2;

/// Linkages whose pivots and pins lie together within this part of their largest distance are one.
const ONE: f64 = 0.02;
/// A mean square of misses below this is rounding.
const ROUNDING: f64 = 1e-20;
/// Below this sine of the transmission angle a linkage is not told from one at a dead point, or at a change point, beyond
/// which it goes on in another way than its sign says.
const FLATTEST: f64 = 0.01;
/// No part is longer or shorter than this in sizes of the path.
const ENDS: [f64; 2] = [1e-3, 1e3];

/// How many different linkages are followed to the end, and how many more of those that keep the wishes.
const FOLLOWED: usize = 32;
const WISHED: usize = 16;

/// A linkage and what tells its place in the order.
#[derive(Clone, Debug)]
pub(super) struct Ranked {
    pub(super) fit: Fit,
    /// Whether its links close on the whole way without a dead point, with the crank turning one way.
    keeps: bool,
    /// Whether it keeps every wish.
    is_wished: bool,
    /// The largest of the lengths in sizes of the path, or the smallest turned over.
    extreme: f64,
    /// A, D, B and C at the first point.
    corners: [Vec2; 4],
}

impl Ranked {
    pub(super) fn of(fit: Fit, wanted: &WantedPath) -> Option<Ranked> {
        let first = *fit.angles.first()?;
        let [b, c, _] = fit.places(first);
        let a = fit.place.origin;
        let (d, far) = match fit.shape.form {
            LinkageForm::FourBar => (fit.far_pivot(), (c - fit.far_pivot()).norm()),
            // A slide has no pivot: the foot of its normal through A.
            LinkageForm::SliderCrank => {
                let foot = Vec2::new(0.0, fit.shape.far).turned(fit.place.scale);
                (a + foot, (c - b).norm())
            }
        };
        let lengths = [(b - a).norm(), (c - b).norm(), far];
        let extreme = lengths
            .iter()
            .map(|length| length.max(1.0 / length))
            .fold(0.0, f64::max);
        let is_one = fit.square.is_finite()
            && lengths
                .iter()
                .all(|length| (ENDS[0]..=ENDS[1]).contains(length))
            && [a, b, c, d].iter().all(|p| p.is_finite());
        is_one.then(|| Ranked {
            keeps: keeps(&fit, wanted),
            is_wished: wanted
                .wishes
                .lack(&fit.shape, &fit.place, ends(&fit, wanted))
                == 0.0,
            extreme,
            corners: [a, d, b, c],
            fit,
        })
    }

    /// What comes first is less.
    fn key(&self) -> (bool, f64, f64) {
        (!self.keeps, self.fit.square.max(ROUNDING), self.extreme)
    }

    fn is_one_with(&self, other: &Ranked, wanted: &WantedPath) -> bool {
        let (x, y) = (&self.fit, &other.fit);
        if x.shape.form != y.shape.form {
            return false;
        }
        let large = self.corners.iter().chain(&other.corners).map(|p| p.norm());
        let near = ONE * large.fold(1.0, f64::max);
        let together = |order: [usize; 4]| {
            let pairs = self.corners.iter().zip(order.map(|i| other.corners[i]));
            pairs.map(|(p, q)| (*p - q).norm()).all(|far| far < near)
        };
        // The same with crank and rocker exchanged, where the crank's angles do not count.
        let turns_over = x.shape.form == LinkageForm::FourBar
            && wanted.turns.is_none()
            && !matches!(x.quarry.held, HeldPivots::Both(..));
        together([0, 1, 2, 3]) || turns_over && together([1, 0, 3, 2])
    }
}

/// Whether a linkage closes on its whole way without a dead point, with the crank turning one way.
fn keeps(fit: &Fit, wanted: &WantedPath) -> bool {
    let angles = &fit.angles;
    let [low, high] = ends(fit, wanted);
    let (short, sine) = fit.shape.worst_between(low, high);
    if short > 0.0 || sine < FLATTEST {
        return false;
    }
    let ordered = |sense: f64| {
        angles
            .windows(2)
            .all(|pair| (pair[1] - pair[0]) * sense >= 0.0)
    };
    let [least, most] = extremes(angles);
    wanted.turns.is_some() || (most - least <= 360.0 && (ordered(1.0) || ordered(-1.0)))
}

/// The crank's least and greatest angle on its whole way, in degrees.
pub(super) fn ends(fit: &Fit, wanted: &WantedPath) -> [f64; 2] {
    match wanted.closed {
        true => [0.0, 360.0],
        false => extremes(&fit.angles),
    }
}

fn extremes(angles: &[f64]) -> [f64; 2] {
    let angles = angles.iter().copied();
    [
        angles.clone().fold(f64::INFINITY, f64::min),
        angles.fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// The best of all that are different; where something is wished, behind them the best that keep it.
pub(super) fn chosen(all: Vec<Ranked>, wanted: &WantedPath) -> Vec<Ranked> {
    let wished: Vec<Ranked> = match wanted.wishes.is_any() {
        true => all.iter().filter(|one| one.is_wished).cloned().collect(),
        false => Vec::new(),
    };
    let mut kept = distinct(all, wanted, FOLLOWED);
    for next in distinct(wished, wanted, WISHED) {
        if !kept.iter().any(|other| next.is_one_with(other, wanted)) {
            kept.push(next);
        }
    }
    kept
}

/// The best of all that are different, at most so many.
fn distinct(mut all: Vec<Ranked>, wanted: &WantedPath, most: usize) -> Vec<Ranked> {
    all.sort_by(|x, y| {
        let (x, y) = (x.key(), y.key());
        x.0.cmp(&y.0)
            .then(x.1.total_cmp(&y.1))
            .then(x.2.total_cmp(&y.2))
    });
    let mut kept: Vec<Ranked> = Vec::new();
    for next in all {
        if kept.len() >= most {
            break;
        }
        if !kept.iter().any(|other| next.is_one_with(other, wanted)) {
            kept.push(next);
        }
    }
    kept
}
