//! The root of a function on the walk, where there is one.

use crate::numeric::root;

/// As [`root`]; `None` where there is none, whatever the reason.
pub(super) fn zero(
    a: (f64, f64),
    b: (f64, f64),
    finest: f64,
    f: impl FnMut(f64) -> Option<f64>,
) -> Option<f64> {
    root(a, b, finest, f).ok()
}
