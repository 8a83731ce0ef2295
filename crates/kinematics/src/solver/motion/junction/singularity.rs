//! Decides whether a dyad is singular, nearly singular or regular at a coordinate.

use super::Refusal;
use crate::arithmetic::Series;
use crate::solver::elements::{Dyad, Height, SingularShift, Step, ZERO};
use crate::solver::exact::Exact;
use crate::solver::motion::limits::NEAR;
use crate::solver::motion::tracking::Walker;
use crate::solver::state::State;
use crate::{Double, Number, Vec2};

/// Threshold relative to the size of a square: smaller leading coefficients may be rounded zeros.
const DOUBLE_THRESHOLD: f64 = 1e-9;
/// Threshold like [`DOUBLE_THRESHOLD`] if only double-double arithmetic has rounded.
const DOUBLE_DOUBLE_THRESHOLD: f64 = 1e-18;
/// Maximum remainder of a square per rounding of the lengths. Short links rotate the pivots and
/// enlarge it.
const MAX_SQUARE_REMAINDER: f64 = 1e4;
/// Maximum distance of change points of several groups that count as one, in radians or scaled
/// lengths. In a mechanism whose lengths come from one formula, they are a few roundings apart.
pub(in crate::solver::motion) const CHANGE_POINT_TOLERANCE: f64 = 1e-12;
/// Maximum squared sine, in roundings of the lengths, of a dyad that is as good as singular. Rounding
/// may split its change point from that of a later dyad by this much.
const SPLIT: f64 = 64.0;
/// Maximum shift of pivots, in roundings of their coordinates, for change points that count as one.
/// A line that begins with a short link is rotated by them.
const LEVER: f64 = 64.0;
/// Maximum number of Newton steps to a snap or a coordinate. Each doubles the digits.
const STEPS: usize = 8;
/// Square of the ratio of two shifts' effects below which the smaller one is a rounding error.
const NO_EFFECT: f64 = 1e-18;
/// Accuracy of a coordinate, in radians or scaled lengths.
const PLACED: f64 = 1e-26;
/// Number of terms sufficient to find an extreme of a dyad's reach.
const FEW_TERMS: usize = 12;

/// The singularity of a dyad at a coordinate.
pub(in crate::solver::motion) enum DyadSingularity {
    Regular,
    Missing { sine: f64 },
    Singular { snap: SingularShift, order: usize },
}

