//! Finds further solutions of a group from known ones: drops one equation, and follows the curve on
//! which all others hold. Wherever the dropped equation holds on that curve, there is a solution.
//!
//! This generalises the classical method for a triad: remove one leg, move the remaining four-bar
//! through its motion, and see where the leg fits. It applies to any group, without a closed form,
//! and drops every equation in turn. Solutions that one curve does not connect may be connected by
//! another.

use super::{Coupled, Scratch};
use crate::Vec2;
use crate::numeric::root;
use crate::solver::lu;
use crate::solver::state::State;

/// Maximum step along a curve, in scaled lengths and radians.
const MAX_LEN: f64 = 0.04;
/// Minimum step, below which a curve is given up: there it branches.
const MIN_LEN: f64 = 1e-5;
/// Maximum first correction after a step, relative to the step: a larger one could lead to another
/// curve.
const MAX_RELATIVE_CORRECTION: f64 = 0.1;
/// Minimum cosine of the angle by which a curve may turn in one step.
const MIN_TURN_COSINE: f64 = 0.98;
/// Maximum number of corrections from a predicted point back to the curve.
const CORRECTIONS: usize = 6;
/// Maximum size of the last correction, in scaled lengths and radians.
const ON_CURVE: f64 = 1e-10;
/// Maximum residual of a near miss. Where the dropped equation's residual has a minimum below this,
/// two solutions may lie within one step, or have just vanished.
const NEAR_MISS: f64 = 0.05;
/// Maximum coordinate of a joint, in scaled lengths: beyond it the curve is given up, since a slide
/// may run away.
const MAX_COORDINATE: f64 = 64.0;
/// Budget of factored matrices for a group of one unknown; each matrix of n unknowns uses n^3.
const WORK: usize = 20_000_000;
/// Maximum number of solutions from which curves are followed.
const MAX_COUNT: usize = 256;

/// A point on a curve: z, the curve's unit tangent there, and the residual of the dropped equation.
#[derive(Clone)]
struct CurvePlace {
    z: Vec<f64>,
    along: Vec<f64>,
    miss: f64,
}

/// Follows curves of a group, and collects the solutions on them.
pub(in crate::solver) struct Tracer<'a> {
    group: &'a Coupled,
    q: f64,
    state: &'a mut State,
    scratch: &'a mut Scratch,
    work: usize,
    roots: Vec<Vec<f64>>,
    /// Pairs of solution and dropped equation whose curve has been followed.
    followed: Vec<(usize, usize)>,
}

impl Coupled {
    /// Returns the given solutions and all others reached from them along curves.
    pub(in crate::solver) fn relatives(
        &self,
        q: f64,
        roots: Vec<Vec<f64>>,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> Vec<Vec<f64>> {
        let mut tracer = Tracer {
            group: self,
            q,
            state,
            scratch,
            work: WORK,
            roots,
            followed: Vec::new(),
        };
        let mut next = 0;
        while next < tracer.roots.len().min(MAX_COUNT) {
            for row in 0..self.unknowns() {
                tracer.follow(next, row);
            }
            next += 1;
        }
        tracer.roots
    }
}

impl Tracer<'_> {
    /// Follows the curve of an equation through a solution: once around if it closes, or else to
    /// both its ends.
    fn follow(&mut self, root: usize, row: usize) {
        if self.followed.contains(&(root, row)) {
            return;
        }
        for sense in [1.0, -1.0] {
            if self.follow_curve(root, row, sense) {
                return;
            }
        }
    }

