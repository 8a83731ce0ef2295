//! Analyses a ram: a slide with its guide on the ground, in terms of presses.
//!
//! Between two dead centres the motion is monotonic, so each height has one driver coordinate.

use super::guide::{MonotoneStretch, SlideFinder, SlidePassing};
use crate::numeric::root;
use crate::solver::{DeadCentre, Range, Solver};
use crate::{Body, Mechanism, SlideId, StrokeEnd};
use thiserror::Error;

/// The difference below which two dead centres have equal depth, relative to the stroke.
const EQUALITY_TOLERANCE: f64 = 1e-9;
/// The reason why a slide is not a ram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NoRam {
    /// There is no slide with its guide on the ground.
    #[error("no slide has its guide on the ground")]
    None,
    /// The slide's guide moves.
    #[error("its guide is not on the ground")]
    Moves,
    /// The slide does not move.
    #[error("it does not move")]
    Stands,
}

/// The end of the stroke at which a ram works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RamEnd {
    /// The end.
    pub end: StrokeEnd,
    /// `true` if it follows from a load or from the guide's direction, `false` for a mere
    /// convention.
    pub is_known: bool,
}

/// The dwell of the ram near the bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dwell {
    /// The driver's coordinate at its beginning.
    pub from: f64,
    /// The driver's coordinate at its end, in the driver's direction.
    pub to: f64,
    /// The driver's travel between, in degrees or in the scene's length unit.
    pub travel: f64,
    /// The duration in s; `None` if the driver's speed is zero.
    pub seconds: Option<f64>,
}

/// A ram over its motion.
#[derive(Clone, Debug)]
pub struct Ram {
    /// The slide.
    pub slide: SlideId,
    /// The working end.
    pub end: RamEnd,
    /// The bottom dead centre: the deepest.
    pub bottom: DeadCentre,
    /// The top dead centre.
    pub top: DeadCentre,
    /// Further dead centres, in the order of the coordinate.
    pub others: Vec<DeadCentre>,
    /// The distance from top to bottom, in the scene's length unit.
    pub stroke: f64,
    /// The driver's travel over one period while the ram closes, and while it opens.
    pub travels: [f64; 2],
    /// The number of times the ram reaches the bottom in one period.
    pub strokes: u32,
    /// The period, in s; `None` if the driver's speed is zero.
    pub seconds: Option<f64>,
    legs: Vec<MonotoneStretch>,
    /// The index of the bottom among the dead centres, in the order of the legs.
    bottom_index: usize,
    guide: SlideFinder,
}

/// Returns the slides that can be rams: on the ground, and not driven.
pub fn rams(mechanism: &Mechanism) -> impl Iterator<Item = SlideId> {
    let pushed = |slide| mechanism.is_pushed(slide);
    let is_ram = move |&id: &SlideId| mechanism.slide(id).on == Body::Ground && !pushed(id);
    mechanism.slide_ids().filter(is_ram)
}

impl RamEnd {
    /// Returns the end named by a press load. Without one, it is the lower end; on a horizontal
    /// guide, it is the far end along its direction.
    #[must_use]
    pub fn of(mechanism: &Mechanism, slide: SlideId) -> RamEnd {
        let pressed = mechanism.loads().iter().find_map(|load| match load {
            crate::Load::Press { slide: s, end, .. } if *s == slide => Some(*end),
            _ => None,
        });
        let up = mechanism.slide(slide).direction().y;
        let end = match pressed {
            Some(end) => end,
            None if up > 0.0 => StrokeEnd::Minimum,
            None => StrokeEnd::Maximum,
        };
        RamEnd {
            end,
            is_known: pressed.is_some() || up != 0.0,
        }
    }
}

