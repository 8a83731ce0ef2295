//! Computes a coupled group through a crossing as a series along its curve, with the driver's
//! coordinate as a further unknown.
//!
//! If the driver reverses directly behind the crossing, a series in its coordinate converges only up
//! to that fold. Along the curve, both are ordinary places. Let J v = 0 and w J = 0 at the crossing.
//! With the parameter t = v.z, the k-th coefficients of z and of the coordinate q solve
//!
//! ```text
//! J z_k + F_q q_k = -r_k        v.z_k = 1 for k = 1, 0 otherwise
//! ```
//!
//! This system is singular: with J p = -F_q, the share s of (p, 1) is free. As in
//! [`super::series`], the next order determines it: w.r_(k+1) = 0.
//!
//! At any other place of the curve, even at a fold, the system is regular and determines everything.

use super::Coupled;
use super::series::{BorderedMatrix, Null, Path, tangents};
use crate::Double;
use crate::arithmetic::Series;
use crate::solver::lu::dot;
use crate::solver::workspace::Workspace;

/// Number of corrections per coefficient: the second one finds the digits that doubles do not hold.
const CORRECTIONS: usize = 2;

/// Number of corrections of the first coefficients at a place that is no crossing. Close to a fold,
/// each gains only some of the digits of a double.
const FIRST_CORRECTIONS: usize = 4;

/// Minimum angle between the branches at a crossing, in radians.
const MIN_ANGLE: f64 = 0.02;

/// A coupled group at a crossing, or at another place of its curve.
pub(in crate::solver) struct CurvePlace<'a> {
    /// The unknowns z.
    pub(in crate::solver) z: &'a [f64],
    /// The matrix J, row by row.
    pub(in crate::solver) matrix: &'a [f64],
}

/// Number of branches that meet at a crossing.
pub(in crate::solver) const BRANCHES: usize = 2;

/// Places the inputs of a group at a series of the driver's coordinate, relative to the crossing and
/// in radians or scaled lengths. Returns the coordinate for the steps.
pub(in crate::solver) type PlaceInputs<'a> =
    &'a mut dyn FnMut(Series, &mut Workspace<Series>) -> Option<Series>;

impl Coupled {
    /// Returns the matrix at the z in the scratch, row by row.
    pub(in crate::solver) fn matrix(&self, q: f64, here: &mut Workspace) -> Vec<f64> {
        let mut buffers = self.open(&mut here.scratch);
        self.jacobian(q, &here.state, &mut buffers);
        buffers.matrix.to_vec()
    }

    /// Reads z from the state, and corrects it. Returns the size of the first correction, or `None`
    /// if the corrections do not converge.
    pub(in crate::solver) fn correction_at(&self, q: f64, here: &mut Workspace) -> Option<f64> {
        let Workspace { state, scratch, .. } = here;
        self.read(state, self.open(scratch).z);
        let corrected = self.correct(q, state, scratch);
        corrected.settled.then_some(corrected.first)
    }

    /// Computes the group's series along its curve, and writes its points and links into `series`.
    /// Through a crossing there are several curves: `branch` is one of them, and `None` at any other
    /// place. Returns the driver's coordinate relative to the place, which grows with the parameter
    /// there. Returns `None` if the series cannot be found.
    ///
    /// Close to a fold, the rate of the arriving motion changes too much to choose the branch. The
    /// caller compares each with that motion.
    pub(in crate::solver) fn follow_curve(
        &self,
        from: &CurvePlace<'_>,
        (branch, terms): (Option<usize>, usize),
        series: &mut Workspace<Series>,
        place: PlaceInputs<'_>,
    ) -> Option<Series> {
        let &CurvePlace { z, matrix } = from;
        let mut curve = Curve {
            path: Path::new(self, z),
            offset: Series::default(),
            place,
            null: Null::of(matrix, self.unknowns())?,
        };
        let known = match branch {
            Some(branch) => curve.solve(matrix, branch, terms, series)?,
            None => curve.solve_regular(matrix, terms, series)?,
        };
        curve.write(known, series)
    }
}

/// The unknowns of a group as series along its curve.
struct Curve<'a, 'p> {
    path: Path<'a>,
    /// The driver's coordinate relative to the crossing.
    offset: Series,
    place: PlaceInputs<'p>,
    null: Null,
}

