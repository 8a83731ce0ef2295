//! Selects the displayed range of values.

/// Quantiles of the samples that count as usual values.
const USUAL_QUANTILES: (f64, f64) = (0.02, 0.98);
/// Next to a gap, a range larger than the usual one by the factor `UNUSUAL` is cut off, at `BEYOND`
/// times the usual range beyond it.
const UNUSUAL: f64 = 3.0;
const BEYOND: f64 = 0.5;
/// Maximum overshoot of a curve between samples, as a fraction of the range.
pub(super) const NEAR: f64 = 0.05;

/// Returns the displayed range, without the values to which rates grow near a gap.
pub(super) fn shown(values: &[Option<f64>], breaks: &[bool]) -> Option<(f64, f64)> {
    let (low, high) = ends(values)?;
    let is_whole = values.iter().all(Option::is_some) && !breaks.contains(&true);
    let (usual_low, usual_high) = usual(values)?;
    let size = usual_high - usual_low;
    if is_whole || size <= 0.0 || high - low <= UNUSUAL * size {
        return Some((low, high));
    }
    let beyond = BEYOND * size;
    Some((low.max(usual_low - beyond), high.min(usual_high + beyond)))
}

/// Returns the smallest and the largest value.
pub(super) fn ends(values: &[Option<f64>]) -> Option<(f64, f64)> {
    let mut values = values.iter().copied().flatten();
    let first = values.next()?;
    Some(values.fold((first, first), |(low, high), v| (low.min(v), high.max(v))))
}

/// Returns the range of the usual values.
pub(super) fn usual(values: &[Option<f64>]) -> Option<(f64, f64)> {
    let mut sorted: Vec<f64> = values.iter().copied().flatten().collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a part of an index"
    )]
    let at = |part: f64| sorted[((last as f64 * part).round() as usize).min(last)];
    Some((at(USUAL_QUANTILES.0), at(USUAL_QUANTILES.1)))
}
