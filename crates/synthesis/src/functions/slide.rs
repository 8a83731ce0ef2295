//! Solves angle-to-slide functions: an offset slider-crank, crank 1 long at the angle f, coupler b,
//! the slide at (t, e).
//!
//! ```text
//! t^2 - 2 t cos f - 2 e sin f + 1 + e^2 - b^2 = 0
//! ```
//!
//! With t = T + q, where q is the wanted travel and T the free datum, it is linear in T, e and the
//! rest,
//!
//! ```text
//! q^2 - 2 q cos f + 2 T (q - cos f) - 2 e sin f + m = 0,   m = 1 + e^2 + T^2 - b^2
//! ```
//!
//! so that three pairs have one solution. If the crank's datum is free as well, f = p + a. Four
//! pairs then have a solution where the determinant of these rows, a trigonometric polynomial in a
//! of degree 3, is 0: at most six.
//!
//! If the output's scale is free, lengths are measured in units of y. The crank is z, complex, with
//! the crank's datum as its argument, and V = (T - i e) z,
//!
//! ```text
//! y^2 + 2 T y - 2 y Re(z e^ip) - 2 Re(V e^ip) + m = 0,   m = |z|^2 + e^2 + T^2 - b^2
//! ```
//!
//! linear in T, z, V and m, with the cubic condition Re(V z*) = T |z|^2. Five pairs have at most
//! three solutions; four pairs with a given datum of the crank have two. If T is given relative to
//! the crank, T = d |z|, three pairs with a given datum of the crank are linear in |z|, |z|^2, |z|
//! e and m.

use super::lines::{SAMPLES, solved};
use super::linkage::FunctionLinkage;
use super::refine::FunctionDesign;
use super::task::{FunctionLaw, TargetFunction};
use super::trigonometric::zeros;
use super::{ExactDesigns, law_angles};
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// Rows are singular if the smallest singular value is below this fraction of the largest.
const SINGULAR: f64 = 1e-12;

/// Solves like [`super::angle::exact`]. Returns `None` in the unsolved cases: a free scale of the
/// crank, or a free datum of the crank with a free output scale and a given output datum.
pub(super) fn exact(target: &TargetFunction) -> Option<ExactDesigns> {
    match target.given {
        [_, None, ..] => None,
        [Some(_), _, _, Some(_)] => Some(turned_by(target, 0.0)),
        [None, _, _, Some(_)] => Some(turned(target)),
        [_, _, None, None] => Some(in_y(target)),
        [Some(_), _, Some(datum), None] => Some(from_datum(target, datum)),
        [None, _, Some(_), None] => None,
    }
}

/// Returns the rows at a rotation of the crank: the factors of T if it is free, of e and m, and the
/// constant. Returns `None` if a scale is free.
fn rows_at(target: &TargetFunction, turn: f64) -> Option<Vec<Vec<f64>>> {
    let (angles, ..) = law_angles(target)?;
    let is_free = target.given[2].is_none();
    let row = |[p, q]: &[f64; 2]| {
        let (sin, cos) = (p + turn).sin_cos();
        let mut row = Vec::with_capacity(4);
        if is_free {
            row.push(2.0 * (q - cos));
        }
        row.extend([-2.0 * sin, 1.0, q * q - 2.0 * q * cos]);
        row
    };
    Some(angles.iter().map(row).collect())
}

/// Solves with the crank's datum increased by `turn`, in the least-squares sense for many pairs.
fn turned_by(target: &TargetFunction, turn: f64) -> ExactDesigns {
    let found = || {
        let rows = rows_at(target, turn)?;
        let width = rows.first()?.len() - 1;
        let matrix = DMatrix::from_fn(rows.len(), width, |i, j| rows[i][j]);
        let known = DVector::from_fn(rows.len(), |i, _| -rows[i][width]);
        let decomposed = nalgebra::SVD::try_new(matrix, true, true, f64::EPSILON, 200)?;
        let values = &decomposed.singular_values;
        let is_regular = values.len() == width && values.min() > SINGULAR * values.max();
        // The minimum-norm solution if the rows are singular.
        let solution = decomposed.solve(&known, SINGULAR * values.max()).ok()?;
        let (t, e, m) = match *solution.as_slice() {
            [t, e, m] => (t, e, m),
            [e, m] => (0.0, e, m),
            _ => return None,
        };
        let lengths = [1.0, (1.0 + e * e + t * t - m).sqrt(), e];
        Some((lengths, t, is_regular))
    };
    let Some((lengths, datum, is_complete)) = found() else {
        return ExactDesigns::default();
    };
    let law = |scale: f64| FunctionLaw {
        crank: [
            target.given[0].unwrap_or(0.0) + turn,
            target.given[1].unwrap_or(1.0),
        ],
        output: [target.given[2].unwrap_or(datum), scale],
    };
    let law = law(target.given[3].unwrap_or(1.0));
    ExactDesigns {
        designs: design(target, lengths, law).into_iter().collect(),
        is_complete,
    }
}