impl Curve<'_, '_> {
    /// Computes the coefficients at a crossing. Returns their number.
    fn solve(
        &mut self,
        matrix: &[f64],
        branch: usize,
        terms: usize,
        series: &mut Workspace<Series>,
    ) -> Option<usize> {
        let n = self.null.v.len();
        self.offset.c[1] = Double::ONE;
        let by_q = self.coefficients(1, series)?;
        self.offset.c[1] = Double::ZERO;
        let border = (&self.null.w[..], &self.null.v[..]);
        let opposite: Vec<f64> = by_q.iter().map(|f| -f).collect();
        let mut free = BorderedMatrix::new(matrix, n, Some(border))?.solve(&opposite, 0.0);
        free[n] = 1.0;
        let length = dot(&free, &free).sqrt();
        free.iter_mut().for_each(|v| *v /= length);

        let rows = matrix.chunks(n).zip(&by_q);
        let mut extended: Vec<f64> = rows
            .flat_map(|(row, &f)| row.iter().copied().chain([f]))
            .collect();
        extended.extend(self.null.v.iter().copied().chain([0.0]));
        let left: Vec<f64> = self.null.w.iter().copied().chain([0.0]).collect();
        let solver = BorderedMatrix::new(&extended, n + 1, Some((&left, &free)))?;
        // The last coefficient would need one more order.
        let known = terms - 1;
        let mut slope = None;
        for k in 0..known {
            for _ in 0..CORRECTIONS {
                let mut right = self.coefficients(k, series)?;
                right.push(self.excess(k));
                let found = solver.solve(&right, 0.0);
                self.add(k, &found[..=n], -1.0);
            }
            if k == 0 {
                continue;
            }
            let steep = match slope {
                Some(steep) => steep,
                None => {
                    let mut values = [0.0; 3];
                    for (value, share) in values.iter_mut().zip([0.0, 1.0, -1.0]) {
                        self.add(1, &free, share);
                        *value = self.next(1, series)?;
                        self.add(1, &free, -share);
                    }
                    let tangents = tangents(values)?;
                    let &(share, steep) = tangents.get(branch).filter(|(s, _)| s.is_finite())?;
                    // The arrival distinguishes branches that are further apart than this.
                    let [none, plus, minus] = values;
                    let bend = 0.5 * (plus + minus) - none;
                    if steep.abs() < MIN_ANGLE * bend.abs() {
                        return None;
                    }
                    self.add(1, &free, share);
                    steep
                }
            };
            for _ in 0..CORRECTIONS {
                let next = self.next(k, series)?;
                self.add(k, &free, -next / steep);
            }
            slope = Some(steep);
        }
        let mut all = self.path.unknowns.iter().chain([&self.offset]);
        let is_finite = all.all(|u| u.c.iter().all(|c| c.hi.is_finite()));
        is_finite.then_some(known)
    }

    /// Computes the coefficients at a place that is no crossing. Returns their number.
    fn solve_regular(
        &mut self,
        matrix: &[f64],
        terms: usize,
        series: &mut Workspace<Series>,
    ) -> Option<usize> {
        let n = self.null.v.len();
        let at_place = BorderedMatrix::new(matrix, n, None)?;
        for _ in 0..FIRST_CORRECTIONS {
            let right = self.coefficients(0, series)?;
            self.path.add(0, &at_place.solve(&right, 0.0), -1.0);
        }
        self.offset.c[1] = Double::ONE;
        let by_q = self.coefficients(1, series)?;
        self.offset.c[1] = Double::ZERO;
        let solver = BorderedMatrix::new(matrix, n, Some((&by_q, &self.null.v)))?;
        for k in 1..terms {
            for _ in 0..CORRECTIONS {
                let right = self.coefficients(k, series)?;
                let found = solver.solve(&right, self.excess(k));
                self.add(k, &found, -1.0);
            }
        }
        let mut all = self.path.unknowns.iter().chain([&self.offset]);
        let is_finite = all.all(|u| u.c.iter().all(|c| c.hi.is_finite()));
        is_finite.then_some(terms)
    }

    /// Writes the group's points and links with `known` coefficients into `series`. Returns the
    /// coordinate, which grows with the parameter at the first place.
    fn write(mut self, known: usize, series: &mut Workspace<Series>) -> Option<Series> {
        self.grow_with_coordinate();
        let Curve {
            mut path,
            offset,
            place,
            ..
        } = self;
        let offset = offset.cut(known);
        let q = place(offset, series)?;
        path.write(q, known, series);
        Some(offset)
    }

    /// Reverses the parameter if the coordinate falls with it at the crossing.
    fn grow_with_coordinate(&mut self) {
        if self.offset.c[1].hi >= 0.0 {
            return;
        }
        for series in self.path.unknowns.iter_mut().chain([&mut self.offset]) {
            for c in series.c.iter_mut().skip(1).step_by(2) {
                *c = -*c;
            }
        }
    }

    /// Returns the k-th coefficients of the equations.
    fn coefficients(&mut self, k: usize, series: &mut Workspace<Series>) -> Option<Vec<f64>> {
        self.path.q = (self.place)(self.offset.cut(k + 1), series)?;
        let Workspace { state, scratch, .. } = series;
        Some(self.path.coefficients(k, state, scratch))
    }

    /// Returns the component of the equations along w in the order after k.
    fn next(&mut self, k: usize, series: &mut Workspace<Series>) -> Option<f64> {
        let next = self.coefficients(k + 1, series)?;
        Some(dot(&self.null.w, &next))
    }

    /// Returns the residual of the equation of the parameter in order k.
    fn excess(&self, k: usize) -> f64 {
        let terms = self.null.v.iter().zip(&self.path.unknowns);
        let sum = terms.fold(Double::ZERO, |sum, (&v, u)| {
            sum + Double::exactly(v) * u.c[k]
        });
        let wanted = if k == 1 { Double::ONE } else { Double::ZERO };
        (sum - wanted).hi
    }

    fn add(&mut self, k: usize, change: &[f64], times: f64) {
        self.path.add(k, change, times);
        let last = change[self.null.v.len()];
        self.offset.c[k] += Double::exactly(last * times);
    }
}