impl Walker<'_> {
    /// Decides whether a dyad is singular at a coordinate, and by which shift it becomes exactly
    /// singular.
    pub(super) fn singularity(
        &self,
        dyad: Dyad<'_>,
        q: Series,
        slack: f64,
        state: &State<Series>,
    ) -> Result<DyadSingularity, Refusal> {
        let extremes =
            [DOUBLE_DOUBLE_THRESHOLD, DOUBLE_THRESHOLD].map(|part| extreme(dyad, part, state));
        let distance = extremes.into_iter().flatten().map(|by| by.abs().hi);
        let distance = distance.reduce(f64::min);
        // At the extreme itself, only the given numbers can be rounded.
        let is_extreme = distance.is_some_and(|distance| distance <= PLACED);
        let part = if is_extreme {
            (slack * MAX_SQUARE_REMAINDER).clamp(DOUBLE_DOUBLE_THRESHOLD, DOUBLE_THRESHOLD)
        } else {
            DOUBLE_THRESHOLD
        };
        let how = (is_extreme, distance);
        match self.singularity_within(part, how, (dyad, q, slack), state) {
            Ok(DyadSingularity::Regular)
                if distance.is_some_and(|by| by <= CHANGE_POINT_TOLERANCE) =>
            {
                let sine = sine(
                    dyad,
                    q,
                    dyad.square(q, SingularShift::default(), state).nearest(),
                    state,
                );
                match sine * sine < NEAR {
                    true => Ok(DyadSingularity::Missing { sine }),
                    false => Ok(DyadSingularity::Regular),
                }
            }
            // Two change points may be close to each other, with a reversal of the group's input
            // between them. They are treated one by one.
            Err(Refusal::End) if is_extreme && part > DOUBLE_DOUBLE_THRESHOLD => {
                match self.singularity_within(DOUBLE_DOUBLE_THRESHOLD, how, (dyad, q, slack), state)
                {
                    Ok(singular @ DyadSingularity::Singular { .. }) => Ok(singular),
                    Ok(DyadSingularity::Regular | DyadSingularity::Missing { .. }) | Err(_) => {
                        Err(Refusal::End)
                    }
                }
            }
            singularity => singularity,
        }
    }

    /// Decides as [`Walker::singularity`] does. Coefficients of a square below `part` of its size
    /// count as zero.
    fn singularity_within(
        &self,
        part: f64,
        (is_extreme, distance): (bool, Option<f64>),
        (dyad, q, slack): (Dyad<'_>, Series, f64),
        state: &State<Series>,
    ) -> Result<DyadSingularity, Refusal> {
        let height = dyad.height(q, SingularShift::default(), state);
        let meeting = dyad.meeting(q, slack, state);
        let close = if is_extreme {
            DOUBLE_DOUBLE_THRESHOLD
        } else {
            CHANGE_POINT_TOLERANCE
        };
        let near = |u: &Vec2<Double>| u.norm().hi <= slack + close;
        let (snap, order, zero) = if let Some(u) = meeting.filter(near) {
            (SingularShift::of_meeting(-u), None, ZERO)
        } else {
            match height.square.valuation(&height.size, part) {
                None => return Err(Refusal::Terms),
                Some(0)
                    if is_extreme
                        && height.square.valuation(&height.size, DOUBLE_THRESHOLD) != Some(0) =>
                {
                    return missing(dyad, q, &height, state);
                }
                Some(0) => return regular_or_end(&height),
                Some(order) => {
                    let snapped = snapped(dyad, q, (order, slack), state);
                    let (snap, zero) = snapped.ok_or(Refusal::End)?;
                    (snap, Some(order), zero)
                }
            }
        };
        let distance = distance.ok_or(Refusal::Terms)?;
        let is_here = distance <= CHANGE_POINT_TOLERANCE || snap.by.norm().hi <= LEVER * slack;
        if !is_here {
            return regular_or_end(&height);
        }
        if across(dyad, snap, state) > slack {
            return missing(dyad, q, &height, state);
        }
        let height = dyad.height(q, snap, state);
        let exact = height.square.valuation(&height.size, zero);
        let exact = exact.ok_or(Refusal::Terms)?;
        let is_meant = order.is_none_or(|order| order == exact);
        let passes = exact % 2 == 0 && height.square.c[exact].hi > 0.0;
        let order = exact;
        if is_meant && passes {
            Ok(DyadSingularity::Singular { snap, order })
        } else {
            Err(Refusal::End)
        }
    }

    /// Decides in double-double whether a dyad is singular at a coordinate. Returns `None` if this
    /// cannot be determined.
    pub(in crate::solver::motion) fn singularity_at(
        &mut self,
        step: usize,
        at: Double,
    ) -> Option<DyadSingularity> {
        let engine = &self.exact?.engine;
        let (q, direction) = self.coordinate_of(at, FEW_TERMS);
        let mut series = engine.state::<Series>(self.state.travels.len());
        self.place_in_series(0..step, at.hi, q, direction, &mut series)?;
        let dyad = engine.program.steps[step].dyad()?;
        self.singularity(dyad, q, self.slack(), &series).ok()
    }

    /// Returns `true` if only rounding separates a dyad's change point from that of an earlier dyad.
    /// All groups pass both at once, where the earlier dyad does.
    pub(in crate::solver::motion) fn is_split_off(&mut self, step: usize, at: Double) -> bool {
        let Some(Exact { engine, .. }) = self.exact else {
            return false;
        };
        let (q, direction) = self.coordinate_of(at, FEW_TERMS);
        let mut series = engine.state::<Series>(self.state.travels.len());
        if self
            .place_in_series(0..step, at.hi, q, direction, &mut series)
            .is_none()
        {
            return false;
        }
        let maximum = SPLIT * self.slack();
        let mut earlier = engine.program.steps[..step].iter().filter_map(Step::dyad);
        earlier.any(|dyad| {
            let square = dyad.square(q, SingularShift::default(), &series).nearest();
            square <= maximum * dyad.right_angle(q, &series)
        })
    }

    /// Returns the coordinate close to `at` where a dyad's reach is extreme, in double-double.
    /// Returns `None` if Newton's method does not converge, or if a step before the dyad is
    /// singular or open there.
    pub(in crate::solver::motion) fn exactly(&mut self, step: usize, at: f64) -> Option<Double> {
        self.exactly_by(step, at, f64::INFINITY)
    }

    /// Returns the coordinate of an extreme as [`Walker::exactly`] does, or `None` if a Newton step
    /// is longer than `maximum`, in radians or scaled lengths.
    pub(in crate::solver::motion) fn exactly_by(
        &mut self,
        step: usize,
        at: f64,
        maximum: f64,
    ) -> Option<Double> {
        // At an extreme of higher order, the leading coefficients are rounding errors.
        let mut parts = [DOUBLE_DOUBLE_THRESHOLD, DOUBLE_THRESHOLD];
        let mut is_different = false;
        let found = self.approach_extreme(step, (at, maximum), parts, &mut is_different);
        if found.is_some() || !is_different {
            return found;
        }
        parts.reverse();
        self.approach_extreme(step, (at, maximum), parts, &mut is_different)
    }

    /// Returns the coordinate of an extreme, where coefficients below `part` of their size count as
    /// zero. Sets `is_different` if the part `other` leads to another Newton step.
    fn approach_extreme(
        &mut self,
        step: usize,
        (at, maximum): (f64, f64),
        [part, other]: [f64; 2],
        is_different: &mut bool,
    ) -> Option<Double> {
        let engine = &self.exact?.engine;
        let mut at = Double::exactly(at);
        for _ in 0..STEPS {
            let (q, direction) = self.coordinate_of(at, FEW_TERMS);
            let mut series = engine.state::<Series>(self.state.travels.len());
            self.place_in_series(0..step, at.hi, q, direction, &mut series)?;
            let dyad = engine.program.steps[step].dyad()?;
            let [by, otherwise] = [part, other].map(|part| extreme(dyad, part, &series));
            *is_different |= by != otherwise;
            let by = by?;
            at = self.moved_exactly(at, by);
            if by.abs().hi < PLACED {
                return Some(at);
            }
            if by.abs().hi > maximum {
                return None;
            }
        }
        None
    }
}

