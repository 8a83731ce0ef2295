//! The chart of a method's errors, iteration by iteration.

use super::plot::{Chart, Datum, DecadeAxis};
use crate::study::ErrorCurve;
use crate::wording::words;

/// Smaller errors, and none at all, stand here: below the rounding of one double.
const LEAST_ERROR: f64 = 1e-17;

/// The chart of the errors of one or more groups. One curve alone is joined.
#[must_use]
pub fn convergence(curves: &[ErrorCurve]) -> Chart {
    let of = |curve: &ErrorCurve| {
        let mark = curve.mark;
        let errors = (0_i32..).zip(curve.errors.clone());
        let data = errors.map(move |(k, error)| Datum {
            x: 10.0_f64.powi(k),
            y: error.max(LEAST_ERROR),
            letter: mark,
            best: curves.len() == 1,
        });
        data.collect::<Vec<_>>()
    };
    Chart {
        // An axis of decades whose labels are their powers counts from nought, one by one.
        x: DecadeAxis {
            title: words().iteration().into(),
            label: |power| power.to_string(),
        },
        y: DecadeAxis {
            title: words().error_of_iteration().into(),
            label: |power| format!("1e{power}"),
        },
        data: curves.iter().flat_map(of).collect(),
    }
}
