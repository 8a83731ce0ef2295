//! What holds a design where its figure falls: constraints with nothing left, and ends, each by its multiplier.

use super::GoalSense;
use super::judge::{DesignSlopes, Judge, JudgedDesign, is_finite};
use nalgebra::{DMatrix, DVector};

/// A constraint with so little left, in parts of its size, holds the design.
const HELD: f64 = 1e-7;
/// What differences to both sides leave of a slope that is nought, in parts of it or of the figure.
const FLAT: f64 = 1e-6;
/// A singular value that is so small a part of the greatest is none.
const SINGULAR: f64 = 1e-9;

/// What may hold a design: constraints with nothing left, and ends.
#[derive(Clone, Debug)]
pub(super) struct Holds {
    all: Vec<MayHold>,
    /// How many numbers a design has.
    count: usize,
}

#[derive(Clone, Debug)]
struct MayHold {
    /// Which constraint it is, if it is one.
    row: Option<usize>,
    /// The slope of what is left of it.
    normal: DVector<f64>,
    /// Whether it holds to one side alone.
    is_one_sided: bool,
}

/// What holds a design where its figure falls.
#[derive(Clone, Debug)]
pub(super) struct DesignHold {
    /// Constraints.
    pub(super) rows: Vec<usize>,
    /// The slopes of what holds it, a row each: these constraints, then the ends.
    pub(super) normals: DMatrix<f64>,
    /// By how much of each the slope of the figure is held.
    multipliers: DVector<f64>,
    /// What is left of that slope.
    pub(super) free: DVector<f64>,
}

impl Holds {
    /// At a design.
    pub(super) fn at(judge: &Judge, here: &JudgedDesign, slopes: &DesignSlopes) -> Holds {
        let mut all = Vec::new();
        for (i, goal) in judge.constraints.iter().enumerate() {
            let is_equal = goal.sense == GoalSense::Equal;
            if is_equal || here.slacks[i] <= HELD {
                all.push(MayHold {
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
            all.push(MayHold {
                row: None,
                normal,
                // Ends that are one hold to both sides.
                is_one_sided: low < high,
            });
        }
        Holds {
            all,
            count: here.numbers.len(),
        }
    }

    /// Their slopes, a row each.
    pub(super) fn normals(&self) -> DMatrix<f64> {
        DMatrix::from_fn(self.all.len(), self.count, |row, i| self.all[row].normal[i])
    }

    /// Whether multipliers hold a design, and none would let it go.
    pub(super) fn keep(&self, multipliers: &DVector<f64>) -> bool {
        let size = multipliers
            .iter()
            .fold(0.0_f64, |size, by| size.max(by.abs()));
        let mut all = self.all.iter().zip(multipliers.iter());
        all.all(|(one, by)| !one.is_one_sided || *by >= -FLAT * size)
    }
}

impl DesignHold {
    /// What holds a design where its figure falls: what would let it go is left out, one after the other.
    pub(super) fn of(judge: &Judge, here: &JudgedDesign, slopes: &DesignSlopes) -> DesignHold {
        let mut holds = Holds::at(judge, here, slopes);
        loop {
            let normals = holds.normals();
            let multipliers = multipliers(&normals, &slopes.value);
            let lets_go = |&i: &usize| holds.all[i].is_one_sided && multipliers[i] < 0.0;
            let worst = (0..holds.all.len())
                .filter(lets_go)
                .min_by(|&a, &b| multipliers[a].total_cmp(&multipliers[b]));
            if let Some(worst) = worst {
                holds.all.remove(worst);
                continue;
            }
            let held = match normals.nrows() {
                0 => DVector::zeros(slopes.value.len()),
                _ => normals.tr_mul(&multipliers),
            };
            return DesignHold {
                rows: holds.all.iter().filter_map(|one| one.row).collect(),
                free: &slopes.value - held,
                normals,
                multipliers,
            };
        }
    }

    pub(super) fn is_stationary(&self, here: &JudgedDesign, slopes: &DesignSlopes) -> bool {
        self.free.norm() <= FLAT * slopes.value.norm().max(here.value.abs())
    }

    /// The slope of the figure less what holds it, by the multipliers of another place.
    pub(super) fn lagrangian(&self, slopes: &DesignSlopes) -> DVector<f64> {
        let mut slope = slopes.value.clone();
        for (&row, by) in self.rows.iter().zip(self.multipliers.iter()) {
            slope -= slopes.slacks.row(row).transpose() * *by;
        }
        slope
    }
}

/// The multipliers with which normals hold a slope best, one for each; nought where normals are no numbers.
pub(super) fn multipliers(normals: &DMatrix<f64>, slope: &DVector<f64>) -> DVector<f64> {
    if normals.nrows() == 0 || !is_finite(normals) {
        return DVector::zeros(normals.nrows());
    }
    let parts = normals.transpose().svd(true, true);
    let least = SINGULAR * parts.singular_values.max();
    let found = parts.solve(slope, least);
    found.unwrap_or_else(|_| DVector::zeros(normals.nrows()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slopes that are no numbers hold nothing, and every normal still has its multiplier.
    #[test]
    fn each_normal_has_a_multiplier() {
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
