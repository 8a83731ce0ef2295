//! Computes the motion of a coupled group as a series, coefficient by coefficient.
//!
//! With the unknowns known up to t^(k-1), the k-th coefficient of the equations is r_k. The k-th
//! coefficient of the unknowns solves J z_k = -r_k, always with the same J.
//!
//! If J is singular, with the null vectors J v = 0 and w J = 0, z_k is known up to s v. The next
//! order determines s: w.r_(k+1) = 0. For k = 1 this is the quadratic of the second-order tangents,
//! with one root for each of the branches that meet. For larger k it is linear.

use super::exact_meeting::product;
use super::{Coupled, GroupScratch, Scratch};
use crate::arithmetic::Series;
use crate::solver::lu::{self, dot};
use crate::solver::state::State;
use crate::solver::workspace::Workspace;
use crate::{Double, Number, Vec2};

/// Minimum discriminant of the quadratic a s^2 + b s + c, relative to b^2 + |a c|. Below it the
/// branches touch, and only orders beyond the second could distinguish them.
const TANGENTIAL: f64 = 1e-9;
/// Number of corrections per coefficient: the second one finds the digits that doubles do not hold.
const CORRECTIONS: usize = 2;

/// Maximum angle in radians whose square is below the rounding error of double-double.
const SMALL_ANGLE: f64 = 1e-16;

/// A factored matrix; a singular one is bordered by its null vectors.
pub(super) struct BorderedMatrix {
    matrix: Vec<f64>,
    pivots: Vec<usize>,
    n: usize,
}

impl BorderedMatrix {
    pub(super) fn new(
        matrix: &[f64],
        n: usize,
        border: Option<(&[f64], &[f64])>,
    ) -> Option<BorderedMatrix> {
        let m = n + usize::from(border.is_some());
        let mut bordered = vec![0.0; m * m];
        for i in 0..n {
            bordered[i * m..i * m + n].copy_from_slice(&matrix[i * n..(i + 1) * n]);
            if let Some((column, row)) = border {
                bordered[i * m + n] = column[i];
                bordered[n * m + i] = row[i];
            }
        }
        let mut pivots = vec![0; m];
        lu::factor(&mut bordered, &mut pivots, m)?;
        Some(BorderedMatrix {
            matrix: bordered,
            pivots,
            n: m,
        })
    }

    pub(super) fn solve(&self, right: &[f64], last: f64) -> Vec<f64> {
        let mut right = right.to_vec();
        right.resize(self.n, last);
        lu::solve(&self.matrix, &self.pivots, &mut right, self.n);
        right
    }
}

/// The null vectors of a singular matrix, of length 1: J v = 0 and w J = 0.
pub(in crate::solver) struct Null {
    pub(super) v: Vec<f64>,
    pub(super) w: Vec<f64>,
}

impl Null {
    /// Computes the null vectors by bordering the matrix with an arbitrary vector, which must not
    /// be orthogonal to them. Returns `None` if the bordered matrix is singular.
    pub(super) fn of(matrix: &[f64], n: usize) -> Option<Null> {
        let any = arbitrary(n);
        let null = |matrix: &[f64]| {
            let mut x =
                BorderedMatrix::new(matrix, n, Some((&any, &any)))?.solve(&vec![0.0; n], 1.0);
            x.truncate(n);
            let length = dot(&x, &x).sqrt();
            x.iter_mut().for_each(|v| *v /= length);
            length.is_finite().then_some(x)
        };
        Some(Null {
            v: null(matrix)?,
            w: null(&transposed(matrix, n))?,
        })
    }
}

/// Returns an arbitrary vector.
fn arbitrary(n: usize) -> Vec<f64> {
    (0..n).map(|i| (1.7 * i as f64 + 0.3).cos()).collect()
}

/// Returns the transpose of a square matrix.
fn transposed(matrix: &[f64], n: usize) -> Vec<f64> {
    (0..n * n).map(|k| matrix[k % n * n + k / n]).collect()
}

