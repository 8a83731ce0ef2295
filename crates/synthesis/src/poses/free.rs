//! Finds the dyads if none is given.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use super::{family, five, four, three};
use crate::{OpenReason, PinConstraint, PoseTask, PosedDyad};
use kinematics::Vec2;
use std::ops::RangeInclusive;

/// Maximum number of linkages proposed from a grid, and from a curve.
const MAX_GRID_SHARE: usize = 100;
const MAX_CURVE_SHARE: usize = 200;
/// Maximum number of a curve's dyads used for linkages.
const DYADS_OF_CURVE: usize = 96;
/// Limits for a continuous family of dyads, in sizes: the maximum distance of pins and pivots, and
/// the range of the links' lengths.
const MAX_DISTANCE_IN_SIZES: f64 = 6.0;
const LENGTHS: RangeInclusive<f64> = 0.03..=12.0;
/// Factor of the wide reach on distances and on the range of lengths.
const WIDE: f64 = 4.0;

/// Distance limit for proposals from a continuous family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PoseReach {
    /// A distance in proportion to the distance between the poses.
    Usual,
    /// A multiple of it, depending on where the pivots and pins of nearly repeated poses lie.
    Wide,
}

impl PoseReach {
    /// Returns the factor relative to the usual reach.
    pub(super) fn times(self, guidance: &Guidance) -> f64 {
        match self {
            PoseReach::Usual => 1.0,
            PoseReach::Wide => WIDE * (guidance.unit / guidance.size).max(1.0),
        }
    }
}

/// The available dyads.
pub(super) struct Free {
    /// The isolated dyads of five poses.
    pub single: Vec<FullDyad>,
    /// A selection if there are, or may be, infinitely many other dyads.
    pub choice: Option<DyadChoice>,
    /// The reason why other dyads may exist, apart from a continuous family.
    pub reason: Option<OpenReason>,
    /// The curves of these dyads, if they are on curves.
    pub curves: Vec<Vec<PosedDyad>>,
}

/// A selection from infinitely many dyads.
pub(super) struct DyadChoice {
    pub dyads: Vec<FullDyad>,
    /// Maximum number of linkages proposed from the dyads.
    pub most: usize,
}

impl Free {
    /// Finds the dyads by the number of independent equations.
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
        let handy_within = |dyad: &FullDyad, times| has_usable_size(guidance, dyad, inside, times);
        let has_usable_size = |dyad: &FullDyad| handy_within(dyad, times);
        let mut pieces = four::pieces(guidance);
        pieces.extend(family::pieces(guidance));
        let seen = |piece: &Vec<FullDyad>| piece.iter().filter_map(FullDyad::dyad).collect();
        let curves = pieces.iter().map(seen).collect();
        // A family is a curve; a few isolated dyads are all that exist, or all that rounding leaves
        // of a family.
        let is_family = pieces.iter().any(|piece| piece.len() > 1);
        let reason = (!single.is_empty() && !is_family).then_some(OpenReason::Rounding);
        let choice = if pieces.is_empty() && single.is_empty() {
            let dyads = three::dyads(guidance, task, inside, times);
            DyadChoice {
                dyads: dyads.into_iter().filter(has_usable_size).collect(),
                most: MAX_GRID_SHARE,
            }
        } else {
            let handy = pieces.into_iter().flatten().filter(has_usable_size);
            let (slides, links): (Vec<FullDyad>, Vec<FullDyad>) =
                handy.partition(|dyad| matches!(dyad.by, PinConstraint::Slide(_)));
            let mut dyads = thinned(&links);
            dyads.extend(thinned(&slides));
            // The single slide of four poses is isolated on its curve and may lie further away.
            let slide =
                four::slide(guidance).filter(|_| slides.is_empty() && task.poses.len() == 4);
            dyads.extend(slide.filter(|slide| handy_within(slide, WIDE * times)));
            DyadChoice {
                dyads,
                most: MAX_CURVE_SHARE,
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

/// Selects as many dyads as linkages use, evenly along the curve.
fn thinned(dyads: &[FullDyad]) -> Vec<FullDyad> {
    let stride = dyads.len().div_ceil(DYADS_OF_CURVE).max(1);
    dyads.iter().step_by(stride).cloned().collect()
}

fn has_usable_size(
    guidance: &Guidance,
    dyad: &FullDyad,
    inside: Option<[Vec2; 2]>,
    times: f64,
) -> bool {
    let size = guidance.size;
    let is_near =
        |at: Vec2| (at - guidance.origin()).norm() <= MAX_DISTANCE_IN_SIZES * times * size;
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
        PinConstraint::Rocker(pivot) => {
            let length = (pin - pivot).norm() / size;
            // In a given box, the distance does not matter.
            let is_near = inside.is_some() || is_near(pivot);
            is_near && is_inside(pivot) && lengths.contains(&length)
        }
        PinConstraint::Slide(_) => true,
    };
    is_near(pin) && is_held_handily
}
