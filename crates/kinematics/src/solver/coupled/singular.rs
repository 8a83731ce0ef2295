//! Measures how close a coupled group is to a singularity, and finds its folds and crossings.
//!
//! At a fold two solutions z meet and the driver reverses. There J has a null vector v, and
//!
//! ```text
//! F(z, q) = 0        J(z, q) v = 0        c.v = 1
//! ```
//!
//! is a regular system for z, v and q (Moore and Spence 1980), though J itself is singular. Its
//! second derivatives come from the second rates of the equations: with z'' = 0 and z' = a these
//! are R(a) = Q(a, a) + 2 L a + r, so that R(a + b) - R(a) - R(b) + R(0) = 2 Q(a, b) and R(a) -
//! R(-a) = 4 L a.
//!
//! At a crossing two solutions meet and both continue. There F_q lies in the range of J, so that
//! the system above is singular as well. Opening the equations by b along the left null vector w
//! makes it regular again:
//!
//! ```text
//! F(z, q) + b w = 0      J v = 0      c.v = 1      J p + F_q = 0      c.p = 0
//! ```
//!
//! If the branches really meet, b is zero, and z' = p + s v on them.

use super::series::Null;
use super::{Coupled, GroupScratch, Scratch};
use crate::Number;
use crate::solver::lu::{self, dot};
use crate::solver::state::State;
use std::ops::Range;

/// The state of Newton's method for a fold, besides z and q: the null vector v, and the vector c
/// that normalises it.
pub(in crate::solver) struct Fold {
    pub(super) v: Vec<f64>,
    pub(super) c: Vec<f64>,
}

/// The state of Newton's method for a crossing, besides z and q: the null vector v, the particular
/// tangent p, and the unfolding.
pub(in crate::solver) struct Crossing {
    pub(super) v: Vec<f64>,
    pub(super) p: Vec<f64>,
    /// The value b by which the equations are opened along w. At a change point it is zero, within
    /// the rounding error of the lengths.
    pub(in crate::solver) unfolding: f64,
    /// The null vectors at the start: they normalise v and p, and open the equations.
    pub(super) null: Null,
}

/// The indices of a crossing's unknowns, which follow z.
pub(super) struct CrossingPlaces {
    pub(super) q: usize,
    pub(super) v: Range<usize>,
    pub(super) p: Range<usize>,
    pub(super) unfolding: usize,
    pub(super) count: usize,
}

impl CrossingPlaces {
    pub(super) fn of(n: usize) -> CrossingPlaces {
        CrossingPlaces {
            q: n,
            v: n + 1..2 * n + 1,
            p: 2 * n + 1..3 * n + 1,
            unfolding: 3 * n + 1,
            count: 3 * n + 2,
        }
    }
}

/// A step of Newton's method: its largest component, and the change of the driver's coordinate.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Correction {
    pub(in crate::solver) size: f64,
    pub(in crate::solver) dq: f64,
}

impl Coupled {
    /// Returns a signed measure of the distance from a singularity, at the z in the scratch. It is
    /// the determinant of the matrix with rows of at most unit length, times its absolute value, and
    /// behaves like the square of a sine. Its size is at most 1 (Hadamard), and 0 if the matrix is
    /// singular.
    pub(in crate::solver) fn measure(&self, q: f64, state: &State, scratch: &mut Scratch) -> f64 {
        let det = self.determinant(q, state, scratch);
        det * det.abs()
    }