/// Returns the distance to the extreme of a dyad's reach, by one Newton step for the last
/// coefficient that vanishes there.
fn extreme(dyad: Dyad<'_>, part: f64, state: &State<Series>) -> Option<Double> {
    let [reach, size] = dyad.reach(state);
    let moving = |n: &usize| reach.c[*n].hi.abs() > part * size.c[*n].hi;
    let order = (2..reach.known).find(moving)?;
    Some(-(reach.c[order - 1] / (reach.c[order] * Double::exactly(order as f64))))
}

/// Returns [`DyadSingularity::Missing`] for a dyad at an extreme of its reach whose arms miss each other,
/// or the end of the motion if it is open.
fn missing(
    dyad: Dyad<'_>,
    q: Series,
    height: &Height,
    state: &State<Series>,
) -> Result<DyadSingularity, Refusal> {
    let square = height.square.nearest();
    if square > 0.0 {
        let sine = sine(dyad, q, square, state);
        Ok(DyadSingularity::Missing { sine })
    } else {
        Err(Refusal::End)
    }
}

/// Returns the sine of a dyad's transmission angle, from the square of its height.
fn sine(dyad: Dyad<'_>, q: Series, square: f64, state: &State<Series>) -> f64 {
    (square / dyad.right_angle(q, state)).sqrt()
}

/// Returns [`DyadSingularity::Regular`] for a dyad not singular here, or the end of the motion if it is
/// open.
fn regular_or_end(height: &Height) -> Result<DyadSingularity, Refusal> {
    if height.square.c[0].hi > 0.0 {
        Ok(DyadSingularity::Regular)
    } else {
        Err(Refusal::End)
    }
}

/// Returns the component of a snap along the line of the pivots, or across the guide. This
/// component separates the arms; the other one only shifts the coordinate of the extreme.
fn across(dyad: Dyad<'_>, snap: SingularShift, state: &State<Series>) -> f64 {
    if snap.equal_arms {
        return 0.0;
    }
    let Some(u) = dyad.pivots(state) else {
        return snap.by.x.hi.abs();
    };
    let u = u.nearest();
    (snap.by.nearest().dot(u) / u.norm()).abs()
}

/// Returns the snap with which the square of a dyad's height begins with `order` zeros, and the part
/// of its size below which its coefficients are zeros. It is a least-squares solution because two
/// shifts serve for more conditions. Where the pivots are at rest relative to each other, a shift does
/// not move the extreme: the rounding of the lengths, at most `slack`, then remains.
fn snapped(
    dyad: Dyad<'_>,
    q: Series,
    (order, slack): (usize, f64),
    state: &State<Series>,
) -> Option<(SingularShift, f64)> {
    let mut snap = SingularShift::default();
    for step in 0..=STEPS {
        let Height {
            square,
            size,
            slopes: [a, b],
        } = dyad.height(q, snap, state);
        let vanishes = |part: f64| {
            let exact = square.valuation(&size, part);
            exact.is_none_or(|exact| exact >= order)
        };
        if vanishes(ZERO) {
            return Some((snap, ZERO));
        }
        if step == STEPS {
            return vanishes(slack).then_some((snap, slack));
        }
        let sum =
            |x: &Series, y: &Series| (0..order).fold(Double::ZERO, |sum, n| sum + x.c[n] * y.c[n]);
        let (aa, ab, bb) = (sum(&a, &a), sum(&a, &b), sum(&b, &b));
        // If only one of the shifts has an effect, the other one stays small.
        let minimum = (aa + bb) * Double::exactly(NO_EFFECT);
        let (aa, bb) = (aa + minimum, bb + minimum);
        let (ac, bc) = (sum(&a, &square), sum(&b, &square));
        let det = aa * bb - ab * ab;
        let by = Vec2::new((ab * bc - bb * ac) / det, (ab * ac - aa * bc) / det);
        if !by.x.hi.is_finite() || !by.y.hi.is_finite() {
            return None;
        }
        snap.by += by;
    }
    None
}
