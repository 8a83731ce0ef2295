//! Builds the chart of an iterative method's errors, iteration by iteration.

use crate::drawing::plot::{Chart, Datum, DecadeAxis};
use crate::study::ErrorCurve;
use crate::wording::words;

/// Returns the chart of the errors of one or more groups. The points of a single curve are joined.
#[must_use]
pub fn convergence(curves: &[ErrorCurve]) -> Chart {
    let of = |curve: &ErrorCurve| {
        let mark = curve.mark;
        let errors = (0_i32..).zip(curve.errors.clone());
        let data = errors.map(move |(k, error)| Datum {
            x: 10.0_f64.powi(k),
            y: error,
            letter: mark,
            best: curves.len() == 1,
        });
        data.collect::<Vec<_>>()
    };
    // The axis counts iterations from 0: its decades are labelled by their exponents.
    let iterations = DecadeAxis {
        title: words().iteration().into(),
        label: |power| power.to_string(),
    };
    Chart::of_errors(iterations, curves.iter().flat_map(of))
}
