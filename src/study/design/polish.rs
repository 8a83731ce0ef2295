//! From a good design to the best one around it, and whether it is that: steps along the constraints, by a Hessian
//! matrix that is gathered on the way (sequential quadratic programming with Broyden, Fletcher, Goldfarb and Shanno's
//! update), each brought back onto the constraints, until the first-order condition of Karush, Kuhn and Tucker holds.

use super::hold::DesignHold;
use super::judge::{DIFFERENCE, DesignSlopes, Judge, JudgedDesign, is_finite};
use super::kink::KinkLook;
use nalgebra::{DMatrix, DVector};

/// Steps at the most, those at kinks, and how often one is halved that betters nothing.
const STEPS: usize = 100;
const KINKS: usize = 30;
const HALVINGS: i32 = 30;
/// How far beside a kink slopes are taken, in parts of the way between the ends.
const BESIDE: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// The longest step, in parts of the way between the ends.
const LONGEST: f64 = 0.25;
/// How much of its curvature an update keeps at least, so that the matrix stays positive (Powell, 1978).
const KEPT: f64 = 0.2;

/// A design at the end of the steps.
#[derive(Clone, Debug)]
pub(super) struct Polished {
    pub(super) design: JudgedDesign,
    /// Whether no small step along the constraints betters it, to first order.
    pub(super) is_stationary: bool,
}

/// Goes on from a design to where no small step along the constraints betters it, if it comes there before `watch`
/// answers false.
pub(super) fn polished(
    judge: &mut Judge,
    design: JudgedDesign,
    watch: &mut dyn FnMut() -> bool,
) -> Polished {
    let mut here = judge.onto(design, Some(&[]));
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
        let hold = DesignHold::of(judge, &here, &slopes);
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
    if !is_stationary && here.worth.0 == 0.0 {
        return at_kink(judge, here, watch);
    }
    Polished {
        design: here,
        is_stationary,
    }
}

/// The same from a design at which slopes are not one: by those from all sides, nearer and nearer to it.
fn at_kink(judge: &mut Judge, mut here: JudgedDesign, watch: &mut dyn FnMut() -> bool) -> Polished {
    let mut is_stationary = false;
    for beside in BESIDE {
        for _ in 0..KINKS {
            let look = KinkLook::at(judge, &here, beside);
            is_stationary = matches!(look, KinkLook::Lowest);
            if !watch() {
                break;
            }
            let KinkLook::Down(way) = look else {
                break;
            };
            let length = LONGEST / way.amax().max(f64::MIN_POSITIVE);
            match bettered(judge, &here, &(way * length), &[]) {
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

/// A step that betters the design, and the slopes there.
fn step(
    judge: &mut Judge,
    here: &JudgedDesign,
    slopes: &DesignSlopes,
    hold: &DesignHold,
    curvature: &DMatrix<f64>,
) -> Option<(JudgedDesign, DesignSlopes)> {
    let way = way(hold, &slopes.value, curvature)?;
    let length = (LONGEST / way.amax().max(f64::MIN_POSITIVE)).min(1.0);
    let there = bettered(judge, here, &(way * length), &hold.rows)?;
    let slopes = judge.slopes(&there, DIFFERENCE, true)?;
    Some((there, slopes))
}

/// A better design on a way, halved as often as that takes, and brought back onto what is held.
fn bettered(
    judge: &mut Judge,
    here: &JudgedDesign,
    way: &DVector<f64>,
    held: &[usize],
) -> Option<JudgedDesign> {
    let mut length = 1.0;
    for _ in 0..HALVINGS {
        if let Some(there) = judge.judge(judge.moved(&here.numbers, &(way * length))) {
            let there = judge.onto(there, Some(held));
            if there.worth < here.worth {
                return Some(there);
            }
        }
        length *= 0.5;
    }
    None
}

/// The step to the lowest place of the quadratic along what holds the design.
fn way(hold: &DesignHold, slope: &DVector<f64>, curvature: &DMatrix<f64>) -> Option<DVector<f64>> {
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
    hold: &DesignHold,
    (before, slopes_before): (&JudgedDesign, &DesignSlopes),
    (after, slopes_after): (&JudgedDesign, &DesignSlopes),
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
