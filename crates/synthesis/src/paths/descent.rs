//! Minimises over all unknowns at once by Levenberg's and Marquardt's method with exact
//! derivatives.
//!
//! If times are free, the crank's angle at every point is an additional unknown, and a point's miss
//! is its distance from the curve. Each such angle occurs only in the rows of its point and is
//! eliminated there. Let J be the rows of a point for the common unknowns, k those for its angle
//! and r its miss:
//!
//! ```text
//! sum (J'J - (J'k)(k'J) / (k'k (1 + lambda))) d = sum (J'r - (J'k) k'r / (k'k (1 + lambda)))
//! angle: (k'r - k'J d) / (k'k (1 + lambda))
//! ```
//!
//! A step then costs, for each point, as much as there are pairs of common unknowns, of which there
//! are at most ten. The last steps use the rows themselves, by their singular values: normal
//! equations would lose half of the digits.

use super::evolution::{Raw, SearchTarget};
use super::linear::{LinkagePlace, Projection};
use super::shape::{LinkageForm, LinkageShape};
use super::task::{GivenPivots, TargetPath};
use kinematics::numeric::DampedSearch;
use kinematics::{Vec2, angle};
use nalgebra::{DMatrix, DVector};

/// Maximum number of common unknowns: two each for A, the scale and the arm, three lengths, and the
/// first angle.
const MAX_COUNT: usize = 10;
const RADIAN: f64 = 180.0 / std::f64::consts::PI;
/// The measure is the mean square of the misses, relative to the path's size.
const DESCENT: DampedSearch = DampedSearch {
    growth: 2.0,
    growth_of_growth: 2.0,
    min_damping: 1e-14,
    max_damping: 1e10,
    exact: 1e-31,
    min_gain: 1e-9,
    ..DampedSearch::DEFAULT
};
/// Singular values below this fraction of the largest belong to unknowns that the path does not
/// determine.
const RANK_TOLERANCE: f64 = 1e-11;

type MatrixOfUnknowns = [[f64; MAX_COUNT]; MAX_COUNT];

/// A linkage in the path's frame, with its crank's angle at every point.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) target: SearchTarget,
    pub(super) shape: LinkageShape,
    pub(super) place: LinkagePlace,
    /// The crank's angle at every point, in degrees.
    pub(super) angles: Vec<f64>,
    /// The weighted mean square of the misses, in squares of the path's size.
    pub(super) square: f64,
}

/// Sums over the rows of all points.
#[derive(Clone, Debug)]
struct NormalSums {
    /// J'J and J'r.
    all: MatrixOfUnknowns,
    all_miss: [f64; MAX_COUNT],
    /// (J'k)(k'J) / k'k and (J'k) k'r / k'k.
    own: MatrixOfUnknowns,
    own_deviation: [f64; MAX_COUNT],
    /// k'J, k'r and k'k of every point; empty if times are given.
    points: Vec<([f64; MAX_COUNT], f64, f64)>,
    square: f64,
}

/// The unknowns of a task and their layout.
#[derive(Clone, Copy, Debug)]
struct Layout {
    held: GivenPivots,
    form: LinkageForm,
    timed: bool,
    count: usize,
}

impl Layout {
    fn of(goal: &TargetPath, target: &SearchTarget) -> Layout {
        let timed = goal.turns.is_some();
        let linear = match target.held {
            GivenPivots::Free => 6,
            GivenPivots::Crank(_) | GivenPivots::Rocker(_) => 4,
            GivenPivots::Both(..) => 2,
        };
        let lengths = match target.form {
            LinkageForm::FourBar => 3,
            LinkageForm::SliderCrank => 2,
        };
        Layout {
            held: target.held,
            form: target.form,
            timed,
            count: linear + lengths + usize::from(timed),
        }
    }
}

/// A point's miss and its rows: derivatives of the tracer with respect to the common unknowns and
/// to the point's own angle.
struct PointRows {
    miss: Vec2,
    common: [Vec2; MAX_COUNT],
    own: Vec2,
}

