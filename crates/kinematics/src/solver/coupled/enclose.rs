//! Encloses the solution of a coupled group.
//!
//! Krawczyk's operator is applied to the group's own equations. With R the inverse of the matrix at
//! the computed z, every solution in the box z + [-t, t] lies in z - R F(z) + (I - R J)[-t, t], J
//! the matrix over the whole box. If this lies inside the box, the box contains exactly one
//! solution. The rates are solutions of linear equations with the same matrix, and are enclosed
//! likewise.
//!
//! The matrix consists of balls. The equations are evaluated at the computed state in
//! double-double, so that their residuals are known with their signs.

use super::{Coupled, GroupScratch, Scratch};
use crate::arithmetic::{Sharp, U};
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Ball, Double, Number, Vec2};

/// The size of the box in which a solution must be proved, relative to the first step.
pub(super) const BOX: f64 = 2.0;
/// Maximum row sum of |I - R J|. A box of twice the step then contains a solution.
pub(super) const CONTRACTION: f64 = 0.5;

/// The rounding error of a Newton step for the length of a direction.
pub(super) const UNIT: f64 = 64.0 * U * U;

/// The inverse R of a matrix, with bounds of |I - R J| by rows.
pub(super) struct Inverse<'a> {
    pub(super) n: usize,
    pub(super) rows: &'a mut [f64],
    /// A bound of each row's sum of |I - R J|.
    pub(super) left: &'a mut [f64],
    /// The largest entry of `left`.
    pub(super) most: f64,
}

/// The inputs of a group and buffers for its equations: balls for the matrix, double-double with a
/// radius for the residuals.
pub(in crate::solver) struct Views<'a> {
    pub balls: (&'a State<Ball>, &'a mut Scratch<Ball>),
    pub sharp: (&'a mut State<Sharp>, &'a mut Scratch<Sharp>),
}

impl Coupled {
    /// Encloses the points and links of the group in double-double. Returns `true` if a solution is
    /// proved.
    pub(in crate::solver) fn enclose(
        &self,
        q: (Ball, Sharp),
        order: u8,
        state: &State,
        views: &mut Views<'_>,
    ) -> bool {
        let mut work = std::mem::take(&mut views.balls.1.work);
        let proved = self.prove(q, order, state, views, &mut work).is_some();
        views.balls.1.work = work;
        if proved {
            let (state, scratch) = &mut views.sharp;
            self.write(q.1, state, &self.open(scratch));
        }
        proved
    }

    /// Returns the length of the buffer for [`Coupled::enclose`]: R, a copy of the matrix, two
    /// vectors, and z with its rates.
    pub(in crate::solver) fn work(&self) -> usize {
        let n = self.unknowns();
        2 * n * n + 2 * n + self.width() + 2 * n
    }

    fn prove(
        &self,
        q: (Ball, Sharp),
        order: u8,
        state: &State,
        views: &mut Views<'_>,
        work: &mut [f64],
    ) -> Option<()> {
        let n = self.unknowns();
        let (inputs, scratch) = &mut views.balls;
        let mut box_room = self.open(scratch);
        let (known, scratch) = &mut views.sharp;
        let mut buffers = self.open(scratch);
        let (rows, rest) = work.split_at_mut(n * n);
        let (matrix, rest) = rest.split_at_mut(n * n);
        let (left, rest) = rest.split_at_mut(n);
        let (column, numbers) = rest.split_at_mut(n);
        let (z, rates) = numbers.split_at_mut(self.width());
        let (first, second) = rates[..2 * n].split_at_mut(n);
        self.read(state, z);
        self.read_rates(state, first, second);
        self.centre(z, &mut buffers);
        for (ball, z) in box_room.z.iter_mut().zip(&*z) {
            *ball = Ball::exactly(*z);
        }
        self.jacobian(q.0, inputs, &mut box_room);
        for (copy, ball) in matrix.iter_mut().zip(&*box_room.matrix) {
            *copy = ball.mid;
        }
        let mut inverse = Inverse {
            n,
            rows,
            left,
            most: f64::INFINITY,
        };
        inverse.fill(matrix, box_room.pivots, column)?;
        self.residuals(q.1, known, &mut buffers);
        let size = inverse.largest_component(buffers.right);
        self.spread(z, BOX * size, box_room.z);
        self.jacobian(q.0, inputs, &mut box_room);
        inverse.measure(box_room.matrix);
        // Negated so that NaN proves nothing.
        if !(inverse.most <= CONTRACTION) {
            return None;
        }
        self.advance(&inverse, &mut buffers);
        let exactly = |to: &mut [Sharp], from: &[f64]| {
            for (to, from) in to.iter_mut().zip(from) {
                *to = Sharp::exactly(*from);
            }
        };
        if order >= VELOCITY {
            exactly(buffers.first, first);
            self.rates(q.1, known, &mut buffers, 1);
            inverse.correct(buffers.right, buffers.first);
        }
        if order >= ACCELERATION {
            exactly(buffers.second, second);
            self.rates(q.1, known, &mut buffers, 2);
            inverse.correct(buffers.right, buffers.second);
        }
        Some(())
    }

