//! Bounds of a coupled group.
//!
//! Krawczyk's operator on the group's own equations: with R the inverse of the matrix at the
//! computed z, every solution in the box z + [-t, t] lies in z - R F(z) + (I - R J)[-t, t], J the
//! matrix over the whole box; where this falls inside the box, there is exactly one. The rates
//! are solutions of linear equations with the same matrix, and are enclosed likewise.

use super::{Coupled, Room, Scratch};
use crate::arithmetic::{U, half_ulp, two_product, two_sum};
use crate::solver::lu;
use crate::solver::state::State;
use crate::solver::step::{ACCELERATION, VELOCITY};
use crate::{Ball, Number};

/// How much larger than the first step the box is that has to prove itself.
const BOX: f64 = 2.0;
/// No row of I - R J may be larger than this in sum; with the box twice the step it then proves
/// itself.
const CONTRACTION: f64 = 0.5;

/// The inverse R of the matrix, and what is left of I - R J, row by row.
struct Inverse<'a> {
    n: usize,
    rows: &'a mut [f64],
    left: &'a mut [f64],
    /// The largest of these.
    most: f64,
}

impl Coupled {
    /// Encloses what the group places; whether a solution was proved.
    pub(in crate::solver) fn enclose(
        &self,
        q: Ball,
        order: u8,
        state: &State,
        enclosure: &mut State<Ball>,
        scratch: &mut Scratch<Ball>,
    ) -> bool {
        let proved = self.prove(q, order, state, enclosure, scratch).is_some();
        if proved {
            self.write(q, enclosure, &self.open(scratch));
        }
        proved
    }
}

/// How far a stored direction can be from the unit vector of its angle: (|d|^2 - 1) / 2, to twice
/// the precision.
fn off_unit(x: f64, y: f64) -> f64 {
    let ((xx, xx_rest), (yy, yy_rest)) = (two_product(x, x), two_product(y, y));
    let (sum, lost) = two_sum(xx, yy);
    let excess = (sum - 1.0) + (lost + xx_rest + yy_rest);
    0.5 * excess.abs() * (1.0 + 4.0 * U) + U * U
}

impl Coupled {
    /// Room for [`Coupled::enclose`]: R, a copy of the matrix, two vectors, and z with its rates.
    pub(in crate::solver) fn work(&self) -> usize {
        let n = self.unknowns();
        2 * n * n + 2 * n + self.width() + 2 * n
    }

    fn prove(
        &self,
        q: Ball,
        order: u8,
        state: &State,
        enclosure: &State<Ball>,
        scratch: &mut Scratch<Ball>,
    ) -> Option<()> {
        let n = self.unknowns();
        let mut work = std::mem::take(&mut scratch.work);
        let proved = {
            let mut room = self.open(scratch);
            let (rows, rest) = work.split_at_mut(n * n);
            let (matrix, rest) = rest.split_at_mut(n * n);
            let (left, rest) = rest.split_at_mut(n);
            let (column, numbers) = rest.split_at_mut(n);
            let numbers = &mut numbers[..self.width() + 2 * n];
            let mut inverse = Inverse {
                n,
                rows,
                left,
                most: f64::INFINITY,
            };
            let (z, rates) = numbers.split_at_mut(self.width());
            let (first, second) = rates.split_at_mut(n);
            self.read(state, z);
            self.read_rates(state, first, second);
            let z = &*numbers;
            self.centre(z, &mut room);
            self.jacobian(q, enclosure, &mut room);
            for (copy, ball) in matrix.iter_mut().zip(&*room.matrix) {
                *copy = ball.mid;
            }
            inverse
                .fill(matrix, room.pivots, column)
                .and_then(|()| self.prove_position(q, z, enclosure, &mut room, &mut inverse))
                .map(|()| self.bound_rates(q, order, z, enclosure, &mut room, &inverse))
        };
        scratch.work = work;
        proved
    }

    /// The computed z, as it is.
    fn centre(&self, z: &[f64], room: &mut Room<'_, Ball>) {
        let joints = 2 * self.free;
        for (ball, &z) in room.z.iter_mut().zip(z) {
            *ball = Ball::exactly(z);
        }
        for direction in room.z[joints..].chunks_exact_mut(2) {
            let off = off_unit(direction[0].mid, direction[1].mid);
            direction.iter_mut().for_each(|d| d.radius = off);
        }
        room.first.fill(Ball::default());
        room.second.fill(Ball::default());
    }

