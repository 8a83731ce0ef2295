//! The places of a box that are looked at: its corners, and where these are few the middles between them too.
//!
//! The worst case lies at a corner where a figure goes one way along every side. Whether it does is looked at on the
//! places themselves: it may go both ways, as beside a dead centre or through a formula that turns over.

use super::worst::MetRange;

/// What is less than this part of all that a figure does is its rounding,
const ROUNDING: f64 = 1e-9;
/// and what is less than this part of the figure itself.
const LAST_DIGITS: f64 = 1e-12;

/// Places of a box of so many sides.
pub(super) struct BoxGrid {
    sides: usize,
    levels: usize,
}

impl BoxGrid {
    /// With the middles between corners, where there are no more sides than `middles`.
    pub(super) fn of(sides: usize, middles: usize) -> BoxGrid {
        let levels = if sides <= middles { 3 } else { 2 };
        BoxGrid { sides, levels }
    }

    /// How many places there are: behind the grid itself the middles of the box's faces, where these are not in it.
    pub(super) fn count(&self) -> usize {
        self.corners() + if self.levels == 2 { 2 * self.sides } else { 0 }
    }

    fn corners(&self) -> usize {
        (0..self.sides).fold(1, |count, _| count * self.levels)
    }

    /// Half of the way from a place to the next along a side, in parts of a tolerance.
    pub(super) fn half_way(&self) -> f64 {
        1.0 / (self.levels - 1) as f64
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

    /// Where a place lies along every side.
    pub(super) fn levels(&self, place: usize) -> Vec<f64> {
        (0..self.sides)
            .map(|side| self.level(place, side))
            .collect()
    }

    /// Whether a figure nowhere falls along a side, or nowhere rises: `found` at every place.
    pub(super) fn goes_one_way(&self, nominal: f64, found: &[f64]) -> bool {
        let rounding = rounding(nominal, found);
        (0..self.sides).all(|side| self.goes_one_way_along(side, nominal, found, rounding))
    }

    fn goes_one_way_along(&self, side: usize, nominal: f64, found: &[f64], rounding: f64) -> bool {
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

/// What a figure may be off by rounding, found so at every place, NaN where it has no value.
pub(super) fn rounding(nominal: f64, found: &[f64]) -> f64 {
    let mut met = MetRange::of(nominal);
    let values = found.iter().filter(|value| value.is_finite());
    values.for_each(|&value| met.meet(value));
    let MetRange { low, high } = met;
    (ROUNDING * (high - low)).max(LAST_DIGITS * low.abs().max(high.abs()))
}
