//! Computes a coupled group as a series through two crossings close to each other, between which
//! its input reverses.
//!
//! In doubles neither crossing can be located: the equations of a crossing are also solved by the
//! reversal. About each crossing alone, a series loses its digits. The equations are therefore
//! opened by b along w, so that J is singular:
//!
//! ```text
//! F(z, q) + b w = 0      J(z, q) v = 0      c.v = 1
//! ```
//!
//! This system is regular at a crossing and at the reversal, so that z, v and b are series in the
//! driver's coordinate. Two solutions cross where b has a double zero. At two such places
//! b = P^2 B with the polynomial P of both (see [`Pair`]). With F(z) = -b w and J v = 0, the
//! equations at z + P s v + P^2 e are divisible by P^2. With Q(v, v) for the second derivative of F
//! along v, they are
//!
//! ```text
//! -B w + s^2 Q(v, v) / 2 + J e + P (...) = 0      c.e = 0
//! ```
//!
//! This is a regular system for the series s and e. Its two solutions, which differ by the sign of
//! s, are the branches.

use super::Coupled;
use super::series::{BorderedMatrix, Null, Path};
use super::singular::{System, add};
use crate::arithmetic::Series;
use crate::solver::elements::Pair;
use crate::solver::lu::{self, dot};
use crate::solver::state::State;
use crate::solver::workspace::Workspace;
use crate::{Double, Number, Vec2};

/// Maximum number of Newton steps to an opening.
const STEPS: usize = 20;
/// Size of the last Newton step in doubles. The series corrects the remaining digits.
const MAX_LAST_STEP: f64 = 1e-9;
/// Maximum rate of the opening near three of its extremes. The rate is a product of their distances,
/// which are below a tenth, and a number about as large as a link.
const MAX_RATE: f64 = 1e-2;
/// Number of corrections per coefficient: the second one finds the digits that doubles do not hold.
const CORRECTIONS: usize = 2;
/// Maximum number of passes over all coefficients. Each reduces the error by about the square of
/// the ratio of the crossings' distance to the radius of convergence.
const MAX_SWEEPS: usize = 12;
/// Distance at which corrections of coefficients are compared, about that of the crossings.
const SWEEP_DISTANCE: f64 = 1e-2;
/// Maximum correction at [`SWEEP_DISTANCE`] that ends the passes.
const SWEPT: f64 = 1e-28;

/// A group at a place where its opened equations are solved, in doubles.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Opening {
    z: Vec<f64>,
    v: Vec<f64>,
    by: f64,
    /// The vectors c and w.
    c: Vec<f64>,
    w: Vec<f64>,
}

/// The solution of a group's opened equations as series.
pub(in crate::solver) struct OpeningSeries {
    unknowns: Vec<Series>,
    v: Vec<Series>,
    /// The opening b.
    pub(in crate::solver) by: Series,
    opening: Opening,
    /// The matrix J at the centre.
    matrix: Vec<f64>,
    /// Q(v, v) at the centre.
    bend: Vec<f64>,
}

impl Coupled {
    /// Solves the opened equations at a coordinate, from the z in the scratch. `here` holds the
    /// group's inputs with their rates. Returns `None` if Newton's method does not converge, or if
    /// the opening has no extreme near the coordinate.
    pub(in crate::solver) fn opening(&self, q: f64, here: &mut Workspace) -> Option<Opening> {
        let n = self.unknowns();
        let Workspace { state, scratch, .. } = here;
        let mut buffers = self.open(scratch);
        self.jacobian(q, state, &mut buffers);
        let Null { v: c, w } = Null::of(buffers.matrix, n)?;
        let z = buffers.z.to_vec();
        let mut opening = Opening {
            z,
            v: c.clone(),
            by: 0.0,
            c,
            w,
        };
        for _ in 0..STEPS {
            let (size, change) = self.opened_system(&opening, q, here).solved()?;
            self.shift(&mut opening.z, &change[..n]);
            opening.by += change[n];
            add(&mut opening.v, &change[n + 1..]);
            if size < MAX_LAST_STEP {
                return self.is_extreme(&opening, q, here).then_some(opening);
            }
        }
        None
    }