    /// The z that lie within `radius` of the computed one in every unknown, moved by `shift`.
    fn spread(
        &self,
        z: &[f64],
        shift: impl Fn(usize) -> f64,
        radius: impl Fn(usize) -> f64,
        balls: &mut [Ball],
    ) {
        let joints = 2 * self.free;
        for i in 0..joints {
            let mid = z[i] + shift(i);
            balls[i] = Ball::new(mid, radius(i) + half_ulp(mid));
        }
        for i in 0..self.turning.len() {
            let (angle, at) = (shift(joints + i), joints + 2 * i);
            let (x, y) = (z[at], z[at + 1]);
            // Turned to the first order; and the truth is a unit vector.
            let off =
                radius(joints + i) + angle * angle + off_unit(x, y) + 2.0 * U * angle.abs() + U;
            balls[at] = Ball::new(x - angle * y, off);
            balls[at + 1] = Ball::new(y + angle * x, off);
        }
    }

    fn prove_position(
        &self,
        q: Ball,
        z: &[f64],
        enclosure: &State<Ball>,
        room: &mut Room<'_, Ball>,
        inverse: &mut Inverse<'_>,
    ) -> Option<()> {
        self.residuals(q, enclosure, room);
        let n = self.unknowns();
        let size = (0..n).fold(0.0, |m: f64, i| {
            m.max(inverse.apply(i, room.right, Ball::largest))
        });
        let reach = BOX * size;
        self.spread(z, |_| 0.0, |_| reach, room.z);
        self.jacobian(q, enclosure, room);
        inverse.measure(room.matrix);
        // Written so that NaN proves nothing.
        if !(inverse.most <= CONTRACTION) {
            return None;
        }
        // The matrix is no longer needed: its first row keeps the step.
        for i in 0..n {
            let fuzz = inverse.apply(i, room.right, |b| b.radius);
            let around = size / (1.0 - inverse.most);
            let round = (n as f64 + 2.0) * U * inverse.apply(i, room.right, |b| b.mid.abs());
            let shift = -inverse.apply_signed(i, room.right);
            room.matrix[i] = Ball::new(shift, fuzz + inverse.left[i] * around + round);
        }
        let steps = &room.matrix[..n];
        self.spread(z, |i| steps[i].mid, |i| steps[i].radius, room.z);
        Some(())
    }

    /// J z' = -b, and J z'' = -b2: what the computed rates leave over goes through R.
    fn bound_rates(
        &self,
        q: Ball,
        order: u8,
        z: &[f64],
        enclosure: &State<Ball>,
        room: &mut Room<'_, Ball>,
        inverse: &Inverse<'_>,
    ) {
        let (n, width) = (self.unknowns(), self.width());
        if order >= VELOCITY {
            for i in 0..n {
                room.first[i] = Ball::exactly(z[width + i]);
            }
            self.rates(q, enclosure, room, 1);
            inverse.correct(room.right, room.first);
        }
        if order >= ACCELERATION {
            for i in 0..n {
                room.second[i] = Ball::exactly(z[width + n + i]);
            }
            self.rates(q, enclosure, room, 2);
            inverse.correct(room.right, room.second);
        }
    }
}

impl Inverse<'_> {
    /// Inverts a matrix, which is used up.
    fn fill(&mut self, matrix: &mut [f64], pivots: &mut [usize], column: &mut [f64]) -> Option<()> {
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

    /// One component of |R| v, v the sizes of balls.
    fn apply(&self, i: usize, balls: &[Ball], size: impl Fn(Ball) -> f64) -> f64 {
        let row = &self.rows[i * self.n..(i + 1) * self.n];
        row.iter().zip(balls).map(|(r, &b)| r.abs() * size(b)).sum()
    }

    /// One component of R v, v the middles of balls.
    fn apply_signed(&self, i: usize, balls: &[Ball]) -> f64 {
        let row = &self.rows[i * self.n..(i + 1) * self.n];
        row.iter().zip(balls).map(|(r, b)| r * b.mid).sum()
    }

    /// How large I - R J can be in every row, J any matrix of a matrix of balls.
    fn measure(&mut self, matrix: &[Ball]) {
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
            // Written so that NaN is kept.
            if !(sum <= self.most) {
                self.most = sum;
            }
        }
    }

    /// Moves computed solutions of a linear system by what their residuals say, with a bound.
    fn correct(&self, residuals: &[Ball], solutions: &mut [Ball]) {
        let size = |b: Ball| b.largest();
        let most = (0..self.n).fold(0.0, |m: f64, i| m.max(self.apply(i, residuals, size)));
        let around = most / (1.0 - self.most);
        for (i, solution) in solutions.iter_mut().enumerate() {
            let step = self.apply(i, residuals, |b| b.mid.abs());
            let mid = solution.mid - self.apply_signed(i, residuals);
            let radius = self.apply(i, residuals, |b| b.radius) + self.left[i] * around;
            let round = (self.n as f64 + 2.0) * U * step + half_ulp(mid);
            *solution = Ball::new(mid, radius + round);
        }
    }
}