impl Coupled {
    /// Returns how many coefficients of the group follow from its inputs.
    pub(super) fn known(&self, q: Series, state: &State<Series>) -> usize {
        let (points, links) = self.inputs();
        let points = points.into_iter().map(|p| state.points[p.index()].p);
        let links = links.into_iter().map(|l| state.links[l.index()].d);
        let known = points.chain(links).map(|v| v.x.known.min(v.y.known));
        known.fold(q.known, usize::min)
    }

    /// Returns the residuals of the group's equations at the places in a workspace.
    pub(in crate::solver) fn misfit<'s, T: Number>(
        &self,
        q: T,
        here: &'s mut Workspace<T>,
    ) -> &'s [T] {
        let Workspace { state, scratch, .. } = here;
        let mut buffers = self.open(scratch);
        self.read(state, buffers.z);
        self.residuals(q, state, &mut buffers);
        buffers.right
    }

    /// Returns a function of the places in a workspace with a simple zero where the matrix is singular, and
    /// the measure of the group. The function is the reciprocal of an element of the inverse matrix, in an
    /// arbitrary basis.
    pub(in crate::solver) fn distance_and_measure(
        &self,
        q: f64,
        here: &mut Workspace,
    ) -> (f64, f64) {
        let n = self.unknowns();
        let Workspace { state, scratch, .. } = here;
        self.read(state, self.open(scratch).z);
        let measure = self.measure(q, state, scratch);
        let matrix = self.matrix(q, here);
        let any = arbitrary(n);
        let solved = BorderedMatrix::new(&matrix, n, None).map(|m| m.solve(&any, 0.0));
        (solved.map_or(0.0, |x| 1.0 / dot(&any, &x)), measure)
    }

    /// Computes the group's series about a state, and writes its points and links into `series`.
    /// The scratch of `here` holds the group's z at a regular state, `branch` that at a singular one;
    /// both workspaces hold the group's inputs. Returns `false` if the series cannot be found.
    pub(in crate::solver) fn follow(
        &self,
        q: Series,
        here: &mut Workspace,
        branch: Option<&Branch<'_>>,
        series: &mut Workspace<Series>,
    ) -> bool {
        let mut buffers = self.open(&mut here.scratch);
        if let Some(Branch { z, .. }) = branch {
            let own = buffers.z.iter_mut().zip(*z);
            own.for_each(|(own, z)| *own = z.hi);
        }
        self.jacobian(q.nearest(), &here.state, &mut buffers);
        let z = buffers.z.to_vec();
        let matrix = buffers.matrix.to_vec();
        let Workspace { state, scratch, .. } = series;
        let mut path = Path {
            q,
            known: self.known(q, state),
            ..Path::new(self, &z)
        };
        if let Some(Branch { z, .. }) = branch {
            path.start_at(z);
        }
        let toward = branch.map(|branch| branch.rate);
        let done = path.solve(&matrix, toward, state, scratch).is_some();
        if done {
            let known = path.known;
            path.write(q, known, series);
        }
        done
    }
}

/// The branch on which the motion passes a singular state of a group.
pub(in crate::solver) struct Branch<'a> {
    /// The unknowns z at the singular state.
    pub(in crate::solver) z: &'a [Double],
    /// The rate of z with which the motion approaches it.
    pub(in crate::solver) rate: &'a [f64],
}

/// The unknowns of a group as series: joints relative to their positions in z, angles relative to
/// their directions in z.
pub(super) struct Path<'a> {
    group: &'a Coupled,
    pub(super) q: Series,
    z: &'a [f64],
    pub(super) unknowns: Vec<Series>,
    /// Number of coefficients to compute.
    known: usize,
}