impl Ram {
    /// Analyses a slide over the motion.
    ///
    /// # Errors
    /// Returns an error if the slide cannot be a ram.
    pub fn new(
        mechanism: &Mechanism,
        solver: &Solver,
        slide: SlideId,
        end: RamEnd,
    ) -> Result<Ram, NoRam> {
        if mechanism.slide(slide).on != Body::Ground {
            return Err(NoRam::Moves);
        }
        let guide = SlideFinder::new(mechanism, solver, slide);
        let legs = guide.legs();
        // A smaller value is deeper.
        let depth = |centre: &DeadCentre| match end.end {
            StrokeEnd::Minimum => centre.position,
            StrokeEnd::Maximum => -centre.position,
        };
        // In a periodic motion the last leg ends at the first leg's beginning.
        let last = match guide.range {
            Range::Full { .. } => None,
            Range::Limited { .. } => legs.last().map(|leg| leg.to),
        };
        let mut turns: Vec<DeadCentre> = legs.iter().map(|leg| leg.from).chain(last).collect();
        let by_depth = |a: &usize, b: &usize| depth(&turns[*a]).total_cmp(&depth(&turns[*b]));
        let deepest = (0..turns.len()).min_by(by_depth);
        let highest = (0..turns.len()).max_by(by_depth);
        let (Some(deepest), Some(highest)) = (deepest, highest) else {
            return Err(NoRam::Stands);
        };
        let (bottom, top) = (turns[deepest], turns[highest]);
        let stroke = depth(&top) - depth(&bottom);
        if !(stroke > 0.0) {
            return Err(NoRam::Stands);
        }
        let (mut closing, mut opening) = (0.0, 0.0);
        for leg in &legs {
            let falls = depth(&leg.to) < depth(&leg.from);
            let travel = leg.to.at - leg.from.at;
            *(if falls != guide.backwards() {
                &mut closing
            } else {
                &mut opening
            }) += travel;
        }
        if let Range::Limited { .. } = guide.range {
            // To and fro: the ram closes on the one way where it opens on the other.
            let both = closing + opening;
            (closing, opening) = (both, both);
        }
        let deep = |c: &&DeadCentre| depth(c) - depth(&bottom) <= EQUALITY_TOLERANCE * stroke;
        let bottoms = turns.iter().filter(deep).count();
        let [bottom, top] = [bottom, top].map(|centre| guide.reduced(centre));
        turns
            .iter_mut()
            .for_each(|centre| *centre = guide.reduced(*centre));
        turns.retain(|centre| *centre != bottom && *centre != top);
        turns.sort_by(|a, b| a.at.total_cmp(&b.at));
        Ok(Ram {
            slide,
            end,
            bottom: guide.reduced(bottom),
            top: guide.reduced(top),
            others: turns,
            stroke,
            travels: [closing, opening],
            strokes: u32::try_from(bottoms).unwrap_or(u32::MAX),
            seconds: guide.seconds(closing + opening),
            legs,
            bottom_index: deepest,
            guide,
        })
    }

    /// Returns the ram's strokes per minute; `None` if the driver's speed is zero.
    #[must_use]
    pub fn strokes_per_minute(&self) -> Option<f64> {
        Some(60.0 * f64::from(self.strokes) / self.seconds?)
    }

    /// Returns the ratio of the closing time to the opening time.
    #[must_use]
    pub fn time_ratio(&self) -> f64 {
        self.travels[0] / self.travels[1]
    }

    /// Returns the ram's state at a height above the bottom, in the scene's length unit, twice:
    /// where it last passes while closing, and where it first passes while opening. Returns `None`
    /// if it does not reach the height next to the bottom.
    pub fn at_height(&mut self, height: f64) -> Option<[SlidePassing; 2]> {
        if !(0.0..=self.stroke).contains(&height) {
            return None;
        }
        // At a limit the driver reverses, and the ram returns the same way.
        let (closing, opening) = match self.bottom_legs() {
            [Some(before), Some(after)] => ((before, false), (after, false)),
            [Some(before), None] => ((before, false), (before, true)),
            [None, Some(after)] => ((after, true), (after, false)),
            [None, None] => return None,
        };
        let mut passing = |(leg, back)| {
            let at = self.crossing(leg, height)?;
            self.guide.passing(at, back, self.stroke)
        };
        let (down, up) = (passing(closing)?, passing(opening)?);
        Some([down, up])
    }

