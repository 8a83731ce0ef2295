//! Fits datums and scales to the positions of the pins.

use super::task::wrapped;

/// Returns the indices in ascending order of x.
pub(super) fn in_order(xs: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..xs.len()).collect();
    order.sort_by(|a, b| xs[*a].total_cmp(&xs[*b]));
    order
}

/// Fits `datum + scale value` to measured numbers and returns the datum and the scale, each of
/// which may be given.
///
/// Angles are determined up to full turns. A given datum is determined up to its `period`: half a
/// turn for a link that may be opposite to its angle, a whole turn for a crank that may not, and
/// `None` for a travel. The miss is minimised in units of the value, as in the search that found
/// the linkage.
pub(super) fn fitted(
    order: &[usize],
    values: &[f64],
    measured: &[f64],
    [datum, scale]: [Option<f64>; 2],
    period: Option<f64>,
) -> Option<[f64; 2]> {
    let first = *order.first()?;
    let expected = |value: f64| Some(scale? * (value - values[first]));
    let mut unwrapped = measured.to_vec();
    if period.is_some() {
        let mut before = first;
        for &i in order {
            // A given scale determines the turn of the next value; if it is free, the nearest turn
            // applies.
            let guess = match expected(values[i]) {
                Some(way) => measured[first] + way,
                None => unwrapped[before],
            };
            unwrapped[i] = guess + wrapped(measured[i] - guess);
            before = i;
        }
    }
    let count = values.len() as f64;
    let mean = |all: &[f64]| all.iter().sum::<f64>() / count;
    let (middle, level) = (mean(values), mean(&unwrapped));
    let product = |a: &[f64], a0: f64, b: &[f64], b0: f64| -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - a0) * (b - b0)).sum()
    };
    let turned = |rest: f64| period.map_or(0.0, |period| (rest / period).round() * period);
    let fitted = match (datum, scale) {
        (None, None) => {
            // The regression line of the value over the measured numbers.
            let scale = product(&unwrapped, level, &unwrapped, level)
                / product(values, middle, &unwrapped, level);
            [level - scale * middle, scale]
        }
        (None, Some(scale)) => [level - scale * middle, scale],
        (Some(datum), None) => {
            // First with a free datum, to find the number of periods; then with the line through
            // the datum.
            let rough = product(&unwrapped, level, &unwrapped, level)
                / product(values, middle, &unwrapped, level);
            let from = datum + turned(level - rough * middle - datum);
            let scale = product(&unwrapped, from, &unwrapped, from)
                / product(values, 0.0, &unwrapped, from);
            [from, scale]
        }
        (Some(datum), Some(scale)) => [datum + turned(level - scale * middle - datum), scale],
    };
    fitted.iter().all(|v| v.is_finite()).then_some(fitted)
}
