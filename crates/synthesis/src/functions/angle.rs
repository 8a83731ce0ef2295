//! Solves angle-to-angle functions by Freudenstein's equation with signed ratios (Freudenstein
//! 1955, "Approximate synthesis of four-bar linkages", Trans. ASME 77, 853-861).
//!
//! With the pivots 1 apart, the crank z e^(i p) and the output link w e^(i q), z and w complex, C -
//! B = b says
//!
//! ```text
//! |1 + w e^iq - z e^ip|^2 = b^2
//! s + Re(w e^iq) - Re(z e^ip) - Re(u e^i(q - p)) = 0,   s = (1 + |w|^2 + |z|^2 - b^2) / 2,   u = w z*
//! ```
//!
//! which divided by |w z| is K1 cos(phi) - K2 cos(psi) + K3 = cos(phi - psi). The arguments of z
//! and w are the datums.
//!
//! If both datums are given, z and w are real, and a negative one is a link opposite to its angle.
//! Three pairs are then linear in (s, w, z, u) up to a factor. Every free datum makes its factor
//! complex and adds the condition that u / (w z*) is real. The condition on u w* z has degree 3, so
//! that four pairs have at most two solutions (the third is w = 0 or z = 0) and five have three.

use super::lines::solved;
use super::linkage::FunctionLinkage;
use super::refine::FunctionDesign;
use super::task::{FunctionLaw, TargetFunction};
use super::{ExactDesigns, law_angles};
use nalgebra::{Complex, DVector};

/// The layout of the unknowns in a vector: s, w, z, u, each complex one as real and imaginary part.
struct AngleColumns {
    crank_is_free: bool,
    output_is_free: bool,
}

/// Returns all four-bars through as many pairs as there are unknowns. For more pairs, returns the
/// ones with the smallest residual of the equation, as starting points.
///
/// Returns `None` if a scale is free.
pub(super) fn exact(target: &TargetFunction) -> Option<ExactDesigns> {
    let (angles, crank_scale, output_scale) = law_angles(target)?;
    let columns = AngleColumns {
        crank_is_free: target.given[0].is_none(),
        output_is_free: target.given[2].is_none(),
    };
    let rows: Vec<Vec<f64>> = angles.iter().map(|[p, q]| columns.row(*p, *q)).collect();
    let free = if columns.has_given_crank() { 1 } else { 2 };
    let solved = solved(&rows, free, |v| columns.condition(v));
    let law = |z: f64, w: f64| FunctionLaw {
        crank: [target.given[0].unwrap_or(z), crank_scale],
        output: [target.given[2].unwrap_or(w), output_scale],
    };
    let designs = solved.vectors.iter().filter_map(|v| {
        let (linkage, [z, w]) = columns.linkage(v, target)?;
        let law = law(z, w);
        let [x, y] = *target.pairs.first()?;
        let at = |[datum, scale]: [f64; 2], value| datum + scale * value;
        let side = linkage.side(at(law.crank, x), at(law.output, y));
        Some(FunctionDesign { linkage, law, side })
    });
    Some(ExactDesigns {
        designs: designs.collect(),
        is_complete: solved.is_complete,
    })
}

impl AngleColumns {
    fn has_given_crank(&self) -> bool {
        !self.crank_is_free && !self.output_is_free
    }

    /// Returns one pair's equation: the factors of s, w, z and u, each with the real part and, for
    /// a complex unknown, the imaginary part.
    fn row(&self, p: f64, q: f64) -> Vec<f64> {
        let mut row = vec![1.0];
        let mut put = |angle: f64, sign: f64, is_complex: bool| {
            row.push(sign * angle.cos());
            if is_complex {
                row.push(-sign * angle.sin());
            }
        };
        put(q, 1.0, self.output_is_free);
        put(p, -1.0, self.crank_is_free);
        put(q - p, -1.0, !self.has_given_crank());
        row
    }

    /// Returns s, w, z and u of a vector.
    fn parts(&self, v: &DVector<f64>) -> (f64, [Complex<f64>; 3]) {
        let mut at = 1;
        let mut take = |is_complex: bool| {
            let real = v[at];
            let imaginary = if is_complex { v[at + 1] } else { 0.0 };
            at += 1 + usize::from(is_complex);
            Complex::new(real, imaginary)
        };
        let w = take(self.output_is_free);
        let z = take(self.crank_is_free);
        let u = take(!self.has_given_crank());
        (v[0], [w, z, u])
    }

    fn condition(&self, v: &DVector<f64>) -> f64 {
        let (_, [w, z, u]) = self.parts(v);
        (u * w.conj() * z).im
    }

    /// Returns the linkage of a vector, which is defined up to a factor, and the arguments of z and
    /// w.
    fn linkage(
        &self,
        v: &DVector<f64>,
        target: &TargetFunction,
    ) -> Option<(FunctionLinkage, [f64; 2])> {
        let (s, [w, z, u]) = self.parts(v);
        let product = w * z.conj();
        // factor u = factor^2 w z*
        let factor = (u * product.conj()).re / product.norm_sqr();
        let (s, w, z) = (s * factor, w * factor, z * factor);
        let square = 1.0 + w.norm_sqr() + z.norm_sqr() - 2.0 * s;
        let length = |v: Complex<f64>, is_free: bool| if is_free { v.norm() } else { v.re };
        let linkage = FunctionLinkage {
            output: target.output,
            crank: length(z, self.crank_is_free),
            coupler: square.sqrt(),
            third: length(w, self.output_is_free),
        };
        linkage.is_valid().then(|| (linkage, [z.arg(), w.arg()]))
    }
}
