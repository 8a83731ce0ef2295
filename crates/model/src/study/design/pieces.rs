//! Improves a design whose figures have kinks. A stroke is the difference of the greatest maximum
//! and the least minimum of a column; where two maxima are equal, it has no slope. Each difference of
//! a maximum and a minimum is a smooth function of the numbers, a piece of the figure. An optimum
//! often lies where several pieces are equal, such as the flattest path with a given stroke.
//!
//! Each step solves a quadratic program with all pieces that are near the figure (sequential quadratic
//! programming). The Hessian matrix of the Lagrangian is a difference of values at followed extrema.

use super::GoalSense;
use super::polish::{MAX_LEN, Polished};
use super::projection::{DIFFERENCE, DesignEvaluator, DesignProjection, EvaluatedDesign};
use super::quadratic_program::{QuadraticMinimum, quadratic_minimum};
use crate::study::excursion::{PieceKind, PlacedFigure};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// Maximum number of steps, and of trials of a step that does not improve.
const STEPS: usize = 60;
const TRIALS: usize = 12;
/// The relative size of a step along the plain slope below which a design is a local optimum.
const FLAT: f64 = 1e-6;
/// Step of second differences, relative to the ranges: the errors by rounding and by the fourth
/// derivative are about equal.
const SECOND_DIFFERENCE: f64 = 3e-4;
/// The smallest eigenvalue of the matrix of a program, relative to the largest one.
const MIN_CURVATURE: f64 = 1e-6;
/// The curvature along the normals of acting constraints, relative to the largest one. The step along
/// them follows from the constraints, and so the matrix may be positive definite.
const CURVATURE_ALONG_NORMALS: f64 = 10.0;
/// The damping is multiplied by `STRONGER` after a step that does not improve, and divided by it after
/// any other step. The least damping that has an effect is relative to the largest curvature.
const STRONGER: f64 = 10.0;
const MIN_DAMPING: f64 = 1e-4;
/// The curvature along the bound of the optimized figure, relative to its size. It is small, because
/// the program must be strictly convex, but the bound has no curvature.
const CURVATURE_OF_BOUND: f64 = 1e-6;

/// The pieces of all figures near a design.
struct PieceModel {
    /// The pieces. The first piece of each figure equals the figure.
    places: Vec<PlacedFigure>,
    /// The pieces of the optimized figure. The largest of their values is minimized.
    optimized: Range<usize>,
    /// The values of the optimized figure's pieces, to be minimized.
    values: Vec<f64>,
    rows: Vec<PieceSlack>,
    /// The slope of each piece, relative to the ranges.
    slopes: DMatrix<f64>,
    /// -1 to maximize, 1 to minimize.
    sense: f64,
}

/// The slack of a piece of a constraint, which must not be negative.
#[derive(Clone, Copy)]
struct PieceSlack {
    piece: usize,
    slack: f64,
    /// The derivative of the slack by the piece's value.
    by_value: f64,
    /// The equality constraint of the piece. One of its pieces must have no slack.
    equality: Option<usize>,
}

/// A step, with the weight of each piece in the Lagrangian.
struct PieceStep {
    travel: DVector<f64>,
    weights: Vec<f64>,
    /// The normals of the acting constraints and bounds.
    normals: Vec<DVector<f64>>,
}

/// Improves a design that satisfies its constraints until no small step improves it, or until `watch`
/// returns `false`. Returns `None` if its figures have no pieces.
pub(super) fn polished_by_pieces(
    judge: &mut DesignEvaluator,
    mut here: EvaluatedDesign,
    watch: &mut dyn FnMut() -> bool,
) -> Option<Polished> {
    let mut damping = 0.0;
    let mut model = PieceModel::at(judge, &here)?;
    for _ in 0..STEPS {
        if !watch() {
            break;
        }
        let count = here.numbers.len();
        let size = model.slope_size().max(here.value.abs());
        let plain = DMatrix::identity(count, count) * size;
        let Some(first) = model.step(judge, &here, &plain) else {
            break;
        };
        if first.travel.norm() <= FLAT {
            // The last step reaches the bounds exactly.
            return Some(Polished {
                design: improved(judge, &here, first.travel).unwrap_or(here),
                is_stationary: true,
            });
        }
        let curvature = model.curvature(judge, &here, &first).unwrap_or(plain);
        let largest = curvature.amax();
        let better = (0..TRIALS).find_map(|_| {
            let damped = &curvature + DMatrix::identity(count, count) * (damping * largest);
            let step = model.step(judge, &here, &damped);
            let there = step.and_then(|step| improved(judge, &here, step.travel));
            damping = match there {
                Some(_) => damping / STRONGER,
                None => (damping * STRONGER).max(MIN_DAMPING),
            };
            there
        });
        let Some(better) = better else {
            break;
        };
        here = better;
        let Some(next) = PieceModel::at(judge, &here) else {
            break;
        };
        model = next;
    }
    Some(Polished {
        design: here,
        is_stationary: false,
    })
}