    /// Follows the curve in one direction. Returns `true` if it closes.
    fn follow_curve(&mut self, root: usize, row: usize, sense: f64) -> bool {
        let Some(mut here) = self.start_curve(root, row, sense) else {
            return false;
        };
        let mut step = 0.25 * MAX_LEN;
        // The residual of a solution is zero: rounding must not give it a sign.
        here.miss = 0.0;
        let mut before = f64::INFINITY;
        let mut is_first = true;
        while step >= MIN_LEN && self.work > 0 {
            let Some(there) = self.advance(row, &here, step) else {
                step *= 0.5;
                continue;
            };
            // Consecutive points that are all solutions: the group moves while its inputs are
            // fixed.
            let is_free = !is_first && here.miss.abs().max(there.miss.abs()) <= ON_CURVE;
            if is_free || there.z.iter().any(|v| v.abs() > MAX_COORDINATE) {
                return false;
            }
            let met = if is_first {
                None
            } else if here.miss * there.miss <= 0.0 {
                self.between(row, &here, &there, step)
            } else if here.miss.abs() < before.min(there.miss.abs()).min(NEAR_MISS) {
                self.solve_from(&here.z, true)
            } else {
                None
            };
            if let Some(z) = met {
                let number = self.known(z);
                if number == root {
                    return true;
                }
                self.followed.push((number, row));
            }
            (before, is_first) = (here.miss.abs(), false);
            here = there;
            step = (1.5 * step).min(MAX_LEN);
        }
        false
    }

    /// Returns the number of a solution, and adds it if it is new.
    fn known(&mut self, z: Vec<f64>) -> usize {
        let mut known = self.roots.iter();
        let known = known.position(|other| {
            let two = [&other[..], &z];
            self.group.is_one(self.q, two, self.state, self.scratch)
        });
        known.unwrap_or_else(|| {
            self.roots.push(z);
            self.roots.len() - 1
        })
    }

    /// Returns a solution as a point on the curve of an equation; `None` if the curve is singular
    /// there.
    fn start_curve(&mut self, root: usize, row: usize, sense: f64) -> Option<CurvePlace> {
        let z = self.roots[root].clone();
        // Any direction along which the equation changes will do: its own gradient.
        let mut buffers = self.group.open(self.scratch);
        buffers.z.copy_from_slice(&z);
        self.group.jacobian(self.q, self.state, &mut buffers);
        let n = self.group.unknowns();
        let mut along = buffers.matrix[row * n..(row + 1) * n].to_vec();
        along.iter_mut().for_each(|v| *v *= sense);
        self.direction(row, z, &along)
    }

    /// Takes one step along the curve. Returns `None` if the curve is not straight enough for it.
    fn advance(&mut self, row: usize, from: &CurvePlace, step: f64) -> Option<CurvePlace> {
        let (z, strain) = self.land(row, from, step)?;
        if strain > MAX_RELATIVE_CORRECTION * step {
            return None;
        }
        let place = self.direction(row, z, &from.along)?;
        let cosine = lu::dot(&place.along, &from.along);
        (cosine >= MIN_TURN_COSINE).then_some(place)
    }

    /// Returns the point of the curve reached from a step along its tangent, and the size of the
    /// first correction. Returns `None` if the corrections do not converge.
    fn land(&mut self, row: usize, from: &CurvePlace, step: f64) -> Option<(Vec<f64>, f64)> {
        let n = self.group.unknowns();
        let mut buffers = self.group.open(self.scratch);
        buffers.z.copy_from_slice(&from.z);
        let change: Vec<f64> = from.along.iter().map(|v| v * step).collect();
        self.group.shift(buffers.z, &change);
        let mut strain = None;
        for _ in 0..CORRECTIONS {
            self.work = self.work.saturating_sub(n.pow(3));
            self.group.residuals(self.q, self.state, &mut buffers);
            self.group.jacobian(self.q, self.state, &mut buffers);
            buffers.matrix[row * n..(row + 1) * n].copy_from_slice(&from.along);
            buffers.right[row] = 0.0;
            lu::factor(buffers.matrix, buffers.pivots, n)?;
            lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
            let size = lu::largest(buffers.right);
            let strain = *strain.get_or_insert(size);
            buffers.right.iter_mut().for_each(|v| *v = -*v);
            self.group.shift(buffers.z, buffers.right);
            if size <= ON_CURVE {
                return Some((buffers.z.to_vec(), strain));
            }
        }
        None
    }