impl<'a> Path<'a> {
    pub(super) fn new(group: &'a Coupled, z: &'a [f64]) -> Path<'a> {
        Path {
            group,
            q: Series::default(),
            z,
            unknowns: vec![Series::default(); group.unknowns()],
            known: 0,
        }
    }

    /// Starts the unknowns at a solution in double-double. At a singular state, the equations leave
    /// their components along the null vector open.
    fn start_at(&mut self, z: &[Double]) {
        let joints = 2 * self.group.free;
        for (unknown, (&z, &near)) in self.unknowns[..joints].iter_mut().zip(z.iter().zip(self.z)) {
            unknown.c[0] = z - Double::exactly(near);
        }
        let directions = z[joints..].chunks(2).zip(self.z[joints..].chunks(2));
        for (unknown, (z, near)) in self.unknowns[joints..].iter_mut().zip(directions) {
            let [z, near] = [Vec2::new(z[0], z[1]), Vec2::new(near[0], near[1]).exactly()];
            // The angle is a rounding error of a double.
            unknown.c[0] = near.cross(z) / near.norm2();
        }
    }

    /// Writes the group's points and links, with the first `known` coefficients of the unknowns.
    pub(super) fn write(&mut self, q: Series, known: usize, series: &mut Workspace<Series>) {
        let Workspace { state, scratch, .. } = series;
        let mut buffers = self.group.open(scratch);
        buffers.first.fill(Series::default());
        buffers.second.fill(Series::default());
        self.fill(known, &mut buffers);
        self.group.write(q, state, &buffers);
    }

    fn solve(
        &mut self,
        matrix: &[f64],
        toward: Option<&[f64]>,
        state: &State<Series>,
        scratch: &mut Scratch<Series>,
    ) -> Option<()> {
        let n = self.group.unknowns();
        let null = match toward {
            Some(_) => Some(Null::of(matrix, n)?),
            None => None,
        };
        let border = null.as_ref().map(|null| (&null.w[..], &null.v[..]));
        let solver = BorderedMatrix::new(matrix, n, border)?;
        let left = match &null {
            Some(null) => {
                // The last coefficient of a singular group would need one more order.
                self.known = self.known.saturating_sub(1);
                self.left_null(null, matrix, state, scratch)?
            }
            None => Vec::new(),
        };
        let mut slope = None;
        for k in 0..self.known {
            // Each correction is solved in doubles and adds as many digits again.
            for _ in 0..CORRECTIONS {
                let right = self.coefficients(k, state, scratch);
                let found = solver.solve(&right, 0.0);
                self.add(k, &found[..n], -1.0);
                let (Some(null), Some(toward), 1..) = (&null, toward, k) else {
                    continue;
                };
                let share = match slope {
                    // In every order, the slope with respect to s equals the first order's slope at
                    // the tangent.
                    Some(steep) => {
                        let next = self.exact_coefficients(k + 1, state, scratch);
                        -product(&left, &next).hi / steep
                    }
                    None => {
                        let both = (null, &left[..]);
                        let (share, steep) = self.tangent(both, toward, state, scratch)?;
                        slope = Some(steep);
                        share
                    }
                };
                self.add(k, &null.v, share);
            }
        }
        let is_finite = |u: &Series| u.c.iter().all(|c| c.hi.is_finite());
        self.unknowns.iter().all(is_finite).then_some(())
    }

    /// Returns the left null vector of the matrix at the first coefficients, in double-double. That of
    /// the matrix in doubles would add its rounding error, times the next coefficients, to s.
    fn left_null(
        &self,
        null: &Null,
        matrix: &[f64],
        state: &State<Series>,
        scratch: &mut Scratch<Series>,
    ) -> Option<Vec<Double>> {
        let n = self.group.unknowns();
        let transposed = transposed(matrix, n);
        let solver = BorderedMatrix::new(&transposed, n, Some((&null.v, &null.w)))?;
        let mut buffers = self.group.open(scratch);
        self.fill(1, &mut buffers);
        self.group.jacobian(self.q, state, &mut buffers);
        let mut left: Vec<Double> = null.w.iter().map(|&w| Double::exactly(w)).collect();
        for _ in 0..CORRECTIONS {
            let column = |j: usize| -> Vec<Double> {
                let rows = buffers.matrix.chunks(n);
                rows.map(|row| row[j].c[0]).collect()
            };
            let right: Vec<f64> = (0..n).map(|j| product(&left, &column(j)).hi).collect();
            for (w, by) in left.iter_mut().zip(solver.solve(&right, 0.0)) {
                *w += Double::exactly(-by);
            }
        }
        Some(left)
    }

    /// Returns the share s of the null vector in the first coefficients on the motion's branch, and
    /// the slope of the next order's equations by s there. Returns `None` if the branches touch.
    fn tangent(
        &mut self,
        (null, left): (&Null, &[Double]),
        toward: &[f64],
        state: &State<Series>,
        scratch: &mut Scratch<Series>,
    ) -> Option<(f64, f64)> {
        let mut at = |share: f64| {
            self.add(1, &null.v, share);
            let next = self.exact_coefficients(2, state, scratch);
            self.add(1, &null.v, -share);
            product(left, &next).hi
        };
        let values = [at(0.0), at(1.0), at(-1.0)];
        tangent(values, dot(toward, &null.v))
    }

    /// Returns the k-th coefficients of the equations, in doubles.
    pub(super) fn coefficients(
        &self,
        k: usize,
        state: &State<Series>,
        scratch: &mut Scratch<Series>,
    ) -> Vec<f64> {
        let exact = self.exact_coefficients(k, state, scratch);
        exact.iter().map(|c| c.hi).collect()
    }

    /// Returns the k-th coefficients of the equations.
    fn exact_coefficients(
        &self,
        k: usize,
        state: &State<Series>,
        scratch: &mut Scratch<Series>,
    ) -> Vec<Double> {
        let mut buffers = self.group.open(scratch);
        self.fill(k + 1, &mut buffers);
        self.group.residuals(self.q, state, &mut buffers);
        buffers.right.iter().map(|r| r.c[k]).collect()
    }

    pub(super) fn add(&mut self, k: usize, change: &[f64], times: f64) {
        for (unknown, change) in self.unknowns.iter_mut().zip(change) {
            unknown.c[k] += Double::exactly(change * times);
        }
    }

    /// Writes the first `known` coefficients of the unknowns into z.
    pub(super) fn fill(&self, known: usize, buffers: &mut GroupScratch<'_, Series>) {
        let joints = 2 * self.group.free;
        for i in 0..joints {
            buffers.z[i] = Series::exactly(self.z[i]) + self.unknowns[i].cut(known);
        }
        for (i, angle) in self.unknowns[joints..].iter().enumerate() {
            let angle = angle.cut(known);
            let at = joints + 2 * i;
            let start = Vec2::new(self.z[at], self.z[at + 1]).exactly::<Double>();
            let unit = start / start.norm();
            let nudge = turned_slightly(angle.c[0]);
            let start = unit.turned(nudge).map(Series::constant);
            let turned = start.turned(angle.turning());
            (buffers.z[at], buffers.z[at + 1]) = (turned.x, turned.y);
        }
    }
}