/// Returns the design after a step, projected back onto the constraints, if it is better.
fn improved(
    judge: &mut DesignEvaluator,
    here: &EvaluatedDesign,
    mut travel: DVector<f64>,
) -> Option<EvaluatedDesign> {
    let length = travel.amax();
    if length > MAX_LEN {
        travel *= MAX_LEN / length;
    }
    let there = judge.evaluate(judge.moved(&here.numbers, &travel))?;
    let there = judge.onto(there, &mut None, DesignProjection::onto_all(&[]));
    (there.score < here.score).then_some(there)
}

impl PieceModel {
    /// Finds the pieces of a design's figures. Of a figure that need not keep all its pieces on one
    /// side, only the piece that equals the figure is used.
    fn at(judge: &mut DesignEvaluator, here: &EvaluatedDesign) -> Option<PieceModel> {
        let figures = judge.pieces(&here.numbers)?;
        let sense = if judge.greatest { -1.0 } else { 1.0 };
        let (mut places, mut rows, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for (k, figure) in figures.into_iter().enumerate() {
            let goal = k.checked_sub(1).and_then(|k| judge.constraints.get(k));
            let needs_all = match (goal.map(|goal| goal.sense), figure.kind) {
                (None, kind) => judge.greatest == (kind == PieceKind::Minimum),
                (Some(GoalSense::Equal), _) => true,
                (Some(GoalSense::AtLeast), kind) => kind == PieceKind::Minimum,
                (Some(GoalSense::AtMost), kind) => kind == PieceKind::Maximum,
            };
            let taken = if needs_all { figure.pieces.len() } else { 1 };
            for piece in figure.pieces.into_iter().take(taken) {
                if let Some(goal) = goal {
                    let is_equal = goal.sense == GoalSense::Equal;
                    // All pieces of a maximum are at most the number, those of a minimum at least.
                    let side = match figure.kind == PieceKind::Maximum && is_equal {
                        true => -1.0,
                        false => 1.0,
                    };
                    rows.push(PieceSlack {
                        piece: places.len(),
                        slack: side * goal.slack(piece.value),
                        by_value: side * goal.slope_of_slack(1.0),
                        equality: is_equal.then_some(k),
                    });
                } else {
                    values.push(sense * piece.value);
                }
                places.push(piece.placed);
            }
        }
        let slopes = judge.slopes_at_places(&places, &here.numbers, DIFFERENCE)?;
        Some(PieceModel {
            optimized: 0..values.len(),
            slopes: DMatrix::from_fn(places.len(), here.numbers.len(), |i, k| slopes[i][k]),
            places,
            values,
            rows,
            sense,
        })
    }

    fn slope_size(&self) -> f64 {
        self.slopes.row(0).norm()
    }

    fn slope(&self, piece: usize) -> DVector<f64> {
        self.slopes.row(piece).transpose()
    }

    /// Returns the step to the minimum of the quadratic model where all linear models of the
    /// constraints hold.
    fn step(
        &self,
        judge: &DesignEvaluator,
        here: &EvaluatedDesign,
        curvature: &DMatrix<f64>,
    ) -> Option<PieceStep> {
        let mut rows = self.rows.clone();
        let mut found = self.solve(judge, here, curvature, &rows)?;
        // An equality on whose pieces nothing presses is met by the piece that equals the figure.
        let equalities = self.rows.iter().filter_map(|row| row.equality);
        let mut equalities: Vec<usize> = equalities.collect();
        equalities.dedup();
        for equality in equalities {
            let is_own = |row: &&(usize, &PieceSlack)| row.1.equality == Some(equality);
            let own: Vec<_> = self
                .rows
                .iter()
                .enumerate()
                .filter(|row| is_own(&row))
                .collect();
            let is_met = own.iter().any(|(i, _)| found.multipliers[*i] > 0.0);
            if let (false, Some((_, first))) = (is_met, own.first()) {
                rows.push(PieceSlack {
                    slack: -first.slack,
                    by_value: -first.by_value,
                    ..**first
                });
                found = self.solve(judge, here, curvature, &rows)?;
            }
        }
        Some(self.weighed(found, &rows, here.numbers.len()))
    }

    /// Solves the program: the numbers' steps, and with several pieces also the bound of the optimized
    /// figure above its first piece. Its inequalities are `rows`, the bounds of the numbers, and the
    /// pieces of the optimized figure.
    fn solve(
        &self,
        judge: &DesignEvaluator,
        here: &EvaluatedDesign,
        curvature: &DMatrix<f64>,
        rows: &[PieceSlack],
    ) -> Option<QuadraticMinimum> {
        let count = here.numbers.len();
        let has_bound = self.values.len() > 1;
        let size = count + usize::from(has_bound);
        let mut normals: Vec<DVector<f64>> = Vec::new();
        let mut limits = Vec::new();
        let mut keep = |of_numbers: &DVector<f64>, of_bound: f64, limit: f64| {
            let normal = |i: usize, _| if i < count { of_numbers[i] } else { of_bound };
            normals.push(DVector::from_fn(size, normal));
            limits.push(limit);
        };
        for row in rows {
            keep(&(self.slope(row.piece) * row.by_value), 0.0, -row.slack);
        }
        for (i, (number, &[low, high])) in here.numbers.iter().zip(&judge.ends).enumerate() {
            let range = high - low;
            let part = |way: f64| if range > 0.0 { way / range } else { 0.0 };
            let mut along = DVector::zeros(count);
            along[i] = 1.0;
            keep(&along, 0.0, part(low - number));
            keep(&-along, 0.0, part(number - high));
        }
        let own = self.slope(0) * self.sense;
        if has_bound {
            keep(&DVector::zeros(count), 1.0, 0.0);
            for piece in self.optimized.clone().skip(1) {
                let off = &own - self.slope(piece) * self.sense;
                keep(&off, 1.0, self.values[piece] - self.values[0]);
            }
        }
        let normals = DMatrix::from_fn(normals.len(), size, |row, i| normals[row][i]);
        let bound_size = here.value.abs().max(f64::MIN_POSITIVE);
        let matrix = DMatrix::from_fn(size, size, |i, k| match (i < count, k < count) {
            (true, true) => curvature[(i, k)],
            (false, false) => CURVATURE_OF_BOUND / bound_size,
            (true, false) | (false, true) => 0.0,
        });
        let slope = DVector::from_fn(size, |i, _| if i < count { own[i] } else { 1.0 });
        quadratic_minimum(&matrix, &slope, &normals, &DVector::from_vec(limits))
    }

    /// Returns the step of a solved program with the weights of the pieces.
    fn weighed(&self, found: QuadraticMinimum, rows: &[PieceSlack], count: usize) -> PieceStep {
        let mut weights = vec![0.0; self.places.len()];
        let mut acting = Vec::new();
        for (row, by) in rows.iter().zip(found.multipliers.iter()) {
            weights[row.piece] -= by * row.by_value;
            if *by > 0.0 {
                acting.push(self.slope(row.piece));
            }
        }
        for i in 0..count {
            let first = rows.len() + 2 * i;
            if found.multipliers.rows(first, 2).amax() > 0.0 {
                let mut along = DVector::zeros(count);
                along[i] = 1.0;
                acting.push(along);
            }
        }
        weights[0] = self.sense;
        for piece in self.optimized.clone().skip(1) {
            let by = found.multipliers[rows.len() + 2 * count + piece];
            weights[piece] += self.sense * by;
            weights[0] -= self.sense * by;
            if by > 0.0 {
                acting.push(self.slope(piece) - self.slope(0));
            }
        }
        PieceStep {
            travel: found.place.rows(0, count).into_owned(),
            weights,
            normals: acting,
        }
    }

    /// Returns a positive definite matrix that agrees with the Hessian matrix of the Lagrangian along
    /// the acting constraints, if it is positive definite there. Returns `None` if a value is missing.
    fn curvature(
        &self,
        judge: &mut DesignEvaluator,
        here: &EvaluatedDesign,
        step: &PieceStep,
    ) -> Option<DMatrix<f64>> {
        let pairs = self
            .places
            .iter()
            .cloned()
            .zip(step.weights.iter().copied());
        let (places, weights): (Vec<PlacedFigure>, Vec<f64>) =
            pairs.filter(|(_, by)| *by != 0.0).unzip();
        let count = here.numbers.len();
        let mut value = |moves: [(usize, f64); 2]| {
            let mut numbers = here.numbers.clone();
            for (i, by) in moves {
                numbers[i] += by * SECOND_DIFFERENCE * (judge.ends[i][1] - judge.ends[i][0]);
            }
            let mut places = places.clone();
            let values = judge.figures.follow_places(&mut places, &numbers)?;
            let all = values.iter().zip(&weights);
            Some(all.map(|(value, by)| value * by).sum::<f64>())
        };
        let own = value([(0, 0.0); 2])?;
        let mut sums = Vec::with_capacity(count);
        for i in 0..count {
            sums.push(value([(i, 1.0), (i, 0.0)])? + value([(i, -1.0), (i, 0.0)])? - 2.0 * own);
        }
        let mut matrix = DMatrix::zeros(count, count);
        for i in 0..count {
            matrix[(i, i)] = sums[i];
            for k in 0..i {
                let both = value([(i, 1.0), (k, 1.0)])? + value([(i, -1.0), (k, -1.0)])?;
                let mixed = 0.5 * (both - 2.0 * own - sums[i] - sums[k]);
                matrix[(i, k)] = mixed;
                matrix[(k, i)] = mixed;
            }
        }
        matrix /= SECOND_DIFFERENCE * SECOND_DIFFERENCE;
        let largest = matrix.amax();
        if !(largest.is_finite() && largest > 0.0) {
            return None;
        }
        for normal in &step.normals {
            let square = normal.norm_squared();
            if square > 0.0 {
                matrix +=
                    normal * normal.transpose() * (CURVATURE_ALONG_NORMALS * largest / square);
            }
        }
        let parts = matrix.symmetric_eigen();
        let minimum = MIN_CURVATURE * parts.eigenvalues.amax();
        let values = parts.eigenvalues.map(|value| value.abs().max(minimum));
        let vectors = parts.eigenvectors;
        Some(&vectors * DMatrix::from_diagonal(&values) * vectors.transpose())
    }
}
