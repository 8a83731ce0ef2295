//! How a dyad stands at a place: singular, all but singular or neither.

use super::Refusal;
use crate::arithmetic::Series;
use crate::solver::elements::{Dyad, Height, Snap, ZERO};
use crate::solver::motion::walk::Walker;
use crate::solver::state::State;
use crate::{Double, Number, Vec2};

/// A square that begins with less than this part of its size may begin with zeros that were rounded.
const ROUGH: f64 = 1e-9;
/// Where nothing was rounded but in twice the digits, it is this part.
const FINE: f64 = 1e-18;
/// What is left of a square by lengths that are rounded, by their rounding at the most: pivots are turned by
/// short links.
const WORN: f64 = 1e4;
/// Change points of several groups that are this close to each other are one, in radians or scaled
/// lengths: a mechanism drawn with lengths from one formula has them a few roundings apart,
const TOGETHER: f64 = 1e-12;
/// or the pivots are so many roundings of their coordinates away from where they would be: a line that
/// begins with a short link is turned by them.
const LEVER: f64 = 64.0;
/// Newton's steps to a snap, or to a place: each doubles the digits.
const STEPS: usize = 8;
/// A place is known to this, in radians or scaled lengths.
const PLACED: f64 = 1e-26;
/// Terms that the reach of one dyad needs to tell where it is extreme.
const FEW: usize = 12;

/// How a dyad stands at a place.
pub(in crate::solver::motion) enum Standing {
    Regular,
    Missing { sine: f64 },
    Singular { snap: Snap, order: usize },
}

impl Walker<'_> {
    /// Whether a dyad is singular at a place, and how it is to be shifted to be so exactly.
    pub(super) fn standing(
        &self,
        dyad: Dyad<'_>,
        q: Series,
        slack: f64,
        state: &State<Series>,
    ) -> Result<Standing, Refusal> {
        let extremes = [FINE, ROUGH].map(|part| extreme(dyad, part, state));
        let apart = extremes.into_iter().flatten().map(|by| by.abs().hi);
        let apart = apart.reduce(f64::min);
        // At the extreme itself only what was given can have been rounded.
        let is_extreme = apart.is_some_and(|apart| apart <= PLACED);
        let part = if is_extreme {
            (slack * WORN).clamp(FINE, ROUGH)
        } else {
            ROUGH
        };
        let how = (is_extreme, apart);
        match self.standing_by(part, how, (dyad, q, slack), state) {
            // Two change points close to each other, and what moves the group turns back between them: one by one.
            Err(Refusal::End) if is_extreme && part > FINE => {
                match self.standing_by(FINE, how, (dyad, q, slack), state) {
                    Ok(singular @ Standing::Singular { .. }) => Ok(singular),
                    Ok(Standing::Regular | Standing::Missing { .. }) | Err(_) => Err(Refusal::End),
                }
            }
            standing => standing,
        }
    }

    /// As [`Walker::standing`], where less than this part of the size of a square is zero.
    fn standing_by(
        &self,
        part: f64,
        (is_extreme, apart): (bool, Option<f64>),
        (dyad, q, slack): (Dyad<'_>, Series, f64),
        state: &State<Series>,
    ) -> Result<Standing, Refusal> {
        let height = dyad.height(q, Snap::default(), state);
        let meeting = dyad.meeting(q, slack, state);
        let close = if is_extreme { FINE } else { TOGETHER };
        let near = |u: &Vec2<Double>| u.norm().hi <= slack + close;
        let (snap, order) = if let Some(u) = meeting.filter(near) {
            (Snap::of_meeting(-u), None)
        } else {
            match height.square.valuation(&height.size, part) {
                None => return Err(Refusal::Terms),
                Some(0)
                    if is_extreme && height.square.valuation(&height.size, ROUGH) != Some(0) =>
                {
                    return missing(dyad, q, &height, state);
                }
                Some(0) => return beside(&height),
                Some(order) => {
                    let snap = snapped(dyad, q, order, state).ok_or(Refusal::End)?;
                    (snap, Some(order))
                }
            }
        };
        let apart = apart.ok_or(Refusal::Terms)?;
        let is_here = apart <= TOGETHER || snap.by.norm().hi <= LEVER * slack;
        if !is_here {
            return beside(&height);
        }
        if across(dyad, snap, state) > slack {
            return missing(dyad, q, &height, state);
        }
        let height = dyad.height(q, snap, state);
        let exact = height.square.valuation(&height.size, ZERO);
        let exact = exact.ok_or(Refusal::Terms)?;
        let is_meant = order.is_none_or(|order| order == exact);
        let passes = exact % 2 == 0 && height.square.c[exact].hi > 0.0;
        let order = exact;
        if is_meant && passes {
            Ok(Standing::Singular { snap, order })
        } else {
            Err(Refusal::End)
        }
    }

    /// How a dyad stands at a place, in twice the digits; `None` where that cannot be told.
    pub(in crate::solver::motion) fn standing_at(
        &mut self,
        step: usize,
        at: Double,
    ) -> Option<Standing> {
        let engine = &self.exact?.engine;
        let (q, direction) = self.coordinate_of(at, FEW);
        let mut series = engine.state::<Series>(self.state.travels.len());
        self.lay(0..step, at.hi, q, direction, &mut series)?;
        let dyad = engine.program.steps[step].dyad()?;
        self.standing(dyad, q, self.slack(), &series).ok()
    }

    /// Where a dyad's reach is extreme to twice the precision, close to a coordinate; those before it
    /// are not singular there.
    pub(in crate::solver::motion) fn exactly(&mut self, step: usize, at: f64) -> Option<Double> {
        let engine = &self.exact?.engine;
        // Where the extreme is of a higher order, what begins it is a rounding.
        [FINE, ROUGH].into_iter().find_map(|part| {
            let mut at = Double::exactly(at);
            for _ in 0..STEPS {
                let (q, direction) = self.coordinate_of(at, FEW);
                let mut series = engine.state::<Series>(self.state.travels.len());
                self.lay(0..step, at.hi, q, direction, &mut series)?;
                let by = extreme(engine.program.steps[step].dyad()?, part, &series)?;
                at = self.moved_exactly(at, by);
                if by.abs().hi < PLACED {
                    return Some(at);
                }
            }
            None
        })
    }
}

