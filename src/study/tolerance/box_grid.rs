//! The places of a box that are looked at: its corners, and where these are few the middles between them too.
//!
//! The worst case lies at a corner where a figure goes one way along every side. Whether it does is looked at on the
//! places themselves: where it goes both ways, as beside a dead centre or through a formula that turns over, the worst
//! of them is an estimate.

use super::corners::{MetRange, WorstCase, WorstKind};

/// Sides of which the middles are looked at as well: 3^9 places.
const MOST_WITH_MIDDLES: usize = 9;
/// What is less than this part of all that a figure does is its rounding.
const ROUNDING: f64 = 1e-9;

/// Places of a box of so many sides.
pub(super) struct BoxGrid {
    sides: usize,
    levels: usize,
}

impl BoxGrid {
    pub(super) fn of(sides: usize) -> BoxGrid {
        let levels = if sides <= MOST_WITH_MIDDLES { 3 } else { 2 };
        BoxGrid { sides, levels }
    }

    /// How many places there are: behind the grid itself the middles of the box's faces, where these are not in it.
    pub(super) fn count(&self) -> usize {
        self.corners() + if self.levels == 2 { 2 * self.sides } else { 0 }
    }

    fn corners(&self) -> usize {
        (0..self.sides).fold(1, |count, _| count * self.levels)
    }

    /// Where a place lies along a side, from -1 to 1.
    fn level(&self, place: usize, side: usize) -> f64 {
        match place.checked_sub(self.corners()) {
            Some(face) if face / 2 == side => [-1.0, 1.0][face % 2],
            Some(_) => 0.0,
            None => {
                let stride = (0..side).fold(1, |stride, _| stride * self.levels);
                let level = place / stride % self.levels;
                2.0 * level as f64 / (self.levels - 1) as f64 - 1.0
            }
        }
    }

    /// Makes the lengths that are the sides off as far as a place lies from the middle; `limits` are those of all.
    pub(super) fn fill(&self, place: usize, sides: &[usize], limits: &[f64], by: &mut [f64]) {
        for (side, &length) in sides.iter().enumerate() {
            by[length] = self.level(place, side) * limits[length];
        }
    }

    /// The worst case of a figure that was found at every place, NaN where it has none.
    pub(super) fn worst(&self, nominal: f64, found: &[f64], fails: bool) -> WorstCase {
        let mut met = MetRange {
            low: nominal,
            high: nominal,
        };
        let values = found.iter().filter(|value| value.is_finite());
        values.for_each(|&value| met.meet(value));
        let rounding = ROUNDING * (met.high - met.low);
        let goes_one_way =
            (0..self.sides).all(|side| self.goes_one_way(side, nominal, found, rounding));
        WorstCase {
            low: met.low,
            high: met.high,
            reached: [met.low, met.high],
            kind: match goes_one_way {
                true => WorstKind::Corners,
                false => WorstKind::Estimated,
            },
            fails,
        }
    }

    /// Whether a figure nowhere falls along a side, or nowhere rises.
    fn goes_one_way(&self, side: usize, nominal: f64, found: &[f64], rounding: f64) -> bool {
        let stride = (0..side).fold(1, |stride, _| stride * self.levels);
        let corners = self.corners();
        let steps = (0..corners).filter(|place| place / stride % self.levels < self.levels - 1);
        let along = steps.map(|place| found[place + stride] - found[place]);
        let faces = found.get(corners + 2 * side..corners + 2 * side + 2);
        let through = faces.map_or([0.0; 2], |faces| [nominal - faces[0], faces[1] - nominal]);
        let (mut rises, mut falls) = (false, false);
        for step in along.chain(through) {
            rises |= step > rounding;
            falls |= step < -rounding;
        }
        !(rises && falls)
    }
}