impl Fit {
    /// Returns the start of a descent.
    pub(super) fn of(goal: &TargetPath, target: SearchTarget, raw: &Raw) -> Fit {
        let turned = |j: usize| goal.turns.as_ref().map(|turns| turns[j]);
        let angles: Vec<f64> = (0..goal.points.len())
            .map(|j| raw.angle(&goal.along[j], turned(j)))
            .collect();
        let found = Projection::of(goal, target.held, &raw.shape, angles.iter().copied());
        Fit {
            target,
            shape: raw.shape,
            place: found.place,
            angles,
            square: f64::INFINITY,
        }
    }

    /// Returns the positions of B, C and the tracer in the path's frame, at a crank angle in
    /// degrees.
    pub(super) fn places(&self, degrees: f64) -> [Vec2; 3] {
        let e = angle::unit(degrees);
        let u = self.shape.coupling(e).u;
        let b = self.place.origin + (e * self.shape.crank).turned(self.place.scale);
        [
            b,
            b + u.turned(self.place.scale),
            b + u.turned(self.place.arm),
        ]
    }

    /// Returns the position of D in the path's frame.
    pub(super) fn far_pivot(&self) -> Vec2 {
        self.place.origin + self.place.scale * self.shape.ground
    }

    /// Returns the rows of a point; `None` if the links do not close, or at a dead point.
    #[inline]
    fn rows(&self, layout: Layout, point: Vec2, degrees: f64) -> Option<PointRows> {
        let (shape, place) = (&self.shape, &self.place);
        let e = angle::unit(degrees);
        let at = shape.coupling(e);
        if at.short > 0.0 || at.lever == 0.0 {
            return None;
        }
        let rates = shape.rates(e, &at);
        let crank = e * shape.crank;
        // The tracer's rate if only the coupler turns.
        let swing = at.u.turned(place.arm).perp();
        let se = e.turned(place.scale);
        let own = se.perp() * shape.crank + swing * rates.by_angle;
        let tracer = place.origin + crank.turned(place.scale) + at.u.turned(place.arm);
        let mut common = [Vec2::ZERO; MAX_COUNT];
        let mut n = 0;
        let mut push = |row: Vec2| {
            common[n] = row;
            n += 1;
        };
        let mut by_ground = swing * rates.by_ground;
        match layout.held {
            GivenPivots::Free => {
                push(Vec2::X);
                push(Vec2::new(0.0, 1.0));
                push(crank);
                push(crank.perp());
            }
            GivenPivots::Crank(_) => {
                push(crank);
                push(crank.perp());
            }
            GivenPivots::Rocker(_) => {
                let crank = crank - Vec2::new(shape.ground, 0.0);
                push(crank);
                push(crank.perp());
                by_ground = by_ground - place.scale;
            }
            GivenPivots::Both(..) => {
                by_ground = by_ground - crank.turned(place.scale) * (1.0 / shape.ground);
            }
        }
        push(at.u);
        push(at.u.perp());
        push(se + swing * rates.by_crank);
        push(swing * rates.by_far);
        if layout.form == LinkageForm::FourBar {
            push(by_ground);
        }
        if layout.timed {
            push(own);
        }
        Some(PointRows {
            miss: point - tracer,
            common,
            own,
        })
    }

    /// Sums all rows into `normal`. Returns `false` if a point has no rows.
    fn sum(&self, target: &TargetPath, layout: Layout, normal: &mut NormalSums) -> bool {
        normal.clear();
        let n = layout.count;
        for (j, &degrees) in self.angles.iter().enumerate() {
            let Some(rows) = self.rows(layout, target.points[j], degrees) else {
                return false;
            };
            let weight = target.weights[j];
            normal.square += weight * rows.miss.norm2();
            for i in 0..n {
                let row = rows.common[i] * weight;
                for l in 0..=i {
                    normal.all[i][l] += row.dot(rows.common[l]);
                }
                normal.all_miss[i] += row.dot(rows.miss);
            }
            if layout.timed {
                continue;
            }
            let square = rows.own.norm2().max(f64::MIN_POSITIVE);
            let along = rows.own.dot(rows.miss);
            let mut products = [0.0; MAX_COUNT];
            let part = weight / square;
            for (product, row) in products.iter_mut().zip(&rows.common[..n]) {
                *product = rows.own.dot(*row);
            }
            for (i, &own) in products[..n].iter().enumerate() {
                for (sum, other) in normal.own[i].iter_mut().zip(&products[..=i]) {
                    *sum += part * own * other;
                }
                normal.own_deviation[i] += part * own * along;
            }
            normal.points.push((products, along, square));
        }
        normal.square.is_finite()
    }

