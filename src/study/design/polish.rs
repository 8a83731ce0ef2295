//! From a good design to the best one around it, and whether it is that: steps along the constraints, by a Hessian
//! matrix that is gathered on the way (sequential quadratic programming with Broyden, Fletcher, Goldfarb and Shanno's
//! update), each brought back onto the constraints, until the first-order condition of Karush, Kuhn and Tucker holds.

use super::GoalSense;
use super::judge::{Judge, Judged, Slopes, is_finite};
use nalgebra::{DMatrix, DVector};

/// Steps at the most, and how often one is halved that betters nothing.
const STEPS: usize = 100;
const HALVINGS: i32 = 30;
/// The longest step, in parts of the way between the ends.
const LONGEST: f64 = 0.25;
/// A constraint with so little left, in parts of its size, holds the design.
const HELD: f64 = 1e-7;
/// What differences to both sides leave of a slope that is nought, in parts of it or of the figure.
const FLAT: f64 = 1e-6;
/// A singular value that is so small a part of the greatest is none.
const SINGULAR: f64 = 1e-9;
/// How much of its curvature an update keeps at least, so that the matrix stays positive (Powell, 1978).
const KEPT: f64 = 0.2;

/// A design at the end of the steps.
#[derive(Clone, Debug)]
pub(super) struct Polished {
    pub(super) design: Judged,
    /// Whether no small step along the constraints betters it, to first order.
    pub(super) is_stationary: bool,
}

/// What holds a design: constraints by their numbers, and numbers at an end.
#[derive(Clone, Debug)]
struct Hold {
    /// Constraints.
    rows: Vec<usize>,
    /// The slopes of what holds it, a row each: these constraints, then the ends.
    normals: DMatrix<f64>,
    /// By how much of each the slope of the figure is held.
    multipliers: DVector<f64>,
    /// What is left of that slope.
    free: DVector<f64>,
}

/// Goes on from a design to where no small step along the constraints betters it, if it comes there.
pub(super) fn polished(judge: &mut Judge, design: Judged) -> Polished {
    let mut here = judge.onto(design, Some(&[]));
    let mut curvature = DMatrix::identity(here.numbers.len(), here.numbers.len());
    let mut is_fresh = true;
    let Some(mut slopes) = judge.slopes(&here, true) else {
        return Polished {
            design: here,
            is_stationary: false,
        };
    };
    let mut is_stationary = false;
    for _ in 0..STEPS {
        let hold = Hold::of(judge, &here, &slopes);
        is_stationary = here.worth.0 == 0.0 && hold.is_stationary(&here, &slopes);
        if is_stationary {
            break;
        }
        if is_fresh {
            curvature.fill_with_identity();
            curvature *= hold.free.norm().max(f64::MIN_POSITIVE);
        }
        let Some((better, after)) = step(judge, &here, &slopes, &hold, &curvature) else {
            // Once more by the plain slope.
            if is_fresh {
                break;
            }
            is_fresh = true;
            continue;
        };
        update(
            judge,
            &mut curvature,
            &hold,
            (&here, &slopes),
            (&better, &after),
        );
        is_fresh = false;
        (here, slopes) = (better, after);
    }
    Polished {
        design: here,
        is_stationary,
    }
}