/// Solves with a free datum of the crank, at the angles where the rows including the constant are
/// singular.
fn turned(target: &TargetFunction) -> ExactDesigns {
    let width = rows_at(target, 0.0).map_or(0, |rows| rows.first().map_or(0, Vec::len));
    let determinant = |turn: f64| {
        let rows = rows_at(target, turn)?;
        Some(DMatrix::from_fn(width, width, |i, j| rows[i][j]).determinant())
    };
    let (turns, is_complete) = if target.pairs.len() == width {
        // Each column except that of m has degree 1 in cos and sin.
        match zeros(width - 1, |turn| determinant(turn).unwrap_or(f64::NAN)) {
            Some(turns) => (turns, true),
            None => (grid(), false),
        }
    } else {
        (grid(), false)
    };
    let mut all = ExactDesigns {
        is_complete,
        ..ExactDesigns::default()
    };
    for turn in turns {
        let exact = turned_by(target, turn);
        all.is_complete &= exact.is_complete;
        all.designs.extend(exact.designs);
    }
    all
}

fn grid() -> Vec<f64> {
    let step = TAU / SAMPLES as f64;
    (0..SAMPLES).map(|k| k as f64 * step).collect()
}

/// Solves with both the output's datum and its scale free.
fn in_y(target: &TargetFunction) -> ExactDesigns {
    let is_free = target.given[0].is_none();
    let (datum, scale) = (
        target.given[0].unwrap_or(0.0),
        target.given[1].unwrap_or(1.0),
    );
    let row = |[x, y]: &[f64; 2]| {
        let (sin, cos) = (datum + scale * x).sin_cos();
        let mut row = vec![y * y, 2.0 * y, 1.0, -2.0 * y * cos];
        if is_free {
            row.push(2.0 * y * sin);
        }
        row.extend([-2.0 * cos, 2.0 * sin]);
        row
    };
    let rows: Vec<Vec<f64>> = target.pairs.iter().map(row).collect();
    // The unknowns h, T, m, z, V.
    let parts = |v: &DVector<f64>| {
        let (imaginary, at) = if is_free { (v[4], 5) } else { (0.0, 4) };
        let z = Complex::new(v[3], imaginary);
        (v[0], v[1], v[2], z, Complex::new(v[at], v[at + 1]))
    };
    let condition = |v: &DVector<f64>| {
        let (h, t, _, z, big) = parts(v);
        (big * z.conj()).re * h - t * z.norm_sqr()
    };
    let solved = solved(&rows, 2, condition);
    let designs = solved.vectors.iter().filter_map(|v| {
        let (h, t, m, z, big) = parts(v);
        let (t, m, z, big) = (t / h, m / h, z / h, big / h);
        let e = -(big / z).im;
        let size = if is_free { z.norm() } else { z.re };
        let coupler = (z.norm_sqr() + e * e + t * t - m).sqrt();
        let crank = if is_free { z.arg() } else { datum };
        // The crank has length 1: a negative z reverses the lengths measured in it.
        let law = FunctionLaw {
            crank: [crank, scale],
            output: [t / size, 1.0 / size],
        };
        design(target, [1.0, coupler / size.abs(), e / size], law)
    });
    ExactDesigns {
        designs: designs.collect(),
        is_complete: solved.is_complete,
    }
}

/// Solves with a free output scale and the output's datum given in crank lengths.
fn from_datum(target: &TargetFunction, datum: f64) -> ExactDesigns {
    let (angle, turn) = (
        target.given[0].unwrap_or(0.0),
        target.given[1].unwrap_or(1.0),
    );
    // The unknowns h, |z|, |z|^2, |z| e, m.
    let row = |[x, y]: &[f64; 2]| {
        let (sin, cos) = (angle + turn * x).sin_cos();
        let linear = 2.0 * y * (datum - cos);
        vec![y * y, linear, -2.0 * datum * cos, -2.0 * sin, 1.0]
    };
    let rows: Vec<Vec<f64>> = target.pairs.iter().map(row).collect();
    let solved = solved(&rows, 2, |v| (v[2] * v[0] - v[1] * v[1]) * v[1]);
    let designs = solved.vectors.iter().filter_map(|v| {
        let (z, e, m) = (v[1] / v[0], v[3] / v[1], v[4] / v[0]);
        let coupler = (z * z * (1.0 + datum * datum) + e * e - m).sqrt();
        let law = FunctionLaw {
            crank: [angle, turn],
            output: [datum, 1.0 / z],
        };
        design(target, [1.0, coupler / z.abs(), e / z], law)
    });
    ExactDesigns {
        designs: designs.collect(),
        is_complete: solved.is_complete,
    }
}

fn design(
    target: &TargetFunction,
    [crank, coupler, third]: [f64; 3],
    law: FunctionLaw,
) -> Option<FunctionDesign> {
    let linkage = FunctionLinkage {
        output: target.output,
        crank,
        coupler,
        third,
    };
    let [x, y] = *target.pairs.first()?;
    let is_number = (law.crank.iter().chain(&law.output)).all(|v| v.is_finite());
    let at = |[datum, scale]: [f64; 2], value| datum + scale * value;
    (linkage.is_valid() && is_number).then(|| FunctionDesign {
        linkage,
        law,
        side: linkage.side(at(law.crank, x), at(law.output, y)),
    })
}