/// The distance at which a dyad's reach is extreme: one step of Newton for the last coefficient that is a
/// zero there.
fn extreme(dyad: Dyad<'_>, part: f64, state: &State<Series>) -> Option<Double> {
    let [reach, size] = dyad.reach(state);
    let moving = |n: &usize| reach.c[*n].hi.abs() > part * size.c[*n].hi;
    let order = (2..reach.known).find(moving)?;
    Some(-(reach.c[order - 1] / (reach.c[order] * Double::exactly(order as f64))))
}

/// A dyad whose reach is extreme here, and whose arms miss each other.
fn missing(
    dyad: Dyad<'_>,
    q: Series,
    height: &Height,
    state: &State<Series>,
) -> Result<Standing, Refusal> {
    let square = height.square.nearest();
    let sine = (square / dyad.right_angle(q, state)).sqrt();
    if square > 0.0 {
        Ok(Standing::Missing { sine })
    } else {
        Err(Refusal::End)
    }
}

/// A dyad that is not singular here.
fn beside(height: &Height) -> Result<Standing, Refusal> {
    if height.square.c[0].hi > 0.0 {
        Ok(Standing::Regular)
    } else {
        Err(Refusal::End)
    }
}

/// How much of a snap is across the reach: what parts the arms, and does not only move the place.
fn across(dyad: Dyad<'_>, snap: Snap, state: &State<Series>) -> f64 {
    if snap.equal_arms {
        return 0.0;
    }
    let Some(u) = dyad.pivots(state) else {
        return snap.by.x.hi.abs();
    };
    let u = u.nearest();
    (snap.by.nearest().dot(u) / u.norm()).abs()
}

/// The snap with which the square of a dyad's height begins with so many zeros: least squares, since two
/// shifts serve for more.
fn snapped(dyad: Dyad<'_>, q: Series, order: usize, state: &State<Series>) -> Option<Snap> {
    let mut snap = Snap::default();
    for _ in 0..STEPS {
        let Height {
            square,
            size,
            slopes: [a, b],
        } = dyad.height(q, snap, state);
        if square
            .valuation(&size, ZERO)
            .is_none_or(|exact| exact >= order)
        {
            return Some(snap);
        }
        let sum =
            |x: &Series, y: &Series| (0..order).fold(Double::ZERO, |sum, n| sum + x.c[n] * y.c[n]);
        let (aa, ab, bb) = (sum(&a, &a), sum(&a, &b), sum(&b, &b));
        // Where only one of the shifts changes anything, the other one stays small.
        let least = (aa + bb) * Double::exactly(1e-28);
        let (aa, bb) = (aa + least, bb + least);
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