    /// Computes the curve's tangent at a point, oriented along `along`. Returns `None` at a
    /// singular point.
    fn direction(&mut self, row: usize, z: Vec<f64>, along: &[f64]) -> Option<CurvePlace> {
        let n = self.group.unknowns();
        self.work = self.work.saturating_sub(n.pow(3));
        let mut buffers = self.group.open(self.scratch);
        buffers.z.copy_from_slice(&z);
        self.group.residuals(self.q, self.state, &mut buffers);
        let miss = buffers.right[row];
        self.group.jacobian(self.q, self.state, &mut buffers);
        buffers.matrix[row * n..(row + 1) * n].copy_from_slice(along);
        buffers.right.fill(0.0);
        buffers.right[row] = 1.0;
        lu::factor(buffers.matrix, buffers.pivots, n)?;
        lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
        let norm = lu::dot(buffers.right, buffers.right).sqrt();
        let along = buffers.right.iter().map(|v| v / norm).collect();
        norm.is_finite().then_some(CurvePlace { z, along, miss })
    }

    /// Returns the solution between two points of a curve at which the dropped equation has
    /// different signs.
    fn between(
        &mut self,
        row: usize,
        from: &CurvePlace,
        to: &CurvePlace,
        step: f64,
    ) -> Option<Vec<f64>> {
        let at = root((0.0, from.miss), (step, to.miss), ON_CURVE, |step| {
            let (z, _) = self.land(row, from, step)?;
            Some(self.direction(row, z, &from.along)?.miss)
        });
        let at = at.ok()?;
        let (z, _) = self.land(row, from, at)?;
        self.solve_from(&z, false)
    }

    /// Returns the solution found from z by Newton's method. With `downhill`, damped steps first
    /// reduce the residuals.
    fn solve_from(&mut self, z: &[f64], downhill: bool) -> Option<Vec<f64>> {
        self.group.open(self.scratch).z.copy_from_slice(z);
        let settled = if downhill {
            self.group.approach(self.q, self.state, self.scratch)
        } else {
            self.group.correct(self.q, self.state, self.scratch).settled
        };
        let z = self.group.open(self.scratch).z.to_vec();
        settled.then_some(z)
    }
}

/// Maximum distance of two approximations of one solution, in units of about the longest link and
/// in radians.
pub(in crate::solver) const EQUALITY_TOLERANCE: f64 = 1e-6;
/// Minimum distance of distinguishable solutions: the square root of the rounding error.
const MIN_DISTANCE: f64 = 1e-8;
/// Maximum residual halfway between two approximations of one solution: the rounding error of the
/// terms. Between different solutions it is larger.
const MAX_MIDPOINT_RESIDUAL: f64 = 4.0 * f64::EPSILON;

/// Returns the largest difference between the components of two solutions.
pub(in crate::solver) fn distance(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

impl Coupled {
    /// Returns `true` if two solutions differ by rounding error only. Overwrites the z in the
    /// scratch.
    pub(in crate::solver) fn is_one(
        &self,
        q: f64,
        [a, b]: [&[f64]; 2],
        state: &State,
        scratch: &mut Scratch,
    ) -> bool {
        let separation = distance(a, b);
        if !(separation < EQUALITY_TOLERANCE) || separation < MIN_DISTANCE {
            return separation < MIN_DISTANCE;
        }
        let buffers = self.open(scratch);
        for (z, (a, b)) in buffers.z.iter_mut().zip(a.iter().zip(b)) {
            *z = 0.5 * (a + b);
        }
        for d in buffers.z[2 * self.free..].chunks_exact_mut(2) {
            let unit = Vec2::new(d[0], d[1]);
            let unit = unit / unit.norm();
            (d[0], d[1]) = (unit.x, unit.y);
        }
        self.gap(q, state, scratch) <= MAX_MIDPOINT_RESIDUAL
    }
}
