//! Improves a good design to a local optimum, and checks optimality. The steps follow the
//! constraints, with a Hessian matrix updated on the way (sequential quadratic programming with the
//! BFGS update). Each step is projected back onto the constraints, until the first-order conditions
//! of Karush, Kuhn and Tucker hold.

use super::active_constraints::ActiveSet;
use super::kink::KinkSampling;
use super::pieces::polished_by_pieces;
use super::projection::{
    DIFFERENCE, DesignEvaluator, DesignProjection, DesignSlopes, EvaluatedDesign, is_finite,
};
use nalgebra::{DMatrix, DVector};

/// Maximum number of steps, of steps at kinks, and of halvings of a step that does not improve.
const STEPS: usize = 100;
const KINKS: usize = 30;
const HALVINGS: i32 = 30;
/// Distances from a kink at which slopes are sampled, relative to the ranges.
const KINK_DISTANCES: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// Maximum length of a step, relative to the ranges.
pub(super) const MAX_LEN: f64 = 0.25;
/// Minimum fraction of the curvature that an update keeps, so that the matrix stays positive
/// definite (Powell, 1978).
const MIN_CURVATURE_FRACTION: f64 = 0.2;

/// A design at the end of the steps.
#[derive(Clone, Debug)]
pub(super) struct Polished {
    pub(super) design: EvaluatedDesign,
    /// `true` if no small step along the constraints improves the design, to first order.
    pub(super) is_stationary: bool,
}

/// Improves a design until no small step along the constraints improves it, or until `watch`
/// returns `false`.
pub(super) fn polished(
    judge: &mut DesignEvaluator,
    design: EvaluatedDesign,
    threads: usize,
    watch: &mut dyn FnMut() -> bool,
) -> Polished {
    let mut here = judge.onto(design, &mut None, DesignProjection::onto_all(&[]));
    if here.score.0 == 0.0
        && let Some(found) = polished_by_pieces(judge, here.clone(), watch)
    {
        if found.is_stationary {
            return found;
        }
        here = found.design;
    }
    let mut curvature = DMatrix::identity(here.numbers.len(), here.numbers.len());
    let mut is_fresh = true;
    let Some(mut slopes) = judge.slopes(&here, DIFFERENCE, true) else {
        return Polished {
            design: here,
            is_stationary: false,
        };
    };
    let mut is_stationary = false;
    for _ in 0..STEPS {
        if !watch() {
            return Polished {
                design: here,
                is_stationary: false,
            };
        }
        let hold = ActiveSet::of(judge, &here, &slopes);
        is_stationary = here.score.0 == 0.0 && hold.is_stationary(&here, &slopes);
        if is_stationary {
            break;
        }
        if is_fresh {
            curvature.fill_with_identity();
            curvature *= hold.free.norm().max(f64::MIN_POSITIVE);
        }
        let Some((better, after)) = step(judge, &here, &slopes, &hold, &curvature) else {
            // Retries once with the plain gradient.
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
    if !is_stationary && here.score.0 == 0.0 {
        return at_kink(judge, here, threads, watch);
    }
    Polished {
        design: here,
        is_stationary,
    }
}

/// Improves a design at a kink by slopes sampled around it, at decreasing distances.
fn at_kink(
    judge: &mut DesignEvaluator,
    mut here: EvaluatedDesign,
    threads: usize,
    watch: &mut dyn FnMut() -> bool,
) -> Polished {
    let mut is_stationary = false;
    for nearby in KINK_DISTANCES {
        for _ in 0..KINKS {
            let look = KinkSampling::at(judge, &here, nearby, threads);
            is_stationary = matches!(look, KinkSampling::Lowest);
            if !watch() {
                break;
            }
            let KinkSampling::Down { travel, slacks } = look else {
                break;
            };
            let length = MAX_LEN / travel.amax().max(f64::MIN_POSITIVE);
            match bettered(judge, &here, &slacks, &(travel * length), &[]) {
                Some(better) => here = better,
                None => break,
            }
        }
    }
    Polished {
        design: here,
        is_stationary,
    }
}

/// Returns a step that improves the design, and the slopes after it.
fn step(
    judge: &mut DesignEvaluator,
    here: &EvaluatedDesign,
    slopes: &DesignSlopes,
    hold: &ActiveSet,
    curvature: &DMatrix<f64>,
) -> Option<(EvaluatedDesign, DesignSlopes)> {
    let travel = way(hold, &slopes.value, curvature)?;
    let length = (MAX_LEN / travel.amax().max(f64::MIN_POSITIVE)).min(1.0);
    let there = bettered(judge, here, &slopes.slacks, &(travel * length), &hold.rows)?;
    let slopes = judge.slopes(&there, DIFFERENCE, true)?;
    Some((there, slopes))
}

/// Returns a better design in a direction, halving the step as necessary and projecting back onto
/// the active constraints. `slacks` are the derivatives of their slacks.
fn bettered(
    judge: &mut DesignEvaluator,
    here: &EvaluatedDesign,
    slacks: &DMatrix<f64>,
    travel: &DVector<f64>,
    held: &[usize],
) -> Option<EvaluatedDesign> {
    let mut length = 1.0;
    for _ in 0..HALVINGS {
        if let Some(there) = judge.evaluate(judge.moved(&here.numbers, &(travel * length))) {
            let mut slacks = Some(slacks.clone());
            let there = judge.onto(there, &mut slacks, DesignProjection::onto_all(held));
            if there.score < here.score {
                return Some(there);
            }
        }
        length *= 0.5;
    }
    None
}

/// Returns the step to the minimum of the quadratic model along the active constraints.
fn way(hold: &ActiveSet, slope: &DVector<f64>, curvature: &DMatrix<f64>) -> Option<DVector<f64>> {
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
    let minimum = f64::EPSILON * parts.singular_values.max();
    let found = parts.solve(&right, minimum).ok()?;
    let travel = found.rows(0, count).into_owned();
    travel.iter().all(|v| v.is_finite()).then_some(travel)
}

/// Updates the matrix with the curvature along a step.
fn update(
    judge: &DesignEvaluator,
    curvature: &mut DMatrix<f64>,
    hold: &ActiveSet,
    (before, slopes_before): (&EvaluatedDesign, &DesignSlopes),
    (after, slopes_after): (&EvaluatedDesign, &DesignSlopes),
) {
    let gone = judge.way_between(&before.numbers, &after.numbers);
    let bent = hold.lagrangian(slopes_after) - hold.lagrangian(slopes_before);
    let image = &*curvature * &gone;
    let own = gone.dot(&image);
    if !(own > 0.0) {
        return;
    }
    let seen = gone.dot(&bent);
    let part = match seen < MIN_CURVATURE_FRACTION * own {
        true => (1.0 - MIN_CURVATURE_FRACTION) * own / (own - seen),
        false => 1.0,
    };
    let bent = bent * part + &image * (1.0 - part);
    let seen = gone.dot(&bent);
    *curvature += &bent * bent.transpose() / seen - &image * image.transpose() / own;
}
