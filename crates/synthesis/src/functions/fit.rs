//! Datums and scales from where the pins are.

use super::wanted::wrapped;

/// The indices from the least to the greatest x.
pub(super) fn in_order(xs: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..xs.len()).collect();
    order.sort_by(|a, b| xs[*a].total_cmp(&xs[*b]));
    order
}

/// The datum and the scale, given or not, with which `datum + scale value` fits measured numbers best; of angles up to
/// full turns, and of a given datum up to its `period`: half a turn of a link that may stand opposite to its angle, a whole
/// one of a crank that may not, none of a travel. What is minimised is the miss counted in the value, as where the
/// linkage was found.
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
            // Where the scale is given it says on which turn the next one is; else that is the nearest.
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
            // The line of the value over what was measured.
            let scale = product(&unwrapped, level, &unwrapped, level)
                / product(values, middle, &unwrapped, level);
            [level - scale * middle, scale]
        }
        (None, Some(scale)) => [level - scale * middle, scale],
        (Some(datum), None) => {
            // First as if the datum were free, to see how it is turned; then through it.
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