    /// Returns a copy with its unknowns changed by a step.
    fn stepped(&self, layout: Layout, step: &[f64], angles: &mut Vec<f64>) -> Fit {
        let mut new = Fit {
            angles: std::mem::take(angles),
            ..Fit {
                angles: Vec::new(),
                ..*self
            }
        };
        new.angles.clear();
        new.angles.extend_from_slice(&self.angles);
        let mut rest = step.iter().copied();
        let mut next = || rest.next().unwrap_or(0.0);
        if layout.held == GivenPivots::Free {
            new.place.origin += Vec2::new(next(), next());
        }
        if !matches!(layout.held, GivenPivots::Both(..)) {
            new.place.scale += Vec2::new(next(), next());
        }
        new.place.arm += Vec2::new(next(), next());
        new.shape.crank += next();
        new.shape.far += next();
        if layout.form == LinkageForm::FourBar {
            new.shape.ground += next();
        }
        if layout.timed {
            let turn = next() * RADIAN;
            new.angles.iter_mut().for_each(|angle| *angle += turn);
        }
        new.settle();
        new
    }

    /// Updates the place to satisfy the given pivots.
    fn settle(&mut self) {
        match self.target.held {
            GivenPivots::Free => {}
            GivenPivots::Crank(a) => self.place.origin = a,
            GivenPivots::Rocker(d) => self.place.origin = d - self.place.scale * self.shape.ground,
            GivenPivots::Both(a, d) => {
                self.place.origin = a;
                self.place.scale = (d - a) * (1.0 / self.shape.ground);
            }
        }
    }

    /// Returns `true` if the linkage meets every preference and its start searched for this; then
    /// no step may violate them.
    fn meets_preferences(&self, target: &TargetPath) -> bool {
        self.target.is_wished && self.violation(target) == 0.0
    }

    /// Returns how much the linkage violates the preferences; 0 if it meets all.
    pub(super) fn violation(&self, target: &TargetPath) -> f64 {
        let ends = super::distinct::ends(self, target);
        target.preferences.violation(&self.shape, &self.place, ends)
    }

    /// Descends by at most `steps` steps. Returns `false` if the start has no rows.
    pub(super) fn descend(&mut self, target: &TargetPath, steps: usize) -> bool {
        let layout = Layout::of(target, &self.target);
        let (mut now, mut next) = (NormalSums::new(), NormalSums::new());
        self.settle();
        if !self.sum(target, layout, &mut now) {
            return false;
        }
        self.square = now.square;
        let holds = self.meets_preferences(target);
        let mut spare = Vec::new();
        let rules = DampedSearch {
            tries: steps,
            ..DESCENT
        };
        rules.run(self.square, |damping| {
            let step = now.solve(layout.count, damping)?;
            let mut trial = self.stepped(layout, &step[..layout.count], &mut spare);
            now.turn(&mut trial.angles, &step[..layout.count], damping);
            let is_better = trial.sum(target, layout, &mut next)
                && next.square < self.square
                && !(holds && trial.violation(target) > 0.0);
            if is_better {
                trial.square = next.square;
                std::mem::swap(self, &mut trial);
                std::mem::swap(&mut now, &mut next);
            }
            spare = trial.angles;
            is_better.then_some(self.square)
        });
        true
    }

    /// Improves the minimum by Gauss-Newton steps on the rows themselves.
    pub(super) fn polish(&mut self, target: &TargetPath, steps: usize) {
        let layout = Layout::of(target, &self.target);
        let mut spare = Vec::new();
        let mut normal = NormalSums::new();
        let holds = self.meets_preferences(target);
        for _ in 0..steps {
            let Some(step) = self.exact_step(target, layout) else {
                return;
            };
            if !self.sum(target, layout, &mut normal) {
                return;
            }
            let mut trial = self.stepped(layout, step.as_slice(), &mut spare);
            normal.turn(&mut trial.angles, step.as_slice(), 0.0);
            let is_better = trial.sum(target, layout, &mut normal) && normal.square < self.square;
            if !is_better || holds && trial.violation(target) > 0.0 {
                return;
            }
            trial.square = normal.square;
            std::mem::swap(self, &mut trial);
            spare = trial.angles;
        }
    }

