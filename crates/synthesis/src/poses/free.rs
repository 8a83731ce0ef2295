//! What dyads there are, where none is given.

use super::dyad::PinHeld;
use super::guidance::Guidance;
use super::{family, five, four, three};
use crate::{OpenReason, Partner, PoseTask, PosedDyad};
use kinematics::Vec2;
use std::ops::RangeInclusive;

/// Linkages that are proposed of a grid, and of a curve.
const MOST_OF_GRID: usize = 100;
const MOST_OF_CURVE: usize = 200;
/// Dyads of a curve that linkages are made of.
const DYADS_OF_CURVE: usize = 96;
/// Where there are any number, no linkage is made of pins and pivots further away than this many sizes, and of links
/// shorter or longer than these.
const REACH: f64 = 6.0;
const LENGTHS: RangeInclusive<f64> = 0.03..=12.0;
/// How many times as far the wide reach goes, and how many times the lengths are out of proportion.
const WIDE: f64 = 4.0;

/// How far away what is proposed may be, where there is any number of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PoseReach {
    /// By how far the poses are apart.
    Usual,
    /// Some times as far, by where the pivots and pins of poses that nearly repeat lie.
    Wide,
}

impl PoseReach {
    /// As a multiple of the usual one.
    pub(super) fn times(self, guidance: &Guidance) -> f64 {
        match self {
            PoseReach::Usual => 1.0,
            PoseReach::Wide => WIDE * (guidance.unit / guidance.size).max(1.0),
        }
    }
}

/// What there is.
pub(super) struct Free {
    /// Those of five poses, each by itself.
    pub single: Vec<PinHeld>,
    /// Where there are others in any number, or may be.
    pub choice: Option<DyadChoice>,
    /// Why it is open whether there are others, where that is not for their number.
    pub reason: Option<OpenReason>,
    /// The curve that these are on, if they are on one.
    pub curves: Vec<Vec<PosedDyad>>,
}

/// Some of any number of dyads.
pub(super) struct DyadChoice {
    pub dyads: Vec<PinHeld>,
    /// How many linkages of them are proposed.
    pub most: usize,
}

impl Free {
    /// By how many equations the poses are: those that repeat what others say do not count.
    pub(super) fn new(
        guidance: &Guidance,
        task: &PoseTask,
        inside: Option<[Vec2; 2]>,
        reach: PoseReach,
    ) -> Free {
        let five = five::dyads(guidance);
        let are_all = five.as_ref().is_some_and(|five| five.are_all);
        let single = five.map_or_else(Vec::new, |five| five.found);
        if are_all {
            return Free {
                single,
                choice: None,
                reason: None,
                curves: Vec::new(),
            };
        }
        let times = reach.times(guidance);
        let handy_within = |dyad: &PinHeld, times| is_handy(guidance, dyad, inside, times);
        let is_handy = |dyad: &PinHeld| handy_within(dyad, times);
        let mut pieces = four::pieces(guidance);
        pieces.extend(family::pieces(guidance));
        let seen = |piece: &Vec<PinHeld>| piece.iter().filter_map(PinHeld::dyad).collect();
        let curves = pieces.iter().map(seen).collect();
        // A family is a curve; a few by themselves are what rounding leaves of one, or all that there is.
        let is_family = pieces.iter().any(|piece| piece.len() > 1);
        let reason = (!single.is_empty() && !is_family).then_some(OpenReason::Rounding);
        let choice = if pieces.is_empty() && single.is_empty() {
            let dyads = three::dyads(guidance, task, inside, times);
            DyadChoice {
                dyads: dyads.into_iter().filter(is_handy).collect(),
                most: MOST_OF_GRID,
            }
        } else {
            let handy = pieces.into_iter().flatten().filter(is_handy);
            let (slides, links): (Vec<PinHeld>, Vec<PinHeld>) =
                handy.partition(|dyad| matches!(dyad.by, Partner::Slide(_)));
            let mut dyads = thinned(&links);
            dyads.extend(thinned(&slides));
            // The one slide of four poses stands alone on its curve, and may go further.
            let slide =
                four::slide(guidance).filter(|_| slides.is_empty() && task.poses.len() == 4);
            dyads.extend(slide.filter(|slide| handy_within(slide, WIDE * times)));
            DyadChoice {
                dyads,
                most: MOST_OF_CURVE,
            }
        };
        Free {
            single,
            choice: Some(choice),
            reason,
            curves,
        }
    }
}

/// As many as linkages are made of, evenly along the curve.
fn thinned(dyads: &[PinHeld]) -> Vec<PinHeld> {
    let stride = dyads.len().div_ceil(DYADS_OF_CURVE).max(1);
    dyads.iter().step_by(stride).cloned().collect()
}

fn is_handy(guidance: &Guidance, dyad: &PinHeld, inside: Option<[Vec2; 2]>, times: f64) -> bool {
    let size = guidance.size;
    let is_near = |at: Vec2| (at - guidance.origin()).norm() <= REACH * times * size;
    let lengths = LENGTHS.start() / times..=LENGTHS.end() * times;
    let is_inside = |at: Vec2| {
        inside.is_none_or(|[a, b]| {
            let between = |v: f64, p: f64, q: f64| p.min(q) <= v && v <= p.max(q);
            between(at.x, a.x, b.x) && between(at.y, a.y, b.y)
        })
    };
    let Some(&pin) = dyad.places.first() else {
        return false;
    };
    let is_held_handily = match dyad.by {
        Partner::Rocker(pivot) => {
            let length = (pin - pivot).norm() / size;
            // Of a box that is given one is as near as another.
            let is_near = inside.is_some() || is_near(pivot);
            is_near && is_inside(pivot) && lengths.contains(&length)
        }
        Partner::Slide(_) => true,
    };
    is_near(pin) && is_held_handily
}