    /// Returns the matrix at the z in the scratch, row by row, each relative to the largest possible
    /// length of the row.
    pub(in crate::solver) fn normalised<'s>(
        &self,
        q: f64,
        state: &State,
        scratch: &'s mut Scratch,
    ) -> &'s [f64] {
        let mut sizes = Vec::with_capacity(self.unknowns());
        let mut buffers = self.open(scratch);
        self.size_rows(q, state, &buffers, |size| sizes.push(size));
        self.jacobian(q, state, &mut buffers);
        for (row, size) in buffers.matrix.chunks_mut(self.unknowns()).zip(sizes) {
            row.iter_mut().for_each(|v| *v /= size);
        }
        buffers.matrix
    }

    /// Returns the determinant of the matrix, relative to the largest possible lengths of its rows, at
    /// the z in the scratch; 0 if the matrix is singular. A row itself may be zero at a singularity.
    pub(in crate::solver) fn determinant(
        &self,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> f64 {
        let n = self.unknowns();
        let mut buffers = self.open(scratch);
        self.jacobian(q, state, &mut buffers);
        let mut det = 1.0;
        self.size_rows(q, state, &buffers, |size| det /= size);
        let Some(sign) = lu::factor(buffers.matrix, buffers.pivots, n) else {
            return 0.0;
        };
        for k in 0..n {
            det *= buffers.matrix[k * n + k].abs();
        }
        sign * det
    }

    /// Returns a start for [`Coupled::approach_fold`] from a state close to a fold, where the group
    /// moves along its null vector. Returns `None` without finite rates in the scratch.
    pub(in crate::solver) fn fold(&self, scratch: &mut Scratch) -> Option<Fold> {
        let buffers = self.open(scratch);
        let length = dot(buffers.first, buffers.first).sqrt();
        let v: Vec<f64> = buffers.first.iter().map(|x| x / length).collect();
        let c = v.clone();
        v.iter().all(|x| x.is_finite()).then_some(Fold { v, c })
    }

    /// Takes one Newton step towards a fold: corrects v and the z in the scratch. Returns the size
    /// of the step, and the change of the driver's coordinate, which the caller applies. `state`
    /// holds the inputs of the group with both derivatives.
    pub(in crate::solver) fn approach_fold(
        &self,
        fold: &mut Fold,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<Correction> {
        let n = self.unknowns();
        let mut buffers = self.open(scratch);
        let system = self.fold_system(&fold.v, &fold.c, q, state, &mut buffers);
        let (size, change) = system.solved()?;
        self.shift(buffers.z, &change[..n]);
        add(&mut fold.v, &change[n + 1..]);
        Some(Correction {
            size,
            dq: change[n],
        })
    }

    /// Returns the equations of a fold at the z in `room`, with their derivatives by z, q and v.
    pub(super) fn fold_system<T: Number>(
        &self,
        v: &[T],
        c: &[T],
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) -> System<T> {
        let n = self.unknowns();
        let local = Local::new(self, q, state, buffers);
        let (z, by_q, by_v) = (0, n, n + 1);
        let mut system = System::new(2 * n + 1);
        system.right[..n].copy_from_slice(&local.misfit);
        system.block(0, z, &local.matrix, n);
        system.column(0, by_q, &local.by_q);
        system.add_right(n, &local.times_matrix(v));
        system.block(n, z, &local.bent(self, v, q, state, buffers), n);
        system.column(n, by_q, &local.times_mixed(v));
        system.block(n, by_v, &local.matrix, n);
        system.row(2 * n, by_v, c);
        system.right[2 * n] = dot(c, v) - T::exactly(1.0);
        system
    }

    /// Returns a start for [`Coupled::approach_crossing`] from a state close to a crossing.
    pub(in crate::solver) fn crossing(
        &self,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<Crossing> {
        let n = self.unknowns();
        let mut buffers = self.open(scratch);
        let rate = buffers.first.to_vec();
        self.jacobian(q, state, &mut buffers);
        let null = Null::of(buffers.matrix, n)?;
        let along = dot(&rate, &null.v);
        let p = rate.iter().zip(&null.v).map(|(r, v)| r - along * v);
        Some(Crossing {
            p: p.collect(),
            v: null.v.clone(),
            unfolding: 0.0,
            null,
        })
    }

    /// Takes one Newton step towards a crossing, like [`Coupled::approach_fold`].
    pub(in crate::solver) fn approach_crossing(
        &self,
        crossing: &mut Crossing,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<Correction> {
        let n = self.unknowns();
        let mut buffers = self.open(scratch);
        let local = Local::new(self, q, state, &mut buffers);
        let Crossing {
            v,
            p,
            unfolding,
            null,
        } = crossing;
        let mut system = self.crossing_system([v, p], null, &local, q, state, &mut buffers);
        system.right[..n].copy_from_slice(&local.misfit);
        let open: Vec<f64> = null.w.iter().map(|w| w * *unfolding).collect();
        system.add_right(0, &open);
        system.add_right(n, &local.times_matrix(v));
        system.right[2 * n] = dot(&null.v, v) - 1.0;
        let third = 2 * n + 1;
        system.add_right(third, &local.times_matrix(p));
        system.add_right(third, &local.by_q);
        system.right[3 * n + 1] = dot(&null.v, p);

        let (size, change) = system.solved()?;
        let places = CrossingPlaces::of(n);
        self.shift(buffers.z, &change[..n]);
        add(v, &change[places.v.clone()]);
        add(p, &change[places.p.clone()]);
        *unfolding += change[places.unfolding];
        Some(Correction {
            size,
            dq: change[places.q],
        })
    }

    /// Returns the derivatives of a crossing's equations by z, q, v, p and the unfolding. The
    /// caller fills in their right side.
    pub(super) fn crossing_system(
        &self,
        [v, p]: [&[f64]; 2],
        null: &Null,
        local: &Local,
        q: f64,
        state: &State,
        buffers: &mut GroupScratch<'_>,
    ) -> System {
        let n = self.unknowns();
        let places = CrossingPlaces::of(n);
        let mut system = System::new(places.count);
        system.block(0, 0, &local.matrix, n);
        system.column(0, places.q, &local.by_q);
        system.column(0, places.unfolding, &null.w);

        system.block(n, 0, &local.bent(self, v, q, state, buffers), n);
        system.column(n, places.q, &local.times_mixed(v));
        system.block(n, places.v.start, &local.matrix, n);
        system.row(2 * n, places.v.start, &null.v);

        let third = 2 * n + 1;
        system.block(third, 0, &local.bent(self, p, q, state, buffers), n);
        system.block(third, 0, &local.mixed, n);
        system.column(third, places.q, &local.times_mixed(p));
        system.column(third, places.q, &local.still);
        system.block(third, places.p.start, &local.matrix, n);
        system.row(3 * n + 1, places.p.start, &null.v);
        system
    }

    /// Returns the second rates of the equations with z' = `first` and z'' = 0.
    fn second_rates<T: Number>(
        &self,
        first: &[T],
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) -> Vec<T> {
        buffers.first.copy_from_slice(first);
        self.rates(q, state, buffers, 2);
        buffers.right.to_vec()
    }
}

/// The equations of a group at one point, with their derivatives; matrices are stored by rows.
pub(super) struct Local<T = f64> {
    n: usize,
    /// F.
    misfit: Vec<T>,
    /// J, the derivative of F by z.
    matrix: Vec<T>,
    /// The derivative of F by q.
    by_q: Vec<T>,
    /// r = R(0), the second derivative by q.
    still: Vec<T>,
    /// L, the second derivative by z and q.
    mixed: Vec<T>,
    /// R(e) for every unit vector e, in order.
    units: Vec<Vec<T>>,
}

impl<T: Number> Local<T> {
    pub(super) fn new(
        group: &Coupled,
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) -> Local<T> {
        let n = group.unknowns();
        group.residuals(q, state, buffers);
        let misfit = buffers.right.to_vec();
        buffers.first.fill(T::default());
        buffers.second.fill(T::default());
        group.rates(q, state, buffers, 1);
        let by_q = buffers.right.to_vec();
        group.jacobian(q, state, buffers);
        let matrix = buffers.matrix.to_vec();
        let mut unit = vec![T::default(); n];
        let still = group.second_rates(&unit, q, state, buffers);
        let (mut units, mut mixed) = (Vec::new(), vec![T::default(); n * n]);
        for j in 0..n {
            unit[j] = T::exactly(-1.0);
            let back = group.second_rates(&unit, q, state, buffers);
            unit[j] = T::exactly(1.0);
            let forth = group.second_rates(&unit, q, state, buffers);
            unit[j] = T::default();
            for i in 0..n {
                mixed[i * n + j] = (forth[i] - back[i]).scaled(0.25);
            }
            units.push(forth);
        }
        Local {
            n,
            misfit,
            matrix,
            by_q,
            still,
            mixed,
            units,
        }
    }

    fn times_matrix(&self, v: &[T]) -> Vec<T> {
        self.matrix.chunks(self.n).map(|row| dot(row, v)).collect()
    }

    fn times_mixed(&self, v: &[T]) -> Vec<T> {
        self.mixed.chunks(self.n).map(|row| dot(row, v)).collect()
    }

    /// Returns Q(v, .), the derivative of J v by z.
    fn bent(
        &self,
        group: &Coupled,
        v: &[T],
        q: T,
        state: &State<T>,
        buffers: &mut GroupScratch<'_, T>,
    ) -> Vec<T> {
        let n = self.n;
        let alone = group.second_rates(v, q, state, buffers);
        let mut bent = vec![T::default(); n * n];
        let mut sum = v.to_vec();
        for j in 0..n {
            sum[j] += T::exactly(1.0);
            let both = group.second_rates(&sum, q, state, buffers);
            sum[j] = v[j];
            for i in 0..n {
                let both = both[i] - alone[i] - self.units[j][i] + self.still[i];
                bent[i * n + j] = both.scaled(0.5);
            }
        }
        bent
    }
}

/// A linear system assembled from blocks; overlapping blocks are added.
pub(super) struct System<T = f64> {
    pub(super) n: usize,
    pub(super) matrix: Vec<T>,
    pub(super) right: Vec<T>,
}

impl<T: Number> System<T> {
    fn new(n: usize) -> System<T> {
        System {
            n,
            matrix: vec![T::default(); n * n],
            right: vec![T::default(); n],
        }
    }

    fn block(&mut self, row: usize, column: usize, block: &[T], width: usize) {
        for (i, values) in block.chunks(width).enumerate() {
            let from = (row + i) * self.n + column;
            add(&mut self.matrix[from..from + width], values);
        }
    }

    fn row(&mut self, row: usize, column: usize, values: &[T]) {
        self.block(row, column, values, values.len());
    }

    fn column(&mut self, row: usize, column: usize, values: &[T]) {
        self.block(row, column, values, 1);
    }

    pub(super) fn add_right(&mut self, row: usize, values: &[T]) {
        add(&mut self.right[row..row + values.len()], values);
    }
}

impl System {
    /// Returns the largest component of the correction that cancels `right`, and the correction.
    /// Returns `None` if the matrix is singular.
    pub(super) fn solved(mut self) -> Option<(f64, Vec<f64>)> {
        let mut pivots = vec![0; self.n];
        lu::factor(&mut self.matrix, &mut pivots, self.n)?;
        lu::solve(&self.matrix, &pivots, &mut self.right, self.n);
        self.right.iter_mut().for_each(|x| *x = -*x);
        let size = lu::largest(&self.right);
        size.is_finite().then_some((size, self.right))
    }
}

pub(super) fn add<T: Number>(to: &mut [T], values: &[T]) {
    for (to, &value) in to.iter_mut().zip(values) {
        *to += value;
    }
}
