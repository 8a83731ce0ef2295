//! The active constraints and bounds of a design, with their Lagrange multipliers.

use super::GoalSense;
use super::projection::{DesignEvaluator, DesignSlopes, EvaluatedDesign, is_finite};
use nalgebra::{DMatrix, DVector};

/// The slack below which a constraint counts as active, relative to its size.
const ACTIVE_SLACK: f64 = 1e-7;
/// The relative size below which a slope counts as zero: the error of two-sided differences,
/// relative to the slope or to the figure.
const FLAT: f64 = 1e-6;
/// The relative size below which a singular value counts as zero.
const SINGULAR: f64 = 1e-9;

/// The constraints and bounds that may be active at a design.
#[derive(Clone, Debug)]
pub(super) struct ActiveConstraints {
    all: Vec<PossibleConstraint>,
    /// Number of a design's variables.
    count: usize,
}

#[derive(Clone, Debug)]
struct PossibleConstraint {
    /// The index of the constraint; `None` for a bound.
    row: Option<usize>,
    /// The slope of its slack.
    normal: DVector<f64>,
    /// `true` for an inequality.
    is_one_sided: bool,
}

/// The active constraints and bounds at a design.
#[derive(Clone, Debug)]
pub(super) struct ActiveSet {
    /// The indices of the active constraints.
    pub(super) rows: Vec<usize>,
    /// The normals of the active constraints, then of the active bounds, one per row.
    pub(super) normals: DMatrix<f64>,
    /// The multipliers that combine the normals to the figure's slope.
    multipliers: DVector<f64>,
    /// The rest of the slope, which the normals do not balance.
    pub(super) free: DVector<f64>,
}

impl ActiveConstraints {
    /// Finds the constraints and bounds without slack at a design.
    pub(super) fn at(
        judge: &DesignEvaluator,
        here: &EvaluatedDesign,
        slopes: &DesignSlopes,
    ) -> ActiveConstraints {
        let mut all = Vec::new();
        for (i, goal) in judge.constraints.iter().enumerate() {
            let is_equal = goal.sense == GoalSense::Equal;
            if is_equal || here.slacks[i] <= ACTIVE_SLACK {
                all.push(PossibleConstraint {
                    row: Some(i),
                    normal: slopes.slacks.row(i).transpose(),
                    is_one_sided: !is_equal,
                });
            }
        }
        for (i, (number, [low, high])) in here.numbers.iter().zip(&judge.ends).enumerate() {
            let inwards = if number <= low {
                1.0
            } else if number >= high {
                -1.0
            } else {
                continue;
            };
            let mut normal = DVector::zeros(here.numbers.len());
            normal[i] = inwards;
            all.push(PossibleConstraint {
                row: None,
                normal,
                // Equal bounds act in both directions.
                is_one_sided: low < high,
            });
        }
        ActiveConstraints {
            all,
            count: here.numbers.len(),
        }
    }

    /// Returns the normals, one per row.
    pub(super) fn normals(&self) -> DMatrix<f64> {
        DMatrix::from_fn(self.all.len(), self.count, |row, i| self.all[row].normal[i])
    }

    /// Returns `true` if no multiplier of an inequality is negative, up to tolerance.
    pub(super) fn keep(&self, multipliers: &DVector<f64>) -> bool {
        let size = multipliers
            .iter()
            .fold(0.0_f64, |size, by| size.max(by.abs()));
        let mut all = self.all.iter().zip(multipliers.iter());
        all.all(|(one, by)| !one.is_one_sided || *by >= -FLAT * size)
    }
}

impl ActiveSet {
    /// Finds the active set: inequalities with negative multipliers are removed one after another,
    /// the most negative first.
    pub(super) fn of(
        judge: &DesignEvaluator,
        here: &EvaluatedDesign,
        slopes: &DesignSlopes,
    ) -> ActiveSet {
        let mut holds = ActiveConstraints::at(judge, here, slopes);
        loop {
            let normals = holds.normals();
            let multipliers = multipliers(&normals, &slopes.value);
            let ends_drag = |&i: &usize| holds.all[i].is_one_sided && multipliers[i] < 0.0;
            let worst = (0..holds.all.len())
                .filter(ends_drag)
                .min_by(|&a, &b| multipliers[a].total_cmp(&multipliers[b]));
            if let Some(worst) = worst {
                holds.all.remove(worst);
                continue;
            }
            let held = match normals.nrows() {
                0 => DVector::zeros(slopes.value.len()),
                _ => normals.tr_mul(&multipliers),
            };
            return ActiveSet {
                rows: holds.all.iter().filter_map(|one| one.row).collect(),
                free: &slopes.value - held,
                normals,
                multipliers,
            };
        }
    }

    pub(super) fn is_stationary(&self, here: &EvaluatedDesign, slopes: &DesignSlopes) -> bool {
        self.free.norm() <= FLAT * slopes.value.norm().max(here.value.abs())
    }

    /// Returns the gradient of the Lagrangian elsewhere, with the multipliers of this design.
    pub(super) fn lagrangian(&self, slopes: &DesignSlopes) -> DVector<f64> {
        let mut slope = slopes.value.clone();
        for (&row, by) in self.rows.iter().zip(self.multipliers.iter()) {
            slope -= slopes.slacks.row(row).transpose() * *by;
        }
        slope
    }
}

/// Returns the least-squares multipliers of normals for a slope; zeros if a normal is not finite.
pub(super) fn multipliers(normals: &DMatrix<f64>, slope: &DVector<f64>) -> DVector<f64> {
    if normals.nrows() == 0 || !is_finite(normals) {
        return DVector::zeros(normals.nrows());
    }
    let parts = normals.transpose().svd(true, true);
    let minimum = SINGULAR * parts.singular_values.max();
    let found = parts.solve(slope, minimum);
    found.unwrap_or_else(|_| DVector::zeros(normals.nrows()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normals with entries that are not finite constrain nothing, but still have a multiplier.
    #[test]
    fn multipliers_treat_non_finite_normals_as_zero() {
        let slope = DVector::from_vec(vec![2.0, 0.0]);
        for (entry, expected) in [(1.0, 2.0), (f64::NAN, 0.0), (f64::INFINITY, 0.0)] {
            let normals = DMatrix::from_row_slice(1, 2, &[entry, 0.0]);
            let found = multipliers(&normals, &slope);
            assert_eq!(found.len(), 1);
            assert!((found[0] - expected).abs() < 1e-12, "{entry}: {found}");
        }
        assert_eq!(multipliers(&DMatrix::zeros(0, 2), &slope).len(), 0);
    }
}