    /// Returns `true` if the opening may have an extreme close to a coordinate: its rate is
    /// w.F_q, with the opposite sign.
    fn is_extreme(&self, at: &Opening, q: f64, here: &mut Workspace) -> bool {
        let Workspace { state, scratch, .. } = here;
        let mut buffers = self.open(scratch);
        buffers.z.copy_from_slice(&at.z);
        buffers.first.fill(0.0);
        buffers.second.fill(0.0);
        self.rates(q, state, &mut buffers, 1);
        dot(&at.w, buffers.right).abs() <= MAX_RATE
    }

    /// Returns the opened equations with their derivatives by z, b and v.
    fn opened_system(&self, at: &Opening, q: f64, here: &mut Workspace) -> System {
        let n = self.unknowns();
        let Workspace { state, scratch, .. } = here;
        let mut buffers = self.open(scratch);
        buffers.z.copy_from_slice(&at.z);
        let mut system = self.fold_system(&at.v, &at.c, q, state, &mut buffers);
        // The opening takes the place of the coordinate.
        for row in 0..2 * n {
            system.matrix[row * (2 * n + 1) + n] = at.w.get(row).copied().unwrap_or(0.0);
        }
        let opened: Vec<f64> = at.w.iter().map(|w| w * at.by).collect();
        system.add_right(0, &opened);
        system
    }

    /// Computes the solution of the opened equations as series about an opening. `here` and
    /// `series` hold the group's inputs. Returns `None` if the series cannot be found.
    pub(in crate::solver) fn opening_series(
        &self,
        q: Series,
        opening: &Opening,
        here: &mut Workspace,
        series: &mut Workspace<Series>,
    ) -> Option<OpeningSeries> {
        let n = self.unknowns();
        let m = 2 * n + 1;
        let mut system = self.opened_system(opening, q.nearest(), here);
        let row = |i: usize| &system.matrix[i * m..(i + 1) * m];
        let matrix: Vec<f64> = (0..n).flat_map(|i| row(i)[..n].to_vec()).collect();
        let bend: Vec<f64> = (n..2 * n).map(|i| dot(&row(i)[..n], &opening.v)).collect();
        let mut pivots = vec![0; m];
        lu::factor(&mut system.matrix, &mut pivots, m)?;
        let mut path = Path::new(self, &opening.z);
        path.q = q;
        let exactly = |v: &f64| Series::exactly(*v);
        let mut v: Vec<Series> = opening.v.iter().map(exactly).collect();
        let mut by = Series::exactly(opening.by);
        let Workspace { state, scratch, .. } = series;
        for k in 0..self.known(q, state) {
            for _ in 0..CORRECTIONS {
                let mut buffers = self.open(scratch);
                path.fill(k + 1, &mut buffers);
                self.residuals(q, state, &mut buffers);
                let opened = buffers.right.iter().zip(&opening.w);
                let opened = opened.map(|(f, &w)| f.c[k] + Double::exactly(w) * by.c[k]);
                let mut right: Vec<f64> = opened.map(|r| r.hi).collect();
                self.jacobian(q, state, &mut buffers);
                let along: Vec<Series> = v.iter().map(|v| v.cut(k + 1)).collect();
                let singular = buffers.matrix.chunks(n).map(|row| dot(row, &along).c[k].hi);
                right.extend(singular);
                let terms = opening.c.iter().zip(&v);
                let length = terms.fold(Double::ZERO, |sum, (&c, v)| {
                    sum + Double::exactly(c) * v.c[k]
                });
                let wanted = if k == 0 { Double::ONE } else { Double::ZERO };
                right.push((length - wanted).hi);
                lu::solve(&system.matrix, &pivots, &mut right, m);
                path.add(k, &right[..n], -1.0);
                by.c[k] += -Double::exactly(right[n]);
                for (v, change) in v.iter_mut().zip(&right[n + 1..]) {
                    v.c[k] += -Double::exactly(*change);
                }
            }
        }
        let known = self.known(q, state);
        let cut = |series: Vec<Series>| series.into_iter().map(|s| s.cut(known)).collect();
        let found = OpeningSeries {
            unknowns: cut(path.unknowns),
            v: cut(v),
            by: by.cut(known),
            opening: opening.clone(),
            matrix,
            bend,
        };
        let is_finite = |s: &Series| s.c.iter().all(|c| c.hi.is_finite());
        let is_found = found.unknowns.iter().all(is_finite) && is_finite(&found.by);
        is_found.then_some(found)
    }

