//! Selects the distinct linkages of many and ranks them.

use super::descent::Fit;
use super::shape::LinkageForm;
use super::task::{GivenPivots, TargetPath};
use kinematics::Vec2;

/// Linkages count as one if their pivots and pins agree within this fraction of their largest distance.
const ONE: f64 = 0.02;
/// Mean square of misses below which only rounding remains.
const ROUNDING: f64 = 1e-20;
/// Sine of the transmission angle below which a linkage cannot be distinguished from one at a dead
/// point or a change point. Beyond such a point it may continue in the other assembly than its sign
/// says.
const MIN_TRANSMISSION_SINE: f64 = 0.01;
/// Minimum and maximum of every length, in sizes of the path.
const ENDS: [f64; 2] = [1e-3, 1e3];

/// Number of different linkages followed to the end, and the number of additional ones that meet
/// the preferences.
const MAX_FOLLOWED: usize = 32;
const MAX_PREFERRED: usize = 16;

/// A linkage with the values that determine its rank.
#[derive(Clone, Debug)]
pub(super) struct Ranked {
    pub(super) fit: Fit,
    /// Whether its links close over the whole task without a dead point, with the crank turning one
    /// way.
    keeps: bool,
    /// `true` if the linkage meets every preference.
    is_wished: bool,
    /// The largest length in sizes of the path, or the reciprocal of the smallest, whichever is
    /// larger.
    extreme: f64,
    /// A, D, B and C at the first point.
    corners: [Vec2; 4],
}

impl Ranked {
    pub(super) fn of(fit: Fit, target: &TargetPath) -> Option<Ranked> {
        let first = *fit.angles.first()?;
        let [b, c, _] = fit.places(first);
        let a = fit.place.origin;
        let (d, far) = match fit.shape.form {
            LinkageForm::FourBar => (fit.far_pivot(), (c - fit.far_pivot()).norm()),
            // A slide has no pivot: the foot of its normal through A is used.
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
            keeps: keeps(&fit, target),
            is_wished: target
                .preferences
                .violation(&fit.shape, &fit.place, ends(&fit, target))
                == 0.0,
            extreme,
            corners: [a, d, b, c],
            fit,
        })
    }

    /// Returns the sorting key; lower is better.
    fn key(&self) -> (bool, f64, f64) {
        (!self.keeps, self.fit.square.max(ROUNDING), self.extreme)
    }

    fn is_one_with(&self, other: &Ranked, target: &TargetPath) -> bool {
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
        // Crank and rocker may also be exchanged if the crank's angles do not count.
        let turns_over = x.shape.form == LinkageForm::FourBar
            && target.turns.is_none()
            && !matches!(x.target.held, GivenPivots::Both(..));
        together([0, 1, 2, 3]) || turns_over && together([1, 0, 3, 2])
    }
}

/// Returns `true` if a linkage closes over its whole task without a dead point, with the crank
/// turning one way.
fn keeps(fit: &Fit, target: &TargetPath) -> bool {
    let angles = &fit.angles;
    let [low, high] = ends(fit, target);
    let (short, sine) = fit.shape.worst_between(low, high);
    if short > 0.0 || sine < MIN_TRANSMISSION_SINE {
        return false;
    }
    let ordered = |sense: f64| {
        angles
            .windows(2)
            .all(|pair| (pair[1] - pair[0]) * sense >= 0.0)
    };
    let [minimum, maximum] = extremes(angles);
    target.turns.is_some() || (maximum - minimum <= 360.0 && (ordered(1.0) || ordered(-1.0)))
}

/// Returns the crank's minimum and maximum angle over the task, in degrees.
pub(super) fn ends(fit: &Fit, target: &TargetPath) -> [f64; 2] {
    match target.closed {
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

/// Returns the best distinct linkages, and after them, if there are preferences, the best that meet
/// all of these.
pub(super) fn chosen(all: Vec<Ranked>, target: &TargetPath) -> Vec<Ranked> {
    let requested: Vec<Ranked> = match target.preferences.has_searched_preference() {
        true => all.iter().filter(|one| one.is_wished).cloned().collect(),
        false => Vec::new(),
    };
    let mut kept = distinct(all, target, MAX_FOLLOWED);
    for next in distinct(requested, target, MAX_PREFERRED) {
        if !kept.iter().any(|other| next.is_one_with(other, target)) {
            kept.push(next);
        }
    }
    kept
}

/// Returns the best distinct linkages, at most `maximum`.
fn distinct(mut all: Vec<Ranked>, target: &TargetPath, maximum: usize) -> Vec<Ranked> {
    all.sort_by(|x, y| {
        let (x, y) = (x.key(), y.key());
        x.0.cmp(&y.0)
            .then(x.1.total_cmp(&y.1))
            .then(x.2.total_cmp(&y.2))
    });
    let mut kept: Vec<Ranked> = Vec::new();
    for next in all {
        if kept.len() >= maximum {
            break;
        }
        if !kept.iter().any(|other| next.is_one_with(other, target)) {
            kept.push(next);
        }
    }
    kept
}
