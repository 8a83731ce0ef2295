//! The best front: entries that no other entry beats in both time and error.

/// The factor from which on an error counts as smaller. The largest of some thousand rounding
/// errors is itself random.
const MIN_ERROR_RATIO: f64 = 1.2;

/// Returns for every pair of time and error whether it is on the best front. A pair is on it if no
/// other pair is faster and not clearly less accurate, or equally fast and more accurate. `None`
/// does not take part.
pub(super) fn front(costs: &[Option<[f64; 2]>]) -> Vec<bool> {
    let beats = |[time, error]: &[f64; 2], own: &[f64; 2]| {
        (*time < own[0] && *error <= MIN_ERROR_RATIO * own[1])
            || (*time <= own[0] && *error < own[1])
    };
    let is_best = |own: &[f64; 2]| !costs.iter().flatten().any(|other| beats(other, own));
    costs
        .iter()
        .map(|own| own.as_ref().is_some_and(is_best))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_contains_undominated_costs() {
        let costs = [
            Some([25.0, 1.7e-7]),
            Some([57.0, 3.0e-16]),
            Some([97.0, 1.0e-16]),
            Some([157.0, 3.4e-16]),
            Some([5869.0, 6.9e-16]),
            None,
            Some([97.0, 2.0e-16]),
            // Slower, and more accurate by no more than chance.
            Some([120.0, 0.9e-16]),
        ];
        let best = [true, true, true, false, false, false, false, false];
        assert_eq!(front(&costs), best);
    }

    #[test]
    fn equal_costs_do_not_dominate_each_other() {
        assert_eq!(front(&[Some([1.0, 1.0]), Some([1.0, 1.0])]), [true, true]);
        assert!(front(&[]).is_empty());
    }
}