    /// Returns the component along c by which a state of the group, in the scratch, differs from
    /// the opened solution at a distance from the centre.
    pub(in crate::solver) fn displacement(
        &self,
        found: &OpeningSeries,
        by: f64,
        mut here: Workspace,
    ) -> f64 {
        let buffers = self.open(&mut here.scratch);
        let joints = 2 * self.free;
        let terms = found.unknowns.iter().zip(&found.opening.c).enumerate();
        terms.fold(0.0, |sum, (i, (unknown, c))| {
            let from = &found.opening.z;
            let away = if i < joints {
                buffers.z[i] - from[i]
            } else {
                let at = joints + 2 * (i - joints);
                let [from, to] = [&from[..], &*buffers.z].map(|z| Vec2::new(z[at], z[at + 1]));
                from.cross(to).atan2(from.dot(to))
            };
            sum + c * (away - unknown.value(Double::exactly(by)).hi)
        })
    }

    /// Computes the group's series on the branch whose displacement has the sign `side` outside the
    /// crossings, and writes its points and links into `series`. Returns the displacement. Returns
    /// `None` if the branches touch or the series cannot be found.
    pub(in crate::solver) fn follow_pair(
        &self,
        q: Series,
        (found, pair): (&OpeningSeries, Pair),
        side: f64,
        series: &mut Workspace<Series>,
    ) -> Option<Series> {
        let n = self.unknowns();
        let Opening { z, c, w, .. } = &found.opening;
        let (quotient, _) = found.by.divided(pair.squared());
        let square = 2.0 * quotient.nearest() * dot(w, w) / dot(w, &found.bend);
        // Negated so that NaN is rejected.
        if !(square > 0.0) {
            return None;
        }
        let first = square.sqrt().copysign(side);
        let slope: Vec<f64> = found.bend.iter().map(|b| first * b).collect();
        let solver = BorderedMatrix::new(&found.matrix, n, Some((&slope, c)))?;
        let known = quotient.known;
        let mut share = Series::exactly(first);
        let mut rest = vec![Series::default(); n];
        let mut path = Path::new(self, z);
        path.q = q;
        let Workspace { state, scratch, .. } = series;
        for sweep in 0..MAX_SWEEPS {
            let mut largest: f64 = 0.0;
            let corrections = if sweep == 0 { CORRECTIONS } else { 1 };
            for k in (0..known).flat_map(|k| std::iter::repeat_n(k, corrections)) {
                found.displace(&mut path, pair, (share, &rest));
                let terms = if sweep == 0 { k + 5 } else { found.by.known };
                let equations = self.all_coefficients(&path, terms, state, scratch);
                let right: Vec<f64> = equations
                    .into_iter()
                    .map(|f| f.divided(pair.squared()).0.c[k].hi)
                    .collect();
                let off = c.iter().zip(&rest).map(|(c, e)| c * e.c[k].hi).sum();
                let change = solver.solve(&right, off);
                for (e, change) in rest.iter_mut().zip(&change) {
                    e.c[k] += -Double::exactly(*change);
                }
                share.c[k] += -Double::exactly(change[n]);
                largest = largest.max(lu::largest(&change) * SWEEP_DISTANCE.powi(k as i32));
            }
            if largest <= SWEPT {
                break;
            }
        }
        found.displace(&mut path, pair, (share, &rest));
        let is_finite = |u: &Series| u.c.iter().all(|c| c.hi.is_finite());
        if !path.unknowns.iter().all(is_finite) {
            return None;
        }
        path.write(q, known, series);
        Some(share.cut(known).multiplied(pair.lower).cut(known))
    }

    /// Returns the first coefficients of the equations as series.
    fn all_coefficients(
        &self,
        path: &Path<'_>,
        terms: usize,
        state: &State<Series>,
        scratch: &mut super::Scratch<Series>,
    ) -> Vec<Series> {
        let mut buffers = self.open(scratch);
        path.fill(terms, &mut buffers);
        self.residuals(path.q, state, &mut buffers);
        buffers.right.to_vec()
    }
}

impl OpeningSeries {
    /// Sets the unknowns to z + P s v + P^2 e.
    fn displace(&self, path: &mut Path<'_>, pair: Pair, (share, rest): (Series, &[Series])) {
        let unknowns = path.unknowns.iter_mut().zip(&self.unknowns);
        for ((unknown, &start), (&v, &e)) in unknowns.zip(self.v.iter().zip(rest)) {
            let along = (share * v).multiplied(pair.lower);
            let more = along + e.multiplied(pair.squared());
            *unknown = start + more;
        }
    }
}