impl Hold {
    /// What holds a design where its figure falls: what would let it go is left out, one after the other.
    fn of(judge: &Judge, here: &Judged, slopes: &Slopes) -> Hold {
        let count = here.numbers.len();
        // Each with the slope of what is left of it, and whether it holds to one side alone.
        let mut all: Vec<(Option<usize>, DVector<f64>, bool)> = Vec::new();
        for (i, goal) in judge.constraints.iter().enumerate() {
            let is_equal = goal.sense == GoalSense::Equal;
            if is_equal || here.slacks[i] <= HELD {
                all.push((Some(i), slopes.slacks.row(i).transpose(), !is_equal));
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
            let mut normal = DVector::zeros(count);
            normal[i] = inwards;
            // Ends that are one hold to both sides.
            all.push((None, normal, low < high));
        }
        loop {
            let normals = DMatrix::from_fn(all.len(), count, |row, i| all[row].1[i]);
            let multipliers = multipliers(&normals, &slopes.value);
            let lets_go = |&i: &usize| all[i].2 && multipliers[i] < 0.0;
            let worst = (0..all.len())
                .filter(lets_go)
                .min_by(|&a, &b| multipliers[a].total_cmp(&multipliers[b]));
            if let Some(worst) = worst {
                all.remove(worst);
                continue;
            }
            return Hold {
                rows: all.iter().filter_map(|(row, ..)| *row).collect(),
                free: &slopes.value - normals.tr_mul(&multipliers),
                normals,
                multipliers,
            };
        }
    }

    fn is_stationary(&self, here: &Judged, slopes: &Slopes) -> bool {
        self.free.norm() <= FLAT * slopes.value.norm().max(here.value.abs())
    }

    /// The slope of the figure less what holds it, by the multipliers of another place.
    fn lagrangian(&self, slopes: &Slopes) -> DVector<f64> {
        let mut slope = slopes.value.clone();
        for (&row, by) in self.rows.iter().zip(self.multipliers.iter()) {
            slope -= slopes.slacks.row(row).transpose() * *by;
        }
        slope
    }
}

/// The multipliers with which normals hold a slope best.
fn multipliers(normals: &DMatrix<f64>, slope: &DVector<f64>) -> DVector<f64> {
    if normals.nrows() == 0 || !is_finite(normals) {
        return DVector::zeros(0);
    }
    let parts = normals.transpose().svd(true, true);
    let least = SINGULAR * parts.singular_values.max();
    let found = parts.solve(slope, least);
    found.unwrap_or_else(|_| DVector::zeros(normals.nrows()))
}

/// A step that betters the design, and the slopes there.
fn step(
    judge: &mut Judge,
    here: &Judged,
    slopes: &Slopes,
    hold: &Hold,
    curvature: &DMatrix<f64>,
) -> Option<(Judged, Slopes)> {
    let way = way(hold, &slopes.value, curvature)?;
    let mut length = (LONGEST / way.amax().max(f64::MIN_POSITIVE)).min(1.0);
    for _ in 0..HALVINGS {
        if let Some(there) = judge.judge(judge.moved(&here.numbers, &(&way * length))) {
            let there = judge.onto(there, Some(&hold.rows));
            if there.worth < here.worth {
                let slopes = judge.slopes(&there, true)?;
                return Some((there, slopes));
            }
        }
        length *= 0.5;
    }
    None
}

/// The step to the lowest place of the quadratic along what holds the design.
fn way(hold: &Hold, slope: &DVector<f64>, curvature: &DMatrix<f64>) -> Option<DVector<f64>> {
    let (count, held) = (slope.len(), hold.normals.nrows());
    let mut matrix = DMatrix::zeros(count + held, count + held);
    matrix.view_mut((0, 0), (count, count)).copy_from(curvature);
    matrix
        .view_mut((count, 0), (held, count))
        .copy_from(&hold.normals);
    matrix
        .view_mut((0, count), (count, held))
        .copy_from(&hold.normals.transpose());
    let mut right = DVector::zeros(count + held);
    right.rows_mut(0, count).copy_from(&-slope);
    if !is_finite(&matrix) {
        return None;
    }
    let parts = matrix.svd(true, true);
    let least = f64::EPSILON * parts.singular_values.max();
    let found = parts.solve(&right, least).ok()?;
    let way = found.rows(0, count).into_owned();
    way.iter().all(|v| v.is_finite()).then_some(way)
}

/// Takes the curvature of a step into the matrix.
fn update(
    judge: &Judge,
    curvature: &mut DMatrix<f64>,
    hold: &Hold,
    (before, slopes_before): (&Judged, &Slopes),
    (after, slopes_after): (&Judged, &Slopes),
) {
    let sizes = judge.ends.iter().map(|[low, high]| high - low);
    let gone = before.numbers.iter().zip(&after.numbers).zip(sizes);
    let gone = gone.map(|((a, b), size)| if size > 0.0 { (b - a) / size } else { 0.0 });
    let gone = DVector::from_iterator(before.numbers.len(), gone);
    let bent = hold.lagrangian(slopes_after) - hold.lagrangian(slopes_before);
    let image = &*curvature * &gone;
    let own = gone.dot(&image);
    if !(own > 0.0) {
        return;
    }
    let seen = gone.dot(&bent);
    let part = match seen < KEPT * own {
        true => (1.0 - KEPT) * own / (own - seen),
        false => 1.0,
    };
    let bent = bent * part + &image * (1.0 - part);
    let seen = gone.dot(&bent);
    *curvature += &bent * bent.transpose() / seen - &image * image.transpose() / own;
}