    /// Returns the minimum-norm least-squares step, by singular values. A free angle is eliminated
    /// by projecting its rows onto the normal of its direction of motion.
    fn exact_step(&self, target: &TargetPath, layout: Layout) -> Option<DVector<f64>> {
        let each = if layout.timed { 2 } else { 1 };
        let count = each * target.points.len();
        let mut matrix = DMatrix::zeros(count.max(layout.count), layout.count);
        let mut misses = DVector::zeros(matrix.nrows());
        for (j, &degrees) in self.angles.iter().enumerate() {
            let rows = self.rows(layout, target.points[j], degrees)?;
            let weight = target.weights[j].sqrt();
            let across = match layout.timed {
                true => [Vec2::X, Vec2::new(0.0, 1.0)],
                false => {
                    let norm = rows.own.norm();
                    [
                        rows.own.perp() * (1.0 / norm.max(f64::MIN_POSITIVE)),
                        Vec2::ZERO,
                    ]
                }
            };
            for (part, across) in across.iter().take(each).enumerate() {
                let row = each * j + part;
                misses[row] = weight * across.dot(rows.miss);
                for i in 0..layout.count {
                    matrix[(row, i)] = weight * across.dot(rows.common[i]);
                }
            }
        }
        if !matrix.iter().all(|v| v.is_finite()) {
            return None;
        }
        let svd = nalgebra::SVD::try_new(matrix, true, true, f64::EPSILON, 200)?;
        svd.solve(&misses, RANK_TOLERANCE * svd.singular_values.max())
            .ok()
    }
}

impl NormalSums {
    fn new() -> NormalSums {
        NormalSums {
            all: [[0.0; MAX_COUNT]; MAX_COUNT],
            all_miss: [0.0; MAX_COUNT],
            own: [[0.0; MAX_COUNT]; MAX_COUNT],
            own_deviation: [0.0; MAX_COUNT],
            points: Vec::new(),
            square: 0.0,
        }
    }

    fn clear(&mut self) {
        (self.all, self.own) = ([[0.0; MAX_COUNT]; MAX_COUNT], [[0.0; MAX_COUNT]; MAX_COUNT]);
        (self.all_miss, self.own_deviation) = ([0.0; MAX_COUNT], [0.0; MAX_COUNT]);
        self.points.clear();
        self.square = 0.0;
    }

    /// Solves for the damped step of the common unknowns, by Cholesky's method.
    fn solve(&self, n: usize, damping: f64) -> Option<[f64; MAX_COUNT]> {
        let part = 1.0 / (1.0 + damping);
        let mut lower = [[0.0; MAX_COUNT]; MAX_COUNT];
        let mut step = [0.0; MAX_COUNT];
        for i in 0..n {
            for l in 0..=i {
                let mut sum = self.all[i][l] - part * self.own[i][l];
                if i == l {
                    sum += damping * self.all[i][i] + f64::MIN_POSITIVE;
                }
                for (one, other) in lower[i][..l].iter().zip(&lower[l]) {
                    sum -= one * other;
                }
                if i == l {
                    if !(sum > 0.0) {
                        return None;
                    }
                    lower[i][i] = sum.sqrt();
                } else {
                    lower[i][l] = sum / lower[l][l];
                }
            }
            let mut sum = self.all_miss[i] - part * self.own_deviation[i];
            for (factor, known) in lower[i][..i].iter().zip(&step) {
                sum -= factor * known;
            }
            step[i] = sum / lower[i][i];
        }
        for i in (0..n).rev() {
            let after = step;
            for (row, &known) in lower[i + 1..n].iter().zip(&after[i + 1..n]) {
                step[i] -= row[i] * known;
            }
            step[i] /= lower[i][i];
        }
        step[..n].iter().all(|v| v.is_finite()).then_some(step)
    }

    /// Turns the crank at every point by the angle that follows from the step.
    fn turn(&self, angles: &mut [f64], step: &[f64], damping: f64) {
        for (angle, (products, along, square)) in angles.iter_mut().zip(&self.points) {
            let common: f64 = products.iter().zip(step).map(|(p, d)| p * d).sum();
            *angle += RADIAN * (along - common) / (square * (1.0 + damping));
        }
    }
}