    /// Returns the dwell within a tolerance of the bottom (in the scene's length unit), without
    /// interruption around the deepest place.
    pub fn dwell(&mut self, tolerance: f64) -> Option<Dwell> {
        if !(tolerance > 0.0) {
            return None;
        }
        let [before, after] = self.bottom_leg_indices();
        let count = self.legs.len();
        let is_periodic = matches!(self.guide.range, Range::Full { .. });
        let reach = |ram: &mut Ram, first: Option<usize>, forwards: bool| {
            let mut travel = 0.0;
            let mut next = first;
            for _ in 0..count {
                let Some(index) = next else { break };
                let leg = ram.legs[index];
                let (near, far) = if forwards {
                    (leg.from, leg.to)
                } else {
                    (leg.to, leg.from)
                };
                let is_within = ram.height(&far) <= tolerance;
                let end = if is_within {
                    far.at
                } else {
                    ram.crossing(leg, tolerance)?
                };
                travel += (end - near.at).abs();
                next = match (forwards, is_periodic) {
                    _ if !is_within => None,
                    (true, true) => Some((index + 1) % count),
                    (false, true) => Some((index + count - 1) % count),
                    (true, false) => Some(index + 1).filter(|i| *i < count),
                    (false, false) => index.checked_sub(1),
                };
            }
            Some(travel)
        };
        let low = reach(self, before, false)?;
        let high = reach(self, after, true)?;
        let maximum = self.travels[0] + self.travels[1];
        let (mut from, mut to) = (self.bottom.at - low, self.bottom.at + high);
        if self.guide.backwards() {
            (from, to) = (to, from);
        }
        // At a limit the ram moves to and fro on the same stretch.
        let there_and_back = !is_periodic && (before.is_none() || after.is_none());
        let travel = if there_and_back { 2.0 } else { 1.0 } * (low + high);
        Some(Dwell {
            from: self.guide.wrapped(from),
            to: self.guide.wrapped(to),
            travel: travel.min(maximum),
            seconds: self.guide.seconds(travel.min(maximum)),
        })
    }

    /// Adds the driver's coordinates over one period at which the ram is at this distance from the
    /// bottom.
    pub(super) fn coordinates(&mut self, height: f64, to: &mut Vec<f64>) {
        for leg in self.legs.clone() {
            to.extend(self.crossing(leg, height));
        }
    }

    /// Adds the driver's coordinates at the dead centres.
    pub(super) fn turns(&self, to: &mut Vec<f64>) {
        to.extend(self.legs.iter().flat_map(|leg| [leg.from.at, leg.to.at]));
    }

    fn height(&self, centre: &DeadCentre) -> f64 {
        (centre.position - self.bottom.position).abs()
    }

    /// Returns the indices of the legs that end and begin at the bottom, by the driver's
    /// coordinate.
    fn bottom_leg_indices(&self) -> [Option<usize>; 2] {
        let (deepest, count) = (self.bottom_index, self.legs.len());
        match self.guide.range {
            Range::Full { .. } => [Some((deepest + count - 1) % count), Some(deepest)],
            Range::Limited { .. } => [deepest.checked_sub(1), Some(deepest).filter(|i| *i < count)],
        }
    }

    /// Returns the legs that end and begin at the bottom, in the driver's direction.
    fn bottom_legs(&self) -> [Option<MonotoneStretch>; 2] {
        let mut legs = self.bottom_leg_indices().map(|i| Some(self.legs[i?]));
        if self.guide.backwards() {
            legs.reverse();
        }
        legs
    }

    /// Finds the coordinate on a leg at which the ram is at this height above the bottom.
    fn crossing(&mut self, leg: MonotoneStretch, height: f64) -> Option<f64> {
        let off = |centre: &DeadCentre| self.height(centre) - height;
        let ends = [leg.from, leg.to].map(|centre| (centre.at, off(&centre)));
        let bottom = self.bottom.position;
        let guide = &mut self.guide;
        let off = |at| Some((guide.slide_at(at)?.0 - bottom).abs() - height);
        root(ends[0], ends[1], f64::EPSILON, off).ok()
    }
}

#[cfg(test)]
#[path = "ram_tests.rs"]
mod tests;
