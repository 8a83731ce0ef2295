//! What of a range of values is worth showing.

/// Parts of the samples between which most of them are.
const USUAL: (f64, f64) = (0.02, 0.98);
/// A range that is so many times that of most samples is not shown whole next to a gap, but this much
/// beyond them.
const UNUSUAL: f64 = 3.0;
const BEYOND: f64 = 0.5;
/// So much farther out than the samples a curve may turn between them, as a part of the range.
pub(super) const NEAR: f64 = 0.05;

/// From where to where, without what only rates near a gap grow to.
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

/// The smallest and the largest value.
pub(super) fn ends(values: &[Option<f64>]) -> Option<(f64, f64)> {
    let mut values = values.iter().copied().flatten();
    let first = values.next()?;
    Some(values.fold((first, first), |(low, high), v| (low.min(v), high.max(v))))
}

/// Between which values most samples are.
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
    Some((at(USUAL.0), at(USUAL.1)))
}