/// Returns the unit vector at an angle in radians, which is usually a small correction.
fn turned_slightly(angle: Double) -> Vec2<Double> {
    if angle.hi.abs() < SMALL_ANGLE {
        Vec2::new(Double::ONE, angle)
    } else {
        Number::unit(angle * Double::DEGREES)
    }
}

/// Returns the zero nearest to `wanted` of a quadratic polynomial a s^2 + b s + c with these values
/// at 0, 1 and -1, and the slope there. Returns `None` if the zeros are too close to each other.
pub(super) fn tangent(values: [f64; 3], wanted: f64) -> Option<(f64, f64)> {
    let tangents = tangents(values)?.into_iter();
    let finite = tangents.filter(|(s, _)| s.is_finite());
    let distance = |(s, _): &(f64, f64)| (s - wanted).abs();
    finite.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Returns both zeros of the polynomial of [`tangent`], each with the slope there. A zero is
/// infinite if the polynomial is linear.
pub(super) fn tangents([c, plus, minus]: [f64; 3]) -> Option<[(f64, f64); 2]> {
    let (a, b) = (0.5 * (plus + minus) - c, 0.5 * (plus - minus));
    let discriminant = b * b - 4.0 * a * c;
    // Negated so that NaN is rejected.
    if !(discriminant > TANGENTIAL * (b * b + (a * c).abs())) {
        return None;
    }
    let half = -0.5 * (b + discriminant.sqrt().copysign(b));
    Some([half / a, c / half].map(|s| (s, 2.0 * a * s + b)))
}