    /// Copies the computed z into `buffers`, with directions scaled to length 1, and clears the rates.
    fn centre(&self, z: &[f64], buffers: &mut GroupScratch<'_, Sharp>) {
        let joints = 2 * self.free;
        for (to, &z) in buffers.z.iter_mut().zip(z) {
            *to = Sharp::exactly(z);
        }
        for d in buffers.z[joints..].chunks_exact_mut(2) {
            let stored = Vec2::new(d[0].mid, d[1].mid);
            // One Newton step corrects the length, which is off by a few u.
            let long = stored.norm2() - Double::ONE;
            let unit = stored * (Double::ONE - long.scaled(0.5));
            let unit = unit.map(|v| Sharp::new(v, long.hi * long.hi + UNIT));
            (d[0], d[1]) = (unit.x, unit.y);
        }
        buffers.first.fill(Sharp::default());
        buffers.second.fill(Sharp::default());
    }

    /// Sets `balls` to all z within `radius` of the computed one in every unknown.
    fn spread(&self, z: &[f64], radius: f64, balls: &mut [Ball]) {
        let joints = 2 * self.free;
        for (i, (ball, &z)) in balls.iter_mut().zip(z).enumerate() {
            let slack = if i < joints { 0.0 } else { 4.0 * U };
            *ball = Ball::new(z, radius + slack);
        }
    }

    /// Moves z by the Newton step for the residuals, with a bound.
    fn advance(&self, inverse: &Inverse<'_>, buffers: &mut GroupScratch<'_, Sharp>) {
        let joints = 2 * self.free;
        let around = inverse.largest_component(buffers.right) / (1.0 - inverse.most);
        for i in 0..inverse.n {
            let step = inverse.step(i, buffers.right, around);
            if i < joints {
                buffers.z[i] += step;
                continue;
            }
            let at = joints + 2 * (i - joints);
            let d = Vec2::new(buffers.z[at], buffers.z[at + 1]);
            // Rotated to second order.
            let angle = step.mid.hi.abs() + step.radius;
            let along = Sharp::new(Double::exactly(-0.5 * step.mid.hi * step.mid.hi), 0.0);
            let more = step.mid.hi.abs() * step.radius + angle * angle * angle;
            let turned = d + d.perp() * step + d * along;
            let widened =
                turned.map(|v| Sharp::new(v.mid, v.radius + more + step.radius * step.radius));
            (buffers.z[at], buffers.z[at + 1]) = (widened.x, widened.y);
        }
    }
}

impl Inverse<'_> {
    /// Inverts a matrix, and overwrites it. Returns `None` if it is singular.
    pub(super) fn fill(
        &mut self,
        matrix: &mut [f64],
        pivots: &mut [usize],
        column: &mut [f64],
    ) -> Option<()> {
        let n = self.n;
        lu::factor(matrix, pivots, n)?;
        for j in 0..n {
            column.fill(0.0);
            column[j] = 1.0;
            lu::solve(matrix, pivots, column, n);
            for (row, &value) in self.rows.chunks_exact_mut(n).zip(&*column) {
                row[j] = value;
            }
        }
        Some(())
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.rows[i * self.n..(i + 1) * self.n]
    }

    /// Returns the largest component of |R| |v|, v the residuals.
    pub(super) fn largest_component(&self, residuals: &[Sharp]) -> f64 {
        let size = |r: Sharp| r.mid.hi.abs() + r.radius;
        let step = |i| -> f64 {
            let terms = self.row(i).iter().zip(residuals);
            terms.map(|(r, &v)| r.abs() * size(v)).sum()
        };
        // Ordered so that NaN is kept.
        (0..self.n)
            .map(step)
            .fold(0.0, |m, v| if v <= m { m } else { v })
    }

    /// Returns one component of the Newton step for the residuals, with a bound; `around` bounds
    /// the size of all components.
    pub(super) fn step(&self, i: usize, residuals: &[Sharp], around: f64) -> Sharp {
        let (mut step, mut terms, mut fuzz) = (0.0, 0.0, 0.0);
        for (r, v) in self.row(i).iter().zip(residuals) {
            step -= r * v.mid.hi;
            terms += (r * v.mid.hi).abs();
            fuzz += r.abs() * v.radius;
        }
        let round = (self.n as f64 + 3.0) * U * terms;
        Sharp::new(Double::exactly(step), fuzz + self.left[i] * around + round)
    }

    /// Bounds the row sums of |I - R J| for every matrix J in a matrix of balls, and their maximum.
    pub(super) fn measure(&mut self, matrix: &[Ball]) {
        let n = self.n;
        let rounding = (n as f64 + 2.0) * U;
        self.most = 0.0;
        for i in 0..n {
            let row = &self.rows[i * n..(i + 1) * n];
            let mut sum = 0.0;
            for j in 0..n {
                let (mut left, mut off) = (if i == j { 1.0 } else { 0.0 }, U);
                for (k, r) in row.iter().enumerate() {
                    let ball = matrix[k * n + j];
                    left -= r * ball.mid;
                    off += r.abs() * (ball.radius + rounding * ball.mid.abs());
                }
                sum += left.abs() + off;
            }
            self.left[i] = sum;
            // Negated so that NaN is kept.
            if !(sum <= self.most) {
                self.most = sum;
            }
        }
    }

    /// Corrects computed solutions of a linear system by their residuals, with a bound.
    fn correct(&self, residuals: &[Sharp], solutions: &mut [Sharp]) {
        let around = self.largest_component(residuals) / (1.0 - self.most);
        for (i, solution) in solutions.iter_mut().enumerate() {
            *solution += self.step(i, residuals, around);
        }
    }
}
